"""hn_simplex with a phase: as simplex.py, with gradients that turn (turns.py)."""

from __future__ import annotations

from bounds import kernel_fixed
from bounds.gradients import Gradient
from bounds.kernels import TURNING
from bounds.noises import Derived, simplex

CASES = tuple((dims, None) for dims in TURNING)


def derive(dims: int, _: Gradient | None) -> Derived:
    return simplex.derived_value(TURNING[dims], turning=True)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return kernel_fixed.largest_intermediates(TURNING[dims], True)


def quotes() -> list[tuple[str, str]]:
    return []


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": TURNING[dims].scale / 1024}
