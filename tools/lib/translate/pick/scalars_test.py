"""Languages without vectors: rare parts of the library, as text. pick.languages_test compiles them."""

from __future__ import annotations

import functools
import re
import unittest
from collections.abc import Callable

from base.debian import Missing
from base.tree import GLSL
from translate.parsing.syntax import Parser
from translate.parsing.tokens import Unknown, tokens_of
from translate.pick import command
from translate.pick.c import C
from translate.pick.evaluate import Module
from translate.pick.javascript import JavaScript, TypeScript
from translate.pick.program import Program, chosen, read
from translate.pick.runners import RUNNERS
from translate.pick.scalars import Syntax, text


@functools.cache
def library(syntax: type[Syntax] = Syntax) -> Module:
    return read(GLSL, {**command.settings("fixed", "lattice"), **syntax.library}, splits=True)


def written(shown: str, syntax: type[Syntax]) -> str:
    """The last function of a text in GLSL, without the heading and the functions that the language lacks."""
    tree = Parser(list(tokens_of(shown, "the text", 1))).parse()
    return text(Program(Module(tree, {}, splits=True), tree[-1:]), syntax()).partition("\n/// x.")[0].strip("\n")


def in_language(language: str) -> Callable:
    """Tests of a language that can be deleted."""
    return unittest.skipUnless(language in command.SYNTAXES, "it was deleted")


@in_language("rust")
class InRust(unittest.TestCase):
    CASES = (
        # Numbers have no type of their own, where they have a method.
        ("uint hn_f(uint h, int n) { return (floatBitsToUint(0.1f) ^ h) * (7u - h) + (3u * h) + uint(min(5, n)); }",
         "pub fn f1(h: u32, n: i32) -> u32 {\n"
         "    let n2 = (0.1_f32.to_bits() ^ h).wrapping_mul(7_u32.wrapping_sub(h));\n"
         "    n2.wrapping_add(h.wrapping_mul(3)).wrapping_add(n.min(5) as u32)\n}"),
        # Branches have values, and those that set something else as well.
        ("vec2 hn_f(vec2 p, int m) { vec2 r = p; float k; if (m < 2) { r = vec2(p.y, 3.0f); k = p.y * p.y; } else "
         "{ k = p.x; } return r * k; }",
         "pub fn f2(x: f32, y: f32, m: i32) -> [f32; 2] {\n    let (mut r_x, mut r_y) = (x, y);\n"
         "    let k = if m < 2 {\n        r_x = y;\n        r_y = 3.0;\n        y * y\n    } else {\n        x\n"
         "    };\n    [r_x * k, r_y * k]\n}"),
        # A loop whose limit or number changes is no range.
        ("int hn_f(int a) { int sum = 0; for (int i = 0; i < a; i++) { sum += i; a -= 2; } return sum + a; }",
         "pub fn f1(mut a: i32) -> i32 {\n    let mut sum = 0;\n    let mut i = 0;\n    while i < a {\n"
         "        a -= 2;\n        sum += i;\n        i += 1;\n    }\n    sum + a\n}"),
        # Parameters that are set are returned; vectors are their components.
        ("void hn_f(vec2 p, uint seed, out ivec2 near, out float far) "
         "{ near = ivec2(p) - 1; far = p.x < p.y ? p.x : p.y; }",
         "/// Returns near; then far.\npub fn f2(x: f32, y: f32, _seed: u32) -> ([i32; 2], f32) {\n"
         "    ([x as i32 - 1, y as i32 - 1], if x < y { x } else { y })\n}"),
        # A cast in front of < would be the beginning of arguments of its type.
        ("bool hn_f(float a, int b) { return int(a) < b && b > int(a) << 2; }",
         "pub fn f1(a: f32, b: i32) -> bool {\n    let n = a as i32;\n    n < b && b > (n << 2)\n}"),
        ("bool hn_f(float a, int b) { return int(a) < b; }",
         "pub fn f1(a: f32, b: i32) -> bool {\n    (a as i32) < b\n}"),
        # As clippy wants it.
        ("uint hn_f(uint h) { return (h >> 19u) | (h << 13u); }",
         "pub fn f(h: u32) -> u32 {\n    h.rotate_left(13)\n}"),
        ("uint hn_f(uint h) { return (h >> 18u) | (h << 13u); }",
         "pub fn f(h: u32) -> u32 {\n    (h >> 18) | (h << 13)\n}"),
        ("int hn_f(int a) { return min(max(a, 1), 9) + max(min(a, 1), 9) + a * -1; }",
         "pub fn f1(a: i32) -> i32 {\n    a.clamp(1, 9) + a.min(1).max(9) + -a\n}"),
        ("float hn_f(float a) { return a * 6.2831853f + a * -2.998046875f + a * 1.57079090f; }",
         "pub fn f1(a: f32) -> f32 {\n    a * core::f32::consts::TAU + a * -2.9980469 + a * 1.5707909\n}"),
        ("float hn_f(float a) { return (1.0f - 1.0f) * a + (a - a) * 3.0f; }",
         "pub fn f1(a: f32) -> f32 {\n    0.0 * a + 0.0\n}"),
        ("float hn_f(float a, float b, float c, float d, float e, float f, float g, float h) "
         "{ return a + b + c + d + e + f + g + h; }",
         "#[allow(clippy::too_many_arguments)]\npub fn f1(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, "
         "h: f32) -> f32 {\n    a + b + c + d + e + f + g + h\n}"),
    )

    def test_they_do_the_same(self) -> None:
        for shown, expected in self.CASES:
            with self.subTest(shown):
                self.assertEqual(written(shown, command.SYNTAXES["rust"]), expected)

    def test_a_function_is_not_called_like_a_parameter(self) -> None:
        shown = written("int hn_i_power(int x) { int y = x * x - 3; return y * y + x * 5 - (y << 2) * y; } "
                        "int hn_f(int power) { return hn_i_power(power) + hn_i_power(power + 1) + hn_i_power(power * 7); }",
                        command.SYNTAXES["rust"])
        self.assertIn("pub fn f1(power: i32) -> i32 {\n    power_2(power) + power_2(power + 1) + power_2(power * 7)\n}", shown)


