"""hn_value_d: hn_value with its derivatives. The value is computed in the same steps, so it has the same bounds;
value.py proves the derivatives."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, value

CASES = value.CASES


def derive(dims: int, gradient: Gradient | None) -> ProvenBounds:
    return replace(value.derive(dims, gradient), slope=value.derive_slope(dims))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    return value.largest_intermediates(dims, gradient) | value.largest_slope_intermediates(dims)


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"slope_error_from_cell_to_nearest": value.slope_error_bound(dims, 0.5)}
