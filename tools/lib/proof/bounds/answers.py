"""Runs the text of sums over numbers that count how far they are off (conformance/sums), in floats and in integers."""

from __future__ import annotations

import ctypes
import functools
import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import catalog.model
from base.tree import CONFORMANCE, GLSL, ROOT
from base.twin import compile_program
from catalog import suite
from proof.bounds.prover import ENGINE
from proof.bounds.rounded import FIXED, Body, made, table
from proof.bounds.table import Bounds, bounds_of, read

SOURCE = CONFORMANCE / "sums" / "answers.cpp"
# It is compiled longer than it runs.
OPTIONS = ("-O0", "-Dalways_inline=unused", "-w", "-frounding-math", "-shared", "-fPIC", "-fno-gnu-unique",
           f"-I{ROOT / 'include'}", f"-I{CONFORMANCE}", f"-I{ENGINE}", f"-I{GLSL}")
KINDS = {"any": 0, "word": 1, "float": 2, "int": 3}


def words_of(argument: str) -> list[float]:
    """From "any", "word:5", "float:0.5", "float:-16:16" or "int:-16:16"."""
    kind, *ends = argument.split(":")
    return [KINDS[kind], *(float(end) for end in (*ends, *ends)[:2])] if ends else [KINDS[kind], 0.0, 0.0]


class Sums:
    """The sums of the suite's table, or others with bodies like those, whose text stands in `own`: C++ as own.py makes it of
    GLSL. They may sum any noise of the library (SUMMARIES)."""

    def __init__(self, *macros: str, bodies: Mapping[str, Body] | None = None, own: str = "",
                 options: Sequence[str] = ()):
        self.bodies = table() if bodies is None else bodies
        bodies_inc = "".join(f'SUM_FUNCTION("{name}", , , (), {body.code})\n' for name, body in (bodies or {}).items())
        if bodies is not None:
            macros += ("SUMS_OWN",)
        summaries = "" if bodies is None else other_summaries()

        def make(folder: Path) -> None:
            suite.write(folder)
            (folder / "bodies.inc").write_text(bodies_inc, encoding="utf-8")
            (folder / "summaries.inc").write_text(summaries, encoding="utf-8")
            (folder / "own.inc").write_text(OWN.format(own), encoding="utf-8")
            compile_program("the text of sums", SOURCE, folder / "new", *OPTIONS, *options, include=folder, macros=macros)

        self.library = ctypes.CDLL(str(made(
            "sums.so", [*macros, own, bodies_inc, summaries, *suite.files().values()],
            [*SOURCE.parent.glob("*.[ch]pp"), *(ENGINE / name for name in ("interval.hpp", "names.hpp"))], make)))
        self.library.answer.restype = ctypes.c_char_p

    def errors(self, name: str, arguments: Mapping[str, str], noise: Sequence[float] = (0.0,) * 7) -> list[float]:
        """For each output, where arguments are by their columns; `noise` as at the top of answers.cpp. Where there is no
        proof a LookupError has the reason."""
        body = self.bodies[name]
        numbers = [x for column in body.inputs for x in words_of(arguments[column.name])]
        found = (ctypes.c_double * 4)()
        problem = self.library.answer(name.encode(), (ctypes.c_double * 48)(*numbers), (ctypes.c_double * 7)(*noise), found)
        if problem:
            raise LookupError(problem.decode())
        return list(found)[:len(body.outputs)]

    def gullies(self, numbers: Sequence[float]) -> list[float]:
        found = (ctypes.c_double * 2)()
        self.library.answer_gullies((ctypes.c_double * len(numbers))(*numbers), found)
        return list(found)


SUMMARIES = {  # of noises by their shapes: the type, for so many dimensions, and its constructor
    "value": ("Float", "n.value()"), "slopes": ("vec{more}", "vec{more}(n.value(), {slopes})"),
    "vector": ("vec{dims}", "vec{dims}({values})")}


OWN = """#define float Float
#define int Int
#include "hashnoise.glsl"
namespace own {{
{}
}}
#undef float
#undef int
"""


def written(value: Bounds, slope: Bounds | None = None) -> str:
    """The summary of a noise, in C++."""
    dims, *numbers = summary(value, slope, False)
    return f"Noise({dims}, {{{', '.join(map(repr, numbers[:3]))}}}, {{{', '.join(map(repr, numbers[3:]))}}})"


def other_summaries() -> str:
    """Summaries of all noises of the library that sums may be over, with the bounds of bounds.inc."""
    lines, of_sums = [], []
    slopes = {(of.noise, of.dimensions): of for of in read(macro="SLOPE_BOUNDS")}
    for noise, dims in ((noise, dims) for noise in catalog.model.read().noises for dims in range(noise.first, noise.last + 1)):
        try:
            value = bounds_of(noise.name, dims, "octahedral")
        except LookupError:
            continue  # a vector has the bounds of its components
        base = noise.name.removesuffix("_vector").removesuffix("_d")
        bounds = written(value, slopes.get((f"{base}_d", dims)))
        if noise.name in ("perlin", "perlin_d", "value_vector", "curl") or (noise.name, dims) == ("cellular_d", 3):
            of_sums.append(f"  of.{noise.name}[{dims}] = {bounds};\n")
            if noise.name == "curl":  # the library's sum has it with a phase, too
                of_sums.append(f"  of.curl_phase[{dims}] = {written(bounds_of('curl_phase', dims, 'none'))};\n")
        elif noise.shape in SUMMARIES and not math.isinf(value.lipschitz) and (noise.shape, dims) not in (("slopes", 1), ("slopes", 4)):
            type_, made = (text.format(dims=dims, more=dims + 1, slopes=", ".join(["n.slope()"] * dims),
                                       values=", ".join(["n.value()"] * dims)) for text in SUMMARIES[noise.shape])
            lines.append(f"inline {type_} hn_{noise.name}(const hn_place{dims}& place, const Uint&) {{\n"
                         f"  static const Noise noise = {bounds};\n  const Summarized n{{noise, off_of(place)}};\n"
                         f"  return {made};\n}}\n")
    return "".join([*lines, "inline Noises own_noises() {\n  Noises of;\n", *of_sums, "  return of;\n}\n"])


@functools.cache
def library(fixed: bool) -> Sums:
    return Sums(*(FIXED,) * fixed)


def summary(noise: Bounds, slope: Bounds | None, fixed: bool) -> list[float]:
    """The bounds of a noise as `errors` takes them."""
    def of(bounds: Bounds) -> list[float]:
        return ([bounds.fixed_error, bounds.lipschitz, bounds.fixed_limit] if fixed
                else [bounds.cell_error, bounds.lipschitz, bounds.limit])
    return [noise.dimensions, *of(noise), *(of(slope) if slope else [0.0] * 3)]
