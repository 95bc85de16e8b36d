"""tools/pick's text in languages without vectors has the bits of the library in C++.

    python3 -m translate.pick.languages_test points FOLDER           the arguments, and the results in C++
    python3 -m translate.pick.languages_test LANGUAGE FOLDER         compiles and compares

Exit status of the second: 0 the same, 1 not, 77 the compiler is not installed.
"""

from __future__ import annotations

import functools
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Sequence
from pathlib import Path

from base.testing import skipped_without
from base.thorough import THOROUGH
from base.tree import GLSL, ROOT
from base.twin import compile_program
from translate.parsing.syntax import Function
from translate.pick import command, own_loops
from translate.pick.comparison import OTHER_KNOBS, compile_words
from translate.pick.evaluate import Module
from translate.pick.gdscript_runner import GDScriptRunner
from translate.pick.osl_runner import OslRunner
from translate.pick.program import Program, chosen, read
from translate.pick.runners import (
    ARRAYS,
    RUNNERS,
    Case,
    CRunner,
    JavaRunner,
    JaxRunner,
    NotRun,
    OpenClRunner,
    Runner,
    ran,
    written_to,
)
from translate.pick.scalars import Piece, Syntax, text

POINTS = 200
# Functions with most of the constructs that languages write differently: vectors that are returned or set, structs,
# loops (one ends when it may). Each arithmetic has two of them or three.
SPECIAL = ("hn_next2", "hn_fbm2", "hn_cellular2_nearest", "hn_cell_border2_nearest", "hn_tile2", "hn_fbm_d2",
           "hn_shuffle")

ALL_RUNNERS = {**RUNNERS, "osl": OslRunner, "opencl": OpenClRunner, **ARRAYS, "gdscript": GDScriptRunner}
# Changes of the one text in C that some compiler refuses.
REFUSED = (("__host__ __device__ inline", "inline"), ("#if defined(__OPENCL_VERSION__) ||", "#if 0 &&"),
           ("uint32_t seed)", "uint32_t or)"), ("{\n  hn_vec2 made = {x, y};\n  return made;", "{\n  return (hn_vec2){x, y};"))
