"""Functions with their helpers, and nothing else: which of those that they call stay functions, and their text."""

from __future__ import annotations

import copy
import difflib
import functools
import gc
import re
import textwrap
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from base.tree import GLSL, version
from translate.names import wgsl_name
from translate.parsing.lines import wrapped
from translate.parsing.preprocessor import Preprocessor
from translate.parsing.syntax import Function, Parameter, definitions
from translate.parsing.tokens import Unknown
from translate.pick import comments
from translate.pick.comments import Facts
from translate.pick.evaluate import Evaluation, FractalOver, Known, Module, Specialization, Typed, dotted
from translate.pick.printer import Language, declared
from translate.pick.statements import Statement, values_of, without_copies, without_dead
from translate.pick.values import AXES, SIZES, Constant, Node, Operation, Variable, begin_anew, scalar_of
from translate.settings import Settings

if TYPE_CHECKING:
    from catalog.tables.functions import Function as Row

CALL = re.compile(r"(hn_\w+)\((?:hn_(tile|place)\()?(float|vec[234])\)+")
JOINED = re.compile(r"\w*(,\w*)+")
STEP = re.compile("hn_(add|next|octaves|mean|density|slopes|shifts)")  # of a loop over octaves
SUMMED = ("hn_perlin", "hn_perlin_d")  # by sums, at the place of an octave
Key = tuple[str, tuple[str, ...]]
gc.set_threshold(1_000_000)  # nodes of expressions are in no cycles, and to look for some takes a fifth of the time


def read(library: Path, settings: dict[str, str], splits: bool = False, own: Sequence[Function] = (),
         below: str = "") -> Module:
    """The whole library with these knobs, with these functions of the user's, and with a text below it."""
    if own or below:
        return _read(library, settings, splits, own, below)
    # Tests ask for the same again and again, and nobody changes a module.
    state = tuple((path, path.stat().st_mtime_ns) for path in sorted(library.rglob("*.*")))
    return _read_once(library, tuple(settings.items()), splits, state)


@functools.lru_cache(maxsize=8)
def _read_once(library: Path, settings: tuple[tuple[str, str], ...], splits: bool, _: object) -> Module:
    return _read(library, dict(settings), splits, (), "")


def _read(library: Path, settings: dict[str, str], splits: bool, own: Sequence[Function], below: str) -> Module:
    # Where floats are precise, all are: the printer writes it. A language's version may be below those that have them.
    is_precise = settings.get("HN_ARITHMETIC") == "HN_PRECISE"
    preprocessor = Preprocessor(library, {**settings, "precise": "", **({"__VERSION__": "400"} if is_precise else {})})
    preprocessor.read(f'#include "hashnoise.glsl"\n{below}', "the library")
    tree = definitions(preprocessor.items)
    for name in (function.name for function in own):
        if any(name in (item.name, *(one.at.text for one in item.parameters)) for item in tree
               if isinstance(item, Function)):
            raise Unknown(f"{name} is a name that the library has: call your function otherwise")
    return Module(tree, preprocessor.constants, splits, own)


def name_of(row: Row, known: dict[tuple[str, tuple[str, ...]], str]) -> str:
    """The name of the form of the library that a row of the table is, also in a module of WGSL."""
    types = tuple(f"hn_{type_}" if type_.startswith("place") else type_.removeprefix("out ")
                  for type_ in row.overloads[-1])
    return known[row.calls, types]


def names() -> dict[tuple[str, tuple[str, ...]], str]:
    """The names of the forms by their names in the library and their types."""
    return {(one.name, tuple(one.types)): name for name, one in read(GLSL, {}).forms.items()}


def expanded(names: Sequence[str]) -> list[str]:
    """Names of forms: hn_fbm2_tile is a tile and what takes it, and so is hn_fbm(hn_tile(vec2)). hn_fbm(vec2) is
    hn_fbm2."""
    found: list[str] = []
    for name in names:
        called = CALL.fullmatch(name)
        tiled = re.fullmatch(r"(hn_\w+?([1-4]))_tile", name)
        if called:
            function, place, type_ = called.groups()
            size = SIZES[type_]
            found += [{"tile": f"hn_tile{size}", "place": f"hn_place_in_cell{size}"}[place]] if place else []
            found.append(f"{function}{size}{'_place' if place else ''}")
        elif tiled:
            found += [f"hn_tile{tiled[2]}", f"{tiled[1]}_place"]
        else:
            found.append(name)
    return list(dict.fromkeys(found))


