"""Shaders by compilers that take no SPIR-V of Vulkan, and the instructions in their output: NVIDIA's nvcc, with
nvdisasm, which prints the machine's instructions, and Intel's IGC, which prints them itself.

SPIRV-Cross prints a shader in Metal's language. With metal.hpp before it, it is CUDA for nvcc, and C++ for OpenCL,
which Clang and LLVM compile to the SPIR-V that IGC takes. No compiler estimates a cost here, so instructions are counted,
each by the unit of the GPU that runs it.
"""

from __future__ import annotations

import math
import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from base import cuda
from base.debian import Missing
from measure.gpu import compiling
from measure.gpu.compiling import Compiled, Device

if TYPE_CHECKING:
    from measure.gpu.chips import Chip
    from measure.gpu.drivers import Drivers

HEADER = Path(__file__).with_name("metal.hpp")
# Clang's options. Operations that may be contracted are marked, and LLVM optimizes later.
OPTIONS = ("-x", "cl", "-cl-std=clc++", "-cl-no-stdinc", "-cl-denorms-are-zero", "-ffp-contract=fast",
           "-freciprocal-math", "-w", "-I", HEADER.parent)
# Functions that SPIRV-Cross defines for what must not be contracted; the header has them.
EXACT = re.compile(r"template<[^\n]*>\n\[\[clang::optnone\]\].*?\n}\n", re.DOTALL)
PARTS = re.compile(r"\.([xyzw]+)\b")  # of a vector
NUMBER = re.compile(r"\b\d+\.\d+(?:e[+-]?\d+)?")
EXACT_PRODUCT = "spvFMul("
BATCH = 24  # shaders that a compiler gets at once
LIMIT = 300.0  # seconds for them
PASSES = ("-O3", "-vectorize-slp=false", "-vectorize-loops=false")  # of LLVM; a compiler of shaders makes no vectors
# In place of "for (;;)", as SPIRV-Cross prints sums: nvcc writes a loop out if a condition stands in its head. No sum of
# the library has more octaves.
LOOP = "for (int step = 0; step < 32; ++step)"


class Failed(Exception):
    """Why a compiler refused a batch."""


def compile_all(found: Drivers, chip: Chip, shaders: Mapping[str, str | Failed], done: Callable[[], None] = lambda: None
                ) -> tuple[Device, list[Compiled]]:
    """One result for each shader, in order. A batch that is refused is tried again in halves."""
    compiler = COMPILERS[chip.vendor.driver](found, chip)
    try:
        device = compiler.device()
    except Failed as why:
        raise Missing(str(why)) from why

    def compiled(ids: Sequence[str]) -> dict[str, Compiled]:
        names = {f"k{number}": id for number, id in enumerate(ids)}
        try:
            statistics = compiler.statistics({name: shaders[id] for name, id in names.items()})
            return {id: Compiled(statistics[name], math.nan) for name, id in names.items()}
        except Failed as why:
            if len(ids) == 1:
                return {ids[0]: Compiled({}, math.nan, str(why))}
        half = len(ids) // 2
        return compiled(ids[:half]) | compiled(ids[half:])

    results: dict[str, Compiled] = {}
    possible = [id for id, text in shaders.items() if isinstance(text, str)]
    for start in range(0, len(possible), BATCH):
        batch = possible[start:start + BATCH]
        results |= compiled(batch)
        for _ in batch:
            done()
    results |= {id: Compiled({}, math.nan, str(why)) for id, why in shaders.items() if id not in results}
    return device, [results[id] for id in shaders]


