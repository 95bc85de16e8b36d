"""Reads the tables that C++ includes: rows like NAME(argument, ...), and macros that stand for several of them.

It takes what these tables consist of, and nothing else: comments to the end of a line, #define with parameters, #undef,
and uses of the two. Anything else is an error that names the file and the line, so that no row is overlooked.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path


class TableError(Exception):
    """What is wrong in a table, and where."""


@dataclass(frozen=True)
class Row:
    """A row, and where it stands; one that a macro makes stands where the macro is used."""
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


@dataclass(frozen=True)
class Macro:
    parameters: tuple[str, ...]
    body: str


STRING = r'"[^"\\]*"'
TOKEN = re.compile(rf"{STRING}|\w+|.", re.DOTALL)
DEFINE = re.compile(r"#define (\w+)\(([\w, ]*)\)\s+(.+)", re.DOTALL)
UNDEFINE = re.compile(r"#undef (\w+)")
COMMENT = re.compile(rf'({STRING})|//[^\n]*')


def read_rows(path: Path, name: str, count: int, others: frozenset[str] = frozenset(),
              at_least: int = 1) -> list[Row]:
    """The rows of the macro `name`, which has `count` arguments. The rows of `others` are left out."""
    text = COMMENT.sub(lambda match: match[1] or "", path.read_text(encoding="utf-8"))
    macros: dict[str, Macro] = {}
    rows: list[Row] = []
    lines = text.split("\n")
    while lines:
        line = text.count("\n") - len(lines) + 2
        statement = lines.pop(0)
        while statement.endswith("\\") or (not statement.startswith("#") and _depth(statement) > 0):
            if not lines:
                raise TableError(f"{path}:{line}: a row is not closed")
            statement = statement.removesuffix("\\").rstrip() + "\n" + lines.pop(0)
        where = Row(path, line, "", ())
        if statement.startswith("#"):
            _direct(statement.rstrip(), macros, where)
        else:
            rows += _expanded(statement, {name, *others}, macros, where)
    rows = [row for row in rows if row.name == name]
    for row in rows:
        if len(row.arguments) != count:
            raise row.error(f"{name} has {len(row.arguments)} arguments instead of {count}")
    if len(rows) < at_least:
        raise TableError(f"{path}: no row of {name}")
    return rows


def _depth(text: str) -> int:
    """How many parentheses are open at its end."""
    bare = re.sub(STRING, "", text)
    return bare.count("(") - bare.count(")")


def _direct(statement: str, macros: dict[str, Macro], where: Row) -> None:
    define, undefine = DEFINE.fullmatch(statement), UNDEFINE.fullmatch(statement)
    if define:
        macros[define[1]] = Macro(tuple(define[2].replace(" ", "").split(",")), define[3])
    elif undefine:
        macros.pop(undefine[1], None)
    else:
        raise where.error(f"{statement.split(chr(10))[0]} is neither #define NAME(...) nor #undef NAME")


def _expanded(text: str, names: set[str], macros: dict[str, Macro], where: Row) -> list[Row]:
    """The rows of a text that consists of uses of `names` and of macros."""
    rows: list[Row] = []
    while text.strip():
        used = re.match(r"\s*(\w+)\(", text)
        if not used or (used[1] not in names and used[1] not in macros):
            known = " nor ".join(sorted(names))
            raise where.error(f"{text.split()[0]} is neither {known} nor a macro that is defined above")
        arguments, text = _arguments(text[used.end():], where)
        if used[1] in names:
            rows.append(Row(where.path, where.line, used[1], arguments))
            continue
        macro = macros[used[1]]
        if len(arguments) != len(macro.parameters):
            raise where.error(f"{used[1]} has {len(arguments)} arguments instead of {len(macro.parameters)}")
        values = dict(zip(macro.parameters, arguments))
        body = "".join(values.get(token, token) for token in TOKEN.findall(macro.body))
        rows += _expanded(body, names, macros, where)
    return rows


def _arguments(text: str, where: Row) -> tuple[tuple[str, ...], str]:
    """What stands before the closing parenthesis, split at the commas, and what follows it."""
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
    raise where.error("a row is not closed")
