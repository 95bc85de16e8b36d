"""The inputs of cellular noise: phases, jitters and metrics, and positions on walls, at corners and in the middle of
cells.

The data of the nearest point jump where another becomes the nearest. Floats may return either there, so such a
function has no such positions, but for fixed arithmetic: that has some where points are equally near, and pairs of
positions between which the nearest point changes.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

import catalog.model
from catalog.tables.configurations import Configuration
from catalog.tables.functions import Function
from proof.golden import simplex_rows
from proof.golden.generator import INT_MAX, INT_MIN, Generator, Row, to_f32
from proof.golden.period_rows import near_seam
from proof.oracle import noises
from proof.oracle.functions import Evaluate, knobs_of, values_of
from proof.oracle.gradients import Knobs
from proof.oracle.nearest import NEAREST

FAMILIES = ("cellular", "extended_cellular")
FINE = 2**20  # fractions are multiples of 2^-20, which fixed arithmetic does not cut
CLEAR = Fraction(1, 2**10)  # how much nearer than the second the nearest point is, where it matters
# The knobs with which that is so, by family. They may be more than have values: then rows stay as they are.
HASHES = {"cellular": (Knobs("pcg"), Knobs("lattice")), "extended_cellular": (Knobs("lattice"),)}
KINDS = 9  # of fractions
SPECIAL, TIES, CHANGES = 4 * KINDS, 16, 12  # how many
# With the Manhattan metric a point two cells away is as near as the nearest ones of the neighbours: those count.
FAR_TIE = (1760080, 0, 0.75, 0.0, 2, 48, 1.0, 3, 2020091907)

# --- A caller's choices --------------------------------------------------------------------------------------

# Numbers beyond an end count as the end; tiny ones, and what fixed arithmetic cuts off.
ODD_JITTERS = tuple(map(to_f32, (-0.5, 1.75, -0.0, 1e-40, 2.0**-33, 2.0**-32, 2.0**-21, 2.0**-20, 1 - 2.0**-24,
                                 1 + 2.0**-23)))
METRICS = tuple(range(1, len(catalog.model.read().metrics) + 1))
ODD_METRICS = (0, len(METRICS) + 1, -3, INT_MIN, INT_MAX)


def jitter(generator: Generator) -> float:
    return generator.pick((0.0, 0.0, 1.0, 1.0, generator.uniform(0, 1), generator.uniform(0, 1),
                           generator.uniform(0, 1), generator.integer(0, 8) / 8, generator.pick(ODD_JITTERS)))


def metric(generator: Generator) -> int:
    return generator.pick((*METRICS, *METRICS, *METRICS, generator.pick(ODD_METRICS)))


def with_choices(rows: Iterable[Row], function: Function, generator: Generator) -> list[Row]:
    """The rows of the form without choices, with those that the function takes before the seed."""
    return [(*row[:-1], *phases(function, index, generator), *(jitter(generator),) * ("jitter" in function.takes),
             *(metric(generator),) * ("metric" in function.takes), row[-1]) for index, row in enumerate(rows)]


def phases(function: Function, index: int, generator: Generator) -> tuple[float, ...]:
    return (simplex_rows.phase(index, generator),) if function.has_phase else ()


# Quarters of a turn, and phases beside them: with these, and a few others, a sine or a cosine in fixed arithmetic is 1
# or -1, and the product of two of them does not fit a signed integer before it is divided.
TURNS = (0.0, 0.25, 0.5, -0.25, 2.0**-17, 0.25 - 2.0**-17, 0.5 + 2.0**-17, -0.25 - 2.0**-17)


def turns(function: Function, generator: Generator) -> list[Row]:
    """Rows of points that move: with each of these phases a position in each kind of place."""
    rows = []
    for phase, kind in itertools.product(TURNS if function.has_phase else (), range(KINDS)):
        *row, seed = placed(function, fraction(kind, function.axes, generator), generator)
        rows.append((*row, phase, generator.pick((1.0, 1.0, 1.0, 0.0, generator.uniform(0, 1))), seed))
    return rows


# --- Positions --------------------------------------------------------------------------------------------------


def fraction(kind: int, n: int, generator: Generator) -> tuple[float, ...]:
    """A fraction in a cell, ..."""
    f = [generator.integer(0, FINE - 1) / FINE for _ in range(n)]
    first, second = generator.pick([(i, j) for i in range(n) for j in range(n) if i != j])
    kind %= KINDS
    if kind == 0:    # on a wall
        f[first] = 0.0
    elif kind == 1:  # right beside one
        f[first] = generator.pick((1 / FINE, 1 - 1 / FINE))
    elif kind == 2:  # in the middle along an axis
        f[first] = 0.5
    elif kind == 3:  # at the same offset along two axes
        f[first] = f[second]
    elif kind == 4:  # at opposite ones
        f[first] = (1 - f[second]) % 1
    elif kind == 5:  # at a corner
        f = [0.0] * n
    elif kind == 6:  # in the middle
        f = [0.5] * n
    elif kind == 7:  # in the middle of a wall, in space or of an edge
        f = [generator.pick((0.0, 0.5)) for _ in range(n)]
    else:            # on two walls
        f[first] = f[second] = 0.0
    return tuple(f)


PERIODS = (0, 1, 2, 3, 7, 64, 2**20, 1000003, 2**30, INT_MAX)


def placed(function: Function, f: Sequence[float], generator: Generator) -> Row:
    """A row of the form without choices at a fraction, in a cell near the origin, or near a seam; cells are far as
    well."""
    n = function.axes
    periods = [generator.pick(PERIODS) for _ in range(n)] if function.has_period else []
    near = [near_seam(period, 8 if period < 8 else 4, generator) if period else generator.integer(-4, 3)
            for period in periods or [0] * n]
    if function.form == "position":
        return (*(to_f32(c + x) for c, x in zip(near, f)), *periods, generator.seed())
    far = [near_seam(period, 2**31 - 8, generator) for period in periods or [0] * n]
    ends = (INT_MIN, INT_MIN + 1, INT_MAX - 1, INT_MAX)
    cell = [generator.pick((a, a, b, generator.pick(ends))) for a, b in zip(near, far)]
    return (*cell, *f, *periods, generator.seed())


def special(function: Function, generator: Generator) -> list[Row]:
    """Rows of the form without choices."""
    return [placed(function, fraction(kind, function.axes, generator), generator) for kind in range(SPECIAL)]


# --- Borders of far cells ---------------------------------------------------------------------------------------

# Places where the nearest border is with a cell two steps on, along each axis and to both sides: a cell and a
# fraction, with the seed 0 and a jitter of 1. They are rare, most of all in space: a search of some thousand million
# places found them, with the default hash. With another hash they are places like others.
FAR_BORDERS = (
    ((1340, 16), (0.0, 0.0)), ((3813, 59), (0.0, 0.0)), ((208, 11), (0.0, 0.0)), ((3330, 55), (1.0, 1.0)),
    ((6308, 19), (1.0, 1.0)), ((2602, 16), (1.0, 0.0)),
    ((7094, 4535, 11), (0.0, 0.6875, 0.0)), ((201, 213, 3), (0.46875, 0.0, 0.0)),
    ((4952, 6143, 41), (0.6875, 1.0, 0.0)), ((6856, 4050, 4), (1.0, 0.375, 0.0)),
    ((918, 3341, 31), (0.375, 1.0, 0.0)), ((3676, 7424, 18), (0.6875, 0.0, 1.0)),
)

# The search with a period of 7, where the cell two steps on lies behind the seam: a cell, a fraction and a seed. A
# search of 170,000 places found them, in the plane.
SEAM = 7
FAR_SEAMS = (
    ((0, 6), (1.0, 1.0), 5090695), ((1, 1), (0.0, 0.0), 3394258), ((1, 4), (0.0, 1.0), 1457481),
    ((2, 6), (0.0, 1.0), 9784923), ((4, 6), (0.0, 1.0), 352842), ((1, 1), (0.0, 1.0), 7596712),
    ((6, 6), (0.0, 1.0), 738032), ((1, 0), (0.0, 1.0), 6109775),
)


def far_borders(function: Function) -> list[Row]:
    if function.bound != "cell_border" or function.sets:
        return []
    rows: list[Row] = []
    for cell, f in FAR_BORDERS:
        if len(cell) != function.axes or (function.form == "position" and 1.0 in f):
            continue
        place = (*cell, *f) if function.form == "cell" else tuple(c + x for c, x in zip(cell, f))
        rows.append((*place, *(0,) * len(cell) * function.has_period, *(1.0,) * ("jitter" in function.takes), 0))
    if function.form == "cell" and function.has_period:
        rows += [(*cell, *f, SEAM, SEAM, *(1.0,) * ("jitter" in function.takes), seed)
                 for cell, f, seed in FAR_SEAMS if function.axes == 2]
    return rows


# --- Where the nearest point changes ----------------------------------------------------------------------------


def jumps(function: Function) -> bool:
    """Whether its values jump where another point becomes the nearest."""
    return bool(function.sets) or "d*" in function.gives


def distances_of(function: Function, fixed: bool) -> Evaluate:
    """The two points that the function returns data of."""
    return values_of(noises.find("cellular_phase" if function.has_phase else "cellular"), function, fixed)


def is_clear(function: Function, knobs: Knobs, row: Row) -> bool:
    # The exact sines of points that move take long, and CLEAR is several times what fixed arithmetic is off by.
    first, second = distances_of(function, fixed=function.has_phase)(knobs, row)
    return second - first >= CLEAR


def cleared(rows: Iterable[Row], function: Function, generator: Generator) -> Iterator[Row]:
    """The rows; where the second point is about as near as the first, with another seed, and with a jitter if a seed
    does not help."""
    for row in rows:
        tries = 0
        while not all(is_clear(function, knobs, row) for knobs in HASHES[function.family]):
            tries += 1
            if tries > 100:
                raise ValueError(f"{function.id}: the nearest point at {row} is not clear, whatever the seed")
            choices = list(row[:-1])
            if "jitter" in function.takes and tries > 2:
                choices[-1 - ("metric" in function.takes)] = generator.uniform(0.25, 1)
            row = (*choices, generator.word())
        yield row


def ties(function: Function, generator: Generator) -> list[Row]:
    """On walls and at corners, without a jitter: there many points are equally near."""
    rows = []
    for index in range(TIES if "jitter" in function.takes else 0):
        *row, seed = placed(function, fraction((0, 5, 8, 7)[index % 4], function.axes, generator), generator)
        of_metrics = (METRICS[index % len(METRICS)],) * ("metric" in function.takes)
        rows.append((*row, *phases(function, index, generator), 0.0, *of_metrics, seed))
    if function.axes == 2 and function.form == "cell" and "metric" in function.takes:
        rows.append(FAR_TIE)
    return rows


def changes(function: Function, knobs: Knobs, generator: Generator) -> list[Row]:
    """Pairs of rows: one step of a fraction along x from the first the nearest point is another one."""
    nearest = values_of(NEAREST, function, True)
    rows: list[Row] = []
    while len(rows) < 2 * CHANGES:
        *row, seed = placed(function, fraction(2, function.axes, generator), generator)
        x = function.axes if function.form == "cell" else 0
        chosen = [*phases(function, len(rows), generator)]
        chosen += [generator.pick((1.0, generator.uniform(0.25, 1)))] * ("jitter" in function.takes)
        chosen += [generator.pick(METRICS)] * ("metric" in function.takes)
        whole = 0 if function.form == "cell" else int(row[0] // 1)

        def at(step: int) -> Row:
            return (*row[:x], to_f32(whole + step / FINE), *row[x + 1:], *chosen, seed)

        low, high = 0, FINE - 1
        at_low = nearest(knobs, at(low))
        if nearest(knobs, at(high)) == at_low:
            continue
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if nearest(knobs, at(middle)) == at_low else (low, middle)
        rows += [at(low), at(high)]
    return rows


def for_fixed(function: Function, settings: Sequence[Configuration], generator: Generator) -> list[Row]:
    """Inputs with a value in fixed arithmetic alone."""
    if not jumps(function):
        return []
    knobs, = dict.fromkeys(knobs_of(setting) for setting in settings if setting.fixed and setting.covers(function))
    return ties(function, generator) + changes(function, knobs, generator)
