"""The inputs of the golden files: edge cases of each function, then numbers of a generator."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Sequence

from oracle import gradients, words
from tables.configurations import Configuration
from tables.functions import Function

INT_MIN, INT_MAX = -2**31, 2**31 - 1
SEEDS = (0, 1, 0xFFFFFFFF)

Row = tuple  # one value per input column, integers and floats


def fnv1a64(data: bytes) -> int:
    """FNV-1a, 64 bit: seeds the generator, and makes the digests."""
    h = 14695981039346656037
    for byte in data:
        h = (h ^ byte) * 1099511628211 & 0xFFFFFFFFFFFFFFFF
    return h


def to_f32(value: float) -> float:
    """The float32 nearest to `value`."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


class Generator:
    """SplitMix64 (Steele, Lea and Flood 2014), with the few kinds of draw that the rows need."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def next(self) -> int:
        """The next 64 bits."""
        self.state = (self.state + 0x9E3779B97F4A7C15) & 0xFFFFFFFFFFFFFFFF
        z = self.state
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & 0xFFFFFFFFFFFFFFFF
        z = (z ^ z >> 27) * 0x94D049BB133111EB & 0xFFFFFFFFFFFFFFFF
        return z ^ z >> 31

    def word(self) -> int:
        return self.next() >> 32

    def integer(self, low: int, high: int) -> int:
        """An integer from `low` to `high`, both included."""
        return low + self.next() % (high - low + 1)

    def pick(self, choices: Sequence) -> object:
        return choices[self.integer(0, len(choices) - 1)]

    def uniform(self, low: float, high: float) -> float:
        """A float32 in [low, high]."""
        return to_f32(low + (high - low) * (self.next() >> 11) / 2**53)

    def seed(self) -> int:
        """A noise seed: one of the edge cases, or any word."""
        return self.pick((*SEEDS, self.word()))


def generator_of(name: str) -> Generator:
    """One of its own for each function, and for each test."""
    return Generator(fnv1a64(name.encode("ascii")))


def word_rows(generator: Generator) -> list[Row]:
    """128 single words."""
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
    magnitude = abs(words.signed(word))
    half = 1 << max(magnitude.bit_length() - 24, 0) >> 1
    return half > 0 and magnitude % (4 * half) == half  # to an even multiple of 2 * half, which is below


def tie_cells(n: int, settings: Sequence[Configuration]) -> list[Row]:
    """For each hash that is used with the sine, the first cell on the diagonal whose gradient hangs on a tie."""
    def hangs(name: str, c: int) -> bool:
        return any(map(hangs_on_a_tie, gradients.sine_arguments(name, (c,) * n, 0)))

    names = dict.fromkeys(setting.hash for setting in settings if "sine_gradient" in setting.families)
    return [(next(c for c in itertools.count() if hangs(name, c)),) * n for name in names]


def lattice_gradient_rows(n: int, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """96 cells of n coordinates, with seeds: the limits, multiples of periods and what is next to them, random ones."""
    rows = [(edge,) * n + (seed,) for seed in SEEDS for edge in (0, 1, -1, INT_MAX, INT_MIN)]
    rows += [cell + (0,) for cell in tie_cells(n, settings)]
    for period in sorted({setting.period for setting in settings} - {0}):
        outermost = INT_MAX // period * period
        for multiple in (period, -period, outermost, -outermost):
            axis, other = generator.integer(0, n - 1), generator.integer(-100, 100)
            for c in (multiple - 1, multiple, multiple + 1):
                rows.append(tuple(c if i == axis else other for i in range(n)) + (generator.seed(),))
    rows += [tuple(generator.integer(-100, 100) for _ in range(n)) + (generator.seed(),) for _ in range(16)]
    while len(rows) < 96:
        rows.append(tuple(generator.integer(INT_MIN, INT_MAX) for _ in range(n)) + (generator.seed(),))
    return rows


def gradient_rows(generator: Generator) -> list[Row]:
    """160 words: the fields of gradient2 and gradient3 extreme, next to a sign change, or (q) as large as p."""
    signs, fields = (0, 1 << 31), (0, 1, 127, 128, 254, 255)
    # The bits below the fields are for neither.
    edges = [sign | p << 23 | q << 15 | (0x7FFF if sign else 0) for sign in signs for p in fields for q in fields]
    edges += [sign | a << 22 | low for sign in signs for a in (0, 1, 255, 256, 510, 511) for low in (0, 0x3FFFFF)]
    return [(word,) for word in edges + [generator.word() for _ in range(64)]]


def position_rows(n: int, generator: Generator) -> list[Row]:
    """192 points in n dimensions: a dyadic grid, coordinates next to 0, far points, random points."""
    axes = {
        2: [(-2.0, -1.5, -1.0, -0.25, 0.0, 0.5, 1.0, 1.75)] * 2,
        3: [(-1.5, -1.0, 0.0, 0.75), (-2.0, -0.25, 0.5, 1.0), (-0.5, 0.0, 1.0, 1.25)],
    }[n]
    rows = [point + (0,) for point in itertools.product(*axes)]
    # The fraction of the negative ones is so near to 1 that a float32 cannot hold it.
    tiny = (2.0**-30, -2.0**-30, 2.0**-126, -2.0**-126)
    rows += [tuple(x if i == axis else 0.5 for i in range(n)) + (0,) for axis in range(n) for x in tiny]
    while len(rows) < 116:
        far = generator.pick((2.0**20, 2.0**22, -2.0**20, -2.0**22))
        point = tuple(generator.pick((far, -far)) + generator.integer(-32, 32) / 8 for _ in range(n))
        rows.append(tuple(to_f32(x) for x in point) + (generator.seed(),))
    while len(rows) < 192:
        reach = generator.pick((4, 64, 4096))
        rows.append(tuple(generator.uniform(-reach, reach) for _ in range(n)) + (generator.seed(),))
    return rows


def cell_rows(n: int, generator: Generator) -> list[Row]:
    """192 cells and fractions in n dimensions; at INT_MAX the far corners wrap to INT_MIN."""
    cells = (INT_MIN, INT_MIN + 1, -1, 0, 1, INT_MAX - 1, INT_MAX)
    fractions = (0.0, 2.0**-24, 0.25, 0.5, 0.75, 1 - 2.0**-24, 1.0)
    rows = [(cell,) * n + (fraction,) * n + (0,) for cell in cells for fraction in (0.0, 0.375, 0.5, 1.0)]
    while len(rows) < 112:
        cell = tuple(generator.pick(cells) for _ in range(n))
        rows.append(cell + tuple(generator.pick(fractions) for _ in range(n)) + (generator.seed(),))
    while len(rows) < 192:
        cell = tuple(generator.integer(INT_MIN, INT_MAX) for _ in range(n))
        rows.append(cell + tuple(generator.uniform(0, 1) for _ in range(n)) + (generator.seed(),))
    return rows


def octave_rows(n: int, generator: Generator) -> list[Row]:
    """64 octave sums in n dimensions.

    Coordinates are multiples of 1/64, so that the position of every octave is exact in float32 too, save for the
    lacunarity 61/32; there the coordinates are smaller, to keep what float32 loses small.
    """
    origin, corner = (0.0,) * n, (64.0, -64.0, 64.0)[:n]
    rows = [origin + (octaves, 2.0, 0.5, 0) for octaves in (-1, 0, 1, 2, 6)]
    rows += [corner + (6, 2.0, 0.5, 0), (-1.0,) * n + (1, 2.0, 0.5, 1), (0.5,) * n + (6, 2.0, 0.0, 0)]
    while len(rows) < 64:
        lacunarity = 2.0 if len(rows) < 43 else (1.5, 2.5, 1.90625)[len(rows) % 3]
        reach = 64 * (8 if lacunarity == 1.90625 else 64)
        point = tuple(generator.integer(-reach, reach) / 64 for _ in range(n))
        gain = generator.pick((0.5, 0.5, 0.25, 0.75, 1.0, 0.0))
        rows.append(point + (generator.integer(1, 6), lacunarity, gain, generator.seed()))
    return rows


# --- Fixed arithmetic has edges of its own, and no end of its domain --------------------------------------------

# Subnormal and other tiny numbers, the step of a fraction, whole numbers and what is next to them, where a float has no
# fraction, where int ends, and the largest.
FIXED_COORDINATES = tuple(to_f32(x) for x in (
    -0.0, 2.0**-149, -2.0**-149, 1e-40, -1e-40, -2.0**-126, 2.0**-33, -2.0**-33, -2.0**-32, 2.0**-21, -2.0**-21,
    2.0**-20, -2.0**-20, -3 * 2.0**-21, 1 - 2.0**-24, -1 + 2.0**-24, 1 + 2.0**-23, -1 - 2.0**-23, -1.0, 7 - 2.0**-21,
    48 - 2.0**-18, -48 - 2.0**-18, 2.0**19 + 0.5, 2.0**23 - 0.5, -2.0**23 + 0.5, 2.0**23, -2.0**23 - 1, 2147483520.0,
    2.0**31, -2.0**31, -2147483904.0, 3e38, -3.4e38))
FIXED_FRACTIONS = (0.0, -0.0, 2.0**-149, 2.0**-21, 2.0**-20, 2.0**-19 - 2.0**-42, 0.25, 0.5 - 2.0**-25, 0.5,
                   0.5 + 2.0**-20, 1 - 2.0**-20, 1 - 2.0**-21, 1 - 2.0**-24, 1.0)


def anywhere(n: int, generator: Generator) -> tuple[float, ...]:
    """A point whose coordinates are of any size."""
    return tuple(to_f32(generator.uniform(-1, 1) * 2.0**generator.integer(-24, 34)) for _ in range(n))


def fixed_position_rows(n: int, generator: Generator) -> list[Row]:
    """Points in n dimensions: each edge along each axis and along all, edges with each other, points anywhere."""
    rows = [tuple(x if i == axis else 0.375 for i in range(n)) + (0,) for axis in range(n) for x in FIXED_COORDINATES]
    rows += [(x,) * n + (0,) for x in FIXED_COORDINATES]
    rows += [tuple(generator.pick(FIXED_COORDINATES) for _ in range(n)) + (generator.seed(),) for _ in range(32)]
    return rows + [anywhere(n, generator) + (generator.seed(),) for _ in range(64)]


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


def fixed_octave_rows(n: int, generator: Generator) -> list[Row]:
    """Octave sums in n dimensions: what is cut off, what is odd, and positions at edges and far."""
    lacunarities = tuple(map(to_f32, (1.9, 3.7, 0.0, 255.0, 2.0, 1.0, 0.3, 1e-40, -2.0, 300.0)))
    gains = tuple(map(to_f32, (0.0, 1.0, 1.5, 0.7, 0.5, 1e-40, -1.0)))
    rows = [anywhere(n, generator) + (octaves, 1.9, 0.7, generator.seed()) for octaves in (-1, 0, 1, 2, 31, 32, 33)]
    rows += [anywhere(n, generator) + (33, 2.0, 1.0, generator.seed()), (-0.75,) * n + (INT_MAX, 2.0, 0.5, 0)]
    rows += [(x,) * n + (3, 1.9, 0.7, 0) for x in FIXED_COORDINATES]
    for lacunarity, gain in itertools.product(lacunarities, gains):
        point = tuple(generator.uniform(-64, 64) for _ in range(n))
        rows.append(point + (generator.integer(2, 6), lacunarity, gain, generator.seed()))
    return [row[:n + 1] + tuple(map(to_f32, row[n + 1:n + 3])) + row[n + 3:] for row in rows]


# --- Which rows a function has ----------------------------------------------------------------------------------


def rows_of(function: Function, fixed: bool, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """The rows of a function; `settings` are all configurations, since gradients have rows for their hashes and
    periods."""
    n, form = function.axes, function.form
    if form == "words":
        if function.family == "independent" and " " in function.outputs:
            return gradient_rows(generator)
        return word_rows(generator) if n == 1 else vec_rows(n, generator)
    if form == "point":
        if function.family == "hash":
            return lattice_rows(n, generator)
        return lattice_gradient_rows(n, settings, generator)
    plain, of_fixed = {"position": (position_rows, fixed_position_rows), "cell": (cell_rows, fixed_cell_rows),
                       "sum": (octave_rows, fixed_octave_rows)}[form]
    rows = plain(n, generator)
    return rows + of_fixed(n, generator) if fixed else rows
