"""The sets of golden values with every bit significant, and the checksum of each: what every device that is right
returns. conformance/expected/exact_sets.hpp has the same sets in the same order."""

from __future__ import annotations

import csv
import itertools
import struct
import zlib
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

EXACT = (":exact", ":fixed")
COLUMNS = ("function", "setting", "checksum")


def bits_of(words: Iterable[str], kinds: Iterable[str]) -> bytes:
    """Words of a golden file as little-endian words of 32 bits; a double stands for a float."""
    numbers = [int(word, 16) for word in words]
    doubles = (struct.unpack("<d", struct.pack("<Q", number))[0] if kind == "f64" else number
               for number, kind in zip(numbers, itertools.cycle(kinds)))
    return b"".join(struct.pack("<f", one) if isinstance(one, float) else struct.pack("<I", one) for one in doubles)


class Sets:
    """functions, settings: of each set, by its number; golden: the checksum of the files."""

    def __init__(self, functions: list[str], settings: list[str], golden: str):
        self.functions, self.settings, self.golden = functions, settings, golden

    def __len__(self) -> int:
        return len(self.functions)

    def group(self, number: int) -> str:
        return self.functions[number].partition(".")[0]

    def is_fixed(self, number: int) -> bool:
        return self.settings[number].endswith(":fixed")

    def checksum(self, number: int) -> int:
        raise NotImplementedError

    def combined(self, numbers: Iterable[int]) -> str:
        """The checksum of several sets, in their order."""
        words = b"".join(struct.pack("<I", self.checksum(number)) for number in sorted(numbers))
        return f"{zlib.crc32(words):08x}"


class GoldenSets(Sets):
    """The sets of a folder of golden files."""

    def __init__(self, folder: Path):
        functions, settings = [], []
        self.paths: dict[str, Path] = {}
        golden = 0
        for path in sorted(folder.glob("*.golden"), key=lambda path: path.stem):
            data = path.read_bytes()
            golden = zlib.crc32(data, golden)
            self.paths[path.stem] = path
            line = next(line for line in data.split(b"\n", 8) if line.startswith(b"settings "))
            for setting in line.decode("ascii").split()[1:]:
                if setting.endswith(EXACT):
                    functions.append(path.stem)
                    settings.append(setting)
        super().__init__(functions, settings, f"{golden:08x}")
        self.checksums: dict[str, dict[str, int]] = {}

    def checksum(self, number: int) -> int:
        function = self.functions[number]
        if function not in self.checksums:
            self.checksums[function] = self._read(self.paths[function])
        return self.checksums[function][self.settings[number]]

    @staticmethod
    def _read(path: Path) -> dict[str, int]:
        head, rows = [], []
        for line in path.read_text(encoding="ascii").splitlines():
            if " = " in line and not line.startswith("columns "):
                rows.append(line.split(" = "))
            else:
                head.append(line.split(" ", 1))
        said = dict(head[1:])
        kinds = [column.rpartition(":")[2] for column in said["columns"].partition(" = ")[2].split()]
        return {setting: zlib.crc32(bits_of((word for row in rows if row[group] != "-" for word in row[group].split()),
                                            kinds))
                for group, setting in enumerate(said["settings"].split(), 1) if setting.endswith(EXACT)}


class FrozenSets(Sets):
    """The sets of a version whose golden files are gone, from the file that `write` made."""

    def __init__(self, path: Path):
        with path.open(encoding="ascii", newline="") as file:
            first, *rows = list(csv.reader(file))
        if first[0] != "golden" or not rows or tuple(rows[0]) != COLUMNS:
            raise ValueError(f"{path}: it does not begin with golden,CHECKSUM and {','.join(COLUMNS)}; "
                             "tools/make results --freeze writes it")
        super().__init__([row[0] for row in rows[1:]], [row[1] for row in rows[1:]], first[1])
        self.rows = rows[1:]

    @cached_property
    def numbers(self) -> list[int]:
        return [int(row[2], 16) for row in self.rows]

    def checksum(self, number: int) -> int:
        return self.numbers[number]


def write(path: Path, sets: Sets) -> None:
    """For FrozenSets."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("golden", sets.golden))
        writer.writerow(COLUMNS)
        writer.writerows((sets.functions[number], sets.settings[number], f"{sets.checksum(number):08x}")
                         for number in range(len(sets)))
