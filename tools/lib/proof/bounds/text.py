"""The errors that the text of the library proves (prover.py), beside the published ones.

A published error stays, and the proven one is at most that; from a position, with L * 2^-24 more (floats.py), and
in HN_FIXED with L * 2^-20, by which the text cuts a place, or with what it rounds a place by. A noise without a row in
bounds.inc gets the proven one, rounded up: so delete a row to have it written anew. A noise without a module in noises/
gets its range and slope from its text as well."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace

import catalog.model
from base.thorough import THOROUGH
from catalog.tables.functions import Function, read_functions
from proof.bounds import noises, rotations
from proof.bounds.floats import position_error
from proof.bounds.gradients import OCTAHEDRAL, SINE, Gradient
from proof.bounds.noises import ProvenBounds
from proof.bounds.prover import Job, Proven, Prover, is_within
from proof.bounds.rounded import FIXED, SINES, table
from proof.bounds.table import Bounds, closer, published

Key = tuple[str, int, Gradient | None]
VALUE, SLOPE, OFFSET = "value", "derivative", "offset"  # kinds of results: each has an error of its own
ERRORS = "error", "error_by_length"  # measures


@dataclass(frozen=True)
class Line:
    """Noises whose errors the text proves in some dimensions, in one arithmetic; and how."""
    noises: str
    dims: tuple[int, ...]
    fixed: bool = False
    gradient: Gradient = OCTAHEDRAL  # or none, for noises without
    arguments: Mapping[str, str] = field(default_factory=dict)  # by columns: beside those that are usual
    most: int = 25_000  # boxes
    tolerance: float = 0.003
    bits: int = 20  # of places in HN_FIXED: the text rounds them to these
    kinds: tuple[str, ...] = (VALUE, SLOPE, OFFSET)
    # Decisions come out as in exact arithmetic: a result that jumps has an error only where they do. Or as at a place
    # that is moved, by 2^-25 along each axis at most: there the noise's module proves that both sides are the same. So it
    # is off by L * 2^-24 more.
    given: bool = False
    moved: bool = False
    limits: bool | None = False  # by the text, too; None: by a formula of the noise's module
    long: bool = False  # not by `--check`, but by writing and by thorough tests
    # The cosine and the sine of a phase are exact there. How far they are off moves a noise or a derivative of the
    # range R by sqrt(2) R times that (rotations.py), which is added.
    exact_sines: bool = False
    any_direction: bool = False  # the directions that the text makes of hashes are any, which are exact

    @property
    def cut(self) -> float:
        """How far HN_FIXED moves a place along each axis: it is cut to 20 bits, and then rounded."""
        return 2**-20 + (2**-(self.bits + 1) if self.bits < 20 else 0)

    @property
    def macros(self) -> tuple[str, ...]:
        return ((FIXED,) * self.fixed + (SINES,) * (self.gradient is SINE) + ("PROVER_EXACT_SINES=1",) * self.exact_sines
                + ("PROVER_ANY_DIRECTION=1",) * self.any_direction)

    def holds(self, key: Key, fixed: bool, kind: str = VALUE) -> bool:
        name, dims, gradient = key
        return (name in self.noises.split() and dims in self.dims and fixed == self.fixed
                and gradient in (self.gradient, None) and kind in self.kinds)


# A noise is here, or its module has formulas: then derive() gives its errors.
PROVEN = (
    Line("perlin perlin_d", (1, 2), fixed=True),
    Line("perlin perlin_d", (3,), fixed=True, long=True),
    Line("perlin", (2, 3), fixed=True, gradient=SINE, limits=True, long=True),
    Line("perlin_phase perlin_d_phase", (2,), fixed=True, arguments={"phase": "box:0:1"}),
    Line("perlin_phase perlin_d_phase", (3,), fixed=True, arguments={"phase": "box:0:1"}, kinds=(VALUE,), long=True),
    Line("perlin perlin_d", (4,), fixed=True, most=60_000, kinds=(VALUE,), long=True),
    Line("simplex simplex_d curl", (2,), fixed=True),
    Line("simplex_phase simplex_d_phase curl_phase", (2,), fixed=True, arguments={"phase": "box:0:1"}, long=True),
    Line("value value_d", (1, 2), fixed=True, limits=True),
    Line("value value_d", (3, 4), fixed=True, most=50_000, limits=True, long=True),
    Line("perlin_vector perlin_vector_d", (2, 3), fixed=True, long=True),
    Line("value_vector value_vector_d", (2, 3), fixed=True, most=50_000, limits=True, long=True),
    Line("value_cubic", (1, 2, 3), fixed=True, bits=15, limits=None),
    Line("perlin perlin_d value value_d value_cubic", (1, 2, 3)),
    Line("perlin perlin_d value value_d", (4,), most=60_000, long=True),
    Line("perlin_vector perlin_vector_d value_vector value_vector_d", (2, 3), long=True),
    Line("perlin", (2,), gradient=SINE),
    Line("perlin", (3,), gradient=SINE, long=True),
    *(Line("perlin_phase perlin_d_phase simplex_phase simplex_d_phase", (dims,), most=100_000, arguments={"phase": "any"},
           exact_sines=True, long=dims == 3) for dims in (2, 3)),
    Line("curl_phase", (2,), most=100_000, arguments={"phase": "any"}, exact_sines=True),
    Line("phasor_bandwidth phasor_d_bandwidth", (2,), arguments=dict.fromkeys(("kx", "ky", "bandwidth", "phase"), "any"),
         any_direction=True),
    Line("phasor_bandwidth phasor_d_bandwidth", (3,), arguments=dict.fromkeys(("kx", "ky", "kz", "bandwidth", "phase"), "any"),
         most=200_000, any_direction=True, long=True),
    Line("phasor phasor_d", (2,), arguments=dict.fromkeys(("kx", "ky", "phase"), "any")),
    Line("phasor phasor_d", (3,), arguments=dict.fromkeys(("kx", "ky", "kz", "phase"), "any"), most=200_000, long=True),
    Line("simplex simplex_d simplex_smooth curl", (2,)),
    Line("simplex simplex_d", (3,)),
    Line("simplex_smooth", (3,), long=True),
    Line("simplex simplex_d", (4,), most=200_000, long=True),
    Line("cellular", (2,), kinds=(VALUE,)),
    Line("cellular", (3,), kinds=(VALUE,), long=True),
    Line("cellular_three", (2,), given=True, moved=True),
    *(Line("cellular_three", (3,), given=True, moved=True, arguments={"metric": f"word:{number}"}, long=True)
      for number in range(1, 5)),  # the hybrid metric has a formula: distances.py
    Line("cellular_smooth", (2, 3)),
    Line("cellular", (2, 3), kinds=(OFFSET,), given=True),
    Line("cellular_d", (2, 3), given=True),
    Line("cellular_phase", (2, 3), kinds=(VALUE,), arguments={"phase": "any"}, exact_sines=True),
)


def lines() -> list[Line]:
    """PROVEN, and lines for noises without a module."""
    return [*PROVEN, *(Line(name, tuple(dims for dims, _ in noises.find(name).cases), fixed, most=100_000)
                       for name in noises.names() if noises.find(name).is_of_text for fixed in (False, True))]


def usual_lines() -> list[Line]:
    """The lines that a default run proves. Their functions are one program for each set of macros."""
    return [line for line in lines() if THOROUGH or not line.long]


def proves(name: str, dims: int, gradient: Gradient | None, fixed: bool, kind: str = VALUE) -> bool:
    return any(line.holds((name, dims, gradient), fixed, kind) for line in lines())


# --- Jobs -------------------------------------------------------------------------------------------------------------


@functools.cache
def rows() -> dict[tuple[str, int, str, str], Function]:
    """The functions with most arguments by noise, dimension, form and kind of results: from a cell and from a
    position, without a period if there is one."""
    def order(function: Function) -> tuple[int, bool]:
        return len(function.inputs) - function.has_period * function.axes, not function.has_period

    found: dict[tuple[str, int, str, str], Function] = {}
    for function in read_functions():
        if function.form in ("position", "cell") and function.type == "f64":
            of_vector = "_vector_d" in function.id
            noise = f"{function.bound.removesuffix('_d')}_vector_d" if of_vector else function.bound
            key = noise, function.axes, function.form, function.outputs[-1].name[0]
            if key not in found or order(function) > order(found[key]):
                found[key] = function
    return found


def kind_of(function: Function, output: str) -> str:
    if output[0] in "oxy":  # of a vector to a point
        return OFFSET
    return SLOPE if output[0] == "d" and len(output) == 2 else VALUE


@dataclass(frozen=True)
class Case:
    """Results of a function that have an error in common."""
    line: Line
    key: Key
    kind: str
    job: Job


def target(name: str, dims: int, line: Line, kind: str) -> float:
    """The documented error from a cell, and less if that from a position needs it."""
    if kind == OFFSET:
        of_vector = noises.find(name).offset_error(dims, line.fixed)
        return of_vector if line.fixed else of_vector - position_error(0.0, 1.0)
    row = row_of((name, dims, line.gradient), kind)
    if not row:
        return -math.inf
    of_floats = min(row.cell_error, row.error - position_error(0.0, row.lipschitz))
    fixed = closer(row).fixed_error if kind == VALUE else row.fixed_error
    return fixed - row.lipschitz * line.cut if line.fixed else of_floats - left_out(name, dims, line, kind)


def left_out(name: str, dims: int, line: Line, kind: str) -> float:
    """The error that exact sines and given decisions leave out."""
    row = row_of((name, dims, line.gradient), kind)
    if not row:
        return 0.0
    of_sines = noises.find(name).moved_by_sines or (lambda _: math.sqrt(2) * rotations.float_error() * row.limit)
    return of_sines(dims) * line.exact_sines + (position_error(0.0, row.lipschitz) if line.moved else 0.0)


def cases(lines: Iterable[Line]) -> Iterator[Case]:
    metrics = range(1, 1 + len(catalog.model.read().metrics))
    for line in lines:
        for name in line.noises.split():
            if missing := {*line.dims} - {dims for noise, dims, *_ in rows() if noise == name}:
                raise LookupError(f"PROVEN of tools/lib/proof/bounds/text.py has {name} in {missing.pop()}D: no function")
            for (bound, dims, form, _), function in rows().items():
                if bound != name or dims not in line.dims or form != "cell":
                    continue
                several = "metric" in [column.name for column in function.inputs] and "metric" not in line.arguments
                for kind in dict.fromkeys(kind_of(function, column.name) for column in function.outputs):
                    if kind not in line.kinds:
                        continue
                    outputs = tuple(column.name for column in function.outputs if kind_of(function, column.name) == kind)
                    length = noises.find(name).length
                    of_length = {"longest": length(dims), "unit": 0.5} if length and kind != OFFSET else {}
                    if length and kind == SLOPE:
                        of_length["measure"] = "error_by_length"
                    for metric in [{"metric": f"word:{number}"} for number in metrics] if several else [{}]:
                        case = Case(line, (name, dims, line.gradient), kind, Job(
                            function.id, outputs, {**line.arguments, **metric}, line.most, line.tolerance,
                            target(name, dims, line, kind), line.bits, int(line.given), **of_length))
                        yield case
                        if line.limits:
                            limit = row_of(case.key, kind).fixed_limit
                            yield from (replace(case, job=replace(case.job, measure=measure, target=limit))
                                        for measure in ("most", "least"))
                        if noises.find(name).is_of_text and not line.fixed:
                            yield from (replace(case, job=replace(case.job, measure=measure, target=-math.inf, tolerance=tolerance))
                                        for measure, tolerance in (("most", 1e-5), ("least", 1e-5), ("slope", 0.003)))


def provers_of(some: Iterable[Case]) -> dict[tuple[str, ...], Prover]:
    """By their macros."""
    functions: dict[tuple[str, ...], dict[str, None]] = {}
    for case in some:
        functions.setdefault(case.line.macros, {})[case.job.function] = None
    with ThreadPoolExecutor() as pool:
        return dict(zip(functions, pool.map(
            lambda macros: Prover({id: table()[id] for id in functions[macros]}, *macros), functions)))


def prove(lines: Sequence[Line]) -> list[tuple[Case, Proven]]:
    """On all cores."""
    of_all = list(cases(lines))
    provers = provers_of(of_all)
    with ThreadPoolExecutor() as pool:
        found = pool.map(lambda case: provers[case.line.macros].prove([case.job])[0], of_all)
        return [(case, replace(proven, bound=proven.bound + left_out(*case.key[:2], case.line, case.kind)))
                for case, proven in zip(of_all, found)]


# --- Beside the published ones ----------------------------------------------------------------------------------------


def row_of(key: Key, kind: str) -> Bounds | None:
    name, dims, gradient = key
    return published(name, dims, (gradient or OCTAHEDRAL).name, "SLOPE_BOUNDS" if kind == SLOPE else "NOISE_BOUNDS")


def below(published: float) -> float:
    """So that rounding up returns the decimal that this was."""
    return math.nextafter(published, 0.0)


def worst(found: Iterable[tuple[Case, Proven]], key: Key, kind: str, fixed: bool, *measures: str) -> float:
    return max(proven.bound for case, proven in found if case.kind == kind and case.line.holds(key, fixed)
               and case.key[:2] == key[:2] and case.job.measure in (measures or ERRORS))


def completed(key: Key, bounds: ProvenBounds, found: Sequence[tuple[Case, Proven]]) -> ProvenBounds:
    """The bounds with errors that the text proves: the published ones, or new ones."""
    slope = _completed(key, SLOPE, bounds.slope, found) if bounds.slope else None
    return replace(_completed(key, VALUE, bounds, found), slope=slope)


def _completed(key: Key, kind: str, bounds: ProvenBounds, found: Sequence[tuple[Case, Proven]]) -> ProvenBounds:
    row = row_of(key, kind)
    if bounds.range is None:
        bounds = replace(bounds, range=worst(found, key, kind, False, "most", "least"))
    if bounds.lipschitz is None:
        bounds = replace(bounds, lipschitz=worst(found, key, kind, False, "slope"))
    if proves(*key, fixed=False, kind=kind):
        cell_error = below(row.cell_error) if row else worst(found, key, kind, False)
        error = below(row.error) if row else position_error(cell_error, bounds.lipschitz)
        bounds = replace(bounds, cell_error=cell_error, error=error, largest=bounds.range + error)
    if proves(*key, fixed=True, kind=kind):
        error = below(row.fixed_error) if row else worst(found, key, kind, True)
        largest = below(row.fixed_limit) if row else bounds.range + error
        bounds = replace(bounds, fixed_error=error, fixed_largest=bounds.fixed_largest or largest)
    if None in (bounds.error, bounds.fixed_error):
        raise LookupError(f"{key[0]} in {key[1]}D has no formulas of its {'fixed ' * (bounds.error is not None)}error, "
                          "and is not in PROVEN of tools/lib/proof/bounds/text.py")
    return bounds


def unseen(found: Iterable[tuple[Case, Proven]]) -> list[str]:
    """A message for each bound of a noise without a module that its text does not prove."""
    return [f"{case.job.function}: its text proves no {case.job.measure}{' with HN_FIXED' * case.line.fixed}: {proven.problem}"
            for case, proven in found if noises.find(case.key[0]).is_of_text and math.isinf(proven.bound)]


def wrong(found: Iterable[tuple[Case, Proven]], derived: Mapping[Key, ProvenBounds]) -> list[str]:
    """A message for each documented error that the text does not prove."""
    messages = []
    for key, of in derived.items():
        if noises.find(key[0]).is_of_text and of.range - of.error > of.promise:
            messages.append(f"catalog/noises.toml: {key[0]} is up to {of.range:.6g} in {key[1]}D, by its text")
    for case, proven in found:
        name, dims, gradient = case.key
        of = derived.get(case.key) or derived[name, dims, None]
        of = (case.kind == SLOPE and of.slope) or of
        if case.job.measure not in ERRORS:
            if case.line.limits and not is_within(proven, of.fixed_largest):
                messages.append(f"{case.job.function}: the {case.kind} is {of.fixed_largest:.6g} at most, and its text "
                                f"proves {proven.bound:.6g} (HN_FIXED)")
            continue
        if case.kind == OFFSET:
            limits = [("", 0.0 if case.line.fixed else position_error(0.0, 1.0),
                       noises.find(name).offset_error(dims, case.line.fixed))]
        elif case.line.fixed:
            if case.line.limits is False and case.kind == VALUE and of.range + proven.bound > of.fixed_largest:
                messages.append(f"{case.job.function}: the value may be {of.range + proven.bound:.6g} (HN_FIXED)")
            documented = (closer(of.bounds(*case.key)) if case.kind == VALUE else of).fixed_error
            limits = [("", of.lipschitz * case.line.cut, documented)]
        else:
            limits = [(" from a cell", 0.0, of.cell_error), (" from a position", position_error(0.0, of.lipschitz), of.error)]
        for form, more, documented in limits:
            if not is_within(replace(proven, bound=proven.bound + more), documented):
                messages.append(
                    f"{case.job.function}: the {case.kind} errs by {documented:.4g} at most{form}, and its text proves "
                    f"{proven.bound + more:.4g}{proven.problem and ': '}{proven.problem} (in {proven.boxes} boxes"
                    f"{', HN_FIXED' * case.line.fixed}{', sine' * (gradient is SINE)})")
    return messages
