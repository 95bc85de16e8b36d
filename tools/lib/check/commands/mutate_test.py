"""Tests of tools/test mutants

A script stands in for hn-conform, so that this takes no driver and no time.
"""

from __future__ import annotations

import os
import re
import sys
import unittest

from base.testing import Case, called
from base.tree import ROOT
from check.mutation import command as mutate
from check.mutation.equivalent import EQUIVALENT, Equivalence, is_equivalent
from check.mutation.mutants import Mutant, all_mutants, sample

SOURCES = {name: path.read_text(encoding="utf-8") for name, path in mutate.glsl_files(mutate.LIBRARY).items()}
MUTANTS = all_mutants(SOURCES)


class Library(unittest.TestCase):
    def test_every_file_and_every_rule_has_mutants(self):
        self.assertEqual({m.file for m in MUTANTS}, set(SOURCES))
        self.assertEqual({m.rule for m in MUTANTS}, {*mutate.rules.RULES, "directive"})
        self.assertGreaterEqual(len(MUTANTS), 1000)

    def test_each_equivalence_is_of_mutants_that_there_are(self):
        for equivalence in EQUIVALENT:
            count = SOURCES[equivalence.file].count(equivalence.old)
            mutants = [m for m in MUTANTS if m.file == equivalence.file]
            self.assertGreater(count, 0, equivalence)
            for new in equivalence.new:
                alone = Equivalence(equivalence.file, equivalence.old, (new,))
                found = len([m for m in mutants if alone.covers(m)])
                self.assertTrue(0 < found <= count, (equivalence, new))  # less where a piece stands for C++ as well

    def test_what_is_squared_or_commutes_is_equivalent_and_its_neighbours_are_not(self):
        def verdicts(file: str, text: str, *changes: tuple[str, str]) -> list[bool]:
            lines = SOURCES[file].split("\n")
            return [is_equivalent(m) for change in changes for m in MUTANTS
                    if m.file == file and text in lines[m.line - 1] and m.change().split(" -> ") == list(change)]

        octave, root, falloff = "detail/octave.glsl", "detail/square_root.glsl", "detail/falloff.glsl"
        self.assertEqual(verdicts(octave, "hn_uint high = ", ("uint(x.x), ratio", "ratio, uint(x.x)"),
                                  ("ratio, 0u", "0u, ratio")), [True, False])
        self.assertEqual(verdicts(root, "hn_i_squared(x * m, y * m, z * m)", ("x", "-x"), ("z", "-z"), ("max", "-max"),
                                  ("x * m, y * m", "y * m, x * m"), ("y * m, z * m", "z * m, y * m")),
                         [True, True, False, True, False])
        self.assertEqual(verdicts("detail/body_centred_lattice.glsl", "hn_i_square(dx.x, dy.x, dz.x, dw.x)",
                                  ("dx.x, dy.x", "dy.x, dx.x"), ("dw", "-dw"), ("dx", "f")), [True, True, False])
        for text, verdict in (("hn_i_magnitude(hn_i_octave(n))", True),
                              ("hn_i_magnitude(hn_i_bounded_octave(n))", True),
                              ("hn_i_ridge(hn_i_bounded_octave(n))", True),
                              ("hn_i_height(hn_i_bounded_octave(n))", False)):
            self.assertEqual(verdicts(octave, text, ("n", "-n")), [verdict], text)
        for function, verdict in (("turbulence", True), ("ridged", True), ("hybrid", False)):
            self.assertEqual(verdicts("octaves4d.glsl", f"hn_add_{function}(", ("n", "-n")), [verdict], function)
        self.assertEqual(verdicts(falloff, "hn_i_square_plus(hn_uint q", ("x", "-x")), [False])
        self.assertEqual(verdicts(falloff, "ivec2(hn_i_magnitude(x), hn_i_magnitude(y))", ("x", "-x")), [True])

    def test_an_equivalence_covers_nothing_else(self):
        source = "a = f(x - y);\nb = f(x - y) - x - y;\n"
        equivalence = Equivalence("a", "x - y)", ("x + y)", "y - x)"))

        def covered(file: str, start: int, end: int, new: str) -> bool:
            return equivalence.covers(Mutant(1, file, "rule", source, start, end, new))

        self.assertTrue(covered("a", 8, 9, "+"))
        self.assertTrue(covered("a", 6, 11, "y - x"))
        self.assertTrue(covered("a", 22, 23, "+"))
        self.assertFalse(covered("a", 8, 9, "*"))
        self.assertFalse(covered("b", 8, 9, "+"))
        self.assertFalse(covered("a", 31, 32, "+"))

    def test_each_mutant_has_one_change(self):
        self.assertEqual(len({(m.file, m.source) for m in MUTANTS}), len(MUTANTS))
        for mutant in MUTANTS:
            self.assertNotEqual(mutant.source, SOURCES[mutant.file], mutant)
            self.assertEqual(mutant.source[:mutant.start] + mutant.old + mutant.source[mutant.start + len(mutant.new):],
                             SOURCES[mutant.file])

    def test_a_mutant_tells_its_place_and_its_change(self):
        source = "int f(int a) {\n  return a +\n a;\n}\n"
        for start, end, new, expected in ((26, 27, "-", "   1  a:2:12                + -> -"),
                                          (24, 24, "-", "   1  a:2:10                a -> -a"),
                                          (24, 30, "", "   1  a:2:10                a + a -> nothing")):
            self.assertEqual(str(Mutant(1, "a", "rule", source, start, end, new)), expected)

    def test_numbers_are_those_of_the_list(self):
        self.assertEqual([m.number for m in MUTANTS], list(range(1, len(MUTANTS) + 1)))

    def test_a_sample_is_reproducible_and_spread(self):
        chosen = sample(MUTANTS, 20, 1)
        self.assertEqual(chosen, sample(MUTANTS, 20, 1))
        self.assertNotEqual(chosen, sample(MUTANTS, 20, 2))
        for i, mutant in enumerate(chosen):
            self.assertIn(mutant, MUTANTS[i * len(MUTANTS) // 20:(i + 1) * len(MUTANTS) // 20])
        self.assertEqual(sample(MUTANTS, 10**6, 1), MUTANTS)


# A stand-in for hn-conform: `unchanged` is its exit status for the library as it is, the others those for a mutant.
FAKE = """#!{python} -IS
import pathlib, sys
arguments = sys.argv[1:]
with open({log!r}, "a") as log: log.write(" ".join(arguments) + "\\n")
def value(name): return pathlib.Path(arguments[arguments.index(name) + 1])
copy = value("--glsl")
changed = any(path.read_bytes() != (pathlib.Path({library!r}) / path.relative_to(copy)).read_bytes()
              for path in copy.rglob("*.glsl"))
status = {unchanged}
if changed:
    status = {with_filter} if "--filter" in arguments else {without}
value("--out").mkdir(exist_ok=True)
if status == 1: (value("--out") / "results.json").write_text('''{results}''')
if status > 1: print("no driver", file=sys.stderr)
sys.exit(status)
"""

FAILURE = '{"runs": [{"cases": [{"id": "a.b", "status": "pass"}, {"id": "c.d", "status": "fail", "samples": 9}]}]}'
CRASH, TIMEOUT = FAILURE.replace("fail", "crash"), FAILURE.replace("fail", "timeout")
WARNING = FAILURE.replace("fail", "warning")
UNCOMPILED = '{"runs": [{"cases": [{"id": "c.d", "status": "fail", "samples": 0}]}]}'
REFUSED = UNCOMPILED.replace("c.d", "config.hash_0.any.fast.fragment.gl330.refused_by_driver")
ERROR = '{"runs": [{"cases": [{"id": "c.d", "status": "error"}]}]}'


class Statuses(unittest.TestCase):
    def body(self, function: str) -> str:
        text = (ROOT / "conformance" / "expected" / "verdict.cpp").read_text(encoding="utf-8")
        found = re.search(rf"^[^ ].*\b{function}\(.*\{{\n((?:  .*\n|\n)*)\}}", text, re.MULTILINE)
        self.assertIsNotNone(found, f"verdict.cpp has no function {function} that can be read")
        return found[1]

    def test_all_that_are_bad_kill_but_error(self):
        names = set(re.findall(r'"(\w+)"[,}]', self.body("name_of")))
        bad = names - set(re.findall(r"!= Status::(\w+)", self.body("is_bad")))
        self.assertLessEqual({"pass", "error"}, names - set(mutate.KILLING))
        self.assertEqual(set(mutate.KILLING), bad - {"error"})


class Sweep(Case):
    def setUp(self):
        self.log = self.folder / "log"

    def sweep(self, *arguments: str, unchanged=0, with_filter=1, without=1, results=FAILURE) -> tuple[int, str]:
        """Exit status and output with a program that ends so."""
        program = self.script("fake", FAKE.format(
            python=sys.executable, log=str(self.log), library=str(mutate.LIBRARY), unchanged=unchanged,
            with_filter=with_filter, without=without, results=results))
        return called(mutate.main, "--program", program, "--file", "perlin2d.glsl", "--sample", "2", *arguments)

    def test_the_verdicts(self):
        """How hn-conform ends, and then the status of the command, and a text that it prints so often."""
        thorough, unsound = ("--thorough", "--jobs", "1"), "library does not pass, so a mutant proves nothing: "
        only_thorough = {"with_filter": "int('--thorough' in arguments)", "without": 0}
        for arguments, ends, expected, text, count in (
                ((), {}, 0, "killed by c.d\n", 2),
                ((), {}, 0, "2 mutants: 2 killed (0 of them did not compile), 0 survived (0 of them not --thorough), "
                 "0 equivalent, 0 errors", 1),
                *(((), {"results": kills}, 0, "killed by c.d\n", 2) for kills in (CRASH, TIMEOUT)),
                *(((), {"results": kills_not}, 3, "  ERROR: ", 2) for kills_not in (WARNING, ERROR, "{")),
                ((), {"results": UNCOMPILED}, 0, "2 killed (2 of them did not compile)", 1),
                ((), {"results": REFUSED}, 0, "2 killed (0 of them did not compile)", 1),
                (thorough, only_thorough, 1, "SURVIVED, and killed with --thorough by c.d\n", 2),
                (thorough, only_thorough, 1, "2 survived (2 of them not --thorough)", 1),
                ((), {"with_filter": 3}, 3, "ERROR: exit status 3: no driver\n", 2),
                ((), {"unchanged": "int('c.d' in arguments)"}, 3, f"{unsound}killed by c.d", 1)):
            with self.subTest(text, ends=ends):
                status, output = self.sweep(*arguments, **ends)
                self.assertEqual((status, output.count(text)), (expected, count), output)

    def test_the_sums_by_rule_and_by_file(self):
        output = self.sweep("--file", "perlin3d.glsl", "--sample", "3")[1]
        rows = [line.split() for line in output.splitlines()]
        self.assertIn(["file", "mutants", *mutate.KINDS], rows)
        self.assertIn(["perlin3d.glsl", "2", "2", "0", "0", "0", "0", "0"], rows)
        self.assertIn(["perlin2d.glsl", "1", "1", "0", "0", "0", "0", "0"], rows)
        self.assertEqual(rows.count(["all", "3", "3", "0", "0", "0", "0", "0"]), 2)

    def used(self) -> list[list[str]]:
        """The filters of each run."""
        lines = self.log.read_text().splitlines()
        self.log.unlink()
        return [line.split(" --filter ")[1:] for line in lines]

    def test_cheap_cases_of_the_file_run_first_and_the_whole_suite_only_if_they_pass(self):
        filters = [list(stage) for stage in mutate.stages_of("perlin2d.glsl")]
        self.assertEqual(filters[-1], [])
        self.assertIn("noise2d.perlin.*.golden", filters[0])
        self.assertIn("noise2d.perlin.*", filters[1])
        self.sweep("--jobs", "1", with_filter=1)
        self.assertEqual(self.used(), [[mutate.NOISE], filters[0], filters[0], ["c.d"]])
        status, output = self.sweep("--jobs", "1", with_filter=0, without=1)
        self.assertEqual((status, output.count("killed by c.d\n")), (0, 2))
        self.assertEqual(self.used(), [[mutate.NOISE], *filters, *filters, ["c.d"]])

    def test_a_file_without_functions_is_judged_by_those_that_include_it(self):
        for file in ("detail/arithmetic.glsl", "detail/cell.glsl", "detail/cubic_spline.glsl", "detail/feature_points2d.glsl"):
            own, near = mutate.judges_of(file)
            self.assertEqual(own, ())
            self.assertTrue(near, file)
            self.assertLessEqual(len(near), mutate.MOST_NEAR)
        self.assertIn("noise2d.cell_border", mutate.judges_of("detail/feature_points2d.glsl")[1])

    def test_every_file_has_stages_and_ends_with_the_whole_suite(self):
        for file in SOURCES:
            stages = mutate.stages_of(file)
            self.assertGreater(len(stages), 1, file)
            self.assertEqual(stages[-1], (), file)

    def test_survivors(self):
        status, output = self.sweep(with_filter=0, without=0)
        self.assertEqual(status, 1, output)
        self.assertEqual(output.count("SURVIVED\n"), 2)
        self.assertEqual(len(output.partition("Survivors:\n")[2].splitlines()), 3)  # two, and the sum

    def test_the_unchanged_library_must_pass(self):
        status, output = self.sweep(unchanged=1)
        self.assertEqual(status, 3)
        self.assertIn("the unchanged library does not pass", output)
        self.assertEqual(len(self.log.read_text().splitlines()), 1)

    def test_listing_runs_nothing(self):
        status, output = called(mutate.main, "--list", "--program", "/nowhere", "--file", "perlin3d.glsl", "--file", "fbm2d.glsl")
        self.assertEqual(status, 0)
        self.assertEqual([int(line.split()[0]) for line in output.splitlines()],
                         [m.number for m in MUTANTS if m.file in ("perlin3d.glsl", "fbm2d.glsl")])

    def test_only_one_rule(self):
        status, output = called(mutate.main, "--list", "--program", "/nowhere", "--rule", "shift")
        self.assertEqual((status, len(output.splitlines())), (0, sum(m.rule == "shift" for m in MUTANTS)))

    def test_a_sample_has_no_equivalent_mutants(self):
        output = called(mutate.main, "--list", "--program", "/nowhere", "--sample", "1000000")[1]
        numbers = {int(line.split()[0]) for line in output.splitlines()}
        self.assertEqual(numbers, {m.number for m in MUTANTS if not is_equivalent(m)})

    def test_bad_usage(self):
        for arguments in (["--sample", "0"], ["--jobs", "x"], ["--file", "nothing.glsl"], ["--program", os.devnull],
                          ["--list", "--file", "config.glsl", "--rule", "shift"], ["--rule", "x"], ["--unknown"]):
            self.assertEqual(called(mutate.main, *arguments)[0], 2, arguments)