class Compiler:
    """A chain of programs of the folder of drivers."""

    def __init__(self, found: Drivers, chip: Chip):
        self.found, self.chip = found, chip

    def call(self, command: Sequence[str | Path], folder: Path, **variables: str) -> str:
        """Its output. Failed if it ends with another status than 0."""
        ours = {name: value for name, value in os.environ.items() if not name.startswith(("IGC_", "LD_"))}
        try:
            done = subprocess.run([str(word) for word in command], cwd=folder, env={**ours, **variables}, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace", check=False,
                                  timeout=LIMIT)
        except subprocess.TimeoutExpired:
            raise Failed(f"the compiler gave no answer for {LIMIT:g} s") from None
        if done.returncode:
            lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
            why = next((line for line in lines if re.search("error|fatal", line, re.IGNORECASE)), "".join(lines[-1:]))
            why = why.replace(f"{folder}/", "").replace(f"{self.found.folder}/", "")
            raise Failed(f"the compiler {compiling.end(done.returncode)}{f' ({why[:200]})' * bool(why)}")
        return done.stdout

    def statistics(self, shaders: Mapping[str, str]) -> dict[str, dict[str, float]]:
        with tempfile.TemporaryDirectory() as scratch:
            found = self.compiled(shaders, Path(scratch))
        if missing := set(shaders) - set(found):
            raise Failed(f"the compiler printed nothing of {len(missing)} shaders")
        return found


class Nvcc(Compiler):
    def compiled(self, shaders: Mapping[str, str], folder: Path) -> dict[str, dict[str, float]]:
        text, binary, programs = folder / "shaders.cu", folder / "shaders.cubin", cuda.toolkit() / "bin"
        text.write_text(module(shaders), encoding="ascii")
        said = self.call([programs / "nvcc", "-std=c++17", f"-arch={self.chip.variable}", "-use_fast_math", "-w",
                          "-I", HEADER.parent, "-Xptxas", "-v", "-cubin", "-o", binary, text], folder)
        used = used_by_ptxas(said)
        counted = counts_of_sass(self.call([programs / "nvdisasm", "-c", binary], folder))
        return {name: {**counted[name], **used[name]} for name in shaders if name in counted and name in used}

    def device(self) -> Device:
        said = self.call([cuda.toolkit() / "bin/nvcc", "--version"], Path.cwd())
        version = re.search(r"release [\d.]+, V([\d.]+)", said)
        return Device(self.chip.variable, f"nvcc {version[1] if version else '?'}")


class Igc(Compiler):
    def compiled(self, shaders: Mapping[str, str], folder: Path) -> dict[str, dict[str, float]]:
        # IGC contracts sums and products of all kernels or of none.
        found = {}
        for exact in (False, True):
            chosen = {name: shader for name, shader in shaders.items() if (EXACT_PRODUCT in shader) is exact}
            if chosen:
                found |= self.by_ocloc(chosen, folder, "" if exact else "-cl-mad-enable")
        return found

    def optimized(self, shaders: Mapping[str, str], folder: Path) -> Path:
        text, plain, made = (folder / name for name in ("shaders.cl", "shaders.bc", "optimized.bc"))
        text.write_text(module(shaders), encoding="ascii")
        self.call(["clang", *OPTIONS, "--target=spir64-unknown-unknown", "-O3", "-Xclang", "-disable-llvm-passes",
                   "-Xclang", "-disable-lifetime-markers", "-Xclang", "-opaque-pointers", "-emit-llvm", "-c", text,
                   "-o", plain], folder)
        self.call([*self.found.program("opt"), *PASSES, plain, "-o", made], folder)
        return made

    def by_ocloc(self, shaders: Mapping[str, str], folder: Path, options: str) -> dict[str, dict[str, float]]:
        spirv = folder / "shaders.spv"
        self.call([*self.found.program("llvm-spirv"), self.optimized(shaders, folder), "-o", spirv], folder)
        said = self.call([*self.found.program("ocloc"), "compile", "-spirv_input", "-file", spirv, "-device",
                          self.chip.variable, "-output", "shaders", *(["-options", options] if options else [])],
                         folder, IGC_DumpASMToConsole="1")
        return counts_of_asm(said, self.chip.lanes)

    def device(self) -> Device:
        self.found.program("ocloc")
        return Device(self.chip.variable, f"IGC {self.found.version('libigc')}, LLVM {self.found.version('libllvm')}")


