"""tools/pack isf: the looks, and that they draw.

    python3 -m unittest ship.isf.isf_test   descriptions of all, and the text of one
    python3 -m ship.isf.isf_test FOLDER     all: npm's parser reads them, and Mesa draws them. FOLDER is for the parser

Exit status: as of the tests; 77 the parser, Mesa or glslang is not here.
"""

from __future__ import annotations

import contextlib
import io
import json
import re
import shutil
import statistics
import subprocess
import sys
import unittest
from pathlib import Path

from base import glslang
from base.javascript.environment import OFFLINE
from base.renderer import NoRenderer, Renderer
from base.testing import SKIPPED, skipped_without
from base.tree import ROOT, TOOLS, version
from ship import command
from ship.isf import files
from translate.pick.command import Choice
from translate.tools import own

PARSER = "interactive-shader-format@2.9.0"
SIDE = 64
TYPES = {"float": "float", "long": "int", "color": "vec4"}
# Reads the given files, and writes the kind of each as JSON.
READ = """const { Parser } = require("./package/lib/main.js");
const files = process.argv.slice(2).map((name) => {
  const parser = new Parser();
  parser.parse(require("fs").readFileSync(name, "utf8"));
  const inputs = (parser.inputs ?? []).map(({ NAME, TYPE }) => [NAME, TYPE]);
  return { valid: parser.valid, type: parser.type, inputs, said: parser.description };
});
console.log(JSON.stringify(files));
"""


def described(text: str) -> dict:
    return json.loads(re.match(r"/\*(.*?)\*/", text, re.DOTALL)[1])


def compiled(text: str, first: str = "#version 330") -> str:
    """A file as a program for ISF has it compiled: behind its own lines, which declare the format's inputs."""
    uniforms = "".join(f"uniform {TYPES[one['TYPE']]} {one['NAME']};\n" for one in described(text)["INPUTS"])
    return (f"{first}\nprecision highp float;\nprecision highp int;\n#define gl_FragColor isf_FragColor\n"
            "out vec4 gl_FragColor;\nuniform vec2 RENDERSIZE;\nuniform float TIME;\nin vec2 isf_FragNormCoord;\n"
            f"{uniforms}{text}")


def drawn(text: str, values: dict[str, str]) -> str:
    """Drawn with numbers in place of uniforms, for a renderer that sets none."""
    text = compiled(text, "#version 450").replace("in vec2 isf_FragNormCoord;",
                                                  f"vec2 isf_FragNormCoord = gl_FragCoord.xy / {SIDE}.0;")
    return re.sub(r"(?m)^uniform (\w+) (\w+);$", lambda found: f"const {found[1]} {found[2]} = {values[found[2]]};",
                  text)


def values_of(text: str, **others: str) -> dict[str, str]:
    """The values that a program starts with."""
    found = {"RENDERSIZE": f"vec2({SIDE}.0)", "TIME": "3.25"}
    for one in described(text)["INPUTS"]:
        value = one["DEFAULT"]
        found[one["NAME"]] = f"vec4({', '.join(map(str, value))})" if one["TYPE"] == "color" else str(value)
    return found | others


class Text(unittest.TestCase):
    def test_the_size_is_called_as_the_page_explains_it(self) -> None:
        page = (files.PACKAGE / "README.md").read_text(encoding="utf-8")
        self.assertIn(f"`size` ({files.INPUTS['size']['LABEL'].lower()} of the picture)", page)

    def test_inputs_are_used_and_begin_within_their_ranges(self) -> None:
        for name, look in files.LOOKS.items():
            for one in files.inputs(look):
                value = files.INPUTS[one]
                if value["TYPE"] == "float":
                    self.assertTrue(value["MIN"] <= value["DEFAULT"] <= value["MAX"])
                if one in look.more or one == "contrast":
                    self.assertRegex(look.code, rf"\b{one}\b", name)

    @unittest.skipUnless(shutil.which("glslangValidator"), "Debian's package glslang-tools is missing")
    def test_a_file_is_json_and_glsl(self) -> None:
        text = files.shader("clouds")
        self.assertEqual(described(text)["DESCRIPTION"], f"Octaves of gradient noise, of hashnoise {version()}")
        for first in ("#version 330", "#version 300 es"):
            done = glslang.compiled(compiled(text, first))
            self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotEqual(glslang.compiled(compiled(text).replace("hn_fbm(p", "hn_fbm(at")).returncode, 0)

    @unittest.skipUnless(shutil.which("glslangValidator"), "Debian's package glslang-tools is missing")
    def test_what_the_page_has_for_other_programs_compiles(self) -> None:
        page = (ROOT / "docs" / "guide" / "engines.md").read_text().partition("## Shadertoy")[2]
        named, = re.findall(r"^    hashnoise/tools/pick (\w+)$", page, re.MULTILINE)
        shadertoy, touch_designer = (code.replace("\n    ", "\n") for code in re.findall(
            r"^    ((?:void mainImage|out vec4).*?)\n\n", page, re.MULTILINE | re.DOTALL))
        text = files.pick()((named,), Choice())
        whole = {shadertoy: ("#version 300 es\nprecision highp float;\nuniform vec3 iResolution;\n"
                             "uniform float iTime;\nout vec4 color;\n",
                             "\nvoid main() { mainImage(color, gl_FragCoord.xy); }\n"),
                 touch_designer: ("#version 330\nin vec3 vUV;\nvec4 TDOutputSwizzle(vec4 c) { return c; }\n", "\n")}
        for code, (before, behind) in whole.items():
            done = glslang.compiled(f"{before}{text}{code}{behind}")
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertNotEqual(glslang.compiled(f"{before}{text}{code.replace('6, ', '')}{behind}").returncode, 0)


