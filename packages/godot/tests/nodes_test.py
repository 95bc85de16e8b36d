"""The nodes of the add-on in visual shaders of a real Godot: each draws as its function does in a shader of text, and the
editor's menu has it.

    python3 packages/godot/tests/nodes_test.py

Exit status: 0 they do, 1 they do not, 77 there is no Godot here.
"""

from __future__ import annotations

import json
import re
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

from engine import Engine, main
from example_test import new_project, part_that_differs

from catalog.tables.functions import read_functions
from ship.godot.files import ADDON
from ship.godot.nodes import Input, call, inputs, text, title
from ship.hlsl_nodes import ARITHMETICS, NODES, forms

HERE = Path(__file__).resolve().parent
SIDE = 64
# No two inputs of a node have the same number, and no input has its default.
GIVEN = {"octaves": [3], "lacunarity": [2.25], "gain": [0.625], "amplitude": [0.75], "jitter": [0.875], "metric": [3],
         "wave": [2.0, 1.0, 0.5], "bandwidth": [0.375], "phase": [0.25], "seed": [4000000007], "period": [4.0, 6.0]}
SHADER = """\
shader_type canvas_item;
#define HN_ARITHMETIC HN_{arithmetic}
#include "res://{addon}/{part}.gdshaderinc"

void fragment() {{
	COLOR = vec4({value} * 0.5 + 0.5, 1.0);
}}
"""
# It opens a visual shader in the editor, presses "Add Node...", prints the branch of the menu, and takes one node.
MENU = """\
@tool
extends EditorPlugin

func _enter_tree() -> void:
	look.call_deferred()

func look() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	await get_tree().create_timer(1.0).timeout
	var graph := VisualShader.new()
	EditorInterface.edit_resource(graph)
	await get_tree().create_timer(1.0).timeout
	var editor: Node = EditorInterface.get_base_control().find_children("*", "VisualShaderEditor", true, false)[0]
	for button in editor.find_children("*", "Button", true, false):
		if button.text == "Add Node...":
			button.pressed.emit()
	for tree in editor.find_children("*", "Tree", true, false):
		for item in branch(tree.get_root(), ["Addons", "hashnoise"]):
			print("found: ", item.get_text(0))
			if item.get_text(0) == "HashNoiseFbm2D":
				item.select(0)
				tree.item_activated.emit()
	await get_tree().create_timer(1.0).timeout
	print("taken: ", graph.get_node(VisualShader.TYPE_VERTEX, 2).get_default_input_values())
	get_tree().quit()

func branch(item: TreeItem, path: Array) -> Array:
	for name in path:
		var inside := item.get_children().filter(func(child): return child.get_text(0) == name) if item else []
		item = inside[0] if inside else null
	return item.get_children() if item else []
"""


# The first row of a function takes a position alone, and the others a phase or such.
PARTS = {(function.calls, str(function.axes)): Path(function.includes).stem for function in reversed(read_functions())}


def literal(one: Input, given: bool) -> str:
    """The value of an input in a shader: GIVEN's, or its default."""
    if one.name == "position":
        return "UV * 8.0" if one.type == "VECTOR_2D" else "vec3(UV * 8.0, 0.0)"
    numbers = GIVEN[one.name] if given else [float(number) for number in re.findall(r"[\d.]+(?=[,)]|$)", one.default)]
    count = {"VECTOR_2D": 2, "VECTOR_3D": 3}.get(one.type, 1)
    if count > 1:
        return f"vec{count}({', '.join(map(str, numbers[:count]))})"
    return {"SCALAR": "{}", "SCALAR_INT": "{:.0f}", "SCALAR_UINT": "{:.0f}u"}[one.type].format(numbers[0])


def of_text(form: str, arithmetic: str, given: bool) -> str:
    """A shader that calls the function of a part."""
    value = call(form) % tuple(literal(one, given) for one in inputs(form))
    whole = {"float": "vec3({})", "vec2": "vec3({}, 0.0)", "vec3": "{}"}[forms()[form].type].format(value)
    return SHADER.format(arithmetic=arithmetic.upper(), addon=ADDON, part=PARTS[forms()[form].name, text(form)[-2]],
                         value=whole)


