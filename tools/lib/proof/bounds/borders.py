"""Which cells hn_cell_border needs: a proof for the plane, and a search.

Let P be the nearest point of a place x, and r the distance from x to the border by the points of a block of cells. So
P is the nearest one of the block from every y within r of x. If a point Q of a cell outside of the block made the
border nearer, there would be such a y with |y - Q| < |y - P|. Let N(y) be the smallest distance to an octahedron
outside of the block, and D(y) the smallest of the largest distances to the octahedra of the block. Then

    |y' - P| <= D(y') for all y' within r of x,    and N(y) < |y - P| <= D(y) for a y within r of x.

So with U = {y: |y - P| > D(y)} and W = {y: N(y) < |y - P| <= D(y)} the block is right if no W is nearer to x than U,
for all places x and P. D and N depend on y only: the points of all cells but P's are gone.

One case is left out: where two points touch, U may be empty. In the middle of a cell D is 1/2. If two centres of cells
that are 1 apart are within r of x, then P is within 1/2 of both, and so it is in the middle between them. But no point
is: directions are not along an axis. So r is less than the larger distance to the two, whichever they are: 0 and one
beside it are taken here.

Branch and bound over boxes of x and P bounds by how much this fails: places y of a grid, some of them in U from
everywhere in the box of P, and boxes of y that may meet W. By reflections and exchanges of axes 1/2 >= x_1 >= .. >= 0.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from proof.bounds import features
from proof.bounds.boxes import Boxes
from proof.bounds.features import Cell

REACH = 0.8125  # a point farther from a place does not matter: r is less, as the proof finds, too


def block(dims: int) -> frozenset[Cell]:
    """The cells that the library reads, for a place with coordinates from 0 on."""
    return features.neighbours(dims).union(*(features.slab(dims, axis) for axis in range(dims)))


@dataclass(frozen=True)
class Grid:
    """Places y in steps of 2^-level, which are the middles of boxes, with D and N there."""
    places: np.ndarray
    half: float
    covered: np.ndarray
    beyond: np.ndarray

    @staticmethod
    def of(cells: Iterable[Cell], dims: int, level: int) -> Grid:
        side, cells = 0.5**level, frozenset(cells)
        axis = np.arange(-REACH, 0.5 + REACH, side) + side / 2
        places = np.array(np.meshgrid(*[axis] * dims)).reshape(dims, -1)
        away = np.maximum(np.maximum(-places, places - 0.5), 0.0)
        places = places[:, (away**2).sum(axis=0) < REACH**2]
        covered = np.minimum.reduce([features.farthest(c, places) for c in cells])
        beyond = np.minimum.reduce([features.nearest(c, places) for c in features.outside(cells, dims)])
        return Grid(places, side / 2, covered, beyond)

    def only(self, which: np.ndarray) -> Grid:
        return Grid(self.places[:, which], self.half, self.covered[which], self.beyond[which])

    def may_meet(self) -> Grid:
        """Only boxes in which N may be less than D. Both change by no more than the place does."""
        return self.only(self.beyond - self.covered < 2 * self.half * len(self.places) ** 0.5)


def _spans(middle: np.ndarray, places: np.ndarray, half: float) -> tuple[np.ndarray, np.ndarray]:
    """The smallest and the largest squares of the distances between boxes and places: boxes by places."""
    low = high = 0.0
    for m, y in zip(middle, places):
        size = abs(m[:, None] - y)
        low = low + np.maximum(size - half, 0.0) ** 2
        high = high + (size + half) ** 2
    return low, high


SLACK = 1e-9


def possible(boxes: Boxes, dims: int) -> np.ndarray:
    """Whether P may be in an octahedron, and the nearest point of x."""
    x, p = np.split((boxes.lo + boxes.hi) / 2, [dims])
    half, cells = boxes.side / 2, features.neighbours(dims)
    away = np.sqrt((np.maximum(abs(x - p) - 2 * half, 0.0) ** 2).sum(axis=0))
    covered = np.minimum.reduce([features.farthest(c, x) for c in cells])
    inside = np.logical_or.reduce([np.maximum(abs(p - np.array(c)[:, None]) - half, 0.0).sum(axis=0) <= 0.5 + SLACK
                                   for c in cells])
    return inside & (away <= covered + half * dims**0.5 + SLACK)


def room(boxes: Boxes, dims: int, grid: Grid, meets: Grid) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For boxes of x and P, a lower bound of the distance to W less an upper one of r. Further which places, and which
    boxes that may meet W, can make a difference in parts of these boxes."""
    x, p = np.split((boxes.lo + boxes.hi) / 2, [dims])
    half = boxes.side / 2
    # r: up to a y of U, and to one of two centres.
    x_low, x_high = _spans(x, grid.places, half)
    p_low, p_high = _spans(p, grid.places, half)
    reach = np.where(p_low > (grid.covered + SLACK) ** 2, x_high, REACH**2).min(axis=1, initial=REACH**2)
    own, beside = ((abs(x) + half) ** 2).sum(axis=0), x.copy()
    beside[0] = 1 - x[0]
    reach = np.minimum(reach, np.maximum(own, ((abs(beside) + half) ** 2).sum(axis=0)))
    matter = ((x_low <= reach[:, None]) & (p_high > grid.covered**2)).any(axis=0)
    # W
    wide, off = half + meets.half, meets.half * dims**0.5 + SLACK
    x_low, _ = _spans(x, meets.places, wide)
    p_low, p_high = _spans(p, meets.places, wide)
    may = (p_high > np.maximum(meets.beyond - off, 0.0) ** 2) & (p_low <= (meets.covered + off) ** 2)
    to_w = np.where(may, x_low, REACH**2).min(axis=1, initial=REACH**2)
    return np.sqrt(to_w) - np.sqrt(reach), matter, (may & (x_low <= reach[:, None] + SLACK)).any(axis=0)


