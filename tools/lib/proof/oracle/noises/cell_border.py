"""Section 16 of docs/reference/contract.md: the distance to the border of the places nearer to one point than to any
other."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TypeVar

from proof.oracle.feature_points import EUCLIDEAN, BlockTooSmall, Field, Point, fixed_root, fixed_square, root, square
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise

Border = TypeVar("Border", int, Fraction)


def smallest(field: Field, between: Callable[[Point, Point], Border],
             cells: Callable[[Border], int]) -> Border:
    """The smallest of what lies between the nearest point and another; `cells` gives a distance, rounded up, of it, in
    the units of the field.

    The distance to the border with a point Q is at least half of what Q is farther than the nearest point P, since P
    and Q are no farther from each other than both distances. A cell is left out where this is more than the found
    distance by 1/64, which is far more than the roundings of fixed arithmetic."""
    slack = field.arithmetic.unit // 64
    (nearest,), found = field.nearest(1), None
    distance = math.isqrt(square(nearest.offset)) + 1

    def may_count(least: Sequence[int]) -> bool:
        return found is None or math.isqrt(square(least)) - distance <= 2 * (cells(found) + slack)

    for _, least, beside in sorted((square(least), least, beside) for beside, least in field.candidates()):
        if not may_count(least):
            break
        point = field.point(beside)
        if point.cell != nearest.cell:
            border = between(nearest, point)
            found = border if found is None else min(found, border)
    if may_count(field.outside):
        raise BlockTooSmall(f"{field} has a border with points outside of the block that is searched")
    return found


def difference(a: Point, b: Point) -> tuple[int, ...]:
    return tuple(x - y for x, y in zip(b.offset, a.offset))


# --- Exact ------------------------------------------------------------------------------------------------------


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    field = Field.exact(lattice, cell, f, EUCLIDEAN)

    def squared(nearest: Point, point: Point) -> Fraction:
        """The square of the distance, in the units of the field."""
        return Fraction((point.rank - nearest.rank)**2, 4 * square(difference(nearest, point)))

    found = smallest(field, squared, lambda border: math.isqrt(math.floor(border)) + 1)
    return (root(found) / field.arithmetic.unit,)


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed_between(nearest: Point, point: Point) -> int:
    """In units of 2^-16."""
    halves = [d // 2 for d in difference(nearest, point)]
    return 16 * (point.rank - nearest.rank) // fixed_root(fixed_square(halves))


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    field = Field.fixed(lattice, cell, fraction, EUCLIDEAN)
    return (smallest(field, fixed_between, lambda border: 16 * (border + 1)),)


NOISES = (Noise("cell_border", exact, fixed, units=(2**16,)),)
