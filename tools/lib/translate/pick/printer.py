"""Statements over values as text: a value used more than once gets a name, the rest stands in its place."""

from __future__ import annotations

import zlib
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from translate.names import PASSED
from translate.parsing.lines import wrapped
from translate.parsing.syntax import STRENGTHS, Function, Parameter
from translate.pick.comments import arguments_of
from translate.pick.evaluate import Module, Specialization
from translate.pick.statements import (
    Break,
    Declare,
    If,
    Loop,
    Return,
    Set,
    Statement,
    blocks,
    changed_in,
    inner,
    operands,
    reachable,
    values_of,
    walk,
    with_tests_inside,
)
from translate.pick.values import SIZES, Constant, Node, Operation, Variable, operation, scalar_of

WIDTH = 100  # of lines, as far as values have parts that can be named
# Names that no variable has: the languages' own, and what readers would take for something else.
RESERVED = frozenset("""abs floor trunc sqrt min max float int uint bool vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3
    uvec4 sample input output filter half fixed common partition active packed this resource patch centroid flat smooth
    mix sign step length distance normal dot cross float2 float3 float4 int2 int3 int4 uint2 uint3 uint4 asfloat asuint
    asint line point triangle linear texture matrix vector string double pass technique register shared static lerp frac
    """.split())
# How strongly operators bind.
STRENGTH = {**STRENGTHS}
# In languages whose comparisons are weaker than & and |.
STRENGTH_OF_PYTHON = {"||": 1, "&&": 2, "<": 3, ">": 3, "<=": 3, ">=": 3, "==": 3, "!=": 3, "|": 4, "^": 5, "&": 6,
                      "<<": 9, ">>": 9, "+": 10, "-": 10, "*": 11, "/": 11, "%": 11}
CHOICE, UNARY, PRIMARY = 0, 11, 12
BITS = ("|", "^", "&", "<<", ">>")  # readers want parentheses around and in these
TRUTH = ("&&", "||")
EXAMPLES = {"metric": "HN_METRIC_EUCLIDEAN", "kind": "HN_DISTRIBUTION_PERLIN2"}  # of what users pass
UNNAMED = {"floor": "whole", "abs": "size"}  # the name of a value that has no name in the library
Place = tuple[tuple[int, int], ...]  # of a statement: of each block around it the number, and the index in it


class Declaration(str):
    """The line of a declaration: what stands before the name, the name, and the text behind it."""
    before: str
    name: str
    behind: str

    def __new__(cls, before: str, name: str, behind: str) -> Declaration:
        made = super().__new__(cls, f"{before} {name}{behind}".lstrip())
        made.before, made.name, made.behind = before, name, behind
        return made


class Piece(NamedTuple):
    """An expression as text, how strongly it binds, and its operator if that stands between two operands."""
    text: str
    binds: float = PRIMARY
    sign: str = ""

    def within(self, strength: float) -> str:
        """In parentheses, unless it binds more strongly than that."""
        return self.text if self.binds > strength else f"({self.text})"


def guard(name: str, code: str) -> str:
    """The name of the include guard of a text. It belongs to this text alone, so it leaves out no other."""
    return f"{name.upper()}_{zlib.crc32(code.encode('ascii')):08X}_H"


