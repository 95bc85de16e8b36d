"""Compute shaders that evaluate the rows of the suite at many points, with each setting that has values of them: what
the tests run.

    python3 -m translate.wgsl.evaluation FILE    writes them as JSON, which hn-conform has inside: {"texts": [...],
                                                 "shaders": {"SETTING ROW": [numbers of texts]}, "knobs": {SETTING: TEXT}}
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from base.tree import GLSL
from catalog.tables.configurations import Configuration, read_configurations
from catalog.tables.functions import read_functions
from translate.settings import NO_SETTINGS
from translate.wgsl.module import Module

# Definitions that the bodies of the rows use (tools/lib/catalog/tables/functions.py).
PROLOGUE = """#define float_of uintBitsToFloat
#define bits_of floatBitsToUint
#define SEEDED(s) , s
#define SEED(s) s
"""
GROUP = 64  # invocations
# Four vectors of words go in for each point, and one comes out.
EPILOGUE = f"""
@group(0) @binding(0) var<storage, read> inputs: array<vec4u>;
@group(0) @binding(1) var<storage, read_write> outputs: array<vec4u>;

@compute @workgroup_size({GROUP})
fn main(@builtin(global_invocation_id) id: vec3u) {{
  let i = id.x;
  if (i < arrayLength(&outputs)) {{
    outputs[i] = EVALUATE(inputs[4u * i], inputs[4u * i + 1u], inputs[4u * i + 2u], inputs[4u * i + 3u]);
  }}
}}
"""


def module_over(knobs: str, bodies: Mapping[str, str], files: Iterable[str] = ("hashnoise.glsl",),
                library: Path = GLSL) -> tuple[Module, dict[str, str]]:
    """The library with a function for each body, and its name by the body's. The knobs are lines of GLSL; what
    the bodies need besides may stand there, too."""
    numbers = {name: f"evaluate_{number}" for number, name in enumerate(bodies)}
    functions = (f"uvec4 {numbers[name]}(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {{ {body} }}\n"
                 for name, body in bodies.items())
    text = "".join([knobs, *(f'#include "{file}"\n' for file in files), PROLOGUE, *functions])
    return Module(library, text, NO_SETTINGS, "rows"), numbers


def evaluations(library: Path, knobs: str, files: Iterable[str], bodies: Mapping[str, str]) -> dict[str, list[str]]:
    """The shader of each body, by its name, in pieces: shaders have most of theirs in common."""
    module, numbers = module_over(knobs, bodies, files, library)
    return {name: [*module.pieces([number], strip=True), EPILOGUE.replace("EVALUATE", number)]
            for name, number in numbers.items()}


def knobs(configuration: Configuration) -> str:
    """The lines that select a setting, as the suite has them (conformance/library/configurations.cpp)."""
    lines = (f"#define {macro.replace('=', ' ')}\n" for macro in configuration.macros)
    own = "#define HN_HASH_FN(k) (((k) ^ ((k) >> 16u)) * 0x045D9F3Bu)\n" * (configuration.hash == "custom")
    return "".join(lines) + own


def embedded() -> dict:
    """The shaders of all rows with all settings that have values in WGSL, which has no HN_PRECISE. A text that several
    have is there once."""
    texts: dict[str, int] = {}
    found: dict[str, list[int]] = {}
    settings = {one.name: one for one in read_configurations() if one.arithmetic != "precise"}
    for setting, configuration in settings.items():
        rows = [row for row in read_functions() if configuration.covers(row)]
        shaders = evaluations(GLSL, knobs(configuration), ("hashnoise.glsl", "self_check.glsl"),
                              {row.id: row.body for row in rows})
        found |= {f"{setting} {row}": [texts.setdefault(piece, len(texts)) for piece in pieces]
                  for row, pieces in shaders.items()}
    return {"texts": list(texts), "shaders": found, "knobs": {name: knobs(one) for name, one in settings.items()}}


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(embedded()), encoding="ascii")
