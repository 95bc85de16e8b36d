"""The generated WGSL compiles, and passes the suite, outside of a browser.

    python3 -m translate.wgsl.wgpu_test HN_CONFORM

Exit status: 0 it does, 1 it does not, 77 there is no wgpu here.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.testing import skipped_without
from base.thorough import THOROUGH
from base.tree import GLSL, ROOT, TOOLS
from translate.settings import ARITHMETICS, Settings
from translate.tools import BY_NAME
from translate.wgsl.device import Device, find_wgpu
from translate.wgsl.module import Module

# Files that users include: those that have the others in them.
WHOLES = [path.name for path in sorted(GLSL.glob("*.glsl")) if "Made by tools/make" in path.read_text()]


class Wgpu(unittest.TestCase):
    device: Device
    program: str

    def test_modules_compile(self):
        for file in WHOLES:
            for arithmetic in ARITHMETICS:
                with self.subTest(file=file, arithmetic=arithmetic):
                    self.device.compile(Module(GLSL, f'#include "{file}"\n', Settings(arithmetic)).text())
        sine = Module(GLSL, '#include "hashnoise.glsl"\n', Settings("HN_FIXED", "FNV1", "SINE"))
        self.device.compile(sine.text(strip=True))

    def test_the_compilation_can_fail(self):
        with self.assertRaises(Exception):
            self.device.compile("fn f() -> f32 { return 1u; }")

    def test_the_code_of_pages_compiles(self):
        for page, count in (("guide/languages.md", 1), ("guide/hex-tiling.md", 1), ("../llms.txt", 1)):
            text = (ROOT / "docs" / page).read_text()
            command = re.search(r"^    tools/pick (.*--language wgsl.*) --out noise.wgsl$", text, re.MULTILINE)[1]
            done = subprocess.run([TOOLS / "pick", *command.split()], capture_output=True, text=True, check=True)
            shaders = re.findall(r"^```wgsl\n(@.*?)^```$", text, re.MULTILINE | re.DOTALL)
            self.assertEqual(len(shaders), count)
            for shader in shaders:
                with self.subTest(page=page):
                    self.device.compile(done.stdout + shader)

    def test_naga_reads_the_glsl(self):
        for arithmetic in ARITHMETICS:
            for call in ("hn_fbm", "absent"):
                done = subprocess.run([TOOLS / "pick", "whole"], capture_output=True, text=True, check=True)
                shader = (f"#version 450\n#define HN_ARITHMETIC {arithmetic}\n{done.stdout}\n"
                          "layout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\n"
                          f"void main() {{ color = vec4({call}(uv, 6, 2.0, 0.5, 7u)); }}\n")
                with self.subTest(arithmetic=arithmetic, call=call):
                    if call == "absent":
                        with self.assertRaisesRegex(Exception, "Unknown function 'absent'"):
                            self.device.compile_glsl(shader)
                    else:
                        self.device.compile_glsl(shader)

    def test_the_suite_is_right(self):
        """By default the cases of a run; thoroughly, and on Dawn as well, all functions with floats and HN_FIXED."""
        which = ("--thorough", "--filter", "*.lattice.*.wgsl.*", "--filter", "bugs.*.wgsl.*") if THOROUGH else (
            "--filter", "*.wgsl.*")
        folders = {"HN_WGPU": str(Path(find_wgpu().__file__).parents[1])}
        if THOROUGH:
            folders["HN_DAWN"] = str(BY_NAME["dawn-0.6.2"].path())
        with tempfile.TemporaryDirectory() as out:
            drivers = [f"--driver={name.removeprefix('HN_').lower()}" for name in folders]
            done = subprocess.run([self.program, "run", *drivers, *which, "--out", out], capture_output=True, text=True,
                                  env={**os.environ, **folders}, check=False)
            self.assertEqual(done.returncode, 0, f"{done.stdout}{done.stderr}")
            runs = json.loads((Path(out) / "results.json").read_text())["runs"]
        self.assertEqual(len(runs), len(folders))
        for run in runs:
            self.assertGreater(run["totals"]["pass"], 600 if THOROUGH else 100)
            self.assertEqual(run["totals"]["unsupported"], 0)


if __name__ == "__main__":
    Wgpu.program = sys.argv.pop(1)
    with skipped_without():
        Wgpu.device = Device()
    print(f"on {Wgpu.device.info()}")
    unittest.main()
