"""Functions of the library as circuits of whole numbers, each with the range that it is known to have.

The library is read as GLSL 1.30 has it, without bits of floats. With HN_FIXED its floats are exact: a float is a whole
number and an exponent here, and costs nothing that integers do not. Loops are unrolled, and both sides of a branch are
computed. A product is one of at most 18 by 18 bits, the size of a multiplier, or a sum of such.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from translate.library import Library
from translate.parsing import syntax
from translate.parsing.syntax import Function
from translate.parsing.tokens import Unknown
from translate.pick.evaluate import Evaluation, Module, Specialization
from translate.pick.statements import Environment, Statement
from translate.pick.typer import Typed
from translate.pick.values import WORD, Constant, Node, Operation, Variable, choice

WIDEST = 18           # a factor of a multiplier
SMALL = 32            # below that products by constants are sums
WIRING = ("shl", "shr", "low")
MOST_LEAVES = 8       # of a choice between constants that a product is taken into
LARGEST_FLOAT = 28    # bits of a whole number that becomes a float: ranges are known to a few bits
ROUNDS = "{} has no value in whole numbers with HN_FIXED: {}. Ask for a noise, such as hn_perlin2"


def width(low: int, high: int) -> int:
    """How many bits a number in that range has, with its sign."""
    return max(high.bit_length(), (-1 - low).bit_length() if low < 0 else 0, low >= 0) + (low < 0)


class Gate:
    """A whole number in [low, high]. Circuit.gate returns the same one for the same arguments."""
    __slots__ = ("kind", "arguments", "by", "low", "high", "number", "name")

    def __init__(self, kind: str, arguments: tuple[Gate, ...], by: object, low: int, high: int, number: int):
        self.kind, self.arguments, self.by = kind, arguments, by
        self.low, self.high, self.number = low, high, number
        self.name = ""

    @property
    def is_signed(self) -> bool:
        return self.low < 0

    @property
    def width(self) -> int:
        return width(self.low, self.high)

    @property
    def value(self) -> int | None:
        return self.by if self.kind == "constant" else None


class Number(NamedTuple):
    """whole * 2^-places. An integer and a bool have no places."""
    whole: Gate
    places: int = 0


class Circuit:
    """Makes gates."""

    def __init__(self) -> None:
        self._made: dict[tuple[object, ...], Gate] = {}

    def gate(self, kind: str, arguments: Sequence[Gate], low: int, high: int, by: object = 0) -> Gate:
        key = (kind, by, low, high, *(one.number for one in arguments))
        if key not in self._made:
            self._made[key] = Gate(kind, tuple(arguments), by, low, high, len(self._made))
        return self._made[key]

    def constant(self, value: int) -> Gate:
        return self.gate("constant", (), value, value, value)

    def input(self, name: str, low: int, high: int) -> Gate:
        made = self.gate("input", (), low, high, name)
        made.name = name
        return made

    # Wires.

    def shifted(self, a: Gate, by: int) -> Gate:
        """a * 2^by, rounded down."""
        if by == 0 or a.value == 0:
            return a
        if a.value is not None:
            return self.constant(a.value << by if by > 0 else a.value >> -by)
        if a.kind == "shl" and (by > 0 or a.by >= -by):
            return self.shifted(a.arguments[0], a.by + by)
        if by > 0:
            return self.gate("shl", (a,), a.low << by, a.high << by, by)
        low, high = a.low >> -by, a.high >> -by
        return self.gate("shr", (a,), low, high, -by)

    def within(self, a: Gate, low: int, high: int) -> Gate:
        """The number of that range with the lowest bits of a."""
        if low <= a.low and a.high <= high:
            return a
        bits = width(low, high)
        if a.value is not None:
            value = a.value & ((1 << bits) - 1)
            return self.constant(value - (1 << bits) if low < 0 and value >> (bits - 1) else value)
        return self.gate("low", (a,), low, high)

    def word(self, a: Gate, is_signed: bool = False, bits: int = 32) -> Gate:
        half = 1 << (bits - 1)
        return self.within(a, -half, half - 1) if is_signed else self.within(a, 0, 2 * half - 1)

    def bit(self, a: Gate, at: int) -> Gate:
        return self.word(self.shifted(a, -at), bits=1)

    # Sums and products.

    def plus(self, a: Gate, b: Gate) -> Gate:
        if a.value is not None:
            a, b = b, a
        if a.value is not None:
            return self.constant(a.value + b.value)
        if b.value == 0:
            return a
        # Constants stand last: a number added for a float and subtracted again is gone.
        for one, other in ((a, b), (b, a)):
            if one.kind == "plus" and one.arguments[1].value is not None:
                return self.plus(self.plus(one.arguments[0], other) if other.value is None else one.arguments[0],
                                 one.arguments[1] if other.value is None else self.plus(one.arguments[1], other))
        if b.value is not None and (pushed := self.pushed(a, lambda leaf: self.plus(leaf, b))):
            return pushed
        return self.gate("plus", (a, b), a.low + b.low, a.high + b.high)

    def minus(self, a: Gate, b: Gate) -> Gate:
        if b.value is not None:
            return self.plus(a, self.constant(-b.value))
        if a.value is not None and (pushed := self.pushed(b, lambda leaf: self.minus(a, leaf))):
            return pushed
        if a.kind == "plus" and a.arguments[1].value is not None:
            return self.plus(self.minus(a.arguments[0], b), a.arguments[1])
        return self.gate("minus", (a, b), a.low - b.high, a.high - b.low)

    def leaves(self, a: Gate) -> int:
        """The number of leaves of a choice between constants; a large number if it has others."""
        if a.value is not None:
            return 1
        return sum(map(self.leaves, a.arguments[1:])) if a.kind == "choice" else MOST_LEAVES + 1

    def pushed(self, a: Gate, of: Callable[[Gate], Gate]) -> Gate | None:
        """The function of a choice between few constants, as a choice."""
        if a.kind != "choice" or self.leaves(a) > MOST_LEAVES:
            return None
        condition, yes, no = a.arguments
        return self.choice(condition, *(of(leaf) if leaf.value is not None else self.pushed(leaf, of)
                                        for leaf in (yes, no)))

    def times(self, a: Gate, b: Gate) -> Gate:
        if a.value is not None:
            a, b = b, a
        if a.value is not None:
            return self.constant(a.value * b.value)
        if b.value == 0:
            return b
        for one, other in ((a, b), (b, a)):
            if pushed := self.pushed(one, lambda leaf, by=other: self.times(by, leaf)):
                return pushed
        if b.value is not None:
            zeros = (b.value & -b.value).bit_length() - 1
            odd = self.constant(b.value >> zeros)
            if abs(odd.value) < SMALL:
                return self.shifted(self.sum_of_shifts(a, odd.value), zeros)
            if zeros:
                return self.shifted(self.times(a, odd), zeros)
        return self.product(a, b)

    def product(self, a: Gate, b: Gate) -> Gate:
        ends = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
        return self.gate("times", (a, b), min(ends), max(ends))

    def by_multipliers(self, a: Gate, b: Gate) -> Gate:
        """A product as a sum of some that a multiplier computes."""
        room = WIDEST - (a.is_signed or b.is_signed)
        for one, other in ((a, b), (b, a)):
            if one.width > (WIDEST if one.is_signed else room):
                low = self.by_multipliers(self.word(one, bits=room), other)
                return self.plus(self.shifted(self.by_multipliers(self.shifted(one, -room), other), room), low)
        return self.product(a, b)

    def by_sums(self, a: Gate, b: Gate) -> Gate:
        """The product without multipliers."""
        if b.value is not None:
            return self.sum_of_shifts(a, b.value)
        a, b = (a, b) if a.width >= b.width else (b, a)
        rows = [self.shifted(self.choice(self.bit(b, at), a, self.constant(0)), at) for at in range(b.width)]
        return self._sum([(row, -1 if b.is_signed and row is rows[-1] else 1) for row in rows])

    def sum_of_shifts(self, a: Gate, by: int) -> Gate:
        """a * by as few sums and differences: one for each digit 1 or -1 of `by`, where no two of them are neighbours."""
        terms: list[tuple[Gate, int]] = []
        at, rest = 0, by
        while rest:
            if rest & 1:
                digit = 2 - (rest & 3)
                terms.append((self.shifted(a, at), digit))
                rest -= digit
            rest >>= 1
            at += 1
        return self._sum(terms)

    def _sum(self, terms: list[tuple[Gate, int]]) -> Gate:
        """The sum of gates with signs, in a tree."""
        while len(terms) > 1:
            pairs = zip(terms[::2], terms[1::2])
            odd = terms[-1:] if len(terms) % 2 else []
            terms = [self._signed_sum(*one, *other) for one, other in pairs] + odd
        (made, sign), = terms
        return made if sign > 0 else self.minus(self.constant(0), made)

    def _signed_sum(self, a: Gate, of_a: int, b: Gate, of_b: int) -> tuple[Gate, int]:
        if of_a == of_b:
            return self.plus(a, b), of_a
        return (self.minus(a, b) if of_a > 0 else self.minus(b, a)), 1

    def quotient(self, a: Gate, by: int, scale: int = 0) -> Gate:
        """a * 2^scale / by, rounded down, for a >= 0: a product by a reciprocal that is long enough for all of them."""
        for places in range(1, 128):
            reciprocal = -(-(1 << (places + scale)) // by)
            if a.high * (reciprocal * by - (1 << (places + scale))) < 1 << places:
                return self.within(self.shifted(self.times(a, self.constant(reciprocal)), -places), 0,
                                   (a.high << scale) // by)
        raise AssertionError

    # Bits, comparisons and choices.

    def bits(self, kind: str, a: Gate, b: Gate) -> Gate:
        if a.value is not None:
            a, b = b, a
        if a.value is not None:
            return self.constant({"and": int.__and__, "or": int.__or__, "xor": int.__xor__}[kind](a.value, b.value))
        if b.value == 0:
            return b if kind == "and" else a
        if kind == "and" and b.value is not None and b.value > 0:
            zeros = (b.value & -b.value).bit_length() - 1
            run = b.value >> zeros
            if run & (run + 1) == 0:
                return self.shifted(self.word(self.shifted(a, -zeros), bits=run.bit_length()), zeros)
        if kind == "and" and not (a.is_signed and b.is_signed):
            return self.gate(kind, (a, b), 0, min(one.high for one in (a, b) if not one.is_signed))
        is_signed = a.is_signed or b.is_signed
        bits = max(one.width + (is_signed and not one.is_signed) for one in (a, b))
        return self.gate(kind, (a, b), -(1 << (bits - 1)) if is_signed else 0, (1 << (bits - is_signed)) - 1)

    def negated(self, a: Gate) -> Gate:
        if a.value is not None:
            return self.constant(1 - a.value)
        return self.gate("not", (a,), 0, 1)

    def less(self, a: Gate, b: Gate) -> Gate:
        if a.high < b.low or a.low >= b.high:
            return self.constant(int(a.high < b.low))
        if b.value == 0:
            return self.bit(a, a.width - 1)
        return self.gate("less", (a, b), 0, 1)

    def equal(self, a: Gate, b: Gate) -> Gate:
        if a.value is not None:
            a, b = b, a
        if a is b or a.high < b.low or b.high < a.low:
            return self.constant(int(a is b))
        if b.value == 0 and a.kind == "shl":
            return self.equal(a.arguments[0], b)
        if (a.low, a.high) == (0, 1) and b.value is not None:
            return a if b.value else self.negated(a)
        return self.gate("equal", (a, b), 0, 1)

    def choice(self, condition: Gate, yes: Gate, no: Gate) -> Gate:
        if condition.value is not None:
            return yes if condition.value else no
        if condition.kind == "not":
            return self.choice(condition.arguments[0], no, yes)
        return self.gate("choice", (condition, yes, no), min(yes.low, no.low), max(yes.high, no.high))

    def size(self, a: Gate) -> Gate:
        if a.value is not None:
            return self.constant(abs(a.value))
        if pushed := self.pushed(a, self.size):
            return pushed
        made = self.choice(self.less(a, self.constant(0)), self.minus(self.constant(0), a), a)
        return self.within(made, 0, max(-a.low, a.high)) if a.is_signed else a

    def root(self, a: Gate) -> Gate:
        """The root of a * 2^8, rounded down, digit by digit."""
        square = self.shifted(a, 8)
        rest = root = self.constant(0)
        for i in range((square.width + 1) // 2):
            digits = self.word(self.shifted(square, -2 * ((square.width + 1) // 2 - 1 - i)), bits=2)
            rest = self.plus(self.shifted(rest, 2), digits)
            trial = self.minus(rest, self.plus(self.shifted(root, 2), self.constant(1)))
            fits = self.negated(self.less(trial, self.constant(0)))
            root = self.plus(self.shifted(root, 1), fits)
            rest = self.within(self.choice(fits, trial, rest), 0, (2 << (i + 1)) - 2)
        return root


class Unrolled(Evaluation):
    """The gates of a function whose loops end at constants. Results of public functions are in the ranges of their
    comments."""

    def __init__(self, module: Module, ranges: Callable[[Function], Sequence[tuple[Fraction, Fraction]]]):
        super().__init__(module, lambda function, _: Specialization(function.name, function.types,
                                                                            (None,) * len(function.types))
                         if (function.name, function.types) in CALLED else None)
        self._ranges = ranges
        self.known: dict[Node, tuple[Fraction, Fraction]] = {}

    def _called(self, expression: syntax.Call, arguments: Sequence[Typed], frame: int, state: Environment,
                block: list[Statement]) -> Typed:
        found = super()._called(expression, arguments, frame, state, block)
        if found.type == "float" and not expression.at.text.startswith("hn_i_"):
            function = self.library.overload(expression.at.text, tuple(argument.type for argument in arguments))
            for range_ in self._ranges(function)[:1] if function else ():
                self.known[found.node] = range_
        return found

    def _branch(self, condition: Node, yes: Sequence[syntax.Statement], no: Sequence[syntax.Statement],
                rest: Sequence[syntax.Statement], frame: int, state: Environment, block: list[Statement]) -> bool:
        states = dict(state), dict(state)
        over = [self._statements((*of, *rest), frame, now, block) for of, now in zip((yes, no), states)]
        for key in dict.fromkeys((*states[0], *states[1])):
            values = [now.get(key) for now in states]
            if None not in values:
                state[key] = choice(condition, *values)
        return all(over)

    def _loop(self, loop: syntax.Loop | syntax.DoLoop, frame: int, state: Environment, block: list[Statement]) -> None:
        asks_behind = isinstance(loop, syntax.DoLoop)
        if not asks_behind and loop.start is not None:
            self._declare(loop.start, frame, state, block)
        while asks_behind or self._goes_on(loop, frame, state, block):
            if self._statements(loop.body.statements, frame, state, block):
                raise Unknown("a loop that a break or a return leaves is no circuit")
            if asks_behind and not self._goes_on(loop, frame, state, block):
                break
            if not asks_behind and loop.step is not None:
                self._assign(loop.step, frame, state, block)

    def _goes_on(self, loop: syntax.Loop | syntax.DoLoop, frame: int, state: Environment,
                 block: list[Statement]) -> bool:
        condition = self._of_type(loop.condition, "bool", frame, state, block).node
        if not isinstance(condition, Constant):
            raise Unknown("a loop has no constant end: give what it counts to as a constant, such as "
                          "--constants octaves=6")
        return bool(condition.value)


CALLED = {("hn_i_root", ("uint",)), ("hn_i_mean", ("int", "int"))}  # that a circuit computes in its own way


OPERATORS: dict[str, Callable[[Circuit, Gate, Gate], Gate]] = {
    "+": Circuit.plus, "-": Circuit.minus, "*": Circuit.times, "<": Circuit.less, "==": Circuit.equal,
    ">": lambda make, a, b: make.less(b, a), "<=": lambda make, a, b: make.negated(make.less(b, a)),
    ">=": lambda make, a, b: make.negated(make.less(a, b)), "!=": lambda make, a, b: make.negated(make.equal(a, b)),
    **{sign: lambda make, a, b, kind=kind: make.bits(kind, a, b) for sign, kind in (
        ("&", "and"), ("|", "or"), ("^", "xor"), ("&&", "and"), ("||", "or"))}}


class Lowering:
    """Makes gates of values. `known` are ranges of floats, `hints` are names."""

    def __init__(self, name: str, circuit: Circuit, inputs: Mapping[str, Gate],
                 known: Mapping[Node, tuple[Fraction, Fraction]], hints: Mapping[Node, str]):
        self.name, self.circuit, self.inputs, self.known, self.hints = name, circuit, inputs, known, hints
        self._done: dict[Node, Number] = {}

    def of(self, node: Node) -> Number:
        pending = [node]
        while pending:  # graphs are deeper than Python's stack
            one = pending[-1]
            needed = [argument for argument in one.arguments if argument not in self._done] if isinstance(
                one, Operation) else []
            pending += needed
            if not needed:
                pending.pop()
                if one not in self._done:
                    self._done[one] = self._named(one, self._made(one))
        return self._done[node]

    def _named(self, node: Node, made: Number) -> Number:
        if node in self.known:
            made = made._replace(whole=self.circuit.within(
                made.whole, *(int(end * (1 << made.places)) for end in self.known[node])))
        gate = made.whole
        while gate.kind == "low":
            gate = gate.arguments[0]
        gate.name = gate.name or self.hints.get(node, "")
        return made

    def refused(self, why: str) -> Unknown:
        return Unknown(ROUNDS.format(self.name, why))

    def _made(self, node: Node) -> Number:
        make = self.circuit
        if isinstance(node, Constant):
            return self._float(str(node.value).rstrip("fF")) if node.type == "float" else Number(
                make.constant(int(node.value)))
        if isinstance(node, Variable):
            return Number(self.inputs[node.name])
        arguments = [self._done[argument] for argument in node.arguments]
        a, b = arguments[0], arguments[-1]
        if node.kind == "call":
            return Number(make.root(a.whole) if node.name.name == "hn_i_root" else self._mean(a.whole, b.whole))
        if node.kind == "construct":
            return self._converted(node.type, a)
        if node.type == "float" and node.name == "*":
            return Number(make.times(a.whole, b.whole), a.places + b.places)
        if node.type == "float" and node.name == "/":
            if b.whole.value is None or b.whole.value & (b.whole.value - 1) or b.whole.value < 1:
                raise self.refused("it divides floats")
            return Number(a.whole, a.places - b.places + b.whole.value.bit_length() - 1)
        numbers = arguments[1:] if node.kind == "choice" else arguments
        places = max(one.places for one in numbers)
        aligned = [make.shifted(one.whole, places - one.places) for one in numbers]
        whole = make.choice(a.whole, *aligned) if node.kind == "choice" else self._whole(node, aligned[0], aligned[-1])
        if node.type in ("int", "uint"):
            whole = make.word(whole, node.type == "int")
        return Number(whole, places if node.type == "float" else 0)

    def _whole(self, node: Operation, a: Gate, b: Gate) -> Gate:
        make, name = self.circuit, node.name
        if node.kind == "unary":
            return {"-": lambda: make.minus(make.constant(0), a), "!": lambda: make.negated(a),
                    "~": lambda: make.bits("xor", a, make.constant(-1 if node.type == "int" else WORD))}[name]()
        if name in ("min", "max"):
            return self._extreme(name, a, b)
        if name == "abs":
            return make.size(a)
        if name in ("<<", ">>"):
            if b.value is None:
                raise self.refused("it shifts by a number that is not constant")
            return make.shifted(a, b.value if name == "<<" else -b.value)
        if name in ("/", "%"):
            if b.value is None or b.value <= 0 or a.is_signed:
                raise self.refused("it divides by a number that is not constant")
            quotient = make.quotient(a, b.value)
            return quotient if name == "/" else make.within(
                make.minus(a, make.times(quotient, b)), 0, b.value - 1)
        if name not in OPERATORS:
            raise self.refused(f"it takes the {name} of a float")
        return OPERATORS[name](make, a, b)

    def _extreme(self, name: str, a: Gate, b: Gate) -> Gate:
        if a.high <= b.low or b.high <= a.low:
            return a if (a.high <= b.low) == (name == "min") else b
        made = self.circuit.choice(self.circuit.less(b, a), *((b, a) if name == "min" else (a, b)))
        best = min if name == "min" else max
        return self.circuit.within(made, best(a.low, b.low), best(a.high, b.high))

    def _mean(self, sum_: Gate, total: Gate) -> Gate:
        """sum * 2^18 / total, cut off towards 0."""
        if total.value is None:
            raise self.refused("it divides by a number that is not constant")
        mean = self.circuit.quotient(self.circuit.size(sum_), total.value, 18)
        return self.circuit.choice(self.circuit.less(sum_, self.circuit.constant(0)),
                                   self.circuit.minus(self.circuit.constant(0), mean), mean)

    # Floats.

    def _float(self, text: str) -> Number:
        """A number as it is written, which a float rounds."""
        value = Fraction(struct.unpack("f", struct.pack("f", float(text)))[0])
        zeros = (value.numerator & -value.numerator).bit_length() - 1 if value else 0
        return Number(self.circuit.constant(value.numerator >> zeros), value.denominator.bit_length() - 1 - zeros)

    def _converted(self, type_: str, a: Number) -> Number:
        """An integer as a float, or as another one; and the whole part of a float."""
        make = self.circuit
        if type_ == "float":
            if a.whole.width > LARGEST_FLOAT:
                raise self.refused("a float would round what it computes")
            return a
        if a.places > 0 and a.whole.is_signed and not (a.whole.kind == "shl" and a.whole.by >= a.places):
            raise self.refused("it takes the whole part of a float that may be negative")
        return Number(make.word(make.shifted(a.whole, -a.places), type_ == "int"))


def at_place(module: Library, function: Function) -> Function:
    """At a place, where the function takes a position."""
    first = function.parameters[0].type if function.parameters else ""
    size = {"float": 1, "vec2": 2, "vec3": 3, "vec4": 4}.get(first)
    if function.parameters and function.parameters[0].at.text == "p" and size:
        return module.overload(function.name, (f"hn_place{size}", *function.types[1:])) or function
    return function
