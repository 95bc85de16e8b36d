"""Writes code for the suite: its functions and its settings, as C++, and its settings for CMake.

    python3 -m catalog.suite FOLDER

conformance/CMakeLists.txt calls it from tools/lib, for a folder of the build. A file that would be the same is left
alone.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from catalog.grid import row
from catalog.model import Catalog, Noise, Sum, read
from catalog.tables.configurations import Configuration, families, read_configurations
from catalog.tables.functions import Column, Function, read_functions

HEAD = "// Made by tools/lib/catalog/suite.py.\n"
# Nothing of the library is declared with the sine gradient that is of one of these.
WITHOUT_SINE = ("octahedral_noise", "octahedral_octave_sum")
HEAD_OF_SUMS = HEAD + """\
// Define one of these macros, and include this file:
//
//   OCTAVE_SUM(name, noise, most strength or amplitude, least, greatest, is bounded): the noise is that which its GLSL
//     function sums. Values that are not bounded may be as large as the noise, if that is beyond the least or the greatest
//   OCTAVE_STEP(name, the sum s with an octave n more, what it makes of the mean): of a sum of values; the first may take
//     a strength
"""


def flag(value: bool) -> str:
    return str(value).lower()


def columns(some: Iterable[Column]) -> str:
    return ", ".join(f'{{"{column.name}", {column.type}}}' for column in some)


def of_functions(catalog: Catalog, functions: Sequence[Function]) -> str:
    """Initialisers of Function (library/functions.hpp)."""
    noises = {noise.name: noise for noise in catalog.noises}
    sums = {sum_.name for sum_ in catalog.sums if sum_.families}

    def one(function: Function) -> str:
        noise = noises.get(function.bound)
        fields = {"id": f'"{function.id}"', "file": f'"{function.includes}"', "family": function.family,
                  "bound": f'"{function.bound}"', "call": f'"{function.bench}"', "body": f'"{function.body}"',
                  "inputs": f"{{{columns(function.inputs)}}}", "outputs": f"{{{columns(function.outputs)}}}",
                  "axes": function.axes * function.has_axes,
                  "plain": f'"{function.plain}"', "configurations": mask(function),
                  "has_unseeded": flag(function.has_unseeded),
                  "is_continuous": flag(not (noise and noise.jumps)),
                  "is_never_negative": flag(bool(noise and is_never_negative(noise))),
                  "is_sum_of_noise": flag(function.bound in sums), "is_offset": flag(function.sets == "offset")}
        return f"{{{', '.join(f'.{name} = {value}' for name, value in fields.items())}}},\n"

    return HEAD + "".join(map(one, functions))


def mask(function: Function) -> str:
    """A bit for each configuration that it has values with."""
    return f"0x{sum(1 << i for i, one in enumerate(read_configurations()) if one.covers(function)):x}u"


def is_never_negative(noise: Noise) -> bool:
    ranges = noise.ranges.get("value", ())
    return bool(ranges) and all(pair and pair[0] >= 0 for pair in ranges)


def of_bodies(functions: Sequence[Function]) -> str:
    """Each body as code."""
    head = HEAD + ("// FUNCTION(id, family, configurations that it has values with, a bit for each, (COLUMN(name, type) "
                   "...), body): the columns are those that go in. Rows not declared with the sine gradient are left out there. "
                   "SUM_FUNCTION may be another macro for octave sums.\n#ifndef SUM_FUNCTION\n#define SUM_FUNCTION FUNCTION\n#endif\n")
    rows = []
    for function in functions:
        inputs = " ".join(f'COLUMN("{column.name}", {column.type})' for column in function.inputs)
        text = f'{"SUM_" * (function.form == "sum")}FUNCTION("{function.id}", {function.family}, {mask(function)}, ({inputs}), {function.body})\n'
        rows.append(f"#if HN_GRADIENT != HN_GRADIENT_SINE\n{text}#endif\n" if function.family in WITHOUT_SINE else text)
    return head + "".join(rows) + "#undef SUM_FUNCTION\n"


def of_configurations(configurations: Sequence[Configuration]) -> str:
    """Initialisers of Configuration (library/configurations.hpp)."""
    return HEAD + "".join(f'{{"{of.name}", "{of.hash.upper()}", Gradient::{of.gradient}, Arithmetic::{of.arithmetic}, {i}}},\n'
                          for i, of in enumerate(configurations))


def of_sums(catalog: Catalog) -> str:
    sums = [sum_ for sum_ in catalog.sums if sum_.families]
    rows = [*map(facts_of, sums), *(row("OCTAVE_STEP", sum_.name, sum_.adds("s", "n", "strength"), sum_.makes("mean"))
                                    for sum_ in sums if sum_.is_of_values)]
    macros = ("OCTAVE_SUM", "OCTAVE_STEP")
    return "".join([HEAD_OF_SUMS, *(f"#ifndef {macro}\n#define {macro}(...)\n#endif\n" for macro in macros), *rows,
                    *(f"#undef {macro}\n" for macro in macros)])


def facts_of(sum_: Sum) -> str:
    least, greatest = sum_.range if isinstance(sum_.range, tuple) else (-1, 1)
    return row("OCTAVE_SUM", sum_.name, sum_.noise, sum_.strength.most if sum_.strength else 0, least, greatest,
               flag(bool(sum_.mean)))


def files() -> dict[str, str]:
    """By their names in the folder. Files that C++ includes are in the room library."""
    catalog, functions, configurations = read(), read_functions(), read_configurations()
    of_cmake = "".join(f'  "{" ".join([one.name, *one.macros])}"\n' for one in configurations)
    return {"library/functions.inc": of_functions(catalog, functions), "library/bodies.inc": of_bodies(functions),
            "library/configurations.inc": of_configurations(configurations), "library/sums.inc": of_sums(catalog),
            "library/metrics.inc": "".join([HEAD, "// Define METRIC(name, number), and include this file.\n", *(
                row("METRIC", name, number) for number, name in enumerate(catalog.metrics, 1)), "#undef METRIC\n"]),
            "library/families.inc": HEAD + "".join(f"{name},\n" for name in families()),
            "configurations.cmake": f"set(configurations\n{of_cmake})\n"}


def write(folder: Path) -> None:
    for name, text in files().items():
        path = folder / name
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
