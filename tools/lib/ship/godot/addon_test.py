"""tools/pack godot: the content of the add-on, as far as no Godot is needed to check it."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

from base.tree import ROOT, version
from catalog.tables.functions import read_functions
from ship.godot.files import ADDON, GAP, WINDOW, package, tiles
from ship.pages.gallery import recipes

ARCHIVE = f"hashnoise-godot-{version()}.zip"


def absent(texts: dict[str, str]) -> dict[str, list[str]]:
    """For each file of a project what it includes or names, and is not there: Godot finds what begins with res://
    alone, and includes what ends in .gdshaderinc."""
    found = {}
    for name, text in texts.items():
        included = re.findall(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">\n]*)', text, re.MULTILINE)
        wrong = [path for path in included if not path.startswith("res://") or not path.endswith(".gdshaderinc")]
        wrong += [path for path in re.findall(r'"(res://[^"]*)"', text) if path.removeprefix("res://") not in texts]
        if wrong:
            found[name] = wrong
    return found


class Addon(unittest.TestCase):
    files: dict[str, str]

    @classmethod
    def setUpClass(cls):
        cls.files = {name: content.decode("utf-8") for name, content in package().items()}

    def test_everything_is_in_its_folder(self):
        self.assertEqual([name for name in self.files if not name.startswith(f"{ADDON}/")], [])
        for name in ("LICENSE", "README.md", "example/gallery.tscn", "example/terrain.tscn", "hashnoise.gdshaderinc"):
            self.assertIn(f"{ADDON}/{name}", self.files)

    def test_each_function_has_a_part(self):
        for function in read_functions():
            part = self.files[f"{ADDON}/{Path(function.includes).stem}.gdshaderinc"]
            self.assertRegex(part, rf"(?m)^\w+ {function.calls}\(", function.id)

    def test_a_part_stands_alone_and_explains_its_functions(self):
        for name, text in self.files.items():
            if name.endswith(".gdshaderinc"):
                with self.subTest(name=name):
                    self.assertNotRegex(text, r"(?m)^#include")
                    self.assertIn(f"hashnoise {version()} for Godot", text.split("\n")[0])
        for part, said in (("fbm2d", "//   octaves     how many"), ("cellular3d", "//   jitter"), ("perlin2d", "//   returns")):
            self.assertIn(said, self.files[f"{ADDON}/{part}.gdshaderinc"])

    def test_what_is_named_is_there(self):
        page = (ROOT / "docs" / "guide" / "godot.md").read_text(encoding="utf-8")
        shaders = "".join(re.findall(r"^```gdshader\n(.*?)^```$", page, re.MULTILINE | re.DOTALL))
        self.assertEqual(absent({**self.files, "page": shaders}), {})
        name = f"{ADDON}/example/recipes/marble.gdshader"
        for right, wrong in (('"res://', '"hashnoise/'), ('fbm2d.gdshaderinc"', 'fbm5d.gdshaderinc"'),
                             (".gdshaderinc", ".glsl")):
            changed = self.files[name].replace(right, wrong)
            self.assertNotEqual(changed, self.files[name])
            self.assertEqual([*absent({**self.files, name: changed})], [name])
        scene = f"{ADDON}/example/terrain.tscn"
        self.assertEqual([*absent({**self.files, scene: self.files[scene].replace("terrain.gdshader", "hills.gdshader")})],
                         [scene])

    def test_all_of_the_gallery_is_in_the_window(self):
        for count in (1, 7, 20, 23, 60):
            columns, side = tiles(count)
            for size, of in zip(WINDOW, (columns, -(-count // columns))):
                self.assertLessEqual(of * side + (of - 1) * GAP, size)
            self.assertGreater(count * side ** 2, 0.25 * WINDOW[0] * WINDOW[1])
        self.assertIn(f"columns = {tiles(len(recipes()))[0]}\n", self.files[f"{ADDON}/example/gallery.tscn"])

    def test_the_gallery_has_every_recipe(self):
        scene = self.files[f"{ADDON}/example/gallery.tscn"]
        for recipe in recipes():
            self.assertIn(f"recipes/{recipe.name}.gdshader", scene)

    def test_the_pages_name_the_file_that_is_made(self):
        self.assertIn(ARCHIVE, (ROOT / "docs" / "guide" / "godot.md").read_text(encoding="utf-8"))
