"""Tests of tools/make golden

The files' contents and form, and that `golden --check` notices what differs.
"""

from __future__ import annotations

import contextlib
import functools
import io
import itertools
import math
import operator
import tempfile
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from unittest import mock

from base.golden_values import Golden, ids
from base.thorough import THOROUGH, in_thorough_runs
from catalog.model import CatalogError
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import NOISES, OCTAVE_SUMS, SPREADS, Column, Function, read_functions
from proof.golden import cellular_rows, gullies_rows, period_rows, phasor_rows, simplex_rows, sum_rows
from proof.golden import command as golden
from proof.golden.files import Digest, GoldenFile, Sample, Values, golden_files, line
from proof.golden.generator import INT_MAX, INT_MIN, fnv1a64, generator_of, to_f32
from proof.golden.rows import CLAMPED
from proof.oracle import curl, feature_points, gradients, jacobians, kernels, noises, rotation, sums, words
from proof.oracle.functions import evaluator, knobs_of, values_of
from proof.oracle.gradients import Knobs
from proof.oracle.integers import signed
from proof.oracle.lattice import Lattice
from proof.oracle.nearest import NEAREST
from proof.oracle.noises import cell_border, simplex, simplex_smooth
from proof.oracle.sums import SHIFT

FUNCTIONS = {function.id: function for function in read_functions()}
# Rows of gullies have a test of their own.
SUMS = [function for function in FUNCTIONS.values()
        if function.family in OCTAVE_SUMS and function.bound != gullies_rows.BOUND]
CELLULAR = [function for function in FUNCTIONS.values() if function.family in cellular_rows.FAMILIES]
PHASORS = [function for function in FUNCTIONS.values() if function.has_wave]
SETTINGS = read_configurations()
FILES = {file.function.id: file for file in golden_files(list(FUNCTIONS.values()), SETTINGS)}


ENDS = {INT_MIN, INT_MAX}
# The numbers in a column of a function's rows with a setting, in every number of dimensions that is named; x, cx, fx
# and px are all axes.
EDGES = (
    ("noise{n}d.perlin", "lattice+fixed", (2, 3), "x", {*map(to_f32, (-1e-40, 3e38, -3.4e38)), -2.0**-21, -2.0**-20,
                                                         2.0**-149, 2.0**23, 2.0**31, -2.0**31}),
    ("noise{n}d.perlin_cell", "lattice+fixed", (2, 3), "fx", {0, 2.0**-149, 0.5, 1 - 2.0**-24, 1}),
    ("fbm.fbm{n}", "lattice+fixed", (2, 3), "octaves", {-1, 0, 1, 32, 33}),
    ("fbm.fbm{n}", "lattice+fixed", (2, 3), "lacunarity", {*map(to_f32, (1.9, 3.7, 0, 255))}),
    ("fbm.fbm{n}", "lattice+fixed", (2, 3), "gain", {0, 1, 1.5}),
    *((f"fbm.fbm{{n}}_{form}", "lattice+fixed", (2, 3), column, edges) for form in ("cell", "cell_period")
      for column, edges in (("cx", {*sum_rows.CELLS}), ("fx", {*sum_rows.FIXED_FRACTIONS}))),
    ("gradient.lattice{n}", "lattice", (2, 3), "x", {0, -1, INT_MIN, INT_MAX}),
    ("noise{n}d.perlin_cell_period", "lattice", (1, 2, 3, 4), "px", {*period_rows.PERIODS}),
    ("noise{n}d.perlin_period", "lattice", (1, 2, 3, 4), "px", {*period_rows.PERIODS}),
    ("position.cell{n}", "any", (1, 2, 3, 4), "x", {0, -1, *ENDS}),
    ("position.cell{n}", "any", (1, 2, 3, 4), "cells", {1, 65536, 0, -1, INT_MAX}),
    ("position.cell{n}", "any", (1, 2, 3, 4), "units", {1, 65536, 0, -1, INT_MAX}),
    ("numbers.shuffle", "any", (1,), "n", {0, 1, 2, 3, 2**16 - 1, 2**16, 2**16 + 1, 2**31}),
    ("numbers.rehash", "any", (1,), "k", {*range(6)}))
# How many different values a function has.
VALUES = {"hash.gradient2": 8, "hash.gradient3": 12, "hash.gradient4": 24}


def values_with(id: str, setting: str) -> Values:
    return next(values for values in FILES[id].values if values.name == setting)


def rows_with(id: str, setting: str = "") -> list[tuple]:
    """The rows of a function, with a setting, or with the first that has it."""
    values = values_with(id, setting) if setting else FILES[id].values[0]
    every, of_fixed = rows_of(id)
    return every + of_fixed if values.configuration.fixed else every


@functools.cache
def rows_of(id: str) -> tuple[list[tuple], list[tuple]]:
    """Which take a while to make."""
    return FILES[id].finite_rows()


@functools.cache
def rows_in(id: str, values: Values) -> int:
    """How many a committed file has. golden.regenerated_is_committed makes the rows of all anew, which takes a
    while."""
    return len(Golden(id, values.name, finite=False).inputs)


