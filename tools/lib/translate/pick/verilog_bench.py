"""Runs modules beside the library in C++ or rows of vectors: Verilator simulates them, and as a second front end Icarus.

A bench draws the arguments of a module, the ends of the ranges among it, and counts the values that differ.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from base.tree import ROOT
from base.twin import COMPILER, SOON
from translate.pick.runners import ran
from translate.pick.values import SIZES
from translate.pick.verilog import FRACTION, REST, FunctionCircuit, Port

SUM = "octaves=4,lacunarity=2,gain=0.5"  # the constants of a sum of octaves
LINT = ("verilator", "--lint-only", "-Wall", "--language", "1364-2005")
BENCH = """#include <cmath>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <random>
#include <vector>

#include "V{module}.h"
#include "hashnoise/hashnoise.hpp"
using namespace hashnoise;

// Reads {inputs} numbers a point of a file, or draws points; prints how many of the values differ.
int main(int count, char** arguments) {{
  std::FILE* file = count > 2 ? std::fopen(arguments[2], "r") : nullptr;
  const long points = std::atol(arguments[1]);
  std::mt19937 g({seed}u);
  auto draw = [&g](long low, long high) {{
    const std::uint32_t kind = g() % 16u;
    if (kind < 2u) return kind == 0u ? low : high;
    if (kind < 4u && low < 0) return long(g() % 7u) - 3;
    const long drawn = long(low + std::int64_t(g()) % (std::int64_t(high) - low + 1));
    return kind == 4u ? drawn & ~0xFFFFL : drawn;
  }};
  V{module} top;
  std::deque<std::vector<long>> expected;
  long differing = 0;
  for (long i = 0; i < points + {latency}; ++i) {{
    if (i < points) {{
      long v[{inputs}];
      for (int j = 0; j < {inputs}; ++j) {{
        static const long low[] = {{{lows}}}, high[] = {{{highs}}};
        if (!file) v[j] = draw(low[j], high[j]);
        else if (std::fscanf(file, "%ld", &v[j]) != 1) return 2;
      }}
{sets}
      const auto value = {call};
      expected.push_back({{{parts}}});
    }}
    top.clock = 0;
    top.eval();
    top.clock = 1;
    top.eval();
    if (i + 1 >= {latency} && !expected.empty()) {{
      const std::vector<long> found = {{{found}}};
      if (found != expected.front() && differing++ == 0) {{
        std::fprintf(stderr, "point %ld: %ld where the library has %ld\\n", i + 1 - {latency}, found[0], expected.front()[0]);
      }}
      expected.pop_front();
    }}
  }}
  std::printf("%ld\\n", differing);
}}
"""
ICARUS = """`default_nettype none
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
      #1 clock = 1;
      #1 clock = 0;
      if (at + 1 >= {latency} && at + 1 < {points} + {latency}) $display("{shown}", {outputs});
    end
  end
endmodule
"""


def written(points: Sequence[Sequence[int]], folder: Path) -> Path:
    file = folder / "points"
    file.write_text("".join(f"{' '.join(map(str, point))}\n" for point in points), encoding="ascii")
    return file


def icarus(made: FunctionCircuit, text: str, points: Sequence[Sequence[int]], folder: Path) -> list[list[int]]:
    """The results of a module at points, which have a number for each port that is read."""
    outputs = [port.name for port in made.outputs]
    inputs = [port.name for port in made.read]
    declared = [f"  {kind} {port.declared};" for kind, ports in (("reg", made.read), ("wire", made.outputs)) for port in ports]
    source = ICARUS.format(
        declared="\n".join(declared), module=made.name, latency=made.pipeline.latency, points=len(points),
        connected=", ".join(f".{name}({name})" for name in (*inputs, *outputs)), format=" ".join(["%d"] * len(inputs)),
        inputs=", ".join(inputs), shown=" ".join(["%0d"] * len(outputs)), outputs=", ".join(outputs))
    written(points, folder)
    (folder / "bench.v").write_text(source, encoding="ascii")
    (folder / f"{made.name}.v").write_text(text, encoding="ascii")
    ran(folder, "iverilog", "-g2005", "-Wall", "-Wno-timescale", "-s", "bench", "-o", "bench.vvp", "bench.v", f"{made.name}.v")
    return [[int(word) for word in line.split()] for line in ran(folder, "vvp", "-n", "bench.vvp").splitlines()]


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


def _expected(made: FunctionCircuit) -> list[str]:
    if len(made.outputs) == 1:
        parts = ["value"]
    else:
        parts = [f"value.{axis}" for axis in "xyzw"[:len(made.outputs)]]
    return [f"std::lround(std::ldexp(double({part}), {value.places}))" for part, value in zip(parts, made.values)]


def _found(port: Port) -> str:
    width = port.width
    shown = f"long(top.{port.name})"
    return f"{shown} - ((top.{port.name} >> {width - 1}) ? {1 << width}L : 0L)" if port.low < 0 else shown


def build(made: FunctionCircuit, text: str, folder: Path) -> Path:
    """A program that compares a module with the library."""
    read = [port.name for port in made.read]
    source = BENCH.format(
        module=made.name, seed=7, latency=made.pipeline.latency, inputs=len(made.ports),
        lows=", ".join(f"{port.low}L" for port in made.ports), highs=", ".join(f"{port.high}L" for port in made.ports),
        sets="".join(f"      top.{port.name} = v[{i}];\n" for i, port in enumerate(made.ports) if port.name in read),
        call=call(made), parts=", ".join(_expected(made)), found=", ".join(map(_found, made.outputs)))
    (folder / "bench.cpp").write_text(source, encoding="ascii")
    (folder / f"{made.name}.v").write_text(text, encoding="ascii")
    flags = " ".join([*COMPILER[1:], SOON, "-w", f"-I{ROOT / 'include'}", "-DHN_ARITHMETIC=HN_FIXED"])
    ran(folder, "verilator", "--cc", "--exe", "--build", "-O3", "--top-module", made.name, "-CFLAGS", flags, "-Wno-fatal",
        f"{made.name}.v", "bench.cpp", "--Mdir", "made")
    return folder / "made" / f"V{made.name}"


def differing(program: Path, points: int, file: Path | None = None) -> int:
    done = subprocess.run([program, str(points), *([file] if file else [])], capture_output=True, text=True, check=True)
    return int(done.stdout)