# Functions with slopes of their own, which JAX finds as well.
SLOPES = ("perlin2", "cellular2", "perlin4", *(("value2", "simplex2", "simplex4", "fbm2") if THOROUGH else ()))
# By how much a sum differs below jit from what it is without, for less than 1000 cells, and slopes from the library's, at
# positions where one in two is whole.
JIT = """import sys
import jax
import numpy
import fused
import noise
drawn = numpy.random.default_rng(7).uniform(-1000, 1000, (4, 100_000)).astype("f4")
known = noise.fbm3(*drawn[:3], 6, 2.0, 0.5, 7)
for text in noise, fused:
    print(abs(known - jax.jit(text.fbm3, static_argnums=3)(*drawn[:3], 6, 2.0, 0.5, 7)).max())
near = numpy.where(numpy.arange(100_000) % 2, drawn / 100, numpy.round(drawn / 100))
for name in sys.argv[1:]:
    axes, settings = int(name[-1]), (6, 2.0, 0.5, 7) if name == "fbm2" else (7,)
    value = lambda *p: jax.tree.leaves(getattr(noise, name)(*p, *settings))[0]
    found = jax.jit(jax.vmap(jax.grad(value, tuple(range(axes)))))(*near[:axes])
    for one, other in zip(found, getattr(noise, f"{name[:-1]}_d{axes}")(*near[:axes], *settings)[1:]):
        print(abs(one - other).max())
"""
TOGETHER = ("hn_perlin2", "hn_value3_place", "hn_tile3")  # in one text
PAGE = (ROOT / "docs" / "guide" / "same-bits.md").read_text(encoding="utf-8")
# A program that prints the height of the page, and the commands that build and run it.
SERVERS = {
    "go": ({"go.mod": "module game\n\ngo 1.18\n",
            "main.go": 'package main\n\nimport (\n\t"game/hashnoise"\n\t"fmt"\n)\n\nfunc main() {\n'
                       '\tvar x, y float32 = 37, -5\n\tfmt.Printf("%.9g", CALL)\n}\n'}, "go run ."),
    "rust": ({"src/main.rs": 'mod hashnoise;\nfn main() { let (x, y) = (37f32, -5f32); print!("{:?}", CALL); }\n'},
             "rustc --edition 2021 -A dead_code src/main.rs", "./main"),
    "java": ({"Server.java": "class Server { public static void main(String[] a) { float x = 37, y = -5; "
                             "System.out.print(CALL); } }\n"}, "javac HashNoise.java Server.java", "java Server"),
    "csharp": ({"Server.cs": 'class Server { static void Main() { float x = 37, y = -5; System.Console.Write((CALL)'
                             '.ToString("R")); } }\n'}, "mcs HashNoise.cs Server.cs", "mono HashNoise.exe"),
    "c": ({"server.c": '#include "hashnoise.h"\n#include <stdio.h>\nint main(void) { float x = 37, y = -5; '
                       'return printf("%.9g", (double)CALL) < 0; }\n'}, "gcc server.c -lm -o server", "./server"),
    "javascript": ({"server.mjs": 'import { fbm2 } from "./hashnoise.mjs";\nconst [x, y] = [37, -5];\nconsole.log(CALL);\n'},
                   "node server.mjs"),
    "gdscript": ({"project.godot": "config_version=5\n",
                  "server.gd": 'extends SceneTree\nconst HashNoise := preload("hashnoise.gd")\nfunc _init() -> void:\n'
                               '\tvar x := 37.0\n\tvar y := -5.0\n\tprint("%.12f" % CALL)\n\tquit()\n'},),
}
# Before the code of the page: it writes the shape's heights, and prints their time.
HEIGHTS = """extends SceneTree

func _init() -> void:
	var begin := Time.get_ticks_usec()
	var shape := shape_of(Vector2i(-24, 8), 64)
	print((Time.get_ticks_usec() - begin) * 1000 / 4096, " ns")
	FileAccess.open("res://found", FileAccess.WRITE).store_buffer(shape.map_data.to_byte_array())
	quit()

"""
HEIGHTS_IN_CPP = """#include <hashnoise/hashnoise.hpp>
#include <chrono>
#include <cstdio>
using namespace hashnoise;
int main() {
  static float heights[64 * 64];
  const auto begin = std::chrono::steady_clock::now();
  for (int turn = 0; turn < 100; turn++)
    for (int i = 0; i < 64 * 64; i++)
      heights[i] = hn_fbm(vec2(float(i % 64 - 24), float(i / 64 + 8)) * 0.125f, 6, 2.0f, 0.5f, 7u);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
  std::printf("%.1f", taken.count() / 409600);
  return std::fwrite(heights, sizeof heights, 1, std::fopen("right", "wb")) != 1;
}
"""


@functools.cache
def module(arithmetic: str, syntax: type[Syntax] = Syntax) -> Module:
    return read(GLSL, {**command.settings(*arithmetic.split()), **syntax.library}, splits=True)


def functions(of: Module, arithmetic: str) -> dict[str, Function]:
    """By default some, in each arithmetic others."""
    known = of.forms
    if arithmetic == OTHER_KNOBS:
        return {name: known[name] for name in ("hn_perlin2", "hn_cellular3_jitter")}
    turn = command.ARITHMETICS.index(arithmetic)
    names = list(known) if THOROUGH else [TOGETHER[0], *SPECIAL[turn::3], *list(known)[turn * 48::144]]
    return {name: known[name] for name in dict.fromkeys(names)}


def drawn(of: Module, arithmetic: str) -> dict[str, Function]:
    """Functions that have points: all with integers, for the text of all of them."""
    return of.forms if arithmetic == "fixed" else functions(of, arithmetic)


