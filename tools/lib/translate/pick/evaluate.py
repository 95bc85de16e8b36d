"""A function partly evaluated: its calls are replaced by bodies, known values are computed, structs are their parts.

The results are statements (statements.py). A function that is called more than once, and is worth a call,
stays one; which, the caller decides.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Union

from translate.library import Library
from translate.parsing import syntax
from translate.parsing.preprocessor import Constant as Macro
from translate.parsing.syntax import Expression, Function, Parameter, Struct
from translate.parsing.tokens import Token
from translate.pick import values
from translate.pick.statements import (
    Break,
    Declare,
    Environment,
    If,
    Loop,
    Return,
    Set,
    Statement,
    blocks,
    reachable,
    values_of,
)
from translate.pick.typer import Leaves, Typed, Typer, plain
from translate.pick.values import (
    AXES,
    SIZES,
    Constant,
    Node,
    Operation,
    Variable,
    construct,
    member,
    operation,
    scalar_of,
    vector_of,
    with_member,
)


@dataclass(frozen=True)
class Specialization:
    """A function that is called. Some of its arguments are left out: one that is the same constant in all calls, one
    that is the same as another (its number), and one that always is what another such function returns, which then has
    its place in this one."""
    name: str
    types: tuple[str, ...]
    known: tuple[Known, ...]

    def left(self, arguments: Sequence[Node]) -> list[Node] | None:
        """The arguments that are passed; None if they do not fit."""
        passed: list[Node] = []
        for argument, known in zip(arguments, self.known):
            if known is None:
                passed.append(argument)
            elif isinstance(known, Specialization):
                if not (isinstance(argument, Operation) and argument.name == known):
                    return None
                passed += argument.arguments
            elif argument != (arguments[known] if isinstance(known, int) else known):
                return None
        return passed


Known = Union[None, Constant, int, Specialization]
GENERIC = frozenset((*AXES, "condition"))  # names of parameters that reveal nothing of the arguments


@dataclass(frozen=True)
class FractalOver:
    """The noise that sums ask for at the place of an octave, in place of the library's."""
    name: str
    replaced: str
    types: tuple[str, ...]  # of both


def component(axis: str) -> str:
    """How a path calls a component, other than a field of that name."""
    return f"_{axis}"


def dotted(path: Sequence[str]) -> str:
    """The name of a part: place.cell, or place.cell_x where vectors are split."""
    return ".".join(path).replace("._", "_")


class Module(Library):
    """The library for an evaluation. For languages without vectors it is split: a vector is its components, as a struct
    is its parts. `summed` is the noise of sums, if it is not the library's."""

    def __init__(self, tree: list[Function | Struct], constants: dict[str, Macro], splits: bool = False,
                 own: Sequence[Function] = ()):
        super().__init__(tree, constants, own)
        self.summed: FractalOver | None = None
        self.splits = splits
        self._parts: dict[str, list[tuple[tuple[str, ...], str]]] = {}
        self._plain: dict[tuple[str, tuple[str, ...]], bool] = {}

    def asks_other_noise(self, call: syntax.Call, types: tuple[str, ...]) -> bool:
        """Whether the noise of sums stands here for the call: hn_perlin(o.place, o.seed)."""
        return (self.summed is not None and (call.at.text, types) == (self.summed.replaced, self.summed.types)
                and isinstance(call.arguments[0], syntax.Member) and call.arguments[0].at.text == "place")

    def parts(self, type_: str) -> list[tuple[tuple[str, ...], str]]:
        """The paths of a type's parts, and their types."""
        if type_ not in self._parts:
            fields = self.structs[type_].fields if type_ in self.structs else ()
            self._parts[type_] = [((name, *path), part) for name, of, _ in fields for path, part in self.parts(of)]
            if not fields:
                of_axes = [((component(axis),), scalar_of(type_)) for axis in AXES[:SIZES.get(type_, 1)]]
                self._parts[type_] = of_axes if self.splits and len(of_axes) > 1 else [((), type_)]
        return self._parts[type_]

    def leaves(self, node: Node) -> Leaves:
        """The leaves of a scalar or a vector."""
        return {path: member(node, path[0][1:]) if path else node for path, _ in self.parts(node.type)}

    def passed(self, parameter: Parameter) -> list[tuple[tuple[str, ...], str]]:
        """The paths and types of users' arguments for it: a struct is whole, and nothing is passed for what a split
        function sets alone, since it returns that."""
        if parameter.type in self.structs:
            return [((), parameter.type)]
        return [] if self.splits and parameter.is_set else self.parts(parameter.type)

    def is_plain(self, function: Function) -> bool:
        """Whether all that it takes and gives are numbers and vectors."""
        key = function.name, function.types
        if key not in self._plain:
            self._plain[key] = all(type_ in SIZES for type_ in (function.type, *function.types)) and not any(
                parameter.is_set for parameter in function.parameters)
        return self._plain[key]


