"""The lanes of <hashnoise/lanes.hpp>: python3 lanes_test.py [--thorough] COMPILER...

The functions over lanes have the values of the scalar twin bit by bit, and a condition that differs between lanes is
noticed. So it is without vector extensions, as MSVC has none: Clang compiles that in its mode for MSVC, on the headers
of GCC's C++ library, since those of Microsoft are not here. One setting each way is tried at few points, each by one
compiler, and with --thorough all settings by each compiler at many.
"""

from __future__ import annotations

import functools
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from msvc import AS_MSVC, WHOLE_AS_MSVC, fp_fast

HERE = Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
THOROUGH = "--thorough" in sys.argv
COMPILERS = [argument for argument in sys.argv[1:] if argument != "--thorough"]
# The values do not depend on what is inlined. Where it is everything, as in the library, compilers take long; and at
# few points a program takes less time than its optimization would.
POINTS = ["-O1", "-Dalways_inline=unused"] if THOROUGH else ["-O0", "-Dalways_inline=noinline", "-DFEW_POINTS"]
SETTINGS = (["HN_ARITHMETIC=HN_FAST"],
            ["HN_ARITHMETIC=HN_PRECISE", "HN_HASH=HN_HASH_FNV1", "HN_GRADIENT=HN_GRADIENT_SINE"],
            ["HN_ARITHMETIC=HN_FIXED", "HN_HASH=HN_HASH_PCG"])
# The instructions that a processor needs for code of a machine.
MACHINES = {"x86-64-v2": "sse4_2", "x86-64-v3": "avx2", "x86-64-v4": "avx512vl"}
PROCESSOR = Path("/proc/cpuinfo").read_text().split() if Path("/proc/cpuinfo").exists() else []
LANES = ("LANES", "HN_LANES_CHECKED")
EXACT = ("-ffp-contract=off",)
FOLDER = tempfile.TemporaryDirectory()  # of the programs


