"""Rows of Perlin-Worley noise: as for octave sums, and places at the points of cells and far from all of them."""

from __future__ import annotations

from collections.abc import Sequence

from catalog.tables.functions import Function
from proof.golden import sum_rows
from proof.golden.generator import Generator, Row, to_f32
from proof.oracle import perlin_worley
from proof.oracle.feature_points import DIRECTION_UNIT, direction
from proof.oracle.gradients import Knobs
from proof.oracle.hashes import MASK, SEED_STEP, mix
from proof.oracle.lattice import Lattice

BOUND = "perlin_worley"

# With the default hash and this seed, all points are farther from this corner than 1.16, so that their octave is below
# -1. It is the best of some million seeds.
FAR, FAR_SEED = (2, -3, 1), 4833969
# Octaves, lacunarities and gains: one octave of cells is alone, or counts most. From the fourth on there are no cells.
SETTINGS = ((1, 2.0, 0.5), (2, 2.0, 0.0), (3, 2.0, 0.0625), (4, 2.0, 0.03125), (33, 1.0, 0.0))
PERIODS = ((0, 0, 0), (5, 0, 7), (1, 2, 3))


def at_point(cell: Sequence[int], seed: int) -> tuple[float, ...]:
    """Where the first octave has the point of a cell, with the default hash and without periods."""
    word = Lattice(Knobs("lattice"), mix(seed + SEED_STEP & MASK)).word(cell)
    return tuple(c + 0.5 + u / (2 * DIRECTION_UNIT) for c, u in zip(cell, direction(word, len(cell))))


def special(function: Function, generator: Generator) -> list[Row]:
    rows = []
    for turn, (octaves, lacunarity, gain) in enumerate(SETTINGS):
        settings = sum_rows.settings(function, octaves, lacunarity, gain, 0.0)
        periods = PERIODS[turn % 2] * function.has_period
        # The positions of later octaves are floats only if the first has few bits, unless they are whole numbers.
        for beside in (0.0, 2.0**-10 if function.has_cell else 2.0**-4, -2.0**-6):
            point = [x + beside for x in FAR]
            rows.append(sum_rows.split(function, point) + periods + settings + (FAR_SEED,))
        seed = generator.seed()
        cell = [generator.integer(0, 4) for _ in FAR]  # which no such period replaces
        for beside in (0.0, 2.0**-20, -2.0**-10) * (function.has_cell or octaves == 1):
            point = [x + beside * (axis == turn % 3) for axis, x in enumerate(at_point(cell, seed))]
            rows.append(sum_rows.split(function, point) + periods + settings + (seed,))
    # With small periods the same few points stand around.
    for octaves in (1, 2, 3, 4) * function.has_period:
        point = [generator.integer(-8, 8) + generator.integer(0, 7) / 8 for _ in FAR]
        rows.append(sum_rows.split(function, point) + PERIODS[2] +
                    sum_rows.settings(function, octaves, 2.0, 0.5, 0.0) + (generator.seed(),))
    return rows


def plain(function: Function, generator: Generator) -> list[Row]:
    rows = sum_rows.plain(function, generator) + special(function, generator)
    for octaves, gain in ((perlin_worley.MOST, 1.0), (perlin_worley.MOST + 1, 1.0), (5, 0.75)):
        rows.append(sum_rows.drawn(function, octaves, 2.0, to_f32(gain), generator))
    return rows


fixed = sum_rows.fixed
