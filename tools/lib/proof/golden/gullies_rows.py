"""Rows of gullies: slopes of all lengths and directions, depths, and the settings of octave sums.

Each octave of gullies goes where those before it have turned the slope, so an error grows from octave to octave. Most
rows that floats are compared with have few octaves, and a depth that turns slopes little.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from catalog.tables.functions import Function
from proof.golden import simplex_rows, sum_rows
from proof.golden.generator import FIXED_COORDINATES, INT_MAX, Generator, Row, to_f32
from proof.golden.period_rows import PERIODS

BOUND = "gullies"

# None, along each axis and a diagonal, where half of a wave is left, hardly any, so little that the square of it is a
# subnormal number or none, with a component that is hardly there, the largest, and what counts as that.
SLOPES = tuple(tuple(map(to_f32, slope)) for slope in (
    (0.0, 0.0), (-0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.6, 0.8), (-0.5, 0.5), (0.125, 0.0),
    (0.0, -0.125), (2.0**-10, -2.0**-12), (-2.0**-30, 2.0**-30), (2.0**-66, 0.0), (2.0**-100, 0.0),
    (1.0, 2.0**-20), (-2.0**-16, -2.0), (8.0, 0.0), (-8.0, 8.0), (8 - 2.0**-20, -8 + 2.0**-20),
    (9.0, 0.5), (-0.25, -300.0), (3e38, -3e38)))
# Numbers that fixed arithmetic cuts to a multiple of 2^-16, and lengths of few units of it.
CUT = tuple(tuple(map(to_f32, slope)) for slope in (
    (1e-40, -1e-40), (2.0**-149, 0.0), (2.0**-17, -2.0**-17), (2.0**-16 - 2.0**-40, 2.0**-16),
    (-3 * 2.0**-17, 2.0**-15), (63 * 2.0**-16, 0.0), (0.0, -64 * 2.0**-16), (65 * 2.0**-16, 1.0),
    (8 - 2.0**-16, 8 - 2.0**-17), (-8 + 2.0**-17, 8 + 2.0**-20), (1 / 3, -1 / 7), (-3e38, 2.0**-16)))
# With how many octaves a depth is: one that is deeper than usual has one, so that no error grows.
DEPTHS = ((0.0, 3), (0.02, 3), (0.1, 3), (0.2, 2), (1.0, 1), (8.0, 1), (9.0, 1), (3e38, 1), (-1.0, 3), (2.0**-20, 2))
FIXED_DEPTHS = (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 1 / 3, 7.9, 8 - 2.0**-18, 8 + 2.0**-17, 3e38, -3e38)
# Octaves, lacunarities and gains.
SETTINGS = ((2, 2.0, 0.5), (3, 2.0, 0.5), (3, 2.0, 0.25), (3, 1.0, 1.0), (2, 2.96875, 0.5), (3, 1.5, 0.75),
            (2, 3.0, 0.25), (3, 2.5, 0.5), (3, 0.5, 0.5), (2, 0.0, 1.0), (2, -1.5, 0.5), (3, 2.0, 0.0), (2, 1.0, 1.5),
            (4, 2.0, 0.25), (6, 2.0, 0.125))
# With these a second octave has slopes of many cells.
STEEP_SETTINGS = ((2, 255.0, 2.0**-7), (2, 300.0, 2.0**-8), (2, 16.0, 0.0625))
# Octaves, lacunarities, gains and depths at the ends of what keeps slopes in their range.
LARGEST = ((2, 8.0, 1.0, 8.0), (7, 2.0, 1.0, 1.0), (4, 4.0, 1.0, 1.0), (2, 255.0, 1.0, 0.25), (32, 1.0, 1.0, 8.0),
           (32, 255.0, 1 / 256, 8.0), (12, 2.0, 1.0, 2.0**-6))
LARGEST_DEPTH, LARGEST_GROWTH = 64, 4096

# A footprint at which an octave begins to fade, or is gone, is 1/4 or 3/4 over a power of the lacunarity.
FOOTPRINTS = (0.0, 0.25, 0.75, 0.125, 0.375, 0.0625, 0.1875, 0.5, 0.3125, 1.0)
FIXED_FOOTPRINTS = (-0.0, 1e-40, 2.0**-26, 2.0**-25, 3 * 2.0**-25, 1 / 7, 0.25 + 2.0**-19, 0.75 - 2.0**-19,
                    0.75 - 2.0**-24, 1.0, 2.0, 3e38, -1.0)


def settings(function: Function, slope: Sequence[float], octaves: int, lacunarity: float, gain: float, depth: float,
             footprint: float) -> Row:
    """In the order of the columns."""
    floats = {"footprint": footprint, "ex": slope[0], "ey": slope[1], "lacunarity": lacunarity, "gain": gain,
              "depth": depth}
    return tuple(octaves if name == "octaves" else to_f32(floats[name]) for name in function.settings)


def visible_at(generator: Generator) -> float:
    return generator.pick((0.0, generator.uniform(0, 0.25), generator.uniform(0.25, 0.75), *FOOTPRINTS))


def slope_of(index: int, slopes: Sequence[tuple[float, float]], generator: Generator) -> tuple[float, float]:
    """The length in a row by its number: every other one is an edge."""
    if index % 2:
        return slopes[index // 2 % len(slopes)]
    most = (0.03125, 1.0, 2.0, 8.0)[index // 2 % 4]
    return (generator.uniform(-most, most), generator.uniform(-most, most))


# --- Of every arithmetic ------------------------------------------------------------------------------------------


def on_triangles(function: Function, index: int, generator: Generator) -> Row:
    """A place where points of the lattice under the waves come, go, or are as near as others."""
    fractions = simplex_rows.fractions(2, 27, generator)
    f = fractions[index % len(fractions)]
    cell = [generator.integer(-4, 3) for _ in f]
    return sum_rows.split(function, [c + x for c, x in zip(cell, f)])


def drawn(function: Function, index: int, of_octaves: tuple[int, float, float], depth: float,
          generator: Generator) -> Row:
    octaves, lacunarity, gain = of_octaves
    periods = sum_rows.periods_of(function, octaves, lacunarity, generator)
    if index % 3:
        place = sum_rows.somewhere(function, octaves, lacunarity, periods, generator)
    else:
        place = on_triangles(function, index // 3, generator)
    slope = slope_of(index, SLOPES, generator)
    return place + periods + settings(function, slope, octaves, lacunarity, gain, depth,
                                      visible_at(generator)) + (generator.seed(),)


def plain(function: Function, generator: Generator) -> list[Row]:
    """96 rows, and more of those with a footprint."""
    rows, none = [], (0,) * (2 * function.has_period)
    for point, octaves, gain, seed in (*(((0.0, 0.0), octaves, 0.5, 0) for octaves in (-1, 0, 1, 2, 3)),
                                       ((64.0, -64.0), 3, 0.5, 0), ((-1.0, -1.0), 1, 0.5, 1), ((0.5, 0.5), 3, 0.0, 0)):
        rows.append(sum_rows.split(function, point) + none +
                    settings(function, (0.75, -0.5), octaves, 2.0, gain, 0.1, 0.0) + (seed,))
    for index, (depth, octaves) in enumerate(DEPTHS * 2):
        rows.append(drawn(function, 3 * index, (octaves, 2.0, 0.5), depth, generator))
    for index, (of_octaves, depth) in enumerate(zip(STEEP_SETTINGS * 2, itertools.cycle((0.02, 0.01)))):
        rows.append(drawn(function, index, of_octaves, depth, generator))
    for footprint in FOOTPRINTS * ("footprint" in function.settings):
        *row, seed = drawn(function, len(rows), generator.pick(((3, 2.0, 0.5), (2, 3.0, 0.25))), 0.1, generator)
        row[function.settings.index("footprint") - len(function.settings)] = footprint
        rows.append((*row, seed))
    for index, of_octaves in zip(range(max(96 - len(rows), 66)), itertools.cycle(SETTINGS)):
        depth = 0.05 if of_octaves[0] > 3 else generator.pick((0.02, 0.1, 0.2, generator.uniform(0.02, 0.2)))
        rows.append(drawn(function, index, of_octaves, depth, generator))
    return rows


# --- Fixed arithmetic ---------------------------------------------------------------------------------------------


def growths(octaves: int, lacunarity: float, gain: float) -> list[float]:
    """(gain * lacunarity)^i of each octave, as fixed arithmetic takes them."""
    growth = min(max(gain, 0), 1) * math.floor(min(max(lacunarity, 0), 255))
    return [growth**i for i in range(min(octaves, 32))]


def kept(octaves: int, lacunarity: float, gain: float, depth: float) -> float:
    """The gain, or a lower one with which slopes keep their range."""
    largest = min(LARGEST_DEPTH / min(max(depth, 2.0**-18), 8), LARGEST_GROWTH)
    if max(growths(octaves, lacunarity, gain), default=0) <= largest:
        return gain
    return to_f32(0.999 * largest**(1 / (min(octaves, 32) - 1)) / math.floor(min(lacunarity, 255)))


def of_fixed(function: Function, index: int, place: Row, of_octaves: tuple[int, float, float], depth: float,
             generator: Generator, footprint: float | None = None) -> Row:
    octaves, lacunarity, gain = of_octaves
    periods = tuple(generator.pick(PERIODS) for _ in range(2 * function.has_period))
    slope = slope_of(index, SLOPES + CUT, generator)
    footprint = visible_at(generator) if footprint is None else footprint
    gain = kept(octaves, lacunarity, gain, depth)
    of_settings = settings(function, slope, octaves, lacunarity, gain, depth, footprint)
    return place + periods + of_settings + (generator.seed(),)


def fixed(function: Function, generator: Generator) -> list[Row]:
    """Inputs that are cut off, odd inputs, many octaves, and places at edges and far."""
    rows: list[Row] = []

    def add(place: Row, of_octaves: tuple[int, float, float], depth: float, footprint: float | None = None) -> None:
        rows.append(of_fixed(function, len(rows), place, of_octaves, depth, generator, footprint))

    for octaves in (-1, 0, 1, 2, 3, 31, 32, 33, INT_MAX):
        add(sum_rows.any_place(function, generator), (octaves, 2.0, 0.5), 0.25, 0.0)
    if function.has_cell:
        for index, (cell, f) in enumerate(itertools.product(sum_rows.CELLS, (0.0, 0.5, 1.0))):
            add((cell,) * 2 + (f,) * 2, (2 + index % 2, 2.0, 0.5), 0.1)
        for f in sum_rows.FIXED_FRACTIONS:
            add((0, INT_MAX, f, f), (2, 1.5, 0.5), 0.1)
    else:
        for x in FIXED_COORDINATES:
            add((x, x), (2, 1.5, 0.75), 0.1)
    for *of_octaves, depth in LARGEST:
        add(sum_rows.any_place(function, generator), tuple(of_octaves), depth, 0.0)
    for index, depth in enumerate(FIXED_DEPTHS):
        add(sum_rows.any_place(function, generator), (1 + index % 3, 2.0, 0.5), depth)
    for footprint in FIXED_FOOTPRINTS * ("footprint" in function.settings):
        add(sum_rows.any_place(function, generator), (4, 2.0, 0.5), 0.1, footprint)
    for lacunarity, gain in itertools.product(sum_rows.LACUNARITIES, sum_rows.GAINS):
        point = tuple(generator.uniform(-64, 64) for _ in range(2))
        place = generator.pick((sum_rows.split(function, point), sum_rows.any_place(function, generator)))
        add(place, (generator.integer(2, 6), lacunarity, gain), generator.pick((0.02, 0.1, 0.5, 8.0)))
    return rows
