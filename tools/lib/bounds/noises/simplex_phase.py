"""hn_simplex with a phase: as simplex.py, with gradients that turn (turns.py)."""

from __future__ import annotations

from bounds import kernel_fixed
from bounds.gradients import Gradient
from bounds.kernels import SIMPLEX
from bounds.noises import Derived, listed, simplex

CASES = tuple((dims, None) for dims in (2, 3))


def derive(dims: int, _: Gradient | None) -> Derived:
    return simplex.derived_value(SIMPLEX[dims], turning=True)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return kernel_fixed.largest_intermediates(SIMPLEX[dims], True)


def quotes() -> list[tuple[str, str]]:
    below = listed([derive(*case).range for case in CASES])
    return [("docs/accuracy.md", f"and `hn_simplex` below {below}.")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": SIMPLEX[dims].scale / 1024}
