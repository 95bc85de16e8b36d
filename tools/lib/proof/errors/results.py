"""The results whose errors are published, and where each is searched: the function, and from where its arguments are."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from catalog.tables.functions import WORDS, Function, read_functions
from proof.bounds.rounded import FIXED, SINES, Body, table
from proof.errors.record import CELL, DERIVATIVE, FLOATS, OFFSET, POSITION, VALUE, Key
from proof.errors.record import FIXED as INTEGERS

FRACTION = "fraction:0:0.99999994"
LEAST_APART = 1 / 800  # two points of cellular noise: where it takes the other one, an offset jumps by that at least


@dataclass(frozen=True)
class Search:
    """A function, and the keys of its outputs: "" for one that has none."""
    function: str
    macros: tuple[str, ...]
    keys: tuple[Key | None, ...]
    arguments: Mapping[str, str] = field(default_factory=dict)  # beside those that are usual

    def inputs(self, body: Body) -> list[str]:
        return [self.arguments.get(column.name) or usual(column.name) for column in body.inputs]

    def outputs(self, body: Body) -> list[str]:
        groups = list(dict.fromkeys(key for key in self.keys if key))
        found = []
        for column, key in zip(body.outputs, self.keys):
            jump, by = math.inf, "one"
            if key and key.result == OFFSET or key and key.name == "cellular_d":
                jump = LEAST_APART
            if key and (key.name, key.result) == ("cellular_d", DERIVATIVE):
                by = "output:0"  # the distance
            if key and key.name == "uniform" and key.result in ("slope", "reach"):
                by = f"{'input' if key.result == 'slope' else 'inverse'}:{[one.name for one in body.inputs].index('reach')}"
            found.append(f"{groups.index(key) if key else len(groups)}:{jump}:{by}")
        return found

    @property
    def groups(self) -> list[Key]:
        return list(dict.fromkeys(key for key in self.keys if key))


def usual(name: str) -> str:
    """Where an argument is from."""
    of = {"seed": "any", "metric": "word:1:5", "phase": "float:-1:1", "jitter": "float:0:1", "bandwidth": "float:0:16",
          "noise": "float:-1:1", "reach": "float:0.0625:3", "a": "float:0:1", "b": "float:0:1", "c": "float:0:1",
          "detail": "float:0:32", "gain": "float:0:1"}
    if name in of:
        return of[name]
    if len(name) == 2 and name[1] in "xyzw":
        return {"c": "word:-1000:1000", "f": FRACTION, "p": "word:0:0", "k": "float:-16:16"}[name[0]]
    return {axis: "position:-64:64" for axis in "xyzw"}[name]


# --- Noises -----------------------------------------------------------------------------------------------------------


@functools.cache
def functions() -> dict[tuple[str, int, str, str], list[Function]]:
    """By noise, axes, form and kind of results: those with most arguments first, without a period if there is one."""
    found: dict[tuple[str, int, str, str], list[Function]] = {}
    for function in read_functions():
        if function.form in (POSITION, CELL) and function.type == "f64":
            noise = f"{function.bound.removesuffix('_d')}_vector_d" if "_vector_d" in function.id else function.bound
            for kind in dict.fromkeys(kind_of(column.name) for column in function.outputs):
                found.setdefault((noise, function.axes, function.form, kind), []).append(function)
    for some in found.values():
        some.sort(key=lambda one: (one.has_period * one.axes - len(one.inputs), one.has_period))
    return found


def kind_of(output: str) -> str:
    if output[0] in "oxy":  # of a vector to a point
        return OFFSET
    return DERIVATIVE if output[0] == "d" and len(output) == 2 else VALUE


def of_noises() -> Iterator[Search]:
    for name, dims in sorted({key[:2] for key in functions()}):
        of_lattice = name.startswith("perlin")
        for gradient in ("octahedral", *("sine",) * (name == "perlin" and dims in (2, 3))) if of_lattice else ("none",):
            for place, arithmetic in ((CELL, FLOATS), (POSITION, FLOATS), (CELL, INTEGERS)):
                macros = (FIXED,) * (arithmetic == INTEGERS) + (SINES,) * (gradient == "sine")
                chosen: dict[str, Function] = {}
                for kind in (VALUE, DERIVATIVE, OFFSET):
                    # With HN_FIXED a position is a cell and a fraction.
                    some = functions().get((name, dims, place, kind)) or (
                        arithmetic == INTEGERS and functions().get((name, dims, POSITION, kind)))
                    if some:
                        chosen.setdefault(some[0].id, some[0])
                for function in chosen.values():
                    yield Search(function.id, macros, tuple(
                        Key(name, dims, gradient, kind_of(column.name), "", place, arithmetic) for column in function.outputs))


# Rows that no search comes near: they keep the number of 1.1.0.
KEPT = {
    "random": "it is exact, but near a whole number a position with HN_FIXED may count to the next cell",
    "hex_tiling": "where a skewed coordinate rounds over a whole number, weights and vectors are those of other corners",
    "cell_border": "its error grows as 1 / s with the distance s of two points, and few seeds have points as near as 1/512",
}


def is_kept(key: Key) -> bool:
    """Such a row; the step from an fBm to a density, which 1.1.0 proved for each density; and sums at positions of few bits,
    which the search does not draw."""
    return key.name in KEPT or key.result == "density" or "exact positions" in key.setting


def of_others() -> Iterator[Search]:
    """The sine gradient, and uniform values."""
    for arithmetic, macros in ((FLOATS, ()), (INTEGERS, (FIXED,))):
        for dims in (2, 3):
            key = Key("sine", 0, "sine", VALUE, "", CELL, arithmetic)
            yield Search(f"gradient.sine{dims}", (*macros, SINES), (key,) * dims, dict.fromkeys("xyz", "word:-1000000:1000000"))
        of = {result: Key("uniform", 0, "none", result, "", CELL, arithmetic)
              for result in (VALUE, "slope", "reach", "coefficient")}
        yield Search("uniform.uniform_d", macros, (of[VALUE], of["slope"]))
        yield Search("uniform.spread_fbm", macros, (of["reach"], *(of["coefficient"],) * 3))


# --- Sums -------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Setting:
    """An octave sum: with |p| <= 16, 5 octaves, lacunarity 2 and gain 1/2, or with these arguments."""
    sum: str
    dims: tuple[int, ...]
    words: str = ""
    arguments: Mapping[str, str] = field(default_factory=dict)
    places: tuple[str, ...] = (POSITION,)
    gradients: tuple[str, ...] = ("octahedral", "sine")
    form: str = ""  # how the function's name ends
    far: int = 16
    is_own: bool = False  # over hn_simplex_d: of own_bodies

    def gradients_in(self, dims: int) -> tuple[str, ...]:
        return tuple(gradient for gradient in self.gradients if gradient != "sine" or dims in (2, 3))


def number(x: float) -> str:
    return f"float:{x}:{x}"


TILE = {axis: "word:1:64" for axis in ("px", "py", "pz")}
BOTH = (POSITION, CELL)
GULLIES = tuple((octaves, depth, slope) for octaves, depth, slope in (
    (2, 0.1, 1), (3, 0.05, 1), (3, 0.1, 1), (3, 0.1, 3), (5, 0.05, 1), (5, 0.05, 3), (5, 0.1, 1), (5, 0.1, 3), (5, 0.2, 3)))
SETTINGS = (
    Setting("fbm", (2,), "a tile, exact positions", TILE, (CELL,), form="_cell_period"),
    Setting("fbm", (2,), "a tile", TILE, (CELL,), form="_cell_period"),
    Setting("fbm", (1, 2, 3, 4)),
    Setting("fbm", (3,), "further out", {"octaves": "word:8:8"}, BOTH, far=1024),
    Setting("fbm", (2,), "4.5 octaves", {"detail": number(4.5)}, form="_detail"),
    Setting("fbm", (2,), "a footprint of 1/16", {"footprint": number(1 / 16)}, form="_footprint"),
    *(Setting(name, (2,)) for name in ("turbulence", "clouds", "billow", "ridged", "hybrid")),
    Setting("ping_pong", (2,), "strength 2", {"strength": number(2)}),
    Setting("weighted", (2,), "strength 1", {"strength": number(1)}),
    Setting("fbm_d", (2, 3), places=BOTH, gradients=("octahedral",)),
    Setting("fbm_d", (2, 3), "over hn_simplex_d, in a loop", places=BOTH, gradients=("none",), is_own=True),
    *(Setting("eroded", (2, 3), f"strength {x}", {"strength": number(x)}, BOTH, ("octahedral",)) for x in (1, 16)),
    Setting("warp", (2, 3), "amplitude 1/2", {"amplitude": number(0.5)}, BOTH, ("none",)),
    *(Setting("warp_progressive", (2, 3), f"amplitude {words}", {"amplitude": number(x)}, BOTH, ("none",))
      for words, x in (("1/4", 0.25), ("1/2", 0.5), ("1", 1))),
    Setting("curl_fbm", (2, 3), places=BOTH, gradients=("none",)),
    Setting("curl_fbm", (2, 3), "with a phase", places=BOTH, gradients=("none",), form="_phase"),
    *(Setting("gullies", (2,), f"{octaves} octaves, depth {depth}, a slope of {slope}",
              {"octaves": f"word:{octaves}:{octaves}", "depth": number(depth), "ex": f"float:{-slope}:{slope}"},
              (CELL,), ("none",), form="_cell_period") for octaves, depth, slope in GULLIES))


LOOP = ("hn_octaves{n} o = hn_octaves({at}, int({octaves}), float_of({lacunarity}), float_of({gain}), {seed}); hn_slopes{n} s = "
        "hn_slopes(o); while (hn_next(o)) hn_add(o, s, hn_simplex_d(o.place, o.seed)); hn_vec{m} n = hn_mean(o, s); "
        "return uvec4(bits_of(n.x), bits_of(n.y), bits_of(n.z), {last});")


def own_bodies() -> dict[str, Body]:
    """The bodies of fbm_d over another noise, which is no row of the suite's table."""
    of = {}
    for dims in (2, 3):
        for place in (POSITION, CELL):
            model = table()[f"fbm_d.fbm_d{dims}{'_cell' * (place == CELL)}"]
            words = dict(zip([column.name for column in model.inputs], WORDS))
            numbers = [f"float_of({words[prefix + axis]})" for prefix in ("f" * (place == CELL),) for axis in "xyz"[:dims]]
            cells = [f"int({words['c' + axis]})" for axis in "xyz"[:dims]] if place == CELL else []
            at = f"vec{dims}({', '.join(numbers)})"
            code = LOOP.format(n=dims, m=dims + 1, at=f"hn_place(ivec{dims}({', '.join(cells)}), {at})" if cells else at,
                               last="bits_of(n.w)" if dims == 3 else "0u", **words)
            of[f"{OWN}{dims}{place}"] = Body(model.inputs, model.outputs, code)
    return of


