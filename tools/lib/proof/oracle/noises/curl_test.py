"""Tests of curl.py: where the second noise is in space, and its phase. (vectors_test.py has values.)"""

from __future__ import annotations

import unittest
from fractions import Fraction

from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.noises import curl


class Places(unittest.TestCase):
    """A place of the second noise that goes into the next cell too early or too late."""

    def test_by_hand(self) -> None:
        half, step, one = 2**19, 2**18, 2**20
        for f, moved in (((0, 0, 0), ([7, 8, 9], [half, 0, step])),
                         ((half - 1, one - 1, 3 * step - 1), ([7, 8, 9], [one - 1] * 3)),
                         ((half, 5, 3 * step), ([8, 8, 10], [0, 5, 0])),
                         ((one, 5, one), ([8, 8, 10], [half, 5, step]))):
            self.assertEqual(curl.moved((7, 8, 9), f, one), moved)
            exact = curl.moved((7, 8, 9), [Fraction(x, one) for x in f], 1)
            self.assertEqual(exact, (moved[0], [Fraction(x, one) for x in moved[1]]))


class Phases(unittest.TestCase):
    """A phase of the second noise that runs as fast as the first, or is cut in another place."""

    def test_by_hand(self) -> None:
        # 3/8 of a turn and 2^-32: the word 0x60000000, and twice that.
        lattice = Lattice(Knobs("lattice"), 7, (), Fraction(3, 8) + Fraction(1, 2**32))
        self.assertEqual(curl.second(lattice).phase, Fraction(3, 4) + Fraction(1, 2**31))
        self.assertEqual(curl.fixed_second(lattice).phase, Fraction(3, 4))
        self.assertEqual(curl.fixed_second(curl.fixed_second(lattice)).phase, Fraction(1, 2))
        self.assertIsNone(curl.second(Lattice(Knobs("lattice"))).phase)
