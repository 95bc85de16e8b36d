"""The public functions of the library, read from its text."""

from __future__ import annotations

import functools
import re
from dataclasses import dataclass
from pathlib import Path

from base.tree import GLSL, glsl_files

LIBRARY = GLSL
FUNCTION = re.compile(r"^HN_FN\s+\w+\s+(hn_(?!i_)\w+)\(((?:[^()]|\([^()]*\))*)\)\s*\{", re.MULTILINE)
# Definitions of public functions in any form: words and a name, and a body.
ANY_FUNCTION = re.compile(r"^ *(?:\w+ +)+(hn_(?!i_)\w+)\([^;{]*\{", re.MULTILINE)
OF_SUMS = re.compile(r'^#include "octaves(\d)d\.glsl"$', re.MULTILINE)  # in the files of sums
OF_THE_PLANE = re.compile(r"// Generated for .* dimensions from the lines above\.")  # names the origin of overloads
EXAMPLE = re.compile(r"^   example  +(\S.*(?:\n {6,}\S.*)*)", re.MULTILINE)  # of a call, in a comment
STATEMENTS = re.compile(r"(?:^   \S+ \S.*;(?: *//.*)?$\n?)+", re.MULTILINE)  # between the sentences of a comment


@dataclass(frozen=True)
class Comment:
    """A block of lines over a function: the number of the first, and their text without the slashes."""
    line: int
    lines: tuple[str, ...]

    @property
    def examples(self) -> list[str]:
        text = "\n".join(self.lines)
        return [*STATEMENTS.findall(text), *(re.sub(r"\s+", " ", found) for found in EXAMPLE.findall(text))]

    @property
    def headings(self) -> set[str]:
        """The headings of its lines: returns, error, cost and so on."""
        return {match[1] for line in self.lines if (match := re.match(r" {2,3}(\w+) {2}", line))}


@dataclass(frozen=True)
class Declaration:
    """A public function, and the block of comment over it or over the overload before it."""
    path: Path
    line: int
    name: str
    types: tuple[str, ...]  # of its arguments, as in GLSL: vec2, uint
    comment: Comment | None
    dimensions_of_sums: int | None = None  # in a file of sums
    arguments: tuple[str, ...] = ()  # their names

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.types)})"

    @property
    def place(self) -> str:
        return f"{self.path}:{self.line}"


def _type(argument: str) -> str:
    """The type of an argument like "hn_vec2 p": "vec2"; "out vec2" of one that the function sets, or changes."""
    written = argument.split()[-2]
    out = re.fullmatch(r"HN_I_(?:IN)?OUT\((\w+)\)", written)
    return f"out {out[1].removeprefix('hn_')}" if out else written.removeprefix("hn_")


def _comment_above(lines: list[str], line: int) -> Comment | None:
    """The comment that ends above a line, which is counted from 1, and above the directives that select it."""
    while line > 1 and lines[line - 2].startswith("#if"):
        line -= 1
    first = line
    while first > 1 and lines[first - 2].startswith("//"):
        first -= 1
    if first == line or OF_THE_PLANE.fullmatch(lines[first - 1]):
        return None
    return Comment(first, tuple(text.removeprefix("//") for text in lines[first - 1:line - 1]))


def _functions(text: str) -> list[tuple[int, str, tuple[str, ...], tuple[str, ...]]]:
    """Where each public function is defined, its name, and the types and the names of its arguments."""
    found = []
    for match in FUNCTION.finditer(text):
        arguments = match[2].split(",")
        names = tuple(argument.split()[-1] for argument in arguments)
        found.append((match.start(), match[1], tuple(map(_type, arguments)), names))
    return found


def declarations(library: Path = LIBRARY) -> list[Declaration]:
    found = []
    for path in glsl_files(library).values():
        text = path.read_text(encoding="utf-8")
        lines, last, of_sums = text.split("\n"), None, OF_SUMS.search(text)
        dimensions = int(of_sums[1]) if of_sums else None
        for start, name, types, arguments in _functions(text):
            line = text.count("\n", 0, start) + 1
            comment = _comment_above(lines, line)
            if comment is None and last is not None and (last.name == name or lines[line - 2].strip()):
                comment = last.comment  # of an overload, or of what stands above without a blank line
            last = Declaration(path, line, name, types, comment, dimensions, arguments)
            found.append(last)
    return found


@functools.cache
def public_files(library: Path = LIBRARY) -> dict[str, str]:
    """The files of detail/, and for each the file above it that users include for it: one that has functions of the same
    name, if there is any."""
    names: dict[Path, set[str]] = {}
    for one in declarations(library):
        names.setdefault(one.path, set()).add(one.name)
    found: dict[str, list[Path]] = {}
    for path in sorted(library.glob("*.glsl")):
        for name in re.findall(r'^#include "detail/(.+)"$', path.read_text(encoding="utf-8"), re.MULTILINE):
            found.setdefault(f"detail/{name}", []).append(path)
    return {name: max(paths, key=lambda path: len(names.get(path, set()) & names.get(library / name, set()))).name
            for name, paths in found.items()}


@functools.cache
def _files(library: Path) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for function in declarations(library):
        files = found.setdefault(function.name, [])
        name = public_files(library).get(function.path.relative_to(library).as_posix(), function.path.name)
        if name not in files:
            files.append(name)
    return found


def files_of(function: str, library: Path = LIBRARY) -> list[str]:
    """The names of the files that define a public function, in one dimension or another; none if there is no such."""
    return _files(library).get(function, [])


def overlooked(library: Path = LIBRARY) -> list[str]:
    """The public functions that declarations() does not find, with their places."""
    found = []
    for path in glsl_files(library).values():
        text = path.read_text(encoding="utf-8")
        known = {match.start(1) for match in FUNCTION.finditer(text)}
        found += [f"{path}:{text.count(chr(10), 0, match.start(1)) + 1}: {match[1]}"
                  for match in ANY_FUNCTION.finditer(text) if match.start(1) not in known]
    return found
