"""The command line of tools/single-file, which describes it."""

from __future__ import annotations

import argparse
from pathlib import Path

from library_file import check_name, write
from single_file.files import PLACES, text
from tree import GLSL


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="tools/single-file", description="Make one file of the library.",
        epilog="noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and "
        "fbm3d.glsl are those in space.")
    parser.add_argument("--language", choices=tuple(PLACES), default="glsl",
                        help="the language of the file (default: %(default)s)")
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--minify", action="store_true", help="as --strip, and leave out needless blanks")
    parser.add_argument("--out", type=Path, help="the file to write (default: standard output)")
    parser.add_argument("name", nargs="?", default="hashnoise.glsl", help="a file of glsl/ (default: %(default)s)")
    arguments = parser.parse_args()
    check_name(parser, arguments.name, GLSL)
    made = text(arguments.name, arguments.language, arguments.strip, arguments.minify)
    write(parser, made, arguments.out)
    return 0
