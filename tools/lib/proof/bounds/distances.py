"""The errors of cellular noise that its text does not prove (text.py): in floats those of borders, of
offsets from points that move, and of the third distance in space; and those in integers.

FLOATS. As elsewhere an operation returns one of the two floats around its exact result (floats.py). GLSL leaves more
room to a square root and to a division: here a root is taken to be within ROOT_ULPS and a quotient within
QUOTIENT_ULPS. Vulkan allows 2 ulp to inversesqrt and 2.5 to a division, and makes a root of both. HN_PRECISE computes
1 / sqrt(q) itself, and is within these. Offsets are in units of half a cell:

    d = 2 f - 1;  d - 2 n for the n-th cell after it;  from the point: d - u * jitter

In space the first two components are x + y and x - y, and the square of the length is half of theirs and z * z.

FIXED. Along an axis an offset D is off by less than 1 unit of 2^-20 cells for the place, 1 for the product of
direction and jitter, and u/2 for the cut of the jitter. N rounds down by less than a unit of 2^-28, which takes up to
2^-14 from a root: where the distance is 2^-14. The root rounds down by less than 2^-18.

BORDERS. The distance to the border of the points P and Q is (|x - Q|^2 - |x - P|^2) / (2 s), s = |P - Q|. If
differences from the place are off by e, then the squares by 2 e each times a distance, and |x - Q| <= |x - P| + s. So
the error grows as 1/s. The components of a direction are below 1, so that points of different cells are at least
APART from each other. Where another point than P is taken for the nearest one, both results are between 0 and
that error. Moving the place itself moves the border by no more than that.
"""

from __future__ import annotations

import math

import numpy as np

from proof.bounds import features
from proof.bounds.boxes import SAFE
from proof.bounds.floats import UNIT, rounding

ROOT_ULPS, QUOTIENT_ULPS = 6.0, 3.0
PLACE, RANK = 2.0**-20, 2.0**-28  # the units of offsets and of squares in fixed arithmetic
LARGEST_COMPONENT = {2: 511 / 512, 3: 255 / 256}  # of a direction
APART = {dims: 1 - largest for dims, largest in LARGEST_COMPONENT.items()}
OPERATIONS = {2: 2, 3: 3}  # that a square of a length rounds in, one after another


def f32(magnitude: float) -> float:
    return float(rounding(magnitude))


# --- Floats -----------------------------------------------------------------------------------------------------------

def components(dims: int, reach: float) -> tuple[float, float]:
    """The errors of a component along x or y, in space of x + y or x - y, and of one along z. `reach` is the largest
    distance that matters, in cells; all else here is in half cells."""
    centre = f32(1.0) + f32(min(2 * reach + 1, 3.99))
    return from_points(dims, reach, centre, f32(0.99))


def from_points(dims: int, reach: float, centre: float, product: float) -> tuple[float, float]:
    """Such errors where a component of the offset from the centre of a cell, and the product of a direction and the
    jitter, are off by so much: of two components that are rotated, so that these are longer by sqrt(2), and of a third one.
    HN_PRECISE may take a jitter as 0."""
    length, point = 2 * reach, product + 2.0**-32
    along = centre + point + f32(length * 1.001)
    if dims == 2:
        return along, along
    rotated = math.sqrt(2) * length * 1.001
    return 2 * centre + f32(rotated + 1) + point + f32(rotated), along


def relative(operations: float) -> float:
    return (1 + UNIT) ** operations - 1


def euclidean_reach(metric: str, dims: int, largest: float) -> float:
    """How far a point can be that is so far in a metric."""
    return {"euclidean": largest, "squared": math.sqrt(largest), "manhattan": largest,
            "chebyshev": largest * math.sqrt(dims), "hybrid": (math.sqrt(1 + 4 * largest) - 1) / 2}[metric]


def manhattan_reach(metric: str, dims: int, largest: float) -> float:
    """The reach in the Manhattan metric."""
    if metric == "hybrid":
        return dims * (math.sqrt(1 + 4 * largest / dims) - 1) / 2
    if metric == "manhattan":
        return largest
    return euclidean_reach(metric, dims, largest) * math.sqrt(dims)


