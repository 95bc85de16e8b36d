"""The files of the add-on for Blender: what packages/blender/ has, and shaders that tools/pick writes."""

from __future__ import annotations

import ast
import re
import zipfile
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

from base.tree import GLSL, ROOT, address, version
from catalog import parameters, popular
from catalog.model import AXES
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
    return popular.ENDS.sub("", form.removeprefix("hn_"))


@cache
def texts() -> dict[str, str]:
    """tools/pick's text of each form."""
    pick = picker()
    return {form: pick((form,), Choice("osl", "fixed")) for form in FORMS}


@cache
def functions() -> Mapping[str, Function]:
    return read_library(GLSL, Choice("osl", "fixed")).forms


def inputs(form: str) -> list[tuple[str, str]]:
    """The parameters behind the position, and their types: one of OSL has no components, so a vector is several."""
    return [(name, type_) for one in functions()[form].parameters if one.at.text != "p"
            for name, type_ in ([(f"{one.at.text}_{axis}", "float") for axis in AXES[:int(one.type[-1])]]
                                if one.type.startswith("vec") else [(one.at.text, one.type)])]


def outputs(form: str) -> dict[str, str]:
    """The sockets of a node group, by their names, with types of GLSL."""
    pairs = re.search(r"^PAIRS = (.*})", (PACKAGE / "nodes.py").read_text(encoding="utf-8"), re.M)[1]
    if pair := ast.literal_eval(pairs).get(shader(form)[:-1]):
        return dict.fromkeys(pair, "float")
    return {"Value": functions()[form].type.removeprefix("hn_")}


def node_table() -> str:
    """The node groups, for the page."""
    sizes: dict[tuple[str, ...], list[str]] = {}
    for form in FORMS:
        name, size = re.fullmatch(r"(\w+)(\d)", shader(form)).groups()
        others = ", ".join(f"`{input_.replace('_', ' ').title()}`" for input_, _ in inputs(form))
        kind = "; ".join(f"`{one}`, a {'number' if type_ == 'float' else 'vector'}"
                         for one, type_ in outputs(form).items())
        sizes.setdefault((name.replace("_", " "), others, kind), []).append(f"{size}D")
    return table(("noise", "there are", "inputs besides `Vector` and `Scale`", "outputs"),
                 [(name, ", ".join(of), others, kind) for (name, others, kind), of in sizes.items()])


def interface() -> Iterator[tuple[str, str]]:
    """The names that stay from 1.0 on, with their meaning: rows of conformance/expected/interface.csv."""
    for form in FORMS:
        position = functions()[form].parameters[0]
        for name, type_ in ((position.at.text, position.type), *inputs(form)):
            yield f"{shader(form)}.{name}", f"{type_} {default_of(parameters.about(form, name, is_fixed=True), type_)}"
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
    website = f'website = "{address()}"\n' if address() else ""
    found[MANIFEST] = manifest.replace("VERSION", version()).replace('website = "ADDRESS"\n', website)
    found |= papers(PACKAGE)
    found |= {f"shaders/{shader(form)}.osl": text for form, text in texts().items()}
    if wheel is not None:
        path = Path(wheel)
        found |= {f"wheels/{path.name}": wheel_file(path),
                  MANIFEST: f'{found[MANIFEST]}\nwheels = ["./wheels/{path.name}"]\n'}
    return found