def listed(module: Module, library: Path) -> str:
    """All forms, by function: first noise, and behind it the steps of loops."""
    groups: dict[str, list[str]] = {}
    for name, function in sorted(module.forms.items()):
        groups.setdefault(function.name, []).append(f"  {name:32} {function.type} {function.name}"
                                                    f"({', '.join(map(declared, function.parameters))})\n")
    first = {function.name: function for function in reversed(module.forms.values())}
    order = sorted(groups, key=lambda name: (STEP.match(name) is not None, name))
    about = {name: re.sub(" (?:on|in) the (?:plane|line)", "", comments.first_sentence(first[name], library))
             for name in order}
    return "\n".join(f"{name}: {about[name]}\n{''.join(groups[name])}" for name in order)


def chosen(module: Module, names: Sequence[str]) -> list[Function]:
    found = {name: module.form(name) for name in names}
    for name, function in found.items():
        if function is None and JOINED.fullmatch(name):
            raise Unknown(f"{name}: separate functions by blanks, such as hn_fbm2 hn_fbm3")
        if function is None:
            raise Unknown(f"there is no function {name}{_hint(name, module.forms)}")
    return [*found.values()]


def _hint(name: str, known: dict[str, Function]) -> str:
    """A suggestion: the forms of a function, or a form that a few typing errors turn into the name."""
    def forms(called: str) -> list[str]:
        return sorted(form for form, function in known.items() if function.name == called)

    if own := forms(name):
        tile = next((f"; in a tile that is {form[:-len('_place')]}_tile" for form in own if f"{form}" in known
                     and form.endswith("2_place")), "")
        return f"; there {'are' if len(own) > 1 else 'is'} {', '.join(own)}{tile}"
    functions = {function.name for function in known.values()}
    bare = {one.removeprefix("hn_"): one for one in {*functions, *known}}  # all have the prefix in common
    near = [bare[one] for one in difflib.get_close_matches(name.removeprefix("hn_"), sorted(bare))]
    if not near:
        return "; --list prints them"
    if near[0] in functions and near[0] not in known:
        near = [form for form in forms(near[0]) if form[:-1] == near[0]] or forms(near[0])  # with a dimension
    near = [form for form in near if form in known]
    *others, last = near
    return f" (did you mean {', '.join(others)}{' or ' if others else ''}{last}?)"


def over(module: Module, form: str) -> Module:
    """The library with sums over the noise of this form: hn_simplex3 or, for sums with derivatives, hn_simplex_d3."""
    noise, = chosen(module, [form])
    types = _of_an_octave(noise)
    at_place = module.overload(noise.name, types)
    if at_place is None:
        raise Unknown(f"--noise {form}: there is no {noise.name}({', '.join(types)}), and more an octave has not")
    for replaced in SUMMED:
        of_library = module.overload(replaced, types)
        if of_library and of_library.type == at_place.type:
            return _with(module, FractalOver(noise.name, replaced, types))
    raise Unknown(f"--noise {form} returns {at_place.type}, and a sum's noise returns a float, or derivatives as "
                  "those of hn_perlin_d")


def _of_an_octave(function: Function) -> tuple[str, str]:
    """The parameters of the noise of an octave, in the dimensions of this function."""
    return f"hn_place{SIZES.get(function.types[0]) or function.types[0][-1]}", "uint"


def _with(module: Module, summed: FractalOver) -> Module:
    with_other = copy.copy(module)
    with_other.summed = summed
    return with_other


class NoSum(Unknown):
    """A function that sums no noise."""


