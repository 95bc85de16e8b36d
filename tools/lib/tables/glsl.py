"""The public functions of the library, read from its text."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from tree import GLSL

LIBRARY = GLSL
FUNCTION = re.compile(r"^HN_FN\s+\w+\s+(hn_(?!i_)\w+)\(([^()]*)\)\s*\{", re.MULTILINE)


@dataclass(frozen=True)
class Comment:
    """A block of lines over a function: the number of the first, and their text without the slashes."""
    line: int
    lines: tuple[str, ...]


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

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.types)})"

    @property
    def place(self) -> str:
        return f"{self.path}:{self.line}"


def _type(argument: str) -> str:
    """The type of an argument like "hn_vec2 p": "vec2"."""
    return argument.split()[-2].removeprefix("hn_")


def _comment_above(lines: list[str], line: int) -> Comment | None:
    """The comment that ends above a line, which is counted from 1, and above the directives that select it."""
    while line > 1 and lines[line - 2].startswith("#if"):
        line -= 1
    first = line
    while first > 1 and lines[first - 2].startswith("//"):
        first -= 1
    if first == line:
        return None
    return Comment(first, tuple(text.removeprefix("//") for text in lines[first - 1:line - 1]))


def declarations(library: Path = LIBRARY) -> list[Declaration]:
    found = []
    for path in sorted(library.glob("*.glsl")):
        text = path.read_text(encoding="utf-8")
        lines, last = text.split("\n"), None
        for match in FUNCTION.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            name, types = match[1], tuple(map(_type, match[2].split(",")))
            comment = _comment_above(lines, line)
            if comment is None and last is not None and last.name == name:
                comment = last.comment
            last = Declaration(path, line, name, types, comment)
            found.append(last)
    return found
