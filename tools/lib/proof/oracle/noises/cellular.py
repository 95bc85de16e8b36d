"""Section 16 of docs/reference/contract.md: the distances of the nearest points of cells, with derivatives, with points
that go round with a phase, and a sum over all points that are near, without creases. (cell_border.py has borders.)"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from proof.oracle.feature_points import (
    EUCLIDEAN,
    BlockTooSmall,
    Field,
    Point,
    exact_field,
    fixed_field,
    fixed_root,
    fixed_square,
    root,
    square,
    whole_numbers,
)
from proof.oracle.integers import NOISE_UNIT, UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise, rotating

# --- Distances --------------------------------------------------------------------------------------------------


def distances(name: str, *outputs: str) -> Noise:
    """So many of them."""
    def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
        return exact_field(lattice, cell, f).distances(len(outputs))

    def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
        return whole_numbers(fixed_field(lattice, cell, fraction).distances(len(outputs)), UNIT)

    return Noise(name, exact, fixed, outputs, (UNIT,) * len(outputs))


# --- Derivatives ------------------------------------------------------------------------------------------------


def exact_d(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    field = Field.exact(lattice, cell, f, EUCLIDEAN)
    point, = field.nearest(1)
    value = field.arithmetic.distance(EUCLIDEAN, point.rank)
    if not value:
        return (value, *(Fraction(0) for _ in cell))
    slopes = [root(Fraction(d * d, square(point.offset))) for d in point.offset]
    return (value, *(-slope if d < 0 else slope for slope, d in zip(slopes, point.offset)))


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


def fixed_d(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    point, = Field.fixed(lattice, cell, fraction, EUCLIDEAN).nearest(1)
    return (8 * fixed_root(point.rank), *fixed_slopes(point.offset))


# --- The smooth one ---------------------------------------------------------------------------------------------


def near_points(field: Field) -> Iterator[Point]:
    """All points nearer than 1, and some others."""
    if square(field.outside) < field.arithmetic.unit**2:
        raise BlockTooSmall(f"the block around {field} is smaller than a cell")
    for beside, least in field.candidates():
        if square(least) < field.arithmetic.unit**2:
            yield field.point(beside)


def exact_smooth(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    field = Field.exact(lattice, cell, f, EUCLIDEAN)
    distances = [field.arithmetic.distance(EUCLIDEAN, point.rank) for point in near_points(field)]
    total = sum((max(Fraction(0), 1 - d)**4 for d in distances), Fraction(0))
    return (1 - root(root(total + Fraction(1, 4096))),)


def fixed_weight(rank: int) -> int:
    """The fourth power of 1 less the distance, in units of 2^-30."""
    t = min(max(2**18 - fixed_root(rank), 0) // 4, 65535)
    q = t * t // 2**16
    return q * q // 4


def fixed_smooth(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    total = sum(fixed_weight(point.rank) for point in near_points(Field.fixed(lattice, cell, fraction, EUCLIDEAN)))
    return (2**19 - fixed_root(fixed_root(total + 2**18) * 2**11),)


CELLULAR = distances("cellular", "first", "second")
NOISES = (CELLULAR, rotating(CELLULAR, "cellular_phase"), distances("cellular_three", "first", "second", "third"),
          Noise("cellular_d", exact_d, fixed_d, units=(NOISE_UNIT,) * 4),
          Noise("cellular_smooth", exact_smooth, fixed_smooth, units=(2**19,)))
