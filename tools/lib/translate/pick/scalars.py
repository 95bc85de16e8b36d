"""Statements as text of languages that know numbers alone: their common parts, and the description of each.

A vector is its components (pick.evaluate), and one that a function returns is an array, a tuple or a struct, as the
language has it. Integers are computed as the library in C++ computes them: words wrap, and integers with a sign do not
leave their range, as long as coordinates and settings are finite.
"""

from __future__ import annotations

import functools
import itertools
import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from catalog.tables.functions import expanded, read_functions
from translate.names import PASSED, wgsl_name
from translate.parsing.lines import wrapped
from translate.parsing.syntax import Function, Parameter
from translate.pick import comments
from translate.pick.comments import Facts
from translate.pick.evaluate import Module, Specialization, dotted
from translate.pick.printer import (
    EXAMPLES,
    UNNAMED,
    Declaration,
    Notation,
    Piece,
    Place,
    Writer,
    constants_of,
    declarations_joined,
    indented_lines,
)
from translate.pick.program import Evaluated, Program
from translate.pick.statements import (
    Declare,
    If,
    Loop,
    Return,
    Set,
    Statement,
    blocks,
    changed_in,
    operands,
    reachable,
    walk,
)
from translate.pick.values import AXES, SIZES, Constant, Node, Operation, Variable, converted, operation, scalar_of

CONSTANT = re.compile(rf"\b(?:{'|'.join(PASSED.values())})\w+")
ROOM = 84  # for components in one line
# Users call distances so in Field, in Python and in tools/bake, by the catalog's names.
DISTANCES = {"first": "f1", "second": "f2", "third": "f3"}
# Types of results that are no vectors, by their first and last components.
RECORDS = {("value", "d"): "Derivatives", ("f1", "f"): "Distances", ("value", "quadrature"): "ValueQuadrature",
           ("value", "slope"): "ValueSlope"}
NEGATED = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}  # of whole numbers


class Part(NamedTuple):
    """A field of a struct, or a result, with the function that returns it."""
    name: str
    type: str
    function: Function | None = None


def paragraph_lines(text: str, width: int = 96, begin: str = "", indent: str = "") -> list[str]:
    """A paragraph in lines, with intervals in one of them."""
    kept = re.sub(r"\[[^\]]*\]", lambda found: found[0].replace(" ", "~"), text.replace("..", "."))
    return [line.replace("~", " ") for line in textwrap.wrap(
        kept, width, initial_indent=begin, subsequent_indent=indent)]


def indented(parts: Sequence[str]) -> str:
    """The text of a class."""
    lines = (part for line in spaced(parts).splitlines()
             for part in wrapped(line.lstrip(), 4 + len(line) - len(line.lstrip())))
    return "".join(f"{line.rstrip()}\n" for line in lines)


def spaced(parts: Sequence[str]) -> str:
    """With an empty line between two of them, unless both are single lines."""
    between = ("" if one.count("\n") == other.count("\n") == 1 else "\n" for one, other in zip(parts, parts[1:]))
    return "".join(itertools.chain(*itertools.zip_longest(parts, between, fillvalue="")))


def block_comment(facts: Facts, tag: str, begin: str = "", types: Mapping[str, str] = {}) -> list[str]:
    """A comment for javadoc and JSDoc. Text behind a tag belongs to it. `begin` stands before a further paragraph, and
    `types` has the text before the names of parameters, and by "" before the result."""
    paragraphs = [facts.what, facts.call and f"{begin}Example: {facts.call}",
                  facts.error and f"{begin}Error: {facts.error}.",
                  *(f"@param {types.get(one, '')}{one} {text}." for names, text in facts.parameters.items()
                    for one in names.split(", ") if one not in facts.sets),
                  facts.all_returns and f"{tag} {types.get('', '')}{facts.all_returns}."]
    lines = [line for paragraph in paragraphs if paragraph for line in ("", *paragraph_lines(paragraph))][1:]
    return ["/**", *(f" * {line}".rstrip() for line in lines), " */"] if lines else []


