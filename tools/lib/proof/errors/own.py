"""Searches for the errors of the functions in a GLSL file of a user's, for `tools/make errors FILE.glsl`.

Each of its functions with a position or a place, which no other function of it calls, is measured: the text over lanes of
floats that round otherwise, beside the same text in doubles. glslang reads the text, and spirv.py writes it as C++."""

from __future__ import annotations

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from base.twin import NotBuilt
from catalog.tables.functions import WORDS, Column
from proof.bounds.rounded import Body
from proof.errors.program import Found, Program, Stopped
from proof.errors.source import Bad, Function, Source, read
from proof.errors.spirv import Module, Refused, Writer

CELLS = ("-64", "64")  # in which positions are, unless others are given
SCALARS = ("float", "int", "uint", "bool")
SIZE = dict.fromkeys(SCALARS, 1) | {f"{kind}vec{size}": size for kind in ("", "i", "u") for size in (2, 3, 4)}
OUTPUTS = {"float": ("",), "vec2": tuple("xy"), "vec3": tuple("xyz"), "vec4": tuple("xyzw")}
LEAST, MOST, TOTAL = 4_000, 1_000_000, 60_000_000  # runs for a function; operations of all
TRIAL = 400  # runs
NEEDED = {"g++": "g++", "glslangValidator": "glslang-tools", "spirv-dis": "spirv-tools"}


# --- The functions that are measured ----------------------------------------------------------------------------------


def dims_of(function: Function) -> int:
    """The axes of a position or a place; 0 of a function that has none."""
    type_ = function.parameters[0].type if function.parameters and not function.parameters[0].way else ""
    found = re.fullmatch(r"vec([234])|(float)|hn_place([1-4])", type_)
    return int(found[1] or found[3] or 1) if found else 0


def chosen(functions: Sequence[Function], wanted: Sequence[str]) -> list[Function]:
    """The wanted functions, or those that no other calls; one that returns nothing, as main, calls none here."""
    if missing := {*wanted} - {one.name for one in functions}:
        raise Bad(f"--function {', '.join(sorted(missing))}: the file has no such function")
    called = {name for one in functions if one.type != "void" for name in one.calls if name != one.name}
    found = [one for one in functions if one.type in OUTPUTS and dims_of(one) > 0
             and (one.name in wanted or not wanted and one.name not in called)]
    if missing := {*wanted} - {one.name for one in found}:
        raise Bad(f"--function {', '.join(sorted(missing))}: it takes no position and no place, or returns no floats")
    return found


# --- The domain -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Measured:
    """A function with the numbers that the search draws for its arguments."""
    body: Body
    inputs: tuple[str, ...]  # of search.cpp
    kinds: tuple[tuple[str, str], ...]  # for each word the argument and its type


class Arguments:
    """The arguments of a function, as code and as the search draws them."""

    def __init__(self, function: Function, within: Mapping[str, str]):
        self.function, self.within = function, within
        self.words = iter(WORDS)
        self.inputs: list[str] = []
        self.kinds: list[tuple[str, str]] = []

    def measured(self, name: str) -> Measured:
        """By its name in C++."""
        made = []
        for number, parameter in enumerate(self.function.parameters):
            if parameter.way:
                raise Bad(f"{self.function.place}: {parameter.name} is an {parameter.way} parameter of a function that is measured")
            if number == 0 and parameter.type.startswith("hn_place"):
                made.append(self.place(parameter.name))
            elif parameter.type in SIZE:
                made.append(self.vector(parameter.type, parameter.name, number == 0))
            else:
                raise Bad(f"{self.function.place}: the search draws no {parameter.type}, as {parameter.name}")
        axes = OUTPUTS[self.function.type]
        results = [f"bits_of({f'n.{axis}' if axis else 'n'})" for axis in axes] + ["0u"] * (4 - len(axes))
        given = "".join(f"auto given{number} = {one}; " for number, one in enumerate(made))
        listed = ", ".join(f"given{number}" for number in range(len(made)))
        code = f"{given}auto n = File().{name}({listed}); return uvec4({', '.join(results)});"
        columns = tuple(Column(f"{of}_{i}", "f32" if kind == "float" else "u32") for i, (of, kind) in enumerate(self.kinds))
        return Measured(Body(columns, tuple(Column(axis or "value", "f64") for axis in axes), code),
                        (*self.inputs, "jumps"), tuple(self.kinds))

    def word(self, name: str, kind: str, input_: str) -> str:
        self.inputs.append(input_)
        self.kinds.append((name, kind))
        word = next(self.words, "")
        if not word:
            raise Bad(f"{self.function.place}: its arguments have more than 16 numbers")
        return {"float": f"float_of({word})", "int": f"int({word})", "uint": word, "bool": f"NotEqual({word}, Uint(0u))"}[kind]

    def ends(self, name: str, *usual: str) -> tuple[str, str] | tuple[()]:
        given = self.within.get(name)
        if given is None:
            return usual  # type: ignore[return-value]
        lo, _, hi = given.partition(":")
        return lo, hi or lo

    def vector(self, type_: str, name: str, is_position: bool) -> str:
        kind = type_ if type_ in SCALARS else {"v": "float", "i": "int", "u": "uint"}[type_[0]]
        usual = {"float": CELLS if is_position else ("0", "1"), "bool": ("0", "1")}.get(kind, ())
        ends = self.ends(name, *usual)
        if kind == "float":
            of_any_size = is_position and float(ends[0]) == -float(ends[1])
            drawn = f"{'position' if of_any_size else 'float'}:{':'.join(ends)}"
        else:
            drawn = f"word:{':'.join(ends)}" if ends else "any"
        parts = [self.word(name, kind, drawn) for _ in range(SIZE[type_])]
        return parts[0] if type_ in SCALARS else f"{type_}({', '.join(parts)})"

    def place(self, name: str) -> str:
        size = dims_of(self.function)
        lo, hi = (int(float(end)) for end in self.ends(name, *CELLS))
        cells = [self.word(name, "int", f"word:{lo}:{max(hi - 1, lo)}") for _ in range(size)]
        fractions = [self.word(name, "float", "fraction:0:0.99999994") for _ in range(size)]
        if size == 1:
            return f"hn_place({cells[0]}, {fractions[0]})"
        return f"hn_place(ivec{size}({', '.join(cells)}), vec{size}({', '.join(fractions)}))"