def not_summed(module: Module, function: Function, summed: FractalOver) -> Unknown:
    """Why --noise cannot stand for this function's calls, and which noise it takes: a form of the same one if it has
    one, else another noise."""
    types = _of_an_octave(function)
    for replaced in SUMMED:
        form = replaced.removeprefix("hn_perlin")
        of_library = module.overload(replaced, types)
        names = (f"{summed.name.removesuffix('_d')}{form}", f"hn_simplex{form}", f"hn_value{form}")
        fitting = (name for name in names if of_library and (other := module.overload(name, types))
                   and other.type == of_library.type)
        if name := next(fitting, None):
            root, = Program(_with(module, FractalOver(name, replaced, types)), [function]).roots
            if root.evaluation.sums_other_noise:
                return Unknown(f"{wgsl_name(function)} sums {replaced}({', '.join(types)}), for which "
                               f"--noise {name}{types[0][-1]} stands")
    why = (f"{function.name}({', '.join(function.types)}) is no sum that calls "
           f"{summed.replaced}({', '.join(summed.types)}), for which --noise could stand")
    if not function.name.startswith("hn_warp"):
        return NoSum(why)
    axes, noise = types[0][-1], summed.name.removesuffix("_d")
    add = f"hn_add_progressive{axes}" if function.name == "hn_warp_progressive" else f"hn_add{axes}_shifts"
    return Unknown(f"{why}. A warp by another noise is a loop (docs/reference/fractals.md#warps) over these functions: "
                   f"tools/pick hn_octaves_of{axes} hn_shifts_of{axes} {add} hn_next{axes} hn_mean{axes}_shifts "
                   f"{noise}{axes}_place")


def check_sums(program: Program, summed: FractalOver) -> None:
    """Functions that sum nothing stand beside sums: one text has the land and what masks it."""
    others = [root for root in program.roots if not root.evaluation.sums_other_noise]
    for root in others:
        wrong = not_summed(program.module, root.function, summed)
        if not isinstance(wrong, NoSum) or len(others) == len(program.roots):
            raise wrong


@dataclass
class Evaluated:
    """A function with its calls in it."""
    function: Function
    evaluation: Evaluation
    block: list[Statement]
    parameters: list[Parameter]  # that are left
    consulted: set[Key]  # functions for which it mattered whether they are called

    @functools.cached_property
    def nodes(self) -> set[Node]:
        return values_of(self.block)

    @functools.cached_property
    def calls(self) -> list[Specialization]:
        return sorted({node.name for node in self.nodes if _is_call(node)}, key=str)

    @functools.cached_property
    def size(self) -> int:
        """How many operations it has."""
        return sum(isinstance(node, Operation) and node.kind not in ("member", "construct") for node in self.nodes)