class Evaluation(Typer):
    """The evaluation of one function. `keeps` decides for a plain function and its arguments whether it is called."""

    library: Module
    make = values

    def __init__(self, module: Module, keeps: Callable[[Function, Sequence[Node]], Specialization | None]):
        super().__init__(module)
        self.keeps = keeps
        self.arguments: dict[tuple[str, tuple[str, ...]], list[tuple[Node, ...]]] = {}
        self.sums_other_noise = False
        self.hints: dict[Node, str] = {}
        self.axes: dict[Node, str] = {}  # of components of vectors that are split
        self._frames = itertools.count(1)
        self._types: dict[tuple[int, str], str] = {}  # of variables, by the number of the call and the name
        self._in_loops: list[int] = []                # the calls that have a loop around this

    def run(self, function: Function, arguments: Sequence[Typed]) -> list[Statement]:
        """The statements; the function's outputs are set behind them, or returned where the module is split."""
        state: Environment = {}
        block: list[Statement] = []
        assert len(function.parameters) == len(arguments)
        for parameter, argument in zip(function.parameters, arguments):
            self._bind(state, 0, parameter.at.text, argument)
        self._statements(function.body.statements, 0, state, block)
        for parameter in function.parameters:
            if parameter.is_set and self.library.passed(parameter):
                for path, type_ in self.library.parts(parameter.type):
                    name = dotted((parameter.at.text, *path))
                    value = state[(0, parameter.at.text, *path)]
                    if not (isinstance(value, Variable) and value.name == name):
                        block.append(Set(Variable(type_, name, is_parameter=True), value))
        if self.library.splits:
            block.append(Return(self._results(function, state)))
        elif function.type in self.library.structs:
            result = Variable(function.type, "result", is_parameter=True)
            block.append(Declare(result, None))
            for path, type_ in self.library.parts(function.type):
                part = Variable(type_, ".".join(("result", *path)), is_parameter=True)
                block.append(Set(part, state[(0, "return", *path)]))
            block.append(Return(result))
        else:
            block.append(Return(state.get((0, "return"))))
        return block

    def _results(self, function: Function, state: Environment) -> Node | None:
        """A split function's result, with the numbers and vectors that it sets."""
        names = [("return", function.type)] if function.type != "void" else []
        names += [(parameter.at.text, parameter.type) for parameter in function.parameters
                  if parameter.is_set and not self.library.passed(parameter)]
        found = tuple(self._whole(type_, (0, name), state) for name, type_ in names)
        return operation("results", "", function.type, found) if len(found) > 1 else found[0] if found else None

    def _whole(self, type_: str, key: tuple[object, ...], state: Environment) -> Node:
        """A value of its parts."""
        if type_ in self.library.structs:
            fields: list[Node] = []
            for name, of, _ in self.library.structs[type_].fields:
                fields += ([self._whole(of, (*key, name), state)] if of in self.library.structs else
                           [state[(*key, name, *path)] for path, _ in self.library.parts(of)])
            return operation("struct", type_, type_, tuple(fields))
        parts = tuple(state[(*key, *path)] for path, _ in self.library.parts(type_))
        return parts[0] if len(parts) == 1 else construct(type_, parts)

    # Variables.

    def _bind(self, state: Environment, frame: int, name: str, value: Typed) -> None:
        self._types[frame, name] = value.type
        for path, node in value.leaves.items():
            state[(frame, name, *path)] = node

    def _read(self, state: Environment, frame: int, name: str) -> Typed | None:
        """The value of a variable; None if there is none of that name."""
        type_ = self._types.get((frame, name))
        if type_ is None:
            return None
        parts = self.library.parts(type_)
        if len(parts) == 1 and not parts[0][0]:
            return Typed(type_, {(): state[frame, name]})
        key = (frame, name)
        return Typed(type_, {path: state[key + path] for path, _ in parts})

    def _hint(self, name: str, value: Typed) -> None:
        """A value keeps the first name that it is given, unless a later one, further out, replaces it."""
        for path, node in value.leaves.items():
            fields = [part for part in path if not part.startswith("_")]
            name = fields[-1] if fields else name
            called = f"{name}{path[-1]}" if len(fields) < len(path) else name
            if len(fields) < len(path) and isinstance(node, Operation) and node.kind == "member":
                node, called = node.arguments[0], name  # the vector that it is of
            known = self.hints.get(node, "n") if isinstance(node, Operation) else ""
            if isinstance(node, Operation) and (known == "n" or len(called) <= len(known)):
                self.hints[node] = called
                if node.kind == "construct" and len(node.arguments) > 1:
                    for axis, argument in zip(AXES, node.arguments):
                        if isinstance(argument, Operation):
                            self.hints.setdefault(argument, f"{name}_{axis}")

    # Statements. Each function returns whether the call is over: by a return or a break.

    def _statements(self, statements: Sequence[syntax.Statement], frame: int, state: Environment,
                    block: list[Statement]) -> bool:
        for i, statement in enumerate(statements):
            rest = statements[i + 1:]
            if isinstance(statement, syntax.Block):
                return self._statements((*statement.statements, *rest), frame, state, block)
            if isinstance(statement, syntax.If):
                condition = self._of_type(statement.condition, "bool", frame, state, block).node
                no = _listed(statement.no)
                if isinstance(condition, Constant):
                    taken = statement.yes.statements if condition.value else no
                    return self._statements((*taken, *rest), frame, state, block)
                ends = _leaves_early(statement.yes.statements) or _leaves_early(no)
                over = self._branch(condition, statement.yes.statements, no, rest if ends else (), frame, state, block)
                if ends:
                    return over
            elif self._statement(statement, frame, state, block):
                return True
        return False

    def _branch(self, condition: Node, yes: Sequence[syntax.Statement], no: Sequence[syntax.Statement],
                rest: Sequence[syntax.Statement], frame: int, state: Environment, block: list[Statement]) -> bool:
        """Both branches, each with the rest if one of them leaves the function or the loop."""
        state_yes, state_no = dict(state), dict(state)
        block_yes: list[Statement] = []
        block_no: list[Statement] = []
        over = [self._statements((*yes, *rest), frame, state_yes, block_yes),
                self._statements((*no, *rest), frame, state_no, block_no)]
        if _breaks(block_yes) or _breaks(block_no):
            # The branch without the break goes on. It stands behind the other one, where all see its variables.
            if _breaks(block_yes):
                block += [If(condition, block_yes, []), *block_no]
            else:
                block += [If(condition, [], block_no), *block_yes]
            state.update(state_no if _breaks(block_yes) else state_yes)
            return all(over)
        changed: list[Variable] = []
        for key in dict.fromkeys((*state_yes, *state_no)):
            one, other = state_yes.get(key), state_no.get(key)
            if one is None or other is None or one is other or one == other:
                if one is not None and other is not None:
                    state[key] = one
                continue
            variable = Variable(one.type, _name_of(key))
            before = state.get(key)
            kept = before if before is one or before is other else None
            block.append(Declare(variable, kept))
            changed.append(variable)
            if one is not kept:
                block_yes.append(Set(variable, one))
            if other is not kept:
                block_no.append(Set(variable, other))
            state[key] = variable
        if changed or block_yes or block_no:
            block.append(If(condition, block_yes, block_no))
        return all(over)

    def _statement(self, statement: syntax.Statement, frame: int, state: Environment, block: list[Statement]) -> bool:
        if isinstance(statement, syntax.Declare):
            self._declare(statement, frame, state, block)
        elif isinstance(statement, syntax.Assign):
            self._assign(statement, frame, state, block)
        elif isinstance(statement, syntax.Evaluate):
            self._value(statement.call, frame, state, block)
        elif isinstance(statement, (syntax.Loop, syntax.DoLoop)):
            self._loop(statement, frame, state, block)
        elif isinstance(statement, syntax.Break):
            block.append(Break(dict(state)))
            return True
        elif isinstance(statement, syntax.Switch):
            raise statement.at.error("a switch is not one that tools/pick knows")
        else:
            if frame in self._in_loops:
                raise statement.at.error("a return in a loop is not one that tools/pick knows")
            if statement.value is not None:
                self._bind(state, frame, "return", self._value(statement.value, frame, state, block))
            return True
        return False

    def _declare(self, statement: syntax.Declare, frame: int, state: Environment, block: list[Statement]) -> None:
        name = statement.at.text
        if statement.value is None:
            self._types[frame, name] = statement.type
            for path, type_ in self.library.parts(statement.type):
                state[(frame, name, *path)] = _nothing(type_)
            return
        value = self._of_type(statement.value, statement.type, frame, state, block)
        self._hint(name, value)
        self._bind(state, frame, name, value)

    def _assign(self, statement: syntax.Assign, frame: int, state: Environment, block: list[Statement]) -> None:
        target = self._value(statement.target, frame, state, block)
        value = self._assigned(statement, target, frame, state, block)
        self._store(statement.target, value, frame, state)

    def _store(self, target: Expression, value: Typed, frame: int, state: Environment) -> None:
        path: list[str] = []
        while isinstance(target, syntax.Member):
            path.insert(0, target.at.text)
            target = target.of
        key = (frame, target.at.text, *path)
        if path and self.library.splits and (*key[:-1], component(path[-1])) in state:
            key = (*key[:-1], component(path[-1]))
        if path and key not in state and key[:-1] in state:  # a component of a vector
            state[key[:-1]] = with_member(state[key[:-1]], path[-1], value.node)
            return
        name = path[-1] if path else target.at.text
        self._hint(f"{target.at.text}{key[-1]}" if str(key[-1]).startswith("_") else name, value)
        for part, node in value.leaves.items():
            state[(*key, *part)] = node

    def _loop(self, loop: syntax.Loop | syntax.DoLoop, frame: int, state: Environment, block: list[Statement]) -> None:
        asks_behind = isinstance(loop, syntax.DoLoop)
        if not asks_behind and loop.start is not None:
            self._declare(loop.start, frame, state, block)
        carried: dict[tuple[object, ...], Variable] = {}
        derived: dict[tuple[object, ...], tuple[tuple[object, ...], Node]] = {}
        seen = {key: list(arguments) for key, arguments in self.arguments.items()}
        while True:
            self.arguments = {key: list(arguments) for key, arguments in seen.items()}  # of the last turn alone
            start: Environment = {**state, **carried}
            for key, (other, node) in derived.items():
                start[key] = replaced(node, {state[other]: carried[other]})
            now, body = dict(start), []
            condition = None
            if not asks_behind and loop.condition is not None:
                condition = self._of_type(loop.condition, "bool", frame, now, body).node
            self._in_loops.append(frame)
            over = self._statements(loop.body.statements, frame, now, body)
            self._in_loops.pop()
            if not asks_behind and loop.step is not None:
                self._assign(loop.step, frame, now, body)
            if asks_behind:
                condition = self._of_type(loop.condition, "bool", frame, now, body).node
            states = [exit_.state for exit_ in _exits(body)] + ([] if over else [now])
            changed = {key for other in states for key in start if other[key] is not start[key]} - {*carried, *derived}
            if not changed:
                found = {key: of for key in carried if (of := _derived(key, carried, state, states))}
                if not found:
                    break
                derived |= found
                for key in found:
                    del carried[key]
            carried |= {key: Variable(start[key].type, _name_of(key)) for key in start if key in changed}
        block += [Declare(variable, state[key]) for key, variable in carried.items()]
        for statements in blocks(body, loops=False):
            for i, statement in enumerate(statements):
                if isinstance(statement, Break) and statement.state:
                    statements[i:i + 1] = [*_sets(carried, statement.state), Break()]
                    break
        if not over:
            body += _sets(carried, now)
        if asks_behind and condition is not None:
            condition = _behind(condition, body, {now[key]: variable for key, variable in carried.items()
                                                  if isinstance(now[key], Operation)})
        block.append(Loop(condition, asks_behind, body))
        state.update(carried)

    # Expressions.

    def _name(self, at: Token, frame: int, state: Environment, block: list[Statement]) -> Typed:
        if found := self._read(state, frame, at.text):
            return found
        if at.text not in self.library.constants:
            raise at.error(f"{at} is no variable, and no macro that stands for a number")
        return self._value(self.library.constant(at.text), frame, state, block)

    def _component(self, of: Typed, axis: str) -> Typed:
        return plain(of.leaves[component(axis),]) if self.library.splits else super()._component(of, axis)

    def _field(self, of: Typed, name: str, type_: str) -> Typed:
        return Typed(type_, {path[1:]: node for path, node in of.leaves.items() if path[0] == name})

    def _called(self, expression: syntax.Call, arguments: Sequence[Typed], frame: int, state: Environment,
                block: list[Statement]) -> Typed:
        at, types = expression.at, tuple(argument.type for argument in arguments)
        if self.library.asks_other_noise(expression, types):
            at = at._replace(text=self.library.summed.name)
            self.sums_other_noise = True
        function = self.library.function(at, types)
        if self.library.is_plain(function):
            nodes = tuple(argument.node if () in argument.leaves else
                          construct(argument.type, tuple(argument.leaves.values())) for argument in arguments)
            key = (function.name, function.types)
            self.arguments.setdefault(key, []).append(nodes)
            special = self.keeps(function, nodes)
            if special:
                if self.library.splits:
                    for parameter, argument, node in zip(function.parameters, expression.arguments, nodes):
                        if isinstance(node, Operation) and node.kind == "construct" and SIZES[node.type] > 1:
                            self.hints.setdefault(
                                node, argument.at.text if isinstance(argument, syntax.Name) else parameter.at.text)
                called = operation("call", special, function.type, tuple(special.left(nodes)))
                return Typed(function.type, self.library.leaves(called))
        inner = next(self._frames)
        for parameter, argument in zip(function.parameters, arguments):
            if parameter.at.text not in GENERIC and not any(
                    node in self.hints for node in argument.leaves.values()):
                self._hint(parameter.at.text, argument)
            self._bind(state, inner, parameter.at.text, argument)
        self._statements(function.body.statements, inner, state, block)
        found = [self._read(state, inner, parameter.at.text) for parameter in function.parameters if parameter.is_set]
        result = self._read(state, inner, "return") or Typed("void", {})
        while state:  # the call's additions stand last
            key, node = state.popitem()
            if key[0] != inner:
                state[key] = node
                break
        targets = (one for one, of in zip(expression.arguments, function.parameters) if of.is_set)
        for argument, value in zip(targets, found):
            self._store(argument, value, frame, state)
        return result

    def _each(self, of: Callable[..., Node], *values: Typed) -> Typed:
        """Where vectors are split it is of their components; a scalar goes with each of them."""
        if not self.library.splits:
            return super()._each(of, *values)
        most = max(values, key=lambda one: SIZES[one.type])
        leaves = {path: of(*(value.leaves.get(path) or value.node for value in values)) for path in most.leaves}
        for path, node in leaves.items():
            if path and isinstance(node, Operation):
                self.axes.setdefault(node, path[0])
        scalar = scalar_of(next(iter(leaves.values())).type)
        return Typed(vector_of(scalar, SIZES[most.type]), leaves)

    def _made(self, type_: str, arguments: Sequence[Typed]) -> Typed:
        nodes = tuple(node for argument in arguments for node in argument.leaves.values())
        if not self.library.splits or SIZES[type_] == 1:
            return plain(construct(type_, nodes))
        parts = self.library.parts(type_)
        nodes = nodes * len(parts) if len(nodes) == 1 else nodes
        return Typed(type_, {path: construct(scalar, (node,)) for (path, scalar), node in zip(parts, nodes)})