class Notation:
    """How a language writes expressions and statements. These are the common parts of C's descendants."""
    strength: Mapping[str, float] = STRENGTH  # of operators
    end = ";"
    condition = "({})"          # as it stands in if and while
    while_, forever = "while", "while (true) {"
    names_choices = False       # whether both choices are computed before
    shortens = False            # whether a branch of one statement may stand on its line
    float_end, word_end = "", "u"  # of literals
    least_int = "(-2147483647 - 1)"
    bools = ("false", "true")
    index = ".{axis}"           # of a component
    joins = True                # whether declarations of one type may share a line
    breaks = " "                # where a long line may be broken
    no_precise = ""             # why it has no `precise`, and what to take
    library: Mapping[str, str] = {}  # macros with which the library is read
    # A struct and a field of it.
    struct_form, field_form = "struct {name} {{\n{fields}}};\n", "  {type} {name};\n"

    # Names.

    def variable(self, name: str) -> str:
        return name

    def field_name(self, name: str) -> str:
        return name

    def type_name(self, name: str) -> str:
        return name

    def type(self, type_: str) -> str:
        raise NotImplementedError

    def path(self, name: str) -> str:
        """A parameter, or a field of one."""
        first, *fields = name.split(".")
        return ".".join([self.variable(first), *map(self.field_name, fields)])

    # Expressions.

    def constant(self, constant: Constant) -> str:
        value = constant.value
        if constant.type == "bool":
            return self.bools[bool(value)]
        if constant.type == "float":
            return self.float(str(value).rstrip("fF"))
        return self.int(int(value)) if constant.type == "int" else self.uint(int(value))

    def float(self, text: str) -> str:
        return f"{text}{self.float_end}"

    def int(self, value: int) -> str:
        return self.least_int if value == -(1 << 31) else str(value)

    def uint(self, value: int) -> str:
        return f"{f'0x{value:X}' if value > 9999 else value}{self.word_end}"

    def stands_apart(self, inside: str, around: str) -> bool:
        """Whether an operation in another one is in parentheses for readers."""
        return inside != around and (around in BITS or (inside in BITS and around not in TRUTH))

    def infix(self, sign: str, left: Piece, right: Piece) -> Piece:
        strength = self.strength[sign]
        parts = [f"({piece.text})" if piece.binds < strength + i or piece.sign and self.stands_apart(piece.sign, sign)
                 else piece.text for i, piece in enumerate((left, right))]
        return Piece(f"{parts[0]} {sign} {parts[1]}", strength, sign)

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        """`type_` is the operands', or the left one's in shifts."""
        return self.infix(sign, left, right)

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        return Piece(f"{sign}{operand.within(UNARY)}", UNARY)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        return Piece(" ".join((condition.within(CHOICE), "?", yes.within(CHOICE), ":", no.within(CHOICE))), CHOICE)

    def member(self, of: Piece, axis: str) -> Piece:
        return Piece(of.within(UNARY) + self.index.format(axis=axis, number="xyzw".find(axis)))

    def component_of(self, of: Piece, axis: str, type_: str) -> Piece:
        """The component of an expression of that type."""
        return self.member(of, axis)

    def construct(self, type_: str, of: str, parts: Sequence[Piece]) -> Piece:
        """A number of another type, which is `of`, or a vector."""
        raise NotImplementedError

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        """A function of GLSL whose result has this type."""
        raise NotImplementedError

    def call(self, name: str, arguments: Sequence[Piece]) -> Piece:
        return Piece(f"{name}({', '.join(piece.text for piece in arguments)})")

    # Statements.

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        """The short form of an assignment, if there is one."""
        if sign in "+-" and by == "1":
            return f"{name}{sign * 2}"
        return f"{name} {sign}= {by}"

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["do {", *body, f"}} while ({condition.text});"]

    def struct(self, name: str, fields: Sequence[tuple]) -> str:
        """A field begins with its name and its type."""
        inside = "".join(self.field_form.format(name=self.field_name(field), type=self.type(type_))
                         for field, type_, *_ in fields)
        return self.struct_form.format(name=self.type_name(name), fields=inside)


