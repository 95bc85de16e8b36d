"""A program in C++ that draws points, and writes the library's arguments and results there, for programs in other
languages to be compared with bit by bit."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.twin import compile_program
from translate.parsing.syntax import Function, Parameter
from translate.pick.command import settings
from translate.pick.evaluate import Module
from translate.pick.values import SIZES, scalar_of, vector_of

HEAD = """#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>

#include "hashnoise/hashnoise.hpp"

namespace hashnoise {
// Seldom a NaN or an infinity, which have bits with HN_FIXED alone.
std::optional<float> no_number(unsigned drawn) {
  constexpr float kNoNumbers[] = {NAN, INFINITY, -INFINITY};
  if (HN_ARITHMETIC != HN_FIXED || drawn % 64 != 0) return {};
  return kNoNumbers[drawn / 64 % 3];
}
"""
OTHER_KNOBS = "fast pcg sine"  # in which two functions are compared, in one language
# From where to where settings are drawn: beyond their ranges, too. Others are positions and fractions.
RANGES = {"lacunarity": (0.5, 4), "gain": (0, 1.5), "jitter": (-0.2, 1.2), "detail": (-0.5, 7), "footprint": (0, 0.5),
          "amplitude": (0, 2), "strength": (0, 3), "phase": (-2, 2), "f": (0, 1)}
OCTAVES, METRIC = "(g() % 64 ? int(g() % 9) - 1 : int(g() >> 1))", "int(g() % 3)"


def made(type_: str, component: str) -> str:
    """A scalar or a vector, each component drawn."""
    return component if SIZES[type_] == 1 else f"{type_}({', '.join([component] * SIZES[type_])})"


def place(size: int) -> str:
    """With a period, or without one."""
    cell, fraction = made(vector_of("int", size), "int(g())"), made(vector_of("float", size), "r(0, 1)")
    period = made(vector_of("int", size), "(int(g() % 9) - 1)")
    return f"(g() % 2 ? hn_place({cell}, {fraction}) : hn_tile(hn_place({cell}, {fraction}), {period}))"


def octaves(size: int) -> str:
    """The second octave of a sum at a place or at a position."""
    position = made(vector_of("float", size), "r(-60, 60)")
    settings = f"{OCTAVES}, r(1, 3.5), r(0.1, 0.9), uint(g())"
    return (f"[&] {{ auto o = g() % 2 ? hn_octaves({place(size)}, {settings}) : hn_octaves({position}, {settings}); "
            "hn_add(o, r(-1, 1)); hn_next(o); return o; }()")


def drawn(parameter: Parameter) -> str:
    """The expression of an argument."""
    name, type_ = parameter.at.text, parameter.type
    if of_axes := re.fullmatch(r"hn_(place|octaves|slopes|shifts|flows)(\d)", type_):
        size = int(of_axes[2])
        return {"place": place(size), "octaves": octaves(size), "slopes": f"hn_slopes({octaves(size)})",
                "shifts": f"hn_shifts({octaves(size)}, r(0, 2))", "flows": f"hn_flows({octaves(size)})"}[of_axes[1]]
    if scalar_of(type_) == "float":
        low, high = RANGES.get(name, (-60, 60))
        far = " * (g() % 4 ? 1.0f : 10000.0f)" if name == "p" else ""
        draw = "r" if name == "phase" else "any"  # a phase that is no number has no value
        return made(type_, f"({draw}({low}, {high}){far})")
    return {"octaves": OCTAVES, "metric": METRIC}.get(name) or made(type_, f"{scalar_of(type_)}(g())")


def _drawing(seed: str, body: str, points: int) -> str:
    """A block of the program that does so at points that it draws."""
    return f"""  {{
    std::mt19937 g({seed});
    const auto r = [&g](double a, double b) {{ return float(a + (b - a) * (g() / 4294967296.0)); }};
    [[maybe_unused]] const auto any = [&](double a, double b) {{ return no_number(g()).value_or(r(a, b)); }};
    for (int i = 0; i < {points}; i++) {{
      {body}
    }}
  }}"""


WORDS = """
FILE* inputs;
FILE* outputs;
void put(FILE* file, uint word) { std::fwrite(&word, sizeof word, 1, file); }
void put(FILE* file, float value) { put(file, std::bit_cast<uint>(value)); }
void put(FILE* file, int value) { put(file, uint(value)); }
void put(FILE* file, bool value) { put(file, uint(value)); }
"""


def words_source(module: Module, functions: Mapping[str, Function], points: int) -> str:
    """A program that draws points and writes two files that its arguments name: the words of the arguments of each
    function at each point, and of its results. `module` is split: a vector is its components. A
    third argument is a number, and each has other points."""
    lines = [HEAD, "}  // namespace hashnoise\nusing namespace hashnoise;", WORDS, "int main(int count, char** names) {",
             "  const uint seed = count > 3 ? uint(std::atoi(names[3])) << 8u : 0u;",
             '  inputs = std::fopen(names[1], "wb");', '  outputs = std::fopen(names[2], "wb");']
    for number, function in enumerate(functions.values()):
        body: list[str] = []
        behind: list[str] = []
        for parameter in function.parameters:
            variable = f"v_{parameter.at.text}"
            is_read = bool(module.passed(parameter))
            body.append(f"{parameter.type} {variable}{f' = {drawn(parameter)}' if is_read else '{}'};")
            puts = [f"put({{}}, {variable}{_path(path)});" for path, _ in module.parts(parameter.type)]
            body += [put.format("inputs") for put in puts if is_read]
            behind += [put.format("outputs") for put in puts if parameter.is_set]
        call = f"{function.name}({', '.join(f'v_{parameter.at.text}' for parameter in function.parameters)})"
        body.append(f"{call};" if function.type == "void" else f"const auto result = {call};")
        if function.type != "void":
            body += [f"put(outputs, result{_path(path)});" for path, _ in module.parts(function.type)]
        lines.append(_drawing(f"seed + {number}u", "\n      ".join([*body, *behind]), points))
    return "\n".join([*lines, "  std::fclose(inputs);", "  std::fclose(outputs);", "}", ""])


def compile_words(module: Module, functions: Mapping[str, Function], points: int, knobs: str, program: Path,
                  *options: str) -> None:
    """Makes that program, beside its source. The knobs are an arithmetic, or an arithmetic, a hash and a gradient."""
    source = program.with_suffix(".cpp")
    source.write_text(words_source(module, functions, points), encoding="ascii")
    macros = [f"{name}={value}" for name, value in settings(*knobs.split()).items()]
    compile_program("the program that draws points", source, program, *options, macros=macros)


def _path(path: Sequence[str]) -> str:
    return "".join(f".{part.removeprefix('_')}" for part in path)
