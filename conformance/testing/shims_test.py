"""The text of the library as HLSL, and in Metal's shading language: python3 shims_test.py CLANG++ [--thorough]

The suite checks its results there (the profiles hlsl60, hlsl50 and msl). Here are the settings that no case has, and
the macros that the files leave behind in a user's code. glslang compiles the HLSL; clang++ compiles Metal's language, a
C++14, with the stand-in for its standard library. The preprocessor of g++ evaluates the conditions for other compilers.
Each value of a setting is tried once, and with --thorough each with all others."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from itertools import product
from pathlib import Path

ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
CONFORMANCE = Path(__file__).resolve().parent.parent
ROOT = CONFORMANCE.parent
COMPILER = sys.argv[1] if len(sys.argv) > 1 else "clang++"
THOROUGH = "--thorough" in sys.argv
# A user's own calls with GLSL's names, and a fractal of the user's.
USER = """
float my_sum(hn_octaves2 o) {
  do hn_add(o, hn_simplex(o.place, o.seed)); while (hn_next(o));
  return hn_mean(o);
}
float2 my_warp(hn_octaves2 o) {
  hn_shifts2 s = hn_shifts(o, 1.0f);
  do hn_add_progressive(o, s, float2(hn_value(o.place, o.seed), 0.5f)); while (hn_next(o));
  return hn_mean(o, s);
}
float my_slopes(hn_octaves3 o) {
  hn_slopes3 s = hn_slopes(o);
  do hn_add_eroded(o, s, hn_value_d(o.place, o.seed), 1.0f); while (hn_next(o));
  return hn_mean(o);
}
float mine(float2 p, uint seed) {
  float3 vec3 = float3(p, 0.5f);
  float uvec4 = hn_perlin(p) + hn_perlin(hn_tile(hn_place(int3(7, 7, 7), vec3), int3(8, 8, 8)), seed) +
                hn_fbm(p, 5, 2.0f, 0.5f, seed) + hn_value_d(float4(p, p), seed).value;
  return uvec4 + hn_turbulence(vec3, 5, 2.1f, 0.5f) + hn_clouds(p, 3, 2.0f, 0.5f) +
         my_sum(hn_octaves(p, 5, 2.0f, 0.5f, 7u)) + my_warp(hn_octaves(p, 5, 2.0f, 0.5f, 7u)).x +
         my_slopes(hn_octaves(vec3, 5, 2.0f, 0.5f, 7u)) + hn_gradient(int2(7, 7)).x +
         hn_unorm(hn_hash(uint3(7u, 7u, seed)) ^ hn_lattice(int4(1, 2, 3, 4)));
}
"""
MAIN = """
RWStructuredBuffer<float> values;
[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  values[id.x] = mine(float2(asfloat(id.x), asfloat(id.y)), id.z);
}
"""


def printed(language: str) -> list[str]:
    """The code of a language in the pages that have some."""
    return re.findall(rf"^```{language}\n(.*?)^```$", "\n".join(
        (ROOT / "docs" / page).read_text() for page in ("guide/languages.md", "guide/hex-tiling.md")), re.MULTILINE | re.DOTALL)


def settings(arithmetics: tuple[str, ...]) -> list[dict[str, str]]:
    rows = list(zip(arithmetics, ("OCTAHEDRAL", "SINE", "SINE"), ("LATTICE", "PCG", "FNV1")))
    if THOROUGH:
        rows = list(product(arithmetics, ("OCTAHEDRAL", "SINE"), ("LATTICE", "PCG", "FNV1")))
    return [{"HN_ARITHMETIC": arithmetic, "HN_GRADIENT": f"HN_GRADIENT_{gradient}", "HN_HASH": f"HN_HASH_{hashed}"}
            for arithmetic, gradient, hashed in rows]


class Shim(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.include = Path(folder.name, "glsl")
        self.glsl = self.include / "hashnoise"
        shutil.copytree(ROOT / "glsl" / "hashnoise", self.glsl)
        shutil.copy(CONFORMANCE / "gpu" / "metal" / "metal_stdlib.hpp", self.include / "metal_stdlib")
        self.file = Path(folder.name, "user.cpp")

    def change(self, file: str, old: str, new: str) -> None:
        text = (self.glsl / file).read_text()
        self.assertIn(old, text)
        (self.glsl / file).write_text(text.replace(old, new))

    def messages(self, *command: str) -> str:
        """The compiler's messages on the file; empty if it takes it."""
        done = subprocess.run([*command, f"-I{self.include}", str(self.file)], capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else f"exit status {done.returncode}: {done.stdout}{done.stderr}"

    def written(self, text: str, knobs: dict[str, str]) -> None:
        self.file.write_text("".join(f"#define {name} {value}\n" for name, value in knobs.items()) + text)

    def left_behind(self, language: str, preprocessed_as: str) -> list[str]:
        """The macros that are not the library's own, behind an include of it."""
        self.written("".join(
            f'#include "hashnoise/{name}"\n' for name in (f"begin.{language}", "hashnoise.glsl", f"end.{language}")), {})
        macros = [set(re.findall(r"#define (\w+)", subprocess.run(
            ["g++", "-E", "-dM", "-x", preprocessed_as, f"-I{self.include}", path], capture_output=True, text=True, check=True).stdout))
                  for path in (self.file, "/dev/null")]
        return sorted(name for name in macros[0] - macros[1] if not re.match("hn_|HN_", name))


class Hlsl(Shim):
    def accepted(self, stage: str) -> str:
        return self.messages("glslangValidator", "-D", "-V", "-S", stage, "-e", "main", "-o", str(self.file) + ".spv")

    def compiled(self, include: str = '#include "hashnoise/hashnoise.hlsl"', **knobs: str) -> str:
        self.written(include + USER + MAIN, knobs)
        return self.accepted("comp")

    def test_the_code_of_the_page_compiles(self):
        shaders = printed("hlsl")
        self.assertEqual(len(shaders), 4)
        for shader in shaders:
            self.written(shader, {})
            self.assertEqual(self.accepted("comp" if "numthreads" in shader else "frag"), "")

    def test_it_compiles_with_every_arithmetic_and_gradient(self):
        for knobs in settings(ARITHMETICS):
            with self.subTest(**knobs):
                self.assertEqual(self.compiled(**knobs), "")

    def test_parts_are_included_between_begin_and_end(self):
        parts = "".join(f'#include "hashnoise/{name}"\n' for name in (
            "begin.hlsl", "fbm.glsl", "end.hlsl", "begin.hlsl", "noise2d.glsl", "warp.glsl", "fbm_d.glsl", "end.hlsl"))
        self.assertEqual(self.compiled(parts + '#include "hashnoise/hashnoise.hlsl"\n'), "")

    def test_a_function_that_only_glsl_has_is_refused(self):
        self.change("detail/arithmetic.glsl", "p - floor(p)", "fract(p)")
        self.assertIn("fract", self.compiled())

    def test_no_macro_is_left_behind(self):
        self.assertEqual(self.left_behind("hlsl", "c"), [])

    def test_a_macro_that_is_left_behind_is_noticed(self):
        self.change("end.hlsl", "#undef floatBitsToUint\n", "")
        self.change("detail/vectors_end.h", "#undef ivec3\n", "")
        self.assertEqual(self.left_behind("hlsl", "c"), ["floatBitsToUint", "ivec3"])


class Metal(Shim):
    def accepted(self, *options: str) -> str:
        return self.messages(COMPILER, "-std=c++14", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *options)

    def compiled(self, **knobs: str) -> str:
        self.written('#include "hashnoise/hashnoise.metal"\nnamespace hashnoise {' + USER + "}\n", knobs)
        return self.accepted()

    def test_the_code_of_the_page_compiles(self):
        shaders = printed("metal")
        self.assertEqual(len(shaders), 1)
        self.written(shaders[0], {"fragment": ""})
        self.assertEqual(self.accepted("-Wno-unknown-attributes"), "")

    def test_it_compiles_with_every_arithmetic_and_gradient(self):
        for knobs in settings(("HN_FAST", "HN_FIXED")):
            with self.subTest(**knobs):
                self.assertEqual(self.compiled(**knobs), "")

    def test_precise_is_refused(self):
        self.assertIn("#error HN_PRECISE needs", self.compiled(HN_ARITHMETIC="HN_PRECISE"))

    def test_a_reference_without_an_address_space_is_noticed(self):
        self.change("config.glsl", "#define HN_I_OUT(type) thread type&", "#define HN_I_OUT(type) out type")
        self.assertIn("unknown type name 'out'", self.compiled())

    def test_no_macro_is_left_behind(self):
        self.assertEqual(self.left_behind("metal", "c++"), [])

    def test_a_macro_that_is_left_behind_is_noticed(self):
        self.change("end.metal", "#undef floatBitsToUint\n", "")
        self.assertEqual(self.left_behind("metal", "c++"), ["floatBitsToUint"])


class Conditions(Shim):
    def preprocessed(self, *macros: str) -> str:
        self.written('#include "hashnoise/hashnoise.glsl"\n', {})
        return self.messages("g++", "-E", "-x", "c", "-Wundef", "-Werror", "-o", "/dev/null", *macros)

    # g++ defines __VERSION__ as a string, as DXC does; without it, its preprocessor is like naga's or Godot's.
    WITHOUT_A_NUMBER = (("-DHN_I_HLSL",), ("-U__VERSION__",))

    def test_no_condition_asks_for_a_name_or_a_number_that_may_not_be_there(self):
        for macros, arithmetic in product(self.WITHOUT_A_NUMBER, ARITHMETICS):
            with self.subTest(macros=macros, arithmetic=arithmetic):
                self.assertEqual(self.preprocessed(f"-DHN_ARITHMETIC={arithmetic}", *macros), "")

    def test_a_condition_that_does_is_noticed(self):
        self.change("detail/hashes.glsl", '#include "../config.glsl"', '#include "../config.glsl"\n#if __VERSION__ < 130\n#endif')
        for macros in self.WITHOUT_A_NUMBER:
            self.assertIn("__VERSION__", self.preprocessed(*macros))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
