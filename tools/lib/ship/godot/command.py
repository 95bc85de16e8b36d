"""The command line of tools/godot-addon, which describes it."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from ship.godot.files import archive, archive_name
from tree import ROOT

DESCRIPTION = """\
Make the add-on for Godot 4.4 and later, and print its path.

The file has addons/hashnoise/ as a project has it: the parts of the library, each as one .gdshaderinc, and an
example. The same tree makes the same bytes; the times in it are SOURCE_DATE_EPOCH's, or of 1980.
"""


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/godot-addon", description=DESCRIPTION,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=str(ROOT / "build" / "godot"), metavar="FOLDER",
                        help="where the file goes (default: build/godot)")
    given = parser.parse_args().folder
    if not given:
        parser.error("the folder has no name")
    folder = Path(given)
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "0")
    if not seconds.isdigit():
        parser.error(f"SOURCE_DATE_EPOCH is a number of seconds, not {seconds}")
    if folder.exists() and not folder.is_dir():
        parser.error(f"{folder} is a file; it must be a folder, or a name for a new one")
    made = folder / archive_name()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        made.write_bytes(archive(int(seconds)))
    except OSError as error:
        parser.error(f"cannot write {made}: {error.strerror}")
    print(made)
    return 0
