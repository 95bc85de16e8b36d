"""Microsoft's compilers take the HLSL of the page, and their code has the golden values. The test pick.translators gives them
the whole library, and each function.

    python3 -m translate.hlsl.compilers_test dxc|fxc HN_CONFORM

Exit status: 0 so it is, 1 it is not, 77 the compiler cannot be had here.
"""

from __future__ import annotations

import os
import re
import resource
import subprocess
import sys
import unittest
from collections.abc import Mapping
from pathlib import Path

from base.debian import program
from base.testing import Case, skipped_without
from base.tree import GLSL, ROOT
from translate.hlsl.compilers import Compiled, compiled, refusal
from translate.pick import command
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES
from translate.tools import DXC, FXC, Tool
from translate.whole import library

PAGE = (ROOT / "docs" / "guide" / "languages.md").read_text(encoding="utf-8")
CODE = re.findall(r"^```hlsl\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
COMPUTE, = (text for text in CODE if "numthreads" in text)
INCLUDING = """#include "hashnoise/hashnoise.hlsl"
float4 main(float2 uv : TEXCOORD0) : SV_Target { return hn_fbm(uv * 8.0, 6, 2.0, 0.5, 7u); }
"""
LAVAPIPE = sorted(Path("/usr/share/vulkan/icd.d").glob("lvp_icd*.json"))
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


class Hlsl(Case):
    tool: Tool
    conform: str
    faults: Mapping[str, str] = {}

    def made(self, texts: Mapping[str, str], profile: str) -> dict[str, Compiled]:
        """The compiler's results of texts with the library beside them."""
        (self.folder / "hashnoise").unlink(missing_ok=True)
        (self.folder / "hashnoise").symlink_to(GLSL)
        files = {name: self.folder / f"{name}.hlsl" for name in texts}
        for name, file in files.items():
            file.write_text(texts[name], encoding="ascii")
        return dict(zip(files, compiled(self.tool, list(files.values()), profile)))

    def run_suite(self, *steps: str) -> None:
        """The tables of expected failures here are for drivers that compile by other means."""
        (self.folder / "expect").mkdir()
        (self.folder / "expect" / "faults.csv").write_text("driver,renderer,case,status,reason\n" + "".join(
            f'vulkan:*,*,bugs.{case}.*.defined,fail,"{reason}"\n' for case, reason in self.faults.items()), encoding="ascii")
        done = subprocess.run(
            [self.conform, "run", "--driver", "vulkan:0", *(f"--through={step}" for step in steps), "--out",
             self.folder / "out", "--expect", self.folder / "expect"],
            env={**os.environ, "VK_DRIVER_FILES": str(LAVAPIPE[0])}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-4000:] + done.stderr)
        counts, = re.findall(r"^(\d+) pass(.*);", done.stdout, re.MULTILINE)
        self.assertGreaterEqual(int(counts[0]), 90)
        self.assertNotIn("unsupported", counts[1])


class Dxc(Hlsl):
    tool = DXC
    faults = {"negated_quotient": "-(x / 4u) becomes x / -4u (SPIRV-Tools 5822, 4456)",
              "int_of_uint_vector": "float2(int2(uint2)) is float2(uint2) (DXC 3396, 6975)",
              "highest_bit": "firstbithigh of a negative int is that of its word (DXC 5665)",
              "enum_constant": "a constant of an enum in a product of floats keeps its bits (DXC 6884)",
              "vector_behind_loop": "lavapipe of Mesa 22.3.6, whatever the compiler (conformance/run/expect/lavapipe.csv)"}

    def test_golden_values(self) -> None:
        self.run_suite(f"dxc:spirv={self.tool.path()}")

    def test_includes_and_the_code_of_the_page_compile(self) -> None:
        texts = {arithmetic: f"#define HN_ARITHMETIC HN_{arithmetic.upper()}\n{INCLUDING}" for arithmetic in command.ARITHMETICS}
        texts |= {f"page{i}": text for i, text in enumerate(CODE) if text != COMPUTE}
        for name, made in (self.made(texts, "ps_6_0") | self.made({"compute": COMPUTE}, "cs_6_0")).items():
            with self.subTest(name):
                self.assertEqual(refusal(made), "")


class Fxc(Hlsl):
    tool = FXC

    def test_golden_values(self) -> None:
        self.run_suite(f"fxc={self.tool.path()}", f"vkd3d={program('vkd3d-compiler')}")

    def test_its_own_includes_are_not_beside_the_file(self) -> None:
        """docs/guide/languages.md has the way that works. If this fails, there is another."""
        self.assertIn("X1507", refusal(self.made({"including": INCLUDING}, "ps_5_0")["including"]))

    def test_a_loop_that_is_unrolled_is_long(self) -> None:
        """It prints the seconds of a processor that the page has."""
        for arithmetic in ("fast", "fixed"):
            noise = command.picked(["hn_fbm3"], command.Choice("hlsl", arithmetic))
            sizes = []
            for attribute in ("[loop]", "[unroll]"):
                text = COMPUTE.replace('#include "hashnoise/hashnoise.hlsl"\n', noise).replace("[loop]", attribute)
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                made = self.made({"shader": text}, "cs_5_0")["shader"]
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                print(f"{arithmetic}, {attribute}: {seconds:.1f} s, {len(made.code)} bytes")
                self.assertEqual(refusal(made), "")
                sizes.append(len(made.code))
            self.assertGreater(sizes[1], 4 * sizes[0])

    def test_the_floor_of_a_value_is_there(self) -> None:
        texts = {"plain": library("hlsl", "fast").replace("#define HN_I_FXC", "") + FLOOR.format("hn_unorm(words[id.x])")}
        for arithmetic in command.ARITHMETICS:
            whole = read(GLSL, {**command.settings(arithmetic, "lattice"), **LANGUAGES["hlsl"].library})
            for call, name in CALLS.items():
                made = Program(whole, chosen(whole, [name])).text(LANGUAGES["hlsl"], arithmetic == "precise")
                texts[f"{name}.{arithmetic}.picked"] = made + FLOOR.format(call)
                texts[f"{name}.{arithmetic}"] = library("hlsl", arithmetic) + FLOOR.format(call)
        without = {f"{name}.without": text.replace("asuint(floor(", "asuint((") for name, text in texts.items()}
        rounds = {name: self.rounds(made) for name, made in self.made({**texts, **without}, "cs_5_0").items()}
        self.assertEqual([name for name in texts if rounds[name] <= rounds[f"{name}.without"]], ["plain"])

    def rounds(self, made: Compiled) -> int:
        """How often a program rounds down."""
        self.assertTrue(made.code, made.messages)
        (self.folder / "code").write_bytes(made.code)
        shown = subprocess.run([program("vkd3d-compiler"), "-x", "dxbc-tpf", "-b", "d3d-asm", self.folder / "code"],
                               capture_output=True, text=True, check=True).stdout
        return len(re.findall(r"\bround_ni\b", shown))


if __name__ == "__main__":
    which, Hlsl.conform = sys.argv[1:3]
    case = {"dxc": Dxc, "fxc": Fxc}[which]
    with skipped_without():
        case.tool.path()
        program("vkd3d-compiler")
    del sys.argv[1:3]
    unittest.main(defaultTest=case.__name__)
