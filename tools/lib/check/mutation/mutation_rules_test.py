"""Tests of rules.py."""

from __future__ import annotations

import re
import unittest

from base.tree import glsl_files
from check.mutation import rules


def changed(rule: rules.Rule, body: str, head: str = "") -> list[str]:
    return [body[:change.start] + change.new + body[change.end:] for change in rule(rules.Code(body, head))]


class Reading(unittest.TestCase):
    SOURCE = """// 1 { 2 }
#define ONE(x) { \\
  3 }
const int outside = 4;
/* 5 {
   6 */ int f(int x) {
#if x > 8  // { 9
  if (y) { return 11; }  // 12
#else
  return 13;
#endif
}
#ifdef __cplusplus
int h() { return 15; }
#endif
int g() { return 14; }
"""

    def test_only_bodies_and_directives_are_changed_in_every_branch_that_a_shader_sees(self):
        found = [(self.SOURCE.count("\n", 0, change.start) + 1, change.new)
                 for rule, change in rules.changes(self.SOURCE) if rule == "constant"]
        self.assertEqual(found, [(8, "12"), (8, "10"), (10, "14"), (10, "12"), (16, "15"), (16, "13")])
        lines = {self.SOURCE.count("\n", 0, change.start) + 1
                 for rule, change in rules.changes(self.SOURCE) if rule == "directive"}
        self.assertEqual(lines, {2, 3, 7, 13})

    def test_blanking_keeps_every_offset(self):
        for blanked in (rules.without_comments, rules.without_directives, rules.without_cpp):
            self.assertEqual([len(line) for line in blanked(self.SOURCE).split("\n")],
                             [len(line) for line in self.SOURCE.split("\n")])

    def test_a_function_knows_its_parameters(self):
        (start, code), *_ = rules.functions("int a; float f(hn_vec2 p, int n) { return p.x; }")
        self.assertEqual(start, 34)
        self.assertEqual([name for _, name, _ in code.variables], ["a", "p", "n"])
        self.assertEqual(code.type_of(1), "vec2")
        self.assertEqual(code.type_of(3), "")  # a component is not a variable

    def test_the_types_of_the_library_are_types(self):
        head = "hn_i_num f(hn_i_num2 p, hn_float a, float b, hn_i_num n)"
        self.assertEqual([kind for _, _, kind in rules.Code("", head).variables], ["num2", "float", "float", "num"])
        self.assertEqual(changed(rules.swap_arguments, "g(a, b, p.x, n, p)", head),
                         ["g(b, a, p.x, n, p)", "g(a, b, n, p.x, p)"])

    def test_what_only_cpp_sees_is_blank(self):
        text = "#ifdef __cplusplus\na\n#if 1\nb\n#else\nc\n#endif\n#elif defined(GL_ES)\nd\n#else\ne\n#endif\nf"
        self.assertEqual("".join(line for line in rules.without_cpp(text).split("\n") if line[:1] != "#").split(),
                         ["def"])
        self.assertNotIn("#if 1", rules.without_cpp(text))
        self.assertIn("#elif defined(GL_ES)", rules.without_cpp(text))

    def test_braces_that_do_not_match_are_an_error(self):
        with self.assertRaises(ValueError):
            list(rules.functions("f() { {"))


