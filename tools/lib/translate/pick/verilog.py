"""Verilog-2005: a pipeline that takes a place and returns the fixed value, once a clock.

Registers stand where a path between two of them would be longer than a clock, by a simple model of delays.
"""

from __future__ import annotations

import functools
import itertools
import re
import textwrap
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from translate.names import variable, wgsl_name
from translate.parsing.syntax import Function
from translate.parsing.tokens import Unknown
from translate.pick import comments
from translate.pick.circuit import WIDEST, WIRING, Circuit, Gate, Lowering, Unrolled, at_place, width
from translate.pick.evaluate import Module, dotted
from translate.pick.program import chosen, not_summed, of_noise
from translate.pick.typer import Typed
from translate.pick.values import AXES, SIZES, WORD, Constant, Operation, Variable, begin_anew

if TYPE_CHECKING:
    from translate.pick.command import Choice

CLOCK = "100"  # MHz
FRACTION, REST = 20, 4  # bits of a fraction, and of an octave sum's rest
# In ns, with the wires: a register's part of a clock, a table of four inputs, a multiplier, a carry, and a bit of it.
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


class Piece(NamedTuple):
    """Bits of a gate from `low` on, or its sign as often, or bits of a constant."""
    gate: Gate | None
    low: int
    count: int = 1
    repeats: bool = False

    @property
    def read(self) -> int:
        """The bits of the gate, as a number that has them."""
        return ((1 << (1 if self.repeats else self.count)) - 1) << self.low


class Used:
    """Which bits of each gate are used for some bits of results, and what of its arguments a gate reads."""

    def __init__(self, results: Sequence[tuple[Gate, int]]):
        self.results = results
        self.same: dict[Gate, Gate] = {}  # sums with the used bits of one summand
        while self._find_bits():
            pass

    def _find_bits(self) -> bool:
        """Returns whether more is the same."""
        self.bits: dict[Gate, int] = {}  # which are used
        self.reads: dict[Gate, list[tuple[Gate, int]]] = {}  # arguments, and how many bits of each
        self._joined: dict[tuple[Gate, int], list[Piece]] = {}
        order = [gate for gate in self.reachable() if gate.kind not in ("constant", *WIRING)]
        self._use(self.results)
        for gate in reversed(order):
            if self.bits.get(gate):
                self.reads[gate] = self._reads(gate)
                self._use(self.reads[gate])
        self.order = [gate for gate in order if gate in self.reads]
        before = len(self.same)
        for gate in self.order:
            for one, other in (gate.arguments, gate.arguments[::-1]) if gate.kind == "plus" else ():
                if self.joined(one, self.has(gate)) == [Piece(None, 0, self.has(gate))]:
                    self.same[gate] = other
        return len(self.same) > before

    def _run(self, gate: Gate, low: int, count: int) -> Piece:
        """Where the first of these bits come from, as many as come from one gate: wires are looked through."""
        repeats = False
        while True:
            if gate in self.same:
                gate = self.same[gate]
            elif gate.value is not None:
                value = -(gate.value >> low & 1) if repeats else gate.value >> low
                return Piece(None, value & ((1 << count) - 1), count)
            elif gate.kind == "shr":
                gate, low = gate.arguments[0], low + gate.by
            elif gate.kind == "shl" and low >= gate.by:
                gate, low = gate.arguments[0], low - gate.by
            elif gate.kind == "shl":
                return Piece(None, 0, count if repeats else min(count, gate.by - low))
            elif low < gate.width:
                count = count if repeats else min(count, gate.width - low)
                if gate.kind != "low":
                    return Piece(gate, low, count, repeats)
                gate = gate.arguments[0]
            elif gate.is_signed:
                low, repeats = gate.width - 1, True
            else:
                return Piece(None, 0, count)

    def joined(self, gate: Gate, count: int) -> list[Piece]:
        """Where the lowest bits of a number come from, the lowest first."""
        if (gate, count) not in self._joined:
            found = self._joined[gate, count] = []
            at = 0
            while at < count:
                one, last = self._run(gate, at, count - at), found[-1] if found else None
                at += one.count
                if last and one.gate is last.gate is None:
                    found[-1] = Piece(None, last.low | one.low << last.count, last.count + one.count)
                elif last and one.gate is last.gate and one.low == last.low + last.count and not one.repeats:
                    found[-1] = last._replace(count=last.count + one.count)
                else:
                    found.append(one)
        return self._joined[gate, count]

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

    def sources(self, of: Sequence[tuple[Gate, int]]) -> dict[Gate, int]:
        """The gates of some numbers, and which bits of them."""
        found: dict[Gate, int] = {}
        for gate, count in of:
            for piece in self.joined(gate, count):
                if piece.gate:
                    found[piece.gate] = found.get(piece.gate, 0) | piece.read
        return found

    def _use(self, of: Sequence[tuple[Gate, int]]) -> None:
        for gate, bits in self.sources(of).items():
            self.bits[gate] = self.bits.get(gate, 0) | bits

    def has(self, gate: Gate) -> int:
        """How many bits a gate computes."""
        return self.bits[gate].bit_length()

    def _reads(self, gate: Gate) -> list[tuple[Gate, int]]:
        count = self.has(gate)
        if gate.kind in ("less", "equal"):
            signed = any(one.is_signed for one in gate.arguments)
            count = max(one.width + (signed and not one.is_signed) for one in gate.arguments)
        return [(one, 1 if gate.kind == "choice" and not i else count) for i, one in enumerate(gate.arguments)]


