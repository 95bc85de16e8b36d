"""Rows of uniform values: spreads of noises and at the edges of their range, out of it and out of order; values at and
beside the ends of each, and far beyond; octaves and gains likewise."""

from __future__ import annotations

import struct

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.oracle.uniform import TABLE, spread

COUNT = 96  # random rows
NOISES = range(1, len(TABLE) + 1)
NUMBERS = (*NOISES, *range(-20, 1), *range(len(TABLE) + 1, 2 * len(TABLE) + 1), 99, 2**16 + 1, 2**24 + 2, -2**16 + 3,
           INT_MAX, INT_MIN, INT_MIN + 4)

# In range: at its ends, all the same, and as far apart as can be.
EDGES = ((1.0, 0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), (1.0, 0.0, 0.0, 1.0), (1.0, 0.0, 1.0, 1.0), (1.0, 0.5, 0.5, 0.5),
         (3.0, 0.25, 0.5, 0.75), (0.0625, 0.25, 0.5, 0.75), (0.0625, 1.0, 1.0, 1.0), (0.0625, 0.0, 0.0, 0.0))
# Out of range, and out of order.
BEYOND = ((0.03125, 0.25, 0.5, 0.75), (0.0, 0.25, 0.5, 0.75), (-1.0, 0.25, 0.5, 0.75), (4.0, 0.25, 0.5, 0.75),
          (1.0, -0.5, 0.5, 0.75), (1.0, 0.25, 0.5, 1.5), (1.0, 1.5, 2.0, 3.0), (1.0, -3.0, -2.0, -1.0),
          (1.0, 0.75, 0.5, 0.25), (1.0, 0.25, 0.75, 0.5), (1.0, 0.5, 0.25, 0.75), (1e30, 1e30, -1e30, 1e30),
          (0.05, 2.0, -1.0, 0.5))
# Which fixed arithmetic cuts to integers whose products keep some bits, and which floats may take for 0.
CUT = ((0.0625 + 2.0**-22, 2.0**-22, 3 * 2.0**-22, 1 - 2.0**-24), (3 - 2.0**-22, 2.0**-21, 2.0**-20, 1 - 2.0**-21),
       (1 / 3, 1e-40, 511 * 2.0**-21, 513 * 2.0**-21), (-0.0, -0.0, 2.0**-149, 3.4e38), (3.4e38, -3.4e38, 1 / 3, 2 / 3),
       (1 + 2.0**-23, 1 / 7, 1 / 7 + 2.0**-23, 0.9), (0.1, 511 * 2.0**-18, 513 * 2.0**-18, 1 - 2.0**-18))
TINY = (2.0**-149, 2.0**-126, 2.0**-100, 2.0**-30)

# One octave, whole numbers of them, beside these, and out of range.
OCTAVES = (1.0, 2.0, 3.0, 5.0, 16.0, 31.0, 32.0, 1.5, 4.75, 31.5, 1 + 2.0**-20, 2 - 2.0**-20, 3 + 2.0**-20, 0.5, 0.0,
           -7.0, 32.5, 1e9)
GAINS = (0.5, 1.0, 0.0, 0.25, 0.75, 0.96875, 1 - 2.0**-20, 2.0**-20, *TINY, 1.5, -0.5)
FIXED_OCTAVES = (1 + 2.0**-23, 1 + 2.0**-18, 2 - 2.0**-22, 6.7, 32 - 2.0**-18, 33.0, -0.0, 1e-40, 3.4e38, -3.4e38)
FIXED_GAINS = (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 513 * 2.0**-18, 1 / 3, 0.7, 1 - 2.0**-18, 1 - 2.0**-24,
               1 + 2.0**-23, 3.4e38, -3.4e38)

Spread = tuple[float, ...]


def rounded(of: Spread) -> Spread:
    return tuple(map(to_f32, of))


def beside(x: float, steps: int) -> float:
    """So many floats farther from 0 than a positive one."""
    word, = struct.unpack("<I", struct.pack("<f", x))
    return struct.unpack("<f", struct.pack("<I", word + steps))[0]


def of_a_noise(generator: Generator) -> Spread:
    return spread(generator.integer(1, len(TABLE)))


def in_order(generator: Generator) -> Spread:
    return (generator.uniform(0.0625, 3), *sorted(generator.uniform(0, 1) for _ in range(3)))


