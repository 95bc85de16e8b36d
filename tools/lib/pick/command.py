"""Writes functions of the library with what they need, and nothing else, to paste into a shader, or into a program for
the CPU.

    tools/pick hn_perlin2                              GLSL, HN_FAST, the default hash
    tools/pick hn_fbm3 hn_cellular2 --arithmetic fixed --out noise.glsl
    tools/pick hn_simplex3 --language rust --out noise.rs
    tools/pick --list                                  which functions there are

A function is called as tools/wgsl calls it, by its form: hn_perlin2 is hn_perlin(vec2 p, uint seed), and
hn_perlin2_place is hn_perlin(hn_place2 place, uint seed). What it is made of stands in its place; what is called more
than once stays a function. What is known is computed, and what nothing needs is gone. The values are those of the
library. For the CPU a function has the name of its form: perlin2 in Rust, Perlin2 in C# and Go, hn_perlin2 in C.

Ask for all functions of a shader or program at once: two texts may have the same function.

Exit status: 0 done, 2 bad usage.
"""

from __future__ import annotations

import argparse
import shlex
import sys
from collections.abc import Sequence
from pathlib import Path

from library_file import write
from parsing.tokens import Unknown
from pick.c import C
from pick.csharp import CSharp
from pick.go import Go
from pick.java import Java
from pick.javascript import JavaScript, TypeScript
from pick.printer import LANGUAGES
from pick.program import Program, chosen, facts, heading, origin, public, read
from pick.rust import Rust
from pick.scalars import Syntax, text
from tree import GLSL
from wgsl.module import HASHES

ARITHMETICS = ("fast", "fixed", "precise")
NO_PRECISE = ("GLSL ES has `precise` from 3.20 on, and what this writes is for 3.00, too: take --arithmetic fixed, "
              "whose bits are the same everywhere")


SYNTAXES: dict[str, type[Syntax]] = {"rust": Rust, "csharp": CSharp, "c": C, "typescript": TypeScript,
                                     "javascript": JavaScript, "java": Java, "go": Go}


def settings(arithmetic: str, hash_: str) -> dict[str, str]:
    return {"HN_ARITHMETIC": f"HN_{arithmetic.upper()}", "HN_HASH": f"HN_HASH_{hash_.upper()}"}


def picked(names: Sequence[str], language: str = "glsl", arithmetic: str = "fast", hash_: str = "lattice",
           library: Path = GLSL) -> str:
    """The text."""
    module = read(library, settings(arithmetic, hash_), splits=language in SYNTAXES)
    functions = chosen(module, names)
    command = ["tools/pick", *dict.fromkeys(names)]
    given = {"language": (language, "glsl"), "arithmetic": (arithmetic, "fast"), "hash": (hash_, "lattice")}
    for option, (value, default) in given.items():
        command += [f"--{option}", value] if value != default else []
    if language in SYNTAXES:
        return text(Program(module, functions), SYNTAXES[language](arithmetic == "precise"),
                    facts(functions, library), origin(shlex.join(command)))
    return heading(functions, shlex.join(command), library) + Program(module, functions).text(
        LANGUAGES[language], precise=arithmetic == "precise")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/pick", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    hashes = tuple(name.lower() for name in HASHES if name != "CUSTOM")
    parser.add_argument("names", nargs="*", metavar="FUNCTION", help="such as hn_perlin2")
    parser.add_argument("--language", choices=(*LANGUAGES, *SYNTAXES), default="glsl",
                        help="glsl (the default) is for 3.30 and later, and with precise for 4.00; glsl-es says highp, "
                        "and is for WebGL2, too; hlsl is for the shader models 5 and 6; rust needs core alone; csharp "
                        "is a static class; c is a header of C99; typescript and javascript are "
                        "modules; java is for 17 and later; go for 1.18 and later")
    parser.add_argument("--arithmetic", choices=ARITHMETICS, default="fast", help="default: %(default)s")
    parser.add_argument("--hash", choices=hashes, default="lattice", metavar="NAME",
                        help=f"{', '.join(hashes)} (default: %(default)s)")
    parser.add_argument("--list", action="store_true", help="write the names of the functions, and what they take")
    parser.add_argument("--glsl", type=Path, default=GLSL, metavar="DIR", help="another copy of the library")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    given = parser.parse_args(arguments)
    if given.list == bool(given.names):
        parser.error("name functions, such as hn_perlin2, or ask for --list")
    if given.arithmetic == "precise" and given.language == "glsl-es":
        parser.error(NO_PRECISE)
    try:
        if given.list:
            known = public(read(given.glsl, settings(given.arithmetic, given.hash)))
            written = "".join(f"{name:32} {function.type} {function.name}({', '.join(function.types)})\n"
                              for name, function in sorted(known.items()))
        else:
            written = picked(given.names, given.language, given.arithmetic, given.hash, given.glsl)
    except (Unknown, OSError) as error:
        parser.exit(2, f"tools/pick: {error}\n")
    write(parser, written, given.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
