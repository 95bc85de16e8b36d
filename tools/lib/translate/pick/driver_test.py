"""tools/pick's text has the golden values, and the bits of the twin, on a driver, and the same bits in GLSL ES
under the lowest precision.

    python3 -m translate.pick.driver_test HN_CONFORM

In a copy of the library the functions of a file are replaced by what tools/pick writes of them, in all of their forms,
and the suite is run with that copy: by default for some files.

Mesa's driver computes mediump of GLSL ES with 16 bits, as phones do. So functions are drawn by it in GLSL ES, under
mediump and lowp, and in GLSL: all of them, pairs of a family, and all in one text; by default some of each.
"""

from __future__ import annotations

import functools
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from base.renderer import Renderer
from base.thorough import THOROUGH
from base.tree import GLSL
from catalog.tables.functions import read_functions
from translate.names import is_public
from translate.parsing.syntax import Function
from translate.pick.command import settings
from translate.pick.comparison import RANGES
from translate.pick.evaluate import Module
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES
from translate.pick.shading_runners import GlslRunner, pairs_of

# The structs are the library's.
WITHOUT_STRUCTS = replace(LANGUAGES["glsl"], structs=False)
SOME = ("perlin2d.glsl", "cellular2d.glsl", "value_d3d.glsl")
LOWEST = "#version 300 es\nprecision mediump float;\nprecision mediump int;\nprecision lowp sampler2D;\n"
# The words of a pixel are drawn by PCG's hash, and those that come back are mixed to one, the color.
MAIN = """
out highp vec4 color;
highp uint drawn(highp uint word) {{
  highp uint k = word * 747796405u + 2891336453u;
  k = ((k >> ((k >> 28u) + 4u)) ^ k) * 277803737u;
  return (k >> 22u) ^ k;
}}
highp float between(highp uint word, highp float low, highp float high) {{
  highp float part = uintBitsToFloat((word >> 9u) | 0x3F800000u) - 1.0;
  return low + part * (high - low);
}}
void main() {{
  highp uvec2 pixel = uvec2(gl_FragCoord.xy);
  highp uint word = pixel.x * {side}u + pixel.y, mixed = 0u;
  highp uint inputs[{most}], outputs[{most}];
  highp uint at = 0u, to = 0u;
{calls}
  highp uvec4 bytes = uvec4(mixed, mixed >> 8u, mixed >> 16u, mixed >> 24u) & 255u;
  color = vec4(bytes);
}}
"""
SIDE = 16
# Whole numbers that are settings; others are any.
WHOLE = {"octaves": "word % 9u", "metric": "word % 6u", "period": "word % 9u"}


def call_of(module: Module, function: Function) -> str:
    """Lines that draw the function's arguments, and mix its results. The module is split."""
    lines, taken, given = GlslRunner.form.call(module, function)
    drawn = [(path[-1] if path and path[-1].isalpha() and len(path[-1]) > 1 else parameter.at.text, type_)
             for parameter in function.parameters if module.passed(parameter)
             for path, type_ in module.parts(parameter.type)]
    assert len(drawn) == taken
    before = []
    for i, (name, type_) in enumerate(drawn):
        low, high = RANGES.get(name, (0, 1) if name.startswith("fraction") else (-60, 60))
        value = f"floatBitsToUint(between(word, float({low}), float({high})))" if type_ == "float" else WHOLE.get(
            name, "word")
        before.append(f"word = drawn(word); inputs[{i}] = {value};")
    after = [f"mixed = drawn(mixed ^ outputs[{i}]);" for i in range(given)]
    return "".join(f"    {line}\n" for line in ("{", *before, *lines, *after, "}"))


def files() -> list[str]:
    """Functions of noise and of sums that no other of these is made of."""
    rows = {function.includes for function in read_functions() if function.file.startswith(("noise", "curl", "fbm"))}
    return sorted(file for file in rows if re.fullmatch(r"(?!octaves|fbm_d)\w+\dd\.glsl", file))


def picked(module: Module, file: str, arithmetic: str) -> str:
    """The file with picked functions in place of its own. Helpers have other names, since the library is there, too."""
    functions = [one for one in module.functions.values() if is_public(one.name) and one.at.path == file]
    text = re.sub(r"\bhn_i_(?=\w+\()", "hn_picked_", Program(module, functions).text(WITHOUT_STRUCTS))
    library = (GLSL / file).read_text(encoding="ascii")
    guard = re.search(r"#ifndef (\w+)", library)[1]
    structs = "".join(re.findall(r"^struct hn_\w+ \{.*?^\};\n", library, re.MULTILINE | re.DOTALL))
    return (f"#ifndef {guard}\n#define {guard}\n#include \"position.glsl\"\n{structs}"
            f"#if HN_ARITHMETIC == HN_{arithmetic.upper()}\n{text}#endif\n#endif\n")