def check(within: Mapping[str, str], functions: Sequence[Function]) -> None:
    names = {parameter.name for one in functions for parameter in one.parameters}
    for name, ends in within.items():
        lo, _, hi = ends.partition(":")
        try:
            if float(lo) > float(hi or lo):
                raise Bad(f"--within {name}={ends}: the first number is greater than the second")
        except ValueError:
            raise Bad(f"--within {name}={ends}: write NAME=LO:HI") from None
        if name not in names and not any(one.refused for one in functions):
            raise Bad(f"--within {name}: no function that is measured has such an argument")


# --- The program ------------------------------------------------------------------------------------------------------

OF_THE_FILE = "main_of_the_file"
LINES = (f"#version 460\n#extension GL_GOOGLE_cpp_style_line_directive : require\n#define main {OF_THE_FILE}\n"
         "#define varying in\n#define attribute in\n")  # as GLSL ES 1.00 has them
MAIN = "\n#undef main\nvoid main() {}\n"  # in which glslang sets variables of the file
# A function of a fragment shader may take derivatives and pictures, which spirv.py refuses by their names.
GLSLANG = ("glslangValidator", "-V", "-R", "--aml", "--amb", "-g", "--keep-uncalled", "-S", "frag", "-o", "text.spv", "text.frag")