OWN = "simplex_loop"


def bodies() -> dict[str, Body]:
    return table() | own_bodies()


def of_sums() -> Iterator[Search]:
    for setting in SETTINGS:
        for dims in setting.dims:
            for gradient in setting.gradients_in(dims):
                for place, arithmetic in [*((place, FLOATS) for place in setting.places), (setting.places[-1], INTEGERS)]:
                    yield of_sum(setting, dims, gradient, place, arithmetic)


def of_sum(setting: Setting, dims: int, gradient: str, place: str, arithmetic: str) -> Search:
    name = f"{setting.sum}{'' if setting.sum == 'gullies' else dims}{setting.form}"
    name += "_cell" * (place == CELL and "cell" not in name)
    id = f"{OWN}{dims}{place}" if setting.is_own else next(id for id in table() if id.split(".")[1] == name)
    far = setting.far
    usual_of_sums = {"octaves": "word:5:5", "lacunarity": number(2), "gain": number(0.5)} | dict.fromkeys("xyzw", f"position:{-far}:{far}") | {f"c{axis}": f"word:{-far}:{far - 1}" for axis in "xyzw"}
    arguments = usual_of_sums | setting.arguments
    body = bodies()[id]
    if setting.sum == "gullies":
        names = [column.name for column in body.inputs]
        arguments["ey"] = f"beside:{names.index('ex')}:{setting.arguments['ex'].split(':')[2]}"
    macros = (FIXED,) * (arithmetic == INTEGERS) + (SINES,) * (gradient == "sine")
    keys = tuple(None if setting.sum == "fbm_d" and column.name == "value" else  # an fBm's
                 Key(setting.sum, dims, gradient, kind_of(column.name), setting.words, place, arithmetic)
                 for column in body.outputs)
    return Search(id, macros, keys, arguments)


def searches() -> list[Search]:
    """All of them."""
    return [*of_noises(), *of_others(), *of_sums()]
