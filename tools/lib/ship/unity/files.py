"""The files of the package for Unity: what tools/pick writes in HLSL and C#, and nodes of Shader Graph."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import PurePosixPath

from base.tree import ROOT, address, version
from ship.hlsl_nodes import ARITHMETICS, FORMS, NODES, PORTS, call, forms, picked, ports, shader, title
from ship.packing import of_npm, own_files
from ship.page import of_package
from ship.unity.subgraphs import NAME, file, own_guid, subgraph
from translate.pick.scalars import bare

PACKAGE = ROOT / "packages" / "unity"
# C# has slopes, too, for normals, and exact places.
SCRIPTS = (*FORMS, "hn_place_in_cell2", "hn_perlin_d2", "hn_simplex_d2", "hn_fbm_d2")


def node(form: str, arithmetic: str) -> str:
    """The functions of a node, in the precisions that Shader Graph has. A half does not hold positions and seeds whose bits
    are the same everywhere."""
    called = title(form, arithmetic)
    type_, taken = PORTS[forms()[form].type], ports(form)
    declared = ", ".join(f"{of} {name}" for of, name in taken)
    passed = ", ".join(name for _, name in taken)
    of_floats = f"void {called}_float({declared}, out {type_} Out) {{\n  Out = {call(form, arithmetic)};\n}}\n"
    if arithmetic == "fixed":
        return of_floats
    return (f"{of_floats}void {called}_half({declared.replace('float', 'half')}, out {type_.replace('float', 'half')} Out) {{\n"
            f"  {type_} n;\n  {called}_float({passed}, n);\n  Out = n;\n}}\n")


def graph(arithmetic: str) -> str:
    guard = f"HASH_NOISE{'_FIXED' if ARITHMETICS[arithmetic] else ''}_HLSL"
    nodes = "".join(node(form, arithmetic) for form in NODES)
    return (f"#ifndef {guard}\n#define {guard}\n\n{shader(arithmetic)}\n"
            f"// For Custom Function nodes of Shader Graph.\n{nodes}\n#endif\n")


def script(arithmetic: str) -> str:
    """A class in the package's namespace. tools/pick writes it into none, since it is for files of a user."""
    head, pragma, class_ = picked(SCRIPTS, "csharp", arithmetic).partition("#pragma warning disable 1591\n")
    return f"{head}{pragma}\nnamespace Hashnoise {{{class_}}}\n"


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    return ((bare(form), "") for form in SCRIPTS)


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
    return f"fileFormatVersion: 2\nguid: {own_guid(path)}\n{OF_FOLDER if is_folder else ''}"


def seen(paths: Iterable[str]) -> list[str]:
    """The files and folders that Unity imports, and those that it copies from a folder that ends in ~ with their GUIDs."""
    found = set()
    for path in map(PurePosixPath, paths):
        for part in (path, *list(path.parents)[:-1]):
            if not part.name.endswith("~"):
                found.add(part.as_posix())
    return sorted(found)


def links() -> dict[str, str]:
    """For Unity's Package Manager, which takes addresses alone."""
    at = f"{address()}/blob/v{version()}"
    return {"documentationUrl": f"{at}/packages/unity/README.md", "changelogUrl": f"{at}/CHANGELOG.md"} if address() else {}


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = own_files(PACKAGE)
    found["package.json"] = json.dumps({**json.loads(of_npm(found["package.json"], NAME)), **links()}, indent=2) + "\n"
    found["LICENSE.md"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    found["CHANGELOG.md"] = of_package(ROOT / "CHANGELOG.md")
    for arithmetic, suffix in ARITHMETICS.items():
        found[f"Shaders/HashNoise{suffix}.hlsl"] = graph(arithmetic)
        found[f"Runtime/HashNoise{suffix}.cs"] = script(arithmetic)
        found |= {file(form, arithmetic): subgraph(form, arithmetic) for form in NODES}
    return found | {f"{path}.meta": meta(path, path not in found) for path in seen(found)}
