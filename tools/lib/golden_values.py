"""The reader of golden files, for tests: points in, and the bits that must come out."""

from __future__ import annotations

import struct
from pathlib import Path


class Golden:
    """A file of golden values: the words that go in, and those that must come out."""

    def __init__(self, path: Path):
        lines = path.read_text(encoding="ascii").split("\n")
        columns = next(line for line in lines if line.startswith("columns ")).removeprefix("columns ")
        self.types = [column.split(":")[1] for column in columns.split(" = ")[1].split()]
        rows = [line.split(" = ") for line in lines if " = " in line and line[0] in "0123456789abcdef"
                and not line.startswith("columns")]
        self.inputs = [[int(word, 16) for word in inputs.split()] for inputs, _ in rows]
        self.expected = [[self._word(kind, word) for kind, word in zip(self.types, outputs.split())]
                         for _, outputs in rows]

    @staticmethod
    def _word(kind: str, text: str) -> int:
        """The bits that a float has; those of a double are exact as one."""
        if kind != "f64":
            return int(text, 16)
        value = struct.unpack(">d", bytes.fromhex(text))[0]
        bits = struct.pack("<f", value)
        if struct.unpack("<f", bits)[0] != value:
            raise ValueError(f"{text} is no float")
        return struct.unpack("<I", bits)[0]
