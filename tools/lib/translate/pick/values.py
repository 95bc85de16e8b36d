"""Values of a function that is partly evaluated: trees whose leaves are numbers, parameters and variables.

Known integers and conditions are computed at once, as in GLSL, and so are exact operations on floats. All else
of floats stays as it is written, since another order of operations could round otherwise.
"""

from __future__ import annotations

import functools
import itertools
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Union

SIZES = {"float": 1, "int": 1, "uint": 1, "bool": 1, "vec2": 2, "vec3": 3, "vec4": 4,
         "ivec2": 2, "ivec3": 3, "ivec4": 4, "uvec2": 2, "uvec3": 3, "uvec4": 4}
PREFIXES = {"float": "", "int": "i", "uint": "u"}  # of vectors
AXES = ("x", "y", "z", "w")
WORD = 0xFFFFFFFF


def scalar_of(type_: str) -> str:
    if "vec" not in type_:  # a scalar, or a struct
        return type_
    return {"i": "int", "u": "uint"}.get(type_[0], "float")


def vector_of(scalar: str, size: int) -> str:
    return scalar if size == 1 else f"{PREFIXES[scalar]}vec{size}"


@dataclass(frozen=True)
class Constant:
    """An int, a uint or a bool that is known, or a float as it is written."""
    type: str
    value: int | str
    written: str = field(default="", compare=False)  # as the library has it


@dataclass(eq=False)
class Variable:
    """A parameter, or a variable that a branch or a loop changes."""
    type: str
    name: str               # as it is written, or like which it is to be called
    is_parameter: bool = False


@dataclass(eq=False)
class Operation:
    """An operator, a constructor, a function of the language or one of the module. Equal ones are one object."""
    kind: str  # unary, binary, choice, member, construct, builtin, call or copy
    name: str  # the operator, the member, the type or the function
    type: str
    arguments: tuple[Node, ...]
    number: int  # of operations, in the order in which they are made: arguments come first


Node = Union[Constant, Variable, Operation]
_made: dict[tuple[object, ...], Operation] = {}
_numbers = itertools.count()


def begin_anew() -> None:
    """Forgets all operations. Statements stand in the order of their numbers, so a text would otherwise depend on what
    else its process has written before: an operation that some function had made would have its number."""
    _made.clear()


def operation(kind: str, name: str, type_: str, arguments: tuple[Node, ...]) -> Operation:
    key = (kind, name, type_, *arguments)
    if key not in _made:
        _made[key] = Operation(kind, name, type_, arguments, next(_numbers))
    return _made[key]


def is_number(node: Node, value: int) -> bool:
    return isinstance(node, Constant) and node.type in ("int", "uint") and node.value == value


def _wrapped(type_: str, value: int) -> Constant:
    value &= WORD
    return Constant(type_, value - (1 << 32) if type_ == "int" and value >> 31 else value)


def _divided(a: int, b: int) -> int:
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


WHOLE: dict[str, Callable[[int, int], int]] = {
    "+": int.__add__, "-": int.__sub__, "*": int.__mul__, "&": int.__and__, "|": int.__or__, "^": int.__xor__,
    "<<": lambda a, b: a << (b & 31), ">>": lambda a, b: a >> (b & 31)}
COMPARED: dict[str, Callable[[int, int], bool]] = {
    "==": int.__eq__, "!=": int.__ne__, "<": int.__lt__, ">": int.__gt__, "<=": int.__le__, ">=": int.__ge__}
SHIFTS = ("<<", ">>")
NEUTRAL = {"+": 0, "-": 0, "|": 0, "^": 0, "<<": 0, ">>": 0, "*": 1, "/": 1}  # as the right operand


@functools.lru_cache(maxsize=None)
def result_type(sign: str, left: str, right: str) -> str | None:
    """The type of an operator's result between these types; None if the library needs none."""
    if left not in SIZES or right not in SIZES:
        return None
    one, other = scalar_of(left), scalar_of(right)
    if sign in ("&&", "||"):
        return "bool" if one == other == "bool" else None
    if sign in COMPARED:
        return "bool" if left == right and SIZES[left] == 1 and (one != "bool" or sign in ("==", "!=")) else None
    if sign in SHIFTS:
        return left if one in PREFIXES and one != "float" and right in ("int", "uint") else None
    if one != other or one not in PREFIXES or (one == "float" and sign in "&|^%") or (
            left != right and 1 not in (SIZES[left], SIZES[right])):
        return None
    return left if SIZES[left] >= SIZES[right] else right


