"""Shaders that call picked functions, and what runs them: wgpu, to which HLSL comes by glslang or DXC and Slang by its
own compiler; Metal's language is compiled as C++, with the suite's stand-in for <metal_stdlib>."""

from __future__ import annotations

import functools
import itertools
import re
import shutil
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing
from base.tree import ROOT
from translate.library_file import ARITHMETICS
from translate.parsing.syntax import Function
from translate.pick.calling import Form
from translate.pick.comparison import OTHER_KNOBS
from translate.pick.evaluate import Module
from translate.pick.runners import ran
from translate.pick.shading import LANGUAGES
from translate.tools import DXC, SLANG
from translate.wgsl.device import Device
from translate.wgsl.wgpu_program import GROUP


def pairs_of(names: Iterable[str]) -> list[tuple[str, str]]:
    """Functions that people take together, since their names begin alike, and their dimensions are the same."""
    families: dict[tuple[str, ...], list[str]] = {}
    for name in names:
        if family := re.match(r"hn_([a-z]{4})[a-z_]*?([1-4])", name):
            families.setdefault(family.groups(), []).append(name)
    return [pair for family in families.values() for pair in itertools.combinations(family, 2)]


@functools.cache
def device() -> Device:
    return Device()


class Case(NamedTuple):
    """A text of a function of a split module, its arguments, and how many bytes come back."""
    module: Module
    function: Function
    text: str
    inputs: bytes
    size: int


class Runner:
    """Runs shaders of a language."""
    form: Form
    arithmetics: Sequence[str] = ("fixed",)  # whose words are the library's
    # The text behind a pick, by the words that a call takes and gives at each of the points.
    entry: str

    def entry_of(self, case: Case, points: int) -> str:
        lines, taken, given = self.form.call(case.module, case.function)
        return self.entry.format(points=points, taken=taken, given=given, group=GROUP,
                                 lines="".join(f"    {line}\n" for line in lines))

    def run(self, cases: Sequence[Case], points: int) -> list[bytes]:
        """The functions' results for these words, one behind another."""
        raise NotImplementedError


class GlslRunner(Runner):
    """Its texts alone: of Vulkan, and of GLSL ES 3.10."""
    form = Form(LANGUAGES["glsl"], struct="{type}({fields})",
                read={"float": "uintBitsToFloat({})", "int": "int({})", "uint": "{}", "bool": "({} & 1u) != 0u"},
                write={"float": "floatBitsToUint({})", "int": "uint({})", "uint": "{}", "bool": "{} ? 1u : 0u"})
    entry = """
layout(local_size_x = {group}) in;
layout(std430, binding = 1) readonly buffer Inputs {{ uint inputs[]; }};
layout(std430, binding = 0) buffer Outputs {{ uint outputs[]; }};
void main() {{
  uint at = {taken}u * gl_GlobalInvocationID.x, to = {given}u * gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x < {points}u) {{
{lines}  }}
}}
"""


class WgslRunner(Runner):
    form = Form(LANGUAGES["wgsl"],
                read={"float": "bitcast<f32>({})", "int": "bitcast<i32>({})", "uint": "{}", "bool": "{} != 0u"},
                write={"float": "bitcast<u32>({})", "int": "bitcast<u32>({})", "uint": "{}",
                       "bool": "select(0u, 1u, {})"},
                declare="var {name}: {type}{value};", struct="{type}({fields})", passed="&{}", result="let result = ")
    entry = """
@group(0) @binding(1) var<storage, read> inputs: array<u32>;
@group(0) @binding(0) var<storage, read_write> outputs: array<u32>;
@compute @workgroup_size({group}) fn main(@builtin(global_invocation_id) id: vec3u) {{
  if (id.x < {points}u) {{
    let at = {taken}u * id.x;
    let to = {given}u * id.x;
{lines}  }}
}}
"""

    def __init__(self) -> None:
        self.device = device()

    def compiled(self, text: str) -> str | bytes:
        """As wgpu takes it."""
        return text

    def run(self, cases: Sequence[Case], points: int) -> list[bytes]:
        return [bytes(self.device.run(self.compiled(case.text + self.entry_of(case, points)), case.inputs, case.size,
                                      points)) for case in cases]


