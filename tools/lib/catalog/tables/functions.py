"""The functions under test: the noises and the sums of the catalog in all their forms, and what catalog/functions.toml
has.

A row is a public function in a form: at a position, from a cell, in a tile, with its settings. The suite, bench,
the twin and the tools treat a function by its row.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from catalog.model import AXES, CATALOG, CatalogError, Entry, Noise, Sum, read, tables
from catalog.tables.configurations import families

FILE = "functions.toml"
NOISES = ("gradient_noise", "lattice_noise", "extended_gradient_noise", "octahedral_noise", "extended_lattice_noise",
          "simplex_noise", "cellular", "extended_cellular")
TYPES = ("u32", "i32", "f32", "f64")
STRENGTHS = ("strength", "amplitude")
BANDWIDTH = "_bandwidth"  # ends the bound of a noise in the forms that take one
SPREADS = ("spread", "spread_value", "spread_sum")  # forms without a seed


@dataclass(frozen=True)
class Column:
    """A word that goes in, or a number that comes out."""
    name: str
    type: str

    def __str__(self) -> str:
        return f"{self.name}:{self.type}"

    @staticmethod
    def listed(text: str) -> tuple[Column, ...]:
        """The columns of a text such as "x:f32 y:f32"."""
        return tuple(Column(*column.split(":")) for column in text.split())


@dataclass(frozen=True)
class Part:
    """A part of a function's arguments: a number or a vector, with its words."""
    name: str
    type: str
    columns: tuple[str, ...] = ()  # "c*" stands for cx, cy and so on; "" for its name
    usual: str = ""  # what bench takes for it

    def names(self, dimensions: int) -> tuple[str, ...]:
        return expanded(self.columns or (self.name,), dimensions)

    @property
    def is_vector(self) -> bool:
        """Whether it is a vector, or would be one in more dimensions."""
        return bool(self.columns)


def expanded(columns: tuple[str, ...], dimensions: int) -> tuple[str, ...]:
    return tuple(name for column in columns
                 for name in ([column.replace("*", axis) for axis in AXES[:dimensions]] if "*" in column else [column]))


# The names of a function's arguments. The position comes first, and the period right behind it.
PARTS = {
    "position": (Part("p", "f32", ("*",)),),
    "cell": (Part("cell", "i32", ("c*",)), Part("f", "f32", ("f*",))),
    "candidate": (Part("cell", "i32", ("c*",)),),  # a cell that has a candidate among scattered points
    "units": (Part("position", "i32", ("*",)), Part("cells", "i32", usual="3"), Part("units", "i32", usual="100")),
    "period": (Part("period", "i32", ("p*",)),),
    "point": (Part("lattice_point", "i32", ("*",)),),
    "words": (Part("words", "u32", ("*",)),),
    "wave": (Part("wave", "f32", ("k*",), "p"),),
    "slope": (Part("slope", "f32", ("ex", "ey"), "p"),),  # that gullies begin with
    "distribution": (Part("spread", "f32", ("reach", "a", "b", "c"), "hn_distribution(HN_DISTRIBUTION_PERLIN2)"),),
    **{name: (Part(name, "u32", usual=usual),) for name, usual in {
        **dict.fromkeys(("key", "h", "i", "zero"), "floatBitsToUint(p.x)"), "k": "1u", "n": "1000u", "seed": "7u"}.items()},
    **{name: (Part(name, "i32", usual=usual),) for name, usual in {
        "metric": "HN_METRIC_EUCLIDEAN", "octaves": "6", "spread": "floatBitsToInt(p.x)"}.items()},
    **{name: (Part(name, "f32", usual=usual),) for name, usual in {
        **dict.fromkeys(("phase", "radius", "noise"), "p.x"), "jitter": "1.0", "bandwidth": "1.0", "detail": "5.5", "footprint": "0.015625",
        "lacunarity": "2.0", "gain": "0.5", "strength": "", "amplitude": "", "depth": ""}.items()},
}
PARTS["place_of_units"] = PARTS["units"]
ITEMS = ("i", "k", "n", "seed")  # each of these words has a meaning of its own
OF_SUMS = ("phase", "footprint", "slope", "octaves", "detail", "lacunarity", "gain", *STRENGTHS, "depth")
# Behind these there is always a seed.
SEEDED = {"candidate", "cell", "period", "place_of_units", "phase", "jitter", "detail", "footprint", "slope", *STRENGTHS}