@dataclass(frozen=True)
class Language(Notation):
    """A language with vectors: its text is that of GLSL, but for this."""
    opening: str = ""     # stands first
    float_end: str = ""
    qualifier: str = ""   # before each type
    scope: str = ""       # first in each function that makes floats of integers
    function: str = ""    # before each function
    out: str = "out {}"
    inout: str = "inout {}"
    passed: str = "{}"    # the arguments for these
    splats: bool = True   # whether operators take a vector and a number
    fills: bool = True    # whether constructors of vectors take one number
    structs: bool = True  # whether structs are defined
    joins: bool = True
    is_included: bool = False  # whether files include the text, and a shader may include two of them
    names_choices: bool = False
    no_precise: str = ""
    names: Mapping[str, str] = field(default_factory=dict)  # of types and functions, where they are not GLSL's
    library: Mapping[str, str] = field(default_factory=dict)
    has_overloads: ClassVar[bool] = True
    braces: ClassVar[bool] = False  # whether a branch of one statement has them, too
    shortens: ClassVar[bool] = True
    passed_constant: ClassVar[str] = "#define {} {}\n"

    def named(self, name: str) -> str:
        return self.names.get(name, name)

    def called(self, name: str, type_: str) -> str:
        """The name of a function of GLSL whose result has this type."""
        return self.named(name)

    def construct(self, type_: str, of: str, parts: Sequence[Piece]) -> Piece:
        return self.call(self.named(type_), parts)

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        return self.call(self.called(name, type_), arguments)

    def type(self, type_: str) -> str:
        return f"{self.qualifier if type_ in SIZES and type_ != 'bool' else ''}{self.named(type_)}"

    def public_name(self, function: Function) -> str:
        """The name by which users call it."""
        return function.name

    def signature(self, function: Function) -> str:
        """The signature in the comment of a function: the library's."""
        return f"{function.name}({', '.join(map(declared, function.parameters))})"

    def example(self, function: Function) -> str:
        """A call. uv is a position from 0 to 1, and what else is no number is a variable."""
        def number(value: float, type_: str) -> str:
            return f"{float(value)}{self.float_end}" if type_ == "float" else f"{value}{'u' * (type_ == 'uint')}"

        def vector(type_: str, parts: Sequence[str]) -> str:
            return parts[0] if SIZES[type_] == 1 else f"{self.named(type_)}({', '.join(parts)})"

        def argument(one: Parameter, numbers: Sequence[float] | None) -> str:
            scalar = scalar_of(one.type)
            if one.at.text in PASSED:
                return EXAMPLES[one.at.text]
            if numbers is not None:
                return vector(one.type, [number(value, scalar) for value in numbers])
            if one.at.text == "p" and one.type in SIZES:
                of_plane = f"uv{'.x' if one.type == 'float' else ''} * {number(8, scalar)}"
                slices = [number(value, scalar) for value in (0.5, 0.25)]
                return of_plane if SIZES[one.type] < 3 else vector(one.type, [of_plane, *slices[:SIZES[one.type] - 2]])
            return (self.passed if one.is_set else "{}").format(one.at.text)

        return f"{self.public_name(function)}({', '.join(arguments_of(function, argument))})"

    def seedless(self, function: Function) -> str:
        """The overload without the seed, for which it is 0."""
        *taken, _ = function.parameters
        passed = ", ".join([*(self.variable(one.at.text) for one in taken), "0u"])
        head = self.head(function.type, function.name, taken, set())
        return f"{head} return {function.name}({passed}); }}\n"

    def constants(self, functions: Sequence[Function], module: Module) -> str:
        """The constants that users pass to the functions, where no library beside the text has them."""
        known = constants_of(functions, module) if self.structs else []
        return "".join(self.passed_constant.format(*one) for one in known)

    def pair(self, name: str, type_: str) -> str:
        """A name with its type, as in parameters and fields."""
        return f"{type_} {name}"

    def parameter(self, one: Parameter, is_read: bool = False) -> str:
        """A parameter in a head. It may be both set and read."""
        form = (self.inout if is_read else self.out) if one.is_set else "{}"
        return self.pair(self.variable(one.at.text), form.format(self.type(one.type)))

    def prototype(self, type_: str, name: str, parameters: Iterable[str]) -> str:
        return f"{self.function}{self.type(type_)} {name}({', '.join(parameters)})"

    def head(self, type_: str, name: str, parameters: Iterable[Parameter], read: set[str]) -> str:
        return f"{self.prototype(type_, name, (self.parameter(one, one.at.text in read) for one in parameters))} {{"

    def writer(self, block: list[Statement], hints: Mapping[Node, str], parameters: Sequence[Parameter],
               names: Mapping[Specialization, str], precise: bool) -> Writer:
        return Writer(self, block, hints, [parameter.at.text for parameter in parameters], names, precise)


def constants_of(functions: Sequence[Function], module: Module) -> list[tuple[str, str]]:
    """The constants that users pass to functions, with their numbers."""
    taken = {parameter.at.text for function in functions for parameter in function.parameters}
    beginnings = tuple(PASSED[name] for name in PASSED if name in taken)
    return [(name, module.constant(name).at.text) for name in module.constants if name.startswith(beginnings)]


