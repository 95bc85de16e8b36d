"""The errors that are published: record.csv has for each the number of 1.1.0, which was proven, and the largest that
`tools/make errors` found."""

from __future__ import annotations

import csv
import functools
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from pathlib import Path

PATH = Path(__file__).with_name("record.csv")
FACTOR = 2  # of the largest error that was found: ten times the effort found at most 1.25 times as much, in nine rows of ten
STEADY = 0.5  # the part of it that a search with a twentieth of the effort finds, or the search has not come to its end
POSITION, CELL = "position", "cell"
FLOATS, FIXED = "floats", "fixed"
VALUE, DERIVATIVE, OFFSET = "value", "derivative", "offset"


@dataclass(frozen=True)
class Key:
    """An error: of a noise, or of a sum with these settings."""
    name: str
    dims: int
    gradient: str  # octahedral, sine or none
    result: str
    setting: str
    place: str
    arithmetic: str

    def __str__(self) -> str:
        words = [self.name, f"{self.dims}D" if self.dims else "", self.gradient.replace("none", ""), self.result,
                 self.setting, f"from a {self.place}", self.arithmetic]
        return ", ".join(filter(None, words))


@dataclass(frozen=True)
class Entry:
    key: Key
    proven: float  # what 1.1.0 published; infinite for what is newer
    found: float  # the largest error of the long search; nan where there is none: results.KEPT
    short: float  # that of the short search, with another seed
    alike: tuple[float, float] = (0.0, 0.0)  # the largest of both, of results that have the same error

    @property
    def most(self) -> float:
        return max(self.found, self.alike[0])

    @property
    def is_steady(self) -> bool:
        return max(self.short, self.alike[1]) >= STEADY * self.most

    @property
    def published(self) -> float:
        """Twice what was found, unless 1.1.0 has a smaller number. It has the number where the search has not come to
        its end."""
        measured = FACTOR * self.most if self.is_steady else math.inf
        return math.nextafter(min(measured, self.proven), 0.0)  # so that rounding up returns the decimals of the record

    @property
    def proven_or_published(self) -> float:
        return self.proven if math.isfinite(self.proven) else self.published


COLUMNS = (*(field.name for field in fields(Key)), "proven", "found", "short")


@functools.cache
def read(path: Path = PATH) -> dict[Key, Entry]:
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    entries = [Entry(Key(**{name: int(row[name]) if name == "dims" else row[name] for name in COLUMNS[:7]}),
                     *(float(row[name] or "nan") for name in COLUMNS[7:])) for row in rows]
    of_groups: dict[tuple, list[Entry]] = {}
    for entry in entries:
        of_groups.setdefault(group_of(entry.key), []).append(entry)

    def alike(key: Key) -> tuple[float, float]:
        """A position may be in any cell, so it has the error from there."""
        some = [one for one in of_groups[group_of(key)] if one.key.place in (CELL, key.place) and not math.isnan(one.found)]
        return max((one.found for one in some), default=0.0), max((one.short for one in some), default=0.0)

    return {entry.key: replace(entry, alike=alike(entry.key)) for entry in entries}


def group_of(key: Key) -> tuple:
    """Noises that compute a value or a derivative in the same steps: hn_perlin, hn_perlin_d and hn_perlin_vector."""
    name = key.name if key.name.startswith("cellular") else re.sub(r"_vector|_d(?=_|$)", "", key.name)
    return name, key.dims, key.gradient, key.result, key.setting, key.arithmetic


def text_of(entries: Iterable[Entry]) -> str:
    def number(x: float) -> str:
        return "" if math.isnan(x) else f"{x:.3g}"

    lines = [COLUMNS, *((*(getattr(entry.key, name) for name in COLUMNS[:7]), *map(number, (entry.proven, entry.found, entry.short)))
                        for entry in entries)]
    return "".join(",".join(f'"{cell}"' if "," in str(cell) else str(cell) for cell in line) + "\n" for line in lines)


def published(name: str, dims: int, gradient: str, result: str = VALUE, place: str = CELL, arithmetic: str = FLOATS,
              setting: str = "") -> float:
    return entry_of(Key(name, dims, gradient, result, setting, place, arithmetic)).published


def proven(name: str, dims: int, gradient: str, result: str = VALUE, place: str = CELL, arithmetic: str = FLOATS) -> float:
    """For a proof of more: no number of it is measured."""
    entry = entry_of(Key(name, dims, gradient, result, "", place, arithmetic))
    if math.isinf(entry.proven):
        raise LookupError(f"{PATH}: the error of {entry.key} is measured, and a proof needs one that is proven")
    return entry.proven


def entry_of(key: Key) -> Entry:
    try:
        return read()[key]
    except KeyError:
        raise LookupError(f"{PATH} has no row of {key}: run tools/make errors") from None
