"""The library for ARM: python3 neon_test.py DIGESTS FOLDER

It is compiled with Debian's cross compiler into FOLDER, which is kept, and run under qemu. What it computes has the
digests that the native program DIGESTS prints. Without the compiler or qemu it is skipped (status 77).
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
COMPILER = "aarch64-linux-gnu-g++"
QEMU = "qemu-aarch64"
SYSTEM = "/usr/aarch64-linux-gnu"  # where Debian keeps the libraries of the cross compiler
DIGESTS, FOLDER = (Path(argument).resolve() for argument in sys.argv[1:3])


def output_of(*command: object) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command[0]} ended with {done.returncode}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def differences(ours: str, theirs: str) -> list[str]:
    """The lines of the first text that the second lacks."""
    return sorted(set(ours.splitlines()) - set(theirs.splitlines()))


class Neon(unittest.TestCase):
    def test_the_bits_are_those_of_the_native_library(self):
        # It is compiled for this test alone, and not by ninja's jobs but by those of ctest.
        output_of("cmake", "-S", ROOT, "-B", FOLDER, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                  "-DCMAKE_SYSTEM_NAME=Linux", "-DCMAKE_SYSTEM_PROCESSOR=aarch64", f"-DCMAKE_CXX_COMPILER={COMPILER}",
                  "-DHASHNOISE_CONFORMANCE=OFF", "-DHASHNOISE_INSTALL=OFF")
        output_of("cmake", "--build", FOLDER, "--target", "hashnoise-grid", "--parallel", os.cpu_count() or 1)
        program = FOLDER / "digests"
        output_of(COMPILER, "-std=c++20", "-O1", "-I", ROOT / "include", Path(__file__).with_name("digests.cpp"),
                  FOLDER / "src/grid/libhashnoise-grid.a", "-o", program, "-pthread")
        native = output_of(DIGESTS)
        self.assertGreater(len(native.splitlines()), 200)
        self.assertEqual(differences(native, output_of(QEMU, "-L", SYSTEM, program, "neon")), [])

    def test_a_digest_that_differs_is_noticed(self):
        native = output_of(DIGESTS)
        first = native.splitlines()[0]
        self.assertEqual(differences(native, native.replace(first, first[:-1] + "x")), [first])


if __name__ == "__main__":
    missing = [program for program in (COMPILER, QEMU) if shutil.which(program) is None]
    if missing:
        print(f"skipped: there is no {' and no '.join(missing)}")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
