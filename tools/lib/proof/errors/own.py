"""Searches for the errors of the functions in a GLSL file of a user's, for `tools/make errors FILE.glsl`.

Each of its functions with a position or a place, which no other function of it calls, is measured: the text over lanes of
floats that round otherwise, beside the same text in doubles."""

from __future__ import annotations

import os
import re
import struct
import sys
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from base.twin import NotBuilt
from catalog.tables.functions import WORDS, Column
from proof.bounds.rounded import Body
from proof.errors.cpp import Refused
from proof.errors.file import Item, Reader
from proof.errors.glsl import Bad, read
from proof.errors.names import SCALARS, TYPES, VECTORS
from proof.errors.program import Found, Program, Stopped

CELLS = ("-64", "64")  # in which positions are, unless others are given
SIZE = {TYPES[name]: size for name, size in (SCALARS | VECTORS).items()}
KINDS = {TYPES[name]: name for name in SCALARS}
OUTPUTS = {"Float": ("",), "vec2": tuple("xy"), "vec3": tuple("xyz"), "vec4": tuple("xyzw")}
LEAST, MOST, TOTAL = 4_000, 1_000_000, 60_000_000  # runs for a function; operations of all
TRIAL = 400  # runs


# --- The functions that are measured ----------------------------------------------------------------------------------


def dims_of(item: Item) -> int:
    """The axes of a position or a place; 0 of a function that has none."""
    type_ = item.parameters[0].type if item.parameters and not item.parameters[0].way else ""
    found = re.fullmatch(r"vec([234])|(Float)|hn_place([1-4])", type_)
    return int(found[1] or found[3] or 1) if found else 0


def has_place(item: Item) -> bool:
    return item.parameters[0].type.startswith("hn_place")


def could_be_measured(item: Item) -> bool:
    return item.is_function and item.type in OUTPUTS and (dims_of(item) > 0 or bool(item.refused and not item.parameters))


def chosen(items: Sequence[Item], wanted: Sequence[str]) -> list[Item]:
    """The wanted functions, or those that no other calls; one that returns nothing, as main, calls none here."""
    functions = [item for item in items if item.is_function]
    if missing := {*wanted} - {item.name for item in functions}:
        raise Bad(f"--function {', '.join(sorted(missing))}: the file has no such function")
    called = {name for item in functions if item.type != "void" for name in item.calls if name != item.name}
    found = [item for item in functions if could_be_measured(item)
             and (item.name in wanted or not wanted and item.name not in called)]
    if missing := {*wanted} - {item.name for item in found}:
        raise Bad(f"--function {', '.join(sorted(missing))}: it takes no position and no place, or returns no floats")
    return found


# --- The domain -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Measured:
    """A function with the numbers that the search draws for its arguments."""
    item: Item
    body: Body
    inputs: tuple[str, ...]  # of search.cpp
    kinds: tuple[tuple[str, str], ...]  # for each word the argument and its type


class Arguments:
    """The arguments of a function, as code and as the search draws them."""

    def __init__(self, item: Item, within: Mapping[str, str]):
        self.item, self.within = item, within
        self.words = iter(WORDS)
        self.inputs: list[str] = []
        self.kinds: list[tuple[str, str]] = []

    def measured(self) -> Measured:
        made = []
        for number, parameter in enumerate(self.item.parameters):
            if parameter.way:
                raise Bad(f"{self.item.token.place}: {parameter.name} is an {parameter.way} parameter of a function that is measured")
            if number == 0 and has_place(self.item):
                made.append(self.place(parameter.name))
            elif parameter.type in SIZE:
                made.append(self.vector(parameter.type, parameter.name, number == 0))
            else:
                type_ = re.sub(r"\bu_", "", parameter.type)
                raise Bad(f"{self.item.token.place}: the search draws no {type_}, as {parameter.name}")
        member = [f"n.{axis}" if axis else "n" for axis in OUTPUTS[self.item.type]]
        results = [f"bits_of({one})" for one in member] + ["0u"] * (4 - len(member))
        code = f"auto n = File().u_{self.item.name}({', '.join(made)}); return uvec4({', '.join(results)});"
        columns = tuple(Column(f"{name}_{i}", "f32" if kind == "float" else "u32") for i, (name, kind) in enumerate(self.kinds))
        outputs = tuple(Column(axis or "value", "f64") for axis in OUTPUTS[self.item.type])
        return Measured(self.item, Body(columns, outputs, code), (*self.inputs, "jumps"), tuple(self.kinds))

    def word(self, name: str, kind: str, input_: str) -> str:
        self.inputs.append(input_)
        self.kinds.append((name, kind))
        word = next(self.words, "")
        if not word:
            raise Bad(f"{self.item.token.place}: its arguments have more than 16 numbers")
        return {"float": f"float_of({word})", "int": f"int({word})", "uint": word, "bool": f"own_bool({word})"}[kind]

    def ends(self, name: str, *usual: str) -> tuple[str, str] | tuple[()]:
        given = self.within.get(name)
        if given is None:
            return usual  # type: ignore[return-value]
        lo, _, hi = given.partition(":")
        return lo, hi or lo

    def vector(self, type_: str, name: str, is_position: bool) -> str:
        kind = KINDS.get(type_) or {"v": "float", "i": "int", "u": "uint"}[type_[0]]
        usual = {"float": CELLS if is_position else ("0", "1"), "bool": ("0", "1")}.get(kind, ())
        ends = self.ends(name, *usual)
        if kind == "float":
            of_any_size = is_position and float(ends[0]) == -float(ends[1])
            drawn = f"{'position' if of_any_size else 'float'}:{':'.join(ends)}"
        else:
            drawn = f"word:{':'.join(ends)}" if ends else "any"
        parts = [self.word(name, kind, drawn) for _ in range(SIZE[type_])]
        return parts[0] if type_ in KINDS else f"{type_}({', '.join(parts)})"

    def place(self, name: str) -> str:
        size = dims_of(self.item)
        lo, hi = (int(float(end)) for end in self.ends(name, *CELLS))
        cells = [self.word(name, "int", f"word:{lo}:{max(hi - 1, lo)}") for _ in range(size)]
        fractions = [self.word(name, "float", "fraction:0:0.99999994") for _ in range(size)]
        if size == 1:
            return f"hn_place({cells[0]}, {fractions[0]})"
        return f"hn_place(ivec{size}({', '.join(cells)}), vec{size}({', '.join(fractions)}))"


