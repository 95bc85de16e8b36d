"""Proofs for hn_cell_border. It changes by no more than the place moves: inside of a cell it is the distance
to the nearest of some lines or planes, and at the border it is 0 on both sides."""

from __future__ import annotations

import math

from proof.bounds import borders, distances, features
from proof.bounds.boxes import SAFE
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, cellular
from proof.bounds.table import scientific, shortest

CASES = cellular.CASES
offset_error = cellular.offset_error
CLEAR = 1 / 8  # a distance between two points that is seldom less
CLIMBED = {2: 0.73, 3: 0.72}  # what borders.climb finds, rounded down


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    largest, lipschitz = features.largest_border(dims), math.sqrt(dims)
    cell_error, parts = distances.border_error(dims), distances.fixed_border_parts(dims)
    error, fixed = position_error(cell_error, lipschitz), sum(parts.values()) * SAFE
    return ProvenBounds(largest, largest, lipschitz, cell_error, error, largest + error, fixed, largest + fixed, parts)


def least(_: int) -> float:
    return 0.0


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return distances.largest_intermediates(dims) | distances.largest_border_intermediates(dims)


def quotes() -> list[tuple[str, str]]:
    floats = [scientific(distances.border_error(dims, apart=CLEAR)) for dims in (2, 3)]
    fixed = [scientific(sum(distances.fixed_border_parts(dims, CLEAR).values())) for dims in (2, 3)]
    largest = [shortest(features.largest_border(dims), 3) for dims in (2, 3)]
    return [("docs/measured/accuracy.md", f"at most {floats[0]} in 2D and {floats[1]} in 3D, or {fixed[0]} and {fixed[1]} with"),
            ("docs/measured/accuracy.md", f"to a border stays below {largest[0]} and {largest[1]}."),
            ("docs/measured/accuracy.md", f"a climb reaches {CLIMBED[2]} and {CLIMBED[3]}")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"border_of_a_climb": borders.climb(dims), "error_of_points_1/8_apart": distances.border_error(dims, apart=CLEAR),
            "fixed_error_of_points_1/8_apart": sum(distances.fixed_border_parts(dims, CLEAR).values())}
