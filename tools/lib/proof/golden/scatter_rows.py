"""The inputs of scattered points: cells at seams and at the ends of int, and radii between which a candidate falls."""

from __future__ import annotations

import math
from collections.abc import Callable

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.golden.period_rows import near_seam
from proof.oracle import scatter
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice

PERIODS = (0, 0, 1, 2, 3, 5, 64, 1000003, 2**30, INT_MAX, -1, INT_MIN)
ENDS = (INT_MIN, INT_MIN + 1, -1, 0, INT_MAX - 1, INT_MAX)
# Numbers beyond an end count as the end; less than a unit is cut off.
RADII = tuple(map(to_f32, (0.0, -0.0, -2.0**-15, -1.0, -3e38, 1e-40, 2.0**-16, 2.0**-15, 3 * 2.0**-16, 0.5,
                           1 - 2.0**-15, 1 - 2.0**-24, 1.0, 1 + 2.0**-23, 1.5, 2.0, 65536.0, 3e38)))
COUNT = 96  # of cells
# The knobs with which pairs of radii are next to a distance. With other hashes they are radii like others.
KNOBS = Knobs("lattice")

# Cells whose nearest rival is a whole number of units away, with the default hash and the seed 0: the first ones of a
# search. With the radius that is this distance the candidate stands, and with one that is a unit larger it does not.
WHOLE_DISTANCES = ((12, 6), (611, 26), (1122, -18), (526, -22, 3), (855, 3, -4), (1169, -40, 5))


def place(n: int, generator: Generator) -> Row:
    """A cell, mostly next to a seam or at an end of int, and its periods."""
    periods = tuple(generator.pick(PERIODS) for _ in range(n))
    reach = generator.pick((8, 200, 2**31 - 8))
    return (*(generator.pick((near_seam(period, reach, generator), near_seam(period, reach, generator),
                              generator.pick(ENDS))) for period in periods), *periods)


def places(n: int, generator: Generator) -> list[Row]:
    """Each end along all axes, in a tile and not, then any."""
    rows = [(end,) * n + (period,) * n for end in ENDS for period in (0, 1, 2, 3, INT_MAX)]
    return rows + [place(n, generator) for _ in range(COUNT - len(rows))]


def nearest_rival(row: Row, seed: int) -> tuple[tuple[int, ...], int] | None:
    """The step to the cell, and the square of the distance in units, of what fells the candidate first."""
    n = len(row) // 2
    rivals = scatter.rivals(Lattice(KNOBS, seed, tuple(row[n:])), row[:n])
    return min(rivals, key=lambda rival: rival[1], default=None)


def around(row: Row, square: int, seed: int) -> list[Row]:
    """With the largest radius with which the candidate stands, one that is cut off to it, and the next one."""
    largest = math.isqrt(square)
    return [(*row, radius / scatter.UNIT, seed) for radius in (largest, largest + 0.75, largest + 1)]


def neighbours(n: int, generator: Generator) -> list[Row]:
    """Where each neighbour fells the candidate first."""
    def somewhere() -> Row:
        return (*(generator.integer(-200, 200) for _ in range(n)), *(0,) * n)

    return felled(set(scatter.steps(n)), lambda row, step: {step}, somewhere, generator)


def across_seams(n: int, generator: Generator) -> list[Row]:
    """Where that is one across a seam, along each axis and to either side."""
    def in_a_tile() -> Row:
        periods = [generator.pick((2, 3, 5)) for _ in range(n)]
        return (*(near_seam(period, 200, generator) for period in periods), *periods)

    def shown(row: Row, step: tuple[int, ...]) -> set:
        return {(axis, o) for axis, (c, period, o) in enumerate(zip(row, row[n:], step))
                if o and c % period == (period - 1 if o > 0 else 0)}

    return felled({(axis, o) for axis in range(n) for o in (-1, 1)}, shown, in_a_tile, generator)


def across_ends(n: int, generator: Generator) -> list[Row]:
    """Where that is one beyond the range of int, in a tile and not."""
    def at_an_end() -> Row:
        cell = [generator.integer(-200, 200) for _ in range(n)]
        cell[generator.integer(0, n - 1)] = generator.pick((INT_MIN, INT_MAX))
        return (*cell, *(generator.pick((0, 7)),) * n)

    def shown(row: Row, step: tuple[int, ...]) -> set:
        return {(axis, o, row[n]) for axis, (c, o) in enumerate(zip(row, step))
                if (c, o) in ((INT_MIN, -1), (INT_MAX, 1))}

    wanted = {(axis, o, period) for axis in range(n) for o in (-1, 1) for period in (0, 7)}
    return felled(wanted, shown, at_an_end, generator)


def felled(wanted: set, shown: Callable[[Row, tuple[int, ...]], set], place: Callable[[], Row],
           generator: Generator) -> list[Row]:
    """Places, with radii around the nearest rival's, which together show all that is wanted. The things that a
    place shows depend on the step to that rival."""
    rows: list[Row] = []
    while wanted:
        row, seed = place(), generator.seed()
        step, square = nearest_rival(row, seed) or ((), scatter.UNIT**2)
        if square < scatter.UNIT**2 and shown(row, step) & wanted:
            wanted = wanted - shown(row, step)
            rows += around(row, square, seed)
    return rows


def whole_distances(n: int) -> list[Row]:
    rows: list[Row] = []
    for cell in WHOLE_DISTANCES:
        if len(cell) == n:
            row = (*cell, *(0,) * n)
            rows += around(row, nearest_rival(row, 0)[1], 0)
    return rows


def rows_of(function: Function, generator: Generator) -> list[Row]:
    n = function.axes
    if "radius" not in function.takes:
        return [(*row, generator.seed()) for row in places(n, generator)]
    rows = [(*place(n, generator), radius, generator.seed()) for radius in RADII for _ in range(3)]
    rows += [(*row, generator.pick((1.0, 0.75, generator.uniform(0, 1))), generator.seed())
             for row in places(n, generator)]
    for of in (neighbours, across_seams, across_ends):
        rows += of(n, generator)
    return rows + whole_distances(n)
