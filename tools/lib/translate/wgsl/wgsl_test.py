"""Tests of the translation to WGSL. wgpu_test.py and hn-conform check whether compilers take it, and its values."""

from __future__ import annotations

import functools
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.thorough import THOROUGH, some
from base.tree import GLSL, TOOLS, glsl_files
from catalog.tables.glsl import declarations
from translate.names import NOT_OVERLOADED
from translate.parsing.tokens import Unknown
from translate.settings import ARITHMETICS, GRADIENTS, HASHES, Settings
from translate.wgsl.evaluation import evaluations, shader_of_bug
from translate.wgsl.module import Module

FILES = list(glsl_files())
WHOLE = '#include "hashnoise.glsl"\n'


def files_with(arithmetic: str) -> list[str]:
    """Each of some files has one of the arithmetics, and in a thorough run each file all; the whole library always has
    all. A step of 9 takes files of each number of dimensions, 1 to 4."""
    return FILES if THOROUGH else FILES[3 * ARITHMETICS.index(arithmetic)::9]


@functools.lru_cache(maxsize=None)
def module_of(file: str, arithmetic: str) -> Module:
    return Module(GLSL, f'#include "{file}"\n', Settings(arithmetic))


def translated(text: str, **settings: str) -> str:
    """The WGSL of a text that includes nothing."""
    module = Module(GLSL, text, Settings(**settings))
    return module.text(module.all_but_constants())


def types_of(overload: tuple[str, ...]) -> tuple[str, ...]:
    """The types as the translator calls them."""
    return tuple(re.sub(r"^(?=(?:place|octaves|slopes|shifts|flows)\d)", "hn_", type_.removeprefix("out ")) for type_ in overload)


