"""The command line of tools/playground, which describes it."""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

from base.javascript import environment
from base.tree import ROOT
from ship.playground.page import Unfit, page
from translate.parsing.tokens import Unknown

PICTURE = ROOT / "docs" / "images" / "playground.png"
LOOKS = ROOT / "playground" / "looks.webp"  # which the page has inside


def draw(html: Path, file: Path) -> int:
    """Writes LOOKS or PICTURE of a page, in Chromium; the exit status of the program that does."""
    folder = ROOT / "build" / "javascript"
    command = ["node", ROOT / "playground" / "picture.mjs", html.resolve(), file]
    return subprocess.run([sys.executable, "-B", environment.__file__, "run", folder, *command], check=False).returncode


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/playground", description="Make the playground, a page of one file.",
                                     epilog="docs/guide/playground.md describes the page.")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "playground.html", metavar="FILE",
                        help="the file to write (default: build/playground.html)")
    parser.add_argument("--picture", action="store_true",
                        help="also write docs/images/playground.png and playground/looks.webp, the pictures of the page "
                        "and of its looks, in Chromium")
    arguments = parser.parse_args()
    out = arguments.out

    def tell(step: str) -> None:
        print(step, file=sys.stderr, flush=True)

    status = 0
    try:
        out.parent.mkdir(parents=True, exist_ok=True)  # before what takes long
        out.write_text(page(tell), encoding="utf-8")
        for file in (LOOKS, PICTURE) if arguments.picture else ():
            status = status or draw(out, file)
            out.write_text(page(tell), encoding="utf-8")  # with the new looks
    except (Unknown, Unfit) as error:
        sys.stderr.write(f"tools/playground: {error}\n")
        return 1
    except OSError as error:
        parser.error(f"cannot write {out}: {error.filename}: {error.strerror}")
    print(out.resolve())
    return status
