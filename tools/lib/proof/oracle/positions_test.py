"""Tests of positions.py: by hand, and that a cell and its fraction are the position."""

from __future__ import annotations

import unittest
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import positions


class Positions(unittest.TestCase):
    def test_by_hand(self) -> None:
        # Three cells are 100 units long.
        table = {0: (0, 0), 33: (0, Fraction(99, 100)), 34: (1, Fraction(2, 100)), 100: (3, 0),
                 -1: (-1, Fraction(97, 100)), -100: (-3, 0), -101: (-4, Fraction(97, 100)),
                 INT_MAX: (64424509, Fraction(41, 100)), INT_MIN: (-64424510, Fraction(56, 100))}
        for position, (cell, fraction) in table.items():
            self.assertEqual(positions.cell(position, 3, 100), cell)
            self.assertEqual(positions.fraction(position, 3, 100), int(fraction * 2**24) / 2**24)

    def test_settings_are_cut(self) -> None:
        for settings, same in (((0, 0), (1, 1)), ((INT_MIN, 7), (1, 7)), ((65537, 7), (65536, 7)), ((7, -1), (7, 1)),
                               ((7, INT_MAX), (7, 65536))):
            for of in (positions.cell, positions.fraction):
                self.assertEqual(of(-1001, *settings), of(-1001, *same))

    def test_a_cell_wraps(self) -> None:
        # 65536 cells are one unit long.
        self.assertEqual([positions.cell(p, 65536, 1) for p in (32767, 32768, 65536, -32769, INT_MAX)],
                         [0x7FFF0000, -2**31, 0, 0x7FFF0000, -65536])

    def test_together_they_are_the_position(self) -> None:
        numbers = generator_of("positions")
        for _ in range(500):
            position = numbers.integer(INT_MIN, INT_MAX)
            cells, units = numbers.integer(1, 300), numbers.integer(1, 65536)
            exact = Fraction(position * cells, units)
            fraction = positions.fraction(position, cells, units)
            self.assertTrue(0 <= fraction < 1)
            self.assertEqual(to_f32(fraction), fraction)
            lost = exact - positions.cell(position, cells, units) - Fraction(fraction)
            self.assertTrue(0 <= lost % 2**32 < Fraction(1, 2**24))
