"""hn_perlin_d with a phase: hn_perlin with a phase and its derivatives along the axes, which perlin_phase.py proves."""

from __future__ import annotations

from dataclasses import replace

from bounds.gradients import Gradient
from bounds.noises import Derived, perlin_phase

CASES = perlin_phase.CASES


def derive(dims: int, gradient: Gradient) -> Derived:
    return replace(perlin_phase.derive(dims, gradient), slope=perlin_phase.derive_slope(dims))


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    return (perlin_phase.largest_intermediates(dims, gradient)
            | perlin_phase.largest_slope_intermediates(dims, perlin_phase.derive_slope(dims).fixed_largest))


def quotes() -> list[tuple[str, str]]:
    return []


def describe(dims: int, _: Gradient) -> dict[str, object]:
    return {"slope_error_from_cell_to_nearest": perlin_phase.slope_error_bound(dims, 0.5)}
