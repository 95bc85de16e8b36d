"""The error of the float arithmetic (HN_FAST and HN_PRECISE), propagated through a noise of lattice points.

A corner of the cell has a value, and the noise interpolates these, in 32-bit floats:

    cell = floor(p);  f = p - cell;  d = f or f - 1
    s(t) = ((t*t)*t) * ((t - 1)*(t*6 - 9) + 1);  lerp(a, b, t) = a + t*(b - a)
    lerp(lerp(n00, n10, u), lerp(n01, n11, u), v), and one level more for each further axis

and its derivatives, from q = f - f*f, the slope of the fade q*q*30, and the gradient's components g of the corners:

    along the axis that is interpolated: (b - a)*slope + lerp(g_a, g_b, u);  then it is interpolated like the value

GLSL fixes no rounding mode: an operation returns one of the two floats around its exact result, so it errs by less than
one ulp. So does a constant that is no float. Inputs and results below 2^-126 may become 0.
Fusing a*b + c only drops a rounding.
NOT covered: a compiler that reassociates, distributes or replaces these operations (fast math, a lerp of another form),
and mediump. (The usual form of the fade, with t*(t*6 - 15) + 10, is the same polynomial and costs
the same, but cancels from terms near 10 to a result near 1, and triples the bound.)

From a position there is one rounding more: p - floor(p) is exact except for -1/2 < p < 0, where it lies in (1/2, 1],
whose floats are 2^-24 apart. This moves f by at most 2^-24 along each axis and so adds L * 2^-24.

HN_PRECISE rounds to nearest, and takes a coordinate below 2^-32 as 0, which moves a value by at most L * 2^-32: far
less than rounding to nearest saves, so the bounds hold for it, too.

Everything is computed for many boxes at a time: a number may be an array of numbers, one for each box.
"""

from __future__ import annotations

import functools
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from proof.bounds.boxes import SAFE, cell, fade, fade_derivative, of_ends, supremum
from proof.bounds.gradients import OCTAHEDRAL, SINE, two_largest

UNIT = 2.0**-23  # the largest relative error of a faithfully rounded operation
TINY = 2.0**-126  # the largest absolute error of flushing a subnormal to 0


def to_float(x):
    """The 32-bit float nearest to x."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


@dataclass(frozen=True)
class Approx:
    """A quantity computed in floats: its exact value is in [lo, hi], the computed one differs by at most err."""
    lo: np.ndarray | float
    hi: np.ndarray | float
    err: np.ndarray | float = 0.0

    @staticmethod
    def within(size, err=0.0) -> Approx:
        return Approx(-size, size, err)

    def size(self):
        """The largest magnitude of the exact value."""
        return np.maximum(abs(self.lo), abs(self.hi))

    def rounded(self, offset=0.0) -> Approx:
        """After one rounding: the ulp of the largest magnitude the computed value can have, if it is computed with an
        offset that this exact value is without."""
        return Approx(self.lo, self.hi, self.err + rounding(offset + self.size() + self.err))

    def clipped(self, lo, hi) -> Approx:
        """With a range known from elsewhere."""
        return Approx(np.maximum(self.lo, lo), np.minimum(self.hi, hi), self.err)

    def exactly(self, factor) -> Approx:
        """Times a number, where that does not round."""
        ends = (self.lo * factor, self.hi * factor)[::1 if factor > 0 else -1]
        return Approx(*ends, self.err * abs(factor))

    def plus(self, constant) -> Approx:
        return Approx(self.lo + constant, self.hi + constant, self.err).rounded()

    def scaled(self, constant) -> Approx:
        return self.exactly(constant).rounded()

    def sum(self, other: Approx) -> Approx:
        return Approx(self.lo + other.lo, self.hi + other.hi, self.err + other.err).rounded()

    def minus(self, other: Approx) -> Approx:
        return self.sum(other.exactly(-1.0))

    def times(self, other: Approx) -> Approx:
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        err = self.size() * other.err + other.size() * self.err + self.err * other.err
        return Approx(np.minimum.reduce(ends), np.maximum.reduce(ends), err).rounded()


def rounding(magnitude, ulps=1.0):
    """The largest error of rounding a result of at most this magnitude; the ulp is 2^(e - 23) in [2^e, 2^(e + 1))."""
    exponent = np.frexp(magnitude * SAFE)[1] - 1
    return ulps * np.ldexp(1.0, exponent - 23) + TINY


def constant(value) -> Approx:
    """One that the compiler rounds."""
    return Approx(value, value).rounded()


def between(t, a, b):
    """The largest (1 - t) a + t b over the range of t, in which it is linear."""
    return np.maximum((1 - t.lo) * a + t.lo * b, (1 - t.hi) * a + t.hi * b)


# --- A fraction -------------------------------------------------------------------------------------------------------

def approx_offsets(lo, hi):
    """f and f - 1, which is exact for f >= 1/2 (Sterbenz), else in [-1, -1/2], whose floats are 2^-24 apart."""
    minus_one = np.where(lo < 0.5, 2.0**-24, 0.0)
    return Approx(lo, hi, TINY), Approx(lo - 1, hi - 1, minus_one + TINY)


def approx_fade(t):
    d = approx_offsets(t.lo, t.hi)[1]
    inner = d.times(t.scaled(6.0).plus(-9.0)).plus(1.0)
    return t.times(t).times(t).times(inner).clipped(fade(t.lo), fade(t.hi))  # s increases


def approx_slope(t):
    """q*q*30, q = t - t*t; q and s' rise up to t = 1/2 and fall from there."""
    def range_of(function):
        ends = function(t.lo), function(t.hi)
        in_it = (t.lo <= 0.5) & (t.hi >= 0.5)
        return np.minimum(*ends), np.where(in_it, function(0.5), np.maximum(*ends))
    q = t.minus(t.times(t)).clipped(*range_of(lambda x: x * (1 - x)))
    return q.times(q).scaled(30.0).clipped(*range_of(functools.partial(fade_derivative, 1)))


