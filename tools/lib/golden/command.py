"""Writes or checks the golden files: inputs, and what the oracle says comes out.

    tools/golden [--out DIR] [--check]

Each file is <function>.<configuration>.golden: a header, one line per row (the bit patterns of the inputs, " = ", those
of the outputs), and for hashes one digest of many more points. A configuration is a hash, then "+sine", "+period<N>",
"+fixed" where HN_GRADIENT, HN_PERIOD and HN_ARITHMETIC are not the default; "any" where the function depends on none
of them. A value that is not exact in a float32 is the double nearest to the exact one; with fixed arithmetic it is the
float itself. A digest is the 64-bit FNV-1a of the results as 4 little-endian bytes each, over all points from `origin`,
the last coordinate running fastest.

The inputs are those of rows.py; their generator is seeded with the function's name alone, so that every
configuration sees the same inputs. Fixed arithmetic has some more behind them.
"""

from __future__ import annotations

import argparse
import itertools
import struct
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from golden.rows import (PERIODIC, SINE, Generator, Row, fixed_octave_rows, fixed_perlin_cell_rows,
                         fixed_perlin_rows, fnv1a64, gradient_rows, lattice_gradient_rows, lattice_rows, octave_rows,
                         perlin_cell_rows, perlin_rows, to_f32, vec_rows, word_rows)
from oracle import exact as oracle
from oracle import fixed as oracle_fixed
from tree import ROOT

BITS = "0.2.0"  # the version in which the values last changed
DEFAULT_DIR = ROOT / "conformance" / "golden"


# --- Functions --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Digest:
    """The block of points that a digest runs over, and the seed of the functions that take one."""
    origin: tuple[int, ...]
    size: tuple[int, ...]
    seed: int | None = None


@dataclass(frozen=True)
class Function:
    """A function of the library: its columns, the rows to evaluate, and how the oracle evaluates one."""
    name: str
    inputs: str
    outputs: str
    rows: Callable[[Generator], list[Row]]
    evaluate: Callable[[str, Row], tuple]
    configurations: tuple[str, ...] = oracle.HASHES
    digest: Digest | None = None
    fixed_rows: Callable[[Generator], list[Row]] | None = None  # what fixed arithmetic has behind the rows

    @property
    def exact(self) -> bool:
        return "f64" not in self.outputs

    def rows_with(self, name: str) -> list[Row]:
        """The rows with the configuration `name`."""
        generator = Generator(fnv1a64(self.name.encode("ascii")))
        rows = self.rows(generator)
        return rows + self.fixed_rows(generator) if self.fixed_rows and is_fixed(name) else rows

    def arithmetic_with(self, name: str) -> str:
        """What the file with the configuration `name` says of its arithmetic."""
        return "exact" if self.exact else "fixed" if is_fixed(name) else "fast"


def is_fixed(name: str) -> bool:
    """Whether HN_ARITHMETIC is fixed in a configuration. ("any" is the name of none.)"""
    return name != "any" and oracle.configuration(name).fixed


def oracle_of(name: str) -> ModuleType:
    """The oracle of a configuration's noise: both have functions of the same names."""
    return oracle_fixed if is_fixed(name) else oracle


def hash_functions() -> list[Function]:
    """hash.*: the exact functions of a hash."""
    def words(name: str, row: Row) -> tuple:
        return (oracle.hash_words(name, row),)

    def lattice(name: str, row: Row) -> tuple:
        return (oracle.lattice(name, row[:-1], row[-1]),)

    # The blocks of words run over the wrap at 2^32, those of coordinates over the sign change.
    vec_digests = {
        2: Digest((2**32 - 64,) * 2, (128, 128)),
        3: Digest((2**32 - 16,) * 3, (32, 32, 16)),
        4: Digest((2**32 - 8, 2**32 - 8, 2**32 - 4, 2**32 - 4), (16, 16, 8, 8)),
    }
    lattice_digests = {
        1: Digest((-8192,), (16384,), 5),
        2: Digest((-64, -64), (128, 128), 5),
        3: Digest((-16, -16, -8), (32, 32, 16), 5),
        4: Digest((-8, -8, -4, -4), (16, 16, 8, 8), 5),
    }
    functions = [Function("hash.word", "key:u32", "value:u32", word_rows, words, digest=Digest((0,), (16384,)))]
    for n, digest in vec_digests.items():
        functions.append(Function(f"hash.vec{n}", columns(n, "u32"), "value:u32",
                                  lambda generator, n=n: vec_rows(n, generator), words, digest=digest))
    for n, digest in lattice_digests.items():
        functions.append(Function(f"hash.lattice{n}", columns(n, "i32") + " seed:u32", "value:u32",
                                  lambda generator, n=n: lattice_rows(n, generator), lattice, digest=digest))
    return functions


