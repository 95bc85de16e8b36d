"""The text of the plane in another number of dimensions.

Names change: hn_place2, hn_vec2, octaves2d.glsl. hn_vec3 and hn_i_num3 are a value with its derivatives, and grow, too.
The type of a variable named after an axis stays (hn_ivec2 x), and so do numbers in comments, but for those in
numbers.py.

A pair is two neighbours that differ in names of axes alone: where the first names one, the second names the next.
Neighbours are arguments, parameters, operands, statements, members or functions. Behind a pair stands what names the
axes after these; on the line its first is left, without its axis. The rule does not guess: an axis y in no pair is an
error, and so is a constructor whose arguments are not as many as the components of its vector.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from translate.parsing.tokens import TOKEN

AXES = "xyzw"
OPENING, CLOSING = ("(", "[", "{"), (")", "]", "}")
OPERATORS = ("+", "^", "|", "&")  # their operands may be a pair
SIGNS = (*OPERATORS, *"-=?:<>;", "return", "<<", ">>", "&&", "||", *(f"{sign}=" for sign in "+-*/&|^<>=!"))
BEFORE_PAIRS = ("", "=", "return")
VECTOR = re.compile(r"[iu]?vec2|hn_i_vector")  # makes a vector of the plane of its components
SCALARS = {"": "float", "i": "int", "u": "uint"}
WHERE = {1: "on the line", 3: "in space", 4: "in four dimensions"}
ALONG = {1: "along x", 3: "along x, y and z", 4: "along x, y, z and w"}
EXAMPLE = "uv * 8.0"  # a position in examples of calls
EXAMPLES = {1: "uv.x * 8.0", 3: "vec3(uv * 8.0, 0.5)", 4: "vec4(uv * 8.0, 0.5, 0.25)"}


class Unclear(Exception):
    """Text that the rule does not cover."""


@dataclass(frozen=True)
class Token:
    lead: str
    text: str
    line: int = 0
    paired: bool = False


Tokens = Sequence[Token]


def tokens_of(text: str) -> list[Token]:
    return [Token(match["lead"], match[match.lastgroup], text.count("\n", 0, match.start(match.lastgroup)))
            for match in TOKEN.finditer(text)]


def text_of(tokens: Tokens) -> str:
    return "".join(token.lead + token.text for token in tokens)


def next_name(a: str, b: str) -> str | None:
    """The name that follows two names: z after x and y, HN_I_STEP_W after HN_I_STEP_Y and HN_I_STEP_Z. It is empty
    beyond w, and None for names that are no pair."""
    if a == b:
        return a
    first, second = a.split("_"), b.split("_")
    unlike = [at for at, (one, other) in enumerate(zip(first, second)) if one != other]
    if len(first) == len(second) and len(unlike) == 1:
        at = unlike[0]
        for axes in (AXES, AXES.upper()):
            if first[at] + second[at] in (axes[:2], axes[1:3]):
                return "_".join([*second[:at], axes[axes.index(second[at]) + 1], *second[at + 1:]])
            if first[at] + second[at] == axes[2:]:
                return ""
    return None


def without_remark(lead: str) -> str:
    """The text before a token, without the comment that ends the line before."""
    return re.sub(r"^ *//[^\n]*", "", lead)


def next_names(a: Tokens, b: Tokens, alike: bool) -> list[str] | None:
    """The tokens of the text behind a pair; None if it is no pair. With `alike` they may be the same."""
    if len(a) != len(b) or any(re.search("[/#]", without_remark(token.lead)) for token in b):
        return None
    names = [next_name(one.text, other.text) for one, other in zip(a, b)]
    return names if None not in names and (alike or any(one.text != other.text for one, other in zip(a, b))) else None


def on_the_line(a: Tokens, b: Tokens) -> list[Token]:
    """The first of a pair without its axis: place.cell for place.cell.x."""
    kept: list[Token] = []
    for one, other in zip(a, b):
        if one.text != other.text and kept and kept[-1].text == ".":
            kept.pop()
        else:
            kept.append(one)
    return kept


def split(tokens: Tokens, ends: Callable[[Token], bool]) -> list[list[Token]]:
    """The tokens, cut behind each that ends a part, outside of brackets."""
    parts: list[list[Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token.text in OPENING) - (token.text in CLOSING)
        parts[-1].append(token)
        if depth == 0 and ends(token):
            parts.append([])
    return [part for part in parts if part]


class Rule:
    """The rule for a number of dimensions."""

    def __init__(self, n: int) -> None:
        self.n = n

    def statements(self, tokens: Tokens) -> list[Token]:
        """Statements, members or functions."""
        parts = split(tokens, lambda token: token.text in (";", "}"))
        return [token for _, run in self.runs(parts, self.operands) for part in run for token in part]

    def arguments(self, tokens: Tokens, maker: Token) -> list[list[Token]]:
        """Arguments or parameters. The maker stands before the bracket."""
        parts = split(tokens, lambda token: token.text == ",")
        parts = [part[:-1] for part in parts[:-1]] + parts[-1:]
        is_vector = VECTOR.fullmatch(maker.text) is not None
        runs = self.runs(parts, self.operands, alike=is_vector and len(parts) == 2)
        found = [part for _, run in runs for part in run]
        if is_vector and maker.text != "hn_i_vector" and len(found) not in (1, self.n):
            raise Unclear(f"`{maker.text}({text_of(tokens)})` has no argument for each axis")
        return found

    def operands(self, tokens: Tokens) -> list[Token]:
        """An argument or a statement: one operand, or several with signs between."""
        signs, parts = [Token("", "")], [[]]
        for part in split(tokens, lambda token: True):
            if part[0].text in SIGNS:
                signs.append(part[0])
                parts.append([])
            else:
                parts[-1] += part
        found: list[Token] = []
        for start, run in self.runs(parts, self.brackets, lambda at: signs[at].text in OPERATORS and (
                signs[at - 1].text in (signs[at].text, *BEFORE_PAIRS))):
            for at, part in enumerate(run):
                found += [signs[start + 1] if at else signs[start], *part]
        return found

    def brackets(self, tokens: Tokens) -> list[Token]:
        """The text within the brackets of an operand."""
        found: list[Token] = []
        for part in split(tokens, lambda token: True):
            if part[0].text == "(":
                maker = found[-1] if found else Token("", "")
                within = self.arguments(part[1:-1], maker)
                if VECTOR.fullmatch(maker.text) and len(within) == 1 and within[0][0].paired:
                    found.pop()  # on the line a vector is its component
                    found += [replace(within[0][0], lead=maker.lead), *within[0][1:]]
                    continue
                commas = [Token("", ",") for _ in within[1:]]
                inner = [token for at, argument in enumerate(within) for token in (*commas[at - 1:at], *argument)]
                found += [part[0], *inner, part[-1]]
            elif part[0].text in OPENING:
                found += [part[0], *self.statements(part[1:-1]), part[-1]]
            else:
                found += part
        return found

    def runs(self, parts: Sequence[Tokens], within: Callable[[Tokens], list[Token]],
             may_join: Callable[[int], bool] = lambda at: True, alike: bool = False) -> Iterator[tuple[int, list]]:
        """Each part that is in no pair, changed within, and each run: a pair, or the part of one that the text has with
        the one that stands behind it. With each the number of its first part."""
        at = 0
        while at < len(parts):
            run = [parts[at]]
            while (at + len(run) < len(parts) and may_join(at + len(run))
                   and next_names(run[-1], parts[at + len(run)], alike)):
                run.append(parts[at + len(run)])
            yield at, [within(run[0])] if len(run) == 1 else self.longer(run, alike)
            at += len(run)

    def longer(self, run: list[Tokens], alike: bool) -> list[list[Token]]:
        """A run in other dimensions."""
        what = text_of(run[0]).strip()
        if any(VECTOR.fullmatch(token.text) for token in run[0]):
            raise Unclear(f"`{what}` has a vector of the plane, and is one of a pair")
        if self.n == 1 and len(run) > 2:
            raise Unclear(f"`{what}` has more than one like it")
        run = [on_the_line(*run)] if self.n == 1 else [*run]
        for _ in range(self.n - 2):
            names = next_names(run[-2], run[-1], alike) or []
            if "" in names:
                raise Unclear(f"`{what}` is one of a pair that has no axis behind it")
            run.append([replace(token, lead=without_remark(token.lead), text=name)
                        for token, name in zip(run[-1], names)])
        return [[replace(token, paired=True) for token in part] for part in run]

    def name(self, name: str) -> str:
        if found := re.fullmatch(r"(hn_)?([iu]?)vec2", name):
            return (found[1] or "") + (SCALARS[found[2]] if self.n == 1 else f"{found[2]}vec{self.n}")
        if found := re.fullmatch(r"((?:hn_)?vec|hn_i_num)3", name):
            if self.n == 4:
                raise Unclear(f"{name} has no room for a value and four derivatives")
            return f"{found[1]}{self.n + 1}"
        if self.n == 1 and name == "hn_i_num2":
            return "hn_i_num"
        name = re.sub(r"^(hn_\w*[a-z])2$", rf"\g<1>{self.n}", name)
        return re.sub(r"^(\w+)2([dD])(_\w+)?$", rf"\g<1>{self.n}\2\3", name)

    def words(self, lead: str) -> str:
        """The words of comments and directives."""
        lead = lead.replace("on the plane", WHERE[self.n]).replace("along x and y", ALONG[self.n])
        return re.sub(r"\w+", lambda word: self.name(word[0]), lead).replace(EXAMPLE, EXAMPLES[self.n])


@functools.lru_cache(maxsize=None)  # tests make the same again and again
def in_dimension(n: int, plane: str, results_grow: bool = True) -> str:
    """The text of the plane in n dimensions. The types of results may stay."""
    rule = Rule(n)
    tokens = rule.statements(tokens_of(plane))
    none = Token("", "")
    found = ""
    for before, token, after in zip([none, *tokens], tokens, [*tokens[1:], none]):
        if not token.paired and {"y", "Y"} & set(token.text.split("_")):
            raise Unclear(f"{token.text} is in no pair: `{plane.splitlines()[token.line].strip()}`")
        stays = after.text in tuple(AXES) or before.text == "HN_FN" and not results_grow
        found += rule.words(token.lead) + (token.text if stays else rule.name(token.text))
    return found
