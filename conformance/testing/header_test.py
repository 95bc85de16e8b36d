"""Tests what compilers print about the headers where a user goes wrong, and beside what a program has already: the
macros of others, their functions, their warnings. python3 header_test.py [--thorough] COMPILER...

With --thorough all headers are compiled behind the real windows.h of MinGW-w64 and X11's, too.
"""

from __future__ import annotations

import itertools
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
INCLUDE = ROOT / "include"
GLSL = ROOT / "glsl" / "hashnoise"
THOROUGH = "--thorough" in sys.argv
COMPILERS = [argument for argument in sys.argv[1:] if argument != "--thorough"]
PUBLIC = sorted(path.name for path in (INCLUDE / "hashnoise").glob("*.hpp"))
HEADERS = ("hashnoise.hpp", "glsl.hpp")
ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
HASHES = ("FNV1", "PARTIAL_FNV1", "JENKINS", "PARTIAL_JENKINS", "MURMUR", "PCG", "XXHASH32", "CUSTOM")
WIDTHS = ("x86-64-v4", "x86-64", "x86-64-v3", "x86-64-v2")  # of instructions
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
    """The calls that a compiler refuses, with the hint in the line of the error."""
    first = CALLS.count("\n") + 1
    lines = re.findall(r"^<stdin>:(\d+):\d+: error: .*\bwrite 16u for a seed, 6 for octaves, 2\.0f for other numbers",
                       said, re.M)
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


# Macros that programs have before an include of ours, as their headers define them.
MACROS = {
    "windows.h": """near;far;min(a,b) (((a)<(b))?(a):(b));max(a,b) (((a)>(b))?(a):(b));small char;hyper long
        interface struct;pascal;cdecl;IN;OUT;OPTIONAL;ERROR 0;DELETE 0x00010000L;CONST const;VOID void;TRUE 1;FALSE 0""",
    "X11": """None 0L;Bool int;Status int;Success 0;True 1;False 0;Always 2;Above 0;Below 1;Complex 0;Convex 2;Nonconvex 1
        Unsorted 0;CursorShape 0;KeyPress 2;FocusIn 9;Opposite 4""",
    "Arduino.h": """min(a,b) ((a)<(b)?(a):(b));max(a,b) ((a)>(b)?(a):(b));abs(x) ((x)>0?(x):-(x));sq(x) ((x)*(x))
        round(x) ((x)>=0?(long)((x)+0.5):(long)((x)-0.5));radians(deg) ((deg)*0.01745);degrees(rad) ((rad)*57.2957)
        constrain(a,l,h) ((a)<(l)?(l):((a)>(h)?(h):(a)));bit(b) (1UL<<(b));bitRead(value,bit) (((value)>>(bit))&1)
        lowByte(w) ((unsigned char)((w)&0xff));highByte(w) ((unsigned char)((w)>>8));PI 3.14;HALF_PI 1.57;TWO_PI 6.28
        DEG_TO_RAD 0.017;RAD_TO_DEG 57.29;EULER 2.718;F(text) (text);B0 0;B1 1;B10 2;HIGH 1;LOW 0;INPUT 0;DEFAULT 1""",
    "Cocoa": """nil nullptr;Nil nullptr;YES true;NO false;check(x) ((void)(x));verify(x) ((void)(x));NSUInteger unsigned
        require(x,y) ((void)(x));MIN(a,b) ((a)<(b)?(a):(b));MAX(a,b) ((a)>(b)?(a):(b));ABS(a) (a);I 1.0fi""",
}


def defined(names: str) -> str:
    return "".join(f"#define {name.strip()}\n" for name in names.replace("\n", ";").split(";"))


def still_there(text: str) -> str:
    """Asks whether each macro that a text defines is still one."""
    return "".join(f"#ifndef {name}\n#error {name} is lost\n#endif\n" for name in re.findall(r"^#define (\w+)", text, re.M))


