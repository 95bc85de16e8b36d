"""Loops over the scalar functions are vectorized: python3 vectorize_test.py G++ CLANG++ [--thorough]

With the flags that hashnoise.hpp names, each compiler reports of each loop whether it made vectors of it. By default
one
compiler tries floats on the plane, and the other integers in space; with --thorough both try all."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

INCLUDE = Path(__file__).resolve().parent.parent.parent / "include"
GCC, CLANG = sys.argv[1:3]
THOROUGH = "--thorough" in sys.argv
FLAGS = {GCC: ["-O3", "-fno-math-errno", "-fno-trapping-math"], CLANG: ["-O3", "-fno-math-errno"]}
SAYS = {GCC: ("-fopt-info-vec", "loop vectorized"), CLANG: ("-Rpass=loop-vectorize", "vectorized loop")}
# GCC 12 makes no vectors of these.
KNOWN = ["hn_simplex(vec3(x[i], y[i], 0.5f), 7u)", "hn_simplex_d(vec3(x[i], y[i], 0.5f), 7u).y",
         "hn_cellular_d(vec2(x[i], y[i]), 7u).y", "hn_cellular_d(vec3(x[i], y[i], 0.5f), 7u).y"]
HEAD = """#include <hashnoise/hashnoise.hpp>
using namespace hashnoise;
"""
LOOP = ("void fill{number}(const float* __restrict x, const float* __restrict y, float* __restrict out, int n) "
        "{{ for (int i = 0; i < n; ++i) out[i] = {call}; }}\n")
# Not sums, and not the border in space: they have an inner loop.
CALLS = [call.replace("P", place)
         for call in ("hn_value(P, 7u)", "hn_value_d(P, 7u).y", "hn_value_cubic(P, 7u)", "hn_perlin(P, 7u)",
                      "hn_perlin_d(P, 7u).y", "hn_simplex(P, 7u)", "hn_simplex_d(P, 7u).y", "hn_simplex_smooth(P, 7u)",
                      "hn_cellular(P, 7u).x", "hn_cellular_d(P, 7u).y", "hn_cellular_smooth(P, 7u)",
                      "hn_cell_border(P, 7u)")
         for place in ("vec2(x[i], y[i])", "vec3(x[i], y[i], 0.5f)")][:-1]


def not_vectorized(compiler: str, arithmetic: str, flags: list[str], calls: list[str]) -> list[str]:
    """The calls whose loop stays one over single numbers."""
    option, phrase = SAYS[compiler]
    loops = "".join(LOOP.format(number=number, call=call) for number, call in enumerate(calls))
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "loops.cpp")
        source.write_text(HEAD + loops)
        done = subprocess.run([compiler, "-std=c++20", "-march=x86-64-v3", *flags, option,
                               f"-DHN_ARITHMETIC={arithmetic}", "-I", str(INCLUDE), "-S", str(source), "-o",
                               str(Path(folder, "loops.s"))], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    found = {int(line) for line in re.findall(rf"loops\.cpp:(\d+):.*{phrase}", done.stderr)}
    first = HEAD.count("\n") + 1
    return [call for line, call in enumerate(calls, first) if line not in found]


class Vectorize(unittest.TestCase):
    def setUp(self):
        machine = os.uname().machine
        if machine != "x86_64":
            self.skipTest(f"the loops are judged for AVX2, and this is {machine}")

    def check(self, compiler: str, arithmetic: str, but: list[str], axes: str = ""):
        calls = [call for call in CALLS if THOROUGH or f"(vec{axes}(" in call]
        self.assertEqual(not_vectorized(compiler, arithmetic, FLAGS[compiler], calls), but)

    def test_gcc_makes_vectors_of_floats(self):
        self.check(GCC, "HN_FAST", [], "2")

    def test_clang_makes_vectors_of_integers(self):
        self.check(CLANG, "HN_FIXED", [], "3")

    if THOROUGH:

        def test_gcc_makes_vectors_of_integers(self):
            self.check(GCC, "HN_FIXED", KNOWN)

        def test_clang_makes_vectors_of_floats(self):
            self.check(CLANG, "HN_FAST", [])

    def test_a_loop_that_is_not_vectorized_is_noticed(self):
        calls = [call for call in CALLS if call.startswith("hn_perlin(")]
        for compiler in FLAGS:
            self.assertEqual(not_vectorized(compiler, "HN_FAST", ["-O1"], calls), calls)
            self.assertEqual(not_vectorized(compiler, "HN_FAST", [*FLAGS[compiler], "-Dalways_inline=noinline"], calls),
                             calls)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
