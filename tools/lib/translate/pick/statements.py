"""Keeps the rest of a function that is partly evaluated: statements over values (values.py)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Union

from translate.pick.values import Constant, Node, Operation, Variable

Environment = dict[tuple[object, ...], Node]  # of variables: the number of the call, the name, the path


@dataclass
class Declare:
    variable: Variable
    value: Node | None


@dataclass
class Set:
    variable: Variable
    value: Node


@dataclass
class If:
    condition: Node
    yes: list[Statement]
    no: list[Statement]


@dataclass
class Loop:
    """`condition` is tested before each turn, or behind it; None is true. The step changes a variable between turns."""
    condition: Node | None
    asks_behind: bool
    body: list[Statement]


@dataclass
class Break:
    state: Environment = field(default_factory=dict)  # what variables are there, until the loop is known


@dataclass
class Return:
    value: Node | None


Statement = Union[Declare, Set, If, Loop, Break, Return]


def operands(statement: Statement) -> list[Node]:
    if isinstance(statement, (Declare, Set, Return)):
        return [statement.value] if statement.value is not None else []
    if isinstance(statement, If):
        return [statement.condition]
    return [statement.condition] if isinstance(statement, Loop) and statement.condition is not None else []


def inner(statement: Statement) -> list[list[Statement]]:
    if isinstance(statement, If):
        return [statement.yes, statement.no]
    return [statement.body] if isinstance(statement, Loop) else []


def walk(block: Sequence[Statement]) -> Iterable[Statement]:
    for statement in block:
        yield statement
        for other in inner(statement):
            yield from walk(other)


def blocks(block: list[Statement], loops: bool = True) -> Iterable[list[Statement]]:
    """It and those in it; without loops, those that a break leaves as well."""
    yield block
    for statement in list(block):
        if loops or not isinstance(statement, Loop):
            for other in inner(statement):
                yield from blocks(other, loops)


def reachable(nodes: Iterable[Node]) -> set[Node]:
    """The operations and variables that values are made of."""
    found: set[Node] = set()
    pending = list(nodes)
    while pending:
        node = pending.pop()
        kind = type(node)
        if kind is Constant or node in found:
            continue
        found.add(node)
        if kind is Operation:
            pending += node.arguments
    return found


def values_of(block: Sequence[Statement]) -> set[Node]:
    return reachable(value for statement in walk(block) for value in operands(statement))


def changed_in(block: Sequence[Statement]) -> set[Variable]:
    return {one.variable for one in walk(block) if isinstance(one, (Declare, Set))}


def _asks_anew(loop: Statement, whole: Sequence[Statement]) -> bool:
    """Whether a part of the condition is computed in each turn, but for a comparison that nothing else reads: it may have
    a name, and then stands in the body."""
    if not isinstance(loop, Loop) or loop.asks_behind or loop.condition is None:
        return False
    changed = changed_in(loop.body)
    moving = {one for one in reachable([loop.condition]) if isinstance(one, Operation) and reachable([one]) & changed}
    return bool(moving - {loop.condition} or moving & reachable(
        value for one in walk(whole) if one is not loop for value in operands(one)))


def with_tests_inside(block: list[Statement], whole: Sequence[Statement] = ()) -> list[Statement]:
    """Loops whose condition is computed anew in each turn begin with a branch that leaves them."""
    whole = whole or block
    if not any(_asks_anew(one, whole) for one in walk(block)):
        return block
    made: list[Statement] = []
    for one in block:
        if isinstance(one, If):
            one = If(one.condition, with_tests_inside(one.yes, whole), with_tests_inside(one.no, whole))
        elif isinstance(one, Loop):
            body, asks = with_tests_inside(one.body, whole), _asks_anew(one, whole)
            one = (Loop(None, False, [If(one.condition, [], [Break()]), *body]) if asks
                   else Loop(one.condition, one.asks_behind, body))
        made.append(one)
    return made


def without_dead(block: list[Statement]) -> list[Statement]:
    """The statements without variables that nothing reads, and without branches in which nothing is left."""
    while True:
        read: set[Node] = set()
        before = -1
        while len(read) != before:
            before = len(read)
            read = reachable(value for statement in walk(block) for value in operands(statement)
                             if not isinstance(statement, (Declare, Set)) or _is_read(statement.variable, read))
        block, changed = _live(block, read, block)
        if not changed:
            return block


def without_copies(block: list[Statement]) -> list[Statement]:
    """The statements without variables that branches set and that are then only copied into others: they set those."""
    reads = Counter(value for statement in walk(block) for value in operands(statement))
    for node in values_of(block):
        reads.update(node.arguments if isinstance(node, Operation) else ())
    for statements in blocks(block):
        at = next((i for i in range(len(statements), 0, -1) if not isinstance(statements[i - 1], Set)), 0) - 1
        if at < 1 or not isinstance(statements[at], If):
            continue
        for copy in statements[at + 1:]:
            others = [one for one in statements[at:] if one is not copy]
            start = next((one for one in statements[:at]
                          if isinstance(one, Declare) and one.variable is copy.value), None)
            if start is None or start.value is not None or reads[copy.value] != 1 or copy.variable.is_parameter or (
                    copy.variable in values_of(others)):
                continue
            for statement in walk([statements[at]]):
                if isinstance(statement, Set) and statement.variable is copy.value:
                    statement.variable = copy.variable
            statements.remove(start)
            statements.remove(copy)
            at -= 1
    return block


def _is_read(variable: Variable, read: set[Node]) -> bool:
    return variable.is_parameter or variable in read


def _read_beside(loop: Loop, whole: Sequence[Statement]) -> set[Node]:
    """The values that statements read which are not in the loop."""
    inside = {id(one) for one in walk([loop])}
    return reachable(value for one in walk(whole) if id(one) not in inside for value in operands(one))


def _live(block: Sequence[Statement], read: set[Node], whole: Sequence[Statement]) -> tuple[list[Statement], bool]:
    left: list[Statement] = []
    changed = False
    for statement in block:
        keeps = True
        if isinstance(statement, (Declare, Set)):
            keeps = _is_read(statement.variable, read)
        elif isinstance(statement, If):
            (yes, one), (no, other) = _live(statement.yes, read, whole), _live(statement.no, read, whole)
            changed |= one or other
            keeps = bool(yes or no)
            statement = If(statement.condition, yes, no)
        elif isinstance(statement, Loop):
            body, one = _live(statement.body, read, whole)
            changed |= one
            keeps = bool({one.variable for one in walk(body) if isinstance(one, Set)} & _read_beside(statement, whole))
            statement = Loop(statement.condition, statement.asks_behind, body)
        if keeps:
            left.append(statement)
        changed |= not keeps
    return left, changed
