"""The library as the page has it inside, as far as pictures take it: its text, with which WebGL2 draws at once."""

from __future__ import annotations

import re

from base.tree import GLSL, glsl_files, included_from, version
from catalog.javascript import drawn, may_draw
from catalog.model import read
from translate.single_file.files import INCLUDE, lines_of, stripped, with_numbers

# The files of sums, and of what moves positions. A sum that is added has none of its own.
OF_SUMS = ("octaves", "fbm", "fbm_d", "warp")
OF_THE_HASH = "hash.glsl"
# Other files of the library's kind: languages that need names of their own.
OTHERS = ("begin.hlsl", "end.hlsl", "detail/vectors_begin.h", "detail/vectors_end.h")


def glsl() -> dict[str, list[str]]:
    """The lines of the files and of their includes, without comments. An included file has its name in the
    library."""
    found: dict[str, list[str]] = {}
    wanted = [*of_pictures(), OF_THE_HASH, *OTHERS]
    while wanted:
        name = wanted.pop()
        if name not in found:
            lines = stripped(with_numbers(lines_of(GLSL / name)))
            found[name] = [named_include(name, line) for line in lines]
            wanted += [include[1] for line in found[name] if (include := INCLUDE.match(line))]
    return dict(sorted(found.items()))


def of_pictures() -> list[str]:
    """The files that pictures are made of: of the noises that can be chosen there, of the same with slopes and with a
    phase, and of sums, in each dimension. Everybody loads the page, so it has no others."""
    noises = [noise.name + form for noise in drawn(read())[0] for form in ("", "_d", "_phase")
              if form != "_phase" or may_draw(noise, "phase")]
    files = re.compile(rf"(?:{'|'.join([*noises, *OF_SUMS])})[1-4]d\.glsl")
    return [name for name in glsl_files() if files.fullmatch(name)]


def named_include(name: str, line: str) -> str:
    return INCLUDE.sub(lambda include: f'#include "{included_from(name, include[1])}"', line)


def library() -> dict:
    return {"version": version(), "glsl": glsl()}
