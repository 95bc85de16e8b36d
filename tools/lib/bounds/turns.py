"""Gradients that turn with a phase (docs/contract.md, section 14): how far they reach, and how large noise that is made
of them can be, proven.

At the angle a = 2 pi phase a gradient g has become g(a) = cos(a) g + sin(a) g', where a quarter of a turn takes g to g'
and the component that is not in the plane of the turn to 0. So no gradient becomes longer. Where a number need not be
tight, and on the plane always, the gradients may be all that are as long as the longest one: h(v) is its length times
|v|. On the plane noise has its largest value where the offsets are along the longest gradients at some phase.

In space the range is bounded for each angle. g(a).v is g.v(a), with v turned by -a in the plane of the turn and its
other component times cos(a). A gradient turns in the plane of its two largest components. By the axis of its smallest
one there are three kinds. For one of them with v(a) let P >= Q be the components in the plane and R the other one, all
without their signs. If R <= Q, h is that of all gradients. Else the best gradient of the kind has the components 1 - t
along P and t/2 along both others: R is better than Q, but may not have more. That makes (1 + t) ((1 - t) P + t (Q + R)
/ 2), as on the plane, for t up to 2/3. h is taken as the largest of the three kinds and of both directions of the turn:
then it depends neither on the signs nor on the order of the axes. Half a turn negates a gradient, and so angles from 0
to pi/2 are enough. That h is at most the largest length times |v|, too: the smaller one counts.

In a box of places and angles the noise is bounded as in boxes.py. The second derivative of g(a).v by a is -(g(a).v),
which is at most the largest length times |v|.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable

import numpy as np

from bounds import kernels, suprema
from bounds.boxes import Boxes, cell, corners, fade, supremum
from bounds.gradients import UNIT, longest, mixed_support
from bounds.kernels import Kernel, Offsets

LEVEL = 9


def turned(x, y, angle):
    c, s = np.cos(angle), np.sin(angle)
    return c * x + s * y, c * y - s * x


def turned_support(v, angle):
    """h in space at angles, of vectors: axes by vectors."""
    best, length = 0.0, np.sqrt((v * v).sum(axis=0))
    for axis, sign in itertools.product(range(3), (1, -1)):
        p, q = map(np.abs, turned(v[(axis + 1) % 3], v[(axis + 2) % 3], sign * angle))
        best = np.maximum(best, mixed_support(np.maximum(p, q), np.minimum(p, q), np.abs(np.cos(angle) * v[axis])))
    return np.minimum(best, longest(3) * length)


# --- Suprema ----------------------------------------------------------------------------------------------------------

def _largest_in_space(value: Callable[[np.ndarray, np.ndarray], np.ndarray],
                      curvature: Callable[[Boxes], tuple[np.ndarray, np.ndarray]], tolerance: float) -> float:
    """Over places in [0, 1/2]^3 and angles, for which 1/2 stands for pi/2. `value` takes places and angles. `curvature`
    gives what the second derivatives along the axes sum to and the one by the angle."""
    def bound(boxes: Boxes):
        reached = boxes.at_vertices(lambda point: value(point[1:], math.pi * point[0])).max(axis=0)
        along, by_angle = curvature(Boxes(boxes.level, boxes.index[1:]))
        return reached + (along + math.pi**2 * by_angle) / 8 * boxes.side**2, reached
    return supremum(bound, cell(4, half=True), LEVEL, tolerance, 1)


@functools.cache
def range_of(kernel: Kernel) -> float:
    """A proven upper bound of the sum of a kernel with gradients that turn, not scaled."""
    if kernel.dims == 2:
        return kernel.longest * kernels.range_of(kernel, UNIT)

    def value(place, angle):
        return sum(turned_support(kernels.vector(kernel, kernels.VALUE, place - np.array(point)[:, None]), angle)
                   for point in kernel.points)

    def curvature(boxes: Boxes):
        along = by_angle = 0.0
        for point in kernel.points:
            offsets = Offsets.of(kernel, boxes, point)
            of_axes = [kernels.jet(kernel, kernels.VALUE, UNIT, offsets, axis) for axis in range(kernel.dims)]
            along, by_angle = along + sum(jet.second for jet in of_axes), by_angle + of_axes[0].value
        return kernel.longest * along, kernel.longest * by_angle
    return _largest_in_space(value, curvature, 3e-4)


@functools.cache
def perlin_range_of(dims: int) -> float:
    """The same of hn_perlin."""
    if dims == 2:
        return longest(2) * suprema.largest(suprema.VALUE, 2, UNIT)

    def value(place, angle):
        s, total = fade(place), 0.0
        for corner in corners(dims):
            weight = math.prod(x if o else 1 - x for x, o in zip(s, corner))
            total = total + weight * turned_support(place - np.array(corner)[:, None], angle)
        return total

    def curvature(boxes: Boxes):
        along = math.sqrt(9 / 8) * suprema.curvature(suprema.VALUE, UNIT, boxes)
        return along, np.full(boxes.index.shape[1], math.sqrt(9 / 8 * 3))
    return _largest_in_space(value, curvature, 1e-4)
