"""Reads the tables that C++ includes: rows like NAME(argument, ...).

It takes what these tables consist of, and nothing else: rows, comments to the end of a line, #include of another table
beside it, and #undef. Anything else is an error that names the file and the line, so that no row is overlooked.
"""

from __future__ import annotations

import functools
import re
from dataclasses import dataclass
from pathlib import Path


class TableError(Exception):
    """What is wrong in a table, and where."""


@dataclass(frozen=True)
class Row:
    """A row, and where it stands."""
    path: Path
    line: int
    name: str
    arguments: tuple[str, ...]

    def error(self, message: str) -> TableError:
        return TableError(f"{self.path}:{self.line}: {message}")

    def text(self, index: int) -> str:
        """An argument that is a string, or several, which C++ joins."""
        parts = re.findall(STRING, self.arguments[index])
        if not parts or re.sub(STRING, "", self.arguments[index]).strip():
            raise self.error(f"{self.arguments[index]} is not a string")
        return "".join(part[1:-1] for part in parts)

    def word(self, index: int) -> str:
        if not re.fullmatch(r"\w+", self.arguments[index]):
            raise self.error(f"{self.arguments[index]} is not a word")
        return self.arguments[index]


STRING = r'"[^"\\]*"'
TOKEN = re.compile(rf"{STRING}|\w+|.", re.DOTALL)
INCLUDE = re.compile(r'#include "(\w+\.inc)"')
UNDEFINE = re.compile(r"#undef \w+")
COMMENT = re.compile(rf'({STRING})|//[^\n]*')


def read_rows(path: Path, name: str, count: int, others: frozenset[str] = frozenset(),
              at_least: int = 1) -> list[Row]:
    """The rows of the macro `name`, which has `count` arguments. The rows of `others` are left out."""
    rows = [row for row in _rows(path, {name, *others}) if row.name == name]
    for row in rows:
        if len(row.arguments) != count:
            raise row.error(f"{name} has {len(row.arguments)} arguments instead of {count}")
    if len(rows) < at_least:
        raise TableError(f"{path}: no row of {name}")
    return rows


def _rows(path: Path, names: set[str]) -> list[Row]:
    rows: list[Row] = []
    for line, statement, is_closed in _statements(path.read_text(encoding="utf-8")):
        where = Row(path, line, "", ())
        if not is_closed:
            raise where.error("a row is not closed")
        if not statement.startswith("#"):
            rows += _of_statement(statement, names, where)
        elif include := INCLUDE.fullmatch(statement.rstrip()):
            rows += _rows(path.with_name(include[1]), names)
        elif not UNDEFINE.fullmatch(statement.rstrip()):
            raise where.error(f'{statement} is neither #include "NAME.inc" nor #undef NAME')
    return rows


@functools.lru_cache(maxsize=16)  # tests read the same tables in many copies of the tree
def _statements(text: str) -> list[tuple[int, str, bool]]:
    """Without comments, each with the number of its first line, and whether it is closed."""
    lines = COMMENT.sub(lambda match: match[1] or "", text).split("\n")
    statements: list[tuple[int, str, bool]] = []
    number = 0
    while number < len(lines):
        first, statement = number, lines[number]
        number += 1
        while is_open := not statement.startswith("#") and _depth(statement) > 0:
            if number == len(lines):
                break
            statement += "\n" + lines[number]
            number += 1
        statements.append((first + 1, statement, not is_open))
    return statements


def _depth(text: str) -> int:
    """How many parentheses are open at its end."""
    bare = re.sub(STRING, "", text)
    return bare.count("(") - bare.count(")")


def _of_statement(text: str, names: set[str], where: Row) -> list[Row]:
    rows: list[Row] = []
    while text.strip():
        used = re.match(r"\s*(\w+)\(", text)
        if not used or used[1] not in names:
            raise where.error(f"{text.split()[0]} is not {' or '.join(sorted(names))}")
        split = _arguments(text[used.end():])
        if split is None:
            raise where.error("a row is not closed")
        arguments, text = split
        rows.append(Row(where.path, where.line, used[1], arguments))
    return rows


@functools.lru_cache(maxsize=4096)
def _arguments(text: str) -> tuple[tuple[str, ...], str] | None:
    """What stands before the closing parenthesis, split at the commas, and what follows it; None if there is none."""
    arguments, depth, position = [""], 0, 0
    for token in TOKEN.findall(text):
        position += len(token)
        if token == ")" and depth == 0:
            return tuple(" ".join(argument.split()) for argument in arguments), text[position:]
        depth += (token == "(") - (token == ")")
        if token == "," and depth == 0:
            arguments.append("")
        else:
            arguments[-1] += token
    return None
