"""Tests of random.py: its numbers by hand, and to which cell a position counts."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN
from proof.oracle import hashes, noises
from proof.oracle.gradients import Knobs

RANDOM = noises.find("random")
KNOBS = Knobs("pcg")


def number_of(cell: tuple[int, ...], seed: int = 7) -> Fraction:
    return Fraction(hashes.lattice("pcg", cell, seed) >> 8, 2**24)


class Random(unittest.TestCase):
    """A number of another cell, or of other bits."""

    def test_of_a_cell_by_hand(self) -> None:
        # The formulas of section 3, for the cell (3, -5) with the seed 7 and HN_HASH_LATTICE.
        k = 7 * 0x2C1B3C6D % 2**32  # 7 has no bits to be shifted down
        k = (k ^ k >> 12) * 0x297A2D39 % 2**32
        s = k ^ k >> 15
        x, y = (3 * 0x9E3779B1 + 0x165667B1) % 2**32, -5 * 0x85EBCA77 % 2**32
        a = x + y % 2**24 * 0xE6133E + s
        k = ((x >> 12 ^ y >> 11 ^ s >> 8) * ((2 * a + 1) * 4097 % 2**24) + a) % 2**32
        k = (k ^ k >> 15) * 0x2C1B3C6D % 2**32
        k = (k ^ k >> 12) * 0x297A2D39 % 2**32
        value = Fraction((k ^ k >> 15) // 256, 2**24)
        for function in (RANDOM.exact, RANDOM.fixed):
            self.assertEqual(function(Knobs("lattice"), (3.25, -4.5), 7), (value,))

    def test_to_which_cell_a_position_counts(self) -> None:
        for x, cell in ((-2.0**-33, 0), (-2.0**-149, 0), (math.nextafter(-2.0**-32, 0), 0), (-2.0**-32, -1), (-1.0, -1),
                        # Elsewhere nothing is tiny, however near to the next cell.
                        (-1 - Fraction(1, 2**40), -2), (1 - Fraction(1, 2**40), 0)):
            for axis in range(4):
                p = [x if i == axis else 5.5 for i in range(4)]
                at = tuple(cell if i == axis else 5 for i in range(4))
                self.assertEqual(RANDOM.exact(KNOBS, p, 7), (number_of(at),), p)
        # Fixed arithmetic cuts off towards 0.
        for x, cell in ((-2.0**-21, 0), (-2.0**-20, -1), (-3 - 2.0**-21, -3), (-3 - 2.0**-20, -4), (3 - 2.0**-22, 2)):
            self.assertEqual(RANDOM.fixed(KNOBS, (x,), 7), (number_of((cell,)),))
        # The fraction of a caller does not matter, and a period reduces the cell.
        for f, (cell, period, reduced) in itertools.product((0.0, 1 - 2.0**-24, 1.0, -3.5), (
                ((-1, 9), (5, 0), (4, 9)), ((-1, 9), (-5, 4), (-1, 1)), ((INT_MAX, INT_MIN), (INT_MAX, 3), (0, 1)))):
            for function in (RANDOM.exact_cell, RANDOM.fixed_cell):
                self.assertEqual(function(KNOBS, cell, (f, 0.5), 7, period), (number_of(reduced),))
