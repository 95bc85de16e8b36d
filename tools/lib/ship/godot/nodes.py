"""The nodes of visual shaders in the add-on: a script for each, and tools/pick's text of its function in both
arithmetics.

A file of its own has 2 to 27 kB, where a part of the library has 24 to 118 kB, and the editor compiles a graph anew at
each change.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from base.tree import GLSL, version
from catalog import popular
from ship import hlsl_nodes
from ship.hlsl_nodes import ARITHMETICS, NODES, Input, alone, camel, forms
from translate.pick.comments import first_sentence

TYPES = {"float": "SCALAR", "int": "SCALAR_INT", "uint": "SCALAR_UINT", "vec2": "VECTOR_2D", "ivec2": "VECTOR_2D",
         "vec3": "VECTOR_3D"}
SHOWN = {"SCALAR": "float", "SCALAR_INT": "int", "SCALAR_UINT": "uint", "VECTOR_2D": "vec2", "VECTOR_3D": "vec3"}
POSITION = "in cells; where nothing is connected, UV * 8"
# The menu lacks a script that names another one by a relative path.
SCRIPT = """\
# A node of visual shaders, of hashnoise {version}. Made by tools/pack godot.
@tool
class_name {title}
extends "res://addons/hashnoise/nodes/node.gd"


func _init() -> void:
	title = "{title}"
	text = "{text}"
	expression = "{call}"
	inputs = [
{inputs}	]
	output = PORT_TYPE_{output}
	description = "{description}"
"""
TEXT = """\
// {title} of hashnoise {version}, by tools/pack godot
// Copyright (c) 2026 The hashnoise authors; MIT License.
#ifndef {guard}
#define {guard}
{code}#endif
"""


def title(form: str) -> str:
    return f"HashNoise{camel(form)}D"


def text(form: str) -> str:
    """The name of its files, without the ends."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", camel(form)).lower() + "d"


def default(one: Input) -> str:
    """In GDScript."""
    if len(one.default) > 1:
        return f"Vector{len(one.default)}({', '.join(str(float(number)) for number in one.default)})"
    return str((float if one.type == "float" else int)(one.default[0])) if one.default else "null"


def inputs(form: str) -> list[Input]:
    return [one._replace(name=one.name.lower(), about=one.about if one.default else POSITION)
            for one in hlsl_nodes.inputs(form)]


def call(form: str) -> str:
    function = forms()[form]
    arguments = ", ".join("hn_tile(%s, ivec2(%s))" if one.type == "hn_place2" else "%s" for one in function.parameters)
    return f"{function.name}({arguments})"


def description(form: str) -> str:
    about = popular.TILE_DOCS.get(form) or first_sentence(forms()[form], GLSL)
    ports = "".join(f"\n{one.name}: {one.about}." for one in inputs(form))
    return f"{about}\n{ports}\n\nFixed has the same bits on every GPU, and Fast is faster."


def script(form: str) -> str:
    rows = "".join(f'\t\t["{one.name}", PORT_TYPE_{TYPES[one.type]}, {default(one)}],\n' for one in inputs(form))
    said = description(form).replace("\n", "\\n")
    return SCRIPT.format(version=version(), title=title(form), text=text(form), call=call(form), inputs=rows,
                         output=TYPES[forms()[form].type], description=said)


def scripts() -> dict[str, str]:
    """By their names in the folder."""
    return {f"{text(form)}.gd": script(form) for form in NODES}


@cache
def functions() -> dict[str, str]:
    """The files that the nodes include, by their names in the folder. Their names are their own, since a shader may have
    other nodes, and parts of the library."""
    found = {}
    for form in NODES:
        code = "".join(re.sub(r"\bhn_", f"hn_{text(form)}_{arithmetic}_", alone(form, "godot", arithmetic))
                       for arithmetic in ARITHMETICS)
        found[f"{text(form)}.gdshaderinc"] = TEXT.format(title=title(form), version=version(), code=code,
                                                         guard=f"HN_NODE_{text(form).upper()}")
    return found


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    for form in NODES:
        yield from ((f"{title(form)}.{one.name}", f"{SHOWN[TYPES[one.type]]} {default(one).replace('null', 'UV * 8')}") for one in inputs(form))
        yield f"{title(form)}.value", f"output {forms()[form].type}"
