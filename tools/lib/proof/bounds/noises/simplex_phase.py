"""hn_simplex with a phase: as in rotations.py, with gradients at all phases."""

from __future__ import annotations

from proof.bounds import kernels, rotations
from proof.bounds.gradients import ROTATED, Gradient
from proof.bounds.kernel_fixed import ramp_one
from proof.bounds.kernels import SIMPLEX
from proof.bounds.noises import ProvenBounds, listed, simplex

CASES = tuple((dims, None) for dims in (2, 3))


def range_of(dims: int) -> float:
    return SIMPLEX[dims].scale / 1024 * kernels.range_of(SIMPLEX[dims], ROTATED)


def unit(dims: int) -> float:
    """Of ramps, scaled."""
    return SIMPLEX[dims].scale / 1024 / ramp_one(dims)


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    kernel = SIMPLEX[dims]
    return rotations.rotated(simplex.derived_value(kernel), range_of(dims), simplex.lipschitz_of(kernel, ROTATED), unit(dims))


def derive_slope(dims: int) -> ProvenBounds:
    kernel = SIMPLEX[dims]
    return rotations.rotated(simplex.derived_slope(kernel), simplex.slope_of(kernel, ROTATED),
                        simplex.slope_lipschitz_of(kernel, ROTATED), 4 * kernel.steps * unit(dims))


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    value = derive(dims, None).fixed_largest / unit(dims)
    return simplex.largest_intermediates(dims, None) | rotations.largest_intermediates("value", value)


def quotes() -> list[tuple[str, str]]:
    below = listed([range_of(dims) for dims, _ in CASES])
    return [("docs/measured/accuracy.md", f"and `hn_simplex` below {below}.")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": SIMPLEX[dims].scale / 1024}
