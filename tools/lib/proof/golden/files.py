"""The contents of golden files. The tables of functions and of configurations list the files and their settings."""

from __future__ import annotations

import functools
import itertools
import struct
from collections.abc import Sequence
from dataclasses import dataclass

from catalog.tables.configurations import Configuration
from catalog.tables.functions import Column, Function
from proof.golden import rows
from proof.golden.generator import Row, fnv1a64, generator_of, to_f32
from proof.oracle.functions import evaluator, knobs_of
from proof.oracle.gradients import Real

BITS = "1.0.0"  # the version in which the values last changed


@dataclass(frozen=True)
class Digest:
    """The block of points that a digest runs over, and the seed of the functions that take one. A float stands there as
    its word."""
    origin: tuple[int, ...]
    size: tuple[int, ...]
    seed: int | None = None


# The blocks of hashes, by their arguments and by the number of axes. The blocks of words run over the wrap at 2^32,
# those of coordinates over the sign change. Rows of candidates run over the seams of a tile, too, with a radius of 1.
ONE = 0x3F800000
DIGESTS = {
    ("words", 1): Digest((0,), (16384,)),
    ("words", 2): Digest((2**32 - 64,) * 2, (128, 128)),
    ("words", 3): Digest((2**32 - 16,) * 3, (32, 32, 16)),
    ("words", 4): Digest((2**32 - 8, 2**32 - 8, 2**32 - 4, 2**32 - 4), (16, 16, 8, 8)),
    ("point", 1): Digest((-8192,), (16384,), 5),
    ("point", 2): Digest((-64, -64), (128, 128), 5),
    ("point", 3): Digest((-16, -16, -8), (32, 32, 16), 5),
    ("point", 4): Digest((-8, -8, -4, -4), (16, 16, 8, 8), 5),
    ("zero", 1): Digest((2**32 - 16,), (64,)),
    ("candidate", 2): Digest((-8, -8, 13, 11, ONE), (16, 16, 1, 1, 1), 5),
    ("candidate", 3): Digest((-4, -4, -2, 7, 5, 3, ONE), (8, 8, 4, 1, 1, 1, 1), 5),
}


def meaning(kind: str, word: int) -> int | float:
    """The meaning of a number in a digest's block, which may go on beyond the largest word."""
    if kind == "f32":
        return struct.unpack("<f", struct.pack("<I", word))[0]
    return word & 0xFFFFFFFF if kind == "u32" else word


@dataclass(frozen=True)
class Values:
    """A function with a setting: a column group of its file."""
    function: Function
    configuration: Configuration

    @property
    def name(self) -> str:
        """The name of the setting: "any" where no knob matters."""
        return "any" if self.function.family == "independent" else self.configuration.name

    @property
    def arithmetic(self) -> str:
        return "exact" if self.function.exact else self.configuration.arithmetic

    def evaluate(self, row: Row) -> tuple[Real, ...]:
        return evaluator(self.function, self.configuration.fixed)(knobs_of(self.configuration), row)

    def digest(self, digest: Digest) -> str:
        seed = () if digest.seed is None else (digest.seed,)
        knobs, evaluate = knobs_of(self.configuration), evaluator(self.function, fixed=False)
        points = itertools.product(*(range(start, start + size) for start, size in zip(digest.origin, digest.size)))
        kinds = [column.type for column in self.function.inputs]
        values = [evaluate(knobs, tuple(map(meaning, kinds, point + seed)))[0] for point in points]
        return f"{fnv1a64(struct.pack(f'<{len(values)}I', *values)):016x}"

    def start_of(self, digest: Digest) -> str:
        """The line of a digest, up to its value."""
        fields = [f"digest {self.name}"]
        fields += ["origin=" + ",".join(map(str, digest.origin)), "size=" + ",".join(map(str, digest.size))]
        fields += [f"seed={digest.seed}"] * (digest.seed is not None)
        return " ".join([*fields, "fnv1a64="])


@dataclass(frozen=True)
class GoldenFile:
    """The file of a function. `settings` are all configurations."""
    function: Function
    settings: Sequence[Configuration]

    @property
    def name(self) -> str:
        return f"{self.function.id}.golden"

    @property
    def values(self) -> list[Values]:
        return [Values(self.function, setting) for setting in self.settings
                if setting.has_golden_values and setting.covers(self.function)]

    def rows(self) -> tuple[list[Row], list[Row]]:
        """The rows that every setting has, and those that only fixed arithmetic has."""
        return rows.kept(self.function, any(values.configuration.fixed for values in self.values))

    def text(self, found: str = "", sample: Sample | None = None) -> str:
        """The file. With a sample only some values are computed; the others are as the text `found` has them. (The
        suite reads all lines, and compares the twin with all values.)"""
        function, values, (every, of_fixed) = self.function, self.values, self.rows()
        lines = ["hashnoise golden 2", f"function {function.id}", f"calls {function.calls}", f"bits {BITS}",
                 f"columns {function.columns}",
                 f"settings {' '.join(f'{group.name}:{group.arithmetic}' for group in values)}",
                 f"rows {len(every) + len(of_fixed)}"]
        chosen = None if sample is None else sample.of(function.id, len(every), len(of_fixed), len(values))
        there = found.split("\n")[len(lines):] if chosen is not None else []

        def results(row: Row, of_all: bool) -> str:
            return "".join(f" = {line(function.outputs, group.evaluate(row))}" if of_all or group.configuration.fixed
                           else " = -" for group in values)

        parts = [(line(function.inputs, row), functools.partial(results, row, i < len(every)))
                 for i, row in enumerate(every + of_fixed)]
        if function.family == "hash" and function.type == "u32":
            digest = DIGESTS[function.form, function.axes]
            parts += [(group.start_of(digest), functools.partial(group.digest, digest)) for group in values]
        for i, (start, rest) in enumerate(parts):
            is_kept = i < len(there) and i not in chosen and there[i].startswith(start)
            lines.append(there[i] if is_kept else start + rest())
        return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Sample:
    """Some lines of each file: so many of the rows that every setting has, and half as many of those of fixed
    arithmetic; and one digest. Which they are depends on `salt`, a text."""
    count: int
    salt: str

    def of(self, id: str, every: int, of_fixed: int, settings: int) -> set[int]:
        generator = generator_of(f"{id} {self.salt}")
        chosen = {generator.integer(0, every - 1) for _ in range(self.count)}
        chosen |= {every + generator.integer(0, of_fixed - 1) for _ in range(self.count // 2 if of_fixed else 0)}
        return chosen | {every + of_fixed + generator.integer(0, settings - 1)}


def golden_files(functions: Sequence[Function], configurations: Sequence[Configuration]) -> list[GoldenFile]:
    files = [GoldenFile(function, configurations) for function in functions]
    return [file for file in files if file.values]


def pattern(kind: str, value: Real) -> str:
    """The bit pattern of a value of a column type, in hexadecimal. Only for f64 may the value need rounding."""
    if kind in ("i32", "u32"):
        return f"{value & 0xFFFFFFFF:08x}"
    if kind == "f64":
        # The only rounding of a noise value: the division of two integers is correctly rounded.
        return struct.pack(">d", float(value)).hex()
    if to_f32(value) != value:
        raise ValueError(f"{value!r} is not exact in float32")
    return struct.pack(">f", value).hex()


def line(columns: Sequence[Column], values: Sequence[Real]) -> str:
    """The bit patterns of the values under the columns."""
    return " ".join(pattern(column.type, value) for column, value in zip(columns, values, strict=True))
