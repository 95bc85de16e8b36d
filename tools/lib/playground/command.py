"""The command line of tools/playground, which describes it."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from parsing.tokens import Unknown
from playground.page import Unfit, page
from tree import ROOT


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/playground", description="Make the playground, a page of one file.",
                                     epilog="docs/playground.md tells what the page does.")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "playground.html", metavar="FILE",
                        help="the file to write (default: build/playground.html)")
    arguments = parser.parse_args()
    try:
        text = page(lambda step: print(step, file=sys.stderr, flush=True))
    except (Unknown, Unfit) as error:
        sys.stderr.write(f"tools/playground: {error}\n")
        return 1
    try:
        arguments.out.parent.mkdir(parents=True, exist_ok=True)
        arguments.out.write_text(text, encoding="utf-8")
    except OSError as error:
        parser.error(f"cannot write {arguments.out}: {error.strerror}")
    print(arguments.out.resolve())
    return 0