def hybrid_error(dims: int, largest: float) -> float:
    """The error of a distance up to the largest in the hybrid metric, in cells."""
    reach, size = (of("hybrid", dims, largest) for of in (euclidean_reach, manhattan_reach))
    across, along = components(dims, reach)
    length, err = 2 * reach, math.hypot(across, along)
    square = (length + err) ** 2 * (1 + relative(OPERATIONS[dims])) - length**2
    total = (2 * across if dims == 2 else across + along) + f32(2 * size * 1.001)
    return (square / 2 + f32(2 * reach**2 * 1.001) + total + f32(2 * largest * 1.001)) / 2 * SAFE


def metric_slope(metric: str, dims: int, largest: float) -> float:
    """How fast a distance changes, for the largest coordinate."""
    if metric == "hybrid":
        return dims + 2 * manhattan_reach(metric, dims, largest)
    if metric == "squared":
        return 2 * manhattan_reach(metric, dims, largest)
    return {"euclidean": math.sqrt(dims), "manhattan": float(dims), "chebyshev": 1.0}[metric]


def _over_distances(error, dims: int, apart: float) -> float:
    """The largest of an error that is convex in the distance of two points: at an end."""
    return max(error(apart), error(2 * BLOCK_REACH[dims])) * SAFE


BLOCK_REACH = {dims: math.sqrt(2.5**2 + (dims - 1) * 1.5**2) for dims in (2, 3)}  # to the farthest point of a block


def border_error(dims: int, apart: float | None = None) -> float:
    """The error for points that are at least so far apart."""
    largest, first = features.largest_border(dims), features.largest_distance(dims, 1)
    of_offset = math.hypot(*components(dims, BLOCK_REACH[dims])) / 2
    squares = relative(OPERATIONS[dims] + 1)
    steps = relative(3 + OPERATIONS[dims] / 2) + UNIT * (ROOT_ULPS + QUOTIENT_ULPS) + UNIT**2 * 1000

    def error(s: float) -> float:
        off = 2 * of_offset  # of s
        gap = (2 * of_offset * (s + 2 * first) + 2 * of_offset**2
               + squares * ((first + s + of_offset) ** 2 + (first + of_offset) ** 2))
        return gap / (2 * (s - off)) * (1 + steps) + largest * (off / (s - off) + steps)
    return _over_distances(error, dims, APART[dims] if apart is None else apart)


# --- Fixed ------------------------------------------------------------------------------------------------------------

def fixed_place(dims: int) -> float:
    """How far the cut moves the place."""
    return math.sqrt(dims) * PLACE


def fixed_point(dims: int) -> float:
    """How far a point is off."""
    return (math.sqrt(dims) + 0.5) * PLACE


def fixed_parts(dims: int) -> dict[str, float]:
    """The parts of the Euclidean distance."""
    return {"cut": fixed_place(dims), "points": fixed_point(dims), "rank": math.sqrt(RANK), "scaling": 2.0**-18}


def fixed_metric_error(metric: str, dims: int, largest: float) -> float:
    reach, off = euclidean_reach(metric, dims, largest), fixed_place(dims) + fixed_point(dims)
    square, total = off * (2 * reach + off) + PLACE + RANK, (2 * dims + 0.5) * PLACE
    return SAFE * {"euclidean": sum(fixed_parts(dims).values()), "squared": square, "manhattan": total,
                   "chebyshev": 2.5 * PLACE, "hybrid": square + total}[metric]


def fixed_direction_parts(dims: int) -> dict[str, float]:
    """The parts of a derivative, times the distance. An offset D that is made longer, to k D, is at least 2^17 long
    then. Its root, in units of 4, rounds down by less than 4 / |k D| of it. This times |D| is at most 4 units of
    2^-20."""
    reach = features.largest_distance(dims, 1)
    return {"cut": 2 * fixed_place(dims), "points": 2 * fixed_point(dims), "rank": 2.0**-26,
            "scaling": 2.0**-18 * (1 + 2.0**-13) + 2.0**-21 * reach}


