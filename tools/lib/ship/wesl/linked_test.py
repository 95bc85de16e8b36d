"""Shaders that import the package for WESL, linked by npm's wesl or by cargo's: they have the golden values, and no
code that they do not call.

    python3 -m ship.wesl.linked_test npm FOLDER      FOLDER has the packages of tools/lib/base/javascript
    python3 -m ship.wesl.linked_test cargo FOLDER    where cargo builds what links

Exit status: 0 it has, 1 it has not, 77 there is no npm, no cargo or no wgpu here.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Mapping
from pathlib import Path

from base.debian import Missing
from base.golden_values import ids
from base.testing import skipped_without
from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT, TOOLS
from base.versions import take_newest
from ship.packing import put
from ship.packing_support import refusals
from ship.wesl.files import PACKAGE, imported, package
from translate.wgsl.device import Device
from translate.wgsl.golden import differing, shaders_over

SAMPLE = ("noise2d.perlin_cell_period", "fbm.clouds3", "hash.unorm")
TESTS = PACKAGE / "tests"


class Refused(Exception):
    """The linker's messages."""


class Linker:
    """A linker of npm or of cargo, with the package in a folder of its own."""

    def __init__(self, kind: str, folder: Path):
        self.kind, self.folder = kind, folder.resolve()
        self.made = self.folder / ("wesl/package" if kind == "npm" else "package")
        if kind == "npm" and not (self.folder / "made").exists():
            raise Missing(f"{folder} has no packages: javascript.packages was skipped, or did not run")
        if kind == "cargo" and not shutil.which("cargo"):
            raise Missing("there is no cargo")
        take_newest("cargo")
        self.use(package())
        if kind == "npm":
            shutil.copy(TESTS / "link.mjs", self.folder / "wesl")

    def use(self, files: Mapping[str, str]) -> None:
        put(self.made, dict(files))
        if self.kind == "cargo":
            project = self.folder / "linker"
            shutil.copytree(TESTS / "linker", project, dirs_exist_ok=True)
            # wesl names a Rust that is newer than it needs.
            done = self.cargo("build", "--quiet", "--ignore-rust-version", "--target-dir", str(self.folder / "target"))
            if done.returncode != 0:
                if re.search("could not compile `(linker|hashnoise_wgsl)`", done.stderr):
                    raise RuntimeError(done.stderr)
                raise Missing(f"wesl cannot be built: {done.stderr.strip().splitlines()[0]}")

    def cargo(self, command: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(["cargo", command, "--manifest-path", self.folder / "linker" / "Cargo.toml", *arguments],
                              capture_output=True, text=True, check=False)

    def linked(self, shaders: Mapping[str, str]) -> dict[str, str]:
        with tempfile.TemporaryDirectory() as scratch:
            names = {name: f"shader_{i}" for i, name in enumerate(shaders)}
            for name, text in shaders.items():
                (Path(scratch) / f"{names[name]}.wesl").write_text(text, encoding="ascii")
            command = [self.folder / "target/debug/linker", scratch]
            if self.kind == "npm":
                command = [TOOLS / "lib" / "base" / "node", "node", self.folder / "wesl/link.mjs", self.made / "weslBundle.js", scratch]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise Refused(done.stderr)
            return {name: (Path(scratch) / f"{file}.wgsl").read_text() for name, file in names.items()}


def evaluation_of(rows: Mapping[str, str]) -> dict[str, str]:
    """For each row, a shader that imports the functions that it calls. Its variables may have names of the module."""
    return shaders_over(rows, lambda names: imported(names, "HN_FIXED"))


class Linked(unittest.TestCase):
    linker: Linker
    device: Device

    def differing(self, rows: Mapping[str, str]) -> set[str]:
        return {*differing(self.device, self.linker.linked(evaluation_of(rows)), rows)}

    def test_golden_values_bit_for_bit(self) -> None:
        known = dict(ids("lattice+fixed", "any"))
        # cargo's reads the package anew for each shader, for a second.
        more = list(known)[::1 if self.linker.kind == "npm" else 10] if THOROUGH else []
        rows = {row: setting for row, setting in known.items() if row in (*SAMPLE, *more)}
        self.assertGreaterEqual(len(rows), len(SAMPLE))
        self.assertEqual(self.differing(rows), set())

    def test_a_changed_constant_is_noticed(self) -> None:
        changed = {name: text.replace("0x85EBCA77u", "0x85EBCA79u") for name, text in package().items()}
        self.assertNotEqual(changed, package())
        self.addCleanup(self.linker.use, package())
        self.linker.use(changed)
        rows = {"noise2d.perlin_cell_period": "lattice+fixed"}
        self.assertEqual(self.differing(rows), {*rows})

    def test_what_is_not_called_is_left_out(self) -> None:
        page = (PACKAGE / "README.md").read_text(encoding="utf-8")
        shader = "".join(line.removeprefix("    ") for line in re.findall(r"^    .*\n|^\n(?=    )", page, re.MULTILINE))
        made = self.linker.linked({"page": shader})["page"]
        self.device.compile(made)
        self.assertLess(len(made), 30000)
        self.assertNotIn("cellular", made)

    @in_thorough_runs
    def test_every_function_can_be_imported(self) -> None:
        public = re.findall(r"^public fn (\w+)", package()["shaders/package.wesl"], re.MULTILINE)
        self.assertGreater(len(public), 350)
        calls = "".join(f"import hashnoise_wgsl::{name};\n" for name in public)
        # The linker drops unused imports, so a function that is not there shows by its name alone.
        self.linker.linked({"all": f"{calls}@fragment fn main() -> @location(0) vec4f {{ return vec4f(1.0); }}\n"})

    def test_what_is_not_there_is_refused(self) -> None:
        call = ("import hashnoise_wgsl::merlin2;\n"
                "@fragment fn main() -> @location(0) vec4f { return vec4f(merlin2(vec2f(1.5), 7u)); }\n")
        with self.assertRaisesRegex(Refused, "merlin2"):
            self.linker.linked({"wrong": call})

    def test_a_registry_takes_it(self) -> None:
        """By its own checks: npm's, and cargo's, which warn of what crates.io refuses."""
        if self.linker.kind == "npm":
            base = TOOLS / "lib" / "base"
            done = subprocess.run([base / "node", "node", base / "javascript" / "registry.mjs",
                                   ROOT / "docs" / "develop" / "publishing.md", self.linker.made],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        else:
            self.assertEqual(refusals(self.linker.made, "publish", "--dry-run"), [])

    def of_page(self, language: str) -> str:
        page = (ROOT / "docs" / "guide" / "engines.md").read_text(encoding="utf-8")
        page = page.partition("\n## WESL\n")[2].partition("\n## ")[0]
        shown, = re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        return shown

    def test_the_code_of_the_page(self) -> None:
        self.device.compile(self.linker.linked({"page": self.of_page("wgsl")})["page"])

    def test_the_page_and_the_manifest_in_rust(self) -> None:
        if self.linker.kind != "cargo":
            self.skipTest("the test wesl.cargo runs it")
        shown = self.of_page("rust")
        program = self.linker.folder / "linker" / "src" / "bin" / "page.rs"
        program.parent.mkdir(exist_ok=True)
        self.addCleanup(program.unlink)
        for text, status in ((shown, 0), (shown.replace("use wesl", "// use wesl"), 101)):
            program.write_text(f"fn main() -> Result<(), Box<dyn std::error::Error>> {{\n{text}println!(\"{{linked}}\");\n"
                               "Ok(())\n}\n", encoding="ascii")
            done = self.linker.cargo("check", "--quiet", "--offline", "--ignore-rust-version", "--bin", "page",
                                     "--target-dir", str(self.linker.folder / "target"))
            self.assertEqual(done.returncode, status, done.stderr)
        host = re.search("(?m)^host: (.*)", subprocess.run(["rustc", "-vV"], capture_output=True, text=True, check=True).stdout)
        done = self.linker.cargo("metadata", "--offline", "--format-version", "1", "--filter-platform", host[1])
        known = json.loads(done.stdout)["packages"]
        asked = {one["name"]: one["rust_version"] for one in known}
        self.assertEqual(asked["hashnoise_wgsl"], asked["wesl-core"])
        self.assertIn(f"Rust {asked['wesl']}, ", (PACKAGE / "README.md").read_text(encoding="utf-8"))
        self.assertEqual(asked["wesl"], asked["wesl-core"])


if __name__ == "__main__":
    with skipped_without():
        Linked.device = Device()
        Linked.linker = Linker(sys.argv[1], Path(sys.argv[2]))
    del sys.argv[1:3]
    unittest.main(verbosity=2)
