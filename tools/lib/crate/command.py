"""Makes the Rust crate hashnoise, and prints where it is.

    tools/crate [--zip] [--only MODULES] [FOLDER]

It is hashnoise-VERSION/ in FOLDER, which is build/rust unless you name one; what was there is replaced. With --zip it
is hashnoise-rust-VERSION.zip in its place. It has what tools/pick writes of the functions that are asked for most, with
HN_FAST and with HN_FIXED, and the vectors to which `cargo test` holds it. Nothing but Python is needed. It takes some
minutes. --only place,perlin,hash makes some modules, which is for tests: place and hash are always needed.

The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.
Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

import argparse
import difflib
import os
import shutil
from collections.abc import Sequence
from pathlib import Path

from crate.files import MODULES, package
from tree import ROOT, version
from zips import zipped

ALL = (*MODULES, "hash")
NEEDED = ("place", "hash")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/crate", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=str(ROOT / "build" / "rust"), metavar="FOLDER",
                        help="where it goes (default: build/rust)")
    parser.add_argument("--zip", action="store_true", help="one file, for a release")
    parser.add_argument("--only", default=",".join(ALL), metavar="MODULES", help=f"of {', '.join(ALL)}")
    given = parser.parse_args(arguments)
    if not given.folder:
        parser.error("the folder has no name")
    modules = [*dict.fromkeys(name.strip() for name in given.only.split(","))]
    for name in modules:
        if name not in ALL:
            near = difflib.get_close_matches(name, ALL, 1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(ALL)}"
            parser.error(f"there is no module {name}; {hint}")
    for name in NEEDED:
        if name not in modules:
            parser.error(f"the others need the module {name}")
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "0")
    if not seconds.isdigit():
        parser.error(f"SOURCE_DATE_EPOCH is a number of seconds, not {seconds}")
    folder = Path(given.folder)
    if folder.exists() and not folder.is_dir():
        parser.error(f"{folder} is a file; it must be a folder, or a name for a new one")
    made = folder / (f"hashnoise-rust-{version()}.zip" if given.zip else f"hashnoise-{version()}")
    files = package(modules)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if given.zip:
            packed = {f"hashnoise-{version()}/{name}": text.encode("utf-8") for name, text in files.items()}
            made.write_bytes(zipped(packed, int(seconds)))
        else:
            put(made, files)
    except OSError as error:
        parser.error(f"cannot write {error.filename or made}: {error.strerror}")
    print(made)
    return 0


def put(folder: Path, files: dict[str, str]) -> None:
    """The files, and no others that an earlier run left. What cargo made stays."""
    for path in folder.glob("*"):
        if path.name not in ("target", "Cargo.lock"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
