"""The files of the package for Unity: what tools/pick writes in HLSL and C#, and functions for nodes of Shader Graph."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import PurePosixPath

from base.tree import ROOT
from catalog.tables.markdown import table
from ship.hlsl_nodes import ARITHMETICS, FORMS, NODES, PORTS, call, camel, forms, picked, ports, shader
from ship.packing import of_npm, own_files
from ship.page import of_package
from ship.recipes import RECIPES
from translate.pick.scalars import bare

PACKAGE = ROOT / "packages" / "unity"
NAME = RECIPES["unity"].name
# C# has slopes, too, for normals, and exact places.
SCRIPTS = (*FORMS, "hn_place_in_cell2", "hn_perlin_d2", "hn_simplex_d2", "hn_fbm_d2")


def node(form: str, arithmetic: str) -> str:
    """The functions of a node, in the precisions that Shader Graph has. A half does not hold positions and seeds whose bits
    are the same everywhere."""
    title = f"HashNoise{ARITHMETICS[arithmetic]}{camel(form)}"
    type_, taken = PORTS[forms()[form].type], ports(form)
    declared = ", ".join(f"{of} {name}" for of, name in taken)
    passed = ", ".join(name for _, name in taken)
    of_floats = f"void {title}_float({declared}, out {type_} Out) {{\n  Out = {call(form, arithmetic)};\n}}\n"
    if arithmetic == "fixed":
        return of_floats
    return (f"{of_floats}void {title}_half({declared.replace('float', 'half')}, out {type_.replace('float', 'half')} Out) {{\n"
            f"  {type_} n;\n  {title}_float({passed}, n);\n  Out = n;\n}}\n")


def graph(arithmetic: str) -> str:
    guard = f"HASH_NOISE{'_FIXED' if ARITHMETICS[arithmetic] else ''}_HLSL"
    nodes = "".join(node(form, arithmetic) for form in NODES)
    return (f"#ifndef {guard}\n#define {guard}\n\n{shader(arithmetic)}\n"
            f"// For Custom Function nodes of Shader Graph.\n{nodes}\n#endif\n")


def script(arithmetic: str) -> str:
    return picked(SCRIPTS, "csharp", arithmetic)


def node_table() -> str:
    return table(("name", "inputs", "output, `Out`"),
                 [(f"`HashNoise{camel(form)}`", ", ".join(f"{name} ({shown(of)})" for of, name in ports(form)),
                   shown(PORTS[forms()[form].type])) for form in NODES])


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    return ((bare(form), "") for form in SCRIPTS)


def shown(type_: str) -> str:
    return f"Vector{type_[-1]}" if type_[-1].isdigit() else "Float"


# As Unity writes it, with blanks behind colons. It writes nothing into a package that it must not change.
OF_FOLDER = """folderAsset: yes
DefaultImporter:
  externalObjects: {}
  userData:\x20
  assetBundleName:\x20
  assetBundleVariant:\x20
"""


def meta(path: str, is_folder: bool) -> str:
    """Unity's file beside each file and folder. In a package that it must not change, it ignores files without one."""
    guid = hashlib.md5(f"{NAME}/{path}".encode(), usedforsecurity=False).hexdigest()
    return f"fileFormatVersion: 2\nguid: {guid}\n{OF_FOLDER if is_folder else ''}"


def seen(paths: Iterable[str]) -> list[str]:
    """The files and folders that Unity imports; what ends in ~ it leaves alone."""
    found = set()
    for path in map(PurePosixPath, paths):
        for part in (path, *list(path.parents)[:-1]):
            if not any(name.endswith("~") for name in part.parts):
                found.add(part.as_posix())
    return sorted(found)


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = own_files(PACKAGE)
    found["package.json"] = of_npm(found["package.json"], NAME)
    found["LICENSE.md"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    found["CHANGELOG.md"] = of_package(ROOT / "CHANGELOG.md")
    for arithmetic, suffix in ARITHMETICS.items():
        found[f"Shaders/HashNoise{suffix}.hlsl"] = graph(arithmetic)
        found[f"Runtime/HashNoise{suffix}.cs"] = script(arithmetic)
    return found | {f"{path}.meta": meta(path, path not in found) for path in seen(found)}
