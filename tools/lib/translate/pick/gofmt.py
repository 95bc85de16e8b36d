"""Lines of Go as gofmt prints them, as far as pick.go writes such: blanks around operators, and columns of structs.

Around an operator there are blanks, unless the text around it binds less strongly or lies deeper: gofmt counts how
deep an expression lies in others (binaryExpr in go/printer/nodes.go).
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Union

from translate.parsing.lines import WIDTH

STRENGTH = {"||": 1, "&&": 2, **dict.fromkeys(("==", "!=", "<", "<=", ">", ">="), 3),
            **dict.fromkeys("+-|^", 4), **dict.fromkeys(("*", "/", "%", "<<", ">>", "&"), 5)}
SIGNS = ("-", "+", "!", "^", "*", "&")  # before an operand
LOWEST, SIGN, HIGHEST = 0, 6, 7
TOKEN = re.compile(r"\s*(<<|>>|&&|\|\||[<>=!]=|[-+*/%&|^<>!(){},:]|\[\d+\]\w+(?=\{)|[][]|"
                   r"0x[\dA-F]+|\d[\d.]*(?:e[-+]?\d+)?|[\w.]+)")
STATEMENT = re.compile(r"(?P<before>\t*(?:\} else )?(?:if |for |return |var \w+ \w+ = |[\w.*, ]+ (?::=|[-+*/%&|^]?=|<<=|>>=) )"
                       r")(?P<values>.+?)(?P<behind> \{)?")
KEY = re.compile(r"(\t+\w+:) (.*)")  # at the beginning of a line that goes on
FIELD = re.compile(r"\t(\w+) +(\S+)")

WHOLE = re.compile(r"(func .*\)(?: \w+)?) (\{ .* \})")


@dataclass(frozen=True)
class Binary:
    sign: str
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Signed:
    sign: str
    of: Expression


@dataclass(frozen=True)
class Around:
    """Expressions in brackets, behind another one if it is not in parentheses."""
    of: Expression | None
    brackets: str
    inside: tuple[Expression, ...]


@dataclass(frozen=True)
class Selected:
    of: Expression
    field: str


@dataclass(frozen=True)
class Keyed:
    key: str
    value: Expression


Expression = Union[str, Binary, Signed, Around, Selected, Keyed]


class Parser:
    def __init__(self, text: str):
        self.tokens = TOKEN.findall(text)
        self.at = 0

    def _next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def _take(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1]

    def all_of(self, end: str = "") -> tuple[Expression, ...]:
        found: list[Expression] = []
        while self._next() != end:
            one = self.expression(1)
            if self._next() == ":":
                self._take()
                one = Keyed(str(one), self.expression(1))
            found.append(one)
            if self._next() == ",":
                self._take()
        return tuple(found)

    def expression(self, least: int) -> Expression:
        left = self._operand()
        while STRENGTH.get(self._next(), LOWEST) >= least:
            sign = self._take()
            left = Binary(sign, left, self.expression(STRENGTH[sign] + 1))
        return left

    def _operand(self) -> Expression:
        if self._next() in SIGNS:
            return Signed(self._take(), self._operand())
        found: Expression
        if self._next() == "(":
            found = self._brackets(None)
        else:
            found = self._take()
        while True:
            if self._next() in ("(", "[", "{"):
                found = self._brackets(found)
            elif self._next().startswith("."):
                found = Selected(found, self._take())
            else:
                return found

    def _brackets(self, of: Expression | None) -> Around:
        begin = self._take()
        end = {"(": ")", "[": "]", "{": "}"}[begin]
        inside = self.all_of(end)
        self._take()
        return Around(of, begin + end, inside)


def printed(one: Expression, around: int = LOWEST, depth: int = 1) -> str:
    if isinstance(one, str):
        return one
    if isinstance(one, Keyed):
        return f"{one.key}: {printed(one.value)}"
    if isinstance(one, Signed):
        return f"{one.sign}{printed(one.of, SIGN, depth)}"
    if isinstance(one, Selected):
        return f"{printed(one.of, HIGHEST, depth)}{one.field}"
    if isinstance(one, Around):
        return _around(one, depth)
    strength = STRENGTH[one.sign]
    blank = " " if strength < _cutoff(one, depth) else ""
    of_left = depth + (not (isinstance(one.left, Binary) and STRENGTH[one.left.sign] == strength))
    return f"{printed(one.left, strength, of_left)}{blank}{one.sign}{blank}{printed(one.right, strength + 1, depth + 1)}"


def _around(one: Around, depth: int) -> str:
    if one.of is None:
        inside = printed(one.inside[0], LOWEST, max(depth - 1, 1))
    elif one.brackets == "[]":
        return f"{printed(one.of, HIGHEST, 1)}[{printed(one.inside[0], LOWEST, depth + 1)}]"
    elif one.brackets == "{}":
        inside = ", ".join(printed(part) for part in one.inside)
    else:
        depth += len(one.inside) > 1
        inside = ", ".join(printed(part, LOWEST, depth) for part in one.inside)
    before = "" if one.of is None else printed(one.of, HIGHEST, depth)
    return f"{before}{one.brackets[0]}{inside}{one.brackets[1]}"


def _cutoff(one: Binary, depth: int) -> int:
    """From which strength on operators have no blanks."""
    strengths, problem = _walked(one)
    if problem:
        return problem + 1
    if {4, 5} <= strengths:
        return 5 if depth == 1 else 4
    return 6 if depth == 1 else 4


def _walked(one: Binary) -> tuple[set[int], int]:
    """The strengths outside of brackets, and of two signs that may not touch."""
    strength = STRENGTH[one.sign]
    found, problem = {strength}, 0
    for side, other in enumerate((one.left, one.right)):
        if isinstance(other, Binary) and STRENGTH[other.sign] >= strength + side:
            inner, more = _walked(other)
            found, problem = found | inner, max(problem, more)
    if isinstance(one.right, Signed):
        both = one.sign + one.right.sign
        problem = 5 if both in ("/*", "&&", "&^") else max(problem, 4 if both in ("++", "--") else 0)
    return found, problem


def _expressions(text: str, depth: int = 1) -> str:
    return ", ".join(printed(one, LOWEST, depth) for one in Parser(text).all_of())


def _line(line: str) -> str:
    """A statement of code."""
    found = STATEMENT.fullmatch(line)
    if not found or "func" in line:
        return line
    before, values, behind = found["before"], found["values"], found["behind"] or ""
    if "; " in values:  # of a loop that counts
        start, condition, step = values.split("; ")
        name, value = start.split(" := ")
        changed = step if step.endswith(("++", "--")) else _line(step)
        return f"{before}{name} := {_expressions(value)}; {_expressions(condition)}; {changed}{behind}"
    several = ", " in before and before.endswith(" := ")
    return f"{before}{_expressions(values, 2 if several else 1)}{behind}"


def _cuts(line: str) -> dict[int, list[int]]:
    """Where a line may go on in the next, behind commas and operators: the brackets around each place, by where these
    begin."""
    around, found = [-1], {}
    for at, letter in enumerate(line):
        if letter in "([{":
            around.append(at)
        elif letter in ")]}":
            around.pop()
        elif letter == " " and (line[at - 1] == "," or line[at - 1] in "+-*/|&^<>" and line[at - 2] in " &|"):
            found[at] = [*around]
    return found


def _wrapped(line: str) -> list[str]:
    """A line that is too long is broken where the fewest brackets are around. The rest has a tab more, and one for
    each bracket around it in which a line was broken before."""
    indent = len(line) - len(line.lstrip("\t"))
    if line.lstrip().startswith("//"):
        return [line]
    lines, cuts, broken = [], _cuts(line), set()
    begin, more = 0, 0
    while 4 * (indent + more) + len(line) - begin - (indent if not lines else 0) > WIDTH:
        room = WIDTH - 4 * (indent + more) + (indent if not lines else 0)
        fitting = [at for at in cuts if begin < at <= begin + room]
        if not fitting:
            break
        at = min(fitting, key=lambda cut: (len(cuts[cut]), -cut))
        lines.append("\t" * more + "\t" * (indent if lines else 0) + line[begin:at])
        broken.add(cuts[at][-1])
        begin, more = at + 1, len(broken & {*cuts[at]})
    return _keys_aligned([*lines, "\t" * more + "\t" * (indent if lines else 0) + line[begin:]])


def _keys_aligned(lines: Sequence[str]) -> list[str]:
    """Lines that begin with a key have their values in a column. The column ends at a line with several keys."""
    found: list[str] = []
    column: list[re.Match[str]] = []
    for line in (*lines, None):
        key = line is not None and KEY.fullmatch(line)
        if column and (not key or ": " in column[-1][2]):
            width = max(len(one[1]) for one in column)
            found += [f"{one[1]:{width}} {one[2]}" for one in column]
            column = []
        if key:
            column.append(key)
        elif line is not None:
            found.append(line)
    return found


def _aligned(lines: Sequence[str]) -> list[str]:
    """Fields of a struct, with their types in a column."""
    fields = [FIELD.fullmatch(line) for line in lines]
    width = max(len(field[1]) for field in fields)
    return [f"\t{field[1]:{width}} {field[2]}" for field in fields]


def _with_bodies(lines: Sequence[str]) -> list[str]:
    """Functions of one line that follow one another, with their bodies in a column."""
    found: list[str] = []
    for is_whole, group in itertools.groupby(lines, lambda line: bool(WHOLE.fullmatch(line))):
        parts = [WHOLE.fullmatch(line) for line in group] if is_whole else []
        width = max((len(part[1]) for part in parts), default=0)
        found += [f"{part[1]:{width}} {part[2]}" for part in parts] if is_whole else group
    return found


def formatted(text: str) -> str:
    """All lines of a text; each is a statement, or the head or the end of one."""
    lines: list[str] = []
    of_struct: list[str] | None = None
    for line in text.splitlines():
        if of_struct is not None and line == "}":
            lines += _aligned(of_struct)
            of_struct = None
        if of_struct is not None:
            of_struct.append(line)
            continue
        if line.endswith(" struct {"):
            of_struct = []
        lines += _wrapped(_line(line))
    return "".join(f"{line}\n" for line in _with_bodies(lines))
