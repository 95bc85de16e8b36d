"""Feature points that go round with a phase (docs/reference/contract.md, section 16): which cells have the nearest
ones, how large the distances can be, and the errors of distances and offsets. The metric is the Euclidean one.

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

FLOATS. With B, the transpose of M, an offset is, in units of half a cell,

    B d - 2 n_z B_z - 2 n_y B_y - 2 n_x B_x - u * jitter

for the columns of B, each product and difference being rounded. The first of these is dims products and one sum less.
Every intermediate vector is at most as long as the offset of the place from the centre of the cell, since along each
axis the place is within half a cell of the centre of its own. The computed B is off by ROTATION, as a norm: in a plane
the errors of a cosine and a sine are those of a multiple of a turn. So ROTATION moves an offset by as much, times its
length before the point is subtracted. An offset that is rotated forwards has all these errors, ROTATION once more, and
those of its own sums.

FIXED. B is computed from 2^16 sines. Its error, as a norm, is evaluated at both ends of the interval of angles that
each belongs to, for each quarter of a turn: between them the exact matrix is off its chord by no more than SAGITTA. A
product that `rotated` sums rounds down by less than 2 units of 2^-20, and the product of direction and jitter by 1. The
jitter is cut twice, by less than 1 + k units.

The rank takes up to 2^-14 from a distance, but only where that is 2^-14; from a larger one, t, it takes less than
2^-28 / t. ROTATION takes the more the farther the place is from the centre of the cell. Their sum is convex in t, so it
is largest at an end.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from proof.bounds import distances, features, rotations
from proof.bounds.boxes import SAFE, Boxes, cell, supremum
from proof.bounds.distances import PLACE, RANK, f32
from proof.bounds.features import Cell
from proof.bounds.integers import DOUBLE
from proof.bounds.sine import fixed_sines

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


# --- Floats -----------------------------------------------------------------------------------------------------------

def rotation_error(dims: int) -> float:
    """ROTATION. In space two rotations are multiplied, and four of the products round."""
    plane = math.sqrt(2) * rotations.float_error()
    return plane if dims == 2 else plane * (2 + plane) + 2 * f32(0.99)


def components(dims: int, reach: float) -> tuple[float, float]:
    """As of from_points, but without ROTATION."""
    away = 2 * (reach + RADIUS[dims]) * 1.001
    projected = dims * f32(1.0) + sum(f32(math.sqrt(axes) * 1.001) for axes in range(2, dims + 1))
    centre = math.sqrt(dims) * 1.001 * f32(1.0) + projected + dims * f32(away)
    product = f32(0.99) + distances.relative(1)  # the jitter is multiplied, and rounds
    return distances.from_points(dims, reach, centre, product)


def moved_by_sines(dims: int) -> float:
    """How far distances move by that."""
    return rotation_error(dims) * (largest_distance(dims, 2) + RADIUS[dims]) * SAFE


def float_offset_error(dims: int) -> float:
    """The error of a component, from a position or a cell, in cells."""
    reach = largest_distance(dims, 1)
    length, rotation = 2 * reach, rotation_error(dims)
    err = math.hypot(*components(dims, reach)) + rotation * (length + 2 * RADIUS[dims])
    if dims == 3:
        err += math.sqrt(2) * f32(2 * length * 1.001) / 2  # x + y and x - y become x and y
    forwards = rotation * length + (2 * dims - 1) * f32(length * 1.001)
    return (((1 + rotation) * err + forwards) / 2 + 2.0**-24) * SAFE


# --- Fixed ------------------------------------------------------------------------------------------------------------

def quarter() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Angles from 0 to a quarter of a turn, in radians, with their cosines and sines in units of 2^-16: the ends of
    each interval in which these are the same, and angles where just one of them has changed. As words, angles are
    multiples of 4."""
    middle = np.arange(2**16 + 1, dtype=np.int64) << 14
    angles = np.concatenate([middle - 2**13, middle - 2**13 + 4, middle + 2**13 - 4, [0, 2**30]])
    angles = angles[(angles >= 0) & (angles <= 2**30)]
    sine, cosine = (fixed_sines()[np.minimum((q + 2**13) >> 14, 65535)] for q in (angles, 2**30 - angles))
    return angles * (math.pi / 2**31), cosine, sine


