"""Tests of random.py: its numbers by hand, and to which cell a position counts."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN
from proof.oracle import noises, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice

RANDOM = noises.find("random")
KNOBS = Knobs("pcg")
DIMENSIONS = (1, 2, 3, 4)
CELL = (3, -5, 7, -11)


def number_of(cell: tuple[int, ...], seed: int = 7) -> Fraction:
    return Fraction(words.lattice("pcg", cell, seed) >> 8, 2**24)


class Random(unittest.TestCase):
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

    def test_of_a_hash_by_hand(self) -> None:
        # The low 8 bits are cut off.
        for hashed, value in ((0, 0), (words.MASK, 1 - Fraction(1, 2**24)), (0xFF, 0), (0x100, Fraction(1, 2**24)),
                            (0x80000000, Fraction(1, 2))):
            with mock.patch.object(Lattice, "hash", return_value=hashed):
                for function in (RANDOM.exact, RANDOM.fixed):
                    self.assertEqual(function(KNOBS, (0.5,)), (value,))

    def test_the_fraction_does_not_matter(self) -> None:
        fractions = (0.0, 2.0**-126, 0.5, 1 - 2.0**-24, 1.0, -3.5, 9.0)  # of a caller, also outside [0, 1]
        for n in DIMENSIONS:
            for cell in (CELL[:n], (-1,) * n, (INT_MAX,) * n, (INT_MIN,) * n):
                for f, function in itertools.product(fractions, (RANDOM.exact_cell, RANDOM.fixed_cell)):
                    self.assertEqual(function(KNOBS, cell, (f,) * n, 7), (number_of(cell),), (cell, f))

    def test_a_period_reduces_the_cell(self) -> None:
        for function in (RANDOM.exact_cell, RANDOM.fixed_cell):
            for cell, period, reduced in (((-1, 9), (5, 0), (4, 9)), ((-1, 9), (-5, 4), (-1, 1)),
                                          ((INT_MAX, INT_MIN), (INT_MAX, 3), (0, 1)), ((-7, 12), (1, 1), (0, 0))):
                self.assertEqual(function(KNOBS, cell, (1.0, 0.5), 7, period), (number_of(reduced),))

    def test_tiny_coordinates_count_as_0(self) -> None:
        for x, cell in ((-2.0**-33, 0), (-2.0**-126, 0), (-2.0**-149, 0), (-0.0, 0), (2.0**-149, 0),
                        (math.nextafter(-2.0**-32, 0), 0), (-2.0**-32, -1), (-2.0**-24, -1), (-1.0, -1)):
            for n in DIMENSIONS:
                for axis in range(n):
                    p = [x if i == axis else 5.5 for i in range(n)]
                    at = tuple(cell if i == axis else 5 for i in range(n))
                    self.assertEqual(RANDOM.exact(KNOBS, p, 7), (number_of(at),), p)
            # In a tile this is the first cell, and not the last one.
            self.assertEqual(RANDOM.exact(KNOBS, (x,), 7, (6,)), (number_of((cell % 6,)),))
        # Elsewhere nothing is tiny, however near to the next cell.
        self.assertEqual(RANDOM.exact(KNOBS, (-1 - Fraction(1, 2**40),), 7), (number_of((-2,)),))
        self.assertEqual(RANDOM.exact(KNOBS, (1 - Fraction(1, 2**40),), 7), (number_of((0,)),))

    def test_fixed_cuts_off_towards_0(self) -> None:
        for x, cell in ((-2.0**-21, 0), (-2.0**-20, -1), (-3 - 2.0**-21, -3), (-3 - 2.0**-20, -4), (3 - 2.0**-22, 2)):
            self.assertEqual(RANDOM.fixed(KNOBS, (x,), 7), (number_of((cell,)),))
            self.assertEqual(RANDOM.exact(KNOBS, (x,), 7), (number_of((math.floor(x),)),))
