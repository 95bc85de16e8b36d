"""Tests of tools/measure compile: its times, and how it treats compilers' messages."""

from __future__ import annotations

import contextlib
import io
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from measure.compile import command, texts
from measure.compile.texts import SUBJECTS, WAYS, fragment, shaders


class CompileTimes(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def main(self, *arguments: str) -> tuple[int, str]:
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            try:
                status = command.main(arguments)
            except SystemExit as stop:
                status = stop.code
        return status, errors.getvalue()

    def program(self, text: str) -> str:
        path = self.folder / "program"
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
        return str(path)

    def test_what_is_timed_compiles(self):
        for version in ("#version 330", "#version 300 es\nprecision highp float;\nprecision highp int;"):
            for subject, way, library in shaders():
                if way == "whole":  # another test compiles these
                    continue
                path = self.folder / "shader.frag"
                path.write_text(fragment(version, subject, library))
                done = subprocess.run(["glslangValidator", path], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{subject.picked}, {way}: {done.stdout}")

    def test_a_record_of_a_compiler(self):
        out = self.folder / "compile.csv"
        with mock.patch.object(texts, "SUBJECTS", SUBJECTS[:1]):
            self.assertEqual(self.main("--compiler", "glslang", "--rounds", "1", "--out", str(out))[0], 0)
        with mock.patch.object(command, "RECORD", out):
            rows = command.record()
        self.assertEqual([row["way"] for row in rows], list(WAYS))
        sizes = {row["way"]: int(row["bytes"]) for row in rows if row["function"] == "hn_perlin2"}
        self.assertGreater(sizes["whole"], 3 * sizes["part"])
        self.assertGreater(sizes["part"], 10 * sizes["pick"])

    def test_the_table(self):
        rows = [{"function": subject.picked, "way": way, "compiler": compiler, "bytes": "1500", "ms": f"{number}.4"}
                for subject in SUBJECTS for compiler in command.COMPILERS for number, way in enumerate(WAYS, 7)]
        self.assertIn("| `hn_perlin2` | 1.5 / 1.5 / 1.5 | 7 / 8 / 9 |", command.page_table(rows))
        with self.assertRaises(LookupError):
            command.page_table(rows[1:])

    def test_a_refused_shader_is_told(self):
        refusing = self.program("echo 'ERROR: 0:7: no such thing'; exit 2")
        with mock.patch.object(shutil, "which", return_value=refusing):
            status, errors = self.main("--compiler", "glslang", "--out", str(self.folder / "out.csv"))
        self.assertEqual(status, 1)
        self.assertIn("no such thing", errors)
        self.assertFalse((self.folder / "out.csv").exists())

    def test_a_page_that_fails_is_told(self):
        failing = self.program("echo '<pre id=\"times\">failed: there is no WebGL2</pre>'")
        with self.assertRaisesRegex(command.Failed, "failed: there is no WebGL2"):
            command.by_angle(failing, self.folder, 1)
        with self.assertRaisesRegex(command.Failed, "left no report"):
            command.by_angle(self.program("true"), self.folder, 1)

    def test_bad_usage(self):
        for arguments, message in ((["--compiler", "fxc"], "invalid choice: 'fxc'"), (["--rounds", "0"], "not from 1 to 100")):
            status, errors = self.main(*arguments)
            self.assertEqual(status, 2)
            self.assertIn(message, errors)
        with mock.patch.object(shutil, "which", return_value=None):
            status, errors = self.main("--compiler", "angle")
        self.assertEqual(status, 2)
        self.assertIn("there is no chromium", errors)


if __name__ == "__main__":
    unittest.main()