def check(within: Mapping[str, str], items: Sequence[Item]) -> None:
    names = {parameter.name for item in items for parameter in item.parameters}
    for name, ends in within.items():
        lo, _, hi = ends.partition(":")
        try:
            if float(lo) > float(hi or lo):
                raise Bad(f"--within {name}={ends}: the first number is greater than the second")
        except ValueError:
            raise Bad(f"--within {name}={ends}: write NAME=LO:HI") from None
        if name not in names and not any(item.refused for item in items):
            raise Bad(f"--within {name}: no function that is measured has such an argument")


# --- The program ------------------------------------------------------------------------------------------------------


def text_of(items: Sequence[Item]) -> str:
    """As C++. The number of an item is in the name of its file, by which a compiler's error finds it."""
    overloaded = {item.name for item in items if item.is_function and item.refused}
    lines = []
    for number, item in enumerate(items):
        if not item.refused:
            lines.append(f'#line {item.token.line} "own:{number}:{item.token.path}"\n{item.code}\n')
        elif item.name in overloaded and item.type and item.parameters:
            listed = ", ".join(f"{one.type}{'&' * bool(one.way)}" for one in item.parameters)
            lines.append(f'#line {item.token.line} "own:{number}:{item.token.path}"\n'
                         f"{item.type} u_{item.name}({listed}) = delete;\n")
    return "".join(lines)


def refuse_callers(items: Sequence[Item]) -> None:
    """Refuses functions that use a refused name. For those with overloads the compiler knows who calls which."""
    functions = [item.name for item in items if item.is_function]
    for _ in items:
        reasons = {name: item for item in items if item.refused for name in item.names if functions.count(name) < 2}
        new = [(item, reasons[name]) for item in items if not item.refused for name in sorted(item.words) if name in reasons]
        for item, of in new:
            item.refused = item.refused or of.refused
        if not new:
            return


def errors_of(output: str) -> dict[int, str]:
    """By their items: the first error of each, in the words of GLSL. The place is in the line of the error, or in one
    beside it: "required from", "in expansion of"."""
    found: dict[int, str] = {}
    before, said = None, ""
    for line in output.splitlines():
        place = re.match(r"own:(\d+):(.*?:\d+):\d+: ", line)
        error = re.search(r": (?:fatal )?error: (.*)", line)
        if error:
            said = in_glsl(error[1])
            place = place or before
        if place and said:
            found.setdefault(int(place[1]), f"{place[2]}: {said}")
            said = ""
        before = None if error else place or before
    return found


def in_glsl(said: str) -> str:
    said = re.sub(r"hashnoise::|\{anonymous\}::|v\d+_\d+::|\b(?:own|rounded)::|\{aka .*?\}\}?|&(?=[,)])|\bFile::", "", said)
    said = re.sub(r"\b(?:u|own)_(?=\w)", "", said)
    for cpp, glsl in (("Lanes<float>", "float"), ("Lanes<int>", "int"), ("Lanes<unsigned int>", "uint"), ("Float", "float"),
                      ("Int", "int"), ("Uint", "uint"), ("Rounded", "float")):
        said = re.sub(rf"\b{cpp}(?!\w)", glsl, said)
    said = re.sub(r"Vector(\d)<float>", r"vec\1", said)
    return re.sub(r" +", " ", said).replace(" ’", "’").split(";")[0]


