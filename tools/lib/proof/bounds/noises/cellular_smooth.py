"""Proofs for hn_cellular_smooth. The sum of weights is largest where two points are at the place, in the
middle of a wall, and others as near as they can be. It is nowhere 4, so it fits 32 bits in units of 2^-30."""

from __future__ import annotations

import math

from proof.bounds import distances, features
from proof.bounds.boxes import SAFE
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, cellular
from proof.bounds.table import shortest

CASES = cellular.CASES
LARGEST = 7 / 8  # where no point is within 1


def least(dims: int) -> float:
    return 1 - (features.largest_weights(dims) + 1 / 4096) ** 0.25


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    lipschitz = features.most_within(dims) ** 0.25 * math.sqrt(dims)
    cell_error, parts = distances.smooth_error(dims), distances.fixed_smooth_parts(dims)
    error, fixed = position_error(cell_error, lipschitz), sum(parts.values()) * SAFE
    return ProvenBounds(LARGEST, LARGEST, lipschitz, cell_error, error, LARGEST + error, fixed, LARGEST, parts)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return distances.largest_intermediates(dims) | distances.largest_smooth_intermediates(dims)


def ends(dims: int) -> list[float]:
    return [-least(dims)]


def quotes() -> list[tuple[str, str]]:
    weights = [shortest(features.largest_weights(dims), 3) for dims in (2, 3)]
    return [("docs/measured/accuracy.md", f"stays below {weights[0]} in 2D and {weights[1]} in 3D")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"smallest": least(dims), "largest_sum_of_weights": features.largest_weights(dims)}
