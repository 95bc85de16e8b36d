#!/usr/bin/env python3
"""The C++ twin with HN_FIXED has the same bits whatever compiler and flags it is built with, and no undefined behaviour.

Usage: twin_flags_test.py [--every-function] [--thorough] COMPILER...

A function of each kind is tried, and with --every-function all that have values of their own. Compilers, flags, gradients
and arithmetics are tried in pairs; with --thorough all of them together. What checks each operation has few points, unless
every function is tried.
"""

import concurrent.futures
import itertools
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPILERS = []
THOROUGH = False
FUNCTIONS = ()  # the macros that choose them
HERE = pathlib.Path(__file__).resolve().parent
# The library asks compilers to inline every function, and then most of the time goes into compiling the same text for
# each caller. With --every-function what is optimised most has that; else they inline none of it, or what they choose.
INLINE_NONE = "-Dalways_inline=noinline"
INLINE_SOME = "-Dalways_inline=unused"  # an attribute that says nothing about it
MOST = ("-O3", "-march=native", "-ffast-math")
INLINED = () if "--every-function" in sys.argv else (INLINE_SOME,)
LEVELS = (("-O0", INLINE_NONE), ("-O2", INLINE_SOME), (*MOST, *INLINED))
CONTRACTION = ((), ("-ffp-contract=fast",))
SANITIZED = ("-O1", INLINE_NONE, "-fsanitize=undefined,float-cast-overflow", "-fno-sanitize-recover=all")
GRADIENTS = ("HN_GRADIENT_OCTAHEDRAL", "HN_GRADIENT_SINE")


# Of three choices and up to three of two: which of the two stands in each row.
ROWS = ((0, (0, 0, 0)), (0, (1, 1, 1)), (1, (0, 0, 1)), (1, (1, 1, 0)), (2, (0, 1, 0)), (2, (1, 0, 1)))


def in_pairs(three, *twos):
    """Six rows of the product of choices, in which each pair of two choices is; with --thorough all."""
    if THOROUGH:
        return list(itertools.product(three, *twos))
    return [(three[first], *(two[number] for two, number in zip(twos, others))) for first, others in ROWS]


class Flags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    @staticmethod
    def points(flags):
        """What is not optimised takes long, and what is checked at each operation."""
        return ["few"] if "-O0" in flags or (FUNCTIONS and SANITIZED[2] in flags) else []

    def digests(self, number, compiler, flags, *macros):
        """What twin_flags.cpp prints, built so: by function its digests."""
        program = self.folder / f"twin-{number}"
        command = [compiler, "-std=c++20", *flags, *(f"-D{macro}" for macro in (*FUNCTIONS, *macros)),
                   f"-I{HERE.parent.parent / 'include'}", f"-I{HERE.parent}", str(HERE / "twin_flags.cpp"), "-o",
                   str(program)]
        subprocess.run(command, check=True)
        done = subprocess.run([program, *self.points(flags)], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""), " ".join(command))
        return {line[0]: line[1:] for line in map(str.split, done.stdout.splitlines())}

    def assert_same(self, one, other, what):
        """Where one has fewer points, only these are compared."""
        self.assertEqual(one.keys(), other.keys(), what)
        for function, digests in one.items():
            count = min(len(digests), len(other[function]))
            self.assertGreater(count, 0)
            self.assertEqual(digests[:count], other[function][:count], (function, what))

    def all_digests(self, builds, *macros):
        """By build, which is a compiler and flags."""
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = pool.map(lambda build: self.digests(build[0], *build[1], *macros), enumerate(builds))
            return dict(zip(builds, found))

    def test_of_fixed_arithmetic_do_not_matter(self):
        rows = in_pairs(LEVELS, COMPILERS, CONTRACTION, GRADIENTS)
        for gradient in GRADIENTS:
            builds = [(compiler, level + contraction) for level, compiler, contraction, of in rows if of == gradient]
            with self.subTest(gradient=gradient):
                self.assertGreaterEqual(len(builds), 3)
                digests = self.all_digests(builds, f"HN_GRADIENT={gradient}", "HN_ARITHMETIC=HN_FIXED")
                most = digests[builds[-1]]
                for function in ("gradient.lattice2", "noise3d.perlin_cell", "noise2d.cellular", "fbm.clouds3"):
                    self.assertEqual(len(most[function]), 2)
                self.assertGreater(len(most), 20 if FUNCTIONS else 100)
                self.assertGreaterEqual(sum(not self.points(flags) for _, flags in builds), 2)
                for build, digest in digests.items():
                    self.assert_same(digest, most, build)

    def test_are_tried_in_pairs(self):
        choices = ((1, 2, 3), ("a", "b"), ("x", "y"), ("p", "q"))
        rows = in_pairs(*choices)
        self.assertEqual(len(rows), 24 if THOROUGH else 6)
        for i, j in itertools.combinations(range(4), 2):
            self.assertEqual({(row[i], row[j]) for row in rows}, set(itertools.product(choices[i], choices[j])))

    def test_of_fast_arithmetic_do(self):
        """If these agreed, the digests would be of nothing."""
        fast = (INLINE_SOME, *MOST, *CONTRACTION[1])
        first, second = self.all_digests([(COMPILERS[0], LEVELS[0]), (COMPILERS[0], fast)],
                                         "HN_ARITHMETIC=HN_FAST").values()
        self.assertNotEqual([digests[0] for digests in first.values()], [digests[0] for digests in second.values()])

    def test_show_no_undefined_behaviour(self):
        arithmetics = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
        rows = in_pairs(arithmetics, GRADIENTS, COMPILERS)
        if FUNCTIONS:  # each arithmetic once, and each gradient and compiler with one of them
            rows = [rows[number] for number in (0, 3, 4)]
        builds = [(compiler, (*SANITIZED, f"-DHN_GRADIENT={gradient}", f"-DHN_ARITHMETIC={arithmetic}"))
                  for arithmetic, gradient, compiler in rows]
        self.assertEqual(len(self.all_digests(builds)), 3 if FUNCTIONS else 12 if THOROUGH else 6)

    def test_show_undefined_behaviour_that_there_is(self):
        """A planted overflow of int."""
        with self.assertRaises(AssertionError) as caught:
            self.all_digests([(COMPILERS[0], SANITIZED)], "HN_ARITHMETIC=HN_FIXED", "HN_TEST_OVERFLOW")
        self.assertIn("overflow", str(caught.exception))


if __name__ == "__main__":
    THOROUGH = "--thorough" in sys.argv
    FUNCTIONS = () if "--every-function" in sys.argv else ("HN_TEST_EACH_KIND",)
    COMPILERS = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    unittest.main(argv=sys.argv[:1])
