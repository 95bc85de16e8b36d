"""The lanes of <hashnoise/lanes.hpp>: python3 lanes_test.py [--thorough] COMPILER...

The functions over lanes have the values of the scalar twin bit by bit, and a condition that differs between lanes is
noticed. The values of two settings are tried at few points, each by one compiler, and with --thorough those of all by each
compiler at many.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from collections.abc import Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
THOROUGH = "--thorough" in sys.argv
COMPILERS = [argument for argument in sys.argv[1:] if argument != "--thorough"]
POINTS = [] if THOROUGH else ["-DFEW_POINTS"]
SETTINGS = (["HN_ARITHMETIC=HN_FAST"],
            ["HN_ARITHMETIC=HN_PRECISE", "HN_HASH=HN_HASH_FNV1", "HN_GRADIENT=HN_GRADIENT_SINE"],
            ["HN_ARITHMETIC=HN_FIXED", "HN_HASH=HN_HASH_PCG"])
# What the processor must have to run what is compiled for a machine.
MACHINES = {"x86-64-v2": "sse4_2", "x86-64-v3": "avx2", "x86-64-v4": "avx512vl"}
PROCESSOR = Path("/proc/cpuinfo").read_text().split() if Path("/proc/cpuinfo").exists() else []
LANES = ("LANES", "HN_LANES_CHECKED")


class Lanes(unittest.TestCase):
    known: dict[tuple[str, ...], list[str]] = {}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = Path(folder.name, "lanes")

    def compiled(self, compiler: str, *macros: str, flags: Sequence[str] = ("-ffp-contract=off",)) -> str:
        """What the compiler says; nothing if it compiles."""
        # The values do not depend on what is inlined. Where it is everything, as the library asks, compilers take long.
        command = [compiler, "-std=c++20", "-O1", "-Dalways_inline=noinline", *flags, "-Wall", "-Wextra",
                   "-Werror", "-I", str(INCLUDE), *POINTS, *(f"-D{macro}" for macro in macros), str(HERE / "lanes.cpp"), "-o",
                   str(self.program)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else f"exit status {done.returncode}: {done.stderr}"

    def scalar(self, *macros: str) -> list[str]:
        """The digests of the scalar twin. They are the same with each compiler: nothing is contracted."""
        if macros not in self.known:
            self.known[macros] = self.digests(COMPILERS[0], *macros)
        return self.known[macros]

    def digests(self, compiler: str, *macros: str) -> list[str]:
        self.assertEqual(self.compiled(compiler, *macros), "")
        lines = self.printed()
        self.assertGreater(len(lines), 5)
        return lines

    def printed(self) -> list[str]:
        return subprocess.run([self.program], capture_output=True, text=True, check=True).stdout.splitlines()

    def test_the_values_are_those_of_the_scalar_twin(self):
        for number, setting in enumerate(SETTINGS if THOROUGH else SETTINGS[::2]):
            for compiler in COMPILERS if THOROUGH else [COMPILERS[number % len(COMPILERS)]]:
                with self.subTest(compiler=compiler, setting=setting):
                    self.assertEqual(self.digests(compiler, *setting, *LANES), self.scalar(*setting))

    def test_fixed_bits_do_not_follow_the_flags(self):
        setting = SETTINGS[2]
        machines = [name for name, flag in MACHINES.items() if flag in PROCESSOR]
        for compiler in COMPILERS if THOROUGH else COMPILERS[-1:]:
            for machine in machines[-1:]:
                flags = ["-ffast-math", f"-march={machine}"]
                with self.subTest(compiler=compiler, flags=flags):
                    self.assertEqual(self.compiled(compiler, *setting, *LANES, flags=flags), "")
                    self.assertEqual(self.printed(), self.scalar(*setting))

    def test_numbers_of_a_word_are_the_same_with_every_setting(self):
        exact = ("pcg3d", "normal", "ball", "sobol", "shuffle")
        found = [[line for line in self.scalar(*setting) if line.split()[0] in exact] for setting in SETTINGS[::2]]
        self.assertEqual(len(found[0]), len(exact))
        self.assertEqual(found[0], found[1])

    def test_a_lane_that_takes_the_value_of_another_is_noticed(self):
        faulty = self.digests(COMPILERS[0], *SETTINGS[0], *LANES, "FAULTY_LANE")
        self.assertEqual([line for line in self.scalar(*SETTINGS[0]) if line in faulty], [])

    def test_what_lanes_cannot_do_is_noticed(self):
        for use in ("x >> 8", "x + 1"):
            self.assertIn("error", self.compiled(COMPILERS[0], *LANES, f"UNFIT={use}"), use)
        for use, works in (("x > y ? x : y", False), ("hn_i_select(x > y, x, y)", True)):
            self.assertEqual(self.compiled(COMPILERS[0], *LANES, f"UNFIT={use}"), "")
            self.assertEqual(subprocess.run([self.program], capture_output=True, check=False).returncode == 0, works, use)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
