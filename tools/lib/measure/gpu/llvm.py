"""Shaders as LLVM's text, for compilers that take no SPIR-V of Vulkan: NVIDIA's ptxas, and Intel's IGC.

The SPIR-V is what Mesa's drivers are given: a fragment shader without calls, as the optimizer of hn-conform leaves it.
It becomes a kernel that reads its inputs from memory and writes its result there. An operation of GLSL becomes one of
LLVM, so that a minimum stays a minimum, and what is `precise` is contracted by no compiler.
"""

from __future__ import annotations

import hashlib
import math
import re
import struct
import subprocess
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

NAME = "@kernel"  # in the definition of one, until a module names it
STRIDE = 1024  # floats between the components of an input in memory
# Behind the last branch of a loop. A loop that always runs as often is written out, so that its steps are counted.
LOOP = ", !llvm.loop !loop"
WRITTEN_OUT = 1_000_000  # the number of the metadata for it; the numbers of loops come next


class Unsupported(Exception):
    """SPIR-V without a translation here."""


@dataclass(frozen=True, eq=False)
class Target:
    """Differences of the compilers behind LLVM."""
    head: str  # of a module: its layout and triple
    kernel: str  # what stands between `define` and `void`
    index: tuple[str, ...]  # lines that set %index, an i64
    declarations: str
    functions: dict[str, str]  # by the names of GLSL.std.450 and of operations
    exact: dict[str, str]  # functions for sums and products that must not be contracted
    constants: int  # the address space of tables
    attributes: str = ""  # of kernels, behind their parameters
    tail: str = ""  # of a module
    annotation: str = ""  # a line for each kernel, of metadata


class Type(NamedTuple):
    text: str  # of LLVM
    kind: str  # "int", "float", "bool", "vector", "array", "struct", "pointer", "void" or "function"
    part: str = ""  # the id of the type of components, or of what is pointed to
    count: int = 0
    parts: tuple[str, ...] = ()  # of a struct


BINARY = {
    "OpIAdd": "add", "OpISub": "sub", "OpIMul": "mul", "OpUDiv": "udiv", "OpSDiv": "sdiv", "OpUMod": "urem",
    "OpSRem": "srem", "OpBitwiseAnd": "and", "OpBitwiseOr": "or", "OpBitwiseXor": "xor", "OpLogicalAnd": "and",
    "OpLogicalOr": "or", "OpLogicalNotEqual": "xor",
}
SHIFTS = {"OpShiftLeftLogical": "shl", "OpShiftRightLogical": "lshr", "OpShiftRightArithmetic": "ashr"}
FLOATS = {"OpFAdd": "fadd", "OpFSub": "fsub", "OpFMul": "fmul"}
COMPARISONS = {
    "OpIEqual": "icmp eq", "OpINotEqual": "icmp ne", "OpULessThan": "icmp ult", "OpULessThanEqual": "icmp ule",
    "OpUGreaterThan": "icmp ugt", "OpUGreaterThanEqual": "icmp uge", "OpSLessThan": "icmp slt",
    "OpSLessThanEqual": "icmp sle", "OpSGreaterThan": "icmp sgt", "OpSGreaterThanEqual": "icmp sge",
    "OpLogicalEqual": "icmp eq", "OpFOrdEqual": "fcmp oeq", "OpFOrdNotEqual": "fcmp one",
    "OpFUnordNotEqual": "fcmp une", "OpFOrdLessThan": "fcmp olt", "OpFOrdLessThanEqual": "fcmp ole",
    "OpFOrdGreaterThan": "fcmp ogt", "OpFOrdGreaterThanEqual": "fcmp oge",
}
CONVERSIONS = {
    "OpConvertFToS": "fptosi", "OpConvertFToU": "fptoui", "OpConvertSToF": "sitofp", "OpConvertUToF": "uitofp",
}
INTRINSICS = {
    "Floor": "llvm.floor", "Ceil": "llvm.ceil", "Trunc": "llvm.trunc", "FAbs": "llvm.fabs", "Fma": "llvm.fma",
    "FMin": "llvm.minnum", "FMax": "llvm.maxnum", "UMin": "llvm.umin", "UMax": "llvm.umax", "SMin": "llvm.smin",
    "SMax": "llvm.smax", "RoundEven": "llvm.rint", "Round": "llvm.rint",
}
IGNORED = frozenset({
    "OpCapability", "OpExtension", "OpExtInstImport", "OpMemoryModel", "OpEntryPoint", "OpExecutionMode", "OpSource",
    "OpSourceExtension", "OpString", "OpName", "OpMemberName", "OpLoopMerge", "OpSelectionMerge", "OpLine", "OpNoLine",
    "OpFunctionEnd", "OpMemberDecorate", "OpModuleProcessed"})
