"""Tests of gullies_rows.py: every edge is there, and rows are where their values are defined and bounded."""

from __future__ import annotations

import itertools
import math
import unittest
from unittest import mock

from catalog.tables.configurations import read_configurations
from catalog.tables.functions import Function, read_functions
from proof.golden import gullies_rows, sum_rows
from proof.golden.files import golden_files
from proof.golden.generator import INT_MAX, INT_MIN, Row, generator_of, to_f32
from proof.golden.rows import FIXED_COORDINATES
from proof.oracle import functions, gullies, jacobians, sums
from proof.oracle.gradients import Knobs
from proof.oracle.integers import signed

KNOBS = Knobs("lattice")
GULLIES = [function for function in read_functions() if function.bound == gullies_rows.BOUND]
ROWS = {function.id: (gullies_rows.plain(function, generator_of(function.id)),
                      gullies_rows.fixed(function, FIXED_COORDINATES, generator_of(function.id)))
        for function in GULLIES}


def of_row(function: Function, row: Row) -> dict[str, float]:
    return dict(zip(function.settings, row[-1 - len(function.settings):-1]))


def evaluated(function: Function, row: Row, fixed: bool) -> tuple:
    return functions.evaluator(function, fixed)(KNOBS, row)


class Rows(unittest.TestCase):
    def test_there_are_four_functions_with_two_settings(self) -> None:
        self.assertEqual(len(GULLIES), 4)
        for file in golden_files(GULLIES, read_configurations()):
            self.assertEqual([values.name for values in file.values], ["lattice", "lattice+fixed"])
            self.assertTrue(90 <= len(ROWS[file.function.id][0]) <= 140)

    def test_every_edge_is_there(self) -> None:
        for function in GULLIES:
            for rows, slopes, depths, footprints in zip(
                    ROWS[function.id], (gullies_rows.SLOPES, gullies_rows.CUT),
                    ([depth for depth, _ in gullies_rows.DEPTHS], gullies_rows.FIXED_DEPTHS),
                    (gullies_rows.FOOTPRINTS, gullies_rows.FIXED_FOOTPRINTS)):
                found = [of_row(function, row) for row in rows]
                self.assertLessEqual(set(slopes), {(of["ex"], of["ey"]) for of in found}, function.id)
                self.assertLessEqual(set(map(to_f32, depths)), {of["depth"] for of in found})
                if "footprint" in function.settings:
                    self.assertLessEqual(set(map(to_f32, footprints)), {of["footprint"] for of in found})
            plain, of_fixed = ([of_row(function, row) for row in rows] for rows in ROWS[function.id])
            self.assertLessEqual({-1, 0, 1, 2, 3, 4, 6}, {of["octaves"] for of in plain})
            self.assertLessEqual({-1, 0, 1, 31, 32, 33, INT_MAX}, {of["octaves"] for of in of_fixed})
            self.assertLessEqual({2, 2.5, 2.96875, 0, 0.5, -1.5, 1, 255, 300}, {of["lacunarity"] for of in plain})
            self.assertLessEqual({0, 0.5, 1, 1.5}, {of["gain"] for of in plain})
            self.assertLessEqual(set(map(to_f32, sum_rows.GAINS)) - {1, 1.5}, {of["gain"] for of in of_fixed})

    def test_places_reach_every_edge(self) -> None:
        for function in GULLIES:
            plain, of_fixed = ROWS[function.id]
            if not function.has_cell:
                self.assertLessEqual(set(FIXED_COORDINATES), {row[0] for row in of_fixed})
                self.assertTrue(any(row[0] < 0 and row[0] % 1 for row in plain))
                continue
            for axis in range(2):
                cells = {row[axis] for row in plain}
                self.assertLess({INT_MIN, INT_MAX}, {row[axis] for row in plain + of_fixed})
                self.assertTrue(any(-8 < c < 0 for c in cells) and any(abs(c) > 2**26 for c in cells))
                self.assertLess({0, 1, 1 - 2.0**-24}, {row[2 + axis] for row in plain})
                self.assertLessEqual(set(sum_rows.FIXED_FRACTIONS), {row[2 + axis] for row in of_fixed})
                seams = {(row[axis], row[4 + axis]) for row in plain}
                for period in (2, 3, 5, 7):
                    self.assertTrue({0, period - 1} & {c % period for c, of in seams if of == period}, (axis, period))

    def test_floats_have_few_octaves_and_turn_slopes_little(self) -> None:
        for function in GULLIES:
            found = [of_row(function, row) for row in ROWS[function.id][0]]
            self.assertGreater(sum(of["octaves"] <= 3 for of in found), 0.8 * len(found))
            for of in found:
                depth = min(max(of["depth"], 0), 8)
                growths = gullies_rows.growths(of["octaves"], of["lacunarity"], of["gain"])
                self.assertTrue(of["octaves"] <= 1 or depth <= to_f32(0.2), of)
                self.assertTrue(max(growths, default=0) <= 3 and len(growths) <= 6, of)

    def test_octaves_of_floats_are_in_the_domain(self) -> None:
        for function in GULLIES:
            for row in ROWS[function.id][0]:
                of, n = of_row(function, row), 4 if function.has_cell else 2
                place = sums.in_cell(row[:2], row[2:4]) if function.has_cell else sums.at_position(row[:2])
                options = gullies.whole(sums.Options(of["octaves"], of["lacunarity"], of["gain"]))
                periods = row[n:n + 2] if function.has_period else gullies.NOTHING
                for i, (q, p, _) in enumerate(sums.octaves_of(place, options, 0, periods)):
                    self.assertTrue(all(-2**31 <= x <= 2**31 - (i > 0) for x in q), row)
                    self.assertTrue(all(period < 2**31 for period in p), row)
                    if not function.has_cell:
                        self.assertTrue(max(map(abs, q)) < 2**15)

    def test_slopes_of_fixed_arithmetic_keep_to_what_their_bounds_are_for(self) -> None:
        """The contract has a limit, and within these rows no integer wraps."""
        for function in GULLIES:
            largest = 0
            for row in [row for rows in ROWS[function.id] for row in rows]:
                of = of_row(function, row)
                growth = max(gullies_rows.growths(of["octaves"], of["lacunarity"], of["gain"]), default=0)
                self.assertLessEqual(growth, gullies_rows.LARGEST_GROWTH)
                largest = max(largest, growth * min(max(of["depth"], 0), 8))
            self.assertTrue(63 < largest <= 64, largest)

    def test_nothing_wraps(self) -> None:
        for turn, function in enumerate(GULLIES):
            rows = [row for rows in ROWS[function.id] for row in rows][turn::8]
            for row in rows:
                right = evaluated(function, row, True)
                with mock.patch.object(jacobians, "wrapped", signed), mock.patch.object(gullies, "wrapped", signed):
                    self.assertEqual(evaluated(function, row, True), right, row)

    def assert_seen(self, fixed: bool, name: str, other: object, least: int = 1) -> None:
        """So many rows of each function have other values."""
        for function in GULLIES:
            seen = 0
            for row in ROWS[function.id][0]:
                if seen < least:
                    right = evaluated(function, row, fixed)
                    with mock.patch.object(gullies, name, other):
                        seen += any(abs(a - b) > 2**-9 for a, b in zip(right, evaluated(function, row, fixed)))
            self.assertEqual(seen, least, (function.id, name))

    def test_rows_see_what_is_clamped(self) -> None:
        for fixed in (False, True):
            self.assert_seen(fixed, "LARGEST_SLOPE", 12)
            self.assert_seen(fixed, "LARGEST_DEPTH", 12)
        self.assert_seen(True, "LARGEST_FIXED_SLOPE", 12 * gullies.SLOPE_UNIT)

    def test_rows_see_that_nothing_turns(self) -> None:
        function = GULLIES[0]
        self.assertFalse(function.has_period)
        rows = [row for row in ROWS[function.id][0] if of_row(function, row)["octaves"] > 1]
        with mock.patch.object(gullies, "NOTHING", ()):
            turned = [evaluated(function, row, True) for row in rows]
        others = sum(a != evaluated(function, row, True) for a, row in zip(turned, rows, strict=True))
        self.assertGreater(others, len(rows) / 2)

    def test_rows_that_would_leave_their_range_have_a_lower_gain(self) -> None:
        for octaves, lacunarity, depth in itertools.product((2, 5, 32, INT_MAX), (2.0, 3.7, 255.0, 300.0),
                                                           (0.02, 1.0, 8.0)):
            gain = gullies_rows.kept(octaves, lacunarity, 1.0, depth)
            growth = max(gullies_rows.growths(octaves, lacunarity, gain))
            self.assertLessEqual(growth * depth, 64)
            self.assertLessEqual(growth, 4096)
            self.assertTrue(gain == 1 or growth > 0.9 * min(64 / depth, 4096), (octaves, lacunarity, depth))
        for lacunarity, gain in ((1.0, 1.0), (0.0, 1.0), (2.0, 0.5), (-2.0, -1.0)):
            self.assertEqual(gullies_rows.kept(32, lacunarity, gain, 8.0), gain)
        self.assertEqual(gullies_rows.growths(3, 2.9, 1.5), [1, 2, 4])
        self.assertTrue(math.isclose(gullies_rows.growths(2, 300.0, 0.5)[1], 127.5))
