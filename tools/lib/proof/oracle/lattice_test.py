"""Tests of lattice.py: seeds, and periods by hand and by what the contract promises of them."""

from __future__ import annotations

import itertools
import unittest

from proof.golden.generator import INT_MAX, INT_MIN, generator_of
from proof.oracle import gradients, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice, repeated

PERIODS = (1, 2, 3, 48, 1000003, 2**20, 2**30, INT_MAX)
KINDS = (Knobs("lattice"), Knobs("pcg"), Knobs("custom"), Knobs("lattice", sine=True), Knobs("fnv1", sine=True))


class Periods(unittest.TestCase):
    def test_by_hand(self) -> None:
        # 2^31 = 48 * 44739242 + 32 = 1000003 * 2147 + 477207; it is 1 more than INT_MAX.
        table = {1: (0, 0, 0, 0), 2: (1, 0, 1, 0), 3: (2, 1, 1, 2), 48: (47, 16, 31, 32),
                 1000003: (1000002, 522796, 477206, 477207), 2**20: (2**20 - 1, 0, 2**20 - 1, 0),
                 INT_MAX: (INT_MAX - 1, INT_MAX - 1, 0, 1), 0: (-1, INT_MIN, INT_MAX, 2**31),
                 -48: (-1, INT_MIN, INT_MAX, 2**31), INT_MIN: (-1, INT_MIN, INT_MAX, 2**31)}
        for period, expected in table.items():
            self.assertEqual(tuple(repeated(c, period) for c in (-1, INT_MIN, INT_MAX, 2**31)), expected, period)

    def test_without_a_period_a_coordinate_wraps_as_words_do(self) -> None:
        for knobs, n in itertools.product(KINDS, (2, 3)):
            for periods in ((), (0,) * n, (-48,) * n):
                lattice = Lattice(knobs, 7, periods)
                self.assertEqual(lattice.gradient((2**31,) + (5,) * (n - 1)),
                                 lattice.gradient((INT_MIN,) + (5,) * (n - 1)))

    def test_the_period_goes_on_beyond_the_last_cell(self) -> None:
        # The far corner of the cell at INT_MAX is at 2^31, which is 32 modulo 48; INT_MIN is 16.
        lattice = Lattice(Knobs("lattice"), 7, (48, 0))
        self.assertEqual(lattice.word((2**31, 5)), lattice.word((32, 5)))
        self.assertNotEqual(lattice.word((2**31, 5)), lattice.word((INT_MIN, 5)))
        self.assertEqual(lattice.word((INT_MIN - 1, 5)), lattice.word((15, 5)))

    def test_a_period_leaves_the_points_from_0_on(self) -> None:
        numbers = generator_of("points")
        for knobs, period, n in itertools.product(KINDS, PERIODS, (1, 2, 3, 4)):
            point = [numbers.integer(0, period - 1) for _ in range(n)]
            moved = [c + period * numbers.integer(-4, 4) for c in point]
            lattice, whole = Lattice(knobs, 3, (period,) * n), Lattice(knobs, 3)
            self.assertEqual(lattice.word(moved), words.point_word(knobs.hash, point, 3))
            self.assertEqual(lattice.gradient(moved), gradients.gradient(knobs, point, 3))
            self.assertEqual(lattice.gradient(moved), whole.gradient(point))

    def test_each_axis_has_its_own(self) -> None:
        for n, axis in ((n, axis) for n in (1, 2, 3, 4) for axis in range(n)):
            lattice = Lattice(Knobs("lattice"), 3, tuple(48 if i == axis else 0 for i in range(n)))
            for other in range(n):
                words_there = {lattice.word([48 * k if i == other else 5 for i in range(n)]) for k in range(3)}
                self.assertEqual(len(words_there), 1 if other == axis else 3)

    def test_they_repeat_not_before(self) -> None:
        for knobs, period, start in itertools.product(KINDS, PERIODS, (0, -1, INT_MIN, INT_MAX)):
            lattice = Lattice(knobs, 3, (period, 0))
            self.assertEqual(lattice.gradient((start, 5)), lattice.gradient((start + period, 5)))
            if period > 1:
                self.assertNotEqual(lattice.word((start, 5)), lattice.word((start + period // 2, 5)))

    def test_as_many_periods_as_axes(self) -> None:
        with self.assertRaises(ValueError):
            Lattice(Knobs("lattice"), 3, (48,)).word((1, 2))
