#!/usr/bin/env python3
"""The C++ twin with HN_FIXED has the same bits whatever compiler and flags it is built with, and no undefined
behaviour.

Usage: twin_flags_test.py --tables=FOLDER [--every-function] [--thorough] COMPILER..., with what
tools/lib/catalog/suite.py wrote

A function of each kind is tried, and with --every-function all that have values of their own. Compilers, flags,
gradients and arithmetics are tried in pairs; with --thorough all of them together. Unless every function is tried, what
checks each operation has few points, and is what is not optimised, too.
"""

import concurrent.futures
import functools
import itertools
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPILERS = []
TABLES = ""
THOROUGH = False
FUNCTIONS = ()  # the macros that choose them
HERE = pathlib.Path(__file__).resolve().parent
# The library makes compilers inline every function, and then most of the time goes into compiling the same text for
# each caller. With --every-function what is optimised most has that; else they inline none of it, or what they choose.
INLINE_NONE = "-Dalways_inline=noinline"
INLINE_SOME = "-Dalways_inline=unused"  # an attribute without an effect on it
MOST = ("-Ofast", "-march=native")  # that is -O3 and -ffast-math
EVERY_FUNCTION = "--every-function" in sys.argv
INLINED = () if EVERY_FUNCTION else (INLINE_SOME,)
# Each operation is checked whatever the level. To optimise takes longer than what it saves at few points.
SANITIZED = ("-O1" if EVERY_FUNCTION else "-O0", INLINE_NONE, "-fsanitize=undefined,float-cast-overflow",
             "-fno-sanitize-recover=all")
LEVELS = (("-O0", INLINE_NONE) if EVERY_FUNCTION else SANITIZED, ("-O2", INLINE_SOME), (*MOST, *INLINED))
CONTRACTION = ((), ("-ffp-contract=fast",))
GRADIENTS = ("HN_GRADIENT_OCTAHEDRAL", "HN_GRADIENT_SINE")


# For three choices, and up to three of two: which of the two stands in each row.
ROWS = ((0, (0, 0, 0)), (0, (1, 1, 1)), (1, (0, 0, 1)), (1, (1, 1, 0)), (2, (0, 1, 0)), (2, (1, 0, 1)))


def in_pairs(three, *twos):
    """Six rows of the product of choices, in which each pair of two choices is; with --thorough all."""
    if THOROUGH:
        return list(itertools.product(three, *twos))
    return [(three[first], *(two[number] for two, number in zip(twos, others))) for first, others in ROWS]


def has_few_points(flags):
    """Unoptimised code takes long, and so does code with checks at each operation."""
    return "-O0" in flags or (len(FUNCTIONS) > 0 and SANITIZED[2] in flags)


@functools.cache
def digests(compiler, flags, macros):
    """The output of twin_flags.cpp, built with these flags: its digests by function."""
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "twin"
        command = [compiler, "-std=c++20", *flags, *(f"-D{macro}" for macro in (*FUNCTIONS, *macros)),
                   f"-I{HERE.parent.parent / 'include'}", f"-I{TABLES}", str(HERE / "twin_flags.cpp"), "-o",
                   str(program)]
        subprocess.run(command, check=True)
        done = subprocess.run([program, *["few"] * has_few_points(flags)], capture_output=True, text=True)
    if done.returncode or done.stderr:
        raise AssertionError(f"exit status {done.returncode}: {done.stderr}: {' '.join(command)}")
    return {line[0]: line[1:] for line in map(str.split, done.stdout.splitlines())}