# The calls of a program: they instantiate the templates.
CALLED = """
inline hashnoise::Range called(std::span<float> values, float x) {
  namespace lanes = hashnoise::lanes;
  const hashnoise::vec3 p(x, x, x);
  values[0] = hashnoise::hn_fbm(p, 6, 2.0f, 0.5f, 7u) + hashnoise::hn_cellular(p, 7u).x + hashnoise::hn_simplex_d(p, 7u).x +
              hashnoise::hn_clouds(hashnoise::vec3(hashnoise::ivec2(1, 2), 3.5f), 5, 2.0f, 0.5f, 7u) +
              hashnoise::hn_position(hashnoise::hn_tile(hashnoise::vec4(x), hashnoise::ivec4(2))).x;
  lanes::fill(hashnoise::Grid<2>{{x, x}, {x, x}, {8, 8}}, values, [](lanes::vec2 q) { return lanes::hn_simplex(q, 7u); });
  return lanes::fill(hashnoise::CellGrid<2>{{1, 2}, {0.0f, 0.0f}, {0.5, 0.5}, {8, 8}}, values,
                     [](lanes::ivec2 cell, lanes::vec2 f) { return lanes::hn_fbm(lanes::hn_place(cell, f), 6, 2.0f, 0.5f, 7u); });
}
"""


def including(header: str) -> str:
    return f"#include <hashnoise/{header}>\n"


def some(choices: Iterable[str], turn: int) -> list[str]:
    """One of them, another with each turn; in a thorough run all."""
    every = list(choices)
    return every if THOROUGH else [every[turn % len(every)]]


def some_compilers(turn: int) -> list[str]:
    return some(COMPILERS, turn)


def all_headers() -> str:
    return "".join(map(including, PUBLIC))


