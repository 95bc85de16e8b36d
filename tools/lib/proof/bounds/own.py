"""Bounds of functions in a GLSL file of one's own, for `tools/make bounds FILE.glsl`.

The file is GLSL that may include files of the library. Its functions with a position or a place, which no other function
of it calls, are proven: their floats beside the same text in exact arithmetic."""

from __future__ import annotations

import contextlib
import math
import re
import subprocess
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from base.twin import NotBuilt
from catalog.tables.functions import WORDS, Column
from proof.bounds.answers import Sums
from proof.bounds.floats import position_error
from proof.bounds.prover import Job, Proven, Prover
from proof.bounds.rounded import Body
from proof.bounds.table import scientific
from translate.parsing.tokens import NUMBER, SIGN, WORD

SECONDS = 30  # for a result
MEASURES = {"error": 0.003, "least": 1e-4, "most": 1e-4, "slope": 0.01}  # with their tolerances
CELLS = "-64:64"  # in which positions are, unless others are given
OPTIONS = ("-g", "-fno-optimize-sibling-calls", "-no-pie", "-fmax-errors=1", "-fdiagnostics-color=never")
MACROS = ("PROVER_OWN", "PROVER_TRACE")

# --- The text ---------------------------------------------------------------------------------------------------------

TOKEN = re.compile(rf"(?P<blank>\s+|//[^\n]*|/\*.*?\*/)|(?P<directive>^[ \t]*#(?:[^\n\\]|\\\n|\\.)*)"
                   rf"|(?P<number>{NUMBER})|(?P<other>{WORD}|{SIGN}|.)", re.DOTALL | re.MULTILINE)
DROPPED = {"highp", "mediump", "lowp", "precise", "invariant", "in"}
CLOSING = {"(": ")", "[": "]", "{": "}"}
BEFORE_EXPRESSION = {"return", ",", ";", "{", "}", "?", ":", "=", "+=", "-=", "*=", "/=", "&=", "|=", "^="}
SETS = ("xyzw", "rgba", "stpq")


class Bad(Exception):
    """A file that is no GLSL, or a request that does not fit it."""


def tokens_of(text: str) -> list[str]:
    found = []
    for match in TOKEN.finditer(text):
        if match.lastgroup == "blank":
            found.append("\n" * match[0].count("\n") or " ")
        elif match.lastgroup == "number" and re.match(r"(?!0[xX]).*[.eE]", match[0]):
            found.append(f"{match[0].rstrip('fF')}_f")
        elif match.lastgroup == "number":
            found.append(f"{'Uint' if match[0][-1] in 'uU' else 'Int'}({match[0]})")
        else:
            directive = match[0].split()[0] if match.lastgroup == "directive" else ""
            found.append("" if directive in ("#version", "#extension", "#pragma") else match[0])
    return found


def is_blank(token: str) -> bool:
    return not token.strip()


def end_of_group(tokens: Sequence[str], start: int) -> int:
    """Where the bracket at start closes."""
    depth = 0
    for at in range(start, len(tokens)):
        depth += tokens[at] in CLOSING
        depth -= tokens[at] in CLOSING.values()
        if depth == 0:
            return at
    raise Bad(f"a {tokens[start]} has no {CLOSING[tokens[start]]}")


def start_of_operand(out: Sequence[str]) -> int:
    """Where the operand that ends there begins, as "f(x).y" or "v[2]"."""
    at = len(out) - 1
    while True:
        depth = 0
        while at >= 0:
            depth += out[at] in CLOSING.values()
            depth -= out[at] in CLOSING
            if depth == 0 and not is_blank(out[at]):
                break
            at -= 1
        if out[at] in ("(", "[") and at > 0 and re.fullmatch(r"\w+|[\])]", out[at - 1]):
            at -= 1  # a function or an array
        elif at > 1 and out[at - 1] == ".":
            at -= 2
        else:
            return at