# The words that go in, in their order.
WORDS = tuple(f"{word}.{axis}" for word in "abcd" for axis in AXES)
# bench's position in so many dimensions, given a vec3 p, or a vec2 on the line and on the plane.
USUAL = {
    "position": ("p.x", "p", "p", "vec4(p, p.x)"),
    "cell": ("int(floor(p.x)), p.x - floor(p.x)", "ivec2(floor(p)), p - floor(p)", "ivec3(floor(p)), p - floor(p)",
             "ivec4(ivec3(floor(p)), floatBitsToInt(p.x)), vec4(fract(p), fract(p.x + p.y))"),
    "units": ("floatBitsToInt(p.x)", "floatBitsToInt(p)", "floatBitsToInt(p)", "floatBitsToInt(vec4(p, p.x))"),
    "point": ("floatBitsToInt(p.x)", "floatBitsToInt(p)", "floatBitsToInt(p)",
              "ivec4(floatBitsToInt(p), floatBitsToInt(p.x - p.y))"),
    "words": ("floatBitsToUint(p.x)", "floatBitsToUint(p)", "floatBitsToUint(p)",
              "uvec4(floatBitsToUint(p), floatBitsToUint(p.x - p.y))"),
}


def glsl_type(type_: str, size: int) -> str:
    scalar, vector = {"u": ("uint", "uvec"), "i": ("int", "ivec"), "f": ("float", "vec")}[type_[0]]
    return f"{vector}{size}" if size > 1 else scalar


def of_words(type_: str, words: list[str]) -> str:
    """The expression of a number or a vector of these words."""
    parts = [{"u32": word, "i32": f"int({word})", "f32": f"float_of({word})"}[type_] for word in words]
    return parts[0] if len(parts) == 1 else f"{glsl_type(type_, len(parts))}({', '.join(parts)})"


