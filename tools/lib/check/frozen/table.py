"""The table of frozen values, conformance/expected/frozen.csv, and its faults. docs/reference/frozen.md describes what
it promises."""

from __future__ import annotations

import csv
import io
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

FIRST = 2048     # points in each run of the tests
ALL = 1024 ** 2  # points in a thorough one; the first ones are among them
COLUMNS = ("function", "setting", "since", f"points_{FIRST}", f"values_{FIRST}", f"points_{ALL}", f"values_{ALL}")
PROVISIONAL = "provisional"  # in place of the version since which the values are frozen

REMEDY = ("A frozen value must not change. If you meant it to, give what is new another name. If you did not, undo the "
          "change of glsl/: tools/test -R '^unit.expected$' names the points of golden files that differ, with the right "
          "values, and tools/make freeze --check --all compares all points, where more functions may differ")

Key = tuple[str, str]  # a function and a setting


Sums = tuple[str, str]  # checksums of the inputs at some points, and of the results


@dataclass(frozen=True)
class Entry:
    """The frozen values of a function with a setting."""

    since: str
    sums: Mapping[int, Sums]  # at FIRST points, and at ALL

    @property
    def is_frozen(self) -> bool:
        return self.since != PROVISIONAL


def parsed_version(text: str) -> tuple[int, ...]:
    return tuple(map(int, text.split(".")))


def parse(text: str) -> dict[Key, Entry]:
    """Raises ValueError with a sentence that names the line."""
    entries: dict[Key, Entry] = {}
    for number, row in enumerate(csv.reader(io.StringIO(text)), 1):
        if number == 1:
            if tuple(row) != COLUMNS:
                raise ValueError(f"line 1: it has to be {','.join(COLUMNS)}")
            continue
        if len(row) != len(COLUMNS):
            raise ValueError(f"line {number}: it has {len(row)} fields in place of {len(COLUMNS)}")
        key = (row[0], row[1])
        if key in entries:
            raise ValueError(f"line {number}: {row[0]} with {row[1]} has a line already")
        entries[key] = Entry(row[2], {FIRST: (row[3], row[4]), ALL: (row[5], row[6])})
    if not entries:
        raise ValueError("it has no entry")
    return entries


def read(path: Path) -> dict[Key, Entry]:
    try:
        return parse(path.read_text(encoding="ascii"))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def text_of(entries: Mapping[Key, Entry]) -> str:
    """In the order of the names, so that a new function is a few lines among the others."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    for key, entry in sorted(entries.items()):
        writer.writerow((*key, entry.since, *entry.sums[FIRST], *entry.sums[ALL]))
    return out.getvalue()


def parse_sums(text: str) -> dict[Key, Sums]:
    """hn-frozen's output."""
    return {(row[0], row[1]): (row[2], row[3]) for row in csv.reader(io.StringIO(text))}


def changed(entries: Mapping[Key, Entry], computed: Mapping[Key, Sums], count: int) -> Iterator[str]:
    """The entries that changed among those computed at so many points, and at the end what to do."""
    remedy = False
    for key in sorted(computed.keys() & entries.keys()):
        (points, values), entry, name = computed[key], entries[key], f"{key[0]} with {key[1]}"
        since = f"frozen since {entry.since}" if entry.is_frozen else "provisional"
        if points != entry.sums[count][0]:
            yield (f"{name}: the points are others than those of its entry, which is {since}. Let the function have "
                   "the points that it had (conformance/expected/points.cpp)")
        elif values != entry.sums[count][1]:
            yield (f"{name}: of {count} points some have other values than those of its entry, which is {since}"
                   + ("" if entry.is_frozen else ". If they are meant to change, run tools/make freeze --provisional"))
            remedy = remedy or entry.is_frozen
    if remedy:
        yield REMEDY


def missing(entries: Mapping[Key, Entry], known: Iterable[Key]) -> Iterator[str]:
    for function, setting in sorted(set(known) - entries.keys()):
        yield f"{function} with {setting}: it has no entry. Run tools/make freeze"


def gone(entries: Mapping[Key, Entry], known: Iterable[Key]) -> Iterator[str]:
    for key in sorted(entries.keys() - set(known)):
        yield (f"{key[0]} with {key[1]}: there is no such function any more. "
               + (f"It is frozen since {entries[key].since}, so it has to stay" if entries[key].is_frozen else
                  "Its entry is provisional: if the function is meant to go, run tools/make freeze --provisional"))


def unsettled(entries: Mapping[Key, Entry], version: str, experimental: Collection[str]) -> Iterator[str]:
    """Only experimental functions are provisional, and no entry is of a later version."""
    for key, entry in sorted(entries.items()):
        name = f"{key[0]} with {key[1]}"
        if entry.is_frozen and parsed_version(entry.since) > parsed_version(version):
            yield f"{name}: it is frozen since {entry.since}, but the library is {version}"
        elif entry.is_frozen and key[0] in experimental:
            yield (f"{name}: it is frozen since {entry.since}, so catalog/functions.toml cannot call it experimental "
                   "any more")
        elif not entry.is_frozen and key[0] not in experimental:
            yield f"{name}: it is provisional, and the function is not experimental. Run tools/make freeze"


def problems(entries: Mapping[Key, Entry], computed: Mapping[Key, Sums], count: int, version: str,
             experimental: Collection[str]) -> list[str]:
    """All that is wrong, where `computed` is all that the library has."""
    return [*changed(entries, computed, count), *missing(entries, computed), *gone(entries, computed),
            *unsettled(entries, version, experimental)]
