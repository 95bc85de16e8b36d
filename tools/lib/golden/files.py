"""What stands in a golden file: which there are follows from the tables of functions and of configurations."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Sequence
from dataclasses import dataclass

from golden.generator import Row, fnv1a64, generator_of, to_f32
from golden.rows import rows_of
from oracle.functions import evaluator, knobs_of
from oracle.gradients import Real
from tables.configurations import Configuration
from tables.functions import Function

BITS = "0.3.0"  # the version in which the values last changed


@dataclass(frozen=True)
class Digest:
    """The block of points that a digest runs over, and the seed of the functions that take one."""
    origin: tuple[int, ...]
    size: tuple[int, ...]
    seed: int | None = None


# Of hashes, by what they take and by the number of axes. The blocks of words run over the wrap at 2^32, those of
# coordinates over the sign change.
DIGESTS = {
    ("words", 1): Digest((0,), (16384,)),
    ("words", 2): Digest((2**32 - 64,) * 2, (128, 128)),
    ("words", 3): Digest((2**32 - 16,) * 3, (32, 32, 16)),
    ("words", 4): Digest((2**32 - 8, 2**32 - 8, 2**32 - 4, 2**32 - 4), (16, 16, 8, 8)),
    ("point", 1): Digest((-8192,), (16384,), 5),
    ("point", 2): Digest((-64, -64), (128, 128), 5),
    ("point", 3): Digest((-16, -16, -8), (32, 32, 16), 5),
    ("point", 4): Digest((-8, -8, -4, -4), (16, 16, 8, 8), 5),
}


@dataclass(frozen=True)
class GoldenFile:
    """The file of a function with a configuration. `settings` are all configurations: some inputs are made for them."""
    function: Function
    configuration: Configuration
    settings: Sequence[Configuration]

    @property
    def configuration_name(self) -> str:
        return "any" if self.function.family == "independent" else self.configuration.name

    @property
    def name(self) -> str:
        return f"{self.function.id}.{self.configuration_name}.golden"

    @property
    def arithmetic(self) -> str:
        return "exact" if self.function.exact else self.configuration.arithmetic

    def rows(self) -> list[Row]:
        """The rows, from a generator that is seeded with the function's name alone."""
        return rows_of(self.function, self.configuration.fixed, self.settings, generator_of(self.function.id))

    def evaluate(self, row: Row) -> tuple[Real, ...]:
        return evaluator(self.function, self.configuration.fixed)(knobs_of(self.configuration), row)

    def text(self) -> str:
        function, rows = self.function, self.rows()
        knobs, evaluate = knobs_of(self.configuration), evaluator(function, self.configuration.fixed)
        lines = ["hashnoise golden 1", f"function {function.id}", f"hash {self.configuration_name}",
                 f"arithmetic {self.arithmetic}", f"bits {BITS}", f"columns {function.inputs} = {function.outputs}",
                 f"rows {len(rows)}"]
        lines += [f"{line(function.inputs, row)} = {line(function.outputs, evaluate(knobs, row))}" for row in rows]
        if function.family == "hash":
            lines.append(self.digest(DIGESTS[function.form, function.axes]))
        return "\n".join(lines) + "\n"

    def digest(self, digest: Digest) -> str:
        seed = () if digest.seed is None else (digest.seed,)
        knobs, evaluate = knobs_of(self.configuration), evaluator(self.function, fixed=False)
        points = itertools.product(*(range(start, start + size) for start, size in zip(digest.origin, digest.size)))
        values = [evaluate(knobs, point + seed)[0] for point in points]
        fields = ["digest", "origin=" + ",".join(map(str, digest.origin)), "size=" + ",".join(map(str, digest.size))]
        fields += [f"seed={s}" for s in seed]
        return " ".join(fields + [f"fnv1a64={fnv1a64(struct.pack(f'<{len(values)}I', *values)):016x}"])


def golden_files(functions: Sequence[Function], configurations: Sequence[Configuration]) -> list[GoldenFile]:
    return [GoldenFile(function, configuration, configurations) for function in functions
            for configuration in configurations if configuration.has_golden_files and configuration.covers(function)]


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


def line(header: str, values: Sequence[Real]) -> str:
    """The bit patterns of the values under the columns of a header."""
    return " ".join(pattern(column.split(":")[1], value) for column, value in zip(header.split(), values, strict=True))
