"""The error of the float arithmetic (HN_FAST and HN_PRECISE), propagated through a noise of lattice points.

A corner of the cell has a value, and the noise interpolates these, in 32-bit floats:

    cell = floor(p);  f = p - cell;  d = f or f - 1
    s(t) = ((t*t)*t) * ((t - 1)*(t*6 - 9) + 1);  lerp(a, b, t) = a + t*(b - a)
    lerp(lerp(n00, n10, u), lerp(n01, n11, u), v), in 3D one level more

GLSL fixes no rounding mode: an operation returns one of the two floats around its exact result, so it errs by less than
one ulp ("to nearest": half an ulp). Inputs and results below 2^-126 may become 0. Fusing a*b + c only drops a rounding.
NOT covered: a compiler that reassociates, distributes or replaces these operations (fast math, a lerp of another form),
and mediump. (The usual form of the fade, with t*(t*6 - 15) + 10, is the same polynomial and costs
the same, but cancels from terms near 10 to a result near 1, and triples the bound.)

From a position there is one rounding more: p - floor(p) is exact except for -1/2 < p < 0, where it lies in (1/2, 1],
whose floats are 2^-24 apart. That moves f by at most 2^-24 along each axis and so adds L * 2^-24.

HN_PRECISE rounds to nearest, and takes a coordinate below 2^-32 as 0, which moves a value by at most L * 2^-32: far
less than rounding to nearest saves, so the bounds hold for it, too.
"""

import math
import struct

from bounds.boxes import SAFE, fade

UNIT = 2.0**-23  # the largest relative error of a faithfully rounded operation
TINY = 2.0**-126  # the largest absolute error of flushing a subnormal to 0


def to_float(x):
    """The 32-bit float nearest to x."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


class Approx:
    """A quantity computed in floats: its exact value is in [lo, hi], the computed one differs by at most err.
    An operation rounds with an error below `ulps` ulp."""

    def __init__(self, lo, hi, err, ulps):
        self.lo, self.hi, self.err, self.ulps = lo, hi, err, ulps

    def size(self):
        """The largest magnitude of the exact value."""
        return max(abs(self.lo), abs(self.hi))

    def rounded(self):
        """After one rounding: the ulp of the largest magnitude the computed value can have."""
        return Approx(self.lo, self.hi, self.err + rounding(self.size() + self.err, self.ulps), self.ulps)

    def clipped(self, lo, hi):
        """With a range known from elsewhere."""
        return Approx(max(self.lo, lo), min(self.hi, hi), self.err, self.ulps)

    def plus(self, constant):
        return Approx(self.lo + constant, self.hi + constant, self.err, self.ulps).rounded()

    def scaled(self, constant):
        """Times a positive constant."""
        return Approx(self.lo * constant, self.hi * constant, self.err * constant, self.ulps).rounded()

    def sum(self, other):
        return Approx(self.lo + other.lo, self.hi + other.hi, self.err + other.err, self.ulps).rounded()

    def times(self, other):
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        err = self.size() * other.err + other.size() * self.err + self.err * other.err
        return Approx(min(ends), max(ends), err, self.ulps).rounded()


def rounding(magnitude, ulps):
    """The largest error of rounding a result of at most this magnitude; the ulp is 2^(e - 23) in [2^e, 2^(e + 1))."""
    exponent = math.frexp(magnitude * SAFE)[1] - 1
    return ulps * math.ldexp(1.0, exponent - 23) + TINY


def approx_offsets(lo, hi, ulps):
    """f and f - 1, which is exact for f >= 1/2 (Sterbenz), else in [-1, -1/2], whose floats are 2^-24 apart."""
    minus_one = ulps * 2.0**-24 if lo < 0.5 else 0.0
    return Approx(lo, hi, TINY, ulps), Approx(lo - 1, hi - 1, minus_one + TINY, ulps)


def approx_fade(t):
    d = approx_offsets(t.lo, t.hi, t.ulps)[1]
    inner = d.times(t.scaled(6.0).plus(-9.0)).plus(1.0)
    return t.times(t).times(t).times(inner).clipped(fade(t.lo), fade(t.hi))  # s increases


def between(t, a, b):
    """The largest (1 - t) a + t b over the range of t, in which it is linear."""
    return max((1 - t.lo) * a + t.lo * b, (1 - t.hi) * a + t.hi * b)


def approx_lerp(a, b, t):
    """a + t (b - a). Before its three roundings its error is (1 - t) A + t B + T (b' - a'), with the errors A, B, T of
    a, b, t and the computed b' - a': less than operation by operation, which would count the error of a twice. The
    exact value is between a and b, whose ranges are centred on 0."""
    difference = a.size() + b.size() + a.err + b.err
    difference_rounding = rounding(difference, t.ulps)
    product = (t.hi + t.err) * (difference + difference_rounding)
    err = between(t, a.err, b.err) + t.err * difference
    err += (t.hi + t.err) * difference_rounding + rounding(product, t.ulps)
    size = between(t, a.size(), b.size())
    return Approx(-size, size, err, t.ulps).rounded()


def approx_interpolation(values, fractions):
    """The interpolation of the values of the corners, x varying fastest, each level along an axis."""
    for fraction in fractions:
        weight = approx_fade(fraction)
        values = [approx_lerp(a, b, weight) for a, b in zip(values[::2], values[1::2])]
    return values[0]


def position_error(cell_error, lipschitz, ulps=1.0):
    """The same from a position: the fraction is up to 2^-24 (to nearest: half of it) off."""
    return cell_error + lipschitz * ulps * 2.0**-24
