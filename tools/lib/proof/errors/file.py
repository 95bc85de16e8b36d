"""The definitions of a GLSL file of a user's: its functions as C++, or why they are refused."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from proof.errors.cpp import Refused, Scope, end_of_group
from proof.errors.glsl import Token
from proof.errors.names import COARSE, OF_CPP, STORAGE
from proof.errors.statements import Statements


@dataclass
class Parameter:
    type: str  # as C++ has it
    name: str
    way: str  # "", "out" or "inout"


@dataclass
class Item:
    """A struct, a variable or a function."""
    token: Token  # its name
    code: str = ""
    number: int = 0  # of all items
    names: tuple[str, ...] = ()  # which others use
    refused: str = ""  # FILE:LINE: why
    type: str = ""  # of a function, from here on
    parameters: list[Parameter] = field(default_factory=list)
    words: frozenset[str] = frozenset()
    calls: frozenset[str] = frozenset()
    head: str = ""  # as the user wrote it

    @property
    def name(self) -> str:
        return self.token.text

    @property
    def is_function(self) -> bool:
        return self.type != ""


class Reader(Statements):
    """Reads the items of a file."""

    def __init__(self, tokens: Sequence[Token]):
        super().__init__(tokens, Scope())
        self.items: list[Item] = []
        self.coarse = ""  # where a precision statement made all floats so

    def read(self) -> list[Item]:
        self.scope.members = set(self.members())
        while self.at < len(self.tokens):
            start = self.at
            self.line = self.token.line
            end = self.end_of_item()
            try:
                self.item(end)
            except Refused as error:
                self.refuse(start, end, str(error))
            self.at = end
        return self.items

    def end_of_item(self) -> int:
        """Behind its ";", or behind the } of a function."""
        at = self.at
        while at < len(self.tokens):
            text = self.tokens[at].text
            if text in ("(", "[", "{"):
                of_function = text == "{" and at > self.at and self.tokens[at - 1].text == ")"
                at = end_of_group(self.tokens, at)
                if of_function:
                    return at + 1
            elif text == ";":
                return at + 1
            at += 1
        return at

    def members(self) -> Iterator[str]:
        """The members of all structs, and their types."""
        for at, token in enumerate(self.tokens[:-2]):
            if token.text == "struct" and self.tokens[at + 2].text == "{":
                yield from (one.text for one in self.tokens[at + 3:end_of_group(self.tokens, at + 2)] if one.kind == "word")

    def refuse(self, start: int, end: int, reason: str) -> None:
        """An item that cannot be written: who uses its names is refused, too."""
        names = list(self.names(start, end))
        for token in names:
            self.scope.refused.setdefault(token.text, reason.split(": ", 1)[-1])

    def names(self, start: int, end: int) -> Iterator[Token]:
        """The names that an item declares, as far as they show."""
        at = start
        while at < end - 1:
            token, after = self.tokens[at], self.tokens[at + 1].text
            if token.text == "=":
                at = next((i for i in range(at, end) if self.tokens[i].text in (",", ";")), end)
            elif token.kind == "word" and (after in ("(", "=", ";", "[", ",") and not self.type_of(token.text)
                                           or self.tokens[start].text == "struct" and at == start + 1):
                yield token
                if after in ("(", "{"):
                    return
            at += 1

    # --- Items ---

    def item(self, end: int) -> None:
        text = self.peek()
        if text == ";":
            return
        if text == "precision":
            if self.peek(1) in COARSE and self.peek(2) == "float":
                self.coarse = f"{self.token.place} makes floats {self.peek(1)}, which may have 10 bits"
            return
        if text == "struct":
            self.struct()
            return
        start = self.at
        qualifiers = self.qualifiers()
        if storage := STORAGE & {*qualifiers}:
            self.inputs(end, min(storage))
            return
        if qualifiers and self.peek() == ";":
            return
        if self.peek() == "void" or self.tokens[self.at + 1:self.at + 2] and self.is_head():
            self.function(end)
            return
        self.at = start
        self.variables(end)

    def is_head(self) -> bool:
        at = self.at + 1
        while at < len(self.tokens) and self.tokens[at].text == "[":
            at = end_of_group(self.tokens, at) + 1
        return at + 1 < len(self.tokens) and self.tokens[at].kind == "word" and self.tokens[at + 1].text == "("

    def inputs(self, end: int, storage: str) -> None:
        """uniform float time; and blocks of them. Their users are refused."""
        for at in range(self.at, end - 1):
            if self.tokens[at].kind == "word" and self.tokens[at + 1].text in (";", ",", "[", "="):
                name = self.tokens[at].text
                self.scope.refused[name] = f"{name} is {'an' if storage[0] in 'aio' else 'a'} {storage} of a shader"

    def struct(self) -> None:
        self.at += 1
        token = self.token
        name, members = self.word(), []
        self.take("{")
        while self.peek() != "}":
            self.qualifiers()
            type_ = self.type()
            shared = self.sizes()
            while True:
                feeds, member = self.lines(self.token), self.word()
                full = self.array(type_, self.sizes() + shared)
                members.append(f"{feeds}{full} {'u_' * (member in OF_CPP)}{member}{{}};")
                if self.peek() != ",":
                    break
                self.at += 1
            self.take(";")
        self.take("}")
        self.scope.types[name] = f"u_{name}"
        self.items.append(Item(token, f"struct u_{name} {{ {' '.join(members)} }};", (name,)))
        if self.peek() != ";":
            raise Refused(self.token, "a variable behind its struct")

    def variables(self, end: int) -> None:
        writer = Statements(self.tokens[self.at:end], self.scope)
        code = f"{writer.declaration(of_file=True)}{writer.take(';')}"
        self.scope.constants = writer.constants
        for token in writer.declared:
            self.scope.refused.pop(token.text, None)
        self.items.append(Item(writer.declared[0], code, tuple(token.text for token in writer.declared)))

    def function(self, end: int) -> None:
        start = self.at
        is_void = self.peek() == "void"
        self.at += is_void
        type_ = "void" if is_void else self.array(self.type(), self.sizes())
        token = self.token
        name = self.word()
        close = end_of_group(self.tokens, self.at)
        if self.tokens[end - 1].text == ";":  # a declaration
            self.scope.functions.add(name)
            return
        head = text_of(self.tokens[start:close + 1])
        body = self.tokens[close + 1:end]
        item = Item(token, names=(name,), type=type_, head=head,
                    words=frozenset(one.text for one in body if one.kind == "word"),
                    calls=frozenset(one.text for one, after in zip(body, body[1:]) if after.text == "("))
        self.items.append(item)
        self.scope.refused.pop(name, None)
        self.scope.functions.add(name)
        try:
            item.parameters = list(self.parameters(close))
            if self.coarse:
                raise Refused(token, self.coarse)
            writer = Statements(body, self.scope)
            writer.declared = [one for one in self.tokens[start:close] if one.kind == "word"]
            for one in writer.declared:
                writer.constants.pop(one.text, None)
            code = writer.block()
            listed = ", ".join(f"{one.type}{'&' * bool(one.way)} u_{one.name}" for one in item.parameters)
            item.code = f"{type_} u_{name}({listed}) {{ {code}{'' if is_void else ' return {};'} }}"
        except Refused as error:
            item.refused = str(error)

    def parameters(self, close: int) -> Iterator[Parameter]:
        self.at += 1
        if self.peek() == "void":
            self.at += 1
        while self.at < close:
            qualifiers = {*self.qualifiers()}
            type_ = self.type()
            shared = self.sizes()
            name = self.word() if self.token.kind == "word" else f"unnamed_{self.at}"
            way = next((way for way in ("inout", "out") if way in qualifiers), "")
            yield Parameter(self.array(type_, self.sizes() + shared), name, way)
            if self.peek() == ",":
                self.at += 1
            elif self.at != close:
                raise Refused(self.token, f"{self.peek()} stands in the parameters")


def text_of(tokens: Sequence[Token]) -> str:
    """On one line, with usual blanks."""
    out = ""
    for before, token in zip((None, *tokens), tokens):
        near = before is None or before.text in ("(", "[") or token.text in ("(", ")", "[", "]", ",")
        out += token.text if near else f" {token.text}"
    return out
