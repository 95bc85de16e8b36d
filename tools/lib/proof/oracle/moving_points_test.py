"""Tests of moving_points.py: rotations by hand, forwards and backwards, and roundings."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction

from proof.golden.generator import generator_of
from proof.golden.simplex_rows import PHASES
from proof.oracle import moving_points
from proof.oracle.gradients import SINE_ERROR
from proof.oracle.moving_points import backwards, columns, fixed_jitter, forwards, rotated

# With these phases sines and cosines in units of 2^-16 are 65536, and -65536.
LARGEST = tuple(quarter / 4 + beside for quarter in range(-2, 3) for beside in (-2.0**-17, 2.0**-17))


def phases(name: str, count: int = 60) -> list[float]:
    numbers = generator_of(name)
    return [*PHASES, *LARGEST, *(numbers.uniform(-2, 2) for _ in range(count))]


class Forwards(unittest.TestCase):
    def taken(self, phase: float, u: tuple[int, ...]) -> tuple[Fraction, ...]:
        return tuple(sum(a * x for a, x in zip(row, u)) for row in forwards(len(u), phase))

    def test_quarters_by_hand(self) -> None:
        for phase, plane, space in ((0.0, (3, 5), (3, 5, 7)), (0.25, (-5, 3), (7, 3, 5)), (0.5, (-3, -5), (-3, 5, -7)),
                                    (-0.25, (5, -3), (7, -3, -5)), (3.25, (-5, 3), (7, 3, 5))):
            self.assertEqual(self.taken(phase, (3, 5)), plane)
            self.assertEqual(self.taken(phase, (3, 5, 7)), space)

    def test_lengths_stay(self) -> None:
        for n, phase in itertools.product((2, 3), phases("lengths")):
            for i, j in itertools.product(range(n), repeat=2):
                product = sum(row[i] * row[j] for row in forwards(n, phase))
                self.assertLess(abs(product - (i == j)), 8 * SINE_ERROR)

    def test_ways(self) -> None:
        self.assertEqual(moving_points.ways(2, 0.25, Fraction(1, 2)), ((0, -Fraction(7, 16)), (Fraction(7, 16), 0)))
        self.assertEqual(moving_points.ways(3, 0.25, Fraction(1)), tuple(
            tuple(Fraction(25, 32) * x for x in row) for row in ((0, 0, 1), (1, 0, 0), (0, 1, 0))))

    def test_only_in_two_and_three_dimensions(self) -> None:
        for n, of in itertools.product((1, 4), (forwards, backwards)):
            with self.assertRaisesRegex(ValueError, "two and three"):
                of(n, 0.5)


class Backwards(unittest.TestCase):
    def test_by_hand(self) -> None:
        # 65535 / 2 is 32767.5: 32767 * 65535 is 65533.5 times 2^15 with what rounds, -32768 * -65535 is 65535.5 times.
        for phase, plane, space in (
                (0.0, ((65535, 0), (0, 65535)), ((65535, 0, 0), (0, 65533, 0), (0, 0, 65535))),
                (0.25, ((0, 65535), (-65535, 0)), ((0, 65535, 0), (0, 0, 65535), (65533, 0, 0))),
                (0.5, ((-65535, 0), (0, -65535)), ((-65535, 0, 0), (0, 65535, 0), (0, 0, -65535))),
                (-0.25, ((0, -65535), (65535, 0)), ((0, -65535, 0), (0, 0, -65535), (65535, 0, 0)))):
            self.assertEqual((backwards(2, phase), backwards(3, phase)), (plane, space), phase)
        # 46341 is the root of 1/2; 23170 * 46341 is 32767.1 times 2^15, and with 1/2 32767.6.
        c = 46341
        self.assertEqual(backwards(3, 0.125), ((c, c, 0), (-32767, 32767, c), (32767, -32767, c)))
        # Of 3/8 the cosine is negative: -23171 * -46341 is 32768.5, and with 1/2 32769.02. S comes first in SC.
        self.assertEqual(backwards(3, 0.375), ((-c, c, 0), (32767, 32769, c), (32767, 32767, -c)))

    def test_a_product_of_ones(self) -> None:
        # It is 2^31 before it is divided, and with what rounds more.
        self.assertEqual(backwards(3, 2.0**-17), ((65536, 3, 0), (-2, 65536, 3), (0, -2, 65536)))
        self.assertEqual([moving_points.fixed_product(a, b) for a, b in
                          ((65536, 65536), (-65536, -65536), (65536, -65536), (3, 65536), (65536, 3), (3, 3), (-3, 3))],
                         [65536, 65536, -65536, 2, 3, 0, 0])
        for phase in LARGEST:
            self.assertIn(65536, {abs(x) for row in backwards(2, phase) for x in row}, phase)

    def test_is_the_other_way_of_forwards(self) -> None:
        for n, phase in itertools.product((2, 3), phases("ways")):
            for row, exact in zip(backwards(n, phase), columns(forwards(n, phase))):
                for found, x in zip(row, exact):
                    self.assertLess(abs(Fraction(found, 2**16) - x), 2**-13, phase)

    def test_it_makes_nothing_much_shorter(self) -> None:
        # A search takes points beyond its block for farther because of this.
        for n, phase in itertools.product((2, 3), phases("shorter", 300)):
            b = backwards(n, phase)
            for i in range(n):
                off = sum(abs(sum(row[i] * row[j] for row in b) - 2**32 * (i == j)) for j in range(n))
                self.assertLess(off, 2 * 2**32 * 2**-12)

    def test_products_by_hand(self) -> None:
        for e, b, expected in ((-2**19, 65535, -8 * 65535), (-2**19, -46341, 8 * 46341), (300, -3, -2), (300, 3, 0),
                               (-1, 65536, -1), (255, 65536, 255), (-1, 65535, -256 + 254), (2**19, 1, 8)):
            self.assertEqual(rotated(e, b), expected, (e, b))

    def test_products_are_near(self) -> None:
        numbers = generator_of("products")
        for _ in range(300):
            e, b = numbers.integer(-2**21, 2**21), numbers.integer(-2**16, 2**16)
            self.assertTrue(0 <= Fraction(e * b, 2**16) - rotated(e, b) < 2)

    def test_jitters(self) -> None:
        for jitter, plane, space in ((0, 0, 0), (1, 917504, 819200), (Fraction(1, 2**20), 0, 0),
                                     (Fraction(2, 2**20), 1, 1), (Fraction(7, 2**21), 2, 2),
                                     (Fraction(1, 2), 458752, 409600)):
            self.assertEqual((fixed_jitter(2, Fraction(jitter)), fixed_jitter(3, Fraction(jitter))), (plane, space))
