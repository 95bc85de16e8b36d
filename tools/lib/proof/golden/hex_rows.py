"""The inputs of hex tiling: places on the seams of triangles and beside them, in cells at seams and at the ends of int.

Where a corner changes, floats may give either. So the fractions are such as floats take exactly, or weights and corners
are clear of that. Fixed arithmetic, which is exact, has any.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.golden.period_rows import PERIODS, near_seam
from proof.oracle.integers import UNIT

BOUND = "hex_tiling"
BESIDE = (0, 0, 1, -1, 2**7, -2**7)  # how far from a seam, in units of 2^-20
ENDS = (INT_MIN, INT_MIN + 1, -2**30 - 1, -2**30, -1, 0, 2**30 - 1, 2**30, INT_MAX - 1, INT_MAX)
COUNT = 96
# How far from a seam a place is whose fractions floats round.
CLEAR = Fraction(1, 2**16)
# No multiples of 2^-20, to which fixed arithmetic cuts, on both sides of seams; or outside of a cell.
FIXED_FRACTIONS = (0.0, -0.0, 2.0**-149, 2.0**-21, 2.0**-20 - 2.0**-43, 0.25 - 2.0**-26, 0.25, 0.5 - 2.0**-25, 0.5,
                   0.75 - 2.0**-24, 1 - 2.0**-24, 1.0, -0.25, 1.25)


def on_seam(kind: int, generator: Generator) -> tuple[float, float]:
    """A fraction beside a seam, in units of 2^-20 of a cell: where X, Y or u - v is whole, or several of them are."""
    x, y = generator.integer(0, UNIT), generator.integer(0, UNIT)
    beside, other = generator.pick(BESIDE), generator.pick(BESIDE)
    half, quarter = UNIT // 2, UNIT // 4
    whole = generator.integer(0, 4)
    if kind % 6 == 0:    # X
        y = 2 * (y // 2)
        x = whole * half - y // 2 + beside
    elif kind % 6 == 1:  # Y
        y = whole % 3 * half + beside
    elif kind % 6 == 2:  # u = v
        x, y = whole * half + y // 2 + beside, 2 * (y // 2)
    elif kind % 6 == 3:  # a corner of triangles, which may be one of the cell
        x, y = whole * quarter + beside, whole % 3 * half + other
    elif kind % 6 == 4:  # the end of a cell
        x, y = generator.pick(((UNIT, y), (x, UNIT), (UNIT, UNIT), (0, y), (x, 0)))
    x, y = (c if 0 <= c <= UNIT else c % UNIT for c in (x, y))
    return x / UNIT, y / UNIT


def cut_over_a_seam(generator: Generator) -> tuple[float, float]:
    """A fraction at which another corner is between the others, or X is whole, where its x is not cut off."""
    whole, y = generator.integer(0, 1), generator.integer(0, UNIT // 2 - 1)
    half, half_y = whole * UNIT // 2, y // 2
    x, y = generator.pick(((half + half_y, 2 * half_y), (UNIT - half - half_y - 1, 2 * half_y + 1)))
    return (x + 0.5) / UNIT, y / UNIT


def is_clear(x: float, y: float) -> bool:
    """Whether the corners around a place are those around all places nearby."""
    skewed = 2 * Fraction(x) + Fraction(y), 2 * Fraction(y)
    return all(abs(c - round(c)) > CLEAR for c in (*skewed, skewed[0] - skewed[1]))


def anywhere(generator: Generator) -> tuple[float, float]:
    """A fraction that floats round, and which is clear of seams."""
    while True:
        f = generator.uniform(0, 1), generator.uniform(0, 1)
        if is_clear(*f):
            return f


def near(generator: Generator) -> Sequence[float]:
    """A position near the origin, whose fraction floats may round."""
    while True:
        p = [generator.uniform(-8, 8) for _ in range(2)]
        if is_clear(*p):
            return p


def cell_and_periods(generator: Generator) -> tuple[Row, Row]:
    periods = tuple(generator.pick((*PERIODS, 1, 2, 3, 0)) for _ in range(2))
    reach = generator.pick((8, 200, 2**31 - 8))
    return tuple(generator.pick((near_seam(period, reach, generator), near_seam(period, reach, generator),
                                 generator.pick(ENDS))) for period in periods), periods


def plain(function: Function, generator: Generator) -> list[Row]:
    """On seams and beside them, and clear of them."""
    rows: list[Row] = []
    for index in range(COUNT):
        f = on_seam(index, generator)
        if function.form == "cell":
            for fraction in (f, anywhere(generator)):
                cell, periods = cell_and_periods(generator)
                rows.append((*cell, *fraction, *periods, generator.seed()))
            continue
        far = generator.pick((0, 0, 4, 8, -8, 2**21, -2**21))
        steps = UNIT if abs(far) <= 8 else 4  # which a float of that size has
        p = (far + generator.integer(-4, 3) + math.floor(x * steps) / steps for x in f)
        rows += [(*p, generator.seed()), (*near(generator), generator.seed())]
    return rows


def fixed(function: Function, generator: Generator) -> list[Row]:
    """Inputs that are cut off, and positions of any size."""
    if function.form == "cell":
        rows = []
        for index in range(COUNT):
            cell, periods = cell_and_periods(generator)
            f = (generator.pick((generator.pick(FIXED_FRACTIONS), generator.uniform(0, 1))) for _ in range(2))
            rows.append((*cell, *(cut_over_a_seam(generator) if index % 4 == 0 else f), *periods, generator.seed()))
        return rows
    beside = [to_f32(sign * (c + part)) for sign in (1, -1) for c in (0, 0.25, 0.5, 1, 7.75)
              for part in (2.0**-21, -2.0**-21, 2.0**-149, 0)]
    rows = [(generator.pick(beside), generator.pick(beside), generator.seed()) for _ in range(COUNT // 2)]
    return rows + [(*generator.anywhere(2), generator.seed()) for _ in range(COUNT // 2)]
