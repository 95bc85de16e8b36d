"""The types of expressions, by which GLSL chooses among overloads, and their values. GLSL that the library does not
need is an error that names the place."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType, SimpleNamespace

from translate.library import Library
from translate.parsing import syntax
from translate.parsing.syntax import Expression
from translate.parsing.tokens import Token
from translate.pick.values import AXES, SHIFTS, SIZES, Constant, Node, result_type, scalar_of, vector_of

NUMBERS = ("float", "int", "uint")
# Functions of the language, by how many arguments, all of one type, which the result has, too.
BUILTINS = {"abs": (1, ("float", "int")), "floor": (1, ("float",)), "trunc": (1, ("float",)), "sqrt": (1, ("float",)),
            "min": (2, NUMBERS), "max": (2, NUMBERS)}
# Functions that reinterpret bits: from what, and to what.
CASTS = {"uintBitsToFloat": ("uint", "float"), "floatBitsToUint": ("float", "uint"),
         "intBitsToFloat": ("int", "float"), "floatBitsToInt": ("float", "int")}

Leaves = dict[tuple[str, ...], Node]  # of a value: a struct may have one for each part, by its path; others have one, at ()


@dataclass
class Typed:
    type: str
    leaves: Leaves

    @property
    def node(self) -> Node:
        return self.leaves[()]


def plain(node: Node) -> Typed:
    return Typed(node.type, {(): node})


class Typer:
    """`make` makes values of others: values.py, which computes known values, or a maker that leaves all as it is
    written. `scope` is where an expression stands, for those who know variables."""

    make: ModuleType | SimpleNamespace
    chosen: Collection[str] = SIZES  # types that ?: may have
    builtins: Mapping[str, tuple[int, tuple[str, ...]]] = BUILTINS

    def __init__(self, library: Library):
        self.library = library

    def _number(self, text: str) -> Constant:
        return number(text)

    def _name(self, at: Token, *scope: object) -> Typed:
        raise NotImplementedError

    def _called(self, call: syntax.Call, arguments: Sequence[Typed], *scope: object) -> Typed:
        """A library function's result."""
        raise NotImplementedError

    def _value(self, expression: Expression, *scope: object) -> Typed:
        kind = type(expression)
        if kind is syntax.Name:
            return self._name(expression.at, *scope)
        if kind is syntax.Call:
            return self._call(expression, *scope)
        if kind is syntax.Binary:
            return self._binary(expression.at, expression.at.text, self._value(expression.left, *scope),
                                self._value(expression.right, *scope))
        if kind is syntax.Member:
            return self._member(expression.at, self._value(expression.of, *scope))
        if kind is syntax.Number:
            try:
                return plain(self._number(expression.at.text))
            except ValueError as wrong:
                raise expression.at.error(str(wrong)) from None
        if kind is syntax.Parentheses:
            return self._value(expression.inside, *scope)
        if kind is syntax.Unary:
            return self._unary(expression.at, self._value(expression.operand, *scope))
        if kind is syntax.Index:
            return self._element(expression, *scope)
        if kind is syntax.Truth:
            return plain(Constant("bool", int(expression.at.text == "true")))
        return self._choice(expression.at, *(self._value(one, *scope) for one in (
            expression.condition, expression.yes, expression.no)))

    def _of_type(self, expression: Expression, type_: str, *scope: object) -> Typed:
        return self._checked(expression.at, self._value(expression, *scope), type_)

    @staticmethod
    def _checked(at: Token, value: Typed, type_: str) -> Typed:
        if value.type != type_:
            raise at.error(f"this is a {value.type} where a {type_} is expected")
        return value

    def _assigned(self, statement: syntax.Assign, target: Typed, *scope: object) -> Typed:
        at, sign = statement.at, statement.at.text
        if statement.value is None:
            if target.type != "int":
                raise at.error(f"{at} changes a {target.type} instead of an int")
            return self._binary(at, sign[0], target, plain(Constant("int", 1)))
        if sign == "=":
            return self._of_type(statement.value, target.type, *scope)
        value = self._binary(at, sign[:-1], target, self._value(statement.value, *scope))
        if value.type != target.type:
            raise at.error(f"{at} makes a {value.type} of a {target.type}")
        return value

    def _member(self, at: Token, of: Typed) -> Typed:
        if of.type in SIZES:
            if at.text not in AXES[:SIZES[of.type]] or SIZES[of.type] == 1:
                raise at.error(f".{at} of a {of.type}: the translator knows .x, .y, .z and .w")
            return self._component(of, at.text)
        struct = self.library.structs.get(of.type)
        for name, type_, _ in struct.fields if struct else ():
            if name == at.text:
                return self._field(of, name, type_)
        raise at.error(f"a {of.type} has no .{at}")

    def _component(self, of: Typed, axis: str) -> Typed:
        return plain(self.make.member(of.node, axis))

    def _field(self, of: Typed, name: str, type_: str) -> Typed:
        raise NotImplementedError

    def _element(self, expression: syntax.Index, *scope: object) -> Typed:
        raise expression.at.error("the translator does not know arrays")

    def _unary(self, at: Token, operand: Typed) -> Typed:
        kind = scalar_of(operand.type)
        if operand.type not in SIZES or kind not in (("bool",) if at.text == "!" else ("float", "int")):
            raise at.error(f"the translator does not know {at} of a {operand.type}")
        return self._each(functools.partial(self.make.unary, at.text), operand)

    def _binary(self, at: Token, sign: str, left: Typed, right: Typed) -> Typed:
        by_unknown = sign in SHIFTS and right.type == "int" and not isinstance(right.node, Constant)
        if result_type(sign, left.type, right.type) is None or by_unknown:
            raise at.error(f"the translator does not know {left.type} {sign} {right.type}")
        return self._each(functools.partial(self.make.binary, sign), left, right)

    def _choice(self, at: Token, condition: Typed, yes: Typed, no: Typed) -> Typed:
        self._checked(at, condition, "bool")
        if yes.type != no.type or yes.type not in self.chosen:
            raise at.error(f"the translator does not know ? of a {yes.type} and a {no.type}")
        return self._each(functools.partial(self.make.choice, condition.node), yes, no)

    def _call(self, call: syntax.Call, *scope: object) -> Typed:
        name = call.at.text
        arguments = [self._value(argument, *scope) for argument in call.arguments]
        types = tuple(argument.type for argument in arguments)
        if name in SIZES:
            return self._construct(call.at, arguments)
        if name in self.builtins or name in CASTS:
            count, kinds = self.builtins.get(name) or (1, CASTS[name][:1])
            if len(types) != count or len(set(types)) != 1 or types[0] not in SIZES or scalar_of(types[0]) not in kinds:
                raise call.at.error(f"the translator does not know {name}({', '.join(types)})")
            scalar = CASTS[name][1] if name in CASTS else scalar_of(types[0])
            return self._each(lambda *nodes: self.make.builtin(name, vector_of(scalar, SIZES[nodes[0].type]), nodes),
                              *arguments)
        if own := self.library.own.get((name, types)):
            return self._each(lambda *nodes: self.make.builtin(name, own.type, nodes), *arguments)
        return self._called(call, arguments, *scope)

    def _each(self, of: Callable[..., Node], *values: Typed) -> Typed:
        return plain(of(*(value.node for value in values)))

    def _construct(self, at: Token, arguments: Sequence[Typed]) -> Typed:
        """A conversion, a vector of components alike, or of the arguments' components."""
        size, sizes = SIZES[at.text], [SIZES.get(argument.type, 0) for argument in arguments]
        if 0 in sizes or (sum(sizes) != size and sizes != [1]):
            raise at.error(f"the translator does not know {at}({', '.join(one.type for one in arguments)})")
        return self._made(at.text, arguments)

    def _made(self, type_: str, arguments: Sequence[Typed]) -> Typed:
        return plain(self.make.construct(type_, tuple(argument.node for argument in arguments)))


@functools.lru_cache(maxsize=None)
def number(text: str) -> Constant:
    if text[-1] in "uU":
        return Constant("uint", _whole(text, text[:-1], 0xFFFFFFFF, "a uint"), f"{text[:-1]}u")
    if text[:2] not in ("0x", "0X") and (text[-1] in "fF" or re.search("[.eE]", text)):
        return Constant("float", text, text)
    return Constant("int", _whole(text, text, 0x7FFFFFFF, "an int"), text)


def _whole(text: str, digits: str, largest: int, what: str) -> int:
    value = int(digits, 0)
    if value > largest:
        raise ValueError(f"{text} does not fit {what}")
    return value