class Pipeline(Used):
    """In which stage each gate is computed."""

    def __init__(self, results: Sequence[tuple[Gate, int]]):
        super().__init__(results)
        self.ahead = {gate: self.sources(self.reads[gate]) for gate in self.order}
        self.delays = {gate: self._delay(gate) for gate in self.order}
        self.shortest = max(self.delays.values(), default=0) + REGISTER  # ns a clock

    def set_clock(self, period: float) -> int:
        """Places the registers, for a clock of so many ns. Returns the latency."""
        if period < self.shortest:
            raise Unknown(f"a clock of {1000 / period:.0f} MHz is too fast for one of its products or sums: at most "
                          f"--clock {int(1000 / self.shortest)}")
        self.stages = self._schedule(period - REGISTER)
        self.latency = max((self.stages[source] for source in self.sources(self.results)), default=0) + 1
        return self.latency

    def set_stages(self, most: int) -> None:
        """Sets the stages of the fastest clock with so few."""
        low, high = 0.0, 2000.0
        for _ in range(16):
            middle = (low + high) / 2
            fits = middle >= self.shortest and self.set_clock(middle) <= most
            low, high = (low, middle) if fits else (middle, high)
        if self.set_clock(high) > most:
            raise Unknown(f"--stages {most}: it takes {self.latency} at the slowest clock, of 0.5 MHz")

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
            start = max((soon[one] for one in self.ahead[gate]), default=(0, 0.0))
            end = start[1] + self.delays[gate]
            soon[gate] = (start[0], end) if end <= room else (start[0] + 1, self.delays[gate])
        last = max((stage for stage, _ in soon.values()), default=0)
        late: dict[Gate, tuple[int, float]] = {}  # when it has to begin
        ends = {source: (last, room) for source in self.sources(self.results)}
        for gate in reversed(self.order):
            stage, end = ends[gate]
            begin = end - self.delays[gate]
            late[gate] = (stage, begin) if begin >= 0 else (stage - 1, room - self.delays[gate])
            for one in self.ahead[gate]:
                ends[one] = min(ends.get(one, late[gate]), late[gate])
        found = [{gate: 0 if gate.kind == "input" else stage for gate, (stage, _) in one.items()}
                 for one in (soon, late)]
        return min((one for one in found if min(one.values(), default=0) >= 0), key=self._registered)

    def _registered(self, stages: Mapping[Gate, int]) -> int:
        """About how many bits registers hold."""
        last = dict(stages)
        for gate in self.order:
            for one in self.ahead[gate]:
                last[one] = max(last[one], stages[gate])
        return sum((last[gate] - stages[gate]) * bin(self.bits[gate]).count("1") for gate in self.order)