def facts_of(evaluated: Evaluated, name: str, syntax: Syntax, known: Facts) -> Facts:
    function, module = evaluated.function, evaluated.evaluation.library
    names = iter(syntax.variable(one.at.text) for one in evaluated.parameters)
    taken = {one.at.text: [next(names) for _ in module.passed(one)] for one in function.parameters}
    sets = [one.at.text for one in function.parameters if one.is_set and not module.passed(one)]

    size = next(filter(None, (re.search(r"\d", type_) for type_ in function.types)), ["1"])[0]

    def of_language(text: str) -> str:
        """With the names that functions and words have in the language: of forms with as many dimensions."""
        def called(found: re.Match[str]) -> str:
            known = (f"{found[0]}{size}", f"{found[0]}_of{size}", found[0])
            form = next((one for one in known if one in module.forms), "")
            return syntax.function_name(form, is_public=True) if form else found[0]

        text = re.sub(r"\bhn_place and hn_tile make one \(tools/pick writes (\w+ and \w+)\)", r"\1 make one", text)
        text = re.sub(r"\bany uint\b", f"any {syntax.word}", text)
        text = re.sub(r"\bany uvec\d", f"any {syntax.word} in each", text)
        return re.sub(r"\bhn_[a-z]\w*", called, text)

    def argument(one: Parameter, numbers: Sequence[float] | None) -> str:
        if one.at.text in PASSED:
            return f"{syntax.example_of.format(syntax.name)}{syntax.constant_name(EXAMPLES[one.at.text])}"
        if one.at.text in sets:
            return syntax.example_set.format(syntax.variable(one.at.text))
        if numbers is not None:
            write = {"float": lambda value: syntax.float(str(float(value))), "int": syntax.int,
                     "uint": syntax.uint}[scalar_of(one.type)]
            return ", ".join(write(value) for value in numbers)
        if one.at.text == "p":
            eight, *slices = (syntax.float(value) for value in ("8.0", "0.5", "0.25"))
            return ", ".join([*(f"{eight} * {axis}" for axis in taken["p"][:2]), *slices[:max(len(taken["p"]) - 2, 0)]])
        return (syntax.example_struct if one.is_set else "{}").format(", ".join(taken[one.at.text]))

    passed = ", ".join(filter(None, comments.arguments_of(function, argument)))
    shown = {", ".join(taken[one]) or syntax.variable(one): of_language(_of_numbers(text, one, syntax))
             for one, text in known.parameters.items()}
    call = f"{syntax.example_of.format(syntax.name)}{name}({passed})" if known.what else ""
    return Facts(of_language(known.what), shown, of_language(known.returns), of_language(known.error), call,
                 () if syntax.sets_parameters else sets)


def _of_numbers(text: str, parameter: str, syntax: Syntax) -> str:
    """With the language's constants, and without what GLSL writes behind a number."""
    if parameter in PASSED:  # HN_METRIC_SQUARED, _MANHATTAN; behind it a sentence on compilers of GLSL
        text = re.sub(r"(?<= )_(?=[A-Z])", PASSED[parameter], text).partition(". ")[0]
    text = re.sub(r"any uint: 7u, not 7", "any", text)
    text = CONSTANT.sub(lambda found: syntax.constant_name(found[0]), text)
    return text.replace("|p|", "the size of a coordinate") if parameter != "p" else text


class Taken(NamedTuple):
    """A parameter: an argument that is set is a struct, one that changes is a variable as well."""
    name: str
    type: str
    is_set: bool
    changes: bool
    is_read: bool


def camel(name: str) -> str:
    return re.sub(r"(?<=.)_([a-z])", lambda found: found[1].upper(), name)


def pascal(name: str) -> str:
    name = camel(name)
    return name[:1].upper() + name[1:]


def bare(name: str) -> str:
    """Without the prefix of the library, which languages with modules do without."""
    return re.sub("^hn_(i_)?", "", name)