def messages(compiler: str, text: str, *options: str, include: Path = INCLUDE, only: str = "-fsyntax-only") -> str:
    """The compiler's messages on the text; empty if it takes it without a warning."""
    command = [compiler, only, "-Wall", "-Wextra", "-Werror", "-I", str(include), *options, "-x", "c++", "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=False).stderr


# Two files of a unity build. SECOND is included behind FIRST.
PLAIN = "#include <hashnoise/{header}.hpp>\n"
FIXED = "#undef HN_ARITHMETIC\n#define HN_ARITHMETIC HN_FIXED\n" + PLAIN
KNOBS = {"HN_ARITHMETIC": "HN_FIXED", "HN_HASH": "HN_HASH_JENKINS", "HN_GRADIENT": "HN_GRADIENT_SINE"}
# Functions of C, and of the C++ library, with the literals that people write.
LITERALS = """
#include <math.h>
#include <stdlib.h>
#include <algorithm>
#include <cmath>
#include <hashnoise/hashnoise.hpp>
#include <hashnoise/lanes.hpp>
USING
using namespace hashnoise;
static_assert(std::is_same_v<decltype(floor(1.5)), double> && std::is_same_v<decltype(floor(1.5f)), float>);
static_assert(std::is_same_v<decltype(abs(-3)), int> && std::is_same_v<decltype(abs(-2.5)), double>);
static_assert(std::is_same_v<decltype(abs(-2.5f)), float> && std::is_same_v<decltype(abs(-3L)), long>);
static_assert(std::is_same_v<decltype(sqrt(2.0)), double> && std::is_same_v<decltype(sqrt(2.0f)), float>);
static_assert(std::is_same_v<decltype(trunc(2.5)), double> && std::is_same_v<decltype(trunc(2.5f)), float>);
static_assert(std::is_same_v<decltype(min(1, 2)), int> || std::is_same_v<decltype(min(1, 2)), const int&>);
inline float of_literals(float x) {
  return static_cast<float>(floor(3) + sqrt(4)) + min(x, 2.0f) + max(1.0f, x) + static_cast<float>(max(1u, 2u)) +
         floor(vec2(1.5f, x)).x + hn_perlin(vec2(x, x), 7u) + abs(x);
}
"""
# Functions of users, which have the names of GLSL's, too.
OF_USERS = """
float floor(float x, int digits);
float min(float x, float y);
template <typename T> T max(T x, T y) { return x < y ? y : x; }
int floatBitsToUint(float x);
"""
WARNINGS = ("-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wfloat-equal -Wundef -Wold-style-cast -Wsign-conversion "
            "-Wdouble-promotion -Wcast-qual -Wcast-align -Wextra-semi -Wmissing-declarations -Wunused-macros "
            "-Wzero-as-null-pointer-constant").split()
MORE_WARNINGS = {"g++": ["-Wuseless-cast", "-Wlogical-op", "-Wduplicated-cond", "-Wduplicated-branches", "-Weffc++",
                         "-Wredundant-decls"],
                 "clang++": ["-Weverything", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic", "-Wno-padded"]}


class BesideOthers(unittest.TestCase):
    """Code of a program does not disturb the headers, nor they the program."""

    def compiled(self, compiler: str, text: str, *options: str) -> None:
        self.assertEqual(messages(compiler, text, "-std=c++20", *options), "")

    def test_each_header_stands_behind_the_macros_of_others(self) -> None:
        every = {re.split(r"[ (]", name.strip())[0]: name for names in MACROS.values() for name in re.split("[;\n]", names)}
        macros = defined(";".join(every.values()))
        for turn, header in enumerate(PUBLIC):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, header=header):
                    self.compiled(compiler, macros + including(header) + still_there(macros))

    @unittest.skipUnless(THOROUGH, "takes long: all of them at once stand for these")
    def test_all_headers_stand_behind_the_macros_of_each(self) -> None:
        for of, names in MACROS.items():
            macros = defined(names)
            for compiler in COMPILERS:
                with self.subTest(compiler=compiler, of=of):
                    self.compiled(compiler, macros + all_headers() + CALLED + still_there(macros))

    def test_what_the_standard_headers_define_stays(self) -> None:
        text = all_headers()
        standard = "".join(sorted({line for path in (INCLUDE / "hashnoise").glob("*.hpp")
                                   for line in re.findall(r"^#include <\w+>\n", path.read_text(), re.M)
                                   if line not in ("#include <arm_neon.h>\n", "#include <wasm_simd128.h>\n")}))
        defined_by = []
        for lines in (standard, text):
            done = subprocess.run([COMPILERS[0], "-std=c++20", "-dM", "-E", "-I", str(INCLUDE), "-x", "c++", "-"],
                                  input=lines, capture_output=True, text=True, check=True)
            defined_by.append(set(done.stdout.splitlines()))
        self.assertIn("#include <cmath>\n", standard)
        self.assertEqual(defined_by[0] - defined_by[1], set())

    def test_a_header_without_its_guard_against_macros_is_noticed(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for name in ("include", "glsl"):
                shutil.copytree(ROOT / name, Path(folder, name))
            for file in ("macros_begin.h", "macros_end.h"):
                Path(folder, "glsl", "hashnoise", "detail", file).write_text("")
            text = defined("None 0L") + including("glsl.hpp")
            self.assertEqual(messages(COMPILERS[0], text, "-std=c++20"), "")
            said = messages(COMPILERS[0], text, "-std=c++20", include=Path(folder, "include"))
            self.assertIn("None", said)

    @unittest.skipUnless(THOROUGH, "takes long: windows.h does")
    def test_each_header_stands_behind_the_real_macros(self) -> None:
        windows = "#include <windows.h>\n{}#ifndef near\n#error near is lost\n#endif\n"
        for header in PUBLIC:
            with self.subTest(header=header):
                self.compiled("x86_64-w64-mingw32-g++", windows.format(including(header)))
        for macro in ("NOMINMAX", "WIN32_LEAN_AND_MEAN", "min(a,b)=(((a)<(b))?(a):(b))"):  # which Microsoft's has
            with self.subTest(macro=macro):
                self.compiled("x86_64-w64-mingw32-g++", windows.format(all_headers()), f"-D{macro}")
        of_x11 = "#include <X11/Xlib.h>\n#include <X11/Xutil.h>\n{}#ifndef None\n#error None is lost\n#endif\n"
        self.compiled(COMPILERS[0], of_x11.format(all_headers()))

    def test_functions_of_others_come_first(self) -> None:
        for turn, using in enumerate(("", OF_USERS, "using namespace std;")):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, using=using):
                    self.compiled(compiler, LITERALS.replace("USING", using))

    def test_a_function_that_is_no_template_would_be_ambiguous(self) -> None:
        said = messages(COMPILERS[0], LITERALS.replace("USING", "namespace hashnoise { float floor(float); }"), "-std=c++20")
        self.assertRegex(said, "error: call of overloaded .floor.float.. is ambiguous")

    def test_exceptions_and_types_at_run_time_may_be_off(self) -> None:
        for compiler in some_compilers(1):
            with self.subTest(compiler=compiler):
                self.compiled(compiler, all_headers(), "-fno-exceptions", "-fno-rtti")

    def test_without_exceptions_a_wrong_size_ends_the_program(self) -> None:
        text = (including("grid.hpp") + "int main() { float n[3]; hashnoise::lanes::fill(hashnoise::Grid<1>{{0}, {1}, {2}}, n, "
                "[](hashnoise::lanes::Float x) { return x; }); }\n")
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder, "program")
            for flag, said in (("-fno-exceptions", "hashnoise: fill: "), ("-fexceptions", "std::invalid_argument")):
                subprocess.run([COMPILERS[0], "-std=c++20", flag, "-I", str(INCLUDE), "-x", "c++", "-", "-o", str(program)],
                               input=text, text=True, check=True)
                done = subprocess.run([program], capture_output=True, text=True, check=False)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(said, done.stderr)
                self.assertIn("the size of the values", done.stderr)

    def test_no_header_warns(self) -> None:
        rows = [(*row, "LATTICE") for row in itertools.product(ARITHMETICS, ("OCTAHEDRAL", "SINE"))]
        # A hash is one line, so with all else at its default one hash beside the default's is enough.
        rows += [("HN_FAST", "OCTAHEDRAL", hashed) for hashed in some(HASHES, 0)]
        for turn, (arithmetic, gradient, hashed) in enumerate(rows):
            knobs = [f"-DHN_ARITHMETIC={arithmetic}", f"-DHN_GRADIENT=HN_GRADIENT_{gradient}", f"-DHN_HASH=HN_HASH_{hashed}"]
            width = [f"-march={WIDTHS[turn // 2 % len(WIDTHS)]}"] if platform.machine() == "x86_64" else []
            for compiler in some_compilers(turn):
                more = MORE_WARNINGS["clang++" if "clang" in Path(compiler).name else "g++"]
                with self.subTest(compiler=compiler, knobs=knobs, width=width):
                    self.compiled(compiler, all_headers() + CALLED, *WARNINGS, *more, *knobs, "-DHN_HASH_FN(k)=(k)", *width)

    def test_floats_of_x87_are_an_error_with_precise(self) -> None:
        text = including("hashnoise.hpp")
        if platform.machine() != "x86_64":
            self.skipTest("this machine has no x87")
        for compiler in (one for one in COMPILERS if "clang" not in Path(one).name):  # Clang has none on x86-64
            for arithmetic, sure in (("HN_FAST", False), ("HN_FIXED", False), ("HN_PRECISE", True)):
                said = messages(compiler, f"#define HN_ARITHMETIC {arithmetic}\n{text}", "-std=c++20", "-mfpmath=387",
                                only="-E")
                self.assertEqual("-mfpmath=sse" in said, sure, (compiler, arithmetic, said))

    def test_a_comparison_of_a_program_warns_as_before(self) -> None:
        said = messages(COMPILERS[0], all_headers() + "inline bool same(float x) { return x == 0.5f; }\n", "-std=c++20", "-Wfloat-equal")
        self.assertEqual(said.count("[-Werror=float-equal]"), 1)


class Unity(unittest.TestCase):
    """Files of one translation unit; each defines its knobs before its include."""

    def said(self, *files: str, options: tuple[str, ...] = ()) -> str:
        return messages(COMPILERS[0], "".join(files), "-std=c++20", *options, only="-E")  # the preprocessor is enough

    def test_other_knobs_than_those_of_the_text_are_an_error(self) -> None:
        for turn, (first, second) in enumerate(itertools.product(("hashnoise", "lanes", "grid"), repeat=2)):
            for knob in some(KNOBS, turn % 3 - turn // 3):  # each with each header
                with self.subTest(first=first, second=second, knob=knob):
                    said = self.said(PLAIN.format(header=first), f"#undef {knob}\n#define {knob} {KNOBS[knob]}\n",
                                     PLAIN.format(header=second))
                    self.assertIn(f"#error {knob} differs from that of the first include of hashnoise", said)
                    self.assertIn(f"give all files of a unity build the same {knob}", said)

    def test_a_file_that_takes_its_knob_back_leaves_no_other_behind(self) -> None:
        said = self.said(FIXED.format(header="hashnoise"), "#undef HN_ARITHMETIC\n", PLAIN.format(header="hashnoise"))
        self.assertIn("HN_ARITHMETIC differs", said)

    def test_the_default_may_be_stated(self) -> None:
        said = self.said(FIXED.format(header="hashnoise"), FIXED.format(header="lanes").replace("FIXED", "FAST"))
        self.assertIn("HN_ARITHMETIC differs", said)

    def test_the_same_knobs_may_be_given_again(self) -> None:
        for compiler in some_compilers(1):
            with self.subTest(compiler=compiler):
                text = "".join(FIXED.format(header=header) for header in ("hashnoise", "lanes", "hashnoise", "grid"))
                self.assertEqual(messages(compiler, text + PLAIN.format(header="grid"), "-std=c++20"), "")
                by_option = "".join(PLAIN.format(header=header) for header in ("lanes", "hashnoise", "grid"))
                again = "#define HN_ARITHMETIC HN_FIXED\n" + PLAIN.format(header="hashnoise")
                for said in (messages(compiler, by_option, "-std=c++20", "-DHN_ARITHMETIC=3", "-DHN_HASH=HN_HASH_PCG", only="-E"),
                             messages(compiler, again + again, "-std=c++20", only="-E")):
                    self.assertEqual(said, "")

    def test_a_wrong_value_is_an_error_behind_the_text_too(self) -> None:
        said = self.said(PLAIN.format(header="hashnoise"), "#undef HN_HASH\n#define HN_HASH 77\n",
                         PLAIN.format(header="hashnoise"))
        self.assertIn("HN_HASH must be one of", said)


# Macros of shaders before an include, in one word or more. Parameters of the library keep their names: octaves, seed.
OF_SHADERS = """near 0.1;far 100.0;PI 3.14159;TAU 6.28318;pi 3.14159;tau 6.28318;E 2.71828;EPS 1e-4;EPSILON 1e-4;time iTime
    resolution iResolution.xy;mouse iMouse;saturate(x) clamp(x,0.,1.);sat(x) clamp(x,0.,1.);lerp mix;lerp3(a,b,c) mix(a,b,c)
    rot(a) mat2(cos(a),sin(a),-sin(a),cos(a));rot2 rot;rotate rot;hash hash12;hash11(p) fract(p);hash12 hash;hash21 hash
    hash22 hash;hash33 hash;noise snoise;fbm fbm4;snoise noise3;fade(t) ((t)*(t));permute mod289;mod289(x) mod(x,289.)
    smooth smoothstep;remap map;map scene;scale 4.0;zoom 2.0;speed 0.5;width 800.0;uv gl_FragCoord.xy;st uv;pos ro;ro pos
    rd dir;dir rd;color vec4(1.);col color;light vec3(1.);camera ro;rand random;random fract;voronoi worley;perlin noise
    simplex noise;turbulence fbm;ridged fbm;frequency 2.0;MAX_STEPS 100;STEPS 100;OCTAVES 6;SEED 7u;SCALE 4.0"""


class Shaders(unittest.TestCase):
    """The text of the library in GLSL, where no macro can be put away."""

    def said(self, macros: str, file: str = "hashnoise.glsl", setting: str = "HN_FAST") -> str:
        text = (f"#version 330\n#extension GL_GOOGLE_include_directive : require\n{macros}#define HN_ARITHMETIC {setting}\n"
                f'#include "hashnoise/{file}"\nout vec4 c;\nvoid main() {{ c = vec4(hn_unorm(7u)); }}\n')
        done = subprocess.run(["glslangValidator", "-l", "--stdin", "-S", "frag", f"-I{GLSL.parent}"], input=text,
                              capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stdout

    def test_the_text_has_no_name_that_shaders_define(self) -> None:
        for setting in ("HN_FAST", "HN_FIXED"):
            with self.subTest(setting=setting):
                self.assertEqual(self.said(defined(OF_SHADERS), setting=setting), "")

    def test_a_name_of_the_text_would_be_noticed(self) -> None:
        self.assertIn("syntax error", self.said(defined("lower 0.1")))
        self.assertIn("syntax error", self.said(defined("octaves 6")))


class Headers(unittest.TestCase):
    def test_an_older_language_is_refused_by_its_name(self) -> None:
        for turn, header in enumerate(HEADERS):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, header=header):
                    errors = [line for line in messages(compiler, including(header), "-std=c++17").splitlines()
                              if "error:" in line]
                    self.assertIn("hashnoise needs C++20: compile with -std=c++20", errors[0])
                    self.assertEqual(messages(compiler, including(header), "-std=c++20"), "")

    def test_the_version_that_msvc_tells_counts(self) -> None:
        for version, refused in (("201703L", True), ("202002L", False)):
            said = messages(COMPILERS[0], including("glsl.hpp"), "-std=c++17", f"-D_MSVC_LANG={version}")
            self.assertEqual("hashnoise needs C++20" in said, refused, version)

    def test_nvcc_is_refused_by_name_where_its_front_end_fails(self) -> None:
        for cuda in (("-D__CUDACC__",), ()):  # nvcc passes .cpp files on
            said = messages(COMPILERS[0], including("grid.hpp"), "-std=c++20", "-D__NVCC__", *cuda, only="-E")
            self.assertEqual("include them in a .cpp file" in said, bool(cuda))

    def test_sums_over_several_noises_live_in_one_file(self) -> None:
        for turn, arithmetic in enumerate(ARITHMETICS):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, arithmetic=arithmetic):
                    setting = ("-std=c++20", f"-DHN_ARITHMETIC={arithmetic}")
                    self.assertEqual(messages(compiler, including("hashnoise.hpp") + SUMS, *setting), "")

    def test_calls_with_the_types_of_glsl_are_taken(self) -> None:
        for compiler in COMPILERS:  # types are the same in every arithmetic
            with self.subTest(compiler=compiler):
                self.assertEqual(messages(compiler, calls(RIGHT), "-std=c++20"), "")

    def test_calls_that_glsl_refuses_are_deleted(self) -> None:
        right_and_wrong = (*WRONG, "hn_mean(hn_octaves(p, 6, 2, .5f, 7u))", *RIGHT[:3])
        for compiler in COMPILERS:
            with self.subTest(compiler=compiler):
                all_errors = ("-ferror-limit=0",) if "clang" in Path(compiler).name else ()
                said = messages(compiler, calls(right_and_wrong), "-std=c++20", *all_errors)
                self.assertEqual(deleted(said, right_and_wrong), list(right_and_wrong[:-3]))

    def test_the_first_line_of_an_error_has_the_cure(self) -> None:
        for turn, call in enumerate(("hn_perlin(p, 16)", "hn_value(vec3(x), 3)", "hn_fbm(p, 6, 2.0, 0.5, 7)")):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, call=call):
                    errors = [line for line in messages(compiler, calls((call,)), "-std=c++20").splitlines() if "error: " in line]
                    self.assertIn("write 16u for a seed", errors[0])
                    self.assertEqual(len(errors), 1)

    def test_a_function_of_the_users_has_deleted_calls_in_any_namespace(self) -> None:
        text = "#include <hashnoise/hashnoise.hpp>\n" + "".join(
            f"{begin}\ninline float other(hashnoise::vec2 p, hashnoise::uint seed) {{ return hn_perlin(p, seed); }}\n"
            f"HN_ONLY_TYPES_OF_GLSL(other)\n{end}\n"
            for begin, end in (("", ""), ("namespace mine { namespace detail {}", "}"), ("namespace hashnoise {", "}")))
        names = ("::other", "mine::other", "hashnoise::other")
        for turn, (seed, wrong) in enumerate((("16u", 0), ("16", len(names)))):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, seed=seed):
                    called = "".join(f"float f{i}(hashnoise::vec2 p) {{ return {name}(p, {seed}); }}\n"
                                     for i, name in enumerate(names))
                    said = messages(compiler, text + called, "-std=c++20")
                    self.assertEqual(len(re.findall(r"error: .*\bwrite 16u for a seed", said)), wrong, said)
                    self.assertEqual(said == "", not wrong)

    def test_every_function_has_deleted_calls(self) -> None:
        functions = public_functions()
        self.assertTrue({"hn_perlin", "hn_fbm", "hn_warp_progressive", "hn_cell", "hn_hash"} <= set(functions))
        wrong = tuple(f"float({function}(true))" for function in functions)
        said = messages(COMPILERS[0], calls((*wrong, "float(hn_i_scramble(true))")), "-std=c++20")
        self.assertEqual(deleted(said, (*wrong, "a function that is not among them")), list(wrong))

    def test_lanes_take_no_other_numbers_either(self) -> None:
        for turn, (first, second) in enumerate((("lanes", "hashnoise"), ("hashnoise", "lanes"))):
            for compiler in some_compilers(turn):
                with self.subTest(compiler=compiler, first=first, second=second):
                    self.assertEqual(messages(compiler, LANES.format(first=first, second=second), "-std=c++20"), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
