"""The text of the library as HLSL: python3 hlsl_test.py

Names of types and of two functions are all that HLSL wants changed. glslang compiles it; what other compilers make of
its conditions is asked of the preprocessor of g++.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from itertools import product
from pathlib import Path

ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
ROOT = Path(__file__).resolve().parent.parent.parent
SHIM = {**{f"{glsl}vec{n}": f"{hlsl}{n}" for glsl, hlsl in (("", "float"), ("i", "int"), ("u", "uint")) for n in (2, 3, 4)},
        "uintBitsToFloat": "asfloat", "floatBitsToUint": "asuint"}
MAIN = """
RWStructuredBuffer<float> values;
[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  float2 p = float2(asfloat(id.x), asfloat(id.y));
  values[id.x] = hn_perlin(p) + hn_perlin(int3(id), float3(p, 0.5f), id.z) + hn_fbm(p, 5, 2.0f, 0.5f, id.z) +
                 hn_turbulence(float3(p, 1.0f), 5, 2.1f, 0.5f) + hn_clouds(p, 3, 2.0f, 0.5f) + hn_gradient(int2(id.xy)).x +
                 hn_unorm(hn_hash(id) ^ hn_lattice(int4(id, 1)));
}
"""


def library() -> str:
    return subprocess.run([ROOT / "tools" / "single-file"], capture_output=True, text=True, check=True).stdout


def defines(macros: dict[str, str]) -> str:
    return "".join(f"#define {name} {value}\n" for name, value in macros.items())


class Hlsl(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name, "library.hlsl")

    def says(self, *command: str) -> str:
        """What a compiler says of the file; nothing if it takes it."""
        done = subprocess.run([*command, str(self.file)], capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else f"exit status {done.returncode}: {done.stdout}{done.stderr}"

    def compiled(self, text: str, **knobs: str) -> str:
        self.file.write_text(defines(SHIM | knobs) + text + MAIN)
        return self.says("glslangValidator", "-D", "-V", "-S", "comp", "-e", "main", "-o", str(self.file) + ".spv")

    def preprocessed(self, text: str, *macros: str) -> str:
        self.file.write_text(text)
        return self.says("g++", "-E", "-x", "c", "-Wundef", "-Werror", "-o", "/dev/null", *macros)

    def test_it_compiles_with_every_arithmetic_and_gradient(self):
        text = library()
        for arithmetic, gradient, hashed in product(ARITHMETICS, ("OCTAHEDRAL", "SINE"), ("LATTICE", "PCG", "FNV1")):
            knobs = {"HN_ARITHMETIC": arithmetic, "HN_GRADIENT": f"HN_GRADIENT_{gradient}",
                     "HN_HASH": f"HN_HASH_{hashed}"}
            with self.subTest(**knobs):
                self.assertEqual(self.compiled(text, **knobs), "")

    def test_a_function_that_only_glsl_has_is_refused(self):
        text = library()
        wrong = text.replace("p - floor(p)", "fract(p)")
        self.assertNotEqual(wrong, text)
        self.assertIn("fract", self.compiled(wrong))

    # g++ defines __VERSION__ as a string, as DXC does; without it, its preprocessor is like naga's or Godot's.
    WITHOUT_A_NUMBER = (("-D__HLSL_VERSION=2021",), ("-U__VERSION__",))

    def test_no_condition_asks_for_a_name_or_a_number_that_may_not_be_there(self):
        text = library()
        for macros in self.WITHOUT_A_NUMBER:
            for arithmetic in ARITHMETICS:
                with self.subTest(macros=macros, arithmetic=arithmetic):
                    self.assertEqual(self.preprocessed(text, f"-DHN_ARITHMETIC={arithmetic}", *macros), "")

    def test_a_condition_that_does_is_noticed(self):
        for macros in self.WITHOUT_A_NUMBER:
            wrong = library() + "#if __VERSION__ < 130\n#endif\n"
            self.assertIn("__VERSION__", self.preprocessed(wrong, *macros))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