FLOATS, ARGUMENTS = "float f(float m, uint w, bool b, ivec2 c)", "float f(vec2 p, float a, float b, uint w, uvec2 c)"
# A rule, the head of a function, its body, and what the body may become.
CHANGES = (
    # Small integers get their neighbours, and shifts stay below the word.
    (rules.change_constants, "", "a + 1u", ["a + 2u", "a + 0u"]),
    (rules.change_constants, "", "a + 0", ["a + 1"]),
    (rules.change_constants, "", "a & 0xFFu", ["a & 0x100u", "a & 0xFEu"]),
    (rules.change_constants, "", "a & 0xF", ["a & 0x10", "a & 0xE"]),
    (rules.change_constants, "", "a << 31", ["a << 30"]),
    (rules.change_constants, "", "a >>= 0x1F", ["a >>= 0x1E"]),
    # Words get their lowest and their highest bit flipped.
    (rules.change_constants, "", "k *= 0xFFFFFFFFu", ["k *= 0xFFFFFFFEu", "k *= 0x7FFFFFFFu"]),
    (rules.change_constants, "", "k & 0x007FFF80u", ["k & 0x007FFF81u", "k & 0x003FFF80u"]),
    (rules.change_constants, "", "k * 16777619u", ["k * 16777618u", "k * 403u"]),
    # Floats move by a sixty-fourth, and terms of quotients by one, unless that could be rounded away.
    (rules.change_constants, "", "0.0f", ["0.015625f"]),
    (rules.change_constants, "", "f * 128.0f", ["f * 130.0f"]),
    (rules.change_constants, "", "-1e2", ["-101.5625"]),
    (rules.change_constants, "", "1913.0f / 1024.0f", ["1914.0f / 1024.0f", "1913.0f / 1025.0f"]),
    (rules.change_constants, "", "x / 65536.0f", ["x / 66560.0f"]),
    # Digits in names are no constants.
    (rules.change_constants, "", "k1 = vec2(h00, d.x3).x_4", []),
    (rules.change_constants, "", "f(true, false)", ["f(false, false)", "f(true, true)"]),
    (rules.change_operators, "", "a + b", ["a - b"]),
    (rules.change_operators, "", "(a) - b[0] * -c", ["(a) + b[0] * -c", "(a) - b[0] + -c"]),
    (rules.change_operators, "", "a / b % c", ["a * b % c", "a / b / c"]),
    (rules.change_operators, "", "a & b | c ^ 1", ["a | b | c ^ 1", "a & b & c ^ 1", "a & b | c | 1", "a & b | c + 1"]),
    (rules.change_operators, "", "a && b || !c", ["a || b || !c", "a && b && !c"]),
    (rules.change_operators, "", "a ^= b;", ["a |= b;", "a += b;", "a = b;"]),
    (rules.change_operators, "", "a += b; c *= d", ["a -= b; c *= d", "a = b; c *= d", "a += b; c += d", "a += b; c = d"]),
    (rules.change_operators, "", "++i", ["--i"]),
    # A sign is no operator.
    (rules.change_operators, "", "return -a;", []),
    (rules.change_operators, "", "a = -b, (-c)", []),
    (rules.change_shifts, "", "a << 3 + b >> 4", ["a >> 3 + b >> 4", "a << 3 + b << 4"]),
    (rules.change_shifts, "", "a >>= 3", ["a <<= 3", "a = 3"]),
    (rules.change_comparisons, "", "a < b", ["a <= b", "a >= b"]),
    (rules.change_comparisons, "", "a >= b == c", ["a > b == c", "a < b == c", "a >= b != c"]),
    (rules.change_comparisons, "", "a <<= b << c", []),
    # A minus is dropped, and what stands first is negated, unless it is a word or a target.
    (rules.change_signs, "", "a * -b - c", ["a * b - c"]),
    (rules.change_signs, "", "!a", ["a"]),
    (rules.change_signs, FLOATS, "return m + 1.0f;", ["return -m + 1.0f;"]),
    (rules.change_signs, FLOATS, "g(ivec2(c), m)", ["g(ivec2(-c), m)", "g(ivec2(c), -m)"]),
    (rules.change_signs, FLOATS, "return b ? abs(m) : m;", [
        "return !b ? abs(m) : m;", "return b ? -abs(m) : m;", "return b ? abs(-m) : m;", "return b ? abs(m) : -m;"]),
    (rules.change_signs, FLOATS, "float x = 1.0f; m = (w);", []),
    # Adjacent arguments of a type are swapped.
    (rules.swap_arguments, ARGUMENTS, "g(a, b, p)", ["g(b, a, p)"]),
    (rules.swap_arguments, ARGUMENTS, "g((w >> 1) & 1u, w)", ["g(w, (w >> 1) & 1u)"]),
    (rules.swap_arguments, ARGUMENTS, "g(p.x + 1.0f,\n  b)", ["g(b,\n  p.x + 1.0f)"]),
    (rules.swap_arguments, ARGUMENTS, "g(h(1u, c.x), h(w, 2u))", [
        "g(h(w, 2u), h(1u, c.x))", "g(h(c.x, 1u), h(w, 2u))", "g(h(1u, c.x), h(2u, w))"]),
    # A constructor takes what is not known as well; what would not compile or not matter is left.
    (rules.swap_arguments, ARGUMENTS, "vec2(a, h(w))", ["vec2(h(w), a)"]),
    (rules.swap_arguments, ARGUMENTS, "g(a < b, b, a)", ["g(a < b, a, b)"]),
    (rules.swap_arguments, ARGUMENTS, "hn_i_multiply_add(a, b, 1.0f)", ["hn_i_multiply_add(a, 1.0f, b)"]),
    *((rules.swap_arguments, ARGUMENTS, text, []) for text in (
        "g(p, a)", "g(p.x, w)", "g(h(p), a)", "g(a, a)", "min(a, b)", "if (a, b)", "g()", "g(2, w)")),
    # Another function, or none.
    (rules.change_calls, "", "min(floor(x), max)", [
        "max(floor(x), max)", "min(ceil(x), max)", "min(trunc(x), max)", "min((x), max)"]),
    (rules.change_calls, "", "hn_hash_pcg(k)", ["hn_hash_xxhash32(k)"]),
    (rules.change_calls, "", "abs(x) + hn_i_high(k, next)", ["(x) + hn_i_high(k, next)"]),
    # Components, and variables of the type that are declared before or next.
    (rules.change_components, "", "x * v.x + v.w", ["x * v.y + v.w", "x * v.x + v.x"]),
    (rules.change_variables, "float f(float a, vec2 b, vec2 c, float d)", "return a * c.x;", [
        "return d * c.x;", "return a * b.x;"]),
    (rules.change_variables, "uint f(uint k)", "uint m = k; m = m ^ 1u;", ["uint m = k; m = k ^ 1u;"]),
    (rules.change_variables, "float f(vec2 a, uint b)", "return a.x;", []),
    # Assignments are dropped.
    (rules.drop_statements, "", "float a = 1; a += 2; for (int i = 0; i < a; ++i) { a = i; }", [
        "float a = 1;  for (int i = 0; i < a; ++i) { a = i; }", "float a = 1; a += 2; for (int i = 0; i < a; ++i) {  }"]),
    (rules.drop_statements, "", "s.a += 2; v.x = s.a; return v.x;", [
        " v.x = s.a; return v.x;", "s.a += 2;  return v.x;"]))