@unittest.skipUnless(__name__ == "__main__", "the test isf.looks makes all")
class Looks(unittest.TestCase):
    folder: Path  # that of the parser

    @classmethod
    def setUpClass(cls) -> None:
        cls.renderer = Renderer(SIDE)
        with contextlib.redirect_stdout(io.StringIO()) as out:
            command.main(["isf", str(cls.folder / "made")])
        cls.made = sorted(Path(out.getvalue().strip()).glob("*.fs"))

    def read(self, *paths: Path) -> list[dict]:
        (self.folder / "read.js").write_text(READ, encoding="ascii")
        done = subprocess.run([TOOLS / "lib" / "base" / "node", "node", "read.js", *paths], cwd=self.folder, capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_a_parser_reads_them(self) -> None:
        self.assertEqual(len(self.made), len(files.LOOKS))
        for path, printed in zip(self.made, self.read(*self.made), strict=True):
            look = files.LOOKS[path.stem.removeprefix("hn-")]
            self.assertEqual(printed["inputs"], [[one, files.INPUTS[one]["TYPE"]] for one in files.inputs(look)])
            self.assertEqual((printed["valid"], printed["type"]), (True, "generator"))
        wrong = self.folder / "wrong.fs"
        wrong.write_text(self.made[0].read_text().replace('"INPUTS": [', '"INPUTS": '))
        self.assertFalse(self.read(wrong)[0]["valid"])

    def test_they_draw(self) -> None:
        for path in self.made:
            with self.subTest(path.name):
                text = path.read_text()
                self.assertEqual(glslang.compiled(compiled(text)).returncode, 0)
                first, again, seed, later = (
                    self.renderer.draw(self.renderer.program(drawn(text, values_of(text, **others))))[0::4]
                    for others in ({}, {}, {"seed": "8.0"}, {"TIME": "4.0"}))
                self.assertTrue(0.0 <= min(first) < 0.35 and 0.65 < max(first) <= 1.0, (min(first), max(first)))
                self.assertEqual(first, again)
                for other in (seed, later):
                    self.assertGreater(sum(abs(one - two) for one, two in zip(first, other)) / len(first), 0.03)

    def test_they_do_not_pulse(self) -> None:
        """At a whole depth and between two a picture of many cells has the same mean and deviation, within 4%. A warp
        moves along z, too, so ink does not pulse on a plane either."""
        def pulse(text: str) -> float:
            values = [self.renderer.draw(self.renderer.program(drawn(text, values_of(
                text, size="37.3", speed="1.0", contrast="0.4", TIME=time))))[0::4] for time in ("0.0", "0.5")]
            return max(abs(before / after - 1.0) for before, after in (
                map(statistics.mean, values), map(statistics.pstdev, values)))

        for path in self.made:
            with self.subTest(path.name):
                text = path.read_text()
                self.assertLess(pulse(text), 0.04)
                if path.name != "hn-ink.fs":
                    self.assertGreater(pulse(text.replace(files.DEPTH, "TIME * speed")), 0.08)


def fetched(folder: Path) -> int:
    """The parser, without packages that it requires and does not use: 0 if it is there."""
    if (folder / "package").exists():
        return 0
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([TOOLS / "lib" / "base" / "node", "npm", "pack", "--silent", "--fetch-retries", "1", PARSER], cwd=folder,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        return SKIPPED if OFFLINE.search(done.stdout + done.stderr) else 1
    shutil.unpack_archive(folder / done.stdout.strip(), folder, "gztar")
    return 0


if __name__ == "__main__":
    Looks.folder = Path(sys.argv.pop(1)).resolve()
    with skipped_without(NoRenderer):
        Renderer(SIDE)
        own("glslangValidator")
    if status := fetched(Looks.folder):
        sys.exit(status)
    unittest.main(defaultTest="Looks", verbosity=2)
