"""Tests of value_cubic.py: its weights, by hand and by what a B-spline is, and that it is smooth."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction
from unittest import mock

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of
from proof.oracle import noises
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import value_cubic
from proof.oracle.noises.value import number

CUBIC = noises.find("value_cubic")
DIMENSIONS = (1, 2, 3)


class Weights(unittest.TestCase):
    def test_by_hand(self) -> None:
        sixth = Fraction(1, 6)
        self.assertEqual(value_cubic.spline_weights(Fraction(0)), (sixth, 4 * sixth, sixth, 0))
        self.assertEqual(value_cubic.spline_weights(Fraction(1)), (0, sixth, 4 * sixth, sixth))
        self.assertEqual(value_cubic.spline_weights(Fraction(1, 2)), tuple(Fraction(i, 48) for i in (1, 23, 23, 1)))

    def test_they_sum_to_one_and_are_not_negative(self) -> None:
        for f in (Fraction(i, 96) for i in range(97)):
            weights = value_cubic.spline_weights(f)
            self.assertEqual(sum(weights), 1)
            self.assertGreaterEqual(min(weights), 0)

    def test_their_mean_is_the_position(self) -> None:
        # A B-spline reproduces lines: without it the weights could belong to other points.
        for f in (Fraction(i, 96) for i in range(97)):
            weights = value_cubic.spline_weights(f)
            self.assertEqual(sum(o * b for o, b in zip(value_cubic.OFFSETS, weights)), f)

    def test_sixth_by_hand(self) -> None:
        # 2^-30 * 178956970.67 is a sixth; an eighth of it is 22369621.33.
        self.assertEqual([value_cubic.sixth(x) for x in (0, 2**14, 2**15)], [0, 22369621, 178956970])

    @in_thorough_runs
    def test_all_fixed_weights(self) -> None:
        for fraction in range(0, UNIT + 1, 31):
            fixed = value_cubic.fixed_weights(fraction)
            self.assertEqual(sum(fixed), 2**18)
            self.assertGreaterEqual(min(fixed), 0)
            for b, exact in zip(fixed, value_cubic.spline_weights(Fraction(fraction, UNIT))):
                # x is rounded by half a unit of 2^-15, and a weight changes by 2/3 of that at most: 8/3. A weight
                # rounds by 1/2, and the third by what the others do.
                self.assertLess(abs(b - exact * 2**18), 8 / 3 + 3 / 2, fraction)
        self.assertEqual(value_cubic.fixed_weights(0), (43691, 174763, 43690, 0))
        self.assertEqual(value_cubic.fixed_weights(UNIT), (0, 43691, 174762, 43691))


class Cubic(unittest.TestCase):
    def test_on_a_line_by_hand(self) -> None:
        v = [number(Lattice(Knobs("pcg"), 7), (c,)) for c in (-4, -3, -2, -1)]
        self.assertEqual(CUBIC.exact(Knobs("pcg"), (-3.0,), 7), ((v[0] + 4 * v[1] + v[2]) / 6,))
        self.assertEqual(CUBIC.exact(Knobs("pcg"), (-2.5,), 7), ((v[0] + 23 * v[1] + 23 * v[2] + v[3]) / 48,))

    def test_no_crease_in_its_slope(self) -> None:
        step = Fraction(1, 2**20)
        for n in DIMENSIONS:
            rest = (Fraction(3, 8), Fraction(5, 8))[:n - 1]
            below, at, above = (CUBIC.exact(Knobs("lattice"), (7 + i * step, *rest), 3)[0] for i in (-1, 0, 1))
            self.assertLess(abs((above - at) - (at - below)), 8 * step**2)

    def test_the_largest_numbers_stay_within_range(self) -> None:
        numbers = generator_of("largest")
        for n, (number_of_all, value_of_all) in itertools.product(DIMENSIONS, ((-2**29, -2**21), (2**29 - 1, 2**21))):
            for f in (0, UNIT // 2, UNIT, *(numbers.integer(0, UNIT) for _ in range(20))):
                with mock.patch.object(value_cubic, "fixed_number", return_value=number_of_all):
                    value, = value_cubic.fixed(Lattice(Knobs("lattice")), (0,) * n, (f,) * n)
                self.assertTrue(abs(value) <= 2**21 and abs(value - value_of_all) < 32)
