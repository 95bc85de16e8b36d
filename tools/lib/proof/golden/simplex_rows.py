"""The inputs of functions above the lattices of simplex noise, and of those with a phase.

Where a position crosses certain planes, other lattice points count, or are the nearest ones. Positions lie on these
planes and right beside them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.golden.period_rows import near_seam

FINE = 2**20  # fractions are multiples of 2^-20, which fixed arithmetic does not cut
BESIDE = 2.0**-20


def part_of_cell(generator: Generator) -> float:
    return generator.integer(0, FINE - 1) / FINE


def on_triangles(kind: int, generator: Generator) -> tuple[float, float]:
    """A fraction in the plane; in steps, which are halves of a cell, it lies ..."""
    x, y = 2 * part_of_cell(generator), 2 * part_of_cell(generator)
    whole = generator.integer(0, 3)
    points = (
        (x, whole),                     # on a row of points
        (whole + y / 2, y),             # on an edge of triangles, of either direction
        (whole - y / 2, y),
        (whole / 2, y),                 # on the axis of a triangle
        (whole / 2, 0.375 + whole),     # as far from three points, or beside
        (x, 0.5 + whole),               # in the middle between rows
        (x, x),                         # at the same offset along both axes
        (whole / 2 + 0.25, (x // 1) + 0.5),  # in the middle of an edge
        (whole, 0.0))                   # at a point
    u, v = points[kind % len(points)]
    return (u / 2 % 1, v / 2 % 1)


def on_centred(n: int, kind: int, generator: Generator) -> tuple[float, ...]:
    """A fraction in three or four dimensions, ..."""
    f = [part_of_cell(generator) for _ in range(n)]
    first, second = generator.pick([(i, j) for i in range(n) for j in range(n) if i != j])
    if kind % 8 == 0:    # in the middle along an axis
        f[first] = 0.5
    elif kind % 8 == 1:  # at the same offset along two axes
        f[first] = f[second]
    elif kind % 8 == 2:  # at opposite ones
        f[first] = (1 - f[second]) % 1
    elif kind % 8 == 3:  # as far from a corner as from the centre
        f = [x / 2 for x in f]
        f[first] = (n / 4 - (sum(f) - f[first])) % 1
    elif kind % 8 == 4:  # a quarter of a cell from the planes of points
        f[first] = generator.pick((0.25, 0.75))
    elif kind % 8 == 5:  # at a point: a corner or a centre
        f = [generator.pick((0.0, 0.5))] * n
    elif kind % 8 == 6:  # in the middle between points
        f = [generator.pick((0.0, 0.25, 0.5, 0.75)) for _ in range(n)]
    else:                # on an axis through a corner
        f = [x if i == first else 0.0 for i, x in enumerate(f)]
    return tuple(f)


def at_the_end(n: int, square: float, generator: Generator) -> tuple[float, ...]:
    """A fraction whose distance from a point, given by its square in cells, is that at which it ends to
    count, but for 2^-20."""
    towards = [generator.uniform(-1, 1) for _ in range(n)]
    factor = math.sqrt(square / sum(x * x for x in towards))
    return tuple(math.floor(x * factor * FINE) / FINE % 1 for x in towards)


# How far the kernels reach, by the number of dimensions: the squares, in cells.
REACHES = {2: (819 / 4096, 1 / 4), 3: (1 / 2, 3 / 4), 4: (1 / 2, 1 / 2)}


def fractions(n: int, count: int, generator: Generator) -> list[tuple[float, ...]]:
    """On planes, and each right beside one of them; and near the ends of kernels."""
    found = []
    for kind in range(count // 3):
        f = on_triangles(kind, generator) if n == 2 else on_centred(n, kind, generator)
        found.append(f)
        axis, beside = generator.integer(0, n - 1), generator.pick((BESIDE, -BESIDE))
        found.append(tuple((x + beside * (i == axis)) % 1 for i, x in enumerate(f)))
        found.append(at_the_end(n, REACHES[n][kind % 2], generator))
    return found


# Twice a period is the period of the lattice of triangles.
PERIODS = (1, 2, 3, 7, 2**20, 2**30, 1000003, INT_MAX)
ENDS = (INT_MIN, -2**30 - 1, -2**30, -1, 0, 2**30 - 1, 2**30, INT_MAX)


def rows_of(function: Function, generator: Generator) -> list[Row]:
    """Positions near the origin, or also far cells; with periods beside a seam."""
    is_cell, rows = function.form == "cell", []
    for f in fractions(function.axes, 48 if function.has_period else 72, generator):
        periods = [generator.pick(PERIODS) for _ in f] if function.has_period else []
        if not periods:
            cell = [generator.integer(-4, 3) if not is_cell else
                    generator.pick((generator.integer(-4, 3), generator.pick(ENDS))) for _ in f]
        elif is_cell:
            cell = [generator.pick((near_seam(period, 2**31 - 8, generator), INT_MIN, INT_MAX)) for period in periods]
        else:
            cell = [near_seam(period, 8 if period < 8 else 4, generator) for period in periods]
        place = (*cell, *f) if is_cell else tuple(to_f32(c + x) for c, x in zip(cell, f))
        rows.append((*place, *periods, generator.seed()))
    return rows


# --- Curl in space ----------------------------------------------------------------------------------------------

# The fractions along x and z at which the place of its second noise enters the next cell, both sides and the ends.
CROSSINGS = ((0.0, 0.0), (0.5 - BESIDE, 0.75 - BESIDE), (0.5 - 2.0**-25, 0.75 - 2.0**-24), (0.5, 0.75), (0.5, 0.25),
             (0.25, 0.75), (1 - 2.0**-24, 1 - 2.0**-24), (1.0, 1.0), (0.0, 1.0))
CROSSING_CELLS = ((INT_MAX, 5, INT_MAX), (2, INT_MAX, -1))
CROSSING_PERIODS = ((1, 2, 3), (3, 1, 2), (2, 3, 1), (3, 3, 3), (INT_MAX, 7, 0), (0, 0, INT_MAX))


def crossings(function: Function) -> list[Row]:
    """Positions, or cells and fractions. Positions are in small cells, where floats have these fractions."""
    is_cell = function.form == "cell"
    places = [(*cell, x, 0.375, z) if is_cell else (*map(to_f32, (cell[0] + x, cell[1] + 0.375, cell[2] + z)),)
              for cell in (CROSSING_CELLS if is_cell else ((0, 5, 0), (2, 5, -1))) for x, z in CROSSINGS]
    return [(*place, *periods, 7) for place in places
            for periods in (CROSSING_PERIODS if function.has_period else ((),))]


# --- Phases -----------------------------------------------------------------------------------------------------

# Whole turns and quarters, numbers that are cut off, the step of 2^-30 and the end of a turn, and phases far from 0.
PHASES = tuple(map(to_f32, (
    0.0, -0.0, 0.25, 0.5, 0.75, 1.0, -0.25, -0.5, -1.0, 1 / 3, -1 / 3, 0.125, 2.0**-30, -2.0**-30, 2.0**-31, -2.0**-31,
    3 * 2.0**-31, 1e-40, 1 - 2.0**-24, -1 + 2.0**-24, 0.25 - 2.0**-26, 1000.125, -1000.125, 2.0**21 + 0.25,
    2.0**23 - 0.5, 2.0**24, -3e38)))


def phase(index: int, generator: Generator) -> float:
    """The fraction in a row by its number: every other one is an edge."""
    if index % 2:
        return PHASES[index // 2 % len(PHASES)]
    return generator.uniform(-1, 1) if index % 4 else generator.uniform(-1000, 1000)


def with_phases(rows: Sequence[Row], generator: Generator) -> list[Row]:
    """The rows of the form without a phase, with one before the seed."""
    return [(*row[:-1], phase(index, generator), row[-1]) for index, row in enumerate(rows)]
