"""Tests of the search for errors, and of its record."""

import contextlib
import io
import math
import unittest
from dataclasses import replace
from unittest import mock

from proof.bounds.rounded import Body
from proof.errors import command, record, results
from proof.errors.program import Program
from proof.errors.record import Entry, Key

KEY = Key("perlin", 2, "octahedral", "value", "", "cell", "floats")
ENTRY = Entry(KEY, proven=3e-6, found=1e-6, short=0.9e-6)
# Bodies of numbers x and y in [0, 1]; errors are in units of 2^-24.
ULP = 2.0**-24
BODIES = {
    "sum": "x + 1.0f", "product": "x * 0.5f", "fused": "x * x - x * x", "quotient": "1.0f / (x + 1.0f)",
    # Where the root is of 0 it loses half of the digits, and no random place is near.
    "singular": "sqrt(max(x * x - x * 0.6f + (y * y - y * 1.4f) + 0.58f, 0.0f))"}


class Search(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.program = Program({name: Body.of("x:f32 y:f32", "value:f64", (
            f"hn_float x = float_of(a.x), y = float_of(a.y); return uvec4(bits_of({code}), 0u, 0u, 0u);")) for name, code in BODIES.items()})

    def found(self, name: str, seed: int = 1, effort: int = 4000):
        of, = self.program.search(name, ["float:0:1"] * 2, ["0:inf:one"], effort, seed)
        return of

    def test_known_errors(self):
        self.assertAlmostEqual(self.found("sum").error / ULP, 2.0, delta=0.05)
        self.assertEqual(self.found("product").error, 0.0)
        self.assertAlmostEqual(self.found("fused").error / ULP, 1.0, delta=0.05)
        self.assertTrue(2.5 < self.found("quotient").error / ULP < 5.0)

    def test_it_walks_to_singular_places(self):
        of = self.found("singular")
        self.assertGreater(of.error, 20 * of.random)

    def test_the_same_seed_finds_the_same(self):
        self.assertEqual(self.found("sum", 5), self.found("sum", 5))
        self.assertNotEqual(self.found("sum", 5).words, self.found("sum", 6).words)


class Record(unittest.TestCase):
    def test_published_is_at_most_what_was_proven(self):
        for entry, most in ((ENTRY, 2e-6), (replace(ENTRY, proven=1.5e-6), 1.5e-6),
                            # A search that has not come to its end, and none.
                            (replace(ENTRY, short=0.4e-6), 3e-6), (replace(ENTRY, found=math.nan, short=math.nan), 3e-6)):
            self.assertAlmostEqual(entry.published, most, delta=1e-20)

    def test_what_is_missing_is_reported(self):
        with self.assertRaisesRegex(LookupError, "record.csv has no row of merlin, 2D, value, from a cell, floats: run tools/make errors"):
            record.published("merlin", 2, "none")
        with mock.patch.object(record, "read", return_value={KEY: replace(ENTRY, proven=math.inf)}):
            with self.assertRaisesRegex(LookupError, "perlin, .* is measured, and a proof needs one that is proven"):
                record.proven("perlin", 2, "octahedral")

    def test_it_is_read_as_it_is_written(self):
        self.assertEqual(record.text_of(record.read().values()), record.PATH.read_text(encoding="utf-8"))

    def test_nothing_exceeds_what_was_proven(self):
        for entry in record.read().values():
            self.assertFalse(entry.found > entry.proven, entry)
            if entry.key.name.startswith("cellular") and entry.key.name != "cellular_smooth" and (
                    entry.key.result, entry.key.arithmetic) == ("value", "fixed") and entry.key.name != "cellular_phase":
                self.assertGreater(entry.found, 0.85 * entry.proven, entry)

    def test_every_output_has_a_key(self):
        bodies = results.bodies()
        for search in results.searches():
            self.assertEqual(len(search.keys), len(bodies[search.function].outputs), search)


class Check(unittest.TestCase):
    def messages(self, error: float, entry: Entry = ENTRY):
        return command.wrong({KEY: error}, {KEY: entry})

    def test_each_fault_is_reported(self):
        self.assertEqual(self.messages(0.9e-6), [])
        self.assertRegex(self.messages(2.1e-6)[0], "an error of 2.1e-06, and the published one is 2e-06")
        self.assertRegex(self.messages(1.5e-6)[0], "the text has changed")
        self.assertRegex(self.messages(0.5e-6)[0], "the text has changed")
        self.assertRegex(self.messages(0.9e-6, replace(ENTRY, proven=0.95e-6))[0], "1.1.0 proved 9.5e-07")
        self.assertRegex(command.wrong({KEY: 1e-6}, {})[0], "has no row of it")
        self.assertRegex(command.wrong({}, {KEY: ENTRY})[0], "nothing searches it")

    def test_bad_usage(self):
        for options in (["--function", "f"], ["--within", "p=1"], ["own.glsl", "--check"]):
            with self.assertRaises(SystemExit) as stopped, contextlib.redirect_stderr(io.StringIO()):
                command.main(options)
            self.assertEqual(stopped.exception.code, 2)

    def test_errors_are_as_recorded(self):
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            status = command.main(["--check"])
        self.assertEqual(status, 0, shown.getvalue())
