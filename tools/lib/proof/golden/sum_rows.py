"""Rows of octave sums: their settings at edges, then with each other; at places near and, from a cell, far."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from catalog.tables.functions import Function
from proof.golden.generator import FIXED_COORDINATES, INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.golden.period_rows import PERIODS, near_seam
from proof.golden.simplex_rows import PHASES
from proof.oracle.jacobians import SUMS

COUNT = 64

# For each setting that only some sums have: edges with any arithmetic, and more with fixed. The strengths of ping-pong
# reach as far as 64, of the weighted sum as far as 1, of eroded sums as far as 16, and amplitudes as far as
# 64. Numbers beyond count as the end.
Edges = dict[str, tuple[tuple[float, ...], tuple[float, ...]]]
EDGES: Edges = {
    # A footprint at which an octave begins to fade, or is gone, is 1/2 or 3/2 over a power of the lacunarity.
    "footprint": ((0.0, *(2.0**-k for k in range(9)), *(3 * 2.0**-k for k in range(6)), 7.0),
                  (-0.0, 1e-40, 2.0**-25, 2.0**-24, 3 * 2.0**-24, 1 / 7, 0.5 + 2.0**-18, 0.5 + 2.0**-23, 1.5 - 2.0**-18,
                   1.5 - 2.0**-23, 2.0, 3e38, -1.0)),
    "detail": ((-1.0, 0.0, 2.0**-20, 0.5, 1.0, 1 + 2.0**-20, 2.0, 3 - 2.0**-20, 5.0, 5.9375, 6.5, 7.0),
               (-0.0, 1e-40, -1e-40, 2.0**-149, 2.0**-33, 2.0**-32, 1 + 2.0**-23, 1 + 2.0**-18, 2 - 2.0**-22, 6.7, 31.0, 31.5, 32.0,
                32 + 2.0**-18, 33.5, 3e38, -3e38)),
    "ping_pong": ((0.0, 2.0, 1.0, 0.5, 4.0, 2.75, 64.0, 100.0, -1.0),
                  (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 513 * 2.0**-18, 1 / 3, 63.9, 64 - 2.0**-18,
                   64 + 2.0**-17, 3e38, -3e38)),
    "weighted": ((0.0, 1.0, 0.5, 0.75, 2.0, -1.0),
                 (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 1 - 2.0**-18, 1 - 2.0**-24, 1 + 2.0**-23, 1 / 3,
                  3e38, -3e38)),
    "eroded": ((0.0, 1.0, 0.25, 4.0, 16.0, 20.0, -1.0),
               (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 1 / 3, 15.9, 16 - 2.0**-18, 16 + 2.0**-17, 3e38,
                -3e38)),
    # From 8 on the shifts of fixed arithmetic have more bits than a float.
    "amplitude": ((0.0, 1.0, 0.5, 2.0, 64.0, 100.0, -1.0),
                  (-0.0, 1e-40, 2.0**-19, 2.0**-18, 511 * 2.0**-18, 1 / 3, 8.0, 8 + 2.0**-17, 31.7, 63.9, 64 - 2.0**-18,
                   64 + 2.0**-17, 3e38, -3e38)),
    "phase": (PHASES, (-0.0, 1e-40, 2.0**-31, 0.5 - 2.0**-25, 1 - 2.0**-24, 2.0**23 + 1, 3e38, -3e38))}


def edges_of(function: Function) -> tuple[str, tuple[float, ...], tuple[float, ...]]:
    """The setting that few have, and its edges; of a sum that has none an empty name."""
    for name in ("phase", "footprint", "detail", "strength", "amplitude"):
        if name in function.settings:
            return name, *EDGES[function.bound if name == "strength" else name]
    return "", (), ()


def usual(function: Function, octaves: int, generator: Generator) -> float:
    """A number for that setting."""
    if "phase" in function.settings:
        return generator.uniform(-4, 4)
    if function.bound == "eroded":
        return generator.pick((1.0, 0.5, 4.0, generator.uniform(0, 2)))
    if function.bound == "warp":
        return generator.pick((1.0, 0.5, 2.0, generator.uniform(0, 4)))
    if function.bound == "warp_progressive":
        # A small error moves all that follows, the more so the larger the amplitude is.
        largest = 2.0 if octaves <= 2 else 0.5 if octaves <= 4 else 0.125
        return generator.pick((largest, largest, generator.uniform(0, largest)))
    return generator.pick({
        "footprint": (0.0, 3.0, *(generator.uniform(0.5, 1) * 2.0**-generator.integer(-1, 7) for _ in range(6))),
        "detail": (octaves, octaves - 0.5, octaves - 2.0**-10, octaves - generator.uniform(0, 1)),
        "ping_pong": (2.0, 2.0, 3.0, generator.uniform(0, 4)),
        "weighted": (1.0, 0.5, generator.uniform(0, 1)),
        "": (0.0,)}[function.bound if "strength" in function.settings else edges_of(function)[0]])


def settings(function: Function, octaves: int, lacunarity: float, gain: float, special: float) -> Row:
    """In the order of the columns; `special` is the one that few sums have."""
    floats = {"lacunarity": lacunarity, "gain": gain, edges_of(function)[0]: special}
    return tuple(octaves if name == "octaves" else to_f32(floats[name]) for name in function.settings)


JACOBIAND = ("fbm_d", "warp_progressive")  # the sums that have the Jacobians of octaves in them


def in_jacobians(function: Function, octaves: int, lacunarity: float, gain: float, amplitude: float) -> bool:
    """Whether a sum keeps to its bound: the contract limits Jacobians."""
    sizes = [abs(gain * lacunarity)**i for i in range(min(octaves, 32))]
    moves = function.bound == "warp_progressive" and min(max(amplitude, 0), 64) * max(sizes, default=0) > 256
    return function.bound not in JACOBIAND or (sum(sizes) <= 64 and not moves)


def kept(function: Function, octaves: int, lacunarity: float, gain: float, special: float | None) -> tuple[int, float]:
    """The octaves and the gain, or lower ones that keep the sum to its bound."""
    amplitude = 2.0 if special is None else special
    if in_jacobians(function, octaves, lacunarity, gain, amplitude):
        return octaves, gain
    if octaves > 8:
        return octaves, to_f32(0.999 / abs(lacunarity))
    while octaves > 2 and not in_jacobians(function, octaves, lacunarity, gain, amplitude):
        octaves -= 1
    if not in_jacobians(function, octaves, lacunarity, gain, amplitude):
        gain = to_f32((31 if amplitude < 8 else 3.9) / abs(lacunarity))
    return octaves, gain


# --- Of every arithmetic: positions of few bits, so that the bounds of floats stay small ---------------------------

# Most are no multiples of 2^-24, to which a fraction is cut.
FRACTIONS = (0.0, 2.0**-126, 2.0**-30, 2.0**-24, 0.375, 0.5, to_f32(0.3), 1 - 2.0**-24, 1.0)


def split(function: Function, point: Sequence[float]) -> Row:
    """A position as the function takes it."""
    cell = [math.floor(x) for x in point]
    return (*cell, *(to_f32(x - c) for x, c in zip(point, cell))) if function.has_cell else tuple(point)


def periods_of(function: Function, octaves: int, lacunarity: float, generator: Generator) -> tuple[int, ...]:
    """Periods that keep within the domain, or none for the form without."""
    largest = math.floor(min(max(lacunarity, 0), 255))**max(octaves, 0)
    found = [generator.pick(PERIODS) for _ in range(function.axes * function.has_period)]
    return tuple(period if abs(period) * largest < 2**31 else 48 for period in found)


def somewhere(function: Function, octaves: int, lacunarity: float, periods: Sequence[int], generator: Generator) -> Row:
    """A place, next to a seam if there are any. All octaves of it are within the range of int."""
    growth = max(abs(lacunarity), 1)**max(octaves - 1, 0)
    # In four dimensions a turn adds more bits.
    reach = 1 if growth > 200 else generator.pick((4, 8) if function.axes == 4 and not periods else (4, 16, 64))
    if function.has_cell:
        # A rotated vector may come to lie along an axis, where it is longer by the square root of the axes at most. A
        # progressive warp moves it, too.
        largest, margin = 2**29 if function.axes == 4 else 2**30, 256 if function.bound == "warp_progressive" else 8
        reach = min(generator.pick((8, 200, 2**28, 2**31)), math.floor(largest / growth) - margin)
    cell = [near_seam(period, reach, generator) for period in periods or (1,) * function.axes]
    if not function.has_cell:
        steps = 64 if periods else 8 if function.axes < 4 else 4
        if function.axes == 4 and growth > 200 and not periods:
            cell, steps = [min(max(c, -1), 1) for c in cell], 1
        return tuple(to_f32(c + generator.integer(0, steps - 1) / steps) for c in cell)
    if octaves <= 1:
        cell = [generator.pick((c, INT_MIN, INT_MAX)) for c in cell]
    return (*cell, *(generator.pick((*FRACTIONS, generator.uniform(0, 1))) for _ in cell))


def drawn(function: Function, octaves: int, lacunarity: float, gain: float, generator: Generator,
          special: float | None = None) -> Row:
    """A row at some place."""
    octaves, gain = kept(function, octaves, lacunarity, gain, special)
    periods = periods_of(function, octaves, lacunarity, generator)
    place = somewhere(function, octaves, lacunarity, periods, generator)
    if special is None:
        special = usual(function, octaves, generator)
    return place + periods + settings(function, octaves, lacunarity, gain, special) + (generator.seed(),)


def octaves_at(function: Function, special: float) -> int:
    """How many octaves an edge of the special setting has, in every arithmetic."""
    name = edges_of(function)[0]
    if name == "detail":
        return math.ceil(special)
    if function.bound == "ping_pong" and special > 4:
        return 1  # a strength is as steep as it is large
    if function.bound == "warp_progressive" and special > 0.5:
        return 2
    return 6 if name == "footprint" else 4


# By dimensions, and by whether there are periods: where slopes sum to more than an eroded sum lets them, with the
# default hash. The octaves are all as coarse as the first. These are the best of six million places and seeds.
STEEP_PERIOD, STEEP_STRENGTH = 5, 0.0625
STEEP = {(2, False): ((-1.625, 6.375), 8, 1.0, 914794061), (2, True): ((5.375, -4.125), 8, 1.0, 64253315),
         (3, False): ((-7.625, -3.75, 6.875), 20, 0.9375, 506409921),
         (3, True): ((1.25, 7.25, 5.25), 20, 0.9375, 277140378)}
TINY = (2.0**-126, -2.0**-126, 2.0**-33, -2.0**-31, 2.0**-30)


def steep(function: Function) -> Row:
    place, octaves, gain, seed = STEEP[function.axes, function.has_period]
    periods = (STEEP_PERIOD,) * (function.axes * function.has_period)
    return split(function, place) + periods + settings(function, octaves, 1.0, gain, STEEP_STRENGTH) + (seed,)


def of_slopes_and_shifts(function: Function, generator: Generator) -> list[Row]:
    rows = [steep(function)] if function.bound == "eroded" else []
    for _ in range(2 * (not function.has_cell)):
        # The second octave would be at a place that no float has.
        place = tuple(generator.pick(TINY) for _ in range(function.axes))
        periods, special = periods_of(function, 1, 2.0, generator), usual(function, 1, generator)
        rows.append(place + periods + settings(function, 1, 2.0, 0.5, special) + (generator.seed(),))
    return rows


def plain(function: Function, generator: Generator) -> list[Row]:
    """64 sums; more of those with a setting of their own, since each edge of it has a row."""
    n, (name, edges, _) = function.axes, edges_of(function)
    rows = []
    origin, corner = (0.0,) * n, (64.0, -64.0, 64.0, -64.0)[:n]
    for point, octaves, gain, seed in (*((origin, octaves, 0.5, 0) for octaves in (-1, 0, 1, 2, 6)),
                                       (corner, 6, 0.5, 0), ((-1.0,) * n, 1, 0.5, 1), ((0.5,) * n, 6, 0.0, 0)):
        periods = periods_of(function, octaves, 2.0, generator)
        rows.append(split(function, point) + periods +
                    settings(function, octaves, 2.0, gain, usual(function, octaves, generator)) + (seed,))
    rows += [drawn(function, 3, 2.0, gain, generator) for gain in (0.0, 1.0, 1.5)]
    for special in edges:
        rows.append(drawn(function, octaves_at(function, special), 2.0, 0.5, generator, special))
        if name == "footprint":
            rows.append(drawn(function, 4, generator.pick((0.5, 1.5, 3.0)), 0.75, generator, special))
    if function.bound in SUMS:
        rows += of_slopes_and_shifts(function, generator)
    # With a period the lacunarity is rounded down, and from a cell one below 0 counts as 0.
    lacunarities = [(2.0, 6), (2.0, 6), (2.0, 4), (1.5, 6), (2.5, 5), (1.90625, 6), (3.0, 4), (1.0, 4), (0.5, 3),
                    (0.0, 2), (255.0, 2)]
    lacunarities += [(2.96875, 4)] if function.has_period else []
    lacunarities += [(-1.5, 2), (300.0, 2)] if function.has_period or function.has_cell else [(-1.5, 3)]
    for lacunarity, count in itertools.islice(itertools.cycle(lacunarities), max(COUNT - len(rows), 40)):
        octaves = generator.integer(2 if count == 2 else 1, count)
        gain = generator.pick((0.5, 0.5, 0.25, 0.75, 1.0, 0.0, 1.5 if octaves < 4 else 0.625))
        rows.append(drawn(function, octaves, lacunarity, gain, generator))
    # More octaves than count.
    rows.append(split(function, (0.375,) * n) + (0,) * (n * function.has_period) +
                settings(function, 40, 1.0, 0.75, 40.5 if name == "detail" else 0.125) + (7,))
    return rows


# --- Fixed arithmetic ---------------------------------------------------------------------------------------------

CELLS = (INT_MIN, INT_MIN + 1, -2**30 - 1, -2**26 - 1, -1, 0, 47, 2**24, 2**26, 2**30, INT_MAX - 1, INT_MAX)
# The last ones count as the nearer end.
FIXED_FRACTIONS = (0.0, -0.0, 2.0**-149, 2.0**-25, 2.0**-24, 2.0**-20 - 2.0**-24, 2.0**-20, to_f32(0.3), 0.5 - 2.0**-25,
                   0.5, 1 - 2.0**-20, 1 - 2.0**-24, 1.0, -0.25, 1.25)
LACUNARITIES = (1.9, 3.7, 0.0, 255.0, 2.0, 1.0, 0.3, 1e-40, -2.0, 300.0)
GAINS = (0.0, 1.0, 1.5, 0.7, 0.5, 1e-40, -1.0)
# Octaves, lacunarities, gains and amplitudes at the ends of what keeps Jacobians in their range.
LARGEST_JACOBIANS = ((2, 255.0, 0.24609375, 4.0), (6, 2.0, 1.0, 8.0), (3, 2.0, 1.0, 64.0), (5, 2.0, 1.0, 16.0),
                  (32, 1.04, 1.0, 64.0), (32, 255.0, 1 / 256, 64.0), (32, 1.0, 1.0, 64.0))


def any_place(function: Function, generator: Generator) -> Row:
    n = function.axes
    if not function.has_cell:
        return generator.anywhere(n)
    cell = [generator.pick((generator.integer(-100, 100), generator.integer(INT_MIN, INT_MAX), generator.pick(CELLS)))
            for _ in range(n)]
    return (*cell, *(generator.pick((generator.uniform(0, 1), generator.pick(FIXED_FRACTIONS))) for _ in range(n)))


def fixed(function: Function, generator: Generator) -> list[Row]:
    """Inputs that are cut off, odd inputs, and places at edges and far."""
    n, (_, edges, more_edges) = function.axes, edges_of(function)

    def row(place: Row, octaves: int, lacunarity: float, gain: float, special: float | None = None) -> Row:
        octaves, gain = kept(function, octaves, lacunarity, gain, special)
        periods = tuple(generator.pick(PERIODS) for _ in range(n * function.has_period))
        if special is None:
            special = usual(function, octaves, generator)
        return place + periods + settings(function, octaves, lacunarity, gain, special) + (generator.seed(),)

    rows = [row(any_place(function, generator), octaves, 1.9, 0.7) for octaves in (-1, 0, 1, 2, 31, 32, 33)]
    rows.append(row(any_place(function, generator), 33, 2.0, 1.0))
    rows.append(row(split(function, (-0.75,) * n), INT_MAX if "octaves" in function.settings else 40, 2.0, 0.5))
    if function.has_cell:
        rows += [row((cell,) * n + (f,) * n, 2, lacunarity, 0.7)
                 for cell in (0, INT_MAX) for f, lacunarity in zip(FIXED_FRACTIONS, itertools.cycle((1.5, 1.0, 1.9)))]
        rows += [row((cell,) * n + (f,) * n, 3, 1.9, 1.0) for cell in CELLS for f in (0.5, 1.0)]
    else:
        rows += [row((x,) * n, 3, 1.9, 0.7) for x in FIXED_COORDINATES]
    for octaves, lacunarity, gain, amplitude in LARGEST_JACOBIANS * (function.bound in JACOBIAND):
        rows.append(row(any_place(function, generator), octaves, lacunarity, gain, amplitude))
    for special in edges + more_edges:
        rows += [row(any_place(function, generator), 6, lacunarity, gain, special)
                 for lacunarity, gain in ((2.0, 0.5), (generator.pick(LACUNARITIES), generator.pick(GAINS)))]
    for lacunarity, gain in itertools.product(LACUNARITIES, GAINS):
        point = tuple(generator.uniform(-64, 64) for _ in range(n))
        place = generator.pick((split(function, point), any_place(function, generator)))
        rows.append(row(place, generator.integer(2, 6), lacunarity, gain))
    return rows