def _nothing(type_: str) -> Node:
    """The value of a variable that has none yet; no computation may need it."""
    scalar = scalar_of(type_)
    zero = Constant(scalar, "0.0f" if scalar == "float" else 0)
    return zero if SIZES[type_] == 1 else construct(type_, (zero,))


def _name_of(key: tuple[object, ...]) -> str:
    *others, last = (str(part) for part in key)
    if last.startswith("_"):  # a component
        return f"{_name_of((*others,))}{last}"
    return "result" if last == "return" else last


def _listed(block: syntax.Block | syntax.If | None) -> Sequence[syntax.Statement]:
    if block is None:
        return ()
    return (block,) if isinstance(block, syntax.If) else block.statements


def _leaves_early(statements: Iterable[syntax.Statement]) -> bool:
    """Whether a return stands in them, or a break that is not of a loop in them."""
    for statement in statements:
        if isinstance(statement, (syntax.Return, syntax.Break)):
            return True
        if isinstance(statement, syntax.Block) and _leaves_early(statement.statements):
            return True
        if isinstance(statement, syntax.If) and _leaves_early((*statement.yes.statements, *_listed(statement.no))):
            return True
    return False


def _breaks(block: Sequence[Statement]) -> bool:
    return bool(block) and isinstance(block[-1], Break)


