"""The inputs of the golden files: edge cases of each function, then numbers of a generator."""

from __future__ import annotations

import itertools
import math
from collections.abc import Container, Sequence
from operator import itemgetter

import catalog.model
from catalog.model import AXES
from catalog.tables.configurations import Configuration
from catalog.tables.functions import SPREADS, Function
from proof.golden import (
    cellular_rows,
    gullies_rows,
    hex_rows,
    period_rows,
    perlin_worley_rows,
    phasor_rows,
    scatter_rows,
    simplex_rows,
    sum_rows,
    uniform_rows,
)
from proof.golden.generator import FIXED_COORDINATES, INT_MAX, INT_MIN, SEEDS, Generator, Row, to_f32
from proof.oracle import gradients, hashes


def word_rows(generator: Generator) -> list[Row]:
    edges = [0, 1, 2, 0x7F, 0x80, 0xFF, 0x100, 0xFFFF, 0x10000, INT_MAX, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF]
    single_bits = [1 << i for i in range(32)]
    byte_patterns = [byte << shift for byte in (0xFF, 0xA5) for shift in (0, 8, 16, 24)]
    words = list(dict.fromkeys(edges + single_bits + byte_patterns))
    return [(word,) for word in words + [generator.word() for _ in range(128 - len(words))]]


def vec_rows(n: int, generator: Generator) -> list[Row]:
    """64 vectors of n words."""
    edges = (0, 1, 0xFF, INT_MAX, 0x80000000, 0xFFFFFFFF)
    rows = [(edge,) * n for edge in edges]
    rows += [tuple(edge if i == axis else 0 for i in range(n)) for axis in range(n) for edge in edges[1:]]
    rows += [tuple(generator.integer(0, 255) for _ in range(n)) for _ in range(16)]
    return rows + [tuple(generator.word() for _ in range(n)) for _ in range(64 - len(rows))]


WORD_EDGES = (0, 1, 2, 0xFF, 0xFFFF, INT_MAX, 0x80000000, 0xFFFFFFFF)
# Numbers of items: none, few, powers of two and those beside them, and as many as there may be.
COUNTS = (0, 1, 2, 3, 4, 5, 7, 8, 9, 31, 32, 33, 52, 1000, 2**16 - 1, 2**16, 2**16 + 1, 2**30 + 1, 2**31 - 1, 2**31)


def item_rows(takes: Sequence[str], generator: Generator) -> list[Row]:
    """128 rows of words, each with a meaning of its own; of items the first, the last, and those beyond them."""
    if "n" in takes:
        rows = [(i, n, 0) for n in COUNTS for i in dict.fromkeys((0, max(n - 1, 0), n))]
        while len(rows) < 128:
            n = generator.pick(COUNTS) or generator.integer(1, 2**generator.integer(1, 31))
            rows.append((generator.pick((generator.word(), generator.integer(0, max(n - 1, 0)))), n, generator.seed()))
        return rows
    second = range(6) if "k" in takes else SEEDS
    rows = [(word, other) for word in WORD_EDGES for other in second]
    rows += [(1 << i, generator.seed()) for i in range(32)]
    return rows + [(generator.word(), generator.seed()) for _ in range(128 - len(rows))]


def zero_rows(generator: Generator) -> list[Row]:
    """64 words: 0, which everybody passes, and others."""
    return [(word,) for word in (*WORD_EDGES, *(generator.word() for _ in range(64 - len(WORD_EDGES))))]


def lattice_rows(n: int, generator: Generator) -> list[Row]:
    """64 lattice points of n coordinates, with seeds."""
    edges = (0, 1, -1, INT_MAX, INT_MIN)
    rows = [(edge,) * n + (seed,) for seed in SEEDS for edge in edges]
    if n > 1:
        rows += [tuple(edge if i == axis else 0 for i in range(n)) + (0,) for axis in range(n) for edge in edges[1:]]
    rows += [tuple(generator.integer(-1000, 1000) for _ in range(n)) + (generator.seed(),) for _ in range(16)]
    while len(rows) < 64:
        rows.append(tuple(generator.integer(INT_MIN, INT_MAX) for _ in range(n)) + (generator.seed(),))
    return rows


def hangs_on_a_tie(word: int) -> bool:
    """Whether the sine of a word would be another one if ties were rounded away from zero."""
    magnitude = abs(hashes.signed(word))
    half = 1 << max(magnitude.bit_length() - 24, 0) >> 1
    return half > 0 and magnitude % (4 * half) == half  # to an even multiple of 2 * half, which is below