class Syntax(Notation):
    """A language that knows numbers alone."""
    indent = 4
    keeps_names = False              # whether names are the library's
    cased = staticmethod(camel)      # the name of a variable or a field
    # A vector and a struct of these parts, and a part of a struct, which may be its name alone.
    vector_of, struct_of, field_of = "{type}({parts})", "{type}({parts})", "{value}"
    results_of = "({})"              # several results
    float_end = "f"
    least_int = "-2147483648"
    types: Mapping[str, str] = {}    # of scalars
    reserved: frozenset[str] = frozenset()
    helpers: Mapping[str, str] = {}  # functions that the language lacks, with their comments
    builtins: Mapping[str, str] = {}  # by GLSL's names, some with a type: the names of helpers, or of the language's own
    needs: Mapping[str, Sequence[str]] = {}  # of helpers: other helpers
    helpers_first = False            # whether functions stand before those that call them
    sets_parameters = False          # whether other results are set by parameters of that name
    set_to = "{}"                    # such a parameter, where it is set
    shifts_by_int = False            # whether the right operand of a shift has to be an int
    names_components = False         # whether those of a result that is no vector have the catalog's names
    counts_a_range = False           # whether loops that count go through a range
    branches_are_values = False      # whether an if has a value
    # The name of a component, and the line that the components of a vector share, if they do.
    component: re.Pattern[str] | None = None
    components = ""
    word = "uint"          # a word of 32 bits in comments
    item = "- "            # before an item of a list in a comment
    name = ""              # the frame of the functions, if users may name it
    is_fixed = False       # whether the arithmetic is HN_FIXED, for who writes about it
    example_of = ""        # begins a call, with that name
    example_struct = "{}"  # the argument for a struct that changes
    example_set = ""       # the argument for an output
    writer: type[Scalars] | None = None  # writes bodies in another way
    passed = ""            # the declaration of a constant that users pass, with a place for its name and its number

    def __init__(self, precise: bool = False):
        self.precise = precise
        self.used: set[str] = set()           # helpers
        self.function_now = ""                # the name of the one that is written
        self.is_public_now = False            # whether users call it
        self.set_structs: frozenset[str] = frozenset()  # parameters of it

    # Names.

    def function_name(self, name: str, is_public: bool) -> str:
        return name if self.keeps_names else self.cased(bare(name))

    def type_name(self, name: str) -> str:
        return name if self.keeps_names else pascal(bare(name))

    def field_name(self, name: str) -> str:
        return self.cased(name)

    def constant_name(self, name: str) -> str:
        """The name of a constant that users pass, such as HN_METRIC_EUCLIDEAN."""
        return name if self.keeps_names else name.removeprefix("HN_")

    def variable(self, name: str) -> str:
        name = self.cased(name)
        return f"{name}_" if name in self.reserved else name

    def type(self, type_: str) -> str:
        return self.types.get(type_) or (self.vector(type_) if "vec" in type_ else self.type_name(type_))

    def vector(self, type_: str) -> str:
        raise NotImplementedError

    def axes(self, result: Part) -> Sequence[str]:
        """The names that users read the components of a result by."""
        return components(result.function) if self.names_components and result.function else AXES

    def helper(self, name: str) -> str:
        """The name of a function that the language lacks, which is then written behind the functions."""
        pending = [name]
        while pending:
            one = pending.pop()
            self.used.add(one)
            pending += [other for other in self.needs.get(one, ()) if other not in self.used]
        return name

    # Expressions.

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        made = self.infix(sign, left, right)
        return self.rounded(made) if type_ == "float" and sign in "+-*/" else made

    def rounded(self, piece: Piece) -> Piece:
        """A float that was computed, as a float has to be."""
        return piece

    def construct(self, type_: str, of: str, parts: Sequence[Piece]) -> Piece:
        return self.make_vector(type_, parts) if "vec" in type_ else self.convert(type_, of, parts[0])

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        raise NotImplementedError

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        called = self.builtins.get(f"{name} {type_}") or self.builtins.get(name, name)
        return self.call(self.helper(called) if called in self.helpers else called, arguments)

    def make_vector(self, type_: str, parts: Sequence[Piece]) -> Piece:
        of = self.vector(type_) if "{type}" in self.vector_of else ""
        return Piece(self.vector_of.format(type=of, parts=", ".join(piece.text for piece in parts)))

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        written = [self.field_of.format(name=name, value=piece.text) for name, piece in
                   zip((self.field_name(field.name) for field in fields), parts)]
        return Piece(self.struct_of.format(type=self.type_name(type_), parts=", ".join(written)))

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        """The results of a function that returns several."""
        return Piece(self.results_of.format(", ".join(piece.text for piece in parts)))

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        made = Declaration(self.type(type_), name, f"{'' if value is None else f' = {value}'}{self.end}")
        return made if SIZES.get(type_) == 1 else str(made)

    def declare_all(self, names: Sequence[str]) -> str:
        """The beginning of a declaration of variables by branches that have values."""
        raise NotImplementedError

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        """The end of a function: its result, and its other results, which parameters may be set to."""
        if self.sets_parameters:
            lines = [f"{self.set_to.format(self.variable(part.name))} = {piece.text};"
                     for part, piece in zip(results, pieces) if part.name != "value"]
            return [*lines, *(f"return {piece.text};" for part, piece in zip(results, pieces) if part.name == "value")]
        whole = pieces[0] if len(pieces) == 1 else self.make_results(results, pieces)
        return [f"return {whole.text}{self.end}"]

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        """The head of a loop that counts. Its body may not read the number."""
        return f"for ({self.declare(type_, name, start, True)} {condition.text}; {step}) {{"

    # Functions.

    def begin(self, program: Program) -> None:
        """Prepares what the functions of a program need."""

    def block(self, evaluated: Evaluated) -> list[Statement]:
        """The statements of a function, as the language can write them."""
        return evaluated.block

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        raise NotImplementedError

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        """Statements before the others."""
        return []

    def body(self, lines: Sequence[str]) -> Sequence[str]:
        """The body of a function, as it stands in the text."""
        return lines

    def struct_comment(self, name: str) -> str:
        """The lines above a struct."""
        text = comments.of_struct(name, lambda function: self.function_name(function, is_public=True))
        lines = self.documented(self.type_name(name), Facts(text)) if text else []
        return "".join(f"{line}\n" for line in lines)

    def documented(self, name: str, facts: Facts) -> list[str]:
        """A comment above a function, in the form that the language's tools know."""
        return [f"/// {line}".rstrip() for line in self.paragraphs(facts)]

    def paragraphs(self, facts: Facts) -> list[str]:
        """The paragraphs of a comment in sentences."""
        listed = [line for names, text in facts.parameters.items() if names not in facts.sets
                  for line in paragraph_lines(f"{names}: {text}.", begin=self.item, indent=" " * len(self.item))]
        paragraphs = [paragraph_lines(facts.what), listed,
                      paragraph_lines(f"Example: {facts.call}" if facts.call else ""),
                      paragraph_lines(f"Returns {facts.all_returns}." if facts.all_returns else ""),
                      paragraph_lines(f"Error: {facts.error}." if facts.error else "")]
        return [line for paragraph in paragraphs if paragraph for line in ("", *paragraph)][1:]

    def joined(self, lines: Sequence[str], indent: int) -> list[str]:
        """Lines of a block as they stand in the text."""
        if self.component:
            lines = self._with_components(lines)
        return declarations_joined(lines, indent) if self.joins else indented_lines(lines, indent, self.breaks)

    def _with_components(self, lines: Sequence[str]) -> list[str]:
        """Components of one vector are declared together, unless one is made of another."""
        groups: list[list[str]] = []
        for line in lines:
            if groups and self._is_next_component(groups[-1], line):
                groups[-1].append(line)
            else:
                groups.append([line])
        return [group[0] if len(group) < 2 else self.components.format(
            ", ".join(one.name for one in group), ", ".join(map(self._value, group))) for group in groups]

    def _is_next_component(self, before: Sequence[str], line: str) -> bool:
        if not isinstance(line, Declaration) or not isinstance(before[-1], Declaration):
            return False
        last, found = (self.component.fullmatch(one.name) for one in (before[-1], line))
        return bool(last and found and last.group(1, 3) == found.group(1, 3)
                    and AXES.index(last[2].lower()) < AXES.index(found[2].lower())
                    and not any(re.search(rf"\b{one.name.split()[-1]}\b", self._value(line)) for one in before)
                    and sum(len(self._value(one)) + len(one.name) + 4 for one in (*before, line)) < ROOM)

    def _value(self, declaration: Declaration) -> str:
        return declaration.behind.partition("= ")[2].removesuffix(self.end)

    def overhead(self, node: Operation) -> int:
        """By how much an operation takes more characters than GLSL's."""
        return 0

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        """All of the text. The names are the public functions'."""
        return "\n".join([*(f"//{line}" for line in heading), "", spaced(parts)])


