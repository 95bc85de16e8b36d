"""Proofs for cellular noise, from docs/reference/contract.md, section 16. features.py, distances.py, moving.py and
borders.py of the folder above have them; here they are put together.

HN_CELLULAR and HN_CELLULAR_THREE. One bound holds for all metrics: the largest. The text proves that of floats. It is
the hybrid metric's, whose distances are the largest; in fixed arithmetic it is the Euclidean one's, by the root of a
small square. The errors of offsets are smaller. Rounding may take the cells of the third point along another axis, where
a place is nearly as far from the centre of its cell along both. This axis is right for another place, no farther than
2^-25 along each axis, since a coordinate 2 f - 1 is off by less than 2^-24. There the blocks of both axes have the third
point, and the distances in either change by no more than L * 2^-25 on the way.

HN_CELLULAR_PHASE. How fast distances change with the phase is not bounded here. One bound holds for the distances and
for each component of an offset: the larger one. It is the offset's, which is rotated twice.

HN_CELLULAR_D. The value is the first of hn_cellular, in the Euclidean metric. A derivative is a component of (position
- point) / distance. An error of the position moves it by that over the distance: without a bound near the point. So the
errors are for a derivative times the distance, in cells. They hold where the second distance is so much larger than the
first that no other point is taken for the nearest one.

HN_CELLULAR_SMOOTH. The sum of weights is largest where two points are at the place, in the middle of a wall, and others
as near as they can be. It is nowhere 4, so it fits 32 bits in units of 2^-30.

HN_CELL_BORDER. It changes by no more than the place moves: inside of a cell it is the distance to the nearest of some
lines or planes, and at the border it is 0 on both sides.
"""

from __future__ import annotations

import math
from dataclasses import replace

from proof.bounds import distances, features, moving
from proof.bounds.boxes import SAFE
from proof.bounds.gradients import Gradient
from proof.bounds.noises import Proof, ProvenBounds, derived, listed
from proof.bounds.table import scientific, shortest

ACCURACY = "docs/measured/accuracy.md"
CASES = ((2, None), (3, None))
CLEAR = 1 / 8  # a distance between two points that is seldom less
LARGEST_SMOOTH = 7 / 8  # where no point is within 1


def proven(largest: float, lipschitz: float, cell_error: float | None, fixed: float, parts: dict[str, float]) -> ProvenBounds:
    """Distances leave their range by their errors."""
    return derived(largest, largest, lipschitz, cell_error, parts, fixed, largest + fixed)


def total(parts: dict[str, float]) -> float:
    return sum(parts.values()) * SAFE


# --- Distances --------------------------------------------------------------------------------------------------------

def derive_distances(dims: int, count: int) -> ProvenBounds:
    """Bounds of so many distances."""
    most = {metric: features.largest_distance(dims, count, metric) for metric in features.METRICS}
    lipschitz, fixed = (max(of(metric, dims, largest) for metric, largest in most.items())
                        for of in (distances.metric_slope, distances.fixed_metric_error))
    return proven(max(most.values()), lipschitz, None, fixed, distances.fixed_parts(dims))


def quotes() -> list[tuple[str, str]]:
    plane, space = ([features.largest_distance(dims, count) for count in (1, 2, 3)] for dims in (2, 3))
    return [(ACCURACY, f"{listed(plane)} in 2D, and below {listed(space)} in 3D")]


def of_distances(first: int, count: int) -> Proof:
    """The proof of a noise with so many distances; those from the first on are its own."""
    def ends(dims: int) -> list[float]:
        return [features.largest_distance(dims, number) for number in range(first, count + 1)]

    return Proof(CASES, lambda dims, _: derive_distances(dims, count),
                 lambda dims, _: distances.largest_intermediates(dims), ends, quotes=quotes)


# --- Points that move -------------------------------------------------------------------------------------------------

def derive_phase(dims: int, _: Gradient | None) -> ProvenBounds:
    fixed = max(moving.fixed_distance_error(dims), moving.offset_error(dims, True))
    return proven(moving.largest_distance(dims, 2), math.sqrt(dims), None, fixed, moving.fixed_parts(dims))


def ends_of_phase(dims: int) -> list[float]:
    return [moving.largest_distance(dims, count) for count in (1, 2)]


