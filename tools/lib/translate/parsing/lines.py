"""Lines of code that are not too long."""

import re
from collections.abc import Sequence

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


def broken(line: str) -> list[str]:
    """A line of code, broken within brackets where it is too long. The rest is indented by 4 more."""
    lines: list[str] = []
    indent, depth = len(line) - len(line.lstrip()), 0
    while len(line) > WIDTH:
        cuts: dict[bool, tuple[int, int]] = {}  # the last ones behind a comma, and elsewhere
        inside = depth
        for i, letter in enumerate(line[:WIDTH]):
            inside += (letter in "([{") - (letter in ")]}")
            if letter == " " and inside > 0 and i > indent + 4:
                cuts[line[i - 1] == ","] = i, inside
        if not cuts:
            found = re.fullmatch(r"( *)((?:var )?[\w., ]+ :?[-+*/&|^<>]*= |return )([^(].*)", line)
            if not found:
                break
            space, begin, rest = found.groups()
            names = begin.removesuffix(" = ")
            line = f"{space}({names}) = {rest}" if len(names) > WIDTH - 20 else f"{space}{begin}({rest})"
            continue
        cut, depth = cuts.get(True) or cuts[False]
        lines.append(line[:cut])
        line = " " * (indent + 4) + line[cut + 1:]
    return [*lines, line]


def without_braces(lines: Sequence[str]) -> list[str]:
    """The lines of blocks in braces, for a language whose blocks are indented alone."""
    shown = (re.sub(r" \{$", ":", line.replace("} else if", "elif").replace("} else", "else"))
             for line in lines if line.strip() != "}")
    return [part for line in shown for part in broken(line)]
