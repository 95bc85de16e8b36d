"""Between which numbers a value is: for a language whose integers are longer than the library's.

A span is the least and the greatest number. A word may be any number that is the same modulo 2^32 until its size
counts, so a span of words may reach beyond 32 bits. A float without a span may be no number.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable

from translate.pick.values import WORD, Constant, Node, Operation, scalar_of

Span = tuple[float, float]
INT: Span = (-1 << 31, (1 << 31) - 1)
UINT: Span = (0, WORD)
LONG: Span = (-1 << 63, (1 << 63) - 1)
OF_TYPES: dict[str, Span] = {"int": INT, "uint": UINT, "bool": (0, 1)}
ARITHMETIC = {"+": operator.add, "-": operator.sub, "*": operator.mul}
EXACT: Span = (-1 << 24, 1 << 24)  # whole numbers that are floats


def is_within(span: Span | None, other: Span) -> bool:
    return span is not None and other[0] <= span[0] and span[1] <= other[1]


def _ends(sign: str, left: Span, right: Span) -> Span:
    """The span of a sum, a difference or a product."""
    ends = [ARITHMETIC[sign](a, b) for a in left for b in right]
    return min(ends), max(ends)


def _long(span: Span) -> Span:
    """A number beyond 64 bits wraps around."""
    return span if is_within(span, LONG) else LONG


def _of_bits(sign: str, left: Span, right: Span) -> Span:
    above = [one for one in (left, right) if one[0] >= 0]
    if sign == "&" and above:
        return 0, min(high for _, high in above)
    bits = max(max(int(high), -int(low) - 1).bit_length() for low, high in (left, right))
    return -(1 << bits) if len(above) < 2 else 0, (1 << bits) - 1


def of_integers(sign: str, left: Span, right: Span) -> Span:
    """The span of an operator's result in 64 bits."""
    if sign in ARITHMETIC:
        return _long(_ends(sign, left, right))
    if sign in "&|^":
        return _of_bits(sign, left, right)
    least, most = int(right[0]), int(right[1])
    if sign == "<<":
        return _long((min(int(left[0]) << most, 0), int(left[1]) << most))
    if sign == ">>":
        return min(int(left[0]) >> least, int(left[0]) >> most), max(int(left[1]) >> least, int(left[1]) >> most)
    size = max(abs(left[0]), abs(left[1]))  # of a quotient or a rest
    return -size if left[0] < 0 or right[0] < 0 else 0, size


class Spans:
    """The spans of numbers as they are printed. `is_named` is whether a value has a name: a word that has one is held
    in 32 bits."""

    def __init__(self, is_named: Callable[[Operation], bool]):
        self._is_named = is_named
        self._known: dict[Node, Span | None] = {}

    def of(self, node: Node) -> Span | None:
        if isinstance(node, Constant):
            value = float(str(node.value).rstrip("fF")) if node.type == "float" else int(node.value)
            return value, value
        if not isinstance(node, Operation):
            return OF_TYPES.get(node.type)
        if node not in self._known:
            found = self._of(node)
            if found and node.type == "int" and not is_within(found, INT):  # the library's stay inside
                found = max(found[0], INT[0]), min(found[1], INT[1])
            self._known[node] = found
        found = self._known[node]
        return UINT if node.type == "uint" and self._is_named(node) and not is_within(found, UINT) else found

    def held(self, node: Node) -> Span | None:
        """The span in 32 bits."""
        span = self.of(node)
        return span if scalar_of(node.type) != "uint" or is_within(span, UINT) else UINT

    def _of(self, node: Operation) -> Span | None:
        whole = OF_TYPES.get(node.type)
        if node.type == "bool" or node.kind in ("call", "struct", "results"):
            return whole
        if node.kind == "member":
            return INT if whole else None  # a vector has integers with a sign
        if node.kind == "copy":
            return self.of(node.arguments[0])
        spans = [self.of(one) for one in node.arguments]
        if node.kind == "choice":
            return _joined(spans[1], spans[2])
        if node.kind == "unary" and spans[0]:
            low, high = spans[0]
            return (-high, -low) if node.name == "-" else (-high - 1, -low - 1)
        if node.kind == "construct" and len(spans) == 1 and node.type in ("int", "uint", "float"):
            return self._converted(node, spans[0])
        if node.kind == "binary" and whole and None not in spans:
            left, right = (self.held(one) if node.name in ("/", "%", ">>") else self.of(one) for one in node.arguments)
            if node.name == "<<" and node.type == "uint" and left[0] < 0:
                left = UINT
            return of_integers(node.name, left, right)
        if node.kind == "binary" and node.type == "float":
            return self._of_floats(node, *spans)
        if node.kind == "builtin" and node.name in ("min", "max"):
            return self._of_ends(node)
        return whole

    def _converted(self, node: Operation, span: Span | None) -> Span | None:
        of = node.arguments[0].type
        if node.type == "float":
            return self.held(node.arguments[0])
        if of == "float":
            whole = OF_TYPES[node.type]
            return (math.trunc(span[0]), math.trunc(span[1])) if fits(span, node.type) else whole
        return span if node.type == "uint" or is_within(span, INT) else INT

    def _of_floats(self, node: Operation, left: Span | None, right: Span | None) -> Span | None:
        first, second = node.arguments
        if node.name == "-" and isinstance(second, Operation) and second.name == "trunc" and second.arguments[0] is first:
            return (-1, 1) if left and math.isfinite(left[0] + left[1]) else None
        if not left or not right or node.name == "/" or not all(map(math.isfinite, (*left, *right))):
            return None
        return _ends(node.name, left, right)

    def _of_ends(self, node: Operation) -> Span | None:
        """min(a, b) is b where b < a, else a: the first one if the second is no number."""
        first, second = map(self.held, node.arguments)
        if not first:
            return None
        low, high = second or (-math.inf, math.inf)
        if node.name == "min":
            return min(first[0], low), min(first[1], high) if second else first[1]
        return max(first[0], low) if second else first[0], max(first[1], high)


def _joined(one: Span | None, other: Span | None) -> Span | None:
    return (min(one[0], other[0]), max(one[1], other[1])) if one and other else None


def fits(span: Span | None, type_: str) -> bool:
    """Whether a float of that span is cut off to an integer of the type as it is; the greatest float below 2^31 is
    2^31 - 128."""
    low, high = OF_TYPES[type_]
    return is_within(span, (low, high - 255))
