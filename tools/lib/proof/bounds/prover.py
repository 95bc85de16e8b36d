"""Proves how far the text of a function may be off, by running it over numbers that prove (conformance/prover): a
function is named by its row in the suite's table, or has a body like those."""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from base.tree import CONFORMANCE
from base.twin import compile_program
from catalog.tables.functions import Column
from proof.bounds import rounded, sine
from proof.bounds.rounded import FIXED, Body, made, with_literals, with_true_numbers, write_literal_text

ENGINE = CONFORMANCE / "prover"
OPTIONS = ("-O1", "-w", "-frounding-math")  # optimized more, it is compiled longer and runs no faster
MACROS = ("always_inline=unused", f"PROVER_SINE={sine.polynomial_error()!r}",
          f"PROVER_FIXED_SINE={sine.fixed_sine_error()!r}")


@dataclass(frozen=True)
class Proven:
    bound: float  # infinite if something was not seen
    at_point: float  # no bound can be less
    boxes: int
    seconds: float
    problem: str
    box: list[list[float]] = field(default_factory=list)  # the worst: its ends along each axis
    frames: list[int] = field(default_factory=list)  # the addresses of the calls on the way to the problem
    parts: list[list] = field(default_factory=list)  # of the bound, and the calls on the way to each


@dataclass(frozen=True)
class Job:
    """A function with its arguments by their columns: "any", "word:5", "float:0.5", or "box:0:1" for each float in
    there. The arguments that are not named are as usual_argument returns them."""
    function: str
    outputs: tuple[str, ...]
    arguments: Mapping[str, str]
    most: int = 25_000  # boxes
    tolerance: float = 0.003  # relative
    target: float = -math.inf  # a bound that is small enough
    bits: int = 20  # of a place in HN_FIXED
    given: int = 0  # or 1: decisions come out as in exact arithmetic
    measure: str = "error"  # or "most", "least", "exact_most", "exact_least", "slope", "error_by_length"
    longest: float = math.inf  # of distances that are the k-th smallest, and of a vector if a result is its direction
    unit: float = 1.0  # of the lengths of the text, in units of `longest` and of the result
    seconds: float = math.inf  # then the search ends with the bound that it has


def usual_argument(column: Column) -> str:
    """A fraction or a setting is in [0, 1], a period is none, and a word is any."""
    if column.type == "f32":
        return "box:0:1"
    return "word:0" if column.name in ("px", "py", "pz", "pw") else "any"


class Prover:
    """Functions compiled with these macros, such as HN_ARITHMETIC=HN_FIXED. A text of somebody else, in C++, is in the
    namespace `own`."""

    def __init__(self, bodies: Mapping[str, Body], *macros: str, text: str = "", options: tuple[str, ...] = ()):
        self.bodies = dict(bodies)
        source = "".join(f"FUNCTION({body.code})\n" for body in self.bodies.values())

        def make(folder: Path) -> None:
            write_literal_text(folder, with_stated_steps if FIXED in macros else with_true_numbers)
            (folder / "bodies.inc").write_text(with_literals(source), encoding="utf-8")
            (folder / "own.inc").write_text(text, encoding="utf-8")
            compile_program("the text over numbers that prove", ENGINE / "prove.cpp", folder / "new", *OPTIONS, *options,
                            f"-I{folder}", macros=(*MACROS, *macros))

        self.program = made("prove", (*OPTIONS, *MACROS, *macros, *options, text, source),
                            [Path(rounded.__file__), *ENGINE.glob("*.[ch]pp")], make)

    def prove(self, jobs: Iterable[Job]) -> list[Proven]:
        """In their order."""
        lines = [self.line(job) for job in jobs]
        done = subprocess.run([self.program], input="".join(lines), capture_output=True, text=True, check=True)
        return [Proven(**json.loads(line)) for line in done.stdout.splitlines()]

    def line(self, job: Job) -> str:
        body = self.bodies[job.function]
        if unknown := job.arguments.keys() - {column.name for column in body.inputs}:
            raise ValueError(f"{job.function} has no argument {', '.join(sorted(unknown))}")
        arguments = [job.arguments.get(column.name, usual_argument(column)) for column in body.inputs]
        outputs = sum(1 << i for i, column in enumerate(body.outputs) if column.name in job.outputs)
        number = list(self.bodies).index(job.function)
        names = "measure", "most", "tolerance", "target", "bits", "given", "longest", "unit", "seconds"
        options = [f"{name}={getattr(job, name)}" for name in names]
        return " ".join(map(str, (number, *arguments, f"outputs={outputs}", *options))) + "\n"


# Steps of HN_FIXED: stated.hpp has others in their place.
STEPS = {f"{result} hn_i_{name}({arguments}": f"{result} hn_i_computed_{name}({arguments}" for result, name, arguments in (
    ("hn_int", "whole_wave", ""), ("hn_i_num2", "rotation", "hn_float phase)"), ("hn_int", "floor", "hn_int x)"),
    ("hn_int", "truncate", "hn_int x)"), ("hn_int", "fract", "hn_int x)"), ("hn_uint", "square", "hn_int"))}


def with_stated_steps(text: str) -> str:
    text = with_true_numbers(text)
    for old, new in STEPS.items():
        text = text.replace(old, new)
    return text


def is_within(proven: Proven, documented: float) -> bool:
    return math.isfinite(proven.bound) and proven.bound <= documented
