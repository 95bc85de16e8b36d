"""What the conformance suite knows of noises and sums: their rows of the table of functions, library/forms.inc.

A row is a form of a function in so many dimensions: at a position, from a cell, in a tile, and some with what may be set.
conformance/library/functions.inc says what the parts of a row mean. Where the catalog says that rows stand by hand, they
stand there, and nothing of such a function is made here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from base.tree import ROOT
from catalog.grid import row
from catalog.model import AXES, Catalog, Function, Noise, Sum

PATH = ROOT / "conformance" / "library" / "forms.inc"
FACTS = ROOT / "conformance" / "library" / "facts.inc"
HEAD = """\
// Made by tools/make catalog: the noises and the sums among the functions under test. functions.inc includes it, and
// says what a row means.
// clang-format off
"""
HEAD_OF_FACTS = """\
// Made by tools/make catalog: what the suite knows of noises and sums. Define one of these macros, and include this
// file:
//
//   NOISE(name, jumps, is never negative)
//   OCTAVE_SUM(name, noise, most strength or amplitude, least, greatest, is bounded, step, mean): the noise is that which
//     its GLSL function sums. Values that are not bounded may be as large as the noise, if that is beyond the least or the
//     greatest. The step is what an octave adds, and the mean what becomes of the mean (sums/bounds.hpp)
//   SUM_STEP(name), SUM_MEAN(name): each of those steps and means
//   OCTAVE_STEP(name, the sum s with an octave n more, what it makes of the mean): of a sum of values; the first may take
//     a strength
// clang-format off
#ifndef NOISE
#define NOISE(...)
#endif
#ifndef OCTAVE_SUM
#define OCTAVE_SUM(...)
#endif
#ifndef SUM_STEP
#define SUM_STEP(...)
#endif
#ifndef SUM_MEAN
#define SUM_MEAN(...)
#endif
#ifndef OCTAVE_STEP
#define OCTAVE_STEP(...)
#endif
"""

# The words that go in, in their order.
WORDS = tuple(f"{word}.{axis}" for word in "abcd" for axis in AXES)

# What bench takes for a position in so many dimensions, given a vec3 p, or a vec2 on the line and on the plane.
POSITION = {1: "p.x", 2: "p", 3: "p", 4: "vec4(p, p.x)"}
CELL = {1: "int(floor(p.x)), p.x - floor(p.x)", 2: "ivec2(floor(p)), p - floor(p)", 3: "ivec3(floor(p)), p - floor(p)",
        4: "ivec4(ivec3(floor(p)), floatBitsToInt(p.x)), vec4(fract(p), fract(p.x + p.y))"}


@dataclass(frozen=True)
class Option:
    """What a function takes between its place and its seed."""
    name: str
    usual: str  # what bench takes for it
    whole: bool = False

    def of(self, word: str) -> str:
        return f"int({word})" if self.whole else f"float_of({word})"


JITTER, METRIC = Option("jitter", "1.0"), Option("metric", "HN_METRIC_EUCLIDEAN", whole=True)
PHASE = Option("phase", "p.x")
OCTAVES, DETAIL = Option("octaves", "6", whole=True), Option("detail", "5.5")
FOOTPRINT = Option("footprint", "0.015625")
RATIOS = (Option("lacunarity", "2.0"), Option("gain", "0.5"))


@dataclass(frozen=True)
class Result:
    """What comes out: the columns, the type that is returned, and how the words are made of one."""
    columns: Sequence[str]
    type: str
    members: Sequence[str]  # of n; "" is n itself

    def text(self) -> str:
        words = [f"bits_of(n{'.' if member else ''}{member})" for member in self.members]
        return f"return uvec4({', '.join([*words, *['0u'] * (4 - len(words))])});"


def vector(size: int) -> str:
    return "hn_float" if size == 1 else f"hn_vec{size}"


def floats(*columns: str) -> Result:
    return Result(columns, vector(len(columns)), [""] if len(columns) == 1 else AXES[:len(columns)])


def results(function: Function, dimensions: int) -> dict[str, Result]:
    """By what the id of a row ends with: five numbers do not fit into one."""
    axes = AXES[:dimensions]
    if function.shape in ("slopes", "distance_with_slopes"):
        slopes = [f"d{axis}" for axis in axes]
        if dimensions < 4:
            return {"": floats("value", *slopes)}
        return {"": Result(slopes, "hn_derivatives4", [f"gradient.{axis}" for axis in axes]),
                "_value": Result(["value"], "hn_derivatives4", ["value"])}
    if function.shape == "vector":
        letter = "s" if isinstance(function, Sum) else "v"
        return {"": floats(*(f"{letter}{axis}" for axis in axes))}
    return {"": floats(*{"value": ("value",), "two_distances": ("first", "second"),
                         "three_distances": ("first", "second", "third")}[function.shape])}


@dataclass(frozen=True)
class Row:
    """A function in a form."""
    id: str
    file: str
    family: str
    bound: str
    calls: str
    dimensions: int
    result: Result
    cell: bool = False
    tile: bool = False
    options: Sequence[Option] = ()
    seeded: bool = False  # it has no overload without a seed at a position
    bench_seed: str = ""  # what bench takes for it; "" for the overload without one

    def text(self) -> str:
        words = iter(WORDS)
        axes = AXES[:self.dimensions]
        columns: list[str] = []
        lines: list[str] = []

        def take(name: str, prefix: str, whole: bool) -> None:
            parts = [f"{'int' if whole else 'float_of'}({next(words)})" for _ in axes]
            columns.extend(f"{prefix}{axis}:{'i' if whole else 'f'}32" for axis in axes)
            kind = f"{'i' if whole else ''}vec{self.dimensions}"
            if self.dimensions == 1:
                lines.append(f"hn_{'int' if whole else 'float'} {name} = {parts[0]};")
            else:
                lines.append(f"hn_{kind} {name} = {kind}({', '.join(parts)});")

        where, bench = "p", POSITION[self.dimensions]
        if self.cell:
            take("cell", "c", whole=True)
            take("f", "f", whole=False)
            where, bench = "hn_place(cell, f)", f"hn_place({CELL[self.dimensions]})"
        else:
            take("p", "", whole=False)
        if self.tile:
            take("period", "p", whole=True)
            period = "64" if self.dimensions == 1 else f"ivec{self.dimensions}(64)"
            where, bench = f"hn_tile({where}, period)", f"hn_tile({bench}, {period})"
        taken = [where]
        for option in self.options:
            columns.append(f"{option.name}:{'i' if option.whole else 'f'}32")
            taken.append(option.of(next(words)))
        word = next(words)
        seed = f", SEED({word})" if self.seeded or self.cell or self.tile else f" SEEDED({word})"
        lines.append(f"{self.result.type} n = {self.calls}({', '.join(taken)}{seed});")
        lines.append(self.result.text())
        benched = [bench, *(option.usual for option in self.options), *([self.bench_seed] if self.bench_seed else [])]
        outputs = " ".join(f"{column}:f64" for column in self.result.columns)
        indent = "\n" + len("FUNCTION(") * " "
        parts = [f'"{self.id}", "{self.file}", {self.family}, "{self.bound}"',
                 f'"{" ".join(columns)} seed:u32 = {outputs}"', f'"{self.calls}({", ".join(benched)})"',
                 indent.join(lines)]
        return f"FUNCTION({f',{indent}'.join(parts)})\n"


def strength_of(sum_: Sum) -> list[Option]:
    return [Option(sum_.strength.name, repr(float(sum_.strength.default)))] if sum_.strength else []


def of_noise(noise: Noise) -> Iterator[Row]:
    families = noise.families
    for dimensions in range(noise.first, noise.last + 1):
        is_usual = dimensions in (2, 3)
        folder = f"noise{dimensions}d.{noise.name}" if noise.shape != "vector" else f"{noise.name}.{noise.name}{dimensions}"
        file, called = f"{noise.name}{dimensions}d.glsl", f"hn_{noise.name}"
        usual = families.usual if is_usual else families.others
        tiles = families.tiles if is_usual else families.others
        for end, result in results(noise, dimensions).items():
            def of_form(form: str, family: str, bench_seed: str = "", **more: object) -> Row:
                return Row(f"{folder}{form}{end}", file, family, noise.name, called, dimensions, result,
                           bench_seed=bench_seed, **more)

            yield of_form("", usual)
            yield of_form("_cell", usual, "floatBitsToUint(p.x)", cell=True)
            yield of_form("_cell_period", tiles, "0u", cell=True, tile=True)
            # A position in a tile is the place of its cell and its fraction. So one noise and one sum prove hn_tile of
            # positions.
            if noise.name == "perlin":
                yield of_form("_period", tiles, "0u", tile=True)
            if "jitter" in noise.options:
                options = [JITTER, METRIC] if "metric" in noise.options else [JITTER]
                yield of_form("_full", tiles, "0u", options=options, seeded=True)
                yield of_form("_cell_full", tiles, "0u", cell=True, tile=True, options=options)
            # A file has the noise with a phase and its derivatives.
            if "phase" in noise.options and is_usual:
                jitters = "jitter" in noise.options
                phase = {"options": [PHASE, *[JITTER] * jitters], "seeded": True}
                file = f"{noise.name.removesuffix('_d')}_phase{dimensions}d.glsl"
                for form, seed, place in (("", "0u", {}), ("_cell", "floatBitsToUint(p.x)", {"cell": True}),
                                          ("_cell_period", "0u", {"cell": True, "tile": True})):
                    if jitters and form == "_cell":
                        continue  # a period of 0 is none
                    yield Row(f"{folder}_phase{form}", file, tiles if jitters else families.others,
                              f"{noise.name}_phase", noise.called_with_phase, dimensions, result, bench_seed=seed,
                              **phase, **place)


def of_sum(sum_: Sum) -> Iterator[Row]:
    """On the plane and in space all forms; on the line and in four dimensions some that between them have all of the
    code. There a strength beside the cell, the fraction and the period has no room."""
    families = sum_.families
    file = "warp" if sum_.shape == "vector" else "fbm_d" if sum_.of == "slopes" else "fbm"
    options = [OCTAVES, *RATIOS, *strength_of(sum_)]
    for dimensions in range(sum_.first, sum_.last + 1):
        is_usual = dimensions in (2, 3)
        (result,) = results(sum_, dimensions).values()

        def of_form(form: str, family: str, bench_seed: str = "", **more: object) -> Row:
            more.setdefault("options", options)
            more.setdefault("seeded", bool(sum_.strength))
            return Row(f"{file}.{sum_.name}{dimensions}{form}", f"{file}{dimensions}d.glsl", family, sum_.name,
                       f"hn_{sum_.name}", dimensions, result, bench_seed=bench_seed, **more)

        further = families.tiles if is_usual else families.others
        yield of_form("", families.usual if is_usual else families.others, "0u" if sum_.strength else "")
        has_room = len(options) + 1 + 3 * dimensions <= len(WORDS)
        if is_usual or not has_room or (sum_.name == "fbm" and dimensions == 1):
            yield of_form("_cell", further, "0u", cell=True)
        if has_room:
            yield of_form("_cell_period", further, "0u", cell=True, tile=True)
        if not has_room or (sum_.name == "fbm" and dimensions == 2):
            yield of_form("_period", further, "0u", tile=True)
        # With less detail: by a float of octaves, and by a footprint.
        if "detail" in sum_.options:
            yield of_form("_detail", further, "0u", options=[DETAIL, *RATIOS], seeded=True)
        if "footprint" in sum_.options:
            yield of_form("_footprint", further, "0u", options=[FOOTPRINT, OCTAVES, *RATIOS], seeded=True)


def facts_of_noise(noise: Noise) -> str:
    ranges = noise.ranges.get("value", ())
    return row("NOISE", noise.name, str(noise.jumps).lower(),
               str(bool(ranges) and all(pair and pair[0] >= 0 for pair in ranges)).lower())


def facts_of(sum_: Sum) -> str:
    least, greatest = sum_.range if isinstance(sum_.range, tuple) else (-1, 1)
    is_bounded = bool(sum_.mean) or sum_.step not in ("", "noise", "size", "eroded")
    step, mean = step_and_mean(sum_)
    return row("OCTAVE_SUM", sum_.name, sum_.noise, sum_.strength.most if sum_.strength else 0, least, greatest,
               str(is_bounded).lower(), step, mean)


def step_and_mean(sum_: Sum) -> tuple[str, str]:
    """What the suite calls what an octave adds, and what becomes of the mean. Derivatives are added as they are, and a
    warp is a step of its own."""
    plain = "noise" if sum_.of == "slopes" else sum_.name
    return sum_.step or plain, sum_.mean or "as_it_is"


def files(catalog: Catalog) -> dict[Path, str]:
    noises = [noise for noise in catalog.noises if noise.families]
    sums = [sum_ for sum_ in catalog.sums if sum_.families]
    rows = [*(one for noise in noises for one in of_noise(noise)), *(one for sum_ in sums for one in of_sum(sum_))]
    steps, means = zip(*map(step_and_mean, sums))
    facts = [*map(facts_of_noise, noises), *map(facts_of, sums),
             *(row("SUM_STEP", step) for step in dict.fromkeys(steps)),
             *(row("SUM_MEAN", mean) for mean in dict.fromkeys(means)),
             *(row("OCTAVE_STEP", sum_.name, sum_.adds("s", "n", "strength"), sum_.makes("mean")) for sum_ in sums
               if sum_.is_of_values)]
    end = "#undef NOISE\n#undef OCTAVE_SUM\n#undef SUM_STEP\n#undef SUM_MEAN\n#undef OCTAVE_STEP\n// clang-format on\n"
    return {PATH: HEAD + "\n".join(one.text() for one in rows) + "// clang-format on\n",
            FACTS: "".join([HEAD_OF_FACTS, *facts, end])}
