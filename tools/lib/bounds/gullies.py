"""hn_gullies: what is proven of the waves of its octaves, and how far the sum may be off, from docs/contract.md, section
24. float_sums.py has the same of floats, for which the suite has the formula: conformance/expected/gullies.cpp.

WAVES. A wave is k = 3/2 (-u_y, u_x) with |u| < 1, so it is shorter than 3/2. The bounds of value and derivatives are
those of phasor noise for 3/2 waves along each axis. How long the vector g of both derivatives is, and how fast v and g
change with k, is bounded by a sum over the points of

    G            hypot(2 m w' |d|, |k| w)                              in units of 1 / cells, times 2 pi with each k
    of v         2 pi |d| w
    of g         2 pi hypot(max(w, 2 m w' |d|^2 - w), 2 pi |k| |d| w)

with d in cells. The last is the largest length of what k changes of (dw/dx_j + 2 pi i k_j w) e(a): w along the axes, and
2 pi i d times the bracket. The matrix w - 2 m w' d d^T has the eigenvalues w and w - 2 m w' |d|^2.

STEP. An octave takes the slope e to e + A |u| g(k), A = depth (gain L)^i f. With r = |e| a step of the length s moves
|u| = r / (r + 1/8) by s / 8 / (r + 1/8)^2 at most, and u by s / (r + 1/8). So |u| g moves by

    (G / 8 + 3/2 G' r) / (r + 1/8)^2 s

with G' for g, and |u| v likewise. A clamp brings no two slopes further apart."""

from __future__ import annotations

import functools
import math
from dataclasses import astuple, dataclass, replace

import numpy as np

from bounds.boxes import Boxes, cell, supremum
from bounds.kernels import Offsets
from bounds.noises import phasor, phasor_d
from bounds.noises.phasor import KERNELS, TURN, Waves, scale_of
from bounds.table import GulliesBounds

LONGEST = 3 / 2  # wave
PLANE = replace(KERNELS[2], waves=LONGEST)


@dataclass(frozen=True)
class Around:
    """What a point has at a distance, in cells, or in a box at most: the weight, its fall, and both products."""
    distance: np.ndarray
    weight: np.ndarray
    least_weight: np.ndarray
    fall: np.ndarray  # 2 m w' |d|, per cell

    def steep(self):
        return np.hypot(self.fall, TURN * LONGEST * self.weight)

    def turning(self):
        return TURN * self.distance * self.weight

    def turning_slope(self):
        matrix = np.maximum(self.weight, self.fall * self.distance - self.least_weight)
        return TURN * np.hypot(matrix, TURN * LONGEST * self.distance * self.weight)


def at_distance(kernel: Waves, distance, least, largest) -> Around:
    """In steps, of which the least and the largest t are known."""
    weight, slope = kernel.weight, kernel.weight.size(1, least, largest)
    return Around(distance / kernel.steps, weight.derivative(0, largest), weight.derivative(0, least),
                  2 * kernel.fall * slope * distance * kernel.steps)


@functools.cache
def largest(quantity: str) -> float:
    """A proven upper bound of the sum over the points, scaled."""
    def bound(boxes: Boxes):
        upper = lower = 0.0
        middle = boxes.lo + boxes.side / 2
        for point in PLANE.points:
            offsets = Offsets.of(PLANE, boxes, point)
            near = at_distance(PLANE, np.sqrt((offsets.size**2).sum(axis=0)), offsets.least, offsets.largest)
            upper = upper + getattr(near, quantity)()
            square = ((middle - np.array(point)[:, None])**2).sum(axis=0)
            t = np.maximum(PLANE.radius - PLANE.fall * square, 0.0)
            lower = lower + getattr(at_distance(PLANE, np.sqrt(square), t, t), quantity)()
        return upper, lower
    return scale_of(PLANE) * supremum(bound, cell(2, half=True), 14, 0.001, None)


def bounds() -> GulliesBounds:
    value, slope = phasor.derived_value(PLANE), phasor_d.derived_slope(PLANE)
    return GulliesBounds(value.cell_error, value.lipschitz, largest("turning"), slope.cell_error, slope.lipschitz,
                         largest("turning_slope"), largest("steep"), value.fixed_error, slope.fixed_error)