class InC(unittest.TestCase):
    def test_a_negative_number_is_shifted_to_the_left(self) -> None:
        self.assertIn("  return (int32_t)((uint32_t)x << 3u);\n",
                      written("int hn_f(int x) { return x << 3u; }", C))


@in_language("csharp")
class InCSharp(unittest.TestCase):
    def test_what_is_no_vector_has_names_of_its_own(self) -> None:
        of, CSharp = library(), command.SYNTAXES["csharp"]
        cases = {"hn_perlin_d2": "float Value, float Dx, float Dy", "hn_value_d1": "float Value, float Dx",
                 "hn_fbm_d3": "float Value, float Dx, float Dy, float Dz",
                 "hn_mean2_slopes": "float Value, float Dx, float Dy", "hn_gullies2": "float Value, float Dx, float Dy",
                 "hn_cellular_d2": "float Value, float Dx, float Dy", "hn_cellular2": "float F1, float F2",
                 "hn_cellular_three3": "float F1, float F2, float F3",
                 "hn_cellular2_nearest": "(float F1, float F2) Value, (int X, int Y) Nearest, (float X, float Y) "
                                         "Offset",
                 "hn_phasor2": "float Value, float Quadrature", "hn_uniform_d": "float Value, float Slope",
                 "hn_mean2_shifts": "float X, float Y", "hn_warp3": "float X, float Y, float Z",
                 "hn_circle": "float X, float Y"}
        for name, returned in cases.items():
            with self.subTest(name):
                shown = " ".join(text(Program(of, chosen(of, [name])), CSharp()).split())
                self.assertIn(f"public static ({returned}) {CSharp().function_name(name, True)}(", shown)


@in_language("java")
class InJava(unittest.TestCase):
    def test_results_that_are_no_vectors_have_records_of_their_own(self) -> None:
        of, Java = library(), command.SYNTAXES["java"]
        cases = {"hn_perlin_d2": "Derivatives2(float value, float dx, float dy)",
                 "hn_value_d1": "Derivatives1(float value, float dx)",
                 "hn_fbm_d3": "Derivatives3(float value, float dx, float dy, float dz)",
                 "hn_mean2_slopes": "Derivatives2(float value, float dx, float dy)",
                 "hn_cellular2": "Distances2(float f1, float f2)",
                 "hn_cellular_three3": "Distances3(float f1, float f2, float f3)",
                 "hn_cellular2_nearest": "Cellular2NearestResult(Distances2 value, Int2 nearest, Float2 offset)",
                 "hn_phasor2": "ValueQuadrature(float value, float quadrature)",
                 "hn_uniform_d": "ValueSlope(float value, float slope)",
                 "hn_warp3": "Float3(float x, float y, float z)", "hn_circle": "Float2(float x, float y)"}
        for name, returned in cases.items():
            with self.subTest(name):
                shown = " ".join(text(Program(of, chosen(of, [name])), Java()).split())
                self.assertIn(f"public static {returned.partition('(')[0]} {Java().function_name(name, True)}(", shown)
                self.assertIn(f"record {returned} {{", shown)
        alone = text(Program(of, chosen(of, ["hn_uniform_d"])), Java())
        self.assertNotIn("Float2", alone)  # a record that nothing uses is left out


