"""Python over arrays: one text for NumPy, PyTorch, JAX, CuPy and what else follows the array API.

A word is an int32, whose sums and products wrap around; where its size counts, its sign is turned over. Both branches are
computed where arrays decide, and then it is chosen. Numbers of Python, such as octaves, decide themselves.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from translate.names import wgsl_name
from translate.parsing.lines import broken, without_braces
from translate.parsing.tokens import Unknown
from translate.pick.evaluate import Module, replaced
from translate.pick.printer import STRENGTH_OF_PYTHON, UNARY
from translate.pick.program import Evaluated, Program
from translate.pick.scalars import Facts, Hoisting, Part, Piece, Syntax, Taken, bare, fields_of, pascal, record_of
from translate.pick.statements import Declare, If, Loop, Return, Set, Statement, inner, operands, walk
from translate.pick.values import AXES, SIZES, Constant, Node, Operation, Variable, operation

COMPARED = ("<", ">", "<=", ">=")
SIGN = -(1 << 31)
STATIC = ("octaves", "metric", "kind")  # parameters that are Python's own numbers
LITERAL = re.compile(r"-?\d+")
MASKED = re.compile(r"(.*) & (\d+)")
HEAD = '''\
import operator
import struct
import sys
from collections import namedtuple
{}

def _arrays(value):
    """The arrays in a value, which may be a tuple of tuples."""
    if isinstance(value, tuple):
        return [array for one in value for array in _arrays(one)]
    return [value] if hasattr(value, "dtype") else []


def _namespace(array):
    """The functions for an array: numpy, jax.numpy, torch."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    name = type(array).__module__.partition(".")[0]
    return sys.modules[{{"dask": "dask.array", "jax": "jax.numpy", "jaxlib": "jax.numpy"}}.get(name, name)]


def _mapped(function, value):
    """The value with what the function makes of the parts of its tuples."""
    if not isinstance(value, tuple):
        return function(value)
    parts = [_mapped(function, one) for one in value]
    return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)


def _called(function, kinds, *values):
    """Calls a function of arrays with users' values of these kinds: f is a float, u a word, i an int, n a number of
    Python, d one or a float, s a structure."""
    given = [*zip(kinds, function.__code__.co_varnames[1:], values)]
    for kind, name, value in given:
        if kind not in "ns":
            _check(function.__name__[1:], kind, name, value)
    arrays = _arrays(values)
    spaces = [_namespace(one) for one in arrays]
    xp = next((one for one in spaces if one.__name__ != "numpy"), spaces[0] if spaces else None)
    if xp is None:
        import numpy as xp
    is_numpy, device = xp.__name__ == "numpy", {{}}
    if xp.__name__ == "torch":
        device["device"] = next(one.device for one in arrays if _namespace(one) is xp)

    def array(value):
        # NumPy has other rules for numbers alone.
        return value.reshape(1) if is_numpy and hasattr(value, "dtype") and not value.ndim else value

    def converted(kind, _, value):
        if kind == "n":
            return operator.index(value)
        if kind == "s":
            return _mapped(array, value)
        if kind == "d" and isinstance(value, (int, float)):
            return struct.unpack("f", struct.pack("f", value))[0]
        if kind == "u" and isinstance(value, int):
            value = _word(value)
        dtype = xp.float32 if kind in "fd" else xp.int32
        if not hasattr(value, "dtype") or isinstance(value, float) or _namespace(value) is not xp:
            return array(xp.asarray(value, dtype=dtype, **device))
        return array(value if value.dtype == dtype else _cast(value, dtype))

    values = [converted(*one) for one in given]
    if not is_numpy:
        return function(xp, *values)
    with xp.errstate(all="ignore"):
        result = function(xp, *values)
    if any(one.ndim for one in arrays):
        return result
    return _mapped(lambda one: one[0] if hasattr(one, "dtype") else one, result)


