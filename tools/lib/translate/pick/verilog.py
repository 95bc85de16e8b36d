"""Verilog-2005: a pipeline that takes a place and returns the fixed value, once a clock.

Registers stand where a path between two of them would be longer than a clock, by a simple model of delays.
"""

from __future__ import annotations

import functools
import itertools
import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from translate.names import wgsl_name
from translate.parsing.syntax import Function
from translate.parsing.tokens import Unknown
from translate.pick import comments
from translate.pick.circuit import (
    WIDEST,
    WIRING,
    Circuit,
    Gate,
    Lowering,
    Real,
    Unrolled,
    at_place,
    intervals,
    width,
)
from translate.pick.evaluate import Module, dotted
from translate.pick.statements import Return
from translate.pick.typer import Typed
from translate.pick.values import AXES, SIZES, Constant, Operation, Variable, begin_anew

CLOCK = "100"  # MHz
FRACTION, REST = 20, 4  # bits of a fraction, and of what an octave sum has beyond them
# In ns, with the wires: what a register takes of a clock, a table of four inputs, a multiplier, a carry, and a bit of it.
REGISTER, TABLE, MULTIPLIER, CARRY, CARRIED = 1.2, 1.0, 5.5, 1.6, 0.035
SIGNS = {"plus": "+", "minus": "-", "times": "*", "and": "&", "or": "|", "xor": "^", "less": "<", "equal": "=="}
RESERVED = frozenset("""always and assign automatic begin buf bufif0 bufif1 case casex casez cell cmos config deassign
    default defparam design disable edge else end endcase endconfig endfunction endgenerate endmodule endprimitive
    endspecify endtable endtask event for force forever fork function generate genvar highz0 highz1 if ifnone incdir
    include initial inout input instance integer join large liblist library localparam macromodule medium module nand
    negedge nmos nor noshowcancelled not notif0 notif1 or output parameter pmos posedge primitive pull0 pull1 pulldown
    pullup rcmos real realtime reg release repeat rnmos rpmos rtran rtranif0 rtranif1 scalared showcancelled signed
    small specify specparam strong0 strong1 supply0 supply1 table task time tran tranif0 tranif1 tri tri0 tri1 triand
    trior trireg unsigned use uwire vectored wait wand weak0 weak1 while wire wor xnor xor
    alias assert assume before bind bins bit break byte chandle checker class clocking const constraint context continue
    cover cross dist do endclass enum eventually expect export extends extern final first_match foreach global iff
    implies import inside int interface intersect let local logic longint matches modport nettype new nexttime null
    package packed priority program property protected pure rand randc ref restrict return s_always sequence shortint
    shortreal soft solve static string strong struct super sync tagged this throughout timeprecision timeunit type
    typedef union unique until untyped var virtual void weak wildcard with within clock unused value""".split())
NO_PORT = ("{0} {1}, for which a module has no port: ask for a noise, such as hn_perlin2, or for a whole sum, such as "
           "hn_fbm2")


class Choices(NamedTuple):
    constants: Mapping[str, str]
    clock: str
    stages: str
    multipliers: str

    @staticmethod
    def of(constants: str, clock: str = "", stages: str = "", multipliers: str = "") -> Choices:
        """Of the texts of options."""
        found: dict[str, str] = {}
        for one in filter(None, constants.split(",")):
            name, sign, value = one.partition("=")
            if not sign:
                raise Unknown(f"--constants {constants}: {one} has no value; write {name}=VALUE")
            found[name.strip()] = value.strip()
        return Choices(found, clock, stages, multipliers)


class Piece(NamedTuple):
    """Bits of a gate from `low` on, one bit of it `count` times, or bits of a constant."""
    gate: Gate | None
    low: int
    count: int
    repeats: bool = False