COMPILERS = {"nvcc": Nvcc, "ocloc": Igc}  # by the driver of a vendor

# Of NVIDIA's instructions: the unit by the first word, and by a modifier where that matters. The letters of an
# architecture may bring others; what is in no row runs on the ALU.
PIPES = (
    ("moves", re.compile(r"MOV|UMOV|IMAD\.MOV|HFMA2|CS2R|S2R|S2UR|R2UR|UR2R")),
    ("FP", re.compile(r"FADD|FMUL|FFMA")),
    ("IMAD", re.compile(r"IMAD|IMUL")),
    ("XU", re.compile(r"MUFU|F2I\b|I2F\b|F2F|FRND|POPC|FLO|BREV")),
    ("memory", re.compile(r"U?LD|ST|TEX|TLD|ATOM|RED")),
    ("branches", re.compile(r"BRA|BRX|BSSY|BSYNC|BREAK|BMOV|EXIT|CALL|RET|WARPSYNC|YIELD|NANOSLEEP|JMP")),
    ("uniform", re.compile(r"U[A-Z]|R2UR")),
)
SASS_KERNEL = re.compile(r"^\.text\.(\w+):")
SASS_LABEL = re.compile(r"^(\.L_\w+):")
SASS = re.compile(r"^\s+/\*[0-9a-f]{4,}\*/\s+(?:@!?U?P\w+\s+)?([A-Z][A-Z0-9_.]*)(.*)")
SASS_TARGET = re.compile(r"`\((\.L_\w+)\)")
PTXAS_KERNEL = re.compile(r"Compiling entry function '(\w+)'|Function properties for (\w+)")
PTXAS_SPILLS = re.compile(r"(\d+) bytes spill stores")
PTXAS_REGISTERS = re.compile(r"Used (\d+) registers")


def pipe(instruction: str) -> str:
    """The unit that runs it."""
    return next((name for name, pattern in PIPES if pattern.match(instruction)), "ALU")


def counts_of_sass(text: str) -> dict[str, dict[str, float]]:
    """By kernel: what nvdisasm prints. A warp takes an issue slot for each instruction."""
    kernels: dict[str, Counter[str]] = {}
    found, labels, place = Counter(), {}, 0
    for line in text.splitlines():
        if head := SASS_KERNEL.match(line):
            found, labels, place = kernels.setdefault(head[1], Counter()), {}, 0
        elif label := SASS_LABEL.match(line):
            labels[label[1]] = place
        elif instruction := SASS.match(line):
            if instruction[1] == "NOP":
                continue
            found[pipe(instruction[1])] += 1
            target = SASS_TARGET.search(instruction[2])
            # Behind the last instruction stands a branch to itself, for what runs on.
            if instruction[1].startswith("BRA") and target and labels.get(target[1], place) < place:
                found["Loops"] += 1
            place += 1
            found["Issue slots"] += 1
    return {name: dict(counted) for name, counted in kernels.items()}


def used_by_ptxas(text: str) -> dict[str, dict[str, float]]:
    """By kernel: what `ptxas -v` prints."""
    kernels: dict[str, dict[str, float]] = {}
    found: dict[str, float] = {}
    for line in text.splitlines():
        if head := PTXAS_KERNEL.search(line):
            found = kernels.setdefault(head[1] or head[2], {})
        if spills := PTXAS_SPILLS.search(line):
            found["Spilled bytes"] = int(spills[1])
        if registers := PTXAS_REGISTERS.search(line):
            found["Registers"] = int(registers[1])
    return kernels


ASM_KERNEL = re.compile(r"^//\.kernel (\w+)")
ASM_LABEL = re.compile(r"^(\w+):")
ASM_REGISTERS = re.compile(r"^//\.thread_config numGRF=(\d+)")
ASM_SPILLS = re.compile(r"^//\.spill size (\d+)")
# A jump has no width. Behind // stands a comment.
ASM = re.compile(r"^(?:\([^)]*\))?\s*(?:([a-z][\w.]*)\s*\((\d+)\|M\d+\)|(jmpi)\b)\s*((?:(?!//).)*)")
ASM_TYPE = re.compile(r":(\w+)")
JUMPS = re.compile(r"(?:goto|jmpi|brd|brc)\b")


