"""Tests of sums.py: octave sums of hn_perlin, by hand, and what the contract promises of them."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction
from functools import partial
from unittest import mock

from golden.generator import generator_of
from oracle import noises, sums
from oracle.gradients import Knobs
from oracle.lattice import Lattice

PERLIN = noises.find("perlin")
(fbm, fixed_fbm), (turbulence, fixed_turbulence), (clouds, fixed_clouds) = (
    tuple(partial(function, PERLIN) for function in pair) for pair in sums.SUMS.values())

SETTINGS = (Knobs("lattice"), Knobs("fnv1"), Knobs("lattice", sine=True))


def exact_noise(*args) -> Fraction:
    value, = PERLIN.exact(*args)
    return value


def fixed_noise(*args) -> Fraction:
    value, = PERLIN.fixed(*args)
    return value


class OctaveSums(unittest.TestCase):
    POINTS = [(0.375, -12.25), (5.125, 7.75, -0.625)]

    def test_one_octave_is_the_noise(self) -> None:
        for point in self.POINTS:
            noise = exact_noise(Knobs("lattice"), point, 3)
            self.assertEqual(fbm(Knobs("lattice"), point, 1, 2.0, 0.5, 3), noise)
            self.assertEqual(turbulence(Knobs("lattice"), point, 1, 2.0, 0.5, 3), abs(noise))

    def test_gain_zero_leaves_the_first_octave(self) -> None:
        for point in self.POINTS:
            self.assertEqual(fbm(Knobs("pcg"), point, 6, 2.0, 0.0, 3), exact_noise(Knobs("pcg"), point, 3))

    def test_two_octaves_by_hand(self) -> None:
        seed, next_seed = 0xFFFFFFFF, 0x9E3779B8
        first = exact_noise(Knobs("pcg"), (0.375, -12.25), seed)
        second = exact_noise(Knobs("pcg"), (0.75 + 0.34375, -24.5 + 0.59375), next_seed)
        self.assertEqual(fbm(Knobs("pcg"), (0.375, -12.25), 2, 2.0, 0.25, seed), (4 * first + second) / 5)
        self.assertEqual(turbulence(Knobs("pcg"), (0.375, -12.25), 2, 2.0, 0.25, seed),
                         (4 * abs(first) + abs(second)) / 5)

    def test_third_axis_is_shifted_too(self) -> None:
        terms = sums.octave_terms(PERLIN, Knobs("pcg"), (1.0, 2.0, 3.0), 2, 2.0, 0.5, 0)
        self.assertEqual(terms[1], (0.5, exact_noise(Knobs("pcg"), (2.34375, 4.59375, 6.71875), 0x9E3779B9)))

    def test_clouds_of_fbm(self) -> None:
        seen = set()
        for seed in range(64):
            t = 2 * fbm(Knobs("pcg"), (0.375, 0.5), 3, 2.0, 0.5, seed) + Fraction(1, 4)
            expected = 0 if t <= 0 else 1 if t >= 1 else 3 * t**2 - 2 * t**3
            self.assertEqual(clouds(Knobs("pcg"), (0.375, 0.5), 3, 2.0, 0.5, seed), expected)
            seen.add("clear" if t <= 0 else "full" if t >= 1 else "between")
        self.assertEqual(seen, {"clear", "full", "between"})

    def test_no_octaves(self) -> None:
        for octaves in (0, -1):
            self.assertEqual(fbm(Knobs("pcg"), (1.5, 2.5), octaves, 2.0, 0.5), 0)
            self.assertEqual(turbulence(Knobs("pcg"), (1.5, 2.5), octaves, 2.0, 0.5), 0)
            self.assertEqual(clouds(Knobs("pcg"), (1.5, 2.5), octaves, 2.0, 0.5), 0.15625)

    def test_ranges(self) -> None:
        numbers = generator_of("ranges")
        for n in (2, 3):
            for _ in range(200):
                arguments = (Knobs("lattice"), [numbers.uniform(-20, 20) for _ in range(n)], 4, 2.0, 0.5,
                             numbers.word())
                self.assertLessEqual(abs(fbm(*arguments)), 1)
                self.assertTrue(abs(fbm(*arguments)) <= turbulence(*arguments) <= 1)
                self.assertTrue(0 <= clouds(*arguments) <= 1)

    def test_ranges_of_the_sine_gradient(self) -> None:
        numbers = generator_of("sine ranges")
        for n in (2, 3):
            for _ in range(50):
                arguments = (Knobs("lattice", sine=True), [numbers.uniform(-20, 20) for _ in range(n)], 4, 2.0, 0.5,
                             numbers.word())
                self.assertTrue(abs(fbm(*arguments)) <= turbulence(*arguments) <= Fraction(n, 2))
                self.assertTrue(0 <= clouds(*arguments) <= 1)

    def test_repeat_after_a_period(self) -> None:
        # With any lacunarity, since it is rounded down.
        for knobs, lacunarity in ((Knobs("lattice"), 2.0), (Knobs("lattice", sine=True), 3.0), (Knobs("lattice"), 1.5)):
            for point in self.POINTS:
                moved = [x - 48 for x in point]
                for function in (fbm, turbulence, clouds):
                    values = [function(knobs, p, 3, lacunarity, 0.5, 3, (48,) * len(p)) for p in (point, moved)]
                    self.assertEqual(*values)
                    values = [function(knobs, p, 3, lacunarity, 0.5, 3) for p in (point, moved)]
                    self.assertTrue(values[0] != values[1] or function is clouds)

    def test_periods_by_hand(self) -> None:
        # The second octave has twice the period along x, and none along y. 2.9 is rounded down.
        seed, next_seed = 0xFFFFFFFF, 0x9E3779B8
        first = exact_noise(Knobs("pcg"), (0.375, -12.25), seed, (5, -5))
        second = exact_noise(Knobs("pcg"), (0.75 + 0.34375, -24.5 + 0.59375), next_seed, (10, 0))
        self.assertEqual(fbm(Knobs("pcg"), (0.375, -12.25), 2, 2.9, 0.25, seed, (5, -5)), (4 * first + second) / 5)

    def test_the_lacunarity_is_cut_with_a_period(self) -> None:
        for lacunarity, same in ((2.9, 2.0), (-1.5, 0.0), (0.75, 0.0), (300.0, 255.0)):
            for function in (fbm, fixed_fbm):
                found = [function(Knobs("pcg"), (0.375, 0.5), 2, x, 0.5, 3, (48, 0)) for x in (lacunarity, same)]
                self.assertEqual(*found)

    def test_seeds_differ(self) -> None:
        self.assertEqual(len({fbm(Knobs("pcg"), (0.375, 0.5), 4, 2.0, 0.5, seed) for seed in range(32)}), 32)


class FixedSums(unittest.TestCase):
    def test_positions(self) -> None:
        table = {
            1.75: (1, 3 * 2**30), -1.75: (-2, 2**30), -1.0: (-1, 0), -0.0: (0, 0), 2.0**-32: (0, 1), 2.0**-33: (0, 0),
            -2.0**-32: (-1, 2**32 - 1), -2.0**-33: (0, 0), -1e-40: (0, 0), -2.0**-21: (-1, 2**32 - 2**11),
            -1 - 2.0**-23: (-2, 2**32 - 2**9), -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), -3.4e38: (-2**31, 0),
        }
        for p, (cell, r) in table.items():
            self.assertEqual(sums.position_of(p), cell * 2**32 + r, p)

    def test_next_position(self) -> None:
        shift = Fraction(11, 32)
        one, third = 2**32, 2**32 // 3
        self.assertEqual(sums.next_position(5 * one, 2 * 2**23, shift), 10 * one + 11 * 2**27)
        self.assertEqual(sums.next_position(-5 * one, 3 * 2**22, Fraction(0)), -7 * one - one // 2)
        self.assertEqual(sums.next_position(-third, 1, Fraction(0)), -171)  # -170.67, rounded down
        self.assertEqual(sums.next_position(2**31 * one - 1, 2**24, Fraction(0)), -2)  # 2^64 - 2, wrapped
        self.assertEqual(sums.next_position(-2**63, 255 * 2**23, shift), -2**63 + 11 * 2**27)
        self.assertEqual(sums.next_position(7 * one, 0, shift), 11 * 2**27)

    def test_weights(self) -> None:
        one = 2**18
        self.assertEqual(sums.weights(3, 0.5), [one, one // 2, one // 4])
        self.assertEqual(sums.weights(3, 0.0), [one, 0, 0])
        self.assertEqual(sums.weights(40, 1.5), [one] * 32)
        self.assertEqual(sums.weights(3, -1.0), [one, 0, 0])
        self.assertEqual((sums.weights(0, 0.5), sums.weights(-1, 0.5)), ([], []))
        # Powers of 0.7, whose 18 bits are 183500: of each product the floor.
        self.assertEqual(sums.weights(4, 0.7), [one, 183500, 183500**2 >> 18, (183500**2 >> 18) * 183500 >> 18])

    def test_weighted_mean(self) -> None:
        one = 2**18
        self.assertEqual(sums.fixed_mean([2**21, -2**20], [one, one // 2]), 2**20)
        self.assertEqual(sums.fixed_mean([-3, 0], [one, one]), -1)  # towards 0
        self.assertEqual(sums.fixed_mean([-3 * 2**20] * 32, [one] * 32), -3 * 2**20)
        self.assertEqual(sums.fixed_mean([], []), 0)
        # The low bits of a weight: 1000 of 2^18 is 1 * 512 + 488, so 2^18 // 512 * 488 is added to 2^18 * 1.
        self.assertEqual(sums.fixed_mean([0, 2**18], [one, 1000]),
                         (2**18 + 2**9 * 488 >> 9) * one // (one + 1000))

    def test_density(self) -> None:
        self.assertEqual([sums.density(v) for v in (-2**21, -2**18, 2**18, 3 * 2**18, 2**21)],
                         [0, 0, 2**20, 2**21, 2**21])
        self.assertEqual(sums.density(0), 5 * 2**16)
        values = []
        for v in range(-2**18, 3 * 2**18 + 1, 11):
            t = Fraction(v + 2**18, 2**20)
            values.append(sums.density(v))
            self.assertLess(abs(Fraction(values[-1], 2**21) - t * t * (3 - 2 * t)), 2.6e-5)
        self.assertEqual(values, sorted(values))

    def test_no_octaves(self) -> None:
        for octaves in (0, -1):
            found = [function(Knobs("pcg"), (1.5, 2.5), octaves, 2.0, 0.5)
                     for function in (fixed_fbm, fixed_turbulence, fixed_clouds)]
            self.assertEqual(found, [0, 0, 0.15625])

    def test_one_octave_is_the_noise_where_nothing_is_cut_off(self) -> None:
        for p in ((0.375, -12.25), (5.125, 7.75, -0.625)):
            self.assertEqual(fixed_fbm(Knobs("lattice"), p, 1, 2.0, 0.5, 3), fixed_noise(Knobs("lattice"), p, 3))
        # Else a position is rounded down, a coordinate of the noise towards 0.
        self.assertEqual(fixed_noise(Knobs("lattice"), (-0.5 - 2.0**-24, 0.25), 3),
                         fixed_noise(Knobs("lattice"), (-0.5, 0.25), 3))
        self.assertEqual(fixed_fbm(Knobs("lattice"), (-0.5 - 2.0**-24, 0.25), 1, 2.0, 0.5, 3),
                         fixed_noise(Knobs("lattice"), (-0.5 - 2.0**-20, 0.25), 3))

    def test_arguments_are_cut(self) -> None:
        p = (0.375, -12.25)
        for octaves, lacunarity, gain, same in ((33, 2.0, 1.0, (32, 2.0, 1.0)), (4, 300.0, 0.5, (4, 255.0, 0.5)),
                                                (4, -2.0, 0.5, (4, 0.0, 0.5)), (4, 2.0, 1.5, (4, 2.0, 1.0)),
                                                (4, 2.0, -0.5, (1, 2.0, 1.0))):
            self.assertEqual(fixed_fbm(Knobs("pcg"), p, octaves, lacunarity, gain), fixed_fbm(Knobs("pcg"), p, *same))

    def test_are_near_the_exact_sums(self) -> None:
        for knobs, n in itertools.product(SETTINGS, (2, 3)):
            numbers = generator_of(str(knobs))
            for gain, octaves in ((0.5, 6), (0.75, 4), (1.0, 3)):
                p = [numbers.integer(-4096, 4096) / 64 for _ in range(n)]
                arguments = (knobs, p, octaves, 2.0, gain, numbers.word())
                for name, limit in (("fbm", 1), ("turbulence", 1), ("clouds", 4)):
                    for periods in ((), (48, 7, 0)[:n]):
                        exact, fixed = (function(PERLIN, *arguments, periods) for function in sums.SUMS[name])
                        self.assertLess(abs(fixed - exact), limit * 2**-15)

    def test_repeat_after_a_period(self) -> None:
        for function in (fixed_fbm, fixed_turbulence, fixed_clouds):
            values = [function(Knobs("lattice"), (x, 7.75), 3, 2.5, 0.5, 3, (48, 0)) for x in (5.125, 5.125 - 96)]
            self.assertEqual(*values)

    def test_a_period_that_is_no_power_of_two_ends_where_a_cell_fits_no_int(self) -> None:
        def repeats(period: int, x: float, octaves: int, lacunarity: float = 3.0) -> bool:
            one, other = (fixed_fbm(Knobs("lattice"), (at, 7.75), octaves, lacunarity, 1.0, 3, (period, period))
                          for at in (x, x + period))
            return one == other

        # 48 * 3^16 = 2066242608 is below 2^31, and with the position of the last octave it is or is not.
        for x, octaves, whole in ((-49.0, 17, True), (1.0, 17, True), (2.0, 17, False)):
            self.assertEqual(repeats(48, x, octaves), whole, (x, octaves))
        # Powers of two repeat up to the octave whose period is 2^31.
        for octaves in (17, 25):
            self.assertTrue(repeats(64, 2.0, octaves, 2.0), octaves)

    def test_periods_keep_their_low_bits(self) -> None:
        # 2^30 * 2 is -2^31, which is none; twice that is 0. 3 * 2^29 * 3 is 2^29 modulo 2^32, a period again.
        self.assertEqual([sums.wrapped(2**30 * 2), sums.wrapped(-2**31 * 2), sums.wrapped(3 * 2**29 * 3)],
                         [-2**31, 0, 2**29])
        found = []
        with mock.patch.object(sums, "Lattice", lambda knobs, seed, periods: found.append(periods) or Lattice(knobs)):
            fixed_fbm(Knobs("lattice"), (0.5, 0.5), 4, 3.0, 0.5, 3, (3 * 2**29, -5))
        self.assertEqual(found, [(3 * 2**29, -5), (2**29, -15), (3 * 2**29, -45), (2**29, -135)])

    def test_the_product_of_a_position_is_exact(self) -> None:
        """95 bits: the largest position and lacunarity, and every low bit set."""
        for position in (2**63 - 1, -2**63, -2**63 + 1, 0x123456789ABCDEF0 | 1):
            for lacunarity in (255 * 2**23, 255 * 2**23 - 1, 2**24 + 1, 1):
                exact = (Fraction(position * lacunarity, 2**23).__floor__() + 2**63) % 2**64 - 2**63
                self.assertEqual(sums.next_position(position, lacunarity, Fraction(0)), exact)

    def test_what_is_no_number_has_no_value(self) -> None:
        for no_number in (float("nan"), float("inf")):
            for p, lacunarity, gain in (((no_number, 0.5), 2.0, 0.5), ((0.25, 0.5), no_number, 0.5),
                                        ((0.25, 0.5), 2.0, no_number)):
                for function in (fbm, fixed_fbm, turbulence, fixed_turbulence, clouds, fixed_clouds):
                    with self.assertRaises((ValueError, OverflowError)):
                        function(Knobs("lattice"), p, 2, lacunarity, gain, 3)

    def test_seeds_step(self) -> None:
        seed, next_seed = 0xFFFFFFFF, 0x9E3779B8
        first = fixed_noise(Knobs("pcg"), (0.375, -12.25), seed)
        second = fixed_noise(Knobs("pcg"), (0.75 + 0.34375, -24.5 + 0.59375), next_seed)
        self.assertLess(abs(fixed_fbm(Knobs("pcg"), (0.375, -12.25), 2, 2.0, 0.25, seed) - (4 * first + second) / 5),
                        2**-20)
