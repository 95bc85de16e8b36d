"""Writes or checks the golden files: inputs, and the oracle's results.

    tools/make golden [--out DIR] [--only NAMES] [--check [--sample N]]

Each file is <function>.golden (docs/reference/formats.md). The functions and the settings are in catalog/; "any"
where the function depends on no knob. A value that is not exact in a float32 is the double nearest to the exact one;
with fixed arithmetic it is the float itself. A digest is the 64-bit FNV-1a of the results as 4 little-endian bytes
each, over all points from `origin`, the last coordinate running fastest.

The inputs are those that the committed files have, the same for every setting. Fixed arithmetic has some more behind
them. A new function takes those of the file with the same columns (rows.py).

With --sample the oracle computes N rows of each file, with every setting, and N / 2 of those that only fixed arithmetic
has; the heads and the inputs of all rows are compared as ever. Which rows they are follows from the text of the oracle
and of the contract, so that a change of one of these selects other rows than before.

With --only it makes the files of functions that match the pattern, such as 'warp.*'; all others stay as
they are, and are not looked at. It may be given several times.

Exit status: 0 written, or all files equal the oracle's; 1 something is not; 2 bad usage, or a table that is wrong.
"""

from __future__ import annotations

import hashlib
import itertools
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from fnmatch import fnmatchcase
from functools import partial
from pathlib import Path

from base.tree import GOLDEN, ROOT, TOOLS
from base.usage import Parser
from catalog.model import CATALOG, CatalogError
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import read_functions
from proof.golden.files import GoldenFile, Sample, golden_files


def generate(directory: Path | None = None, sample: Sample | None = None, only: Sequence[str] = ()) -> dict[str, str]:
    """The golden files, all or those whose functions a pattern matches: the text by the file name. Rows that a sample
    leaves out are as in the file in the directory."""
    files = [file for file in golden_files(read_functions(), read_configurations())
             if not only or any(fnmatchcase(file.function.id, pattern) for pattern in only)]
    with ProcessPoolExecutor() as pool:
        return dict(zip((file.name for file in files), pool.map(partial(generated, directory, sample), files)))


def generated(directory: Path | None, sample: Sample | None, file: GoldenFile) -> str:
    path = directory / file.name if directory else None
    # latin-1 takes any byte. A text that is no value is computed.
    return file.text(path.read_bytes().decode("latin-1") if path and path.is_file() else "", sample)


def salt() -> str:
    """It changes if a source of the values changes: the contract, the oracle, or a table."""
    modules = [path for folder in ("oracle", "golden") for path in (TOOLS / "lib" / "proof" / folder).rglob("*.py")
               if not path.stem.endswith("_test")]
    digest = hashlib.sha256()
    for path in (ROOT / "docs" / "reference" / "contract.md", *sorted(CATALOG.glob("*.toml")), *sorted(modules)):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def stale(directory: Path, files: dict[str, str]) -> list[str]:
    """The golden files in the directory which are not among `files`."""
    return sorted(path.name for path in directory.glob("*.golden") if path.name not in files)


def write(directory: Path, files: dict[str, str], all_of_them: bool = True) -> None:
    """Makes the golden files of the directory be `files`, or have `files` among them."""
    directory.mkdir(parents=True, exist_ok=True)
    for name in stale(directory, files) if all_of_them else ():
        (directory / name).unlink()
    for name, text in files.items():
        (directory / name).write_bytes(text.encode("ascii"))


def first_difference(expected: str, found: str) -> str:
    """The first line in which two different texts differ, one-based."""
    pairs = itertools.zip_longest(expected.splitlines(keepends=True), found.splitlines(keepends=True))
    number, pair = next((number, pair) for number, pair in enumerate(pairs, 1) if pair[0] != pair[1])
    return f"line {number}: expected {pair[0]!r}, found {pair[1]!r}"


def differences(directory: Path, files: dict[str, str], all_of_them: bool = True) -> list[str]:
    """Faults of the golden files in the directory, which should have no others if these are all; one message
    per file."""
    messages = []
    for name, text in sorted(files.items()):
        path = directory / name
        if not path.is_file():
            messages.append(f"{name}: missing")
        elif (found := path.read_bytes()) != text.encode("ascii"):
            # latin-1 shows any byte, and keeps different bytes different.
            messages.append(f"{name}: differs, {first_difference(text, found.decode('latin-1'))}")
    return messages + [f"{name}: extra" for name in (stale(directory, files) if all_of_them else ())]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make golden", __doc__)
    parser.add_argument("--out", type=Path, default=GOLDEN, metavar="DIR", help=f"default: {GOLDEN}")
    parser.add_argument("--only", action="append", default=[], metavar="NAMES",
                        help="only functions whose names this pattern matches, such as 'warp.*'")
    parser.add_argument("--check", action="store_true", help="compare with DIR instead of writing")
    parser.add_argument("--sample", type=int, metavar="N", help="compute so many rows of each file, with --check")
    options = parser.parse_args(arguments)
    if options.sample is not None and not (options.check and options.sample > 0):
        parser.error("--sample wants a positive number, and --check")
    sample = Sample(options.sample, salt()) if options.sample else None
    try:
        files = generate(options.out if sample else None, sample, options.only)
    except CatalogError as error:
        print(error, file=sys.stderr)
        return 2
    if not files:
        parser.error(f"no function has such a name: {' '.join(options.only)}")
    if not options.check:
        write(options.out, files, all_of_them=not options.only)
        print(f"{len(files)} golden files written to {options.out}")
        return 0
    messages = differences(options.out, files, all_of_them=not options.only)
    what = f"{options.sample} rows and more of each of {len(files)}" if sample else f"{len(files)}"
    print("\n".join(messages) if messages else f"{what} golden files equal the oracle's")
    return 1 if messages else 0