class Scalars(Writer):
    """Writes the body of one function."""
    language: Syntax

    def __init__(self, syntax: Syntax, structs: Mapping[str, Sequence[Part]], block: list[Statement],
                 hints: Mapping[Node, str], axes: Mapping[Node, str], parameters: Iterable[str],
                 names: Mapping[Specialization, str], results: Sequence[Part]):
        self.results = results
        self.axes = axes
        self.structs = structs
        self.indent = syntax.indent
        self._changed = {id(one.variable) for one in walk(block) if isinstance(one, Set)}
        self._valued: dict[int, list[Variable]] = {}  # of branches that have values, by id(): variables that get them
        self._yielded: set[Variable] = set()          # by branches
        self._last: set[int] = set()                  # branches whose values are returned, by id()
        super().__init__(syntax, block, hints, parameters, names, reserved={*syntax.reserved, *syntax.helpers})

    def changed_parameters(self) -> set[str]:
        """The parameters that are variables as well."""
        return {self.called[one.variable] for one in walk(self.block)
                if isinstance(one, Declare) and id(one) in self._dropped and one.variable in self.called
                and isinstance(one.value, Variable) and one.value.is_parameter}

    def _find_values(self) -> None:
        """Branches that end with setting some variables, which nothing else sets."""
        for block in blocks(self.block):
            for i, branches in enumerate(block):
                if not isinstance(branches, If):
                    continue
                starts: list[Declare] = []
                for start in reversed(block[:i]):
                    if not isinstance(start, Declare) or start.value is not None:
                        break
                    starts.insert(0, start)
                variables = [start.variable for start in starts]
                if variables and _only_sets(branches, variables):
                    self._valued[id(branches)] = variables
                    self._yielded |= {*variables}
                    self._dropped |= {id(start) for start in starts}
                    after = block[i + 1] if i + 1 < len(block) else None
                    if isinstance(after, Return) and [after.value] == variables:
                        self._last.add(id(branches))
                        self._dropped.add(id(after))

    def _find_counts(self) -> None:
        """The loops through a range, if the language has them: by one, to a limit that the loop does not change.
        The others ask a condition."""
        super()._find_counts()
        if self.language.branches_are_values:
            self._find_values()
        for loop in walk(self.block):
            if self.language.counts_a_range and id(loop) in self._counts:
                start, step = self._counts[id(loop)]
                asked = loop.condition
                is_range = (isinstance(asked, Operation) and asked.name == "<" and asked.arguments[0] is start.variable
                            and step.value == operation("binary", "+", "int", (start.variable, Constant("int", 1))))
                changed = {one.variable for one in walk(loop.body) if isinstance(one, Set) and one is not step}
                if not is_range or start.variable in changed or changed & reachable([asked]):
                    del self._counts[id(loop)]
                    self._dropped -= {id(start), id(step)}

    def _new_name(self, node: Node, hint: str) -> str:
        if not hint and node in self.axes:
            hint = f"{UNNAMED.get(str(node.name), 'n')}{self.axes[node]}"
        return super()._new_name(node, hint)

    # Statements.

    def _declaration(self, type_: str, name: str, text: str | None) -> str:
        return self.language.declare(type_, self.language.variable(name), text, changes=False)

    def _joined(self, lines: Sequence[str], indent: int) -> list[str]:
        return self.language.joined(lines, indent)

    def _declared(self, variable: Variable, name: str, value: str | None) -> str:
        return self.language.declare(variable.type, self.language.variable(name), value, id(variable) in self._changed)

    def _returned(self, value: Node) -> list[str]:
        is_whole = isinstance(value, Operation) and value.kind == "results"
        pieces = [self._piece(one) for one in (value.arguments if is_whole else (value,))]
        return self.language.returned(self.results, pieces)

    def _if(self, statement: If) -> list[str]:
        if id(statement) not in self._valued:
            return super()._if(statement)
        names = [self.language.variable(self._new_name(one, one.name)) for one in self._valued[id(statement)]]
        lines = super()._if(statement)
        if id(statement) in self._last:
            return lines
        return [f"{self.language.declare_all(names)}{lines[0]}", *lines[1:-1], f"{lines[-1]}{self.language.end}"]

    def _lines(self, block: list[Statement], indent: int) -> list[str]:
        yielded = [one for one in block if isinstance(one, Set) and one.variable in self._yielded]
        if not yielded:
            return super()._lines(block, indent)
        # The results of the block stand behind its other statements.
        self._dropped |= {id(one) for one in yielded}
        lines = super()._lines(block, indent)
        texts = [self._text(one.value) for one in yielded]
        whole = texts[0] if len(texts) == 1 else f"({', '.join(texts)})"
        return [*lines, *wrapped(whole, indent)]

    def _counted(self, loop: Loop, start: Declare, step: Set) -> str:
        name = self.called.get(start.variable) or self._new_name(start.variable, start.variable.name)
        is_read = start.variable in reachable(value for one in walk(loop.body) if one is not step
                                              for value in operands(one))
        return self.language.loop(start.variable.type, self.language.variable(name), self._text(start.value),
                                self._piece(loop.condition), self._change(step), is_read)

    def _negated(self, condition: Node) -> str:
        if isinstance(condition, Operation) and condition not in self.called:
            if condition.kind == "unary" and condition.name == "!":
                return self._text(condition.arguments[0])
            if condition.kind == "binary" and condition.name in NEGATED and condition.arguments[0].type != "float":
                return self.language.binary(NEGATED[condition.name], condition.arguments[0].type,
                                          *(self._piece(argument) for argument in condition.arguments)).text
        return super()._negated(condition)

    # Expressions.

    def _piece(self, node: Node) -> Piece:
        if isinstance(node, Operation) and node.kind == "struct" and node not in self.called:
            parts = [self._piece(one) for one in node.arguments]
            return self.language.make_struct(node.type, self.structs[node.type], parts)
        return super()._piece(node)

    def _arguments(self, node: Operation) -> Sequence[Node]:
        if self.language.shifts_by_int and node.name in ("<<", ">>") and node.arguments[1].type == "uint":
            return node.arguments[0], converted("int", node.arguments[1])
        return node.arguments

    def _length_of(self, node: Operation) -> int:
        return super()._length_of(node) + self.language.overhead(node)


