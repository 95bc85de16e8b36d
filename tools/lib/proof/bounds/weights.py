"""The weights w(t) of simplex noise and of phasor noise (docs/reference/contract.md, sections 13 and 23), and their
derivatives. The fall of a weight is 2 m w'(t): what the weight's derivative multiplies an offset with."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass

import numpy as np

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


@dataclass(frozen=True, eq=False)
class Weight:
    """A polynomial: coefficients by powers of t."""
    coefficients: Terms

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


CUBE = Weight({3: 1.0})
FOURTH = Weight({4: 1.0})
FIFTH = Weight({5: 4.0})
PLANE = Weight({3: 3.0, 4: -2.0})
EVEN = Weight({3: 16.0, 4: -30.0, 5: 15.0})
