"""The weights w(t) of simplex noise and of phasor noise (docs/reference/contract.md, sections 13 and 23): their
derivatives, and how integers compute them. The fall of a weight is 2 m w'(t): what the weight's
derivative multiplies an offset with.

In integers t is off by e, and

    Q    by (t + e)^2 - t^2 and 2^-17, as it is rounded to a multiple of 2^-16
    W    by the errors of its factors, and 2^-19
    E    an eighth of the fall, likewise

EVEN. The weight of phasor noise is t^3 (1 + 15 (1 - t)^2), and its slope 3 h^2 with h = 4 t - 5 t^2. The steps depend on
each other. So e is followed through the exact weight, which moves by at most |e| times the largest slope between t and
t + e, and the roundings of the steps through steps from a t + e that is exact. With r = 2^-17, x = t (1 - t), and x and h
taken at t + e,

    Q    is rounded by r, and so G is off by that
    M    is off by r |1 - 30 x| + 15 r^2 because of both, and by r because 15 G^2 is rounded
    W    is off by t times that, and by 2^-19
    H    is off by 5 r, so its square by 10 r |h| + 25 r^2, and by r because it is rounded; E has 3 m / 4 times that
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

NEAR_ONE, WEIGHT_ONE = 2**16, 2**18  # the units of t and Q, and of W and E
HALF_NEAR, HALF_WEIGHT = 0.5 / NEAR_ONE, 0.5 / WEIGHT_ONE


Terms = dict[int, float]  # of a polynomial: coefficients by powers


def derived(terms: Terms, order: int) -> Terms:
    return {power - order: math.perm(power, order) * c for power, c in terms.items() if power >= order}


def value_of(terms: Terms, t):
    return sum(c * t**power for power, c in terms.items()) + 0 * t


@functools.cache
def _roots(*items: tuple[int, float]) -> list[float]:
    """The real roots, or nearly real ones: doubles turn a double root into two complex ones."""
    terms = dict(items)
    found = np.roots([terms.get(power, 0.0) for power in range(max(terms, default=0), -1, -1)])
    return [float(root.real) for root in found if abs(root.imag) < 1e-6]


def ends_of(terms: Terms, low, high):
    """The least and the largest of a polynomial from low to high: it has them at an end or where its slope is 0."""
    at_ends = value_of(terms, low), value_of(terms, high)
    least, largest = np.minimum(*at_ends), np.maximum(*at_ends)
    for root in _roots(*derived(terms, 1).items()):
        there, inside = value_of(terms, root), (low <= root) & (root <= high)
        least = np.where(inside, np.minimum(least, there), least)
        largest = np.where(inside, np.maximum(largest, there), largest)
    return least, largest


def product_error(a, a_err, b, b_err):
    return a_err * (b + b_err) + a * b_err


def square_error(t, e):
    return product_error(t, e, t, e) + HALF_NEAR


def _fixed_cube(_, t, e):
    return product_error(t * t, square_error(t, e), t, e) + HALF_WEIGHT


def _fixed_fourth(_, t, e):
    q = square_error(t, e)
    return product_error(t * t, q, t * t, q) + HALF_WEIGHT


def _fixed_fifth(_, t, e):
    q = square_error(t, e)
    return 4 * product_error(t**4, product_error(t * t, q, t * t, q) + HALF_NEAR, t, e) + HALF_WEIGHT


def _fixed_plane(_, t, e):
    """2 Q u, u = t (3/2 - t), which is rounded like Q."""
    u = np.minimum(3 / 2 * t, 9 / 16)  # or more, for all t up to that
    off = e * np.maximum(3 / 2, 2 * t) + e * e + HALF_NEAR
    return 2 * product_error(t * t, square_error(t, e), u, off) + HALF_WEIGHT


def _fixed_plane_fall(_, t, e, m: int):
    """2 Q (9/8 - t)."""
    return m * 2 * product_error(t * t, square_error(t, e), 9 / 8, e) + HALF_WEIGHT


# G, H and M of the contract, with which a weight is M t and its slope 3 H^2.
OF_G, OF_H, OF_M = {1: 1.0, 2: -1.0}, {1: 4.0, 2: -5.0}, {2: 16.0, 3: -30.0, 4: 15.0}


def _around(terms: Terms, low, high, e):
    """The least and the largest of a polynomial where t, which is in that range, is off by at most e."""
    return ends_of(terms, np.maximum(low - e, 0.0), high + e)


def _moved(order: int, low, high, e):
    """How far EVEN or a derivative of it moves, if t, which is in that range, is off by at most e."""
    return e * np.maximum(*map(np.abs, _around(EVEN.terms(order + 1), low, high, e)))


def _fixed_even(low, high, e):
    least, largest = _around(OF_G, low, high, e)
    of_m = HALF_NEAR * (np.maximum(1 - 30 * least, 30 * largest - 1) + 1) + 15 * HALF_NEAR**2
    return _moved(0, low, high, e) + (high + e) * of_m + HALF_WEIGHT


def _fixed_even_fall(low, high, e, m: int):
    h = np.maximum(*map(np.abs, _around(OF_H, low, high, e)))
    of_square = 10 * HALF_NEAR * h + 25 * HALF_NEAR**2 + HALF_NEAR
    return m / 4 * (_moved(1, low, high, e) + 3 * of_square)


@dataclass(frozen=True, eq=False)
class Weight:
    """A polynomial: coefficients by powers of t. `fixed` and `fixed_fall` bound the errors of W and E, given the least and
    the largest t and its error. A fall has its m as an argument. Where there are no derivatives there is no fall."""
    coefficients: Terms
    fixed: Callable
    fixed_fall: Callable | None = None

    def terms(self, order: int) -> Terms:
        return derived(self.coefficients, order)

    def derivative(self, order: int, t):
        """The derivative of an order from 0 (the weight itself)."""
        return value_of(self.terms(order), t)

    def ends(self, order: int, low, high):
        """The least and the largest of the derivative for t from low to high, both at least 0."""
        return ends_of(self.terms(order), low, high)

    def size(self, order: int, low, high):
        """The largest magnitude."""
        return np.maximum(*map(np.abs, self.ends(order, low, high)))


CUBE = Weight({3: 1.0}, _fixed_cube, lambda _, t, e, m: m * 0.75 * square_error(t, e))
FOURTH = Weight({4: 1.0}, _fixed_fourth, lambda low, t, e, m: m * _fixed_cube(low, t, e))
FIFTH = Weight({5: 4.0}, _fixed_fifth)
PLANE = Weight({3: 3.0, 4: -2.0}, _fixed_plane, _fixed_plane_fall)
EVEN = Weight({3: 16.0, 4: -30.0, 5: 15.0}, _fixed_even, _fixed_even_fall)
