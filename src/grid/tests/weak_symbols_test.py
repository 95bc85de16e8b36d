#!/usr/bin/env python3
"""No object of the kernels defines a symbol that a linker may take for the whole program.

Usage: weak_symbols_test.py COMPILER NM OBJECT...

The kernels are compiled with the instructions of one set. An inline function that is not inlined is a weak symbol, and
of all that have its name a linker keeps one: it may be that with AVX-512, and a program would crash in it on a
processor that lacks this. So a kernel's functions have internal linkage, or are always inlined.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

COMPILER = NM = ""
OBJECTS = []
# nm's letters for a symbol that is weak or unique, and defined: weak ones without a definition are small letters.
WEAK = "WVu"
# A pointer to a function of the C++ library, which unwinding reads. It has no instructions.
HARMLESS = re.compile(r"DW\.ref\.__gxx_personality_v0$")


def weak_symbols(path):
    done = subprocess.run([NM, "--defined-only", "--demangle", path], check=True, capture_output=True, text=True)
    lines = [line.split(maxsplit=2) for line in done.stdout.splitlines() if line.strip()]
    if not lines:
        raise ValueError(f"{path} defines nothing")
    return sorted(name for _, kind, name in lines if kind in WEAK and not HARMLESS.match(name))


class WeakSymbols(unittest.TestCase):
    def test_of_kernels_are_none(self):
        self.assertGreaterEqual(len(OBJECTS), 1)
        for path in OBJECTS:
            with self.subTest(path=path):
                self.assertEqual(weak_symbols(path), [])

    def of_text(self, text, *flags):
        with tempfile.TemporaryDirectory() as folder:
            source, path = pathlib.Path(folder) / "a.cpp", pathlib.Path(folder) / "a.o"
            source.write_text(text)
            subprocess.run([COMPILER, "-std=c++20", *flags, "-c", str(source), "-o", str(path)], check=True)
            return weak_symbols(path)

    def test_of_inline_functions_templates_and_variables_are_reported(self):
        for text, expected in (("inline int f(int x) { return x; } int g(int x) { return f(x); }", "f(int)"),
                               ("#include <vector>\nvoid g(std::vector<int>& v) { v.push_back(1); }", "vector<int"),
                               ("inline int a = 5; int g() { return a; }", "a")):
            with self.subTest(text):
                self.assertIn(expected, " ".join(self.of_text(text, "-O0")))

    def test_of_internal_functions_and_those_that_are_always_inlined_are_none(self):
        for text in ("namespace { inline int f(int x) { return x; } } int g(int x) { return f(x); }",
                     "[[gnu::always_inline]] inline int f(int x) { return x; } int g(int x) { return f(x); }"):
            self.assertEqual(self.of_text(text, "-O0"), [])

    def test_of_an_object_without_symbols_are_an_error(self):
        with self.assertRaises(ValueError):
            self.of_text("")


if __name__ == "__main__":
    COMPILER, NM, *OBJECTS = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
