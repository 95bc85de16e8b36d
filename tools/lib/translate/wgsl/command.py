"""The command line of tools/pick whole --language wgsl."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL
from translate.library_file import IMPORT_PATH_HELP, add_options, check_name, import_path, imported_as, write
from translate.parsing.tokens import Unknown
from translate.settings import ARITHMETICS, NO_PRECISE, Settings, settings_of
from translate.wgsl.module import Module

DESCRIPTION = "Make a WGSL module of a file of the library. For single functions: tools/pick hn_fbm2 --language wgsl."
EPILOG = """\
noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and fbm3d.glsl are
those in space; hashnoise.glsl is everything. tools/pick --list prints the names of the functions.

  tools/pick whole --language wgsl --arithmetic fixed fbm2d.glsl > fbm2d.wgsl
  tools/pick whole --language wgsl --import-path hashnoise --out assets/shaders/hashnoise.wgsl
"""


def header(name: str, settings: Settings, path: str) -> str:
    return f"""\
{imported_as(path)}\
// hashnoise in WGSL. Made by tools/pick whole --language wgsl from {name} with {settings}.
// Copyright (c) 2026 The hashnoise authors; MIT License.
//
// The functions and their comments are the GLSL's: vec2 there is vec2f here, ivec2 is vec2i, and uvec2
// is vec2u. A function with several forms there has a name for each form here, and always takes the seed: hn_perlin(p,
// seed) is hn_perlin2(p, seed), and hn_perlin(hn_tile(p, period), seed) is hn_perlin2_place(hn_tile2(p, period), seed).
// A parameter that a function sets is a pointer: hn_cellular2_nearest(p, jitter, metric, seed, &nearest, &offset).

"""


def parsed_arguments(parser: argparse.ArgumentParser, given: Sequence[str]) -> argparse.Namespace:
    add_options(parser, ARITHMETICS, "fast", "default: %(default)s; WGSL has no precise")
    parser.add_argument("--import-path", metavar="NAME", type=import_path, help=IMPORT_PATH_HELP)
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--glsl", type=Path, default=GLSL, metavar="DIR", help="another copy of the library")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    parser.add_argument("name", nargs="?", default="hashnoise.glsl", help="a file of glsl/hashnoise/ (default: %(default)s)")
    arguments = parser.parse_args(given)
    check_name(parser, arguments.name, arguments.glsl)
    return arguments


def main(given: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="tools/pick whole --language wgsl", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments = parsed_arguments(parser, given)
    settings = settings_of(arguments.arithmetic, arguments.hash, arguments.gradient, arguments.hash_function or "")
    try:
        if arguments.arithmetic == "precise":
            raise Unknown(NO_PRECISE)
        settings.macros()
    except Unknown as error:
        parser.exit(2, f"{parser.prog}: {error}\n")
    try:
        module = Module(arguments.glsl, f'#include "{arguments.name}"\n', settings)
        text = header(arguments.name, settings, arguments.import_path or "") + module.text(strip=arguments.strip)
    except Unknown as error:
        sys.stderr.write(f"tools/pick whole --language wgsl: {error}\n")
        return 1
    write(parser, text, arguments.out)
    return 0
