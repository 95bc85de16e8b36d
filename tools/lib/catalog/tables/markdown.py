"""Tables in pages, which tools/make writes between two comments: `<!-- tools/make PART: NAME -->` and `<!-- end -->`."""

from __future__ import annotations

from collections.abc import Sequence

from catalog.tables.marks import between

END = "<!-- end -->"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n".replace("|  |", "| |") for line in lines)


def with_section(path: str, page: str, name: str, content: str) -> str:
    """The page with a new content between the comments; the name is the first's, "tools/make bounds: noises"."""
    return between(path, page, f"<!-- {name} -->", END, content)