class Hoisting(Scalars):
    """For interpreters, which compute all that is written: what a loop leaves as it is stands before the loop."""

    def _place(self, node: Operation, place: Place) -> Place:
        if not hasattr(self, "_loops"):
            self._loops = {self._numbers[id(one.body)]: changed_in(one.body) for one in walk(self.block) if isinstance(one, Loop)}
            self._read: dict[Node, set[Variable]] = {}
        while place and place[-1][0] in self._loops and not self._variables(node) & self._loops[place[-1][0]]:
            place = place[:-1]
        return place

    def _variables(self, node: Node) -> set[Variable]:
        if isinstance(node, Constant):
            return set()
        if node not in self._read:
            self._read[node] = {node} if isinstance(node, Variable) else set().union(*map(self._variables, node.arguments))
        return self._read[node]


def _only_sets(branches: If, variables: Sequence[Variable]) -> bool:
    """Whether each branch ends with setting them in order, or with branches that do, and sets them nowhere else."""
    for block in (branches.yes, branches.no):
        if block and isinstance(block[-1], If) and _only_sets(block[-1], variables):
            before = block[:-1]
        else:
            before, last = block[:-len(variables)], block[-len(variables):]
            if [getattr(one, "variable", None) for one in last] != [*variables] or not all(
                    isinstance(one, Set) for one in last):
                return False
        if any(isinstance(one, Set) and one.variable in variables for one in walk(before)):
            return False
    return True


