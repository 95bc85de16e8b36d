"""Writes functions of SPIR-V as C++ over the types of own.hpp. glslang has read the GLSL, so each value has a type, and each
way through a function is a jump to a label."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from base.tree import GLSL

SCALARS = {"OpTypeVoid": "void", "OpTypeBool": "bool"}
# The operations of own.hpp, which takes any types: without FOrd of FOrdLessThan.
OPERATIONS = frozenset(re.findall(r"^(?:OPERATION_\d\(|\w+ )([A-Z]\w+)[,(]", Path(__file__).with_name("own.hpp").read_text(encoding="utf-8"),
                                  re.MULTILINE))
OF_TYPES = re.compile(r"^(?:FOrd|FUnord|[FSUI])(?=[A-Z])")
CONVERSIONS = {f"Op{name}" for name in "ConvertFToS ConvertFToU ConvertSToF ConvertUToF CopyObject CopyLogical".split()}
NO_ERROR = set("Sin Cos Tan Asin Acos Atan Atan2 Sinh Cosh Tanh Asinh Acosh Atanh".split())
SKIPPED = {"OpSelectionMerge", "OpNoLine", "OpNop", "OpPhi"}
CHAINS = ("OpAccessChain", "OpInBoundsAccessChain")
OF_SHADERS = {"OpKill": "discard", "OpDPdx": "dFdx", "OpDPdy": "dFdy", "OpFwidth": "fwidth"}
STORAGE = {"Uniform": "a uniform", "UniformConstant": "a uniform", "PushConstant": "a uniform", "Input": "an input", "Output": "an output",
           "StorageBuffer": "a buffer", "Workgroup": "shared memory"}
LIBRARY = frozenset(re.findall(r"\bhn_\w+(?=\()", "\n".join(path.read_text(encoding="utf-8") for path in GLSL.rglob("*.glsl"))))
SOURCE = re.compile(r'^ *OpSource(?:Continued)?\b[^"\n]*(?:"(?:[^"\\]|\\.)*")?$', re.MULTILINE)  # with lines of its own
WORD = re.compile(r'"(?:[^"\\]|\\.)*"|\S+')


@dataclass
class Instruction:
    result: str
    op: str
    type: str
    operands: list[str]


@dataclass
class Function:
    """A function of the file, or of the library."""
    id: str
    name: str
    type: str
    parameters: list[Instruction] = field(default_factory=list)
    body: list[Instruction] = field(default_factory=list)

    @property
    def is_of_library(self) -> bool:
        return self.name in LIBRARY

    @cached_property
    def calls(self) -> list[str]:
        return [one.operands[0] for one in self.body if one.op == "OpFunctionCall"]


class Refused(Exception):
    """A step that the search does not take: FILE:LINE, and the reason."""


class Module:
    """The text that spirv-dis prints."""

    def __init__(self, text: str):
        self.of: dict[str, Instruction] = {}
        self.names: dict[str, str] = {}
        self.members: dict[tuple[str, str], str] = {}
        self.coarse: set[str] = set()
        self.globals: list[Instruction] = []
        self.refused = ""  # why the variables of the file have no values
        self.functions: list[Function] = []
        inside: Function | None = None
        line: Instruction | None = None  # where the next function begins
        for words in map(WORD.findall, SOURCE.sub("", text).splitlines()):
            if not words or words[0] == ";":
                continue
            result, op, rest = (words[0], words[2], words[3:]) if words[1:2] == ["="] else ("", words[0], words[1:])
            if op == "OpName":
                self.names[rest[0]] = rest[1].strip('"')
            elif op == "OpMemberName":
                self.members[rest[0], rest[1]] = rest[2].strip('"')
            elif op == "OpDecorate" and rest[1] == "RelaxedPrecision":
                self.coarse.add(rest[0])
            typed = bool(result) and not op.startswith(("OpType", "OpLabel", "OpString", "OpExtInstImport"))
            one = Instruction(result, op, rest[0] if typed else "", rest[typed:])
            if result:
                self.of[result] = one
            if op == "OpFunction":
                inside = Function(result, self.names[result].split("(")[0], one.type, body=[line] if line else [])
            elif op == "OpFunctionEnd" and inside:
                self.functions.append(inside)
                inside = None
            elif op == "OpLine" and not inside:
                line = one
            elif inside:
                (inside.parameters if op == "OpFunctionParameter" else inside.body).append(one)
            elif op == "OpVariable":
                self.globals.append(one)

    # --- Types and constants ---

    def type_of(self, id: str) -> str:
        """As own.hpp has it."""
        one = self.of[id]
        match one.op:
            case "OpTypeFloat":
                return "Float"
            case "OpTypeInt":
                return "Int" if one.operands[1] == "1" else "Uint"
            case "OpTypeVector":
                return f"VectorType<{self.type_of(one.operands[0])}, {one.operands[1]}>"
            case "OpTypeMatrix":
                return f"Array<{self.type_of(one.operands[0])}, {one.operands[1]}>"
            case "OpTypeArray":
                return f"Array<{self.type_of(one.operands[0])}, {self.of[one.operands[1]].operands[0]}>"
            case "OpTypePointer":
                return self.type_of(one.operands[1])
            case "OpTypeStruct":
                return self.names[id] if self.names[id].startswith("hn_") else f"S{id[1:]}"
        return SCALARS.get(one.op, "")

    def structs(self) -> Iterator[str]:
        for id, one in self.of.items():
            if one.op == "OpTypeStruct" and not self.type_of(id).startswith("hn_"):
                types = [self.type_of(member) for member in one.operands]
                if all(types):  # without pictures
                    yield f"struct S{id[1:]} {{ {' '.join(f'{type_} m{i}{{}};' for i, type_ in enumerate(types))} }};\n"

    def member(self, struct: str, number: str) -> str:
        return self.members[struct, number] if self.names[struct].startswith("hn_") else f"m{number}"

    def value(self, id: str) -> str:
        """A constant, or the variable that has a result."""
        one = self.of[id]
        match one.op:
            case "OpConstant":
                type_ = self.type_of(one.type)
                number = one.operands[0]
                # Doubles take the shortest decimals of the float, which are those of the text in most cases.
                return f"{type_}({shortest(number)}_f)" if type_ == "Float" else f"{type_}({number}{'u' * (type_ == 'Uint')})"
            case "OpConstantTrue" | "OpConstantFalse":
                return one.op[10:].lower()
            case "OpConstantNull" | "OpUndef":
                return f"{self.type_of(one.type)}{{}}"
            case "OpConstantComposite":
                return self.made(one, [self.value(part) for part in one.operands])
        return f"v{id[1:]}" if one.op != "OpFunction" else f"f{id[1:]}"

    def made(self, one: Instruction, parts: Sequence[str]) -> str:
        left, right = "()" if self.of[one.type].op == "OpTypeVector" else "{}"
        return f"{self.type_of(one.type)}{left}{', '.join(parts)}{right}"

    def written(self, functions: str) -> str:
        """own.inc of own.hpp: main sets the variables of the file."""
        main = next(one.id for one in self.functions if one.name == "main")
        variables = "".join(f"{self.type_of(one.type)} v{one.result[1:]}{{}};\n" for one in self.globals
                            if one.operands[0] == "Private" and not self.refused)
        sets = "" if self.refused else f"f{main[1:]}();"
        return f"{''.join(self.structs())}{variables}File() {{ rounds = 0; {sets} }}\n{functions}"


def shortest(number: str) -> str:
    text = float.fromhex(number) if "x" in number.lower() else float(number)
    decimals = str(np.float32(text))
    return decimals if re.search("[.e]", decimals) else f"{decimals}.0"


# --- Functions --------------------------------------------------------------------------------------------------------


class Writer:
    """Writes one function."""

    def __init__(self, module: Module, function: Function):
        self.module, self.function = module, function
        self.place = ""
        self.pointers: dict[str, str] = {one.result: f"v{one.result[1:]}" for one in (*module.globals, *function.parameters)}
        self.phis: dict[str, list[tuple[str, str]]] = {}  # by the block before: what is set at its end
        self.block = ""

    def text(self) -> str:
        module, function = self.module, self.function
        for one in function.body:
            for value, before in zip(one.operands[::2], one.operands[1::2]) if one.op == "OpPhi" else ():
                self.phis.setdefault(before, []).append((one.result, value))
        written = "".join(map(self.instruction, function.body))
        listed = ", ".join(f"{module.type_of(one.type)}& v{one.result[1:]}" if self.is_pointer(one.type) else
                           f"{module.type_of(one.type)} v{one.result[1:]}" for one in function.parameters)
        declared = "".join(f"{module.type_of(one.type)} v{one.result[1:]}{{}};\n" for one in function.body
                           if one.type and one.op not in CHAINS and module.type_of(one.type) != "void")
        return f"{module.type_of(function.type)} f{function.id[1:]}({listed}) {{\n{declared}{written}}}\n"

    def is_pointer(self, type_: str) -> bool:
        return self.module.of[type_].op == "OpTypePointer"

    def refuse(self, reason: str) -> None:
        raise Refused(f"{self.place}: {reason}")

    def value(self, id: str) -> str:
        """Also of a pointer: what it points to."""
        one = self.module.of.get(id)
        if one is None:
            return id
        if one.op == "OpVariable" and one.operands[0] in STORAGE:
            self.refuse(f"{self.module.names.get(id) or 'a variable'} is {STORAGE[one.operands[0]]} of a shader")
        if self.module.refused and one in self.module.globals:
            raise Refused(self.module.refused)
        return self.pointers.get(id) or self.module.value(id)

    def chain(self, one: Instruction) -> str:
        base, *indices = one.operands
        root = self.module.of[base]
        if root.op == "OpVariable" and root.operands[0] == "Uniform" and indices:  # a member of the block of all of them
            struct = self.module.of[root.type].operands[1]
            self.refuse(f"{self.module.members[struct, self.module.of[indices[0]].operands[0]]} is a uniform of a shader")
        numbers = [self.module.of[index].operands[0] if self.module.of[index].op == "OpConstant" else self.value(index)
                   for index in indices]
        return self.part(self.value(base), self.module.of[root.type].operands[1], numbers)

    def part(self, text: str, type_: str, numbers: Sequence[str]) -> str:
        """A part of a value or a variable of that type, in C++; of a struct the numbers are known."""
        for number in numbers:
            of = self.module.of[type_]
            if of.op == "OpTypeStruct":
                text, type_ = f"{text}.{self.module.member(type_, number)}", of.operands[int(number)]
            else:
                text, type_ = f"at({text}, {number})", of.operands[0]
        return text

    def go(self, label: str) -> str:
        """To a block, with the values that it takes from this one."""
        sets = "".join(f"v{result[1:]} = {self.value(value)}; " for result, value in self.phis.get(self.block, ()))
        return f"{sets}goto b{label[1:]}"

    def instruction(self, one: Instruction) -> str:
        operands, result = one.operands, f"v{one.result[1:]}"
        match one.op:
            case "OpLine":
                path = self.module.of[operands[0]].operands[0].strip('"')
                self.place = f"{path}:{operands[1]}"
                return ""
            case "OpLabel":
                self.block = one.result
                return f"b{one.result[1:]}:;\n"
            case "OpLoopMerge":
                return "another();\n"
            case op if op in CHAINS:
                self.pointers[one.result] = self.chain(one)
                return ""
            case op if op in SKIPPED:
                return ""
        type_ = self.module.type_of(one.type) if one.type else ""
        if one.result in self.module.coarse and "Float" in type_:
            self.refuse("mediump: such floats may have 10 bits")
        if one.op == "OpVariable":
            self.pointers[one.result] = result
            return f"{result} = {self.value(operands[1])};\n" if len(operands) > 1 else ""
        code = self.code(one, type_, [self.value(of) for of in operands])
        return f"{result} = {code};\n" if one.type and type_ != "void" else f"{code};\n"

    def code(self, one: Instruction, type_: str, values: Sequence[str]) -> str:
        operands = one.operands
        match one.op:
            case "OpLoad":
                return values[0]
            case "OpStore":
                return f"{values[0]} = {values[1]}"
            case "OpBranch":
                return self.go(operands[0])
            case "OpBranchConditional":
                return f"if ({values[0]}) {{ {self.go(operands[1])}; }} {self.go(operands[2])}"
            case "OpSwitch":
                cases = "".join(f"case {of}: {self.go(label)}; " for of, label in zip(operands[2::2], operands[3::2]))
                return f"switch (selector({values[0]})) {{ {cases}default: {self.go(operands[1])}; }}"
            case "OpReturn":
                return "return"
            case "OpReturnValue":
                return f"return {values[0]}"
            case "OpUnreachable":
                return "std::abort()"
            case "OpCompositeConstruct":
                return self.module.made(one, values)
            case "OpCompositeExtract":
                return self.part(values[0], self.module.of[operands[0]].type, operands[1:])
            case "OpCompositeInsert":
                return f"{values[1]}; {self.part(f'v{one.result[1:]}', one.type, operands[2:])} = {values[0]}"
            case "OpVectorExtractDynamic":
                return f"at({values[0]}, {values[1]})"
            case "OpVectorShuffle":
                return f"shuffled<{', '.join(operands[2:])}>({values[0]}, {values[1]})"
            case "OpFunctionCall":
                return f"{self.called(operands[0])}({', '.join(values[1:])})"
            case "OpExtInst":
                return self.operation(operands[1], values[2:])
            case "OpBitcast":
                return f"bits<{type_}>({values[0]})"
            case op if op in CONVERSIONS:
                return f"converted<{type_}>({values[0]})"
            case op if op.startswith(("OpImage", "OpSampled")) or op in OF_SHADERS:
                self.refuse(f"{OF_SHADERS.get(op, 'texture')} needs a shader that runs")
        return self.operation(one.op[2:], values)

    def operation(self, name: str, values: Sequence[str]) -> str:
        if name in NO_ERROR:
            self.refuse(f"GLSL states no error of {name.lower()}")
        general = OF_TYPES.sub("", name)
        if general not in OPERATIONS:
            self.refuse(f"the search does not take {name.lower()}")
        return f"{general}({', '.join(values)})"

    def called(self, id: str) -> str:
        name = self.module.names[id].split("(")[0]
        return name if name in LIBRARY else f"f{id[1:]}"
