"""Finds where the feature points of cellular noise can be (docs/reference/contract.md, section 16): which cells have
the nearest ones, and how large the distances can be.

The point of a cell lies in an octahedron (on the plane a square): the places that are not farther than 1/2 from the
centre of the cell, in sum along the axes. Points of different cells are independent. So at a place x the largest that
the k-th smallest distance can be is the k-th smallest distance to the farthest places of the octahedra, and everything
that falls with each distance is largest where each point is nearest. A jitter below 1 only makes the octahedra smaller.

BLOCKS. Let S_k(v) be the sum of the k largest magnitudes of the components of v. It is a norm, and S_k(u) <= 1/2 for
the offset u of a point from the centre of its cell. So if for cells c and o, and for every k,

    S_k(c - x) + 1 <= S_k(o - x)        (relative to x, with integer centres)

then every point of o is at least as far from x as every point of c, in each metric that is a convex and symmetric
function of the magnitudes that grows with each (Hardy, Littlewood and Polya; all five are). To have the m nearest
points, a block of cells needs, for every x, m such cells c for each cell o outside of it. By reflections and exchanges
of axes 1/2 >= x_1 >= x_2 >= .. >= 0. There the left side is convex, and a sum of k components of o - x is linear and
not more than the right side; so it is enough to look at the corners of this simplex. The program does that in fractions. A cell
o beyond +-3 along an axis is farther than the one that has 3 there instead.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

import numpy as np

from proof.bounds.boxes import Boxes, cell, supremum

Cell = tuple[int, ...]
HALF = Fraction(1, 2)
FARTHEST = 3  # along an axis; see above


# --- Blocks -----------------------------------------------------------------------------------------------------------

def neighbours(dims: int) -> frozenset[Cell]:
    """The middle cell and those around it."""
    return frozenset(itertools.product((-1, 0, 1), repeat=dims))


def slab(dims: int, axis: int) -> frozenset[Cell]:
    """The cells beside the block that are two steps on along an axis."""
    return frozenset(c[:axis] + (2,) + c[axis:] for c in itertools.product((-1, 0, 1), repeat=dims - 1))


def outside(block: Iterable[Cell], dims: int) -> list[Cell]:
    return sorted(set(itertools.product(range(-FARTHEST, FARTHEST + 1), repeat=dims)) - set(block))


def simplex(dims: int) -> list[tuple[Fraction, ...]]:
    """The corners of 1/2 >= x_1 >= x_2 >= .. >= 0."""
    return [(HALF,) * k + (Fraction(0),) * (dims - k) for k in range(dims + 1)]


def largest_sum(v: Sequence[Fraction], k: int) -> Fraction:
    """S_k."""
    return sum(sorted(map(abs, v), reverse=True)[:k], Fraction(0))


@functools.lru_cache(maxsize=None)  # blocks that differ in a cell ask for the same pairs
def always_nearer(c: Cell, o: Cell) -> bool:
    """Whether every point of c is proven to be as near as every point of o, from all places of the simplex."""
    dims, places = len(o), simplex(len(o))
    sizes = [[abs(o_i - x_i) for o_i, x_i in zip(o, x)] for x in places]
    for k in range(1, dims + 1):
        needed = [largest_sum([c_i - x_i for c_i, x_i in zip(c, x)], k) + 1 for x in places]
        if not any(all(sum(size[i] for i in chosen) >= least for size, least in zip(sizes, needed))
                   for chosen in itertools.combinations(range(dims), k)):
            return False
    return True


def not_proven(block: Iterable[Cell], dims: int, count: int,
               nearer: Callable[[Cell, Cell], bool] = always_nearer) -> list[Cell]:
    """The cells outside of the block that are not proven to have none of the nearest points, so many of them."""
    block = frozenset(block)
    return [o for o in outside(block, dims) if sum(nearer(c, o) for c in block) < count]


# --- Distances --------------------------------------------------------------------------------------------------------

def _from_centre(c: Cell, places: np.ndarray) -> np.ndarray:
    return abs(places - np.array(c, float).reshape(-1, *[1] * (places.ndim - 1)))


def farthest(c: Cell, places: np.ndarray, metric: str = "euclidean") -> np.ndarray:
    """The largest distance to a point of the cell: to a corner of the octahedron, since distances are convex. Of
    these one along the axis where the place is farthest from the centre."""
    v = _from_centre(c, places)
    if metric == "chebyshev":
        return v.max(axis=0) + 0.5
    total = v.sum(axis=0) + 0.5
    if metric == "manhattan":
        return total
    square = (v * v).sum(axis=0) + v.max(axis=0) + 0.25
    return {"euclidean": np.sqrt, "squared": np.positive, "hybrid": total.__add__}[metric](square)


def nearest(c: Cell, places: np.ndarray) -> np.ndarray:
    """The smallest Euclidean distance to the octahedron of the cell: the cut of each component is at most
    `cut`, so that the rest has the sum 1/2."""
    v = -np.sort(-_from_centre(c, places), axis=0)
    sums = np.cumsum(v, axis=0)
    cut = np.maximum(np.maximum.reduce([(sums[k] - 0.5) / (k + 1) for k in range(len(v))]), 0.0)
    return np.sqrt((np.minimum(v, cut) ** 2).sum(axis=0))


METRICS = ("euclidean", "squared", "manhattan", "chebyshev", "hybrid")
TOLERANCE, LEVELS = 1e-5, 24


@functools.cache
def largest_distance(dims: int, count: int, metric: str = "euclidean") -> float:
    """The largest that the smallest distance can be, for 1, the second smallest for 2, and so on. In a box each
    farthest distance is largest at a vertex, as it is convex."""
    cells = sorted(neighbours(dims) | slab(dims, 0))

    def bound(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        most = boxes.at_vertices(lambda places: np.array([farthest(c, places, metric) for c in cells]))
        smallest = np.partition(most, count - 1, axis=0)[count - 1]
        return np.partition(most.max(axis=1), count - 1, axis=0)[count - 1], smallest.max(axis=0)
    return supremum(bound, cell(dims, half=True), LEVELS, TOLERANCE, exchange=0)


def closeness(distance):
    """The weight of a point of hn_cellular_smooth."""
    return np.maximum(1 - distance, 0.0) ** 4


@functools.cache
def largest_weights(dims: int) -> float:
    """The largest sum of weights. In a box no point is nearer than from the middle, less half a diagonal."""
    cells = sorted(neighbours(dims))

    def of_places(places: np.ndarray, nearer: float = 0.0) -> np.ndarray:
        return sum(closeness(np.maximum(nearest(c, places) - nearer, 0.0)) for c in cells)

    def bound(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        middle = (boxes.lo + boxes.hi) / 2
        return of_places(middle, boxes.side / 2 * dims**0.5), of_places(middle)
    return supremum(bound, cell(dims, half=True), LEVELS, 5e-4, exchange=0)


# --- Borders ----------------------------------------------------------------------------------------------------------

def _covering(places: np.ndarray) -> np.ndarray:
    """The largest distance from the nearest point, at places that are anywhere: all is periodic. Along each axis the
    middle of the place's own cell is the nearest one, so of no other cell is the farthest place as near."""
    return farthest((0,) * len(places), places - np.rint(places))


