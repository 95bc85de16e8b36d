"""Tests of positions.py, by hand."""

from __future__ import annotations

import unittest
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN
from proof.oracle import positions


class Positions(unittest.TestCase):
    """A cell or a fraction that is rounded or cut in another way."""

    def test_by_hand(self) -> None:
        # Three cells are 100 units long.
        table = {0: (0, 0), 33: (0, Fraction(99, 100)), 34: (1, Fraction(2, 100)), 100: (3, 0),
                 -1: (-1, Fraction(97, 100)), -101: (-4, Fraction(97, 100)),
                 INT_MAX: (64424509, Fraction(41, 100)), INT_MIN: (-64424510, Fraction(56, 100))}
        for position, (cell, fraction) in table.items():
            self.assertEqual(positions.cell(position, 3, 100), cell)
            self.assertEqual(positions.fraction(position, 3, 100), int(fraction * 2**24) / 2**24)
        # 65536 cells are one unit long, so that a cell wraps.
        self.assertEqual([positions.cell(p, 65536, 1) for p in (32767, 32768, -32769)],
                         [0x7FFF0000, -2**31, 0x7FFF0000])

    def test_settings_are_cut(self) -> None:
        for settings, same in (((0, 0), (1, 1)), ((INT_MIN, 7), (1, 7)), ((65537, 7), (65536, 7)),
                               ((7, INT_MAX), (7, 65536))):
            for of in (positions.cell, positions.fraction):
                self.assertEqual(of(-1001, *settings), of(-1001, *same))
