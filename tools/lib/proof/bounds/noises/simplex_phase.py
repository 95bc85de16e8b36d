"""hn_simplex with a phase: as in rotations.py, with gradients at all phases."""

from __future__ import annotations

from proof.bounds import kernel_fixed, kernels, rotations
from proof.bounds.gradients import ROTATED, Gradient
from proof.bounds.kernel_fixed import ramp_one
from proof.bounds.kernels import ROTATING, SIMPLEX
from proof.bounds.noises import ProvenBounds, listed, simplex

CASES = tuple((dims, None) for dims in ROTATING)


def range_of(dims: int) -> float:
    return ROTATING[dims].scale / 1024 * kernels.range_of(ROTATING[dims], ROTATED)


def unit(dims: int) -> float:
    """The unit of scaled ramps."""
    return ROTATING[dims].scale / 1024 / ramp_one(dims)


def ratio(dims: int) -> float:
    """The ratio of the scales with and without a phase."""
    return ROTATING[dims].scale / SIMPLEX[dims].scale


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return rotations.rotated(simplex.derived_value(SIMPLEX[dims]), dims, range_of(dims),
                             simplex.lipschitz_of(ROTATING[dims], ROTATED), unit(dims), ratio(dims))


def derive_slope(dims: int) -> ProvenBounds:
    kernel = ROTATING[dims]
    return rotations.rotated(simplex.derived_slope(SIMPLEX[dims]), dims, simplex.slope_of(kernel, ROTATED),
                             simplex.slope_lipschitz_of(kernel, ROTATED), 4 * kernel.steps * unit(dims), ratio(dims))


def scaled_intermediates(name: str, dims: int, largest: float, of_unit: float) -> dict[str, float]:
    return rotations.largest_intermediates(name, dims, largest / of_unit, kernel_fixed.fixed_scale(ROTATING[dims]))


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return (kernel_fixed.largest_intermediates(ROTATING[dims])
            | scaled_intermediates("value", dims, derive(dims, None).fixed_largest, unit(dims)))


def quotes() -> list[tuple[str, str]]:
    below = listed([range_of(dims) for dims, _ in CASES])
    return [("docs/measured/accuracy.md", f"and `hn_simplex` below {below}.")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": ROTATING[dims].scale / 1024}
