"""The functions in most use: catalog/popular.toml."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from catalog.model import CATALOG, loads

# Ends of names of forms that are left out in names of nodes, as a node has one form.
ENDS = re.compile("_(jitter|bandwidth)$")
# Nodes for tiles: their functions share the comment of the form at a position.
TILE_DOCS = {
    "hn_perlin2_place": "Perlin noise in a tile of the plane: it repeats after the period, without a seam.",
    "hn_fbm2_place": "Fractional Brownian motion (fBm) in a tile of the plane: it repeats after the period, without a "
                     "seam. Its octaves are not rotated, so it shows the axes more than the fBm that does not repeat."}


@cache
def _lists() -> dict[str, dict[str, Any]]:
    return loads((CATALOG / "popular.toml").read_text(encoding="utf-8"))


def nodes(who: str) -> tuple[str, ...]:
    """The forms that are nodes, or node groups, of a package."""
    return tuple(f"hn_{form}" for form, have in _lists()["nodes"].items() if who in have)


def modules() -> dict[str, tuple[tuple[str, ...], int]]:
    """The forms of the Rust crate: the functions of each, and in how many dimensions at most."""
    return {name: (tuple(f"hn_{function}" for function in of["functions"]), of["dimensions"])
            for name, of in _lists()["rust"].items()}


def snippets() -> dict[str, str]:
    """The functions of docs/reference/snippets, and the use of each."""
    return {f"hn_{name}": what for name, what in _lists()["snippets"].items()}