# --- Interpolation ----------------------------------------------------------------------------------------------------

def approx_lerp(a, b, t, offset=0.0):
    """a + t (b - a). Before its three roundings its error is (1 - t) A + t B + T (b' - a'), with the errors A, B, T of
    a, b, t and the computed b' - a': less than operation by operation, which would count the error of a twice. The
    exact value is between a and b, whose ranges are centred on 0, or on an offset that they are given without."""
    difference = a.size() + b.size() + a.err + b.err
    difference_rounding = rounding(difference)
    product = (t.hi + t.err) * (difference + difference_rounding)
    err = between(t, a.err, b.err) + t.err * difference
    err = err + (t.hi + t.err) * difference_rounding + rounding(product)
    size = between(t, a.size(), b.size())
    return Approx.within(size, err).rounded(offset)


def pairs(values: Sequence) -> list[tuple]:
    return list(zip(values[::2], values[1::2]))


def approx_interpolation(values, fractions, offset=0.0):
    """The interpolation of the values of the corners, x varying fastest, each level along an axis."""
    for fraction in fractions:
        weight = approx_fade(fraction)
        values = [approx_lerp(a, b, weight, offset) for a, b in pairs(values)]
    return values[0]


def approx_climb(a, b, slope):
    """(b - a)*slope, the ranges of a and b being centred on 0."""
    return Approx.within(a.size() + b.size(), a.err + b.err).rounded().times(slope)


def approx_derivatives(values, fractions, of_gradient):
    """The derivatives of the interpolation along each axis. `of_gradient` is a component of the gradients."""
    nodes = [(value, []) for value in values]
    for fraction in fractions:
        t, slope = approx_fade(fraction), approx_slope(fraction)
        of_gradient = approx_lerp(of_gradient, of_gradient, t)  # the same at each corner and along each axis
        nodes = [(approx_lerp(a, b, t), [approx_lerp(p, q, t) for p, q in zip(made, others)]
                  + [approx_climb(a, b, slope).sum(of_gradient)]) for (a, made), (b, others) in pairs(nodes)]
    return nodes[0][1]


def approx_number_derivatives(values, fractions, offset):
    """The derivatives of numbers, without gradients. In the plane, what climbs along x is interpolated along y first.
    The rises have no offset, and the corners' numbers rise exactly."""
    t, slopes = [approx_fade(f) for f in fractions], [approx_slope(f) for f in fractions]
    rises = [Approx.within(a.size() + b.size(), a.err + b.err) for a, b in pairs(values)]
    if len(fractions) == 1:
        return [rises[0].times(slopes[0])]
    edges = [approx_lerp(a, b, t[0], offset) for a, b in pairs(values)]
    nodes = [(approx_lerp(a, b, t[1], offset),
              [approx_lerp(p, q, t[1]).times(slopes[0]), approx_climb(a, b, slopes[1])])
             for (a, b), (p, q) in zip(pairs(edges), pairs(rises))]
    for weight, slope in zip(t[2:], slopes[2:]):
        nodes = [(approx_lerp(a, b, weight, offset), [approx_lerp(p, q, weight) for p, q in zip(made, others)]
                  + [approx_climb(a, b, slope)]) for (a, made), (b, others) in pairs(nodes)]
    return nodes[0][1]


