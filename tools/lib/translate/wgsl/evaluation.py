"""Compute shaders that evaluate the rows of the suite at many points, with each setting that has values of them: what
the tests run.

    python3 -m translate.wgsl.evaluation BUGS FILE    writes them as JSON, which hn-conform has inside: {"texts": [...],
                                                      "shaders": {"SETTING ROW": [numbers of texts]}, "knobs": {SETTING:
                                                      TEXT}}; BUGS prints the rows of bugs (conformance/web/bug_rows.cpp)
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from base.tree import GLSL
from catalog.tables.configurations import Configuration, read_configurations
from catalog.tables.functions import read_functions
from translate.parsing.tokens import Unknown
from translate.settings import NO_SETTINGS
from translate.wgsl.module import Module
from translate.wgsl.wgpu_program import GROUP
from translate.wgsl.writer import FunctionWriter, RowWriter

# Definitions that the bodies of the rows use (tools/lib/catalog/tables/functions.py).
PROLOGUE = """#define float_of uintBitsToFloat
#define bits_of floatBitsToUint
#define SEEDED(s) , s
#define SEED(s) s
"""
# Four vectors of words go in for each point, and one comes out.
EPILOGUE = f"""
@group(0) @binding(0) var<storage, read_write> outputs: array<vec4u>;
@group(0) @binding(1) var<storage, read> inputs: array<vec4u>;

@compute @workgroup_size({GROUP})
fn main(@builtin(global_invocation_id) id: vec3u) {{
  let i = id.x;
  if (i < arrayLength(&outputs)) {{
    outputs[i] = EVALUATE(inputs[4u * i], inputs[4u * i + 1u], inputs[4u * i + 2u], inputs[4u * i + 3u]);
  }}
}}
"""


def module_over(knobs: str, bodies: Mapping[str, str], files: Iterable[str] = ("hashnoise.glsl",),
                library: Path = GLSL, writer: type[FunctionWriter] = FunctionWriter) -> tuple[Module, dict[str, str]]:
    """The library with a function for each body, and its name by the body's. The knobs are lines of GLSL; what
    the bodies need besides may stand there, too."""
    numbers = {name: f"evaluate_{number}" for number, name in enumerate(bodies)}
    functions = (f"uvec4 {numbers[name]}(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {{ {body} }}\n"
                 for name, body in bodies.items())
    text = "".join([knobs, *(f'#include "{file}"\n' for file in files), PROLOGUE, *functions])
    return Module(library, text, NO_SETTINGS, "rows", writer), numbers


def evaluations(library: Path, knobs: str, files: Iterable[str], bodies: Mapping[str, str],
                writer: type[FunctionWriter] = FunctionWriter) -> dict[str, list[str]]:
    """The shader of each body, by its name, in pieces: shaders have most of theirs in common."""
    module, numbers = module_over(knobs, bodies, files, library, writer)
    return {name: [*module.pieces([number], strip=True), EPILOGUE.replace("EVALUATE", number)]
            for name, number in numbers.items()}


def shader_of_bug(bug: Mapping[str, str]) -> list[str]:
    """A translation of its GLSL, or its own text; with names of types that old translators know, too."""
    return [re.sub(r"\bvec([234])([fiu])\b", lambda found: f"vec{found[1]}<{found[2]}32>", piece)
            for piece in _shader_of_bug(bug)]


def _shader_of_bug(bug: Mapping[str, str]) -> list[str]:
    if wgsl := bug.get("wgsl"):
        head = "fn evaluate(a: vec4u, b: vec4u, c: vec4u, d: vec4u) -> vec4u"
        return [f"{bug['wgsl_declarations']}{head} {{\n{wgsl}\n}}\n", EPILOGUE.replace("EVALUATE", "evaluate")]
    text = f'#include "config.glsl"\n{bug["declarations"]}'
    try:
        return evaluations(GLSL, text, (), {bug["id"]: bug["body"]}, RowWriter)[bug["id"]]
    except Unknown as why:
        raise Unknown(f"{bug['id']} has wgsl among its profiles: {why}") from None


def knobs(configuration: Configuration) -> str:
    """The lines that select a setting, as the suite has them (conformance/library/configurations.cpp)."""
    lines = (f"#define {macro.replace('=', ' ')}\n" for macro in configuration.macros)
    own = "#define HN_HASH_FN(k) (((k) ^ ((k) >> 16u)) * 0x045D9F3Bu)\n" * (configuration.hash == "custom")
    return "".join(lines) + own


def embedded(bugs: Iterable[Mapping[str, str]]) -> dict:
    """The shaders of all bugs, and of all rows with all settings that have values in WGSL, which has no HN_PRECISE. A
    text that several have is there once."""
    texts: dict[str, int] = {}
    found: dict[str, list[int]] = {}
    settings = {one.name: one for one in read_configurations() if one.arithmetic != "precise"}
    for setting, configuration in settings.items():
        rows = [row for row in read_functions() if configuration.covers(row)]
        shaders = evaluations(GLSL, knobs(configuration), ("hashnoise.glsl", "self_check.glsl"),
                              {row.id: row.body for row in rows})
        found |= {f"{setting} {row}": [texts.setdefault(piece, len(texts)) for piece in pieces]
                  for row, pieces in shaders.items()}
    for bug in bugs:
        found[f"lattice {bug['id']}"] = [texts.setdefault(piece, len(texts)) for piece in shader_of_bug(bug)]
    return {"texts": list(texts), "shaders": found, "knobs": {name: knobs(one) for name, one in settings.items()}}


if __name__ == "__main__":
    rows = subprocess.run([sys.argv[1]], capture_output=True, check=True).stdout
    Path(sys.argv[2]).write_text(json.dumps(embedded(json.loads(rows))), encoding="ascii")