def float_functions() -> list[Function]:
    """hash.*: the exact functions from a word to a float, which do not depend on the hash."""
    def function(name: str, outputs: str, rows: Callable, evaluate: Callable) -> Function:
        return Function(name, "h:u32", outputs, rows, evaluate, ("any",))

    return [
        function("hash.gradient2", columns(2, "f32"), gradient_rows, lambda _, row: oracle.gradient2(*row)),
        function("hash.gradient3", columns(3, "f32"), gradient_rows, lambda _, row: oracle.gradient3(*row)),
        function("hash.unorm", "value:f32", word_rows, lambda _, row: (oracle.unorm(*row),)),
        function("hash.snorm", "value:f32", word_rows, lambda _, row: (oracle.snorm(*row),)),
    ]


# The noise in fixed arithmetic: with another hash and with a period only where these matter. Octave sums are the same
# above any noise.
FIXED_SUMS = ("lattice+fixed", "lattice+sine+fixed")
FIXED_NOISES = (*FIXED_SUMS, "fnv1+fixed", "lattice+period48+fixed")


def lattice_gradient_functions(n: int) -> list[Function]:
    """hn_gradient: exact as gradient.lattice*, with the sine gradient.sine*."""
    def function(kind: str, outputs: str, configurations: tuple[str, ...]) -> Function:
        return Function(f"gradient.{kind}{n}", columns(n, "i32") + " seed:u32", outputs,
                        lambda generator: lattice_gradient_rows(n, generator),
                        lambda name, row: oracle_of(name).gradient(name, row[:n], row[n]), configurations)

    return [function("lattice", columns(n, "f32", "g"), (*oracle.HASHES, *PERIODIC)),
            function("sine", columns(n, "f64", "g"), (*SINE, "lattice+sine+fixed"))]


def noise_functions(n: int) -> list[Function]:
    """The functions of n dimensions whose arithmetic is the device's floats, or fixed."""
    noises = (*oracle.HASHES, *SINE, *PERIODIC, *FIXED_NOISES)
    sums = (*oracle.HASHES, "lattice+sine", *FIXED_SUMS)

    def octave_sum(kind: str) -> Function:
        return Function(f"fbm.{kind}{n}", columns(n, "f32") + " octaves:i32 lacunarity:f32 gain:f32 seed:u32",
                        "value:f64", lambda generator: octave_rows(n, generator),
                        lambda name, row: (getattr(oracle_of(name), kind)(name, row[:n], *row[n:]),), sums,
                        fixed_rows=lambda generator: fixed_octave_rows(n, generator))

    cell_columns = columns(n, "i32", "c") + " " + columns(n, "f32", "f") + " seed:u32"
    return [
        Function(f"noise{n}d.perlin", columns(n, "f32") + " seed:u32", "value:f64",
                 lambda generator: perlin_rows(n, generator),
                 lambda name, row: (oracle_of(name).perlin(name, row[:n], row[n]),), noises,
                 fixed_rows=lambda generator: fixed_perlin_rows(n, generator)),
        Function(f"noise{n}d.perlin_cell", cell_columns, "value:f64",
                 lambda generator: perlin_cell_rows(n, generator),
                 lambda name, row: (oracle_of(name).perlin_cell(name, row[:n], row[n:2 * n], row[2 * n]),), noises,
                 fixed_rows=lambda generator: fixed_perlin_cell_rows(n, generator)),
        *map(octave_sum, ("fbm", "turbulence", "clouds")),
    ]


def columns(n: int, kind: str, prefix: str = "") -> str:
    """The first n of x, y, z, w as columns of one type."""
    return " ".join(f"{prefix}{axis}:{kind}" for axis in "xyzw"[:n])


def functions() -> list[Function]:
    of_dimensions = [function for n in (2, 3) for function in lattice_gradient_functions(n) + noise_functions(n)]
    return hash_functions() + float_functions() + of_dimensions


# --- Text -------------------------------------------------------------------------------------------------------


