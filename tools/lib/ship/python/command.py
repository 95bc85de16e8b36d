"""The command line of tools/pack python. wheel.sh makes the wheel, and the source distribution."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from base.usage import Parser
from ship.packing import add_folder, checked_folder, make_folder

DESCRIPTION = """\
Builds the Python package as a wheel, checks it, and prints its path.

Packages of PyPI build it (scikit-build-core, nanobind) and check it (numpy); if PYTHON is that of a virtual
environment, it may have numpy and pip already. The check is that the wheel can be installed into a new virtual
environment, and that `python -m hashnoise.check` finds the bits of its vectors there. The wheel is for this machine and
those like it; the workflow `release` makes the wheels of PyPI by cibuildwheel and pyproject.toml.

Exit status: 0 done, 1 the wheel computes wrong values, 2 bad usage, 4 it could not be built."""


def main(arguments: Sequence[str]) -> int:
    parser = Parser("tools/pack python", DESCRIPTION)
    add_folder(parser, "build/wheels")
    parser.add_argument("--python", default="python3", metavar="PYTHON", help="the one that it is for (default: python3)")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--sdist", action="store_true",
                      help="the source distribution in its place: of it pip makes the package on any machine that has a "
                           "C++20 compiler, and cibuildwheel the wheels of PyPI")
    kind.add_argument("--library", metavar="FILE",
                      help="a libhashnoise-grid.a of this source, with which the wheel is linked; else its kernels "
                           "are compiled, for all instruction sets, which takes some minutes. A wheel for others wants "
                           "those")
    given = parser.parse_args(arguments)
    folder = checked_folder(parser, given)
    if given.library is not None and not Path(given.library).is_file():
        parser.error(f"there is no library {given.library}")
    if not shutil.which(given.python):
        parser.error(f"there is no program {given.python}; --python takes a Python, for instance python3.12")
    is_old = "import sys; sys.exit(sys.version_info < (3, 10))"
    if subprocess.run([given.python, "-c", is_old], check=False).returncode != 0:
        parser.error(f"{given.python} is no Python 3.10 or later")
    make_folder(parser, folder)
    os.execvp("bash", ["bash", str(Path(__file__).with_name("wheel.sh")), str(folder.resolve()), given.python,
                       given.library or "", "1" if given.sdist else ""])
