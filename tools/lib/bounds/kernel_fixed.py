"""What the fixed arithmetic (HN_FIXED, docs/contract.md, sections 8, 13 and 14) does to a sum over lattice points.

A coordinate is cut to a multiple of 2^-20 cells, which moves the value by at most L * 2^-20 (CUT), and likewise a
derivative. There the offsets are exact. The rest is bounded over boxes of places, for each point that counts:

    t    N rounds down by less than 2^-30, t by 2^-17 to the nearest. Where t would be 1 it is 2^-16 less.
    Q    off by (t + e)^2 - t^2, e the error of t, and 2^-17
    W    off by Q (t + e) - t^3, and 2^-19
    R    the ramp rounds as RAMP_ROUNDING says (noises/perlin/fixed.py). With a phase see TURN.

The value adds h(d) times the error of W, the error of R times W, and what part(R, W) rounds down by. A derivative adds
the error of W, as |g_i| <= 1, and what part(g, W) rounds by; 3/4 of a unit that >> 2 rounds down by; and of the product

    3 part(part(R, 2 m Q), D >> 2)        in units of 2^-27: 6 m Q R d

the errors of Q and R, what both parts round by, and up to 3 units of D that are lost.

SCALE is that of Perlin noise.

TURN. The cosine and the sine are off by that of the sine gradient, and by the angle that is cut off. With a and b as in
kernel_floats.py the two move g(a).v by at most sqrt(2) LONGEST |v| times that. Two parts round down, with factors of
which the squares sum to that of 2^18; a ramp is lengthened after that.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from bounds import kernels
from bounds.boxes import SAFE, Boxes, cell, supremum
from bounds.gradients import LONGEST, OCTAHEDRAL
from bounds.integers import FADE_ONE, ONE, SLOPE_UNIT, UNIT, part_intermediate, scaled_intermediate
from bounds.kernel_floats import ANGLE_CUT
from bounds.kernels import Kernel, Offsets
from bounds.noises.perlin.fixed import RAMP_ONE, RAMP_ROUNDING
from bounds.noises.perlin.floats import MORE
from bounds.sine import fixed_sine_error, fixed_sine_largest

NEAR_ONE = 2**16  # the unit of t and Q


# --- Turns ------------------------------------------------------------------------------------------------------------

@functools.cache
def turn_error() -> float:
    """Of the cosine and the sine of a phase."""
    return fixed_sine_error() + ANGLE_CUT


def turn_effect(dims: int) -> float:
    """How far a gradient times a vector is off, for each length of that vector."""
    return math.sqrt(2) * LONGEST[dims] * turn_error()


MIXED_ROUNDING = math.sqrt(2) * 511 + 2 + 2 * 511  # of two parts, in units of what they are parts of


def ramp_one(dims: int) -> int:
    return RAMP_ONE[OCTAHEDRAL][dims]


def ramp_rounding(dims: int, turns: bool) -> float:
    """In its units."""
    plain = RAMP_ROUNDING[OCTAHEDRAL][dims]
    return plain + (1 + MORE[dims]) * MIXED_ROUNDING if turns else plain


# --- A box of places --------------------------------------------------------------------------------------------------

def part_rounding(factor, negative=False):
    """Of part(d, t) for |t| up to the factor, a real number in units of 2^-18: see integers.py. If no t is above 0, the
    two products round to different sides."""
    units = np.ceil(factor * FADE_ONE)
    high, low = 511 / 512 * (units / 512 + 1), np.minimum(units, 511)
    return np.where(factor > 0, np.where(negative, np.maximum(high, low), high + low), 0.0)


def errors_of_weight(kernel: Kernel, t):
    """Of Q and of W, for t of up to that."""
    e = 0.5 / NEAR_ONE + kernel.fall * 2.0**-30 + np.where(t > 1 - 1 / NEAR_ONE, 0.5 / NEAR_ONE, 0.0)
    of_square = 2 * t * e + e * e + 0.5 / NEAR_ONE
    return of_square, of_square * (t + e) + t * t * e + 0.5 / FADE_ONE


class Point:
    """The largest of what a lattice point has in each box."""

    def __init__(self, kernel: Kernel, boxes: Boxes, point, turns: bool):
        self.offsets = Offsets.of(kernel, boxes, point)
        t, one = self.offsets.largest, ramp_one(kernel.dims)
        self.counts, gradient, longest = t > 0, *kernels.reach(kernel, turns)
        self.square, self.weight = t**2, t**3
        self.square_error, self.weight_error = errors_of_weight(kernel, t)
        self.ramp = longest * gradient.support(self.offsets.size)
        self.ramp_error = np.full(t.shape, ramp_rounding(kernel.dims, turns) / one)
        self.gradient, self.gradient_error = longest, 0.0
        if turns:
            length = np.sqrt((self.offsets.size**2).sum(axis=0))
            self.ramp_error = self.ramp_error + turn_effect(kernel.dims) * length
            self.gradient_error = turn_effect(kernel.dims) + MIXED_ROUNDING / one
        self.one = one

    def value(self):
        error = ((self.ramp + self.ramp_error) * self.weight_error + self.ramp_error * self.weight
                 + part_rounding(self.weight + self.weight_error) / self.one)
        return np.where(self.counts, error, 0.0)

    def derivative(self, fall: int, axis: int):
        upright = ((self.gradient + self.gradient_error) * self.weight_error + self.gradient_error * self.weight
                   + (part_rounding(self.weight + self.weight_error) + 3) / self.one)
        d, ramp = self.offsets.size[axis], self.ramp + self.ramp_error
        falling = d * (ramp * self.square_error + self.ramp_error * self.square)
        square = self.square + self.square_error
        negative = self.offsets.middle[axis] + self.offsets.half <= 0
        rounding = d * part_rounding(fall * square / 2) + part_rounding(d, negative)
        lost = fall / 2 * ramp * square * 3 / ONE
        error = upright + 6 * fall * falling + 12 * (rounding / self.one + lost)
        return np.where(self.counts, error, 0.0)


LEVELS, TOLERANCE = {2: 10, 3: 8, 4: 7}, 0.01


def _supremum(kernel: Kernel, of_boxes) -> float:
    def bound(boxes: Boxes):
        # What a box has in its middle is no bound, but no box around it can have less.
        return of_boxes(boxes), of_boxes(Boxes(30, (boxes.index * 2 + 1) << (29 - boxes.level)))
    return supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE,
                    None if kernel.triangles else 0)


@functools.cache
def rounding_effect(kernel: Kernel, turns: bool) -> float:
    """All but CUT and SCALE, not scaled."""
    return _supremum(kernel, lambda boxes: sum(Point(kernel, boxes, point, turns).value() for point in kernel.points))


@functools.cache
def slope_rounding_effect(kernel: Kernel, turns: bool) -> float:
    """The same of a derivative, per step."""
    def of_boxes(boxes: Boxes):
        points = [Point(kernel, boxes, point, turns) for point in kernel.points]
        return np.maximum.reduce([sum(point.derivative(kernel.fall, axis) for point in points)
                                  for axis in range(kernel.dims)])
    return _supremum(kernel, of_boxes)


# --- Bounds -----------------------------------------------------------------------------------------------------------

def fixed_scale(kernel: Kernel) -> int:
    """The ramps in 4D have units twice as large."""
    return kernel.scale * (2**29 // ramp_one(kernel.dims))


def scaling_error(kernel: Kernel, unit: float) -> float:
    return (256 * fixed_scale(kernel) / 2**18 + 1 / 2) * unit


def error_parts(kernel: Kernel, turns: bool, lipschitz: float) -> dict[str, float]:
    return {"cut": lipschitz / ONE, "points": kernel.scale / 1024 * rounding_effect(kernel, turns),
            "scaling": scaling_error(kernel, UNIT)}


def slope_error_parts(kernel: Kernel, turns: bool, lipschitz: float) -> dict[str, float]:
    scale = kernel.steps * kernel.scale / 1024
    return {"cut": lipschitz / ONE, "points": scale * slope_rounding_effect(kernel, turns),
            "scaling": kernel.steps * scaling_error(kernel, SLOPE_UNIT)}


def total(parts: dict[str, float]) -> float:
    return sum(parts.values()) * SAFE


def without_cut(parts: dict[str, float]) -> float:
    """What takes a value out of its range."""
    return sum(value for name, value in parts.items() if name != "cut") * SAFE


# --- Overflow ---------------------------------------------------------------------------------------------------------

def longest_ramp(dims: int, turns: bool) -> float:
    """For offsets of at most 1."""
    reach = LONGEST[dims] * math.sqrt(dims) if turns else OCTAHEDRAL.reach(dims)
    return reach * ramp_one(dims) + ramp_rounding(dims, turns)


def turned_intermediates(dims: int) -> dict[str, float]:
    """A direction times an offset is as in noises/perlin/fixed.py, and so is the cross product: |m y| + |b z| is at most
    512 * 2^20. The parts are at most sqrt(2) of the length of an offset; g and g' are as long as 1 or LONGEST."""
    longest = max(math.sqrt(2 * dims), math.sqrt(2) * LONGEST[dims]) * fixed_sine_largest() + turn_error()
    return {"part of a turn": part_intermediate(2.0**29 * fixed_sine_largest(), np.array([FADE_ONE])),
            "turned": longest * 2**29 + 2 * MIXED_ROUNDING}


