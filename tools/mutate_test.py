"""Tests of tools/mutate: python3 tools/mutate_test.py

A script stands in for hn-conform, so that this takes no driver and no time.
"""

from __future__ import annotations

import contextlib
import io
import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # the tree stays clean: no __pycache__ beside the sources
from test_support import load_script  # noqa: E402

mutate = load_script("mutate")
SOURCES = {path.name: path.read_text(encoding="utf-8") for path in mutate.LIBRARY.glob("*.glsl")}
MUTANTS = mutate.all_mutants(SOURCES)


def changes(body: str) -> list[str]:
    """The body after each change of a constant."""
    return [body[:change.start] + change.new + body[change.end:] for change in mutate.change_constants(body)]


class Reading(unittest.TestCase):
    SOURCE = """// 1 { 2 }
#define ONE(x) { \\
  3 }
const int outside = 4;
/* 5 {
   6 */ int f(int x) {
#if 7 < 8  // { 9
  if (x < 10) { return 11; }  // 12
#else
  return 13;
#endif
}
int g() { return 14; }
"""

    def test_only_bodies_of_functions_are_changed_in_every_branch(self):
        found = mutate.all_mutants({"a.glsl": self.SOURCE})
        self.assertEqual([(m.line, m.old, m.new) for m in found], [
            (8, "10", "11"), (8, "10", "9"), (8, "11", "12"), (8, "11", "10"), (10, "13", "14"), (10, "13", "12"),
            (13, "14", "15"), (13, "14", "13")])

    def test_blanking_keeps_every_offset(self):
        code = mutate.code_of(self.SOURCE)
        self.assertEqual([len(line) for line in code.split("\n")], [len(line) for line in self.SOURCE.split("\n")])

    def test_braces_that_do_not_match_are_an_error(self):
        with self.assertRaises(ValueError):
            list(mutate.bodies("f() { {"))


class Constants(unittest.TestCase):
    def test_small_integers_get_their_neighbours(self):
        self.assertEqual(changes("a + 1u"), ["a + 2u", "a + 0u"])
        self.assertEqual(changes("a + 0"), ["a + 1"])
        self.assertEqual(changes("a & 0xFFu"), ["a & 0x100u", "a & 0xFEu"])

    def test_shifts_stay_below_the_word(self):
        self.assertEqual(changes("a << 31"), ["a << 30"])
        self.assertEqual(changes("a >>= 0x1F"), ["a >>= 0x1E"])

    def test_words_get_their_lowest_and_their_highest_bit_flipped(self):
        self.assertEqual(changes("k *= 0xFFFFFFFFu"), ["k *= 0xFFFFFFFEu", "k *= 0x7FFFFFFFu"])
        self.assertEqual(changes("k & 0x007FFF80u"), ["k & 0x007FFF81u", "k & 0x003FFF80u"])
        self.assertEqual(changes("k * 16777619u"), ["k * 16777618u", "k * 403u"])

    def test_floats_move_by_a_sixty_fourth(self):
        self.assertEqual(changes("0.0f"), ["0.015625f"])
        self.assertEqual(changes("f * 128.0f"), ["f * 130.0f"])
        self.assertEqual(changes("-1e2"), ["-101.5625"])

    def test_terms_of_quotients_move_by_one_unless_that_could_be_rounded_away(self):
        self.assertEqual(changes("1913.0f / 1024.0f"), ["1914.0f / 1024.0f", "1913.0f / 1025.0f"])
        self.assertEqual(changes("x / 65536.0f"), ["x / 66560.0f"])

    def test_digits_in_names_are_no_constants(self):
        self.assertEqual(changes("k1 = vec2(h00, d.x3).x_4"), [])


