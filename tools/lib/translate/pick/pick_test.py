"""Tests of tools/pick: the values of its texts, their compilation, its size, and bad usage."""

from __future__ import annotations

import contextlib
import functools
import io
import itertools
import operator
import re
import shutil
import subprocess
import tempfile
import unittest
from collections.abc import Iterable
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from unittest import mock

from base.thorough import THOROUGH
from base.tree import GLSL, ROOT, TOOLS
from translate.names import is_passed
from translate.parsing.preprocessor import Preprocessor
from translate.parsing.syntax import Binary, Function, Name, Number, Parentheses, Parser, definitions
from translate.parsing.tokens import Unknown, tokens_of
from translate.pick import command, comments, pages, shader, tsl, values
from translate.pick.evaluate import Module
from translate.pick.printer import Language
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES

# The largest that a text may be, without the comment.
SIZES = {"hn_perlin2": (1600, 42), "hn_value2": (1600, 42), "hn_simplex2": (2600, 48), "hn_cellular2": (2700, 52),
         "hn_fbm2": (2225, 48)}
OPERATORS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "<<": operator.lshift, ">>": operator.rshift,
             "&": operator.and_, "|": operator.or_, "^": operator.xor}
WITHOUT_HIGHP = Language()  # as GLSL is, for readers of a test
# Functions with most of the constructs that languages write differently.
MIXED = ("hn_perlin2", "hn_fbm_d2", "hn_cellular2_nearest", "hn_tile4", "hn_next3")


# The languages that can be deleted, and that were.
DELETED = {"csharp", "go", "java", "rust", "verilog"} - {*command.SYNTAXES, *command.OTHERS}


def here(cases: Iterable[tuple]) -> list[tuple]:
    """The cases that name no language that was deleted, in their words or in the words of a command."""
    return [case for case in cases if not DELETED & {*case, *(case[0] if isinstance(case[0], tuple) else ())}]


@functools.cache
def module(arithmetic: str, hash_: str = "lattice", gradient: str = "octahedral") -> Module:
    return read(GLSL, command.settings(arithmetic, hash_, gradient))


@functools.lru_cache(maxsize=8)
def program(of: Module, *names: str, calls_first: bool = False) -> Program:
    return Program(of, chosen(of, names), calls_first)


def text(*names: str, arithmetic: str = "fast", language: str = "glsl", of: Module | None = None,
         calls_first: bool = False) -> str:
    made = program(of or module(arithmetic), *names, calls_first=calls_first)
    return made.text(LANGUAGES[language], arithmetic == "precise")


def code(shown: str) -> str:
    return "".join(line for line in shown.splitlines(keepends=True) if not line.startswith("//"))


def is_node(function: Function) -> bool:
    """Whether three.js has nodes for it."""
    try:
        return bool(tsl.signature(function))
    except Unknown:
        return False


class Constants(unittest.TestCase):
    def test_what_is_made_of_them_is_one_where_all_languages_agree(self) -> None:
        """naga 22 refuses i32(1048576.0), and SPIRV-Tools of 2023 computes some bits wrong."""
        def constant(value: str | int) -> values.Constant:
            whole = "uint" if isinstance(value, int) and value >= 0 else "int"
            return values.Constant("float" if isinstance(value, str) else whole, value)

        for type_, given, expected in (
                ("int", "1048576.0f", 1048576), ("int", "-1.75f", -1), ("int", "-2147483648.0", -2**31),
                ("int", "2147483648.0", None), ("int", "16777217.0", None), ("uint", "4294967040.0", 4294967040),
                ("uint", "4294967296.0", None), ("uint", "-0.5", 0), ("uint", "-1.0", None), ("int", 2**32 - 1, -1), ("uint", -1, 2**32 - 1),
                ("float", 16777216, "16777216.0f"), ("float", 16777217, None), ("float", -3, "-3.0f")):
            made = values.construct(type_, (constant(given),))
            with self.subTest(type_=type_, given=given):
                self.assertEqual(made.value if isinstance(made, values.Constant) else None, expected)
                self.assertEqual(made.type, type_)
        for sign, left, right, expected in (
                ("*", "0.0", "1048576.0", "0.0f"), ("*", "-0.0", "1048576.0", None), ("*", "0.0", "-2.0", None),
                ("/", "0.0", "4.0", "0.0f"), ("/", "0.0", "0.0", None), ("-", "0.5", "0.5", "0.0f"),
                ("*", "0.1", "0.5", None)):
            with self.subTest(sign, left=left, right=right):
                made = values.binary(sign, constant(left), constant(right))
                self.assertEqual(made.value if isinstance(made, values.Constant) else None, expected)
        for given, word in (("1.0f", 0x3F800000), ("-0.0", 0x80000000)):
            self.assertEqual(values.builtin("floatBitsToUint", "uint", (constant(given),)).value, word)
        self.assertNotIsInstance(values.builtin("floatBitsToUint", "uint", (constant("0.1"),)), values.Constant)

    def test_a_step_between_neighbours_is_one(self) -> None:
        """The library takes the origin off both, for compilers that see no constant otherwise."""
        x, step, origin = values.Variable("uint", "x"), values.Constant("uint", 3), values.Constant("uint", 5)
        ahead = values.binary("-", values.binary("+", x, step), origin)
        self.assertEqual(values.binary("-", ahead, values.binary("-", x, origin)), step)
        self.assertIsInstance(values.binary("-", ahead, values.binary("-", x, step)), values.Operation)