def quotes_of_phase() -> list[tuple[str, str]]:
    plane, space = (listed(ends_of_phase(dims)) for dims in (2, 3))
    off = [moving.fixed_distance_error(dims) for dims in (2, 3)]
    return [(ACCURACY, f"With a phase the two distances stay below {plane} in 2D, and below {space} in 3D"),
            (ACCURACY, f"the distances are within {scientific(off[0])} in 2D and {scientific(off[1])} in 3D")]


# --- Derivatives ------------------------------------------------------------------------------------------------------

def derive_d(dims: int, _: Gradient | None) -> ProvenBounds:
    largest, parts = features.largest_distance(dims, 1), distances.fixed_parts(dims)
    value = proven(largest, math.sqrt(dims), None, total(parts), parts)
    return replace(value, slope=derive_slope(dims))


def derive_slope(dims: int) -> ProvenBounds:
    parts = distances.fixed_direction_parts(dims)
    return ProvenBounds(0.0, 1.0, 2 * math.sqrt(dims), None, None, None, total(parts), 1 + 2.0**-14, parts)


# --- The smooth one ---------------------------------------------------------------------------------------------------

def least_smooth(dims: int) -> float:
    return 1 - (features.largest_weights(dims) + 1 / 4096) ** 0.25


def derive_smooth(dims: int, _: Gradient | None) -> ProvenBounds:
    lipschitz, parts = features.most_within(dims) ** 0.25 * math.sqrt(dims), distances.fixed_smooth_parts(dims)
    bounds = proven(LARGEST_SMOOTH, lipschitz, None, total(parts), parts)
    return replace(bounds, fixed_largest=LARGEST_SMOOTH)


def quotes_of_smooth() -> list[tuple[str, str]]:
    weights = [shortest(features.largest_weights(dims), 3) for dims in (2, 3)]
    return [(ACCURACY, f"stays below {weights[0]} in 2D and {weights[1]} in 3D")]


# --- Borders ----------------------------------------------------------------------------------------------------------

def derive_border(dims: int, _: Gradient | None) -> ProvenBounds:
    parts = distances.fixed_border_parts(dims)
    return proven(features.largest_border(dims), math.sqrt(dims), distances.border_error(dims), total(parts), parts)


def quotes_of_border() -> list[tuple[str, str]]:
    floats = [scientific(distances.border_error(dims, apart=CLEAR)) for dims in (2, 3)]
    fixed = [scientific(sum(distances.fixed_border_parts(dims, CLEAR).values())) for dims in (2, 3)]
    largest = [shortest(features.largest_border(dims), 3) for dims in (2, 3)]
    return [(ACCURACY, f"at most {floats[0]} in 2D and {floats[1]} in 3D, or {fixed[0]} and {fixed[1]} with"),
            (ACCURACY, f"to a border stays below {largest[0]} and {largest[1]}.")]


# --- By name ----------------------------------------------------------------------------------------------------------

def offset_error(dims: int, fixed: bool) -> float:
    """A component of the offset of a point that is nearest in any metric errs by this, from a position or a cell, in cells.
    In floats it is the published error, which the text proves of hn_cellular; hn_cell_border has the same."""
    return 2.5 * distances.PLACE if fixed else math.nextafter({2: 3.88e-7, 3: 1.05e-6}[dims], 0.0)


PROOFS = {
    "cellular": replace(of_distances(1, 2), offset_error=offset_error),
    "cellular_three": of_distances(3, 3),
    "cellular_phase": Proof(CASES, derive_phase, lambda dims, _: moving.largest_intermediates(dims),
                            ends_of_phase, quotes=quotes_of_phase, offset_error=moving.offset_error,
                            moved_by_sines=moving.moved_by_sines, length=lambda dims: moving.largest_distance(dims, 2)),
    "cellular_d": Proof(CASES, derive_d, lambda dims, _: (
        distances.largest_intermediates(dims) | distances.largest_direction_intermediates(dims)),
                        length=lambda dims: features.largest_distance(dims, 1)),
    "cellular_smooth": Proof(
        CASES, derive_smooth,
        lambda dims, _: distances.largest_intermediates(dims) | distances.largest_smooth_intermediates(dims),
        lambda dims: [-least_smooth(dims)], least_smooth, quotes=quotes_of_smooth),
    "cell_border": Proof(
        CASES, derive_border,
        lambda dims, _: distances.largest_intermediates(dims) | distances.largest_border_intermediates(dims),
        least=lambda _: 0.0, offset_error=offset_error, quotes=quotes_of_border)}
