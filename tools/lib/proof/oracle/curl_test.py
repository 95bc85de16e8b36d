"""Tests of curl.py: it consists of derivatives, and has no divergence."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX
from proof.oracle import curl, noises, words
from proof.oracle.curl import CURL
from proof.oracle.testing import FORMS, KNOBS, moved, places, quotient

SIMPLEX_D = noises.find("simplex_d")
SEED = 0xDEADBEEF
NO_MOVE = (Fraction(0),) * 3
# In eighths of a cell: of all such places the flow is fastest, or slowest, at some of these. Without the move, too.
EXTREMES = ((0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 0, 4), (0, 1, 4), (0, 2, 4), (0, 2, 5))


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
        for x, y, z in [*points(3, 8), (Fraction(-1, 2), Fraction(1), Fraction(3, 4))]:
            _, ax, ay, az = SIMPLEX_D.exact(KNOBS, (x, y, z), SEED, (3, 0, 5))
            _, bx, by, bz = SIMPLEX_D.exact(KNOBS, (x + Fraction(1, 2), y, z + Fraction(1, 4)), other, (3, 0, 5))
            self.assertEqual(CURL.exact(KNOBS, (x, y, z), SEED, (3, 0, 5)),
                             (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx))

    def test_places_by_hand(self) -> None:
        def of(*f: int) -> tuple[list[int], list[int]]:
            return curl.moved((7, 8, 9), f, 2**20)

        half, step = 2**19, 2**18
        self.assertEqual(of(0, 0, 0), ([7, 8, 9], [half, 0, step]))
        self.assertEqual(of(half - 1, 2**20 - 1, 3 * step - 1), ([7, 8, 9], [2**20 - 1] * 3))
        self.assertEqual(of(half, 5, 3 * step), ([8, 8, 10], [0, 5, 0]))
        self.assertEqual(of(2**20 - 1, 5, 2**20 - 1), ([8, 8, 10], [half - 1, 5, step - 1]))
        self.assertEqual(of(2**20, 5, 2**20), ([8, 8, 10], [half, 5, step]))
        self.assertEqual(curl.moved((0, 0, 0), (Fraction(2, 3), Fraction(1, 3), Fraction(2, 3)), 1),
                         ([1, 0, 0], [Fraction(1, 6), Fraction(1, 3), Fraction(11, 12)]))

    def test_the_end_of_a_cell_is_the_start_of_the_next(self) -> None:
        cell, f = (INT_MAX, 5, -1), (Fraction(5, 8), Fraction(3, 8), Fraction(7, 8))
        for axis, periods in itertools.product(range(3), ((), (1, 2, 3), (INT_MAX,) * 3)):
            for of in (CURL.exact_cell, CURL.fixed_cell):
                end, start = ([end if i == axis else x for i, x in enumerate(f)] for end in (1, 0))
                following = [c + (i == axis) for i, c in enumerate(cell)]
                self.assertEqual(of(KNOBS, cell, end, SEED, periods), of(KNOBS, following, start, SEED, periods))

    def test_behind_the_last_cell_without_a_period_is_the_first(self) -> None:
        for of in (CURL.exact_cell, CURL.fixed_cell):
            found = [of(KNOBS, (cell, 0, cell), (0.75, 0.5, 0.875), SEED) for cell in (INT_MAX, -INT_MAX - 2)]
            self.assertEqual(*found)

    def evenness(self) -> float:
        """The least RMS speed over the greatest, by the place in a cell."""
        squares = [sum(sum(v * v for v in CURL.fixed_cell(KNOBS, (3 * i, 5, 7), [Fraction(x, 8) for x in place], SEED))
                       for i in range(100)) for place in EXTREMES]
        return math.sqrt(min(squares) / max(squares))

    def test_it_is_as_fast_everywhere(self) -> None:
        # On average over all cells it is 0.335, and 0.045 without the move.
        self.assertGreater(self.evenness(), 0.25)
        with mock.patch.object(curl, "MOVE", NO_MOVE):
            self.assertLess(self.evenness(), 0.06)

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
