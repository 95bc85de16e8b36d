"""Functions in HLSL that are nodes of engines' shader graphs: the functions in most use, with the arguments of a node."""

from __future__ import annotations

import hashlib
import re
from functools import cache
from typing import NamedTuple

from base.tree import GLSL
from catalog import parameters, popular
from translate.parsing.syntax import Function
from translate.pick.command import Choice, picker, read_library

# The arithmetics, with their suffixes in the names of classes, files and nodes.
ARITHMETICS = {"fast": "", "fixed": "Fixed"}
# One shader may have both arithmetics, and one program.
NAMES = {("hlsl", "fixed"): "hn_fixed", ("csharp", "fixed"): "HashNoiseFixed"}
NODES = popular.nodes("graphs")
# All functions: shaders and scripts also have the short forms of those that take a jitter.
FORMS = (*NODES, *(form.removesuffix("_jitter") for form in NODES if form.endswith("_jitter")), "hn_tile2")
PORTS = {"float": "float", "int": "float", "uint": "float", "vec2": "float2", "vec3": "float3", "ivec2": "float2"}
PERIOD = "after how many cells it repeats along each axis: whole numbers; 0 is never"
IN_TILE = ": a whole number from 1 to 255 here, since octaves have to fit into the period"
# A port is a float, and a seed may be any whole number that a float has.
CONVERTED = {"int": "(int){}", "uint": "(uint)(int){}"}


@cache
def picked(names: tuple[str, ...], language: str, arithmetic: str) -> str:
    return picker()(names, Choice(language, arithmetic, name=NAMES.get((language, arithmetic), "")))


def alone(form: str, language: str, arithmetic: str) -> str:
    """The text of the function of one node, without comments and macros."""
    names = ("hn_tile2", form) if form.endswith("_place") else (form,)
    return re.sub(r"(?m)^ *//.*\n|^#.*\n", "", picked(names, language, arithmetic))


def title(form: str, arithmetic: str) -> str:
    return f"HashNoise{ARITHMETICS[arithmetic]}{camel(form)}"


def guid(name: str) -> str:
    """Of something in an engine's file: each version has the same, so what users link to it stays linked."""
    return hashlib.md5(name.encode(), usedforsecurity=False).hexdigest()


def width(type_: str) -> int:
    """The components of a port."""
    return int(type_.removeprefix("float") or 1)


@cache
def forms() -> dict[str, Function]:
    return read_library(GLSL, Choice("hlsl")).forms


def camel(name: str) -> str:
    """perlin2_place is PerlinTile2, and cellular2_jitter is Cellular2."""
    words = popular.ENDS.sub("", name.removeprefix("hn_")).replace("2_place", "_tile2").split("_")
    return "".join(word[0].upper() + word[1:] for word in words)


def port(name: str) -> str:
    return "Position" if name in ("p", "place") else name[0].upper() + name[1:]


class Input(NamedTuple):
    name: str
    type: str                   # in GLSL
    default: tuple[float, ...]  # a number for each component; none for a position
    about: str


def inputs(form: str) -> list[Input]:
    """A node's inputs, in their order."""
    found = []
    for one in forms()[form].parameters:
        name = one.at.text
        about = parameters.about(form, name, is_fixed=True)
        if name == "place":
            found += [Input("Position", "vec2", (), "in cells"), Input("Period", "ivec2", (8, 8), PERIOD)]
        elif about is None:
            found.append(Input(port(name), one.type, (), "in cells"))
        else:
            axes = "xyz"[:int(one.type[-1])] if one.type[-1].isdigit() else ""
            of_axes = [parameters.about(form, f"{name}_{axis}", is_fixed=True) for axis in axes]
            found.append(Input(port(name), one.type, tuple(of.default or 0 for of in of_axes or [about]),
                               about.what + IN_TILE * (name == "lacunarity" and form.endswith("_place"))))
    return found


def ports(form: str) -> list[tuple[str, str]]:
    """The type and the name of a node's inputs."""
    return [(PORTS[one.type], one.name) for one in inputs(form)]


def call(form: str, arithmetic: str) -> str:
    """The call of the function, with the ports."""
    function, begin = forms()[form], NAMES.get(("hlsl", arithmetic), "hn")
    arguments = [f"{begin}_tile(Position, (int2)Period)" if one.type == "hn_place2" else
                 CONVERTED.get(one.type, "{}").format(port(one.at.text)) for one in function.parameters]
    return f"{begin}{function.name.removeprefix('hn')}({', '.join(arguments)})"


def shader(arithmetic: str) -> str:
    """A file with all functions."""
    return picked(FORMS, "hlsl", arithmetic)