def _check(function, kind, name, value):
    """Whether users may pass it: a number, or an array of a library that has float32, without a mask and labels."""
    is_array = hasattr(value, "dtype")
    dtype = getattr(value, "dtype", type(value))
    of = getattr(dtype, "name", getattr(dtype, "__name__", str(dtype))).rpartition(".")[2]
    if is_array and (hasattr(value, "mask") or not hasattr(_namespace(value), "float32")):
        of = type(value).__name__  # an array with a mask, or with labels
    if not of.startswith(("int", "uint", "bool") if kind in "ui" else ("int", "uint", "bool", "float", "bfloat")):
        raise TypeError(f"{{function}}: {{name}} must be a number or an array of "
                        f"{{'whole ' * (kind in 'ui')}}numbers, as numpy.asarray({{name}}) is, not {{of}}")


def _cast(x, dtype):
    if isinstance(x, (int, float)):
        return int(x) if "int" in str(dtype) else float(x)
    return x.astype(dtype) if hasattr(x, "astype") else x.to(dtype)


def _word(x):
    """A whole number of Python as an int32."""
    return (x + 2147483648) % 4294967296 - 2147483648 if isinstance(x, int) else x


def _where(xp, condition, a, b):
    if isinstance(condition, bool):
        return a if condition else b
    if not hasattr(a, "dtype") and not hasattr(b, "dtype"):
        if isinstance(a, bool):
            return a if a == b else condition if a else ~condition
        is_float = isinstance(a, float) or isinstance(b, float)
        return _cast(xp.where(condition, a, b), xp.float32 if is_float else xp.int32)
    return xp.where(condition, a, b)


def _chosen(xp, condition, yes, no):
    """The results of one of two functions."""
    if isinstance(condition, bool):
        return yes() if condition else no()
    return tuple(_where(xp, condition, *both) for both in zip(yes(), no()))
