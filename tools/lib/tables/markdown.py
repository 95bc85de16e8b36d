"""Tables in pages, which commands write between two comments: `<!-- tools/COMMAND: NAME -->` and `<!-- end -->`."""

from __future__ import annotations

from collections.abc import Sequence

END = "<!-- end -->\n"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n".replace("|  |", "| |") for line in lines)


def with_section(path: str, page: str, name: str, content: str) -> str:
    """The page with a new content between the comments; the name is that of the first, "tools/bounds: noises"."""
    start = f"<!-- {name} -->\n"
    before, found, rest = page.partition(start)
    if not found or END not in rest:
        raise LookupError(f"{path} has no {start.strip()} with {END.strip()} after it")
    return before + start + content + rest[rest.index(END):]