class Names(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.modules = {arithmetic: module_of("hashnoise.glsl", arithmetic) for arithmetic in ARITHMETICS}

    def test_they_are_the_same_with_each_arithmetic(self):
        """The committed table of the interface has those with HN_FIXED."""
        fast, fixed = ({key: name for key, name in module.names().items() if not key[0].startswith("hn_i_")}
                       for module in self.modules.values())
        self.assertEqual(fast, fixed)

    def test_every_public_function_has_one(self):
        for arithmetic, module in self.modules.items():
            names, texts = module.names(), module.text()
            for declaration in declarations():
                types = types_of(declaration.types)
                with self.subTest(arithmetic=arithmetic, function=str(declaration)):
                    self.assertIn((declaration.name, types), names)
                    self.assertIn(f"\nfn {names[declaration.name, types]}(", texts)

    def test_those_of_places(self):
        internal = {of: name for (of, types), name in self.modules["HN_FAST"].names().items()
                    if of.startswith("hn_i_") and types == ("hn_place2",)}
        self.assertEqual([*internal.values()], [f"{of}_place2" for of in internal])
        self.assertTrue(internal)

    def test_parameters_that_keep_a_name_are_those_of_a_function(self):
        """Else a parameter has another name now, and its function gets dimensions that it does not have."""
        takes = {tuple(one.at.text for one in function.parameters)
                 for function in self.modules["HN_FAST"].library.forms.values()}
        self.assertEqual(set(NOT_OVERLOADED) - takes, set())

    def test_a_function_that_is_missing_is_noticed(self):
        module = Module(GLSL, '#include "perlin2d.glsl"\n')
        missing = [str(d) for d in declarations() if (d.name, types_of(d.types)) not in module.names()]
        self.assertIn("hn_perlin(vec3, uint)", missing)
        self.assertNotIn("hn_perlin(vec2, uint)", missing)

    def test_they_do_not_move(self):
        """A definition in a single file has the same name and the same text in the whole."""
        for arithmetic, module in self.modules.items():
            for file in files_with(arithmetic):
                for definition in module_of(file, arithmetic).definitions():
                    if definition.lines != module.definition(definition.name).lines:
                        self.fail(f"{file} and hashnoise.glsl have another {definition.name}, with {arithmetic}")

    def test_two_functions_with_one_name_are_refused(self):
        with self.assertRaisesRegex(Unknown, "the text:2: hn_f2 is the name of another function in WGSL, too"):
            translated("float hn_f(vec2 p, uint seed) { return p.x; }\n"
                       "float hn_f(vec2 p, float q, uint seed) { return q; }\n")

    def test_a_word_that_wgsl_reserves_has_another(self):
        self.assertIn("let from_: f32 = x;\n  return from_;", translated("float f(float x) { float from = x; return from; }"))


class Modules(unittest.TestCase):
    def test_what_no_public_function_needs(self):
        for arithmetic in ARITHMETICS:
            module = module_of("hashnoise.glsl", arithmetic)
            self.assertGreater(len(module.text(module.all_but_constants())), len(module.text()))

    def test_each_file_with_each_setting(self):
        for arithmetic in ARITHMETICS:
            for file in files_with(arithmetic):
                with self.subTest(file=file, arithmetic=arithmetic):
                    text = module_of(file, arithmetic).text()
                    code = re.sub(r"//.*", "", text)
                    self.assertIsNone(re.search(r"\b([iu]?vec[234]|float|int|uint|hn_i_num\d?)\b|#|\?", code))
                    self.assertEqual(text.count("{"), text.count("}"))
        for turn, hash_ in enumerate(HASHES):
            for gradient in some(GRADIENTS, turn):
                own = "mine" if hash_ == "CUSTOM" else ""
                with self.subTest(hash=hash_, gradient=gradient):
                    file = "hashnoise.glsl" if hash_ == "LATTICE" else "gradient.glsl"
                    text = Module(GLSL, f'#include "{file}"\n', Settings("HN_FIXED", hash_, gradient, own)).text()
                    self.assertEqual("mine(k)" in text, hash_ == "CUSTOM")

    def test_comments_of_public_functions_stay(self):
        text = module_of("hashnoise.glsl", "HN_FAST").text()
        for declaration in declarations():
            first = declaration.comment.lines[0]
            with self.subTest(function=str(declaration)):
                self.assertIn(f"//{first}\n", text)
        self.assertNotIn("0 if left out", text)

    def test_it_is_the_same_every_time(self):
        command = [sys.executable, TOOLS / "pick", "whole", "--language", "wgsl", "--arithmetic", "HN_FIXED", "noise2d.glsl"]
        first, second = (subprocess.run(command, capture_output=True, check=True).stdout for _ in range(2))
        self.assertEqual(first, second)

    def test_what_is_asked_for_is_there_and_no_more(self):
        text = module_of("hashnoise.glsl", "HN_FAST").text(["hn_perlin2"], strip=True)
        self.assertIn("fn hn_perlin2(p: vec2f, seed: u32) -> f32 {", text)
        self.assertNotIn("hn_perlin3", text)
        self.assertNotIn("//", text)
        with self.assertRaisesRegex(Unknown, "there is no hn_perlin5"):
            module_of("hashnoise.glsl", "HN_FAST").text(["hn_perlin5"])

    def test_precise_is_refused(self):
        with self.assertRaisesRegex(Unknown, "HN_PRECISE is not possible in WGSL.*Take HN_FIXED"):
            Module(GLSL, WHOLE, Settings("HN_PRECISE"))

    def test_an_error_of_the_library_is_one(self):
        with self.assertRaisesRegex(Unknown, r"config\.glsl:\d+: HN_METRIC_SQUARED is none"):
            with tempfile.TemporaryDirectory() as folder:
                (Path(folder) / "config.glsl").write_text("#if HN_HASH == 8\n#error HN_METRIC_SQUARED is none\n#endif\n")
                Module(Path(folder), '#define HN_HASH_LATTICE 8\n#include "config.glsl"\n')
        with self.assertRaisesRegex(Unknown, "--hash-function"):
            Module(GLSL, WHOLE, Settings(hash="CUSTOM"))

    def test_shaders_of_rows(self):
        body = ("hn_vec2 p = vec2(float_of(a.x), float_of(a.y)); "
                "return uvec4(bits_of(hn_perlin(p SEEDED(a.z))), 0u, 0u, 0u);")
        shaders = evaluations(GLSL, "#define HN_ARITHMETIC HN_FIXED\n", ["perlin2d.glsl"], {"noise2d.perlin": body})
        text = "".join(shaders["noise2d.perlin"])
        self.assertIn("let p: vec2f = vec2f(bitcast<f32>(a.x), bitcast<f32>(a.y));\n"
                      "return vec4u(bitcast<u32>(hn_perlin2(p, a.z)), 0u, 0u, 0u);\n", text)
        self.assertNotIn("hn_perlin3", text)
        with self.assertRaisesRegex(Unknown, "Take HN_FIXED"):
            evaluations(GLSL, "#define HN_ARITHMETIC HN_PRECISE\n", ["perlin2d.glsl"], {"noise2d.perlin": body})


class Command(unittest.TestCase):
    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, TOOLS / "pick", "whole", "--language", "wgsl", *arguments], capture_output=True, text=True, check=False)

    def test_statuses(self):
        self.assertEqual(self.call("--help").returncode, 0)
        self.assertEqual(self.call("absent.glsl").returncode, 2)
        self.assertEqual(self.call("--hash", "ABSENT").returncode, 2)
        refused = self.call("--arithmetic", "HN_PRECISE")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("Take HN_FIXED (--arithmetic fixed)", refused.stderr)
        refused = self.call("--hash", "custom")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("--hash custom --hash-function my_hash", refused.stderr)
        self.assertEqual(self.call("--out", "/dev/null/absent", "hash.glsl").returncode, 2)

    def test_import_path(self):
        one, other = (self.call(*arguments, "hash.glsl").stdout for arguments in ((), ("--import-path", "game::noise")))
        self.assertEqual(other, f"#define_import_path game::noise\n\n{one}")
        for path in ("a b", "a:b", "1a", "a::", ""):
            done = self.call("--import-path", path)
            self.assertEqual(done.returncode, 2)
            self.assertIn("such as game::noise", done.stderr)

    def test_another_copy(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "glsl"
            shutil.copytree(GLSL, copy)
            path = copy / "detail" / "word.glsl"
            path.write_text(path.read_text().replace("0x2C1B3C6Du", "0x2C1B3C6Fu"))
            self.assertIn("0x2C1B3C6Fu", self.call("--glsl", str(copy), "hash.glsl").stdout)
            path.write_text(path.read_text().replace("k ^= k >> 15u;", "k ^= ~k;"))
            done = self.call("--glsl", str(copy), "hash.glsl")
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"word\.glsl:\d+: the translator does not know ~")


