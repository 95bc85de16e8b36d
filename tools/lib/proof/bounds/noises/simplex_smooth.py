"""hn_simplex_smooth: as simplex.py, with larger kernels."""

from __future__ import annotations

from proof.bounds import kernel_fixed, kernel_floats
from proof.bounds.gradients import Gradient
from proof.bounds.kernels import SMOOTH
from proof.bounds.noises import ProvenBounds, listed, simplex

CASES = tuple((dims, None) for dims in SMOOTH)


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return simplex.derived_value(SMOOTH[dims])


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return kernel_fixed.largest_intermediates(SMOOTH[dims])


def quotes() -> list[tuple[str, str]]:
    below = listed([derive(*case).range for case in CASES])
    return [("docs/measured/accuracy.md", f"`hn_simplex_smooth` below {below} in 2D")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": SMOOTH[dims].scale / 1024,
            "error_from_cell_to_nearest": kernel_floats.error_bound(SMOOTH[dims], 0.5)}
