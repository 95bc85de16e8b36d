"""Tests of hex_rows.py: floats find the corners of every row that they have, and a fault of a function changes a value
of its rows."""

from __future__ import annotations

import functools
import itertools
import math
import unittest
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import read_functions
from proof.golden import hex_rows
from proof.golden.generator import INT_MAX, INT_MIN, Row, generator_of, to_f32
from proof.oracle import functions, hexes, lattice, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice

KNOBS = Knobs("lattice")
FUNCTIONS = {function.name: function for function in read_functions() if function.bound == hex_rows.BOUND}


@functools.cache
def rows(name: str, fixed: bool) -> list[Row]:
    """For every arithmetic, or for fixed arithmetic alone."""
    generator, function = generator_of(f"noise2d.{name}"), FUNCTIONS[name]
    every = hex_rows.plain(function, generator)
    return hex_rows.for_fixed(function, generator) if fixed else every


def values(name: str) -> list[tuple]:
    evaluate = functions.evaluator(FUNCTIONS[name], False)
    return [evaluate(KNOBS, row) for row in rows(name, False)]


def rounded(x: Fraction) -> set[Fraction]:
    """The floats to which a number may be rounded."""
    near = to_f32(float(x))
    step = 2.0**(math.frexp(near)[1] - 24) if near else 2.0**-149
    return {Fraction(near)} if Fraction(near) == x else {Fraction(c) for c in (near - step, near, near + step)}


def fractions_in_floats(row: Row, form: str) -> Iterator[tuple[Fraction, ...]]:
    """The fractions of a cell, or of a position in all roundings with the cell."""
    if form == "cell":
        yield tuple(map(Fraction, row[2:4]))
        return
    yield from itertools.product(*(rounded(Fraction(p) - math.floor(p)) for p in row[:2]))


def found_in_floats(f: Sequence[Fraction]) -> Iterator[tuple]:
    """Which triangle it is, in all roundings: the first corner in skewed coordinates, and the side."""
    for x in rounded(2 * f[0] + f[1]):
        y = 2 * f[1]
        yield math.floor(x), math.floor(y), x - math.floor(x) > y - math.floor(y)


class HexRows(unittest.TestCase):
    def check_floats(self, name: str) -> None:
        """Every rounding finds the corners of the exact place."""
        form = FUNCTIONS[name].form
        for row in rows(name, False):
            exact = row[2:4] if form == "cell" else [p - math.floor(p) for p in map(Fraction, row[:2])]
            corners = hexes.triangle(list(map(Fraction, exact)))[0]
            (i, j), (k, _) = corners[0].skewed, corners[1].skewed
            for f in fractions_in_floats(row, form):
                for found in found_in_floats(f):
                    self.assertEqual(found, (i, j, k > i), row)

    def test_floats_find_the_corners(self) -> None:
        for name in FUNCTIONS:
            self.check_floats(name)

    def test_places_that_are_not_clear_are_found(self) -> None:
        self.addCleanup(rows.cache_clear)
        x = to_f32(0.3)
        for f in ((x, 1 - 2 * x - 2.0**-25), (x / 2 + 2.0**-26, x)):  # X, or u - v, is too near to a whole number
            self.assertEqual(tuple(map(to_f32, f)), f)
            self.assertFalse(hex_rows.is_clear(*f))
            rows.cache_clear()
            with mock.patch.object(hex_rows, "anywhere", lambda generator: f), self.assertRaises(AssertionError):
                self.check_floats("hex_words")

    def assert_noticed(self, names: Sequence[str], module: object, name: str, fault: object) -> None:
        for function in names:
            right = values(function)
            with mock.patch.object(module, name, fault):
                self.assertNotEqual(values(function), right, (function, name))

    def test_ties_matter_to_words(self) -> None:
        right = hexes.triangle

        def other_side(place: Sequence[Fraction]) -> tuple:
            corners, weights = right(place)
            if weights[1] == 0:
                (i, j), (m, n) = corners[0].skewed, corners[1].skewed
                corners[1] = hexes.Corner((2 * i + 1 - m, 2 * j + 1 - n))
            return corners, weights

        self.assert_noticed(("hex_words", "hex_x", "hex_y"), hexes, "triangle", other_side)

    def test_corners_matter(self) -> None:
        right = hexes.triangle

        def moved(at: int) -> Callable:
            def triangle(place: Sequence[Fraction]) -> tuple:
                corners, weights = right(place)
                i, j = corners[at].skewed
                corners[at] = hexes.Corner((i + 1, j))
                return corners, weights
            return triangle

        for at in range(3):
            self.assert_noticed(("hex_words", "hex_x"), hexes, "triangle", moved(at))

        def reordered(place: Sequence[Fraction]) -> tuple:
            corners, (a, b, c) = right(place)
            return corners, [c, b, a]

        self.assert_noticed(("hex_weights",), hexes, "triangle", reordered)

    def test_rows_of_the_lattice_matter(self) -> None:
        def towards_0(corner: hexes.Corner) -> tuple[int, int]:
            i, j = corner.skewed
            return i - int((j + j % 2) / 2 + 0.5 * (j < 0)), j

        def not_shifted(corner: hexes.Corner) -> tuple[int, int]:
            i, j = corner.skewed
            return i - j // 2, j

        for point in (lambda corner: corner.skewed, not_shifted, towards_0):
            self.assert_noticed(("hex_words",), hexes.Corner, "point", property(point))

    def test_periods_matter(self) -> None:
        right = lattice.repeated
        for fault in (lambda c, period: c, lambda c, period: right(words.signed(c), period),
                      lambda c, period: c - period * int(c / period) if period > 0 else c):
            self.assert_noticed(("hex_words",), lattice, "repeated", fault)
        for change in (lambda periods: periods, lambda periods: periods[::-1]):
            def of_triangles(of: Lattice) -> Lattice:
                return replace(of, periods=tuple(2 * period for period in change(of.periods)) if change(of.periods)
                               is not of.periods else of.periods)
            self.assert_noticed(("hex_words",), Lattice, "of_triangles", property(of_triangles))

    def test_rows_have_edges(self) -> None:
        for name, fixed in itertools.product(FUNCTIONS, (False, True)):
            found = rows(name, fixed)
            if FUNCTIONS[name].form == "cell":
                for axis in range(2):
                    self.assertTrue({INT_MIN, INT_MAX, -1, 0} <= {row[axis] for row in found}, (name, axis))
                    self.assertTrue({0, 1, 2, 3, INT_MAX} <= {row[4 + axis] for row in found}, (name, axis))
                    self.assertTrue(fixed or {0.0, 1.0} <= {row[2 + axis] for row in found})
                if fixed:
                    self.assertTrue(any(not 0 <= f <= 1 for row in found for f in row[2:4]))
            else:
                self.assertTrue(all(to_f32(p) == p for row in found for p in row[:2]))
                self.assertTrue(any(max(map(abs, row[:2])) >= (2**31 if fixed else 2**20) for row in found))

    def test_what_fixed_arithmetic_cuts_matters(self) -> None:
        for name in FUNCTIONS:
            exact, fixed = (functions.evaluator(FUNCTIONS[name], arithmetic) for arithmetic in (False, True))
            found = [row for row in rows(name, True)
                     if FUNCTIONS[name].form == "position" or 0 <= min(row[2:4]) <= max(row[2:4]) <= 1]
            self.assertGreater(sum(exact(KNOBS, row) != fixed(KNOBS, row) for row in found), 4, name)
