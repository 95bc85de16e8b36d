"""GLSL's preprocessor, which keeps the comments, and leaves the macros in place that only stand for a number.

Such a macro becomes a constant of the WGSL module, so that its name stays in the text.
"""

from __future__ import annotations

import functools
import operator
import posixpath
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from translate.parsing.tokens import Token, Unknown, tokens_of

DIRECTIVE = re.compile(r"\s*#\s*(\w+)\s*(.*)")
CONDITIONAL = ("if", "ifdef", "ifndef", "elif", "else", "endif")
NAME = re.compile(r"(\w+)\s*\(")  # the first of a head
DEFINE = re.compile(r"(\w+)(\(([\w\s,]*)\))?\s*(.*)")
BINARY = {  # of the conditions of #if, by how strongly they bind
    "||": (1, lambda a, b: int(bool(a) or bool(b))), "&&": (2, lambda a, b: int(bool(a) and bool(b))),
    "==": (3, operator.eq), "!=": (3, operator.ne), "<": (4, operator.lt), "<=": (4, operator.le),
    ">": (4, operator.gt), ">=": (4, operator.ge), "+": (5, operator.add), "-": (5, operator.sub),
    "*": (6, operator.mul)}


@dataclass(frozen=True)
class Macro:
    name: str
    parameters: tuple[str, ...] | None  # None where it takes no parentheses
    body: tuple[Token, ...]
    comment: str  # behind it


@dataclass(frozen=True)
class Constant:
    """A macro that stands for a number, or for an expression of numbers."""
    name: str
    body: tuple[Token, ...]
    comment: str


class Line(NamedTuple):
    """A line of code without its comment."""
    code: str
    path: str
    number: int
    before: tuple[str, ...]  # the comments above it
    after: str               # the comment behind it

    def tokens(self) -> list[Token]:
        tokens = list(tokens_of(self.code, self.path, self.number))
        if self.before:
            tokens[0] = tokens[0]._replace(before=self.before)
        if self.after:
            tokens[-1] = tokens[-1]._replace(after=self.after)
        return tokens


class Item:
    """A definition, whose tokens are made when they are first used. `function` is the name of one, as far as it shows."""

    def __init__(self, lines: list[Line], expanded: Callable[[list[Token]], list[Token]], macros: Mapping[str, Macro]):
        self._lines = lines
        self._expanded = expanded
        text = ""
        for line in lines:
            text += f"{line.code} "
            if "{" in line.code:
                break
        head, brace, _ = text.partition("{")
        name = NAME.search(head) if brace and not head.startswith("struct ") else None
        self.function = name[1] if name and name[1] not in macros else ""

    @functools.cached_property
    def _parts(self) -> tuple[list[Token], list[Token], list[Line]]:
        """The text up to the first {, the text behind it on its line, and the lines below."""
        tokens: list[Token] = []
        for count, line in enumerate(self._lines, 1):
            tokens += line.tokens()
            if "{" in line.code:
                break
        end = next((i for i, token in enumerate(tokens, 1) if token.text == "{"), len(tokens))
        return self._expanded(tokens[:end]), tokens[end:], self._lines[count:]

    @property
    def head(self) -> list[Token]:
        return self._parts[0]

    def rest(self) -> list[Token]:
        _, tokens, lines = self._parts
        return self._expanded(tokens + [token for line in lines for token in line.tokens()])


@dataclass
class Branch:
    """The present branch of an #if. If the condition is unknown it is not decided, and all branches hold."""
    condition: str
    decided: bool
    holds: bool
    before: bool  # whether one above it holds, or it


class Conditions:
    """The open #ifs."""

    def __init__(self) -> None:
        self.open: list[Branch] = []

    def active(self) -> bool:
        return all(branch.holds for branch in self.open)

    def take(self, name: str, condition: str, value: Callable[[str, str], bool | None]) -> bool:
        """Takes a directive; returns whether it is decided. `value` evaluates a condition, None if that is unknown."""
        if name in ("if", "ifdef", "ifndef"):
            holds = value(name, condition) if self.active() else False
            self.open.append(Branch(condition, holds is not None, holds is not False, holds is not False))
            return holds is not None
        branch = self.open.pop()
        if name == "endif":
            return branch.decided
        if branch.decided:
            branch.holds = self.active() and not branch.before and (name == "else" or value(name, condition) is True)
            branch.before |= branch.holds
        self.open.append(branch)
        return branch.decided


