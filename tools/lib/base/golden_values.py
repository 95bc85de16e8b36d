"""The reader of golden files (docs/reference/formats.md), for tests: words in, and those that must come out."""

from __future__ import annotations

import functools
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from base.tree import GOLDEN

INFINITY = 0x7F800000  # the bits of the exponent of a float
Columns = tuple[tuple[str, str], ...]  # names and types


@dataclass(frozen=True)
class Head:
    """The lines before the rows."""
    calls: str           # the function of the library: hn_perlin
    columns: Columns     # what goes in
    results: Columns     # what comes out
    settings: list[str]  # those with values, in the order of their groups
    bits: str            # the version in which a value last changed
    rows: int
    size: int            # how many lines it has

    @property
    def axes(self) -> int:
        return sum(name in ("x", "y", "z", "w", "cx", "cy", "cz", "cw") for name, _ in self.columns)


def head_of(path: Path) -> Head:
    said = {}
    with path.open(encoding="ascii") as file:
        for size, line in enumerate(file, 1):
            key, _, said[key] = line.rstrip("\n").partition(" ")
            if key == "rows":
                columns, results = (tuple(tuple(column.split(":")) for column in side.split())
                                    for side in said["columns"].split(" = "))
                settings = [setting.split(":")[0] for setting in said["settings"].split()]
                return Head(said["calls"], columns, results, settings, said["bits"], int(said["rows"]), size)
    raise ValueError(f"{path} does not state how many rows it has")


class Golden:
    """The values of a function with a setting, as words: the bit patterns in the file.

    head      the lines before the rows
    inputs    a list of words for each row
    values    likewise, what must come out
    finite    without the rows that have an infinity among the inputs: packages refuse it or return NaN
    """

    def __init__(self, id: str, setting: str = "lattice+fixed", folder: Path = GOLDEN, finite: bool = True):
        path = folder / f"{id}.golden"
        self.head = head_of(path)
        rows = _rows(path.read_text(encoding="ascii"), self.head.size)
        if len(rows) != self.head.rows or not rows:
            raise ValueError(f"{id}: the head states {self.head.rows} rows, and there are {len(rows)}")
        group = 1 + self.head.settings.index(setting)
        chosen = [[[int(word, 16) for word in side.split()] for side in (row[0], row[group])] for row in rows
                  if row[group] != "-"]
        if finite:
            floats = [i for i, (_, kind) in enumerate(self.head.columns) if kind == "f32"]
            chosen = [row for row in chosen if all(row[0][i] & INFINITY != INFINITY for i in floats)]
        self.inputs, self.values = ([row[side] for row in chosen] for side in (0, 1))

    @property
    def expected(self) -> list[list[int]]:
        """The bits of results, where every one counts: those of a double are exact as those of a float."""
        return [[float_bits(word) if kind == "f64" else word for (_, kind), word in zip(self.head.results, words)]
                for words in self.values]


@functools.lru_cache(maxsize=1)  # a file is read once for each of its settings
def _rows(text: str, size: int) -> list[list[str]]:
    return [line.split(" = ") for line in text.splitlines()[size:] if not line.startswith("digest ")]


def float_bits(word: int) -> int:
    value, = struct.unpack(">d", struct.pack(">Q", word))
    bits = struct.pack("<f", value)
    if struct.unpack("<f", bits)[0] != value:
        raise ValueError(f"{word:016x} is no float")
    return struct.unpack("<I", bits)[0]


def ids(*settings: str, folder: Path = GOLDEN) -> Iterator[tuple[str, str]]:
    """The functions that have values with one of the settings, each with the first that it has."""
    for path in sorted(folder.glob("*.golden")):
        there = head_of(path).settings
        if setting := next((setting for setting in settings if setting in there), ""):
            yield path.stem, setting