def pattern(kind: str, value: oracle.Real) -> str:
    """The bit pattern of a value of a column type, in hexadecimal. Only for f64 may the value need rounding."""
    if kind in ("i32", "u32"):
        return f"{value & 0xFFFFFFFF:08x}"
    if kind == "f64":
        # The only rounding of a noise value: the division of two integers is correctly rounded.
        return struct.pack(">d", float(value)).hex()
    if to_f32(value) != value:
        raise ValueError(f"{value!r} is not exact in float32")
    return struct.pack(">f", value).hex()


def line(header: str, values: Sequence[oracle.Real]) -> str:
    """The bit patterns of the values under the columns of a header."""
    return " ".join(pattern(column.split(":")[1], value) for column, value in zip(header.split(), values, strict=True))


def digest_line(function: Function, name: str) -> str:
    """The digest of a function under the hash `name`."""
    digest = function.digest
    seed = () if digest.seed is None else (digest.seed,)
    ranges = [range(start, start + size) for start, size in zip(digest.origin, digest.size)]
    values = [function.evaluate(name, point + seed)[0] for point in itertools.product(*ranges)]
    value = fnv1a64(struct.pack(f"<{len(values)}I", *values))
    fields = ["digest", "origin=" + ",".join(map(str, digest.origin)), "size=" + ",".join(map(str, digest.size))]
    fields += [f"seed={s}" for s in seed]
    return " ".join(fields + [f"fnv1a64={value:016x}"])


def render(function: Function, name: str) -> str:
    """The golden file of a function with the configuration `name`."""
    rows = function.rows_with(name)
    lines = [
        "hashnoise golden 1",
        f"function {function.name}",
        f"hash {name}",
        f"arithmetic {function.arithmetic_with(name)}",
        f"bits {BITS}",
        f"columns {function.inputs} = {function.outputs}",
        f"rows {len(rows)}",
    ]
    for row in rows:
        lines.append(line(function.inputs, row) + " = " + line(function.outputs, function.evaluate(name, row)))
    if function.digest:
        lines.append(digest_line(function, name))
    return "\n".join(lines) + "\n"


def generate() -> dict[str, str]:
    """All golden files: the text by the file name."""
    return {f"{function.name}.{name}.golden": render(function, name)
            for function in functions() for name in function.configurations}


# --- Files ------------------------------------------------------------------------------------------------------


def stale(directory: Path, files: dict[str, str]) -> list[str]:
    """The golden files in the directory which are not among `files`."""
    return sorted(path.name for path in directory.glob("*.golden") if path.name not in files)


def write(directory: Path, files: dict[str, str]) -> None:
    """Makes the golden files of the directory be `files`."""
    directory.mkdir(parents=True, exist_ok=True)
    for name in stale(directory, files):
        (directory / name).unlink()
    for name, text in files.items():
        (directory / name).write_bytes(text.encode("ascii"))


def first_difference(expected: str, found: str) -> str:
    """The first line in which two different texts differ, one-based."""
    pairs = itertools.zip_longest(expected.splitlines(keepends=True), found.splitlines(keepends=True))
    number, pair = next((number, pair) for number, pair in enumerate(pairs, 1) if pair[0] != pair[1])
    return f"line {number}: expected {pair[0]!r}, found {pair[1]!r}"


def differences(directory: Path, files: dict[str, str]) -> list[str]:
    """What is wrong with the golden files in the directory, one message per file."""
    messages = []
    for name, text in sorted(files.items()):
        path = directory / name
        if not path.is_file():
            messages.append(f"{name}: missing")
        elif (found := path.read_bytes()) != text.encode("ascii"):
            # latin-1 shows any byte, and keeps different bytes different.
            messages.append(f"{name}: differs, {first_difference(text, found.decode('latin-1'))}")
    return messages + [f"{name}: extra" for name in stale(directory, files)]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="golden", description="Writes or checks the golden files.")
    parser.add_argument("--out", type=Path, default=DEFAULT_DIR, metavar="DIR", help="default: conformance/golden")
    parser.add_argument("--check", action="store_true", help="compare with DIR instead of writing")
    options = parser.parse_args(arguments)
    files = generate()
    if not options.check:
        write(options.out, files)
        print(f"{len(files)} golden files written to {options.out}")
        return 0
    messages = differences(options.out, files)
    print("\n".join(messages) if messages else f"{len(files)} golden files are as the oracle says")
    return 1 if messages else 0