@dataclass(frozen=True)
class Function:
    id: str
    family: str  # functions whose values depend on the same knobs
    bound: str  # "exact", "sine", or the noise or sum that it is: perlin_d of noise2d.perlin_d_cell
    takes: tuple[str, ...]
    gives: tuple[str, ...]
    type: str  # of its results
    dimensions: int = 1
    includes: str = ""
    calls: str = ""  # the function of the library
    returns: str = ""  # the type, if it is no number and no vector
    members: tuple[str, ...] = ()  # in the order of the function's results
    sets: str = ""  # "nearest" or "offset", which it is given to set; "" for its value
    always_seeded: bool = False
    benched: str | None = None  # None: it follows from the rest
    bench_seed: str = "0u"
    strength: str = ""  # the usual one
    experimental: bool = False  # not frozen from 1.0 on
    plain: str = ""  # the id of the row whose derivative, or whose value beside it, this is; of a sum, without slopes

    @property
    def file(self) -> str:
        return self.id.split(".")[0]

    @property
    def name(self) -> str:
        """Without the file."""
        return self.id.split(".")[1]

    def error(self, message: str) -> CatalogError:
        return CatalogError(f"catalog: {self.id}: {message}")

    # --- Arguments and results ---

    @property
    def parts(self) -> list[Part]:
        return [part for name in self.takes for part in PARTS[name]]

    @property
    def inputs(self) -> tuple[Column, ...]:
        columns = [Column(name, part.type) for part in self.parts for name in part.names(self.dimensions)]
        return (*columns, *[Column("seed", "u32")] * self.has_seed)

    @property
    def outputs(self) -> tuple[Column, ...]:
        return tuple(Column(name, self.type) for name in expanded(self.gives, self.dimensions))

    @property
    def columns(self) -> str:
        """As golden files have them."""
        return f"{' '.join(map(str, self.inputs))} = {' '.join(map(str, self.outputs))}"

    @property
    def form(self) -> str:
        """Its first argument, with those like it."""
        first = self.takes[0]
        if first in ITEMS or "k" in self.takes:
            return "items"
        if "octaves" in self.takes or ("detail" in self.takes and first != "distribution"):
            return "sum"
        return {"key": "words", "h": "words", "units": "place", "place_of_units": "place_of_noise",
                "noise": "spread_value", "distribution": "spread_sum"}.get(first, first)

    @property
    def has_axes(self) -> bool:
        return any("*" in column for part in self.parts for column in part.columns)

    @property
    def axes(self) -> int:
        """How many coordinates, or words, it takes."""
        return self.dimensions if self.has_axes else 1

    @property
    def has_cell(self) -> bool:
        """Whether it takes a cell and the fraction in it, or a candidate's cell, in place of a position."""
        return self.takes[0] in ("cell", "candidate")

    @property
    def settings(self) -> tuple[str, ...]:
        """The arguments of an octave sum between the periods and the seed."""
        return tuple(name for taken in self.takes if taken in OF_SUMS for part in PARTS[taken]
                     for name in part.names(0)) if self.form == "sum" else ()

    @property
    def has_period(self) -> bool:
        return "period" in self.takes

    @property
    def has_place(self) -> bool:
        """Whether the library takes a place, and no position."""
        return self.has_cell or self.has_period or self.form == "place_of_noise"

    @property
    def has_phase(self) -> bool:
        return "phase" in self.takes

    @property
    def has_seed(self) -> bool:
        """Whether a seed is behind all that it takes."""
        return self.form not in ("words", "items", "zero", "place", *SPREADS)

    @property
    def has_unseeded(self) -> bool:
        """Whether there is an overload without that seed."""
        return self.has_seed and not self.always_seeded and not SEEDED & {*self.takes}

    @property
    def exact(self) -> bool:
        return self.bound == "exact"

    @property
    def component(self) -> int | None:
        """Which component of a vector it has with its derivatives: as 1 for noise2d.value_vector_d_y. The noise of such
        a function is a component's."""
        own = self.bound.removesuffix(BANDWIDTH)
        of_a_vector = self.returns.startswith("hn_derivatives") and self.calls != f"hn_{own}"
        return "xyz".index(self.members[0][-1]) if of_a_vector else None

    # --- The function of the library ---

    @property
    def types(self) -> tuple[str, ...]:
        """The types of its arguments, without the seed (but of items) and its outputs."""
        first = [f"place{self.axes}"] if self.has_place else []
        parts = [part for name in self.takes[bool(first):] if name != "period" for part in PARTS[name]]
        return (*first, *(glsl_type(part.type, len(part.names(self.dimensions))) for part in parts))

    @property
    def overloads(self) -> tuple[tuple[str, ...], ...]:
        """The types without a seed, and with one. In a candidate a cell may stand for the place."""
        out = (f"out ivec{self.axes}", f"out vec{self.axes}") if self.sets else ()
        if not self.has_seed:
            return (self.types,)
        seeded = (*self.types, "uint", *out)
        if self.form == "candidate":
            return (seeded, (f"ivec{self.axes}", *seeded[1:]))
        return ((*self.types, *out), seeded) if self.has_unseeded else (seeded,)

    @property
    def body(self) -> str:
        """The body of uvec4 evaluate(uvec4 a, uvec4 b, uvec4 c, uvec4 d), valid in shaders and as C++. float_of and
        bits_of reinterpret bits. SEEDED(s) is ", s", or nothing where the overload without a seed is under test;
        SEED(s) is the seed if there is none."""
        words, lines, taken = iter(WORDS), [], []
        for part in self.parts:
            size = len(part.names(self.dimensions))
            value = of_words(part.type, [next(words) for _ in range(size)])
            if part.is_vector:
                lines.append(f"hn_{glsl_type(part.type, size)} {part.name} = {value};")
            taken.append(part.name if part.is_vector else value)
        place = self._place(taken)
        seed = "" if not self.has_seed else f" SEEDED({next(words)})" if self.has_unseeded else f", SEED({next(words)})"

        def call(*arguments: str) -> str:
            return f"{self.calls}({', '.join(arguments)}{seed}{', nearest, offset' if self.sets else ''})"

        n = self.axes
        if self.sets:
            lines += [f"hn_ivec{n} nearest;", f"hn_vec{n} offset;", f"{call(*place)};"]
        else:
            returned = self.returns or f"hn_{glsl_type(self.type, len(self.outputs))}"
            lines.append(f"{returned} n = {call(*place)};")
            if self.form == "candidate":
                is_plain = " && ".join(f"period.{axis} == 0" for axis in AXES[:n])
                lines.append(f"if ({is_plain}) n = {call('cell', *place[1:])};")
        return " ".join([*lines, f"return uvec4({', '.join(self._words())});"])

    def _place(self, taken: list[str]) -> list[str]:
        """The arguments, of the numbers and vectors that the function takes: a place stands for its parts."""
        if self.form == "place_of_noise":
            return [f"hn_place({', '.join(taken)})"]
        count = len(PARTS[self.takes[0]])
        where, rest = taken[:count], taken[count:]
        if self.has_cell:
            where = [f"hn_place({', '.join(where)})"]
        return [f"hn_tile({where[0]}, {rest[0]})", *rest[1:]] if self.has_period else [*where, *rest]

    def _words(self) -> list[str]:
        """The four words of the result."""
        of, count = self.sets or "n", len(self.outputs)
        members = self.members or ([""] if count == 1 else AXES[:count])
        cast = {"u": "{}", "i": "uint({})", "f": "bits_of({})"}[self.type[0]]
        return [*(cast.format(of + "." * bool(member) + member) for member in members), *["0u"] * (4 - count)]

    @property
    def bench(self) -> str:
        """bench's expression: the function at a position p, a vec3 if there are three axes or more, else a vec2; "" if
        another row measures the same. Parameters that a function sets are hn_bench_cell2 and hn_bench_cell3, an ivec2
        and an ivec3, and hn_bench_offset2 and hn_bench_offset3."""
        if self.benched is not None:
            return self.benched
        n = self.axes
        first, *others = self.takes
        usual = [part.usual or self.strength for name in others if name != "period" for part in PARTS[name]]
        if first == "cell":
            where = [f"hn_place({USUAL['cell'][n - 1]})"]
        elif first in ("units", "place_of_units", "candidate"):
            where = [USUAL["units"][n - 1], *(part.usual for part in PARTS[first][1:])]
            where = [f"hn_place({', '.join(where)})"] if first == "place_of_units" else where
        else:
            where = [USUAL[first][n - 1]] if first in USUAL else [part.usual for part in PARTS[first]]
        if self.has_period and first != "candidate":
            where = [f"hn_tile({where[0]}, {'64' if n == 1 else f'ivec{n}(64)'})"]
        seed = [self.bench_seed] * (self.has_seed and not self.has_unseeded)
        sets = [f"hn_bench_cell{n}", f"hn_bench_offset{n}"] * bool(self.sets)
        call = f"{self.calls}({', '.join([*where, *usual, *seed, *sets])})"
        if not self.sets:
            return call
        value = f"vec{n}({call})" if self.returns == "float" else f"vec3({call}, 0.0)" if n == 3 else call
        return f"{value} + vec{n}({sets[0]}) + {sets[1]}"


