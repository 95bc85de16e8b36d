"""Bounds the effect of fixed arithmetic (HN_FIXED, docs/reference/contract.md, sections 8 and 13) does to a sum over
lattice points.

A coordinate is cut to a multiple of 2^-20 cells, which moves the value by at most L * 2^-20 (CUT), and likewise a
derivative. There the offsets are exact, and so are ramps and gradients. The rest is bounded over boxes of places, for
each point that counts:

    t    N rounds down by less than 2^-30, t by 2^-17 to the nearest. Where t would be 1 it is 2^-16 less.
    W    and E, the eighth of the fall: see weights.py

The value adds h(d) times the error of W, and what part(R, W) rounds down by. A derivative adds the error of W times
|g_i|; part(g, W) is exact, since g is a multiple of 2^18 in its units; and of the product

    2 part(part(R, E), D >> 2)        in units of 2^-27: R (8 E) d

the error of E, what both parts round by, and up to 3 units of D that are lost.

SCALE is as for Perlin noise.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from proof.bounds import kernels
from proof.bounds.boxes import Boxes, cell, supremum
from proof.bounds.gradients import LENGTH, OCTAHEDRAL
from proof.bounds.integers import FADE_ONE, ONE, SLOPE_UNIT, UNIT, part_intermediate, scaled_intermediate
from proof.bounds.kernels import Kernel, Offsets
from proof.bounds.noises.perlin.fixed import RAMP_ONE
from proof.bounds.weights import HALF_NEAR, NEAR_ONE


def ramp_one(dims: int) -> int:
    return RAMP_ONE[OCTAHEDRAL][dims]


# --- A box of places --------------------------------------------------------------------------------------------------

def part_rounding(factor, negative=False):
    """The rounding of part(d, t) for |t| up to the factor, a real number in units of 2^-18: see integers.py. If no t is
    above 0, the two products round to different sides."""
    units = np.ceil(factor * FADE_ONE)
    high, low = 511 / 512 * (units / 512 + 1), np.minimum(units, 511)
    return np.where(factor > 0, np.where(negative, np.maximum(high, low), high + low), 0.0)


def near_error(kernel: Kernel, t):
    """The error of t up to that number."""
    return HALF_NEAR + kernel.fall * 2.0**-30 + np.where(t > 1 - 1 / NEAR_ONE, HALF_NEAR, 0.0)


class Weighted:
    """A lattice point's largest number in each box, whatever its weight is multiplied with: a ramp, which is
    less than 2^31 in units of 1 / one."""

    def __init__(self, kernel: Kernel, boxes: Boxes, point, one: int):
        self.offsets, self.one = Offsets.of(kernel, boxes, point), one
        t, self.weights, self.fall = self.offsets.largest, kernel.weight, kernel.fall
        self.counts, self.near_error = t > 0, near_error(kernel, t)
        self.weight = kernel.weight.size(0, self.offsets.least, t)
        self.weight_error = kernel.weight.fixed(self.offsets.least, t, self.near_error)

    def added(self, ramp, ramp_error):
        error = ((ramp + ramp_error) * self.weight_error + ramp_error * self.weight
                 + part_rounding(self.weight + self.weight_error) / self.one)
        return np.where(self.counts, error, 0.0)


class Point(Weighted):
    """With a gradient."""

    def __init__(self, kernel: Kernel, boxes: Boxes, point):
        super().__init__(kernel, boxes, point, ramp_one(kernel.dims))
        self.ramp, self.component = OCTAHEDRAL.support(self.offsets.size), OCTAHEDRAL.component(kernel.dims)

    def value(self):
        return self.added(self.ramp, 0.0)

    def derivative(self, axis: int):
        d = self.offsets.size[axis]
        eighth = self.fall / 4 * self.weights.size(1, self.offsets.least, self.offsets.largest)  # E
        eighth_error = self.weights.fixed_fall(self.offsets.least, self.offsets.largest, self.near_error, self.fall)
        negative = self.offsets.middle[axis] + self.offsets.half <= 0
        rounding = d * part_rounding(eighth + eighth_error) + part_rounding(d, negative)
        lost = self.ramp * (eighth + eighth_error) * 3 / ONE
        return np.where(self.counts, self.component * self.weight_error
                        + 8 * (d * self.ramp * eighth_error + rounding / self.one + lost), 0.0)


LEVELS, TOLERANCE = {2: 10, 3: 8, 4: 7}, 0.01


def error_supremum(kernel: Kernel, of_boxes) -> float:
    """The supremum of the error that is given for each box."""
    def bound(boxes: Boxes):
        # The value in the middle of a box is no bound, but no box around it can have less.
        return of_boxes(boxes), of_boxes(Boxes(30, (boxes.index * 2 + 1) << (29 - boxes.level)))
    return supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE,
                    None if kernel.triangles else 0)


@functools.cache
def rounding_effect(kernel: Kernel) -> float:
    """All but CUT and SCALE, not scaled."""
    return error_supremum(kernel, lambda boxes: sum(Point(kernel, boxes, point).value() for point in kernel.points))


@functools.cache
def slope_rounding_effect(kernel: Kernel) -> float:
    """The effect on a derivative, per step."""
    def of_boxes(boxes: Boxes):
        points = [Point(kernel, boxes, point) for point in kernel.points]
        return np.maximum.reduce([sum(point.derivative(axis) for point in points)
                                  for axis in range(kernel.dims)])
    return error_supremum(kernel, of_boxes)


# --- Bounds -----------------------------------------------------------------------------------------------------------

def fixed_scale(kernel: Kernel) -> int:
    """The ramps in 4D have units twice as large."""
    return kernel.scale * (2**29 // ramp_one(kernel.dims))


def scaling_error(kernel: Kernel, unit: float) -> float:
    return (256 * fixed_scale(kernel) / 2**18 + 1 / 2) * unit


def error_parts(kernel: Kernel, lipschitz: float) -> dict[str, float]:
    return {"cut": lipschitz / ONE, "points": kernel.scale / 1024 * rounding_effect(kernel),
            "scaling": scaling_error(kernel, UNIT)}


def slope_error_parts(kernel: Kernel, lipschitz: float) -> dict[str, float]:
    scale = kernel.steps * kernel.scale / 1024
    return {"cut": lipschitz / ONE, "points": scale * slope_rounding_effect(kernel),
            "scaling": kernel.steps * scaling_error(kernel, SLOPE_UNIT)}


# --- Overflow ---------------------------------------------------------------------------------------------------------

def longest_ramp(kernel: Kernel) -> float:
    """For offsets of at most 1."""
    return OCTAHEDRAL.reach(kernel.dims) * ramp_one(kernel.dims)


def pieces(kernel: Kernel) -> tuple[np.ndarray, np.ndarray]:
    """The ends of 4096 ranges of t."""
    low = np.arange(4096) / 4096 * kernel.radius
    return low, low + kernel.radius / 4096


def weighted_intermediates(kernel: Kernel, ramp: float) -> dict[str, float]:
    """The words of ramps up to that size. The value is at most 1. No offset from a point that is visited is more than 1
    along an axis: so the squares sum to at most 2 steps on the plane, and elsewhere to 1, or 3/2 with the larger
    kernel, where m is 1. The word m q is then at most 2^31. The products in the weights of simplex noise fit 32
    bits, since t < 2^16, and t (98304 - t) is at most 49152^2. A sum of the parts of some of the points is as large as
    that of all can be."""
    weight = kernel.weight.size(0, *pieces(kernel)).max() * FADE_ONE + 1
    return {"half of the word of a square": 2.0**30, "ramp": ramp,
            "attenuated": part_intermediate(ramp, np.array([math.ceil(weight)])),
            "scaled": scaled_intermediate(1024 / kernel.scale * ramp_one(kernel.dims), fixed_scale(kernel))}


def largest_intermediates(kernel: Kernel) -> dict[str, float]:
    return weighted_intermediates(kernel, longest_ramp(kernel))


def largest_slope_intermediates(kernel: Kernel) -> dict[str, float]:
    """The words of a derivative. Where E is not 0, m d^2 <= r - t: so the length of an offset is at most
    sqrt((r - t) / m), from which k = R E and the product with the offset, for t in each of many ranges. On the plane
    Q (73728 - t) is less than 4/27 of 73728^3 / 2^16. For a sum of points more is known: each is at
    most its share of the largest derivative."""
    dims, one, whole = kernel.dims, ramp_one(kernel.dims), np.array([FADE_ONE])
    low, high = pieces(kernel)
    eighth = kernel.fall / 4 * kernel.weight.size(1, low, high)
    away = np.sqrt((kernel.radius - low) / kernel.fall)
    k = float((eighth * away).max()) * LENGTH[dims] * one * 1.001 + 4 * 1023
    moved = float((eighth * away * away).max()) * LENGTH[dims] * one * 1.001 + 4 * 1023
    derivative = kernels.slope_of(kernel, OCTAHEDRAL) + slope_rounding_effect(kernel)
    return {"falling": k, "k": part_intermediate(k, whole),
            "fall of the plane": 4 / 27 * 73728**3 / 2**16 + 2**16,
            "leaning": OCTAHEDRAL.component(dims) * one / 4 + 2 * (moved + 2 * 1023),
            "scaled derivative": scaled_intermediate(derivative * one / 4, fixed_scale(kernel))}
