"""The weights w(t) of simplex noise (docs/contract.md, section 13): their derivatives, and how they are computed, in
floats and in integers. The fall of a weight is 2 m w'(t): what the weight's derivative multiplies an offset with.

In integers t is off by e, and

    Q    by (t + e)^2 - t^2 and 2^-17, as it is rounded to a multiple of 2^-16
    W    by what its factors are off by, and 2^-19
    E    an eighth of the fall, likewise
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bounds.floats import Approx

NEAR_ONE, WEIGHT_ONE = 2**16, 2**18  # the units of t and Q, and of W and E
HALF_NEAR, HALF_WEIGHT = 0.5 / NEAR_ONE, 0.5 / WEIGHT_ONE


def product_error(a, a_err, b, b_err):
    return a_err * (b + b_err) + a * b_err


def square_error(t, e):
    """Of Q."""
    return product_error(t, e, t, e) + HALF_NEAR


def _fixed_cube(t, e):
    return product_error(t * t, square_error(t, e), t, e) + HALF_WEIGHT


def _fixed_fourth(t, e):
    q = square_error(t, e)
    return product_error(t * t, q, t * t, q) + HALF_WEIGHT


def _fixed_fifth(t, e):
    q = square_error(t, e)
    return 4 * product_error(t**4, product_error(t * t, q, t * t, q) + HALF_NEAR, t, e) + HALF_WEIGHT


def _fixed_plane(t, e):
    """2 Q u, u = t (3/2 - t), which is rounded like Q."""
    u = np.minimum(3 / 2 * t, 9 / 16)  # or more, for all t up to that
    off = e * np.maximum(3 / 2, 2 * t) + e * e + HALF_NEAR
    return 2 * product_error(t * t, square_error(t, e), u, off) + HALF_WEIGHT


def _fixed_plane_fall(t, e):
    """2 Q (9/8 - t)."""
    return 2 * product_error(t * t, square_error(t, e), 9 / 8, e) + HALF_WEIGHT


def _floats_cube(t: Approx) -> Approx:
    return t.times(t).times(t)


def _floats_fourth(t: Approx) -> Approx:
    q = t.times(t)
    return q.times(q)


def _floats_plane(t: Approx) -> Approx:
    rest = Approx(-2 * t.hi, -2 * t.lo, 2 * t.err, t.ulps).plus(3.0)
    return _floats_cube(t).times(rest)


def _floats_plane_fall(t: Approx, m: int) -> Approx:
    rest = Approx(-16 * t.hi, -16 * t.lo, 16 * t.err, t.ulps).plus(18.0)
    return t.times(t).times(rest).scaled(float(m))


@dataclass(frozen=True, eq=False)
class Weight:
    """A polynomial: coefficients by powers of t. `floats` computes it, and `float_fall` its fall; `fixed` and
    `fixed_fall` bound the errors of W and E, given the largest t and its error. Where there are no
    derivatives there is no fall."""
    coefficients: dict[int, float]
    floats: Callable[[Approx], Approx]
    fixed: Callable
    float_fall: Callable[[Approx, int], Approx] | None = None
    fixed_fall: Callable | None = None

    def terms(self, order: int) -> dict[int, float]:
        return {power - order: math.perm(power, order) * c for power, c in self.coefficients.items() if power >= order}

    def derivative(self, order: int, t):
        """Of order 0 (the weight itself) and more."""
        return sum(c * t**power for power, c in self.terms(order).items()) + 0 * t

    def ends(self, order: int, low, high):
        """Bounds of the derivative for t from low to high, both at least 0."""
        return tuple(sum(c * (a if c > 0 else b)**power for power, c in self.terms(order).items())
                     for a, b in ((low, high), (high, low)))

    def size(self, order: int, low, high):
        """The largest magnitude."""
        return np.maximum(*map(np.abs, self.ends(order, low, high)))


CUBE = Weight({3: 1.0}, _floats_cube, _fixed_cube, lambda t, m: t.times(t).scaled(6.0 * m),
              lambda t, e: 1.5 * square_error(t, e))
FOURTH = Weight({4: 1.0}, _floats_fourth, _fixed_fourth, lambda t, m: _floats_cube(t).scaled(8.0 * m),
                lambda t, e: 2 * _fixed_cube(t, e))
FIFTH = Weight({5: 4.0}, lambda t: _floats_fourth(t).times(t).scaled(4.0), _fixed_fifth)
PLANE = Weight({3: 3.0, 4: -2.0}, _floats_plane, _fixed_plane, _floats_plane_fall, _fixed_plane_fall)
