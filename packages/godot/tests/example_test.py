"""The example of the add-on, and the code of the page, in a new project of a real Godot.

    python3 packages/godot/tests/example_test.py

The recipes have the pictures of the gallery, which C++ draws. Exit status: 0 they have, 1 they have not, 77 there is no
Godot here.
"""

from __future__ import annotations

import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from engine import RENDERERS, Engine, Failure, main

from base.png import read_png
from base.tree import GLSL, ROOT
from base.twin import compile_program
from ship.godot.files import ADDON, TURN, package, recipe_texts
from ship.packing import put
from translate.pick.command import settings
from translate.pick.program import Program, chosen, read
from translate.pick.shading import LANGUAGES

HERE = Path(__file__).resolve().parent
PAGE = ROOT / "docs" / "guide" / "godot.md"
SIDE = 512  # of the gallery's pictures
# The heights of two chunks, in the call of the page, and in its script.
HEIGHTS_IN_CPP = """\
#include <hashnoise/hashnoise.hpp>
#include <cstdio>
using namespace hashnoise;
int main() {
  const ivec2 chunks[] = {ivec2(64, -32), ivec2(-70000, 9)};
  for (ivec2 first : chunks)
    for (int i = 0; i < 64 * 64; ++i) {
      const ivec2 at(i % 64, i / 64);
      const float height = CALL;
      std::fwrite(&height, 4, 1, stdout);
    }
}
"""
HEIGHTS_IN_GODOT = """\
extends SceneTree
func _init():
	var heights := Heights.new()
	var out := FileAccess.open("res://out", FileAccess.WRITE)
	for first in [Vector2i(64, -32), Vector2i(-70000, 9)]:
		out.store_buffer(heights.of_chunk(first).to_byte_array())
	quit()
"""
NOISY = {"ink": 0.002}  # the part of the pixels that may differ more, where a little noise turns a colour


def new_project(folder: Path) -> None:
    """An empty project with the add-on."""
    put(folder, package())
    (folder / "project.godot").write_text("config_version=5\n")
    for name in ("evaluate.gd", "scenes.gd"):
        (folder / name).write_bytes((HERE / name).read_bytes())


def drawn(engine: Engine, renderer: str, shaders: dict[str, str]) -> dict[str, bytes]:
    """The colours of each shader, drawn on a square."""
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder)
        new_project(project)
        for name, text in shaders.items():
            (project / f"{name}.gdshader").write_text(text)
        job = {"size": [SIDE, SIDE], "shaders": [{"code": f"res://{name}.gdshader", "rows": [{"out": f"res://{name}.out"}]}
                                                 for name in shaders]}
        (project / "job.json").write_text(json.dumps(job))
        engine.run(project, renderer, "res://evaluate.gd", "res://job.json")
        found = {}
        for name in shaders:
            colours = (project / f"{name}.out").read_bytes()
            found[name] = bytes(value for i, value in enumerate(colours) if i % 4 < 3)
        return found


def part_that_differs(one: bytes, other: bytes) -> float:
    return sum(abs(a - b) > 2 for a, b in zip(one, other, strict=True)) / len(one)