# --- Noises and sums -------------------------------------------------------------------------------------------------


def results(function: Noise | Sum, dimensions: int) -> dict[str, dict[str, Any]]:
    """The results, by the end of a row's id: five numbers do not fit into one."""
    if function.shape in ("slopes", "distance_with_slopes"):
        if dimensions < 4:
            return {"": {"gives": ("value", "d*")}}
        of = {"returns": "hn_derivatives4"}
        return {"": {"gives": ("d*",), "members": tuple(f"gradient.{axis}" for axis in AXES), **of},
                "_value": {"gives": ("value",), "members": ("value",), **of}}
    return {"": {"gives": {"value": ("value",), "two_distances": ("first", "second"),
                           "three_distances": ("first", "second", "third"),
                           "vector": ("s*",) if isinstance(function, Sum) else ("v*",)}[function.shape]}}


def of_noise(noise: Noise) -> Iterator[Function]:
    families = noise.families
    for dimensions in range(noise.first, noise.last + 1):
        is_usual = dimensions in (2, 3)
        start = f"noise{dimensions}d.{noise.name}" if noise.shape != "vector" else f"{noise.name}.{noise.name}{dimensions}"
        plain = f"noise{dimensions}d.{noise.plain}"
        usual = families.usual if is_usual else families.others
        tiles = families.tiles if is_usual else families.others
        for end, result in results(noise, dimensions).items():
            def of_form(form: str, family: str, *takes: str, **more: Any) -> Function:
                every = {"bound": noise.name, "includes": f"{noise.name}{dimensions}d.glsl", "calls": f"hn_{noise.name}",
                         "plain": f"{plain}{form}" if noise.plain else ""}
                return Function(f"{start}{form}{end}", family=family, takes=takes, type="f64", dimensions=dimensions,
                                **{**every, **result, **more})

            of_word = {"bench_seed": "floatBitsToUint(p.x)"}
            yield of_form("", usual, "position")
            yield of_form("_cell", usual, "cell", **of_word)
            yield of_form("_cell_period", tiles, "cell", "period")
            # A position in a tile is the place of its cell and its fraction. So one noise and one sum prove hn_tile of
            # positions.
            if noise.name == "perlin":
                yield of_form("_period", tiles, "position", "period")
            if "jitter" in noise.options:
                options = ["jitter", "metric"] if "metric" in noise.options else ["jitter"]
                yield of_form("_full", tiles, "position", *options)
                yield of_form("_cell_full", tiles, "cell", "period", *options)
            # A file has the noise with a phase and its derivatives.
            if "phase" in noise.options and is_usual:
                options = ["phase", *["jitter"] * ("jitter" in noise.options)]
                phase = {"bound": f"{noise.name}_phase", "calls": noise.called_with_phase,
                         "includes": f"{noise.plain or noise.name}_phase{dimensions}d.glsl"}
                family = tiles if "jitter" in options else families.others
                yield of_form("_phase", family, "position", *options, **phase)
                if "jitter" not in options:  # a period of 0 is none
                    yield of_form("_phase_cell", family, "cell", *options, **phase, **of_word)
                yield of_form("_phase_cell_period", family, "cell", "period", *options, **phase)