def counts_of_asm(text: str, lanes: int) -> dict[str, dict[str, float]]:
    """By kernel: what IGC prints. An instruction passes once for each `lanes` lanes that it has, at least once; a
    message to memory and a branch once. Waits (sync, nop) are not counted. IGC compiles a kernel that spills once more,
    and prints it again: the last one counts."""
    kernels: dict[str, Counter[str]] = {}
    found, labels = Counter(), set()
    for line in text.splitlines():
        if head := ASM_KERNEL.match(line):
            found, labels = Counter(), set()
            kernels[head[1]] = found
        elif registers := ASM_REGISTERS.match(line):
            found["Registers"] = int(registers[1])
        elif spills := ASM_SPILLS.match(line):
            found["Spilled bytes"] = int(spills[1])
        elif label := ASM_LABEL.match(line):
            labels.add(label[1])
        elif instruction := ASM.match(line):
            name, width, operands = instruction[1] or instruction[3], int(instruction[2] or 1), instruction[4]
            kind, passes = unit(name, operands), max(1.0, width / lanes)
            if kind in ("memory", "branches"):
                passes = 1.0
            found["Instructions"] += 1
            found["Passes"] += passes
            found[kind] += passes
            if name == "while" or JUMPS.match(name) and labels & set(operands.split()):
                found["Loops"] += 1  # it goes back
    return {name: dict(counted) for name, counted in kernels.items()}


def unit(name: str, operands: str) -> str:
    """The kind of an instruction of Intel's."""
    first = name.split(".")[0]
    if first in ("send", "sends", "sendc", "sendsc", "load", "store"):
        return "memory"
    if first in ("if", "else", "endif", "while", "jmpi", "goto", "join", "brd", "brc", "call", "calla", "ret", "break",
                 "cont", "halt"):
        return "branches"
    if first == "math":
        return "math"
    type = ASM_TYPE.search(operands)
    floats = bool(type and type[1] in ("f", "hf", "df", "bf"))
    if first == "mov":
        return "moves"
    if not floats and first in ("mul", "mach", "macl", "mad", "mullh"):
        return "products"
    return "floats" if floats else "integers"


def module(shaders: Mapping[str, str]) -> str:
    """CUDA or C++ for OpenCL with a kernel for each shader, of its name."""
    return f'#include "{HEADER.name}"\n' + "".join(f"namespace metal::of_{name} {{{text}SHADER({name})\n}}\n"
                                                   for name, text in shaders.items())


def translated(files: Mapping[str, Path]) -> dict[str, str | Failed]:
    """The shaders of SPIR-V files in Metal's language, as metal.hpp takes it. Missing without the programs that
    translate them."""
    def parts(found: re.Match[str]) -> str:
        numbers = ["xyzw".index(letter) for letter in found[1]]
        return f"[{numbers[0]}]" if len(numbers) == 1 else f".at<{', '.join(map(str, numbers))}>()"

    def one(file: Path) -> str | Failed:
        done = subprocess.run(["spirv-cross", "--msl", "--msl-force-native-arrays", file], capture_output=True, text=True,
                              check=False)
        if done.returncode:
            return Failed(f"SPIRV-Cross: {done.stderr.strip()}")
        text = EXACT.sub("", done.stdout.partition("using namespace metal;")[2])
        return NUMBER.sub(r"\g<0>f", PARTS.sub(parts, text)).replace("for (;;)", LOOP)

    if missing := [program for program in ("clang", "spirv-cross") if not shutil.which(program)]:
        raise Missing(f"there is no {' and no '.join(missing)}, by which shaders are translated")
    return {id: one(file) for id, file in files.items()}