class Example(unittest.TestCase):
    engine: Engine

    def gallery(self, name: str) -> bytes:
        width, height, colours = read_png(ROOT / "docs" / "guide" / "gallery" / f"{name}.png")
        self.assertEqual((width, height), (SIDE, SIDE))
        return colours

    def test_recipes_have_the_pictures_of_the_gallery(self):
        # A looping recipe has the same time there.
        recipes = {name: text.replace(TURN, "0.25") for name, text in recipe_texts().items()}
        self.assertGreaterEqual(len(recipes), 15)
        for renderer in RENDERERS:
            # All are drawn by the first, and some by the others.
            some = recipes if renderer == "gl_compatibility" else {name: recipes[name] for name in ("mud", "planet", "hills")}
            for name, colours in drawn(self.engine, renderer, some).items():
                with self.subTest(renderer=renderer, name=name):
                    self.assertLessEqual(part_that_differs(colours, self.gallery(name)), NOISY.get(name, 0))

    def test_another_seed_is_noticed(self):
        recipe = recipe_texts()["marble"]
        colours = drawn(self.engine, "gl_compatibility", {"marble": recipe.replace("7u", "8u")})["marble"]
        self.assertGreater(part_that_differs(colours, self.gallery("marble")), 0.2)

    def test_scenes_are_shown_on_every_renderer(self):
        for renderer in RENDERERS:
            with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as out:
                new_project(Path(folder))
                scenes = [f"res://{ADDON}/example/{name}.tscn" for name in ("gallery", "terrain")]
                self.engine.run(Path(folder), renderer, "res://scenes.gd", out, "png", *scenes, options=("--fixed-fps", "60"))
                for name in ("gallery", "terrain"):
                    width, _, colours = read_png(Path(out) / f"{name}.png")
                    self.assertEqual(width, 1152)  # of a new project's window
                    with self.subTest(renderer=renderer, scene=name):
                        self.assertGreater(len({colours[i:i + 3] for i in range(0, len(colours), 3 * 97)}), 1000)

    def test_the_code_of_the_page_compiles(self):
        page = PAGE.read_text(encoding="utf-8")
        shaders = re.findall(r"^```gdshader\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(shaders), 2)
        for renderer in RENDERERS:
            first = drawn(self.engine, renderer, {"page": shaders[0]})["page"]
            self.assertGreater(len(set(first)), 50)
            self.compile(renderer, shaders[1:])
        with self.assertRaises(Failure):
            self.compile("gl_compatibility", [text.replace("hn_fbm_d(", "hn_fbn_d(") for text in shaders[1:]])

    def test_the_messages_of_the_page(self):
        page = PAGE.read_text(encoding="utf-8")
        shader = re.search(r"^```gdshader\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1]
        include, = re.findall(r"#include .*\n", shader)
        message = re.search(r"^    SHADER ERROR: (.*)", page, re.MULTILINE)[1]
        for wrong, expected in ((f"#define HN_ARITHMETIC HN_FIXXED\n{include}", message),
                                (f"{include}#define HN_ARITHMETIC HN_FIXED\n", message),
                                (include.replace("fbm2d", "fbm9d"), message)):
            with self.subTest(wrong), self.assertRaisesRegex(Failure, re.escape(expected)):
                self.compile("gl_compatibility", [shader.replace(include, wrong)])
        message = re.search(r"`(No matching function .*?)`", page)[1]
        with self.assertRaisesRegex(Failure, re.escape(message)):
            self.compile("gl_compatibility", [shader.replace("7u", "7")])

    def test_the_names_of_fastnoiselite_are_those_of_the_page(self):
        above, _, page = (ROOT / "docs" / "guide" / "moving.md").read_text(encoding="utf-8").partition("\n## Godot\n")
        table = re.search(r"^\| Godot \|.*\n((?:\|.*\n)+)", page, re.MULTILINE)[1]
        named = {name for line in table.splitlines() for name in re.findall(r"`(\w+)`", line.split("|")[1])}
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "project.godot").write_text("config_version=5\n")
            (Path(folder) / "names.gd").write_text(
                "extends SceneTree\nfunc _init():\n\tfor name in ClassDB.class_get_integer_constant_list"
                '("FastNoiseLite", true):\n\t\tprint("name: ", name)\n\tfor found in ClassDB.class_get_property_list'
                '("FastNoiseLite", true):\n\t\tprint("property: ", found.name)\n\tquit()\n')
            printed = self.engine.run(Path(folder), "gl_compatibility", "res://names.gd")
        constants, properties = (set(re.findall(rf"^{kind}: (\w+)$", printed, re.MULTILINE)) for kind in ("name", "property"))
        self.assertEqual(named - constants - properties, set())
        known = re.findall(r"[A-Z0-9]+\b", above.replace("_", ""))
        prefix = r"^(TYPE|FRACTAL|RETURN|DISTANCE|DOMAIN_WARP_FRACTAL)_"
        unknown = {name for name in constants - named
                   if not any(one.endswith(re.sub(prefix, "", name).replace("_", "")) for one in known)}
        # Both libraries have a constant for no fractal, and rows of cells name the result.
        self.assertEqual(unknown, {"TYPE_CELLULAR", "FRACTAL_NONE", "DOMAIN_WARP_FRACTAL_NONE"})

    def test_heights_in_gdscript_have_the_bits_of_cpp(self):
        """By the script and the compute shader of the page; with another seed they differ."""
        page = PAGE.read_text(encoding="utf-8")
        shader, = re.findall(r"^```text\n(#\[compute\]\n.*?)^```$", page, re.MULTILINE | re.DOTALL)
        script, = re.findall(r"^```gdscript\n(class_name Heights\n.*?)^```$", page, re.MULTILINE | re.DOTALL)
        picked, = re.findall(r"^    tools/pick (\S+) --arithmetic (\S+) > (\S+\.glslinc)$", page, re.MULTILINE)
        call = re.search(r"hn_fbm\(.*(?=;)", shader)[0]
        library = read(GLSL, settings(picked[1], "lattice"))
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder)
            (project / "heights.cpp").write_text(HEIGHTS_IN_CPP.replace("CALL", call))
            compile_program("the call of the page", project / "heights.cpp", project / "heights", "-O0",
                            macros=["HN_ARITHMETIC=HN_FIXED"])
            expected = subprocess.run([project / "heights"], capture_output=True, check=True).stdout
            (project / "project.godot").write_text("config_version=5\n")
            (project / "heights.gd").write_text(script)
            (project / "run.gd").write_text(HEIGHTS_IN_GODOT)
            (project / picked[2]).write_text(Program(library, chosen(library, [picked[0]])).text(LANGUAGES["glsl"]))
            for seed, renderer, same in ((7, "forward_plus", True), (7, "mobile", True), (8, "mobile", False)):
                (project / "heights.glsl").write_text(shader.replace("7u", f"{seed}u"))
                self.engine.import_files(project)
                self.engine.run(project, renderer, "res://run.gd")
                with self.subTest(renderer=renderer, seed=seed):
                    self.assertEqual((project / "out").read_bytes() == expected, same)
            (project / "none.gd").write_text("extends SceneTree\nfunc _init():\n\tprint('device: ', "
                                             "RenderingServer.create_local_rendering_device())\n\tquit()\n")
            self.assertIn("device: <Object#null>\n", self.engine.run(project, "gl_compatibility", "res://none.gd"))

    def test_picked_functions_draw_the_same_as_the_addon(self):
        shaders = {}
        for name, part, call in (("hn_fbm2", "fbm2d", "hn_fbm(UV * 8.0, 6, 2.0, 0.5, 7u)"),
                                 ("hn_cellular2", "cellular2d", "hn_cellular(UV * 8.0, 7u).x - 0.5"),
                                 ("hn_simplex3", "simplex3d", "hn_simplex(vec3(UV * 8.0, 0.5), 7u)"),
                                 ("hn_gullies2", "gullies2d", "hn_gullies(UV * 8.0, vec2(1.0), 4, 2.0, 0.5, 0.1, 7u).x")):
            for arithmetic in ("fast", "fixed"):
                library = read(GLSL, settings(arithmetic, "lattice"))
                picked = Program(library, chosen(library, [name])).text(LANGUAGES["godot"])
                included = (f'#define HN_ARITHMETIC HN_{arithmetic.upper()}\n'
                            f'#include "res://{ADDON}/{part}.gdshaderinc"\n')
                for kind, text in (("picked", picked), ("included", included)):
                    shaders[f"{name}_{arithmetic}_{kind}"] = (
                        f"shader_type canvas_item;\n{text}\nvoid fragment() {{\n\tCOLOR = vec4(vec3(0.5 + {call}), 1.0);"
                        "\n}\n")
        shaders["other"] = shaders["hn_fbm2_fixed_picked"].replace("7u)), 1.0", "8u)), 1.0")
        for renderer in RENDERERS:
            pictures = drawn(self.engine, renderer, shaders)
            self.assertGreater(part_that_differs(pictures["other"], pictures["hn_fbm2_fixed_included"]), 0.5)
            for name in pictures:
                if name.endswith("_picked"):
                    with self.subTest(renderer=renderer, name=name):
                        included = pictures[name.replace("_picked", "_included")]
                        self.assertGreater(len(set(included)), 50)
                        self.assertEqual(part_that_differs(pictures[name], included), 0)

    def compile(self, renderer: str, shaders: list[str]) -> None:
        with tempfile.TemporaryDirectory() as folder:
            new_project(Path(folder))
            loads = []
            for number, text in enumerate(shaders):
                (Path(folder) / f"page{number}.gdshader").write_text(text)
                # To ask for the uniforms compiles the shader.
                loads.append(f'\tprint(load("res://page{number}.gdshader").get_shader_uniform_list())\n')
            (Path(folder) / "compile.gd").write_text(f"extends SceneTree\nfunc _init():\n{''.join(loads)}\tquit()\n")
            self.engine.run(Path(folder), renderer, "res://compile.gd")


if __name__ == "__main__":
    main(Example)