NOTHING = Constant("float", "0.0f")
FLOATS: dict[str, Callable[[Fraction, Fraction], Fraction]] = {
    "+": Fraction.__add__, "-": Fraction.__sub__, "*": Fraction.__mul__, "/": Fraction.__truediv__}


def hides(sign: str, left: Node) -> bool:
    """Whether an operation that does nothing stays. An exclusive or hides the number from FXC, and an or keeps
    the conversions of an integer apart for vkd3d (detail/word.glsl)."""
    return sign == "|" or sign == "^" and isinstance(left, Operation) and left.name == "floatBitsToUint"


def exact(value: Fraction) -> Constant | None:
    """The constant of a float, if it is one and a short decimal writes it."""
    try:
        is_float = Fraction(struct.unpack("f", struct.pack("f", float(value)))[0]) == value
    except OverflowError:
        return None
    text = repr(float(value))
    return Constant("float", f"{text}f") if is_float and len(text) < 14 and "e" not in text else None


def _number(constant: Constant) -> Fraction:
    return Fraction(str(constant.value).rstrip("fF"))


def _folded(sign: str, left: Constant, right: Constant) -> Constant | None:
    one, other = map(_number, (left, right))
    if sign not in FLOATS or sign == "/" and not other or exact(one) is None or exact(other) is None:
        return None
    value = FLOATS[sign](one, other)
    if not value:  # 0 has a sign: here +0's, unless a 0 or a minus makes another
        return NOTHING if one and sign in "+-" or sign in "*/" and "-" not in left.value + right.value else None
    return exact(value)


def unary(sign: str, operand: Node) -> Node:
    if isinstance(operand, Constant):
        if operand.type == "float" and sign == "-" and not operand.value.startswith("-"):
            return Constant("float", f"-{operand.value}")
        if sign == "!":
            return Constant("bool", int(not operand.value))
        if operand.type in ("int", "uint"):
            return _wrapped(operand.type, -operand.value if sign == "-" else ~operand.value)
    return operation("unary", sign, operand.type, (operand,))


def binary(sign: str, left: Node, right: Node) -> Node:
    if sign in ("&&", "||"):
        for one, other in ((left, right), (right, left)):
            if isinstance(one, Constant):
                return other if bool(one.value) == (sign == "&&") else one
        return operation("binary", sign, "bool", (left, right))
    known = isinstance(left, Constant) and isinstance(right, Constant)
    if known and left.type == right.type == "float":
        if sign not in COMPARED and (folded := _folded(sign, left, right)):
            return folded
        known = False
    if sign in COMPARED:
        if known:
            return Constant("bool", int(COMPARED[sign](left.value, right.value)))
        return operation("binary", sign, "bool", (left, right))
    whole = scalar_of(left.type) != "float"
    if whole and known:
        if sign in WHOLE:
            return _wrapped(left.type, WHOLE[sign](left.value, right.value))
        if right.value:
            quotient = _divided(left.value, right.value)
            return _wrapped(left.type, quotient if sign == "/" else left.value - quotient * right.value)
    if sign == "-" and left is right and left.type in ("float", "int", "uint"):  # the computed number is finite
        return NOTHING if left.type == "float" else Constant(left.type, 0)
    if left.type == right.type == "uint" and sign == "-" and less_the_same(left, right):
        left, right = left.arguments[0], right.arguments[0]
    if whole and sign == "-" and isinstance(left, Operation) and left.kind == "binary" and left.name == "+" and (
            left.arguments[0] is right):
        return left.arguments[1]
    if not whole and sign in "+-" and isinstance(right, Constant) and right.value.startswith("-"):
        sign, right = "-+"[sign == "-"], Constant(right.type, right.value[1:])  # the same bits
    type_ = result_type(sign, left.type, right.type)
    if whole:
        if sign in NEUTRAL and is_number(right, NEUTRAL[sign]) and left.type == type_ and not hides(sign, left):
            return left
        if sign in "+|^" and is_number(left, 0) or sign == "*" and is_number(left, 1):
            if right.type == type_:
                return right
        for one, other in ((left, right), (right, left)):
            if sign == "&" and is_number(other, WORD if other.type == "uint" else -1) and one.type == type_:
                return one
        if sign in "&*" and (is_number(left, 0) or is_number(right, 0)) and SIZES[type_] == 1:
            return Constant(type_, 0)
    elif sign in "*/" and isinstance(right, Constant) and right.value.rstrip("fF") == "1.0":
        return left
    return operation("binary", sign, type_, (left, right))


