"""The files of the plugin for Unreal: what tools/pick writes in HLSL, and the text of custom nodes."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache

from base.tree import ROOT, address, version
from catalog.tables.markdown import table
from ship.hlsl_nodes import ARITHMETICS, NODES, PORTS, call, forms, ports, shader
from ship.packing import Refused, own_files
from translate.pick.scalars import bare

PACKAGE = ROOT / "packages" / "unreal"
DESCRIPTION = "HashNoise.uplugin"


def code(form: str, arithmetic: str = "fast") -> str:
    """The text of a custom node."""
    return f"return {call(form, arithmetic)};"


def output(form: str) -> str:
    type_ = PORTS[forms()[form].type]
    return f"CMOT Float {type_[-1] if type_[-1].isdigit() else 1}"


def node_table() -> str:
    """The nodes, for the page. HLSL has one name in 2D and in 3D."""
    sizes: dict[tuple[str, str], list[str]] = {}
    types: dict[tuple[str, str], list[str]] = {}
    for form in NODES:
        key = code(form), ", ".join(f"`{name}`" for _, name in ports(form))
        sizes.setdefault(key, []).append(ports(form)[0][0][-1])
        types.setdefault(key, []).append(output(form))
    return table(("Code", "Inputs", "Components of Position", "Output Type"),
                 [(f"`{key[0]}`", key[1], " or ".join(of), " or ".join(dict.fromkeys(types[key])))
                  for key, of in sizes.items()])


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    return ((f"{bare(form)} {arithmetic}", f"{code(form, arithmetic)} {output(form)}")
            for form in NODES for arithmetic in ARITHMETICS)


@cache
def package(engine: str | None = None) -> dict[str, str]:
    """All files, by their paths. Fab wants a zip file for each version of the engine."""
    if engine is not None and not re.fullmatch(r"5\.\d+", engine):
        raise Refused(f"--engine {engine}: write a version of Unreal such as 5.6")
    found = own_files(PACKAGE)
    own = {"VersionName": version()} | ({"CreatedByURL": address()} if address() else {}) | (
        {"EngineVersion": f"{engine}.0"} if engine else {})
    found[DESCRIPTION] = json.dumps({**json.loads(found[DESCRIPTION]), **own}, indent=2) + "\n"
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    for arithmetic, suffix in ARITHMETICS.items():
        found[f"Shaders/HashNoise{suffix}.ush"] = shader(arithmetic)
    return found
