"""Writes or checks the vectors: rows of the golden files as JSON, for ports of the library to other languages.

    tools/make vectors [--check [--sample N]] [--out DIR] [--program PATH]

Each file of vectors/ is FUNCTION.json, and index.json lists them; docs/porting.md tells what they hold. Run it after
tools/make golden. The bounds of floats are asked of hn-tolerances, which tools/test builds. With --sample N so many
files are made and compared, others whenever the contract, the oracle or a table changes.

Exit status: 0 written, or all is as it should be; 1 something is not; 2 bad usage, or there is no such program.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from base.tree import ROOT, VECTORS
from base.usage import Parser
from catalog.tables.functions import read_functions
from proof.golden.command import differences, salt, write
from proof.golden.generator import generator_of
from proof.vectors.files import INDEX, NoVectors, vectors

PROGRAM = ROOT / "build" / "conformance" / "hn-tolerances"
ENDING = "json"


def sampled(folder: Path, count: int) -> dict[str, str]:
    """The files of a folder but for so many."""
    found = {path.name: path.read_text(encoding="latin-1") for path in sorted(folder.glob(f"*.{ENDING}"))}
    found.pop(INDEX, None)
    generator = generator_of(f"vectors {salt()}")
    for _ in range(min(count, len(found))):
        del found[generator.pick(list(found))]
    ours = {f"{function.id}.{ENDING}" for function in read_functions()}
    return {name: text for name, text in found.items() if name in ours}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make vectors", __doc__)
    parser.add_argument("--check", action="store_true", help="compare with DIR instead of writing")
    parser.add_argument("--sample", type=int, metavar="N", help="make so many files, with --check")
    parser.add_argument("--out", type=Path, default=VECTORS, metavar="DIR", help="default: vectors/")
    parser.add_argument("--program", type=Path, default=PROGRAM, metavar="PATH",
                        help="hn-tolerances (default: build/conformance/hn-tolerances)")
    given = parser.parse_args(arguments)
    if given.sample is not None and not (given.check and given.sample > 0):
        parser.error("--sample wants a positive number, and --check")
    try:
        files = vectors(given.program.resolve(), sampled(given.out, given.sample) if given.sample else {})
        if not given.check:
            write(given.out, files, ENDING)
            print(f"{len(files)} files written to {given.out}")
            return 0
    except NoVectors as error:
        parser.exit(2, f"tools/make vectors: {error}\n")
    except OSError as error:
        parser.exit(2, f"tools/make vectors: cannot write {error.filename}: {error.strerror}\n")
    messages = differences(given.out, files, ENDING)
    right = f"{given.sample or len(files)} files of {len(files)} are as they should be"
    print("\n".join([*messages, "tools/make vectors writes them"]) if messages else right)
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
