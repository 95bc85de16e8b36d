"""Which file has which function."""

from __future__ import annotations

import functools
import re

from single_file.files import text
from tables import glsl
from tables.markdown import table

DIMENSIONS = re.compile(r"(\d)d\.glsl$")


@functools.cache
def size(file: str) -> str:
    """Of the file with all that it includes, without comments."""
    return f"{len(text([file], strip=True)) / 1000:.0f} kB"


def files_table() -> str:
    """A row has the functions that the same files have."""
    rows: dict[tuple[str, ...], list[str]] = {}
    for function in sorted({found.name for found in glsl.declarations()}):
        files = {column: [] for column in "1234*"}
        for file in glsl.files_of(function):
            match = DIMENSIONS.search(file)
            files[match[1] if match else "*"].append(f"`{file}` {size(file)}")
        rows.setdefault(tuple(", ".join(of) for of in files.values()), []).append(f"`{function}`")
    return table(("", "1D", "2D", "3D", "4D", "all"), [[", ".join(functions), *cells] for cells, functions in rows.items()])
