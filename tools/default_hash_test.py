#!/usr/bin/env python3
"""The candidates of tools/default-hash replace what they say, compile, and are all on the page.

Run it by tools/scientific-python.
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import test_support  # noqa: F401  (keeps the tree free of __pycache__)

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools" / "choice"))

import candidates
import measure
import page

CALLS = ("#include <hashnoise/hashnoise.hpp>\n"
         "float f(hashnoise::vec3 p) { return hashnoise::hn_perlin(p) + hashnoise::hn_perlin({p.x, p.y}); }\n")


def compiles(candidate):
    with tempfile.TemporaryDirectory() as folder:
        include = candidates.write(candidate, ROOT, Path(folder))
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", *(f"-D{m}" for m in candidate.macros), "-I", include,
                               "-x", "c++", "-"], input=CALLS, capture_output=True, text=True, check=False)
        return done.returncode == 0


class Candidates(unittest.TestCase):
    def test_each_compiles(self):
        for candidate in candidates.HASHES + candidates.GRADIENTS:
            self.assertTrue(compiles(candidate), candidate.name)

    def test_one_that_is_wrong_does_not(self):
        self.assertFalse(compiles(candidates.Candidate("wrong", "", {"hn_i_word": candidates.word("return kk;")})))

    def test_the_library_is_the_first_of_each(self):
        self.assertEqual([c.functions for c in (candidates.HASHES[0], candidates.GRADIENTS[0])], [{}, {}])

    def test_all_definitions_go_and_the_new_ones_take_their_place(self):
        text = ("HN_FN uint f(uint k) { return k; }\nHN_FN uvec2 f(uvec2 k) {\n  if (a) { b; }\n  return k;\n}\n"
                "HN_FN uint g(uint k) { return f(k); }\n")
        self.assertEqual(candidates.replaced(text, "f", "new"), "new\n\nHN_FN uint g(uint k) { return f(k); }\n")

    def test_a_function_that_is_not_there_is_no_candidate(self):
        with self.assertRaises(ValueError):
            candidates.replaced("HN_FN uint g(uint k) { return k; }\n", "f", "new")
        wrong = candidates.Candidate("wrong", "", {"hn_i_mixed": "new"})
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ValueError):
            candidates.write(wrong, ROOT, Path(folder))

    def test_the_page_has_all_of_them(self):
        text = (ROOT / "docs" / "default-hash.md").read_text(encoding="utf-8")
        for candidate in candidates.HASHES + candidates.GRADIENTS:
            self.assertIn(f"| `{candidate.name}` |", text)


class Front(unittest.TestCase):
    @staticmethod
    def result(ratio, navi, failed):
        cost = measure.Cost(ratio, 0.0, 100, navi, 90)
        return measure.Result(candidates.HASHES[0], {2: cost, 3: cost}, {}, {2: failed, 3: []}, None)

    def test_what_passes_and_is_cheaper_dominates(self):
        dear, cheap = self.result(0.3, 200, []), self.result(0.2, 150, [])
        self.assertTrue(page.dominated(dear, [dear, cheap]))
        self.assertFalse(page.dominated(cheap, [dear, cheap]))

    def test_what_fails_does_not(self):
        dear, weak = self.result(0.3, 200, []), self.result(0.2, 150, ["avalanche"])
        self.assertFalse(page.dominated(dear, [dear, weak]))

    def test_what_is_dearer_in_one_respect_does_not(self):
        a, b = self.result(0.3, 150, []), self.result(0.2, 200, [])
        self.assertFalse(page.dominated(a, [a, b]) or page.dominated(b, [a, b]))


if __name__ == "__main__":
    unittest.main()
