"""Tests of slopes.py and of the noises with derivatives: by hand. (noises_test.py has what all derivatives are.)"""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import generator_of
from proof.oracle import noises, slopes
from proof.oracle.cells import smooth
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT, fade
from proof.oracle.lattice import Lattice
from proof.oracle.noises import perlin_d, value_d
from proof.oracle.testing import KNOBS, quotient

DIMENSIONS = (1, 2, 3, 4)


class Weights(unittest.TestCase):
    def test_the_slope_of_the_weight(self) -> None:
        self.assertEqual([slopes.smooth_slope(Fraction(i, 4)) for i in range(5)],
                         [0, Fraction(270, 256), Fraction(15, 8), Fraction(270, 256), 0])
        for x in (Fraction(1, 7), Fraction(2, 5), Fraction(6, 7)):
            self.assertLess(abs(quotient(lambda h: smooth(x + h)) - slopes.smooth_slope(x)), 2**-60)

    def test_along_each_axis_the_slopes_sum_to_zero(self) -> None:
        numbers = generator_of("weights")
        for n in DIMENSIONS:
            f = tuple(Fraction(numbers.integer(0, 64), 64) for _ in range(n))
            for along_axis in zip(*(of_corner for _, of_corner in slopes.corner_slopes(f))):
                self.assertEqual(sum(along_axis), 0)


class FadeSlope(unittest.TestCase):
    def test_by_hand(self) -> None:
        # At 1/4: x = 2^15, q = 2^15 * 3 * 2^15 / 2^16 = 49152, q * q >> 4 = 150994944, slope = 276480 = 270/256 * 2^18.
        # At 1/2 x is 65535, and q too: (65535^2 >> 4) * 15 + 4096 >> 13 = 491505, 15 below 15/8 * 2^18.
        self.assertEqual([slopes.fade_slope(f) for f in (0, 2**18, 2**19, 3 * 2**18, UNIT)],
                         [0, 276480, 491505, 276480, 0])

    def test_all_fractions(self) -> None:
        for f in range(0, UNIT + 1, 5):
            x = f / UNIT
            self.assertLess(abs(slopes.fade_slope(f) - 30 * (x * (1 - x))**2 * 2**18), 24, f)
            self.assertEqual(slopes.fade_slope(f), slopes.fade_slope(UNIT - f))


class Steps(unittest.TestCase):
    def test_rise(self) -> None:
        self.assertEqual([slopes.rise(a, b) for a, b in ((0, 7), (7, 0), (-2**29, 2**29))], [1, -2, 2**28])

    def test_a_ramp_along_an_axis(self) -> None:
        # Half way: t and the slope 15/8 as words. 1.875 * (2560 >> 2) = 1200; half way from 512 to 1536 are 1024.
        a, b = slopes.Ramp(0, (1024,), (512, 2048)), slopes.Ramp(2560, (3072,), (1536, 0))
        found = slopes.interpolated_ramp(a, b, 2**17, 491520)
        self.assertEqual(found, slopes.Ramp(1280, (2048, 1024 + 960), (1024,)))
        # Of value noise the term with the gradient is left out.
        self.assertEqual(slopes.interpolated_ramp(slopes.Ramp(0), slopes.Ramp(2560), 2**17, 491520),
                         slopes.Ramp(1280, (960,)))


class Derivatives(unittest.TestCase):
    def test_by_hand(self) -> None:
        # At a lattice point a derivative of Perlin noise is the gradient's component, of value noise 0.
        for n, cell in itertools.product(DIMENSIONS, (-3, 5)):
            point, knobs = (cell,) * n, Knobs("pcg")
            gradient = perlin_d.Lattice(knobs, 7).gradient(point)
            expected = [Fraction(g) * perlin_d.perlin.scale(Lattice(knobs), n) for g in gradient]
            self.assertEqual(list(noises.find("perlin_d").exact(knobs, point, 7)), [0, *expected])
            self.assertEqual(noises.find("value_d").exact(knobs, point, 7)[1:], (0,) * n)
            self.assertEqual(noises.find("value_d").fixed(knobs, point, 7)[1:], (0,) * n)


class FixedValueNoise(unittest.TestCase):
    FRACTION = (3 * 2**17, 2**18 + 9, 5 * 2**16)

    def with_numbers(self, numbers: Sequence[int]) -> tuple[int, ...]:
        """Of a cell with these numbers at its corners."""
        n = len(numbers).bit_length() - 1
        with mock.patch.object(value_d.value, "fixed_number", side_effect=numbers):
            return value_d.fixed(value_d.Lattice(KNOBS), (0,) * n, self.FRACTION[:n])

    def test_the_largest_numbers_do_not_overflow(self) -> None:
        for n in (1, 2, 3):
            for numbers in itertools.product((-2**29, 2**29 - 1), repeat=2**n):
                for found in self.with_numbers(numbers):
                    self.assertLessEqual(abs(found), 2**21)  # the slope of the fade is at most 15/8, the rise 2

    def test_in_the_plane_that_along_x_is_made_last(self) -> None:
        # The rises along x are 4001 >> 2 and -8001 >> 2, whose remainders are lost before they are interpolated.
        numbers = (0, 2**20, 4001, 2**20 - 8001)
        x, y = self.FRACTION[:2]
        rise = slopes.lerp(1000, -2001, fade(y))
        self.assertEqual(self.with_numbers(numbers)[1], (slopes.part(rise, slopes.fade_slope(x)) + 128) >> 8)