class Expressions:
    """Values as text."""

    def __init__(self, language: Notation, names: Mapping[Specialization, str]):
        self.language = language
        self.names = names  # of functions
        self.called: dict[Node, str] = {}  # the names of values and variables

    def _text(self, node: Node) -> str:
        return self._piece(node).text

    def _piece(self, node: Node) -> Piece:
        language = self.language
        if isinstance(node, Constant):
            text = self._constant(node)
            return Piece(text, UNARY if text.startswith("-") else PRIMARY)
        if node in self.called or isinstance(node, Variable):
            return self._named(node)
        if node.kind == "copy":
            return self._piece(node.arguments[0])
        pieces = [self._piece(argument) for argument in self._arguments(node)]
        of = node.arguments[0].type if node.arguments else ""
        if node.kind == "member":
            return language.component_of(pieces[0], node.name, of)
        if node.kind == "unary":
            return language.unary(node.name, of, pieces[0])
        if node.kind == "choice":
            return language.choice(*pieces, node.type)
        if node.kind == "binary":
            return language.binary(node.name, of, *pieces)
        if node.kind == "construct":
            return language.construct(node.type, of, pieces)
        if node.kind == "builtin":
            return language.builtin(node.name, node.type, pieces)
        return language.call(self.names.get(node.name, node.name), pieces)

    def _constant(self, constant: Constant) -> str:
        return self.language.constant(constant)

    def _named(self, node: Node) -> Piece:
        """A named value: a field's name is behind a point."""
        return Piece(self.language.path(self.called.get(node) or node.name))

    def _arguments(self, node: Operation) -> Sequence[Node]:
        """The arguments of an operation, as the language takes them."""
        if node.kind == "binary":
            return self._operands(node)
        number = splatted(node) if self.language.fills else None
        return node.arguments if number is None else (number,)

    def _operands(self, node: Operation) -> Sequence[Node]:
        left, right = node.arguments
        return [self._scalar(one) if SIZES[other.type] > 1 else one for one, other in ((left, right), (right, left))]

    def _scalar(self, node: Node) -> Node:
        """A number in place of a vector of it, unless that has a name: a name is for what reads it."""
        number = splatted(node) if self.language.splats and node not in self.called else None
        return node if number is None else number


