"""Parts of files that are made, between two lines of comment."""

from __future__ import annotations

from pathlib import Path

from tree import ROOT

START, END = "tools/catalog: {}", "tools/catalog: end"


def with_section(path: str, name: str, content: str, text: str | None = None) -> tuple[Path, str]:
    """The path, and its text (that of the file, unless one is given) with the content between the line of comment that
    says `tools/catalog: NAME` and the one that says `tools/catalog: end`."""
    file = ROOT / path
    lines = (text if text is not None else file.read_text(encoding="utf-8")).splitlines(keepends=True)
    starts = [i for i, line in enumerate(lines) if line.rstrip().endswith(START.format(name))]
    if len(starts) != 1:
        raise LookupError(f"{path} has {len(starts)} lines with {START.format(name)!r}; there has to be one")
    ends = [i for i, line in enumerate(lines) if i > starts[0] and line.rstrip().endswith(END)]
    if not ends:
        raise LookupError(f"{path} has no {END!r} behind {START.format(name)!r}")
    return file, "".join(lines[:starts[0] + 1]) + content + "".join(lines[ends[0]:])