def with_multipliers(circuit: Circuit, results: Sequence[tuple[Gate, int]],
                     most: float) -> list[tuple[Gate, int]]:
    """With products that multipliers compute, those that would take the most tables otherwise: at most so many
    multipliers."""
    used = Used(results)
    costs: dict[Gate, tuple[float, int]] = {}  # tables for a multiplier, and multipliers
    for gate in used.order:
        if gate.kind == "times":
            a, b = (min(one.width, used.has(gate)) for one in gate.arguments)
            count = sum(i + j < used.has(gate) for i in range(0, a, WIDEST) for j in range(0, b, WIDEST))
            by = gate.arguments[1].value
            tables = a * b if by is None else a * bin(by).count("1") / 2
            costs[gate] = tables / count, count
    kept: set[Gate] = set()
    for gate in sorted(costs, key=lambda one: (-costs[one][0], one.number)):
        if costs[gate][1] <= most:
            kept.add(gate)
            most -= costs[gate][1]
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
            first, kept, unused = pipeline.stages[gate], 0, []  # bits that the register behind a stage has
            for stage in range(pipeline.latency - 1, first - 1, -1):
                if kept:
                    low, high = (kept & -kept).bit_length() - 1, kept.bit_length() - 1
                    found[stage].append((self._name(gate, stage + 1), f"[{high}:{low}] " if high else "",
                                         self._slice(gate, stage, low, high)))
                read = self.used.get((gate, stage), 0) | kept
                kept = read and (1 << read.bit_length()) - (read & -read)  # all between the first and the last
                if stage == first:
                    kept = (1 << (gate.width if gate.kind == "input" else pipeline.has(gate))) - 1
                runs = re.finditer("1+", f"{kept & ~read:b}"[::-1])
                unused[:0] = [self._slice(gate, stage, run.start(), run.end() - 1) for run in runs]
            self.unused += unused
        return found

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
            self.used[one.gate, stage] = self.used.get((one.gate, stage), 0) | one.read
            text = self._slice(one.gate, stage, one.low, one.read.bit_length() - 1)
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


class FunctionCircuit:
    """A function as a module."""

    def __init__(self, module: Module, asked: Function, library: Path, choice: Choice):
        self.name, self.function = wgsl_name(asked), at_place(module, asked)
        self.facts = of_noise(comments.facts(asked, library, False, choice.knobs), module.summed)
        self.module, self.choice, self.constants = module, choice, constants(choice.constants)
        self.has_rest = any(one.at.text == "octaves" for one in self.function.parameters)
        self.ports: list[Port] = []
        self.outputs: list[Port] = []
        self.circuit = Circuit()
        self.inputs: dict[str, Gate] = {}
        begin_anew()
        ranges = functools.cache(functools.partial(_ranges, library=library))
        evaluation = Unrolled(module, ranges)
        *_, returned = evaluation.run(self.function, self._arguments())
        result = returned.value
        if module.summed and not evaluation.sums_other_noise:
            raise not_summed(module, asked, module.summed)
        if result is None or self.function.type in module.structs:
            raise Unknown(NO_PORT.format(self.name, f"returns {self.function.type}"))
        is_vector = isinstance(result, Operation) and result.kind == "construct" and SIZES[result.type] > 1
        parts = result.arguments if is_vector else (result,)
        lowering = Lowering(self.name, self.circuit, self.inputs, evaluation.known, evaluation.hints)
        self.values = [lowering.of(part) for part in parts]
        known = ranges(asked)
        known = known[:1] if len(parts) == 1 else known if len(known) == len(parts) else []
        results: list[tuple[Gate, int]] = []
        for axis, part, value, range_ in itertools.zip_longest(AXES[:len(parts)], parts, self.values, known):
            gate = value.whole
            if range_ and part.type == "float":
                gate = self.circuit.within(gate, *(int(end * 2**value.places) for end in range_))
            what = f"in units of 2^{-value.places}" if value.places else "a whole number"
            self.outputs.append(Port(f"value_{axis}" if is_vector else "value", gate.low, gate.high, what))
            results.append((gate, gate.width))
        self.pipeline = Pipeline(with_multipliers(self.circuit, results, float(choice.multipliers or "inf")))
        if choice.stages:
            self.pipeline.set_stages(int(choice.stages))
        else:
            self.pipeline.set_clock(1000 / float(choice.clock or CLOCK))

    def _arguments(self) -> list[Typed]:
        """A constant for each parameter that is known, and a port for each other one."""
        missing, found = [], []
        for parameter in self.function.parameters:
            name, type_ = parameter.at.text, parameter.type
            is_place = re.fullmatch("hn_place[1-4]", type_)
            leaves = {}
            if name in self.constants:
                leaves[()] = _constant(name, type_, self.constants[name])
            elif parameter.is_set or type_ in self.module.structs and not is_place:
                takes = f"takes {type_}" if type_ in self.module.structs else f"sets {name}"
                raise Unknown(NO_PORT.format(self.name, takes))
            elif type_.startswith(("float", "vec")) or name in ("octaves", "metric", "kind"):
                missing.append((name, type_))
            else:
                leaves = {path: self._of_place(path, scalar) if is_place else
                          self._port(dotted((name, *path)), scalar, self.facts.parameters.get(name, ""))
                          for path, scalar in self.module.parts(type_)}
            found.append(Typed(type_, leaves))
        if missing:
            *names, last = [name for name, _ in missing]
            raise Unknown(f"{self.name} takes {', '.join(names)}{' and ' * bool(names)}{last}, which a circuit has as "
                          f"constants: add --constants {','.join(f'{name}={_usual(name, type_)}' for name, type_ in missing)}")
        return found

    def _of_place(self, path: tuple[str, ...], type_: str) -> Constant | Variable:
        if path[0] in ("period", "tiled") or path[0] == "rest" and not self.has_rest:
            return Constant(type_, 0)
        return self._port(dotted(path), path[0], "")

    def _port(self, name: str, kind: str, what: str) -> Variable:
        bits, is_signed, what = {
            "cell": (32, True, "the cell along that axis"),
            "fraction": (FRACTION, False, f"the position in the cell, in units of 2^-{FRACTION}"),
            "rest": (REST, False, f"the bits behind the fraction, in units of 2^-{FRACTION + REST}"),
            "int": (32, True, what), "uint": (32, False, what.replace("any uint: 7u, not 7", "any")),
            "bool": (1, False, what)}[kind]
        shown = variable(name, RESERVED)
        low, high = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if is_signed else (0, (1 << bits) - 1)
        self.ports.append(Port(shown, low, high, what))
        self.inputs[name] = self.circuit.input(shown, low, high)
        return Variable(kind if kind in SIZES else "int", name, is_parameter=True)

    @property
    def read(self) -> list[Port]:
        """The ports that the module needs."""
        names = {gate.by for gate in self.pipeline.order if gate.kind == "input"}
        return [port for port in self.ports if port.name in names]

    def text(self) -> str:
        taken = {port.name for port in (*self.ports, *self.outputs)}
        names = {gate: gate.by if gate.kind == "input" else _free(gate.name or "n", taken) for gate in self.pipeline.order}
        lines = Text(self.pipeline, names, [port.name for port in self.outputs]).lines()
        ports = ",\n".join(["    input wire clock", *(f"    input wire {port.declared}" for port in self.read),
                            *(f"    output reg {port.declared}" for port in self.outputs)])
        body = "".join(f"  {one}\n" if one else "\n" for line in lines for one in textwrap.wrap(
            line, 118, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False) or [""])
        return f"module {self.name} (\n{ports}\n);\n{body}endmodule\n"

    def comment(self) -> list[str]:
        rows = {port.name: f"{port.width} bits, {'signed' if port.low < 0 else 'unsigned'}: {port.what}"
                for port in (*self.read, *self.outputs)}
        rows |= {"latency": f"{self.pipeline.latency} clocks; a value leaves at each", "returns": self.facts.returns}
        given = ", ".join(f"{name} {value}" for name, value in self.constants.items())
        return comments.laid_out(self.facts.what + (f" Here {given}." if given else ""), rows, 118)