class Writer(Expressions):
    """Writes the body of one function. `hints` has the library's names of values, `names` the names of calls."""
    indent = 2

    def __init__(self, language: Notation, block: list[Statement], hints: Mapping[Node, str], parameters: Iterable[str],
                 names: Mapping[Specialization, str], precise: bool = False, reserved: Iterable[str] = ()):
        super().__init__(language, names)
        self.block = block = with_tests_inside(block)
        self.hints = hints
        self.precise = precise
        known = (node for node in values_of(block) if isinstance(node, Operation))
        functions = (str(node.name) for node in known if node.kind == "builtin")
        results = (one.variable.name for one in walk(block) if isinstance(one, Declare) and one.variable.is_parameter)
        self.taken = {*parameters, *results, *names.values(), *functions, *RESERVED, *reserved}
        self.named: set[Operation] = set()
        self._lengths: dict[Operation, int] = {}  # until another is named
        self._numbers = {id(one): number for number, one in enumerate(blocks(block))}
        self._places: dict[Operation, Place] = {}
        self._counts: dict[int, tuple[Declare, Set]] = {}  # of loops that count, by id()
        self._dropped: set[int] = set()                    # statements that stand elsewhere, by id()
        self._save()
        self._choose()
        if precise:
            self._name_precise()
        if language.names_choices:
            self._name_choices()
        self._name_late()
        self._split()
        self._find_counts()
        self._find_changed_parameters()

    def lines(self) -> list[str]:
        self._starts: dict[tuple[int, int], list[Operation]] = {}
        for node in sorted(self.named, key=lambda one: one.number):
            self._starts.setdefault(self._places[node][-1], []).append(node)
        for statement in walk(self.block):
            if isinstance(statement, (Set, Declare)) and statement.variable.is_parameter:
                self.called[statement.variable] = statement.variable.name
        return self._lines(self.block, self.indent)

    # Names, and their places.

    def _save(self) -> None:
        """Copies a variable that was set before: _name_late gives it a name."""
        for block in blocks(self.block):
            changed: set[object] = set()
            for statement in block:
                if not isinstance(statement, (Set, Return)):
                    changed = set()
                elif isinstance(statement.value, Variable) and _key(statement.value) in changed and (
                        statement.value.type in SIZES):
                    statement.value = operation("copy", "", statement.value.type, (statement.value,))
                if isinstance(statement, Set):
                    changed.add(_key(statement.variable))

    def _choose(self) -> None:
        """Names a value used more than once, where all its uses see it."""
        uses: Counter[Operation] = Counter()
        at: dict[Operation, list[Place]] = {}
        self._visit(self.block, (), at)
        for node, places in at.items():
            uses[node] = len(places)
        known = {node for node in values_of(self.block) if isinstance(node, Operation)}
        for node in sorted(known, key=lambda one: -one.number):  # its user has a higher number
            place = self._place(node, _common(at[node]))
            self._places[node] = place
            repeats = uses[node]
            if (repeats > 1 or place not in at[node]) and not _is_cheap(node):
                self.named.add(node)
                repeats = 1
            for argument in node.arguments:
                if isinstance(argument, Operation):
                    uses[argument] += repeats
                    at.setdefault(argument, []).append(place)

    def _place(self, node: Operation, place: Place) -> Place:
        """Where a value is computed that is used there."""
        return place

    def _visit(self, block: list[Statement], around: Place, at: dict[Operation, list[Place]]) -> None:
        number = self._numbers[id(block)]
        first = 0
        for i, statement in enumerate(block):
            # Variables that are set one after another are set at once, as it were, and the result is known then.
            if not isinstance(statement, (Set, Return)):
                first = i + 1
            place = (*around, (number, min(first, i)))
            evaluated = place
            if isinstance(statement, Loop) and statement.asks_behind:
                evaluated = (*place, (self._numbers[id(statement.body)], len(statement.body)))
            for node in operands(statement):
                if isinstance(node, Operation):
                    at.setdefault(node, []).append(evaluated)
            for other in inner(statement):
                self._visit(other, place, at)

    def _name_late(self) -> None:
        """Names a value that would be read too late otherwise: behind a variable that it reads was set."""
        for block in blocks(self.block):
            changed: set[object] = set()
            for statement in block:
                if not isinstance(statement, (Set, Return)):
                    changed = set()
                    continue
                if isinstance(statement.value, Operation) and changed & {
                        _key(node) for node in self._inside(statement.value) if isinstance(node, Variable)}:
                    self.named.add(statement.value)
                if isinstance(statement, Set):
                    changed.add(_key(statement.variable))

    def _name_precise(self) -> None:
        """Names floats that go elsewhere than into a float: `precise` is of a variable, and of its maker in the
        same function."""
        known = values_of(self.block)
        gone = [value for statement in walk(self.block) for value in operands(statement)]
        gone += [argument for node in known if isinstance(node, Operation) and (
            node.kind == "call" or not _is_float(node.type)) for argument in node.arguments]
        self.named |= {node for node in gone if isinstance(node, Operation) and _is_float(node.type)
                       and node.kind not in ("call", "member")}

    def _name_choices(self) -> None:
        """Names what ?: chooses from, if it is computed: between names and numbers ANGLE selects, and else it branches."""
        self.named |= {one for node in values_of(self.block) if isinstance(node, Operation) and node.kind == "choice"
                       for one in node.arguments[1:] if isinstance(one, Operation) and one.kind not in ("copy", "member")}

    def _inside(self, node: Operation) -> list[Node]:
        """The values inside an expression at its place."""
        found: list[Node] = []
        pending = list(node.arguments)
        while pending:
            one = pending.pop()
            found.append(one)
            if isinstance(one, Operation) and one not in self.named:
                pending += one.arguments
        return found

    def _split(self) -> None:
        """Names parts of a text too long for a line."""
        whole = [node for statement in walk(self.block) for node in operands(statement) if isinstance(node, Operation)]
        for node in (*whole, *sorted(self.named, key=lambda one: one.number)):
            while (length := self._length(node)) > WIDTH:
                parts = [one for one in self._inside(node) if isinstance(one, Operation) and one not in self.named
                         and one.kind != "member" and 12 < self._length(one) < length - 20]
                if not parts:
                    break
                hinted = [one for one in parts if one in self.hints]
                self.named.add(max(hinted or parts, key=lambda one: (self._length(one) <= WIDTH) * self._length(one)))
                self._lengths.clear()

    def _length(self, node: Node) -> int:
        """About as many characters as its expression takes."""
        if isinstance(node, Constant):
            return len(self._constant(node))
        if isinstance(node, Variable):
            return 5
        if node not in self._lengths:
            self._lengths[node] = self._length_of(node)
        return self._lengths[node]

    def _length_of(self, node: Operation) -> int:
        name = self.names[node.name] if isinstance(node.name, Specialization) else node.name
        return 3 + len(name) + sum(6 if argument in self.named else 1 + self._length(argument)
                                   for argument in node.arguments)

    def _find_counts(self) -> None:
        """Loops that count: what declares the number that is counted, and what changes it last."""
        for block in blocks(self.block):
            for i, statement in enumerate(block):
                if not isinstance(statement, Loop) or statement.condition is None or statement.asks_behind or not statement.body:
                    continue
                *rest, last = statement.body
                start = next((other for other in block[:i] if isinstance(other, Declare) and isinstance(last, Set)
                              and other.variable is last.variable), None)
                if start is not None and reachable([last.value]) & changed_in(rest):
                    continue  # between turns it would read what they are by then
                if start is not None and start.variable not in values_of(block[i + 1:]):
                    self._counts[id(statement)] = start, last
                    self._dropped |= {id(start), id(last)}

    def _find_changed_parameters(self) -> None:
        """Variables that begin as a parameter which nothing else reads: they are it."""
        made = (node for node in values_of(self.block) if isinstance(node, Operation))
        reads = Counter(argument for node in made for argument in node.arguments)
        reads.update(value for statement in walk(self.block) for value in operands(statement))
        for statement in self.block:
            start = statement.value if isinstance(statement, Declare) else None
            if isinstance(start, Variable) and start.is_parameter and reads[start] == 1 and "." not in start.name and (
                    id(statement) not in self._dropped):  # the head of a loop declares it
                self.called[statement.variable] = start.name
                self._dropped.add(id(statement))

    # Lines.

    def _lines(self, block: list[Statement], indent: int) -> list[str]:
        number = self._numbers[id(block)]
        lines: list[str] = []
        for i in range(len(block) + 1):
            for node in self._starts.get((number, i), []):
                text = self._text(node)
                name = self._new_name(node, self.hints.get(node, ""))
                lines.append(self._declaration(node.type, name, text))
            if i < len(block) and id(block[i]) not in self._dropped:
                lines += self._statement(block[i])
        return self._joined(lines, indent)

    def _joined(self, lines: Sequence[str], indent: int) -> list[str]:
        """The lines of a block with this indentation; those in the blocks in it have more."""
        return declarations_joined(lines, indent)

    def _declaration(self, type_: str, name: str, text: str | None) -> str:
        behind = ";" if text is None else f" = {text};"
        made = Declaration(self._type(type_), self.language.variable(name), behind)
        return made if self.language.joins and type_ in SIZES else str(made)

    def _declared(self, variable: Variable, name: str, value: str | None) -> str:
        """The declarations of what branches and loops change."""
        return self._declaration(variable.type, name, value)

    def _type(self, type_: str) -> str:
        precise = self.precise and not self.language.no_precise and type_ in SIZES and _is_float(type_)
        return f"{'precise ' if precise else ''}{self.language.type(type_)}"

    def _new_name(self, node: Node, hint: str) -> str:
        name = hint or (UNNAMED.get(str(node.name), "") if isinstance(node, Operation) else "") or "n"
        if name in self.taken:
            name = next(f"{name}{i}" for i in range(2, 1000) if f"{name}{i}" not in self.taken)
        self.taken.add(name)
        self.called[node] = name
        return name

    def _statement(self, statement: Statement) -> list[str]:
        if isinstance(statement, Declare):
            value = self._text(statement.value) if statement.value is not None else None
            name = self.called.get(statement.variable) or self._new_name(statement.variable, statement.variable.name)
            return [self._declared(statement.variable, name, value)]
        if isinstance(statement, Set):
            return [f"{self._change(statement)}{self.language.end}"]
        if isinstance(statement, Return):
            return self._returned(statement.value) if statement.value is not None else []
        if isinstance(statement, Break):
            return [f"break{self.language.end}"]
        return self._if(statement) if isinstance(statement, If) else self._loop(statement)

    def _returned(self, value: Node) -> list[str]:
        return [f"return {self._text(value)};"]

    def _change(self, statement: Set) -> str:
        name, value = self._text(statement.variable), statement.value
        if isinstance(value, Operation) and value.kind == "binary" and value not in self.called:
            left, right = value.arguments
            changed = _key(statement.variable)
            left_is, right_is = (isinstance(one, Variable) and _key(one) == changed for one in (left, right))
            if value.name == "+" and right_is:  # the same bits, of floats as well
                left, right = right, left
            if (left_is or value.name == "+" and right_is) and (
                    short := self.language.change(value.type, name, value.name, self._text(right))):
                return short
        return f"{name} = {self._text(value)}"

    def _if(self, statement: If) -> list[str]:
        condition = self._text(statement.condition) if statement.yes else self._negated(statement.condition)
        head = f"if {self.language.condition.format(condition)} {{"
        lines = [head, *self._lines(statement.yes or statement.no, self.indent)]
        if statement.yes and statement.no:
            lines += self._otherwise(statement.no)
        if self.language.shortens and len(lines) == 2 and len(head) + len(lines[1]) < WIDTH:
            return [f"{head} {lines[1].strip()} }}" if self.language.braces else f"{head[:-2]} {lines[1].strip()}"]
        return [*lines, "}"]

    def _negated(self, condition: Node) -> str:
        return self.language.unary("!", "bool", self._piece(condition)).text

    def _otherwise(self, block: list[Statement]) -> list[str]:
        """The other branch; a lone condition in it is an `else if`."""
        lines = self._lines(block, self.indent)
        if len(block) == 1 and isinstance(block[0], If) and lines[0].lstrip().startswith("if ") and (
                lines[-1] == f"{' ' * self.indent}}}"):
            shown = [line[self.indent:] for line in lines]
            return [f"}} else {shown[0]}", *shown[1:-1]]
        return ["} else {", *lines]

    def _loop(self, loop: Loop) -> list[str]:
        language = self.language
        if loop.asks_behind:
            body = self._lines(loop.body, self.indent)
            return language.do(body, self._piece(loop.condition), self._negated(loop.condition))
        if id(loop) in self._counts:
            head = self._counted(loop, *self._counts[id(loop)])
        elif loop.condition is not None:
            head = f"{language.while_} {language.condition.format(self._text(loop.condition))} {{"
        else:
            head = language.forever
        return [head, *self._lines(loop.body, self.indent), "}"]

    def _counted(self, loop: Loop, start: Declare, step: Set) -> str:
        """The head of a loop that counts."""
        return f"for ({self._statement(start)[0]} {self._text(loop.condition)}; {self._change(step)}) {{"