'''


class Body(Hoisting):
    """Writes the body of a function."""
    language: Python

    def _if(self, statement: If) -> list[str]:
        if self.language.now.is_sure(statement.condition):
            return super()._if(statement)
        names = [self.language.variable(self.called[one]) for one in set_in([statement])]
        lines: list[str] = []
        branches: list[str] = []
        for name, block in (("yes", statement.yes), ("no", statement.no)):
            made = self._lines(block, self.indent)
            if not made:
                branches.append(f"lambda: ({', '.join(names)},)")
                continue
            branches.append(self._new_function(name))
            lines += [f"def {branches[-1]}() {{", *made, f"    return {', '.join(names)},", "}"]
        condition = self._text(statement.condition)
        return [*lines, f"{', '.join(names)}, = _chosen(xp, {condition}, {', '.join(branches)})"]

    def _new_function(self, name: str) -> str:
        found = next(one for one in (name, *(f"{name}{i}" for i in range(2, 100))) if one not in self.taken)
        self.taken.add(found)
        return found

    def _loop(self, loop: Loop) -> list[str]:
        if not is_endless(loop):
            return super()._loop(loop)
        names = [self.language.variable(self.called[one]) for one in set_in(loop.body)]
        turn = self._new_function("turn")
        going = self._text(loop.condition.arguments[0])
        others = ", ".join(name for name in names if name != going)
        return [f"def {turn}({others}, {going}) {{", *self._lines(loop.body, self.indent),
                f"    return {others}, {going}", "}",
                f"{others}, {going} = {self.language.helper('_repeated')}(xp, {turn}, {others}, {going})"]

    def _piece(self, node: Node) -> Piece:
        if node not in self.called and isinstance(node, Operation) and node.kind in ("binary", "unary", "builtin"):
            pieces = [self._piece(argument) for argument in self._arguments(node)]
            fusible = [self.language.is_fusible(one) for one in node.arguments]
            if node.kind == "binary" and node.type == "float" and node.name in ("+", "-") and any(fusible):
                helped = [self.language.builtin("_rounded", "float", [piece]) if one else piece
                          for one, piece in zip(fusible, pieces)]
                return self.language.binary(node.name, "float", *helped)
            if node.name in OF_NUMBERS and self.language.now.may_be_python(node):
                return self.language.builtin(OF_NUMBERS[node.name], node.type, pieces)
            if node.name in ("&&", "||") and self.language.now.is_sure(node):
                return Piece(f"({f' {PYTHON[node.name]} '.join(piece.text for piece in pieces)})")
            if node.name == "!" and self.language.now.is_sure(node):
                return Piece(f"(not {pieces[0].text})")
            if node.type == "uint" and node.name in ("+", "-", "*", "<<", "~") and self.language.now.may_be_python(node):
                return Piece(f"_word({super()._piece(node).text})")
        return super()._piece(node)


OF_NUMBERS = {"floor": "_floor", "trunc": "_trunc", "floatBitsToUint": "_bits", "uintBitsToFloat": "_of_bits"}  # for what may be a number of Python
PYTHON = {"&&": "and", "||": "or"}


def set_in(block: Sequence[Statement]) -> list[Variable]:
    """The variables that are set, in order, and not declared inside."""
    inside = {one.variable for one in walk(block) if isinstance(one, Declare)}
    return [*dict.fromkeys(one.variable for one in walk(block) if isinstance(one, Set) and one.variable not in inside)]


def is_endless(loop: Loop) -> bool:
    return isinstance(loop.condition, Operation) and loop.condition.name == "_repeated"


class Function:
    """One of the functions of a program: its statements, and which of its values are numbers of Python."""

    def __init__(self, evaluated: Evaluated, module: Module, may: set[str], always: set[str]):
        self.module = module
        self.may, self.always = may, always  # parameters
        self.values: dict[Variable, list[Node]] = {}
        for statement in walk(evaluated.block):
            if isinstance(statement, (Declare, Set)):
                self.values.setdefault(statement.variable, []).extend(operands(statement))
        self.sure = {one for one in self.values if not one.is_parameter and one.type in ("int", "bool")}
        self._known: dict[Node, bool] = {}
        self.possible = {*self.values}  # the variables that may be numbers of Python
        while dropped := {one for one in self.possible if not all(map(self.may_be_python, self.values[one]))}:
            self.possible -= dropped
            self._known.clear()
        self._scaled: dict[Node, bool] = {}
        while dropped := {one for one in self.sure if not all(map(self.is_sure, self.values[one]))
                          or one in self._set_below(evaluated.block)}:
            self.sure -= dropped
        self.block = self._masked(self._with_structs(evaluated))

    def _set_below(self, block: Sequence[Statement]) -> set[Variable]:
        """The variables that are set in branches, or in loops, that arrays decide on."""
        found: set[Variable] = set()
        for statement in walk(block):
            if isinstance(statement, If) and not self.is_sure(statement.condition):
                found |= {*set_in([statement])}
            if isinstance(statement, Loop) and statement.asks_behind and not self.is_sure(statement.condition):
                found |= {*set_in([statement])}
        return found

    def is_sure(self, node: Node) -> bool:
        """Whether it is a number of Python in every call."""
        if isinstance(node, Constant):
            return True
        if isinstance(node, Variable):
            return node in self.sure or node.is_parameter and node.name in self.always
        return node.name == "_most" or node.type in ("int", "bool") and node.kind != "call" and all(map(self.is_sure, node.arguments))

    def may_be_python(self, node: Node) -> bool:
        if isinstance(node, Constant):
            return True
        if isinstance(node, Variable):
            return node.name.partition(".")[0] in self.may if node.is_parameter else (
                node in self.possible or node not in self.values)
        if node not in self._known:
            # A vector has both, and of a loop without a turn there is what was before it.
            of_parts = any if node.type not in SIZES or SIZES[node.type] > 1 or (
                node.kind == "call" and node.type == "float") else all
            self._known[node] = of_parts(map(self.may_be_python, node.arguments))
        return self._known[node]

    def is_of_lacunarity(self, node: Node) -> bool:
        if isinstance(node, Variable):
            return node.name.rpartition(".")[2] == "lacunarity"
        if node not in self._scaled:
            self._scaled[node] = isinstance(node, Operation) and any(map(self.is_of_lacunarity, node.arguments))
        return self._scaled[node]

    def _with_structs(self, evaluated: Evaluated) -> list[Statement]:
        """Without setting the fields of parameters: they are returned, behind the results."""
        changed = {one.variable.name: one.value for one in evaluated.block
                   if isinstance(one, Set) and one.variable.is_parameter}
        structs = [self._struct(one.type, one.at.text, changed) for one in evaluated.parameters
                   if one.is_set and one.type in self.module.structs]
        if not structs:
            return evaluated.block
        *block, last = (one for one in evaluated.block if not (isinstance(one, Set) and one.variable.is_parameter))
        known = [] if last.value is None else [*last.value.arguments] if getattr(last.value, "kind", "") == "results" else [last.value]
        whole = (*known, *structs)
        return [*block, Return(operation("results", "", "", whole) if len(whole) > 1 else whole[0])]

    def _struct(self, type_: str, name: str, changed: Mapping[str, Node]) -> Node:
        parts = [self._struct(part.type, f"{name}.{part.name}", changed) if part.type in self.module.structs else
                 changed.get(f"{name}.{part.name}") or Variable(part.type, f"{name}.{part.name}", is_parameter=True)
                 for part in fields_of(self.module, type_)]
        return operation("struct", type_, type_, tuple(parts))

    def _masked(self, block: list[Statement]) -> list[Statement]:
        """Loops that arrays decide on go as long as one element does; the others keep what they have."""
        made: list[Statement] = []
        for one in block:
            if isinstance(one, If):
                one = If(one.condition, self._masked(one.yes), self._masked(one.no))
            if isinstance(one, Loop):
                one = Loop(one.condition, one.asks_behind, self._masked(one.body))
                if not self.is_sure(one.condition):
                    asked = one.condition
                    counts = isinstance(asked, Operation) and asked.kind == "binary" and asked.arguments[0] in self.sure
                    made += [self._mask(one)] if counts and not one.asks_behind else self._mask_turns(one, made)
                    continue
            made.append(one)
        return made

    def _mask(self, loop: Loop) -> Loop:
        counter, limit = loop.condition.arguments
        body = [Set(one.variable, operation("choice", "?", one.variable.type, (loop.condition, one.value, one.variable)))
                if isinstance(one, Set) and one.variable is not counter else one for one in loop.body]
        most = operation("builtin", "_most", "int", (limit,))
        return Loop(operation("binary", loop.condition.name, "bool", (counter, most)), False, body)

    def _mask_turns(self, loop: Loop, before: Sequence[Statement]) -> list[Statement]:
        if any(set_in(other) for one in loop.body for other in inner(one) if {*set_in(other)} & {*set_in(loop.body)}):
            raise Unknown("a branch that changes what a loop changes")
        going, turn = Variable("bool", "going"), Variable("int", "turn")
        self.sure.add(turn)
        new: dict[Node, Node] = {}
        for one in loop.body:
            if isinstance(one, Set):
                new[one.variable] = operation("choice", "?", one.variable.type, (going, one.value, one.variable))
        body = [Set(one.variable, new[one.variable]) if isinstance(one, Set) else one for one in loop.body]
        body.append(Set(going, replaced(loop.condition, dict(new))))
        begun = {one.variable: one.value for one in before if isinstance(one, Declare) and one.value is not None}
        start = Declare(going, Constant("bool", 1) if loop.asks_behind else replaced(loop.condition, begun))
        if not loop.asks_behind or loop.condition.name != "<":  # nothing limits it
            return [start, Loop(operation("builtin", "_repeated", "bool", (going,)), True, body)]
        limit = loop.condition.arguments[1]
        body.append(Set(turn, operation("binary", "+", "int", (turn, Constant("int", 1)))))
        goes_on = operation("builtin", "_goes_on", "bool", (going, turn, operation("builtin", "_most", "int", (limit,))))
        return [start, Declare(turn, Constant("int", 0)), Loop(goes_on, True, body)]


class Python(Syntax):
    word = "whole number of 32 bits"
    library = {"__VERSION__": "130"}  # without bits of floats, through which no derivative passes
    strength = STRENGTH_OF_PYTHON
    indent = 4
    end = ""
    condition, forever = "{}", "while True {"
    bools = ("False", "True")
    float_end = word_end = ""
    counts_a_range = names_components = True
    helpers_first = True
    passed = "{} = {}"
    index, vector_of = "[{number}]", "({parts})"
    struct_of, field_of = "{type}({parts})", "{name}={value}"
    writer = Body
    reserved = frozenset("""and as assert async await break class continue def del elif else except finally for from
        global if import in is lambda nonlocal not or pass raise return try while with yield False None True xp abs min
        max sys range isinstance float int type str bool operator struct namedtuple _arrays _namespace _mapped _called
        _check _cast _word _where _chosen""".split())
    needs = {"_to_uint": ("_to_int",)}
    helpers = {
        "_most": '''\