class Program:
    """The chosen functions, and those that they call. For a hundred functions `calls_first` is eight times as fast, and the
    text is as long within a hundredth."""

    def __init__(self, module: Module, roots: Sequence[Function], calls_first: bool = False):
        begin_anew()
        self.module = module
        self._asked_for = roots
        self.specialized: dict[Key, Specialization] = {}
        self._done: dict[tuple[Specialization, bool], Evaluated] = {}  # that those in `specialized` leave as they are
        if calls_first:
            self._start_with_calls()
        else:
            self._evaluate_all()
        while new := self._worth_a_call() or self._joined():
            if not self._keep(new):
                self._keep(new[:1])

    def _evaluate_all(self) -> None:
        self.roots = [self._evaluated(self._all_passed(root), is_root=True) for root in self._asked_for]
        self.called = self._called()

    def _start_with_calls(self) -> None:
        """First every function stays one, and then those alone that are worth a call. A call that does not fit the
        known values of the others has the function in its place, so each step is right."""
        roots = {(root.name, root.types) for root in self._asked_for}
        self.specialized = {key: Specialization(*key, (None,) * len(key[1])) for key in self.module.functions
                            if key not in roots}
        self._evaluate_all()
        worth = {key: calls for key, calls in self._arguments().items() if key in self.specialized and len(calls) > 1}
        while len(worth) < len(self.specialized):
            now = {key: Specialization(*key, self._known(calls)) for key, calls in worth.items()}
            changed = {key for key, special in self.specialized.items() if now.get(key) != special}
            self.specialized = now
            self._done = {of: one for of, one in self._done.items() if not one.consulted & changed}
            self._evaluate_all()
            worth = {key: calls for key, calls in self._arguments().items()
                     if key in now and self._is_worth(now[key], len(calls))}

    def _keep(self, new: Sequence[Specialization]) -> bool:
        """Whether these stay functions: of several each has to be called as before, else the first one comes first."""
        before, special, done = self._arguments(), self.specialized, self._done
        keys = {(one.name, one.types) for one in new}
        self.specialized = {**special, **{(one.name, one.types): one for one in new}}
        self._done = {of: one for of, one in done.items() if not one.consulted & keys}
        self._evaluate_all()
        now = self._arguments()
        if len(new) == 1 or all(len(now.get(key, ())) == len(before[key]) and
                                self._known(now[key]) == self.specialized[key].known for key in keys):
            return True
        self.specialized, self._done = special, done
        return False

    def _evaluated(self, special: Specialization, is_root: bool = False) -> Evaluated:
        if (special, is_root) not in self._done:
            self._done[special, is_root] = self._evaluate(special, is_root)
        return self._done[special, is_root]

    def _evaluate(self, special: Specialization, is_root: bool) -> Evaluated:
        function = self.module.overload(special.name, special.types)
        consulted: set[Key] = set()

        def keeps(called: Function, arguments: Sequence[Node]) -> Specialization | None:
            key = called.name, called.types
            consulted.add(key)
            found = self.specialized.get(key)
            return found if found and found.left(arguments) is not None else None

        evaluation = Evaluation(self.module, keeps)
        parameters: list[Parameter] = []
        values: list[Typed] = []
        nodes: list[Node] = []  # of the arguments
        known = iter(special.known)
        for parameter in function.parameters:
            leaves = {path: Variable(type_, dotted((parameter.at.text, *path)), is_parameter=True)
                      for path, type_ in self.module.parts(parameter.type)}
            # Users pass the components of a vector where there are no vectors.
            for path, type_ in self.module.passed(parameter) if is_root else [((), parameter.type)]:
                of = next(known)
                if isinstance(of, Constant):
                    nodes.append(of)
                elif isinstance(of, int):
                    nodes.append(nodes[of])
                elif isinstance(of, Specialization):
                    inside = self._evaluate(of, is_root=False)  # afresh, since its variables get other names
                    consulted |= inside.consulted
                    taken = {one.at.text for one in (*function.parameters, *parameters)}
                    parameters += [_renamed(one, inside.nodes, taken) for one in inside.parameters]
                    evaluation.hints.update(inside.evaluation.hints)
                    evaluation.axes.update(inside.evaluation.axes)
                    nodes.append(inside.block[0].value)
                else:
                    name = self._named(function, parameter, path) if is_root else parameter.at.text
                    parameters.append(Parameter(parameter.at._replace(text=name), type_, parameter.is_set))
                    nodes.append(Variable(type_, name, is_parameter=True))
                if type_ in SIZES:
                    leaves |= {(*path, *rest): node for rest, node in self.module.leaves(nodes[-1]).items()}
            values.append(Typed(parameter.type, leaves))
        return Evaluated(function, evaluation, without_copies(without_dead(evaluation.run(function, values))),
                         parameters, consulted)

    def _named(self, function: Function, parameter: Parameter, path: tuple[str, ...]) -> str:
        """The arguments for a parameter. A position that is split is x, y and so on."""
        name = dotted((parameter.at.text, *path))
        taken = any(one.at.text in AXES for one in function.parameters)
        if not self.module.splits or parameter.at.text != "p" or taken:
            return name
        return path[0][1:] if path else AXES[0]

    def _all_passed(self, function: Function) -> Specialization:
        count = sum(len(self.module.passed(parameter)) for parameter in function.parameters)
        return Specialization(function.name, function.types, (None,) * count)

    def _called(self) -> dict[Specialization, Evaluated]:
        """The functions that are called, those that others need first."""
        found: dict[Specialization, Evaluated] = {}
        order: list[Specialization] = []

        def visit(evaluated: Evaluated) -> None:
            for special in evaluated.calls:
                if special not in found:
                    found[special] = self._evaluated(special)
                    visit(found[special])
                    order.append(special)

        for root in self.roots:
            visit(root)
        return {special: found[special] for special in order}

    # Which functions stay.

    def _all(self) -> list[Evaluated]:
        return [*self.roots, *self.called.values()]

    def _arguments(self) -> dict[Key, dict[tuple[Node, ...], None]]:
        """The arguments of all calls, each once, by the function."""
        found: dict[Key, dict[tuple[Node, ...], None]] = {}
        for one in self._all():
            for key, arguments in one.evaluation.arguments.items():
                found.setdefault(key, {}).update(dict.fromkeys(arguments))
        return found

    @staticmethod
    def _known(calls: Iterable[tuple[Node, ...]]) -> tuple[Known, ...]:
        columns = list(zip(*calls))
        return tuple(column[0] if isinstance(column[0], Constant) and len(set(column)) == 1
                     else columns.index(column) if columns.index(column) < i else None
                     for i, column in enumerate(columns))

    def _worth_a_call(self) -> list[Specialization]:
        """Long functions that are called more than once with other arguments: the longest, and those that follow by
        length as long as none calls another one, since each changes what those that call it are."""
        found: list[Specialization] = []
        roots = {(root.function.name, root.function.types) for root in self.roots}
        for key, calls in self._arguments().items():
            if len(calls) < 2 or key in self.specialized or key in roots:
                continue
            special = Specialization(*key, self._known(calls))
            if self._is_worth(special, len(calls)):
                found.append(special)
        found.sort(key=lambda special: -self._evaluated(special).size)
        for count in range(1, len(found)):
            # With those before it, and with those as long as it, since the order of these may change.
            others = [*found[:count], *(one for one in found if self._evaluated(one).size == self._evaluated(found[count]).size)]
            if any(self._calls(found[count], one) or self._calls(one, found[count]) for one in others):
                return found[:count]
        return found

    def _is_worth(self, special: Specialization, count: int) -> bool:
        """By the savings of all calls but one, less a head of a function and its calls, all in operations."""
        return (count - 1) * self._evaluated(special).size > 4 + count

    def _calls(self, special: Specialization, other: Specialization) -> bool:
        return (other.name, other.types) in self._evaluated(special).consulted

    def _joined(self) -> list[Specialization]:
        """A function that takes another one's result in all its calls, joined with the other."""
        uses: Counter[Node] = Counter()
        calls: dict[Specialization, list[Operation]] = {}
        made_here = (node for one in self._all() for node in one.nodes if isinstance(node, Operation))
        for node in sorted(made_here, key=lambda one: one.number):  # sets have no order
            uses.update(node.arguments)
            if _is_call(node):
                calls.setdefault(node.name, []).append(node)
        for special, made in calls.items():
            free = [i for i, known in enumerate(special.known) if known is None]
            if len(free) != len(made[0].arguments):
                continue  # it has one in it already
            for i, arguments in zip(free, zip(*(call.arguments for call in made))):
                other = arguments[0].name if _is_call(arguments[0]) else None
                if other and len(self.called[other].block) == 1 and len(calls[other]) == len(arguments) and all(
                        _is_call(one) and one.name == other and uses[one] == 1 for one in arguments):
                    known = (*special.known[:i], other, *special.known[i + 1:])
                    return [Specialization(special.name, special.types, known)]
        return []

    # Text.

    def text(self, language: Language, precise: bool = False, with_seedless: bool = False) -> str:
        """With overloads that lack the seed, if the language has overloads and the library has those."""
        functions = [text for _, text in self.pieces(language, precise)]
        if with_seedless and language.has_overloads:
            functions += [language.seedless(root.function) for root in self.roots if self.may_lack_seed(root.function)]
        constants = language.constants([root.function for root in self.roots], self.module)
        return "".join([language.opening, constants, *functions])

    def pieces(self, language: Language, precise: bool = False) -> Iterator[tuple[str, str]]:
        """Structs and functions, each behind its helpers. A name is the same in all languages of one program, and that
        of a function that is wanted is the one of its form."""
        def key(name: str, one: Evaluated) -> object:
            types = tuple(parameter.type for parameter in one.parameters)
            return (name, types) if language.has_overloads else name

        names = self.names([key(language.public_name(root.function), root) for root in self.roots], key=key)
        for name in self.structs() if language.structs else []:
            yield name, language.struct(name, self.module.structs[name].fields)
        for special, evaluated in self.called.items():
            yield f"{special.name} {' '.join(special.types)}", self._function(evaluated, names[special], language, names, precise)
        for root in self.roots:
            shown = language.public_name(root.function)
            yield wgsl_name(root.function), self._function(root, shown, language, names, precise)

    def may_lack_seed(self, function: Function) -> bool:
        """Whether GLSL has it without the seed behind its other parameters."""
        return function.types[-1:] == ("uint",) and self.module.overload(function.name, function.types[:-1]) is not None

    def names(self, taken: Iterable[object], named: Callable[[str], str] = str,
              key: Callable[[str, Evaluated], object] = lambda name, _: name) -> dict[Specialization, str]:
        """The names of the functions that are called. Overloads may differ in what is left out alone: the later has a
        number. A key distinguishes functions, and `taken` has those of others."""
        found: dict[Specialization, str] = {}
        known = {*taken}
        for special, evaluated in self.called.items():
            numbered = map(named, (special.name, *(f"{special.name}_{i}" for i in range(2, 100))))
            found[special] = next(name for name in numbered if key(name, evaluated) not in known)
            known.add(key(found[special], evaluated))
        return found

    def structs(self) -> list[str]:
        """The structs in parameters and results, with the structs inside, in the order of the library."""
        needed = {type_ for root in self.roots for type_ in (root.function.type, *root.function.types)}
        for name, struct in reversed(self.module.structs.items()):
            if name in needed:
                needed |= {type_ for _, type_, _ in struct.fields}
        return [name for name in self.module.structs if name in needed]

    def _function(self, evaluated: Evaluated, name: str, language: Language, names: dict[Specialization, str],
                  precise: bool) -> str:
        variables = (node for node in evaluated.nodes if isinstance(node, Variable))
        read = {variable.name.partition(".")[0] for variable in variables if variable.is_parameter}
        read |= {one.at.text for one in evaluated.parameters if one.type not in SIZES}
        head = language.head(evaluated.function.type, name, evaluated.parameters, read)
        lines = language.writer(evaluated.block, evaluated.evaluation.hints, evaluated.parameters, names,
                                precise).lines()
        if language.scope and any(map(_is_converted, evaluated.nodes)):
            lines = [f"  {language.scope}", *lines]
        if len(lines) == 1 and len(head) + len(lines[0]) < 100:
            return f"{head} {lines[0].strip()} }}\n"
        return "\n".join([*wrapped(head, 0), *lines, "}"]) + "\n"