class GoldenContents(unittest.TestCase):
    def test_format(self) -> None:
        lines = self.file("noise1d.value")
        self.assertEqual(lines[:7], [
            "hashnoise golden 2", "function noise1d.value", "calls hn_value", "bits 1.0.0",
            "columns x:f32 seed:u32 = value:f64", "settings pcg:fast lattice:fast lattice+fixed:fixed",
            f"rows {len(lines) - 8}"
        ])
        self.assertRegex(lines[7], "^c0000000 00000000( = [0-9a-f]{16}){3}$")
        self.assertRegex(lines[-2], "^[0-9a-f]{8} [0-9a-f]{8} = - = - = [0-9a-f]{16}$")
        self.assertEqual(lines[-1], "")

    def file(self, function: str) -> list[str]:
        """The lines of a golden file."""
        return FILES[function].text().split("\n")

    def test_format_of_other_files(self) -> None:
        exact = self.file("gradient.lattice2")
        self.assertEqual(exact[4:6], ["columns x:i32 y:i32 seed:u32 = gx:f32 gy:f32", "settings fnv1:exact "
                                      "partial_fnv1:exact jenkins:exact partial_jenkins:exact murmur:exact pcg:exact "
                                      "xxhash32:exact lattice:exact custom:exact"])
        sine = self.file("gradient.sine3")
        self.assertEqual(sine[4], "columns x:i32 y:i32 z:i32 seed:u32 = gx:f64 gy:f64 gz:f64")
        self.assertRegex(sine[5], "^settings fnv1.sine:fast .* lattice.sine:fast lattice.sine.fixed:fixed$")
        self.assertEqual(self.file("hash.unorm")[5], "settings any:exact")
        digests = self.file("hash.lattice2")[-10:]
        self.assertEqual([line.split()[1] for line in digests[:-1]], [setting.split(":")[0] for setting in exact[5].split()[1:]])

    def test_fixed_arithmetic_by_hand(self) -> None:
        # Where a float has no fraction there is no noise.
        perlin, clouds = (values_with(id, "lattice+fixed") for id in ("noise2d.perlin", "fbm.clouds2"))
        for x in (-0.0, to_f32(3e38)):
            self.assertIn((x, x, 0), rows_with("noise2d.perlin", "lattice+fixed"))
            self.assertEqual(perlin.evaluate((x, x, 0)), (0,))
        no_octaves = [row for row in rows_with("fbm.clouds2", "lattice+fixed") if row[2] in (0, -1)]
        self.assertGreaterEqual(len(no_octaves), 4)
        for row in no_octaves:
            self.assertEqual(clouds.evaluate(row), (Fraction(5, 32),), row)

    def test_values_of_fixed_arithmetic_are_floats(self) -> None:
        """The committed files equal the oracle's: golden.regenerated_is_committed."""
        for id, file in FILES.items():
            for values in file.values:
                if values.configuration.fixed:
                    read = Golden(id, values.name)  # with bits of floats
                    for (_, kind), results in zip(read.head.results, zip(*read.expected)):
                        self.assertTrue(kind == "i32" or 0x80000000 not in results, id)

    def test_infinities_have_rows_where_they_have_values(self) -> None:
        for id, file in FILES.items():
            function, inputs = file.function, Golden(id, file.values[-1].name, finite=False).inputs
            for column, values in zip(function.inputs, zip(*inputs)):
                has = column.name in {*CLAMPED, "radius"} and function.form not in SPREADS and (
                    column.name, function.bound) != ("footprint", gullies_rows.BOUND)
                if column.type == "f32":
                    found = {word for word in values if word & 0x7F800000 == 0x7F800000}
                    self.assertEqual(found, {0xFF800000, 0x7F800000} if has else set(), (id, column.name))

    def test_only_fixed_arithmetic_has_further_inputs(self) -> None:
        for id, file in FILES.items():
            fixed = next((values for values in file.values if values.configuration.fixed), None)
            further = fixed is not None and rows_in(id, fixed) > rows_in(id, file.values[0])
            self.assertEqual(further, fixed is not None and not file.function.form.startswith(("point", "place")), id)

    def columns(self, id: str, setting: str, name: str) -> Iterator[list]:
        """The numbers in a column, or in each axis' column."""
        names = [column.name for column in FUNCTIONS[id].inputs]
        axes = [name[:-1] + axis for axis in "xyzw"] if name[-1] == "x" else [name]
        for found, *column in zip(names, *rows_with(id, setting)):
            if found in axes:
                yield column

    def test_rows_have_every_edge(self) -> None:
        for id, setting, dimensions, name, edges in EDGES:
            for n in dimensions:
                found = list(self.columns(id.format(n=n), setting, name))
                self.assertTrue(found)
                for column in found:
                    self.assertLessEqual(edges, {*column}, (id, n, name))

    def test_positions_of_fixed_arithmetic_are_beside_whole_numbers(self) -> None:
        for n in (2, 3):
            for column in self.columns(f"noise{n}d.perlin", "lattice+fixed", "x"):
                self.assertIn(-1, {math.copysign(1, x) for x in column if x == 0})
                phases = {x - round(x) for x in column if abs(x) < 100}
                self.assertTrue(any(0 < x < 2**-17 for x in phases) and any(-2**-17 < x < 0 for x in phases))
            self.assertIn((INT_MAX, 1), {(row[0], row[n]) for row in rows_with(f"fbm.fbm{n}_cell", "lattice+fixed")})

    def test_rows_of_gradients_reach_every_case(self) -> None:
        for id, count in VALUES.items():
            self.assertEqual(len({values_with(id, "any").evaluate(row) for row in rows_with(id)}), count)
        for n in (2, 3):
            coordinates = {c for column in self.columns(f"gradient.lattice{n}", "lattice", "x") for c in column}
            for sign, reach in itertools.product((-1, 1), (2**20, 2**30)):
                phases = {c % 2**20 for c in coordinates if c * sign >= reach - 1}
                self.assertTrue({0, 1, 2**20 - 1} <= phases, (n, sign, reach))

    def test_periods_have_seams_near_and_far(self) -> None:
        for n in (1, 2, 3, 4):
            found = {(row[i], row[2 * n + i]) for row in rows_with(f"noise{n}d.perlin_cell_period") for i in range(n)}
            self.assertTrue(ENDS <= {cell for cell, _ in found})
            # The points of some cell lie on both sides of a seam, and of some far from the origin.
            at_seams = [(cell, period) for cell, period in found if period > 1 and cell % period == period - 1]
            self.assertTrue({2, 3, 5, 7, 48, 64} <= {period for _, period in at_seams}, n)
            self.assertTrue(any(abs(cell) > 10**6 and period < 100 for cell, period in at_seams), n)
            for column in self.columns(f"noise{n}d.perlin_period", "lattice", "x"):
                self.assertTrue(all(abs(x) < 2**23 and to_f32(x) == x for x in column))

    def test_items_are_at_their_ends_and_beyond(self) -> None:
        rows = rows_with("numbers.shuffle")
        for n in (3, 52, 2**31):
            self.assertLessEqual({0, n - 1, n}, {i for i, other, _ in rows if other == n})
        self.assertGreater(min(sum(n / 2 < i < n for i, n, _ in rows), sum(i > n for i, n, _ in rows)), 10)

    def test_sums_have_every_edge_of_their_settings(self) -> None:
        for function in SUMS:
            name, edges, of_fixed = sum_rows.edges_of(function)
            for setting, expected in (("lattice", edges), ("lattice+fixed", edges + of_fixed)):
                rows = [self.of_row(function, row) for row in rows_with(function.id, setting)]
                octaves = {options.octaves for options, *_ in rows}
                self.assertTrue({-1, 0, 1, 2, 6} <= octaves or name in ("detail", "footprint"))
                self.assertTrue({2.0, 1.5, 1.90625, 0.5, 0, 255} <= {options.lacunarity for options, *_ in rows})
                self.assertTrue({0, 0.5, 1, 1.5} <= {options.gain for options, *_ in rows})
                if name:
                    field = "octaves" if name == "detail" else name
                    found = {getattr(options, field) for options, *_ in rows}
                    self.assertTrue(set(map(to_f32, expected)) <= found, (function.id, setting))
                # Most rows have another number.
                self.assertGreater(len(rows), 2 * len(expected))

    def test_there_are_values_for_what_the_tables_say(self) -> None:
        there = {f"{id}.{values.name}" for id, file in FILES.items() for values in file.values}
        for name in ("hash.word.fnv1", "hash.unorm.any", "gradient.lattice2.lattice", "gradient.sine3.fnv1+sine",
                     "noise3d.perlin_cell_period.lattice+fixed", "fbm.clouds2.lattice+sine+fixed",
                     "position.cell4.any", "noise2d.simplex_cell_period.pcg", "fbm_d.eroded3.lattice+fixed",
                     "warp.warp_progressive2_cell_period.lattice"):
            self.assertIn(name, there)
        for name in ("hash.unorm.lattice", "hash.word.lattice+fixed", "gradient.lattice2.lattice+sine",
                     "noise2d.perlin.lattice+precise", "fbm.fbm2.fnv1+sine", "fbm.fbm1.lattice+sine",
                     "fbm_d.fbm_d2.lattice+sine", "fbm.fbm2.fnv1", "noise2d.simplex_cell.pcg"):
            self.assertNotIn(name, there)

    def test_a_setting_that_is_left_out_takes_its_values_with_it(self) -> None:
        others = [setting for setting in SETTINGS if setting.name != "lattice+fixed"]
        files = {file.function.id: file for file in golden_files(list(FUNCTIONS.values()), others)}
        self.assertEqual({id for id in FILES if len(FILES[id].values) != len(files[id].values)},
                         {function.id for function in FUNCTIONS.values()
                          if function.family in (*NOISES, *OCTAVE_SUMS, "curl", "utility", "distribution")})
        functions = [function for function in FUNCTIONS.values() if function.family != "curl"]
        no_curl = [replace(setting, families=tuple({*setting.families} - {"curl"})) for setting in SETTINGS]
        self.assertEqual([file.function for file in golden_files(list(FUNCTIONS.values()), no_curl)], functions)

    def test_a_function_that_the_oracle_does_not_have(self) -> None:
        function = FUNCTIONS["noise2d.perlin"]
        for change, message in (({"bound": "merlin"}, r"noise2d\.perlin: .*write .*/oracle/noises/merlin\.py"),
                                ({"family": "octave_sum"}, r"/oracle/sums\.py, and name it in SUMS"),
                                ({"family": "independent"}, r"/oracle/functions\.py, in OF_WORDS")):
            file = GoldenFile(replace(function, **change), [setting for setting in SETTINGS if setting.name == "lattice"])
            with self.assertRaisesRegex(CatalogError, message):
                file.text()

    def test_phases_reach_every_case(self) -> None:
        for n, name, form in itertools.product((2, 3), ("perlin", "perlin_d", "simplex", "simplex_d"),
                                               ("", "_cell", "_cell_period")):
            self.check_phases(f"noise{n}d.{name}_phase{form}", -2)
        for n, form in itertools.product((2, 3), ("", "_cell_period")):
            self.check_phases(f"noise{n}d.cellular_phase{form}", -3)

    def check_phases(self, id: str, column: int) -> None:
        found = [row[column] for row in rows_with(id)]
        self.assertTrue(set(simplex_rows.PHASES) <= set(found))
        self.assertTrue(any(math.copysign(1, phase) < 0 for phase in found if phase == 0))
        self.assertGreater(len(set(found)), len(found) / 3)

    def test_waves_reach_every_case(self) -> None:
        self.assertEqual(len(PHASORS), 8)
        for function in PHASORS:
            n = function.axes
            self.check_phases(function.id, -2)
            for rows, edges in zip(rows_of(function.id), (phasor_rows.EDGES, phasor_rows.CUT)):
                waves = {row[-2 - n:-2] for row in rows}
                alone = {(edge, axis) for edge, axis in itertools.product(edges, range(n))
                         if tuple(edge if i == axis else 0 for i in range(n)) in waves}
                self.assertEqual({edge for edge, _ in alone}, set(edges), function.id)
                if len(rows) > 5 * n * len(edges):
                    self.assertEqual(len(alone), n * len(set(edges)), function.id)
                self.assertLessEqual({(abs(edge),) * n for edge in edges}, {tuple(map(abs, wave)) for wave in waves})
                self.assertGreater(len(waves), len(rows) / 2)
                # An edge of a phase is with waves of each kind, and so is a phase that is none.
                self.assertEqual({(row[-2] in simplex_rows.PHASES, index % 5) for index, row in enumerate(rows)},
                                 set(itertools.product((False, True), range(5))))

    def test_points_that_move_are_in_every_kind_of_place(self) -> None:
        for n in (2, 3):
            places: dict[float, list[tuple]] = {}
            for row in rows_with(f"noise{n}d.cellular_phase_cell_period", "lattice"):
                if row[-2] == 1:  # where a jitter moves points farthest
                    places.setdefault(row[-3], []).append(row[n:2 * n])
            for phase in (0.0, 0.25, 0.5, -0.25):
                for at in (0.0, 0.5):
                    self.assertTrue(any(at in f for f in places[phase]), (n, phase))
            # Beside quarters the sines and the cosines are 1 and -1.
            found = [rotation.fixed_cosine_and_sine(phase) for phase in places]
            for numbers in zip(*found):
                self.assertTrue({2**16, -2**16} <= set(numbers), n)

    def test_simplex_rows_reach_every_plane(self) -> None:
        for n, name in ((2, "simplex"), (2, "simplex_phase"), (3, "simplex_smooth"), (4, "simplex_d")):
            fractions = [row[n:2 * n] for row in rows_with(f"noise{n}d.{name}_cell")]
            at = [tuple(map(Fraction, f)) for f in fractions]
            for axis in range(n):
                self.assertTrue(any(f[axis] == 0.5 for f in at))
            self.assertTrue(any(f[0] == f[1] and f[0] * 4 % 1 for f in at))
            self.assertIn((0,) * n, at)
            if n == 2:
                # On an edge of triangles, of either direction, and beside it; in the middle between three points.
                for slope, beside in itertools.product((1, -1), (0, 2**-20)):
                    self.assertTrue(any((2 * x + slope * y - beside) % 1 == 0 and y * 4 % 1 for x, y in at))
                self.assertTrue(any((x * 4 % 1, y * 2 % 1) == (0, Fraction(3, 8)) for x, y in at))
            else:
                self.assertIn((0.5,) * n, at)
                self.assertTrue(any(sum(f) == Fraction(n, 4) and f[0] * 8 % 1 for f in at))

    def test_simplex_rows_reach_where_kernels_end(self) -> None:
        for name, table in (("simplex", simplex.KERNELS), ("simplex_smooth", simplex_smooth.KERNELS)):
            for n, kernel in table.items():
                just_counts = just_not = 0
                for row in rows_with(f"noise{n}d.{name}_cell"):
                    f = tuple(map(Fraction, row[n:2 * n]))
                    step = 2**22
                    # A kernel that is wider by 2^-17 in the square of its distance.
                    wider = replace(kernel, r=kernel.r + kernel.m * 2**-7)
                    if all((x * step).denominator == 1 for x in f):
                        position = [int(kernel.steps * x * step) for x in f]
                        found = kernels.points(kernel, position, step)
                        just_not += len(kernels.points(wider, position, step)) > len(found)
                        narrower = replace(kernel, r=kernel.r - kernel.m * 2**-7)
                        just_counts += len(kernels.points(narrower, position, step)) < len(found)
                self.assertTrue(just_counts > 3 and just_not > 3, (name, n, just_counts, just_not))

    def test_simplex_rows_reach_every_seam(self) -> None:
        for n in (2, 3, 4):
            rows = rows_with(f"noise{n}d.simplex_cell_period")
            found = {(row[i], row[2 * n + i]) for row in rows for i in range(n)}
            for period in simplex_rows.PERIODS:
                phases = {cell % period for cell, of in found if of == period}
                self.assertTrue({0, period - 1} <= phases, (n, period))

    def test_curl_rows_reach_where_the_second_place_enters_another_cell(self) -> None:
        knobs, right = Knobs("lattice"), curl.moved

        def wraps(*place):
            cell, f = right(*place)
            return [words.signed(c & words.MASK) for c in cell], f

        def stays(cell, *fraction):
            return cell, right(cell, *fraction)[1]

        for name in ("curl3", "curl3_cell", "curl3_cell_period"):
            function = FUNCTIONS[f"curl.{name}"]
            rows = simplex_rows.crossings(function.form, function.has_period)
            self.assertEqual(rows_of(function.id)[0][-len(rows):], rows)
            # Without a period a cell that wraps is the same one.
            for (fault, least), fixed in itertools.product(((stays, 0.4), (wraps, function.has_period / 8)),
                                                           (False, True)):
                expected = [evaluator(function, fixed)(knobs, row) for row in rows]
                with mock.patch.object(curl, "moved", fault):
                    found = [evaluator(function, fixed)(knobs, row) for row in rows]
                differing = sum(map(operator.ne, found, expected)) / len(rows)
                self.assertTrue(differing >= least and bool(differing) == bool(least), (name, fault, differing))

    @in_thorough_runs
    def test_cellular_rows_choose_every_jitter_and_metric(self) -> None:
        metrics: dict[str, set[int]] = {}
        for function in CELLULAR:
            rows = [row for rows in rows_of(function.id) for row in rows]
            if function.has_metric:
                found = [row[-2] for row in rows]
                metrics.setdefault(function.bound, set()).update(found)
                self.assertLess(set(cellular_rows.METRICS), set(found), function.id)
                odd = sum(metric not in cellular_rows.METRICS for metric in found)
                self.assertLess(odd, len(found) / 6)
            if function.has_jitter:
                found = [row[-2 - function.has_metric] for row in rows]
                for jitter in (0, 1):
                    self.assertGreater(found.count(jitter), len(found) / 12, function.id)
                outside = sum(not 0 <= jitter <= 1 for jitter in found)
                self.assertTrue(0 < outside < len(found) / 12, function.id)
                self.assertGreater(len(set(found)), len(found) / 8)
        for found in metrics.values():
            self.assertEqual(found, {*cellular_rows.METRICS, *cellular_rows.ODD_METRICS})

    def test_cellular_rows_reach_every_place(self) -> None:
        for function in CELLULAR:
            if function.form != "cell" or cellular_rows.jumps(function):
                continue
            n = function.axes
            rows = rows_with(function.id)
            fractions = [row[n:2 * n] for row in rows]
            self.assertTrue({(0.0,) * n, (0.5,) * n} <= set(fractions))
            for axis in range(n):
                cells = {row[axis] for row in rows}
                self.assertTrue({INT_MIN, INT_MAX} <= cells)
                self.assertTrue(any(-64 < c < 0 for c in cells) and any(c < -2**20 for c in cells - {INT_MIN}))
                self.assertTrue(any(f[axis] == 0 and all(x * 8 % 1 for i, x in enumerate(f) if i != axis)
                                    for f in fractions), (function.id, "on a wall"))
            self.assertTrue(any(2.0**-20 in (x, 1 - x) for f in fractions for x in f))
            self.assertTrue(any(f[i] == f[j] and f[i] * 8 % 1 for f in fractions for i in range(n) for j in range(i)))
            if function.has_period:
                found = [(row[i], row[2 * n + i]) for row in rows for i in range(n)]
                self.assertTrue({0, 1, 2, 3, 7, 64, 2**30, INT_MAX} <= {period for _, period in found})
                for period in (2, 3, 7, 64):  # on both sides of a seam
                    self.assertTrue({0, period - 1} <= {cell % period for cell, of in found if of == period},
                                    (function.id, period))

    def test_some_borders_are_those_of_cells_two_steps_on(self) -> None:
        lattice = Lattice(knobs_of(next(setting for setting in SETTINGS if setting.name == "lattice")), 0)
        steps = set()
        for cell, f in cellular_rows.FAR_BORDERS:
            field = feature_points.Field.fixed(lattice, cell, [int(x * 2**20) for x in f], feature_points.EUCLIDEAN)
            (nearest,), axes = field.nearest(1), range(len(cell))
            others = [(beside, field.point(beside)) for beside in itertools.product(range(-3, 4), repeat=len(cell))]
            beside = min((cell_border.fixed_between(nearest, point), beside) for beside, point in others
                         if point.cell != nearest.cell)[1]
            steps |= {(len(cell), axis, beside[axis] > 0) for axis in axes if abs(beside[axis]) == 2}
            self.assertEqual(max(map(abs, beside)), 2, cell)
        self.assertEqual(steps, {(n, axis, after) for n in (2, 3) for axis in range(n) for after in (False, True)})
        for function in CELLULAR:
            if function.noise == "cell_border" and not function.sets:
                self.assertGreater(len(cellular_rows.far_borders(function)), 1)

    @in_thorough_runs
    def test_cellular_positions_are_near_and_far(self) -> None:
        for function in CELLULAR:
            if function.form == "position":
                found = [row[:function.axes] for row in rows_with(function.id)]
                self.assertTrue(any(max(map(abs, p)) >= 2**19 for p in found), function.id)
                self.assertTrue(any(max(p) < 0 for p in found))

    def unclear(self, function: Function, rows: Sequence[tuple], setting: str) -> list[tuple]:
        """The rows at which the second point is about as near as the first."""
        knobs = knobs_of(next(configuration for configuration in SETTINGS if configuration.name == setting))
        return [row for row in rows if not cellular_rows.is_clear(function, knobs, row)]

    @in_thorough_runs
    def test_the_nearest_point_is_clear_where_it_matters(self) -> None:
        jumping = [function for function in CELLULAR if cellular_rows.jumps(function)]
        self.assertEqual(len(jumping), 2 * (3 + 6 + 2 + 2))
        for function in jumping:
            rows = rows_with(function.id, "lattice")
            hashes = [setting.name for setting in SETTINGS if setting.covers(function) and not setting.fixed]
            for setting in hashes:
                self.assertEqual(self.unclear(function, rows, setting), [], (function.id, setting))
            # The check finds faults of fixed arithmetic, behind the others.
            more = rows_with(function.id, "lattice+fixed")[len(rows):]
            self.assertGreater(len(self.unclear(function, more, "lattice")), 2 * cellular_rows.CHANGES - 1)

    @in_thorough_runs
    def test_fixed_arithmetic_has_ties_and_changes_of_the_nearest_point(self) -> None:
        knobs = knobs_of(next(setting for setting in SETTINGS if setting.name == "lattice+fixed"))
        for function in CELLULAR:
            if not cellular_rows.jumps(function):
                continue
            rows = rows_with(function.id, "lattice+fixed")
            distances = cellular_rows.distances_of(function, True)
            nearest = values_of(NEAREST, function, True)
            if function.has_jitter:
                equal = sum(first == second for first, second in (distances(knobs, row) for row in rows))
                self.assertGreater(equal, 6, function.id)
            pairs = rows[-2 * cellular_rows.CHANGES:]
            for before, after in zip(pairs[::2], pairs[1::2]):
                at = function.axes if function.form == "cell" else 0
                self.assertEqual(after[at] - before[at], 2.0**-20)
                self.assertNotEqual(nearest(knobs, before), nearest(knobs, after))

    def test_a_place_that_no_seed_makes_clear(self) -> None:
        function = FUNCTIONS["noise2d.cellular_d"]
        with mock.patch.object(cellular_rows, "CLEAR", 2), self.assertRaisesRegex(ValueError, "is not clear"):
            list(cellular_rows.cleared([(0.5, 0.5, 0)], function, generator_of("clear")))

    def test_a_tie_matters_to_every_sine_gradient(self) -> None:
        def away(n: int) -> int:
            step = 1 << max(n.bit_length() - 24, 0)
            return int(math.copysign((abs(n) + step // 2) // step * step, n))

        sine = [setting for setting in SETTINGS if setting.gradient == "sine" and setting.arithmetic == "fast"]
        for n, knobs in itertools.product((2, 3), map(knobs_of, sine)):
            cells = [(row[:n], row[n]) for row in rows_with(f"gradient.sine{n}")]
            even = [component for cell in cells for component in gradients.gradient(knobs, *cell)]
            with mock.patch.object(gradients, "round24", away):
                other = [component for cell in cells for component in gradients.gradient(knobs, *cell)]
            # By more than the contract allows.
            self.assertGreater(max(abs(a - b) for a, b in zip(even, other)), 2**-19, (n, knobs))

    @in_thorough_runs
    def test_the_sine_is_exact_enough_for_the_nearest_double(self) -> None:
        # The weights of the components of a noise sum to n / 2 at most; clouds are up to three times as steep as it.
        margin = 3 * Fraction(3, 2) * gradients.SINE_ERROR
        for id, file in FILES.items():
            if any(values.name == "lattice+sine" for values in file.values):
                for row in rows_of(id)[0]:
                    for value in values_with(id, "lattice+sine").evaluate(row):
                        if value not in (0, 1):
                            self.assertEqual(float(value - margin), float(value + margin), (id, row))

    def test_patterns(self) -> None:
        self.assertEqual(line(Column.listed("a:i32 b:u32 c:f32 d:f64"), (-2, 255, -1.5, 0.5)),
                         "fffffffe 000000ff bfc00000 3fe0000000000000")
        self.assertEqual(line(Column.listed("a:f64"), (Fraction(1, 3),)), "3fd5555555555555")
        self.assertEqual(line(Column.listed("a:f64"), (Fraction(0),)), "0000000000000000")
        with self.assertRaises(ValueError):
            line(Column.listed("a:f32"), (0.1,))
        with self.assertRaises(ValueError):
            line(Column.listed("a:u32 b:u32"), (1,))

    def test_digest_runs_over_the_last_coordinate_first(self) -> None:
        file = values_with("hash.lattice2", "lattice")
        with mock.patch.object(words, "lattice", lambda _, point, seed: 100 * point[0] + 10 * point[1] + seed):
            found = file.digest(Digest((1, 2), (2, 3), 4))
        values = b"".join(value.to_bytes(4, "little") for value in (124, 134, 144, 224, 234, 244))
        self.assertEqual(found, f"digest lattice origin=1,2 size=2,3 seed=4 fnv1a64={fnv1a64(values):016x}")

    def test_row_counts(self) -> None:
        least = {"hash.word": 64, "hash.gradient2": 128, "hash.gradient3": 128,
                 "gradient.lattice2": 96, "gradient.lattice3": 96, "gradient.sine2": 96, "gradient.sine3": 96}
        for name in FUNCTIONS:
            noise = 96 if FUNCTIONS[name].has_period else 192
            if name.startswith("noise4d"):
                noise //= 2  # their exact values take long
            expected = least.get(name, noise if name.startswith("noise") and FUNCTIONS[name].form != "sum" else 64)
            self.assertGreaterEqual(rows_in(name, FILES[name].values[0]), expected, name)

    def of_row(self, function: Function, row: Sequence) -> tuple[sums.Options, sums.Place, Sequence[int]]:
        """The options, the position and the periods of a sum."""
        n, places = function.axes, function.axes * (1 + function.has_cell)
        place = sums.in_cell(row[:n], row[n:places]) if function.has_cell else sums.at_position(row[:n])
        names = ["octaves" if name == "detail" else name for name in function.settings]
        behind_periods = places + n * function.has_period
        options = sums.Options(**dict(zip(names, row[behind_periods:-1], strict=True)))
        if function.has_cell:
            options = sums.from_cell(options)
        return options, place, row[places:behind_periods]

    def positions_of(self, function: Function, row: Sequence) -> list[sums.Place]:
        options, place, periods = self.of_row(function, row)
        if function.bound != "warp_progressive":
            return [q for q, *_ in sums.octaves_of(place, options, 0, periods)]
        noise = noises.find(jacobians.SUMS[function.bound].noise)
        octaves = jacobians.progressive_octaves(noise, Knobs("lattice"), place, options, row[-1], periods)
        return [q for (q, *_), _ in octaves]

    def test_jacobians_keep_to_what_their_bounds_are_for(self) -> None:
        jacobiand = [function for function in SUMS if function.bound in sum_rows.JACOBIAND]
        self.assertEqual(len(jacobiand), 12)
        for function in jacobiand:
            sizes, moves = [], []
            for row in rows_with(function.id, "lattice+fixed"):
                options, _, periods = self.of_row(function, row)
                growth = abs(options.gain * sums.growth_of(options, periods))
                powers = [growth**i for i in range(sums.count_of(options))]
                sizes.append(sum(powers))
                moves.append(sums.clamped(options.amplitude, 0, 64) * max(powers, default=0))
            self.assertTrue(60 < max(sizes) <= 64, function.id)
            self.assertEqual(max(moves) <= 256, function.bound == "warp_progressive" or not max(moves))
            self.assertTrue(max(moves) > 200 or function.bound == "fbm_d", function.id)

    def test_nothing_wraps_where_jacobians_keep_their_range(self) -> None:
        """The contract's domain is one in which fixed arithmetic loses no bits but those of cells. By default every
        fourth row has it, others of each function."""
        for turn, function in enumerate(SUMS):
            if function.bound in jacobians.SUMS:
                tried = slice(None) if THOROUGH else slice(turn % 4, None, 4)
                fixed, rows = values_with(function.id, "lattice+fixed"), rows_with(function.id, "lattice+fixed")[tried]
                with mock.patch.object(jacobians, "wrapped", signed):
                    values = [line(function.outputs, fixed.evaluate(row)) for row in rows]
                right = Golden(function.id).values[tried]
                self.assertEqual(values, [" ".join(f"{word:016x}" for word in words) for words in right])

    def test_slopes_sum_to_more_than_an_eroded_sum_lets_them(self) -> None:
        for function in SUMS:
            if function.bound != "eroded":
                continue
            for configuration, name in (("lattice", "LARGEST_SUM"), ("lattice+fixed", "LARGEST_E")):
                file, row = values_with(function.id, configuration), sum_rows.steep(function)
                self.assertIn(row, rows_of(function.id)[0])
                value, = file.evaluate(row)
                with mock.patch.object(jacobians, name, 2 * getattr(jacobians, name)):
                    other, = file.evaluate(row)
                self.assertGreater(abs(value - other), 2**-12, (function.id, configuration))

    @in_thorough_runs
    def test_octaves_of_floats_are_in_the_domain(self) -> None:
        for function in SUMS:
            far = 0
            for row in rows_with(function.id, "lattice"):
                options, place, periods = self.of_row(function, row)
                self.assertLess(sum(sums.weights(options)), 16)
                octaves = max(math.ceil(options.octaves), 0)
                for period in periods:
                    self.assertLess(period * math.floor(sums.clamped(options.lacunarity, 0, 255))**octaves, 2**31)
                positions = self.positions_of(function, row)
                if not function.has_cell:
                    self.assertTrue(all(abs(x) < 2**15 for q in positions for x in q))
                    continue
                # The end of the last cell is beyond the largest int.
                self.assertTrue(all(-2**31 <= x <= 2**31 - (i > 0) for i, q in enumerate(positions) for x in q))
                # The whole positions have the same lacunarity.
                self.assertTrue(periods or options.lacunarity * 2**23 % 1 == 0)
                far += octaves > 1 and max(map(abs, place)) > 2**26
            self.assertEqual(far > 4, function.has_cell, function.id)

    def test_octave_positions_are_exact_in_float32(self) -> None:
        """All of them with a period, where nothing turns. Else the first two, unless the lacunarity has many bits."""
        for function in SUMS:
            for row in rows_with(function.id, "lattice") * (not function.has_cell):
                options, place, periods = self.of_row(function, row)
                if function.bound == "warp_progressive":
                    continue  # its octaves are where no float is
                if periods:
                    lacunarity = sums.lacunarity_of(options, periods)
                    self.assert_exact_positions(list(map(float, place)), options.octaves, float(lacunarity))
                elif options.lacunarity != 1.90625:
                    for q, *_ in itertools.islice(sums.octaves_of(place, options, 0), 2):
                        self.assertEqual([to_f32(float(x)) for x in q], q)

    def assert_exact_positions(self, q: Sequence[float], octaves: int, lacunarity: float) -> None:
        # From each octave to the next, with and without a fused multiply-add.
        for _ in range(octaves - 1):
            scaled = [x * lacunarity for x in q]
            q = [x + float(shift) for x, shift in zip(scaled, SHIFT)]
            for x in scaled + q:
                self.assertEqual(to_f32(x), x)

    def test_many_clouds_are_neither_clear_nor_full(self) -> None:
        for n in (2, 3):
            values = [values_with(f"fbm.clouds{n}", "lattice").evaluate(row)[0]
                      for row in rows_with(f"fbm.clouds{n}")]
            self.assertGreaterEqual(sum(0 < value < 1 for value in values), len(values) / 2)
            self.assertIn(0, values)


class GoldenReader(unittest.TestCase):
    """golden_values.py: files that it reads, and files that it refuses."""

    def setUp(self) -> None:
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = Path(directory.name)
        self.text = (golden.GOLDEN / "noise2d.simplex.golden").read_text()

    def read(self, text: str, setting: str = "lattice+fixed") -> Golden:
        (self.directory / "noise2d.simplex.golden").write_text(text)
        return Golden("noise2d.simplex", setting, self.directory)

    def test_it_reads_what_is_written(self) -> None:
        function = FUNCTIONS["noise2d.simplex"]
        for setting in ("pcg", "lattice", "lattice+fixed"):
            found, rows = self.read(self.text, setting), rows_with("noise2d.simplex", setting)
            self.assertEqual((found.head.calls, found.head.axes), ("hn_simplex", 2))
            words = [[f"{word:08x}" for word in row] for row in found.inputs]
            self.assertEqual(words, [line(function.inputs, row).split() for row in rows])
            right = values_with("noise2d.simplex", setting).evaluate(rows[7])
            self.assertEqual(f"{found.values[7][0]:016x}", line(function.outputs, right))

    def test_it_finds_who_has_a_setting(self) -> None:
        found = dict(ids("pcg", "any"))
        self.assertEqual((found["noise2d.simplex"], found["hash.unorm"]), ("pcg", "any"))
        self.assertNotIn("noise2d.simplex_cell", found)

    def test_what_is_wrong_is_refused(self) -> None:
        lines = self.text.split("\n")
        for changed in (lines[:-2] + [""], lines[:-1] + [lines[-2], ""], lines[:7], lines[:6] + lines[7:]):
            with self.assertRaises(ValueError):
                self.read("\n".join(changed))
        with self.assertRaises(ValueError):
            self.read(self.text, "fnv1")
        no_float = self.read("\n".join([*lines[:7], f"{lines[7][:-1]}1", *lines[8:]]))
        with self.assertRaisesRegex(ValueError, "is no float"):
            self.assertFalse(no_float.expected)


class GoldenCheck(unittest.TestCase):
    """Faults that --check must notice, on a few files in a directory of its own."""

    def setUp(self) -> None:
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = Path(directory.name) / "golden"
        self.files = {file.name: file.text() for file in FILES.values() if file.function.family == "independent"}
        golden.write(self.directory, self.files)

    def run_main(self, *arguments: str) -> tuple[int, str]:
        """The exit status and the output, with the table cut down to the functions of the few files."""
        out = io.StringIO()
        functions = [function for function in FUNCTIONS.values() if f"{function.id}.golden" in self.files]
        with mock.patch.object(golden, "read_functions", return_value=functions), contextlib.redirect_stdout(out):
            return golden.main([*arguments, "--out", str(self.directory)]), out.getvalue()

    def test_untouched_files_pass(self) -> None:
        self.assertEqual(self.run_main("--check")[0], 0)

    def test_what_is_damaged_missing_or_extra_is_noticed(self) -> None:
        for damage, expected in (
                (lambda text: text.replace(b"\n", b"\r\n"), ".*"), (lambda text: text[:-1], ".*"),
                (lambda text: text + b"\n", ".*"), (lambda text: b"", ".*"), (lambda text: text[:-2] + b"\xff\n", ".*"),
                (lambda text: text.replace(b" = 00000000\n", b" = 00000001\n", 1),
                 r"differs, line \d+: expected .*, found .*"),
                (None, "missing")):
            path = self.directory / "hash.unorm.golden"
            whole = path.read_bytes()
            path.unlink() if damage is None else path.write_bytes(damage(whole))
            status, output = self.run_main("--check")
            self.assertEqual(status, 1)
            self.assertRegex(output, rf"^hash\.unorm\.golden: {expected}\n$")
            path.write_bytes(whole)
        (self.directory / "hash.old.golden").write_text("")
        self.assertEqual(self.run_main("--check"), (1, "hash.old.golden: extra\n"))
        self.directory = self.directory / "none"
        self.assertEqual(self.run_main("--check")[0], 1)

    def test_a_sample_notices_a_digit_in_what_it_computes_and_everything_in_the_rest(self) -> None:
        path = self.directory / "hash.unorm.golden"
        whole = path.read_text()
        lines = whole.split("\n")
        rows = int(lines[6].split()[1])
        chosen = Sample(3, golden.salt()).of("hash.unorm", rows, 0, 1)
        noticed = set()
        for i in range(rows):
            changed = list(lines)
            changed[7 + i] = changed[7 + i][:-1] + ("1" if changed[7 + i][-1] == "0" else "0")
            path.write_text("\n".join(changed))
            if (FILES["hash.unorm"].text(path.read_text(), Sample(3, golden.salt())) != path.read_text()):
                noticed.add(i)
        self.assertEqual(noticed, chosen & set(range(rows)))
        self.assertIn(len(noticed), (1, 2, 3))
        other = next(i for i in range(rows) if i not in chosen)
        for old, new in ((lines[7 + other][:8], "12345678"), (lines[7 + other][-8:], "-"), (lines[7 + other], ""),
                         (lines[7 + other][-8:], "0000000G"), (lines[7 + other], lines[7 + other] + " ")):
            path.write_text(whole.replace(lines[7 + other], lines[7 + other].replace(old, new)))
            status, output = self.run_main("--check", "--sample", "3")
            self.assertEqual((status, output.startswith(f"hash.unorm.golden: differs, line {8 + other}: ")), (1, True))
        path.write_text(whole)
        self.assertEqual(self.run_main("--check", "--sample", "3"),
                         (0, f"3 rows and more of each of {len(self.files)} golden files equal the oracle's\n"))

    def test_a_sample_computes_rows_of_fixed_arithmetic_and_a_digest(self) -> None:
        for id, lines in (("noise1d.value", 3 + 1), ("hash.lattice1", 3 + 1)):
            file = FILES[id]
            every, of_fixed = (len(rows) for rows in file.rows())
            chosen = Sample(3, "salt").of(id, every, of_fixed, len(file.values))
            text = (golden.GOLDEN / file.name).read_text()
            with mock.patch.object(Values, "evaluate", return_value=(1,)), \
                    mock.patch.object(Values, "digest", return_value="digest"):
                changed = file.text(text, Sample(3, "salt")).split("\n")
            wrong = {i - 7 for i, (line, right) in enumerate(zip(changed, text.split("\n"), strict=True)) if line != right}
            self.assertEqual(wrong, {i for i in chosen if i < every + of_fixed or file.function.family == "hash"})
            self.assertTrue(any(i >= every for i in wrong))
            self.assertLessEqual(len(wrong), lines)

    def test_another_oracle_asks_other_rows(self) -> None:
        self.assertRegex(golden.salt(), "^[0-9a-f]{64}$")
        self.assertNotEqual(Sample(8, "a").of("noise2d.perlin", 192, 195, 18), Sample(8, "b").of("noise2d.perlin", 192, 195, 18))

    def test_writing_removes_stale_files_only(self) -> None:
        (self.directory / "hash.old.golden").write_text("")
        (self.directory / "README.md").write_text("")
        self.assertEqual(self.run_main()[0], 0)
        self.assertEqual({path.name for path in self.directory.iterdir()}, {*self.files, "README.md"})
        self.assertEqual(self.run_main("--check")[0], 0)

    def test_only_some_files(self) -> None:
        # Each command sees its own of one file that is missing, one that is wrong, and one that is extra.
        (self.directory / "hash.old.golden").write_text("")
        (self.directory / "hash.unorm.golden").write_text("")
        (self.directory / "hash.snorm.golden").unlink()
        self.assertEqual(self.run_main("--check", "--only", "hash.gradient[34]")[0], 0)
        self.assertEqual(self.run_main("--check", "--only", "*.snorm", "--only", "hash.gradient*"),
                         (1, "hash.snorm.golden: missing\n"))
        self.assertEqual(self.run_main("--only", "*.snorm")[1], f"1 golden files written to {self.directory}\n")
        self.assertEqual((self.directory / "hash.snorm.golden").read_text(), self.files["hash.snorm.golden"])
        self.assertEqual([(self.directory / f"hash.{name}.golden").read_text() for name in ("old", "unorm")], ["", ""])
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            self.run_main("--only", "hash.no_such*")

    def test_bad_usage(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as exit_:
            golden.main(["--chekc"])
        self.assertEqual(exit_.exception.code, 2)
        for arguments in (["--sample", "3"], ["--check", "--sample", "0"]):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
                golden.main(arguments)