STORE = re.compile(r"OpStore (\S+) (\S+)")
OPERAND = re.compile(r'"[^"]*"|\S+')


class Kernel:
    """One shader: translates it line by line."""

    def __init__(self, target: Target):
        self.target = target
        self.types: dict[str, Type] = {}
        self.typed: dict[str, str] = {}  # the id of the type of each value
        self.constants: dict[str, str] = {}
        self.numbers: dict[str, int] = {}  # of constants, for indices
        self.exact: set[str] = set()  # NoContraction
        self.variables: list[tuple[str, str, str, str]] = []  # id, type, storage class, initializer
        self.tables: dict[str, str] = {}  # variables that hold a constant alone, and its id
        self.in_tables: set[str] = set()  # pointers into those
        self.labels: set[str] = set()
        self.declared: set[str] = set()
        self.definition = ""
        self.has_exact_product = False
        self.body: list[str] = []
        self.fresh = 0

    # Values, as LLVM writes them.
    def value(self, id: str) -> str:
        return self.constants.get(id, f"%v{id[1:]}")

    def type(self, id: str) -> str:
        return self.types[id].text

    def of(self, id: str) -> str:
        return f"ptr addrspace({self.target.constants})" if id in self.in_tables else self.type(self.typed[id])

    def both(self, id: str) -> str:
        return f"{self.of(id)} {self.value(id)}"

    def emit(self, text: str) -> str:
        """A line that makes a value without an id of its own."""
        self.fresh += 1
        self.body.append(f"  %t{self.fresh} = {text}")
        return f"%t{self.fresh}"

    def set(self, id: str, type: str, text: str) -> None:
        self.typed[id] = type
        self.body.append(f"  %v{id[1:]} = {text}")

    def splat(self, value: str, vector: str) -> str:
        """A vector with the float in each component."""
        return self.emit(self.assembled(vector, [f"float {value}"] * self.types[vector].count))

    def assembled(self, type: str, parts: Sequence[str]) -> str:
        """A vector, an array or a struct of parts, each with its type. Returns what to set the result to."""
        text, made = self.type(type), "undef"
        for place, part in enumerate(parts):
            line = (f"insertelement {text} {made}, {part}, i32 {place}" if self.types[type].kind == "vector" else
                    f"insertvalue {text} {made}, {part}, {place}")
            if place < len(parts) - 1:
                made = self.emit(line)
        return line

    def component(self, vector: str, place: int) -> str:
        """One of a vector, which stands behind its type."""
        return self.emit(f"extractelement {vector}, i32 {place}")

    def call(self, function: str, type: str, arguments: Sequence[str]) -> str:
        """A function of LLVM's, which takes vectors, with the suffix of the type."""
        found = self.types[type]
        suffix = f"v{found.count}{self._letter(found.part)}" if found.kind == "vector" else self._letter(type)
        name = f"@{function}.{suffix}"
        text = found.text
        self.declared.add(f"declare {text} {name}({', '.join([text] * len(arguments))})")
        return f"call {text} {name}({', '.join(f'{text} {argument}' for argument in arguments)})"

    def _letter(self, type: str) -> str:
        return "f32" if self.types[type].kind == "float" else "i32"

    def each(self, function: str, type: str, arguments: Sequence[str]) -> str:
        """A function of one target, which takes floats: for each component. Returns what to set the result to."""
        found = self.types[type]
        self.declared.add(f"declare float @{function}({', '.join(['float'] * len(arguments))})")
        if found.kind != "vector":
            return f"call float @{function}({', '.join(f'float {argument}' for argument in arguments)})"
        made = []
        for place in range(found.count):
            parts = [f"float {self.component(f'{found.text} {argument}', place)}" for argument in arguments]
            made.append(f"float {self.emit(f'call float @{function}({{}})'.format(', '.join(parts)))}")
        return self.assembled(type, made)

    def arithmetic(self, id: str, op: str, type: str, left: str, right: str) -> str:
        if id not in self.exact:
            return f"{FLOATS[op]} contract {self.type(type)} {left}, {right}"
        self.has_exact_product |= op == "OpFMul"
        if op == "OpFSub":
            right, op = self.emit(f"fneg {self.type(type)} {right}"), "OpFAdd"
        if op in self.target.exact:
            return self.each(self.target.exact[op], type, (left, right))
        return f"{FLOATS[op]} {self.type(type)} {left}, {right}"

    def find_tables(self, lines: Sequence[str]) -> None:
        """Arrays that are written once, as a whole: GLSL's constant arrays, which a compiler reads from memory of
        constants."""
        constants = {line.split()[0] for line in lines if " = OpConstantComposite " in line}
        written = [STORE.match(line).groups() for line in lines if line.startswith("OpStore ")]
        chains = {line.split()[0]: line.split()[4] for line in lines if " = OpAccessChain " in line}
        values: dict[str, set[str]] = {}
        for pointer, value in written:
            values.setdefault(chains.get(pointer, pointer), set()).add("" if pointer in chains else value)
        for line in lines:
            if " = OpVariable " in line and line.split()[4] in ("Function", "Private"):
                id, *initial = line.split()[0], *line.split()[5:]
                found = values.get(id, set()) | set(initial)
                if len(found) == 1 and found <= constants:
                    self.tables[id] = next(iter(found))

    def take(self, line: str) -> None:
        result, _, rest = line.rpartition(" = ")
        op, *words = OPERAND.findall(rest)
        if op in IGNORED:
            return
        method = getattr(self, op, None)
        if method:
            method(result, *words)
        elif op in BINARY:
            type, left, right = words
            self.set(result, type, f"{BINARY[op]} {self.type(type)} {self.value(left)}, {self.value(right)}")
        elif op in SHIFTS:
            type, left, right = words
            count = self.value(right)
            if right not in self.constants:  # LLVM would leave out what depends on a shift by more
                count = self.emit(f"and {self.type(type)} {count}, {self._filled(type, 31)}")
            self.set(result, type, f"{SHIFTS[op]} {self.type(type)} {self.value(left)}, {count}")
        elif op in FLOATS:
            type, left, right = words
            self.set(result, type, self.arithmetic(result, op, type, self.value(left), self.value(right)))
        elif op in COMPARISONS:
            type, left, right = words
            self.set(result, type, f"{COMPARISONS[op]} {self.both(left)}, {self.value(right)}")
        elif op in CONVERSIONS:
            type, source = words
            text = f"{CONVERSIONS[op]} {self.both(source)} to {self.type(type)}"
            # The same holds for a number that does not fit.
            self.set(result, type, text if "tofp" in text else f"freeze {self.type(type)} {self.emit(text)}")
        else:
            raise Unsupported(f"{op} has no translation")

    def OpDecorate(self, _: str, id: str, decoration: str, *__: str) -> None:
        if decoration == "NoContraction":
            self.exact.add(id)

    def OpTypeVoid(self, id: str) -> None:
        self.types[id] = Type("void", "void")

    def OpTypeBool(self, id: str) -> None:
        self.types[id] = Type("i1", "bool")

    def OpTypeInt(self, id: str, width: str, _: str) -> None:
        self.types[id] = Type(f"i{width}", "int")

    def OpTypeFloat(self, id: str, width: str) -> None:
        if width != "32":
            raise Unsupported(f"floats of {width} bits have no translation")
        self.types[id] = Type("float", "float")

    def OpTypeVector(self, id: str, part: str, count: str) -> None:
        self.types[id] = Type(f"<{count} x {self.type(part)}>", "vector", part, int(count))

    def OpTypeMatrix(self, id: str, part: str, count: str) -> None:
        self.types[id] = Type(f"[{count} x {self.type(part)}]", "array", part, int(count))

    def OpTypeArray(self, id: str, part: str, count: str) -> None:
        size = self.numbers[count]
        self.types[id] = Type(f"[{size} x {self.type(part)}]", "array", part, size)

    def OpTypeStruct(self, id: str, *parts: str) -> None:
        self.types[id] = Type(f"{{ {', '.join(map(self.type, parts))} }}", "struct", parts=parts)

    def OpTypePointer(self, id: str, _: str, part: str) -> None:
        self.types[id] = Type("ptr", "pointer", part)

    def OpTypeFunction(self, id: str, *_: str) -> None:
        self.types[id] = Type("", "function")

    def _constant(self, id: str, type: str, text: str) -> None:
        self.typed[id], self.constants[id] = type, text

    def OpConstant(self, id: str, type: str, text: str) -> None:
        if self.types[type].kind == "int":
            self.numbers[id] = int(text)
            self._constant(id, type, text)
        else:
            self._constant(id, type, float_constant(text))

    def OpConstantTrue(self, id: str, type: str) -> None:
        self._constant(id, type, "true")

    def OpConstantFalse(self, id: str, type: str) -> None:
        self._constant(id, type, "false")

    def OpConstantNull(self, id: str, type: str) -> None:
        self._constant(id, type, "zeroinitializer")

    def OpUndef(self, id: str, type: str) -> None:
        self._constant(id, type, "undef")

    def OpConstantComposite(self, id: str, type: str, *parts: str) -> None:
        opening, closing = {"vector": "<>", "array": "[]", "struct": "{}"}[self.types[type].kind]
        self._constant(id, type, f"{opening}{', '.join(map(self.both, parts))}{closing}")

    def OpVariable(self, id: str, type: str, storage: str, initial: str = "") -> None:
        if storage not in ("Input", "Output", "Private", "Function"):
            raise Unsupported(f"variables that are {storage} have no translation")
        self.typed[id] = type
        if self.tables.get(id) in self.constants and self.types[self.types[type].part].kind == "array":
            text = f"{self.both(self.tables[id])}"
            name = f"@table_{hashlib.sha256(text.encode()).hexdigest()[:16]}"
            self.declared.add(f"{name} = private unnamed_addr addrspace({self.target.constants}) constant {text}")
            self.constants[id] = name
            self.in_tables.add(id)
            return
        self.variables.append((id, self.types[type].part, storage, initial))

    def OpFunction(self, *_: str) -> None:
        if self.body:
            raise Unsupported("a call of a function has no translation")
        self.body.append("  ; variables")  # which are known at the end

    def OpLabel(self, id: str) -> None:
        self.labels.add(id)
        self.body.append(f"l{id[1:]}:")

    def _end(self, text: str, *labels: str) -> None:
        """The end of a block. One that goes back to a label closes a loop."""
        self.body.append(text + LOOP * any(label in self.labels for label in labels))

    def OpBranch(self, _: str, label: str) -> None:
        self._end(f"  br label %l{label[1:]}", label)

    def OpBranchConditional(self, _: str, condition: str, yes: str, no: str, *__: str) -> None:
        self._end(f"  br {self.both(condition)}, label %l{yes[1:]}, label %l{no[1:]}", yes, no)

    def OpSwitch(self, _: str, selector: str, default: str, *pairs: str) -> None:
        cases = " ".join(f"{self.of(selector)} {number}, label %l{label[1:]}"
                         for number, label in zip(pairs[::2], pairs[1::2]))
        self.body.append(f"  switch {self.both(selector)}, label %l{default[1:]} [ {cases} ]")

    def OpPhi(self, id: str, type: str, *pairs: str) -> None:
        # A value that stands further below is known by its name.
        self.set(id, type, f"phi {self.type(type)} " + ", ".join(
            f"[ {self.value(value)}, %l{label[1:]} ]" for value, label in zip(pairs[::2], pairs[1::2])))

    def OpReturn(self, _: str) -> None:
        self.body.append("  br label %end")

    def OpKill(self, _: str) -> None:
        self.body.append("  br label %end")

    def OpUnreachable(self, _: str) -> None:
        self.body.append("  unreachable")

    def OpLoad(self, id: str, type: str, pointer: str, *_: str) -> None:
        self.set(id, type, f"load {self.type(type)}, {self.both(pointer)}")

    def OpStore(self, _: str, pointer: str, value: str, *__: str) -> None:
        if pointer in self.in_tables:
            return
        self.body.append(f"  store {self.both(value)}, {self.both(pointer)}")

    def OpAccessChain(self, id: str, type: str, base: str, *indices: str) -> None:
        pointed = self.type(self.types[self.typed[base]].part)
        self.set(id, type, f"getelementptr {pointed}, {self.both(base)}, i32 0, {', '.join(map(self.both, indices))}")
        if base in self.in_tables:
            self.in_tables.add(id)

    def OpCopyObject(self, id: str, type: str, value: str) -> None:
        self.set(id, type, f"select i1 true, {self.both(value)}, {self.both(value)}")

    def OpSelect(self, id: str, type: str, condition: str, yes: str, no: str) -> None:
        self.set(id, type, f"select {self.both(condition)}, {self.both(yes)}, {self.both(no)}")

    def OpBitcast(self, id: str, type: str, value: str) -> None:
        self.set(id, type, f"bitcast {self.both(value)} to {self.type(type)}")

    def OpFNegate(self, id: str, type: str, value: str) -> None:
        self.set(id, type, f"fneg {self.both(value)}")

    def OpSNegate(self, id: str, type: str, value: str) -> None:
        self.set(id, type, f"sub {self.type(type)} zeroinitializer, {self.value(value)}")

    def OpNot(self, id: str, type: str, value: str) -> None:
        self.set(id, type, f"xor {self.both(value)}, {self._filled(type, -1)}")

    OpLogicalNot = OpNot

    def OpVectorTimesScalar(self, id: str, type: str, vector: str, scalar: str) -> None:
        self.set(id, type, self.arithmetic(id, "OpFMul", type, self.value(vector),
                                           self.splat(self.value(scalar), type)))

    def OpFDiv(self, id: str, type: str, left: str, right: str) -> None:
        self.set(id, type, self._divided(type, self.value(left), self.value(right)))

    def _divided(self, type: str, left: str, right: str) -> str:
        return self.each(self.target.functions["OpFDiv"], type, (left, right))

    def OpFMod(self, id: str, type: str, left: str, right: str) -> None:
        text, x, y = self.type(type), self.value(left), self.value(right)
        whole = self.emit(self.call("llvm.floor", type, [self.emit(self._divided(type, x, y))]))
        self.set(id, type, f"fsub contract {text} {x}, {self.emit(f'fmul contract {text} {whole}, {y}')}")

    def OpSMod(self, id: str, type: str, left: str, right: str) -> None:
        text, y = self.type(type), self.value(right)
        rest = self.emit(f"srem {text} {self.value(left)}, {y}")
        bits = self._like(type, "i1")
        other = self.emit(f"icmp slt {text} {self.emit(f'xor {text} {rest}, {y}')}, zeroinitializer")
        some = self.emit(f"icmp ne {text} {rest}, zeroinitializer")
        both = self.emit(f"and {bits} {other}, {some}")
        self.set(id, type, f"select {bits} {both}, {text} {self.emit(f'add {text} {rest}, {y}')}, {text} {rest}")

    def _sum_of_products(self, left: str, right: str) -> str:
        """The dot product, of values of one type: the name of a float."""
        vector, total = self.types[self.typed[left]], ""
        for index in range(vector.count):
            x, y = (self.component(self.both(side), index) for side in (left, right))
            product = self.emit(f"fmul contract float {x}, {y}")
            total = self.emit(f"fadd contract float {total}, {product}") if total else product
        return total

    def OpDot(self, id: str, type: str, left: str, right: str) -> None:
        self.set(id, type, f"fadd contract float {self._sum_of_products(left, right)}, -0.0")

    def OpMatrixTimesVector(self, id: str, type: str, matrix: str, vector: str) -> None:
        found, total = self.types[self.typed[matrix]], ""
        for index in range(found.count):
            column = self.emit(f"extractvalue {self.both(matrix)}, {index}")
            factor = self.splat(self.component(self.both(vector), index), type)
            product = self.emit(f"fmul contract {self.type(type)} {column}, {factor}")
            total = self.emit(f"fadd contract {self.type(type)} {total}, {product}") if total else product
        self.set(id, type, f"fadd contract {self.type(type)} {total}, {self._filled(type, -0.0)}")

    def OpVectorTimesMatrix(self, id: str, type: str, vector: str, matrix: str) -> None:
        found, made = self.types[self.typed[matrix]], []
        for index in range(found.count):
            column = f"{matrix} {index}"
            self._constant(column, found.part, self.emit(f"extractvalue {self.both(matrix)}, {index}"))
            made.append(f"float {self._sum_of_products(vector, column)}")
        self.set(id, type, self.assembled(type, made))

    def OpCompositeConstruct(self, id: str, type: str, *parts: str) -> None:
        texts = []
        for part in parts:
            inner = self.types[self.typed[part]]
            if self.types[type].kind == "vector" and inner.kind == "vector":
                texts += [f"{self.type(inner.part)} {self.component(self.both(part), place)}"
                          for place in range(inner.count)]
            else:
                texts.append(self.both(part))
        self.set(id, type, self.assembled(type, texts))

    def OpCompositeExtract(self, id: str, type: str, composite: str, *indices: str) -> None:
        value, kind = self.value(composite), self.typed[composite]
        for place, index in enumerate(indices):
            found = self.types[kind]
            text = (f"extractelement {found.text} {value}, i32 {index}" if found.kind == "vector" else
                    f"extractvalue {found.text} {value}, {index}")
            kind = found.parts[int(index)] if found.kind == "struct" else found.part
            if place < len(indices) - 1:
                value = self.emit(text)
        self.set(id, type, text)

    def OpCompositeInsert(self, id: str, type: str, part: str, composite: str, *indices: str) -> None:
        if len(indices) != 1:
            raise Unsupported("OpCompositeInsert into a part of a part has no translation")
        found = self.types[type]
        self.set(id, type, f"insertelement {self.both(composite)}, {self.both(part)}, i32 {indices[0]}"
                 if found.kind == "vector" else f"insertvalue {self.both(composite)}, {self.both(part)}, {indices[0]}")

    def OpVectorExtractDynamic(self, id: str, type: str, vector: str, index: str) -> None:
        self.set(id, type, f"extractelement {self.both(vector)}, {self.both(index)}")

    def OpVectorShuffle(self, id: str, type: str, left: str, right: str, *places: str) -> None:
        left_count, right_count = (self.types[self.typed[side]].count for side in (left, right))
        if left_count == right_count:
            mask = ", ".join("i32 undef" if place == "0xFFFFFFFF" else f"i32 {place}" for place in places)
            self.set(id, type, f"shufflevector {self.both(left)}, {self.both(right)}, <{len(places)} x i32> <{mask}>")
            return
        part = self.type(self.types[type].part)  # LLVM shuffles vectors of one length
        sources = [(left, place) if place < left_count else (right, place - left_count) for place in map(int, places)]
        self.set(id, type, self.assembled(type, [f"{part} {self.component(self.both(source), place)}"
                                                 for source, place in sources]))

    def OpAny(self, id: str, type: str, vector: str) -> None:
        self._joined(id, type, vector, "or")

    def OpAll(self, id: str, type: str, vector: str) -> None:
        self._joined(id, type, vector, "and")

    def _joined(self, id: str, type: str, vector: str, operation: str) -> None:
        parts = [self.component(self.both(vector), place) for place in range(self.types[self.typed[vector]].count)]
        while len(parts) > 2:
            parts[:2] = [self.emit(f"{operation} i1 {parts[0]}, {parts[1]}")]
        self.set(id, type, f"{operation} i1 {parts[0]}, {parts[1]}")

    def OpUMulExtended(self, id: str, type: str, left: str, right: str) -> None:
        wide = [self.emit(f"zext {self.both(side)} to i64") for side in (left, right)]
        product = self.emit(f"mul i64 {wide[0]}, {wide[1]}")
        low = self.emit(f"trunc i64 {product} to i32")
        high = self.emit(f"trunc i64 {self.emit(f'lshr i64 {product}, 32')} to i32")
        made = self.emit(f"insertvalue {self.type(type)} undef, i32 {low}, 0")
        self.set(id, type, f"insertvalue {self.type(type)} {made}, i32 {high}, 1")

    def OpExtInst(self, id: str, type: str, _: str, name: str, *arguments: str) -> None:
        values, text = [self.value(argument) for argument in arguments], self.type(type)
        if name in INTRINSICS:
            self.set(id, type, self.call(INTRINSICS[name], type, values))
        elif name in self.target.functions:
            self.set(id, type, self.each(self.target.functions[name], type, values))
        elif name == "Fract":
            floor = self.emit(self.call("llvm.floor", type, values))
            self.set(id, type, f"fsub contract {text} {values[0]}, {floor}")
        elif name in ("FClamp", "UClamp", "SClamp", "NClamp"):
            low, high = (INTRINSICS[f"{name[0].replace('N', 'F')}{side}"] for side in ("Max", "Min"))
            self.set(id, type, self.call(high, type, [self.emit(self.call(low, type, values[:2])), values[2]]))
        elif name == "FMix":
            slope = self.emit(f"fsub contract {text} {values[1]}, {values[0]}")
            product = self.emit(f"fmul contract {text} {slope}, {values[2]}")
            self.set(id, type, f"fadd contract {text} {product}, {values[0]}")
        elif name == "Step":
            self.set(id, type, self._step(type, *values))
        elif name == "FSign":
            zero = "zeroinitializer"
            up, down = (self.emit(f"fcmp {order} {text} {values[0]}, {zero}") for order in ("ogt", "olt"))
            bits = self._like(type, "i1")
            ones = [self.emit(f"uitofp {bits} {side} to {text}") for side in (up, down)]
            self.set(id, type, f"fsub {text} {ones[0]}, {ones[1]}")
        elif name == "SAbs":
            negative = self.emit(f"sub {text} zeroinitializer, {values[0]}")
            self.set(id, type, self.call("llvm.smax", type, [values[0], negative]))
        elif name in ("Exp", "Log", "Pow"):
            self.set(id, type, self._power(name, type, *values))
        elif name == "Length":
            self.set(id, type, self.each(self.target.functions["Sqrt"], type,
                                         [self._sum_of_products(arguments[0], arguments[0])]))
        elif name == "Normalize":
            root = self.emit(self.each(self.target.functions["InverseSqrt"], self.types[type].part,
                                       [self._sum_of_products(arguments[0], arguments[0])]))
            self.set(id, type, f"fmul contract {text} {values[0]}, {self.splat(root, type)}")
        elif name == "SmoothStep":
            self._smooth_step(id, type, *values)
        else:
            raise Unsupported(f"GLSL's {name} has no translation")

    def _like(self, type: str, part: str) -> str:
        found = self.types[type]
        return f"<{found.count} x {part}>" if found.kind == "vector" else part

    def _step(self, type: str, edge: str, x: str) -> str:
        above = self.emit(f"fcmp oge {self.type(type)} {x}, {edge}")
        return f"uitofp {self._like(type, 'i1')} {above} to {self.type(type)}"

    def _power(self, name: str, type: str, x: str, exponent: str = "") -> str:
        """By powers and logarithms of 2, which GPUs have."""
        if name != "Exp":
            x = self.emit(self.each(self.target.functions["Log2"], type, (x,)))
        factor = exponent or self._filled(type, math.log2(math.e) if name == "Exp" else math.log(2.0))
        product = f"fmul contract {self.type(type)} {x}, {factor}"
        return product if name == "Log" else self.each(self.target.functions["Exp2"], type, (self.emit(product),))

    def _filled(self, type: str, number: float) -> str:
        found = self.types[type]
        part = self.type(found.part) if found.kind == "vector" else found.text
        one = float_constant(str(number)) if part == "float" else str(number)
        return f"<{', '.join([f'{part} {one}'] * found.count)}>" if found.kind == "vector" else one

    def _smooth_step(self, id: str, type: str, low: str, high: str, x: str) -> None:
        text = self.type(type)
        span, offset = (self.emit(f"fsub contract {text} {side}, {low}") for side in (high, x))
        ratio = self.emit(self._divided(type, offset, span))
        ratio = self.emit(self.call("llvm.maxnum", type, [ratio, self._filled(type, 0.0)]))
        ratio = self.emit(self.call("llvm.minnum", type, [ratio, self._filled(type, 1.0)]))
        square = self.emit(f"fmul contract {text} {ratio}, {ratio}")
        twice = self.emit(f"fmul contract {text} {ratio}, {self._filled(type, 2.0)}")
        left = self.emit(f"fsub contract {text} {self._filled(type, 3.0)}, {twice}")
        self.set(id, type, f"fmul contract {text} {square}, {left}")

    def finish(self) -> None:
        """Makes the definition. Inputs and the result lie in memory, component by component."""
        head, tail, place = list(self.target.index), ["end:"], {"Input": 0, "Output": 0}
        for id, type, storage, initial in self.variables:
            name = f"%v{id[1:]}"
            head.append(f"  {name} = alloca {self.type(type)}")
            if initial:
                head.append(f"  store {self.type(type)} {self.value(initial)}, ptr {name}")
            if storage not in place:
                continue
            found = self.types[type]
            if "float" not in (found.text, self.type(found.part) if found.kind == "vector" else ""):
                raise Unsupported("inputs and results other than floats have no translation")
            lines, memory = (head, "%in") if storage == "Input" else (tail, "%out")
            for index in range(found.count or 1):
                step = f"{name}_{index}"
                lines += [f"  {step}i = add i64 %index, {STRIDE * place[storage]}",
                          f"  {step}m = getelementptr float, ptr addrspace(1) {memory}, i64 {step}i",
                          f"  {step}o = getelementptr float, ptr {name}, i32 {index}"]
                ends = [f"ptr addrspace(1) {step}m", f"ptr {step}o"]
                source, target = ends if storage == "Input" else reversed(ends)
                lines += [f"  {step} = load float, {source}", f"  store float {step}, {target}"]
                place[storage] += 1
        first = next(line for line in self.body if line.endswith(":"))
        body = self.body[1:]  # less the place of the variables
        self.definition = "\n".join([f"define {self.target.kernel}void {NAME}(ptr addrspace(1) noalias %in, "
                                      f"ptr addrspace(1) noalias %out) {self.target.attributes}{{", "entry:", *head,
                                      f"  br label %{first[:-1]}", *body, *tail, "  ret void", "}"])


