"""Lines of code that are not too long."""

import re

WIDTH = 120  # as .clang-format has it


def wrapped(text: str, indent: int, blanks: str = " ") -> list[str]:
    """A line of code with that indentation, broken where it is too long, behind a comma if there is one, else at a
    blank that matches. The rest is indented by 4 more."""
    lines, more = [], 0
    while indent + more + len(text) > WIDTH:
        room = WIDTH - indent - more
        cut = text.rfind(", ", 0, room) + 1 or max((found.end() - 1 for found in re.finditer(blanks, text[:room])),
                                                   default=0)
        if cut <= 0:
            break
        lines.append(" " * (indent + more) + text[:cut])
        text, more = text[cut + 1:], 4
    return [*lines, " " * (indent + more) + text]
