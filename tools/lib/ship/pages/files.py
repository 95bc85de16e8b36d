"""Which file has which function, and which package a node of it."""

from __future__ import annotations

import functools
import re

from catalog import popular
from catalog.tables import glsl
from catalog.tables.markdown import table
from translate.single_file.files import text

DIMENSIONS = re.compile(r"(\d)d\.glsl$")
NODE = re.compile(r"(hn_\w+?)(\d)(?:_jitter|_bandwidth|(_place))?")
GRAPHS = {"graphs": "Unity, Unreal, Godot", "blender": "Blender", "materialx": "MaterialX"}


@functools.cache
def size(file: str) -> str:
    """The size of the file with all that it includes, without comments."""
    return f"{len(text([file], strip=True)) / 1000:.0f} kB"


def files_table() -> str:
    """The functions that are not in the files of their names. A row has those that the same files have."""
    rows: dict[str, list[str]] = {}
    for function in sorted({found.name for found in glsl.declarations()}):
        files = sorted({DIMENSIONS.sub("*d.glsl", file) for file in glsl.files_of(function)})
        if files != [f"{function.removeprefix('hn_')}*d.glsl"]:
            rows.setdefault(", ".join(f"`{file}`" for file in files), []).append(f"`{function}`")
    return table(("functions", "files, with the dimensions for `*`"), [[", ".join(functions), files] for files, functions in rows.items()])


def nodes_table() -> str:
    """The nodes of packages for graphs of shaders. A row has the functions with the same cells."""
    sizes: dict[str, dict[str, list[str]]] = {}
    for who in GRAPHS:
        for form in popular.nodes(who):
            name, size, place = NODE.fullmatch(form).groups()
            of = sizes.setdefault(f"`{name}`{' in a tile' if place else ''}", {one: [] for one in GRAPHS})
            of[who].append(f"{size}D")
    rows: dict[tuple[str, ...], list[str]] = {}
    for name, of in sizes.items():
        rows.setdefault(tuple(", ".join(cell) for cell in of.values()), []).append(name)
    return table(("", *GRAPHS.values()), [[", ".join(names), *cells] for cells, names in rows.items()])
