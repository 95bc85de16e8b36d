"""Tests of tools/test fuzz

Scripts stand in for the fuzzers, so that this takes no build and no time. fuzz.corpus tests the fuzzers
themselves, and that they find a planted fault.
"""

from __future__ import annotations

import unittest
from unittest import mock

from base.testing import Case, called
from check.fuzz import command as fuzz

SOUND = """echo "$@" > "$(dirname "$0")/called"
echo stat::number_of_executed_units: 1234
"""
BROKEN = """echo ERROR: AddressSanitizer: heap-buffer-overflow
exit 77
"""


class Fuzzing(Case):
    def program(self, target: str, text: str) -> None:
        self.script(f"conformance/fuzz-{target}", text)

    def call(self, *arguments: str) -> tuple[int, str]:
        with mock.patch.object(fuzz, "build"):
            return called(fuzz.main, "--build", self.folder, *arguments)

    def test_nothing_found_is_0(self) -> None:
        self.program("golden", SOUND)
        status, text = self.call("--seconds", "5", "golden")
        self.assertEqual(status, 0)
        self.assertRegex(text, "golden +nothing found in 1,234 inputs")
        called = (self.folder / "conformance" / "called").read_text(encoding="utf-8")
        self.assertIn("-max_total_time=5", called)
        self.assertIn(str(fuzz.FUZZ / "corpus" / "golden"), called)

    def test_something_found_is_1_and_says_what_and_where(self) -> None:
        self.program("golden", BROKEN)
        self.program("results", SOUND)
        status, text = self.call("--runs", "5", "golden", "results")
        self.assertEqual(status, 1)
        self.assertIn("heap-buffer-overflow", text)
        self.assertIn(str(self.folder / "findings" / "golden" / "findings"), text)
        self.assertIn("results", text, "the others are run all the same")

    def test_bad_usage_is_2(self) -> None:
        for arguments in (["nothing"], ["--seconds", "0"], ["--runs", "x"], ["--runs", "1", "--seconds", "1"], ["--walk"]):
            self.assertEqual(self.call(*arguments)[0], 2, arguments)

    def test_what_cannot_be_built_is_4(self) -> None:
        with mock.patch.dict("os.environ", {"PATH": "/nowhere"}):
            status, text = called(fuzz.main, "--build", self.folder, "golden")
        self.assertEqual(status, 4)
        self.assertIn("cmake", text)


class Corpus(unittest.TestCase):
    def test_every_target_has_one_that_is_small(self) -> None:
        self.assertTrue(fuzz.TARGETS)
        for target in fuzz.TARGETS:
            files = list((fuzz.FUZZ / "corpus" / target).iterdir())
            self.assertTrue(files, target)
            for file in files:
                self.assertLess(file.stat().st_size, 4096, file)
            self.assertTrue((fuzz.FUZZ / "corpus" / f"{target}.dict").exists(), target)
