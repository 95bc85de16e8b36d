"""Steps of the float arithmetic (HN_FAST and HN_PRECISE), for the formulas of errors of noises that are not in PROVEN of
text.py.

GLSL fixes no rounding mode: an operation returns one of the two floats around its exact result, so it errs by less than
one ulp. So does a constant that is no float. Inputs and results below 2^-126 may become 0.
Fusing a*b + c only drops a rounding.
NOT covered: a compiler that reassociates, distributes or replaces these operations (fast math, a lerp of another form),
and mediump.

From a position there is one rounding more: p - floor(p) is exact except for -1/2 < p < 0, where it lies in (1/2, 1],
whose floats are 2^-24 apart. This moves f by at most 2^-24 along each axis and so adds L * 2^-24.

HN_PRECISE rounds to nearest, and takes a coordinate below 2^-32 as 0, which moves a value by at most L * 2^-32: far
less than rounding to nearest saves, so the bounds hold for it, too.

Everything is computed for many boxes at a time: a number may be an array of numbers, one for each box.
"""

from __future__ import annotations

import functools
import struct
from dataclasses import dataclass

import numpy as np

from proof.bounds.boxes import SAFE
from proof.bounds.gradients import OCTAHEDRAL, two_largest

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


def position_error(cell_error, lipschitz):
    """The error from a position: the fraction is up to 2^-24 off."""
    return cell_error + lipschitz * 2.0**-24
