"""The generated WGSL compiles, and has the values of the golden files, outside of a browser.

    python3 -m translate.wgsl.wgpu_test HN_CONFORM

The tolerances of floats, and their shaders, come from the page that hn-conform writes for browsers. Exit status: 0
it does, 1 it does not, 77 there is no wgpu here.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Iterable
from pathlib import Path

from base.golden_values import ids
from base.testing import skipped_without
from base.thorough import THOROUGH
from base.tree import GLSL, ROOT, TOOLS
from catalog.tables.functions import read_functions
from translate.settings import ARITHMETICS, Settings
from translate.wgsl.device import Absent, Device
from translate.wgsl.evaluation import evaluations
from translate.wgsl.golden import Page, differing
from translate.wgsl.module import Module

# Files that users include: those that have the others in them.
WHOLES = [path.name for path in sorted(GLSL.glob("*.glsl")) if "Made by tools/make" in path.read_text()]


def shaders(library: Path, rows: Iterable[str]) -> dict[str, str]:
    """The functions of these rows, with HN_FIXED."""
    chosen = {function.id: function.body for function in read_functions() if function.id in rows}
    made = evaluations(library, "#define HN_ARITHMETIC HN_FIXED\n", ["hashnoise.glsl"], chosen)
    return {row: "".join(pieces) for row, pieces in made.items()}


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

    def test_golden_values_of_fixed(self):
        golden = dict(ids("lattice+fixed", "any"))
        self.assertGreater(len(golden), 300)
        # By default a third of the functions: a driver takes long to compile them, and the text of all compiles above.
        some = golden if THOROUGH else dict(list(golden.items())[::3])
        self.assertEqual(differing(self.device, shaders(GLSL, some), some), {})

    def test_golden_values_of_floats(self):
        page = Page(self.program, "*.lattice.fast.compute.wgsl.golden")
        self.assertGreater(len(page.cases), 285)
        # By default some of each file, and others than above.
        cases = page.cases if THOROUGH else page.cases[1::4]
        wrong = {case["id"]: text for case in cases if (text := page.wrong(self.device, case))}
        self.assertEqual(wrong, {})

    def test_a_float_that_is_off_is_noticed(self):
        page = Page(self.program, "noise2d.perlin.lattice.fast.compute.wgsl.golden")
        case, = page.cases
        self.assertEqual(page.wrong(self.device, case), "")
        self.assertNotEqual(page.wrong(self.device, {**case, "allowed": 1e-9}), "")

    def test_a_changed_constant_is_noticed(self):
        rows = ("noise2d.perlin", "noise3d.value_cell", "fbm.clouds2")
        golden = dict.fromkeys(rows, "lattice+fixed")
        for file, old, new in (("detail/word.glsl", "0x85EBCA77u", "0x85EBCA79u"), ("detail/arithmetic.glsl", "1572864u", "1572868u")):
            with self.subTest(file=file), tempfile.TemporaryDirectory() as folder:
                copy = Path(folder) / "glsl"
                shutil.copytree(GLSL, copy)
                text = (copy / file).read_text()
                self.assertIn(old, text)
                (copy / file).write_text(text.replace(old, new))
                self.assertEqual(set(differing(self.device, shaders(copy, golden), golden)), set(rows))


if __name__ == "__main__":
    Wgpu.program = sys.argv.pop(1)
    with skipped_without(Absent):
        Wgpu.device = Device()
    print(f"on {Wgpu.device}")
    unittest.main()
