"""Feature points that go round with a phase (docs/reference/contract.md, section 16): which cells have the nearest
ones, and how large the distances can be. The metric is the Euclidean one.

POINTS. All of them rotate by the same matrix M. So the point of a cell is not farther from the centre of its cell than
RADIUS: the longest direction, times half of the largest jitter. Here it may be anywhere within that.

BLOCKS. A point of a cell c is as near to a place x as one of a cell o, if |c - x| + RADIUS <= |o - x| - RADIUS, that
is,

    |o - x|^2 - |c - x|^2 >= 4 RADIUS |c - x| + 4 RADIUS^2

The left side is linear in x, and the right side is convex. So, as in features.py, the corners of the simplex are
enough, and two such cells c of the block for each o outside. Both sides are nearest at the corner of 2^n cells.

DISTANCES. In the simplex the nearest centre is the cell's own, and the next one its neighbour's along
the first axis. Both distances are convex, so with RADIUS they are largest at corners. On the plane the points of four
cells are that far from the corner where these meet, if they are rotated by 1/8. In any dimension those of the
neighbours of a cell are that far from its centre, if they are not rotated. But in space no rotation takes directions to
all diagonals of a cube. There the first distance is bounded over boxes of places and angles, as that to the farthest
corner of an octahedron that is rotated. For a constant angle this is convex in the place. With the angle a corner
moves, and is off a chord of its way by no more than 1/2 k times 4 (see below) times 1/8 of the square of the chord's
angle. Half a turn, and a rotation backwards, only reflect the rest. So angles up to a quarter of a turn are
enough.

"""

from __future__ import annotations

import functools
import math

import numpy as np

from proof.bounds import features
from proof.bounds.boxes import SAFE, Boxes, cell, supremum
from proof.bounds.features import Cell

JITTER = {2: 28 / 32, 3: 25 / 32}  # k of the contract
LONGEST = {2: math.hypot(511, 1) / 512, 3: math.hypot(510, 2) / 512}  # of the directions
RADIUS = {dims: JITTER[dims] * longest / 2 for dims, longest in LONGEST.items()}


# --- Geometry ---------------------------------------------------------------------------------------------------------

@functools.lru_cache(maxsize=None)  # blocks that differ in a cell ask for the same pairs
def always_nearer(radius: float, c: Cell, o: Cell) -> bool:
    """Whether every point of c is proven to be as near as every point of o, from all places of the simplex."""
    return all(math.dist(o, x) - math.dist(c, x) >= 2 * radius * SAFE for x in features.simplex(len(o)))


def not_proven(dims: int, block: frozenset[Cell], radius: float) -> list[Cell]:
    """The cells outside of the block that are not proven to have none of the nearest two points."""
    return features.not_proven(block, dims, 2, functools.partial(always_nearer, radius))


@functools.cache
def largest_distance(dims: int, count: int) -> float:
    """The largest that the smallest distance can be, for 1, or the second smallest, for 2."""
    cells = [(n,) + (0,) * (dims - 1) for n in range(count)]
    largest = (max(math.dist(c, x) for c in cells for x in features.simplex(dims)) + RADIUS[dims]) * SAFE
    return min(largest, largest_in_space()) if (dims, count) == (3, 1) else largest


def farthest_in_space(cells: np.ndarray, places: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """The largest distance to a point of each cell: cells by places."""
    off = (cells[:, :, None] - places[None]).transpose(1, 0, 2)
    rotated = [sum(b * d for b, d in zip(row, off)) for row in rows(3, np.cos(angles), np.sin(angles), np.multiply)]
    return np.sqrt((off**2).sum(axis=0) + JITTER[3] * abs(np.array(rotated)).max(axis=0) + JITTER[3] ** 2 / 4)


def largest_in_space() -> float:
    cells = np.array(sorted(features.neighbours(3)), float)

    def bound(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        most = boxes.at_vertices(lambda point: farthest_in_space(cells, point[:3] - 0.5, math.pi / 2 * point[3]))
        bulge = JITTER[3] / 2 * 4 / 8 * (math.pi / 2 * boxes.side) ** 2
        return most.max(axis=1).min(axis=0) + bulge, most.min(axis=0).max(axis=0)
    return supremum(bound, cell(4), 12, 3e-4)


def room(dims: int) -> float:
    """The limit for twice the radius: at the corner of a cell, how much farther the cells beyond it are."""
    corner, centre = (0.5,) * dims, (0,) * dims
    return math.dist((2, *centre[1:]), corner) - math.dist(centre, corner)


def rows(dims: int, cosine, sine, product):
    """The rows of B."""
    if dims == 2:
        return [[cosine, sine], [-sine, cosine]]
    both = product(sine, cosine)
    return [[cosine, sine, 0 * sine], [-both, product(cosine, cosine), sine], [product(sine, sine), -both, cosine]]
