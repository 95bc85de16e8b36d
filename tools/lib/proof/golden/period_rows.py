"""The inputs of functions with periods: each period along an axis of its own, at seams and far from them."""

from __future__ import annotations

from collections.abc import Sequence

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32

# 0 and less are none.
PERIODS = (0, 1, 2, 3, 5, 7, 48, 64, 1000003, 2**20, 2**30, INT_MAX, -1, -48, INT_MIN)


def sets_of_periods(n: int, generator: Generator) -> list[tuple[int, ...]]:
    """For 96 rows, in four dimensions for 48: each period along all axes, then each with others."""
    alike, count = (1, 48) if n == 4 else (3, 96)
    sets = [(period,) * n for period in PERIODS for _ in range(alike)]
    return sets + [tuple(generator.pick(PERIODS) for _ in range(n)) for _ in range(count - len(sets))]


def near_seam(period: int, reach: int, generator: Generator) -> int:
    """A cell next to a multiple of the period, up to `reach` from 0: mostly the one with points on both sides."""
    step = period if 0 < period <= reach else 1
    return step * generator.integer(-(reach // step), reach // step) + generator.pick((-2, -1, -1, 0, 1))


ENDS = (INT_MIN, INT_MIN + 1, INT_MAX - 1, INT_MAX)
FRACTIONS = (0.0, 2.0**-126, 2.0**-24, 0.375, 0.5, 1 - 2.0**-24, 1.0)


def rows_of(function: Function, generator: Generator) -> list[Row]:
    """Positions with an eighth's fraction, or any, near seams where the domain has some; or cells near seams up to the
    ends of int, where the corners of the last cells lie beyond it."""
    is_cell, rows = function.form == "cell", []
    for index, periods in enumerate(sets_of_periods(function.axes, generator)):
        reach = (8, 200, 2**31 - 8 if is_cell else 2**20)[index % 3]
        if is_cell:
            cell = [generator.pick((near_seam(period, reach, generator), near_seam(period, reach, generator),
                                    generator.pick(ENDS))) for period in periods]
            place = (*cell, *(generator.pick((*FRACTIONS, generator.uniform(0, 1))) for _ in periods))
        else:
            fraction = generator.pick((0.0, 0.125, 0.875, generator.uniform(0, 1)))
            place = tuple(to_f32(near_seam(period, reach, generator) + fraction) for period in periods)
        rows.append((*place, *periods, generator.seed()))
    return rows


def inserted(rows: Sequence[Row], n: int, place: int, generator: Generator) -> list[Row]:
    """Rows of the form without periods, with some at their place: behind the position, or behind the fraction."""
    return [row[:place] + tuple(generator.pick(PERIODS) for _ in range(n)) + row[place:] for row in rows]
