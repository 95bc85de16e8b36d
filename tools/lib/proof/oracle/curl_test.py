"""Tests of curl.py: by the derivatives of which it is made, and that it has no divergence."""

from __future__ import annotations

import unittest
from fractions import Fraction

from proof.golden.generator import generator_of
from proof.oracle import curl, noises, words
from proof.oracle.curl import CURL
from proof.oracle.gradients import Knobs
from proof.oracle.integers import SLOPE_UNIT, UNIT
from proof.oracle.slopes_test import quotient

KNOBS = Knobs("lattice")
SIMPLEX_D = noises.find("simplex_d")
SEED = 0xDEADBEEF


def points(n: int, count: int) -> list[list[Fraction]]:
    numbers = generator_of(f"curl{n}")
    return [[Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(n)] for _ in range(count)]


class Curl(unittest.TestCase):
    def test_in_the_plane(self) -> None:
        for p in points(2, 8):
            for form in ("exact", "fixed"):
                _, dx, dy = getattr(SIMPLEX_D, form)(KNOBS, p, SEED, (3, 0))
                self.assertEqual(getattr(CURL, form)(KNOBS, p, SEED, (3, 0)), (dy, -dx))

    def test_in_space(self) -> None:
        other = words.mix(0xDEADBEEF + 0x9E3779B9 - 2**32)
        for p in points(3, 8):
            (_, ax, ay, az), (_, bx, by, bz) = (SIMPLEX_D.exact(KNOBS, p, seed, (3, 0, 5)) for seed in (SEED, other))
            self.assertEqual(CURL.exact(KNOBS, p, SEED, (3, 0, 5)),
                             (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx))

    def test_it_has_no_divergence(self) -> None:
        for n in (2, 3):
            for p in points(n, 3):
                total = Fraction(0)
                for axis in range(n):
                    def component(x: Fraction, axis: int = axis) -> Fraction:
                        return CURL.exact(KNOBS, [*p[:axis], x, *p[axis + 1:]], SEED)[axis]

                    total += quotient(component, p[axis], Fraction(1, 2**26))
                self.assertLess(abs(total), 2**-70)

    def test_products_by_hand(self) -> None:
        # 3.5 * -2 in units of 2^-20, then what the parts below 2^9 add, each rounded down together.
        self.assertEqual(curl.prod(7 * 2**18, -2**20), -7 * 2**20)
        self.assertEqual(curl.prod(2**19 + 5, 2**19 + 7), 2**20 + (1024 * 12 >> 9))
        self.assertEqual(curl.prod(-1, 1), (-1 * 1 + 511 * 0) >> 9)
        self.assertEqual(curl.prod(1, -1), -1)
        self.assertEqual(curl.prod(511, 511), 0)
        self.assertEqual(curl.prod(2**19, 1), 2)

    def test_products_are_near(self) -> None:
        numbers = generator_of("products")
        for _ in range(1000):
            a, b = (numbers.integer(-2**22, 2**22) for _ in range(2))
            self.assertTrue(-2 < curl.prod(a, b) - Fraction(a * b, 2**18) <= 0)

    def test_a_component_is_rounded_to_nearest(self) -> None:
        # In units of 2^-19; those of 2^-16 are multiples of 8. The products are 24 and 23 in units of 2^-20.
        for low, expected in ((12, 16), (11, 8)):
            self.assertEqual(curl.fixed_component((0, 2**19, 0), (0, 0, low), 1, 2), expected)

    def test_fixed_arithmetic_is_near(self) -> None:
        for n in (2, 3):
            for p in points(n, 30):
                for exact, fixed in zip(CURL.exact(KNOBS, p, SEED), CURL.fixed(KNOBS, p, SEED), strict=True):
                    self.assertLess(abs(exact - fixed), 2**-7)
                    self.assertEqual((fixed * (SLOPE_UNIT if n == 2 else 2**16)).denominator, 1)