# --- Ramps ------------------------------------------------------------------------------------------------------------

def largest_of(numbers):
    return functools.reduce(np.maximum, numbers)


def approx_plane_ramp(own):
    """With 3/4 along either axis and 1/4 along the other."""
    x, y = own
    err = largest_of((3 * a.err + b.err) / 4 + rounding(0.75 * (a.size() + a.err)) for a, b in ((x, y), (y, x)))
    size = OCTAHEDRAL.support([x.size(), y.size()])
    return Approx.within(size, err + TINY).rounded()


def approx_sum_of_two(own):
    """The sum of the two that are largest, with the two largest errors."""
    size, err = (sum(two_largest(np.broadcast_arrays(*numbers))) for numbers in
                 ([d.size() for d in own], [d.err for d in own]))
    return Approx.within(size, err).rounded()


def approx_octahedral_ramp(own):
    """From the offsets of a corner, or of a lattice point."""
    if len(own) == 1:
        return Approx.within(own[0].size(), own[0].err).rounded()
    return approx_plane_ramp(own) if len(own) == 2 else approx_sum_of_two(own)


def approx_sine_ramp(own):
    """g . d for any |g_i| <= 1 whose floats are within SINE.component_error, and at most 1, too."""
    products = [Approx.within(d.size(), d.err + d.size() * SINE.component_error).rounded() for d in own]
    return functools.reduce(Approx.sum, products)


# --- The cubic spline -------------------------------------------------------------------------------------------------

def spline_weight(t):
    """The exact weights of points 2 and 0 at a fraction t: b_2 and b_0. The errors of -1 and 1 are the same at 1 -
    t."""
    return t**3 / 6, 2 / 3 - t**2 + t**3 / 2


def approx_spline(t):
    """b_-1, b_0, b_1, b_2."""
    def of(x):
        """b_2 and b_0 at x: the cube of x over 6, and three times that plus (2/3 - x*x)."""
        low, high = spline_weight(x.lo), spline_weight(x.hi)
        outer = x.times(x).times(x).times(constant(1 / 6)).clipped(low[0], high[0])
        inner = outer.scaled(3.0).sum(constant(2 / 3).minus(x.times(x)))
        return outer, inner.clipped(high[1], low[1])  # it falls
    last, second = of(t)
    far = approx_offsets(t.lo, t.hi)[1]
    first, third = of(far.exactly(-1.0))  # 1 - f rounds as f - 1
    return [first, second, third, last]


def approx_blend(value, weights, offset):
    """The sum of four products of numbers within the size of `value`, and an offset, with the weights, in their order.
    The exact weights sum to 1, and the exact result is as large as `value`."""
    largest = offset + value.size()
    err, total = value.err, 0.0
    for i, weight in enumerate(weights):
        err = err + (largest + value.err) * weight.err
        product = (largest + value.err) * (weight.size() + weight.err)
        err = err + rounding(product)
        total = np.minimum(total + product, largest + err)  # the weights sum to 1
        if i > 0:
            err = err + rounding(total + err)
    return Approx(value.lo, value.hi, err)


# --- Bounds -----------------------------------------------------------------------------------------------------------

LEVELS = {1: 16, 2: 11, 3: 8, 4: 5}
TOLERANCE = 0.001  # relative


@functools.cache
def error_supremum(error: Callable[[Sequence[np.ndarray], Sequence[np.ndarray]], np.ndarray], dims: int) -> float:
    """The largest error over the fractions of a cell, given a bound for boxes by their lower and upper ends."""
    return supremum(of_ends(error), cell(dims), LEVELS[dims], TOLERANCE, most=100_000)


def position_error(cell_error, lipschitz):
    """The error from a position: the fraction is up to 2^-24 off."""
    return cell_error + lipschitz * 2.0**-24