def text(program: Program, syntax: Syntax, known: Sequence[Facts] = (), heading: Sequence[str] = ()) -> str:
    """The functions of a program. Facts about them are in their order."""
    facts = itertools.chain(known, itertools.repeat(Facts()))
    called: list[str] = []
    of_roots: dict[str, str] = {}
    for name, evaluated, is_public, written in _functions(program, syntax):
        if is_public:
            comment = syntax.documented(name, facts_of(evaluated, name, syntax, next(facts)))
            of_roots[name] = "\n".join([*comment, written])
        else:
            called.append(written)
    structs = [syntax.struct_comment(name) + syntax.struct(name, fields) for name, fields in _structs(program).items()]
    constants = "".join(f"{syntax.passed.format(syntax.constant_name(name), number)}\n"
                        for name, number in constants_of([root.function for root in program.roots], program.module))
    helpers = [syntax.helpers[name] for name in syntax.helpers if name in syntax.used]
    functions = [helpers, called, of_roots.values()]
    in_order = itertools.chain(*(functions if syntax.helpers_first else reversed(functions)))
    return syntax.file(heading, [*of_roots], [*filter(None, [constants]), *structs, *in_order])


def pieces(program: Program, syntax: Syntax) -> Iterator[tuple[str, str]]:
    """The parts of text(), without comments: each piece by the name that others call it by."""
    functions = [(name, written) for name, _, _, written in _functions(program, syntax)]
    structs = [(syntax.type_name(name), syntax.struct(name, fields)) for name, fields in _structs(program).items()]
    helpers = [(name, syntax.helpers[name]) for name in syntax.helpers if name in syntax.used]
    return iter([*structs, *helpers, *functions])