class Preprocessor:
    """The definitions of a text, in the order in which a compiler sees them."""

    def __init__(self, library: Path, settings: dict[str, str]):
        self.library = library
        self.macros: dict[str, Macro] = {}
        self.constants: dict[str, Constant] = {}
        self.items: list[Item] = []
        self._chunk: list[Line] = []     # no item yet
        self._heading = ""               # the first line of the file, above its first token
        self._comments: list[str] = []   # above the next token
        self._guards: dict[str, str] = {}  # of files that a macro leaves out as a whole if they are included again
        for name, value in settings.items():
            self._define(f"{name} {value}", "the options", 0, "")

    def read(self, text: str, path: str) -> None:
        self._read(text, path)
        self._flush()

    def define(self, text: str) -> None:
        """NAME BODY or NAME(PARAMETERS) BODY."""
        self._define(text.rstrip(), text, 0, "")

    def expanded(self, line: str) -> str:
        return " ".join(token.text for token in self._expanded(list(tokens_of(line, line, 0)), self.macros, keep_constants=True))

    def stands_for(self, name: str, text: str) -> bool:
        """Whether a macro is defined as that text."""
        return name in self.macros and " ".join(token.text for token in self.macros[name].body) == text

    def holds(self, condition: str) -> bool:
        return self._holds(condition, condition, 0)

    def _read(self, text: str, path: str) -> None:
        heading = text.partition("\n")[0]
        self._heading = heading if heading.startswith("//") else ""
        conditions = Conditions()
        guard, outside = "", 0  # stands outside of a guard, or may
        for number, line in enumerate(text.split("\n"), 1):
            code, slashes, comment = line.partition("//")
            if "#" in code and (directive := DIRECTIVE.fullmatch(code.rstrip())):
                if not conditions.open:
                    outside += 1
                    guard = directive[2].strip() if directive[1] == "ifndef" and outside == 1 else ""
                comment = f"//{comment.rstrip()}" if slashes else ""
                self._direct(directive[1], directive[2].strip(), comment, path, number, conditions)
            elif conditions.active() and line != self._heading:
                outside += not conditions.open and code.strip() != ""
                self._take(code, f"//{comment.rstrip()}" if slashes else "", path, number)
        if conditions.open:
            raise Unknown(f"{path}: an #if has no #endif")
        if guard and outside == 1:
            self._guards[path] = guard

    def _take(self, code: str, comment: str, path: str, line: int) -> None:
        if not code.strip():
            self._comments.append(comment)
            return
        heading = [self._heading, ""] if self._heading else []
        self._chunk.append(Line(code, path, line, (*heading, *self._comments), comment))
        self._heading, self._comments = "", []

    def _direct(self, name: str, rest: str, comment: str, path: str, line: int, conditions: Conditions) -> None:
        if name in CONDITIONAL:
            if name in ("elif", "else", "endif") and not conditions.open:
                raise Unknown(f"{path}:{line}: #{name} has no #if")
            conditions.take(name, rest, lambda name, rest: self._holds(rest, path, line) if name in ("if", "elif") else
                            (rest in self.macros) == (name == "ifdef"))
            if name == "endif" and conditions.active():
                self._comments = []
        elif not conditions.active():
            return
        elif name == "define":
            self._flush()
            self._define(rest, path, line, comment)
            self._comments = []
        elif name == "undef":
            self._flush()
            self.macros.pop(rest, None)
            self._comments = []
        elif name == "include":
            self._include(rest, path, line)
        elif name == "error":
            raise Unknown(f"{path}:{line}: {rest}")
        else:
            raise Unknown(f"{path}:{line}: the translator does not know #{name}")

    def _include(self, rest: str, path: str, line: int) -> None:
        file = re.fullmatch(r'"([\w./]+)"', rest)
        within = posixpath.dirname(path) if (self.library / path).is_file() else ""
        name = posixpath.normpath(posixpath.join(within, file[1])) if file else ""
        if not name or not (self.library / name).is_file():
            raise Unknown(f"{path}:{line}: there is no {rest} in {self.library}")
        if self._guards.get(name, "") in self.macros:
            self._comments = []
            return
        self._flush()
        heading = self._heading
        self._read((self.library / name).read_text(encoding="ascii"), name)
        self._heading, self._comments = heading, []

    def _define(self, text: str, path: str, line: int, comment: str) -> None:
        match = DEFINE.fullmatch(text)
        if not match:
            raise Unknown(f"{path}:{line}: #define {text} is not one that the translator knows")
        name = match[1]
        parameters = None
        if match[2] is not None:
            parameters = tuple(part.strip() for part in match[3].split(",")) if match[3].strip() else ()
        body = tuple(tokens_of(match[4], path, line))
        macro = Macro(name, parameters, body, comment)
        if self._is_constant(macro):
            known = self.constants.get(name)
            if known and [token.text for token in known.body] != [token.text for token in body]:
                raise Unknown(f"{path}:{line}: {name} stands for two numbers")
            self.constants[name] = Constant(name, body, comment)
        self.macros[name] = macro

    def _is_constant(self, macro: Macro) -> bool:
        if macro.parameters is not None or not macro.body:
            return False
        known = all(token.kind == "number" or token.text in self.constants or token.text in tuple("+-*/()")
                    for token in macro.body)
        return known and any(token.kind == "number" for token in macro.body)

    def _flush(self) -> None:
        """Makes items of whole text, since macros are about to change."""
        if not self._chunk:
            return
        macros = dict(self.macros)
        item: list[Line] = []
        depth = 0
        for line in self._chunk:
            item.append(line)
            depth += line.code.count("{") - line.code.count("}")
            if depth == 0 and "}" in line.code:
                self._add(item, macros)
                item = []
        if item:
            self._add(item, macros)
        self._chunk = []

    def _add(self, lines: list[Line], macros: Mapping[str, Macro]) -> None:
        self.items.append(Item(lines, lambda tokens: self._expanded(tokens, macros, keep_constants=True), macros))

    def _expanded(self, tokens: list[Token], macros: Mapping[str, Macro], keep_constants: bool) -> list[Token]:
        stack = tokens[::-1]
        done: list[Token] = []
        comments: tuple[str, ...] = ()
        while stack:
            token = stack.pop()
            if comments:
                token = token._replace(before=comments + token.before)
                comments = ()
            macro = macros.get(token.text) if token.kind == "word" and token.text not in token.hidden else None
            if macro is None or (keep_constants and token.text in self.constants):
                done.append(token)
                continue
            hidden = token.hidden | {macro.name}
            body = list(macro.body)
            if macro.parameters is not None:
                if not stack or stack[-1].text != "(":
                    done.append(token)
                    continue
                arguments, last = self._arguments(token, stack)
                hidden = (token.hidden & last.hidden) | {macro.name}
                if len(arguments) != len(macro.parameters) and not (arguments == [[]] and not macro.parameters):
                    raise token.error(f"{macro.name} has {len(arguments)} arguments instead of {len(macro.parameters)}")
                values = {name: self._expanded(argument, macros, keep_constants)
                          for name, argument in zip(macro.parameters, arguments)}
                body = [part for piece in macro.body for part in values.get(piece.text, [piece])]
                token = token._replace(after=last.after)
            body = [Token(part.kind, part.text, token.path, token.line, (), "", part.hidden | hidden) for part in body]
            if body:
                body[0] = body[0]._replace(before=token.before)
                body[-1] = body[-1]._replace(after=token.after)
            else:
                comments = token.before
            stack += body[::-1]
        return done

    @staticmethod
    def _arguments(name: Token, stack: list[Token]) -> tuple[list[list[Token]], Token]:
        """Takes the arguments of a macro off the stack, and the parenthesis that closes them."""
        stack.pop()
        arguments: list[list[Token]] = [[]]
        depth = 0
        while stack:
            token = stack.pop()
            if token.text == ")" and depth == 0:
                return arguments, token
            depth += (token.text == "(") - (token.text == ")")
            if token.text == "," and depth == 0:
                arguments.append([])
            else:
                arguments[-1].append(token)
        raise name.error(f"the arguments of {name.text} have no end")

    def _holds(self, text: str, path: str, line: int) -> bool:
        defined = re.sub(r"defined\s*(?:\(\s*(\w+)\s*\)|(\w+))",
                         lambda match: str(int((match[1] or match[2]) in self.macros)), text)
        tokens = self._expanded(list(tokens_of(defined, path, line)), self.macros, keep_constants=False)
        tokens.append(Token("end", "", path, line))
        value, rest = self._value(tokens, 0)
        if rest[0].kind != "end":
            raise rest[0].error(f"{rest[0]} is not expected in #if {text}")
        return bool(value)

    def _value(self, tokens: list[Token], strength: int) -> tuple[int, list[Token]]:
        """The value of a condition, and the tokens behind it. Operators that bind as `strength` or weaker end it."""
        first, rest = tokens[0], tokens[1:]
        if first.text == "!":
            value, rest = self._value(rest, 7)
            value = int(not value)
        elif first.text == "(":
            value, rest = self._value(rest, 0)
            if rest[0].text != ")":
                raise rest[0].error(f"{rest[0]} stands where ) is expected in a condition")
            rest = rest[1:]
        elif first.kind == "number":
            value = int(first.text.rstrip("uU"), 0)
        else:
            raise first.error(f"{first} has no value in a condition")
        while rest[0].text in BINARY and BINARY[rest[0].text][0] > strength:
            binds, function = BINARY[rest[0].text]
            other, rest = self._value(rest[1:], binds)
            value = int(function(value, other))
        return value, rest
