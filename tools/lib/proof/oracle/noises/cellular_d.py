"""Section 16 of docs/reference/contract.md: the distance of the nearest point, and its derivatives."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.feature_points import EUCLIDEAN, Field, fixed_root, fixed_square, root, square
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.lattice import Lattice

UNITS = (NOISE_UNIT,) * 4

# --- Exact ------------------------------------------------------------------------------------------------------


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    field = Field.exact(lattice, cell, f, EUCLIDEAN)
    point, = field.nearest(1)
    value = field.arithmetic.distance(EUCLIDEAN, point.rank)
    if not value:
        return (value, *(Fraction(0) for _ in cell))
    slopes = [root(Fraction(d * d, square(point.offset))) for d in point.offset]
    return (value, *(-slope if d < 0 else slope for slope, d in zip(slopes, point.offset)))


# --- Fixed ------------------------------------------------------------------------------------------------------


def enlarged(d: Sequence[int]) -> tuple[int, ...]:
    """k D: offsets in the same direction, which are not small."""
    m = max(map(abs, d))
    a = 1024 if m < 1024 else 1
    b = 32 * a if m * a < 32768 else a
    k = 4 * b if m * b < 131072 else b
    return tuple(k * x for x in d)


def fixed_slopes(d: Sequence[int]) -> tuple[int, ...]:
    """In units of 2^-21."""
    large = enlarged(d)
    r = max(fixed_root(fixed_square(large)), 1)
    magnitudes = [abs(x) * 2**19 // r for x in large]
    return tuple(int(math.copysign(1, x)) * slope for slope, x in zip(magnitudes, d))


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    point, = Field.fixed(lattice, cell, fraction, EUCLIDEAN).nearest(1)
    return (8 * fixed_root(point.rank), *fixed_slopes(point.offset))
