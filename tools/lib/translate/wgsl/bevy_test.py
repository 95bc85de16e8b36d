"""Modules of tools/pick whole --language wgsl and tools/pick as Bevy imports them: naga_oil composes them, and what
comes out has golden values.

    python3 -m translate.wgsl.bevy_test FOLDER    where cargo builds what composes

Exit status: 0 it has, 1 it has not, 77 there is no cargo or no wgpu here.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Collection
from pathlib import Path

from base.debian import Missing
from base.testing import skipped_without
from base.tree import ROOT, TOOLS
from base.versions import take_newest
from translate.wgsl.device import Device
from translate.wgsl.golden import differing, shaders_over

COMPOSER = Path(__file__).resolve().parent / "composer"
EXAMPLE = ROOT / "examples" / "bevy"
SAMPLE = ("noise1d.perlin", "noise2d.perlin", "noise2d.perlin_cell_period", "noise3d.value_cell",
          "noise4d.simplex", "fbm.clouds3", "fbm.fbm2")
# The parts of Bevy that the example needs.
BEVY = {"vertex_output": """#define_import_path bevy_sprite::mesh2d_vertex_output
struct VertexOutput { @builtin(position) position: vec4f, @location(0) world_position: vec4f,
                      @location(1) world_normal: vec3f, @location(2) uv: vec2f }
""", "view_bindings": """#define_import_path bevy_sprite::mesh2d_view_bindings
struct Globals { time: f32, delta_time: f32, frame_count: u32 }
@group(0) @binding(1) var<uniform> globals: Globals;
"""}


class Refused(Exception):
    """naga_oil's messages."""


def build(folder: Path) -> Path:
    if not shutil.which("cargo"):
        raise Missing("there is no cargo")
    take_newest("cargo")
    done = subprocess.run(["cargo", "build", "--locked", "--quiet", "--manifest-path", COMPOSER / "Cargo.toml",
                           "--target-dir", folder], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        # Our lines are wrong, or this machine lacks something: a network, or a newer Rust.
        if "could not compile `composer`" in done.stderr or "lock file" in done.stderr:
            raise RuntimeError(done.stderr)
        raise Missing(f"naga_oil cannot be built: {done.stderr.strip().splitlines()[0]}")
    return folder / "debug" / "composer"


def picked(*options: str) -> str:
    """The text that a user gets."""
    return subprocess.run([sys.executable, TOOLS / "pick", *options], capture_output=True, text=True, check=True).stdout


def library(*options: str) -> str:
    return picked("whole", "--language", "wgsl", *options)


def evaluation_of(rows: Collection[str]) -> dict[str, str]:
    """For each row, a shader that imports the functions that it calls."""
    return shaders_over(rows, lambda names: "".join(f"#import hashnoise::{name}\n" for name in names))


class Bevy(unittest.TestCase):
    composer: Path
    device: Device

    def composed(self, modules: dict[str, str], shaders: dict[str, str]) -> dict[str, str]:
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder)
            (here / "out").mkdir()
            for name, text in {**modules, **shaders}.items():
                (here / f"{name}.wgsl").write_text(text)
            done = subprocess.run([self.composer, here / "out", *(here / f"{name}.wgsl" for name in modules), "--",
                                   *(here / f"{name}.wgsl" for name in shaders)], capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise Refused(done.stderr)
            return {name: (here / "out" / f"{name}.wgsl").read_text() for name in shaders}

    def differing(self, text: str) -> set[str]:
        """The rows of the sample that have other bits than their files."""
        composed = self.composed({"hashnoise": text}, evaluation_of(SAMPLE))
        return {*differing(self.device, composed, dict.fromkeys(SAMPLE, "lattice+fixed"))}

    def test_golden_values_bit_for_bit(self):
        whole = library("--import-path", "hashnoise", "--arithmetic", "HN_FIXED")
        self.assertTrue(whole.startswith("#define_import_path hashnoise\n"))
        self.assertEqual(self.differing(whole), set())

    def test_picked_functions_have_them_too(self):
        """The functions that the rows call, in one module."""
        imported = re.findall(r"#import hashnoise::(hn_\w+)", "".join(evaluation_of(SAMPLE).values()))
        names = [name for name in dict.fromkeys(imported) if not re.fullmatch(r"hn_place\d", name)]
        text = picked(*names, "--language", "wgsl", "--arithmetic", "fixed", "--import-path", "hashnoise")
        self.assertEqual(self.differing(text), set())

    def test_a_changed_constant_is_noticed(self):
        whole = library("--import-path", "hashnoise", "--arithmetic", "HN_FIXED", "--strip")
        self.assertIn("0x85EBCA77u", whole)
        self.assertEqual(self.differing(whole.replace("0x85EBCA77u", "0x85EBCA79u")),
                         set(SAMPLE) - {"noise1d.perlin"})  # it belongs to the second axis

    def test_what_is_not_there_is_refused(self):
        module = {"hashnoise": picked("hn_fbm2", "--language", "wgsl", "--import-path", "hashnoise")}
        user = "#import hashnoise::{}\n@fragment fn main() -> @location(0) vec4f {{ return vec4f({}(vec2f(1.5), 6, 2.0, 0.5, 7u)); }}\n"
        self.assertIn("fn main", self.composed(module, {"user": user.format("hn_fbm2", "hn_fbm2")})["user"])
        with self.assertRaisesRegex(Refused, "hn_clouds2"):
            self.composed(module, {"user": user.format("hn_clouds2", "hn_clouds2")})
        with self.assertRaisesRegex(Refused, "hashnoise"):
            self.composed({"hashnoise": picked("hn_fbm2", "--language", "wgsl")}, {"user": user.format("hn_fbm2", "hn_fbm2")})

    def test_the_code_of_the_page(self):
        engines = (ROOT / "docs" / "guide" / "engines.md").read_text(encoding="utf-8")
        page = re.search(r"^## Bevy and wgpu\n(.*?)^## ", engines, re.MULTILINE | re.DOTALL)[1]
        command = re.search(r"^    hashnoise/tools/pick (.*) --out assets/shaders/hashnoise.wgsl$", page, re.MULTILINE)[1]
        shader, = re.findall(r"^```wgsl\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        modules = {"hashnoise": picked(*command.split()), **BEVY}
        self.assertIn("fn fragment", self.composed(modules, {"page": shader})["page"])
        with self.assertRaisesRegex(Refused, "hn_cloudz3"):
            self.composed(modules, {"page": shader.replace("hn_clouds3", "hn_cloudz3")})

    def test_the_example(self):
        command = re.search(r"tools/pick (.*) --out assets/shaders/hashnoise.wgsl", (EXAMPLE / "src/main.rs").read_text())[1]
        modules = {"hashnoise": picked(*command.split()), **BEVY}
        own = (EXAMPLE / "assets/shaders/clouds.wgsl").read_text()
        self.assertIn("fn fragment", self.composed(modules, {"clouds": own})["clouds"])


if __name__ == "__main__":
    with skipped_without():
        Bevy.composer = build(Path(sys.argv.pop(1)))
        Bevy.device = Device()
    unittest.main()
