"""Tests of slopes.py and of the noises with derivatives: by hand, by difference quotients, and near the exact ones."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Callable, Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, generator_of
from proof.oracle import noises, slopes
from proof.oracle.cells import smooth
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT, fade
from proof.oracle.noises import perlin_d, value_d

PAIRS = (("perlin", "perlin_d"), ("value", "value_d"))
DIMENSIONS = (1, 2, 3, 4)


def quotient(f: Callable[[Fraction], Fraction], x: Fraction, step: Fraction) -> Fraction:
    """The limit of the exact difference quotients at x, but for the fourth power of the step."""
    def central(h: Fraction) -> Fraction:
        return (f(x + h) - f(x - h)) / (2 * h)

    return (4 * central(step) - central(2 * step)) / 3


class Weights(unittest.TestCase):
    def test_the_slope_of_the_weight(self) -> None:
        self.assertEqual([slopes.smooth_slope(Fraction(i, 4)) for i in range(5)],
                         [0, Fraction(270, 256), Fraction(15, 8), Fraction(270, 256), 0])
        for x in (Fraction(1, 7), Fraction(2, 5), Fraction(6, 7)):
            self.assertLess(abs(quotient(smooth, x, Fraction(1, 2**20)) - slopes.smooth_slope(x)), 2**-60)

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
    def points(self, n: int, count: int) -> list[tuple[list[Fraction], int]]:
        """Positions that fixed arithmetic does not cut, and seeds."""
        numbers = generator_of(f"derivatives{n}")
        return [([Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(n)], numbers.word())
                for _ in range(count)]

    def test_the_value_is_that_of_the_noise(self) -> None:
        for (plain, with_derivatives), n in itertools.product(PAIRS, DIMENSIONS):
            for p, seed in self.points(n, 4):
                for of, of_both in ((getattr(noises.find(plain), form), getattr(noises.find(with_derivatives), form))
                                    for form in ("exact", "fixed")):
                    for periods in ((), (5,) * n):
                        found = of_both(Knobs("lattice"), p, seed, periods)
                        self.assertEqual(found[:1], of(Knobs("lattice"), p, seed, periods))
                        self.assertEqual(len(found), 1 + n)

    def check_quotients(self, derivatives: Callable, plain: noises.Noise, n: int) -> None:
        """Exact derivatives are the limits of exact difference quotients, with a period, too."""
        for (p, seed), periods in itertools.product(self.points(n, 2), ((), (5,) * n)):
            found = derivatives(Knobs("lattice"), p, seed, periods)
            for axis in range(n):
                def moved(x: Fraction, axis: int = axis) -> Fraction:
                    value, = plain.exact(Knobs("lattice"), [*p[:axis], x, *p[axis + 1:]], seed, periods)
                    return value

                limit = quotient(moved, p[axis], Fraction(1, 2**26))
                self.assertLess(abs(limit - found[1 + axis]), 2**-80)

    def test_they_are_the_limits_of_difference_quotients(self) -> None:
        for (plain, with_derivatives), n in itertools.product(PAIRS, DIMENSIONS):
            self.check_quotients(noises.find(with_derivatives).exact, noises.find(plain), n)

    def test_derivatives_without_the_scale_are_noticed(self) -> None:
        of = noises.find("perlin_d").exact
        with self.assertRaises(AssertionError):
            self.check_quotients(lambda *args: [x * Fraction(1023, 1024) for x in of(*args)], noises.find("perlin"), 2)

    def test_by_hand(self) -> None:
        # At a lattice point a derivative of Perlin noise is the gradient's component, of value noise 0.
        for n, cell in itertools.product(DIMENSIONS, (-3, 5)):
            point, knobs = (cell,) * n, Knobs("pcg")
            gradient = perlin_d.Lattice(knobs, 7).gradient(point)
            expected = [Fraction(g) * perlin_d.perlin.scale(knobs, n) for g in gradient]
            self.assertEqual(list(noises.find("perlin_d").exact(knobs, point, 7)), [0, *expected])
            self.assertEqual(noises.find("value_d").exact(knobs, point, 7)[1:], (0,) * n)
            self.assertEqual(noises.find("value_d").fixed(knobs, point, 7)[1:], (0,) * n)

    def test_cells_meet(self) -> None:
        # f = 1 in one cell is f = 0 in the next: at the seam of a period, and where cells wrap without one.
        numbers = generator_of("meet")
        for (_, name), n, (cell, following, period) in itertools.product(
                PAIRS, DIMENSIONS, ((4, 0, 5), (INT_MAX, -2**31, 0), (INT_MAX, 1, INT_MAX))):
            for axis in range(n):
                f = [numbers.integer(0, 64) / 64 for _ in range(n)]
                ends = [noises.find(name).exact_cell(Knobs("lattice"), [c if i == axis else 3 for i in range(n)],
                                                     [x if i == axis else y for i, y in enumerate(f)], 9, (period,) * n)
                        for c, x in ((cell, 1.0), (following, 0.0))]
                self.assertEqual(*ends)

    def test_fixed_ones_are_near(self) -> None:
        for (_, name), n in itertools.product(PAIRS, DIMENSIONS):
            noise = noises.find(name)
            for p, seed in self.points(n, 12):
                for exact, fixed in zip(noise.exact(Knobs("lattice"), p, seed), noise.fixed(Knobs("lattice"), p, seed)):
                    self.assertLess(abs(exact - fixed), 2**-11, (name, n))

    def test_fixed_ones_are_in_units(self) -> None:
        for (_, name), n in itertools.product(PAIRS, DIMENSIONS):
            for p, seed in self.points(n, 4):
                for derivative in noises.find(name).fixed(Knobs("lattice"), p, seed)[1:]:
                    self.assertEqual((derivative * 2**19).denominator, 1)

    def test_there_are_none_with_the_sine_gradient(self) -> None:
        for of, n in itertools.product((noises.find("perlin_d").exact, noises.find("perlin_d").fixed), DIMENSIONS):
            with self.assertRaisesRegex(ValueError, "no hn_perlin_d"):
                of(Knobs("lattice", sine=True), (0.5,) * n)


class FixedValueNoise(unittest.TestCase):
    FRACTION = (3 * 2**17, 2**18 + 9, 5 * 2**16)

    def with_numbers(self, numbers: Sequence[int]) -> tuple[int, ...]:
        """Of a cell with these numbers at its corners."""
        n = len(numbers).bit_length() - 1
        with mock.patch.object(value_d.value, "fixed_number", side_effect=numbers):
            return value_d.fixed(value_d.Lattice(Knobs("lattice")), (0,) * n, self.FRACTION[:n])

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
