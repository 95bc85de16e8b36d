"""tools/pick whole: files of the library with all that they include, as one. WGSL is translated, and its knobs are
options; in other languages the text stays as it is."""

from __future__ import annotations

import argparse
import functools
from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL
from catalog.tables.glsl import files_of
from translate.library_file import IMPORT_PATH_HELP, add_options, check_name, import_path, imported_as, write
from translate.parsing.tokens import Unknown
from translate.settings import ARITHMETICS, NO_PRECISE, Settings, settings_of
from translate.single_file.files import PLACES, text
from translate.wgsl.module import Module

EPILOG = """\
A function stands for its file; if several files have it, in one dimension each, it is answered with their names.
noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and fbm3d.glsl are
those in space; hashnoise.glsl is everything. For single functions: tools/pick hn_fbm2.

  tools/pick whole --language wgsl --arithmetic fixed fbm2d.glsl > fbm2d.wgsl
  tools/pick whole --language wgsl --import-path hashnoise --out assets/shaders/hashnoise.wgsl
"""


def of_wgsl(names: Sequence[str], settings: Settings, given: argparse.Namespace) -> str:
    header = f"""\
{imported_as(given.import_path or "")}\
// hashnoise in WGSL. Made by tools/pick whole --language wgsl from {", ".join(names)} with {settings}.
// Copyright (c) 2026 The hashnoise authors; MIT License.
//
// The functions and their comments are the GLSL's: vec2 there is vec2f here, ivec2 is vec2i, and uvec2
// is vec2u. A function with several forms there has a name for each form here, and always takes the seed: hn_perlin(p,
// seed) is hn_perlin2(p, seed), and hn_perlin(hn_tile(p, period), seed) is hn_perlin2_place(hn_tile2(p, period), seed).
// A parameter that a function sets is a pointer: hn_cellular2_nearest(p, jitter, metric, seed, &nearest, &offset).

"""
    included = "".join(f'#include "{name}"\n' for name in names)
    return header + Module(given.glsl, included, settings).text(strip=given.strip)


@functools.cache
def library(language: str, arithmetic: str, file: str = "hashnoise.glsl") -> str:
    """A file with all that it includes, and one arithmetic."""
    if language == "wgsl":
        return Module(GLSL, f'#include "{file}"\n', settings_of(arithmetic, "lattice", "octahedral")).text(strip=True)
    return f"#define HN_ARITHMETIC HN_{arithmetic.upper()}\n{text([file], language, strip=True)}"


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="tools/pick whole", description="Make one file of the library, or of parts of it.", epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--language", choices=(*PLACES, "wgsl"), default="glsl",
                        help="the language of the file (default: %(default)s)")
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--minify", action="store_true", help="as --strip, and leave out needless blanks; not of WGSL")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    parser.add_argument("names", nargs="*", default=["hashnoise.glsl"], metavar="name",
                        help="a file of glsl/hashnoise/, or a function that one of them has (default: hashnoise.glsl)")
    group = parser.add_argument_group("with --language wgsl")
    add_options(group, ARITHMETICS, "fast", "default: %(default)s; WGSL has no precise")
    group.add_argument("--import-path", metavar="NAME", type=import_path, help=IMPORT_PATH_HELP)
    group.add_argument("--glsl", type=Path, default=GLSL, metavar="DIR", help="another copy of the library")
    given = parser.parse_args(arguments)
    names = []
    for name in given.names:
        files = files_of(name, given.glsl)
        if len(files) > 1:
            parser.error(f"{name} is in {', '.join(files)}: name those that you need")
        names += files or [name]
    for name in names:
        check_name(parser, name, given.glsl)
    names = list(dict.fromkeys(names))
    is_wgsl = given.language == "wgsl"
    settings = settings_of(given.arithmetic, given.hash, given.gradient, given.hash_function or "")
    if is_wgsl and given.minify or not is_wgsl and (settings != Settings() or given.import_path or given.glsl != GLSL):
        parser.error(f"--language {given.language} has no such option: see tools/pick whole --help")
    if is_wgsl and given.arithmetic == "precise":
        parser.exit(2, f"{parser.prog}: {NO_PRECISE}\n")
    try:
        settings.macros()
    except Unknown as error:
        parser.exit(2, f"{parser.prog}: {error}\n")
    try:
        made = of_wgsl(names, settings, given) if is_wgsl else text(names, given.language, given.strip, given.minify)
    except Unknown as error:
        parser.exit(1, f"{parser.prog}: {error}\n")
    write(parser, made, given.out)
    return 0
