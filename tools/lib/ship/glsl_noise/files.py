"""The files of the drop-in for npm's glsl-noise: its names, with noise of the library that looks alike."""

from __future__ import annotations

import json
import re
from functools import cache
from typing import NamedTuple

from base.tree import GLSL, ROOT, version
from catalog.tables.markdown import table
from measure.likeness import ports
from measure.likeness.table import OLDER, ROWS
from ship.packing import of_npm, papers
from ship.recipes import RECIPES
from translate.parsing.syntax import Function
from translate.pick import command
from translate.pick.evaluate import Module
from translate.pick.program import Program, read
from translate.pick.shading import LANGUAGES

PACKAGE = ROOT / "packages" / "glsl-noise"
NAME = RECIPES["glsl-noise"].name
# The folders of glsl-noise, with the functions in their files.
FOLDERS = {"simplex": "snoise", "classic": "cnoise", "periodic": "pnoise"}
AXES = (2, 3, 4)
LATER = ("uvec2", "uvec3", "uvec4", "uintBitsToFloat", "floatBitsToUint")  # than GLSL ES 1.00
LANGUAGE = LANGUAGES["glsl"]  # for WebGL2, and for OpenGL, too


class File(NamedTuple):
    folder: str
    axes: int

    @property
    def path(self) -> str:
        """Without its ending."""
        return f"{self.folder}/{self.axes}d"

    @property
    def function(self) -> str:
        return FOLDERS[self.folder]

    @property
    def head(self) -> str:
        """Of the function, in GLSL."""
        period = f", vec{self.axes} rep" if self.folder == "periodic" else ""
        return f"float {self.function}(vec{self.axes} p{period})"


FILES = tuple(File(folder, axes) for folder in FOLDERS for axes in AXES)


@cache
def record() -> dict[str, ports.Port]:
    return ports.read()


def call(file: File) -> str:
    """Of the library: what looks like theirs, by docs/guide/moving.md."""
    theirs = f"{'cnoise' if file.folder == 'periodic' else file.function}(vec{file.axes} p)"
    rows = {row.theirs: row for row in ROWS if row.table == "webgl-noise"}
    row = rows.get(f"`{theirs}`{OLDER}", rows[f"`{theirs}`"])
    measured = record()[row.id]
    called = ports.call(row, measured.scale, measured.factor, seed="0u")
    if file.folder != "periodic":
        return called
    if ports.number(measured.scale):
        raise ValueError(f"{theirs} has a scale, with which the period would be another one")
    return called.replace("(p,", f"(hn_tile(p, ivec{file.axes}(rep)),")


@cache
def library() -> Module:
    """With the functions of all files below it."""
    heads = {file: re.sub(r"\b(float|vec\d)\b", r"hn_\1", file.head) for file in FILES}
    below = "".join(f"HN_FN {head} {{ return {call(file)}; }}\n" for file, head in heads.items())
    return read(GLSL, command.settings("fast", "lattice"), below=below)


def function(file: File) -> Function:
    types = (f"vec{file.axes}",) * (2 if file.folder == "periodic" else 1)
    return library().functions[file.function, types]


def for_glslify(text: str, prefix: str) -> str:
    """Text that glslify leaves as it is. It knows GLSL ES 1.00, and so takes types and functions that came later, and
    the u behind a number, for names of the file, which it changes. It does not change names of macros."""
    text = re.sub(r"\b(0x[0-9A-F]+|\d+)u\b", r"uint(\1)", text)
    used = [name for name in LATER if re.search(rf"\b{name}\b", text)]
    text = re.sub(rf"\b({'|'.join(LATER)})\b", rf"{prefix}\1", text)
    return "".join(f"#define {prefix}{name} {name}\n" for name in used) + text


@cache
def glsl(file: File) -> str:
    """A file's text. The names of helpers are its own, since a shader may have several of these files. Text that
    glslify exports stands where glsl-noise has it."""
    prefix = f"hn_{file.function}{file.axes}_"
    text = Program(library(), [function(file)]).text(LANGUAGE).replace("hn_i_", prefix)
    return (f"// {file.head}, of hashnoise {version()}: {call(file)}\n"
            "// Copyright (c) 2026 The hashnoise authors; MIT License.\n"
            f"{for_glslify(text, prefix)}\n#pragma glslify: export({file.function})\n")


def module(text: str) -> str:
    """The same as a string."""
    return f"export default {json.dumps(text)};\n"


def file_table() -> str:
    """The function of each file, for the page."""
    return table(("file", "function", "what it returns"),
                 [(f"`glsl-noise/{file.path}`", f"`{file.head}`", f"`{call(file)}`") for file in FILES])


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = {"package.json": of_npm((PACKAGE / "package.json").read_text(encoding="utf-8"), NAME), **papers(PACKAGE)}
    for file in FILES:
        text = glsl(file)
        found |= {f"{file.path}.glsl": text, f"{file.path}.js": module(text),
                  f"{file.path}.d.ts": "declare const text: string;\nexport default text;\n"}
    return found