def plain(tokens: Sequence[str]) -> list[str]:
    """The text in C++, which has no qualifiers, no swizzles, and no ?: of numbers that a hash makes."""
    out: list[str] = []
    at, start = 0, 0  # of the expression
    while at < len(tokens):
        token = tokens[at]
        if token in ("(", "["):
            end = end_of_group(tokens, at)
            inside = plain(tokens[at + 1:end])
            is_element = token == "[" and not re.fullmatch(r"\s*Int\(\d+\)\s*", "".join(inside))
            if token == "[":
                inside = ["element", "(", *inside, ")"] if is_element else re.findall(r"\d+", inside[0])
            out += [token, *inside, CLOSING[token]]
            at = end
        elif token == "?":
            yes, no, end = parts_of_choice(tokens, at)
            condition = out[start:]
            del out[start:]
            out += [" choice(", *condition, ", [&] { return ", *plain(yes), "; }, [&] { return ", *plain(no), "; })"]
            at = end - 1
        elif token in ("out", "inout"):
            at = next(i for i in range(at + 1, len(tokens)) if not is_blank(tokens[i]))
            out += [tokens[at], "&"]
        elif token == "precision":
            at = tokens.index(";", at)
        elif axes := swizzle(tokens, at, out):
            operand = start_of_operand(out[:-1])
            of = out[operand:-1]
            del out[operand:]
            out += [f"swizzled<{', '.join(map(str, axes))}>", "(", *of, ")"]
        elif token not in DROPPED:
            out.append(token)
            start = len(out) if token in BEFORE_EXPRESSION else start
        at += 1
    return out


def swizzle(tokens: Sequence[str], at: int, out: Sequence[str]) -> list[int]:
    """The axes of .xy and the like."""
    if not out or out[-1] != "." or len(tokens[at]) not in (2, 3, 4):
        return []
    return next(([axes.index(letter) for letter in tokens[at]] for axes in SETS if {*tokens[at]} <= {*axes}), [])


def parts_of_choice(tokens: Sequence[str], at: int) -> tuple[Sequence[str], Sequence[str], int]:
    """Both sides of a ?, and where it ends."""
    colon, nested, here = 0, 0, at + 1
    while here < len(tokens):
        token = tokens[here]
        if token in CLOSING:
            here = end_of_group(tokens, here)
        elif token == "?":
            nested += 1
        elif token == ":" and nested:
            nested -= 1
        elif token == ":" and not colon:
            colon = here
        elif token in (",", ";", ")", ":"):
            break
        here += 1
    if not colon:
        raise Bad("a ? has no :")
    return tokens[at + 1:colon], tokens[colon + 1:here], here


def transformed(path: Path) -> str:
    """The file as C++, with the files that it includes from beside it."""
    lines = [f'#line 1 "{path}"\n']
    for token in plain(tokens_of(path.read_text(encoding="utf-8"))):
        included = re.match(r'\s*#\s*include\s*[<"]([^">]+)[">]', token)
        beside = path.parent / included[1] if included else path
        if included and beside.is_file():
            lines.append(f'{transformed(beside)}\n#line {"".join(lines).count(chr(10))} "{path}"')
        elif included:
            lines.append(f'#include "{included[1].removeprefix("hashnoise/")}"')
        else:
            lines.append(token)
    return "".join(lines) + "\n"


# --- Functions --------------------------------------------------------------------------------------------------------

HEAD = re.compile(r"(?:^|[;}\n])\s*(?:HN_FN\s+)?(\w+)\s+(\w+)\s*\(([^(){};]*)\)\s*\{", re.DOTALL)
SIZE = {"float": 1, "int": 1, "uint": 1} | {f"{kind}vec{n}": n for kind in ("", "i", "u") for n in (2, 3, 4)}
OUTPUTS = {"float": ("",)} | {f"vec{n}": tuple("xyzw"[:n]) for n in (2, 3, 4)} | {
    f"derivatives{n}": ("value", *(f"derivative.{axis}" for axis in "xyz"[:n])) for n in (2, 3)}


@dataclass(frozen=True)
class Own:
    """A function of the file."""
    type: str
    name: str
    parameters: tuple[tuple[str, str], ...]  # a type and a name
    line: int

    @property
    def dims(self) -> int:
        """The axes of its position or place; 0 if it has none."""
        found = re.match(r"(?:vec|place)([1-4])|(float)", self.parameters[0][0] if self.parameters else "")
        return int(found[1] or 1) if found else 0

    @property
    def has_place(self) -> bool:
        return "place" in self.parameters[0][0]

    def __str__(self) -> str:
        return f"{self.type} {self.name}({', '.join(' '.join(one) for one in self.parameters)})"


