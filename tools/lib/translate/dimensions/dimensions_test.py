"""Tests of the texts that are generated from the plane's."""

from __future__ import annotations

import unittest

from translate.dimensions import files
from translate.dimensions.numbers import IN_SPACE
from translate.dimensions.rule import Unclear, in_dimension


class Rule(unittest.TestCase):
    """The library's own files are made by it, and command_test holds them to that."""

    def test_a_value_grows_with_its_derivatives(self):
        self.assertEqual(in_dimension(3, "hn_vec3 n = vec3(v, g.x, g.y);"), "hn_vec4 n = vec4(v, g.x, g.y, g.z);")
        with self.assertRaisesRegex(Unclear, "hn_vec3 has no room"):
            in_dimension(4, "hn_vec3 n;")

    def test_what_is_unclear_is_an_error(self):
        for n, plane, why in ((3, "n = a.x * b.y;", "y is in no pair: `n = a.x"),
                              (3, "n = a.x * b.y - a.y * b.x;", "y is in no pair"),  # a difference is no sum
                              (3, "n = c - v.x + v.y;", "y is in no pair"),  # and v.y is not its second
                              (3, "n = v.x + v.y * 2;", "y is in no pair"),
                              (3, "s.x = 1;\n#if A\ns.y = 1;\n#endif\n", "y is in no pair"),
                              (3, "x = 1;\n// another\ny = 1;\n", "y is in no pair"),
                              (3, "vec2(f(s), g(s))", "no argument for each axis"),
                              (3, "vec2(a.x, 0.0f)", "no argument for each axis"),
                              (4, "f(a.y, a.z)", "no axis behind it"),
                              (1, "f(a.x, a.y, a.z)", "more than one like it"),
                              (3, "s.x = f(vec2(1, 1));\ns.y = f(vec2(1, 1));", "vector of the plane, and is one of")):
            with self.subTest(plane=plane), self.assertRaisesRegex(Unclear, why):
                in_dimension(n, plane)


def part(what: str, text: str) -> str:
    return f"// From here {what}\n{text.rstrip()}\n// To here {what}\n"


SAME = "a3d.glsl is generated from a2d.glsl."
BELOW = "// Generated for 1, 3 and 4 dimensions from the lines above.\n"


def struct(n: str, type_: str) -> str:
    return f"struct hn_place{n} {{\n  hn_{type_} cell;\n}};\n"


class Files(unittest.TestCase):
    def test_what_is_below_a_line_is_made_of_what_is_above_it(self):
        above = "#if A\n// A place.\n" + struct("2", "ivec2") + "HN_FN hn_int f(hn_int cell) { return 0; }\n" + BELOW
        made = struct("1", "int") + struct("3", "ivec3") + struct("4", "ivec4")
        for below in ("#endif\n", "\nHN_FN hn_int f() { return 1; }\n", ""):
            for stale in ("", made, struct("5", "ivec5")):
                with self.subTest(below=below, stale=stale):
                    self.assertEqual(files.made({"a.glsl": above + stale + below}), {"a.glsl": above + made + below})

    def test_one_dimension_alone(self):
        text = struct("2", "ivec2") + BELOW.replace("1, 3 and 4", "3")
        self.assertEqual(files.made({"a.glsl": text}), {"a.glsl": text + struct("3", "ivec3")})

    def test_what_is_by_hand_stays(self):
        plane = f"two\nhand 2\n{part(SAME, 'hn_place2')}more by hand 2\n{part(SAME, 'hn_vec2')}end 2\n"
        space = f"three\n{part(SAME, 'old')}hand 3\n{part(SAME, 'old')}end 3\n"
        self.assertEqual(files.made({"detail/a2d.glsl": plane, "detail/a3d.glsl": space}),
                         {"detail/a3d.glsl": f"three\n{part(SAME, 'hn_place3')}hand 3\n{part(SAME, 'hn_vec3')}end 3\n"})

    def test_a_file_of_several_dimensions(self):
        same = "a.glsl is generated from detail/a2d.glsl, in 1 and 3 dimensions."
        plane = f"\n// A place.\n{struct('2', 'ivec2')}\n#if A\nHN_FN hn_int f(hn_place2 p) {{}}\n#endif\n"
        made = (f"\n// A place.\n{struct('1', 'int')}{struct('3', 'ivec3')}\n#if A\nHN_FN hn_int f(hn_place1 p) {{}}\n"
                f"HN_FN hn_int f(hn_place3 p) {{}}\n#endif\n")
        texts = {"detail/a2d.glsl": f"hn_int f() {{}}\n{part(same, plane)}hand 2\n", "a.glsl": f"two\n{part(same, 'old')}hand 3\n"}
        self.assertEqual(files.made(texts), {"a.glsl": f"two\n{part(same, made)}hand 3\n"})

    def test_a_whole_file(self):
        same = "warp3d.glsl is generated from warp2d.glsl."
        numbers = IN_SPACE["warp2d.glsl"]
        head = "// A warp.\n// To read it in one piece: docs/reference/snippets/hn_warp2.md\n"
        plane = f"{head}\n{part(same, f'hn_place2  // {chr(32).join(numbers)}')}\n#endif\n"
        made = ("// A warp.\n//\n// Made from warp2d.glsl by tools/make. tools/lib/translate/dimensions/numbers.py has its numbers."
                f"\n\n{part(same, f'hn_place3  // {chr(32).join(numbers.values())}')}\n#endif\n")
        self.assertEqual(files.made({"warp2d.glsl": plane, "warp3d.glsl": "old\n"}), {"warp3d.glsl": made})

    def test_a_number_is_no_part_of_another(self):
        self.assertEqual(files.transformed("warp2d.glsl", "// 28 multiplications and 8 multiplications", 3),
                         "// 28 multiplications and 18 multiplications")
        self.assertEqual(files.transformed("warp2d.glsl", "// 8 multiplications", 4), "// 8 multiplications")

    def test_a_line_that_cannot_be_followed_is_an_error(self):
        two = struct("2", "ivec2")
        for texts, why in (
                ({"a.glsl": f"{struct('1', 'int')}{BELOW}"}, "a.glsl has nothing of the plane above"),
                ({"a.glsl": f"{two}\n{BELOW}"}, "a.glsl has nothing of the plane above"),
                ({"a.glsl": two + BELOW.replace("4", "5")}, "a.glsl has .*, which tools/make dimensions does not know"),
                ({"a3d.glsl": f"// From here {SAME}\n"}, "a3d.glsl has .*, or only one end of it"),
                ({"a3d.glsl": part(SAME, "")}, "a3d.glsl needs as many lines .* as a2d.glsl"),
                ({"a3d.glsl": part(SAME, ""), "a2d.glsl": part(SAME, "") * 2}, "a3d.glsl needs as many lines .* as a2d.glsl"),
                ({"a2d.glsl": part(SAME, "f();\n")}, "generated from a2d.glsl.` is in a2d.glsl: it must name all"),
                ({"a2d.glsl": part(SAME, "f(a.y);\n"), "a3d.glsl": part(SAME, "")}, "a2d.glsl, in 3 dimensions: y is in no pair: `f"),
                ({"warp2d.glsl": ""}, "warp2d.glsl does not state `8 multiplications`")):
            with self.subTest(texts=texts), self.assertRaisesRegex(Unclear, why):
                files.made(texts)