def _most(limit):
    """How often a loop turns: as often as may be, where arrays decide on it."""
    return limit if isinstance(limit, int) else 32
''',
        "_goes_on": '''\
def _goes_on(xp, going, turn, most):
    """Whether a loop turns once more: below jit and vmap nobody knows yet for which elements."""
    if turn >= most or isinstance(going, bool):
        return turn < most and going
    if xp.__name__ == "torch" and xp.compiler.is_compiling():
        return True
    try:
        return bool(going.any())
    except (TypeError, RuntimeError):
        return True
''',
        "_repeated": '''\
def _repeated(xp, turn, *values):
    """The values after as many turns as an element takes. The last is which of them go on."""
    values = turn(*values)
    if xp.__name__ == "jax.numpy":
        return sys.modules["jax"].lax.while_loop(lambda now: now[-1].any(), lambda now: turn(*now), values)
    while values[-1].any():
        values = turn(*values)
    return values
''',
        "_not": '''\
def _not(x):
    return not x if isinstance(x, bool) else ~x
''',
        "_min": '''\
def _min(xp, a, b):
    return _where(xp, b < a, b, a)
''',
        "_max": '''\
def _max(xp, a, b):
    return _where(xp, a < b, b, a)
''',
        "_min_word": f'''\
def _min_word(xp, a, b):
    return _where(xp, (b ^ {SIGN}) < (a ^ {SIGN}), b, a)