def float_constant(text: str) -> str:
    """As LLVM writes it: the bits of a double."""
    number = float.fromhex(text) if "x" in text else float(text)
    if abs(number) >= 2.0 ** 128:  # how spirv-dis writes what is no number
        number = math.copysign(math.inf if abs(number) == 2.0 ** 128 else math.nan, number)
    number = struct.unpack("<f", struct.pack("<f", number))[0]
    return f"0x{struct.unpack('<Q', struct.pack('<d', number))[0]:016X}"


def kernel_of(text: str, target: Target) -> Kernel:
    """The shader that spirv-dis printed. Unsupported if it has what has no translation."""
    lines = [line for line in text.splitlines() if line and not line.startswith(";")]
    kernel = Kernel(target)
    kernel.find_tables(lines)
    for line in lines:
        kernel.take(line)
    kernel.finish()
    return kernel


class Kernels:
    """Shaders, translated once for each target."""

    def __init__(self, texts: Mapping[str, str]):
        self.texts, self.lock = texts, threading.Lock()
        self.found: dict[Target, dict[str, Kernel | Unsupported]] = {}

    def of(self, target: Target) -> dict[str, Kernel | Unsupported]:
        def one(text: str) -> Kernel | Unsupported:
            try:
                return kernel_of(text, target)
            except Unsupported as why:
                return why

        with self.lock:
            if target not in self.found:
                self.found[target] = {id: one(text) for id, text in self.texts.items()}
            return self.found[target]