def _exits(block: list[Statement]) -> list[Break]:
    return [exit_ for one in blocks(block, loops=False) for exit_ in one if isinstance(exit_, Break) and exit_.state]


def _sets(carried: dict[tuple[object, ...], Variable], state: Environment) -> list[Statement]:
    """Variables that change in a turn."""
    return [Set(variable, state[key]) for key, variable in carried.items() if state[key] is not variable]


def _derived(key: tuple[object, ...], carried: dict[tuple[object, ...], Variable], state: Environment,
             states: Sequence[Environment]) -> tuple[tuple[object, ...], Node] | None:
    """The variable that a value is a fixed function of before each turn, and that function of what the variable was
    before the first."""
    for other in carried:
        first = state[other]
        if other != key and isinstance(first, Variable) and isinstance(state[key], Operation) and all(
                replaced(state[key], {first: now[other]}) is now[key] for now in states):
            return other, state[key]
    return None


def _behind(condition: Node, body: Sequence[Statement], new: dict[Node, Node]) -> Node:
    """The condition of a loop that tests behind its body, of the variables that the body has set. Where the body
    computes the same of what they were before, it is of copies, so that it is not the same node."""
    shown = replaced(condition, dict(new))
    made = {node for node in reachable([shown]) if isinstance(node, Operation)}
    if made & values_of(body) == set():
        return shown
    return replaced(condition, {value: operation("copy", "", variable.type, (variable,))
                                for value, variable in new.items()})


def replaced(node: Node, new: dict[Node, Node]) -> Node:
    if isinstance(node, Constant):
        return node
    if node not in new:
        if not isinstance(node, Operation):
            return node
        arguments = tuple(replaced(argument, new) for argument in node.arguments)
        new[node] = operation(node.kind, node.name, node.type, arguments)
    return new[node]
