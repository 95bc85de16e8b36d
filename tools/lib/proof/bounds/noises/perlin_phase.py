"""hn_perlin with a phase: as in rotations.py, with gradients at all phases."""

from __future__ import annotations

from proof.bounds import rotations
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.noises import ProvenBounds, listed, perlin, perlin_d
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound, slope_bound, slope_lipschitz_bound
from proof.bounds.noises.perlin.fixed import RAMP_ONE

CASES = ((2, OCTAHEDRAL), (3, OCTAHEDRAL))


def unit(dims: int) -> float:
    """Of ramps, scaled."""
    return SCALE[OCTAHEDRAL][dims] / RAMP_ONE[OCTAHEDRAL][dims]


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(perlin.derive(dims, gradient), range_bound(dims, ROTATED), lipschitz_bound(dims, ROTATED),
                        unit(dims))


def derive_slope(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(perlin_d.derive(dims, gradient).slope, slope_bound(dims, ROTATED),
                        slope_lipschitz_bound(dims, ROTATED), 4 * unit(dims))


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    value = derive(dims, gradient).fixed_largest / unit(dims)
    return perlin.largest_intermediates(dims, gradient) | rotations.largest_intermediates("value", value)


def quotes() -> list[tuple[str, str]]:
    below = listed([range_bound(dims, ROTATED) for dims, _ in CASES])
    return [("docs/measured/accuracy.md", f"With a phase `hn_perlin` stays below {below} in 2D")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    return {"error_from_cell_to_nearest": rotations.mixed(perlin.error_bound(dims, gradient, 0.5),
                                                      range_bound(dims, ROTATED), 0.5)}
