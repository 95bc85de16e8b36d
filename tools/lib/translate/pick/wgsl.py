"""WGSL: functions by the names of their forms, since it has no overloads (translate/names.py)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from translate.names import RESERVED, variable, wgsl_name, wgsl_type
from translate.parsing.syntax import Function, Parameter
from translate.pick.evaluate import Specialization
from translate.pick.printer import BITS, TRUTH, UNARY, Expressions, Language, Piece, Writer
from translate.pick.statements import Set, Statement, walk
from translate.pick.typer import CASTS
from translate.pick.values import SHIFTS, SIZES, Node, Operation, Variable, construct, converted, scalar_of, vector_of


@dataclass(frozen=True)
class Wgsl(Language):
    out: str = "ptr<function, {}>"
    inout: str = "ptr<function, {}>"
    has_overloads = False
    braces = True
    forever = "loop {"
    passed_constant = "const {}: i32 = {};\n"
    struct_form, field_form = "struct {name} {{\n{fields}}}\n", "  {name}: {type},\n"

    def named(self, name: str) -> str:
        return wgsl_type(name)

    def called(self, name: str, type_: str) -> str:
        return f"bitcast<{wgsl_type(type_)}>" if name in CASTS else name

    def variable(self, name: str) -> str:
        return variable(name)

    def field_name(self, name: str) -> str:
        return variable(name)

    def public_name(self, function: Function) -> str:
        return wgsl_name(function)

    def signature(self, function: Function) -> str:
        return self.prototype(function.type, wgsl_name(function), map(self.parameter, function.parameters))[len("fn "):]

    def pair(self, name: str, type_: str) -> str:
        return f"{name}: {type_}"

    def prototype(self, type_: str, name: str, parameters: Iterable[str]) -> str:
        returned = f" -> {self.type(type_)}" if type_ != "void" else ""
        return f"fn {name}({', '.join(parameters)}){returned}"

    def stands_apart(self, inside: str, around: str) -> bool:
        if inside in SHIFTS or inside in TRUTH and around in TRUTH and inside != around:
            return True
        return super().stands_apart(inside, around)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        return self.call("select", (no, yes, condition))

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["loop {", *body, f"  continuing {{ break if {negated}; }}", "}"]

    def writer(self, block: list[Statement], hints: Mapping[Node, str], parameters: Sequence[Parameter],
               names: Mapping[Specialization, str], precise: bool) -> Writer:
        return WgslWriter(self, block, hints, parameters, names)


class WgslExpressions(Expressions):
    _pointers: set[str]  # parameters

    def _named(self, node: Node) -> Piece:
        text = super()._named(node).text
        name, *fields = text.split(".", 1)
        if not (isinstance(node, Variable) and node.is_parameter and name in self._pointers):
            return Piece(text)
        return Piece(".".join([f"(*{name})", *fields])) if fields else Piece(f"*{name}", UNARY)

    def _arguments(self, node: Operation) -> Sequence[Node]:
        """A constructor's are converted first, if they are several, or if one is repeated."""
        arguments = super()._arguments(node)
        if node.kind == "construct" and (len(arguments) > 1 or SIZES[arguments[0].type] < SIZES[node.type]):
            scalar = scalar_of(node.type)
            return [one if scalar_of(one.type) == scalar else construct(vector_of(scalar, SIZES[one.type]), (one,))
                    for one in arguments]
        return arguments

    def _operands(self, node: Operation) -> Sequence[Node]:
        """Shifts are by unsigned counts, and of a vector and a number there are the operators of arithmetic alone."""
        if node.name not in BITS:
            return super()._operands(node)
        left, right = node.arguments
        if node.name in SHIFTS:
            size = SIZES[left.type]
            count = converted("uint", right) if SIZES[right.type] == 1 else right
            return [left, construct(vector_of("uint", size), (count,))]
        return [construct(node.type, (one,)) for one in (left, right)]


class WgslWriter(WgslExpressions, Writer):
    def __init__(self, language: Wgsl, block: list[Statement], hints: Mapping[Node, str],
                 parameters: Sequence[Parameter], names: Mapping[Specialization, str]):
        self._pointers = {variable(one.at.text) for one in parameters if one.is_set}
        self._changed = {one.variable for one in walk(block) if isinstance(one, Set)}
        taken = (name for one in parameters for name in (one.at.text, variable(one.at.text)))
        super().__init__(language, block, hints, taken, names, reserved=RESERVED)

    def _find_changed_parameters(self) -> None:
        """None is a variable."""

    def _declaration(self, type_: str, name: str, text: str | None) -> str:
        return f"let {name} = {text};"

    def _declared(self, variable: Variable, name: str, value: str | None) -> str:
        if value is None:
            return f"var {name}: {self._type(variable.type)};"
        return f"{'var' if variable in self._changed else 'let'} {name} = {value};"