def functions_of(text: str, wanted: Sequence[str]) -> list[Own]:
    """The functions with a position or a place: the wanted ones, or all that no other function calls."""
    found, bodies = [], []
    for match in HEAD.finditer(text):
        split = [tuple(one.removeprefix("hn_") for one in parameter.split()[-2:])
                 for parameter in match[3].split(",") if parameter.strip() not in ("", "void")]
        found.append(Own(match[1].removeprefix("hn_"), match[2], tuple(split), text.count("\n", 0, match.start(2)) + 1))
        rest = re.findall(r"[{}]|[^{}]+", text[match.end() - 1:])
        bodies.append((match[2], "".join(rest[:end_of_group(rest, 0)])))
    if missing := {*wanted} - {one.name for one in found}:
        raise Bad(f"--function {', '.join(sorted(missing))}: the file has no such function")
    called = {one.name for one in found for name, body in bodies if name != one.name and f"{one.name}(" in body}
    return [one for one in found if one.dims and one.type in OUTPUTS
            and (one.name in wanted or not wanted and one.name not in called)]


def body_and_arguments(function: Own, within: Mapping[str, str]) -> tuple[Body, dict[str, str]]:
    words, made, inputs, arguments = iter(WORDS), [], [], {}
    for number, (type_, name) in enumerate(function.parameters):
        size = function.dims if number == 0 else SIZE.get(type_, 0)
        if not size:
            raise Bad(f"{function}: {type_} {name} is no number and no vector")
        kind, vector = {"i": ("int", "i"), "u": ("uint", "u")}.get(type_[0], ("float", ""))
        parts = {"cell": [f"int({next(words)})" for _ in range(size)]} if number == 0 and function.has_place else {}
        inputs += [Column(f"cell {axis}", "i32") for axis, _ in enumerate(parts.get("cell", ()))]
        parts[name] = []
        for axis in range(size):
            column = Column(f"{name} {axis}", "f32" if kind == "float" else "u32")
            inputs.append(column)
            parts[name].append(f"{kind}_of({next(words)})" if kind == "float" else f"{kind}({next(words)})")
            ends = within.get(name, ("0:1" if function.has_place else CELLS) if number == 0 else "0:1" if kind == "float" else "")
            if ends:
                shape = "position" if number == 0 and not function.has_place else "box"
                arguments[column.name] = f"{shape}:{ends}" if ":" in ends else f"{'float' if kind == 'float' else 'word'}:{ends}"
        vectors = [of[0] if size == 1 else f"{'i' if one == 'cell' else vector}vec{size}({', '.join(of)})"
                   for one, of in parts.items()]
        made.append(f"hn_place({', '.join(vectors)})" if len(vectors) == 2 else vectors[0])
    results = [f"bits_of(n{'.' * bool(member)}{member})" for member in OUTPUTS[function.type]]
    results += ["0u"] * (4 - len(results))
    code = f"auto n = own::{function.name}({', '.join(made)}); return uvec4({', '.join(results)});"
    return Body(tuple(inputs), tuple(Column(name, "f64") for name in OUTPUTS[function.type]), code), arguments


# --- Proofs -----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Result:
    function: Own
    output: str
    proven: Mapping[str, Proven]  # by their measures, the error first


def prove(path: Path, wanted: Sequence[str], within: Mapping[str, str]) -> tuple[list[Result], Prover]:
    functions = functions_of("".join(tokens_of(path.read_text(encoding="utf-8"))), wanted)
    if not functions:
        raise Bad(f"{path}: no function takes a position or a place, and returns floats")
    made = {str(function): (function, *body_and_arguments(function, within)) for function in functions}
    try:
        prover = Prover({id: body for id, (_, body, _) in made.items()}, *MACROS, text=transformed(path),
                        options=(*OPTIONS, f"-I{path.parent}"))
    except NotBuilt as error:
        raise Bad(first_error(str(error))) from None

    def bounds(one: tuple[str, str]) -> Result:
        id, output = one
        job = Job(id, (output,), made[id][2], most=10**9, seconds=SECONDS / len(MEASURES))
        found = {}
        for measure, tolerance in MEASURES.items():
            found[measure], = prover.prove([replace(job, measure=measure, tolerance=tolerance)])
            if found[measure].problem:
                break
        return Result(made[id][0], output, found)

    with ThreadPoolExecutor() as pool:
        return list(pool.map(bounds, [(id, output.name) for id, (_, body, _) in made.items() for output in body.outputs])), prover