''',
        "_max_word": f'''\
def _max_word(xp, a, b):
    return _where(xp, (a ^ {SIGN}) < (b ^ {SIGN}), b, a)
''',
        "_to_int": '''\
def _to_int(xp, x):
    """The nearest int."""
    inside = _where(xp, x < 2147483648.0, _where(xp, x < -2147483648.0, -2147483648.0, x), 0.0)
    return _where(xp, x >= 2147483648.0, 2147483647, _cast(inside, xp.int32))
''',
        "_to_uint": '''\
def _to_uint(xp, x):
    """The nearest word."""
    large = _where(xp, x < 4294967296.0, _to_int(xp, x - 4294967296.0), -1)
    return _where(xp, x >= 2147483648.0, large, _to_int(xp, _where(xp, x > 0.0, x, 0.0)))
''',
        "_floor": '''\
def _floor(xp, x):
    return float(x // 1) if isinstance(x, float) else xp.floor(x)
''',
        "_rounded": '''\
def _rounded(xp, x):
    """A product that no compiler fuses with a sum."""
    fuses = xp.__name__ == "jax.numpy" or xp.__name__ == "torch" and xp.compiler.is_compiling()
    return xp.where(x == x, x, x + x) if fuses else x
''',
        "_of_bits": '''\
def _of_bits(xp, x):
    return (xp.asarray(x, dtype=xp.int32) if isinstance(x, int) else x).view(xp.float32)
''',
        "_bits": '''\
def _bits(xp, x):
    return struct.unpack("i", struct.pack("f", x))[0] if isinstance(x, float) else x.view(xp.int32)
''',
        "_abs": '''\
def _abs(xp, x):
    """With the slope of the side above at 0, as simplex noise takes it."""
    return _where(xp, x < 0.0, -x, x + 0.0)
''',
        "_trunc": '''\
def _trunc(xp, x):
    return float(int(x)) if isinstance(x, float) else xp.trunc(x)
''',
        "_no_slope": '''\
def _no_slope(xp, x):
    """What becomes a whole number, through which no derivative passes: to ask for one is an error."""
    def refuse(*_):
        raise TypeError("no derivative passes through an angle, such as a phase or a position in waves, nor through "
                        "the octaves of a place: pass x.detach() in PyTorch, jax.lax.stop_gradient(x) in JAX")

    if xp.__name__ == "torch" and xp.is_grad_enabled() and (x.requires_grad or (
            not xp.compiler.is_compiling() and xp.autograd.forward_ad.unpack_dual(x).tangent is not None)):
        refuse()
    if xp.__name__ == "jax.numpy":
        same = sys.modules["jax"].custom_jvp(lambda x: x)
        same.defjvp(refuse)
        x = same(x)
    return x
''',
        "_sqrt": '''\
def _sqrt(xp, x):
    """With a slope of 0 at 0."""
    above = x > 0.0
    return _where(xp, above, xp.sqrt(_where(xp, above, x, 1.0)), _where(xp, x < 0.0, float("nan"), 0.0))
''',
        "_right": '''\
def _right(x, shift):
    """A word shifted to the right by more than 0."""
    return (x >> shift) & ~(-1 << (32 - shift))
''',
        "_float": '''\
def _float(xp, x):
    """A word as a float."""
    return _cast((x >> 16) & 65535, xp.float32) * 65536.0 + _cast(x & 65535, xp.float32)
''',
        "_quotient": '''\
def _quotient(xp, a, b):
    q = abs(a) // abs(b)
    return _where(xp, (a < 0) == (b < 0), q, -q)
''',
        "_quotient_word": f'''\
def _quotient_word(xp, a, b):
    q = (((a >> 1) & 2147483647) // _where(xp, b > 0, b, 1)) * 2
    q = _where(xp, ((a - q * b) ^ {SIGN}) < (b ^ {SIGN}), q, q + 1)
    return _where(xp, b < 0, _where(xp, (a ^ {SIGN}) < (b ^ {SIGN}), 0, 1), q)
''',
    }

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.functions: dict[int, Function] = {}  # by id() of what they are evaluated from
        self.now: Function | None = None
        self.records: dict[str, str] = {}  # of results
        self.taken_now: Sequence[Taken] = ()

    def begin(self, program: Program) -> None:
        """Finds the parameters that may be numbers of Python, and that always are."""
        own = (self.function_name(wgsl_name(root.function), is_public=True) for root in program.roots)
        self.reserved = Python.reserved | {f"_{name}" for name in own}
        every = [*program.roots, *reversed(program.called.values())]
        may: dict[int, set[str]] = {id(one): set() for one in every}
        sure = {id(one): {taken.at.text for taken in one.parameters if taken.type in ("int", "bool")} for one in every}
        for root in program.roots:
            may[id(root)] = {one.at.text for one in root.parameters if self.kind(one.at.text, one.type) in "nd"}
            sure[id(root)] = {one.at.text for one in root.parameters if self.kind(one.at.text, one.type) == "n"}
        before = None
        while before != (now := [(len(may[id(one)]), len(sure[id(one)])) for one in every]):
            before = now
            for one in every:
                self.functions[id(one)] = caller = Function(one, program.module, may[id(one)], sure[id(one)])
                for node in one.nodes:
                    if isinstance(node, Operation) and node.kind == "call":
                        called = program.called[node.name]
                        for taken, argument in zip(called.parameters, node.arguments):
                            parts = argument.arguments if getattr(argument, "kind", "") == "construct" else [argument]
                            may[id(called)] |= {taken.at.text} if any(map(caller.may_be_python, parts)) else set()
                            sure[id(called)] -= set() if caller.is_sure(argument) else {taken.at.text}

    def is_fusible(self, node: Node) -> bool:
        """Whether it is a product that compilers must not fuse with a sum: that of positions in the next octave, whose
        fractions would differ the more the larger they are."""
        return (isinstance(node, Operation) and node.name == "*" and node.type == "float"
                and self.now.is_of_lacunarity(node))

    def block(self, evaluated: Evaluated) -> list[Statement]:
        self.now = self.functions[id(evaluated)]
        return self.now.block

    @staticmethod
    def kind(name: str, type_: str) -> str:
        """The kind of value that users pass for a parameter (_called)."""
        if type_ not in SIZES:
            return "s"
        return "n" if name in STATIC else "d" if name == "detail" else {"float": "f", "uint": "u"}.get(type_, "i")

    # Names.

    def function_name(self, name: str, is_public: bool) -> str:
        return bare(name) if is_public else f"_{bare(name)}"

    def field_name(self, name: str) -> str:
        return name

    def variable(self, name: str) -> str:
        return f"{name}_" if name in self.reserved else name

    def type(self, type_: str) -> str:
        return self.type_name(type_)

    # Expressions.

    def uint(self, value: int) -> str:
        return str(value - (1 << 32) if value >> 31 else value)

    def infix(self, sign: str, left: Piece, right: Piece) -> Piece:
        strength = self.strength[sign]
        parts = [f"({one.text})" if one.binds < strength + i or strength == one.binds == 3 or (
            one.sign and self.stands_apart(one.sign, sign)) else one.text for i, one in enumerate((left, right))]
        return Piece(f"{parts[0]} {sign} {parts[1]}", strength, sign)

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if sign in ("&&", "||"):
            return self.infix(sign[0], left, right)
        if type_ == "uint" and sign in COMPARED:
            return self.infix(sign, *map(self._turned, (left, right)))
        if type_ == "uint" and sign == ">>":
            return self._right(left, right)
        if type_ == "uint" and sign == "&" and left.sign == "&" and right.text.isdigit() and (
                found := MASKED.fullmatch(left.text)):
            return Piece(f"{found[1]} & {int(found[2]) & int(right.text)}", self.strength["&"], "&")
        if type_ in ("int", "uint") and sign in ("/", "%"):
            quotient = self.call("_quotient" if type_ == "int" else "_quotient_word", [left, right])
            return quotient if sign == "/" else self.infix("-", left, self.infix("*", quotient, right))
        if sign in ("+", "-") and LITERAL.fullmatch(right.text) and SIGN < int(right.text) < 0:
            return self.infix("+-"[sign == "+"], left, Piece(right.text[1:]))
        return self.infix(sign, left, right)

    def _right(self, left: Piece, right: Piece) -> Piece:
        """A word that is shifted to the right: without the copies of its sign."""
        if not right.text.isdigit():
            return self.call("_right", [left, right])
        mask = Piece(str((1 << (32 - int(right.text))) - 1))
        return self.infix("&", self.infix(">>", left, right), mask)

    def _turned(self, piece: Piece) -> Piece:
        """A word with its sign turned over: int32 are ordered as words are then."""
        if LITERAL.fullmatch(piece.text):
            return Piece(str(int(piece.text) ^ SIGN), UNARY)
        return self.infix("^", piece, Piece(str(SIGN)))

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        if sign == "!":
            return self.call("_not", [operand])
        return super().unary(sign, type_, operand)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        return self.call("_where", [condition, yes, no])

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float":
            return self.call(f"_to_{to}", [piece])
        if of == "bool":
            return self.call("_cast", [piece, Piece(f"xp.{'float32' if to == 'float' else 'int32'}")])
        if to != "float":
            return piece
        masked = MASKED.fullmatch(piece.text)
        if of == "int" or piece.sign == "&" and masked and not int(masked[2]) >> 31:
            return self.call("_cast", [piece, Piece("xp.float32")])
        return self.call("_float", [piece])

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        if name in ("min", "max"):
            return self.call(f"_{name}{'_word' * (type_ == 'uint')}", arguments)
        if name in ("trunc", "_trunc") and not self.is_fixed:  # of floats angles alone take it
            return self.call(f"xp.{name}" if name == "trunc" else name, [self.call("_no_slope", arguments)])
        if name in ("floor", "trunc"):
            return self.call(f"xp.{name}", arguments)
        if name == "sqrt" or name == "abs" and type_ == "float":
            return self.call(f"_{name}", arguments)
        if name in ("uintBitsToFloat", "floatBitsToUint"):
            return Piece(f"{arguments[0].within(UNARY)}.view(xp.{'float32' if type_ == 'float' else 'int32'})")
        return self.call(name, arguments)

    def call(self, name: str, arguments: Sequence[Piece]) -> Piece:
        """A function that no user calls takes the namespace first, but for some helpers."""
        if name in self.helpers:
            self.helper(name)
        known = self.helpers.get(name) or (HEAD if name in self.reserved else f"def {name}(xp")
        takes_namespace = name.startswith("_") and f"def {name}(xp" in known
        return super().call(name, [Piece("xp")] * takes_namespace + [*arguments])

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        return f"{name} = {value}"

    def change(self, type_: str, name: str, sign: str, by: str) -> None:
        return None  # += would change users' arrays

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["while True {", *body, f"    if {negated} {{", "        break", "    }", "}"]

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        limit = condition.text.split(" < ", 1)[1]
        return f"for {name} in range({limit if start == '0' else f'{start}, {limit}'}) {{"

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        """Users get names where the parts are no axes."""
        if self.is_public_now:
            pieces = [*map(self._record, results, pieces), *pieces[len(results):]]
        if len(pieces) == 1:
            return [f"return {pieces[0].text}"]
        parts = ", ".join(piece.text for piece in pieces)
        if not self.is_public_now or len(pieces) != len(results):
            return [f"return {parts}"]
        return [f"return {self._named(f'{pascal(self.function_now)}Result', [part.name for part in results])}({parts})"]

    def _record(self, result: Part, piece: Piece) -> Piece:
        axes = self.axes(result)[:SIZES.get(result.type, 1)]
        if len(axes) < 2 or axes[0] in AXES:
            return piece
        name = self._named(record_of(axes), axes)
        return Piece(f"{name}{piece.text}" if piece.text.startswith("(") else f"{name}(*{piece.text})")

    def _named(self, name: str, fields: Iterable[str]) -> str:
        self.records[name] = self._tuple(name, fields)
        return name

    @staticmethod
    def _tuple(name: str, fields: Iterable[str]) -> str:
        named = ", ".join(f'"{field}"' for field in fields)
        return "\n".join(broken(f'{name} = namedtuple("{name}", [{named}])')) + "\n"

    def joined(self, lines: Sequence[str], indent: int) -> list[str]:
        return [f"{' ' * indent}{line}" for line in lines if not line.endswith(" = None")]

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        self.taken_now = parameters
        return f"def {'_' * is_public}{name}({', '.join(['xp', *(one.name for one in parameters)])}):"

    def body(self, lines: Sequence[str]) -> Sequence[str]:
        return without_braces(lines)

    def documented(self, name: str, facts: Facts) -> list[str]:
        """The function that users call, with its comment."""
        taken = ", ".join(f"{one.name}=0" if one.name == "seed" else one.name for one in self.taken_now)
        kinds = "".join(self.kind(one.name, one.type) for one in self.taken_now)
        lines = self.paragraphs(facts)
        comment = [*(f"    {line}".rstrip() for line in (f'"""{lines[0]}', *lines[1:])), '    """'] if lines else []
        passed = ", ".join([f"_{name}", f'"{kinds}"', *(one.name for one in self.taken_now)])
        return [*broken(f"def {name}({taken}):"), *comment, *broken(f"    return _called({passed})"), "", ""]

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        return self._tuple(self.type_name(name), (field.name for field in fields))

    def struct_comment(self, name: str) -> str:
        return super().struct_comment(name).replace("/// ", "# ")

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        functions = [part.removesuffix("}\n") for part in parts if "def " in part]
        others = [part for part in parts if "def " not in part]
        first = "".join([*others, *self.records.values()])
        text = "\n\n".join([HEAD.format(f"\n{first}\n" if first else "\n"), *functions])
        return "\n".join([*(f"#{line}" for line in heading), "", text])
