"""Modules of tools/pick whole --language wgsl and tools/pick as Bevy imports them: naga_oil composes them, and what
comes out has the golden values.

    python3 -m translate.wgsl.bevy_test FOLDER    where cargo builds what composes

Exit status: 0 it has, 1 it has not, 77 there is no cargo or no wgpu here.
"""

from __future__ import annotations

import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Collection
from pathlib import Path

from base.tree import ROOT, TOOLS
from base.versions import take_newest
from translate.wgsl.device import Absent, Device
from translate.wgsl.evaluation import EPILOGUE
from translate.wgsl.golden import differing, shaders_over

SKIPPED = 77
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
        raise Absent("there is no cargo")
    take_newest("cargo")
    done = subprocess.run(["cargo", "build", "--locked", "--quiet", "--manifest-path", COMPOSER / "Cargo.toml",
                           "--target-dir", folder], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        # Our lines are wrong, or this machine lacks something: a network, or a newer Rust.
        if "could not compile `composer`" in done.stderr or "lock file" in done.stderr:
            raise RuntimeError(done.stderr)
        raise Absent(f"naga_oil cannot be built: {done.stderr.strip().splitlines()[0]}")
    return folder / "debug" / "composer"


def picked(*options: str) -> str:
    """The text that a user gets."""
    return subprocess.run([sys.executable, TOOLS / "pick", *options], capture_output=True, text=True, check=True).stdout


def library(*options: str) -> str:
    return picked("whole", "--language", "wgsl", *options)


def evaluation_of(rows: Collection[str]) -> dict[str, str]:
    """For each row, a shader that imports the functions that it calls."""
    return shaders_over(rows, "HN_FIXED",
                        lambda names: "".join(f"#import hashnoise::{name}\n" for name in names))


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

    def test_the_example_draws_the_clouds_of_the_library(self):
        """Its sky is mixed by hn_clouds3, whose value comes out where sky and cloud differ."""
        command = re.search(r"tools/pick (.*) --out assets/shaders/hashnoise.wgsl", (EXAMPLE / "src/main.rs").read_text())[1]
        own = (EXAMPLE / "assets/shaders/clouds.wgsl").read_text()
        modules = {"hashnoise": picked(*command.split()), **BEVY}
        self.assertIn("fn fragment", self.composed(modules, {"clouds": own})["clouds"])
        lines = [line for line in own.split("@fragment")[0].splitlines() if "bevy_sprite" not in line]
        evaluate = """fn evaluate(a: vec4u, b: vec4u, c: vec4u, d: vec4u) -> vec4u {
  return vec4u(bitcast<vec3u>(sky(bitcast<vec2f>(a.xy), bitcast<f32>(a.z))), 0u);
}
"""
        direct = """fn evaluate(a: vec4u, b: vec4u, c: vec4u, d: vec4u) -> vec4u {
  let uv = bitcast<vec2f>(a.xy);
  let seconds = bitcast<f32>(a.z);
  return vec4u(bitcast<u32>(hn_clouds3(vec3f(uv.x * 8.0 + 0.1 * seconds, uv.y * 4.5, 0.05 * seconds), 6, 2.0, 0.5, 7u)), 0u, 0u, 0u);
}
"""
        epilogue = EPILOGUE.replace("EVALUATE", "evaluate")
        composed = self.composed(modules, {"sky": "\n".join(lines) + "\n" + evaluate + epilogue,
                                           "noise": "#import hashnoise::hn_clouds3\n" + direct + epilogue})
        points = [(x / 16, y / 16, 3.5) for x in range(16) for y in range(16)]
        words = [[struct.unpack("<I", struct.pack("<f", part))[0] for part in point] for point in points]
        skies, noises = (self.device.evaluate(composed[name], words) for name in ("sky", "noise"))
        values = set()
        for (_, y, _), sky, noise in zip(points, skies, noises, strict=True):
            red = struct.unpack("<f", struct.pack("<I", sky[0]))[0]
            thick = struct.unpack("<f", struct.pack("<I", noise[0]))[0]
            clear = 0.72 + (0.2 - 0.72) * (1 - y)
            self.assertAlmostEqual(red, clear + (1 - clear) * thick, delta=1e-4)
            values.add(round(thick, 2))
        self.assertGreater(len(values), 20)


if __name__ == "__main__":
    try:
        Bevy.composer = build(Path(sys.argv.pop(1)))
        Bevy.device = Device()
    except Absent as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    unittest.main()
