"""The command line of tools/wgsl, which describes it."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from library_file import check_name, write
from parsing.tokens import Unknown
from tree import GLSL
from wgsl.module import ARITHMETICS, GRADIENTS, HASHES, Module, Settings
from wgsl.names import is_public

DESCRIPTION = "Make a WGSL module of the library."
EPILOG = """\
noise2d.glsl is the noise on the plane, and fbm2d.glsl the octave sums on the plane; noise3d.glsl and fbm3d.glsl are
those in space; hashnoise.glsl is everything. docs/languages.md tells the names of the functions.

  tools/wgsl --arithmetic HN_FIXED fbm2d.glsl > fbm2d.wgsl
  tools/wgsl --only hn_perlin3,hn_fbm2 --strip > noise.wgsl
  tools/wgsl --import-path hashnoise --only hn_fbm2 --out assets/shaders/hashnoise.wgsl
  tools/wgsl --names noise2d.glsl
"""


IMPORT_PATH = re.compile(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*")


def header(name: str, settings: Settings, import_path: str = "") -> str:
    define = f"#define_import_path {import_path}\n\n" if import_path else ""
    return f"""\
{define}\
// hashnoise in WGSL. Made by tools/wgsl from {name} with {settings}.
// Copyright (c) 2026 The hashnoise authors; MIT License.
//
// The functions are those of the GLSL, and so are their comments: vec2 there is vec2f here, ivec2 is vec2i, and uvec2 is
// vec2u. What has several forms there has a name for each form here, and always takes the seed: hn_perlin(p, seed) is
// hn_perlin2(p, seed), and hn_perlin(hn_tile(p, period), seed) is hn_perlin2_place(hn_tile2(p, period), seed). What a
// function sets is a pointer: hn_cellular2_nearest(p, jitter, metric, seed, &nearest, &offset).

"""


def parsed_arguments(parser: argparse.ArgumentParser) -> argparse.Namespace:
    parser.add_argument("--arithmetic", choices=(*ARITHMETICS, "HN_PRECISE"), default="HN_FAST", metavar="NAME",
                        help="HN_FAST (the default) or HN_FIXED. WGSL has no HN_PRECISE")
    parser.add_argument("--hash", choices=HASHES, default="LATTICE", metavar="NAME",
                        help=f"{', '.join(HASHES)} (default: %(default)s)")
    parser.add_argument("--hash-function", default="", metavar="NAME",
                        help="with --hash CUSTOM: your function, which takes and returns a u32")
    parser.add_argument("--gradient", choices=GRADIENTS, default="OCTAHEDRAL", metavar="NAME",
                        help="OCTAHEDRAL (the default) or SINE")
    parser.add_argument("--only", metavar="NAMES",
                        help="these functions and what they need, with commas between; else all public ones")
    parser.add_argument("--import-path", metavar="NAME",
                        help="for Bevy and naga_oil: write #define_import_path NAME, so that #import NAME::hn_fbm2 finds it")
    parser.add_argument("--strip", action="store_true", help="leave out comments, empty lines and indentation")
    parser.add_argument("--names", action="store_true", help="write which function of the GLSL has which name, instead")
    parser.add_argument("--glsl", type=Path, default=GLSL, metavar="DIR", help="another copy of the library")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    parser.add_argument("name", nargs="?", default="hashnoise.glsl", help="a file of glsl/hashnoise/ (default: %(default)s)")
    arguments = parser.parse_args()
    check_name(parser, arguments.name, arguments.glsl)
    if arguments.only is not None:
        arguments.only = [name.strip() for name in arguments.only.split(",") if name.strip()]
        if not arguments.only:
            parser.error("--only names no function; --names tells which there are")
    if arguments.import_path is not None and not IMPORT_PATH.fullmatch(arguments.import_path):
        parser.error(f"an import path is made of names with :: between them, such as game::noise, not "
                     f"{arguments.import_path!r}")
    return arguments


def written_names(module: Module) -> str:
    """A line for each public function, by its name in WGSL."""
    lines = [f"{new:40} {old}({', '.join(types)})" for (old, types), new in module.names().items()
             if is_public(old)]
    return "".join(f"{line}\n" for line in sorted(lines))


def check_functions(parser: argparse.ArgumentParser, only: list[str], module: Module) -> None:
    """Refuses what is no function of the module. Who writes the name that GLSL has is told those of its forms."""
    names = module.names()
    for name in only:
        if name not in names.values():
            forms = sorted({new for (old, _), new in names.items() if old == name})
            hint = f"it has a name for each form: {', '.join(forms)}" if forms else "--names tells which there are"
            parser.error(f"there is no function {name} in WGSL; {hint}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/wgsl", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments = parsed_arguments(parser)
    settings = Settings(arguments.arithmetic, arguments.hash, arguments.gradient, arguments.hash_function)
    try:
        module = Module(arguments.glsl, f'#include "{arguments.name}"\n', settings)
        if arguments.names:
            text = written_names(module)
        else:
            check_functions(parser, arguments.only or [], module)
            text = header(arguments.name, settings, arguments.import_path)
            text += module.text(arguments.only or [], arguments.strip)
    except Unknown as error:
        sys.stderr.write(f"tools/wgsl: {error}\n")
        return 1
    write(parser, text, arguments.out)
    return 0
