"""Tests what CMake makes of an architecture, of HASHNOISE_INSTRUCTION_SETS and of a debug build, and that the sources
need no more of C++20's library than libc++ has: python3 configure_test.py CMAKE COMPILER

Nothing is compiled but CMake's own checks of the compiler; Clang reads the sources.
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


def configure(folder: str, *options: str, compiler: str = COMPILER, path: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run([CMAKE, "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                           "-DHASHNOISE_CONFORMANCE=OFF", *options], capture_output=True, text=True, check=False,
                          env={**os.environ, "PATH": f"{path}:{os.environ['PATH']}"})


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


class Library(unittest.TestCase):
    """libc++ has parts of C++20 later than GCC's library. The test grid.libcxx also runs what comes of it."""

    def messages(self, *sources: str | Path, text: str = "") -> str:
        return subprocess.run(["clang++", "-stdlib=libc++", "-std=c++20", "-fsyntax-only", "-DHASHNOISE_HAS_GENERIC",
                               "-I", ROOT / "include", "-x", "c++", *sources], input=text, capture_output=True,
                              text=True, check=False).stderr

    def test_libcxx_has_all_that_the_sources_need(self):
        headers = "".join(f"#include <hashnoise/{path.name}>\n" for path in (ROOT / "include/hashnoise").glob("*.hpp"))
        self.assertEqual(self.messages(ROOT / "src" / "grid" / "threads.cpp", "-", text=headers), "")

    def test_what_it_lacks_is_noticed(self):
        self.assertIn("jthread", self.messages("-", text="#include <thread>\nstd::jthread thread;\n"))


# The program that joins what Clang compiles for several architectures of a Mac. This one keeps the first.
LIPO = """#!/bin/sh
for word; do
  [ "$previous" = -output ] && output=$word || case $word in -*) ;; *) first=${first-$word} ;; esac
  previous=$word
done
cp "$first" "$output"
"""


class Architecture(unittest.TestCase):
    def test_a_program_for_several_has_what_all_have(self):
        for names, expected in (("x86_64;x86_64h", "sse4.1, avx2, avx512"), ("x86_64;arm64", "generic")):
            with self.subTest(names), tempfile.TemporaryDirectory() as folder:
                lipo = Path(folder, "lipo")
                lipo.write_text(LIPO)
                lipo.chmod(0o755)
                done = configure(folder, "-DCMAKE_SYSTEM_NAME=Darwin", "-DCMAKE_SYSTEM_PROCESSOR=x86_64",
                                 "-DCMAKE_CXX_COMPILER_TARGET=x86_64-apple-macos11",
                                 f"-DCMAKE_OSX_ARCHITECTURES={names}", f"-DCMAKE_OSX_SYSROOT={folder}",
                                 "-DCMAKE_HAVE_LIBC_PTHREAD=ON",
                                 "-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY", compiler="clang++", path=folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f"hashnoise::grid has kernels for {expected}\n", done.stdout)


class InstructionSets(unittest.TestCase):
    def configure(self, sets: str, *options: str) -> subprocess.CompletedProcess[str]:
        with tempfile.TemporaryDirectory() as folder:
            return configure(folder, f"-DHASHNOISE_INSTRUCTION_SETS={sets}", *options)

    def test_native_has_the_lowest_set(self):
        done = self.configure("native")
        self.assertEqual(done.returncode, 0, done.stderr)
        lowest = {"x86_64": "sse4.1", "aarch64": "neon"}.get(os.uname().machine, "generic")
        self.assertRegex(done.stdout, f"hashnoise::grid has kernels for {lowest}(, avx2|, avx512)?\n")

    def test_who_compiles_all_sets_is_told_how_long_that_takes(self):
        # The compiler decides, and not CMake's word for the processor, which is "x86" for Emscripten.
        done = self.configure("all", f"-DCMAKE_SYSTEM_NAME={os.uname().sysname}",
                              "-DCMAKE_SYSTEM_PROCESSOR=x86")
        self.assertEqual(done.returncode, 0, done.stderr)
        announced = "more than a minute of processor time for each" in " ".join(done.stdout.split())
        self.assertEqual(announced, os.uname().machine == "x86_64")

    def test_a_wrong_name_is_an_error_that_has_the_right_ones_and_the_nearest(self):
        right, other = {"x86_64": ("sse4.1", "SSE41"), "aarch64": ("neon", "Neon")}.get(os.uname().machine,
                                                                                        ("native", "Native"))
        for wrong, nearest in (("sse2", ""), (other, f" (did you mean {right}?)")):
            done = self.configure(wrong)
            self.assertNotEqual(done.returncode, 0)
            said = " ".join(done.stderr.split())
            self.assertIn(f'HASHNOISE_INSTRUCTION_SETS has "{wrong}"{nearest}.', said)
            self.assertRegex(said, "all, native, or a list of these sets of this architecture: "
                                   r"(sse4\.1, avx2, avx512|neon|generic)\.")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