class Used:
    """Which bits of each gate are used for some bits of results, and what of its arguments a gate reads."""

    def __init__(self, results: Sequence[tuple[Gate, int]]):
        self.results = results
        self.same: dict[Gate, Gate] = {}  # sums whose used bits are those of one summand
        while self._find_bits():
            pass

    def _find_bits(self) -> bool:
        """Returns whether more is the same."""
        self.bits: dict[Gate, int] = {}  # which are used
        self.reads: dict[Gate, list[tuple[Gate, int]]] = {}  # arguments, and how many bits of each
        order = [gate for gate in self.reachable() if gate.kind not in ("constant", *WIRING)]
        for gate, count in self.results:
            self._use(gate, count)
        for gate in reversed(order):
            self.reads[gate] = self._reads(gate) if self.bits.get(gate) else []
            for argument, count in self.reads[gate]:
                self._use(argument, count)
        self.order = [gate for gate in order if self.bits.get(gate)]
        before = len(self.same)
        for gate in self.order:
            if gate.kind == "plus":
                for one, other in (gate.arguments, gate.arguments[::-1]):
                    if self.joined(one, self.has(gate)) == [Piece(None, 0, self.has(gate))]:
                        self.same[gate] = other
        return len(self.same) > before

    def pieces(self, gate: Gate, low: int, count: int) -> Iterator[Piece]:
        """Where bits of a number come from, the lowest first: wires are looked through."""
        if count <= 0:
            return
        if gate in self.same:
            yield from self.pieces(self.same[gate], low, count)
        elif gate.value is not None:
            yield Piece(None, (gate.value >> low) & ((1 << count) - 1), count)
        elif gate.kind == "shl" and low < gate.by:
            zeros = min(count, gate.by - low)
            yield Piece(None, 0, zeros)
            yield from self.pieces(gate, low + zeros, count - zeros)
        elif gate.kind in ("shl", "shr"):
            yield from self.pieces(gate.arguments[0], low - gate.by if gate.kind == "shl" else low + gate.by, count)
        else:
            inside = max(min(count, gate.width - low), 0)
            of_low = gate.kind == "low"
            if inside:
                yield from self.pieces(gate.arguments[0], low, inside) if of_low else [Piece(gate, low, inside)]
            if count > inside and not gate.is_signed:
                yield Piece(None, 0, count - inside)
            elif count > inside:
                at = gate.width - 1
                sign, = self.pieces(gate.arguments[0], at, 1) if of_low else [Piece(gate, at, 1)]
                yield Piece(None, -(sign.low & 1) & ((1 << (count - inside)) - 1), count - inside) if (
                    sign.gate is None) else sign._replace(count=count - inside, repeats=True)

    def joined(self, gate: Gate, count: int) -> list[Piece]:
        """The pieces of the lowest bits, with neighbours of one number together."""
        found: list[Piece] = []
        for one in self.pieces(gate, 0, count):
            last = found[-1] if found else None
            if last and last.gate is one.gate is None:
                found[-1] = Piece(None, last.low | one.low << last.count, last.count + one.count)
            elif last and last.gate is one.gate and not last.repeats and not one.repeats and (
                    one.low == last.low + last.count):
                found[-1] = last._replace(count=last.count + one.count)
            else:
                found.append(one)
        return found

    def reachable(self) -> list[Gate]:
        """In the order in which they are made, that is arguments first."""
        found: set[Gate] = set()
        pending = [gate for gate, _ in self.results]
        while pending:
            gate = pending.pop()
            if gate not in found:
                found.add(gate)
                pending += gate.arguments
        return sorted(found, key=lambda one: one.number)

    def _sources(self, of: Sequence[tuple[Gate, int]]) -> list[Gate]:
        return list(dict.fromkeys(piece.gate for gate, count in of for piece in self.joined(gate, count) if piece.gate))

    def _use(self, gate: Gate, count: int) -> None:
        for piece in self.joined(gate, count):
            if piece.gate:
                ones = (1 << (1 if piece.repeats else piece.count)) - 1
                self.bits[piece.gate] = self.bits.get(piece.gate, 0) | ones << piece.low

    def has(self, gate: Gate) -> int:
        """How many bits a gate computes."""
        return self.bits[gate].bit_length()

    def _reads(self, gate: Gate) -> list[tuple[Gate, int]]:
        if gate.kind == "input":
            return []
        if gate.kind in ("less", "equal"):
            signed = any(one.is_signed for one in gate.arguments)
            count = max(one.width + (signed and not one.is_signed) for one in gate.arguments)
            return [(one, count) for one in gate.arguments]
        if gate.kind == "choice":
            return [(gate.arguments[0], 1), *((one, self.has(gate)) for one in gate.arguments[1:])]
        return [(one, self.has(gate)) for one in gate.arguments]

