"""Tests what compilers say of the headers where a user goes wrong: python3 header_test.py COMPILER..."""

from __future__ import annotations

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
INCLUDE = ROOT / "include"
COMPILERS = sys.argv[1:]
HEADERS = ("hashnoise.hpp", "glsl.hpp")
ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
# Sums over several noises in one file: of the library and of the user's.
SUMS = """
namespace hashnoise {
inline float ridged_of_value(hn_octaves2 o) {
  do hn_add_ridged(o, hn_value(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o);
}
inline float weighted_of_value(hn_octaves3 o) {
  do hn_add_weighted(o, hn_value(o.place, o.seed), 1.0f);
  while (hn_next(o));
  return hn_mean(o);
}
inline float mine(hn_place2 place, uint seed) {
  return hn_position(place).y + static_cast<float>((unsigned(place.cell.x) ^ seed) & 1u);
}
inline float limited_of_mine(hn_octaves2 o, bool part) {
  do {
    if (part) hn_add_detail(o, mine(o.place, o.seed));
    else hn_add_footprint(o, mine(o.place, o.seed));
  } while (hn_next(o));
  return hn_mean(o);
}
}  // namespace hashnoise

float all_of_them(float x) {
  using namespace hashnoise;
  const vec2 p(x, 0.5f);
  return ridged_of_value(hn_octaves(hn_place(ivec2(3, 4), p), 5, 2.0f, 0.5f, 7u)) +
         weighted_of_value(hn_octaves(hn_tile(vec3(x), ivec3(4)), 5, 2.0f, 0.5f, 7u)) +
         limited_of_mine(hn_octaves(p, 4.5f, 2.0f, 0.5f, 7u), true) +
         limited_of_mine(hn_octaves(p, 0.01f, 5, 2.0f, 0.5f, 7u), false);
}
"""

