"""Runs modules beside the library in C++ or rows of vectors: Icarus simulates them, or Verilator, which is faster.

A program draws the arguments of a module, the ends of the ranges among it, and prints the library's values.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from base.twin import compile_program
from translate.pick.runners import ran
from translate.pick.values import SIZES
from translate.pick.verilog import FRACTION, REST, FunctionCircuit

SUM = "octaves=4,lacunarity=2,gain=0.5"  # the constants of a sum of octaves
LINT = ("verilator", "--lint-only", "-Wall", "--language", "1364-2005")
LIBRARY = """#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "hashnoise/hashnoise.hpp"
using namespace hashnoise;

int main() {{
  std::FILE* file = std::fopen("points", "w");
  std::mt19937 g(7u);
  auto draw = [&g](long low, long high) {{
    const std::uint32_t kind = g() % 16u;
    if (kind < 2u) return kind == 0u ? low : high;
    if (kind < 4u && low < 0) return long(g() % 7u) - 3;
    const long drawn = long(low + std::int64_t(g()) % (std::int64_t(high) - low + 1));
    return kind == 4u ? drawn & ~0xFFFFL : drawn;
  }};
  for (long i = 0; i < {points}; ++i) {{
    const long v[] = {{{drawn}}};
    std::fprintf(file, "{format}\\n", {read});
    const auto value = {call};
    std::printf("{shown}\\n", {values});
  }}
  return std::fclose(file);
}}
"""
BENCH = """`default_nettype none
module bench;
  integer file, count, at;
  reg clock;
{declared}
  {module} one (.clock(clock), {connected});
  initial begin
    file = $fopen("points", "r");
    clock = 0;
    for (at = 0; at < {points} + {latency}; at = at + 1) begin
      if (at < {points}) count = $fscanf(file, "{format}", {inputs});
      {sets}
      #1 clock = 1;
      #1 clock = 0;
      if (at + 1 >= {latency} && at + 1 < {points} + {latency}) $display("{shown}", {outputs});
    end
  end
endmodule
"""


def simulated(made: FunctionCircuit, text: str, points: int, folder: Path, by_verilator: bool = False) -> list[str]:
    """The results of a module at the points of the file `points`, which has a number for each port that is read."""
    outputs = [port.name for port in made.outputs]
    inputs = [port.name for port in made.read]
    # Verilator 5.006 does not see that $fscanf changes an input.
    of_file = [port._replace(name=f"next_{port.name}") for port in made.read]
    declared = [f"  {kind} {port.declared};" for kind, ports in (("reg", (*of_file, *made.read)), ("wire", made.outputs))
                for port in ports]
    source = BENCH.format(
        declared="\n".join(declared), module=made.name, latency=made.pipeline.latency, points=points,
        connected=", ".join(f".{name}({name})" for name in (*inputs, *outputs)), format=" ".join(["%d"] * len(inputs)),
        inputs=", ".join(port.name for port in of_file), sets=" ".join(f"{name} = next_{name};" for name in inputs), shown=" ".join(["%0d"] * len(outputs)), outputs=", ".join(outputs))
    (folder / "bench.v").write_text(source, encoding="ascii")
    (folder / f"{made.name}.v").write_text(text, encoding="ascii")
    sources = ("bench.v", f"{made.name}.v")
    if by_verilator:
        ran(folder, "verilator", "--binary", "-O3", "-Wno-fatal", "--top-module", "bench", *sources, "--Mdir", "made")
        return ran(folder, folder / "made" / "Vbench").splitlines()
    ran(folder, "iverilog", "-g2005", "-Wall", "-Wno-timescale", "-s", "bench", "-o", "bench.vvp", *sources)
    return ran(folder, "vvp", "-n", "bench.vvp").splitlines()


def at_points(made: FunctionCircuit, text: str, points: Sequence[Sequence[int]], folder: Path, by_verilator: bool) -> list[str]:
    (folder / "points").write_text("".join(f"{' '.join(map(str, point))}\n" for point in points), encoding="ascii")
    return simulated(made, text, len(points), folder, by_verilator)


class Vectors(NamedTuple):
    """Rows of a file of vectors: the numbers of all ports, and the values in their units."""
    points: list[list[int]]
    values: list[list[int]]
    left_out: int  # a fraction of 1 is no fraction of 20 bits, and constants may be others


def vectors(made: FunctionCircuit, file: Path) -> Vectors:
    """The rows with HN_FIXED and the constants of the module."""
    of_file = json.loads(file.read_text(encoding="utf-8"))
    rows = next(one["rows"] for one in of_file["settings"] if one["name"] == "lattice+fixed")
    size = sum(one["name"] in ("cx", "cy", "cz", "cw") for one in of_file["inputs"]) or 1
    names = [one["name"] for one in of_file["inputs"]]
    found = Vectors([], [], 0)
    for row in rows:
        passed = dict(zip(names, row["in"]))
        others = {name: passed[name] for name in names[2 * size:]}
        units = [int(f * (1 << (FRACTION + REST))) for f in row["in"][size:2 * size]]
        if max(units) >> (FRACTION + REST) or any(
                    abs(others[name] - float(value)) > 1e-6 for name, value in made.constants.items()):
            found = found._replace(left_out=found.left_out + 1)
            continue
        numbers = [*row["in"][:size], *(unit >> REST for unit in units)]
        numbers += [unit & ((1 << REST) - 1) for unit in units] if made.has_rest else []
        found.points.append([*numbers, *(value for name, value in others.items() if name not in made.constants)])
        found.values.append(row["units"])
    return found


def of_read(made: FunctionCircuit, points: Sequence[Sequence[int]]) -> list[list[int]]:
    """Points without the numbers of ports that no gate reads."""
    kept = [i for i, port in enumerate(made.ports) if port in made.read]
    return [[point[i] for i in kept] for point in points]


def _vector(kind: str, size: int, parts: Sequence[str]) -> str:
    return parts[0] if size == 1 else f"{kind}{size}({', '.join(parts)})"


def call(made: FunctionCircuit) -> str:
    """The library's value of the numbers `v`, by the order of the ports."""
    at = {port.name: i for i, port in enumerate(made.ports)}
    passed: list[str] = []
    for parameter in made.function.parameters:
        name, type_ = parameter.at.text, parameter.type
        if name in made.constants:
            value = made.constants[name]
            passed.append({"float": f"float({float(value)})" if type_ == "float" else "", "uint": f"{value}u"}.get(type_, value))
        elif found := re.fullmatch("hn_place([1-4])", type_):
            size = int(found[1])
            axes = [f"_{axis}" for axis in "xyzw"[:size]] if size > 1 else [""]
            cells = _vector("ivec", size, [f"int(v[{at[f'cell{axis}']}])" for axis in axes])
            units = [f"v[{at[f'fraction{axis}']}]" + (f" * {1 << REST} + v[{at[f'rest{axis}']}]" if made.has_rest else "")
                     for axis in axes]
            scale = FRACTION + (REST if made.has_rest else 0)
            fractions = _vector("vec", size, [f"float({one}) * {2.0**-scale!r}f" for one in units])
            passed.append(f"hn_place({cells}, {fractions})")
        else:
            size = SIZES[type_]
            names = [name] if size == 1 else [f"{name}_{axis}" for axis in "xyzw"[:size]]
            scalar = {"i": "int", "u": "uint", "b": "bool"}[type_[0]]
            parts = [f"{scalar}(v[{at.get(one, at.get(f'{one}_'))}])" for one in names]
            passed.append(parts[0] if size == 1 else f"{type_}({', '.join(parts)})")
    if made.module.summed:  # fBm of another noise, in the loop that users write
        return (f"[&] {{ auto o = hn_octaves({', '.join(passed)}); do hn_add(o, {made.module.summed.name}(o.place, o.seed)); "
                "while (hn_next(o)); return hn_mean(o); }()")
    return f"{made.function.name}({', '.join(passed)})"


def _values(made: FunctionCircuit) -> list[str]:
    """The library's `value` in the units of the outputs."""
    parts = ["value"] if len(made.outputs) == 1 else [f"value.{axis}" for axis in "xyzw"[:len(made.outputs)]]
    return [f"std::lround(std::ldexp(double({part}), {value.places}))" for part, value in zip(parts, made.values)]


def differing(made: FunctionCircuit, text: str, points: int, folder: Path) -> int:
    """At how many points that are drawn a module differs from the library."""
    read = [f"v[{i}]" for i, port in enumerate(made.ports) if port in made.read]
    source = folder / "library.cpp"
    source.write_text(LIBRARY.format(
        points=points, drawn=", ".join(f"draw({port.low}L, {port.high}L)" for port in made.ports),
        format=" ".join(["%ld"] * len(read)), read=", ".join(read), call=call(made),
        shown=" ".join(["%ld"] * len(made.outputs)), values=", ".join(_values(made))), encoding="ascii")
    compile_program("the program that draws points", source, folder / "library", "-O2", macros=["HN_ARITHMETIC=HN_FIXED"])
    expected = ran(folder, folder / "library").splitlines()
    found = simulated(made, text, points, folder, by_verilator=True)
    return sum(a != b for a, b in zip(expected, found, strict=True))
