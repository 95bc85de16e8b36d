"""The ranges of cellular noise, from docs/reference/contract.md, section 16. features.py, moving.py and borders.py of the
folder above have the geometry; here it is put together.

HN_CELLULAR and HN_CELLULAR_THREE. One bound holds for all metrics: the largest, which is the hybrid metric's.

HN_CELLULAR_D. The value is the first of hn_cellular, in the Euclidean metric. A derivative is a component of (position
- point) / distance: at most 1.

HN_CELLULAR_SMOOTH. The sum of weights is largest where two points are at the place, in the middle of a wall, and others
as near as they can be. It is nowhere 4, so it fits 32 bits in units of 2^-30.
"""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import features, moving
from proof.bounds.noises import Proof, ProvenBounds, listed
from proof.bounds.table import shortest

ACCURACY = "docs/measured/accuracy.md"
CASES = ((2, None), (3, None))
LARGEST_SMOOTH = 7 / 8  # where no point is within 1


def within(largest: float) -> ProvenBounds:
    return ProvenBounds(largest, largest)


# --- Distances --------------------------------------------------------------------------------------------------------

def derive_distances(dims: int, count: int) -> ProvenBounds:
    return within(max(features.largest_distance(dims, count, metric) for metric in features.METRICS))


def quotes() -> list[tuple[str, str]]:
    plane, space = ([features.largest_distance(dims, count) for count in (1, 2, 3)] for dims in (2, 3))
    return [(ACCURACY, f"{listed(plane)} in 2D, and below {listed(space)} in 3D")]


def of_distances(first: int, count: int) -> Proof:
    """The proof of a noise with so many distances; those from the first on are its own."""
    def ends(dims: int) -> list[float]:
        return [features.largest_distance(dims, number) for number in range(first, count + 1)]

    return Proof(CASES, lambda dims, _: derive_distances(dims, count), ends, quotes=quotes)


# --- Points that move -------------------------------------------------------------------------------------------------

def ends_of_phase(dims: int) -> list[float]:
    return [moving.largest_distance(dims, count) for count in (1, 2)]


def quotes_of_phase() -> list[tuple[str, str]]:
    plane, space = (listed(ends_of_phase(dims)) for dims in (2, 3))
    return [(ACCURACY, f"With a phase the two distances stay below {plane} in 2D, and below {space} in 3D")]


# --- The smooth one ---------------------------------------------------------------------------------------------------

def least_smooth(dims: int) -> float:
    return 1 - (features.largest_weights(dims) + 1 / 4096) ** 0.25


def quotes_of_smooth() -> list[tuple[str, str]]:
    weights = [shortest(features.largest_weights(dims), 3) for dims in (2, 3)]
    return [(ACCURACY, f"stays below {weights[0]} in 2D and {weights[1]} in 3D")]


# --- Borders ----------------------------------------------------------------------------------------------------------

def quotes_of_border() -> list[tuple[str, str]]:
    largest = [shortest(features.largest_border(dims), 3) for dims in (2, 3)]
    return [(ACCURACY, f"to a border stays below {largest[0]} and {largest[1]}.")]


# --- By name ----------------------------------------------------------------------------------------------------------

PROOFS = {
    "cellular": of_distances(1, 2),
    "cellular_three": of_distances(3, 3),
    "cellular_phase": Proof(CASES, lambda dims, _: within(moving.largest_distance(dims, 2)), ends_of_phase,
                            quotes=quotes_of_phase),
    "cellular_d": Proof(CASES, lambda dims, _: replace(within(features.largest_distance(dims, 1)),
                                                       slope=ProvenBounds(0.0, 1.0))),
    "cellular_smooth": Proof(CASES, lambda *_: within(LARGEST_SMOOTH), lambda dims: [-least_smooth(dims)], least_smooth,
                             quotes=quotes_of_smooth),
    "cell_border": Proof(CASES, lambda dims, _: within(features.largest_border(dims)), least=lambda _: 0.0,
                         quotes=quotes_of_border)}