@functools.cache
def built(compiler: str, *macros: str, flags: tuple[str, ...] = EXACT) -> tuple[str, Path]:
    """The compiler's messages, empty if it compiles, and the program."""
    program = Path(FOLDER.name, str(built.cache_info().misses))
    command = [compiler, "-std=c++20", *POINTS, *flags, "-Wall", "-Wextra", "-Werror", "-I", str(INCLUDE),
               *(f"-D{macro}" for macro in macros), str(HERE / "lanes.cpp"), "-o", str(program)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else f"exit status {done.returncode}: {done.stderr}", program


@functools.cache
def digests(compiler: str, *macros: str, flags: tuple[str, ...] = EXACT, options: tuple[str, ...] = ()) -> list[str]:
    """The output of the program, built so."""
    messages, program = built(compiler, *macros, flags=flags)
    if messages:
        raise AssertionError(messages)
    return printed(program, *options)


def printed(program: Path, *options: str) -> list[str]:
    return subprocess.run([program, *options], capture_output=True, text=True, check=True).stdout.splitlines()


def as_msvc(*macros: str, flags: tuple[str, ...] = EXACT) -> tuple[str, Path]:
    """The result of `built` for lanes that Clang compiles as MSVC would."""
    quickly = () if THOROUGH else ("__forceinline=inline",)
    return built(COMPILERS[-1], *LANES, *macros, *quickly, flags=(*flags, *AS_MSVC))


def scalar(*macros: str) -> list[str]:
    """The digests of the scalar twin. They are the same with each compiler: nothing is contracted."""
    return digests(COMPILERS[0], *macros)


class Lanes(unittest.TestCase):
    def test_the_values_are_those_of_the_scalar_twin(self):
        for setting in SETTINGS if THOROUGH else SETTINGS[:1]:
            for compiler in COMPILERS if THOROUGH else COMPILERS[:1]:
                with self.subTest(compiler=compiler, setting=setting):
                    self.assertEqual(digests(compiler, *setting, *LANES), scalar(*setting))

    def test_lanes_without_vector_extensions_have_these_values_too(self):
        for setting in SETTINGS if THOROUGH else SETTINGS[2:]:
            with self.subTest(setting=setting):
                messages, program = as_msvc(*setting)
                self.assertEqual(messages, "")
                self.assertEqual(printed(program), scalar(*setting))

    def test_msvc_takes_the_headers(self):
        """Lanes need less of them."""
        text = "#include <hashnoise/hashnoise.hpp>\n#include <hashnoise/field.hpp>\n"
        done = subprocess.run([COMPILERS[-1], "-std=c++20", "-fsyntax-only", *WHOLE_AS_MSVC, "-I", str(INCLUDE),
                               "-x", "c++", "-"], input=text, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    @unittest.skipUnless(THOROUGH, "takes long, and MSVC takes them as the same")
    def test_lanes_without_vector_extensions_may_be_asked_for(self):
        for compiler in COMPILERS:
            for setting in SETTINGS:
                with self.subTest(compiler=compiler, setting=setting):
                    self.assertEqual(digests(compiler, *setting, *LANES, "HN_LANES_PORTABLE"), scalar(*setting))

    @unittest.skipUnless(THOROUGH, "takes long: each is a compilation")
    def test_what_msvc_does_not_have_is_noticed(self):
        for unfit in ("__builtin_sqrtf(1.0f) > 0.0f ? x : y", "[&]() __attribute__((always_inline)) { return x; }()",
                      "[&]() { [[gnu::unused]] int n = 0; return x; }()"):
            messages, _ = as_msvc(f"UNFIT={unfit}")
            self.assertIn("error: ", messages, unfit)
        self.assertEqual(as_msvc("UNFIT=x")[0], "")

    def test_fixed_bits_do_not_follow_the_flags(self):
        setting = SETTINGS[2]
        machines = [name for name, flag in MACHINES.items() if flag in PROCESSOR]
        for compiler in COMPILERS if THOROUGH else COMPILERS[-1:]:
            for machine in machines[-1:]:
                for flags in (("-O1", "-ffast-math"), ("-Ofast",)) if THOROUGH else (("-O1", "-ffast-math"),):
                    for lanes in ((), ("HN_LANES_PORTABLE",)) if THOROUGH else ((),):
                        with self.subTest(compiler=compiler, machine=machine, flags=flags, lanes=lanes):
                            found = digests(compiler, *setting, *LANES, *lanes, flags=(*flags, f"-march={machine}"))
                            self.assertEqual(found, scalar(*setting))

    def test_what_clang_makes_of_fp_fast(self):
        self.assertLessEqual({"-ffast-math", "-ffp-contract=fast", "-ffinite-math-only", "-fno-signed-zeros"},
                             {*fp_fast(COMPILERS[-1])})

    @unittest.skipUnless(THOROUGH, "takes long: each is a compilation with optimization")
    def test_fixed_bits_do_not_follow_fp_fast(self):
        flags = ("-O1", *fp_fast(COMPILERS[-1]))
        for setting, is_same in ((SETTINGS[2], True), (SETTINGS[0], False)):  # that it does something is seen by HN_FAST
            messages, program = as_msvc(*setting, flags=flags)
            self.assertEqual(messages, "")
            self.assertEqual(printed(program) == scalar(*setting), is_same)

    def test_numbers_of_a_word_are_the_same_with_every_setting(self):
        exact = ("pcg3d", "gaussian", "ball", "sobol", "shuffle")
        found = [[line for line in scalar(*setting) if line.split()[0] in exact] for setting in SETTINGS[::2]]
        self.assertEqual(len(found[0]), len(exact))
        self.assertEqual(found[0], found[1])

    def test_a_lane_that_takes_the_value_of_another_is_noticed(self):
        faulty = digests(COMPILERS[0], *SETTINGS[0], *LANES, options=("--faulty-lane",))
        self.assertGreater(len(faulty), 5)
        self.assertEqual([line for line in scalar(*SETTINGS[0]) if line in faulty], [])

    def test_what_lanes_cannot_do_is_noticed(self):
        messages, _ = built(COMPILERS[0], *LANES, "UNFIT=(x >> 8, x + 1)")
        self.assertEqual(messages.count(" error: no match for"), 2, messages)
        messages, program = built(COMPILERS[0], *LANES, "UNFIT=faulty_lane ? x > y ? x : y : select(x > y, x, y)")
        self.assertEqual(messages, "")
        for options, works in (["--faulty-lane"], False), ([], True):
            done = subprocess.run([program, *options], capture_output=True, check=False)
            self.assertEqual(done.returncode == 0, works, options)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
