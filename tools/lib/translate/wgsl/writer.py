"""Functions as they are written, in WGSL: the text keeps its names, its statements and its comments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from types import SimpleNamespace

from translate.library import Library
from translate.names import variable, wgsl_name, wgsl_type
from translate.parsing import syntax
from translate.parsing.lines import WIDTH, wrapped
from translate.parsing.syntax import Expression, Function, Parameter, Statement
from translate.parsing.tokens import Token
from translate.pick.printer import UNARY, Piece
from translate.pick.typer import BUILTINS, Typed, Typer, number, plain
from translate.pick.values import SHIFTS, SIZES, Constant, Node, Operation, Variable, result_type, scalar_of, vector_of
from translate.pick.wgsl import Wgsl, WgslExpressions

LANGUAGE = Wgsl(splats=False, fills=False)


@dataclass
class Definition:
    """A function, a struct or a constant of the module, and its needs among the others."""
    name: str
    comments: tuple[str, ...]
    lines: list[str]
    needs: list[str] = field(default_factory=list)
    is_constant: bool = False


def made(kind: str, name: str, type_: str, *arguments: Node) -> Operation:
    return Operation(kind, name, type_, arguments, 0)


def constructed(type_: str, arguments: tuple[Node, ...]) -> Operation:
    scalars = {scalar_of(argument.type) for argument in arguments}
    if len(arguments) > 1 and len(scalars) == 1 and scalars != {scalar_of(type_)}:  # they are converted at once
        arguments = (constructed(vector_of(scalars.pop(), SIZES[type_]), arguments),)
    return made("construct", type_, type_, *arguments)


# Makes values of others as they are written.
UNCHANGED = SimpleNamespace(
    unary=lambda sign, one: made("unary", sign, one.type, one),
    binary=lambda sign, left, right: made("binary", sign, result_type(sign, left.type, right.type), left, right),
    builtin=lambda name, type_, arguments: made("builtin", name, type_, *arguments),
    choice=lambda condition, yes, no: made("choice", "?", yes.type, condition, yes, no),
    member=lambda of, axis: made("member", axis, scalar_of(of.type), of), construct=constructed)


class Expressions(WgslExpressions):
    def __init__(self, pointers: set[str]):
        super().__init__(LANGUAGE, {})
        self._pointers = pointers

    def text(self, value: Typed) -> str:
        return self._text(value.node)

    def right(self, value: Typed) -> str:
        return self._text(self._operands(value.node)[1])

    def _constant(self, constant: Constant) -> str:
        return constant.written or super()._constant(constant)

    def _piece(self, node: Node) -> Piece:
        if isinstance(node, Operation) and node.kind == "address":
            text = self._text(node.arguments[0])
            return Piece(text.removeprefix("*") if text.startswith("*") else f"&{text}")
        if isinstance(node, Operation) and node.kind == "index":
            return Piece(f"{self._text(node.arguments[0])}[{self._text(node.arguments[1])}]")
        if isinstance(node, Operation) and node.kind == "parentheses":
            return Piece(self._piece(node.arguments[0]).within(UNARY))
        return super()._piece(node)


class FunctionWriter(Typer):
    make = UNCHANGED
    chosen = tuple(name for name, size in SIZES.items() if size == 1)  # the library has a function for others

    def __init__(self, library: Library, function: Function | None = None):
        super().__init__(library)
        self.function = function
        self.changed: set[str] = set()   # variables that do not keep their first value
        self.needs: dict[str, None] = {}
        self.scopes: list[dict[str, Variable]] = []
        self.expressions = Expressions(
            {variable(one.at.text) for one in function.parameters if one.is_set} if function else set())

    def _number(self, text: str) -> Constant:
        found = number(text)
        if found.type == "float" and text[-1] not in "fF":
            raise ValueError(f"{text} has no f: C++ takes it for a double")
        return found

    def definition(self) -> Definition:
        function = self.function
        # Twice: changes are known behind the first.
        for _ in range(2):
            self.scopes = [{parameter.at.text: Variable(parameter.type, parameter.at.text, is_parameter=True)
                            for parameter in function.parameters}]
            copies = [parameter for parameter in function.parameters
                      if not parameter.is_set and parameter.at.text in self.changed]
            body = [f"  var {variable(parameter.at.text)} = {parameter.at.text}_in;" for parameter in copies]
            body += self._block(function.body, 2)
        head = LANGUAGE.prototype(function.type, wgsl_name(function), map(self._parameter, function.parameters))
        for type_ in (function.type, *function.types):
            self._need_type(type_)
        after = function.body.comments.after
        if len(body) == 1 and not after and len(head) + len(body[0].strip()) + 5 <= WIDTH and "//" not in body[0]:
            lines = [f"{head} {{ {body[0].strip()} }}"]
        else:
            lines = wrapped(f"{head} {{", 0)
            lines += [f"  {after}"] * bool(after)
            lines += [*body, "}"]
        return Definition(wgsl_name(function), function.comments.before, lines, list(self.needs))

    def constant(self, name: str) -> Definition:
        constant = self.library.constants[name]
        value = self._value(self.library.constant(name))
        comment = f"  {constant.comment}" if constant.comment else ""
        lines = [f"const {name}: {wgsl_type(value.type)} = {self.expressions.text(value)};{comment}"]
        needs = [token.text for token in constant.body if token.text in self.library.constants]
        return Definition(name, (), lines, needs, is_constant=True)

    def _parameter(self, parameter: Parameter) -> str:
        if not parameter.is_set and parameter.at.text in self.changed:
            return LANGUAGE.pair(f"{parameter.at.text}_in", wgsl_type(parameter.type))
        return LANGUAGE.parameter(parameter)

    def _need_type(self, type_: str) -> None:
        if type_ in self.library.structs:
            self.needs[type_] = None

    # Statements.

    def _block(self, block: syntax.Block, indent: int) -> list[str]:
        self.scopes.append({})
        lines = [line for statement in block.statements for line in self._statement(statement, indent)]
        self.scopes.pop()
        return lines

    def _statement(self, statement: Statement, indent: int) -> list[str]:
        comments = statement.comments
        lines = [" " * indent + line if line else "" for line in comments.before]
        if isinstance(statement, syntax.Block):
            return [*lines, " " * indent + "{", *self._block(statement, indent + 2), " " * indent + "}"]
        if isinstance(statement, syntax.If):
            return lines + self._if(statement, indent)
        if isinstance(statement, syntax.Loop):
            return lines + self._loop(statement, indent)
        if isinstance(statement, syntax.DoLoop):
            return lines + self._do_loop(statement, indent)
        if isinstance(statement, syntax.Switch):
            return lines + self._switch(statement, indent)
        code = wrapped(self._simple(statement) + ";", indent)
        if comments.after:
            if len(code[-1]) + len(comments.after) + 2 <= WIDTH:
                code[-1] += f"  {comments.after}"
            else:
                code.insert(0, " " * indent + comments.after)
        return lines + code

    def _if(self, statement: syntax.If, indent: int) -> list[str]:
        space = " " * indent
        condition = self._text(statement.condition, "bool")
        yes = self._block(statement.yes, indent + 2)
        if statement.no is None and len(yes) == 1 and "//" not in yes[0]:
            short = f"{space}if ({condition}) {{ {yes[0].strip()} }}"
            if len(short) <= WIDTH:
                return [short]
        lines = [*wrapped(f"if ({condition}) {{", indent), *yes]
        if isinstance(statement.no, syntax.If):
            rest = self._if(statement.no, indent)
            return [*lines, f"{space}}} else {rest[0].strip()}", *rest[1:]]
        if statement.no is not None:
            lines += [f"{space}}} else {{", *self._block(statement.no, indent + 2)]
        return [*lines, f"{space}}}"]

    def _loop(self, loop: syntax.Loop, indent: int) -> list[str]:
        if loop.start is None and loop.condition is None and loop.step is None:
            return [" " * indent + "loop {", *self._block(loop.body, indent + 2), " " * indent + "}"]
        self.scopes.append({})
        start = self._simple(loop.start) if loop.start else ""
        condition = self._text(loop.condition, "bool") if loop.condition else ""
        step = self._simple(loop.step) if loop.step else ""
        lines = wrapped(f"for ({start}; {condition}; {step}) {{", indent)
        lines += [*self._block(loop.body, indent + 2), " " * indent + "}"]
        self.scopes.pop()
        return lines

    def _do_loop(self, loop: syntax.DoLoop, indent: int) -> list[str]:
        body = self._block(loop.body, indent + 2)
        return [" " * indent + "loop {", *body, " " * (indent + 2) + "continuing {",
                *wrapped(f"break if !({self._text(loop.condition, 'bool')});", indent + 4), " " * (indent + 2) + "}",
                " " * indent + "}"]

    def _switch(self, statement: syntax.Switch, indent: int) -> list[str]:
        raise statement.at.error("the translator does not know switch")

    def _simple(self, statement: Statement) -> str:
        if isinstance(statement, syntax.Declare):
            return self._declaration(statement)
        if isinstance(statement, syntax.Assign):
            return self._assignment(statement)
        if isinstance(statement, syntax.Evaluate):
            return self.expressions.text(self._value(statement.call))
        if isinstance(statement, syntax.Break):
            return "break"
        return "return" if statement.value is None else f"return {self._text(statement.value, self.function.type)}"

    def _declaration(self, statement: syntax.Declare) -> str:
        name, type_ = statement.at.text, statement.type
        value = f" = {self._text(statement.value, type_)}" if statement.value else ""
        if name in self.scopes[-1] or (len(self.scopes) == 2 and name in self.scopes[0]):
            raise statement.at.error(f"{name} is a variable already")
        self.scopes[-1][name] = Variable(type_, name)
        self._need_type(type_)
        keyword = "let" if statement.value and name not in self.changed else "var"
        return f"{keyword} {variable(name)}: {wgsl_type(type_)}{value}"

    def _assignment(self, statement: syntax.Assign) -> str:
        changed = statement.target
        while isinstance(changed, (syntax.Member, syntax.Index)):
            changed = changed.of
        if not isinstance(changed, syntax.Name):
            raise changed.at.error(f"{changed.at} cannot be assigned to")
        self.changed.add(changed.at.text)
        target = self._value(statement.target)
        value, sign = self._assigned(statement, target), statement.at.text
        if statement.value is None:
            return f"{self.expressions.text(target)}{sign}"
        shown = self.expressions.text(value) if sign == "=" else self.expressions.right(value)
        return f"{self.expressions.text(target)} {sign} {shown}"

    # Expressions.

    def _text(self, expression: Expression, type_: str) -> str:
        return self.expressions.text(self._of_type(expression, type_))

    def _value(self, expression: Expression, *scope: object) -> Typed:
        value = super()._value(expression)
        if isinstance(expression, syntax.Parentheses):
            return plain(made("parentheses", "", value.type, value.node))
        return value

    def _name(self, at: Token, *scope: object) -> Typed:
        for variables in reversed(self.scopes):
            if at.text in variables:
                return plain(variables[at.text])
        if at.text not in self.library.constants:
            raise at.error(f"{at} is no variable, and no macro that stands for a number")
        self.needs[at.text] = None
        value = type(self)(self.library)._value(self.library.constant(at.text))
        return plain(Variable(value.type, at.text))

    def _field(self, of: Typed, name: str, type_: str) -> Typed:
        return plain(made("member", variable(name), type_, of.node))

    def _called(self, call: syntax.Call, arguments: Sequence[Typed], *scope: object) -> Typed:
        """A seed that is left out is put in."""
        function = self.library.function(call.at, tuple(argument.type for argument in arguments))
        seeded = self.library.seeded(function) or function
        given = iter(zip(call.arguments, arguments))
        passed = [Constant("uint", 0) if seeded is not function and parameter.at.text == "seed" else
                  self._passed(parameter, *next(given)) for parameter in seeded.parameters]
        self.needs[wgsl_name(seeded)] = None
        return plain(made("call", wgsl_name(seeded), function.type, *passed))

    def _passed(self, parameter: Parameter, argument: Expression, value: Typed) -> Node:
        if not parameter.is_set:
            return value.node
        if not isinstance(argument, syntax.Name):
            raise argument.at.error(f"what {parameter.at} is set to must be a variable")
        if not any(one.is_set and one.at.text == argument.at.text for one in self.function.parameters):
            self.changed.add(argument.at.text)
        return made("address", "", value.type, value.node)


class RowWriter(FunctionWriter):
    """Rows of the suite, which are no text of the library's: they have more of GLSL than every language could
    print."""
    builtins = {**BUILTINS, **dict.fromkeys(("sin", "cos", "fract"), (1, ("float",)))}

    def _number(self, text: str) -> Constant:
        found = number(text)
        if found.type == "int":  # without the i it takes the type of its neighbours
            return Constant("int", found.value, f"{text}i")
        return number(f"{text}f") if found.type == "float" and text[-1] not in "fF" else found

    def _element(self, expression: syntax.Index, *scope: object) -> Typed:
        of, index = self._value(expression.of), self._of_type(expression.index, "int")
        element, bracket, _ = of.type.partition("[")
        if not bracket:
            raise expression.at.error(f"a {of.type} is no array")
        return plain(made("index", "", element, of.node, index.node))

    def _switch(self, statement: syntax.Switch, indent: int) -> list[str]:
        value = self._value(statement.value)
        lines = [f"switch {self.expressions.text(value)} {{"]
        for labels, block in statement.cases:
            shown = ", ".join("default" if label is None else self._text(label, value.type) for label in labels)
            lines += [f"{'' if labels == (None,) else 'case '}{shown}: {{", *self._block(block, 0), "}"]
        return [" " * indent + line for line in [*lines, "}"]]

    def _unary(self, at: Token, operand: Typed) -> Typed:
        if at.text == "-" and operand.type == "uint":  # WGSL negates no words
            return self._binary(at, "-", plain(Constant("uint", 0)), operand)
        return super()._unary(at, operand)

    def _binary(self, at: Token, sign: str, left: Typed, right: Typed) -> Typed:
        if sign in SHIFTS and right.type == "int" and not isinstance(right.node, Constant):
            right = plain(constructed("uint", (right.node,)))
        return super()._binary(at, sign, left, right)
