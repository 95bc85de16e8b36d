"""Tests of perlin.py: values by hand and of a C program written from the contract, and what the contract promises."""

from __future__ import annotations

import functools
import itertools
import math
import operator
import unittest
from collections.abc import Iterator, Sequence
from fractions import Fraction
from unittest import mock

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of, to_f32
from proof.oracle import gradients, integers, noises, ramps, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.noises import perlin

PERLIN = noises.find("perlin")

UNIT = 2**20


def exact(*args) -> Fraction:
    value, = PERLIN.exact(*args)
    return value


def units(value: Fraction) -> int:
    """A noise in units of 2^-21."""
    assert (value * 2**21).denominator == 1
    return int(value * 2**21)


@functools.cache
def all_gradients(n: int) -> list[tuple[float, ...]]:
    """All in n dimensions."""
    if n == 1:
        return [gradients.gradient1(field << 14) for field in range(512)]
    return sorted({gradients.OCTAHEDRAL[n](word) for word in range(0, 2**32, 2**20)})


def interpolated_perlin(knobs: Knobs, p: Sequence[float], seed: int, periods: Sequence[int] = ()) -> Fraction:
    """The noise in exact arithmetic too, but as nested interpolations rather than as a weighted sum."""
    cell = [math.floor(x) for x in p]
    f = [Fraction(x) - c for x, c in zip(p, cell)]

    def value(corner: tuple[int, ...]) -> Fraction:
        if len(corner) == len(f):
            point = [c + o for c, o in zip(cell, corner)]
            point = [c % period if period > 0 else c for c, period in zip(point, periods or [0] * len(f))]
            gradient = gradients.gradient(knobs, point, seed)
            return sum(Fraction(g) * (x - o) for g, x, o in zip(gradient, f, corner))
        t = f[len(corner)]
        low, high = value((*corner, 0)), value((*corner, 1))
        return low + (high - low) * t**3 * (t * (t * 6 - 15) + 10)

    return value(()) * perlin.scale(Lattice(knobs), len(f))


class Perlin(unittest.TestCase):
    def samples(self, n: int, count: int = 40) -> Iterator[tuple[Knobs, list[float], int]]:
        """A hash, a point and a seed, some times."""
        numbers = generator_of(f"perlin{n}")
        for name in words.HASHES:
            for _ in range(count):
                yield Knobs(name), [numbers.uniform(-50, 50) for _ in range(n)], numbers.word()

    def test_weighted_sum_is_interpolation(self) -> None:
        for n in (1, 2, 3, 4):
            for sample in self.samples(n, 3):
                self.assertEqual(exact(*sample), interpolated_perlin(*sample))
            for knobs, period in ((Knobs("murmur", sine=True), 0), (Knobs("pcg"), 48),
                                  (Knobs("lattice", sine=True), 7)):
                for _, point, seed in itertools.islice(self.samples(n), 3 if n in (2, 3) or not knobs.sine else 0):
                    self.assertEqual(exact(knobs, point, seed, (period,) * n),
                                     interpolated_perlin(knobs, point, seed, (period,) * n))

    def test_on_a_line_by_hand(self) -> None:
        # The words of the points -3 and -2 with the seed 7; s(1/4) is 106 / 1024, s(1/2) is 1/2.
        a, b = ((2 * (words.point_word("pcg", (c,), 7) >> 14 & 511) - 511) / 512 for c in (-3, -2))
        self.assertEqual(exact(Knobs("pcg"), (-2.5,), 7), (a - b) / 2)
        self.assertEqual(exact(Knobs("pcg"), (-2.75,), 7),
                         2 * (Fraction(a) / 4 * Fraction(918, 1024) - Fraction(b) * 3 / 4 * Fraction(106, 1024)))

    def test_tiny_negative_coordinate(self) -> None:
        # Its fraction has more bits than a double.
        self.assertEqual(PERLIN.exact(Knobs("pcg"), (-2.0**-126, 0.5)),
                         PERLIN.exact_cell(Knobs("pcg"), (-1, 0), (1 - Fraction(1, 2**126), 0.5)))


class Ramps(unittest.TestCase):
    def test_octahedral_ramps(self) -> None:
        # They are exact.
        numbers = generator_of("ramps")
        for n in (1, 2, 3, 4):
            for _ in range(1000):
                h = numbers.word()
                d = [numbers.integer(-UNIT, UNIT) for _ in range(n)]
                exact_ramp = sum(Fraction(g) * Fraction(x, UNIT) for g, x in zip(gradients.OCTAHEDRAL[n](h), d))
                self.assertEqual(Lattice(Knobs("pcg")).fixed_ramp(h, d), exact_ramp * ramps.RAMP_UNITS[n], (n, h, d))

    def test_sine_ramps_are_rounded_down(self) -> None:
        numbers = generator_of("sine ramps")
        for n in (2, 3):
            for _ in range(500):
                g = [numbers.integer(-65536, 65536) for _ in range(n)]
                d = [numbers.integer(-UNIT, UNIT) for _ in range(n)]
                exact_ramp = Fraction(sum(a * b for a, b in zip(g, d)), 2**8)
                self.assertTrue(-n < ramps.sine_ramp(g, d) - exact_ramp <= 0)