def start(dims: int, level: int) -> Boxes:
    """All x of the simplex, and P in the cells around."""
    ranges = [range(2 ** (level - 1))] * dims + [range(-3 * 2 ** (level - 1), 3 * 2 ** (level - 1))] * dims
    index = np.array(list(itertools.product(*ranges))).T
    return Boxes(level, index).only((index[:dims - 1] >= index[1:dims]).all(axis=0))


def simplex_only(boxes: Boxes, dims: int) -> Boxes:
    index = boxes.index[:dims]
    return boxes.only((index[:-1] >= index[1:]).all(axis=0))


def prove(cells: Iterable[Cell], dims: int, levels: int, grid_level: int, first: int = 2) -> tuple[float, int]:
    """How much of r, at most, a point outside of the block may cut off, down to boxes of that level, and how many boxes
    were looked at: 0 is a proof."""
    grid = Grid.of(cells, dims, grid_level)
    meets = grid.may_meet()
    first_boxes = start(dims, first)
    stack = [(first_boxes.only([i]), grid, meets) for i in range(first_boxes.index.shape[1])]
    count, worst = 0, 0.0
    while stack:
        boxes, grid, meets = stack.pop()
        boxes = boxes.only(possible(boxes, dims))
        if boxes.index.shape[1] == 0:
            continue
        count += boxes.index.shape[1]
        found, matter, may = room(boxes, dims, grid, meets)
        left = found < SLACK
        if boxes.level >= levels:
            worst = max(worst, float(-found[left].min(initial=0.0)))
        elif left.any():
            grid, meets = grid.only(matter), meets.only(may)
            for i in np.flatnonzero(left):
                stack.append((simplex_only(boxes.only([i]).halved(), dims), grid, meets))
    return worst, count


# --- A search ---------------------------------------------------------------------------------------------------------

def octahedron(dims: int, steps: int) -> np.ndarray:
    """Places on it, its corners among them, but for a little, so that no two cells touch."""
    parts = np.array([c for c in itertools.product(range(-steps, steps + 1), repeat=dims) if sum(map(abs, c)) == steps])
    return parts.T / (2 * steps) * (1 - 2.0**-10)


def cut_off(cells: Iterable[Cell], dims: int, x: np.ndarray, p: np.ndarray, steps: int) -> np.ndarray:
    """The length of a block's border that a point outside of the block cuts off, for places x and nearest points P.
    Points of different cells are independent: the block's are where their borders are farthest, as far as is tried, and
    the one outside is where its border is nearest. A positive length is a fault of the block."""
    points, cells = octahedron(dims, steps), frozenset(cells)
    own = np.rint(p)

    def borders(cell: Cell) -> np.ndarray:
        q = points + np.array(cell)[:, None]
        square = ((x[:, :, None] - q[:, None]) ** 2).sum(axis=0) - ((x - p) ** 2).sum(axis=0)[:, None]
        return square / (2 * np.sqrt(((p[:, :, None] - q[:, None]) ** 2).sum(axis=0)))
    inside = [np.where((own == np.array(c)[:, None]).all(axis=0), np.inf, borders(c).max(axis=1)) for c in cells]
    outer = [c for c in itertools.product(range(-2, 4), repeat=dims) if c not in cells]
    beyond = np.minimum.reduce([borders(c).min(axis=1) for c in outer])
    least = np.minimum.reduce(inside)
    return np.where(least > 0, least - beyond, -np.inf)  # else P is not the nearest point


def search(cells: Iterable[Cell], dims: int, rounds: int, count: int, steps: int, seed: int = 0) -> float:
    """The largest of these, by random search near the best ones."""
    rng = np.random.default_rng(seed)

    def fresh(number: int) -> tuple[np.ndarray, np.ndarray]:
        points = octahedron(dims, steps)
        cell = rng.integers(-1, 2, (dims, number)) * (rng.random((dims, number)) < 0.5)
        return (rng.uniform(0, 0.5, (dims, number)) * (rng.random((dims, number)) < 0.7),
                cell + points[:, rng.integers(0, points.shape[1], number)] * rng.uniform(0.5, 1, number))
    x, p = fresh(4 * count)
    best, reach = -np.inf, 0.1
    for _ in range(rounds):
        found = cut_off(cells, dims, x, p, steps)
        order = found.argsort()[::-1][:count // 4]
        best = max(best, float(found[order[0]]))
        near = np.tile(order, 4)
        move = rng.normal(0, reach, (2, dims, len(near))) * (np.arange(len(near)) >= len(order))
        x_near = np.clip(x[:, near] + move[0], 0, 0.5)
        off = p[:, near] + move[1] - (cell := np.rint(p[:, near]))
        off *= np.minimum(1, 0.5 * (1 - 2.0**-10) / np.maximum(abs(off).sum(axis=0), 1e-9))
        x_new, p_new = fresh(count // 4)
        x, p, reach = np.concatenate([x_near, x_new], axis=1), np.concatenate([cell + off, p_new], axis=1), reach * 0.9
    return best
