"""Particles that a flow carries end at the same bits in JavaScript, in a shader and in C++: 100,000 steps of picked text
and of the header, with HN_FIXED. A step is a power of two times the velocity: the product is exact, so a compiler may
fuse it with the sum."""

from __future__ import annotations

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.testing import skipped_without
from base.tree import ROOT, TOOLS
from translate.pick.runners import ran
from translate.wgsl.device import Device
from translate.wgsl.wgpu_program import GROUP

FUNCTION = "hn_curl_fbm3_phase"
PARTICLES, STEPS = 100, 1000
STEP = 2.0**-6  # of the time
# A particle starts by its number, and the flow changes with the number of the step. All of these numbers are exact.
START = ("{i} * 0.25", "2.5 - {i} * 0.125", "{i} * 0.0625")
SETTINGS = "{step} * 0.0009765625, 3, 2.0, 0.5, 7"

JAVASCRIPT = """import {{ curlFbm3Phase }} from "./picked.mjs";
const words = new Uint32Array(3 * {particles}), p = new Float32Array(words.buffer);
for (let i = 0; i < {particles}; i++) {{
  let [x, y, z] = [{start}].map(Math.fround);
  for (let step = 0; step < {steps}; step++) {{
    const [u, v, w] = curlFbm3Phase(x, y, z, {settings});
    [x, y, z] = [Math.fround(x + u * {size}), Math.fround(y + v * {size}), Math.fround(z + w * {size})];
  }}
  p.set([x, y, z], 3 * i);
}}
console.log(words.join(" "));
"""
GLSL = """#version 450
{picked}
layout(local_size_x = {group}) in;
layout(std430, binding = 1) readonly buffer Inputs {{ uint inputs[]; }};
layout(std430, binding = 0) buffer Outputs {{ uint outputs[]; }};
void main() {{
  uint i = gl_GlobalInvocationID.x;
  if (i < {particles}u) {{
    vec3 p = vec3({start});
    for (int step = 0; step < {steps}; step++) p += {size} * hn_curl_fbm(p, {settings}u);
    for (int axis = 0; axis < 3; axis++) outputs[3u * i + uint(axis)] = floatBitsToUint(p[axis]);
  }}
}}
"""
CPP = """#include <cstdio>
#include <hashnoise/hashnoise.hpp>
using namespace hashnoise;
int main() {{
  for (int i = 0; i < {particles}; ++i) {{
    vec3 p({start});
    for (int step = 0; step < {steps}; ++step) {{
      const vec3 v = hn_curl_fbm(p, {settings}u);
      p = vec3(p.x + {size} * v.x, p.y + {size} * v.y, p.z + {size} * v.z);
    }}
    std::printf("%u %u %u ", floatBitsToUint(p.x), floatBitsToUint(p.y), floatBitsToUint(p.z));
  }}
}}
"""


def program(text: str, number: str, step: str, size: float, **more: str) -> str:
    """The text with all but its pick filled in; `number` and `step` are these as floats."""
    return text.format(particles=PARTICLES, steps=STEPS, start=", ".join(START).format(i=number), size=repr(size),
                       settings=SETTINGS.format(step=step), group=GROUP, **more)


def picked(language: str) -> str:
    return subprocess.run([TOOLS / "pick", FUNCTION, "--language", language, "--arithmetic", "fixed"],
                          capture_output=True, text=True, check=True).stdout


def words_of(text: str) -> list[int]:
    return list(map(int, text.split()))


def in_javascript(folder: Path, size: float = STEP) -> list[int]:
    (folder / "picked.mjs").write_text(picked("javascript"), encoding="ascii")
    (folder / "main.mjs").write_text(program(JAVASCRIPT, "i", "step", size), encoding="ascii")
    return words_of(ran(folder, "node", "main.mjs"))


def in_a_shader(folder: Path, size: float = STEP) -> list[int]:
    text = program(GLSL, "float(i)", "float(step)", size, picked=picked("glsl"))
    (folder / "main.comp").write_text(text, encoding="ascii")
    ran(folder, "glslangValidator", "-V", "main.comp", "-o", "made")
    found = Device().run((folder / "made").read_bytes(), bytes(4), 12 * PARTICLES, PARTICLES)
    return memoryview(found).cast("B").cast("I").tolist()


def in_cpp(folder: Path, size: float = STEP, *options: str) -> list[int]:
    text = program(CPP, "static_cast<float>(i)", "static_cast<float>(step)", size)
    (folder / "main.cpp").write_text(re.sub(r"\b\d+\.\d+\b", r"\g<0>f", text), encoding="ascii")
    ran(folder, "g++", "-std=c++20", "-O1", "-DHN_ARITHMETIC=HN_FIXED", "-I", ROOT / "include", *options, "main.cpp",
        "-o", "main")
    return words_of(ran(folder, folder / "main"))


class Particles(unittest.TestCase):
    """They are as far apart at the end as a flow takes them, and each bit of the way counts."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_all_languages_end_at_the_same_bits(self) -> None:
        found = in_cpp(self.folder)
        self.assertEqual(len({*found}), 3 * PARTICLES)
        self.assertEqual(in_javascript(self.folder), found)
        self.assertEqual(in_a_shader(self.folder), found)
        self.assertEqual(in_cpp(self.folder, STEP, "-O2", "-mfma", "-ffp-contract=fast"), found)

    def test_another_step_ends_elsewhere(self) -> None:
        """One that is no power of two, in the last bit."""
        expected = in_javascript(self.folder)
        for of in (in_javascript, in_a_shader, in_cpp):
            other = of(self.folder, STEP * (1 + 2.0**-23))
            self.assertGreater(sum(a != b for a, b in zip(other, expected, strict=True)), PARTICLES, of)


if __name__ == "__main__":
    with skipped_without():
        Device()
    unittest.main()
