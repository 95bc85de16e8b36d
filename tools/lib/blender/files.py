"""The files of the add-on for Blender: what packages/blender/ has, and shaders that tools/pick writes."""

from __future__ import annotations

import re
from functools import cache

from packing import papers
from pick.command import Choice, picker, read_library
from pick.program import public
from tables.markdown import table
from tree import GLSL, ROOT, version

PACKAGE = ROOT / "packages" / "blender"
NAME = "hashnoise-blender"
MANIFEST = "blender_manifest.toml"
# What node groups are made of, all with HN_FIXED.
FORMS = ("hn_value2", "hn_value3", "hn_perlin2", "hn_perlin3", "hn_simplex2", "hn_simplex3", "hn_random2", "hn_random3",
         "hn_cellular2_full", "hn_cellular3_full", "hn_cell_border2", "hn_cell_border3", "hn_fbm2", "hn_fbm3",
         "hn_ridged2", "hn_ridged3", "hn_turbulence2", "hn_turbulence3", "hn_billow2", "hn_billow3", "hn_clouds2",
         "hn_clouds3", "hn_warp2", "hn_warp3")


def shader(form: str) -> str:
    """The name of its file."""
    return form.removeprefix("hn_").removesuffix("_full")


@cache
def texts() -> dict[str, str]:
    """What tools/pick writes of each form."""
    pick = picker()
    return {form: pick((form,), Choice("osl", "fixed")) for form in FORMS}


def node_table() -> str:
    """The node groups, for the page."""
    known = public(read_library(GLSL, Choice("osl", "fixed")))
    sizes: dict[tuple[str, ...], list[str]] = {}
    for form in FORMS:
        function = known[form]
        name, size = re.fullmatch(r"(\w+)(\d)", shader(form)).groups()
        others = ", ".join(f"`{one.at.text.title()}`" for one in function.parameters if one.at.text != "p")
        kind = "a number" if function.type == "float" else "a vector"
        sizes.setdefault((name.replace("_", " "), others, kind), []).append(f"{size}D")
    return table(("noise", "there are", "inputs besides `Vector` and `Scale`", "`Value`"),
                 [(name, ", ".join(of), others, kind) for (name, others, kind), of in sizes.items()])


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = {path.name: path.read_text(encoding="utf-8") for path in sorted(PACKAGE.glob("*.py"))}
    found[MANIFEST] = (PACKAGE / MANIFEST).read_text(encoding="utf-8").replace('"VERSION"', f'"{version()}"')
    return found | papers(PACKAGE) | {f"shaders/{shader(form)}.osl": text for form, text in texts().items()}
