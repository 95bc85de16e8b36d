"""Tests of tools/make golden

The files' contents and form, and that `golden --check` notices what differs.
"""

from __future__ import annotations

import contextlib
import functools
import io
import itertools
import math
import unittest
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from base.golden_values import Golden, head_of, ids
from base.testing import Case
from base.thorough import THOROUGH, in_thorough_runs
from catalog.model import AXES, CatalogError
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import Column, read_functions
from proof.golden import command as golden
from proof.golden import rows
from proof.golden.files import GoldenFile, Sample, Values, golden_files, line
from proof.golden.generator import INT_MAX, INT_MIN, generator_of
from proof.oracle import gradients, jacobians
from proof.oracle.functions import knobs_of
from proof.oracle.integers import signed
from proof.oracle.testing import METRICS
from proof.vectors.files import meaning

FUNCTIONS = {function.id: function for function in read_functions()}
SUMS = [function for function in FUNCTIONS.values()
        if function.form == "sum" and function.bound != "gullies"]
SETTINGS = read_configurations()
FILES = {file.function.id: file for file in golden_files(list(FUNCTIONS.values()), SETTINGS)}


# Numbers that each column of that name has, of every function: edges of what it may be, and those beyond that count as
# the nearer end. x, cx, fx and so on are all axes.
ENDS = {0, -1, INT_MIN, INT_MAX}
BEYOND = {0.0, 1.0, -math.inf, math.inf}
EDGES = {
    "f32 axis": {-0.0, -1.0, 2.0**-21, math.inf, -math.inf}, "i32 axis": {*ENDS, 1},
    "u32 axis": {0, 1, 2**31, 2**32 - 1},
    "c*": ENDS, "f*": {0.0, 2.0**-149, 0.5, 1 - 2.0**-24, 1.0}, "p*": {*ENDS, 1, 2, 3, 5, 2**30},
    "k*": {0.0, 1.0, 16.0, -16.0, -17.0, 2.0**-17}, "e*": {0.0, 1.0, -1.0, 8.0},
    "bandwidth": {0.0, 0.5, 1.0, 16.0, 17.0, -1.0}, "phase": {0.0, 0.25, -0.25, 0.5, 1.0, 2.0**-30, 1000.125}, "jitter": BEYOND,
    "metric": {0, *METRICS, INT_MAX}, "seed": {0, 1, 2**32 - 1}, "radius": BEYOND | {0.5, 2.0**-16},
    "octaves": {-1, 0, 1, 2, 6, 32, 33, INT_MAX}, "detail": {0.0, 1.0, 1 + 2.0**-23, 2.0},
    "footprint": {0.0, 0.25, 2.0, -1.0},
    "lacunarity": {0.0, 0.5, 1.0, 2.0, 255.0, 300.0}, "gain": {0.0, 0.25}, "strength": BEYOND | {2.0**-18, -1.0},
    "amplitude": BEYOND | {64.0, 100.0, -1.0}, "depth": {0.0, 1.0, 8.0, 9.0, -1.0},
    "cells": {*ENDS, 1, 65536, 65537} - {-1},
    "units": {*ENDS, 1, 65536, 65537} - {-1}, "n": {0, 1, 2, 3, 2**16, 2**31}, "i": {0, 1, 2**31}, "k": {*range(6)},
    "h": {0, 2**31, 2**32 - 1}, "key": {0, 1, 2**31, 255}, "zero": {0, 1, 2**31}, "noise": {0.0, 2.0**-149, 0.0625},
    "spread": {*range(-19, 21)}, "reach": {0.0, 0.0625, 1.0, 3.0, -1.0, 4.0}, "a": {0.0, 0.5, 1.0, -0.5, 1.5},
    "b": {0.0, 0.5, 1.0, -1.0, 2.0}, "c": {0.0, 0.5, 1.0, 1.5}}


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
    return tuple([row for row in some if all(map(math.isfinite, row))] for some in FILES[id].rows())


@functools.cache
def rows_in(id: str, values: Values) -> int:
    """How many a committed file has. golden.regenerated_is_committed makes the rows of all anew, which takes a
    while."""
    return len(Golden(id, values.name, finite=False).inputs)


