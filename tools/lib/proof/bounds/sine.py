"""The sine of the sine gradient, in floats and in integers: how far it is off, proven.

IN FLOATS. In quarter turns the argument is y, and sin(pi/2 y) is evaluated as follows; its sign is exact:

    x = float(q >> 6) * 2^-24;  t = x*x;  s = x*(c1 + t*(c3 + t*(c5 + t*c7)))

q is an integer in [0, 2^30] and within 3 of y * 2^30, the shift drops up to 63 more, and q >> 6, at most 2^24, is a
float: so x is in [0, 1], and |x - y| <= 66 / 2^30. As the sine's slope is at most pi/2, |s - sin(pi/2 y)| is at most
the float error of s at x, plus the polynomial's distance from sin(pi/2 x), plus pi/2 * 66 / 2^30: the first two by
branch and bound over x. s <= 1, since before its last rounding it is at most 1, and no rounding crosses a float.

IN INTEGERS. q is within 3 of the exact argument in units of 2^-30 quarter turns, and x is q * 2^-14, rounded: for each
of the 2^16 x the sine lies between its values at the ends of x's range of q, and the integers are evaluated.
"""

import functools
import math

import numpy as np

from proof.bounds.boxes import SAFE, Bound, Boxes, cell, smooth, supremum
from proof.bounds.floats import Approx, to_float
from proof.bounds.integers import DOUBLE, word

# --- In floats --------------------------------------------------------------------------------------------------------

SINE_COEFFICIENTS = tuple(map(to_float, (1.57079090, -0.64589171, 0.07943160, -0.00433127)))  # of x, x^3, x^5, x^7
SINE_ARGUMENT_ERROR = (3 + 2**6 - 1) / 2**30  # of x in quarter turns: 3 units of the reduction, 63 of the shift
DOUBLE_SINE = 2.0**-48  # more than the rounding errors of the few double operations below, on numbers up to 2


def sine_polynomial(x):
    c1, c3, c5, c7 = SINE_COEFFICIENTS
    return x * (c1 + x * x * (c3 + x * x * (c5 + x * x * c7)))


def sine_truncation(point):
    """The error of the polynomial, in exact arithmetic."""
    return abs(sine_polynomial(point[0]) - np.sin(math.pi / 2 * point[0]))


def sine_curvature():
    """Bounds of the second derivative on [0, 1]: of the polynomial, and of its difference from the sine."""
    polynomial = sum(k * (k - 1) * abs(c) for k, c in zip((1, 3, 5, 7), SINE_COEFFICIENTS))
    return polynomial, polynomial + (math.pi / 2) ** 2


def approx_sine_factors(lo, hi):
    """x, and the bracket that it is multiplied with last."""
    x = Approx(lo, hi)
    t = x.times(x).clipped(lo**2, hi**2)
    c1, c3, c5, c7 = SINE_COEFFICIENTS
    inner = t.times(Approx(c7, c7)).plus(c5)
    return x, t.times(t.times(inner).plus(c3)).plus(c1)


def _largest(bound: Bound) -> float:
    return supremum(bound, cell(1), 24, 1e-4)


def _float_error(lo, hi):
    x, bracket = approx_sine_factors(lo, hi)
    return x.times(bracket).err


def sine_bound():
    """A proven upper bound of |s - sin| for the sine of the gradient, at the exact argument."""
    truncation = smooth(sine_truncation, lambda boxes: sine_curvature()[1])

    def bound(boxes: Boxes):
        middle = (boxes.lo + boxes.hi) / 2
        return (truncation(boxes)[0] + _float_error(boxes.lo[0], boxes.hi[0]),
                sine_truncation(middle) + _float_error(middle[0], middle[0]))
    return _largest(bound) + math.pi / 2 * SINE_ARGUMENT_ERROR + DOUBLE_SINE


@functools.cache
def sine_truncation_bound():
    """A proven upper bound of the error of the polynomial alone."""
    return _largest(smooth(sine_truncation, lambda boxes: sine_curvature()[1])) + DOUBLE_SINE


def polynomial_error():
    """A proven upper bound of the error without roundings, with that of the reduction of the argument."""
    return sine_truncation_bound() + math.pi / 2 * SINE_REDUCTION / 2**30


def sine_largest():
    """A proven upper bound of s before its last rounding. If that is at most 1, which is a float, then so is s."""
    polynomial = smooth(lambda point: sine_polynomial(point[0]), lambda boxes: sine_curvature()[0])

    def bound(boxes: Boxes):
        x, bracket = approx_sine_factors(boxes.lo[0], boxes.hi[0])
        upper, lower = polynomial(boxes)
        return upper + x.hi * bracket.err, lower
    return supremum(bound, cell(1), 24, 0.0) + DOUBLE_SINE


# --- In integers ------------------------------------------------------------------------------------------------------

def fixed_sine(x):
    """g of the contract for x in [0, 2^16), in units of 2^-16."""
    u = word(x * x) >> 16
    inner = 5208 - (word(u * 288) >> 16)
    inner = 42328 - (word(u * word(inner)) >> 16)
    y = 102943 - (word(u * word(inner)) >> 16)
    return word(x * (word(y) >> 1) + 2**14) >> 15


SINE_REDUCTION = 3  # how far q is off, in units of 2^-30 quarter turns: as in floats


@functools.cache
def fixed_sines():
    """g of every x."""
    return fixed_sine(np.arange(2**16, dtype=np.int64))


def fixed_sine_largest():
    """1, or the end to which a component exceeds it."""
    return max(1.0, fixed_sines().max() / 2**16)


@functools.cache
def fixed_sine_error():
    """A proven upper bound of |S - sin|, from all x."""
    least = np.arange(2**16) * 2**14 - 2**13 - SINE_REDUCTION  # below 0 for x = 0: at worst sin is the other way round
    most = least + 2**14 - 1 + 2 * SINE_REDUCTION
    most[-1] = 2**30  # where the sine is largest
    errors = [np.abs(fixed_sines() / 2**16 - np.sin(np.pi / 2 * q / 2**30)).max() for q in (least, most)]
    return float(max(errors)) * SAFE + DOUBLE
