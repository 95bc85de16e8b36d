"""What commands that make a text of a file of glsl/hashnoise/ have in common: its name, and where the text goes."""

from __future__ import annotations

import argparse
import difflib
import sys
from pathlib import Path

from tables import glsl


def check_name(parser: argparse.ArgumentParser, name: str, library: Path) -> None:
    """Refuses what is no file of the library, and says which may be meant."""
    names = sorted(path.name for path in library.glob("*.glsl"))
    if name in names:
        return
    if files := glsl.files_of(name, library):
        parser.error(f"{name} is a function, and not a file: it is in {', '.join(files)}")
    if f"{name}.glsl" in names:
        near = [f"{name}.glsl"]
    else:
        near = difflib.get_close_matches(name, names)
    hint = f"did you mean {' or '.join(near)}?" if near else f"there are: {', '.join(names) or 'no files'}"
    parser.error(f"there is no {name} in {library.name}/; {hint}")


def write(parser: argparse.ArgumentParser, text: str, out: Path | None) -> None:
    """To standard output, or into a file, whose folder is made if it is not there, and whose path is printed."""
    if out is None:
        sys.stdout.write(text)
        return
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(text, encoding="ascii")
        print(out)
    except OSError as error:
        parser.error(f"cannot write {out}: {error.strerror}")
