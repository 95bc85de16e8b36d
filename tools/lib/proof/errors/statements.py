"""Writes the statements of a user's GLSL as C++ (cpp.py has the expressions)."""

from __future__ import annotations

from proof.errors.cpp import Refused, Writer


class Statements(Writer):
    def block(self) -> str:
        out, constants = self.take("{"), dict(self.constants)
        while self.peek() != "}":
            out += f" {self.statement()}"
        self.constants = constants
        return f"{out} {self.take('}')}"

    def statement(self) -> str:
        text = self.peek()
        if text == "{":
            return self.block()
        if text == ";":
            return self.take()
        if text in ("if", "while", "switch"):
            return self.headed()
        if text == "for":
            return self.loop()
        if text == "do":
            out = f"{self.take()} {self.statement()} {self.take('while')} {self.take('(')}another() && ({self.expression()}"
            return f"{out}){self.take(')')}{self.take(';')}"
        if text in ("case", "default"):
            return self.label()
        if text == "return":
            return f"{self.take()} {self.expression()}{self.take(';')}"
        if text in ("break", "continue"):
            return f"{self.take()}{self.take(';')}"
        if text == "else":
            raise Refused(self.token, "an else has no if")
        if text in ("struct", "precision", "discard"):
            raise Refused(self.token, f"the search does not take {text} in a function")
        out = self.declaration() if self.is_declaration() else self.expression()
        return f"{out}{self.take(';')}"

    def headed(self) -> str:
        """if (...) ... else ..., while (...) ..., switch (...) ..."""
        kind = self.peek()
        keyword = self.take()
        before, after = {"while": ("another() && (", ")"), "switch": ("whole(", ")")}.get(kind, ("", ""))
        out = f"{keyword} {self.take('(')}{before}{self.expression()}{after}{self.take(')')} {self.statement()}"
        if kind == "if" and self.peek() == "else":
            out += f" {self.take()} {self.statement()}"
        return out

    def loop(self) -> str:
        constants = dict(self.constants)
        out = f"{self.take('for')} {self.take('(')}"
        if self.peek() != ";":
            out += self.declaration(of_loop=True) if self.is_declaration() else self.expression()
        out += f"{self.take(';')} another()"
        if self.peek() != ";":
            out += f" && ({self.expression()})"
        out += f"{self.take(';')} {self.expression()}{self.take(')')} {self.statement()}"
        self.constants = constants
        return out

    def label(self) -> str:
        out = self.take()
        if out.strip() == "case":
            start = self.at
            while self.peek() not in (":", ""):
                self.at += 1
            out += f" {self.constant(self.tokens[start:self.at])}"
        return f"{out}{self.take(':')}"