class Pipeline(Used):
    """In which stage each gate is computed."""

    def __init__(self, results: Sequence[tuple[Gate, int]], period: float):
        super().__init__(results)
        self.sources = {gate: self._sources(self.reads[gate]) for gate in self.order}
        self.delays = {gate: self._delay(gate) for gate in self.order}
        slowest = max(self.delays.values(), default=0)
        if slowest + REGISTER > period:
            raise Unknown(f"a clock of {1000 / period:.0f} MHz is too fast for one of its products or sums: at most "
                          f"--clock {int(1000 / (slowest + REGISTER))}")
        self.stages = self._schedule(period - REGISTER)
        self.latency = max((self.stages[source] for source in self._sources(results)), default=0) + 1

    def _delay(self, gate: Gate) -> float:
        if gate.kind == "input":
            return 0
        if gate.kind == "times":
            return MULTIPLIER
        wide = max(count for _, count in self.reads[gate])
        return CARRY + CARRIED * wide if gate.kind in ("plus", "minus", "less", "equal") and wide > 2 else TABLE

    def _schedule(self, room: float) -> dict[Gate, int]:
        """As soon as possible, or as late, whichever takes fewer registers."""
        soon: dict[Gate, tuple[int, float]] = {}
        for gate in self.order:
            start = max((soon[one] for one in self.sources[gate]), default=(0, 0.0))
            end = start[1] + self.delays[gate]
            soon[gate] = (start[0], end) if end <= room else (start[0] + 1, self.delays[gate])
        last = max((stage for stage, _ in soon.values()), default=0)
        late: dict[Gate, tuple[int, float]] = {}  # when it has to begin
        ends = {source: (last, room) for source in self._sources(self.results)}
        for gate in reversed(self.order):
            stage, end = ends[gate]
            begin = end - self.delays[gate]
            late[gate] = (stage, begin) if begin >= 0 else (stage - 1, room - self.delays[gate])
            for one in self.sources[gate]:
                ends[one] = min(ends.get(one, late[gate]), late[gate])
        found = [{gate: 0 if gate.kind == "input" else stage for gate, (stage, _) in one.items()}
                 for one in (soon, late)]
        return min((one for one in found if min(one.values(), default=0) >= 0), key=self.registered)

    def registered(self, stages: Mapping[Gate, int]) -> int:
        """About how many bits registers hold."""
        last = dict(stages)
        for gate in self.order:
            for one in self.sources[gate]:
                last[one] = max(last[one], stages[gate])
        return sum((last[gate] - stages[gate]) * bin(self.bits[gate]).count("1") for gate in self.order)


def with_multipliers(circuit: Circuit, results: Sequence[tuple[Gate, int]],
                     most: int | None) -> list[tuple[Gate, int]]:
    """The same with products that multipliers compute, those that would take the most tables otherwise: at most so many
    multipliers; None is any number."""
    used = Used(results)
    costs: dict[Gate, tuple[float, int]] = {}  # tables for a multiplier, and multipliers
    for gate in used.order:
        if gate.kind == "times":
            a, b = (min(one.width, used.has(gate)) for one in gate.arguments)
            count = sum(i + j < used.has(gate) for i in range(0, a, WIDEST) for j in range(0, b, WIDEST))
            by = gate.arguments[1].value
            tables = a * b if by is None else a * bin(by).count("1") / 2
            costs[gate] = tables / count, count
    left = most
    kept: set[Gate] = set()
    for gate in sorted(costs, key=lambda one: (-costs[one][0], one.number)):
        if left is None or costs[gate][1] <= left:
            kept.add(gate)
            left = None if left is None else left - costs[gate][1]
    made: dict[Gate, Gate] = {}
    for gate in used.reachable():
        arguments = [made[one] for one in gate.arguments]
        if gate in costs:
            of = circuit.by_multipliers if gate in kept else circuit.by_sums
            made[gate] = circuit.within(of(*arguments), gate.low, gate.high)
        else:
            made[gate] = circuit.gate(gate.kind, arguments, gate.low, gate.high, gate.by)
        made[gate].name = made[gate].name or gate.name
    return [(made[gate], count) for gate, count in results]


