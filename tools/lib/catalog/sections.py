"""Parts of files that are made, between two lines of comment."""

from __future__ import annotations

from pathlib import Path

from base.tree import ROOT
from catalog.tables.marks import between

START, END = "tools/make catalog: {}", "tools/make catalog: end"


def with_section(path: str, name: str, content: str, text: str | None = None) -> tuple[Path, str]:
    """The path, and its text (that of the file, unless one is given) with the content between the line of comment that
    has `tools/make catalog: NAME` and the one that has `tools/make catalog: end`."""
    file = ROOT / path
    text = file.read_text(encoding="utf-8") if text is None else text
    start = START.format(name)
    if (count := text.count(f"{start}\n")) != 1:
        raise LookupError(f"{path} has {count} lines with {start!r}; there has to be one")
    return file, between(path, text, start, END, content)