def first_error(output: str) -> str:
    """The compiler's, in the words of GLSL."""
    found = re.search(r"^(\S+:\d+):\d+: (?:fatal )?error: (.*)", output, re.MULTILINE)
    if not found:
        return output
    said = re.sub(r"hn::prover::(?:own::)?|hashnoise::v\d+_\d+::|\{aka .*?\}\}?|&(?=[,)])", "", found[2])
    for cpp, glsl in (("Float", "float"), ("Int", "int"), ("Uint", "uint"), ("Truth", "bool")):
        said = re.sub(rf"\b{cpp}\b", glsl, said)
    return f"{found[1]}: {said}"


# --- Sums -------------------------------------------------------------------------------------------------------------


def errors_of_sums(path: Path, results: Sequence[Result], within: Mapping[str, str]) -> dict[tuple[str, str], float]:
    """Of functions over noises of the library at any place: numbers of their ranges, with the published errors. By
    function and output; without those that are not proven so either."""
    made, found = {str(one.function): body_and_arguments(one.function, within) for one in results}, {}
    try:
        sums = Sums(bodies={name: body for name, (body, _) in made.items()}, own=transformed(path),
                    options=(f"-I{path.parent}",)) if results else None
    except NotBuilt:
        return {}
    for name, (body, given) in made.items():
        usual = {column.name: "any" for column in body.inputs} | {
            column: re.sub("^(box|position):", "float:", argument) for column, argument in given.items()}
        with contextlib.suppress(LookupError):
            found |= {(name, column.name): error for column, error in zip(body.outputs, sums.errors(name, usual))
                      if math.isfinite(error)}
    return found


# --- For a reader -----------------------------------------------------------------------------------------------------


def place_of(frames: Sequence[int], prover: Prover) -> str:
    """The user's line that called, and the library's."""
    done = subprocess.run(["addr2line", "-i", "-e", prover.program, *(hex(frame - 1) for frame in frames)],
                          capture_output=True, text=True, check=False)
    places = [line.split(" (")[0] for line in done.stdout.splitlines() if ".glsl:" in line]
    made = f"{prover.program.parent}/"
    library = [place.replace(made, "glsl/hashnoise/") for place in places if place.startswith(made)]
    own = [place for place in places if not place.startswith(made)]
    return ", in ".join([*own[:1], *library[:1]])


def report(path: Path, wanted: Sequence[str], within: Mapping[str, str]) -> int:
    """The exit status."""
    results, prover = prove(path, wanted, within)
    of_sums = errors_of_sums(path, [one for one in results if one.proven["error"].problem], within)
    last, right = None, 0
    for one in results:
        if one.function is not last:
            print(f"{path}:{one.function.line}: {one.function}")
        last, error = one.function, one.proven["error"]
        title = f"  {one.output or 'value':12}"
        if error.problem and (sum_error := of_sums.get((str(one.function), one.output))) is not None:
            print(f"{title} error {scientific(sum_error)}, as a sum of noises with their published errors")
            right += 1
        elif error.problem:
            ends = " x ".join(f"[{lo:.4g}, {hi:.4g}]" for lo, hi in error.box)
            print(f"{title} cannot be proven: {error.problem} at {place_of(error.frames, prover)}"
                  f"{ends and f', for fractions in {ends}'}")
        if error.problem:
            continue
        right += 1
        form, slope = "a cell" if one.function.has_place else "a position", one.proven["slope"].bound
        print(f"{title} in [{-one.proven['least'].bound:.6g}, {one.proven['most'].bound:.6g}], slopes up to {slope:.4g} between "
              f"jumps, error {scientific(error.bound)} from {form} ({error.boxes} boxes, {error.seconds:.1f} s)")
        if one.function.has_place:
            print(f"{'':14} error {scientific(position_error(error.bound, slope))} from a position")
    print("Errors are beside the same text in exact arithmetic, for any seed, in any rounding mode.")
    return int(right < len(results))
