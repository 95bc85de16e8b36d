"""The files of the add-on for Godot."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from base.tree import ROOT, version
from ship.godot import nodes
from ship.godot.store import beside as beside  # for tools/pack
from ship.packing import own_files
from ship.pages.gallery import recipes
from translate.pick.command import Choice
from translate.pick.command import picked as pick
from translate.single_file import godot
from translate.single_file.files import Part, in_order, parts

PACKAGE = ROOT / "packages" / "godot"
ADDON = "addons/hashnoise"
# A file of the library has something for users if it defines a function of theirs, or only names such files.
PUBLIC = re.compile(r"HN_FN (?:\w+ )+hn_(?!i_)\w+\(|HN_[A-Z_]+[1-4]D\(\w+, \w+\)$")
HEADER = """\
// Part of hashnoise {version} for Godot 4.4 and later: {what}
// Copyright (c) 2026 The hashnoise authors; MIT License. Made by tools/pack godot from {name}.
//
//   #include "res://addons/hashnoise/{stem}.gdshaderinc"
//
{where}
"""
COMMENTED = "// Helpers come first. The file's own functions follow, each below a comment on its arguments and result."
PLAIN = "// The functions are explained in the files of one noise each, such as perlin2d.gdshaderinc."
RECIPE = """\
// A recipe of hashnoise's gallery. Made by tools/pack godot.
shader_type canvas_item;
{code}
void fragment() {{
	vec2 uv = vec2(UV.x, 1.0 - UV.y);
	COLOR = vec4({call}, 1.0);
}}
"""
RECIPES = f"{ADDON}/example/recipes"
WINDOW = 1152, 648  # of a new project
GAP = 4             # of a grid, between tiles
# Eight seconds make a turn of the recipes that loop.
TURN = "fract(TIME / 8.0)"


def public_parts(library: dict[str, Part]) -> list[str]:
    return [name for name, part in library.items() if not name.startswith("detail/")
            and (any(PUBLIC.match(line) for line in part.lines) or "Made by tools/make" in part.lines[0])]


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    yield from ((f"{Path(name).stem}.gdshaderinc", "") for name in public_parts(parts()))
    yield from nodes.interface()


def part_text(name: str, library: dict[str, Part], stripped: dict[str, Part]) -> str:
    """A part with all that it needs, without the needed parts' comments."""
    first = library[name].lines[0]
    only_names_others = "Made by tools/make" in first
    what = re.match(r"// hashnoise: (.*?\.)(?: |$)", first)[1]
    needed = in_order(name, library)
    lines = [line for other in needed[:-1] for line in stripped[other].lines]
    lines += ["", *library[name].lines] if not only_names_others else stripped[name].lines
    header = HEADER.format(version=version(), what=what, name=name, stem=Path(name).stem,
                           where=PLAIN if only_names_others else COMMENTED)
    return header + "\n".join(godot.expanded(lines)) + "\n"


def recipe_texts() -> dict[str, str]:
    """The gallery as shaders of Godot, by their names."""
    texts = {}
    for recipe in recipes():
        code = re.sub(r'#include "hashnoise/(\w+)\.glsl"', rf'#include "res://{ADDON}/\1.gdshaderinc"', recipe.code)
        texts[recipe.name] = RECIPE.format(code=code, call=recipe.call(TURN))
    return texts


def tiles(count: int) -> tuple[int, int]:
    """How many columns make so many square tiles largest that all are in the window, and the side of one."""
    def side(columns: int) -> int:
        return min((size + GAP) // of - GAP for size, of in zip(WINDOW, (columns, -(-count // columns))))
    columns = max(range(1, count + 1), key=side)
    return columns, side(columns)


def gallery(names: list[str]) -> str:
    """A scene with a tile for each recipe."""
    columns, side = tiles(len(names))
    ids = list(enumerate(names, 1))
    blocks = [f"[gd_scene load_steps={2 * len(ids) + 1} format=3]"]
    blocks += [f'[ext_resource type="Shader" path="res://{RECIPES}/{name}.gdshader" id="{i}"]' for i, name in ids]
    blocks += [f'[sub_resource type="ShaderMaterial" id="material_{i}"]\nshader = ExtResource("{i}")' for i, _ in ids]
    blocks += [f'[node name="Gallery" type="GridContainer"]\ncolumns = {columns}']
    blocks += [f'[node name="{name.capitalize()}" type="ColorRect" parent="."]\n'
               f'material = SubResource("material_{i}")\ncustom_minimum_size = Vector2({side}, {side})\n'
               f'tooltip_text = "{name}"' for i, name in ids]
    return "\n\n".join(blocks) + "\n"


@cache
def package(picked: bool = True) -> dict[str, bytes]:
    """The files of a project, by their paths there. Without what tools/pick writes it takes a tenth of the time."""
    library, stripped = parts(), parts(strip=True)
    found = {f"{ADDON}/{Path(name).stem}.gdshaderinc": part_text(name, library, stripped).encode("ascii")
             for name in public_parts(library)}
    shaders = recipe_texts()
    found |= {f"{RECIPES}/{name}.gdshader": text.encode("utf-8") for name, text in shaders.items()}
    found[f"{ADDON}/example/gallery.tscn"] = gallery(list(shaders)).encode("ascii")
    found[f"{ADDON}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    made = {f"nodes/{name}": text for name, text in nodes.scripts().items()}
    if picked:
        made |= {f"nodes/{name}": text for name, text in nodes.functions().items()}
        made["example/hn_fbm2.gd"] = pick(("hn_fbm2",), Choice("gdscript", "fixed"))
    made |= own_files(PACKAGE / ADDON)
    return found | {f"{ADDON}/{path}": text.encode("utf-8") for path, text in made.items()}
