"""Tests of value.py: its numbers by hand, and interpolation on a line."""

from __future__ import annotations

import unittest
from fractions import Fraction
from unittest import mock

from proof.oracle import noises, words
from proof.oracle.gradients import Knobs
from proof.oracle.integers import lerp
from proof.oracle.lattice import Lattice
from proof.oracle.noises import value

VALUE = noises.find("value")


class Numbers(unittest.TestCase):
    # The word, the number, and the one of fixed arithmetic.
    WORDS = {0: (-1, -2**29), 0xFF800000: (-1, -2**29), 1: (-1 + Fraction(1, 2**22), -2**29 + 128),
             0x00400000: (0, 0), 0x80600000: (Fraction(1, 2), 2**28),
             words.MASK: (1 - Fraction(1, 2**22), 2**29 - 128)}

    def test_by_hand(self) -> None:
        for word, expected in self.WORDS.items():
            with mock.patch.object(Lattice, "word", return_value=word):
                lattice = Lattice(Knobs("lattice"))
                self.assertEqual((value.number(lattice, (0,)), value.fixed_number(lattice, (0,))), expected)

    def test_rounding(self) -> None:
        self.assertEqual([value.rounded(n) for n in (-2**29, -129, -128, 127, 128, 2**29 - 129, 2**29 - 1)],
                         [-2**21, -1, 0, 0, 1, 2**21 - 1, 2**21])


class Value(unittest.TestCase):
    def test_on_a_line_by_hand(self) -> None:
        # s(1/4) is 106 / 1024, and its fade 27136 in units of 2^-18.
        a, b = (words.point_word("pcg", (c,), 7) for c in (-3, -2))
        exact = (Fraction(a & 0x7FFFFF) * 918 + Fraction(b & 0x7FFFFF) * 106) / 1024 / 2**22 - 1
        fixed = lerp(((a & 0x7FFFFF) << 7) - 2**29, ((b & 0x7FFFFF) << 7) - 2**29, 27136) + 128 >> 8
        self.assertEqual(VALUE.exact(Knobs("pcg"), (-2.75,), 7), (exact,))
        self.assertEqual(VALUE.fixed(Knobs("pcg"), (-2.75,), 7), (Fraction(fixed, 2**21),))

    def test_at_lattice_points_it_is_the_number(self) -> None:
        for n in (1, 2, 3, 4):
            point = (5, -6, 7, -8)[:n]
            self.assertEqual(VALUE.exact(Knobs("pcg"), point, 9), (value.number(Lattice(Knobs("pcg"), 9), point),))

    def test_in_the_middle_it_is_the_mean(self) -> None:
        lattice = Lattice(Knobs("lattice"), 9, (1, 0))
        mean = (value.number(lattice, (0, 3)) + value.number(lattice, (0, 4))) / 2
        self.assertEqual(VALUE.exact(Knobs("lattice"), (0.5, 3.5), 9, (1, 0)), (mean,))
