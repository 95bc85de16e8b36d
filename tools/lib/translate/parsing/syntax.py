"""The tree of the GLSL that the library is written in: a narrow subset (docs/develop/internals.md, "One text in several
languages"). Other GLSL is an error that names the place."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple, Union

from translate.parsing.preprocessor import Item
from translate.parsing.tokens import Token

SCALARS = ("float", "int", "uint", "bool")
VECTORS = tuple(f"{prefix}vec{n}" for prefix in ("", "i", "u") for n in (2, 3, 4))
ASSIGNMENTS = ("=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=")
STRENGTHS = {"||": 1, "&&": 2, "|": 3, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, ">": 7, "<=": 7, ">=": 7, "<<": 8,
             ">>": 8, "+": 9, "-": 9, "*": 10, "/": 10, "%": 10}


@dataclass(frozen=True)
class Number:
    at: Token


@dataclass(frozen=True)
class Truth:
    at: Token


@dataclass(frozen=True)
class Name:
    at: Token


@dataclass(frozen=True)
class Call:
    at: Token  # the name of the called function, or of the constructed type
    arguments: tuple[Expression, ...]


@dataclass(frozen=True)
class Member:
    at: Token  # the name behind the point
    of: Expression


@dataclass(frozen=True)
class Index:
    at: Token  # the [
    of: Expression
    index: Expression


@dataclass(frozen=True)
class Unary:
    at: Token
    operand: Expression


@dataclass(frozen=True)
class Binary:
    at: Token
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Choice:
    at: Token
    condition: Expression
    yes: Expression
    no: Expression


@dataclass(frozen=True)
class Parentheses:
    at: Token
    inside: Expression


Expression = Union[Number, Truth, Name, Call, Member, Index, Unary, Binary, Choice, Parentheses]


@dataclass(frozen=True)
class Comments:
    before: tuple[str, ...] = ()
    after: str = ""


@dataclass(frozen=True)
class Declare:
    at: Token  # the name
    type: str  # of an array "uint[8]"
    value: Expression | None
    comments: Comments


@dataclass(frozen=True)
class Assign:
    at: Token  # the operator, or ++ and --
    target: Expression
    value: Expression | None
    comments: Comments


@dataclass(frozen=True)
class Evaluate:
    call: Call
    comments: Comments


@dataclass(frozen=True)
class Return:
    at: Token
    value: Expression | None
    comments: Comments


@dataclass(frozen=True)
class Break:
    comments: Comments


@dataclass(frozen=True)
class Block:
    statements: tuple[Statement, ...]
    comments: Comments


@dataclass(frozen=True)
class If:
    at: Token
    condition: Expression
    yes: Block
    no: Block | If | None
    comments: Comments


@dataclass(frozen=True)
class Loop:
    at: Token
    start: Declare | None
    condition: Expression | None
    step: Assign | None
    body: Block
    comments: Comments


@dataclass(frozen=True)
class DoLoop:
    at: Token
    body: Block
    condition: Expression  # tested behind the body
    comments: Comments


@dataclass(frozen=True)
class Switch:
    at: Token
    value: Expression
    cases: tuple[tuple[tuple[Expression | None, ...], Block], ...]  # their values; None for the default
    comments: Comments


Statement = Union[Declare, Assign, Evaluate, Return, Break, Block, If, Loop, DoLoop, Switch]


@dataclass(frozen=True)
class Parameter:
    at: Token  # the name
    type: str
    is_set: bool  # out and inout


class Head(NamedTuple):
    at: Token  # the name
    type: str
    parameters: tuple[Parameter, ...]
    comments: Comments
    read_body: Callable[[], Block]


class Function:
    """Its head and its body are read when they are first used: a pick needs few of a thousand functions."""

    def __init__(self, name: str, read: Callable[[], Head]):
        self.name = name
        self._read = read

    @functools.cached_property
    def head(self) -> Head:
        return self._read()

    @functools.cached_property
    def body(self) -> Block:
        return self.head.read_body()

    @functools.cached_property
    def types(self) -> tuple[str, ...]:
        return tuple(parameter.type for parameter in self.head.parameters)

    def __getattr__(self, name: str) -> object:
        """Its head: at, type, parameters and comments. From then on it is an attribute of its own, which is quicker."""
        value = getattr(self.head, name)
        self.__dict__[name] = value
        return value


@dataclass(frozen=True)
class Struct:
    at: Token
    fields: tuple[tuple[str, str, Comments], ...]  # name and type
    comments: Comments

    @property
    def name(self) -> str:
        return self.at.text


def definitions(items: Iterable[Item]) -> list[Function | Struct]:
    """The definitions of a text that was preprocessed."""
    found: list[Function | Struct] = []
    types = {*SCALARS, *VECTORS, "void"}
    for item in items:
        if item.function:
            found.append(Function(item.function, functools.partial(_read_head, item, types)))
        else:
            found += Parser([*item.head, *item.rest()], types).parse()
    return found


def _read_head(item: Item, types: set[str]) -> Head:
    parser = Parser(item.head, types)
    head = parser.head()

    def body() -> Block:
        inside = Parser([item.head[-1], *item.rest()], types)
        found = inside.block()
        inside.end("a function")
        return found

    return head._replace(read_body=body)


class Parser:
    def __init__(self, tokens: list[Token], types: set[str] | None = None):
        last = tokens[-1] if tokens else Token("end", "", "an empty text", 1)
        self.tokens = [*tokens, Token("end", "", last.path, last.line)]
        self.position = 0
        self.types = {*SCALARS, *VECTORS, "void"} if types is None else types

    def parse(self) -> list[Function | Struct]:
        found: list[Function | Struct] = []
        while self._next.kind != "end":
            found.append(self._struct() if self._next.text == "struct" else self._function())
        return found

    def expression(self) -> Expression:
        found = self._expression()
        self.end("an expression")
        return found

    def end(self, what: str) -> None:
        if self._next.kind != "end":
            raise self._next.error(f"{self._next} is not expected behind {what}")

    # Tokens.

    @property
    def _next(self) -> Token:
        return self.tokens[self.position]

    def _take(self) -> Token:
        token = self._next
        self.position += token.kind != "end"
        return token

    def _takes(self, *texts: str) -> Token | None:
        return self._take() if self._next.text in texts and self._next.kind != "end" else None

    def _expect(self, text: str) -> Token:
        if self._next.text != text:
            raise self._next.error(f"{self._next} stands where {text} is expected")
        return self._take()

    def _word(self, what: str) -> Token:
        if self._next.kind != "word" or self._next.text in self.types:
            raise self._next.error(f"{self._next} stands where {what} is expected")
        return self._take()

    def _type(self) -> str:
        if self._next.text not in self.types:
            raise self._next.error(f"{self._next} stands where a type is expected")
        return self._take().text

    def _comments(self, first: int) -> Comments:
        """The comments of a statement that has just been taken: those in its middle stand above it."""
        tokens = self.tokens[first:self.position]
        before = [line for i, token in enumerate(tokens) for line in token.before if line or i == 0]
        before += [token.after for token in tokens[:-1] if token.after]
        return Comments(tuple(before), tokens[-1].after)

    # Text outside of functions.

    def _struct(self) -> Struct:
        comments = Comments(self._take().before)
        name = self._word("the name of a struct")
        self.types.add(name.text)
        self._expect("{")
        fields = []
        while not self._takes("}"):
            first = self.position
            type_ = self._type()
            field = self._word("the name of a field")
            self._expect(";")
            fields.append((field.text, type_, self._comments(first)))
        self._expect(";")
        return Struct(name, tuple(fields), comments)

    def head(self) -> Head:
        """The head of a function, as far as its {."""
        comments = Comments(self._next.before)
        type_ = self._type()
        name = self._word("the name of a function")
        self._expect("(")
        parameters: list[Parameter] = []
        while not self._takes(")"):
            if parameters:
                self._expect(",")
            is_set = self._takes("out", "inout") is not None
            parameter_type = self._type()
            parameters.append(Parameter(self._word("the name of a parameter"), parameter_type, is_set))
        if self._next.text != "{":
            raise self._next.error(f"{self._next} stands where {{ is expected")
        return Head(name, type_, tuple(parameters), comments, self.block)

    def _function(self) -> Function:
        head = self.head()
        block = self.block()
        return Function(head.at.text, lambda: head._replace(read_body=lambda: block))

    # Statements.

    def block(self) -> Block:
        first = self.position
        self._expect("{")
        comments = self._comments(first)
        statements = []
        while self._next.text != "}":
            if self._next.kind == "end":
                raise self._next.error("a { has no }")
            statements.append(self._statement())
        self._take()
        return Block(tuple(statements), Comments((), comments.after))

    def _body(self) -> Block:
        """The block behind an if or a for; a statement on its own is one, too."""
        return self.block() if self._next.text == "{" else Block((self._statement(),), Comments())

    def _statement(self) -> Statement:
        first = self._next
        if first.text == "{":
            return self.block()
        if first.text == "if":
            return self._if()
        if first.text == "for":
            return self._for()
        if first.text == "while":
            return self._while()
        if first.text == "do":
            return self._do()
        if first.text == "switch":
            return self._switch()
        start = self.position
        if self._takes("return"):
            value = None if self._next.text == ";" else self._expression()
            self._expect(";")
            return Return(first, value, self._comments(start))
        if self._takes("break"):
            self._expect(";")
            return Break(self._comments(start))
        if first.text in self.types and self.tokens[self.position + 1].kind == "word":
            return self._declaration()
        statement = self._simple()
        self._expect(";")
        comments = self._comments(start)
        if isinstance(statement, Call):
            return Evaluate(statement, comments)
        return Assign(statement.at, statement.target, statement.value, comments)

    def _declaration(self) -> Declare:
        start = self.position
        type_ = self._type()
        name = self._word("the name of a variable")
        if self._takes("["):
            type_ += f"[{self._take()}]"
            self._expect("]")
        value = self._expression() if self._takes("=") else None
        self._expect(";")
        return Declare(name, type_, value, self._comments(start))

    def _simple(self) -> Assign | Call:
        """An assignment or a call, without the semicolon."""
        before = self._takes("++", "--")
        if before:
            return Assign(before, self._postfix(), None, Comments())
        target = self._postfix()
        if isinstance(target, Call):
            return target
        sign = self._takes(*ASSIGNMENTS, "++", "--")
        if not sign:
            raise self._next.error(f"{self._next} stands where an assignment is expected")
        value = None if sign.text in ("++", "--") else self._expression()
        return Assign(sign, target, value, Comments())

    def _if(self) -> If:
        start = self.position
        at = self._expect("if")
        self._expect("(")
        condition = self._expression()
        self._expect(")")
        comments = Comments(self._comments(start).before)
        yes = self._body()
        no: Block | If | None = None
        if self._takes("else"):
            no = self._if() if self._next.text == "if" else self._body()
        return If(at, condition, yes, no, comments)

    def _for(self) -> Loop:
        start_position = self.position
        at = self._expect("for")
        self._expect("(")
        start = None if self._takes(";") else self._declaration()
        condition = None if self._next.text == ";" else self._expression()
        self._expect(";")
        step = None if self._next.text == ")" else self._simple()
        if isinstance(step, Call):
            raise step.at.error(f"{step.at} is called where a for loop has its step")
        self._expect(")")
        comments = Comments(self._comments(start_position).before)
        return Loop(at, start, condition, step, self._body(), comments)

    def _while(self) -> Loop:
        start = self.position
        at = self._expect("while")
        self._expect("(")
        condition = self._expression()
        self._expect(")")
        comments = Comments(self._comments(start).before)
        return Loop(at, None, condition, None, self._body(), comments)

    def _do(self) -> DoLoop:
        start = self.position
        at = self._expect("do")
        body = self._body()
        self._expect("while")
        self._expect("(")
        condition = self._expression()
        self._expect(")")
        self._expect(";")
        return DoLoop(at, body, condition, Comments(self._comments(start).before))

    def _switch(self) -> Switch:
        start = self.position
        at = self._expect("switch")
        self._expect("(")
        value = self._expression()
        self._expect(")")
        self._expect("{")
        comments = Comments(self._comments(start).before)
        cases = []
        while not self._takes("}"):
            labels: list[Expression | None] = []
            while label := self._takes("case", "default"):
                labels.append(self._expression() if label.text == "case" else None)
                self._expect(":")
            statements: list[Statement] = []
            while self._next.text not in ("case", "default", "}"):
                statements.append(self._statement())
            if not labels or self._next.text != "}" and not isinstance(statements[-1], (Break, Return)):
                raise self._next.error(f"{self._next} stands where a case has to end")
            cases.append((tuple(labels), Block(tuple(statements), Comments())))
        return Switch(at, value, tuple(cases), comments)

    # Expressions.

    def _expression(self) -> Expression:
        condition = self._binary(0)
        at = self._takes("?")
        if not at:
            return condition
        yes = self._expression()
        self._expect(":")
        return Choice(at, condition, yes, self._expression())

    def _binary(self, strength: int) -> Expression:
        left = self._unary()
        while STRENGTHS.get(self._next.text, 0) > strength:
            sign = self._take()
            left = Binary(sign, left, self._binary(STRENGTHS[sign.text]))
        return left

    def _unary(self) -> Expression:
        sign = self._takes("-", "!", "~", "+")
        if not sign:
            return self._postfix()
        if sign.text in ("~", "+"):
            raise sign.error(f"the translator does not know {sign} before an operand")
        return Unary(sign, self._unary())

    def _postfix(self) -> Expression:
        found = self._primary()
        while at := self._takes(".", "["):
            if at.text == ".":
                found = Member(self._word("a member"), found)
            else:
                found = Index(at, found, self._expression())
                self._expect("]")
        return found

    def _primary(self) -> Expression:
        token = self._take()
        if token.kind == "number":
            return Number(token)
        if token.text in ("true", "false"):
            return Truth(token)
        if token.text == "(":
            inside = self._expression()
            self._expect(")")
            return Parentheses(token, inside)
        if token.kind != "word":
            raise token.error(f"{token} stands where an expression is expected")
        if self._next.text != "(":
            if token.text in self.types:
                raise token.error(f"{token} is a type, and stands where an expression is expected")
            return Name(token)
        self._take()
        arguments: list[Expression] = []
        while not self._takes(")"):
            if arguments:
                self._expect(",")
            arguments.append(self._expression())
        return Call(token, tuple(arguments))
