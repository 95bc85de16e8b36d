"""Writes or checks the vectors: rows of the golden files as JSON, for ports of the library to other languages.

    tools/vectors [--check] [--out DIR] [--program PATH]

Each file of vectors/ is FUNCTION.json, and index.json lists them; docs/porting.md tells what they hold. Run it after
tools/golden. The bounds of floats are asked of hn-tolerances, which tools/test builds.

Exit status: 0 written, or all is as it should be; 1 something is not; 2 bad usage, or there is no such program.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from golden.command import differences, write
from tree import ROOT, VECTORS
from vectors.files import NoVectors, vectors

PROGRAM = ROOT / "build" / "conformance" / "hn-tolerances"
ENDING = "json"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/vectors", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with DIR instead of writing")
    parser.add_argument("--out", type=Path, default=VECTORS, metavar="DIR", help="default: vectors/")
    parser.add_argument("--program", type=Path, default=PROGRAM, metavar="PATH",
                        help="hn-tolerances (default: build/conformance/hn-tolerances)")
    given = parser.parse_args(arguments)
    try:
        files = vectors(given.program.resolve())
        if not given.check:
            write(given.out, files, ENDING)
            print(f"{len(files)} files written to {given.out}")
            return 0
    except NoVectors as error:
        parser.exit(2, f"tools/vectors: {error}\n")
    except OSError as error:
        parser.exit(2, f"tools/vectors: cannot write {error.filename}: {error.strerror}\n")
    messages = differences(given.out, files, ENDING)
    right = f"{len(files)} files are as they should be"
    print("\n".join([*messages, "tools/vectors writes them"]) if messages else right)
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