def module(kernels: Mapping[str, Kernel], target: Target) -> str:
    """LLVM's text of kernels, by the names that they get."""
    declared = sorted(set().union(*(kernel.declared for kernel in kernels.values())))
    notes = [target.annotation.format(name=name, number=number) for number, name in enumerate(kernels)]
    listed = f"!nvvm.annotations = !{{{', '.join(f'!{number}' for number in range(len(notes)))}}}"
    text = "\n".join([target.head, target.declarations, *declared,
                      *(kernel.definition.replace(NAME, f"@{name}", 1) for name, kernel in kernels.items()),
                      *([listed, *notes] if target.annotation else []), target.tail])
    first, *others = text.split(LOOP)
    loops = [(f"!{number}", part) for number, part in enumerate(others, WRITTEN_OUT + 1)]
    return "".join([first, *(f", !llvm.loop {loop}{part}" for loop, part in loops),
                    *(f"\n{loop} = distinct !{{{loop}, !{WRITTEN_OUT}}}" for loop, _ in loops),
                    f'\n!{WRITTEN_OUT} = !{{!"llvm.loop.unroll.full"}}\n'])


def disassembled(file: Path) -> str:
    """The text of a SPIR-V file."""
    return subprocess.run(["spirv-dis", "--raw-id", "--no-indent", "--no-header", "--no-color", file], text=True,
                          stdout=subprocess.PIPE, check=True).stdout


