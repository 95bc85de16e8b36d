"""Tests what CMake makes of HASHNOISE_INSTRUCTION_SETS and of a debug build: python3 configure_test.py CMAKE COMPILER

Nothing is compiled but CMake's own checks of the compiler.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CMAKE, COMPILER = sys.argv[1:3]


def configure(folder: str, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={COMPILER}",
                           "-DHASHNOISE_CONFORMANCE=OFF", *options], capture_output=True, text=True, check=False)


class Debug(unittest.TestCase):
    def test_kernels_have_lines_and_no_variables(self):
        for build, last in (("Debug", "-g1"), ("RelWithDebInfo", "-g1"), ("Release", None)):
            with self.subTest(build), tempfile.TemporaryDirectory() as folder:
                done = configure(folder, f"-DCMAKE_BUILD_TYPE={build}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
                self.assertEqual(done.returncode, 0, done.stderr)
                commands = json.loads(Path(folder, "compile_commands.json").read_text(encoding="utf-8"))
                kernels = [one["command"].split() for one in commands if "-kernels-" in one["command"]]
                self.assertTrue(kernels)
                for command in kernels:
                    given = [None, *(flag for flag in command if flag.startswith("-g") and "gnu" not in flag)]
                    self.assertEqual(given[-1], last)


class InstructionSets(unittest.TestCase):
    def configure(self, sets: str) -> subprocess.CompletedProcess[str]:
        with tempfile.TemporaryDirectory() as folder:
            return configure(folder, f"-DHASHNOISE_INSTRUCTION_SETS={sets}")

    def test_native_has_the_lowest_set(self):
        done = self.configure("native")
        self.assertEqual(done.returncode, 0, done.stderr)
        lowest = {"x86_64": "sse4.1", "aarch64": "neon"}.get(os.uname().machine, "generic")
        self.assertRegex(done.stdout, f"hashnoise::grid has kernels for {lowest}(, avx2|, avx512)?\n")

    def test_who_compiles_all_sets_is_told_how_long_that_takes(self):
        done = self.configure("all")
        self.assertEqual(done.returncode, 0, done.stderr)
        announced = "more than a minute of processor time for each" in " ".join(done.stdout.split())
        self.assertEqual(announced, os.uname().machine == "x86_64")

    def test_a_wrong_name_is_an_error_that_has_the_right_ones(self):
        done = self.configure("sse2")
        self.assertNotEqual(done.returncode, 0)
        said = " ".join(done.stderr.split())
        self.assertIn('HASHNOISE_INSTRUCTION_SETS has "sse2".', said)
        self.assertNotIn("did you mean", said)
        self.assertRegex(said, r"all, native, or a list of these sets of \w+: (sse4\.1, avx2, avx512|neon|generic)\.")

    def test_another_spelling_is_an_error_that_has_the_name(self):
        right, other = {"x86_64": ("sse4.1", "SSE41"), "aarch64": ("neon", "Neon")}.get(os.uname().machine,
                                                                                        ("native", "Native"))
        done = self.configure(other)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"(did you mean {right}?)", " ".join(done.stderr.split()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