class Text:
    """The lines of a module."""

    def __init__(self, pipeline: Pipeline, names: Mapping[Gate, str], outputs: Sequence[str]):
        self.pipeline, self.names, self.outputs = pipeline, names, outputs
        self.used: dict[tuple[Gate, int], int] = {}  # bits that are read in a stage
        self.unused: list[str] = []

    def lines(self) -> list[str]:
        pipeline = self.pipeline
        logic: dict[int, list[str]] = {stage: [] for stage in range(pipeline.latency)}
        for gate in pipeline.order:
            if gate.kind != "input":
                stage = pipeline.stages[gate]
                declared = f"{_range(pipeline.has(gate))}{self.names[gate]}"
                logic[stage].append(f"wire {declared} = {self._expression(gate, stage)};")
        last = pipeline.latency - 1
        results = [f"{name} <= {self._bits(gate, count, last)};"
                   for name, (gate, count) in zip(self.outputs, pipeline.results)]
        registers = self._registers()
        whole = {f"{name}{range_.strip() or '[0]'}": name for of_stage in registers for name, range_, _ in of_stage}
        lines: list[str] = []
        for stage in range(pipeline.latency):
            lines += ["", f"// Stage {stage + 1} of {pipeline.latency}.", *logic[stage]]
            kept = registers[stage]
            lines += [f"reg {range_}{name};" for name, range_, _ in kept]
            sets = [f"{name} <= {value};" for name, _, value in kept] if stage < last else results
            lines += ["always @(posedge clock) begin", *(f"  {one}" for one in sets), "end"]
        if self.unused:
            lines += ["", "// Bits that nothing reads, for linters.",
                      f"wire unused = &{{1'b0, {', '.join(self.unused)}}};"]
        return [re.sub(r"\w+\[\d+(?::\d+)?\]", lambda found: whole.get(found[0], found[0]), line) for line in lines]

    def _registers(self) -> list[list[tuple[str, str, str]]]:
        """Behind each stage: the names, ranges and values of what later ones read."""
        pipeline = self.pipeline
        found: list[list[tuple[str, str, str]]] = [[] for _ in range(pipeline.latency)]
        for gate in pipeline.order:
            first = pipeline.stages[gate]
            later = 0
            covers = {}
            for stage in range(pipeline.latency - 1, first, -1):
                later |= self.used.get((gate, stage), 0)
                covers[stage] = _cover(later)
            for stage in range(first, pipeline.latency):
                here, following = covers.get(stage, 0), covers.get(stage + 1, 0)
                if stage == first:
                    here = (1 << (pipeline.has(gate) if gate.kind != "input" else gate.width)) - 1
                self._leave(gate, stage, here & ~(self.used.get((gate, stage), 0) | following))
                if following:
                    low, high = _ends(following)
                    found[stage].append((self._name(gate, stage + 1), f"[{high}:{low}] " if high else "",
                                         self._slice(gate, stage, low, high)))
        return found

    def _leave(self, gate: Gate, stage: int, bits: int) -> None:
        while bits:
            low = (bits & -bits).bit_length() - 1
            count = ((bits >> low) ^ ((bits >> low) + 1)).bit_length() - 1
            self.unused.append(self._slice(gate, stage, low, low + count - 1))
            bits &= ~(((1 << count) - 1) << low)

    def _name(self, gate: Gate, stage: int) -> str:
        """In that stage."""
        return self.names[gate] if stage == self.pipeline.stages[gate] else f"{self.names[gate]}_s{stage + 1}"

    def _slice(self, gate: Gate, stage: int, low: int, high: int) -> str:
        is_first = stage == self.pipeline.stages[gate]
        whole = gate.width if gate.kind == "input" and is_first else self.pipeline.has(gate)
        name = self._name(gate, stage)
        if (whole == 1) or (is_first and (low, high) == (0, whole - 1)):
            return name
        return f"{name}[{high}]" if low == high else f"{name}[{high}:{low}]"

    def _bits(self, gate: Gate, count: int, stage: int) -> str:
        """The lowest bits of a number."""
        parts: list[str] = []
        for one in reversed(self.pipeline.joined(gate, count)):
            if one.gate is None:
                parts.append(f"{one.count}'h{one.low:X}" if one.low else f"{one.count}'d0")
                continue
            taken = 1 if one.repeats else one.count
            self.used[one.gate, stage] = self.used.get((one.gate, stage), 0) | ((1 << taken) - 1) << one.low
            text = self._slice(one.gate, stage, one.low, one.low + taken - 1)
            parts.append(f"{{{one.count}{{{text}}}}}" if one.repeats and one.count > 1 else text)
        return parts[0] if len(parts) == 1 else f"{{{', '.join(parts)}}}"

    def _expression(self, gate: Gate, stage: int) -> str:
        parts = [self._bits(one, count, stage) for one, count in self.pipeline.reads[gate]]
        if gate.kind == "not":
            return f"~{parts[0]}"
        if gate.kind == "choice":
            return f"{parts[0]} ? {parts[1]} : {parts[2]}"
        if gate.kind in ("less", "times") and any(one.is_signed for one in gate.arguments):
            parts = [f"$signed({part})" for part in parts]
        return f" {SIGNS[gate.kind]} ".join(parts)


