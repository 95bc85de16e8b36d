"""Microsoft's compilers take the HLSL of the library and of files, and their code has the golden values.

    python3 -m translate.hlsl.compilers_test dxc|fxc HN_CONFORM

Exit status: 0 so it is, 1 it is not, 77 the compiler cannot be had here.
"""

from __future__ import annotations

import functools
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.debian import Missing, program
from base.testing import skipped_without
from base.tree import GLSL, ROOT, TOOLS
from translate.hlsl.compilers import Compiled, compiled, refusal
from translate.pick import command
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES
from translate.tools import DXC, FXC

PAGE = (ROOT / "docs" / "guide" / "languages.md").read_text(encoding="utf-8")
CODE = re.findall(r"^```hlsl\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
COMPUTE, = (text for text in CODE if "numthreads" in text)
LAVAPIPE = Path("/usr/share/vulkan/icd.d")
MAIN = """
float4 main(float2 uv : TEXCOORD0) : SV_Target {
  float3 n = hn_fbm_d(uv * 8.0, 6, 2.0, 0.5, 7u);
  float2 c = hn_cellular(hn_tile(uv * 4.0, int2(4, 4)), 7u);
  return float4(n.x + hn_simplex(float3(uv, c.y), 7u), n.y, c.x, hn_gullies(uv, n.yz, 4, 2.0, 0.5, 0.1, 7u).x);
}
"""
# FXC takes a whole number times a small one for a whole number, and leaves out the floor of it.
FLOOR = """
RWStructuredBuffer<uint> words;
[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {{
  words[id.x] = asuint(floor({} * 6.0));
}}
"""

# Inputs that become floats of whole numbers, each with the name of a picked function.
POINT = "asfloat(words[id.x])"
CALLS = {"hn_unorm(words[id.x])": "hn_unorm", "hn_snorm(words[id.x])": "hn_snorm",
         f"hn_random({POINT}, 7u)": "hn_random1", f"hn_perlin(float2({POINT}, 0.5), 7u)": "hn_perlin2",
         f"hn_fbm(float2({POINT}, 0.5), 6, 2.0, 0.5, 7u)": "hn_fbm2",
         f"hn_cellular(float2({POINT}, 0.5), 7u).x": "hn_cellular2",
         "hn_fraction(int(words[id.x]), 7, 7)": "hn_fraction1"}


@functools.cache
def library(arithmetic: str) -> str:
    """All of it as one file, as users make it."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "all.hlsl"
        subprocess.run([sys.executable, TOOLS / "pick", "whole", "--language", "hlsl", "--strip", "--out", file],
                       check=True, capture_output=True)
        return f"#define HN_ARITHMETIC HN_{arithmetic.upper()}\n{file.read_text(encoding='ascii')}"


class Compiler:
    filter: str  # of the cases of the suite that it compiles

    def compile(self, texts: dict[str, str], stage: str) -> dict[str, Compiled]:
        """The compilers' results."""
        raise NotImplementedError

    def values(self) -> dict[str, str]:
        """The suite's environment, to run this compiler's output."""
        raise NotImplementedError


class ByDxc(Compiler):
    filter = "*.hlsl60.*"

    def __init__(self) -> None:
        self.program = DXC.path()

    def compile(self, texts: dict[str, str], stage: str) -> dict[str, Compiled]:
        found = {}
        with tempfile.TemporaryDirectory() as folder:
            for name, text in texts.items():
                file = Path(folder) / f"{name}.hlsl"
                file.write_text(text, encoding="ascii")
                profile = {"pixel": "ps_6_0", "compute": "cs_6_0"}[stage]
                made, = compiled(DXC, [file], profile, "main", "-spirv", "-fspv-target-env=vulkan1.1", "-I",
                                       str(GLSL.parent))
                if made.code:
                    (Path(folder) / "code").write_bytes(made.code)
                    judged = subprocess.run(["spirv-val", "--target-env", "vulkan1.1", Path(folder) / "code"],
                                            capture_output=True, text=True, check=False)
                    made = made._replace(messages=made.messages + judged.stdout + judged.stderr)
                    direct, = compiled(DXC, [file], profile, "main", "-I", str(GLSL.parent))  # what Direct3D 12 takes
                    if not direct.code:
                        made = direct
                found[name] = made
        return found

    def values(self) -> dict[str, str]:
        return {"HN_DXC": str(self.program)}


class ByFxc(Compiler):
    filter = "*.hlsl50.*"

    def __init__(self) -> None:
        FXC.path()
        self.vkd3d = program("vkd3d-compiler")  # what Direct3D 11 takes becomes SPIR-V by it
        self.scratch = tempfile.TemporaryDirectory()

    def compile(self, texts: dict[str, str], stage: str) -> dict[str, Compiled]:
        found: dict[str, Compiled] = {}
        names = list(texts)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "hashnoise").symlink_to(GLSL)
            for i in range(0, len(names), 50):  # to start it takes a second
                files = [Path(folder) / f"{name}.hlsl" for name in names[i:i + 50]]
                for name, file in zip(names[i:i + 50], files):
                    file.write_text(texts[name], encoding="ascii")
                made = compiled(FXC, files, {"pixel": "ps_5_0", "compute": "cs_5_0"}[stage])
                found |= dict(zip(names[i:i + 50], made))
        return found

    def values(self) -> dict[str, str]:
        stand_in = Path(self.scratch.name) / "vkd3d-compiler"
        command = shlex.join([sys.executable, "-B", "-m", "translate.hlsl.compilers"])
        stand_in.write_text(f'#!/bin/sh\nPYTHONPATH={shlex.quote(str(TOOLS / "lib"))} exec {command} "$@"\n')
        stand_in.chmod(0o755)
        return {"HN_VKD3D_COMPILER": str(stand_in), "HN_VKD3D_REAL": str(self.vkd3d)}


