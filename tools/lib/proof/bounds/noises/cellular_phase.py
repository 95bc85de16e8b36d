"""Proofs for hn_cellular_phase, from docs/reference/contract.md, section 16. moving.py of the folder above
has the proofs. How fast distances change with the phase is not bounded here.

One bound holds for the distances and for each component of an offset: the larger one. It is the offset's, which is
rotated twice.
"""

from __future__ import annotations

import math

from proof.bounds import moving
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, cellular, listed
from proof.bounds.table import scientific

CASES = cellular.CASES
COUNT = cellular.COUNT
offset_error = moving.offset_error


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    largest, lipschitz = moving.largest_distance(dims, COUNT), math.sqrt(dims)
    cell_error = max(moving.distance_error(dims, largest), offset_error(dims, False))
    fixed = max(moving.fixed_distance_error(dims), offset_error(dims, True))
    error = position_error(cell_error, lipschitz)
    return ProvenBounds(largest, largest, lipschitz, cell_error, error, largest + error, fixed, largest + fixed,
                   moving.fixed_parts(dims))


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return moving.largest_intermediates(dims)


def ends(dims: int) -> list[float]:
    return [moving.largest_distance(dims, count) for count in (1, COUNT)]


def quotes() -> list[tuple[str, str]]:
    plane, space = (listed(ends(dims)) for dims in (2, 3))
    errors = [position_error(moving.distance_error(dims, ends(dims)[-1]), math.sqrt(dims)) for dims in (2, 3)]
    off = [moving.fixed_distance_error(dims) for dims in (2, 3)]
    return [("docs/measured/accuracy.md", text) for text in (
        f"With a phase the two distances stay below {plane} in 2D, and below {space} in 3D",
        f"distances is at most {scientific(errors[0])} in 2D and {scientific(errors[1])} in 3D",
        f"the distances are within {scientific(off[0])} in 2D and {scientific(off[1])} in 3D")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"first_largest": moving.largest_distance(dims, 1), "offset_error": offset_error(dims, False),
            "fixed_offset_error": offset_error(dims, True), "radius": moving.RADIUS[dims]}