def module_of(source: Source, functions: Sequence[Function]) -> Module:
    """Without the functions that glslang refuses, whose reasons are set."""
    while True:
        with tempfile.TemporaryDirectory() as folder:
            text = source.without(one for one in functions if one.refused)
            Path(folder, "text.frag").write_text(f"{LINES}{text}{MAIN}", encoding="utf-8")
            done = subprocess.run(GLSLANG, cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode == 0:
                return Module(subprocess.run(["spirv-dis", "--raw-id", "text.spv"], cwd=folder, capture_output=True, text=True,
                                             check=True).stdout)
        if recursive := [one for name in re.findall(r" calling (\w+)\(", done.stdout) for one in functions if one.name == name]:
            for one in recursive:
                one.refused = f"{one.place}: {one.name} calls itself"
            continue
        error = re.search(r"^ERROR: (.*:\d+): (?:'(.*?)' : )?(.*)", done.stdout, re.MULTILINE)
        if not error:
            raise Bad(f"glslangValidator: {done.stdout}{done.stderr}")
        place, name = error[1], error[2]
        reason = re.sub(r"' *(?:(?:const|temp|global|highp) +)*(\w+)'", r"'\1'", error[3]).strip()
        of = next((one for one in functions if not one.refused and source.has(one, place)), None)
        if not of:
            raise Bad(f"{place}: {name or ''}{': ' * bool(name)}{reason}")
        callee = next((one for one in functions if one.refused and one.name == name), None)
        of.refused = callee.refused if callee else f"{place}: {name or ''}{': ' * bool(name)}{reason}"


def written(module: Module, functions: Sequence[Function]) -> tuple[str, dict[str, str]]:
    """The text in C++, and the names there of the functions. Functions that cannot be written, and their callers,
    are refused."""
    of_file = {one.id: one for one in module.functions if not one.is_of_library}
    heads = {}
    for name in {one.name for one in functions}:
        heads |= dict(zip((one.id for one in of_file.values() if one.name == (OF_THE_FILE if name == "main" else name)),
                          (one for one in functions if one.name == name and not one.refused)))
    texts, reasons = {}, {}
    for id, one in sorted(of_file.items(), key=lambda item: item[1].name != "main"):
        if id in heads:
            heads[id].calls = {module.names[called].split("(")[0] for called in one.calls}
        try:
            texts[id] = Writer(module, one).text()
        except Refused as error:
            if one.name == "main":
                module.refused = str(error)
            else:
                reasons[id] = str(error)
    while new := {id: reasons[called] for id, one in of_file.items() if id not in reasons for called in one.calls if called in reasons}:
        reasons |= new
    for id in reasons.keys() & heads.keys():
        heads[id].refused = reasons[id]
    return module.written("".join(text for id, text in texts.items() if id not in reasons)), {
        head.id: f"f{id[1:]}" for id, head in heads.items()}


def compiled(source: Source, functions: Sequence[Function], wanted: Sequence[str], within: Mapping[str, str], macros: Sequence[str]
             ) -> tuple[list[Function], Program | None, dict[str, Measured]]:
    """The functions that are measured, with their arguments by their ids."""
    text, names = written(module_of(source, functions), functions)
    found, measured = chosen(functions, wanted), {}
    if found:
        check(within, found)
    for one in found:
        try:
            if not one.refused:
                measured[one.id] = Arguments(one, within).measured(names[one.id])
        except Bad as error:
            one.refused = str(error)
    if not measured:
        return found, None, {}
    try:
        return found, Program({id: one.body for id, one in measured.items()}, "ERRORS_OWN", *macros, text=text), measured
    except NotBuilt as error:
        raise Bad(str(error)) from None


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
    """The errors of a function's outputs, with the count of random places."""
    function: Function
    measured: Measured | None = None
    places: int = 0
    found: tuple[Found, ...] = ()
    program: Program | None = None


def searched(program: Program, function: Function, measured: Measured, count: int) -> Result:
    try:
        effort = effort_of(program, function.id, measured, count)
        found = program.search(function.id, measured.inputs, outputs_of(measured), effort)
    except Stopped as reason:
        function.refused = f"{function.place}: {reason}"
        return Result(function)
    return Result(function, measured, effort // 2, tuple(found), program)


def results(path: Path, wanted: Sequence[str], within: Mapping[str, str], *more: str) -> list[Result]:
    """In the order of the file; with more macros."""
    source = read(path)
    functions = list(source.functions())
    found, program, measured = compiled(source, functions, wanted, within, [*source.macros, *more])
    if not found:
        raise Bad(f"{path}: no function takes a position or a place, and returns floats")

    def one(function: Function) -> Result:
        if program is None or function.id not in measured:
            return Result(function)
        return searched(program, function, measured[function.id], len(measured))

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(one, found))


def shown(error: float) -> str:
    return re.sub(r"e([-+])0", r"e\1", f"{error:.2g}").replace("e+", "e")


def print_result(result: Result) -> None:
    print(f"{result.function.place}: {result.function.head}")
    if not result.measured:
        print(f"  refused: {result.function.refused}")
        return
    for column, one in zip(result.measured.body.outputs, result.found):
        at = f" at {place_of(result.measured, one.words)}" if one.error else ""
        print(f"  {column.name:7} error {shown(one.error)}{at}; values in [{one.least:.4g}, {one.most:.4g}]")
    print(f"  {'':7} the largest of 16 roundings at {result.places:,} places, and of a climb from the worst")


def report(path: Path, wanted: Sequence[str], within: Mapping[str, str]) -> int:
    """The exit status."""
    if missing := [package for program, package in NEEDED.items() if not shutil.which(program)]:
        print(f"tools/make errors FILE.glsl needs Debian's packages {', '.join(missing)}", file=sys.stderr)
        return 4
    try:
        found = results(path, wanted, within)
    except Bad as error:
        print(error, file=sys.stderr)
        return 2
    for result in found:
        print_result(result)
    print("Errors are beside the same text in doubles. A search finds no bound: an error may be larger elsewhere.")
    return int(any(result.function.refused for result in found))