class Shaders(unittest.TestCase):
    def spirv(self, shader: str) -> str:
        """A shader after an optimizer."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [str(Path(folder) / name) for name in ("shader.frag", "whole.spv", "less.spv")]
            Path(paths[0]).write_text(shader, encoding="ascii")
            for call in (["glslangValidator", "-G", "--aml", "--amb", "-o", paths[1], paths[0]],
                         ["spirv-opt", "-O", paths[1], "-o", paths[2]]):
                done = subprocess.run(call, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            return subprocess.run(["spirv-dis", paths[2]], capture_output=True, text=True, check=True).stdout

    @staticmethod
    def operations(spirv: str) -> int:
        body = spirv[spirv.index("OpFunction "):]
        return len(re.findall(r"= Op(?!Label|Load|AccessChain|Phi|Variable|Function)\w+", body))

    MAIN = ("layout(location = 0) in vec4 v;\nlayout(location = 1) flat in uint seed;\n"
            "layout(location = 0) out vec4 color;\nvoid main() {{ color = vec4({}); }}\n")
    CALLS = {"hn_perlin2": "hn_perlin(v.xy, seed)", "hn_simplex3": "hn_simplex(v.xyz, seed)",
             "hn_cellular2": "hn_cellular(v.xy, seed), 0.0, 0.0",
             "hn_fbm2": "hn_fbm(v.xy, int(seed & 7u), v.z, v.w, seed)",
             "hn_warp_progressive2": "hn_warp_progressive(v.xy, 3, 2.0, 0.5, v.z, seed), 0.0, 0.0"}

    def test_no_operation_is_added(self) -> None:
        whole = subprocess.run([TOOLS / "pick", "whole", "--strip"], capture_output=True,
                               text=True, check=True).stdout
        for arithmetic in command.ARITHMETICS if THOROUGH else ("fast", "fixed"):
            # By default each in one arithmetic.
            calls = list(self.CALLS.items())[0 if THOROUGH else arithmetic == "fixed"::1 if THOROUGH else 2]
            for name, call in calls:
                main = self.MAIN.format(call)
                with self.subTest(name=name, arithmetic=arithmetic):
                    picked = self.operations(self.spirv(f"#version 450\n{text(name, arithmetic=arithmetic)}{main}"))
                    library = self.operations(self.spirv(
                        f"#version 450\n#define HN_ARITHMETIC HN_{arithmetic.upper()}\n{whole}{main}"))
                    self.assertLessEqual(picked, library)
                    self.assertGreater(picked, library // 2)  # so both were counted

    def test_precise_reaches_every_float(self) -> None:
        for name in ("hn_perlin2", "hn_fbm2"):
            spirv = self.spirv("#version 450\n" + text(name, arithmetic="precise") + self.MAIN.format(self.CALLS[name]))
            computed = set(re.findall(r"(%\w+) = OpF(?:Add|Sub|Mul|Div)", spirv))
            self.assertGreater(len(computed), 20)
            self.assertEqual(computed - set(re.findall(r"OpDecorate (%\w+) NoContraction", spirv)), set())

    def test_a_shader_of_the_suite_keeps_its_head_and_main(self) -> None:
        main = "uniform uint zero;\nvoid main() { colour = evaluate(zero); }\n"
        of_precise = "float twice(float x) { precise float n = x * 2.0; return n; }\n"
        for head, functions, short in (
                ("#version 310 es\n// case\nprecision mediump int;\n",
                 "highp uint twice(highp uint a) { precision highp int; return a * 2u; }\n"
                 "highp uint evaluate(highp uint a) { return twice(a) + 1u; }\n",
                 "highp uint evaluate(highp uint a) { return a * 2u + 1u; }\n"),
                ("#version 400\n", f"{of_precise}uint evaluate(uint a) {{ return uint(twice(float(a))); }}\n",
                 "uint evaluate(uint a) {\n  precise float n = float(a) * 2.0;\n  return uint(n);\n}\n")):
            with self.subTest(head):
                self.assertEqual(shader.shortened(head + functions + main), head + short + main)
        for refused in ("#version 330\nvoid main() {}\n", f"struct pair {{ mediump int a; }};\n{main}"):
            self.assertRaises(Unknown, shader.shortened, refused)

    def test_every_number_is_highp(self) -> None:
        bare = r"(?<!highp )\b(?:float|u?int|[iu]?vec\d) \w+(?: =|[,;)])"
        for name in list(module("fast").forms)[::1 if THOROUGH else 24]:
            self.assertNotRegex(text(name), bare)
        self.assertRegex(text(name).replace("highp ", ""), bare)

    def test_an_int_becomes_a_float_apart_from_its_uint_in_hlsl(self) -> None:
        """For vkd3d, which takes both conversions for one (detail/word.glsl)."""
        hlsl, glsl = (command.picker()(["hn_perlin2"], command.Choice(language, "fixed"))
                      for language in ("hlsl", "glsl"))
        self.assertIn("float(fraction_x | 0)", hlsl)
        self.assertEqual(re.findall(r"\bfloat\(\w+\)", hlsl), [])
        self.assertNotIn("| 0", glsl)

    def test_literals_of_literals_are_below_2_31(self) -> None:
        """FXC takes others for 2^31: 0x00E6133Eu * 8194u, for instance."""
        own = "uint own(uint x) {\n  return x ^ ((HN_I_SUM_Y * 2u) * 4097u & 255u);\n}"

        def large(arithmetic: str) -> list[str]:
            """The files of those that the library has, and this text."""
            library = Preprocessor(GLSL, {**command.settings(arithmetic, "lattice"), "precise": ""})
            library.read(f'#include "hashnoise.glsl"\n{own}', "own")
            constants = {name: Parser(list(one.body)).expression() for name, one in library.constants.items()}
            found = []

            def value(of: object) -> int | None:
                """The value of a literal, and of an expression of literals."""
                if isinstance(of, Number):
                    return int(of.at.text.rstrip("u"), 0) if re.fullmatch("0x[0-9A-F]+u?|[0-9]+u?", of.at.text) else None
                if isinstance(of, Name) and of.at.text in constants:
                    return value(constants[of.at.text])
                parts = [value(getattr(of, field.name)) for field in fields(of)] if is_dataclass(of) else []
                if isinstance(of, tuple | list):
                    parts = [value(part) for part in of]
                if isinstance(of, Parentheses):
                    return parts[-1]
                if not isinstance(of, Binary) or None in parts[1:] or of.at.text not in OPERATORS:
                    return None
                result = OPERATORS[of.at.text](*parts[1:])
                if result >= 2**31:
                    found.append(of.at.path)
                return result

            for function in definitions(library.items):
                value(function.body if isinstance(function, Function) else ())
            return found
        for arithmetic in command.ARITHMETICS if THOROUGH else ("fixed",):
            self.assertEqual(large(arithmetic), ["own"])

    def test_variables_have_names_of_their_own_in_godot(self) -> None:
        """As tools/pick whole gives them."""
        declared = r"\b(?:float|u?int|bool|[iu]?vec[234]|hn_\w+[1-4]) (\w+)(?= =|[,;)])|(?<=[;,]) (\w+)(?= =)"
        for name in MIXED[:3]:
            shown = code(text(name, language="godot"))
            right, wrong = ({one or other for one, other in re.findall(declared, text_)}
                            for text_ in (shown, shown.replace("p_hn", "p")))
            self.assertGreater(len(right), 10)
            self.assertEqual([{one for one in names if not one.endswith("_hn")} for names in (right, wrong)], [set(), {"p"}])

    def test_glsl_chooses_between_names_and_numbers(self) -> None:
        """Another choice is a branch in browsers, and a loop with thirty of them does not finish compiling."""
        plain = r"(?:-?\d[\w.]*|[a-z][\w.]*)"
        computed = re.compile(rf"\?(?! {plain} : {plain}[;,)])")
        for name in list(module("fixed").forms)[::1 if THOROUGH else 40]:
            for language in ("glsl", "godot"):
                shown = " ".join(code(text(name, arithmetic="fixed", language=language)).split())
                self.assertIsNone(computed.search(shown), name)
        self.assertRegex(code(text("hn_simplex3", arithmetic="fixed", language="hlsl")), computed)

    def test_they_are_short(self) -> None:
        for name, (length, lines) in SIZES.items():
            with self.subTest(name):
                self.assertLessEqual(len(text(name)), length)
                self.assertLessEqual(text(name).count("\n"), lines)
        names = list(module("fast").forms)[::1 if THOROUGH else 40]
        longest = max((line for name in names for line in text(name).splitlines()), key=len)
        self.assertLessEqual(len(longest), 120)

        with self.subTest("all of them, from calls"):
            self.assertLess(len(text(*SIZES, calls_first=True)), 1.01 * len(text(*SIZES)))


class Statements(unittest.TestCase):
    """Constructs that are rare in the library: variables that change together, and ways out of loops and functions."""

    CASES = (
        ("void hn_swap(inout float a, inout float b) { float t = a; a = b; b = t; }",
         "void hn_swap(inout float a, inout float b) {\n  float n = a;\n  a = b;\n  b = n;\n}\n"),
        ("void hn_set(inout vec2 p, out float old) { old = p.x; p.x = p.y + 1.0f; p.y = p.x * 2.0f; }",
         "void hn_set(inout vec2 p, out float old) {\n  float old2 = p.x, n = p.y + 1.0;\n"
         "  p = vec2(n, n * 2.0);\n  old = old2;\n}\n"),
        ("float hn_turn(float a, int n) { float b = 1.0f; for (int i = 0; i < n; i++) { float t = a; a = b; b = t; } "
         "return a - b; }",
         "float hn_turn(float a, int n) {\n  float b = 1.0;\n  for (int i = 0; i < n; i++) {\n    float n2 = a;\n"
         "    a = b;\n    b = n2;\n  }\n  return a - b;\n}\n"),
        ("float hn_leave(float x, int n) { float sum = 0.0f; for (int i = 0; i < n; i++) { float y = x * sum; "
         "if (y > 3.0f) { sum = sum + 1.0f; break; } if (y < 1.0f) { y = y - 1.0f; } sum = sum + y; } return sum; }",
         "float hn_leave(float x, int n) {\n  float sum = 0.0;\n  for (int i = 0; i < n; i++) {\n"
         "    float y = x * sum;\n    if (y > 3.0) {\n      sum += 1.0;\n      break;\n    }\n    float y2 = y;\n"
         "    if (y < 1.0) y2 = y - 1.0;\n    sum += y2;\n  }\n  return sum;\n}\n"),
        ("float hn_return(float a) { if (a < 0.0f) return -a; float b = a * 2.0f; return b * b; }",
         "float hn_return(float a) {\n  float result;\n  if (a < 0.0) {\n    result = -a;\n  } else {\n"
         "    float b = a * 2.0;\n    result = b * b;\n  }\n  return result;\n}\n"),
        ("float hn_chain(int m, float a) { if (m == 2) return a * 1.0f; if (m == 3) return a + 1.0f; return a; }",
         "float hn_chain(int m, float a) {\n  float result;\n  if (m == 2) {\n    result = a;\n  } else if (m == 3) {\n"
         "    result = a + 1.0;\n  } else {\n    result = a;\n  }\n  return result;\n}\n"),
        ("uint hn_same(uint a, bool b) { uint c = a & 0xFFFFFFFFu; return (c == 0u ? 0u : c) + (b ? 1u : 0u); }",
         "uint hn_same(uint a, bool b) { return a + (b ? 1u : 0u); }\n"),
        # A condition behind the body reads variables of the body, also where it was tested before.
        ("uint hn_walk(uint x, uint n) { uint v = 9u; do { x = x * 5u + 1u; v = v >= n ? x : v; } while (v >= n); "
         "return v; }",
         "uint hn_walk(uint x, uint n) {\n  uint v = 9u;\n  do {\n    uint x2 = x * 5u + 1u;\n    x = x2;\n"
         "    v = v >= n ? x2 : v;\n  } while (v >= n);\n  return v;\n}\n"),
        # Branches do not set a variable before they read it.
        ("float hn_read(float r, float b) { for (int i = 0; i < 3; i++) { float s; if (r < b) { s = b; } "
         "else { s = r + 1.0f; } r = s; } return r; }",
         "float hn_read(float r, float b) {\n  for (int i = 0; i < 3; i++) {\n    float s;\n    if (r < b) {\n"
         "      s = b;\n    } else {\n      s = r + 1.0;\n    }\n    r = s;\n  }\n  return r;\n}\n"))

    IN_WGSL = (
        ("void hn_set(inout vec2 p, out float old) { old = p.x; p.x = p.y + 1.0f; p.y = p.x * 2.0f; }",
         "fn hn_set2(p: ptr<function, vec2f>, old: ptr<function, f32>) {\n  let old2 = (*p).x;\n"
         "  let n = (*p).y + 1.0;\n  *p = vec2f(n, n * 2.0);\n  *old = old2;\n}\n"),
        ("void hn_more(inout vec2 p) { p = vec2((p.x + 1.0f) * 2.0f, p.y); p = (p - 1.0f) * (p * 3.0f); }",
         "fn hn_more2(p: ptr<function, vec2f>) {\n  let p2 = vec2f(((*p).x + 1.0) * 2.0, (*p).y);\n"
         "  *p = (p2 - 1.0) * (p2 * 3.0);\n}\n"),
        ("void hn_next(inout float a) { a = (a + 1.0f) * -a; }",
         "fn hn_next1(a: ptr<function, f32>) { *a = (*a + 1.0) * -(*a); }\n"),
        ("uvec2 hn_bits(uvec2 a, int n, uint k) { return ((a >> 3u) >> 1u) ^ uvec2(k) | uvec2(ivec2(n)); }",
         "fn hn_bits2(a: vec2u, n: i32, k: u32) -> vec2u {\n"
         "  return (((a >> vec2u(3u)) >> vec2u(1u)) ^ vec2u(k)) | vec2u(vec2i(n));\n}\n"),
        ("vec2 hn_mixed(ivec2 a, float final, bool b) "
         "{ return vec2(a) * (b || final < 1.0f && a.x > 2 ? 2.0f : final) - -final; }",
         "fn hn_mixed2(a: vec2i, final_: f32, b: bool) -> vec2f {\n"
         "  return vec2f(a) * select(final_, 2.0, b || (final_ < 1.0 && a.x > 2)) - -final_;\n}\n"),
        ("vec3 hn_made(ivec2 a, float x) { return vec3(x, a.x, 3) + vec3(a.y); }",
         "fn hn_made2(a: vec2i, x: f32) -> vec3f { return vec3f(x, f32(a.x), 3.0) + vec3f(f32(a.y)); }\n"),
        ("float hn_cast(int a, uvec2 b) { return intBitsToFloat(a) + uintBitsToFloat(b).x * float(a); }",
         "fn hn_cast1(a: i32, b: vec2u) -> f32 { return bitcast<f32>(a) + bitcast<vec2f>(b).x * f32(a); }\n"),
        ("int hn_do(int n) { int i = n; do i = i * 3; while (i < 100 && i > 0); return i; }",
         "fn hn_do1(n: i32) -> i32 {\n  var i = n;\n  loop {\n    i *= 3;\n"
         "    continuing { break if !(i < 100 && i > 0); }\n  }\n  return i;\n}\n"),
        ("float hn_turn(float a, int n) { for (int i = 0; i < n; i++) { a = a * a - 1.0f; } return a; }",
         "fn hn_turn1(a: f32, n: i32) -> f32 {\n  var a2 = a;\n  for (var i = 0; i < n; i++) {\n"
         "    a2 = a2 * a2 - 1.0;\n  }\n  return a2;\n}\n"),
        ("float hn_if(float a) { float b = 1.0f; if (a < 0.0f) b = a; return b * b; }",
         "fn hn_if1(a: f32) -> f32 {\n  var b = 1.0;\n  if (a < 0.0) { b = a; }\n  return b * b;\n}\n"),
        ("float hn_branches(float a) { float b; if (a < 0.0f) { b = a; } else { b = a + 1.0f; } return b * b; }",
         "fn hn_branches1(a: f32) -> f32 {\n  var b: f32;\n  if (a < 0.0) {\n    b = a;\n  } else {\n"
         "    b = a + 1.0;\n  }\n  return b * b;\n}\n"))

    def written(self, shown: str, language: str = "glsl") -> str:
        tree = Parser(list(tokens_of(shown, "the text", 1))).parse()
        return Program(Module(tree, {}), tree[-1:]).text(WITHOUT_HIGHP if language == "glsl" else LANGUAGES[language])

    def test_they_do_the_same(self) -> None:
        for language, cases in (("glsl", self.CASES), ("wgsl", self.IN_WGSL)):
            for shown, expected in cases:
                with self.subTest(shown, language=language):
                    self.assertEqual(self.written(shown, language), expected)

    def test_no_variable_has_the_name_of_the_users_hash(self) -> None:
        choice = command.Choice("wgsl", hash="custom", hash_function="h2")
        library = command.read_library(GLSL, choice)
        shown = Program(library, chosen(library, ["hn_perlin2"])).text(LANGUAGES["wgsl"])
        self.assertRegex(shown, r"\bh2\(")
        self.assertNotRegex(shown, r"\blet h2\b")

    def test_overloads_that_become_alike_have_names_of_their_own(self) -> None:
        shown = ("float hn_i_a(float x, int n) { float y = x * x + x * 3.0f - x / (x + 2.0f); "
                 "return y * y + float(n); } "
                 "float hn_i_a(float x) { float y = x * x - x * 5.0f + x / (x + 4.0f); return y * y - y; } "
                 "float hn_f(float a, float b, float c, float d, float e) { return hn_i_a(a, 3) + hn_i_a(b, 3) "
                 "+ hn_i_a(c, 3) + hn_i_a(d, 3) + hn_i_a(a) + hn_i_a(b) + hn_i_a(c) + hn_i_a(e); }")
        heads = re.findall(r"^float (\w+\(.*\)) \{", self.written(shown), re.MULTILINE)
        self.assertEqual(sorted(heads)[1:], ["hn_i_a(float x)", "hn_i_a_2(float x)"])

    def test_a_return_in_a_loop_is_refused_with_its_place(self) -> None:
        with self.assertRaisesRegex(Unknown, "^the text:1: a return in a loop"):
            self.written("float hn_f(int n) { for (int i = 0; i < n; i++) { return 1.0f; } return 2.0f; }")


class Nodes(unittest.TestCase):
    """The nodes of three.js; npm.browser has their values."""
    pick = staticmethod(command.picker())

    def test_a_module_has_a_node_of_each_function_and_both_texts(self) -> None:
        shown = self.pick(["hn_perlin2", "hn_tile2"], command.Choice("tsl"))
        self.assertEqual(re.findall(r"^export const (\w+)", shown, re.MULTILINE), ["hn_perlin2", "hn_tile2"])
        self.assertEqual(re.findall(r"^import .* from (.*);$", shown, re.MULTILINE), ['"three/tsl"'])
        for language in ("glsl", "wgsl"):
            with self.subTest(language):
                self.assertIn(f"({tsl.quoted(text('hn_perlin2', 'hn_tile2', language=language))});\n", shown)

    def test_what_returns_or_sets_more_has_none(self) -> None:
        for name in ("hn_simplex_d4", "hn_cellular2_nearest"):
            with self.subTest(name), self.assertRaisesRegex(Unknown, "three.js has no nodes for|there is no function"):
                self.pick([name], command.Choice("tsl"))

    def test_a_text_is_quoted(self) -> None:
        self.assertEqual(tsl.quoted("a `b` ${c} \\ d"), "`a \\`b\\` \\${c} \\\\ d`")


class Comments(unittest.TestCase):
    """They stand alone, and may stand in a template of JavaScript, which a backtick ends. In every language: by default
    of some functions, in each language of others."""
    REFERENCE = re.compile(r"\b(?:above|below)\b(?!,? (?:-?\d|the first|a whole|a thresh))"
                           r"|docs/|\.md\b|\.glsl\b|in place of (?:p|the cell)\b|`")
    LANGUAGES = (*LANGUAGES, *command.SYNTAXES, command.TSL)
    pick = staticmethod(command.picker())

    @staticmethod
    def comment(shown: str) -> str:
        """The text of all comments, or of the last one in Python, in one line."""
        if '"""' in shown:
            return " ".join(shown.rsplit('"""', 2)[1].split())
        lines = [found[1] for line in shown.splitlines() if (found := re.match(r"\s*(?://+|/?\*+/?|##)(.*)", line))]
        return " ".join(" ".join(lines).split())

    def test_nothing_refers_to_what_is_not_there(self) -> None:
        known = list(module("fast").forms)
        for turn, language in enumerate(self.LANGUAGES):
            for name in known if THOROUGH else [*known[turn * 9::432], "hn_cellular2_jitter"]:
                if language == command.TSL and not is_node(module("fast").forms[name]):
                    continue
                with self.subTest(name, language=language):
                    self.assertNotRegex(self.comment(self.pick([name], command.Choice(language, "fixed"))),
                                        self.REFERENCE)

    def test_a_reference_would_be_noticed(self) -> None:
        for line in ("returns as above, in the metric", "error docs/measured/accuracy.md", "as of the sums in fbm2d.glsl",
                     "the functions below use those", "returns `value`"):
            self.assertRegex(line, self.REFERENCE)

    def test_all_is_explained(self) -> None:
        """Every function is explained: it is in the library's comments, so each language has it."""
        for name, function in module("fast").forms.items():
            with self.subTest(name):
                facts = comments.facts(function, GLSL, True)
                self.assertEqual([one for one, text in facts.parameters.items() if not text], [])
                self.assertEqual(len(facts.parameters), len(function.parameters))
                self.assertTrue(facts.what and (facts.returns or function.type == "void"))
                self.assertIn(function.name, LANGUAGES["glsl"].example(function))
                shown = " ".join([facts.what, *facts.parameters.values(), facts.returns, facts.error])
                self.assertNotRegex(shown, self.REFERENCE)
                for setting in ("octaves", "lacunarity", "gain", "strength", "amplitude", "depth"):
                    self.assertIn("usually", facts.parameters.get(setting, "usually"))
                if "p" in facts.parameters:
                    self.assertIn("cells", facts.parameters["p"])

    def test_the_whole_comment_of_the_base_form_is_there(self) -> None:
        shown = self.comment(self.pick(["hn_cellular2_jitter"], command.Choice()))
        for part in ("the distances to the nearest and to the second nearest", "This form also takes the jitter and "
                     "the metric.", "in [0, 1.1181]", "on average 0.43 and 0.70", "at most 2.08e-6"):
            self.assertIn(part, shown)

    OF_ARITHMETICS = re.compile(r"HN_(?:FAST|FIXED|PRECISE|GRADIENT)\w*")

    def test_they_have_one_arithmetic_and_one_gradient(self) -> None:
        """The number that all return, hn_self_check, is of none."""
        known = {name: function for name, function in module("fast").forms.items() if name != "hn_self_check"}
        for arithmetic, gradient in itertools.product(command.ARITHMETICS, ("octahedral", "sine")):
            knobs = command.Choice(arithmetic=arithmetic, gradient=gradient).knobs
            for name, function in known.items():
                facts = comments.facts(function, GLSL, True, knobs)
                for shown in (facts.what, *facts.parameters.values(), facts.returns, facts.error):
                    self.assertNotRegex(shown, self.OF_ARITHMETICS, f"{name}, {arithmetic}, {gradient}")
        of_all = [comments.facts(function, GLSL, True) for function in known.values()]
        self.assertGreater(sum(bool(self.OF_ARITHMETICS.search(f"{one.returns} {one.error}")) for one in of_all), 100)

    def test_errors_and_limits_are_those_of_the_arithmetic(self) -> None:
        def of(name: str, arithmetic: str, gradient: str = "octahedral") -> comments.Facts:
            return comments.facts(module("fast").forms[name], GLSL, True,
                                  command.Choice(arithmetic=arithmetic, gradient=gradient).knobs)

        limits = "It takes a gain above 1 as 1, and a lacunarity outside [0, 255] as 0 or 255."
        for arithmetic, gain in (("fast", "; not negative, and the sum of its powers below 2^126"), ("fixed", ""),
                                 ("precise", "; not negative, and the sum of its powers below 2^100")):
            facts = of("hn_fbm2", arithmetic)
            self.assertEqual(facts.parameters["gain"], f"ratio of amplitudes (persistence), usually 0.5{gain}")
            self.assertEqual(facts.what.endswith(limits), arithmetic == "fixed")
        self.assertEqual(facts.error, "at a position it grows with |p| * lacunarity^octaves, since a float rounds the "
                         "positions; at a place it does not")
        self.assertEqual(of("hn_fbm2", "fixed").error, "it does not grow with the coordinates")
        for name, arithmetic, gradient, error in (
                ("hn_perlin2", "fixed", "octahedral", "at most 4.30e-5 against the exact value"),
                ("hn_perlin2", "fixed", "sine", "at most 7.99e-5 against the exact value"),
                ("hn_perlin2", "fast", "octahedral", "at most 2.67e-6 against the exact value, in any rounding mode. "
                 "From a cell at most 2.44e-6"),
                ("hn_perlin2", "fast", "sine", "at most 2.42e-6 against the exact value, in any rounding mode. "
                 "From a cell at most 2.42e-6"),
                ("hn_cellular_d2", "fixed", "octahedral", "hn_cellular's, and of a derivative at most 8.30e-6 "
                 "divided by the distance"),
                ("hn_clouds2", "fixed", "octahedral", "3 times hn_fbm's, plus 2.6e-5"),
                ("hn_gradient_lattice2", "fixed", "sine", "less than 3.7e-5")):
            self.assertEqual(of(name, arithmetic, gradient).error, error, name)
        self.assertTrue(of("hn_perlin2", "fixed", "sine").returns.startswith(
            "[-1, 1], which is not scaled, mean 0, 0 at lattice points, "))

    def test_no_constant_is_named_that_a_text_lacks(self) -> None:
        """In languages of the CPU, but for hn_distribution's argument: its own text has that."""
        of_library = {name: module("fast").constant(name).at.text for name in module("fast").constants if is_passed(name)}
        for (language, syntax), (name, count) in itertools.product(command.SYNTAXES.items(), (
                ("hn_uniform", 0), ("hn_distribution", 18), ("hn_distribution_fbm", 0), ("hn_cellular2_jitter", 5))):
            with self.subTest(name, language=language):
                shown = self.pick([name], command.Choice(language))
                called = {syntax().constant_name(constant): number for constant, number in of_library.items()}
                declared = {one for one, number in called.items() if f"{syntax.passed.format(one, number)}\n" in shown}
                named = {one for one in called
                         if re.search(rf"(?<!istribution\()\b{one}\b", self.comment(shown))}
                self.assertEqual(len(declared), count)
                self.assertLessEqual(named, declared)
                self.assertEqual(bool(named), bool(declared))
        shown = self.comment(self.pick(["hn_uniform"], command.Choice("c")))
        self.assertIn("of the noise: hn_distribution(HN_DISTRIBUTION_PERLIN2) and so on", shown)
        self.assertIn("hn_uniform(0.25f, distribution_x, distribution_y, distribution_z, distribution_w)", shown)

    def test_every_parameter_is_named_in_every_language(self) -> None:
        for language in command.SYNTAXES:
            shown = self.comment(self.pick(["hn_fbm2"], command.Choice(language, "fixed")))
            for name in ("x", "y", "octaves", "lacunarity", "gain", "seed"):
                with self.subTest(name, language=language):
                    self.assertRegex(shown, rf'(?:@param (?:{{\w+}} )?|name="|- |, )(?:noise_)?{name}\b')
            self.assertIn("usually 4 to 8; more than 32 count as 32", re.sub(r"\W*\n\W*", " ", shown))

    def compiled(self, call: str, name: str, shown: str) -> subprocess.CompletedProcess[str]:
        function = module("fast").forms[name]
        variables = "".join(f"  highp {one.type} {one.at.text};\n".replace("highp hn_", "hn_")
                            for one in function.parameters)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "shader.frag"
            file.write_text(f"#version 300 es\nprecision mediump float;\nin vec2 uv;\n{shown}\nvoid main() {{\n"
                            f"{variables}  {call};\n}}\n", encoding="ascii")
            return subprocess.run(["glslangValidator", file], capture_output=True, text=True, check=False)

    def test_the_call_of_the_comment_compiles(self) -> None:
        known = module("fast").forms
        for name in list(known)[::1 if THOROUGH else 30]:
            with self.subTest(name):
                shown = self.pick([name], command.Choice())
                call = re.search(r" example (.*?)(?: (?:returns|error) .*)? Of hashnoise", self.comment(shown))[1]
                done = self.compiled(call, name, shown)
                self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotEqual(self.compiled("hn_fbm(uv * 8.0, 6)", "hn_fbm2", self.pick(["hn_fbm2"], command.Choice()))
                            .returncode, 0)

    def test_calls_in_other_languages(self) -> None:
        expected = {"hlsl": "hn_cellular(uv * 8.0, 1.0, HN_METRIC_EUCLIDEAN, 7u, nearest, offset)",
                    "wgsl": "hn_cellular2_nearest(uv * 8.0, 1.0, HN_METRIC_EUCLIDEAN, 7u, &nearest, &offset)",
                    "rust": "cellular2_nearest(8.0 * x, 8.0 * y, 1.0, METRIC_EUCLIDEAN, 7)",
                    "csharp": "HashNoise.Cellular2Nearest(8.0f * x, 8.0f * y, 1.0f, HashNoise.MetricEuclidean, 7u)",
                    "c": "hn_cellular2_nearest(8.0f * x, 8.0f * y, 1.0f, HN_METRIC_EUCLIDEAN, 7u, &nearest, &offset)",
                    "java": "HashNoise.cellular2Nearest(8.0f * x, 8.0f * y, 1.0f, HashNoise.METRIC_EUCLIDEAN, 7)",
                    "go": "hashnoise.Cellular2Nearest(8.0 * x, 8.0 * y, 1.0, hashnoise.MetricEuclidean, 7)"}
        for language, call in here(expected.items()):
            with self.subTest(language):
                shown = self.comment(self.pick(["hn_cellular2_nearest"], command.Choice(language, "fixed")))
                self.assertIn(call, shown)

    @unittest.skipIf("rust" in DELETED, "Rust was deleted")
    def test_a_place_in_rust_names_who_makes_a_valid_one(self) -> None:
        shown = self.pick(["hn_perlin2_place"], command.Choice("rust"))
        self.assertRegex(shown, r"/// Only functions that return one make a valid one:.*\n#\[derive.*\n"
                                r"pub struct Place2 \{\n    pub cell_x: i32,")

    def test_two_texts_are_an_error_in_c(self) -> None:
        """The guard of one must not leave out another one, whose bits are others. The same text may come twice."""
        one = self.pick(["hn_fbm2"], command.Choice("c"))
        others = [self.pick(names, choice) for names, choice in (
            (["hn_fbm2"], command.Choice("c", "fixed")), (["hn_fbm2"], command.Choice("c", "precise")),
            (["hn_fbm2"], command.Choice("c", hash="pcg")), (["hn_fbm2"], command.Choice("c", gradient="sine")),
            (["hn_fbm2"], command.Choice("c", noise="hn_simplex2")), (["hn_fbm2", "hn_value2"], command.Choice("c")),
            (["hn_random2"], command.Choice("c")))]
        guards = {re.search(r"#if !defined\((HN_\w+_[0-9A-F]{8}_H)\) .*\n#define \1\n", shown)[1]
                  for shown in (one, *others)}
        self.assertEqual(len(guards), 1 + len(others))
        main = ('#include "first.h"\n#include "second.h"\n'
                    "float made(void) { return hn_fbm2(1.5f, 2.5f, 6, 2.0f, 0.5f, 7u); }\n")
        for second, status in ((one, 0), *((other, 1) for other in others)):
            with tempfile.TemporaryDirectory() as folder:
                for name, shown in (("first.h", one), ("second.h", second), ("program.c", main)):
                    (Path(folder) / name).write_text(shown, encoding="ascii")
                done = subprocess.run(["gcc", "-std=c99", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "program.c"],
                                      cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(bool(done.returncode), bool(status), done.stderr)
            self.assertEqual("name all functions in one call" in done.stderr, bool(status))

    def test_two_files_of_a_shader_may_include_a_text(self) -> None:
        """Here only a C++ compiler reads Metal."""
        shown = self.pick(["hn_cellular2_jitter"], command.Choice("metal"))
        self.assertRegex(shown, r"\n#ifndef (HN_CELLULAR2_JITTER_[0-9A-F]{8}_H)\n#define \1\n#include <metal_stdlib>\n")
        main = "float4 main() : SV_Target { return hn_fbm(float2(1, 2), 6, 2.0, 0.5, 7u); }\n"
        shown = self.pick(["hn_fbm2"], command.Choice("hlsl"))
        for text_, status in ((shown, 0), (re.sub("#(?:ifndef|define|endif).*", "", shown), 1)):
            with self.subTest(status), tempfile.TemporaryDirectory() as folder:
                for name, written in (("picked.hlsl", text_), ("one.hlsl", '#include "picked.hlsl"\n'),
                                      ("main.hlsl", f'#include "one.hlsl"\n#include "picked.hlsl"\n{main}')):
                    (Path(folder) / name).write_text(written, encoding="ascii")
                done = subprocess.run(["glslangValidator", "-D", "-V", "-I.", "-S", "frag", "-e", "main", "-o", "out",
                                       "main.hlsl"], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(bool(done.returncode), bool(status), done.stdout)

    def test_the_seed_may_be_left_out_where_functions_have_overloads(self) -> None:
        for language in LANGUAGES:
            shown = code(self.pick(["hn_fbm2", "hn_ball"], command.Choice(language)))
            with self.subTest(language):
                found = re.findall(r"\bhn_fbm\((?:(?!seed)[^)])*\) \{ return hn_fbm\(.*, 0u\); \}", shown)
                self.assertEqual(len(found), int(language != "wgsl"))
        done = self.compiled("hn_fbm(uv * 8.0, 6, 2.0, 0.5)", "hn_fbm2", self.pick(["hn_fbm2"], command.Choice()))
        self.assertEqual(done.returncode, 0, done.stdout)


class Command(unittest.TestCase):
    def call(self, *arguments: str) -> tuple[int, str]:
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown), contextlib.redirect_stderr(shown):
            try:
                status = command.main(arguments)
            except SystemExit as stop:
                status = int(stop.code)
        return status, shown.getvalue()

    def test_a_noise_for_sums_leaves_the_others_and_may_stand_anywhere(self) -> None:
        status, shown = self.call("hn_fbm2", "--noise", "hn_simplex2", "hn_cellular2", "--language", "javascript")
        self.assertEqual(status, 0)
        self.assertRegex(shown, r"(?s)The noise is\s+(?:\* )?simplex2\..*export function fbm2\(.*export function cellular2\(")
        self.assertEqual(shown.count("The noise is simplex2"), 1)

    def test_it_says_what_it_wrote_and_how(self) -> None:
        status, shown = self.call("hn_value2", "--arithmetic", "fixed", "--language", "glsl-es")
        self.assertEqual((status, shown), self.call("hn_value2", "--arithmetic", "fixed"))
        of_c = {self.call("hn_value2", "--language", language) for language in ("c", "cuda", "hip", "opencl")}
        self.assertEqual(len(of_c), 1)
        self.assertEqual(status, 0)
        self.assertRegex(shown, r"^// hn_value\(vec2 p, uint seed\)\n// Value noise")
        self.assertRegex(shown, r"\n//   returns +\[-1, 1\]")
        self.assertIn("by: tools/pick hn_value2 --arithmetic fixed\n", shown)
        again = re.search("by: tools/pick (.*)\n", shown)[1]
        self.assertEqual(self.call(*again.split())[1], shown)
        without_seed = "highp float hn_value(highp vec2 p) { return hn_value(p, 0u); }\n"
        self.assertEqual(code(shown), text("hn_value2", arithmetic="fixed") + without_seed)

    def test_words_of_options(self) -> None:
        """Options take the words of the library, too, in any case. The command in the text has the usual ones."""
        one, *others = (self.call("hn_perlin2", *words.split()) for words in (
            "--arithmetic fixed --hash pcg --gradient sine", "--arithmetic HN_FIXED --hash PCG --gradient SINE",
            "--arithmetic Fixed --hash HN_HASH_PCG --gradient hn_gradient_sine"))
        self.assertIn("by: tools/pick hn_perlin2 --arithmetic fixed --hash pcg --gradient sine\n", one[1])
        self.assertEqual(others, [one, one])

    def test_the_page_says_how_many_functions_there_are(self) -> None:
        """tools/make pages makes its examples."""
        page = (ROOT / "docs" / "guide" / "languages.md").read_text()
        self.assertIn(f"# {len(module('fast').forms)} functions\n", page)

    def test_the_pages_of_snippets_are_what_it_writes(self) -> None:
        folder = ROOT / "docs" / "reference" / "snippets"
        self.assertEqual((folder / "README.md").read_text(), pages.index())
        self.assertEqual({path.stem for path in folder.glob("hn_*")}, set(pages.FUNCTIONS))
        picked = pages.for_pages()
        for name in pages.FUNCTIONS if THOROUGH else ("hn_random2",):
            self.assertEqual((folder / f"{name}.md").read_text(), pages.page(name, picked),
                             f"run tools/make snippets for {name}")

    def test_pages_are_written_into_a_folder(self) -> None:
        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.object(pages, "FUNCTIONS", {"hn_random2": "a number"}), \
                mock.patch.object(pages, "OF_TREE", pages.OF_TREE[:1]):
            new = Path(folder, "new")
            self.assertEqual(pages.main(["--out", str(new)]), 0)
            self.assertIn("[hn_random2](hn_random2.md) | a number", (new / "README.md").read_text())
            self.assertEqual(pages.main(["--out", str(new), "--check"]), 0)
            for name, text in (("hn_random2.md", "another text"), ("hn_old.md", "a page of no function")):
                (new / name).write_text(text)
                with contextlib.redirect_stderr(io.StringIO()) as shown:
                    self.assertEqual(pages.main(["--out", str(new), "--check"]), 1)
                self.assertEqual(shown.getvalue(), f"{name}: it is not what tools/make snippets writes\n")
                self.assertEqual(pages.main(["--out", str(new)]), 0)
            self.assertEqual({path.name for path in new.iterdir()}, {"README.md", "hn_random2.md"})
            self.assertIn(self.call("hn_random2")[1], Path(folder, "new", "hn_random2.md").read_text())

    def test_the_text_is_the_same_in_another_process(self) -> None:
        """Python's sets have another order there, and other functions may have been evaluated before."""
        names = ("hn_fbm2", "hn_cellular2")
        shown = subprocess.run([TOOLS / "pick", *names, "--arithmetic", "fixed"], capture_output=True, text=True,
                               check=True).stdout
        self.assertTrue(code(shown).startswith(text(*names, arithmetic="fixed")))

    @unittest.skipIf("rust" in DELETED, "Rust was deleted")
    def test_the_text_is_the_same_behind_others(self) -> None:
        """Where nothing is forgotten between them, statements that another function has, too, stand elsewhere."""
        def behind(*others: str) -> str:
            pick = command.picker()
            return [pick([name], command.Choice("rust", "fixed")) for name in (*others, "hn_cell_border3_jitter")][-1]

        self.assertEqual(behind("hn_cellular_phase3_place_nearest"), behind())
        with mock.patch.object(values, "_known", return_value=None):  # else they have no statement in common
            alone = behind()
            values.begin_anew()
            with mock.patch("translate.pick.program.begin_anew"):
                self.assertNotEqual(behind("hn_cellular_phase3_place_nearest"), alone)

    def test_a_file(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "new" / "noise.glsl"
            self.assertEqual(self.call("hn_value2", "--out", str(path)), (0, f"{path}\n"))
            self.assertTrue(code(path.read_text()).startswith(text("hn_value2")))

    def test_output_that_cannot_be_written_is_an_error(self) -> None:
        for redirection, reason in ((">/dev/full", "No space left on device"), (">&-", "Bad file descriptor")):
            for command_ in (f"pick hn_random2 {redirection}", f"pick whole random2d.glsl {redirection}"):
                with self.subTest(command_):
                    done = subprocess.run(["bash", "-c", f"{TOOLS}/{command_}"], capture_output=True, text=True,
                                          check=False)
                    name = command_.partition(" ")[0] + " whole" * ("whole" in command_)
                    self.assertEqual((done.returncode, done.stderr),
                                     (2, f"tools/{name}: cannot write the standard output: {reason}\n"))

    def test_a_sum_over_another_noise_is_that_of_a_library_which_sums_it(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            library = Path(folder) / "glsl"
            shutil.copytree(GLSL, library)
            changed = 0
            for file in library.glob("fbm*.glsl"):
                lines = [re.sub(r"hn_perlin(?=(_d)?\(o\.place, o\.seed\))", "hn_simplex", line) for line in
                         file.read_text().splitlines(keepends=True) if not file.name.startswith("fbm1d")]
                changed += "hn_simplex(o.place" in "".join(lines)
                file.write_text("".join(lines) if changed else file.read_text())
            self.assertGreater(changed, 2)
            cases = (("hn_fbm2", "hn_simplex2", "glsl"), ("hn_fbm_d2", "hn_simplex_d2", "c"))
            for sum_, noise, language in cases if THOROUGH else cases[:1]:
                choice = command.Choice(language, "fixed")
                with self.subTest(sum_):
                    here = command.picked([sum_], replace(choice, noise=noise))
                    self.assertRegex(here, rf"tools/pick {sum_} (--language c )?--arithmetic fixed --noise {noise}\n")
                    self.assertRegex(here, rf"The[\s/]+noise[\s/]+is[\s/]+{noise[:-1]}\.[\s/]+Ranges")
                    self.assertEqual(code(here), code(command.picked([sum_], choice, library)))
                    self.assertNotEqual(code(here), code(command.picked([sum_], choice)))

    def test_the_list_has_what_can_be_asked_for(self) -> None:
        status, shown = self.call("--list")
        self.assertEqual(status, 0)
        known = module("fast").forms
        lines = shown.splitlines()
        self.assertCountEqual([line.split()[0] for line in lines if line.startswith("  ")], known)
        groups = [line.partition(":")[0] for line in lines if line and not line.startswith("  ")]
        self.assertCountEqual(groups, {function.name for function in known.values()})
        self.assertLess(groups.index("hn_perlin"), groups.index("hn_add"))
        self.assertIn("  hn_cellular2_nearest             vec2 hn_cellular(vec2 p, float jitter, int metric, uint "
                      "seed, out ivec2 nearest, out vec2 offset)", lines)

    def test_a_second_text_has_names_of_its_own(self) -> None:
        for language, name, begins, example in here((
                ("csharp", "Terrain", "public static class Terrain {", "<code>Terrain.Lattice2(3, -5, 7u)</code>"),
                ("java", "Terrain", "public final class Terrain {", "Example: Terrain.lattice2(3, -5, 7)"),
                ("go", "terrain", "package terrain\n", "Example: terrain.Lattice2(3, -5, 7)"))):
            with self.subTest(language):
                shown = self.call("hn_lattice2", "--language", language, "--name", name)[1]
                self.assertIn(f"by: tools/pick hn_lattice2 --language {language} --arithmetic fast --name {name}\n",
                              shown)
                self.assertIn(begins, shown)
                self.assertIn(example, shown)
                self.assertNotIn("hashnoise", shown.partition("by:")[2].lower().replace("the hashnoise authors", ""))

    def test_a_shader_of_osl_has_a_name_of_its_own(self) -> None:
        usual, named = (self.call("hn_fbm2", "--language", "osl", "--noise", "hn_value2", *more)[1].partition("\n")
                        for more in ((), ("--name", "rough_land")))
        self.assertIn("--name rough_land", named[0])
        self.assertIn("\nshader hashnoise_fbm2(", usual[2])
        self.assertEqual(named[2], usual[2].replace("shader hashnoise_fbm2(", "shader rough_land("))

    def test_a_text_of_osl_without_a_shader_is_noted(self) -> None:
        for names, first in ((("hn_fbm2_tile",), "hn_tile2"), (("hn_perlin2_place",), "hn_perlin2_place"),
                             (("hn_perlin_d4", "hn_fbm2"), "hn_perlin_d4"), (("hn_fbm2",), "")):
            with self.subTest(names), tempfile.TemporaryDirectory() as folder:
                status, shown = self.call(*names, "--language", "osl", "--out", f"{folder}/noise.osl")
                self.assertEqual(status, 0)
                self.assertEqual("no shader" in shown, bool(first))
                self.assertIn(first and f"the first one, {first}, takes or returns", shown)

    def test_two_texts_of_hlsl_with_names_of_their_own_are_one_shader(self) -> None:
        of_hlsl = ("--language", "hlsl", "--hash", "custom", "--hash-function", "hn_mine")
        usual, other = (self.call("hn_cellular2_jitter", *of_hlsl, *more)[1] for more in
                        ((), ("--name", "my", "--arithmetic", "fixed")))
        self.assertIn("// my_cellular(vec2 p, float jitter, int metric, uint seed)\n", other)
        self.assertIn("by: tools/pick hn_cellular2_jitter --language hlsl", other)
        main = ("float4 main(float2 uv : TEXCOORD0) : SV_Target {\n"
                "  return float4(hn_cellular(uv, 1.0, HN_METRIC_MANHATTAN, 7u), my_cellular(uv, 1.0, 1, 7u));\n}\n")
        for second, status in ((other, 0), (other.replace("my_", "hn_"), 1)):
            with self.subTest(status), tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "shader.hlsl"
                file.write_text(f"uint hn_mine(uint k) {{ return k; }}\n{usual}{second}{main}", encoding="ascii")
                done = subprocess.run(["glslangValidator", "-D", "-V", "-S", "frag", "-e", "main", "-o", "/dev/null",
                                       file], capture_output=True, text=True, check=False)
                self.assertEqual(bool(done.returncode), bool(status), done.stdout)

    def test_a_tile_is_found_from_the_name_of_a_function(self) -> None:
        both = self.call("hn_tile2", "hn_fbm2_place")
        self.assertEqual(self.call("hn_fbm2_tile"), both)
        self.assertEqual(self.call("hn_fbm(hn_tile(vec2))"), both)
        self.assertEqual(self.call("hn_fbm(vec2)"), self.call("hn_fbm2"))
        self.assertEqual(self.call("hn_fbm(hn_place(vec3))"), self.call("hn_place_in_cell3", "hn_fbm3_place"))
        self.assertIn("; in a tile that is hn_perlin2_tile\n", self.call("hn_perlin")[1])
        self.assertIn("there is no function hn_ball2_place", self.call("hn_ball2_tile")[1])

    def test_a_name_that_the_text_does_not_have_is_taken(self) -> None:
        for language, name in here((("java", "Float2"), ("csharp", "Perlin2"), ("go", "noise"))):
            self.assertEqual(self.call("hn_value2", "--language", language, "--name", name)[0], 0, name)
        if "java" in DELETED:
            return
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "Terrain.java"
            status, _ = self.call("hn_value2", "--language", "java", "--name", "Terrain", "--out", str(path))
            self.assertEqual(status, 0)

    def test_bad_usage(self) -> None:
        for arguments, message in here((((), "name functions"), (("--list", "hn_value2"), "name functions"),
                                   (("hn_perln2",), "there is no function hn_perln2 (did you mean hn_perlin2"),
                                   (("hn_perln",), "no function hn_perln (did you mean hn_perlin1, hn_perlin2, hn_per"),
                                   (("perlin3",), "there is no function perlin3 (did you mean hn_perlin3"),
                                   (("hn_gulies",), "no function hn_gulies (did you mean hn_gullies2?)"),
                                   (("zzzzzzzz",), "there is no function zzzzzzzz; --list prints them"),
                                   (("hn_foo",), "there is no function hn_foo; --list prints them"),
                                   (("hn_fbm2,hn_fbm3",), "separate functions by blanks"),
                                   (("hn_fbm2,", "hn_fbm3"), "separate functions by blanks"),
                                   (("hn_perlin",), "there are hn_perlin1, hn_perlin1_place"),
                                   (("hn_value2", "--hash", "custom"), "--hash custom --hash-function my_hash"),
                                   (("hn_value2", "--hash", "HN_PCG"), "invalid choice: 'hn_pcg'"),
                                   (("hn_value2", "--hash", "custom", "--hash-function", "a-b"), "not 'a-b'"),
                                   (("hn_value2", "--hash", "custom", "--hash-function", "mine", "--language", "c"),
                                    "is of shading languages: glsl"),
                                   (("hn_value2", "--hash", "custom", "--hash-function", "seed"), "call your function"),
                                   (("hn_value2", "--import-path", "noise"), "is of --language wgsl"),
                                   (("hn_value2", "--language", "wgsl", "--import-path", "a b"), "such as game::noise"),
                                   (("hn_value2", "--language", "wgls"), "invalid choice: 'wgls'"),
                                   (("hn_value2", "--arithmetic", "precise", "--language", "metal"), "no `precise`"),
                                   (("hn_value2", "--arithmetic", "precise", "--language", "slang"), "out of SPIR-V"),
                                   (("hn_value2", "--arithmetic", "precise", "--language", "godot"), "no `precise`"),
                                   (("hn_value2", "--arithmetic", "precise", "--language", "wgsl"), "Take HN_FIXED"),
                                   (("hn_value2", "--arithmetic", "HN_PRECISE", "--language", "wgsl"),
                                    "--arithmetic fixed"),
                                   (("hn_value2", "--noise", "hn_simplex2"), "hn_value(vec2, uint) is no sum"),
                                   (("hn_fbm2", "--noise", "hn_simplex3"),
                                    "hn_fbm2 sums hn_perlin(hn_place2, uint), for which --noise hn_simplex2 stands"),
                                   (("hn_fbm2", "--noise", "hn_cellular_d2"), "--noise hn_simplex2 stands"),
                                   (("hn_fbm2", "hn_fbm1", "--noise", "hn_simplex2"), "--noise hn_value1 stands"),
                                   (("hn_perlin2", "--noise", "hn_simplex2", "--language", "verilog"),
                                    "tools/pick: hn_perlin(vec2, uint) is no sum"),
                                   (("hn_fbm_d2", "--noise", "hn_simplex2"), "--noise hn_simplex_d2 stands"),
                                   (("hn_fbm3_place", "--noise", "hn_value_d2"), "--noise hn_value3 stands"),
                                   (("hn_fbm2", "hn_warp2", "--noise", "hn_value2"), "hn_warp("),
                                   (("hn_fbm2", "--noise", "hn_simplx2"), "there is no function hn_simplx2"),
                                   (("hn_fbm2", "--noise", "hn_curl2"), "returns vec2, and a sum"),
                                   (("hn_fbm2", "--noise", "hn_unorm"), "there is no hn_unorm(hn_place1, uint)"),
                                   (("hn_value2", "--name", "Mine"), f"is of --language {', '.join(command.NAMED)}."),
                                   (("hn_value2", "--language", "rust", "--name", "mine"), "a module of any name"),
                                   (("hn_value2", "--language", "java", "--name", "a-b"), "such as Terrain, not 'a-b'"),
                                   (("hn_value2", "--language", "hlsl", "--name", "my_"), "single underscores"),
                                   (("hn_value2", "--language", "java", "--out", "/nowhere/Terrain.java"),
                                    "Terrain.java has to have a public class of its name: add --name Terrain"),
                                   (("hn_value2", "--list"), "or ask for --list"),
                                   (("hn_value2", "--glsl", "/nowhere"), "/nowhere"))):
            with self.subTest(arguments):
                status, shown = self.call(*arguments)
                self.assertEqual(status, 2)
                self.assertIn(message, shown)
        with contextlib.redirect_stderr(io.StringIO()) as shown, self.assertRaises(SystemExit) as stop, \
                mock.patch.object(pages, "FUNCTIONS", {}):
            pages.main(["--out", "/dev/null/out"])
        self.assertEqual(stop.exception.code, 2)
        self.assertIn("/dev/null/out", shown.getvalue())

    def test_a_name_that_the_language_or_the_text_has_is_refused(self) -> None:
        for function, language, name in here((
                ("hn_value2", "osl", "noise"), ("hn_value2", "go", "func"), ("hn_value2", "go", "math"),
                ("hn_value2", "csharp", "Value2"), ("hn_value2", "csharp", "System"), ("hn_value2", "java", "Math"),
                ("hn_circle", "java", "Float2"), ("hn_value2_place", "java", "Place2"))):
            with self.subTest(language=language, name=name):
                status, shown = self.call(function, "--language", language, "--name", name)
                self.assertEqual(status, 2)
                self.assertIn(f"--name {name} is a word of the language, or a name in the text", shown)

    def test_a_warp_by_another_noise_is_a_loop_over_functions_that_can_be_picked(self) -> None:
        for warp in ("hn_warp2", "hn_warp_progressive2", "hn_warp3", "hn_warp_progressive3_place"):
            status, shown = self.call(warp, "--noise", f"hn_simplex{warp.removesuffix('_place')[-1]}")
            self.assertEqual(status, 2)
            picked = re.search(r"#warps\) over these functions: tools/pick (.*)", shown)[1].split()
            self.assertEqual("progressive" in warp, "progressive" in picked[2])
            self.assertEqual(self.call(*picked)[0], 0, picked)

    def test_what_the_evaluation_does_not_know_is_told_with_its_place(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            library = Path(folder) / "glsl"
            shutil.copytree(GLSL, library)
            file = library / "value2d.glsl"
            wanted = "HN_FN hn_float hn_value(hn_vec2 p, hn_uint seed) {"
            self.assertIn(wanted, file.read_text())
            file.write_text(file.read_text().replace(wanted, f"{wanted} hn_absent(p);"))
            status, shown = self.call("hn_value2", "--glsl", str(library))
        self.assertEqual(status, 2)
        self.assertRegex(shown, r"value2d\.glsl:\d+: there is no function hn_absent\(vec2\)")
