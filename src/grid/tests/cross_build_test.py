"""The library on other machines and with other compilers: python3 cross_build_test.py WHERE DIGESTS FOLDER

It is compiled into FOLDER, which is kept, and run: for ARM, RISC-V and Windows with Debian's cross compilers, by qemu
and wine, for WebAssembly by Emscripten in Node.js, by Clang with libc++, without vector extensions as MSVC would
compile it, and with -Ofast. Its results have the digests that the native program DIGESTS prints, and so have those of
conformance/testing/consumer/, which takes the header, lanes and a Field. Without the compiler or the emulator the test
is skipped (status 77)."""

from __future__ import annotations

import os
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
TESTING = ROOT / "conformance" / "testing"
sys.path[:0] = [str(TESTING), str(ROOT / "tools" / "lib")]
sys.argv, (WHERE, *PATHS) = sys.argv[:1], sys.argv[1:]
from msvc import WHOLE_AS_MSVC  # noqa: E402

from base import cross_build  # noqa: E402
from base.cross_build import NEON, Place  # noqa: E402

DIGESTS, FOLDER = (Path(path).resolve() for path in PATHS)
# And the instructions of each. Where nothing is forced inline, a quarter of the time is enough to compile.
QUICK = "-Dalways_inline=unused"
HERE = ("sse4.1", "avx2", "avx512", "neon", "generic")
PLACES = {
    "neon": (NEON, ("neon",)),
    "riscv": (Place("riscv64-linux-gnu-g++", ("qemu-riscv64", "-L", "/usr/riscv64-linux-gnu"), "Linux", (QUICK,)),
              ("generic",)),
    "windows": (Place("x86_64-w64-mingw32-g++-posix", ("wine",), "Windows", ("-static",)),
                ("sse4.1", "avx2", "avx512")),
    # Node.js has fetch, which 3.1.6 takes for a browser's; so the program has its WebAssembly in its own file.
    "emscripten": (Place("em++", ("node",), "Emscripten", (QUICK, "-fexceptions"),
                         ("-sALLOW_MEMORY_GROWTH", "-sSINGLE_FILE"), ("emcmake", "cmake")), ("generic",)),
    "libcxx": (Place("clang++", (), flags=("-stdlib=libc++", QUICK)), HERE),
    "msvc": (Place("clang++", (), flags=WHOLE_AS_MSVC), ("generic",)),
    "fast_math": (Place("g++", (), flags=("-Ofast", QUICK)), HERE),
}
PLACE, SETS = PLACES[WHERE]
BUILD = cross_build.Build(PLACE, FOLDER)
# Wine makes a folder for itself here, and prints by itself what it has not done yet.
ENVIRONMENT = {**os.environ, "WINEPREFIX": str(FOLDER / "wine"), "WINEDEBUG": "-all"}
# With -ffinite-math-only a compiler may leave out checks for such numbers.
NO_NUMBER = """
#include <cstdio>
#include <hashnoise/field.hpp>
#include <stdexcept>
int main() {
  const float number = hashnoise::uintBitsToFloat(0x7FC00000u);
  float value = 0.0f;
  try {
    hashnoise::Field<1>(hashnoise::Settings{}).fill(hashnoise::Grid<1>{{number}, {1.0f}, {1}}, {&value, 1});
  } catch (const std::invalid_argument&) {
    std::puts("origin");
  }
  try {
    hashnoise::Settings settings;
    settings.fractal = "fbm";
    settings.gain = number;
    const hashnoise::Field<2> field(settings);
  } catch (const std::invalid_argument&) {
    std::puts("gain");
  }
}
"""


def output_of(*command: object) -> str:
    return cross_build.output_of(*command, environment=ENVIRONMENT)


def differences(ours: str, theirs: str) -> list[str]:
    """The lines of the first text that the second lacks."""
    return sorted(set(ours.splitlines()) - set(theirs.splitlines()))


class Elsewhere(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # It is compiled for this test alone, and not by ninja's jobs but by those of ctest.
        BUILD.library()

    def test_the_bits_are_those_of_the_native_library(self):
        program = BUILD.program(Path(__file__).with_name("digests.cpp"))
        native = output_of(DIGESTS)
        self.assertGreater(len(native.splitlines()), 200)
        there = output_of(*PLACE.runner, program, "--list").split()
        self.assertGreater(len(there), 0)
        for name in there:  # a processor may lack the wider ones
            with self.subTest(instructions=name):
                self.assertIn(name, SETS)
                self.assertEqual(differences(native, output_of(*PLACE.runner, program, name)), [])

    def test_header_and_lanes_and_fields_agree(self):
        program = BUILD.program(TESTING / "consumer" / "grid.cpp")
        self.assertIn("0 and 0 of 111 values differ", output_of(*PLACE.runner, program))

    def test_what_is_no_number_is_refused(self):
        source = FOLDER / "no_number.cpp"
        source.write_text(NO_NUMBER, encoding="utf-8")
        self.assertEqual(output_of(*PLACE.runner, BUILD.program(source)).split(), ["origin", "gain"])

    def test_a_digest_that_differs_is_noticed(self):
        native = output_of(DIGESTS)
        first = native.splitlines()[0]
        self.assertEqual(differences(native, native.replace(first, first[:-1] + "x")), [first])


if __name__ == "__main__":
    missing = PLACE.missing()
    if missing:
        print(f"skipped: there is no {' and no '.join(missing)}")
        sys.exit(77)
    unittest.main()