class Driver(unittest.TestCase):
    program: str

    def run_suite(self, arithmetic: str, names: list[str], change: tuple[str, str] = ("", ""),
                  options: Sequence[str] = ("--driver=osmesa",)) -> tuple[int, str]:
        module = read(GLSL, settings(arithmetic, "lattice"))
        rows = [function.id for function in read_functions() if function.includes in names]
        with tempfile.TemporaryDirectory() as folder:
            library = Path(folder) / "glsl"
            shutil.copytree(GLSL, library)
            for name in names:
                text = picked(module, name, arithmetic)
                self.assertIn(change[0], text)
                (library / name).write_text(text.replace(*change), encoding="ascii")
            filters = [f"--filter={row}.lattice.{arithmetic}.*.{check}" for row in rows for check in ("golden", "twin")]
            command = [self.program, "run", *options, f"--glsl={library}", f"--out={folder}/out", *filters]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_the_suite_passes(self) -> None:
        for arithmetic in ("fixed", "fast"):
            with self.subTest(arithmetic):
                status, shown = self.run_suite(arithmetic, files() if THOROUGH else list(SOME))
                self.assertEqual(status, 0, shown)
                self.assertRegex(shown, r"(?m)^[1-9]\d+ pass; [1-9]\d{4,} values compared")

    def test_a_changed_constant_is_noticed(self) -> None:
        status, shown = self.run_suite("fixed", ["perlin2d.glsl"], ("0x85EBCA77u", "0x85EBCA79u"))
        self.assertEqual(status, 1, shown)
        self.assertIn("NOT AS EXPECTED", shown)

    def test_a_driver_whose_constructors_have_the_precision_of_the_scope_does_no_harm(self) -> None:
        """NVIDIA's makes an infinite float of 100000 where that is mediump."""
        options = ("--driver=egl-gles", "--inject=mediump_conversions")
        scope = LANGUAGES["glsl"].scope
        for change, expected in (((scope, scope), 0), ((scope, ""), 1)):
            with self.subTest(expected=expected):
                status, shown = self.run_suite("fixed", ["cellular2d.glsl"], change, options)
                self.assertEqual(status, expected, shown)
                self.assertRegex(shown, r"(?m)^[1-9]\d* pass")


class LowestPrecision(unittest.TestCase):
    """In GLSL ES, beside GLSL."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.renderer = Renderer(SIDE)

    @staticmethod
    @functools.cache
    def modules(arithmetic: str) -> tuple[Module, Module]:
        """The library, and split."""
        return read(GLSL, settings(arithmetic, "lattice")), read(GLSL, settings(arithmetic, "lattice"), splits=True)

    def text(self, arithmetic: str, names: Sequence[str]) -> str:
        of = self.modules(arithmetic)[0]
        return Program(of, chosen(of, names)).text(LANGUAGES["glsl"])

    def drawn(self, arithmetic: str, text: str, called: Sequence[str]) -> bytes:
        split = self.modules(arithmetic)[1]
        calls = "".join(call_of(split, split.forms[name]) for name in called)
        shader = text + MAIN.format(side=SIDE, most=100, calls=calls)
        return self.renderer.draw(self.renderer.program(shader)).tobytes()

    def differs(self, arithmetic: str, names: Sequence[str], called: Sequence[str] = (), text: str = "",
                has_highp: bool = True) -> bool:
        text = text or self.text(arithmetic, names)
        if not has_highp:
            text = text.replace("precision highp float;", "").replace("highp ", "")
        low, high = (self.drawn(arithmetic, head + text, called or names) for head in (LOWEST, "#version 330\n"))
        return low != high

    def test_functions_have_the_bits_of_desktop_glsl(self) -> None:
        for turn, arithmetic in enumerate(("fast", "fixed")):
            names = list(self.modules(arithmetic)[0].forms)
            for name in names if THOROUGH else names[turn * 40::80]:
                with self.subTest(name, arithmetic=arithmetic):
                    self.assertFalse(self.differs(arithmetic, [name]))

    def test_so_do_pairs_of_a_family(self) -> None:
        for turn, arithmetic in enumerate(("fast", "fixed")):
            pairs = pairs_of(self.modules(arithmetic)[0].forms)
            for pair in pairs[turn::2 if THOROUGH else 300]:
                with self.subTest(pair, arithmetic=arithmetic):
                    self.assertFalse(self.differs(arithmetic, pair))

    def test_so_do_all_functions_in_one_text(self) -> None:
        """To write that text takes minutes, so by default it has some of the functions."""
        for turn, arithmetic in enumerate(("fast", "fixed")):
            names = list(self.modules(arithmetic)[0].forms)[0 if THOROUGH else turn * 32::1 if THOROUGH else 64]
            text = self.text(arithmetic, names)
            for name in names if THOROUGH else names[1::3]:
                with self.subTest(name, arithmetic=arithmetic):
                    self.assertFalse(self.differs(arithmetic, names, [name], text))

    def test_without_highp_they_do_not(self) -> None:
        """So this driver has 16 bits."""
        for arithmetic in ("fast", "fixed"):
            for names in (["hn_fbm2"], ["hn_cell_border2"], ["hn_fbm2", "hn_cell_border2"], ["hn_lattice3"]):
                with self.subTest(names, arithmetic=arithmetic):
                    self.assertFalse(self.differs(arithmetic, names))
                    self.assertTrue(self.differs(arithmetic, names, has_highp=False))


if __name__ == "__main__":
    Driver.program = sys.argv.pop(1)
    unittest.main()