def _functions(program: Program, syntax: Syntax) -> Iterator[tuple[str, Evaluated, bool, str]]:
    """Names, whether users call them, and texts: first those that others call."""
    syntax.begin(program)
    public = [syntax.function_name(wgsl_name(root.function), is_public=True) for root in program.roots]
    parameters = (one.at.text for evaluated in (*program.roots, *program.called.values())
                  for one in evaluated.parameters)
    # There are no overloads, and no function is called like a variable.
    names = program.names({*public, *syntax.helpers, *syntax.reserved, *map(syntax.variable, parameters)},
                          lambda name: syntax.function_name(name, is_public=False))
    structs = _structs(program)
    for name, evaluated, is_public in (
            *((names[special], evaluated, False) for special, evaluated in program.called.items()),
            *((name, root, True) for name, root in zip(public, program.roots))):
        yield name, evaluated, is_public, _function(evaluated, name, is_public, syntax, structs, names)


def _structs(program: Program) -> dict[str, list[Part]]:
    return {name: fields_of(program.module, name) for name in program.structs()}


def fields_of(module: Module, name: str) -> list[Part]:
    """The fields of a struct: a vector has its components."""
    return [Part(dotted((field, *path)), part) for field, type_, _ in module.structs[name].fields
            for path, part in ([((), type_)] if type_ in module.structs else module.parts(type_))]


def results_of(function: Function, module: Module) -> list[Part]:
    """Its result, and behind it the parameters that it sets in GLSL."""
    results = [Part("value", function.type, function)] if function.type != "void" else []
    return results + [Part(one.at.text, one.type) for one in function.parameters
                      if one.is_set and not module.passed(one)]


@functools.cache
def _results() -> dict[str, tuple[str, ...]]:
    """By the function, the names for the components of a result that is no vector: the catalog's, but for distances."""
    return {row.calls: tuple(DISTANCES.get(name, name) for name in row.gives)
            for row in read_functions() if row.gives[0] in ("value", "first") and not row.returns}


def components(function: Function) -> Sequence[str]:
    """The names of the components of its result: a vector's are its axes."""
    is_mean_with_slopes = function.name == "hn_mean" and function.types[1:] and "slopes" in function.types[1]
    given = _results().get("hn_fbm_d" if is_mean_with_slopes else function.name, AXES)
    return expanded(given, SIZES[function.type] - 1) if len(given) > 1 and function.type in SIZES else AXES


def record_of(axes: Sequence[str]) -> str:
    """The name of the type of results that are no vectors, by their components; a number counts the dimensions."""
    kind = RECORDS.get((axes[0], axes[-1]))
    return kind or f"{RECORDS[axes[0], axes[-1][:1]]}{len(axes) - (axes[0] == 'value')}"


def _function(evaluated: Evaluated, name: str, is_public: bool, syntax: Syntax,
              structs: Mapping[str, Sequence[Part]], names: Mapping[Specialization, str]) -> str:
    function = evaluated.function
    parameters = [parameter.at.text for parameter in evaluated.parameters]
    snake = [bare(special.name) for special in names]  # as variables are called before the language changes them
    results = results_of(function, evaluated.evaluation.library)
    beside = [one.name for one in results[function.type != "void":]] if syntax.sets_parameters else []
    writer = (syntax.writer or Scalars)(syntax, structs, syntax.block(evaluated), evaluated.evaluation.hints,
                     evaluated.evaluation.axes, [*parameters, *beside, *snake], names, results)
    syntax.function_now, syntax.is_public_now = name, is_public
    syntax.set_structs = frozenset(syntax.variable(one.at.text) for one in evaluated.parameters if one.is_set)
    lines = writer.lines()
    changed = writer.changed_parameters()
    read = {node.name.partition(".")[0] for node in evaluated.nodes if isinstance(node, Variable) and node.is_parameter}
    taken = [Taken(syntax.variable(one.at.text), one.type, one.is_set, one.at.text in changed,
                   one.is_set or one.at.text in read) for one in evaluated.parameters]
    head = syntax.function(name, taken, results, is_public)
    first = [f"{' ' * syntax.indent}{line}" for line in syntax.beginning(taken, is_public)]
    heads = [line for part in head.splitlines() for line in wrapped(part, 0)]
    return "\n".join([*heads, *syntax.body([*first, *lines]), "}"]) + "\n"