class Library(unittest.TestCase):
    def found(self, file: str, text: str) -> set[tuple[str, str]]:
        """The changes in the lines which contain the text."""
        lines = SOURCES[file].split("\n")
        return {(m.old, m.new) for m in MUTANTS if m.file == file and text in lines[m.line - 1]}

    def test_known_constants_are_changed(self):
        self.assertEqual(self.found("noise2d.glsl", "return (n0 + t.y"),
                         {("1913.0f", "1914.0f"), ("1024.0f", "1025.0f")})
        self.assertEqual(self.found("hash.glsl", "uvec2 hn_i_spread("),
                         {("0x85EBCA77u", "0x85EBCA76u"), ("0x85EBCA77u", "0x05EBCA77u")})
        self.assertEqual(self.found("fbm.glsl", "seed += "),
                         {("0x9E3779B9u", "0x9E3779B8u"), ("0x9E3779B9u", "0x1E3779B9u")})
        self.assertIn(("3.0f", "3.046875f"), self.found("hash.glsl", "uintBitsToFloat(((h"))  # with HN_I_BITCAST
        self.assertIn(("32768.0f", "33280.0f"), self.found("hash.glsl", "float(h >> 16)"))  # and without

    def test_files_without_functions_have_no_mutants(self):
        self.assertEqual({m.file for m in MUTANTS}, {"fbm.glsl", "gradient.glsl", "hash.glsl", "noise2d.glsl",
                                                   "noise3d.glsl"})

    def test_each_equivalence_is_of_mutants_that_there_are(self):
        for equivalence in mutate.EQUIVALENT:
            found = [m.new for m in MUTANTS if equivalence.covers(m)]
            self.assertEqual(sorted(found), sorted(equivalence.new), equivalence)
        self.assertEqual(sum(map(mutate.is_equivalent, MUTANTS)), sum(len(e.new) for e in mutate.EQUIVALENT))

    def test_each_mutant_has_exactly_one_change(self):
        self.assertEqual(len({(m.file, m.source) for m in MUTANTS}), len(MUTANTS))
        for mutant in MUTANTS:
            original = SOURCES[mutant.file].split("\n")
            changed = mutant.source.split("\n")
            self.assertEqual(len(original), len(changed))
            different = [i for i, (a, b) in enumerate(zip(original, changed), 1) if a != b]
            self.assertEqual(different, [mutant.line], mutant)
            before, rest = original[mutant.line - 1][:mutant.column - 1], original[mutant.line - 1][mutant.column - 1:]
            self.assertTrue(rest.startswith(mutant.old), mutant)
            self.assertEqual(changed[mutant.line - 1], before + mutant.new + rest[len(mutant.old):])

    def test_numbers_are_those_of_the_list(self):
        self.assertEqual([m.number for m in MUTANTS], list(range(1, len(MUTANTS) + 1)))

    def test_a_sample_is_reproducible_and_spread(self):
        chosen = mutate.sample(MUTANTS, 20, 1)
        self.assertEqual(chosen, mutate.sample(MUTANTS, 20, 1))
        self.assertNotEqual(chosen, mutate.sample(MUTANTS, 20, 2))
        for i, mutant in enumerate(chosen):
            self.assertIn(mutant, MUTANTS[i * len(MUTANTS) // 20:(i + 1) * len(MUTANTS) // 20])
        self.assertEqual(mutate.sample(MUTANTS, 10**6, 1), MUTANTS)


# What stands in for hn-conform: `unchanged` is its exit status for the library as it is, the others those for a mutant.
FAKE = """#!{python} -IS
import pathlib, sys
arguments = sys.argv[1:]
with open({log!r}, "a") as log: log.write(" ".join(arguments) + "\\n")
def value(name): return pathlib.Path(arguments[arguments.index(name) + 1])
changed = any(path.read_bytes() != (pathlib.Path({library!r}) / path.name).read_bytes()
              for path in value("--glsl").iterdir())
status = {unchanged}
if changed:
    status = {with_filter} if "--filter" in arguments else {without}
value("--out").mkdir(exist_ok=True)
if status == 1: (value("--out") / "results.json").write_text('''{results}''')
if status > 1: print("no driver", file=sys.stderr)
sys.exit(status)
"""

FAILURE = '{"runs": [{"cases": [{"id": "a.b", "status": "pass"}, {"id": "c.d", "status": "fail"}]}]}'
ERROR = '{"runs": [{"cases": [{"id": "c.d", "status": "error"}]}]}'


class Sweep(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.program = Path(scratch.name, "fake")
        self.log = Path(scratch.name, "log")

    def sweep(self, *arguments: str, unchanged=0, with_filter=1, without=1, results=FAILURE) -> tuple[int, str]:
        """Exit status and output with a program that ends so."""
        self.program.write_text(FAKE.format(
            python=sys.executable, log=str(self.log), library=str(mutate.LIBRARY), unchanged=unchanged,
            with_filter=with_filter, without=without, results=results), encoding="utf-8")
        self.program.chmod(0o755)
        return self.main("--program", str(self.program), "--file", "noise2d.glsl", "--sample", "2", *arguments)

    def main(self, *arguments: str) -> tuple[int, str]:
        output = io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            try:
                status = mutate.main(arguments)
            except SystemExit as stop:
                status = stop.code
        return status, output.getvalue()

    def test_all_killed(self):
        status, output = self.sweep()
        self.assertEqual(status, 0, output)
        self.assertEqual(output.count("killed by c.d\n"), 2)
        self.assertIn("2 mutants: 2 killed, 0 survived, 0 equivalent, 0 errors", output)

    def test_value_checks_of_the_file_run_first_and_the_whole_suite_only_if_they_pass(self):
        self.sweep("--jobs", "1", with_filter=1)
        filtered = [line.partition("--filter ")[2] for line in self.log.read_text().splitlines()]
        self.assertEqual(filtered, [""] + ["noise2d.*.golden --filter noise2d.*.unseeded"] * 2)
        self.log.unlink()
        status, output = self.sweep("--jobs", "1", with_filter=0, without=1)
        self.assertEqual((status, output.count("killed by c.d\n")), (0, 2))
        self.assertEqual([" --filter " in line for line in self.log.read_text().splitlines()],
                         [False, True, False, True, False])

    def test_survivors(self):
        status, output = self.sweep(with_filter=0, without=0)
        self.assertEqual(status, 1, output)
        self.assertEqual(output.count("SURVIVED\n"), 2)

    def test_a_program_that_cannot_judge_is_an_error(self):
        status, output = self.sweep(with_filter=3)
        self.assertEqual(status, 3, output)
        self.assertEqual(output.count("ERROR: exit status 3: no driver\n"), 2)

    def test_a_case_with_an_error_does_not_kill(self):
        self.assertEqual(self.sweep(results=ERROR)[0], 3)
        self.assertEqual(self.sweep(results="{")[0], 3)

    def test_the_unchanged_library_must_pass(self):
        status, output = self.sweep(unchanged=1)
        self.assertEqual(status, 3)
        self.assertIn("the unchanged library does not pass", output)
        self.assertEqual(len(self.log.read_text().splitlines()), 1)

    def test_listing_runs_nothing(self):
        status, output = self.main("--list", "--program", "/nowhere", "--file", "noise3d.glsl", "--file", "fbm.glsl")
        self.assertEqual(status, 0)
        self.assertEqual([int(line.split()[0]) for line in output.splitlines()],
                         [m.number for m in MUTANTS if m.file in ("noise3d.glsl", "fbm.glsl")])

    def test_bad_usage(self):
        for arguments in (["--sample", "0"], ["--jobs", "x"], ["--file", "nothing.glsl"], ["--program", os.devnull],
                          ["--list", "--file", "config.glsl"], ["--unknown"]):
            self.assertEqual(self.main(*arguments)[0], 2, arguments)


if __name__ == "__main__":
    unittest.main()
