"""hn_perlin with a phase: as in rotations.py, with gradients at all phases."""

from __future__ import annotations

from proof.bounds import rotations
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.noises import ProvenBounds, listed, perlin, perlin_d
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound, slope_bound, slope_lipschitz_bound
from proof.bounds.noises.perlin.fixed import RAMP_ONE

CASES = ((2, OCTAHEDRAL), (3, OCTAHEDRAL))


def unit(dims: int) -> float:
    """The unit of scaled ramps."""
    return SCALE[ROTATED][dims] / RAMP_ONE[OCTAHEDRAL][dims]


def ratio(dims: int) -> float:
    """The ratio of the scales with and without a phase."""
    return SCALE[ROTATED][dims] / SCALE[OCTAHEDRAL][dims]


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(perlin.derive(dims, gradient), dims, range_bound(dims, ROTATED),
                             lipschitz_bound(dims, ROTATED), unit(dims), ratio(dims))


def derive_slope(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(perlin_d.derive(dims, gradient).slope, dims, slope_bound(dims, ROTATED),
                             slope_lipschitz_bound(dims, ROTATED), 4 * unit(dims), ratio(dims))


def scaled_intermediates(name: str, dims: int, largest: float, of_unit: float) -> dict[str, float]:
    return rotations.largest_intermediates(name, dims, largest / of_unit, round(1024 * SCALE[ROTATED][dims]))


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    return (perlin.largest_intermediates(dims, gradient)
            | scaled_intermediates("value", dims, derive(dims, gradient).fixed_largest, unit(dims)))


def quotes() -> list[tuple[str, str]]:
    below = listed([range_bound(dims, ROTATED) for dims, _ in CASES])
    return [("docs/measured/accuracy.md", f"With a phase `hn_perlin` stays below {below} in 2D")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    error = ratio(dims) * perlin.error_bound(dims, gradient, 0.5)
    return {"scale": SCALE[ROTATED][dims],
            "error_from_cell_to_nearest": rotations.mixed(dims, error, range_bound(dims, ROTATED), 0.5)}
