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
from proof.bounds.integers import (
    FADE_ONE,
    ONE,
    RAMP_ONE,
    SLOPE_UNIT,
    UNIT,
    fixed_scale,
    part_intermediate,
    scaled_intermediate,
    scaling_error,
)
from proof.bounds.kernels import Kernel, Offsets
from proof.bounds.weights import HALF_NEAR, NEAR_ONE


def ramp_one(dims: int) -> int:
    return RAMP_ONE[dims]


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


class Point:
    """A lattice point's largest number in each box, and its error: of its ramp times the weight, or times the fall."""

    def __init__(self, kernel: Kernel, boxes: Boxes, point):
        self.offsets, self.one = Offsets.of(kernel, boxes, point), ramp_one(kernel.dims)
        t, self.weights, self.fall = self.offsets.largest, kernel.weight, kernel.fall
        self.counts, self.near_error = t > 0, near_error(kernel, t)
        self.weight = kernel.weight.size(0, self.offsets.least, t)
        self.weight_error = kernel.weight.fixed(self.offsets.least, t, self.near_error)
        self.ramp, self.ramp_error = kernel.fixed_ramp(self.offsets)

    def value(self):
        error = ((self.ramp + self.ramp_error) * self.weight_error + self.ramp_error * self.weight
                 + part_rounding(self.weight + self.weight_error) / self.one)
        return np.where(self.counts, error, 0.0)

    def falling(self, axis: int):
        """The product of the ramp and the fall, times the offset."""
        least, d = self.offsets.least, self.offsets.size[axis]
        eighth = self.fall / 4 * self.weights.size(1, least, self.offsets.largest)  # E
        error = self.weights.fixed_fall(least, self.offsets.largest, self.near_error, self.fall)
        negative = self.offsets.middle[axis] + self.offsets.half <= 0
        rounding = d * part_rounding(eighth + error) + part_rounding(d, negative)
        off = d * (self.ramp * error + self.ramp_error * eighth) + self.ramp * (eighth + error) * 3 / ONE
        return np.where(self.counts, 8 * (off + rounding / self.one), 0.0)

    def upright(self, component: float):
        """The weight, times a component of a gradient."""
        return np.where(self.counts, component * self.weight_error, 0.0)


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
        points, component = [Point(kernel, boxes, point) for point in kernel.points], OCTAHEDRAL.component(kernel.dims)
        return np.maximum.reduce([sum(point.upright(component) + point.falling(axis) for point in points)
                                  for axis in range(kernel.dims)])
    return error_supremum(kernel, of_boxes)


# --- Bounds -----------------------------------------------------------------------------------------------------------

def scale_of(kernel: Kernel) -> int:
    return fixed_scale(kernel.scale / 1024, kernel.dims)


def scale_error(kernel: Kernel, unit: float) -> float:
    return scaling_error(scale_of(kernel), unit)


def error_parts(kernel: Kernel, lipschitz: float) -> dict[str, float]:
    return {"cut": lipschitz / ONE, "points": kernel.scale / 1024 * rounding_effect(kernel),
            "scaling": scale_error(kernel, UNIT)}


def slope_error_parts(kernel: Kernel, lipschitz: float) -> dict[str, float]:
    scale = kernel.steps * kernel.scale / 1024
    return {"cut": lipschitz / ONE, "points": scale * slope_rounding_effect(kernel),
            "scaling": kernel.steps * scale_error(kernel, SLOPE_UNIT)}


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
            "scaled": scaled_intermediate(1024 / kernel.scale * ramp_one(kernel.dims), scale_of(kernel))}


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
            "scaled derivative": scaled_intermediate(derivative * one / 4, scale_of(kernel))}
