"""Section 16 of docs/reference/contract.md: the nearest point of cellular noise, its cell and its offset."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.feature_points import exact_field, fixed_field
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise


def exact_cell(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[int, ...]:
    point, = exact_field(lattice, cell, f).nearest(1)
    return point.named(lattice)


def fixed_cell(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    point, = fixed_field(lattice, cell, fraction).nearest(1)
    return point.named(lattice)


def exact_offset(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    field = exact_field(lattice, cell, f)
    point, = field.nearest(1)
    return tuple(Fraction(-d, field.arithmetic.unit) for d in field.arithmetic.straight(point.offset))


def fixed_offset(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    field = fixed_field(lattice, cell, fraction)
    point, = field.nearest(1)
    return tuple(-d for d in field.arithmetic.straight(point.offset))


# With the Euclidean metric, if none is chosen, these are what borders give, too. Rotated they are of points that move.
NEAREST = Noise("nearest", exact_cell, fixed_cell, ("nx", "ny", "nz"), (1,) * 3, rotates=True)
OFFSET = Noise("offset", exact_offset, fixed_offset, ("ox", "oy", "oz"), (UNIT,) * 3, rotates=True)
