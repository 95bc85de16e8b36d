"""Lines of GLSL that became longer or shorter: no line has more than 120 columns."""

from __future__ import annotations

import re
from collections.abc import Iterator

from translate.parsing.lines import WIDTH

COMMENT = re.compile(r"( *//   \w+  +| *// *)(?=\S)")  # and where its text begins
ONE_LINE = re.compile(r"(\S.*\) \{) (.*;) \}")  # a function
ONE_RETURN = re.compile(r"^(\S.*\) \{)\n {2}(return .*;)\n\}$", re.MULTILINE)  # a function that could be one line


def places_to_break(line: str) -> Iterator[tuple[int, list[int]]]:
    """The blanks behind a comma or an operator. With each the columns where the value, and brackets begin."""
    value = re.match(r" *return |.*? = | +", line)
    columns = [value.end()] if value else []
    for at, sign in enumerate(line):
        if sign in "([":
            columns.append(at + 1)
        elif sign in ")]" and columns:
            columns.pop()
        elif sign == " " and columns and re.search(r",$| [-+^|&]$", line[:at]):
            yield at, [*columns]


def broken(line: str) -> list[str]:
    """A line of code, broken where the fewest brackets are open, and there as far right as it fits."""
    if len(line) <= WIDTH:
        return [line]
    if function := ONE_LINE.fullmatch(line):
        return [function[1], *broken(f"  {function[2]}"), "}"]
    places = [(at, columns) for at, columns in places_to_break(line) if at <= WIDTH]
    if not places:
        return [line]
    at, columns = max(places, key=lambda place: (-len(place[1]), place[0]))
    return [line[:at], *broken(" " * columns[-1] + line[at + 1:])]


def joined(text: str) -> str:
    """The text, where code that fits one line is in one."""
    lines = text.split("\n")
    for at in range(len(lines) - 1, 0, -1):
        goes_on = lines[at].startswith("    ") and not re.search(r"[;{}]$|//|^#|^$", lines[at - 1])
        if goes_on and len(lines[at - 1]) + 1 + len(lines[at].lstrip()) <= WIDTH:
            lines[at - 1:at + 1] = [f"{lines[at - 1]} {lines[at].lstrip()}"]
    return ONE_RETURN.sub(lambda found: one if len(one := f"{found[1]} {found[2]} }}") <= WIDTH else found[0], "\n".join(lines))


def with_short_lines(text: str) -> str:
    """The text, where the words that do not fit a line of a comment are in the next."""
    lines, found = text.split("\n"), []
    while lines:
        line = lines.pop(0)
        comment = COMMENT.match(line)
        if not comment:
            found += broken(line)
            continue
        if len(line) > WIDTH:
            at = line.rindex(" ", 0, WIDTH + 1)
            line, rest = line[:at], line[at + 1:]
            before = "//".join([line.partition("//")[0], " " * (comment.end() - line.index("//") - 2)])
            goes_on = lines and re.match(re.escape(before) + r"(?=\S)(?!\w+  )", lines[0])
            lines[:1 if goes_on else 0] = [before + rest + (f" {lines[0][len(before):]}" if goes_on else "")]
        found.append(line)
    return "\n".join(found)
