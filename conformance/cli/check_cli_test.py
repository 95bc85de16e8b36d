#!/usr/bin/env python3
"""hn-conform check: somebody's own function on drivers, against values in a file, of a record, and of another driver."""

import re
import unittest

from program import ROOT, ProgramTest

PAGE = (ROOT / "docs" / "guide" / "conformance.md").read_text()
HASH, POINTS = re.search(r"```glsl\n(float hash.*?)```.*?```csv\n(.*?)```", PAGE, re.DOTALL).groups()
FUNCTIONS = """#version 120
uint mixed(ivec2 cell, uint seed) { return (uint(cell.x) * 0x7FEB352Du ^ uint(cell.y)) + seed; }
vec3 swapped(vec3 a) { return a.zyx; }
float twice(float x) { return 2.0 * x; }
"""


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.glsl = self.write("own.glsl", FUNCTIONS)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def check(self, expression, points, *arguments, drivers=("osmesa",)):
        chosen = [word for driver in drivers for word in ("--driver", driver)]
        return self.call("check", f"{self.glsl}:{expression}", "--points", self.write("points.csv", points),
                         "--out", self.out, *chosen, *arguments)

    def cases(self):
        return {(run["driver"], case["id"]): case for run in self.results()["runs"] for case in run["cases"]}

    def test_a_planted_difference_is_found_unless_it_is_within_the_tolerance(self):
        expected = self.write("expected.csv", "# of nobody\nvalue\n1\n-3.001\n1e30\n\n")
        arguments = ("twice(x)", "x\n0.5\n-1.5\n5e29\n", "--expect", expected)
        self.assertEqual(self.check(*arguments, "--tolerance", "0.01").returncode, 0)
        done = self.check(*arguments)
        self.assertEqual(done.returncode, 1, done.stderr)
        case = self.cases()["osmesa", "check.twice.any.fast.fragment.gl330.same"]
        self.assertEqual((case["status"], case["mismatches"], case["samples"]), ("fail", 1, 3))
        for part in ("differs first at x=-1.5 (bfc00000): got -3 (c0400000), expected -3.00099993 (c0401062) within "
                     "1e-05, 4194 units in the last place away, and at 1 of 3 points", f"those of {expected}"):
            self.assertIn(part, case["message"])
            self.assertIn(part, " ".join(done.stdout.split()))
        self.assertIn("4194 units in the last place away", (self.out / "index.html").read_text())
        self.assertIn("of own.glsl.", case["evidence"]["shader"].replace(str(self.folder) + "/", ""))

    def test_a_hash_of_a_sine_differs_between_drivers_and_one_of_integers_does_not(self):
        self.glsl.write_text(HASH + FUNCTIONS)
        done = self.check("hash(p)", POINTS, drivers=("osmesa", "softpipe-gles"))
        self.assertEqual(done.returncode, 1, done.stderr)
        cases = self.cases()
        self.assertEqual(cases["osmesa", "check.hash.any.fast.fragment.gl330.same"]["status"], "pass")
        message = cases["softpipe-gles", "check.hash.any.fast.fragment.es300.same"]["message"]
        self.assertRegex(message, r"differs first at p.x=.* units in the last place away, and at \d of 4 points. "
                                  r"The expected values are those of osmesa in gl330")
        cells = "cell.x:int,cell.y:int,seed:uint\n" + "".join(f"{-i},{i << 20},{i * 0x9E3779B1 % 2**32}\n" for i in range(64))
        done = self.check("mixed(cell, seed)", cells, drivers=("osmesa", "softpipe-gles"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_what_one_driver_returned_is_kept(self):
        values = self.folder / "values.csv"
        points = "a.x,a.y,a.z\n0.1,2,3\n-4,16777217,1e-20\n"
        done = self.check("swapped(a)", points, "--record", values)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = values.read_text()
        self.assertRegex(text, "# driver: osmesa in gl330\n# renderer: llvmpipe")
        rows = [line for line in text.splitlines() if not line.startswith("#")]
        self.assertEqual(rows, ["value.x:float,value.y:float,value.z:float", "3,2,0.1", "1e-20,16777216,-4"])
        self.assertEqual(self.check("swapped(a)", points, "--expect", values, "--tolerance", "0").returncode, 0)
        values.write_text(text.replace("16777216", "16777218"))
        self.assertEqual(self.check("swapped(a)", points, "--expect", values, "--tolerance", "0").returncode, 1)
        case = self.cases()["osmesa", "check.swapped.any.exact.fragment.gl330.same"]
        self.assertIn("got value.y=16777216 (4b800000), expected 16777218 (4b800001) within 0, 1 unit in the last",
                      case["message"])

    def test_bad_input_is_refused_with_its_place(self):
        points, own = self.folder / "points.csv", self.glsl
        values = self.write("values.csv", "value\n1\n")
        for expression, text, arguments, parts in (
                ("twice(x)", "x\n1\ntwo\n", (), (f'{points}:3:1: "two" is no finite float',)),
                ("twice(x)", "x\nnan\n", (), (f"{points}:2:1", "nan")),
                ("twice(x)", "x\n1,2\n", (), (f"{points}:2: it has 2 fields, and the header has 1",)),
                ("twice(x)", "x\n", (), (f"{points}: there must be a header, and 1 to 1048576 rows",)),
                ("twice(x)", "p.x,p.z\n1,2\n", (), (f'{points}:1:2: "p.z" does not follow',)),
                ("twice(x)", "x:half\n1\n", (), (f'{points}:1:1: "x:half" has no type',)),
                ("twice(y)", "x\n1\n", (), ("the expression of twice:1", "'y'", "of the points' float x")),
                ("bvec2(x)", "x\n1\n", (), ("the expression must be a float",)),
                ("twice(x)", "x\n1\n2\n", ("--expect", values), (f"{values}: it has 1 columns and 1 rows; the function returns 1 numbers at each of 2",)),
                ("vec2(x)", "x\n1\n", ("--expect", values), ("1 rows; the function returns 2 numbers",)),
                ("twice(x)", "x\n1\n", ("--driver", "gpu"), ('there is no driver "gpu"',))):
            with self.subTest(text=text, expression=expression):
                self.assert_refused(self.check(expression, text, *arguments, drivers=()), *parts)
        own.write_text("float twice(float x) {\n  return wrong;\n}\n")
        self.assert_refused(self.check("twice(x)", "x\n1\n"), f"{own}:2", "'wrong'")
        own.write_text("float f(float x) { return log(x); }\n")
        self.assertRegex(self.check("f(x)", "x\n1\n-1\n").stdout, r"first at x=-1 .*got -?nan .*expected -?nan")


if __name__ == "__main__":
    unittest.main(verbosity=2)