class HlslRunner(WgslRunner):
    form = Form(LANGUAGES["hlsl"],
                read={"float": "asfloat({})", "int": "asint({})", "uint": "{}", "bool": "({} != 0u)"},
                write={"float": "asuint({})", "int": "asuint({})", "uint": "{}", "bool": "({} ? 1u : 0u)"})
    entry = """
[[vk::binding(1)]] StructuredBuffer<uint> inputs;
[[vk::binding(0)]] RWStructuredBuffer<uint> outputs;
[numthreads({group}, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{
  if (id.x < {points}u) {{
    uint at = {taken}u * id.x, to = {given}u * id.x;
{lines}  }}
}}
"""

    def __init__(self) -> None:
        super().__init__()
        self.words()

    def words(self) -> Sequence[str | Path]:
        """The command that makes SPIR-V; raises Missing."""
        return "glslangValidator", "-D", "-V", "-S", "comp", "-e", "main", "-o", "made", "shader.hlsl"

    def compiled(self, text: str) -> str | bytes:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "shader.hlsl").write_text(text, encoding="ascii")
            ran(Path(folder), *self.words())
            return (Path(folder) / "made").read_bytes()


class DxcRunner(HlslRunner):
    def words(self) -> Sequence[str | Path]:
        return (DXC.path(), "-spirv", "-fspv-target-env=vulkan1.1", "-T", "cs_6_0", "-E", "main", "-Fo", "made", "shader.hlsl")


class SlangRunner(HlslRunner):
    """To WGSL."""

    def words(self) -> Sequence[str | Path]:
        return (SLANG.path(), "-lang", "slang", "shader.hlsl", "-target", "wgsl", "-entry", "main", "-stage", "compute", "-o",
                "made")

    def compiled(self, text: str) -> str | bytes:
        return super().compiled(text).decode()


class MetalRunner(Runner):
    """All texts are in one program, since it takes seconds to compile. It reads `inputs`, and writes `outputs`."""
    form = Form(LANGUAGES["metal"],
                read={"float": "as_type<float>({})", "int": "as_type<int>({})", "uint": "{}", "bool": "{} != 0u"},
                write={"float": "as_type<uint>({})", "int": "as_type<uint>({})", "uint": "{}", "bool": "uint({})"})
    arithmetics = (*ARITHMETICS, OTHER_KNOBS)
    entry = """
int run(std::FILE* read, std::FILE* written) {{
  std::vector<uint> inputs({taken}u * {points}u), outputs({given}u * {points}u);
  if (std::fread(inputs.data(), sizeof(uint), inputs.size(), read) != inputs.size()) return 1;
  for (uint i = 0u; i < {points}u; i++) {{
    const uint at = {taken}u * i, to = {given}u * i;
{lines}  }}
  return std::fwrite(outputs.data(), sizeof(uint), outputs.size(), written) != outputs.size();
}}
"""
    MAIN = """int main() {{
  std::FILE* read = std::fopen("inputs", "rb");
  std::FILE* written = std::fopen("outputs", "wb");
  const int failed = {calls};
  return std::fclose(written) | failed;
}}
"""

    def __init__(self) -> None:
        if not shutil.which("clang++"):
            raise Missing("there is no clang++: apt-get install clang")

    def run(self, cases: Sequence[Case], points: int) -> list[bytes]:
        runs = "".join(f"namespace text{number} {{\n{case.text}{self.entry_of(case, points)}}}\n"
                       for number, case in enumerate(cases))
        calls = " | ".join(f"text{number}::run(read, written)" for number in range(len(cases)))
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            shutil.copy(ROOT / "conformance" / "gpu" / "metal" / "metal_stdlib.hpp", folder / "metal_stdlib")
            (folder / "main.cpp").write_text("#include <metal_stdlib>\n#include <cstdio>\n#include <vector>\n" + runs
                                             + self.MAIN.format(calls=calls), encoding="ascii")
            (folder / "inputs").write_bytes(b"".join(case.inputs for case in cases))
            ran(folder, "clang++", "-std=c++14", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-I.",
                "-fsanitize=shift,signed-integer-overflow", "-fno-sanitize-recover=all", "main.cpp")
            ran(folder, "./a.out")
            got = (folder / "outputs").read_bytes()
        found = []
        for case in cases:
            found.append(got[:case.size])
            got = got[case.size:]
        return found


RUNNERS: dict[str, type[Runner]] = {"wgsl": WgslRunner, "hlsl": HlslRunner, "dxc": DxcRunner,
                                    "slang": SlangRunner, "metal": MetalRunner}
