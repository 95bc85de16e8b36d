"""The functions under test, and what follows from their rows in functions.inc."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from base.tree import FUNCTIONS
from catalog.tables.inc import Row, read_rows

# Functions whose values depend on the same knobs.
FAMILIES = ("independent", "hash", "gradient", "sine_gradient", "gradient_noise", "lattice_noise", "octave_sum",
            "further_gradient_noise", "octahedral_noise", "further_lattice_noise", "further_octave_sum",
            "simplex_noise", "curl", "cellular", "further_cellular", "octahedral_octave_sum",
            "utility", "distribution")
NOISES = ("gradient_noise", "lattice_noise", "further_gradient_noise", "octahedral_noise", "further_lattice_noise",
          "simplex_noise", "cellular", "further_cellular")
OCTAVE_SUMS = ("octave_sum", "further_octave_sum", "octahedral_octave_sum")
# Every hash has values of these: they hash words, or blend them first. The others are the same code with any hash.
OF_EVERY_HASH = ("hash", "gradient", "gradient_noise", "lattice_noise")

# What is proven under these names has a seed at a position, too.
ALWAYS_SEEDED = ("hex_tiling", "gullies")
STRENGTHS = ("strength", "amplitude")  # settings behind which there is always a seed

# What the names of the inputs say that a function takes; n of them have an axis.
FORMS = {
    "words": re.compile(r"(?:key|h):u32|(?:[xyzw]:u32 ?)+"),
    # Words of which each has a meaning of its own.
    "items": re.compile(r"h:u32 k:u32|i:u32 (?:n:u32 )?seed:u32"),
    "zero": re.compile(r"zero:u32"),  # what a check of words begins with
    "point": re.compile(r"(?:[xyzw]:i32 )+seed:u32"),
    # A cell that has a candidate, and how near another may be.
    "candidate": re.compile(r"(?:c[xyz]:i32 )+(?:p[xyz]:i32 )+(?:radius:f32 )?seed:u32"),
    # A spread, by its number, for a value, and of a sum of octaves.
    "spread": re.compile(r"spread:i32"),
    "spread_value": re.compile(r"noise:f32 reach:f32 a:f32 b:f32 c:f32"),
    "spread_sum": re.compile(r"reach:f32 a:f32 b:f32 c:f32 detail:f32 gain:f32"),
    "position": re.compile(r"(?:[xyzw]:f32 )+(?:p[xyzw]:i32 )*(?:(?:k[xyz]:f32 )+phase:f32 |phase:f32 )?"
                           r"(?:jitter:f32 )?(?:metric:i32 )?seed:u32"),
    "cell": re.compile(r"(?:c[xyzw]:i32 )+(?:f[xyzw]:f32 )+(?:p[xyzw]:i32 )*(?:(?:k[xyz]:f32 )+phase:f32 |phase:f32 )?"
                       r"(?:jitter:f32 )?(?:metric:i32 )?seed:u32"),
    # From a position, or from a cell and a fraction: the settings stand behind those and the periods.
    "sum": re.compile(r"(?:(?:[xyzw]:f32 )+|(?:c[xyzw]:i32 )+(?:f[xyzw]:f32 )+)(?:p[xyzw]:i32 )*"
                      r"(?P<settings>(?:(?:footprint:f32 )?octaves:i32|detail:f32) lacunarity:f32 gain:f32 "
                      r"(?:strength:f32 |amplitude:f32 )?|"
                      r"(?:footprint:f32 )?ex:f32 ey:f32 octaves:i32 lacunarity:f32 gain:f32 depth:f32 )seed:u32"),
    # A position that is a whole number of units: where it is, and the noise there.
    "place": re.compile(r"(?:[xyzw]:i32 )+cells:i32 units:i32"),
    "place_of_noise": re.compile(r"(?:[xyzw]:i32 )+cells:i32 units:i32 seed:u32"),
}


SPREADS = ("spread", "spread_value", "spread_sum")  # forms without a seed


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
        prefix = "c" if self.has_cell else ""
        return len(re.findall(rf"\b{prefix}[xyzw]:", self.inputs)) or 1

    @property
    def has_cell(self) -> bool:
        """Whether it takes a cell and the fraction in it, in place of a position."""
        return self.inputs.startswith("cx:")

    @property
    def settings(self) -> tuple[str, ...]:
        """The names of what an octave sum takes between the periods and the seed."""
        settings = FORMS["sum"].fullmatch(self.inputs)
        return tuple(re.findall(r"(\w+):", settings["settings"])) if settings else ()

    @property
    def has_period(self) -> bool:
        """Whether it takes periods, behind the position or the fraction."""
        return "px:" in self.inputs

    @property
    def has_place(self) -> bool:
        """Whether what the library takes is a place, and no position."""
        return self.has_cell or self.has_period or self.form == "place_of_noise"

    @property
    def has_phase(self) -> bool:
        """Whether it takes a phase, right before the seed."""
        return "phase:" in self.inputs

    @property
    def has_wave(self) -> bool:
        """Whether it takes a wave, with a number for each axis, right before the phase."""
        return "kx:" in self.inputs

    @property
    def has_jitter(self) -> bool:
        """Whether it takes a jitter, behind the periods."""
        return "jitter:" in self.inputs

    @property
    def has_radius(self) -> bool:
        """Whether it takes a radius, behind the periods."""
        return "radius:" in self.inputs

    @property
    def has_metric(self) -> bool:
        """Whether it takes a metric, right behind the jitter."""
        return "metric:" in self.inputs

    @property
    def sets(self) -> str:
        """What of the function it has: "nearest" or "offset", which that is given to set, or "" for its value. A
        candidate's vector is its value."""
        if self.form == "candidate":
            return ""
        return {"nx:": "nearest", "ox:": "offset"}.get(self.outputs[:3], "")

    @property
    def exact(self) -> bool:
        return self.bound == "exact"

    @property
    def noise(self) -> str:
        """The noise that it is, as perlin for noise2d.perlin_cell, and perlin_d for one with derivatives."""
        return self.bound

    @property
    def component(self) -> int | None:
        """Which component of a vector it has with its derivatives: as 1 for noise2d.value_vector_d_y. None if it has
        no such part."""
        named = re.search(r"_vector_d(?:_\w+)?_([xyz])$", self.name)
        return "xyz".index(named[1]) if named else None

    @property
    def body(self) -> str:
        """Of a function of four vectors of words, a to d."""
        return self.row.arguments[6]

    @property
    def calls(self) -> str:
        """The function of the library that its body calls."""
        names = set(re.findall(r"\b(hn_\w+)\(", self.body)) - {"hn_place", "hn_tile"}
        if len(names) != 1:
            raise self.row.error(f"{self.id} calls {len(names)} functions of the library instead of one")
        return names.pop()

    @property
    def types(self) -> tuple[str, ...]:
        """The types of its arguments, without the seed (but of items) and what it sets."""
        def vector(prefix: str, scalar: str) -> str:
            return f"{prefix}vec{self.axes}" if self.axes > 1 else scalar

        where = f"place{self.axes}" if self.has_place else vector("", "float")
        wave, phase = (vector("", "float"),) * self.has_wave, ("float",) * self.has_phase
        chosen = (*wave, *phase, *("float",) * self.has_jitter, *("int",) * self.has_metric)
        settings = tuple({"octaves": "int", "ex": "vec2"}.get(name, "float") for name in self.settings if name != "ey")
        return {"words": (vector("u", "uint"),), "zero": ("uint",), "candidate": (where, *("float",) * self.has_radius),
                "items": ("uint",) * len(self.inputs.split()),
                "point": (vector("i", "int"),), "position": (where, *chosen), "cell": (where, *chosen),
                "place_of_noise": (where,), "sum": (where, *settings),
                "place": (vector("i", "int"), "int", "int"), "spread": ("int",), "spread_value": ("float", "vec4"),
                "spread_sum": ("vec4", "float", "float")}[self.form]

    @property
    def overloads(self) -> tuple[tuple[str, ...], ...]:
        """The types without a seed, and with one. At a place, and with what is chosen beside it, there is always a
        seed, and so there is of some others. Of a candidate a cell may stand for the place."""
        out = (f"out ivec{self.axes}", f"out vec{self.axes}") if self.sets else ()
        if self.form in ("words", "items", "place", "zero", *SPREADS):
            return (self.types,)
        seeded = (*self.types, "uint", *out)
        if self.form == "candidate":
            return (seeded, (f"ivec{self.axes}", *seeded[1:]))
        always = (self.has_place or self.has_phase or self.has_jitter or self.bound in ALWAYS_SEEDED
                  or any(name in self.settings for name in ("detail", "footprint", *STRENGTHS)))
        return (seeded,) if always else ((*self.types, *out), seeded)


def _function(row: Row) -> Function:
    family, columns = row.word(2), row.text(4)
    if family not in FAMILIES:
        raise row.error(f"{family} is not a family; there are {', '.join(FAMILIES)}")
    inputs, separator, outputs = columns.partition(" = ")
    form = next((form for form, pattern in FORMS.items() if pattern.fullmatch(inputs)), None)
    if not form or not re.fullmatch(r"\w+:(u32|i32|f32|f64)( \w+:(u32|i32|f32|f64))*", outputs):
        raise row.error(f"{columns} are not columns that the tools know; tools/lib/catalog/tables/functions.py has the forms")
    return Function(row, row.text(0), family, row.text(3), inputs, outputs, form)


def read_functions(path: Path = FUNCTIONS) -> list[Function]:
    functions = [_function(row) for row in read_rows(path, "FUNCTION", 7)]
    known = set()
    for function in functions:
        if function.id in known:
            raise function.row.error(f"{function.id} is there already")
        known.add(function.id)
    return functions