def write_points(folder: Path) -> None:
    """The functions' arguments and results, for each arithmetic."""
    folder.mkdir(parents=True, exist_ok=True)
    for arithmetic in (*command.ARITHMETICS, OTHER_KNOBS):
        of = module(arithmetic)
        program = folder / arithmetic
        compile_words(of, drawn(of, arithmetic), POINTS, arithmetic, program, "-O0", "-Dalways_inline=unused")
        subprocess.run([program, f"{program}.in", f"{program}.out"], check=True)


def counts(of: Module, function: Function) -> tuple[int, int]:
    """How many words are passed at a point, and how many come back."""
    passed = sum(len(of.parts(one.type)) for one in function.parameters if of.passed(one))
    back = sum(len(of.parts(one.type)) for one in function.parameters if one.is_set)
    return passed, back + (len(of.parts(function.type)) if function.type != "void" else 0)


def words(folder: Path, arithmetic: str, of: Module) -> dict[str, tuple[bytes, bytes]]:
    """The arguments of each function at all points, and its results."""
    inputs, outputs = (Path(f"{folder / arithmetic}.{end}").read_bytes() for end in ("in", "out"))
    found: dict[str, tuple[bytes, bytes]] = {}
    at = [0, 0]
    for name, function in drawn(of, arithmetic).items():
        ends = [start + 4 * POINTS * count for start, count in zip(at, counts(of, function))]
        found[name] = inputs[at[0]:ends[0]], outputs[at[1]:ends[1]]
        at = ends
    return found


