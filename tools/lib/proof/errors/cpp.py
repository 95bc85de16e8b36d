"""Writes GLSL of a user's as C++ over own.hpp: a statement or an expression at a time, on the lines where it stands."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from proof.errors.glsl import Token
from proof.errors.names import COARSE, KEYWORDS, OF_CPP, QUALIFIERS, TAKEN, TYPES, axes_of, refusal

ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
COMPARISONS = {"<": "< less >", ">": "> greater <", "<=": "<= at_most >=", ">=": ">= at_least <=", "==": "== same ==",
               "!=": "!= different !="}
CONSTRUCTORS = {"int": "own_int", "uint": "own_uint", "bool": "own_bool"}
OPENING = {"(": ")", "[": "]", "{": "}"}


class Refused(Exception):
    """A text that the search does not take: its place and the reason."""

    def __init__(self, token: Token, reason: str):
        super().__init__(f"{token.place}: {reason}")


def end_of_group(tokens: Sequence[Token], start: int) -> int:
    """Where the bracket at start closes."""
    depth = 0
    for at in range(start, len(tokens)):
        depth += tokens[at].text in OPENING
        depth -= tokens[at].text in OPENING.values()
        if depth == 0:
            return at
    raise Refused(tokens[start], f"a {tokens[start].text} has no {OPENING[tokens[start].text]}")


@dataclass
class Scope:
    """The names that the text before declares."""
    types: dict[str, str] = field(default_factory=lambda: dict(TYPES))
    functions: set[str] = field(default_factory=set)
    members: set[str] = field(default_factory=set)  # of its structs
    constants: dict[str, int] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)  # with their reasons


class Writer:
    def __init__(self, tokens: Sequence[Token], scope: Scope):
        self.tokens = tokens
        self.scope = scope
        self.constants = dict(scope.constants)
        self.at = 0
        self.line = tokens[0].line if tokens else 0
        self.temporaries = 0
        self.declared: list[Token] = []  # variables

    # --- Tokens ---

    def peek(self, ahead: int = 0) -> str:
        return self.tokens[self.at + ahead].text if self.at + ahead < len(self.tokens) else ""

    @property
    def token(self) -> Token:
        return self.tokens[min(self.at, len(self.tokens) - 1)]

    def take(self, *expected: str) -> str:
        """The next token, on its line."""
        if self.at >= len(self.tokens) or expected and self.peek() not in expected:
            found = f"{self.peek()} stands where" if self.at < len(self.tokens) else "the text ends where"
            raise Refused(self.token, f"{found} {' or '.join(expected) or 'more'} is expected")
        token = self.token
        self.at += 1
        return self.lines(token) + token.text

    def lines(self, token: Token) -> str:
        """The line feeds up to a token."""
        count = max(token.line - self.line, 0)
        self.line += count
        return "\n" * count

    def word(self) -> str:
        """A name, whose line the next token has to make up for."""
        if self.token.kind != "word" or self.peek() in KEYWORDS:
            raise Refused(self.token, f"{self.peek()} stands where a name is expected")
        self.at += 1
        return self.tokens[self.at - 1].text

    # --- Types and declarations ---

    def qualifiers(self) -> list[str]:
        found = []
        while self.peek() in QUALIFIERS:
            if self.peek() in COARSE and not re.match("u?int|[iu]vec", self.peek(1)):
                raise Refused(self.token, f"{self.peek()}: such floats may have 10 bits")
            found.append(self.peek())
            self.at += 1
            if found[-1] == "layout" and self.peek() == "(":
                self.at = end_of_group(self.tokens, self.at) + 1
        return found

    def type_of(self, name: str) -> str:
        return self.scope.types.get(name) or (name if name.startswith("hn_") else "")

    def is_declaration(self) -> bool:
        at = self.at
        while at < len(self.tokens) and self.tokens[at].text in QUALIFIERS:
            at += 1
        if at > self.at:
            return True
        name, after = self.peek(), self.tokens[at + 1] if at + 1 < len(self.tokens) else self.token
        if after.text == "[" and self.type_of(name):  # float[3] a, and not float[3](...)
            after = self.tokens[min(end_of_group(self.tokens, at + 1) + 1, len(self.tokens) - 1)]
        return self.token.kind == "word" and name not in KEYWORDS and after.kind == "word"

    def type(self) -> str:
        token = self.token
        name = self.word()
        if reason := self.scope.refused.get(name) or refusal(name):
            raise Refused(token, reason)
        if not self.type_of(name):
            raise Refused(token, f"{name} is no type that is declared")
        return self.type_of(name)

    def sizes(self) -> list[int]:
        """The sizes of an array, behind its type or its name; 0 for one that is not written."""
        found = []
        while self.peek() == "[":
            end = end_of_group(self.tokens, self.at)
            inside = self.tokens[self.at + 1:end]
            found.append(self.constant(inside) if inside else 0)
            self.at = end + 1
        return found

    def constant(self, tokens: Sequence[Token]) -> int:
        """The value of an expression of integers."""
        text = "".join(f" {self.constants.get(token.text, token.text.rstrip('uU'))} " for token in tokens)
        if not re.fullmatch(r"[\s\d()+*/%<>-]+|\s*0[xX][0-9a-fA-F]+\s*", text):
            raise Refused(tokens[0], f"{''.join(token.text for token in tokens)} is no number that the search knows here")
        try:
            return int(eval(text.replace("/", "//").strip()))  # noqa: S307 (numbers and operators alone)
        except (SyntaxError, ArithmeticError, ValueError):
            raise Refused(tokens[0], f"{text.strip()} is no number") from None

    @staticmethod
    def array(type_: str, sizes: Sequence[int]) -> str:
        for size in reversed(sizes):
            type_ = f"Array<{type_}, {size}>"
        return type_

    def declaration(self, of_file: bool = False, of_loop: bool = False) -> str:
        """Up to its ";". A variable begins behind its own value, which may have another of that name."""
        is_constant = "const" in self.qualifiers()
        type_ = self.type()
        shared, found = self.sizes(), []
        while True:
            token = self.token
            feeds, name = self.lines(token), self.word()
            self.declared.append(token)
            sizes = self.sizes() + shared
            value, start = "", self.at
            self.constants.pop(name, None)
            if self.peek() == "=":
                self.at += 1
                value = self.expression(commas=False)
                given = self.tokens[start + 1:self.at]
                if 0 in sizes:
                    sizes[sizes.index(0)] = self.count_of(given)
                if is_constant and type_ in ("Int", "Uint") and not sizes:
                    self.remember(name, given)
            full, is_own = self.array(type_, sizes), any(one.text == name for one in self.tokens[start:self.at])
            if is_own and (of_file or of_loop):
                raise Refused(token, f"the value of {name} has another {name}")
            if is_own:
                self.temporaries += 1
                found.append(f"{feeds}const {full} before_{self.temporaries} ={value}; {full} u_{name} = before_{self.temporaries}")
            else:
                head = "" if of_loop and found else f"{'const ' * is_constant}{full} "
                found.append(f"{feeds}{head}u_{name}{f' ={value}' if value else '{}'}")
            if self.peek() != ",":
                return (", " if of_loop else "; ").join(found)
            self.at += 1

    def remember(self, name: str, value: Sequence[Token]) -> None:
        try:
            self.constants[name] = self.constant(value)
        except Refused:
            self.constants.pop(name, None)

    def count_of(self, value: Sequence[Token]) -> int:
        """The number of elements of float[](...)."""
        start = next((i for i, token in enumerate(value) if token.text == "("), 0)
        if not value or value[start].text != "(":
            raise Refused(self.token, "an array has no size")
        depth, count = 0, 1
        for token in value[start:end_of_group(value, start)]:
            depth += (token.text in OPENING) - (token.text in OPENING.values())
            count += token.text == "," and depth == 1
        return count

    # --- Expressions ---

    def expression(self, commas: bool = True) -> str:
        """Up to a bracket that closes, a ";" or a ":"; or up to a ","."""
        out, is_operand = "", True  # expected
        while self.at < len(self.tokens) and self.peek() not in (";", ")", "]", "}", ":"):
            text = self.peek()
            if text == "," and not commas:
                break
            if self.token.kind in ("word", "number") or text == "(":
                out += f" {self.postfix()}"
                is_operand = False
                continue
            sign = self.take()
            if text == "?":
                out += f"{sign} {self.expression(False)} {self.take(':')} {self.expression(False)}"
            elif text in COMPARISONS:
                out += f" {sign[:-len(text)]}{COMPARISONS[text]}"
            elif text in ("/", "%"):
                out += f" {sign} divisor({self.unary()})"
                continue
            elif text in ("/=", "%="):
                out += f" {sign} divisor({self.expression(False)})"
                continue
            elif text == "^^" or text in "[{":
                raise Refused(self.tokens[self.at - 1], f"the search does not take {text} here")
            elif not (text == "+" and is_operand):
                out += f" {sign}"
            is_operand = text not in ("++", "--")
        return out

    def unary(self) -> str:
        out = ""
        while self.peek() in ("+", "-", "!", "~", "++", "--"):
            sign = self.take()
            out += "" if sign.strip() == "+" else f" {sign}"
        return out + self.postfix()

    def arguments(self) -> str:
        open_ = self.take("(")
        if self.peek() == "void":
            self.take("void")
        return open_ + self.expression() + self.take(")")

    def postfix(self) -> str:
        """A number, a name or parentheses, with all that follows: a call, members, elements."""
        out, axes = self.primary(), []
        while True:
            if self.peek() == ".":
                self.at += 1
                token = self.token
                name = self.word()
                next_axes = axes_of(name)
                if name == "length" and self.peek() == "(":
                    out += f".length{self.arguments()}"
                elif next_axes and name in self.scope.members:
                    out, axes = self.either(self.swizzled(out, axes), name, next_axes), []
                elif next_axes:
                    if axes and max(next_axes) >= len(axes):
                        raise Refused(token, f"{name} is beyond the swizzle before it")
                    axes = [axes[axis] for axis in next_axes] if axes else next_axes
                    if len(axes) == 1:
                        out, axes = f"{out}.{'xyzw'[axes[0]]}", []
                else:
                    out, axes = f"{self.swizzled(out, axes)}.{'u_' * (name in OF_CPP)}{name}", []
            elif self.peek() == "[":
                bracket = self.token
                index = f"{self.take('[')[:-1]}{self.expression()}{self.take(']')[:-1]}"
                if axes and self.peek() in ASSIGNMENTS | {"++", "--"}:
                    raise Refused(bracket, "an element of a swizzle is written")
                out, axes = f"at({self.swizzled(out, axes)}, {index})", []
            else:
                break
        if axes and self.peek() in ASSIGNMENTS:
            if len({*axes}) < len(axes):
                raise Refused(self.token, "a swizzle is written that has a component twice")
            out = f"swizzle<{', '.join(map(str, axes))}>({out})"
        else:
            out = self.swizzled(out, axes)
        while self.peek() in ("++", "--"):
            out += self.take()
        return out

    @staticmethod
    def swizzled(of: str, axes: Sequence[int]) -> str:
        return f"swizzled<{', '.join(map(str, axes))}>({of})" if axes else of

    def either(self, of: str, name: str, axes: Sequence[int]) -> str:
        """A member of a struct, or a swizzle: the type decides."""
        member = f"{'u_' * (name in OF_CPP)}{name}"
        kind = "swizzle" if self.peek() in ASSIGNMENTS else "swizzled"
        other = f"(v.{'xyzw'[axes[0]]})" if len(axes) == 1 else f"{kind}<{', '.join(map(str, axes))}>(v)"
        return (f"[](auto&& v) -> decltype(auto) {{ if constexpr (requires {{ v.{member}; }}) {{ return (v.{member}); }} "
                f"else {{ return {other}; }} }}({of})")

    def primary(self) -> str:
        token = self.token
        if token.kind == "number":
            text = self.take()
            feeds, number = text[:len(text) - len(token.text)], token.text
            if re.match(r"0[xX]|\d+[uU]?$", number):
                return f"{feeds}{'Uint' if number[-1] in 'uU' else 'Int'}({number})"
            return f"{feeds}Float({number.rstrip('fF')}_f)"
        if token.text == "(":
            return self.arguments()
        name = self.peek()
        if reason := self.reason(name):
            raise Refused(token, reason)
        if name in ("true", "false"):
            return self.take()
        feeds = self.lines(token)
        name = self.word()
        if self.type_of(name) and self.peek() in ("(", "[") and not (name.startswith("hn_") and self.peek() == "["):
            return feeds + self.constructor(name)
        if name.startswith(("hn_", "HN_")):
            return feeds + name
        if self.peek() != "(":
            return f"{feeds}u_{name}"
        if name not in self.scope.functions and name not in TAKEN:
            raise Refused(token, f"{name} is not declared")
        return f"{feeds}{'u_' if name in self.scope.functions else 'own_'}{name}{self.arguments()}"

    def reason(self, name: str) -> str:
        """Why a name in an expression is refused, or nothing."""
        if name in self.scope.functions or any(one.text == name for one in self.declared):
            return ""
        is_call = self.peek(1) == "(" or name.startswith("gl_")
        return self.scope.refused.get(name) or (refusal(name) if is_call else "")

    def constructor(self, name: str) -> str:
        """float(...), or float[3](...)."""
        if self.peek() == "(":
            return f"{CONSTRUCTORS.get(name, self.type_of(name))}{self.arguments()}"
        sizes = self.sizes()
        if 0 in sizes:
            sizes[sizes.index(0)] = self.count_of(self.tokens[self.at:])
        return self.array(self.type_of(name), sizes) + self.arguments()