def _range(count: int) -> str:
    return f"[{count - 1}:0] " if count > 1 else ""


def _ends(bits: int) -> tuple[int, int]:
    return (bits & -bits).bit_length() - 1, bits.bit_length() - 1


def _cover(bits: int) -> int:
    """All between the first and the last."""
    if not bits:
        return 0
    low, high = _ends(bits)
    return (2 << high) - (1 << low)


class Port(NamedTuple):
    name: str
    low: int
    high: int
    what: str

    @property
    def width(self) -> int:
        return width(self.low, self.high)

    @property
    def declared(self) -> str:
        return f"{'signed ' if self.low < 0 else ''}{_range(self.width)}{self.name}"


class Made:
    """A function as a module."""

    def __init__(self, module: Module, asked: Function, library: Path, choices: Choices):
        self.name = wgsl_name(asked)
        self.function = at_place(module, asked)
        self.facts = comments.facts(asked, library, False)
        self.module, self.choices = module, choices
        self.ports: list[Port] = []
        self.circuit = Circuit()
        self.inputs: dict[str, Gate] = {}
        begin_anew()
        ranges = functools.cache(functools.partial(_ranges, library=library))
        evaluation = Unrolled(module, ranges)
        block = evaluation.run(self.function, self._arguments())
        lowering = Lowering(self.name, self.circuit, self.inputs, evaluation.known, evaluation.hints)
        result = next(one.value for one in block if isinstance(one, Return))
        if module.summed and not evaluation.sums_other_noise:
            raise Unknown(f"{self.name} is no sum, for whose noise --noise could stand: ask for hn_fbm2 or another sum")
        if result is None or self.function.type in module.structs:
            raise Unknown(NO_PORT.format(self.name, f"returns {self.function.type}"))
        parts = result.arguments if isinstance(result, Operation) and result.kind == "construct" and (
            SIZES[result.type] > 1) else (result,)
        values = [lowering.of(part) for part in parts]
        known = ranges(asked)
        known = known[:1] if len(values) == 1 else known if len(known) == len(values) else []
        names = ["value"] if len(values) == 1 else [f"value_{axis}" for axis in AXES[:len(values)]]
        self.outputs: list[Port] = []
        results: list[Gate] = []
        for name, value, known_range in zip(names, values, [*known, *[None] * len(values)]):
            gate = value.whole if isinstance(value, Real) else value
            if known_range and isinstance(value, Real):
                gate = self.circuit.within(gate, *(int(end * 2**value.places) for end in known_range))
            what = f"in units of 2^{-value.places}" if isinstance(value, Real) and value.places else "a whole number"
            self.outputs.append(Port(name, gate.low, gate.high, what))
            results.append(gate)
        self.units = [value.places if isinstance(value, Real) else 0 for value in values]
        most = int(choices.multipliers) if choices.multipliers else None
        self.pipeline = self._pipeline(with_multipliers(self.circuit, [(gate, gate.width) for gate in results], most))

    def _arguments(self) -> list[Typed]:
        """A constant for each parameter that is known, and a port for each other one."""
        missing, found = [], []
        constants = dict(self.choices.constants)
        for parameter in self.function.parameters:
            name, type_ = parameter.at.text, parameter.type
            leaves = {}
            if name in constants:
                leaves[()] = _constant(name, type_, constants.pop(name))
            elif re.fullmatch("hn_place[1-4]", type_):
                leaves = {path: self._of_place(path, type_) for path, type_ in self.module.parts(type_)}
            elif type_ in self.module.structs or parameter.is_set:
                raise Unknown(NO_PORT.format(
                    self.name, f"takes {type_}" if type_ in self.module.structs else f"sets {name}"))
            elif type_.startswith(("float", "vec")) or name in ("octaves", "metric", "kind"):
                missing.append((name, type_))
            else:
                leaves = {path: self._port(dotted((name, *path)), scalar, self.facts.parameters.get(name, ""))
                          for path, scalar in self.module.parts(type_)}
            found.append(Typed(type_, leaves))
        if missing:
            shown = ",".join(f"{name}={_usual(name, type_)}" for name, type_ in missing)
            names = [name for name, _ in missing]
            listed = " and ".join(filter(None, [", ".join(names[:-1]), names[-1]]))
            raise Unknown(f"{self.name} takes {listed}, which a circuit has as constants: add --constants {shown}")
        self.left = constants
        return found

    def _of_place(self, path: tuple[str, ...], type_: str) -> Constant | Variable:
        if path[0] in ("period", "tiled") or path[0] == "rest" and not self.has_rest:
            return Constant(type_, 0)
        return self._port(dotted(path), path[0], "")

    @property
    def has_rest(self) -> bool:
        return any(one.at.text == "octaves" for one in self.function.parameters)

    def _port(self, name: str, kind: str, what: str) -> Variable:
        bits, is_signed, what = {
            "cell": (32, True, "the cell along that axis"),
            "fraction": (FRACTION, False, f"the position in the cell, in units of 2^-{FRACTION}"),
            "rest": (REST, False, f"the bits behind the fraction, in units of 2^-{FRACTION + REST}"),
            "int": (32, True, what), "uint": (32, False, what.replace("any uint: 7u, not 7", "any")),
            "bool": (1, False, what)}[kind]
        shown = f"{name}_" if name in RESERVED else name
        low, high = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if is_signed else (0, (1 << bits) - 1)
        self.ports.append(Port(shown, low, high, what))
        self.inputs[name] = self.circuit.input(shown, low, high)
        return Variable({"cell": "int", "fraction": "int", "rest": "int"}.get(kind, kind), name, is_parameter=True)

    def _pipeline(self, results: Sequence[tuple[Gate, int]]) -> Pipeline:
        if not self.choices.stages:
            return Pipeline(results, 1000 / float(self.choices.clock or CLOCK))
        wanted, low, high = int(self.choices.stages), 0.0, 2000.0
        if Pipeline(results, high).latency > wanted:
            raise Unknown(f"--stages {wanted}: a pipeline has at least 1")
        for _ in range(16):  # the shortest period with so few stages
            middle = (low + high) / 2
            try:
                fits = Pipeline(results, middle).latency <= wanted
            except Unknown:
                fits = False
            low, high = (low, middle) if fits else (middle, high)
        return Pipeline(results, high)

    def text(self) -> str:
        pipeline = self.pipeline
        taken = {port.name for port in (*self.ports, *self.outputs)}
        names: dict[Gate, str] = {gate: gate.by for gate in pipeline.order if gate.kind == "input"}
        for gate in pipeline.order:
            if gate.kind != "input":
                names[gate] = _free(gate.name or "n", taken)
        lines = Text(pipeline, names, [port.name for port in self.outputs]).lines()
        ports = ["input wire clock", *(f"input wire {port.declared}" for port in self.read),
                 *(f"output reg {port.declared}" for port in self.outputs)]
        head = "".join(f"    {port}{',' if port is not ports[-1] else ''}\n" for port in ports)
        body = "".join(f"  {line}\n" if line else "\n" for line in lines for line in _wrapped(line))
        return f"module {self.name} (\n{head});\n{body}endmodule\n"

    @property
    def read(self) -> list[Port]:
        """The ports that the module needs."""
        names = {gate.by for gate in self.pipeline.order if gate.kind == "input"}
        return [port for port in self.ports if port.name in names]

    def comment(self) -> list[str]:
        facts = self.facts
        rows = {port.name: f"{port.width} bits, {'signed' if port.low < 0 else 'unsigned'}: {port.what}"
                for port in (*self.read, *self.outputs)}
        constants = ", ".join(f"{name} {value}" for name, value in self.choices.constants.items())
        written = textwrap.wrap(facts.what + (f" Here {constants}." if constants else ""), 117)
        wide = max(map(len, [*rows, "latency"]))
        rows |= {"latency": f"{self.pipeline.latency} clocks; a value leaves at each", "returns": facts.returns}
        for name, text in rows.items():
            written += textwrap.wrap(text, 117, initial_indent=f"  {name:{wide}}  ", subsequent_indent=" " * (wide + 4))
        return [f" {line}" for line in written]


