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
float root(float x) { return sqrt(x); }
"""


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.glsl = self.write("own.glsl", FUNCTIONS)

    def write(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
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

    def test_equal_bits_are_equal_and_so_are_any_two_nan(self):
        words = "inf\n-inf\n-1\n1\nnan\n"
        for drivers in (("osmesa",), ("osmesa", "softpipe-gles"), ("osmesa", "webgl2"), ("osmesa", "vulkan:0")):
            with self.subTest(drivers=drivers):
                done = self.check("root(x)", "x\n" + words, drivers=drivers)
                if "is not here" in done.stderr:
                    continue
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                ran = {id: case for id, case in self.cases().items() if case["status"] != "unsupported"}
                self.assertEqual({id[0] for id in ran}, {*drivers, "osmesa"})
                for id, case in ran.items():
                    self.assertEqual((case["status"], case["mismatches"], case["samples"]), ("warning", 0, 5), id)
                    self.assertRegex(case["message"], r"NaN, as expected, at 3 of 5 points, first at x=-[iI]nf(inity)? "
                                     r"\(ff800000\)\. GLSL leaves NaN open: .* those of osmesa in gl330$")
        self.assertEqual(self.check("1.0 / x", "x\n0\n").returncode, 0)
        for points, right, message in (("x\n-1\n", "y\n1\n", "got -?nan \\([f7]fc00000\\), expected 1 \\(3f800000\\) within 1e-05, and at 1"),
                                       ("x\n1\n", "y\nnan\n", "got 1 \\(3f800000\\), expected nan \\(7fc00000\\), and at 1"),
                                       ("x\n1\n", "y\n-inf\n", "got 1 \\(3f800000\\), expected -inf \\(ff800000\\), and at 1")):
            done = self.check("root(x)", points, "--expect", self.write("right.csv", right))
            self.assertEqual(done.returncode, 1, right)
            case = self.cases()["osmesa", "check.root.any.fast.fragment.gl330.same"]
            self.assertRegex(case["message"], message)
            self.assertIn("red on this driver", case["evidence"]["note"])

    def test_infinities_and_nan_are_written_read_and_passed_on(self):
        self.glsl.write_text("uint bits(float x) { return floatBitsToUint(x); }\nfloat same(float x) { return x; }\n")
        spellings = ("inf", "+inf", "Infinity", "INF", "+1.0e+0", "-inf", "-Infinity", "1e-50", "nan", "NaN", "-nan(ind)")
        points = "x\n" + "".join(f"{one}\n" for one in spellings)
        values = self.folder / "values.csv"
        self.assertEqual(self.check("same(x)", points, "--record", values).returncode, 0)
        self.assertEqual(re.sub("-nan", "nan", values.read_text()).split()[-12:], ["value:float", *["inf"] * 4, "1",
                         "-inf", "-inf", "0", *["nan"] * 3])
        self.assertEqual(self.check("same(x)", points, "--expect", values).returncode, 0)
        words = "value\n" + "".join(f"{one}\n" for one in [0x7F800000] * 4 + [0x3F800000, 0xFF800000, 0xFF800000, 0])
        for drivers in (("osmesa",), ("softpipe",), ("webgl2",), ("vulkan:0",)):
            done = self.check("bits(x)", "\n".join(points.split()[:9]), "--expect", self.write("words.csv", words), drivers=drivers)
            self.assertTrue("is not here" in done.stderr or done.returncode == 0, done.stdout + done.stderr)

    def test_a_table_may_be_one_of_a_spreadsheet(self):
        for text in (b'\xef\xbb\xbf# from a spreadsheet,\r\n"x"\r\n"0.5"\r\n', b"x,,\n0.5,,\n\n"):
            done = self.check("twice(x)", text, "--expect", self.write("right.csv", b'\xef\xbb\xbf"y"\r\n"1"\r\n'))
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_translator_that_takes_another_form_gets_one_that_is_written(self):
        for through in (("naga",), ("spirv-cross",)):
            done = self.check("twice(x)", "x\n1\n", *(word for one in through for word in ("--through", one)), drivers=("egl-gles",))
            if "cannot be run" in done.stderr or "is not here" in done.stderr:
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.results()["runs"][0]["way"][0]["takes"], "spirv")

    def test_the_page_is_about_the_function(self):
        self.check("twice(x)", "x\n1\n", "--expect", self.write("right.csv", "y\n3\n"))
        page = (self.out / "index.html").read_text()
        self.assertIn(f"Check of <strong>{self.glsl}:twice(x)</strong>", page)
        self.assertIn(f"compared with the right ones in {self.folder}/right.csv", page)
        self.assertEqual(self.results()["runs"][0]["check"], {"function": f"{self.glsl}:twice(x)", "right_values": f"{self.folder}/right.csv"})

    def test_bad_input_is_refused_with_its_place(self):
        points, own = self.folder / "points.csv", self.glsl
        values = self.write("values.csv", "value\n1\n")
        for expression, text, arguments, parts in (
                ("twice(x)", "x\n1\ntwo\n", (), (f'{points}:3:1: "two" is no float, as 0.5, -1e-3, inf and nan are (column x, float)',)),
                ("twice(x)", "x\n1e39\n", (), (f'{points}:2:1: "1e39" is beyond the largest float',)),
                ("twice(x)", "x\n+-1\n", (), (f'{points}:2:1: "+-1" is no float',)),
                ("twice(x)", 'x\n"0,5"\n', (), (f'{points}:2:1: "0,5" is no float; write a point in place of the comma',)),
                ("twice(x)", "x,y\n,1\n", (), (f'{points}:2:1: "" is no float; write nan where there is no number',)),
                ("twice(float(i))", "i:int\n7.0\n", (), (f'{points}:2:1: "7.0" is no whole number in decimal digits (column i, int)',)),
                ("twice(float(i))", "i:uint\n4294967296\n", (), (f'{points}:2:1: "4294967296" is out of the range of its type',)),
                ("twice(x)", "x\np 1\n", (), (f'{points}:2:1: "p 1" is no float',)),
                ("twice(x)", "# x\n0.5\n1\n", (), (f'{points}:2:1: "0.5" is no name of an argument; the first line that',)),
                ("twice(x)", ",x\n0,0.5\n", (), (f'{points}:1:1: "" has no name',)),
                ("twice(x)", "x;y\n0,5;1\n", (), (f"{points}:1: it has semicolons between its fields",)),
                ("twice(x)", "x\n1\n".encode("utf-16"), (), (f"{points}: it is UTF-16",)),
                ("twice(x)", "x\n1,2\n", (), (f"{points}:2: it has 2 fields, and the header has 1",)),
                ("twice(x)", "x\n", (), (f"{points}: there must be a header, and 1 to 1048576 rows",)),
                ("twice(x)", "p.x,p.z\n1,2\n", (), (f'{points}:1:2: "p.z" does not follow',)),
                ("twice(x)", "x:half\n1\n", (), (f'{points}:1:1: "x:half" has no type',)),
                ("twice(y)", "x\n1\n", (), ("the expression of twice:1", "'y'", "of the points' float x")),
                ("bvec2(x)", "x\n1\n", (), ("the expression must be a float",)),
                ("twice(x)", "x\n1\n2\n", ("--expect", values), (f"{values}: it has 1 columns and 1 rows below its header; the function returns 1 numbers at each of 2",)),
                ("vec2(x)", "x\n1\n", ("--expect", values), ("1 rows below its header; the function returns 2 numbers",)),
                ("twice(x)", "x\n1\n", ("--driver", "gpu"), ('there is no driver "gpu"',))):
            with self.subTest(text=text, expression=expression):
                self.assert_refused(self.check(expression, text, *arguments, drivers=()), *parts)
        own.write_text("float twice(float x) {\n  return wrong;\n}\n")
        self.assert_refused(self.check("twice(x)", "x\n1\n"), f"{own}:2", "'wrong'")


if __name__ == "__main__":
    unittest.main(verbosity=2)
