"""Finds which modules of tools/lib a module imports, now or later, without running it."""

from __future__ import annotations

import ast
import functools
from collections.abc import Iterable, Iterator
from pathlib import Path

from base.tree import TOOLS

LIB = TOOLS / "lib"


def path_of(module: str) -> Path:
    return LIB.joinpath(*module.split(".")).with_suffix(".py")


def files_of(starts: Iterable[Path]) -> dict[Path, str]:
    """The texts of these files, and of all of lib/ that they import."""
    found: dict[Path, str] = {}
    left = list(starts)
    while left:
        path = left.pop()
        if path not in found:
            found[path] = path.read_text(encoding="utf-8")
            left += imported(found[path])
    return found


@functools.lru_cache(maxsize=None)
def imported(text: str) -> tuple[Path, ...]:
    return tuple(_imported(ast.parse(text)))


def _imported(tree: ast.Module) -> Iterator[Path]:
    for node in ast.walk(tree):
        names = []
        if isinstance(node, ast.Import):
            names = [name.name for name in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module, *(f"{node.module}.{name.name}" for name in node.names)]
        for name in names:
            for path in (path_of(name), LIB.joinpath(*name.split("."), "__init__.py")):
                if path.is_file():
                    yield path