def compiled(items: Sequence[Item], macros: Sequence[str], wanted: Sequence[Item],
             within: Mapping[str, str]) -> tuple[Program | None, dict[int, Measured]]:
    """Without the functions that a compiler refuses, and those that call one; by the numbers of the items."""
    for number, item in enumerate(items):
        item.number = number
    while True:
        refuse_callers(items)
        measured = {}
        for item in wanted:
            try:
                if not item.refused:
                    measured[item.number] = Arguments(item, within).measured()
            except Bad as error:
                item.refused = str(error)
        if not measured:
            return None, {}
        bodies = {str(number): one.body for number, one in measured.items()}
        try:
            return Program(bodies, "ERRORS_OWN", *macros, text=text_of(items)), measured
        except NotBuilt as error:
            found = errors_of(str(error))
            if not found:
                raise Bad(str(error)) from None
            for number, reason in found.items():
                items[number].refused = items[number].refused or reason


# --- For a reader -----------------------------------------------------------------------------------------------------


def shown_word(word: int, kind: str) -> str:
    if kind == "float":
        number = struct.unpack("f", struct.pack("I", word))[0]
        return next(text for digits in range(1, 10)
                    if struct.pack("f", float(text := f"{number:.{digits}g}")) == struct.pack("f", number))
    if kind == "bool":
        return "true" if word else "false"
    return str(word - 2**32 if kind == "int" and word >= 2**31 else word)


def place_of(measured: Measured, words: Sequence[int]) -> str:
    """p=(28.68, 46.72), seed=7."""
    parts: dict[tuple[str, str], list[str]] = {}
    for kind, word in zip(measured.kinds, words):
        parts.setdefault(kind, []).append(shown_word(word, kind[1]))
    shown: dict[str, str] = {}
    for (name, _), of in parts.items():
        vector = of[0] if len(of) == 1 else f"({', '.join(of)})"
        shown[name] = f"{shown[name]} + {vector}" if name in shown else vector  # a cell, and the position in it
    return ", ".join(f"{name}={value}" for name, value in shown.items())


def effort_of(program: Program, id: str, measured: Measured, count: int) -> int:
    """The runs of a function: about as long for each of them."""
    outputs = outputs_of(measured)
    operations = program.operations(id, measured.inputs, outputs, TRIAL)
    return min(max(TOTAL // count // (operations + 20), LEAST), MOST)


def outputs_of(measured: Measured) -> list[str]:
    return [f"{i}:inf:one" for i, _ in enumerate(measured.body.outputs)]


@dataclass(frozen=True)
class Result:
    """The errors of a function's outputs, with the count of random places, or why it is refused."""
    item: Item
    refused: str = ""
    measured: Measured | None = None
    places: int = 0
    found: tuple[Found, ...] = ()
    program: Program | None = None


def searched(program: Program, measured: Measured, count: int) -> Result:
    id = str(measured.item.number)
    try:
        effort = effort_of(program, id, measured, count)
        found = program.search(id, measured.inputs, outputs_of(measured), effort)
    except Stopped as reason:
        return Result(measured.item, f"{measured.item.token.place}: {reason}")
    return Result(measured.item, "", measured, effort // 2, tuple(found), program)


def results(path: Path, wanted: Sequence[str], within: Mapping[str, str], *more: str) -> list[Result]:
    """In the order of the file; with more macros."""
    source = read(path)
    items = Reader(source.tokens).read()
    functions = chosen(items, wanted)
    if not functions:
        raise Bad(f"{path}: no function takes a position or a place, and returns floats")
    check(within, functions)
    program, measured = compiled(items, [*source.macros, *more], functions, within)

    def one(item: Item) -> Result:
        if program is None or item.number not in measured:
            return Result(item, item.refused)
        return searched(program, measured[item.number], len(measured))

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(one, functions))


def shown(error: float) -> str:
    return re.sub(r"e([-+])0", r"e\1", f"{error:.2g}").replace("e+", "e")


def print_result(result: Result) -> None:
    print(f"{result.item.token.place}: {result.item.head}")
    if not result.measured:
        print(f"  refused: {result.refused}")
        return
    for column, one in zip(result.measured.body.outputs, result.found):
        at = f" at {place_of(result.measured, one.words)}" if one.error else ""
        print(f"  {column.name:7} error {shown(one.error)}{at}; values in [{one.least:.4g}, {one.most:.4g}]")
    print(f"  {'':7} the largest of 16 roundings at {result.places:,} places, and of a climb from the worst")


def report(path: Path, wanted: Sequence[str], within: Mapping[str, str]) -> int:
    """The exit status."""
    try:
        found = results(path, wanted, within)
    except (Bad, Refused) as error:  # the second of a bracket that does not close
        print(error, file=sys.stderr)
        return 2
    for result in found:
        print_result(result)
    print("Errors are beside the same text in doubles. A search finds no bound: an error may be larger elsewhere.")
    return int(any(result.refused for result in found))