class Noise(unittest.TestCase):
    # Of another C program written from the contract: hn_perlin, hn_perlin of cell and fraction.
    POINT, SEED = tuple(map(to_f32, (-12.34375, 5.7, 0.8125))), 0xDEADBEEF
    CELL, FRACTION = (2**31 - 1, -2**31, -7), (0.1875, 1.0, 0.640625)
    SINE_VECTORS = {2: (630731, -259344), 3: (447805, 534313)}

    def test_values_of_a_c_program_with_the_sine_gradient(self) -> None:
        for n, expected in self.SINE_VECTORS.items():
            knobs = Knobs("lattice", sine=True)
            found = (*PERLIN.fixed(knobs, self.POINT[:n], self.SEED),
                     *PERLIN.fixed_cell(knobs, self.CELL[:n], self.FRACTION[:n], 5))
            self.assertEqual(tuple(map(units, found)), expected)

    def test_where_a_difference_wraps(self) -> None:
        # In space, where y and z are whole, corners without a weight have ramps from -2^30 to 2^30. With one of them
        # a unit less nothing wraps, and the value is the same.
        for whole, of_word in ((1, ((0, -1, -1), (0, 1, 1))), (0, ((-1, 0, -1), (1, 0, 1)))):
            found = []
            for ends in ((UNIT, UNIT), (UNIT, UNIT - 1)):
                fraction = list(ends)
                fraction.insert(1 - whole, UNIT // 3)
                with mock.patch.dict(gradients.OCTAHEDRAL, {3: lambda h: of_word[h]}), \
                     mock.patch.object(Lattice, "word", lambda _, corner: corner[1 - whole]):
                    found.append(perlin.fixed(Lattice(Knobs("lattice")), (0, 0, 0), fraction))
            self.assertLess(abs(found[0][0] - found[1][0]), 8)
        self.assertEqual((integers.difference(-2**30, 2**30), integers.difference(-2**30, 2**30 - 1)),
                         (-2**31, 2**31 - 1))

    @in_thorough_runs
    def test_nothing_overflows_and_how_large_it_gets(self) -> None:
        # Whatever the gradients: at each corner the largest ramp there is, of any sign. With the sine gradient it is
        # rounded down, in units of 2^-21: along each axis by less than 8 (see Lerp), in the ramps and at the end by
        # less than 2.
        limits = ((Knobs("lattice"), 1, 2**21), (Knobs("lattice"), 2, 2**21), (Knobs("lattice"), 3, 2**21),
                  (Knobs("lattice"), 4, 2**21), (Knobs("lattice", sine=True), 2, 2**21 + 18),
                  (Knobs("lattice", sine=True), 3, 3 * 2**20 + 26))
        edges = (0, 1, int(0.3268 * UNIT), UNIT // 2 - 1, UNIT // 2, UNIT // 2 + 1, UNIT - 1, UNIT)
        for knobs, n, limit in limits:
            numbers = generator_of(str(knobs))
            for fraction in itertools.product(edges if n < 3 else edges[:5:2] + edges[-1:], repeat=n):
                mixed = [numbers.pick((-1, 1)) for _ in range(2**n)]
                for signs in ([1] * 2**n, [-1] * 2**n, mixed):
                    self.assertLessEqual(abs(self.noise_of_largest_ramps(knobs, fraction, signs)), limit)

    def test_scaling_rounds_to_nearest(self) -> None:
        half = Fraction(1, 2)
        for n, factor in ((1, 2048), (2, 1831), (3, 985), (4, 1906)):
            # All corners alike, there is nothing to interpolate.
            for ramp in (512 * k + low for k in range(-256, 256) for low in (255, 256)):
                with mock.patch.object(perlin, "fixed_ramp", return_value=ramp):
                    value, = perlin.fixed(Lattice(Knobs("lattice")), (0,) * n, (2**18,) * n)
                rounded = math.floor(Fraction(ramp, 512) + half)
                self.assertEqual(value, math.floor(Fraction(rounded * factor, 512) + half), ramp)

    def noise_of_largest_ramps(self, knobs: Knobs, fraction: Sequence[int], signs: Sequence[int]) -> int:
        remaining = iter(signs)
        n = len(fraction)

        def ramp(lattice: Lattice, corner: Sequence[int], d: Sequence[int]) -> int:
            if knobs.sine:
                largest = ramps.sine_ramp([2**16 if x > 0 else -2**16 for x in d], d)
            else:
                slope = max(sum(map(operator.mul, g, d)) for g in all_gradients(n))
                largest = math.floor(slope * ramps.RAMP_UNITS[n] / UNIT)
            return next(remaining) * largest

        with mock.patch.object(perlin, "fixed_ramp", ramp):
            value, = perlin.fixed(Lattice(knobs), (0,) * n, fraction)
        return value

    def test_the_checks_check(self) -> None:
        for check, bad in ((integers.signed, (2**31, -2**31 - 1)), (integers.word, (2**32, -1))):
            for n in bad:
                with self.assertRaises(OverflowError):
                    check(n)
