"""Proves things of a cell, box by box: the fade and its derivatives, and suprema by branch and bound.

Nothing is sampled: a supremum is bounded by branch and bound over boxes of fractions. Bounds are computed in doubles,
for many boxes at a time; SAFE inflates each result by far more than their own rounding errors.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

SAFE = 1 + 1e-9  # a few hundred double operations err by less than 1e-13 relative
# The largest |s'|, |s''| (at t = (1 - 1/sqrt(3)) / 2), |s'''|, |s''''| and |s'''''| on [0, 1], by their order.
FADE_MAX = (1.0, 15 / 8, 10 / math.sqrt(3), 60.0, 360.0, 720.0)


def fade(t):
    return t * t * t * (t * (t * 6 - 15) + 10)


def fade_derivative(order, t):
    """The derivative of an order from 0 (the fade itself) to 3."""
    if order == 0:
        return fade(t)
    if order == 1:
        return 30 * (t * (1 - t)) ** 2
    return {2: 60 * t * (1 - t) * (1 - 2 * t), 3: 60 - 360 * t * (1 - t)}[order]


def largest_derivative(order, lo, hi):
    """A bound of |s^(order)|, for order 1 to 3, on [lo, hi]: it is off a straight line by at most its own second
    derivative times (hi - lo)^2 / 8."""
    ends = np.maximum(abs(fade_derivative(order, lo)), abs(fade_derivative(order, hi)))
    return np.minimum(ends + FADE_MAX[order + 2] / 8 * (hi - lo) ** 2, FADE_MAX[order])


def corners(dims):
    return itertools.product((0, 1), repeat=dims)


# --- Branch and bound -------------------------------------------------------------------------------------------------

CHUNK = 1 << 14  # boxes at a time: so the numbers of a few stay in the processor's cache


@dataclass(frozen=True)
class Boxes:
    """Boxes with sides of 2^-level. The index of a box, times that, is its lower end along each axis."""
    level: int
    index: np.ndarray  # axes by boxes

    @property
    def side(self) -> float:
        return 0.5 ** self.level

    @property
    def lo(self) -> np.ndarray:
        return self.index * self.side

    @property
    def hi(self) -> np.ndarray:
        return (self.index + 1) * self.side

    @property
    def dims(self) -> int:
        return self.index.shape[0]

    def vertices(self) -> Iterator[np.ndarray]:
        """Each end of all the boxes in turn."""
        for corner in corners(self.dims):
            yield (self.index + np.array(corner)[:, None]) * self.side

    def at_vertices(self, value: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        """The values of a function of places, axes by places, at each end of each box, vertices by boxes. Boxes share
        most of their ends, and each is computed once."""
        ends = np.concatenate([self.index + np.array(corner)[:, None] for corner in corners(self.dims)], axis=1)
        first = ends.min(axis=1, keepdims=True)
        spans = [int(span) for span in (ends - first).max(axis=1) + 1]
        if math.prod(spans) >= 2**63:
            places, which = ends, np.arange(ends.shape[1])
        else:
            _, some, which = np.unique(np.ravel_multi_index(tuple(ends - first), spans), return_index=True,
                                       return_inverse=True)
            places = ends[:, some]
        values = value(places * self.side)
        return values[..., which].reshape(*values.shape[:-1], 2**self.dims, self.index.shape[1])

    def only(self, which) -> Boxes:
        return Boxes(self.level, self.index[:, which])

    def halved(self) -> Boxes:
        """Each cut in two along each axis. The parts of a box follow each other, as they share ends."""
        parts = [2 * self.index + np.array(corner)[:, None] for corner in corners(self.dims)]
        return Boxes(self.level + 1, np.stack(parts, axis=2).reshape(self.dims, -1))

    def sorted_from(self, axis: int) -> Boxes:
        """Only those that have points with f_axis <= .. <= f_n: each other point is such a one with axes exchanged."""
        index = self.index[axis:]
        return self.only((index[:-1] <= index[1:]).all(axis=0))


def cell(dims: int, half: bool = False) -> Boxes:
    """[0, 1]^dims as one box, or [0, 1/2]^dims."""
    return Boxes(1 if half else 0, np.zeros((dims, 1), np.int64))


def grid(dims: int, level: int) -> Boxes:
    """The boxes of [0, 1/2]^dims of that level."""
    boxes = cell(dims, half=True)
    while boxes.level < level:
        boxes = boxes.halved()
    return boxes


Bound = Callable[[Boxes], tuple[np.ndarray, ...]]


def in_chunks(bound: Bound, boxes: Boxes) -> list[np.ndarray]:
    count = boxes.index.shape[1]
    chunks = [bound(boxes.only(slice(start, start + CHUNK))) for start in range(0, count, CHUNK)]
    return [np.concatenate(column) for column in zip(*chunks)]


def supremum(bound: Bound, boxes: Boxes, levels: int, tolerance: float = 1e-6, exchange: int | None = None,
             most: int = 200_000) -> float:
    """An upper bound over the boxes. `bound` gives one for each box, and a lower bound of the supremum: a box
    whose bound is above the largest of these by more than the tolerance is halved, down to a level or until there are
    too many boxes. Every box that is not halved counts with its bound. From the axis `exchange` on, axes may be
    exchanged."""
    settled = best = 0.0
    while True:
        if exchange is not None:
            boxes = boxes.sorted_from(exchange)
        upper, lower = in_chunks(bound, boxes)
        best = max(best, float(lower.max()))
        rest = upper > best * (1 + tolerance)
        if not rest.any() or boxes.level >= levels or rest.sum() << boxes.dims > most:
            return max(settled, float(upper.max())) * SAFE
        settled = max(settled, float(upper[~rest].max(initial=0.0)))
        boxes = boxes.only(rest).halved()


def smooth(value: Callable[[np.ndarray], np.ndarray], curvature: Callable[[Boxes], np.ndarray]) -> Bound:
    """The bound of a value that is a maximum of smooth functions. `curvature` gives the sum of the largest magnitudes
    of their second derivatives along the axes, on a box: multilinear interpolation between the vertices errs by at most
    1/8 of that times the side squared."""
    def bound(boxes: Boxes) -> tuple[np.ndarray, np.ndarray]:
        attained = boxes.at_vertices(value).max(axis=0)
        return attained + curvature(boxes) / 8 * boxes.side ** 2, attained
    return bound