class GoldenContents(unittest.TestCase):

    def test_values_of_fixed_arithmetic_are_floats(self) -> None:
        """The committed files equal the oracle's: golden.regenerated_is_committed."""
        for id, file in FILES.items():
            for values in file.values:
                if values.configuration.fixed:
                    read = Golden(id, values.name)  # with bits of floats
                    for (_, kind), results in zip(read.head.results, zip(*read.expected)):
                        self.assertTrue(kind == "i32" or 0x80000000 not in results, id)

    def test_rows_have_every_edge(self) -> None:
        """Of every function, also of one that is new. (That rows stay as they are golden.regenerated_is_committed
        sees.)"""
        for id, file in FILES.items():
            read, function = Golden(id, file.values[-1].name, finite=False), file.function
            self.assertGreaterEqual(len(read.inputs), 96 if function.form in ("position", "cell") else 64, id)
            for column, of_column in zip(function.inputs, zip(*read.inputs)):
                kind = (f"{column.name[0]}*" if len(column.name) == 2 else
                        f"{column.type} axis" if column.name in AXES else column.name)
                numbers = {meaning(column.type, word) for word in of_column}
                with self.subTest(id, column=column.name):
                    self.assertLessEqual(EDGES[kind], numbers)

    def test_a_setting_that_is_left_out_takes_its_values_with_it(self) -> None:
        fixed, = (setting for setting in SETTINGS if setting.name == "lattice+fixed")
        others = [setting for setting in SETTINGS if setting != fixed]
        files = {file.function.id: file for file in golden_files(list(FUNCTIONS.values()), others)}
        self.assertEqual({id for id in FILES if len(FILES[id].values) != len(files[id].values)},
                         {function.id for function in FUNCTIONS.values() if function.family in fixed.families})
        functions = [function for function in FUNCTIONS.values() if function.family != "curl"]
        no_curl = [replace(setting, families=tuple({*setting.families} - {"curl"})) for setting in SETTINGS]
        self.assertEqual([file.function for file in golden_files(list(FUNCTIONS.values()), no_curl)], functions)

    def test_a_function_that_the_oracle_does_not_have(self) -> None:
        for id, change, message in (
                ("noise2d.perlin", {"bound": "merlin"},
                 r"noise2d\.perlin: the oracle has no merlin: write it in .*/oracle/noises"),
                ("fbm.fbm2", {"bound": "merlin"}, r"/oracle/sums\.py, and name it in SUMS"),
                ("hash.word", {"calls": "hn_merlin"}, r"/oracle/functions\.py, in OF_ROWS")):
            lattice = [setting for setting in SETTINGS if setting.name == "lattice"]
            file = GoldenFile(replace(FUNCTIONS[id], **change), lattice)
            with self.assertRaisesRegex(CatalogError, message):
                file.text()

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


class GoldenRows(Case):
    """Inputs that a file loses, and those that a new one gets."""

    def test_no_row_is_lost(self) -> None:
        rows_here = sum(head_of(golden.GOLDEN / file.name).rows for file in FILES.values())
        self.assertGreaterEqual(rows_here, 125_239, "those of version 1.1; an older row stays where it is")

    def test_a_new_function_takes_the_rows_of_the_one_most_like_it(self) -> None:
        for id, columns, like in (("noise2d.perlim", "noise2d.perlin", "noise2d.perlin_d"),
                                  ("noise3d.simplest", "noise3d.value", "noise3d.simplex_d")):
            new = replace(FUNCTIONS[columns], id=id)
            self.assertEqual(rows.most_alike(new, golden.GOLDEN).stem, like)
            self.assertEqual(rows.kept(new, fixed=True), rows.kept(FUNCTIONS[like], fixed=True))
        self.assertEqual(rows.kept(FUNCTIONS["noise2d.perlin"], fixed=False)[1], [])

    def test_rows_by_hand_count(self) -> None:
        function = FUNCTIONS["noise1d.perlin"]
        file = self.folder / "noise1d.perlin.golden"
        for text in ("c0000000 00000007\n3f000000 ffffffff = -\n",
                     "hashnoise golden 2\ncolumns x:f32 seed:u32 = old:f64\nrows 9\n3f000000 ffffffff = - = 3fe0000000000000\n"
                     "c0000000 00000007\ndigest lattice origin=1\n"):
            file.write_text(text)
            self.assertEqual(rows.kept(function, True, self.folder), ([(-2.0, 7)], [(0.5, 2**32 - 1)]))
        file.write_text(text.replace("x:f32", "x:i32"))
        (self.folder / "b.golden").write_text((golden.GOLDEN / "hash.word.golden").read_text())
        with self.assertRaisesRegex(CatalogError, "noise1d.perlin: no golden file has the columns x:f32 seed:u32: write"):
            rows.kept(function, True, self.folder)

    def test_other_seeds_are_the_only_change(self) -> None:
        function = FUNCTIONS["noise2d.perlin"]
        drawn, every = rows.redrawn(function, generator_of("seeds")), rows.kept(function, False)[0]
        self.assertEqual([row[:2] for row in drawn], [row[:2] for row in every])
        self.assertGreater(len({row[2] for row in drawn}), 0.9 * len(every))


class GoldenReader(Case):
    """golden_values.py: files that it reads, and files that it refuses."""

    def setUp(self) -> None:
        self.text = (golden.GOLDEN / "noise2d.simplex.golden").read_text()

    def read(self, text: str, setting: str = "lattice+fixed") -> Golden:
        (self.folder / "noise2d.simplex.golden").write_text(text)
        return Golden("noise2d.simplex", setting, self.folder)

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


class GoldenCheck(Case):
    """Faults that --check must notice, on a few files in a directory of its own."""

    def setUp(self) -> None:
        self.directory = self.folder / "golden"
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

    def test_a_sample_notices_a_digit_in_what_it_computes_and_in_all_inputs(self) -> None:
        """unit.expected reads the other values, and compares the twin with them."""
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
        for old, new in ((lines[7 + other][:8], "12345678"), (lines[7 + other], "")):
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
            wrong = {i - 7 for i, (line, right) in enumerate(zip(changed, text.split("\n"), strict=True))
                     if line != right}
            self.assertEqual(wrong, {i for i in chosen if i < every + of_fixed or file.function.family == "hash"})
            self.assertTrue(any(i >= every for i in wrong))
            self.assertLessEqual(len(wrong), lines)

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