def tie_cells(n: int, settings: Sequence[Configuration]) -> list[Row]:
    """For each hash that is used with the sine, the first cell on the diagonal whose gradient hangs on a tie."""
    def hangs(name: str, c: int) -> bool:
        return any(map(hangs_on_a_tie, gradients.sine_arguments(name, (c,) * n, 0)))

    names = dict.fromkeys(setting.hash for setting in settings if "sine_gradient" in setting.families)
    return [(next(c for c in itertools.count() if hangs(name, c)),) * n for name in names]


def lattice_gradient_rows(n: int, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """96 cells of n coordinates, with seeds: the limits, cells beside multiples of 2^20, random ones."""
    rows = [(edge,) * n + (seed,) for seed in SEEDS for edge in (0, 1, -1, INT_MAX, INT_MIN)]
    rows += [cell + (0,) for cell in tie_cells(n, settings)]
    for multiple in (2**20, -2**20, 2047 * 2**20, -2047 * 2**20):
        axis, other = generator.integer(0, n - 1), generator.integer(-100, 100)
        for c in (multiple - 1, multiple, multiple + 1):
            rows.append(tuple(c if i == axis else other for i in range(n)) + (generator.seed(),))
    rows += [tuple(generator.integer(-100, 100) for _ in range(n)) + (generator.seed(),) for _ in range(16)]
    while len(rows) < 96:
        rows.append(tuple(generator.integer(INT_MIN, INT_MAX) for _ in range(n)) + (generator.seed(),))
    return rows


def gradient_rows(generator: Generator) -> list[Row]:
    """141 words: on the line and on the plane the fields of the gradients extreme and next to a sign change; in three
    and four dimensions the first and the last words of each pairing, with each pair and sign."""
    # The bits above and below the fields are for neither.
    edges = [sign | a << 14 | others for sign in (0, 1 << 31) for a in (0, 1, 255, 256, 510, 511)
             for others in (0, 0x7F803FFF)]
    thirds = [0, 0x55555554, 0x55555555, 0x55555556, 0xAAAAAAA9, 0xAAAAAAAA, 0xAAAAAAAB, 0xFFFFFFFF]
    # Bits 20 to 22 choose the pair and the signs.
    edges += [third | bits << 20 for third in (0, 0x56000000, 0xAB000000) for bits in range(8)]
    return [(word,) for word in edges + thirds + [generator.word() for _ in range(85)]]


def position_rows(n: int, generator: Generator) -> list[Row]:
    """192 points in n dimensions: a dyadic grid, coordinates next to 0, far points, random points. 96 of four, whose
    exact values take long."""
    axes = {
        1: [tuple(i / 16 for i in range(-32, 32))],
        2: [(-2.0, -1.5, -1.0, -0.25, 0.0, 0.5, 1.0, 1.75)] * 2,
        3: [(-1.5, -1.0, 0.0, 0.75), (-2.0, -0.25, 0.5, 1.0), (-0.5, 0.0, 1.0, 1.25)],
        4: [(-1.5, 0.0, 0.75), (-2.0, 0.5), (-0.25, 1.0), (-1.0, 1.25)],
    }[n]
    rows = [point + (0,) for point in itertools.product(*axes)]
    # The fraction of the negative ones is so near to 1 that a float32 cannot hold it.
    tiny = (2.0**-30, -2.0**-30, 2.0**-126, -2.0**-126)
    rows += [tuple(x if i == axis else 0.5 for i in range(n)) + (0,) for axis in range(n) for x in tiny]
    far_end, end = (58, 96) if n == 4 else (116, 192)
    while len(rows) < far_end:
        far = generator.pick((2.0**20, 2.0**22, -2.0**20, -2.0**22))
        point = tuple(generator.pick((far, -far)) + generator.integer(-32, 32) / 8 for _ in range(n))
        rows.append(tuple(to_f32(x) for x in point) + (generator.seed(),))
    while len(rows) < end:
        reach = generator.pick((4, 64, 4096))
        rows.append(tuple(generator.uniform(-reach, reach) for _ in range(n)) + (generator.seed(),))
    return rows


# Cells whose first corner has, with the default hash and the seed 0, a word beside a third of all words: there
# gradients in three and four dimensions have other axes. All words were searched for them. With another hash they are
# cells like others.
BESIDE_THIRDS = ((-1249059409, 2, 0, 0), (285610395, 0, 0, 0), (1152198107, 0, 0, 0), (1917728123, 2, 0, 0))


def cell_rows(n: int, generator: Generator) -> list[Row]:
    """192 cells and fractions in n dimensions, 100 in four; at INT_MAX the far corners wrap to INT_MIN."""
    cells = (INT_MIN, INT_MIN + 1, -1, 0, 1, INT_MAX - 1, INT_MAX)
    fractions = (0.0, 2.0**-126, 2.0**-24, 2.0**-10, 0.25, 0.5, 0.75, 1 - 2.0**-10, 1 - 2.0**-24, 1.0)
    edges_end, end = (64, 96) if n == 4 else (112, 192)
    rows = [(cell,) * n + (fraction,) * n + (0,) for cell in cells for fraction in (0.0, 0.375, 0.5, 1.0)]
    while len(rows) < edges_end:
        cell = tuple(generator.pick(cells) for _ in range(n))
        rows.append(cell + tuple(generator.pick(fractions) for _ in range(n)) + (generator.seed(),))
    while len(rows) < end:
        cell = tuple(generator.integer(INT_MIN, INT_MAX) for _ in range(n))
        rows.append(cell + tuple(generator.uniform(0, 1) for _ in range(n)) + (generator.seed(),))
    return rows + [cell[:n] + (0.25, 0.625, 0.4375, 0.125)[:n] + (0,) for cell in BESIDE_THIRDS if n >= 3]


# --- Positions that are whole numbers ---------------------------------------------------------------------------

SCALES = (1, 2, 3, 7, 100, 1024, 4096, 65535, 65536)
SCALES_BEYOND = (0, -1, 65537, INT_MAX, INT_MIN)  # they count as the nearer end


def place_rows(n: int, seeded: bool, generator: Generator) -> list[Row]:
    """160 positions of n whole numbers, with cells and units: edges with each other, then random ones."""
    edges = (0, 1, -1, 99, -100, 65535, -65536, INT_MAX - 1, INT_MAX, INT_MIN + 1, INT_MIN)
    rows = [(edge,) * n + scale for edge in edges
            for scale in ((1, 1), (3, 100), (100, 3), (65536, 1), (1, 65536), (65535, 65536))]
    for beyond in SCALES_BEYOND:
        rows += [(-1234567,) * n + (beyond, 7), (1234567,) * n + (7, beyond)]
    while len(rows) < 96:
        point = tuple(generator.pick(edges) for _ in range(n))
        rows.append((*point, generator.pick(SCALES + SCALES_BEYOND), generator.pick(SCALES + SCALES_BEYOND)))
    while len(rows) < 160:
        reach = generator.pick((1000, INT_MAX))
        point = tuple(generator.integer(-reach, reach) for _ in range(n))
        rows.append((*point, generator.integer(1, 65536), generator.integer(1, 65536)))
    return [(*row, generator.seed()) for row in rows] if seeded else rows


# --- Fixed arithmetic has edges of its own, and no end of its domain --------------------------------------------

FIXED_FRACTIONS = (0.0, -0.0, 2.0**-149, 2.0**-21, 2.0**-20, 2.0**-19 - 2.0**-42, 0.25, 0.5 - 2.0**-25, 0.5,
                   0.5 + 2.0**-20, 1 - 2.0**-20, 1 - 2.0**-21, 1 - 2.0**-24, 1.0)


def fixed_position_rows(n: int, generator: Generator) -> list[Row]:
    """Points in n dimensions: each edge along each axis and along all, edges with each other, points anywhere."""
    rows = [tuple(x if i == axis else 0.375 for i in range(n)) + (0,) for axis in range(n) for x in FIXED_COORDINATES]
    rows += [(x,) * n + (0,) for x in FIXED_COORDINATES]
    rows += [tuple(generator.pick(FIXED_COORDINATES) for _ in range(n)) + (generator.seed(),) for _ in range(32)]
    return rows + [generator.anywhere(n) + (generator.seed(),) for _ in range(64)]


def fixed_cell_rows(n: int, generator: Generator) -> list[Row]:
    """Cells and fractions in n dimensions: each fraction along each axis and along all, then with each other."""
    cells = (INT_MIN, -1, 0, 47, INT_MAX)
    rows = [(0,) * n + tuple(f if i == axis else 0.375 for i in range(n)) + (0,)
            for axis in range(n) for f in FIXED_FRACTIONS]
    rows += [(cell,) * n + (f,) * n + (0,) for cell in (0, INT_MAX) for f in FIXED_FRACTIONS]
    for _ in range(64):
        cell = tuple(generator.pick(cells) for _ in range(n))
        rows.append(cell + tuple(generator.pick(FIXED_FRACTIONS) for _ in range(n)) + (generator.seed(),))
    return rows


# --- Which rows a function has ----------------------------------------------------------------------------------

# Makers of rows of those that need special ones.
OF_THEIR_OWN = {of.BOUND: of for of in (gullies_rows, hex_rows, perlin_worley_rows)}
SIMPLEX = ("simplex_noise", "curl")  # the families above its lattices
# Noises that jump at whole numbers have no values for negative coordinates that drivers may flush to 0.
JUMPING = frozenset(noise.name for noise in catalog.model.read().noises if noise.jumps)
LEAST = 2.0**-30


def rows_of(function: Function, fixed: bool, settings: Sequence[Configuration],
            generator: Generator) -> tuple[list[Row], list[Row]]:
    """The rows of a function, and those behind them that are for fixed arithmetic alone, if it has values with that.
    `settings` are all configurations, since gradients have rows for their hashes."""
    n, form = function.axes, function.form
    if form == "words":
        if function.name.startswith("gradient"):
            return gradient_rows(generator), []
        return word_rows(generator) if n == 1 else vec_rows(n, generator), []
    if form == "items":
        return item_rows(function.takes, generator), []
    if form == "zero":
        return zero_rows(generator), []
    if form == "candidate":
        return scatter_rows.rows_of(function, generator), []
    if form == "point":
        if function.family == "hash":
            return lattice_rows(n, generator), []
        return lattice_gradient_rows(n, settings, generator), []
    if form in ("place", "place_of_noise"):
        return place_rows(n, form == "place_of_noise", generator), []
    of = OF_THEIR_OWN.get(function.bound) or (sum_rows if form == "sum" else uniform_rows if form in SPREADS else None)
    if of:
        return of.plain(function, generator), of.fixed(function, generator) if fixed else []
    return (plain_rows(function, settings, generator),
            rows_of_fixed(function, settings, generator) if fixed else [])


# Numbers that fixed arithmetic clamps: infinities have values there.
CLAMPED = {*AXES, *(f"f{axis}" for axis in AXES), "jitter", "lacunarity", "gain", "strength", "amplitude", "detail",
           "footprint"}


def with_infinities(function: Function, every: list[Row], of_fixed: list[Row]) -> tuple[list[Row], list[Row]]:
    """And with infinities, where these have a value: in place of the least and of the greatest number of a column."""
    def infinite(rows: list[Row], names: Container[str]) -> list[Row]:
        columns = [i for i, column in enumerate(function.inputs) if column.type == "f32" and column.name in names]
        return [(*row[:i], end, *row[i + 1:]) for i in columns for end, row in (
            (-math.inf, min(rows, key=itemgetter(i))), (math.inf, max(rows, key=itemgetter(i))))]

    names = CLAMPED - {"footprint"} if function.bound == gullies_rows.BOUND else CLAMPED
    if of_fixed and function.form not in SPREADS:
        of_fixed = of_fixed + infinite(of_fixed, names)
    return every + infinite(every, ("radius",)), of_fixed


def with_phases(rows: list[Row], function: Function, waves: Sequence[float], generator: Generator) -> list[Row]:
    """And with waves, if it has some, among them `waves`. Rows of cellular noise have a phase among the things a caller
    chooses."""
    if not function.has_phase or function.family in cellular_rows.FAMILIES:
        return rows
    rows = simplex_rows.with_phases(rows, generator)
    if "wave" in function.takes:
        rows = phasor_rows.with_waves(rows, function.axes, waves, generator)
    return phasor_rows.with_bandwidths(rows, generator) if "bandwidth" in function.takes else rows


def rows_of_fixed(function: Function, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """Rows of noises, and of functions made of them, for fixed arithmetic alone."""
    n, form = function.axes, function.form
    rows = {"position": fixed_position_rows, "cell": fixed_cell_rows}[form](n, generator)
    if function.has_period:
        rows = period_rows.inserted(rows, n, 2 * n if form == "cell" else n, generator)
    if function.family in cellular_rows.FAMILIES:
        rows = cellular_rows.with_choices(rows, function, generator)
        rows += cellular_rows.for_fixed(function, settings, generator)
    return with_phases(rows, function, phasor_rows.CUT, generator)


def plain_rows(function: Function, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """Rows of noises, and of functions made of them, for every arithmetic."""
    n, form = function.axes, function.form
    if function.has_period:
        rows = period_rows.rows_of(function, generator)
    else:
        rows = {"position": position_rows, "cell": cell_rows}[form](n, generator)
    if function.family in SIMPLEX:
        rows += simplex_rows.rows_of(function, generator)
    if function.family == "curl" and n == 3:
        rows += simplex_rows.crossings(function)
    if function.family in cellular_rows.FAMILIES:
        rows = cellular_rows.with_choices(rows + cellular_rows.special(function, generator), function, generator)
        rows += cellular_rows.turns(function, generator)
        rows += cellular_rows.far_borders(function)
        if cellular_rows.jumps(function):
            rows = list(cellular_rows.cleared(rows, function, generator))
    if function.bound in JUMPING and form == "position":
        rows = [tuple(-LEAST if -LEAST < x < 0 else x for x in row[:n]) + row[n:] for row in rows]
    return with_phases(rows, function, phasor_rows.EDGES, generator)