def of_sum(sum_: Sum) -> Iterator[Function]:
    """On the plane and in space all forms; on the line and in four dimensions some that between them have all of the
    code. There a strength beside the cell, the fraction and the period has no room."""
    families = sum_.families
    file = "warp" if sum_.shape == "vector" else "fbm_d" if sum_.of == "slopes" else "fbm"
    ratios = ["lacunarity", "gain"]
    options = ["octaves", *ratios, *([sum_.strength.name] if sum_.strength else [])]
    for dimensions in range(sum_.first, sum_.last + 1):
        is_usual = dimensions in (2, 3)
        (result,) = results(sum_, dimensions).values()

        def of_form(form: str, family: str, *takes: str) -> Function:
            return Function(f"{file}.{sum_.name}{dimensions}{form}", family, sum_.name, takes, type="f64",
                            dimensions=dimensions, includes=f"{file}{dimensions}d.glsl", calls=f"hn_{sum_.name}",
                            plain=f"{sum_.plain}.{sum_.plain}{dimensions}{form}" if sum_.plain else "",
                            strength=repr(float(sum_.strength.default)) if sum_.strength else "", **result)

        further = families.tiles if is_usual else families.others
        yield of_form("", families.usual if is_usual else families.others, "position", *options)
        has_room = len(options) + 1 + 3 * dimensions <= len(WORDS)
        if is_usual or not has_room or (sum_.name == "fbm" and dimensions == 1):
            yield of_form("_cell", further, "cell", *options)
        if has_room:
            yield of_form("_cell_period", further, "cell", "period", *options)
        if not has_room or (sum_.name == "fbm" and dimensions == 2):
            yield of_form("_period", further, "position", "period", *options)
        # With less detail: by a float of octaves, and by a footprint.
        if "detail" in sum_.options:
            yield of_form("_detail", further, "position", "detail", *ratios)
        if "footprint" in sum_.options:
            yield of_form("_footprint", further, "position", "footprint", "octaves", *ratios)


