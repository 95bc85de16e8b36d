"""Tests of tools/make format, which is run by the test format.committed."""

from __future__ import annotations

import unittest

from base.testing import Case, called
from check.format import command

# An ending of files, a text that the formatters refuse, and their text for it.
CHANGED = ((".cpp", "int  f( ) {return 1 ;}\n", "int f() { return 1; }\n"),
           (".glsl", "float f(float x){return x;}\n", "float f(float x) { return x; }\n"),
           (".hlsl", "float f(float x){return x;}\n", "float f(float x) { return x; }\n"),
           (".py", "import sys\nimport os\nprint( os,sys)\n", "import os\nimport sys\n\nprint(os, sys)\n"))


class Format(Case):
    @classmethod
    def setUpClass(cls):
        if command.main(["--check", __file__]) == 4:
            raise unittest.SkipTest("PyPI cannot be reached, so there are no formatters")

    def setUp(self):
        (self.folder / ".clang-format").write_bytes((command.ROOT / ".clang-format").read_bytes())

    def test_what_is_not_formatted_is_reported_and_mended(self):
        for ending, wrong, right in CHANGED:
            file = self.folder / f"file{ending}"
            with self.subTest(file=file.name):
                file.write_text(wrong)
                status, printed = called(command.main, "--check", file)
                self.assertEqual((status, file.read_text()), (1, wrong))
                self.assertIn(f"{file}:1", printed)
                self.assertEqual(called(command.main, file), (0, ""))
                self.assertEqual(file.read_text(), right)
                self.assertEqual(called(command.main, "--check", file), (0, ""))

    def test_a_mistake_that_cannot_be_mended_is_reported(self):
        file = self.folder / "file.py"
        file.write_text("print(unknown)\n")
        status, printed = called(command.main, file)
        self.assertEqual(status, 1)
        self.assertIn("undefined-name", printed)