NVPTX = Target(
    'target datalayout = "e-i64:64-i128:128-v16:16-v32:32-n16:32:64"\ntarget triple = "nvptx64-nvidia-cuda"',
    "", ("  %thread = call i32 @llvm.nvvm.read.ptx.sreg.tid.x()", "  %index = zext i32 %thread to i64"),
    "declare i32 @llvm.nvvm.read.ptx.sreg.tid.x()",
    {"OpFDiv": "llvm.nvvm.div.approx.ftz.f", "Sqrt": "llvm.nvvm.sqrt.approx.ftz.f",
     "InverseSqrt": "llvm.nvvm.rsqrt.approx.ftz.f", "Sin": "llvm.nvvm.sin.approx.ftz.f",
     "Cos": "llvm.nvvm.cos.approx.ftz.f", "Exp2": "llvm.nvvm.ex2.approx.ftz.f", "Log2": "llvm.nvvm.lg2.approx.ftz.f"},
    {"OpFAdd": "llvm.nvvm.add.rn.ftz.f", "OpFMul": "llvm.nvvm.mul.rn.ftz.f"}, 4,
    '"denormal-fp-math-f32"="preserve-sign,preserve-sign" ', "",
    '!{number} = !{{ptr @{name}, !"kernel", i32 1}}')
SPIR = Target(
    'target datalayout = "e-i64:64-v16:16-v24:32-v32:32-v48:64-v96:128-v192:256-v256:256-v512:512-v1024:1024"\n'
    'target triple = "spir64-unknown-unknown"',
    "spir_kernel ", ("  %index = call spir_func i64 @_Z13get_global_idj(i32 0)",),
    "declare spir_func i64 @_Z13get_global_idj(i32)",
    {"OpFDiv": "_Z13native_divideff", "Sqrt": "_Z11native_sqrtf", "InverseSqrt": "_Z12native_rsqrtf",
     "Sin": "_Z10native_sinf", "Cos": "_Z10native_cosf", "Exp2": "_Z11native_exp2f", "Log2": "_Z11native_log2f"},
    {}, 2, "!intel_reqd_sub_group_size !0 ", "!0 = !{i32 16}")
