"""Tests of perlin.py: values by hand and of a C program written from the contract, and what the contract promises."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
from fractions import Fraction
from unittest import mock

from golden import rows
from golden.rows import generator_of
from oracle import gradients, integers, noises, sums, words
from oracle.cells import smooth
from oracle.gradients import Knobs
from oracle.noises import perlin

PERLIN = noises.find("perlin")

UNIT = 2**20

SETTINGS = (Knobs("lattice"), Knobs("fnv1"), Knobs("lattice", period=48), Knobs("lattice", sine=True))


def units(value: Fraction) -> int:
    """A noise in units of 2^-21."""
    assert (value * 2**21).denominator == 1
    return int(value * 2**21)


def interpolated_perlin(knobs: Knobs, p: Sequence[float], seed: int) -> Fraction:
    """The noise in exact arithmetic too, but as nested interpolations rather than as a weighted sum."""
    cell = [math.floor(x) for x in p]
    f = [Fraction(x) - c for x, c in zip(p, cell)]

    def value(corner: tuple[int, ...]) -> Fraction:
        if len(corner) == len(f):
            gradient = gradients.gradient(knobs, [c + o for c, o in zip(cell, corner)], seed)
            return sum(Fraction(g) * (x - o) for g, x, o in zip(gradient, f, corner))
        t = f[len(corner)]
        low, high = value((*corner, 0)), value((*corner, 1))
        return low + (high - low) * t**3 * (t * (t * 6 - 15) + 10)

    return value(()) * perlin.scale(knobs, len(f))


class Perlin(unittest.TestCase):
    def samples(self, n: int, count: int = 40):
        """A hash, a point and a seed, some times."""
        numbers = generator_of(f"perlin{n}")
        for name in words.HASHES:
            for _ in range(count):
                yield Knobs(name), [numbers.uniform(-50, 50) for _ in range(n)], numbers.word()

    def test_zero_at_lattice_points(self) -> None:
        for knobs, n in itertools.product(map(Knobs, words.HASHES), (2, 3)):
            for point in itertools.product((-2**22, -3, 0, 7), repeat=n):
                self.assertEqual(PERLIN.exact(knobs, point, 5), 0)

    def test_weighted_sum_is_interpolation(self) -> None:
        for n in (2, 3):
            for sample in self.samples(n, 5):
                self.assertEqual(PERLIN.exact(*sample), interpolated_perlin(*sample))
            for knobs in (Knobs("murmur", sine=True), Knobs("pcg", period=48), Knobs("lattice", sine=True, period=7)):
                for _, point, seed in itertools.islice(self.samples(n), 3):
                    self.assertEqual(PERLIN.exact(knobs, point, seed), interpolated_perlin(knobs, point, seed))

    def test_tiny_negative_coordinate(self) -> None:
        # Its fraction has more bits than a double.
        self.assertEqual(PERLIN.exact(Knobs("pcg"), (-2.0**-126, 0.5)),
                         PERLIN.exact_cell(Knobs("pcg"), (-1, 0), (1 - Fraction(1, 2**126), 0.5)))

    def test_within_range_and_not_flat(self) -> None:
        for n in (2, 3):
            values = [PERLIN.exact(*sample) for sample in self.samples(n)]
            self.assertLessEqual(max(map(abs, values)), 1)
            self.assertGreater(max(values), 0.5)
            self.assertLess(min(values), -0.5)

    def test_range_of_the_sine_gradient(self) -> None:
        for n in (2, 3):
            values = [PERLIN.exact(Knobs("lattice", sine=True), point, seed) for _, point, seed in self.samples(n)]
            self.assertLessEqual(max(map(abs, values)), Fraction(n, 2))
            self.assertGreater(max(values), 0.5)
            self.assertLess(min(values), -0.5)
        self.assertEqual([perlin.scale(Knobs("lattice", sine=True), n) for n in (2, 3)], [1, 1])

    def test_noise_repeats_after_a_period(self) -> None:
        for n in (2, 3):
            for knobs in (Knobs("lattice", period=48), Knobs("fnv1", sine=True, period=2**20), Knobs("pcg", period=1)):
                for _, point, seed in itertools.islice(self.samples(n), 5):
                    moved = [Fraction(x) + factor * knobs.period for x, factor in zip(point, (-3, 1, 2))]
                    self.assertEqual(PERLIN.exact(knobs, point, seed), PERLIN.exact(knobs, moved, seed))

    def test_scale_is_the_largest_that_stays_within_range(self) -> None:
        # On |x| + |y| (+ |z|) = 1 a ramp is at most the largest component of f - o. Its weighted mean, largest over
        # the cell, times the scale, is just below 1, and with the next larger multiple of 1/1024 it is above.
        grid = [Fraction(i, 32) for i in range(17)]  # the other half is its mirror image
        near = [Fraction(x) for x in (0.3268, 0.3491, 0.5)]  # the maxima, found by a finer search
        for n, scale in perlin.OCTAHEDRAL_SCALES.items():
            bound = max(self.weighted_bound(f) for axis in (grid, near) for f in itertools.product(axis, repeat=n))
            self.assertLess(bound * scale, 1)
            self.assertGreater(bound * (scale + Fraction(1, 1024)), 1)

    def weighted_bound(self, fraction: Sequence[Fraction]) -> Fraction:
        total = Fraction(0)
        for corner in itertools.product((0, 1), repeat=len(fraction)):
            weight = math.prod(smooth(f) if o else 1 - smooth(f) for f, o in zip(fraction, corner))
            total += weight * max(abs(f - o) for f, o in zip(fraction, corner))
        return total

    def test_cells_meet(self) -> None:
        # f = 1 in one cell is f = 0 in the next, also where the cells wrap.
        for n in (2, 3):
            numbers = generator_of("meet")
            settings = (*map(Knobs, words.HASHES), Knobs("lattice", sine=True), Knobs("lattice", period=48),
                        Knobs("fnv1", sine=True, period=48))
            for knobs, axis, cell in itertools.product(settings, range(n), (-1, 0, 47, 2**31 - 1)):
                if knobs.period and cell == 2**31 - 1:
                    continue  # 48 does not divide 2^32: see test_the_period_goes_on_to_the_last_cell
                cells = [cell] * n
                fraction = [numbers.uniform(0, 1) for _ in range(n)]
                ones = [1.0 if i == axis else f for i, f in enumerate(fraction)]
                zeros = [0.0 if i == axis else f for i, f in enumerate(fraction)]
                following = [-2**31 if i == axis and c == 2**31 - 1 else c + (i == axis) for i, c in enumerate(cells)]
                self.assertEqual(PERLIN.exact_cell(knobs, cells, ones, 9),
                                 PERLIN.exact_cell(knobs, following, zeros, 9))

    def test_continuous(self) -> None:
        step = 2.0**-18
        for n in (2, 3):
            for knobs, point, seed in self.samples(n, 5):
                for axis in range(n):
                    border = [math.floor(x) if i == axis else x for i, x in enumerate(point)]
                    before = [x - step if i == axis else x for i, x in enumerate(border)]
                    difference = PERLIN.exact(knobs, border, seed) - PERLIN.exact(knobs, before, seed)
                    self.assertLess(abs(difference), 8 * step)

    def test_point_is_cell_and_fraction(self) -> None:
        self.assertEqual(PERLIN.exact(Knobs("pcg"), (-1.25, 3.5), 7),
                         PERLIN.exact_cell(Knobs("pcg"), (-2, 3), (0.75, 0.5), 7))
        self.assertEqual(PERLIN.exact(Knobs("pcg"), (-1.25, 3.5)), PERLIN.exact(Knobs("pcg"), (-1.25, 3.5), 0))

    def test_seeds_differ(self) -> None:
        for knobs in map(Knobs, words.HASHES):
            self.assertEqual(len({PERLIN.exact(knobs, (0.375, 0.5), seed) for seed in range(32)}), 32, knobs)
            self.assertEqual(len({PERLIN.exact(knobs, (0.375, 0.5, 0.25), seed) for seed in range(32)}), 32, knobs)


class Ramps(unittest.TestCase):
    def test_octahedral_ramps_are_exact(self) -> None:
        numbers = generator_of("ramps")
        for _ in range(1000):
            h = numbers.word()
            d = [numbers.integer(-UNIT, UNIT) for _ in range(3)]
            for ramp, gradient in ((perlin.ramp2, gradients.gradient2(h)), (perlin.ramp3, gradients.gradient3(h))):
                exact = sum(Fraction(g) * Fraction(x, UNIT) for g, x in zip(gradient, d))
                self.assertEqual(Fraction(ramp(h, d), 2**29), exact)

    def test_sine_ramps_are_rounded_down(self) -> None:
        numbers = generator_of("sine ramps")
        for n in (2, 3):
            for _ in range(500):
                g = [numbers.integer(-65536, 65536) for _ in range(n)]
                d = [numbers.integer(-UNIT, UNIT) for _ in range(n)]
                exact = Fraction(sum(a * b for a, b in zip(g, d)), 2**8)
                self.assertTrue(-n < perlin.sine_ramp(g, d) - exact <= 0)


class Noise(unittest.TestCase):
    # Of a C program written from the contract: hn_perlin, hn_perlin of cell and fraction, fBm, turbulence, clouds.
    POINT, SEED = tuple(map(rows.to_f32, (-12.34375, 5.7, 0.8125))), 0xDEADBEEF
    CELL, FRACTION = (2**31 - 1, -2**31, -7), (0.1875, 1.0, 0.640625)
    VECTORS = {
        (Knobs("lattice"), 2): (655546, -229145, 217300, 486364, 914360),
        (Knobs("lattice"), 3): (-333911, 226917, -457540, 576775, 0),
        (Knobs("fnv1"), 2): (-313224, 353789, 559406, 785310, 1844763),
        (Knobs("fnv1"), 3): (178425, 520881, -74033, 202715, 178240),
        (Knobs("lattice", period=48), 2): (1124504, -554878, 689959, 750933, 2047151),
        (Knobs("lattice", period=48), 3): (-585668, -541472, -299874, 366881, 0),
        (Knobs("lattice", sine=True), 2): (485426, -449071, 271937, 378773, 1077948),
        (Knobs("lattice", sine=True), 3): (779366, -395129, 337937, 439251, 1274365),
    }

    def test_values_of_a_c_program(self) -> None:
        lacunarity, gain = rows.to_f32(1.9), rows.to_f32(0.7)
        for (knobs, n), expected in self.VECTORS.items():
            octave_sums = [fixed(PERLIN, knobs, self.POINT[:n], 5, lacunarity, gain, self.SEED)
                           for _, fixed in sums.SUMS.values()]
            found = [PERLIN.fixed(knobs, self.POINT[:n], self.SEED),
                     PERLIN.fixed_cell(knobs, self.CELL[:n], self.FRACTION[:n], 5), *octave_sums]
            self.assertEqual(tuple(map(units, found)), expected, (knobs, n))

    def test_is_near_the_exact_noise(self) -> None:
        for knobs, n in itertools.product((*SETTINGS, Knobs("fnv1", sine=True, period=1048576)), (2, 3)):
            numbers = generator_of(str(knobs))
            for _ in range(40):
                # Multiples of 2^-20: nothing is cut off.
                p = [Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(n)]
                seed = numbers.seed()
                self.assertLess(abs(PERLIN.fixed(knobs, p, seed) - PERLIN.exact(knobs, p, seed)), 2**-15)

    def test_zero_at_lattice_points(self) -> None:
        for knobs, n in itertools.product(SETTINGS, (2, 3)):
            for c in (-3.0, 0.0, -0.0, 2.0**23, -2.0**31, 3e38):
                self.assertEqual(PERLIN.fixed(knobs, (c,) * n, 5), 0)

    def test_values_are_floats(self) -> None:
        numbers = generator_of("floats")
        for knobs, n in itertools.product(SETTINGS, (2, 3)):
            for _ in range(20):
                value = PERLIN.fixed(knobs, rows.anywhere(n, numbers), numbers.word())
                self.assertEqual(rows.to_f32(float(value)), value)

    def test_nothing_overflows_and_how_large_it_gets(self) -> None:
        # Whatever the gradients: at each corner the largest ramp there is, of any sign.
        cases = ((Knobs("lattice"), 2, 2**21), (Knobs("lattice"), 3, 2**21),
                 # It is rounded down, in units of 2^-21: along each axis by less than 8 (see Lerp), in the ramps and at
                 # the end by less than 2.
                 (Knobs("lattice", sine=True), 2, 2**21 + 18), (Knobs("lattice", sine=True), 3, 3 * 2**20 + 26))
        edges = (0, 1, int(0.3268 * UNIT), int(0.3491 * UNIT), UNIT // 2 - 1, UNIT // 2, UNIT // 2 + 1, UNIT - 1, UNIT)
        for knobs, n, limit in cases:
            numbers = generator_of(str(knobs))
            for fraction in itertools.product(edges, repeat=n):
                mixed = [numbers.pick((-1, 1)) for _ in range(2**n)]
                for signs in ([1] * 2**n, [-1] * 2**n, mixed):
                    self.assertLessEqual(abs(self.noise_of_largest_ramps(knobs, fraction, signs)), limit)

    def test_scaling_rounds_to_nearest(self) -> None:
        half = Fraction(1, 2)
        for n, factor in ((2, 1913), (3, 1819)):
            # All corners alike, there is nothing to interpolate. 512 steps of the first rounding meet all ends of the
            # second: both factors are odd.
            for ramp in (512 * k + low for k in range(-256, 256) for low in (255, 256)):
                with mock.patch.object(perlin, "corner_ramp", return_value=ramp):
                    value = perlin.fixed(Knobs("lattice"), (0,) * n, (2**18,) * n, 0)
                rounded = math.floor(Fraction(ramp, 512) + half)
                self.assertEqual(value, math.floor(Fraction(rounded * factor, 512) + half), ramp)

    def noise_of_largest_ramps(self, knobs: Knobs, fraction: Sequence[int], signs: Sequence[int]) -> int:
        remaining = iter(signs)

        def ramp(knobs: Knobs, corner: Sequence[int], d: Sequence[int], seed: int) -> int:
            largest = perlin.sine_ramp([2**16 if x > 0 else -2**16 for x in d], d) if knobs.sine else 512 * max(
                map(abs, d))
            return next(remaining) * largest

        with mock.patch.object(perlin, "corner_ramp", ramp):
            return perlin.fixed(knobs, (0,) * len(fraction), fraction, 0)

    def test_the_checks_check(self) -> None:
        for check, bad in ((integers.signed, (2**31, -2**31 - 1)), (integers.word, (2**32, -1))):
            for n in bad:
                with self.assertRaises(OverflowError):
                    check(n)
