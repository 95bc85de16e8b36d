"""tools/pack godot: the content of the add-on, as far as no Godot is needed to check it."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

from base.tree import ROOT, version
from catalog.tables.functions import read_functions
from ship import hlsl_nodes
from ship.godot import nodes, store
from ship.godot.files import ADDON, GAP, WINDOW, package, tiles
from ship.pages.gallery import recipes

PORTS = {"SCALAR": "float", "SCALAR_INT": "float", "SCALAR_UINT": "float", "VECTOR_2D": "float2", "VECTOR_3D": "float3"}
ARCHIVE = f"hashnoise-godot-{version()}.zip"


def absent(texts: dict[str, str]) -> dict[str, list[str]]:
    """For each file of a project what it includes or names, and is not there: Godot finds what begins with res://
    alone, and includes what ends in .gdshaderinc."""
    found = {}
    for name, text in texts.items():
        included = re.findall(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">\n]*)', text, re.MULTILINE)
        wrong = [path for path in included if not path.startswith("res://") or not path.endswith(".gdshaderinc")]
        wrong += [path for path in re.findall(r'"(res://[^"]*[^"/])"', text) if path.removeprefix("res://") not in texts]
        if wrong:
            found[name] = wrong
    return found


def node_faults(texts: dict[str, str]) -> list[str]:
    """The rows of the table of nodes that have no script, or one with another class or with other ports."""
    found = []
    for form in hlsl_nodes.NODES:
        script = texts.get(f"{ADDON}/nodes/{nodes.text(form)}.gd", "")
        ports = [(PORTS[type_], name) for name, type_ in re.findall(r'\["(\w+)", PORT_TYPE_(\w+), ', script)]
        of_table = [(type_, name.lower()) for type_, name in hlsl_nodes.ports(form)]
        if (f"\nclass_name {nodes.title(form)}\n" not in script or ports != of_table
                or re.search(r"expression = .*", script)[0].count("%s") != len(ports)):
            found.append(form)
    return found


def store_faults(files: dict[str, str | bytes]) -> list[str]:
    """Faults that the Asset Store would refuse: an empty field, and a picture that is no JPEG of 1280 by 720 pixels or more."""
    form, picture = files["-store.md"], files["-store.jpg"]
    found = re.findall(r"^\| ([^|]+) \| *\|$", form, re.MULTILINE)
    found += re.findall(r"^## (.*)\n+(?=##|\Z)", form, re.MULTILINE)
    # The marker, the length, the precision, the height, the width.
    frame = re.search(rb"\xff[\xc0-\xc2]..\x08(..)(..)", picture, re.DOTALL)
    height, width = (int.from_bytes(part, "big") for part in frame.groups()) if frame else (0, 0)
    return found + ["the picture"] * (width < 1280 or height < 720 or 9 * width != 16 * height or len(picture) > 150_000)


class Addon(unittest.TestCase):
    files: dict[str, str]

    @classmethod
    def setUpClass(cls):
        cls.files = {name: content.decode("utf-8") for name, content in package(picked=False).items()}

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
            if re.fullmatch(rf"{ADDON}/\w+\.gdshaderinc", name):
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
        self.assertEqual([*absent({**self.files, scene: self.files[scene].replace("land.gdshader", "hills.gdshader")})],
                         [scene])

    def test_each_row_of_the_table_is_a_node_with_its_ports(self):
        self.assertEqual(node_faults(self.files), [])
        names = re.findall(r"^class_name (\w+)$", "".join(self.files.values()), re.MULTILINE)
        self.assertEqual((len(names), len(set(names))), (len(hlsl_nodes.NODES),) * 2)
        self.assertIn('''	inputs = [
		["position", PORT_TYPE_VECTOR_2D, null],
		["period", PORT_TYPE_VECTOR_2D, Vector2(8.0, 8.0)],
		["seed", PORT_TYPE_SCALAR_UINT, 0],
	]
	output = PORT_TYPE_SCALAR
''', self.files[f"{ADDON}/nodes/perlin_tile2d.gd"])
        name = f"{ADDON}/nodes/cellular3d.gd"
        for right, wrong in (("class_name HashNoise", "class_name Hashnoise"), ("jitter", "jiter"), (", %s)", ")"),
                             ("PORT_TYPE_VECTOR_3D", "PORT_TYPE_VECTOR_2D")):
            with self.subTest(wrong):
                self.assertEqual(node_faults({**self.files, name: self.files[name].replace(right, wrong)}),
                                 ["hn_cellular3_jitter"])

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

    def test_the_form_of_the_store_is_filled_in(self):
        files = store.beside()
        self.assertEqual(store_faults(files), [])
        changelog = f"## {version()} (2026-11-30)\n\n- [Godot](a.md): nodes.\n- Rust.\n\n## 1.0.0 (2026-01-01)\n\n- Godot.\n"
        self.assertEqual(store.changes(changelog).splitlines()[:-1], ["- Godot: nodes."])
        form, small = files["-store.md"], (ROOT / "docs/images/vectors.png").read_bytes()
        for wrong, fault in (({"-store.md": form.replace("| MIT |", "| |")}, "License"), ({"-store.jpg": small}, "the picture"),
                             ({"-store.md": form.partition("\n- ")[0]}, "Changelog")):
            with self.subTest(fault):
                self.assertEqual(store_faults({**files, **wrong}), [fault])

    def test_the_page_names_the_file_that_is_made_and_counts_nodes(self):
        page = (ROOT / "docs" / "guide" / "godot.md").read_text(encoding="utf-8")
        self.assertIn(ARCHIVE, page)
        self.assertIn(f"There are {len(hlsl_nodes.NODES)} nodes:", page)