class Hlsl(unittest.TestCase):
    compiler: Compiler
    conform: str

    def refused(self, texts: dict[str, str], stage: str = "pixel") -> dict[str, str]:
        """Texts that do not compile, or not in silence."""
        return {name: said for name, made in self.compiler.compile(texts, stage).items() if (said := refusal(made))}

    def test_the_whole_library(self) -> None:
        texts = {arithmetic: library(arithmetic) + MAIN for arithmetic in command.ARITHMETICS}
        self.assertEqual(self.refused(texts), {})
        self.assertEqual([*self.refused({"wrong": texts["fast"].replace("hn_fbm_d(uv", "hn_fbn_d(uv")})], ["wrong"])

    def run_suite(self, glsl: Path, filter_: str) -> tuple[int, str]:
        drivers = sorted(LAVAPIPE.glob("lvp_icd*.json"))
        with tempfile.TemporaryDirectory() as out, tempfile.TemporaryDirectory() as no_excuses:  # those are vkd3d's
            done = subprocess.run(
                [self.conform, "run", "--driver", "vulkan:0", "--glsl", glsl, "--filter", filter_, "--out", out,
                 "--expect", no_excuses],
                env={**os.environ, **self.compiler.values(), "VK_DRIVER_FILES": str(drivers[0])}, capture_output=True,
                text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_golden_values_on_lavapipe(self) -> None:
        status, said = self.run_suite(GLSL, self.compiler.filter)
        self.assertEqual(status, 0, said[-4000:])
        passed = re.search(r"(\d+) pass(, \d+ unsupported)?;", said)
        self.assertTrue(passed and int(passed[1]) >= 90 and not passed[2], said[-1000:])
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "hashnoise"
            shutil.copytree(GLSL, copy)
            for file in copy.rglob("*.glsl"):
                file.write_text(file.read_text().replace("0x85EBCA77u", "0x85EBCA79u"))
            status, said = self.run_suite(copy, self.compiler.filter.replace("*.", "noise2d.perlin.*", 1))
            self.assertEqual(status, 1, said[-1000:])
            self.assertIn("values are wrong", said)


class Dxc(Hlsl):
    def test_it_includes_the_library(self) -> None:
        included = f'#include "hashnoise/hashnoise.hlsl"\n{MAIN}'
        texts = {arithmetic: f"#define HN_ARITHMETIC HN_{arithmetic.upper()}\n{included}"
                 for arithmetic in command.ARITHMETICS}
        texts |= {f"page{i}": text for i, text in enumerate(CODE) if "numthreads" not in text}
        self.assertEqual(self.refused(texts), {})
        self.assertEqual(self.refused({"page": COMPUTE}, "compute"), {})


class FxcOnly(Hlsl):
    def test_its_own_includes_are_not_beside_the_file(self) -> None:
        """docs/guide/languages.md has the way that works. If this fails, there is another."""
        said = self.refused({"including": f'#include "hashnoise/hashnoise.hlsl"\n{MAIN}'})
        self.assertIn("X1507", said["including"])

    def test_a_loop_that_is_unrolled_is_long(self) -> None:
        """It prints the seconds of a processor that the page has."""
        for arithmetic in ("fast", "fixed"):
            noise = command.picked(["hn_fbm3"], command.Choice("hlsl", arithmetic))
            sizes = []
            for attribute in ("[loop]", "[unroll]"):
                text = COMPUTE.replace('#include "hashnoise/hashnoise.hlsl"\n', noise).replace("[loop]", attribute)
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                made = self.compiler.compile({"shader": text}, "compute")["shader"]
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                print(f"{arithmetic}, {attribute}: {seconds:.1f} s, {len(made.code)} bytes")
                self.assertEqual(refusal(made), "")
                sizes.append(len(made.code))
            self.assertGreater(sizes[1], 4 * sizes[0])

    def test_the_floor_of_a_value_is_there(self) -> None:
        texts = {"plain": library("fast").replace("#define HN_I_FXC", "") + FLOOR.format("hn_unorm(words[id.x])")}
        for arithmetic in command.ARITHMETICS:
            whole = read(GLSL, {**command.settings(arithmetic, "lattice"), **LANGUAGES["hlsl"].library})
            for call, name in CALLS.items():
                made = Program(whole, chosen(whole, [name])).text(LANGUAGES["hlsl"], arithmetic == "precise")
                texts[f"{name}.{arithmetic}.picked"] = made + FLOOR.format(call)
                texts[f"{name}.{arithmetic}"] = library(arithmetic) + FLOOR.format(call)
        without = {f"{name}.without": text.replace("asuint(floor(", "asuint((") for name, text in texts.items()}
        compiled = self.compiler.compile({**texts, **without}, "compute")
        rounds = {name: self.rounds(made) for name, made in compiled.items()}
        self.assertEqual([name for name in texts if rounds[name] <= rounds[f"{name}.without"]], ["plain"])

    def rounds(self, made: Compiled) -> int:
        """How often a program rounds down."""
        self.assertTrue(made.code, made.messages)
        with tempfile.NamedTemporaryFile() as file:
            file.write(made.code)
            file.flush()
            shown = subprocess.run([self.compiler.vkd3d, "-x", "dxbc-tpf", "-b", "d3d-asm", file.name],
                                   capture_output=True, text=True, check=True).stdout
        return len(re.findall(r"\bround_ni\b", shown))


if __name__ == "__main__":
    which, Hlsl.conform = sys.argv[1:3]
    case = {"dxc": Dxc, "fxc": FxcOnly}[which]
    with skipped_without(Missing):
        case.compiler = {"dxc": ByDxc, "fxc": ByFxc}[which]()
    del sys.argv[1:3]
    unittest.main(defaultTest=case.__name__)
