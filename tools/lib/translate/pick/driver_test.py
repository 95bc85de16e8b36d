"""tools/pick's text has the golden values, and the bits of the twin, on a driver, in GLSL ES under mediump, too.

    python3 -m translate.pick.driver_test HN_CONFORM

In a copy of the library the functions of a file are replaced by what tools/pick writes of them, in all of their forms,
and the suite is run with that copy: by default for some files. Mesa's driver computes mediump of GLSL ES with 16 bits, as
phones do; the test pick.combinations looks at what is mediump in the SPIR-V of each text.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from base.thorough import THOROUGH
from base.tree import GLSL
from catalog.tables.functions import read_functions
from translate.names import is_public
from translate.pick.command import settings
from translate.pick.evaluate import Module
from translate.pick.program import Program, read
from translate.pick.shading import LANGUAGES

# The structs are the library's.
WITHOUT_STRUCTS = replace(LANGUAGES["glsl"], structs=False)
SOME = ("perlin2d.glsl", "cellular2d.glsl", "value_d3d.glsl")


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
                status, shown = self.run_suite(arithmetic, files() if THOROUGH else list(SOME),
                                               options=("--driver=osmesa", "--driver=egl-gles"))
                self.assertEqual(status, 0, shown)
                self.assertRegex(shown, r"(?m)^[1-9]\d+ pass; [1-9]\d{4,} values compared")

    def test_without_highp_it_does_not(self) -> None:
        """So the driver of GLSL ES has 16 bits."""
        status, shown = self.run_suite("fast", ["perlin2d.glsl"], ("highp ", ""), ("--driver=egl-gles",))
        self.assertEqual(status, 1, shown)
        self.assertIn("values are wrong", shown)

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


if __name__ == "__main__":
    Driver.program = sys.argv.pop(1)
    unittest.main()
