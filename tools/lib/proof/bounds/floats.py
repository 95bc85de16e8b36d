"""Steps of the float arithmetic (HN_FAST and HN_PRECISE), for the formulas of errors that text.py does not prove.

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

import struct
from dataclasses import dataclass

import numpy as np

from proof.bounds.boxes import SAFE

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

    def size(self):
        """The largest magnitude of the exact value."""
        return np.maximum(abs(self.lo), abs(self.hi))

    def rounded(self) -> Approx:
        """After one rounding: the ulp of the largest magnitude that the computed value can have."""
        return Approx(self.lo, self.hi, self.err + rounding(self.size() + self.err))

    def clipped(self, lo, hi) -> Approx:
        """With a range known from elsewhere."""
        return Approx(np.maximum(self.lo, lo), np.minimum(self.hi, hi), self.err)

    def plus(self, constant) -> Approx:
        return Approx(self.lo + constant, self.hi + constant, self.err).rounded()

    def times(self, other: Approx) -> Approx:
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        err = self.size() * other.err + other.size() * self.err + self.err * other.err
        return Approx(np.minimum.reduce(ends), np.maximum.reduce(ends), err).rounded()


def rounding(magnitude, ulps=1.0):
    """The largest error of rounding a result of at most this magnitude; the ulp is 2^(e - 23) in [2^e, 2^(e + 1))."""
    exponent = np.frexp(magnitude * SAFE)[1] - 1
    return ulps * np.ldexp(1.0, exponent - 23) + TINY


def position_error(cell_error, lipschitz):
    """The error from a position: the fraction is up to 2^-24 off."""
    return cell_error + lipschitz * 2.0**-24
