"""Programs that call picked functions in other languages: they read the words of arguments, and write the words of
results."""

from __future__ import annotations

import itertools
import json
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing
from base.pypi import environment
from base.testing import check_opencl
from base.thorough import THOROUGH
from base.tree import ROOT, TOOLS
from translate.names import wgsl_name
from translate.parsing.syntax import Function
from translate.pick.c import C
from translate.pick.command import SYNTAXES
from translate.pick.evaluate import Module
from translate.pick.javascript import JavaScript
from translate.pick.scalars import Part, Piece, Syntax, fields_of, pascal, results_of
from translate.pick.values import AXES, SIZES, scalar_of


class NotRun(Exception):
    """A text that is not compiled, or a program that fails."""


def ran(folder: Path, *command: str | Path) -> str:
    """A program's output; raises NotRun if it fails."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise NotRun(f"{' '.join(map(str, command))} returned {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def written_to(folder: Path, files: Mapping[str, str]) -> list[str]:
    """The names of files, which are written into a folder."""
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="ascii")
    return [*files]


class Case(NamedTuple):
    """A function, a text that has it, and at how many points it is called."""
    function: Function
    text: str
    points: int


class Runner:
    """Runs programs of a language. Words are read by `read` and written by `write`, where {} stands for the value."""
    syntax: type[Syntax] | None  # none if it was deleted
    programs: Sequence[str]  # that are needed
    packages: str            # of Debian, which have them
    linters: Sequence[str] = ()  # programs that lint() needs beside them
    read: Mapping[str, str]
    write: Mapping[str, str]
    faults: Mapping[tuple[str, str], str]  # operators of types, and faults with {} as operands
    arithmetics: Sequence[str] = ("fast", "fixed", "precise")  # that the language has
    exact = ""               # a program that compares the helpers of the syntax with the language's own
    loop = "for (int point = 0; point < {points}; point++) {{"  # the head of a loop of {points}
    receives = "var r = "    # before a call that returns something
    one_of = "r.{name}"      # of several results
    struct_of = ""           # a struct of these parts, where the function that makes it may not be in the text
    only: Sequence[str] = ()  # functions, where all take too long in a thorough run
    whole = False            # whether all functions are tried, in one text
    optimizes = False        # whether it is built as users build it, and not with all checks
    indent = "        "

    def check(self, lints: bool = False) -> None:
        programs = (*self.programs, *self.linters) if lints else self.programs
        missing = [program for program in programs if not shutil.which(program)]
        if missing:
            raise Missing(f"there is no {' and no '.join(missing)}: apt-get install {self.packages}")

    def few(self, module: Module, function: Function, rows: Sequence[bytes]) -> Sequence[int]:
        """The points at which it is called: all."""
        return range(len(rows))

    def run(self, cases: Sequence[Case], module: Module, inputs: bytes, folder: Path) -> bytes:
        """The functions' results for these words."""
        (folder / "inputs").write_bytes(inputs)
        calls = [self.call(module, case.function, case.points) for case in cases]
        self.build_and_run([case.text for case in cases], calls, folder)
        return (folder / "outputs").read_bytes()

    def build_and_run(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> None:
        """It reads the file `inputs`, and writes `outputs`."""
        ran(folder, *self.build(texts, calls, folder))

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        """The command that does so."""
        raise NotImplementedError

    def run_exact(self, folder: Path) -> None:
        raise NotImplementedError

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """Compiles texts with all warnings as errors, and runs what people have to find fault with the language's
        texts; raises NotRun."""
        raise NotImplementedError

    def declare(self, type_: str, name: str, value: str, changes: bool) -> str:
        return self.syntax().declare(type_, name, value, changes)

    def result(self, results: Sequence[Part], number: int) -> str:
        return self.one_of.format(name=results[number].name, number=number) if len(results) > 1 else "r"

    def called(self, name: str, arguments: Sequence[str], results: Sequence[Part]) -> list[str]:
        """The statements of a call, whose result is `r`."""
        return [f"{self.receives if results else ''}{name}({', '.join(arguments)});"]

    def call(self, module: Module, function: Function, points: int) -> str:
        syntax = self.syntax()
        syntax.struct_of = self.struct_of or syntax.struct_of
        lines: list[str] = []
        arguments: list[str] = []
        outputs: list[tuple[str, str]] = []  # types and expressions
        results = results_of(function, module)

        def made(type_: str, name: str) -> Piece:
            """A value of words: each is read into a variable first, since languages differ in the order."""
            if type_ not in module.structs:
                lines.append(self.declare(type_, name, self.read[type_], False))
                return Piece(name)
            fields = fields_of(module, type_)
            return syntax.make_struct(type_, fields, [made(part.type, f"{name}{i}") for i, part in enumerate(fields)])

        def leaves(type_: str, value: str, axes: Sequence[str] = AXES) -> list[tuple[str, str]]:
            if type_ in module.structs:
                return [leaf for part in fields_of(module, type_)
                        for leaf in leaves(part.type, f"{value}.{syntax.field_name(part.name)}")]
            if SIZES[type_] > 1:
                return [(scalar_of(type_), syntax.member(Piece(value), axis).text) for axis in axes[:SIZES[type_]]]
            return [(type_, value)]

        for parameter in function.parameters:
            for _, type_ in module.passed(parameter):
                name = f"v{len(arguments)}"
                piece = made(type_, name)
                if type_ in module.structs:
                    name = f"{name}s"
                    lines.append(self.declare(type_, name, piece.text, parameter.is_set))
                arguments.append(syntax.example_struct.format(name) if parameter.is_set else name)
                if parameter.is_set:
                    outputs += leaves(type_, name)
        of_results = [leaf for i, part in enumerate(results) for leaf in leaves(part.type, self.result(results, i), syntax.axes(part))]
        # Parameters that are set stand behind the result; further results in the order of the parameters.
        lines += self.called(syntax.function_name(wgsl_name(function), is_public=True), arguments, results)
        lines += [self.write[type_].format(value) for type_, value in (*of_results, *outputs)]
        inside = "".join(f"{self.indent}    {line}\n" for line in lines)
        return f"{self.indent}{self.loop.format(points=points)}\n{inside}{self.indent}}}"


class RustRunner(Runner):
    """The text is a crate of its own, without std; an addition that overflows ends the program."""
    syntax = SYNTAXES.get("rust")
    programs = ("rustc",)
    packages = "rustc rust-clippy"
    linters = ("clippy-driver",)
    read = {"float": "f32::from_bits(next())", "int": "next() as i32", "uint": "next()", "bool": "next() != 0"}
    write = {"float": "out.push(f32::to_bits({}));", "int": "out.push({} as u32);", "uint": "out.push({});",
             "bool": "out.push(u32::from({}));"}
    # (A logical shift would end the program, since a product then overflows.)
    faults = {("int", ">>"): "i32::min(i32::MAX, ({}) / (1 << {}))",
              ("uint", "*"): "u32::saturating_mul({}, {})"}
    loop = "for _ in 0..{points} {{"
    receives, one_of = "let r = ", "r.{number}"
    MAIN = """fn main() {{
    let bytes = std::fs::read("inputs").unwrap();
    let mut words = bytes.chunks(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    let mut next = || words.next().unwrap();
    let mut out: Vec<u32> = Vec::new();
{calls}    let written: Vec<u8> = out.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write("outputs", written).unwrap();
}}
"""

    # Roots of all that two exponents have, or of one in 16 by default; those of
    # others are the same times a power of 2. One float in 1021 of all.
    exact = """fn main() {
    for x in (0x3F80_0000..0x4080_0000).step_by(STEP).map(f32::from_bits) {
        assert_eq!(sqrt(x).to_bits(), x.sqrt().to_bits(), "the root of {x}");
    }
    let borders = [0x8000_0000, 0x7F80_0000, 0xFF80_0000, 0x0080_0000];
    for x in (0..=u32::MAX).step_by(1021).chain(borders).map(f32::from_bits) {
        if x.is_nan() {
            assert!(floor(x).is_nan() && trunc(x).is_nan() && sqrt(x).is_nan());
            continue;
        }
        assert_eq!(floor(x).to_bits(), x.floor().to_bits(), "{x} rounded down");
        assert_eq!(trunc(x).to_bits(), x.trunc().to_bits(), "{x} rounded to 0");
        assert_eq!(abs(x).to_bits(), x.abs().to_bits(), "the size of {x}");
        assert!(x < 0.0 || sqrt(x).to_bits() == x.sqrt().to_bits(), "the root of {x}");
    }
}
"""

    def run_exact(self, folder: Path) -> None:
        helpers = "".join(self.syntax.helpers[name] for name in ("sqrt", "floor", "trunc", "abs"))
        step = f"const STEP: usize = {1 if THOROUGH else 16};\n"
        (folder / "exact.rs").write_text(f"{step}{helpers}{self.exact}", encoding="ascii")
        ran(folder, "rustc", "--edition", "2021", "-O", "exact.rs")
        ran(folder, folder / "exact")

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        modules = "".join(f"pub mod m{i} {{\n{text}}}\n" for i, text in enumerate(texts))
        (folder / "noise.rs").write_text(f"#![no_std]\n#![deny(warnings)]\n{modules}", encoding="ascii")
        blocks = "".join(f"    {{\n        use noise::m{i}::*;\n{call}\n    }}\n" for i, call in enumerate(calls))
        (folder / "main.rs").write_text(self.MAIN.format(calls=blocks), encoding="ascii")
        options = ("-O",) if self.optimizes else ("-C", "debug-assertions")
        ran(folder, "rustc", "--edition", "2021", "--crate-type", "rlib", *options, "noise.rs")
        ran(folder, "rustc", "--edition", "2021", *options, "--extern", "noise=libnoise.rlib", "main.rs")
        return [folder / "main"]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """By clippy with its default lints."""
        modules = "".join(f"pub mod m{i} {{\n{text}}}\n" for i, text in enumerate(texts))
        written_to(folder, {"noise.rs": f"#![no_std]\n{modules}"})
        ran(folder, "clippy-driver", "--edition", "2021", "--crate-type", "rlib", "--emit", "metadata", "-D", "warnings",
            "noise.rs")


class CRunner(Runner):
    """Each text is a translation unit of its own; undefined behaviour ends the program."""
    syntax = C
    programs = ("gcc",)
    packages = "gcc clang"
    struct_of = "{{{parts}}}"
    read = {"float": "next_float()", "int": "(int32_t)next()", "uint": "next()", "bool": "next() != 0u"}
    write = {"float": "put_float({});", "int": "put((uint32_t){});", "uint": "put({});", "bool": "put((uint32_t){});"}
    faults = {("int", ">>"): "(({}) / (1 << ({})))", ("uint", ">>"): "(uint32_t)((int32_t)({}) >> ({}))"}
    WARNINGS = ("-std=c99", "-pedantic-errors", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Wshadow",
                "-Werror")
    linters = ("clang",)
    WORDS = """#include <stdint.h>
uint32_t next(void);
float next_float(void);
void put(uint32_t word);
void put_float(float x);
"""
    MAIN = """#include <stdio.h>
#include <string.h>
static FILE *inputs, *outputs;
uint32_t next(void) {{
  uint32_t word = 0;
  if (fread(&word, sizeof word, 1, inputs) != 1) fputs("inputs ends too soon", stderr);
  return word;
}}
float next_float(void) {{
  uint32_t word = next();
  float x;
  memcpy(&x, &word, sizeof x);
  return x;
}}
void put(uint32_t word) {{ fwrite(&word, sizeof word, 1, outputs); }}
void put_float(float x) {{ fwrite(&x, sizeof x, 1, outputs); }}
int main(void) {{
  inputs = fopen("inputs", "rb");
  outputs = fopen("outputs", "wb");
{runs}
  return fclose(outputs);
}}
"""

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        names = ["main.c"]
        for i, (text, call) in enumerate(zip(texts, calls)):
            (folder / f"m{i}.h").write_text(text, encoding="ascii")
            names.append(f"m{i}.c")
            head = f'#include "m{i}.h"\n{self.WORDS}void run{i}(void);\n'
            (folder / names[-1]).write_text(f"{head}void run{i}(void) {{\n{call}\n}}\n", encoding="ascii")
        declared = "".join(f"void run{i}(void);\n" for i in range(len(texts)))
        runs = "".join(f"  run{i}();\n" for i in range(len(texts)))
        (folder / "main.c").write_text(self.WORDS + declared + self.MAIN.format(runs=runs), encoding="ascii")
        options = ("-O2",) if self.optimizes else ("-fsanitize=undefined,float-cast-overflow", "-fno-sanitize-recover=all")
        ran(folder, "gcc", *self.WARNINGS, "-ffp-contract=off", *options, *names, "-lm", "-o", "main")
        return [folder / "main"]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        headers = written_to(folder, {f"m{i}.h": text for i, text in enumerate(texts)})
        units = written_to(folder, {f"m{i}.c": f'#include "{name}"\n' for i, name in enumerate(headers)})
        for compiler in ("gcc", "clang"):
            ran(folder, compiler, *self.WARNINGS, "-Wno-unused-function", "-fsyntax-only", *units)

    def called(self, name: str, arguments: Sequence[str], results: Sequence[Part]) -> list[str]:
        """How a number, a vector or a struct is called, and pointers to others."""
        syntax = self.syntax()
        lines = [f"{syntax.type(part.type)} {part.name};" for part in results]
        pointers = [f"&{part.name}" for part in results if part.name != "value"]
        call = f"{name}({', '.join((*arguments, *pointers))});"
        return [*lines, f"value = {call}" if any(part.name == "value" for part in results) else call]

    def result(self, results: Sequence[Part], number: int) -> str:
        return results[number].name


class OpenClRunner(CRunner):
    """Texts of C as OpenCL C, which the first driver runs: pocl, on a CPU. Calls of one text are kernels of a program."""
    programs = ("clang", "g++", "/usr/bin/python3")
    packages = "clang g++ pocl-opencl-icd python3-pyopencl"
    whole = True
    arithmetics = ("fixed", "precise")  # a driver may fuse products in HN_FAST
    read = {"float": "*(__global const float *)in++", "int": "(int32_t)*in++", "uint": "*in++", "bool": "*in++ != 0u"}
    write = {"float": "*(__global float *)out++ = {};", "uint": "*out++ = {};",
             **dict.fromkeys(("int", "bool"), "*out++ = (uint32_t){};")}
    IN_KERNEL = 24  # calls: drivers inline all of them, and the optimizer of one that is long takes minutes
    KERNEL = """
__kernel void run{number:03}(__global uint32_t *at, __global const uint32_t *inputs, __global uint32_t *outputs) {{
  __global const uint32_t *in = inputs + at[0];
  __global uint32_t *out = outputs + at[1];
{calls}
  at[0] = (uint32_t)(in - inputs);
  at[1] = (uint32_t)(out - outputs);
}}
"""
    MAIN = """import sys
import numpy
import pyopencl
device = [one for platform in pyopencl.get_platforms() for one in platform.get_devices()][0]
context = pyopencl.Context([device])
queue = pyopencl.CommandQueue(context)
words = [numpy.zeros(2, "u4"), numpy.fromfile("inputs", "u4"), numpy.zeros(1 << 24, "u4")]
shared = pyopencl.mem_flags.READ_WRITE | pyopencl.mem_flags.COPY_HOST_PTR
buffers = [pyopencl.Buffer(context, shared, hostbuf=one) for one in words]
for name in sys.argv[1:]:
    with open(name) as file:
        program = pyopencl.Program(context, file.read()).build(["-cl-opt-disable"])
    for kernel in sorted(program.all_kernels(), key=lambda one: one.function_name):
        kernel(queue, (1,), None, *buffers)
for one, buffer in zip(words, buffers):
    pyopencl.enqueue_copy(queue, one, buffer)
words[2][:words[0][1]].tofile("outputs")
"""
    # NVIDIA's headers declare these for NVRTC.
    CUDA = """#define __device__ __attribute__((device))
#define __host__ __attribute__((host))
#define __fmul_rn __nvvm_mul_rn_f
__device__ inline float floorf(float x) { return __builtin_floorf(x); }
__device__ inline float truncf(float x) { return __builtin_truncf(x); }
__device__ inline float fabsf(float x) { return __builtin_fabsf(x); }
__device__ inline float sqrtf(float x) { return __nvvm_sqrt_rn_f(x); }
"""
    SILENT = ("-Wall", "-Wextra", "-pedantic", "-Wno-unused-function", "-Werror")
    COMPILERS = (("g++", "-std=c++98", "-fsyntax-only", "-x", "c++"), ("clang++", "-std=c++20", "-fsyntax-only", "-x", "c++"),
                 *(("clang", f"-cl-std=CL{version}", "-target", "spir64", "-nostdlibinc", "-fsyntax-only", "-x", "cl")
                   for version in ("1.2", "2.0", "3.0")))
    TO_PTX = ("clang", "--cuda-device-only", "-nocudainc", "-nocudalib", "--cuda-gpu-arch=sm_75", "-D__CUDACC_RTC__", "-S",
              "-o", "text.ptx", "-include", "cuda.h", "-x", "cuda")

    def check(self, lints: bool = False) -> None:
        super().check(lints)
        check_opencl("/usr/bin/python3")

    def kernels(self, calls: Sequence[str]) -> str:
        return "".join(self.KERNEL.format(number=i, calls="\n".join(calls[i:i + self.IN_KERNEL]))
                       for i in range(0, len(calls), self.IN_KERNEL))

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        programs = itertools.groupby(zip(texts, calls), lambda one: one[0])
        sources = written_to(folder, {f"m{i}.cl": text + self.kernels([call for _, call in of_text])
                                      for i, (text, of_text) in enumerate(programs)})
        return ["env", "POCL_CACHE_DIR=cache", "PYOPENCL_NO_CACHE=1", "/usr/bin/python3", "-c", self.MAIN, *sources]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """By compilers of each language that the text is."""
        super().lint(texts, folder)
        written_to(folder, {"cuda.h": self.CUDA})
        for text in texts:
            names = re.findall(r"^HN_INLINE \w+ (hn_(?!i_)\w+)\(", text, re.MULTILINE)
            used = "".join(f"__device__ auto *used_{name} = {name};\n" for name in names)
            for compiler in (*self.COMPILERS, self.TO_PTX):
                written_to(folder, {"text": text + used * (compiler == self.TO_PTX)})
                ran(folder, *compiler[:-2], *self.SILENT, *compiler[-2:], "text")


class CSharpRunner(Runner):
    """Each text is in a namespace of its own."""
    syntax = SYNTAXES.get("csharp")
    programs = ("mcs", "mono")
    packages = "mono-mcs mono-runtime"
    read = {"float": "Words.Float()", "int": "unchecked((int)Words.Next())", "uint": "Words.Next()", "bool": "Words.Next() != 0u"}
    write = {"float": "Words.Put({});", "int": "Words.Put(unchecked((uint){}));", "uint": "Words.Put({});",
             "bool": "Words.Put({} ? 1u : 0u);"}
    faults = {("int", ">>"): "(({}) / (1 << ({})))", ("uint", "*"): "(({}) | ({}))"}
    COMPILE = ("mcs", "-langversion:7.2", "-warn:4", "-warnaserror", "-checked+")  # what overflows is an exception
    MAIN = """static class Words {{
    static byte[] read = System.IO.File.ReadAllBytes("inputs");
    static System.IO.MemoryStream written = new System.IO.MemoryStream();
    static int at = 0;
    public static uint Next() {{ at += 4; return System.BitConverter.ToUInt32(read, at - 4); }}
    public static float Float() {{ at += 4; return System.BitConverter.ToSingle(read, at - 4); }}
    public static void Put(float x) {{ written.Write(System.BitConverter.GetBytes(x), 0, 4); }}
    public static void Put(uint x) {{ written.Write(System.BitConverter.GetBytes(x), 0, 4); }}
    static void Main() {{
{runs}
        System.IO.File.WriteAllBytes("outputs", written.ToArray());
    }}
}}
"""

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        names: list[str] = ["words.cs"]
        for i, (text, call) in enumerate(zip(texts, calls)):
            names.append(f"m{i}.cs")
            run = f"static class Run {{\n    public static void All() {{\n{call}\n    }}\n}}\n"
            (folder / names[-1]).write_text(f"namespace M{i} {{\nusing static M{i}.HashNoise;\n{text}{run}}}\n",
                                            encoding="ascii")
        runs = "".join(f"        M{i}.Run.All();\n" for i in range(len(texts)))
        (folder / "words.cs").write_text(self.MAIN.format(runs=runs), encoding="ascii")
        ran(folder, *self.COMPILE, "-out:main.exe", *names)
        return ["mono", "main.exe"]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        names = written_to(folder, {f"m{i}.cs": f"namespace M{i} {{\n{text}}}\n" for i, text in enumerate(texts)})
        ran(folder, *self.COMPILE, "-target:library", "-doc:noise.xml", "-out:noise.dll", *names)

    def result(self, results: Sequence[Part], number: int) -> str:
        return f"r.{pascal(results[number].name)}" if len(results) > 1 else "r"


class JavaScriptRunner(Runner):
    """Each text is a module."""
    syntax = JavaScript
    programs = ("node",)
    packages = "nodejs"
    read = {"float": "float()", "int": "next() | 0", "uint": "next()", "bool": "next() !== 0"}
    write = {"float": "putFloat({});", "int": "put({});", "uint": "put({});", "bool": "put({} ? 1 : 0);"}
    faults = {("int", ">>"): "(({}) >>> ({}))", ("uint", "*"): "(({}) * ({}))"}
    loop = "for (let point = 0; point < {points}; point++) {{"
    receives = "const r = "
    WORDS = """import { readFileSync, writeFileSync } from "node:fs";
const inputs = readFileSync("inputs");
const outputs = [];
const [at, one] = [{ next: -4 }, new DataView(new ArrayBuffer(4))];
export const next = () => inputs.readUInt32LE(at.next += 4);
export const float = () => inputs.readFloatLE(at.next += 4);
export const put = (word) => outputs.push(word >>> 0);
export const putFloat = (x) => {
  if (!Object.is(Math.fround(x), x)) throw `${x} is no float`;
  one.setFloat32(0, x);
  put(one.getUint32(0));
};
export const write = () => writeFileSync("outputs", Uint32Array.from(outputs));
"""

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        (folder / "words.mjs").write_text(self.WORDS, encoding="ascii")
        imported = 'import { next, float, put, putFloat } from "./words.mjs";\n'
        for i, (text, call) in enumerate(zip(texts, calls)):
            (folder / f"text{i}.mjs").write_text(text, encoding="ascii")
            names = ", ".join(re.findall(r"^export function (\w+)", text, re.MULTILINE))
            run = f'import {{ {names} }} from "./text{i}.mjs";\n{imported}{call}\n'
            (folder / f"run{i}.mjs").write_text(run, encoding="ascii")
        main = "".join(f'import "./run{i}.mjs";\n' for i in range(len(texts)))
        (folder / "main.mjs").write_text(f'{main}import {{ write }} from "./words.mjs";\nwrite();\n', encoding="ascii")
        return ["node", "main.mjs"]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        names = written_to(folder, {f"text{i}.mjs": text for i, text in enumerate(texts)})
        written_to(folder, {"main.mjs": "".join(f'import "./{name}";\n' for name in names)})
        ran(folder, "node", "main.mjs")


class JavaRunner(Runner):
    """Each text is in a package of its own."""
    syntax = SYNTAXES.get("java")
    programs = ("javac", "java")
    packages = "default-jdk-headless"
    read = {"float": "Float.intBitsToFloat(Words.next())", "int": "Words.next()", "uint": "Words.next()",
            "bool": "Words.next() != 0"}
    write = {"float": "Words.put(Float.floatToRawIntBits({}));", "int": "Words.put({});", "uint": "Words.put({});",
             "bool": "Words.put({} ? 1 : 0);"}
    faults = {("int", ">>"): "(({}) >>> ({}))", ("uint", ">>"): "(({}) >> ({}))"}
    one_of = "r.{name}()"
    cheap = ("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xshare:auto")  # for programs that end soon
    WORDS = """package words;
import java.nio.*;
import java.nio.file.*;
public final class Words {{
    static ByteBuffer inputs;
    static ByteBuffer outputs = ByteBuffer.allocate(1 << 26).order(ByteOrder.LITTLE_ENDIAN);
    public static int next() {{ return inputs.getInt(); }}
    public static void put(int word) {{ outputs.putInt(word); }}
    public static void main(String[] arguments) throws Exception {{
        inputs = ByteBuffer.wrap(Files.readAllBytes(Path.of("inputs"))).order(ByteOrder.LITTLE_ENDIAN);
{runs}
        Files.write(Path.of("outputs"), java.util.Arrays.copyOf(outputs.array(), outputs.position()));
    }}
}}
"""

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        runs = "".join(f"        m{i}.Run.all();\n" for i in range(len(texts)))
        files = {"words/Words.java": self.WORDS.format(runs=runs)}
        for i, (text, call) in enumerate(zip(texts, calls)):
            files[f"m{i}/HashNoise.java"] = f"package m{i};\n{text}"
            head = f"package m{i};\nimport static m{i}.HashNoise.*;\nimport words.Words;\n"
            body = f"    public static void all() {{\n{call}\n    }}\n"
            files[f"m{i}/Run.java"] = f"{head}public class Run {{\n{body}}}\n"
        self._compile(files, folder)
        return ["java", *(() if self.optimizes else self.cheap), "words.Words"]

    def _compile(self, files: Mapping[str, str], folder: Path) -> None:
        ran(folder, "javac", *(f"-J{option}" for option in self.cheap), "-proc:none", "-Xlint:all",
            "-Xdoclint:all,-missing", "-Werror", *written_to(folder, files))

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        self._compile({f"m{i}/HashNoise.java": f"package m{i};\n{text}" for i, text in enumerate(texts)}, folder)


class GoRunner(Runner):
    """Each text is a package, with what calls it."""
    syntax = SYNTAXES.get("go")
    programs = ("go",)
    packages = "golang-go"
    read = {"float": "words.Float()", "int": "int32(words.Next())", "uint": "words.Next()", "bool": "words.Next() != 0"}
    write = {"float": "words.PutFloat({});", "int": "words.Put(uint32({}));", "uint": "words.Put({});",
             "bool": "words.Put(choose({}, uint32(1), uint32(0)));"}
    faults = {("int", ">>"): "int32(uint32({}) >> ({}))", ("uint", ">>"): "uint32(int32({}) >> ({}))"}
    loop = "for point := 0; point < {points}; point++ {{"
    WORDS = """package words

import (
    "encoding/binary"
    "math"
    "os"
)

var inputs, _ = os.ReadFile("inputs")
var outputs []byte

func Next() uint32 {
    word := binary.LittleEndian.Uint32(inputs)
    inputs = inputs[4:]
    return word
}
func Float() float32 { return math.Float32frombits(Next()) }
func Put(word uint32) { outputs = append(outputs, byte(word), byte(word>>8), byte(word>>16), byte(word>>24)) }
func PutFloat(x float32) { Put(math.Float32bits(x)) }
func Write() { os.WriteFile("outputs", outputs, 0644) }
"""

    def build(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> Sequence[str | Path]:
        numbers = range(len(texts))
        imports = "".join(f'    m{i} "hn/m{i}"\n' for i in numbers)
        runs = "".join(f"    m{i}.Run()\n" for i in numbers)
        main = f'package main\n\nimport (\n    "hn/words"\n{imports})\n\nfunc main() {{\n{runs}    words.Write()\n}}\n'
        files = {"go.mod": "module hn\n\ngo 1.18\n", "words/words.go": self.WORDS, "main.go": main}
        for i, text, call in zip(numbers, texts, calls):
            files[f"m{i}/noise.go"] = text
            chooses = "" if "func choose" in text or "choose(" not in call else self.syntax.helpers["choose"]
            head = f'package hashnoise\n\nimport "hn/words"\n\n{chooses}'
            files[f"m{i}/run.go"] = f"{head}func Run() {{\n{call}\n}}\n"
        written_to(folder, files)
        ran(folder, "go", "build", "-o", "main", ".")
        return [folder / "main"]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        written_to(folder, {"go.mod": "module hn\n\ngo 1.18\n",
                            **{f"m{i}/noise.go": text for i, text in enumerate(texts)}})
        ran(folder, "go", "vet", "./...")

    def declare(self, type_: str, name: str, value: str, changes: bool) -> str:
        return f"{name} := {value};"

    def called(self, name: str, arguments: Sequence[str], results: Sequence[Part]) -> list[str]:
        received = ", ".join(f"r{i}" for i in range(len(results)))
        return [f"{received}{' := ' if results else ''}{name}({', '.join(arguments)});"]

    def result(self, results: Sequence[Part], number: int) -> str:
        return f"r{number}"


class PythonRunner(Runner):
    """Each text is a module. Its functions take arrays of all points."""
    syntax = SYNTAXES.get("python")
    programs = ("python3",)
    packages = "python3-numpy"
    whole = True
    arithmetics = ("fixed", "fast", "precise")
    namespace = "numpy"
    most = 99 if THOROUGH else 3  # values of octaves and such: each is a call
    faults = {("uint", ">>"): "(({}) >> ({}))", ("uint", "*"): "(({}) | ({}))"}
    DRIVER = Path(__file__).with_name("python_driver.py")

    def python(self) -> Sequence[str | Path]:
        return [TOOLS / "lib" / "base" / "scientific-python"]

    def takes(self, module: Module, function: Function) -> list[tuple[str, str, int]]:
        """The kinds of what users pass (Python.kind), the types, and at which word each begins."""
        found: list[tuple[str, str, int]] = []
        at = 0
        for name, type_ in ((one.at.text, type_) for one in function.parameters for _, type_ in module.passed(one)):
            found.append((self.syntax.kind(name, type_), type_, at))
            at += len(module.parts(type_))
        return found

    def few(self, module: Module, function: Function, rows: Sequence[bytes]) -> Sequence[int]:
        """Where Python's own numbers are some of all: those next to 2."""
        places = [4 * at for kind, _, at in self.takes(module, function) if kind == "n"]
        keys = [tuple(int.from_bytes(row[at:at + 4], "little", signed=True) for at in places) for row in rows]
        taken = sorted({*keys}, key=lambda key: [abs(number - 2) for number in key])[:self.most]
        return [i for i, key in enumerate(keys) if key in taken]

    def run(self, cases: Sequence[Case], module: Module, inputs: bytes, folder: Path) -> bytes:
        syntax = self.syntax()

        def taken(type_: str) -> object:
            return [syntax.type_name(type_), [taken(part.type) for part in fields_of(module, type_)]] if (
                type_ in module.structs) else type_

        texts = {text: f"text{i}.py" for i, text in enumerate(dict.fromkeys(case.text for case in cases))}
        written_to(folder, {name: text for text, name in texts.items()})
        described = []
        for function, text, points in cases:
            takes = self.takes(module, function)
            described.append({
                "file": texts[text], "name": syntax.function_name(wgsl_name(function), is_public=True), "points": points,
                "takes": [taken(type_) for _, type_, _ in takes],
                "static": [i for i, (kind, _, _) in enumerate(takes) if kind == "n"],
                "words": sum(len(module.parts(type_)) for _, type_, _ in takes),
                "gives": sum(len(module.parts(part.type)) for part in results_of(function, module)) + sum(
                    len(module.parts(one.type)) for one in function.parameters if one.is_set and module.passed(one))})
        written_to(folder, {"cases.json": json.dumps(described)})
        (folder / "inputs").write_bytes(inputs)
        ran(folder, *self.python(), self.DRIVER, self.namespace, folder)
        return (folder / "outputs").read_bytes()

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        names = written_to(folder, {f"text{i}.py": text for i, text in enumerate(texts)})
        ran(folder, "python3", "-W", "error", "-m", "py_compile", *names)


class JaxRunner(PythonRunner):
    """Below jit, in an environment with what jax.txt names."""
    whole = THOROUGH
    arithmetics = ("fixed",)  # XLA fuses products of floats
    namespace = "jax.jit"
    most = 1  # and is compiled

    @property
    def package(self) -> str:
        return self.namespace.partition(".")[0]

    def check(self, lints: bool = False) -> None:
        super().check(lints)
        if environment(ROOT / "build" / f"python-{self.package}", self.DRIVER.with_name(f"{self.package}.txt")):
            raise Missing(f"{self.package} cannot be installed: PyPI cannot be reached")

    def python(self) -> Sequence[str | Path]:
        return [ROOT / "build" / f"python-{self.package}" / "bin" / "python"]


class TorchRunner(JaxRunner):  # its roots of floats are a bit off
    namespace = "torch"
    most = 3


class CompiledTorchRunner(JaxRunner):
    """torch.compile takes up to minutes for a function."""
    whole = False
    only = ("hn_perlin2", "hn_simplex2", "hn_value3_place", "hn_cellular2", "hn_fbm2", "hn_tile2")
    namespace = "torch.compile"


RUNNERS: dict[str, type[Runner]] = {language: of for language, of in {
    "rust": RustRunner, "csharp": CSharpRunner, "c": CRunner, "javascript": JavaScriptRunner, "java": JavaRunner,
    "go": GoRunner}.items() if of.syntax}  # else it was deleted
# Namespaces of arrays.
ARRAYS: dict[str, type[Runner]] = {} if PythonRunner.syntax is None else {
    "python": PythonRunner, "torch": TorchRunner, "jax": JaxRunner, "torch.compile": CompiledTorchRunner}
