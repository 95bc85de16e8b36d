"""The command line of tools/single-file, which describes it."""

from __future__ import annotations

import argparse
import pathlib
import sys

from single_file.files import PLACES, text
from tree import GLSL


def main() -> int:
    parser = argparse.ArgumentParser(
        description="Make one file of the library.",
        epilog="noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and "
        "fbm3d.glsl are those in space.")
    parser.add_argument("--language", choices=tuple(PLACES), default="glsl",
                        help="the language of the file (default: %(default)s)")
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--minify", action="store_true", help="as --strip, and leave out blanks that say nothing")
    parser.add_argument("--out", help="the file to write (default: standard output)")
    parser.add_argument("name", nargs="?", default="hashnoise.glsl", help="a file of glsl/ (default: %(default)s)")
    arguments = parser.parse_args()
    if not (GLSL / arguments.name).is_file():
        names = ", ".join(sorted(path.name for path in GLSL.glob("*.glsl")))
        parser.error(f"there is no {arguments.name} in glsl/; there are: {names}")
    made = text(arguments.name, arguments.language, arguments.strip, arguments.minify)
    if arguments.out is None:
        sys.stdout.write(made)
        return 0
    try:
        pathlib.Path(arguments.out).write_text(made, encoding="ascii")
    except OSError as error:
        parser.error(f"cannot write {arguments.out}: {error.strerror}")
    return 0
