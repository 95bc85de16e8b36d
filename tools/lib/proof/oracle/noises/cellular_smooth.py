"""Section 16 of docs/reference/contract.md: a sum over all points of cells that are near, without creases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from proof.oracle.feature_points import EUCLIDEAN, BlockTooSmall, Field, Point, fixed_root, root, square
from proof.oracle.lattice import Lattice

UNITS = (2**19,)


def near_points(field: Field) -> Iterator[Point]:
    """All points nearer than 1, and some others."""
    if square(field.outside) < field.arithmetic.unit**2:
        raise BlockTooSmall(f"the block around {field} is smaller than a cell")
    for beside, least in field.candidates():
        if square(least) < field.arithmetic.unit**2:
            yield field.point(beside)


# --- Exact ------------------------------------------------------------------------------------------------------


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    field = Field.exact(lattice, cell, f, EUCLIDEAN)
    distances = [field.arithmetic.distance(EUCLIDEAN, point.rank) for point in near_points(field)]
    total = sum((max(Fraction(0), 1 - d)**4 for d in distances), Fraction(0))
    return (1 - root(root(total + Fraction(1, 4096))),)


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed_weight(rank: int) -> int:
    """The fourth power of 1 less the distance, in units of 2^-30."""
    t = min(max(2**18 - fixed_root(rank), 0) // 4, 65535)
    q = t * t // 2**16
    return q * q // 4


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    total = sum(fixed_weight(point.rank) for point in near_points(Field.fixed(lattice, cell, fraction, EUCLIDEAN)))
    return (2**19 - fixed_root(fixed_root(total + 2**18) * 2**11),)
