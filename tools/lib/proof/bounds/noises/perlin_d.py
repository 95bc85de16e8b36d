"""hn_perlin_d: hn_perlin with its derivatives. The value is computed in the same steps, so it has the same bounds; the
derivatives are proven in perlin/."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds.gradients import OCTAHEDRAL, Gradient
from proof.bounds.noises import ProvenBounds, derived, perlin
from proof.bounds.noises.perlin.exact import slope_bound, slope_lipschitz_bound
from proof.bounds.noises.perlin.fixed import largest_slope_intermediates, slope_error_parts
from proof.bounds.noises.perlin.floats import slope_error_bound

CASES = tuple((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4))


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    slope = derived(0.0, slope_bound(dims), slope_lipschitz_bound(dims), slope_error_bound(dims), slope_error_parts(dims))
    return replace(perlin.derive(dims, gradient), slope=slope)


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    largest = derive(dims, gradient).slope.fixed_largest
    return perlin.largest_intermediates(dims, gradient) | largest_slope_intermediates(dims, largest)


def describe(dims: int, _: Gradient) -> dict[str, object]:
    return {"slope_error_from_cell_to_nearest": slope_error_bound(dims, 0.5)}
