"""The inputs of the golden files, which are kept: a file has those that it had, and the oracle computes its values.

A new file takes the inputs of the file that has the same columns and the name most like its own. Rows by hand are lines
of words behind them, also in a file that has nothing else: `c0000000 00000007`, and for fixed arithmetic alone
`7f800000 00000007 = -`. tools/make golden computes their values, and puts the latter behind the others.
"""

from __future__ import annotations

import math
import os
import re
import struct
from pathlib import Path

from base.golden_values import head_of
from base.tree import GOLDEN
from catalog.tables.functions import Function
from proof.golden.generator import Generator, Row

LINE = re.compile(r"[0-9a-f]{8}(?: [0-9a-f]{8})*(?= = |$)")
TINY = 2.0**-60
CODES = {"f32": ">f", "i32": ">i", "u32": ">I"}


def inputs_of(function: Function) -> str:
    return " ".join(map(str, function.inputs))


def rows_in(path: Path, function: Function) -> tuple[list[Row], list[Row]]:
    """The rows that every setting has, and those that only fixed arithmetic has; none if the file has other columns."""
    found: tuple[list[Row], list[Row]] = [], []
    codes = [CODES[column.type] for column in function.inputs]
    for line in path.read_bytes().decode("latin-1").split("\n") if path.is_file() else ():
        if line.startswith("columns ") and line.partition(" = ")[0] != f"columns {inputs_of(function)}":
            return [], []
        words = start[0].split() if (start := LINE.match(line)) else []
        if words and len(words) == len(codes):
            row = tuple(struct.unpack(code, bytes.fromhex(word))[0] for code, word in zip(codes, words))
            found[" = -" in line].append(row)
    return found


def most_alike(function: Function, folder: Path) -> Path:
    """The file whose rows a new function takes."""
    def likeness(path: Path) -> tuple[int, int]:
        head = head_of(path)
        is_alike = " ".join(map(":".join, head.columns)) == inputs_of(function)
        return is_alike * (1 + len(os.path.commonprefix((path.stem, function.id)))), head.rows

    return max((path for path in folder.glob("*.golden") if path.stem != function.id), key=likeness)


def kept(function: Function, fixed: bool, folder: Path = GOLDEN) -> tuple[list[Row], list[Row]]:
    """The rows of a function: for every setting, and for fixed arithmetic alone, if it has values with that."""
    own = folder / f"{function.id}.golden"
    every, of_fixed = rows_in(own, function)
    if not every:
        every, of_fixed = rows_in(most_alike(function, folder), function)
    if not every:
        raise function.error(f"no golden file has the columns {inputs_of(function)}: write their words into {own}, a line "
                             "for each row")
    return every, of_fixed if fixed else []


def redrawn(function: Function, generator: Generator) -> list[Row]:
    """The rows for every setting, without infinities and with other seeds. Doubles lose a tiny number beside others, and
    with another seed it may decide which point is nearest: what sets that has none."""
    least = TINY if function.sets else 0.0
    at = [column.name == "seed" for column in function.inputs]
    return [tuple(generator.word() if is_seed else x for is_seed, x in zip(at, row))
            for row in kept(function, fixed=False)[0] if all(math.isfinite(x) and (x == 0 or abs(x) > least) for x in row)]
