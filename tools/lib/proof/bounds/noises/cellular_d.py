"""Proofs for hn_cellular_d. The value is the first of hn_cellular, in the Euclidean metric.

A derivative is a component of (position - point) / distance. An error of the position moves it by that over the
distance: without a bound near the point. So the errors are for a derivative times the distance, in
cells. They hold where the second distance is so much larger than the first that no other point is taken for the nearest
one.
"""

from __future__ import annotations

import math

from proof.bounds import distances, features
from proof.bounds.boxes import SAFE
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, cellular

CASES = cellular.CASES
quotes = cellular.quotes


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    largest, lipschitz = features.largest_distance(dims, 1), math.sqrt(dims)
    cell_error = distances.distance_error(dims, largest)
    error, parts = position_error(cell_error, lipschitz), distances.fixed_parts(dims)
    fixed = sum(parts.values()) * SAFE
    return ProvenBounds(largest, largest, lipschitz, cell_error, error, largest + error, fixed, largest + fixed, parts,
                   derive_slope(dims))


def derive_slope(dims: int) -> ProvenBounds:
    lipschitz = 2 * math.sqrt(dims)
    cell_error = distances.direction_error(dims, features.largest_distance(dims, 1))
    error, parts = position_error(cell_error, lipschitz), distances.fixed_direction_parts(dims)
    fixed = sum(parts.values()) * SAFE
    longer = 20 * distances.UNIT  # of a vector of length 1, whatever its errors
    return ProvenBounds(0.0, 1.0, lipschitz, cell_error, error, 1 + longer, fixed, 1 + 2.0**-14, parts)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return distances.largest_intermediates(dims) | distances.largest_direction_intermediates(dims)
