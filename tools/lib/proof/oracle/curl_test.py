"""Tests of curl.py: it consists of derivatives, and has no divergence."""

from __future__ import annotations

import unittest
from fractions import Fraction

from proof.oracle import curl, noises, words
from proof.oracle.curl import CURL
from proof.oracle.testing import FORMS, KNOBS, moved, places, quotient

SIMPLEX_D = noises.find("simplex_d")
SEED = 0xDEADBEEF


def points(n: int, count: int) -> list[list[Fraction]]:
    return [p for p, _ in places("curl", n, count)]


class Curl(unittest.TestCase):
    def test_in_the_plane(self) -> None:
        for p in points(2, 8):
            for form in FORMS:
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
                total = sum(quotient(lambda x: CURL.exact(KNOBS, moved(p, axis, x), SEED)[axis]) for axis in range(n))
                self.assertLess(abs(total), 2**-70)

    def test_products_by_hand(self) -> None:
        # 3.5 * -2 in units of 2^-20, then what the parts below 2^9 add, each rounded down together.
        self.assertEqual(curl.prod(7 * 2**18, -2**20), -7 * 2**20)
        self.assertEqual(curl.prod(2**19 + 5, 2**19 + 7), 2**20 + (1024 * 12 >> 9))
        self.assertEqual(curl.prod(-1, 1), (-1 * 1 + 511 * 0) >> 9)
        self.assertEqual(curl.prod(1, -1), -1)
        self.assertEqual(curl.prod(511, 511), 0)
        self.assertEqual(curl.prod(2**19, 1), 2)

    def test_a_component_is_rounded_to_nearest(self) -> None:
        # In units of 2^-19; those of 2^-16 are multiples of 8. The products are 24 and 23 in units of 2^-20.
        for low, expected in ((12, 16), (11, 8)):
            self.assertEqual(curl.fixed_component((0, 2**19, 0), (0, 0, low), 1, 2), expected)
