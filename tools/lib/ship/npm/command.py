"""The command line of tools/pack npm. pack.sh makes the package."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from base.usage import Parser
from ship.packing import add_folder, checked_folder, make_folder

DESCRIPTION = """\
Makes the npm package hashnoise-VERSION.tgz, and prints its path.

Clang compiles the twin to WebAssembly, and npm packs. On Debian missing packages for that are installed. The package
has the same bytes for the same commit.

Exit status: 0 done, 2 bad usage, 4 it could not be made."""


def main(arguments: Sequence[str]) -> int:
    parser = Parser("tools/pack npm", DESCRIPTION)
    add_folder(parser, "build/npm")
    folder = checked_folder(parser, parser.parse_args(arguments))
    make_folder(parser, folder)
    os.execvp("bash", ["bash", str(Path(__file__).with_name("pack.sh")), str(folder.resolve())])
