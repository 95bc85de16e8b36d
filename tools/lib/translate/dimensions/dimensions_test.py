"""Tests of the texts that are generated from the plane's."""

from __future__ import annotations

import unittest

from translate.dimensions import files, layout
from translate.dimensions.numbers import IN_SPACE
from translate.dimensions.rule import Unclear, in_dimension


class Names(unittest.TestCase):
    def test_types_and_files_have_the_number_of_dimensions(self):
        plane = '#include "a2d.glsl"\nhn_place2 f(hn_vec2 p, hn_ivec2 c, hn_i_num2 n, hn_i_box2 b) {}\n'
        for n, made in ((1, '#include "a1d.glsl"\nhn_place1 f(hn_float p, hn_int c, hn_i_num n, hn_i_box1 b) {}\n'),
                        (3, '#include "a3d.glsl"\nhn_place3 f(hn_vec3 p, hn_ivec3 c, hn_i_num3 n, hn_i_box3 b) {}\n'),
                        (4, '#include "a4d.glsl"\nhn_place4 f(hn_vec4 p, hn_ivec4 c, hn_i_num4 n, hn_i_box4 b) {}\n')):
            with self.subTest(n=n):
                self.assertEqual(in_dimension(n, plane), made)

    def test_a_value_grows_with_its_derivatives(self):
        self.assertEqual(in_dimension(3, "hn_vec3 n = vec3(v, g.x, g.y);"), "hn_vec4 n = vec4(v, g.x, g.y, g.z);")
        with self.assertRaisesRegex(Unclear, "hn_vec3 has no room"):
            in_dimension(4, "hn_vec3 n;")

    def test_the_type_of_what_is_named_after_an_axis_stays(self):
        self.assertEqual(in_dimension(3, "hn_ivec2 x;\nhn_ivec2 y;\nhn_ivec2 p;"),
                         "hn_ivec2 x;\nhn_ivec2 y;\nhn_ivec2 z;\nhn_ivec3 p;")

    def test_results_may_stay(self):
        self.assertEqual(in_dimension(3, "HN_FN hn_vec2 f(hn_vec2 p) {}", False), "HN_FN hn_vec2 f(hn_vec3 p) {}")

    def test_comments_say_where_they_are(self):
        self.assertEqual(in_dimension(3, "// A sum on the plane, along x and y: fbm2d.glsl has 2 of hn_vec2.\n"),
                         "// A sum in space, along x, y and z: fbm3d.glsl has 2 of hn_vec3.\n")
        self.assertEqual(in_dimension(1, "#ifndef HN_FBM2D_GLSL  // on the plane\n"),
                         "#ifndef HN_FBM1D_GLSL  // on the line\n")


class Pairs(unittest.TestCase):
    def test_arguments(self):
        for n, made in ((1, "f(p, 1)"), (3, "vec3(f(p.x, 1), f(p.y, 1), f(p.z, 1))"),
                        (4, "vec4(f(p.x, 1), f(p.y, 1), f(p.z, 1), f(p.w, 1))")):
            self.assertEqual(in_dimension(n, "vec2(f(p.x, 1), f(p.y, 1))"), made)

    def test_arguments_of_a_constructor_may_be_the_same(self):
        self.assertEqual(in_dimension(3, "vec2(0.0f, 0.0f)"), "vec3(0.0f, 0.0f, 0.0f)")
        self.assertEqual(in_dimension(1, "ivec2(0, 0)"), "0")
        self.assertEqual(in_dimension(3, "max(a, a) + uvec2(c)"), "max(a, a) + uvec3(c)")
        self.assertEqual(in_dimension(1, "uvec2(c)"), "uint(c)")

    def test_they_need_not_begin_with_x_and_may_name_several_axes(self):
        self.assertEqual(in_dimension(3, "g(f(s.x, n.y), f(s.y, n.z))"), "g(f(s.x, n.y), f(s.y, n.z), f(s.z, n.w))")
        self.assertEqual(in_dimension(3, "ivec2(o.x.y & 15, o.y.y & 15)"), "ivec3(o.x.y & 15, o.y.y & 15, o.z.y & 15)")

    def test_names_that_end_in_an_axis(self):
        self.assertEqual(in_dimension(4, "uvec2(c.x - HN_I_STEP_X, c.y - HN_I_STEP_Y)"),
                         "uvec4(c.x - HN_I_STEP_X, c.y - HN_I_STEP_Y, c.z - HN_I_STEP_Z, c.w - HN_I_STEP_W)")

    def test_parameters(self):
        self.assertEqual(in_dimension(3, "f(hn_i_num r, hn_i_num x, hn_i_num y, hn_i_num t)"),
                         "f(hn_i_num r, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num t)")

    def test_operands(self):
        self.assertEqual(in_dimension(3, "n = v.x * v.x + v.y * v.y;"), "n = v.x * v.x + v.y * v.y + v.z * v.z;")
        self.assertEqual(in_dimension(4, "return f(j.x ^ j.y ^ s);"), "return f(j.x ^ j.y ^ j.z ^ j.w ^ s);")
        self.assertEqual(in_dimension(1, "n = v.x + v.y;"), "n = v;")

    def test_statements_and_members(self):
        self.assertEqual(in_dimension(3, "{\n  s.x = f(v.x);\n  s.y = f(v.y);\n  return s;\n}"),
                         "{\n  s.x = f(v.x);\n  s.y = f(v.y);\n  s.z = f(v.z);\n  return s;\n}")
        self.assertEqual(in_dimension(4, "  hn_i_num x;  // along each axis\n  hn_i_num y;\n"),
                         "  hn_i_num x;  // along each axis\n  hn_i_num y;\n  hn_i_num z;\n  hn_i_num w;\n")

    def test_functions(self):
        function = "HN_FN hn_uint f_{0}(hn_i_box{1} b) {{ return b.{0}; }}\n"
        self.assertEqual(in_dimension(3, "".join(function.format(axis, 2) for axis in "xy")),
                         "".join(function.format(axis, 3) for axis in "xyz"))

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


