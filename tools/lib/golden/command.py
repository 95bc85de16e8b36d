"""Writes or checks the golden files: inputs, and what the oracle says comes out.

    tools/golden [--out DIR] [--check]

Each file is <function>.<configuration>.golden: a header, one line per row (the bit patterns of the inputs, " = ", those
of the outputs), and for hashes one digest of many more points. The functions are those of functions.inc, the
configurations those of configurations.inc; "any" where the function depends on no knob. A value that is not exact in a
float32 is the double nearest to the exact one; with fixed arithmetic it is the float itself. A digest is the 64-bit
FNV-1a of the results as 4 little-endian bytes each, over all points from `origin`, the last coordinate running fastest.

The inputs are those of rows.py; their generator is seeded with the function's name alone, so that every configuration
sees the same inputs. Fixed arithmetic has some more behind them.

Exit status: 0 written, or all is as the oracle says; 1 something is not; 2 bad usage, or a table that is wrong.
"""

from __future__ import annotations

import argparse
import itertools
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from golden.files import GoldenFile, golden_files
from tables.configurations import read_configurations
from tables.functions import read_functions
from tables.inc import TableError
from tree import GOLDEN


def generate() -> dict[str, str]:
    """All golden files: the text by the file name."""
    files = golden_files(read_functions(), read_configurations())
    with ProcessPoolExecutor() as pool:
        return dict(zip((file.name for file in files), pool.map(GoldenFile.text, files, chunksize=4)))


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
    parser.add_argument("--out", type=Path, default=GOLDEN, metavar="DIR", help=f"default: {GOLDEN}")
    parser.add_argument("--check", action="store_true", help="compare with DIR instead of writing")
    options = parser.parse_args(arguments)
    try:
        files = generate()
    except TableError as error:
        print(error, file=sys.stderr)
        return 2
    if not options.check:
        write(options.out, files)
        print(f"{len(files)} golden files written to {options.out}")
        return 0
    messages = differences(options.out, files)
    print("\n".join(messages) if messages else f"{len(files)} golden files are as the oracle says")
    return 1 if messages else 0
