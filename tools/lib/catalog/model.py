"""The catalog as catalog/*.toml have it, and its faults."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from tomllib import loads
from typing import Any, Optional

from base.tree import ROOT

CATALOG = ROOT / "catalog"
SHAPES = ("value", "slopes", "two_distances", "three_distances", "distance_with_slopes", "vector", "value_and_quadrature")
WITH_DERIVATIVES = "slopes", "distance_with_slopes"
WITH_VALUE = "value", "slopes", "value_and_quadrature"  # shapes with a component of that name
AXES = "xyzw"
OWN = "own"  # the noise of a sum that leaves no choice
MEANS = ("", "density", "billows", "bounded")  # glsl/hashnoise/detail/octave.glsl


# Two steps of glsl/hashnoise/detail/octave.glsl: the one of hn_add, and one that is not public.
PLAIN, BOUNDED = "noise", "billow"


class CatalogError(ValueError):
    """The fault, with the file and the entry."""


@dataclass(frozen=True)
class Strength:
    """The number that a sum takes beside octaves, lacunarity and gain."""
    name: str
    default: float
    most: float
    about: str


@dataclass(frozen=True)
class Families:
    """The settings for which the suite has values of a function (catalog/configurations.toml)."""
    usual: str  # on the plane and in space
    tiles: str  # there, in a tile; of a sum also from a cell
    others: str  # on the line, in four dimensions, and with a phase


@dataclass(frozen=True)
class Function:
    """A noise or a sum."""
    name: str
    first: int  # dimension
    last: int
    shape: str
    about: str  # with {dimensions}
    more: str
    returns: str
    source: str
    example: str  # the printed numbers; "" if it is left out
    options: Mapping[str, str]
    families: Families | None  # None: its rows stand there by hand
    brief: str  # for the README
    use: str  # for the pages
    plain: str  # the function without derivatives; "" of one without them

    def sentence(self) -> str:
        return self.about.format(dimensions=self.dimensions_in_words())

    def dimensions_in_words(self) -> str:
        if self.first == self.last:
            return f"in {self.first}D"
        between = "and" if self.last == self.first + 1 else "to"
        return f"in {self.first}D {between} {self.last}D"

    def is_in(self, dimensions: int) -> bool:
        return self.first <= dimensions <= self.last


Range = Optional[tuple[float, float]]  # None: it is not known


@dataclass(frozen=True)
class Noise(Function):
    small: bool  # whether the twin in WebAssembly has it
    jumps: bool  # whether it is not continuous
    ranges: Mapping[str, tuple[Range, ...]]  # by component, for each dimension from the first on

    @property
    def all_ranges(self) -> Mapping[str, tuple[Range, ...]]:
        """Also that of a value without one: src/grid/ranges.hpp takes it as in [-1, 1]."""
        usual = ((-1, 1),) * (self.last - self.first + 1) if self.shape in WITH_VALUE else ()
        return {"value": usual, **self.ranges}

    @property
    def called_with_phase(self) -> str:
        """The function with a phase. With a jitter it has a name of its own: both are floats, so that of two overloads
        one would be taken for the other."""
        return f"hn_{self.name}_phase" if "jitter" in self.options else f"hn_{self.name}"


@dataclass(frozen=True)
class Sum(Function):
    of: str  # the shape of the noises that it sums, or OWN
    noise: str  # "" of noises of its own
    range: tuple[float, float] | str  # "noise": that of the noise; its strength's name: all up to that size
    strength: Strength | None
    step: str  # by which it adds an octave to a value; "" if it is none
    mean: str  # its value from the mean
    adds_words: str  # the step's work, in words
    error: str  # in words

    @property
    def takes_noise(self) -> bool:
        return self.of != OWN

    @property
    def public_step(self) -> str | None:
        """hn_add, or hn_add_ridged for hn_ridged; None if there is none."""
        if self.step in ("", BOUNDED):
            return None
        return "hn_add" if self.step == PLAIN else f"hn_add_{self.name}"

    @property
    def step_of_loops(self) -> str:
        """The step for a loop of a user's own, "" if there is none. Billows have one that bounds the noise, and is not
        public."""
        return "hn_add_turbulence" if self.step == BOUNDED else self.public_step or ""

    @property
    def is_of_values(self) -> bool:
        """Whether it has neither slopes nor shifts: a loop over one step."""
        return self.of == self.shape == "value"

    def adds(self, sum_: str, noise: str, strength: str) -> str:
        """The expression of a sum with an octave more."""
        return f"hn_i_add_{self.step}({', '.join([sum_, noise, *([strength] if self.strength else [])])})"

    def adds_to(self, octaves: str, noise: str) -> str:
        """The statement that adds an octave, by the public step if there is one."""
        if self.public_step:
            return f"{self.public_step}({', '.join([octaves, noise, *(['strength'] if self.strength else [])])})"
        return f"{octaves}.sum = {self.adds(f'{octaves}.sum', noise, 'strength')}"

    def makes(self, mean: str) -> str:
        return f"hn_i_{self.mean}({mean})" if self.mean else mean


@dataclass(frozen=True)
class Setting:
    name: str
    is_whole: bool
    least: float | None
    most: float | None
    fixed: tuple[float | None, float | None]  # the least and the most with HN_FIXED
    default: float | None
    about: str


@dataclass(frozen=True)
class Catalog:
    noises: tuple[Noise, ...]
    sums: tuple[Sum, ...]
    settings: Mapping[str, Setting]
    metrics: tuple[str, ...]


class Entry:
    """The keys of an entry; each is taken once, and none is left."""

    def __init__(self, file: str, name: str, keys: Any) -> None:
        self.file = file
        self.where = f"catalog/{file}: {name}"
        if not isinstance(keys, dict):
            raise CatalogError(f"{self.where} has to be a table")
        self.keys = dict(keys)

    def take(self, key: str, kind: type | tuple[type, ...], *default: Any) -> Any:
        if key not in self.keys:
            if default:
                return default[0]
            raise CatalogError(f"{self.where} has no {key}")
        value = self.keys.pop(key)
        if not isinstance(value, kind) or isinstance(value, bool) != (kind is bool):
            raise CatalogError(f"{self.where}: {key} is {value!r}, which is of the wrong type")
        return value

    def one_of(self, key: str, names: tuple[str, ...], *default: str) -> str:
        value: str = self.take(key, str, *default)
        if value not in names:
            raise CatalogError(f"{self.where}: {key} is {value!r}, and has to be one of {', '.join(names)}")
        return value

    def pair(self, key: str, value: Any) -> tuple[float, float]:
        if not (isinstance(value, list) and len(value) == 2 and all(isinstance(one, (int, float)) for one in value)
                and value[0] <= value[1]):
            raise CatalogError(f"{self.where}: {key} is {value!r}, and has to be two numbers, the lesser first")
        return value[0], value[1]

    def end(self) -> None:
        if self.keys:
            raise CatalogError(f"{self.where} has a key {next(iter(self.keys))!r}, which means nothing")


def _function(entry: Entry, name: str) -> dict[str, Any]:
    first, last = entry.pair("dimensions", entry.take("dimensions", list))
    if not (isinstance(first, int) and isinstance(last, int) and 1 <= first and last <= 4):
        raise CatalogError(f"{entry.where}: dimensions are {[first, last]}, and have to be in [1, 4]")
    about: str = entry.take("about", str)
    if "{dimensions}" not in about:
        raise CatalogError(f"{entry.where}: about needs {{dimensions}}, which becomes \"in 2D and 3D\" and so on")
    options = entry.take("options", dict, {})
    return {"name": name, "first": first, "last": last, "shape": entry.one_of("shape", SHAPES, "value"), "about": about,
            "more": entry.take("more", str, ""), "returns": entry.take("returns", str),
            "source": entry.take("source", str), "example": entry.take("example", str, ""), "options": options,
            "families": _families(entry, name), "brief": entry.take("brief", str), "use": entry.take("use", str),
            "plain": entry.take("plain", str, "")}


def _families(entry: Entry, name: str) -> Families | None:
    if "rows" in entry.keys:
        entry.one_of("rows", ("by hand",))
        if "families" in entry.keys:
            raise CatalogError(f"{entry.where}: rows that stand by hand name their families themselves")
        return None
    families = Entry(entry.file, f"{name}.families", entry.take("families", dict))
    usual = families.take("usual", str)
    made = Families(usual, families.take("tiles", str, usual), families.take("others", str, usual))
    families.end()
    return made


def _noise(name: str, keys: Any) -> Noise:
    entry = Entry("noises.toml", name, keys)
    common = _function(entry, name)
    ranges = {}
    for component, by_dimension in entry.take("ranges", dict, {}).items():
        if not isinstance(by_dimension, list) or len(by_dimension) != common["last"] - common["first"] + 1:
            raise CatalogError(f"{entry.where}: the ranges of {component} have to be one for each dimension")
        ranges[component] = tuple(entry.pair(component, pair) if pair else None for pair in by_dimension)
    noise = Noise(**common, small=entry.take("small", bool, False), jumps=entry.take("jumps", bool, False), ranges=ranges)
    if unknown := noise.options.keys() - {"wave", "bandwidth", "phase", "jitter", "metric"}:
        raise CatalogError(f"{entry.where}: a noise has no option {min(unknown)}")
    entry.end()
    return noise


def _strength(where: str, keys: Any) -> Strength:
    entry = Entry("sums.toml", where, keys)
    strength = Strength(entry.one_of("name", ("strength", "amplitude")), entry.take("default", (int, float)),
                        entry.take("most", (int, float)), entry.take("about", str))
    entry.end()
    if not 0 <= strength.default <= strength.most:
        raise CatalogError(f"{entry.where}: the default is not in [0, {strength.most}]")
    return strength


def _sum(name: str, keys: Any, noises: Mapping[str, Noise]) -> Sum:
    entry = Entry("sums.toml", name, keys)
    common = _function(entry, name)
    given = entry.take("strength", dict, None)
    strength = _strength(f"{name}.strength", given) if given else None
    value = entry.take("range", (list, str))
    named = ("noise", strength.name) if strength else ("noise",)
    if isinstance(value, str) and value not in named:
        raise CatalogError(f"{entry.where}: range is {value!r}, and has to be two numbers or {' or '.join(named)}")
    of = entry.one_of("of", (*SHAPES, OWN), "value")
    made = Sum(**common, of=of, noise=entry.one_of("noise", tuple(noises), "perlin") if of != OWN else "",
               range=entry.pair("range", value) if isinstance(value, list) else value, strength=strength,
               step=entry.take("step", str, ""), mean=entry.one_of("mean", MEANS, ""),
               adds_words=entry.take("adds", str, ""), error=entry.take("error", str, ""))
    if bool(made.step) != (made.shape == "value" and made.takes_noise):
        raise CatalogError(f"{entry.where}: a sum that is a value has a step, and no other has one")
    if made.takes_noise and noises[made.noise].shape != made.of:
        raise CatalogError(f"{entry.where}: it sums noises of the shape {made.of}, and {made.noise} is none")
    entry.end()
    return made


def _setting(name: str, keys: Any) -> Setting:
    entry = Entry("settings.toml", name, keys)
    number = (int, float)
    is_whole = bool(entry.one_of("kind", ("whole", ""), ""))
    least, most = entry.take("least", number, None), entry.take("most", number, None)
    fixed = entry.take("fixed", list, [least, most])
    if len(fixed) != 2:
        raise CatalogError(f"{entry.where}: fixed has to be two numbers, and is {fixed}")
    setting = Setting(name, is_whole, least, most, (fixed[0], fixed[1]), entry.take("default", number, None),
                      entry.take("about", str))
    entry.end()
    return setting


def tables(folder: Path, file: str) -> dict[str, Any]:
    try:
        return loads((folder / file).read_text(encoding="utf-8"))
    except ValueError as error:
        raise CatalogError(f"catalog/{file}: {error}") from None


def read(folder: Path = CATALOG) -> Catalog:
    noises = {name: _noise(name, keys) for name, keys in tables(folder, "noises.toml").items()}
    sums = tuple(_sum(name, keys, noises) for name, keys in tables(folder, "sums.toml").items())
    settings = tables(folder, "settings.toml")
    metrics = Entry("settings.toml", "metrics", settings.pop("metrics", None))
    names = tuple(metrics.take("names", list))
    metrics.end()
    for function in (*noises.values(), *sums):
        if (function.shape in WITH_DERIVATIVES or getattr(function, "of", "") == "slopes") != bool(function.plain):
            raise CatalogError(f"catalog: {function.name}: what has derivatives has a plain, and nothing else")
        if function.plain and function.plain not in (*noises, *(sum_.name for sum_ in sums)):
            raise CatalogError(f"catalog: {function.name}: plain is {function.plain!r}, which is no noise and no sum")
    return Catalog(tuple(noises.values()), sums, {name: _setting(name, keys) for name, keys in settings.items()}, names)