# Every kind of argument of the functions, with the numbers as GLSL writes them, and as C++ does.
RIGHT = (
    "hn_perlin(x)", "hn_perlin(x, 7u)", "hn_perlin(hn_tile(x, 16), 7u)", "hn_perlin(d, 7u)", "hn_perlin(0.5)",
    "hn_perlin({x, x}, 7u)", "hn_perlin(hn_tile(p, ivec2(8, 5)), 7u)", "hn_perlin(hn_place(c, p), seed)", "hn_perlin(hn_tile(hn_place(c, p), ivec2(8)), 0.25, 7u)",
    "hn_perlin(p, 0.25f, 7u)", "hn_perlin(vec4(x), seed)", "hn_perlin(vec2(d, d), seed)",
    "hn_value_d(vec4(x), 7u).value", "hn_cellular(p, 1.0f, HN_METRIC_MANHATTAN, 7u).x",
    "hn_cellular(hn_place(p), 0.5, 3, 7u).x", "hn_fbm(p, 6, 2.0f, 0.5f)", "hn_fbm(p, 6, 2.0, 0.5)",
    "hn_fbm(p, 6, 2.0, 0.5, 7u)", "hn_fbm(x, octaves, d, 0.5f, seed)", "hn_fbm(p, 2.5f, 2.0f, 0.5f, 7u)",
    "hn_fbm(p, 0.1f, 3, 2.0f, 0.5f, 7u)", "hn_fbm(p, 0.1, 3, 2.0, 0.5, 7u)", "hn_fbm(hn_place(c, p), 6, 2.0, 0.5, 7u)",
    "hn_fbm(hn_tile(p, ivec2(4)), 6, 2.0, 0.5, 7u)", "hn_ping_pong(p, 6, 2.0, 0.5, 2.0, 7u)",
    "hn_warp(p, 6, 2.0f, 0.5f, 0.25f, 7u).x",
    "hn_curl(p, 7u).x", "hn_gradient(c, 7u).x", "hn_cell(c, 3, 64).x", "hn_perlin(hn_place(c, 3, 64), 7u)",
    "float(hn_hash(uvec2(3u, 4u)))", "hn_unorm(7u)", "hn_mean(hn_octaves(p, 6, 2.0, 0.5, 7u))",
    "hn_mean(hn_octaves(p, 2.5f, 2.0f, 0.5f, 7u))", "hn_mean(hn_octaves(hn_tile(x, 4), 6, 2.0f, 0.5f, 7u))",
)
# C++ would convert a number, and GLSL does not.
WRONG = (
    "hn_fbm(p, 2.5f, 2.0f, .5f)", "hn_fbm(p, 2.5, 2.0, .5)", "hn_fbm(x, 2.5f, 2.0f, .5f)",
    "hn_fbm(vec4(x), 2.5f, 2.0f, .5f)", "hn_fbm(p, .1f, 3, 2.0f, .5f)", "hn_fbm(p, .1, 3, 2.0, .5)",
    "hn_fbm(vec3(x), .1f, 3, 2.0f, .5f)", "hn_fbm(p, 6, 2, .5f)", "hn_fbm(p, 6, 2.0f, .5f, 7)",
    "hn_fbm(p, 6u, 2.0f, .5f)", "hn_fbm(hn_place(c, p), 2.5f, 2.0f, .5f, 7u)", "hn_fbm(hn_tile(p, ivec2(4)), 6.0f, 2.0f, .5f, 7u)",
    "hn_ridged(p, 2.5f, 2.0f, .5f)", "hn_warp(p, 2.5f, 2.0f, .5f, 1.0f, 7u).x", "hn_warp(p, 6, 2.0f, .5f, 7u).x",
    "hn_ping_pong(p, 6, 2.0f, .5f, 2.0f)", "hn_perlin(x, 16)", "hn_perlin(0.5, 16)",
    "hn_perlin(d, 16)", "hn_perlin(x, octaves)", "hn_perlin(p, 16)", "hn_perlin(p, 16.0f)", "hn_perlin(vec3(x), 16)",
    "hn_perlin(vec4(x), 16)", "hn_perlin(hn_place(3, p.x), 7)", "hn_perlin(x, 16u, 7u)", "hn_perlin(p, 1, 7u)",
    "hn_perlin(x, 7ul)", "hn_perlin(x, true)", "hn_perlin(3)", "hn_perlin(hn_place(c, p), 7)", "hn_perlin(hn_tile(x, 16.0f), 7u)", "hn_perlin(hn_tile(x, 16u), 7u)", "hn_cellular(p, 7).x",
    "hn_cellular(p, 1, 3, 7u).x", "hn_cellular_three(p, 1.0f, 3.0f, 7u).x", "hn_hash(7)", "hn_unorm(1)",
    "hn_gradient(c, 7).x",
)
CALLS = """
#include <hashnoise/hashnoise.hpp>
using namespace hashnoise;
float all_of_them([[maybe_unused]] float x, [[maybe_unused]] double d, [[maybe_unused]] vec2 p,
                  [[maybe_unused]] ivec2 c, [[maybe_unused]] uint seed, [[maybe_unused]] int octaves) {
  float sum = 0.0f;
"""


def calls(which: tuple[str, ...]) -> str:
    """Each on a line of its own."""
    return CALLS + "".join(f"  sum += {call};\n" for call in which) + "  return sum;\n}\n"


def deleted(said: str, which: tuple[str, ...]) -> list[str]:
    """The calls of which a compiler says that they are deleted."""
    first = CALLS.count("\n") + 1
    lines = re.findall(r"^<stdin>:(\d+):\d+: error: (?:use of|call to) deleted function", said, re.M)
    return [which[line - first] for line in sorted({int(line) for line in lines})]


def public_functions() -> list[str]:
    """The functions that the text of the library has for users."""
    text = "\n".join(file.read_text(encoding="ascii") for file in sorted((ROOT / "glsl" / "hashnoise").glob("*.glsl")))
    named = re.findall(r"^HN_FN \w+ (hn_\w+)\(", text, re.M) + re.findall(r"^HN_\w+[1-4]D\((hn_\w+), ", text, re.M)
    return sorted({name for name in named if not name.startswith("hn_i_")})