class Lines(unittest.TestCase):
    A, B = "a" * 34, "b" * 30

    def test_a_long_line_is_broken_where_the_fewest_brackets_are_open(self):
        self.assertEqual(layout.broken(f"  return f({self.A}, g({self.A}, {self.B}), h(1, 2));"),
                         [f"  return f({self.A}, g({self.A}, {self.B}),", "           h(1, 2));"])
        self.assertEqual(layout.broken(f"  n = f({self.A}, 1) + f({self.A}, 2) + f({self.B}, 3);"),
                         [f"  n = f({self.A}, 1) + f({self.A}, 2) +", f"      f({self.B}, 3);"])
        self.assertEqual(layout.broken(f"HN_FN hn_float f(hn_vec2 p) {{ return f({self.A * 2}, {self.B}); }}"),
                         ["HN_FN hn_float f(hn_vec2 p) {", f"  return f({self.A * 2}, {self.B});", "}"])
        short = f"  return f({self.A}, {self.B});"
        self.assertEqual(layout.broken(short), [short])

    def test_words_of_a_comment_go_to_its_next_line(self):
        for first, indented, after in (("// ", "// ", "HN_FN"),
                                       ("//   returns  ", "//            ", "//   error    none")):
            words = "word " * ((layout.WIDTH - len(first)) // len("word "))
            with self.subTest(first=first):
                self.assertEqual(layout.with_short_lines(f"{first}{words}and longer.\n{indented}More.\n{after}"),
                                 f"{first}{words.strip()}\n{indented}and longer. More.\n{after}")
                self.assertEqual(layout.with_short_lines(f"{first}{words}and longer.\n{after}"),
                                 f"{first}{words.strip()}\n{indented}and longer.\n{after}")

    def test_code_on_the_line_is_in_one_line_if_it_fits(self):
        self.assertEqual(layout.joined("  return f(a,\n           b);\n// c\n    d;"),
                         "  return f(a, b);\n// c\n    d;")
        long = f"  f({self.A * 3},\n    {self.B});"
        self.assertEqual(layout.joined(long), long)
        self.assertEqual(layout.joined("hn_float f(hn_float p) {\n  return g(p,\n           p);\n}"),
                         "hn_float f(hn_float p) { return g(p, p); }")


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
                ({"a.glsl": two + BELOW.replace("4", "5")}, "a.glsl has .*, which tools/make umbrella does not know"),
                ({"a3d.glsl": f"// From here {SAME}\n"}, "a3d.glsl has .*, or only one end of it"),
                ({"a3d.glsl": part(SAME, "")}, "a3d.glsl needs as many lines .* as a2d.glsl"),
                ({"a3d.glsl": part(SAME, ""), "a2d.glsl": part(SAME, "") * 2}, "a3d.glsl needs as many lines .* as a2d.glsl"),
                ({"a2d.glsl": part(SAME, "f();\n")}, "generated from a2d.glsl.` is in a2d.glsl: it must name all"),
                ({"a2d.glsl": part(SAME, "f(a.y);\n"), "a3d.glsl": part(SAME, "")}, "a2d.glsl, in 3 dimensions: y is in no pair: `f"),
                ({"warp2d.glsl": ""}, "warp2d.glsl does not state `8 multiplications`")):
            with self.subTest(texts=texts), self.assertRaisesRegex(Unclear, why):
                files.made(texts)
