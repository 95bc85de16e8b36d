"""hn_simplex_d: hn_simplex with its derivatives. The value is computed in the same steps, so it has the same bounds."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import kernel_fixed, kernel_floats
from proof.bounds.gradients import Gradient
from proof.bounds.kernels import SIMPLEX
from proof.bounds.noises import ProvenBounds, simplex

CASES = simplex.CASES


def derive(dims: int, gradient: Gradient | None) -> ProvenBounds:
    return replace(simplex.derive(dims, gradient), slope=simplex.derived_slope(SIMPLEX[dims]))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    return (simplex.largest_intermediates(dims, gradient)
            | kernel_fixed.largest_slope_intermediates(SIMPLEX[dims]))


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"slope_error_from_cell_to_nearest": kernel_floats.slope_error_bound(SIMPLEX[dims], 0.5)}
