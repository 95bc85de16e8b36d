"""hn_perlin with a phase: as turns.py says, with gradients at all phases."""

from __future__ import annotations

from proof.bounds import turns
from proof.bounds.gradients import OCTAHEDRAL, TURNED, Gradient
from proof.bounds.noises import Derived, listed, perlin, perlin_d
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound, slope_bound, slope_lipschitz_bound
from proof.bounds.noises.perlin.fixed import RAMP_ONE

CASES = ((2, OCTAHEDRAL), (3, OCTAHEDRAL))


def unit(dims: int) -> float:
    """Of ramps, scaled."""
    return SCALE[OCTAHEDRAL][dims] / RAMP_ONE[OCTAHEDRAL][dims]


def derive(dims: int, gradient: Gradient) -> Derived:
    return turns.turned(perlin.derive(dims, gradient), range_bound(dims, TURNED), lipschitz_bound(dims, TURNED),
                        unit(dims))


def derive_slope(dims: int, gradient: Gradient) -> Derived:
    return turns.turned(perlin_d.derive(dims, gradient).slope, slope_bound(dims, TURNED),
                        slope_lipschitz_bound(dims, TURNED), 4 * unit(dims))


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    value = derive(dims, gradient).fixed_largest / unit(dims)
    return perlin.largest_intermediates(dims, gradient) | turns.largest_intermediates("value", value)


def quotes() -> list[tuple[str, str]]:
    below = listed([range_bound(dims, TURNED) for dims, _ in CASES])
    return [("docs/measured/accuracy.md", f"With a phase `hn_perlin` stays below {below} in 2D")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    return {"error_from_cell_to_nearest": turns.mixed(perlin.error_bound(dims, gradient, 0.5),
                                                      range_bound(dims, TURNED), 0.5)}