class InTypeScript(unittest.TestCase):
    @staticmethod
    def erased(shown: str) -> str:
        """Without types, and with a declaration for each variable: which share a line depends on how long they are."""
        shown = re.sub(r"export interface \w+ \{[^}]*\}|export type [^\n]*|/\*\*.*?\*/", "", shown, flags=re.DOTALL)
        shown = re.sub(r": (?:number|boolean|void|[A-Z]\w*)\b|\): \{[^}]*\}(?= \{)",
                       lambda found: ")" if found[0].startswith(")") else "", shown)
        return re.sub(r"; (?:const|let) (?=\w+(?: =|[,;]))", ", ", " ".join(shown.split()))

    def test_without_its_types_it_is_javascript(self) -> None:
        of = library()
        for name in ("hn_perlin2", "hn_cellular2_nearest", "hn_next2"):
            typed, plain = (text(Program(of, chosen(of, [name])), syntax()) for syntax in (TypeScript, JavaScript))
            with self.subTest(name):
                self.assertRegex(typed, r"(?m)^function \w+\(\w+: ")
                self.assertNotRegex(plain, r"(?m)^function \w+\(\w+: ")
                self.assertEqual(self.erased(typed), self.erased(plain))


class InAll(unittest.TestCase):
    def test_lines_are_no_longer_than_elsewhere(self) -> None:
        of = library()
        for name in ("hn_cellular2_nearest", "hn_octaves_of2_place"):
            program = Program(of, chosen(of, [name]))
            for language, syntax in command.SYNTAXES.items():
                with self.subTest(name, language=language):
                    self.assertLessEqual(max(map(len, text(program, syntax()).splitlines())), 120)

    def test_a_compiler_that_is_missing_is_named_with_its_package(self) -> None:
        class Absent(RUNNERS["javascript"]):
            programs = ("hn-no-such-compiler",)
        with self.assertRaisesRegex(Missing, "no hn-no-such-compiler: apt-get install nodejs"):
            Absent().check()


class Comments(unittest.TestCase):
    NAMES = ("hn_octaves_of2", "hn_lattice2", "hn_cellular2_nearest", "hn_scattered2", "hn_next2", "hn_perlin2")

    @classmethod
    def setUpClass(cls) -> None:
        pick = command.picker()
        cls.texts = {language: pick(cls.NAMES, command.Choice(language, "fixed"))
                     for language in command.SYNTAXES if language != "osl"}

    def test_the_head_is_what_tools_of_the_language_look_for(self) -> None:
        for language, head in (("csharp", r"// <auto-generated/>\n"), ("go", r"// Code generated .* DO NOT EDIT\.\n"),
                               ("go", r"[^|]*\n\n// Package hashnoise computes procedural noise\.\npackage hashnoise\n")):
            if language in self.texts:
                self.assertRegex(self.texts[language], rf"\A{head}")
        for language, shown in self.texts.items():
            with self.subTest(language):
                head = " ".join(re.sub(r"(?m)^(//|#) *", "", shown.partition("\n\n")[0]).split())
                self.assertIn(f"tools/pick {' '.join(self.NAMES)} --language {language} --arithmetic fixed Copyright",
                              head)
                self.assertLessEqual(max(map(len, shown.splitlines())), 120)

    @in_language("go")
    def test_in_go_a_comment_is_a_sentence_that_begins_with_the_name(self) -> None:
        for begin in ("Octaves2 is the octaves of a loop, made by OctavesOf2 and others.",
                      "Lattice2 computes the hash of a lattice point, to scatter", "Next2 moves on to the next octave.",
                      "Scattered2 returns whether the point of a cell", "Perlin2 computes Perlin noise on the plane"):
            self.assertIn(f"\n// {begin}", self.texts["go"])

    def test_structs_have_comments(self) -> None:
        for language, before in (("csharp", "fields.</summary>\n    public struct Octaves2 {"),
                                 ("go", "of these fields.\ntype Octaves2 struct {"),
                                 ("java", "\n     */\n    public static final class Octaves2 {"),
                                 ("c", "seed of these fields.\ntypedef struct {"),
                                 ("javascript", " * of these fields.\n * @typedef {object} Octaves2\n"),
                                 ("typescript", " * of these fields.\n */\nexport interface Octaves2 {")):
            with self.subTest(language):
                self.assertIn(before, self.texts.get(language, before))

    def test_functions_and_words_are_called_as_in_the_language(self) -> None:
        for language, lattice, word in (
                ("rust", "lattice2(nearest, seed)", "any u32"), ("csharp", "Lattice2(nearest, seed)", "any uint"),
                ("c", "hn_lattice2(nearest, seed)", "any uint32_t"), ("go", "Lattice2(nearest, seed)", "any uint32"),
                ("javascript", "lattice2(nearest, seed)", "any whole number from 0 to 2^32 - 1"),
                ("java", "lattice2(nearest, seed)", "any int: its 32 bits, so Integer.remainderUnsigned(h, n) is")):
            if language not in self.texts:
                continue
            with self.subTest(language):
                shown = " ".join(re.sub(r"(?m)^ *(///?|\*)", "", self.texts[language]).split())
                self.assertIn(f" {lattice} is a random hash", shown)
                self.assertIn(word, shown.replace("Any", "any"))

    @in_language("java")
    def test_records_that_users_do_not_get_are_private_in_java(self) -> None:
        self.assertIn("    private record Int4(", self.texts["java"])
        self.assertIn("    public record Int2(", self.texts["java"])


