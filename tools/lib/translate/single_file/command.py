"""The command line of tools/pick whole in all languages but WGSL."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL
from catalog.tables.glsl import files_of
from translate.library_file import check_name, write
from translate.single_file.files import PLACES, text


def main(given: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="tools/pick whole", description="Make one file of the library, or of parts of it.",
        epilog="A function that several files have, in one dimension each, is answered with their names. noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and "
        "fbm3d.glsl are those in space.")
    parser.add_argument("--language", choices=(*PLACES, "wgsl"), default="glsl",
                        help="the language of the file (default: %(default)s)")
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--minify", action="store_true", help="as --strip, and leave out needless blanks")
    parser.add_argument("--out", type=Path, help="the file to write (default: standard output)")
    parser.add_argument("names", nargs="*", default=["hashnoise.glsl"], metavar="name",
                        help="a file of glsl/hashnoise/, or a function that one of them has (default: hashnoise.glsl)")
    arguments = parser.parse_args(given)
    names = []
    for name in arguments.names:
        files = files_of(name)
        if len(files) > 1:
            parser.error(f"{name} is in {', '.join(files)}: name those that you need")
        names += files or [name]
    for name in names:
        check_name(parser, name, GLSL)
    made = text(list(dict.fromkeys(names)), arguments.language, arguments.strip, arguments.minify)
    write(parser, made, arguments.out)
    return 0
