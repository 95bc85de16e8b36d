"""Parts of files that commands write, between two lines."""

from __future__ import annotations


def between(path: str, text: str, start: str, end: str, content: str) -> str:
    """The text of a file with a new content behind the first line that ends with `start`, up to the next line that has
    `end` in it."""
    before, found, rest = text.partition(f"{start}\n")
    if not found or end not in rest:
        raise LookupError(f"{path} has no {start} with {end} after it")
    return before + found + content + rest[rest.rfind("\n", 0, rest.index(end)) + 1:]
