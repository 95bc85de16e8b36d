"""The module of Slang that tools/pick whole makes: its compiler writes it in four languages, and wgpu has the bits of
the C++ header.

    python3 -m translate.single_file.slang_test FOLDER     FOLDER has what pick.languages_test has written

Exit status: 0 it has, 1 it has not, 77 there is no wgpu or no compiler here.
"""

from __future__ import annotations

import re
import sys
import tempfile
import unittest
from pathlib import Path

from base.testing import skipped_without
from base.tree import ROOT
from translate.pick import slang
from translate.pick.languages_test import POINTS, difference, functions, module, words
from translate.pick.runners import NotRun, ran
from translate.pick.shading_runners import Case, SlangRunner
from translate.single_file.files import text

FIXED = {"HN_ARITHMETIC": "HN_FIXED"}
PAGE = (ROOT / "docs" / "guide" / "languages.md").read_text(encoding="utf-8").partition("\n## Slang\n")[2].partition("\n## ")[0]


class Imported(SlangRunner):
    """Calls a module's functions, in place of a text of its own."""
    target = "wgsl"
    folder: Path

    def compiled(self, text: str) -> str | bytes:
        made = slang.compiled(text, self.target, self.folder, FIXED)
        return made if self.target == "spirv" else made.decode()


class Module(unittest.TestCase):
    points: Path
    runner: Imported

    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.runner.folder = Path(scratch.name)
        self.write(text(["hashnoise.glsl"], "slang", strip=True))

    def write(self, shown: str) -> None:
        (self.runner.folder / "hashnoise.slang").write_text(shown, encoding="ascii")

    def differences(self, names: list[str]) -> list[str]:
        of = module("fixed")
        known = functions(of, "fixed")
        passed = [words(self.points, "fixed", of)[name] for name in names]
        cases = [Case(of, known[name], "import hashnoise;\n", given, len(back))
                 for name, (given, back) in zip(names, passed)]
        found = self.runner.run(cases, POINTS)
        return [f"{name}: {said}" for name, (_, back), got in zip(names, passed, found)
                if (said := difference(known[name], back, got))]

    def test_the_bits_are_those_of_the_library(self) -> None:
        names = list(functions(module("fixed"), "fixed"))
        self.assertGreater(len(names), 5)
        self.assertEqual(self.differences(names), [])
        self.runner.target = "spirv"
        self.addCleanup(setattr, self.runner, "target", "wgsl")
        self.assertEqual(self.differences(names[:2]), [])

    def test_a_changed_constant_is_noticed(self) -> None:
        right = text(["hashnoise.glsl"], "slang", strip=True)
        self.write(right.replace("0x85EBCA77u", "0x85EBCA79u"))
        self.assertEqual(len(self.differences(["hn_perlin2"])), 1)

    def test_the_code_of_the_page_is_there_in_four_languages(self) -> None:
        shader, = re.findall(r"^```slang\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
        for target in slang.TARGETS:
            for macros in ({}, FIXED):
                with self.subTest(target=target, macros=macros):
                    made = slang.compiled(shader, target, self.runner.folder, macros)
                    if target in ("wgsl", "spirv"):
                        self.runner.device.compile(made if target == "spirv" else made.decode())
                    elif target == "hlsl":
                        (self.runner.folder / "shader.comp").write_bytes(made)
                        ran(self.runner.folder, "glslangValidator", "-D", "-V", "-e", "main", "--auto-map-bindings",
                            "-o", "spirv", "shader.comp")
                    else:
                        self.assertIn(b"[[kernel]]", made)

    def test_what_is_wrong_is_told(self) -> None:
        shader = "import hashnoise;\n[numthreads(1, 1, 1)] void main() {}\n"
        with self.assertRaisesRegex(NotRun, "take HN_FIXED"):
            slang.compiled(shader, "wgsl", self.runner.folder, {"HN_ARITHMETIC": "HN_PRECISE"})
        with self.assertRaisesRegex(NotRun, "hn_merlin"):
            slang.compiled(shader.replace("{}", "{ hn_merlin(1.5); }"), "wgsl", self.runner.folder)


if __name__ == "__main__":
    Module.points = Path(sys.argv.pop(1))
    with skipped_without():
        Module.runner = Imported()
    unittest.main()