def less_the_same(left: Node, right: Node) -> bool:
    """Whether both are differences from one constant."""
    return all(isinstance(one, Operation) and one.kind == "binary" and one.name == "-" for one in (left, right)) and (
        isinstance(left.arguments[1], Constant) and left.arguments[1] == right.arguments[1])


def builtin(name: str, type_: str, arguments: tuple[Node, ...]) -> Node:
    if name in ("min", "max") and all(isinstance(argument, Constant) for argument in arguments):
        return (min if name == "min" else max)(arguments, key=_number)
    first = arguments[0]
    if name == "floatBitsToUint" and isinstance(first, Constant) and exact(_number(first)):
        word, = struct.unpack("I", struct.pack("f", float(first.value.rstrip("fF"))))
        return Constant("uint", word, f"0x{word:X}u")
    return operation("builtin", name, type_, arguments)


def choice(condition: Node, yes: Node, no: Node) -> Node:
    if isinstance(condition, Constant):
        return yes if condition.value else no
    # x == 0 ? 0 : x is x.
    if isinstance(condition, Operation) and condition.name == "==" and scalar_of(yes.type) != "float" and (
            condition.arguments in ((yes, no), (no, yes))):
        return no
    return yes if yes is no else operation("choice", "?", yes.type, (condition, yes, no))


def member(of: Node, axis: str) -> Node:
    """A component of a vector; that which it was made of, where this is known."""
    if isinstance(of, Operation) and of.kind == "construct":
        at = AXES.index(axis)
        scalar = scalar_of(of.type)
        if len(of.arguments) == 1 and SIZES[of.arguments[0].type] == 1:
            return converted(scalar, of.arguments[0])
        inside = of.arguments[0]
        is_made = isinstance(inside, Operation) and inside.kind == "construct" and len(inside.arguments) > 1
        if len(of.arguments) == 1 and is_made:
            return converted(scalar, member(of.arguments[0], axis))
        if all(SIZES[argument.type] == 1 for argument in of.arguments):
            return converted(scalar, of.arguments[at])
        for argument in of.arguments:
            if at < SIZES[argument.type] and scalar_of(argument.type) == scalar and len(of.arguments) > 1:
                return member(argument, AXES[at]) if SIZES[argument.type] > 1 else argument
            at -= SIZES[argument.type]
    return operation("member", axis, scalar_of(of.type), (of,))


def _known(type_: str, constant: Constant) -> Constant | None:
    """A constant as another type, where that is one number in all languages. naga 22 refuses i32(1048576.0)."""
    number = _number(constant)
    if type_ == "float":
        return exact(number)
    least, bits = (-1 << 31, 31) if type_ == "int" else (0, 32)
    fits = constant.type != "float" or exact(number) and least <= int(number) < 1 << bits
    return _wrapped(type_, int(number)) if fits else None


def converted(type_: str, node: Node) -> Node:
    """A scalar as another type."""
    if node.type == type_:
        return node
    if isinstance(node, Constant) and type_ != "bool" and (known := _known(type_, node)):
        return known
    if (isinstance(node, Operation) and node.kind == "construct" and {node.type, type_} == {"int", "uint"}
            and node.arguments[0].type == type_):
        return node.arguments[0]  # there and back: the bits stay
    return operation("construct", type_, type_, (node,))


def construct(type_: str, arguments: tuple[Node, ...]) -> Node:
    if SIZES[type_] == 1:
        return converted(type_, arguments[0])
    if len(arguments) == 1 and arguments[0].type == type_:
        return arguments[0]
    # vec2(v.x, v.y) is v.
    first = arguments[0]
    if (len(arguments) == SIZES[type_] and isinstance(first, Operation) and first.kind == "member"
            and first.arguments[0].type == type_
            and all(argument is operation("member", axis, first.type, first.arguments)
                    for argument, axis in zip(arguments, AXES))):
        return first.arguments[0]
    return operation("construct", type_, type_, arguments)


def with_member(of: Node, axis: str, value: Node) -> Node:
    """The vector with another component."""
    return construct(of.type, tuple(value if other == axis else member(of, other) for other in AXES[:SIZES[of.type]]))
