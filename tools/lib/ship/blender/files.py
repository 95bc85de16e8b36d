"""The files of the add-on for Blender: what packages/blender/ has, and shaders that tools/pick writes."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

from base.tree import GLSL, ROOT, address, version
from catalog import parameters, popular
from catalog.tables.markdown import table
from ship.packing import Refused, papers
from translate.parsing.syntax import Function
from translate.pick.command import Choice, picker, read_library
from translate.pick.osl import default_of

PACKAGE = ROOT / "packages" / "blender"
MANIFEST = "blender_manifest.toml"
FORMS = popular.nodes("blender")  # of node groups, all with HN_FIXED


def shader(form: str) -> str:
    """The name of its file."""
    return form.removeprefix("hn_").removesuffix("_jitter")


@cache
def texts() -> dict[str, str]:
    """tools/pick's text of each form."""
    pick = picker()
    return {form: pick((form,), Choice("osl", "fixed")) for form in FORMS}


@cache
def functions() -> Mapping[str, Function]:
    return read_library(GLSL, Choice("osl", "fixed")).forms


def outputs(form: str) -> dict[str, str]:
    """The sockets of a node group, by their names, with types of GLSL."""
    if shader(form).startswith("cellular"):
        nodes = (PACKAGE / "nodes.py").read_text(encoding="utf-8")
        return dict.fromkeys(re.search(r'^DISTANCES = \("(\w+)", "(\w+)"\)', nodes, re.M).groups(), "float")
    return {"Value": functions()[form].type.removeprefix("hn_")}


def node_table() -> str:
    """The node groups, for the page."""
    sizes: dict[tuple[str, ...], list[str]] = {}
    for form in FORMS:
        function = functions()[form]
        name, size = re.fullmatch(r"(\w+)(\d)", shader(form)).groups()
        others = ", ".join(f"`{one.at.text.title()}`" for one in function.parameters if one.at.text != "p")
        kind = "; ".join(f"`{one}`, a {'number' if type_ == 'float' else 'vector'}"
                         for one, type_ in outputs(form).items())
        sizes.setdefault((name.replace("_", " "), others, kind), []).append(f"{size}D")
    return table(("noise", "there are", "inputs besides `Vector` and `Scale`", "outputs"),
                 [(name, ", ".join(of), others, kind) for (name, others, kind), of in sizes.items()])


def interface() -> Iterator[tuple[str, str]]:
    """The names that stay from 1.0 on, with their meaning: rows of conformance/expected/interface.csv."""
    for form in FORMS:
        for one in functions()[form].parameters:
            default = default_of(parameters.about(form, one.at.text, is_fixed=True), one.type)
            yield f"{shader(form)}.{one.at.text}", f"{one.type} {default}"
        yield from ((f"{shader(form)}.{name.lower()}", f"output {type_}") for name, type_ in outputs(form).items())
    yield "Scale", re.search(r"^SCALE = ([\d.]+)", (PACKAGE / "nodes.py").read_text(encoding="utf-8"), re.M)[1]


def wheel_file(path: Path) -> bytes:
    if not re.fullmatch(r"hashnoise-[\w.+]+(-[\w.]+){3}\.whl", path.name) or not zipfile.is_zipfile(path):
        raise Refused(f"{path} is no wheel of hashnoise; tools/pack python makes one")
    return path.read_bytes()


@cache
def package(wheel: str | None = None) -> dict[str, str | bytes]:
    """All files, by their paths, with a wheel of the Python package if that is named."""
    found: dict[str, str | bytes] = {path.name: path.read_text(encoding="utf-8")
                                     for path in sorted(PACKAGE.glob("*.py"))}
    manifest = (PACKAGE / MANIFEST).read_text(encoding="utf-8")
    found[MANIFEST] = manifest.replace("VERSION", version()).replace("ADDRESS", address())
    found |= papers(PACKAGE)
    found |= {f"shaders/{shader(form)}.osl": text for form, text in texts().items()}
    if wheel is not None:
        path = Path(wheel)
        found |= {f"wheels/{path.name}": wheel_file(path),
                  MANIFEST: f'{found[MANIFEST]}\nwheels = ["./wheels/{path.name}"]\n'}
    return found