def fixed_smooth_parts(dims: int) -> dict[str, float]:
    """The parts of hn_cellular_smooth. A weight rounds down: t by less than 2^-16, t * t by 2^-16, and its square by
    2^-30. These take less than 2^-15 t^2 + 2^-30 from a weight. The squares of t sum to at most the root of their
    number times the sum of weights W, which is halved from step to step here."""
    number, unit = features.most_within(dims), 2.0**-16
    root = number**0.25
    edges = features.largest_weights(dims) * 1.01 * 0.999 ** np.arange(40_000)
    taken = 2 * unit * np.sqrt(number * edges[:-1]) + number * 2.0**-30
    weights = (taken / (4 * (np.maximum(edges[1:] - taken, 0.0) + 1 / 4096) ** 0.75)).max()
    of_distance = {part: value * root for part, value in fixed_parts(dims).items()}
    of_distance["scaling"] += 2.0**-17 * 1.001 + 2.0**-19  # the two roots
    return of_distance | {"weights": root * unit + float(weights)}


def fixed_border_parts(dims: int, apart: float | None = None) -> dict[str, float]:
    """M rounds down by less than a unit of 2^-26, and its root by less than 2^-17."""
    largest, first = features.largest_border(dims), features.largest_distance(dims, 1)
    point = fixed_point(dims)
    off = 2 * point + math.sqrt(dims) * 2 * PLACE

    def points(s: float) -> float:
        gap = 2 * point * (s + 2 * first + 4 * PLACE) + RANK
        return gap / (2 * (s - off)) + largest * off / (s - off)

    def rank(s: float) -> float:
        computed = math.sqrt((s - off) ** 2 - 2.0**-26) - 2.0**-17
        return (largest + points(s)) * (s / computed - 1)
    apart = APART[dims] if apart is None else apart
    return {"cut": fixed_place(dims), "points": _over_distances(points, dims, apart), "rank": rank(apart) * SAFE,
            "scaling": 2.0**-16}


# Magnitudes of fixed arithmetic. Words are below 2^32, so half of them is listed.

def largest_square(dims: int) -> float:
    """In cells, of an offset from a point of a block: of its farthest cell in the middle of a slab, or at a corner."""
    return 2.5**2 + (dims - 1) * 1.5**2 + 2.0**-10


def square_intermediates(largest: float) -> dict[str, float]:
    """The words of a square of so many cells, and of its rest after a root."""
    return {"half of a square": largest * 2**28 / 2, "rest of a square": 2 * math.sqrt(largest) * 2**18 + 2}


def largest_intermediates(dims: int) -> dict[str, float]:
    """The product of a direction and the jitter, and the square."""
    return {"offset of a point": 512 * LARGEST_COMPONENT[dims] * 2.0**20, **square_intermediates(largest_square(dims))}


def largest_direction_intermediates(dims: int) -> dict[str, float]:
    """A component that is divided, which is lengthened only if it is below 2^-3 cells."""
    longest = features.largest_distance(dims, 1) + 2.0**-10
    return {"half of a numerator": longest * 2**31 / 2, "half of a rest": math.sqrt(dims) * longest * 2**18 * 2**8 / 2}


def largest_smooth_intermediates(dims: int) -> dict[str, float]:
    weights = features.largest_weights(dims) + 2.0**-10
    return {"half of the sum of weights": weights * 2**30 / 2, "half of a root": math.sqrt(weights) * 2**30 / 2}


def largest_border_intermediates(dims: int) -> dict[str, float]:
    """A difference of squares over a root is below the sum of two distances, but for the errors of a small root."""
    sum_of_distances = BLOCK_REACH[dims] + features.largest_distance(dims, 1)
    return {"quotient": 1.02 * sum_of_distances * 2**15, "rest of a quotient": 4 * BLOCK_REACH[dims] * 2**17 + 2}
