"""Tests of uniform_rows.py: the rows have the edges, floats find the side of each, and a fault of a function changes a
value of its rows."""

from __future__ import annotations

import functools
import math
import operator
import unittest
from collections.abc import Callable, Iterator
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import read_functions
from proof.golden import uniform_rows
from proof.golden.generator import INT_MAX, INT_MIN, Row, generator_of, to_f32
from proof.oracle import functions, uniform
from proof.oracle.sums import clamped

FUNCTIONS = {function.name: function for function in read_functions() if function.file == "uniform"}


@functools.cache
def rows(name: str, fixed: bool = False) -> list[Row]:
    """For every arithmetic, or with fixed arithmetic."""
    generator = generator_of(f"uniform.{name}")
    every = uniform_rows.plain(FUNCTIONS[name], generator)
    return every + uniform_rows.for_fixed(FUNCTIONS[name], generator) if fixed else every


def values(name: str, fixed: bool) -> Iterator[tuple]:
    evaluate = functions.evaluator(FUNCTIONS[name], fixed)
    return (evaluate(None, row) for row in rows(name, fixed))


@functools.cache
def right(name: str, fixed: bool) -> list[tuple]:
    return list(values(name, fixed))


def spreads(name: str) -> set[tuple[float, ...]]:
    return {row[1:] if FUNCTIONS[name].form == "spread_value" else row[:4] for row in rows(name)}


class UniformRows(unittest.TestCase):
    def test_all_is_floats(self) -> None:
        for name, fixed in (("uniform", False), ("uniform_d", True), ("spread_fbm", True)):
            self.assertTrue(all(to_f32(x) == x for row in rows(name, fixed) for x in row), name)

    def test_every_noise_is_there(self) -> None:
        self.assertLessEqual({*range(-1, len(uniform.TABLE) + 2), INT_MAX, INT_MIN}, {row[0] for row in rows("spread")})
        for name in ("uniform", "uniform_d", "spread_fbm"):
            self.assertLessEqual({uniform.spread(number) for number in uniform_rows.NOISES}, spreads(name))

    def test_spreads_are_out_of_range_and_out_of_order(self) -> None:
        for name in ("uniform", "uniform_d", "spread_fbm"):
            found = spreads(name)
            for wrong in (lambda reach, a, b, c: reach < 0, lambda reach, a, b, c: 0 < reach < 0.0625,
                          lambda reach, a, b, c: reach > 3, lambda reach, a, b, c: a > b > c > 0,
                          lambda reach, a, b, c: min(a, b, c) < 0, lambda reach, a, b, c: max(a, b, c) > 1):
                self.assertGreater(sum(wrong(*of) for of in found), 0, name)

    def test_values_are_at_both_ends_and_beside_them(self) -> None:
        for of in (uniform.spread(9), uniform_rows.EDGES[0], uniform_rows.EDGES[6]):
            at = [row[0] for row in rows("uniform") if row[1:] == of]
            for x in (of[0], 3.0, 2.0**-149):
                self.assertLessEqual({x, -x}, {*at})
            self.assertEqual({math.copysign(1, x) for x in at if x == 0}, {1, -1})
            self.assertTrue(any(of[0] < x < of[0] * (1 + 2.0**-22) for x in at))
            self.assertTrue(any(of[0] * (1 - 2.0**-22) < x < of[0] for x in at))

    def test_octaves_and_gains_have_edges(self) -> None:
        octaves, gains = ({row[i] for row in rows("spread_fbm")} for i in (4, 5))
        self.assertLessEqual({1.0, 2.0, 32.0, 0.5, -7.0, 32.5}, octaves)
        self.assertLessEqual({0.0, 1.0, 2.0**-149, 1.5, -0.5}, gains)
        self.assertGreater(sum(x % 1 > 0 for x in octaves), 20)

    def assert_noticed(self, name: str, fixed: bool, attribute: str, fault: object) -> None:
        expected = right(name, fixed)
        with mock.patch.object(uniform, attribute, fault):
            self.assertTrue(any(map(operator.ne, values(name, fixed), expected)), (name, fixed, attribute))

    def test_ranges_matter(self) -> None:
        for name in ("uniform", "uniform_d", "spread_fbm"):
            for limit, other in (("LEAST_REACH", Fraction(1, 32)), ("LARGEST_REACH", 4)):
                for fixed in (False, True):
                    self.assert_noticed(name, fixed, limit, other)

            def in_any_order(reach: float, a: float, b: float, c: float) -> tuple[Fraction, ...]:
                return (clamped(reach, uniform.LEAST_REACH, uniform.LARGEST_REACH),
                        *(clamped(x, 0, 1) for x in (a, b, c)))

            def fixed_in_any_order(unit: int, *spread: float) -> tuple[int, ...]:
                return tuple(math.trunc(x * unit) for x in in_any_order(*spread))

            self.assert_noticed(name, False, "in_range", in_any_order)
            self.assert_noticed(name, True, "fixed_in_range", fixed_in_any_order)
        for fixed in (False, True):  # with a larger limit sums still have no more than 32 octaves
            self.assert_noticed("spread_fbm", fixed, "MOST_OCTAVES", 31)

    def test_constants_matter(self) -> None:
        for fixed in (False, True):
            for attribute in ("BELL", "WAY", "VARIANCE"):
                numbers = getattr(uniform, attribute)
                for i in range(len(numbers)):
                    other = tuple(x + (i == j) for j, x in enumerate(numbers))
                    self.assert_noticed("spread_fbm", fixed, attribute, other)
        for i in range(len(uniform.TABLE)):
            other = tuple((*of[:3], of[3] + (i == j)) for j, of in enumerate(uniform.TABLE))
            self.assert_noticed("spread", False, "TABLE", other)
        self.assert_noticed("spread", False, "PERLIN2", 8)

    def test_roundings_of_fixed_arithmetic_matter(self) -> None:
        def product(a: int, b: int) -> int:
            return int(Fraction(a * b, 2**18))  # towards 0

        def near(a: int, b: int) -> int:
            return (a * b + 2**17) >> 18

        def quotient(x: int, t: int) -> int:
            return (x * 2**18 + t // 2) // t

        def mix(p: int, q: int, y: int) -> int:
            return p - uniform.product(p - q, y)  # rounded up

        faults: tuple[tuple[str, str, Callable], ...] = (
            ("uniform", "product", near), ("uniform", "quotient", quotient), ("uniform", "mix", mix),
            ("uniform_d", "quotient", quotient), ("spread_fbm", "product", product), ("spread_fbm", "product", near),
            ("spread_fbm", "quotient", quotient))
        for name, attribute, fault in faults:
            self.assert_noticed(name, True, attribute, fault)