def anywhere(generator: Generator) -> Spread:
    return (generator.uniform(-1, 4), *(generator.uniform(-1, 2) for _ in range(3)))


def some(generator: Generator) -> Spread:
    """Mostly of a noise or in order."""
    return generator.pick((of_a_noise, in_order, in_order, anywhere))(generator)


def edges_of(of: Spread) -> list[float]:
    """Values: the middle and tiny ones, the ends of a spread and their neighbours, and beyond all spreads."""
    reach = to_f32(min(max(of[0], 0.0625), 3))
    found = (0.0, *TINY[::3], reach / 2, beside(reach, -1), reach, beside(reach, 1), 3.0)
    return [signed for x in found for signed in (x, -x)]


def values(generator: Generator) -> list[Row]:
    rows = [(x, *of) for of in (spread(9), EDGES[0], EDGES[6]) for x in edges_of(of)]
    rows += [(sign * 1e30, *of) for of in (spread(2), EDGES[5]) for sign in (1, -1)]
    for of in (*map(spread, NOISES), *EDGES, *map(rounded, BEYOND)):
        reach = min(max(of[0], 0.0625), 3)
        rows += [(to_f32(sign * reach * generator.uniform(0, 1)), *of) for sign in (1, -1)]
        rows.append((generator.pick(edges_of(of)), *of))
    for _ in range(COUNT):
        of = some(generator)
        rows.append((to_f32(min(max(of[0], 0.0625), 3) * generator.uniform(-1.125, 1.125)), *of))
    return [rounded(row) for row in rows]


def fixed_values(generator: Generator) -> list[Row]:
    """Whole numbers of 2^-21 and what lies between, where the integers change."""
    rows = [(x, *of) for of in CUT for x in edges_of(rounded(of))]
    for far in (3.4e38, 3 + 2.0**-22, 3 - 2.0**-22, 1e-40, 2.0**-21, 2.0**-22, 3 * 2.0**-22, 511 * 2.0**-21):
        rows += [(sign * far, *generator.pick((spread(9), *EDGES, *CUT))) for sign in (1, -1)]
    for of in (*CUT, *EDGES, *BEYOND):
        reach = min(max(of[0], 0.0625), 3)
        rows += [(sign * reach * generator.uniform(0, 1), *of) for sign in (1, -1)]
    return [rounded(row) for row in rows]


def sums(generator: Generator) -> list[Row]:
    rows = [(*spread(9), octaves, 0.5) for octaves in OCTAVES] + [(*spread(2), 4.5, gain) for gain in GAINS]
    rows += [(*of, generator.pick(OCTAVES), generator.pick(GAINS)) for of in (*map(spread, NOISES), *EDGES, *BEYOND)]
    # At the edges the spread belongs to a sum, whose numbers may be clamped, or its reach is at its largest.
    rows += [(*of, octaves, gain) for of in EDGES for octaves, gain in ((2.0, 1.0), (32.0, 1.0), (5.0, 0.5))]
    while len(rows) < 2 * COUNT:
        octaves = generator.pick((generator.uniform(1, 9), float(generator.integer(1, 32))))
        gain = generator.pick((0.5, generator.uniform(0, 1), generator.uniform(0.9, 1)))
        rows.append((*some(generator), octaves, gain))
    return [rounded(row) for row in rows]


def fixed_sums(generator: Generator) -> list[Row]:
    rows = [(*spread(9), octaves, 0.75) for octaves in FIXED_OCTAVES]
    rows += [(*spread(2), 6.5, gain) for gain in FIXED_GAINS]
    for of in (*CUT, *EDGES, *BEYOND):
        rows.append((*of, generator.pick(OCTAVES + FIXED_OCTAVES), generator.pick(GAINS + FIXED_GAINS)))
        rows.append((*of, generator.uniform(1, 32), generator.uniform(0, 1)))
    return [rounded(row) for row in rows]


def plain(function: Function, generator: Generator) -> list[Row]:
    """The rows for every arithmetic."""
    if function.form == "spread":
        return [(number,) for number in NUMBERS]
    return values(generator) if function.form == "spread_value" else sums(generator)


def fixed(function: Function, generator: Generator) -> list[Row]:
    """Rows for fixed arithmetic alone."""
    return fixed_values(generator) if function.form == "spread_value" else fixed_sums(generator)