class Changes(unittest.TestCase):
    def test_of_each_rule(self):
        for rule, head, text, results in CHANGES:
            with self.subTest(rule.__name__, text=text):
                self.assertEqual(changed(rule, text, head), results)

    def test_functions_that_rules_name_exist(self):
        text = "".join(path.read_text(encoding="ascii") for path in glsl_files().values())
        defined = set(re.findall(r"\b(hn_\w+)\(", text))
        named = {name for name in (*rules.STEPS, *rules.OTHER_FUNCTIONS) if name.startswith("hn_")}
        self.assertGreater(len(named), 20)
        self.assertEqual(named - defined, set())


class Directives(unittest.TestCase):
    def changed(self, line: str) -> list[str]:
        return [line[:change.start] + change.new + line[change.end:] for change in rules.change_directive(line)]

    def test_lines_are_dropped(self):
        for line in ('#include "hash.glsl"', "#error too small", "  #define NAME"):
            self.assertEqual([text.strip() for text in self.changed(line)], [""])

    def test_values_of_macros(self):
        self.assertEqual(self.changed("#define N 3"), ["", "#define N 4", "#define N 2"])
        self.assertEqual(self.changed("#define F(x, n) g(x & 0xF)"),
                         ["", "#define F(x, n) g(x & 0x10)", "#define F(x, n) g(x & 0xE)",
                          "#define F(x, n) g(x | 0xF)"])
        self.assertEqual(self.changed("#define HN_HASH HN_HASH_PCG"), ["", "#define HN_HASH HN_HASH_XXHASH32"])
        self.assertEqual(self.changed("#define HN_I_HIGHP highp"), ["", "#define HN_I_HIGHP mediump"])

    def test_conditions(self):
        self.assertEqual(self.changed("#if A < 1 || B"), ["#if A < 2 || B", "#if A < 0 || B", "#if A < 1 && B",
                                                          "#if A <= 1 || B", "#if A >= 1 || B"])
        self.assertEqual(self.changed("#elif A == 0"), ["#elif A == 1", "#elif A != 0"])
        self.assertEqual(self.changed("#if KNOB"), ["#if !KNOB"])
        self.assertEqual(self.changed("#ifdef A"), ["#ifndef A"])
        self.assertEqual(self.changed("#ifndef A"), ["#ifdef A"])
        self.assertEqual(self.changed("#if !defined(A)"), ["#if defined(A)"])
        self.assertEqual(self.changed("#elif defined(A)"), ["#elif !defined(A)"])

    def test_what_only_structures_stays(self):
        self.assertEqual(self.changed("#else") + self.changed("#endif"), [])