# --- Others ----------------------------------------------------------------------------------------------------------


def _of_row(group: str, name: str, keys: Mapping[str, Any], dimensions: int | None) -> Function:
    entry = Entry(FILE, f"{group}.{name}", keys)
    n = "" if dimensions is None else str(dimensions)

    def text(key: str, *default: Any) -> Any:
        value = entry.take(key, str, *default)
        return value and value.format(group=group, name=name, n=n)

    def texts(key: str) -> tuple[str, ...]:
        return tuple(entry.take(key, list))

    id_, takes, calls = text("id", "{group}.{name}{n}"), texts("takes"), text("calls")
    if unknown := {*takes} - PARTS.keys():
        raise CatalogError(f"{entry.where}: nothing is known of {min(unknown)}, which it takes")
    sets = entry.one_of("sets", ("nearest", "offset", ""), "")
    gives = (f"{sets[0]}*",) if sets else texts("gives")
    type_ = {"nearest": "i32", "offset": "f64"}[sets] if sets else entry.one_of("type", TYPES, "f64")
    member, component = entry.take("member", str, ""), entry.take("component", str, "")
    members = tuple(f"{member}.{axis}" for axis in AXES[:len(gives)]) if member else ()
    if component:
        firsts = ["value", *expanded(gives, dimensions or 1)[1:]]
        members = tuple(f"{one}.{component}" for one in firsts)
    own = calls.removeprefix("hn_")
    row = Function(id_, entry.one_of("family", families()), text("bound", own), takes, gives, type_, dimensions or 1,
                   text("includes", f"{own}{n}d.glsl"), calls, text("returns", ""), members, sets,
                   entry.take("seeded", bool, False), text("bench", None),
                   experimental=entry.take("experimental", bool, False), plain=text("plain", ""))
    entry.end()
    return row


def _of_group(groups: Mapping[str, Mapping[str, Any]], group: str) -> Iterator[Function]:
    keys = groups[group]
    if "like" in keys:
        like = groups[keys["like"]]
        keys = {**like, **{key: value for key, value in keys.items() if key != "like"}}
    every = {key: value for key, value in keys.items() if not isinstance(value, dict)}
    rows = {key: value for key, value in keys.items() if isinstance(value, dict)}
    for of_all in every.pop("dimensions", [None]):
        for name, row in rows.items():
            own = {**every, **row}
            for dimensions in own.pop("dimensions", [of_all]):
                if of_all in (None, dimensions):
                    yield _of_row(group, name, own, dimensions)


def _rows(folder: Path) -> Iterator[Function]:
    catalog, groups = read(folder), tables(folder, FILE)
    by_hand = [row for group in groups if group != "noises_and_sums" for row in _of_group(groups, group)]
    for one in (one for one in (*catalog.noises, *catalog.sums) if not one.families):
        found = {row.axes for row in by_hand if row.calls == f"hn_{one.name}"}
        if found != {*range(one.first, one.last + 1)}:
            raise CatalogError(f"catalog/{FILE}: rows of {one.name} have {sorted(found)} dimensions, and its entry has "
                               f"{one.first} to {one.last}")
    for group in groups:
        if group == "noises_and_sums":
            for noise in (noise for noise in catalog.noises if noise.families):
                yield from of_noise(noise)
            for sum_ in (sum_ for sum_ in catalog.sums if sum_.families):
                yield from of_sum(sum_)
        else:
            yield from _of_group(groups, group)


@functools.cache
def _read(folder: Path) -> tuple[Function, ...]:
    functions: dict[str, Function] = {}
    for function in _rows(folder):
        if function.id in functions:
            raise function.error("it is there already")
        if function.family not in families():
            raise function.error(f"{function.family} is not a family; there are {', '.join(families())}")
        if len(function.inputs) > len(WORDS) or len(function.outputs) > len(AXES):
            raise function.error(f"it has more words than the {len(WORDS)} that go in and the {len(AXES)} that come out")
        functions[function.id] = function
    return tuple(functions.values())


def read_functions(folder: Path = CATALOG) -> list[Function]:
    return list(_read(folder))