class Translation(unittest.TestCase):
    def assert_becomes(self, glsl: str, wgsl: str) -> None:
        self.assertEqual(translated(glsl).strip(), wgsl.strip())

    def test_expressions(self):
        for glsl, wgsl in {
                "int f(int a, int b) { return a + b << 2; }": "(a + b) << 2u",
                "uint f(uint a, uint b) { return a ^ b & 3u; }": "a ^ (b & 3u)",
                "uint f(uint a, uint b, uint c) { return a ^ b ^ c; }": "a ^ b ^ c",
                "bool f(int a, int b) { return a < 1 && b < 2 || a == b; }": "(a < 1 && b < 2) || a == b",
                "bool f(uint a) { return (a & 1u) != 0u; }": "(a & 1u) != 0u",
                "float f(float a, float b, float c) { return a - (b - c); }": "a - (b - c)",
                "float f(float a, float b) { return -a * b; }": "-a * b",
                "float f(float a, float b) { return -(a + b); }": "-(a + b)",
                "int f(bool c, int a, int b) { return c ? a : b; }": "select(b, a, c)",
                "uvec3 f(uvec3 a) { return a >> 3u; }": "a >> vec3u(3u)",
                "ivec3 f(ivec3 a) { return a >> 31; }": "a >> vec3u(31u)",
                "uvec3 f(uvec3 a) { return a & 7u; }": "a & vec3u(7u)",
                "vec3 f(vec3 a, float b) { return a * b + 1.0f; }": "a * b + 1.0f",
                "ivec2 f(float p) { return ivec2(floor(p), 0.0f); }": "vec2i(vec2f(floor(p), 0.0f))",
                "ivec2 f(float p) { return ivec2(p); }": "vec2i(i32(p))",
                "vec2 f(ivec2 p) { return vec2(p); }": "vec2f(p)",
                "uint f(float x) { return floatBitsToUint(x); }": "bitcast<u32>(x)",
                "vec3 f(uvec3 x) { return uintBitsToFloat(x); }": "bitcast<vec3f>(x)"}.items():
            with self.subTest(glsl=glsl):
                self.assertIn(f"return {wgsl}; }}", translated(glsl))

    def test_statements(self):
        self.assert_becomes("""
            uint f(uint k) {
              k ^= k >> 15u;  // why
              // and so on
              return k;
            }""", """
fn f(k_in: u32) -> u32 {
  var k = k_in;
  k ^= k >> 15u;  // why
  // and so on
  return k;
}""")
        self.assert_becomes("""
            int f(int n) {
              int sum = 0;
              int least = 1;
              for (int i = least; i < n; ++i) sum += i;
              if (sum > 9) return 9; else if (sum < 0) { sum = 0; }
              for (;;) { sum -= 2; if (sum < 2) break; }
              return sum;
            }""", """
fn f(n: i32) -> i32 {
  var sum: i32 = 0;
  let least: i32 = 1;
  for (var i: i32 = least; i < n; i++) {
    sum += i;
  }
  if (sum > 9) {
    return 9;
  } else if (sum < 0) { sum = 0; }
  loop {
    sum -= 2;
    if (sum < 2) { break; }
  }
  return sum;
}""")

    def test_parameters_that_are_set(self):
        self.assert_becomes("""
            struct pair { float x; float y; };
            void g(inout pair p, float x) { p.x += x; }
            void f(out pair p, out float z) { g(p, 1.0f); z = p.y; pair q; g(q, z); }""", """
struct pair {
  x: f32,
  y: f32,
}

fn g(p: ptr<function, pair>, x: f32) { (*p).x += x; }

fn f(p: ptr<function, pair>, z: ptr<function, f32>) {
  g(p, 1.0f);
  *z = (*p).y;
  var q: pair;
  g(&q, *z);
}""")

    def test_a_parameter_that_is_passed_on_to_be_set_is_a_copy(self):
        self.assertIn("fn f(x_in: f32) -> f32 {\n  var x = x_in;\n  g(&x);\n  return x;\n}", translated(
            "void g(inout float x) { x += 1.0f; }\nfloat f(float x) { g(x); return x; }"))

    def test_macros_that_stand_for_numbers_stay(self):
        self.assert_becomes("""
            #define HN_I_ONE 1.0f  // a whole
            #define HN_I_HALF (HN_I_ONE / 2.0f)
            #define HN_I_TYPE float
            #define HN_I_TWICE(x) ((x) + (x))
            #if 1 + 1 == 2 && !defined(HN_I_NONE)
            HN_I_TYPE f() { return HN_I_TWICE(HN_I_HALF); }
            #endif""", """
const HN_I_ONE: f32 = 1.0f;  // a whole
const HN_I_HALF: f32 = (HN_I_ONE / 2.0f);

fn f() -> f32 { return ((HN_I_HALF) + (HN_I_HALF)); }""".replace("(HN_I_HALF)", "HN_I_HALF"))

    def test_a_seed_that_is_left_out_is_put_in(self):
        text = translated("""
            float hn_f(vec2 p, uint seed) { return p.x; }
            float hn_f(vec2 p) { return hn_f(p, 0u); }
            float f(vec2 p) { return hn_f(p); }""")
        self.assertEqual(text.count("fn hn_f2("), 1)
        self.assertIn("return hn_f2(p, 0u);", text)

    def test_rows_of_bugs_have_more(self):
        for glsl, wgsl in {
                "hn_int n = 3; while (n < 64) n += int(a.x); return uvec4(uint(n));":
                    "for (; n < 64i; ) {\nn += i32(a.x);\n}",
                "hn_uint t[8]; t[0] = a.x; return uvec4(t[int(a.y) & 7]);":
                    "var t: array<u32, 8>;\nt[0i] = a.x;\nreturn vec4<u32>(t[i32(a.y) & 7i]);",
                "switch (a.x) { case 1u: case 2u: return b; default: break; case 3u: return c; } return a;":
                    "switch a.x {\ncase 1u, 2u: {\nreturn b;\n}\ndefault: {\nbreak;\n}\ncase 3u: {\nreturn c;\n}\n}",
                "return uvec4(-a.x, a.x << int(a.y), bits_of(sin(2.0)), 0u);":
                    "return vec4<u32>(0u - a.x, a.x << u32(i32(a.y)), bitcast<u32>(sin(2.0f)), 0u);"}.items():
            with self.subTest(glsl=glsl):
                self.assertIn(wgsl, "".join(shader_of_bug({"id": "bugs.x", "declarations": "", "body": glsl})))
        own = {"id": "bugs.x", "wgsl_declarations": "fn f() {}\n", "wgsl": "return a;"}
        self.assertIn("fn f() {}\nfn evaluate(a: vec4<u32>,", "".join(shader_of_bug(own)))
        with self.assertRaisesRegex(Unknown, "bugs.x has wgsl among its profiles: rows:6: case stands where a case has to"):
            shader_of_bug({"id": "bugs.x", "declarations": "", "body": "switch (a.x) { default: a.x = 1u; case 1u: }"})

    def test_what_is_unknown_is_refused(self):
        for glsl, message in {
                "float f(float x) { return x }": "} stands where ; is expected",
                "float f(float x) { return sin(x); }": r"there is no function sin\(float\)",
                "float f(float x) { return x + 1; }": r"the translator does not know float \+ int",
                "float f(int x) { return x; }": "this is a int where a float is expected",
                "float f(float x) { return x * 2.0; }": "2.0 has no f",
                "uint f(uint x) { return ~x; }": "the translator does not know ~",
                "uint f(uint x) { return -x; }": "the translator does not know - of a uint",
                "vec2 f(vec3 v) { return v.xy; }": ".xy of a vec3",
                "float f(vec2 v) { return v[0]; }": "arrays",
                "vec2 f(bool c, vec2 a) { return c ? a : a; }": r"\? of a vec2",
                "int f(int a, int b) { return a >> b; }": "int >> int",
                "float f(float x) { y = x; return y; }": "y is no variable",
                "float f(float x) { g(x) = 1.0f; return x; }": "= stands where ; is expected",
                "void g(out float x) { x = 1.0f; }\nvoid f() { g(1.0f); }": "must be a variable",
                "float hn_f(vec2 p, uint seed) { return p.x; }\nfloat hn_f(vec2 p) { return hn_f(p, 1u); }":
                    "without a seed must be",
                "void f(int x) { switch (x) { default: return; } }": "does not know switch",
                "mat2 f(float x) { return x; }": "mat2 stands where a type is expected",
                "uniform float x;": "uniform stands where a type is expected",
                "float f(float x) { return x; }\nfloat f(float y) { return y; }": "f is there already",
                "float f(float x) { return x @ x; }": "@ x; } is no GLSL|@ is no GLSL",
                "#pragma once": "#pragma",
                "#if ABSENT\n#endif": "ABSENT has no value",
                "#if 1": "an #if has no #endif",
                "#error no": "the text:1: no",
                '#include "absent.glsl"': "there is no",
                "#define F(x) x\nfloat f() { return F(1.0f, 2.0f); }": "F has 2 arguments instead of 1",
                "int f() { return 2147483648; }": "does not fit an int"}.items():
            with self.subTest(glsl=glsl), self.assertRaisesRegex(Unknown, message) as raised:
                translated(glsl)
            self.assertRegex(str(raised.exception), r"^the text(:\d+)?: ")