def largest_intermediates(kernel: Kernel, turns: bool) -> dict[str, float]:
    """The value is at most 1. No offset from a point that is visited is more than 1 along an axis: so
    the squares sum to at most 2 steps on the plane, and elsewhere to 1, or 3/2 with the larger kernel, of which m is 1.
    The word m q is then at most 2^31. Those of the weights fit 32 bits with t < 2^16. A sum of the parts of some of the
    points is as large as that of all can be."""
    ramp, one = longest_ramp(kernel.dims, turns), ramp_one(kernel.dims)
    whole = np.array([FADE_ONE])
    return {**(turned_intermediates(kernel.dims) if turns else {}), "half of the word of a square": 2.0**30,
            "ramp": ramp, "attenuated": part_intermediate(ramp, whole),
            "scaled": scaled_intermediate(1024 / kernel.scale * one, fixed_scale(kernel))}


def largest_slope_intermediates(kernel: Kernel, turns: bool) -> dict[str, float]:
    """The same of a derivative. As t <= r <= 1, and d^2 <= r / m where t is not 0, k is at most m/2 |g| d, and 3 k d is at
    most 3/2 |g|. Of a sum of points more is known: each is at most its share of the largest derivative."""
    dims, one, whole = kernel.dims, ramp_one(kernel.dims), np.array([FADE_ONE])
    longest = (math.sqrt(2) if dims == 4 else LONGEST[dims]) * one + ramp_rounding(dims, turns) + 2 * MIXED_ROUNDING
    k = kernel.fall / 2 * math.sqrt(1 / kernel.fall) * longest + 2 * 1023
    upright = part_intermediate(longest, whole) / 4 + 1
    leaning = 1.5 * longest + 3 * 3 * 1023
    gradient, factor = kernels.reach(kernel, turns)
    derivative = kernels.slope_of(kernel, gradient) * factor + slope_rounding_effect(kernel, turns)
    return {"falling": part_intermediate(longest_ramp(dims, turns), whole), "k": part_intermediate(k, whole),
            "leaning": upright + leaning,
            "scaled derivative": scaled_intermediate(derivative * one / 4, fixed_scale(kernel))}
