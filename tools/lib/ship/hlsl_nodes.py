"""Functions in HLSL that are nodes of engines' shader graphs: the functions in most use, with the arguments of a node."""

from __future__ import annotations

from functools import cache

from base.tree import GLSL
from catalog import popular
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
# A port is a float, and a seed may be any whole number that a float has.
CONVERTED = {"int": "(int){}", "uint": "(uint)(int){}"}


@cache
def picked(names: tuple[str, ...], language: str, arithmetic: str) -> str:
    return picker()(names, Choice(language, arithmetic, name=NAMES.get((language, arithmetic), "")))


@cache
def forms() -> dict[str, Function]:
    return read_library(GLSL, Choice("hlsl")).forms


def camel(name: str) -> str:
    """perlin2_place is PerlinTile2, and cellular2_jitter is Cellular2."""
    words = popular.ENDS.sub("", name.removeprefix("hn_")).replace("2_place", "_tile2").split("_")
    return "".join(word[0].upper() + word[1:] for word in words)


def port(name: str) -> str:
    return "Position" if name in ("p", "place") else name[0].upper() + name[1:]


def ports(form: str) -> list[tuple[str, str]]:
    """The type and the name of a node's inputs."""
    taken: list[tuple[str, str]] = []
    for one in forms()[form].parameters:
        if one.type == "hn_place2":
            taken += [("float2", "Position"), ("float2", "Period")]
        else:
            taken.append((PORTS[one.type], port(one.at.text)))
    return taken


def call(form: str, arithmetic: str) -> str:
    """The call of the function, with the ports."""
    function, begin = forms()[form], NAMES.get(("hlsl", arithmetic), "hn")
    arguments = [f"{begin}_tile(Position, (int2)Period)" if one.type == "hn_place2" else
                 CONVERTED.get(one.type, "{}").format(port(one.at.text)) for one in function.parameters]
    return f"{begin}{function.name.removeprefix('hn')}({', '.join(arguments)})"


def shader(arithmetic: str) -> str:
    """A file with all functions."""
    return picked(FORMS, "hlsl", arithmetic)