@functools.cache
def largest_border(dims: int) -> float:
    """A bound of the distance to the border. Let P be the nearest point of a place x, and r that distance. Then P is
    the nearest point of every y within r of x, and |y - P| is at most the covering D(y). For y = x + d and x - d the
    mean of |y - P|^2 is |d|^2 + |x - P|^2. So r cannot be |d|, if the mean of D(x + d)^2 and D(x - d)^2 is less than
    |d|^2. D changes by no more than its place does."""
    reach = {2: 4, 3: 2}[dims]
    directions = np.array([np.array(d) / np.linalg.norm(d)
                           for d in itertools.product(range(-reach, reach + 1), repeat=dims)
                           if next((i for i in d if i), 0) > 0 and max(map(abs, d)) == reach]).T[:, :, None]
    lengths = np.arange(96, 160) / 128

    def of_places(middle: np.ndarray, off: float) -> np.ndarray:
        """The least length that is refuted along any of the directions."""
        found, left = np.full(middle.shape[1], lengths[-1]), np.arange(middle.shape[1])
        for length in lengths:
            places, step = middle[:, None, left], length * directions
            mean = (_covering(places + step) + off) ** 2 + (_covering(places - step) + off) ** 2
            refuted = (mean / 2 < length**2).any(axis=0)
            found[left[refuted]], left = length, left[~refuted]
        return found

    def bound(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        middle = (boxes.lo + boxes.hi) / 2
        return of_places(middle, boxes.side / 2 * dims**0.5), of_places(middle, 0.0)
    return supremum(bound, cell(dims, half=True), 6, 0.01, exchange=0, most=400)
