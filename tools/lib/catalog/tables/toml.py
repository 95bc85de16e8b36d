"""Reads TOML as far as catalog/ has it, where Python has no tomllib, which is there from 3.11 on.

A table has one name or several, a line has one key, and a value is a string, a number, true, false, an array of these,
or an inline table of one line. Other TOML is an error here.
"""

from __future__ import annotations

import ast
import re
from typing import Any

TABLE = re.compile(r"\[(\w+(?:\.\w+)*)\]")
KEY = re.compile(r"(\w+) = (.+)")
TOKEN = re.compile(
    r"""\s*((?:"(?:[^"\\]|\\["\\])*"|'[^'\\]*')(?!\s*["'])|-?\d+(?:\.\d+)?|true\b|false\b|[\[\]{},]|\w+\s*=|\#.*)""")
WORDS = {"true": "True", "false": "False"}


class TomlError(ValueError):
    pass


def loads(text: str) -> dict[str, Any]:
    tables: dict[str, Any] = {}
    here = tables
    heads = set()
    for number, line in enumerate(text.splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        if head := TABLE.fullmatch(line.partition("#")[0].rstrip()):
            if head[1] in heads:
                raise TomlError(f"line {number} begins a table for the second time")
            heads.add(head[1])
            here = tables
            for name in head[1].split("."):
                here = here.setdefault(name, {})
            continue
        key = KEY.fullmatch(line)
        if not key or key[1] in here:
            raise TomlError(f"line {number} is no table and no new key with a value of one line")
        here[key[1]] = _value(key[2], number)
    return tables


def _value(text: str, number: int) -> Any:
    """Python writes all of these likewise, but for true and false, and for the = of an inline table."""
    written, at = "", 0
    while at < len(text) and text[at:].strip():
        token = TOKEN.match(text, at)
        if not token:
            raise TomlError(f"line {number} has a value that is not read here: {text[at:].strip()}")
        at = token.end()
        word = token[1]
        if not word.startswith("#"):
            written += WORDS.get(word, f'"{word[:-1].rstrip()}":' if word.endswith("=") else word)
    try:
        return ast.literal_eval(written)
    except (SyntaxError, ValueError):
        raise TomlError(f"line {number} has a value that is not read here: {text}") from None