def heading(program: Program, language: Language, command: str, library: Path, knobs: Settings,
            renamed: Callable[[str], str]) -> str:
    """The head: functions, arguments, results, errors, and the command that makes the text again."""
    lines: list[str] = []
    for root, of_function in zip(program.roots, facts(program, library, language.has_overloads, knobs)):
        function = root.function
        lines += [*textwrap.wrap(f" {language.signature(function)}", 118, subsequent_indent="     "),
                  *comments.lines(of_function, language.variable, language.example(function))]
    return "".join(f"//{line}\n" for line in (*map(renamed, lines), *origin(command)))


def origin(command: str) -> list[str]:
    return [*textwrap.wrap(f" Of hashnoise {version()}, by: {command}", 118, subsequent_indent="     ",
                           break_long_words=False, break_on_hyphens=False),
            " Copyright (c) 2026 The hashnoise authors; MIT License."]


def facts(program: Program, library: Path, may_lack_seed: bool, knobs: Settings) -> list[Facts]:
    """The library's comments on each function, as far as they are of these knobs."""
    return [of_noise(comments.facts(root.function, library, may_lack_seed, knobs),
                     program.module.summed if root.evaluation.sums_other_noise else None) for root in program.roots]


def of_noise(known: Facts, summed: FractalOver | None) -> Facts:
    """The facts of a sum, for one of another noise."""
    return known._replace(what=f"{known.what} The noise is {summed.name}. Ranges and errors are those with "
                          f"{summed.replaced}.") if summed else known


def _is_call(node: Node) -> bool:
    return isinstance(node, Operation) and node.kind == "call"


def _is_converted(node: Node) -> bool:
    """Whether it is a float that is made of integers."""
    return isinstance(node, Operation) and node.kind == "construct" and scalar_of(node.type) == "float" and any(
        scalar_of(argument.type) in ("int", "uint") for argument in node.arguments)


def _renamed(parameter: Parameter, nodes: set[Node], taken: set[str]) -> Parameter:
    """With a name that is free, here and in the values that read it."""
    old = parameter.at.text
    new = next(name for name in (old, *(f"{old}{i}" for i in range(2, 100))) if name not in taken)
    taken.add(new)
    for node in nodes:
        if isinstance(node, Variable) and node.is_parameter and node.name == old:
            node.name = new
    return Parameter(parameter.at._replace(text=new), parameter.type, parameter.is_set)
