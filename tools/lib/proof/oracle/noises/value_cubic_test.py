"""Tests of value_cubic.py: its weights by hand. (vectors_test.py has values.)"""

from __future__ import annotations

import unittest
from fractions import Fraction

from base.thorough import THOROUGH
from proof.oracle.integers import UNIT
from proof.oracle.noises import value_cubic


class Weights(unittest.TestCase):
    """Another spline, weights of other points, or weights that are rounded in another place."""

    def test_by_hand(self) -> None:
        sixth = Fraction(1, 6)
        self.assertEqual(value_cubic.spline_weights(Fraction(0)), (sixth, 4 * sixth, sixth, 0))
        self.assertEqual(value_cubic.spline_weights(Fraction(1, 2)), tuple(Fraction(i, 48) for i in (1, 23, 23, 1)))
        # 2^-30 * 178956970.67 is a sixth; an eighth of it is 22369621.33.
        self.assertEqual([value_cubic.sixth(x) for x in (0, 2**14, 2**15)], [0, 22369621, 178956970])
        self.assertEqual(value_cubic.fixed_weights(0), (43691, 174763, 43690, 0))
        self.assertEqual(value_cubic.fixed_weights(UNIT), (0, 43691, 174762, 43691))

    def test_fixed_ones_are_near(self) -> None:
        for fraction in range(0, UNIT + 1, 31 if THOROUGH else 4093):
            fixed = value_cubic.fixed_weights(fraction)
            self.assertEqual((sum(fixed), min(fixed) >= 0), (2**18, True))
            for b, exact in zip(fixed, value_cubic.spline_weights(Fraction(fraction, UNIT))):
                # x is rounded by half a unit of 2^-15, and a weight changes by 2/3 of that at most: 8/3. A weight
                # rounds by 1/2, and the third by what the others do.
                self.assertLess(abs(b - exact * 2**18), 8 / 3 + 3 / 2, fraction)