def quarters():
    """The other quarters, in turn."""
    angle, cosine, sine = quarter()
    for _ in range(4):
        yield angle, cosine, sine
        angle, cosine, sine = angle + math.pi / 2, -sine, cosine


def rows(dims: int, cosine, sine, product):
    """The rows of B."""
    if dims == 2:
        return [[cosine, sine], [-sine, cosine]]
    both = product(sine, cosine)
    return [[cosine, sine, 0 * sine], [-both, product(cosine, cosine), sine], [product(sine, sine), -both, cosine]]


def fixed_product(a, b):
    """The product of two sines in units of 2^-16."""
    return ((a >> 1) * b + 2**14) >> 15


def largest_norm(matrices: np.ndarray) -> float:
    """The largest norm of n by n matrices. The Frobenius norm is not less, and rules out most."""
    bound = np.sqrt((matrices**2).sum(axis=(0, 1)))
    least = np.linalg.norm(matrices[..., bound.argmax()], 2)
    return float(np.linalg.norm(matrices[..., bound >= least].transpose(2, 0, 1), 2, axis=(1, 2)).max())


@functools.cache
def fixed_rotation_error(dims: int) -> float:
    """ROTATION. The derivatives of the matrix by the angle have norms of at most 1 on the plane, and of 2, then 4, in
    space, where two rotations are multiplied."""
    speed = dims - 1
    sagitta = (speed * 2 * math.pi * 2.0**-18) ** 2 / 8
    worst = max(largest_norm(np.array(rows(dims, cosine, sine, fixed_product)) / 2**16
                             - np.array(rows(dims, np.cos(angle), np.sin(angle), np.multiply)))
                for angle, cosine, sine in quarters())
    return worst + sagitta + speed * rotations.ANGLE_CUT + DOUBLE


def fixed_points(dims: int) -> float:
    """How far a point is off, but for ROTATION: the first row of B in space has a 0."""
    axes = (2, 2) if dims == 2 else (2, 3, 3)
    return (math.hypot(*(2 * n for n in axes)) + LONGEST[dims] * (1 + JITTER[dims]) / 2) * PLACE


def fixed_offset_before(dims: int, distance: float) -> float:
    """How far an offset is off before its length is computed."""
    return distances.fixed_place(dims) + fixed_points(dims) + fixed_rotation_error(dims) * (distance + RADIUS[dims])


def fixed_parts(dims: int) -> dict[str, float]:
    rotated = fixed_rotation_error(dims) * (largest_distance(dims, 2) + RADIUS[dims])
    return distances.fixed_parts(dims) | {"points": fixed_points(dims) + rotated}


def fixed_distance_error(dims: int) -> float:
    """At a distance of 2^-14 after all but the rank, and at the largest."""
    reach, least = largest_distance(dims, 2), math.sqrt(RANK)
    off = fixed_offset_before(dims, reach)
    near = fixed_offset_before(dims, least + off) + least
    far = off + RANK / (reach - off)
    return (max(near, far) + 2.0**-18) * SAFE


def fixed_offset_error(dims: int) -> float:
    """The error of a component. The nearest point that is found may be farther than the nearest one, by as much as both
    are off."""
    reach = largest_distance(dims, 1) + 2.0**-10
    return (fixed_offset_before(dims, reach) * (1 + fixed_rotation_error(dims)) + fixed_rotation_error(dims) * reach
            + 2 * dims * PLACE) * SAFE


def offset_error(dims: int, fixed: bool) -> float:
    return fixed_offset_error(dims) if fixed else float_offset_error(dims)


def largest_intermediates(dims: int) -> dict[str, float]:
    """An offset is rotated forwards if it is the nearest. A square belongs to an offset to a cell at a corner of the
    block. In space the half of a sine is multiplied with another one's."""
    length = 1.5 * math.sqrt(dims) + RADIUS[dims] + 2.0**-10
    largest = int(fixed_sines().max())
    products = {"product of two sines": (largest // 2 + 1) ** 2 + 2.0**15} if dims == 3 else {}
    return {"offset of a point": 512 * distances.LARGEST_COMPONENT[dims] * JITTER[dims] * 2.0**20,
            "rotated offset": ((largest_distance(dims, 1) + 2.0**-10) * 2**12 + 1) * largest * 4,
            **products, **distances.square_intermediates(length**2)}
