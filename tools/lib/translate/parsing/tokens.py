"""The words, numbers and signs of GLSL, with where they stand and the comments beside them."""

from __future__ import annotations

import functools
import re
from typing import NamedTuple

# All that read GLSL in Python make their tokens of these, with the text before each: blanks, comments and
# directives.
WORD = r"[A-Za-z_]\w*"
NUMBER = r"0[xX][0-9a-fA-F]+[uU]?|(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?[fF]?|\d+[eE][+-]?\d+[fF]?|\d+[uU]?"
SIGN = r"<<=|>>=|&&|\|\||\+\+|--|<<|>>|[-+*/%&|^<>=!]=|[-+*/%&|^<>=!~?:;,.(){}\[\]]"
TOKEN = re.compile(rf"(?P<lead>(?:\s|//[^\n]*|#(?:[^\n\\]|\\\n)*)*)"
                   rf"(?:(?P<word>{WORD})|(?P<number>{NUMBER})|(?P<sign>{SIGN})|(?P<unknown>[^\s\w])|(?P<end>$))")


class Unknown(Exception):
    """An error for GLSL that the translator does not know, with its place: "FILE:LINE: what"."""


class Token(NamedTuple):  # a module has a million of them, and a data class takes four times as long
    kind: str  # word, number, sign, or end
    text: str
    path: str
    line: int
    before: tuple[str, ...] = ()  # the comment lines above it, and "" for an empty line
    after: str = ""               # the comment behind it, on its line
    hidden: frozenset[str] = frozenset()  # macros that it came out of, which do not expand in it again

    def error(self, message: str) -> Unknown:
        return Unknown(f"{self.path}:{self.line}: {message}")

    def __str__(self) -> str:
        return "the end of the text" if self.kind == "end" else self.text


@functools.lru_cache(maxsize=None)  # nearly all modules include the same files
def tokens_of(code: str, path: str, line: int) -> tuple[Token, ...]:
    """The tokens of a text without comments, all of one line."""
    found = []
    for match in TOKEN.finditer(code):
        kind = match.lastgroup
        if kind == "unknown" or "#" in match["lead"]:
            raise Unknown(f"{path}:{line}: {match[0].split()[0]} is no GLSL that the translator knows")
        if kind != "end":
            found.append(Token(kind, match[kind], path, line))
    return tuple(found)