class Nodes(unittest.TestCase):
    engine: Engine

    def differing(self, renderer: str, chosen: tuple[str, ...], edit: Callable[[Path], object] = lambda folder: None) -> set[str]:
        """The nodes that draw other colours than their functions: with defaults in floats, and with other inputs in
        integers."""
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder)
            new_project(project)
            edit(project / ADDON / "nodes")
            (project / "graphs.gd").write_bytes((HERE / "graphs.gd").read_bytes())
            graphs, shaders, names = [], [], []
            for form in chosen:
                for at, arithmetic in enumerate(ARITHMETICS):
                    name = f"{text(form)}_{arithmetic}"
                    graphs.append({"node": f"res://{ADDON}/nodes/{text(form)}.gd", "arithmetic": at,
                                   "out": f"res://{name}.tres", **({"inputs": GIVEN} if at else {})})
                    (project / f"{name}.gdshader").write_text(of_text(form, arithmetic, at == 1))
                    shaders += [{"code": f"res://{name}.{end}", "rows": [{"out": f"res://{name}.{end}.out"}]}
                                for end in ("tres", "gdshader")]
                    names.append(name)
            (project / "graphs.json").write_text(json.dumps(graphs))
            (project / "job.json").write_text(json.dumps({"size": [SIDE, SIDE], "shaders": shaders}))
            self.engine.run(project, renderer, "res://graphs.gd", "res://graphs.json")
            self.engine.run(project, renderer, "res://evaluate.gd", "res://job.json")
            found = set()
            for name in names:
                drawn, expected = ((project / f"{name}.{end}.out").read_bytes() for end in ("tres", "gdshader"))
                self.assertGreater(len(set(expected)), 20, name)
                if part_that_differs(drawn, expected) > 0:
                    found.add(name)
            return found

    def test_each_draws_what_its_function_draws(self):
        for renderer, chosen in (("gl_compatibility", NODES), ("forward_plus", NODES[::9]), ("mobile", NODES[4::9])):
            with self.subTest(renderer=renderer):
                self.assertEqual(self.differing(renderer, chosen), set())

    def test_a_wrong_order_of_ports_is_noticed(self):
        def swapped(folder: Path) -> None:
            for name, one, other in (("fbm2d.gd", "lacunarity", "gain"), ("warp2d.gd", "gain", "amplitude")):
                path = folder / name
                rows = re.findall(rf'\t\t\["(?:{one}|{other})".*\n', path.read_text())
                self.assertEqual(len(rows), 2)
                path.write_text(path.read_text().replace("".join(rows), "".join(reversed(rows))))

        self.assertEqual(self.differing("gl_compatibility", ("hn_fbm2", "hn_warp2", "hn_fbm3"), swapped),
                         {"fbm2d_fast", "fbm2d_fixed", "warp2d_fast", "warp2d_fixed"})

    def test_the_menu_of_the_editor_has_each_by_its_name(self):
        with tempfile.TemporaryDirectory() as folder:
            project = Path(folder)
            new_project(project)
            (project / "addons/menu").mkdir()
            (project / "addons/menu/plugin.cfg").write_text('[plugin]\nname="menu"\ndescription=""\nauthor=""\nversion=""\n'
                                                            'script="menu.gd"\n')
            (project / "addons/menu/menu.gd").write_text(MENU)
            # The editor does not see a relative path.
            lost = (project / ADDON / "nodes" / "perlin2d.gd").read_text().replace("HashNoisePerlin2D", "HashNoiseLost")
            (project / ADDON / "nodes" / "lost.gd").write_text(lost.replace(f"res://{ADDON}/nodes/", ""))
            self.engine.import_files(project)
            with (project / "project.godot").open("a") as settings:
                settings.write('[editor_plugins]\nenabled=PackedStringArray("res://addons/menu/plugin.cfg")\n')
            printed = self.engine.edit(project)
        self.assertEqual(re.findall(r"^found: (.*)$", printed, re.MULTILINE), sorted(map(title, NODES)))
        self.assertIn("taken: [0, <null>, 1, 6, 2, 2.0, 3, 0.5, 4, 0]\n", printed)


if __name__ == "__main__":
    main(Nodes)
