"""The example's land: its shape fits, and its ball stays on it; and the picture of the page.

    python3 packages/godot/tests/land_test.py
    python3 packages/godot/tests/land_test.py --picture docs/images/godot.jpg   draws it anew, in Forward+

Exit status: 0 they do, 1 they do not, 77 there is no Godot here.
"""

from __future__ import annotations

import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

from engine import Engine, display, find, main
from example_test import HERE, new_project

from base.testing import skipped_without
from base.twin import compile_program
from ship.godot.files import ADDON

SCENE = f"res://{ADDON}/example/terrain.tscn"
SIDE = 129  # heights along each axis, a metre apart
PLACES = [[-63.9 + 0.61 * i + 0.3, 37 * i % 127 - 63 + i % 7 / 9] for i in range(200)]
# By the shader's own text, in floats.
HEIGHTS = """\
#include <hashnoise/hashnoise.hpp>
#include <cstdio>
using namespace hashnoise;
float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
LAND
int main() {
  for (int i = 0; i < SIDE * SIDE; ++i) {
    const float height = land(vec2(i % SIDE - 64, i / SIDE - 64), 6).x;
    std::fwrite(&height, 4, 1, stdout);
  }
}
"""
# Godot's own physics has floats, and Jolt steps of the range of heights.
ENGINES = {"GodotPhysics3D": 1e-4, "Jolt Physics": 0.02}


def heights_of_the_shader(folder: Path, text: str) -> list[float]:
    land = re.sub(r"\b(\d+\.\d+)\b", r"\1f", text[text.index("vec3 land("):])
    (folder / "land.cpp").write_text(HEIGHTS.replace("LAND", land).replace("SIDE", str(SIDE)))
    compile_program("the land", folder / "land.cpp", folder / "land", "-O0", macros=["HN_ARITHMETIC=HN_FIXED"])
    printed = subprocess.run([folder / "land"], capture_output=True, check=True).stdout
    return [*struct.unpack(f"{SIDE * SIDE}f", printed)]


def on_the_mesh(heights: list[float], x: float, z: float) -> float:
    """The height of the drawn triangles, which end at the second diagonal of each square."""
    column, row = int(x + 64), int(z + 64)
    u, v = x + 64 - column, z + 64 - row
    a, b, c, d = (heights[(row + i) * SIDE + column + j] for i in (0, 1) for j in (0, 1))
    return a + u * (b - a) + v * (c - a) if u + v < 1 else d + (1 - u) * (c - d) + (1 - v) * (b - d)


class Land(unittest.TestCase):
    engine: Engine

    def measured(self, physics: str, edit: Callable[[str], str] = str) -> tuple[float, dict]:
        """How far the shape is from the mesh at most, and all that the script has found."""
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder)
            new_project(project)
            with (project / "project.godot").open("a") as settings:
                settings.write(f'[physics]\n3d/physics_engine="{physics}"\n')
            example = project / ADDON / "example"
            (example / "ground.gd").write_text(edit((example / "ground.gd").read_text()))
            (project / "shapes.gd").write_bytes((HERE / "shapes.gd").read_bytes())
            (project / "places.json").write_text(json.dumps(PLACES))
            self.engine.run(project, "gl_compatibility", "res://shapes.gd", SCENE, "res://places.json", "res://out.json",
                            options=("--fixed-fps", "60"))
            found = json.loads((project / "out.json").read_text())
            heights = heights_of_the_shader(project, (example / "land.gdshaderinc").read_text())
        self.assertGreater(max(heights) - min(heights), 20)
        return max(abs(on_the_mesh(heights, *place) - y) for place, y in zip(PLACES, found["heights"], strict=True)), found

    def test_the_shape_fits_the_land_and_the_ball_stays(self):
        for physics, nearest in ENGINES.items():
            with self.subTest(physics):
                distance, found = self.measured(physics)
                self.assertLess(distance, nearest)
                self.assertLess(found["speed"], 0.01)
                x, y, z = found["ball"]
                # It lies in a hollow above the sea; its radius is 1.
                self.assertLess(max(abs(x), abs(z - 11.5)), 1)
                self.assertTrue(1 < y < 3, y)

    def test_another_land_is_noticed(self):
        distance, _ = self.measured("GodotPhysics3D", lambda script: script.replace("0.5, 7)", "0.5, 8)"))
        self.assertGreater(distance, 5)


def draw(path: Path) -> None:
    """The scene as somebody sees it who opens it, four seconds later."""
    with skipped_without(), tempfile.TemporaryDirectory() as home, display() as shown_on:
        engine, project = Engine(find()[0], shown_on, Path(home)), Path(home) / "project"
        new_project(project)
        engine.run(project, "forward_plus", "res://scenes.gd", home, "jpg", SCENE,
                   options=("--fixed-fps", "60", "--resolution", "1280x720"))
        path.write_bytes((Path(home) / "terrain.jpg").read_bytes())


if __name__ == "__main__":
    if sys.argv[1:2] == ["--picture"]:
        draw(Path(sys.argv[2]))
    else:
        main(Land)
