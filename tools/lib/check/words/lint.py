"""Finds words that make a reader read a sentence of the pages twice.

    python3 -B -m check.words.lint    prints each with its place; exit status 1 if there is one
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

from base.tree import ROOT

PAGES = ("docs/*/*.md",)
EXCEPTIONS: set[tuple[str, str]] = set()  # a page, and the words that may stand there
LONGEST_CELL = 250  # letters
PATTERNS = {
    r"\b[Oo]f (?:which|whose)\b": "write two sentences",
    r"\b(?:says|said|tells|told|asks|asked)\b": "programs print, write, return and read; pages list, state and document",
    r"(?:^[>*\-\d. ]*|[.:;!?][)\"]? |\| |\*\*)(?:What|That|Those) (?![^.]*\?)": "begin with the subject: the reader or the code",
    r"\b[Dd]earer\b": "costs more"}
MADE = re.compile(r"^<!-- (?!tools/make catalog: |end )[^\n]* -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)
WHOLLY_MADE = re.compile(r"`tools/make \w+` writes this page|`hn-conform list --checks` prints this page")
CODE = re.compile(r"^```.*?^```$|^ {4,}\S.*?$", re.MULTILINE | re.DOTALL)
QUOTED = re.compile(r"`[^`\n]*`|\]\([^)\n]*\)")


def blank(found: re.Match[str]) -> str:
    """As many lines, so that the lines below keep their numbers."""
    return "\n" * found[0].count("\n")


def faults(name: str, page: str) -> Iterator[str]:
    """Of a page, without its code and the parts that are made of records, of code or of other pages."""
    if WHOLLY_MADE.search(page):
        return
    lines = CODE.sub(blank, MADE.sub(blank, page)).splitlines()
    if not re.match(r"[A-Z`*\[]", next(filter(None, lines[1:]), "")):
        yield f"{name}:1: begin with a sentence that states what the page is for"
    for number, line in enumerate(lines, 1):
        for pattern, remedy in PATTERNS.items():
            for found in re.finditer(pattern, "" if line.startswith("#") else QUOTED.sub("``", line)):
                words = found[0].strip("|*.:;!?)\">- ")
                if (name, words) not in EXCEPTIONS:
                    yield f"{name}:{number}: '{words}': {remedy}"
        for cell in line.split(" | ") if line.startswith("|") else ():
            if len(cell.strip("| ")) > LONGEST_CELL:
                yield f"{name}:{number}: a cell of {len(cell.strip('| '))} letters: split the row, or write prose below the table"


def faults_of_pages(root: Path = ROOT) -> Iterator[str]:
    for path in sorted(path for pattern in PAGES for path in root.glob(pattern)):
        yield from faults(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))


if __name__ == "__main__":
    messages = list(faults_of_pages())
    print("\n".join(messages) or "no such words")
    sys.exit(bool(messages))
