#!/usr/bin/env python3
"""The C++ twin with HN_FIXED has the same bits whatever compiler and flags it is built with, and no undefined behaviour.

Usage: twin_flags_test.py [--thorough] COMPILER...

Compilers, flags, gradients and arithmetics are tried in pairs; with --thorough all of them together.
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
HERE = pathlib.Path(__file__).resolve().parent
LEVELS = (("-O0",), ("-O2",), ("-O3", "-march=native", "-ffast-math"))
CONTRACTION = ((), ("-ffp-contract=fast",))
SANITIZED = ("-O1", "-fsanitize=undefined,float-cast-overflow", "-fno-sanitize-recover=all")
GRADIENTS = ("HN_GRADIENT_OCTAHEDRAL", "HN_GRADIENT_SINE")


def every_second(*choices):
    """Half of the product of choices: each pair of two choices is in it."""
    numbered = itertools.product(*(enumerate(choice) for choice in choices))
    return [tuple(value for _, value in row) for row in numbered
            if THOROUGH or sum(number for number, _ in row) % 2 == 0]


class Flags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def digests(self, number, compiler, flags, *macros):
        """What twin_flags.cpp prints, built so."""
        program = self.folder / f"twin-{number}"
        command = [compiler, "-std=c++20", *flags, *(f"-D{macro}" for macro in macros),
                   f"-I{HERE.parent.parent / 'include'}", f"-I{HERE.parent}", str(HERE / "twin_flags.cpp"), "-o",
                   str(program)]
        subprocess.run(command, check=True)
        done = subprocess.run([program], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""), " ".join(command))
        return done.stdout

    def all_digests(self, builds, *macros):
        """By build, which is a compiler and flags."""
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = pool.map(lambda build: self.digests(build[0], *build[1], *macros), enumerate(builds))
            return dict(zip(builds, found))

    def test_of_fixed_arithmetic_do_not_matter(self):
        builds = [(compiler, level + contraction)
                  for compiler, level, contraction in every_second(COMPILERS, LEVELS, CONTRACTION)]
        for gradient in GRADIENTS:
            with self.subTest(gradient=gradient):
                digests = self.all_digests(builds, f"HN_GRADIENT={gradient}", "HN_ARITHMETIC=HN_FIXED")
                first = digests[builds[0]]
                ids = [line.split()[0] for line in first.splitlines()]
                for function in ("gradient.lattice2", "noise3d.perlin_cell", "fbm.clouds3"):
                    self.assertIn(function, ids)
                for build, digest in digests.items():
                    self.assertEqual(digest, first, build)

    def test_are_tried_in_pairs(self):
        choices = (("a", "b"), (1, 2, 3), ("x", "y"))
        rows = every_second(*choices)
        self.assertEqual(len(rows), 12 if THOROUGH else 6)
        for i, j in itertools.combinations(range(3), 2):
            self.assertEqual({(row[i], row[j]) for row in rows}, set(itertools.product(choices[i], choices[j])))

    def test_of_fast_arithmetic_do(self):
        """If these agreed, the digests would be of nothing."""
        builds = [(COMPILERS[0], LEVELS[0]), (COMPILERS[0], LEVELS[2] + CONTRACTION[1])]
        first, second = self.all_digests(builds, "HN_ARITHMETIC=HN_FAST").values()
        self.assertNotEqual(first, second)

    def test_show_no_undefined_behaviour(self):
        arithmetics = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
        for arithmetic, gradient, compiler in every_second(arithmetics, GRADIENTS, COMPILERS):
            with self.subTest(arithmetic=arithmetic, gradient=gradient, compiler=compiler):
                self.all_digests([(compiler, SANITIZED)], f"HN_GRADIENT={gradient}", f"HN_ARITHMETIC={arithmetic}")

    def test_show_undefined_behaviour_that_there_is(self):
        """A planted overflow of int."""
        with self.assertRaises(AssertionError) as caught:
            self.all_digests([(COMPILERS[0], SANITIZED)], "HN_ARITHMETIC=HN_FIXED", "HN_TEST_OVERFLOW")
        self.assertIn("overflow", str(caught.exception))


if __name__ == "__main__":
    THOROUGH = "--thorough" in sys.argv
    COMPILERS = [argument for argument in sys.argv[1:] if argument != "--thorough"]
    unittest.main(argv=sys.argv[:1])