def circuits(names: Sequence[str], choice: Choice, module: Module, library: Path) -> list[FunctionCircuit]:
    return [FunctionCircuit(module, one, library, choice) for one in chosen(module, names)]


def constants(text: str) -> dict[str, str]:
    """The constants of NAME=VALUE,NAME=VALUE."""
    found: dict[str, str] = {}
    for one in filter(None, text.split(",")):
        name, sign, value = one.partition("=")
        if not sign:
            raise Unknown(f"--constants {text}: {one} has no value; write {name}=VALUE")
        found[name.strip()] = value.strip()
    return found


def _ranges(function: Function, library: Path) -> list[tuple[Fraction, Fraction]]:
    """The ranges of its results, such as [-1, 1], as its comment states them. Distances have others in other metrics."""
    if any(one.at.text == "metric" for one in function.parameters):
        return []
    returns = comments.facts(function, library, False).returns
    return [(Fraction(low), Fraction(high)) for low, high in re.findall(
        r"\[(-?\d[\d.]*), (\d+(?:\.\d+)?)[\])]", returns)]


def _free(name: str, taken: set[str]) -> str:
    name = variable(name, RESERVED)
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
    return Constant(type_, value & WORD if type_ == "uint" else value)


def text(made: Sequence[FunctionCircuit], heading: Sequence[str]) -> str:
    known = [one.at.text for of in made for one in of.function.parameters]
    if unknown := [name for name in made[0].constants if name not in known]:
        raise Unknown(f"--constants {unknown[0]}: {made[0].name} has no such parameter; it takes "
                      f"{', '.join(one.at.text for one in made[0].function.parameters)}")
    parts = ["".join(f"//{line}\n" for line in one.comment()) + one.text() for one in made]
    begin = "".join(f"//{line}\n" for line in heading)
    return f"{begin}\n`default_nettype none\n\n" + "\n".join(parts) + "\n`default_nettype wire\n"
