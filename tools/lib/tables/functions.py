"""The functions under test, and what follows from their rows in functions.inc."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from tables.inc import Row, read_rows
from tree import FUNCTIONS

# Functions whose values depend on the same knobs.
FAMILIES = ("independent", "hash", "gradient", "sine_gradient", "gradient_noise", "lattice_noise", "octave_sum")
NOISES = ("gradient_noise", "lattice_noise")

# What the names of the inputs say that a function takes; n of them have an axis.
FORMS = {
    "words": re.compile(r"(?:key|h):u32|(?:[xyzw]:u32 ?)+"),
    "point": re.compile(r"(?:[xyzw]:i32 )+seed:u32"),
    "position": re.compile(r"(?:[xyzw]:f32 )+seed:u32"),
    "cell": re.compile(r"(?:c[xyzw]:i32 )+(?:f[xyzw]:f32 )+seed:u32"),
    "sum": re.compile(r"(?:[xyzw]:f32 )+octaves:i32 lacunarity:f32 gain:f32 seed:u32"),
}


@dataclass(frozen=True)
class Function:
    """A row of the table."""
    row: Row
    id: str
    family: str
    bound: str
    inputs: str
    outputs: str
    form: str  # what it takes: a key of FORMS

    @property
    def file(self) -> str:
        return self.id.split(".")[0]

    @property
    def name(self) -> str:
        """Without the file."""
        return self.id.split(".")[1]

    @property
    def axes(self) -> int:
        """How many coordinates, or words, it takes."""
        prefix = "c" if self.form == "cell" else ""
        return len(re.findall(rf"\b{prefix}[xyzw]:", self.inputs)) or 1

    @property
    def exact(self) -> bool:
        return "f64" not in self.outputs

    @property
    def noise(self) -> str:
        """The noise that it is, as perlin for noise2d.perlin_cell."""
        return self.name.removesuffix("_cell")


    @property
    def calls(self) -> str:
        """The function of the library that its body calls."""
        names = set(re.findall(r"\b(hn_\w+)\(", self.row.arguments[6]))
        if len(names) != 1:
            raise self.row.error(f"{self.id} calls {len(names)} functions of the library instead of one")
        return names.pop()

    @property
    def types(self) -> tuple[str, ...]:
        """The types of its arguments, without the seed."""
        def vector(prefix: str, scalar: str) -> str:
            return f"{prefix}vec{self.axes}" if self.axes > 1 else scalar

        return {"words": (vector("u", "uint"),), "point": (vector("i", "int"),), "position": (vector("", "float"),),
                "cell": (vector("i", "int"), vector("", "float")),
                "sum": (vector("", "float"), "int", "float", "float")}[self.form]

    @property
    def overloads(self) -> tuple[tuple[str, ...], ...]:
        """The types without a seed, and with one."""
        return (self.types,) if self.form == "words" else (self.types, (*self.types, "uint"))


def _function(row: Row) -> Function:
    family, columns = row.word(2), row.text(4)
    if family not in FAMILIES:
        raise row.error(f"{family} is not a family; there are {', '.join(FAMILIES)}")
    inputs, separator, outputs = columns.partition(" = ")
    form = next((form for form, pattern in FORMS.items() if pattern.fullmatch(inputs)), None)
    if not form or not re.fullmatch(r"\w+:(u32|f32|f64)( \w+:(u32|f32|f64))*", outputs):
        raise row.error(f"{columns} are not columns that the tools know; tools/lib/tables/functions.py has the forms")
    return Function(row, row.text(0), family, row.text(3), inputs, outputs, form)


def read_functions(path: Path = FUNCTIONS) -> list[Function]:
    functions = [_function(row) for row in read_rows(path, "FUNCTION", 7)]
    for index, function in enumerate(functions):
        if function.id in (other.id for other in functions[:index]):
            raise function.row.error(f"{function.id} is there already")
    return functions