def _ranges(function: Function, library: Path) -> list[tuple[Fraction, Fraction]]:
    """The ranges of its results, as its comment states them. Distances have others in other metrics."""
    if any(one.at.text == "metric" for one in function.parameters):
        return []
    return intervals(comments.facts(function, library, False).returns)


def _wrapped(line: str) -> list[str]:
    if len(line) <= 118:
        return [line]
    return textwrap.wrap(line, 118, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _free(name: str, taken: set[str]) -> str:
    name = f"{name}_" if name in RESERVED else name
    joint = "_" if name[-1].isdigit() else ""
    found = name if name not in taken else next(
        one for i in itertools.count(2) if (one := f"{name}{joint}{i}") not in taken)
    taken.add(found)
    return found


def _usual(name: str, type_: str) -> str:
    value = comments.ARGUMENTS.get(name, (1,))[0]
    return str(float(value)) if type_ == "float" else str(int(value))


def _constant(name: str, type_: str, text: str) -> Constant:
    try:
        value = Fraction(text) if type_ == "float" else int(text, 0)
    except ValueError:
        kind = "a number" if type_ == "float" else "an integer"
        raise Unknown(f"--constants {name}={text}: {name} is {kind}, such as {name}={_usual(name, type_)}") from None
    if type_ == "float":
        return Constant("float", f"{float(value)}f")
    return Constant(type_, value & 0xFFFFFFFF if type_ == "uint" else value)


def text(made: Sequence[Made], heading: Sequence[str]) -> str:
    unknown = [name for name in made[0].choices.constants if all(name in one.left for one in made)]
    if unknown:
        raise Unknown(f"--constants {unknown[0]}: {made[0].name} has no such parameter; it takes "
                      f"{', '.join(one.at.text for one in made[0].function.parameters)}")
    parts = ["".join(f"//{line}\n" for line in one.comment()) + one.text() for one in made]
    begin = "".join(f"//{line}\n" for line in heading)
    return f"{begin}\n`default_nettype none\n\n" + "\n".join(parts) + "\n`default_nettype wire\n"