class Language(unittest.TestCase):
    runner: Runner
    folder: Path

    def differing(self, arithmetic: str, of: Module, texts: Sequence[tuple[str, str]]) -> list[str]:
        """How each text of a function differs from the library; nothing if it does not."""
        known, drawn_words = of.forms, words(self.folder, arithmetic, of)
        given, expected, points = {}, {}, {}
        for name in dict.fromkeys(name for name, _ in texts):
            rows, results = ([one[i:i + len(one) // POINTS] for i in range(0, len(one), len(one) // POINTS)]
                             for one in drawn_words[name])
            taken = self.runner.few(of, known[name], rows)
            given[name], expected[name] = (b"".join(one[i] for i in taken) for one in (rows, results))
            points[name] = len(taken)
        cases = [Case(known[name], shown, points[name]) for name, shown in texts]
        with tempfile.TemporaryDirectory() as folder:
            found = self.runner.run(cases, of, b"".join(given[name] for name, _ in texts), Path(folder))
        self.assertEqual(len(found), sum(len(expected[name]) for name, _ in texts))
        differences: list[str] = []
        for name, _ in texts:
            back = expected[name]
            differences.append(difference(known[name], back, found[:len(back)], points[name]))
            found = found[len(back):]
        return [f"{name}: {shown}" if shown else "" for (name, _), shown in zip(texts, differences)]

    def arithmetics(self) -> Sequence[str]:
        """By default integers, and floats that are precise or not, in turn from language to language."""
        turn = list(ALL_RUNNERS.values()).index(type(self.runner))
        known = self.runner.arithmetics
        some = ("fixed", "precise" if turn % 2 and "precise" in known else "fast")
        return known if THOROUGH else [one for one in some if one in known]

    def text(self, arithmetic: str, of: Module, *names: str, syntax: type[Syntax] | None = None) -> str:
        return text(Program(of, chosen(of, names)), self.syntax(arithmetic, syntax or self.runner.syntax))

    @staticmethod
    def syntax(arithmetic: str, of: type[Syntax]) -> Syntax:
        made = of(arithmetic == "precise")
        made.is_fixed = arithmetic == "fixed"
        return made

    def whole(self, arithmetic: str, of: Module) -> list[tuple[str, str]]:
        """All functions that have points, in one text."""
        names = drawn(of, arithmetic)
        shown = text(Program(of, chosen(of, names), calls_first=True), self.syntax(arithmetic, self.runner.syntax))
        return [(name, shown) for name in names]

    def test_the_bits_are_those_of_the_library(self) -> None:
        for arithmetic in self.arithmetics():
            of = module(arithmetic, self.runner.syntax)
            if self.runner.whole and (THOROUGH or arithmetic == "fixed"):
                texts = self.whole(arithmetic, of)
                self.lint(texts[0][1])
            else:
                texts = [(name, self.text(arithmetic, of, name)) for name in self.runner.only or functions(of, arithmetic)]
                texts += [(TOGETHER[0], self.text(arithmetic, of, *TOGETHER))]
            with self.subTest(arithmetic=arithmetic):
                self.assertGreater(len(texts), 5)
                self.assertEqual("\n".join(filter(None, self.differing(arithmetic, of, texts))), "")

    def lint(self, shown: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            self.runner.lint([shown], Path(folder))

    def test_compilers_of_all_languages_take_the_text_of_c(self) -> None:
        if not isinstance(self.runner, OpenClRunner):
            return
        of = module("fast")
        self.lint(text(Program(of, chosen(of, of.forms), calls_first=True), self.runner.syntax()))
        right = self.text("fast", of, "hn_cellular2")
        self.lint(right)
        for old, new in REFUSED:
            with self.subTest(old):
                self.assertIn(old, right)
                with self.assertRaises(NotRun):
                    self.lint(right.replace(old, new))

    def test_below_jit_floats_and_slopes_are_within_their_bounds(self) -> None:
        """And floats of a text in which XLA fuses positions are not."""
        if type(self.runner) is not JaxRunner:
            return
        of = module("fast", self.runner.syntax)
        shown = self.text("fast", of, *(f"hn_{name[:-1]}{d}{name[-1]}" for name in SLOPES for d in ("", "_d")), "hn_fbm3")
        fused = shown.replace("return xp.where(x == x, x, x + x) if fuses else x", "return x")
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            written_to(folder, {"noise.py": shown, "fused.py": fused, "jit.py": JIT})
            values, of_fused, *slopes = map(float, ran(folder, *self.runner.python(), "jit.py", *SLOPES).split())
        self.assertLess(values, 3e-7)
        self.assertGreater(of_fused, 1e-4)
        self.assertLess(max(slopes), 4e-6)  # no NaN is

    def test_gcc_vectorizes_a_loop_with_the_options_of_the_text(self) -> None:
        if type(self.runner) is not CRunner:
            return
        of = module("fast")
        for name, call in (("hn_perlin2", "x[i], y[i], 7u"), ("hn_simplex3", "x[i], y[i], x[i], 7u"),
                           ("hn_value_cubic2", "x[i], y[i], 7u")):
            shown = self.text("fast", of, name)
            options = re.search(r"-O3 [\w= -]+", shown)[0].split()
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                written_to(Path(folder), {
                    "loop.c": f"{shown}void loop(const float *restrict x, const float *restrict y, float *restrict out, "
                              f"int n) {{ for (int i = 0; i < n; i++) out[i] = {name}({call}); }}\n"})
                for more, is_found in (("-ftree-vectorize", True), ("-fno-tree-vectorize", False)):
                    ran(Path(folder), "gcc", "-std=c99", *options, more, f"-fopt-info-vec=found{more}", "-c", "loop.c")
                    found = (Path(folder) / f"found{more}").read_text(encoding="ascii")
                    self.assertEqual("loop vectorized" in found, is_found, found)

    def test_a_text_that_is_not_compiled_is_told(self) -> None:
        if not isinstance(self.runner, OslRunner):
            return  # the texts of the others are one program, which is compiled or not
        of = module("fixed", self.runner.syntax)
        right = self.text("fixed", of, "hn_perlin2")
        with self.assertRaisesRegex(NotRun, "1.osl is not compiled"):
            self.differing("fixed", of, [("hn_perlin2", right), ("hn_perlin2", right.replace(";", "", 1))])

    def test_the_shader_of_the_page_is_compiled(self) -> None:
        if not isinstance(self.runner, OslRunner):
            return
        page = (ROOT / "docs" / "guide" / "engines.md").read_text(encoding="utf-8")
        names, lines = re.search(r"(?ms)^    hashnoise/tools/pick (\S+) --language osl --out tile\.osl\n\n"
                                 r"(    shader .*?^    \})", page).groups()
        functions = command.picked(command.expanded([names]), command.Choice("osl"))
        shader = re.sub("(?m)^    ", "", lines) + "\n"
        with tempfile.TemporaryDirectory() as folder:
            self.runner.lint([functions + shader], Path(folder))
            with self.assertRaisesRegex(NotRun, "is not compiled"):
                self.runner.lint([functions + shader.replace("hn_tile2(p[0], ", "hn_tile2(")], Path(folder))

    def test_what_the_language_lacks_is_exact(self) -> None:
        if self.runner.exact:
            with tempfile.TemporaryDirectory() as folder:
                self.runner.run_exact(Path(folder))

    def height_in_cpp(self, call: str) -> bytes:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            written_to(folder, {"height.cpp": f"""#include <hashnoise/hashnoise.hpp>
#include <cstdio>
using namespace hashnoise;
int main() {{ float x = 37, y = -5; std::printf("%.9g", {call}); return x == y; }}
"""})
            compile_program("the call of the page", folder / "height.cpp", folder / "height", "-O0",
                            macros=["HN_ARITHMETIC=HN_FIXED"])
            return struct.pack("<f", float(ran(folder, folder / "height")))

    def test_the_program_of_the_page_has_the_bits_of_the_library(self) -> None:
        """And a program with another seed does not."""
        if not isinstance(self.runner, JavaRunner):
            return  # the page has a program in Java
        pick, *build = re.findall(r"(?m)^    ((?:tools/pick|javac?) .*)", PAGE)
        program, = re.findall(r"(?ms)^```java\n(.*?)^```$", PAGE)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            expected = self.height_in_cpp(re.search(r"with the bits of `(hn_fbm\(.*?, 7u\))`", PAGE)[1])
            ran(folder, ROOT / pick.split()[0], *pick.split()[1:])
            for text_, same in ((program, True), (program.replace("0.5f, 7)", "0.5f, 8)"), False)):
                written_to(folder, {"Server.java": text_})
                *_, shown = [ran(folder, *line.split()) for line in build]
                self.assertEqual(struct.pack("<f", float(shown)) == expected, same, shown)

    def test_the_server_of_the_page_has_the_bits_of_the_shader(self) -> None:
        language = next(name for name, runner in ALL_RUNNERS.items() if isinstance(self.runner, runner))
        if language not in SERVERS:
            return  # OSL is for no server
        pick = re.search(r"\| `(tools/pick .*?)` with \|", PAGE)[1]
        options, call = re.search(rf"\| `(--language {language} .*?)` \| `(.*?)` \|", PAGE).groups()
        files, *build = SERVERS[language]
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            call_in_glsl, stated = re.search(r"the same height by `(.*?)`; at `x` = 37 and `y` = -5 it is (-[\d.]+)\. ", PAGE).groups()
            expected = self.height_in_cpp(call_in_glsl)
            self.assertEqual(struct.pack("<f", float(stated)), expected)
            ran(folder, ROOT / pick.split()[0], *pick.split()[1:], *options.split())
            written_to(folder, {file: text_.replace("CALL", call) for file, text_ in files.items()})
            *_, shown = [ran(folder, *line.split()) for line in build] or [self.runner.run_script(folder, "server.gd")]
            self.assertEqual(struct.pack("<f", float(shown.split()[-1])), expected)

    def test_the_shape_of_godots_page_has_the_bits_of_the_library(self) -> None:
        """And a shape of another seed does not. The page has its time as a multiple of C++'s."""
        if not isinstance(self.runner, GDScriptRunner):
            return
        page = (ROOT / "docs" / "guide" / "godot.md").read_text(encoding="utf-8")
        pick, block = re.search(r"(?s)\n    (tools/pick \S+ --language gdscript .*?)\n.*?```gdscript\n(.*?)```", page).groups()
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            ran(folder, ROOT / pick.split()[0], *pick.split()[1:])
            written_to(folder, {"heights.cpp": HEIGHTS_IN_CPP, "project.godot": "config_version=5\n"})
            compile_program("heights", folder / "heights.cpp", folder / "heights", macros=["HN_ARITHMETIC=HN_FIXED"])
            ratios: list[float] = []
            for shown, same in ((block, True), (block.replace(", 7)", ", 8)"), False), (block, True)):
                written_to(folder, {"shape.gd": f"{HEIGHTS}{shown}"})
                taken = re.search(r"(\d+) ns", self.runner.run_script(folder, "shape.gd"))
                ratios.append(int(taken[1]) / float(ran(folder, folder / "heights")))
                right, found = ((folder / file).read_bytes() for file in ("right", "found"))
                self.assertEqual(len(found), len(right))
                self.assertEqual(found == right, same)
        print(f"GDScript takes {taken[1]} ns for a height, {' '.join(f'{one:.0f}' for one in ratios)} times as long as C++")
        said = int(re.search(r"(\d+) times as long as C\+\+", page)[1])
        self.assertTrue(said / 3 < sorted(ratios)[1] < said * 3, ratios)

    def test_loops_of_somebody_else_that_ask_before_each_turn(self) -> None:
        of, own = own_loops.module(True), own_loops.cases(True, POINTS)
        cases = [Case(function, text(Program(of, [function]), self.runner.syntax()), POINTS) for function, *_ in own]
        with tempfile.TemporaryDirectory() as folder:
            found = self.runner.run(cases, of, b"".join(given for _, given, _ in own), Path(folder))
        self.assertEqual(found, b"".join(right for *_, right in own))

    def test_a_fault_of_the_printer_is_noticed(self) -> None:
        of = module("fixed", self.runner.syntax)
        texts = [("hn_perlin2", self.text("fixed", of, "hn_perlin2", syntax=faulty(self.runner.syntax, *fault)))
                 for fault in self.runner.faults.items()]
        right = self.text("fixed", of, "hn_perlin2")
        self.assertNotIn(right, [shown for _, shown in texts])
        *wrong, none = self.differing("fixed", of, [*texts, ("hn_perlin2", right)])
        self.assertEqual(none, "")
        for fault, shown in zip(self.runner.faults, wrong):
            with self.subTest(fault):
                self.assertRegex(shown, f"^hn_perlin2: [1-9][0-9]* of {POINTS} ")
        if "unchecked" in right:
            with self.assertRaisesRegex(NotRun, "OverflowException"):
                self.differing("fixed", of, [("hn_perlin2", right.replace("unchecked", ""))])


def faulty(syntax: type[Syntax], of: tuple[str, str], wrong: str) -> type[Syntax]:
    """The language with an operator that is written in another way."""
    class Faulty(syntax):
        def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
            if (type_, sign) == of:
                return Piece(wrong.format(left.text, right.text))
            return super().binary(sign, type_, left, right)
    return Faulty


def difference(function: Function, expected: bytes, found: bytes, points: int) -> str:
    """At how many points the words differ, and how at the first."""
    if expected == found:
        return ""
    size = len(expected) // points
    pairs = [(expected[i:i + size], found[i:i + size]) for i in range(0, len(expected), size)]
    if function.name == "hn_next":  # in C++ it stops before the octave that is none
        pairs = [(a, b) if a[0] else (a[:4], b[:4]) for a, b in pairs]
    wrong = [i for i, (a, b) in enumerate(pairs) if a != b]
    if not wrong:
        return ""
    right, ours = (" ".join(f"{word:08X}" for word, in struct.iter_unpack("<I", one)) for one in pairs[wrong[0]])
    return f"{len(wrong)} of {points} points differ, the first is {wrong[0]}: {ours} where the library has {right}"


if __name__ == "__main__":
    what, where = sys.argv[1], Path(sys.argv[2]).resolve()
    del sys.argv[1:3]
    if what == "points":
        write_points(where)
        sys.exit(0)
    Language.runner, Language.folder = ALL_RUNNERS[what](), where
    with skipped_without():
        Language.runner.check()
    unittest.main(verbosity=2)