def all_digests(*builds):
    """The digests of builds, each a compiler, flags and macros."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda build: digests(*build), builds))


def macros(arithmetic, gradient=GRADIENTS[0]):
    return f"HN_ARITHMETIC={arithmetic}", f"HN_GRADIENT={gradient}"


class Flags(unittest.TestCase):
    def assert_same(self, one, other, what):
        """Where one has fewer points, only these are compared."""
        self.assertEqual(one.keys(), other.keys(), what)
        for function, digests in one.items():
            count = min(len(digests), len(other[function]))
            self.assertGreater(count, 0)
            self.assertEqual(digests[:count], other[function][:count], (function, what))

    def test_of_fixed_arithmetic_do_not_matter(self):
        rows = in_pairs(LEVELS, COMPILERS, CONTRACTION, GRADIENTS)
        for gradient in GRADIENTS:
            builds = [(compiler, level + contraction) for level, compiler, contraction, of in rows if of == gradient]
            with self.subTest(gradient=gradient):
                self.assertGreaterEqual(len(builds), 3)
                found = all_digests(*((*build, macros("HN_FIXED", gradient)) for build in builds))
                most = found[-1]
                for function in ("gradient.lattice2", "noise3d.perlin_cell", "noise2d.cellular", "fbm.clouds3"):
                    self.assertEqual(len(most[function]), 2)
                self.assertGreater(len(most), 20 if FUNCTIONS else 100)
                self.assertGreaterEqual(sum(not has_few_points(flags) for _, flags in builds), 2)
                for build, digest in zip(builds, found):
                    self.assert_same(digest, most, build)

    def test_of_fixed_arithmetic_do_not_matter_where_arguments_are_constants(self):
        for known in ("HN_TEST_KNOWN_INTEGERS", "HN_TEST_KNOWN_FLOATS"):
            as_written, *found = all_digests(*((compiler, flags, (*macros("HN_FIXED"), known))
                                               for compiler, flags in ((COMPILERS[0], ("-O0", INLINE_NONE)),
                                                                       *((one, MOST) for one in COMPILERS))))
            self.assertIn("noise3d.perlin_cell", as_written)
            for compiler, digest in zip(COMPILERS, found):
                with self.subTest(known=known, compiler=compiler):
                    self.assert_same(as_written, digest, MOST)

    def test_that_reorder_sums_are_seen(self):
        reordered = (*macros("HN_FIXED"), "HN_TEST_REORDERED")
        for compiler in COMPILERS:
            as_written, most = all_digests((compiler, LEVELS[0], reordered), (compiler, MOST, reordered))
            self.assertNotEqual(as_written, most, compiler)

    def test_are_tried_in_pairs(self):
        choices = ((1, 2, 3), ("a", "b"), ("x", "y"), ("p", "q"))
        rows = in_pairs(*choices)
        self.assertEqual(len(rows), 24 if THOROUGH else 6)
        for i, j in itertools.combinations(range(4), 2):
            self.assertEqual({(row[i], row[j]) for row in rows}, set(itertools.product(choices[i], choices[j])))

    def test_of_fast_arithmetic_do(self):
        """If these agreed, the digests would be of nothing."""
        fast = ("-O1", INLINE_SOME, "-march=native", "-ffast-math", *CONTRACTION[1])
        first, second = all_digests(*((COMPILERS[0], flags, macros("HN_FAST")) for flags in (LEVELS[0], fast)))
        self.assertNotEqual([digests[0] for digests in first.values()], [digests[0] for digests in second.values()])

    def test_show_no_undefined_behaviour(self):
        arithmetics = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
        rows = in_pairs(arithmetics, GRADIENTS, COMPILERS)
        if FUNCTIONS:  # each arithmetic once, and each gradient and compiler with one of them
            rows = list(zip(arithmetics, itertools.cycle(GRADIENTS), itertools.cycle(COMPILERS)))
        found = all_digests(*((compiler, SANITIZED, macros(arithmetic, gradient))
                              for arithmetic, gradient, compiler in rows))
        self.assertEqual(len(found), 3 if FUNCTIONS else 12 if THOROUGH else 6)

    def test_show_undefined_behaviour_that_there_is(self):
        """A planted overflow of int."""
        with self.assertRaisesRegex(AssertionError, "overflow"):
            digests(COMPILERS[0], SANITIZED, (*macros("HN_FIXED"), "HN_TEST_OVERFLOW"))


if __name__ == "__main__":
    THOROUGH = "--thorough" in sys.argv
    FUNCTIONS = () if "--every-function" in sys.argv else ("HN_TEST_EACH_KIND",)
    TABLES = next(argument.partition("=")[2] for argument in sys.argv if argument.startswith("--tables="))
    COMPILERS = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    unittest.main(argv=sys.argv[:1])