# Vectors of lanes take no number of another type either: their constructors are explicit.
LANES = """
#include <hashnoise/{first}.hpp>
#include <hashnoise/{second}.hpp>
namespace lanes = hashnoise::lanes;
using lanes::vec2, lanes::Float, lanes::Uint;
template <typename... T>
concept Fbm = requires(T... arguments) {{ hn_fbm(arguments...); }};
template <typename... T>
concept Perlin = requires(T... arguments) {{ hn_perlin(arguments...); }};
static_assert(Fbm<vec2, int, float, float> && Fbm<vec2, int, float, float, unsigned>);
static_assert(Fbm<vec2, float, float, float, unsigned> && Fbm<vec2, float, int, float, float, unsigned>);
static_assert(Perlin<Float, unsigned> && Perlin<vec2, Uint> && Perlin<lanes::hn_place1, unsigned>);
static_assert(!Fbm<vec2, float, float, float> && !Fbm<vec2, float, int, float, float> && !Fbm<vec2, int, int, float>);
static_assert(!Perlin<Float, int> && !Perlin<vec2, int> && !Perlin<vec2, float> && !Perlin<lanes::hn_place1, int>);
"""


def including(header: str) -> str:
    return f"#include <hashnoise/{header}>\n"


def says(compiler: str, text: str, *options: str) -> str:
    """What a compiler says of the text; nothing if it takes it without a warning."""
    command = [compiler, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-I", str(INCLUDE), *options, "-x", "c++", "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=False).stderr


class Headers(unittest.TestCase):
    def test_an_older_language_is_refused_by_its_name(self) -> None:
        for compiler in COMPILERS:
            for header in HEADERS:
                with self.subTest(compiler=compiler, header=header):
                    errors = [line for line in says(compiler, including(header), "-std=c++17").splitlines()
                              if "error:" in line]
                    self.assertIn("hashnoise needs C++20: compile with -std=c++20", errors[0])
                    self.assertEqual(says(compiler, including(header), "-std=c++20"), "")

    def test_the_version_that_msvc_tells_counts(self) -> None:
        for version, refused in (("201703L", True), ("202002L", False)):
            said = says(COMPILERS[0], including("glsl.hpp"), "-std=c++17", f"-D_MSVC_LANG={version}")
            self.assertEqual("hashnoise needs C++20" in said, refused, version)

    def test_sums_over_several_noises_live_in_one_file(self) -> None:
        for compiler in COMPILERS:
            for arithmetic in ARITHMETICS:
                with self.subTest(compiler=compiler, arithmetic=arithmetic):
                    setting = ("-std=c++20", f"-DHN_ARITHMETIC={arithmetic}")
                    self.assertEqual(says(compiler, including("hashnoise.hpp") + SUMS, *setting), "")

    def test_calls_with_the_types_of_glsl_are_taken(self) -> None:
        for compiler in COMPILERS:  # types are the same in every arithmetic
            with self.subTest(compiler=compiler):
                self.assertEqual(says(compiler, calls(RIGHT), "-std=c++20"), "")

    def test_calls_that_glsl_refuses_are_deleted(self) -> None:
        right_and_wrong = (*WRONG, "hn_mean(hn_octaves(p, 6, 2, .5f, 7u))", *RIGHT[:3])
        for compiler in COMPILERS:
            with self.subTest(compiler=compiler):
                all_errors = ("-ferror-limit=0",) if "clang" in Path(compiler).name else ()
                said = says(compiler, calls(right_and_wrong), "-std=c++20", *all_errors)
                self.assertEqual(deleted(said, right_and_wrong), list(right_and_wrong[:-3]))

    def test_every_function_has_deleted_calls(self) -> None:
        functions = public_functions()
        self.assertTrue({"hn_perlin", "hn_fbm", "hn_warp_progressive", "hn_cell", "hn_hash"} <= set(functions))
        wrong = tuple(f"float({function}(true))" for function in functions)
        said = says(COMPILERS[0], calls((*wrong, "float(hn_i_mix(true))")), "-std=c++20")
        self.assertEqual(deleted(said, (*wrong, "a function that is not among them")), list(wrong))

    def test_lanes_take_no_other_numbers_either(self) -> None:
        for compiler in COMPILERS:
            for first, second in (("lanes", "hashnoise"), ("hashnoise", "lanes")):
                with self.subTest(compiler=compiler, first=first, second=second):
                    self.assertEqual(says(compiler, LANES.format(first=first, second=second), "-std=c++20"), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
