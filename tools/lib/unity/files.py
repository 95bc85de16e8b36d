"""The files of the package for Unity: what tools/pick writes in HLSL and C#, and functions for nodes of Shader Graph."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable
from functools import cache
from pathlib import PurePosixPath

from parsing.syntax import Function
from pick.command import Choice, picker, read_library
from pick.program import public
from tree import GLSL, ROOT, version

PACKAGE = ROOT / "packages" / "unity"
NAME = "com.hashnoise.noise"
# The arithmetics, with what they add to the names of classes, files and nodes.
ARITHMETICS = {"fast": "", "fixed": "Fixed"}
# What nodes are made of. The forms at a place are nodes for tiles.
NODES = ("hn_value2", "hn_value3", "hn_perlin2", "hn_perlin3", "hn_simplex2", "hn_simplex3", "hn_cellular2",
         "hn_cellular3", "hn_cell_border2", "hn_fbm2", "hn_fbm3", "hn_ridged2", "hn_ridged3", "hn_warp2",
         "hn_perlin2_place", "hn_fbm2_place")
TILE = "hn_tile2"
# C# has slopes, too, for normals, and exact places.
SCRIPTS = (*NODES, TILE, "hn_place_of_cell2", "hn_perlin_d2", "hn_simplex_d2", "hn_fbm_d2")
PORTS = {"float": "float", "int": "float", "uint": "float", "vec2": "float2", "vec3": "float3", "ivec2": "float2"}
# A port is a float, and a seed may be any whole number that a float has.
CONVERTED = {"int": "(int){}", "uint": "(uint)(int){}"}


@cache
def picked(names: tuple[str, ...], language: str, arithmetic: str) -> str:
    return picker()(names, Choice(language, arithmetic))


@cache
def forms() -> dict[str, Function]:
    return public(read_library(GLSL, Choice("hlsl")))


def camel(name: str) -> str:
    """perlin2_place is PerlinTile2."""
    words = name.removeprefix("hn_").replace("2_place", "_tile2").split("_")
    return "".join(word[0].upper() + word[1:] for word in words)


def port(name: str) -> str:
    return "Position" if name in ("p", "place") else name[0].upper() + name[1:]


def ports(form: str) -> list[tuple[str, str]]:
    """The type and the name of what a node takes."""
    taken: list[tuple[str, str]] = []
    for one in forms()[form].parameters:
        if one.type == "hn_place2":
            taken += [("float2", "Position"), ("float2", "Period")]
        else:
            taken.append((PORTS[one.type], port(one.at.text)))
    return taken


def node(form: str, arithmetic: str) -> str:
    """The functions of a node, in the precisions that Shader Graph has."""
    function, title = forms()[form], f"HashNoise{ARITHMETICS[arithmetic]}{camel(form)}"
    arguments = ["hn_tile(Position, (int2)Period)" if one.type == "hn_place2" else
                 CONVERTED.get(one.type, "{}").format(port(one.at.text)) for one in function.parameters]
    type_, taken = PORTS[function.type], ports(form)
    declared = ", ".join(f"{of} {name}" for of, name in taken)
    passed = ", ".join(name for _, name in taken)
    return (f"void {title}_float({declared}, out {type_} Out) {{\n"
            f"  Out = {function.name}({', '.join(arguments)});\n}}\n"
            f"void {title}_half({declared.replace('float', 'half')}, out {type_.replace('float', 'half')} Out) {{\n"
            f"  {type_} n;\n  {title}_float({passed}, n);\n  Out = n;\n}}\n")


def shader(arithmetic: str) -> str:
    """One text with names of its own, so that a graph may have both."""
    suffix = ARITHMETICS[arithmetic]
    guard = f"HASH_NOISE{'_FIXED' if suffix else ''}_HLSL"
    text = (f"#ifndef {guard}\n#define {guard}\n\n{picked((*NODES, TILE), 'hlsl', arithmetic)}\n"
            "// For Custom Function nodes of Shader Graph.\n" + "".join(node(form, arithmetic) for form in NODES) +
            "\n#endif\n")
    return re.sub(r"\bhn_", "hn_fixed_", text) if suffix else text


def script(arithmetic: str) -> str:
    return picked(SCRIPTS, "csharp", arithmetic).replace("static class HashNoise ",
                                                         f"static class HashNoise{ARITHMETICS[arithmetic]} ")


def table() -> str:
    """The nodes, for the page."""
    rows = "".join(f"| `HashNoise{camel(form)}` | {', '.join(f'{name} ({shown(of)})' for of, name in ports(form))} | "
                   f"{shown(PORTS[forms()[form].type])} |\n" for form in NODES)
    return f"| name | inputs | output, `Out` |\n| --- | --- | --- |\n{rows}"


def shown(type_: str) -> str:
    return f"Vector{type_[-1]}" if type_[-1].isdigit() else "Float"


def meta(path: str) -> str:
    """What Unity keeps beside each file and folder. In a package that it must not change, it ignores what has none."""
    guid = hashlib.md5(f"{NAME}/{path}".encode(), usedforsecurity=False).hexdigest()
    return f"fileFormatVersion: 2\nguid: {guid}\n"


def seen(paths: Iterable[str]) -> list[str]:
    """The files and folders that Unity imports; what ends in ~ it leaves alone."""
    found = set()
    for path in map(PurePosixPath, paths):
        for part in (path, *path.parents[:-1]):
            if not any(name.endswith("~") for name in part.parts):
                found.add(part.as_posix())
    return sorted(found)


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = {path.relative_to(PACKAGE).as_posix(): path.read_text(encoding="utf-8")
             for path in sorted(PACKAGE.rglob("*")) if path.is_file()}
    described = json.loads(found["package.json"])
    found["package.json"] = json.dumps({"name": NAME, "version": version(), **described}, indent=2) + "\n"
    found["README.md"] = found["README.md"].replace("<!-- nodes -->\n", table())
    found["LICENSE.md"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    for arithmetic, suffix in ARITHMETICS.items():
        found[f"Shaders/HashNoise{suffix}.hlsl"] = shader(arithmetic)
        found[f"Runtime/HashNoise{suffix}.cs"] = script(arithmetic)
    return found | {f"{path}.meta": meta(path) for path in seen(found)}