class OfOsl(unittest.TestCase):
    pick = staticmethod(command.picker())

    def picked(self, name: str) -> str:
        return self.pick([name], command.Choice("osl"))

    def test_a_component_of_a_result_is_taken_by_a_function(self) -> None:
        made = self.picked("hn_cell2")
        self.assertIn("int hn_i_x_of_uvec2(hn_uvec2 a) { return a.x; }", made)
        self.assertNotIn(").x", made)

    def test_a_shader_has_the_position_and_defaults(self) -> None:
        made = self.picked("hn_fbm2").partition("\nshader ")[2]
        plain = re.sub(r"(?s)\s+\[\[.*?\]\]|(?<=,)\n   ", "", made)
        self.assertIn("point p = P, int octaves = 6, float lacunarity = 2.0, float gain = 0.5, int seed = 0, output ",
                      plain)
        self.assertIn("value = hn_fbm2(p[0], p[1], octaves, lacunarity, gain, seed);", made)
        self.assertIn("value = vector(value_n.x, value_n.y, 0);", self.picked("hn_curl2"))
        self.assertIn("value_w = value_n.w;", self.picked("hn_perlin_d3"))
        self.assertIn("output float result = 0", self.picked("hn_uniform"))  # whose first input is a value

    def test_a_parameter_has_a_text_and_the_ends_of_its_arithmetic(self) -> None:
        floats = 'string help = "ratio of amplitudes from octave to octave (persistence)",\n           float min = 0.0'
        self.assertIn(f"\n    float gain = 0.5\n        [[ {floats} ]],\n", self.picked("hn_fbm2"))
        self.assertIn(f" {floats}, float max = 1.0 ]],\n", self.pick(["hn_fbm2"], command.Choice("osl", "fixed")))
        self.assertIn("int min = 1, int max = 5 ]]", self.picked("hn_cellular2_jitter"))
        self.assertIn('[[ string help = "how often it folds",\n           float min = 0.0, float max = 64.0 ]]',
                      self.picked("hn_ping_pong2"))
        seed = self.picked("hn_perlin2").partition("int seed = 0")[2].partition("output")[0]
        self.assertEqual(seed.strip(), '[[ string help = "different seeds give independent fields" ]],')

    def test_a_struct_in_a_struct_is_set_by_itself(self) -> None:
        made = self.picked("hn_octaves_of1")
        self.assertIn("  made.place = place;\n", made)
        self.assertIn("return hn_i_made_octaves1(hn_place1(", made)

    def test_a_place_has_no_shader(self) -> None:
        self.assertNotIn("\nshader ", self.picked("hn_perlin2_place"))

    def test_precise_is_refused(self) -> None:
        with self.assertRaisesRegex(Unknown, "take --arithmetic fixed"):
            command.picked(["hn_perlin2"], command.Choice("osl", "precise"))