def declared(parameter: Parameter) -> str:
    """A parameter as the library has it in GLSL."""
    way = ("out " if parameter.type in SIZES else "inout ") if parameter.is_set else ""
    return f"{way}{parameter.type} {parameter.at.text}"


def _is_float(type_: str) -> bool:
    return scalar_of(type_) == "float"


def _is_cheap(node: Operation) -> bool:
    """Whether it is about as short as a name for it: a component, or made of numbers alone."""
    return node.kind == "member" or all(isinstance(argument, Constant) for argument in node.arguments)


def _key(variable: Variable) -> object:
    """Which variable it is: a parameter is known by its name."""
    return variable.name if variable.is_parameter else variable


def splatted(node: Node) -> Node | None:
    """The number that all components of a vector are."""
    if isinstance(node, Operation) and node.kind == "construct" and len(node.arguments) > 1 and all(
            argument == node.arguments[0] for argument in node.arguments) and SIZES[node.arguments[0].type] == 1:
        return node.arguments[0]
    return None


def declarations_joined(lines: Sequence[str], indent: int) -> list[str]:
    """With declarations of one type in one line, as far as they fit, and long lines in several."""
    joined: list[str] = []
    for line in lines:
        last = joined[-1] if joined else ""
        # Behind one without a value stands no more than another one.
        if isinstance(line, Declaration) and isinstance(last, Declaration) and line.before == last.before and (
                "," not in last.behind.partition(" = ")[0] and indent + len(last) + len(line) - len(line.before) <= WIDTH):
            joined[-1] = Declaration(last.before, last.name, f"{last.behind[:-1]}, {line.name}{line.behind}")
        else:
            joined.append(line)
    return indented_lines(joined, indent)


def indented_lines(lines: Sequence[str], indent: int, blanks: str = " ") -> list[str]:
    return [part for line in lines
            for part in wrapped(line.lstrip(), indent + len(line) - len(line.lstrip()), blanks)]


def _common(places: Sequence[Place]) -> Place:
    """Where something has to stand that is used in these places."""
    first = places[0]
    for other in places[1:]:
        depth = 0
        while depth < min(len(first), len(other)) and first[depth] == other[depth]:
            depth += 1
        if depth < min(len(first), len(other)) and first[depth][0] == other[depth][0]:
            first = (*first[:depth], min(first[depth], other[depth]))
        else:
            first = first[:depth]
    return first
