"""Compute shaders that evaluate the rows of the suite at many points: what the tests run.

hn-conform has this package inside, and calls it with a file of JSON, a list of {"knobs": TEXT, "files": [NAME, ...],
"bodies": {NAME: TEXT}}. The answer is {"texts": [...], "groups": [{"shaders": {NAME: [numbers of texts]}}, or {"error": "why there are none"}]}.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from translate.parsing.tokens import Unknown
from translate.wgsl.module import NO_SETTINGS, Module

# What the bodies of the rows take for granted (tools/lib/catalog/tables/functions.py).
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


def evaluations(library: Path, knobs: str, files: Iterable[str], bodies: Mapping[str, str]) -> dict[str, list[str]]:
    """The shader of each body, by its name, in pieces: shaders have most of theirs in common. The knobs are lines of
    GLSL; what the bodies need besides may stand there, too."""
    numbers = {name: f"evaluate_{number}" for number, name in enumerate(bodies)}
    functions = [f"uvec4 {numbers[name]}(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {{ {body} }}\n"
                 for name, body in bodies.items()]
    includes = "".join(f'#include "{file}"\n' for file in files)
    module = Module(library, knobs + includes + PROLOGUE + "".join(functions), NO_SETTINGS, "rows")
    return {name: [*module.pieces([number], strip=True), EPILOGUE.replace("EVALUATE", number)]
            for name, number in numbers.items()}


def answered(library: Path, question: list[dict]) -> dict:
    texts: dict[str, int] = {}
    groups: list[dict] = []
    for group in question:
        try:
            found = evaluations(library, group["knobs"], group["files"], group["bodies"])
        except Unknown as error:
            groups.append({"error": str(error)})
            continue
        groups.append({"shaders": {name: [texts.setdefault(piece, len(texts)) for piece in pieces]
                                   for name, pieces in found.items()}})
    return {"texts": list(texts), "groups": groups}


def main() -> int:
    library, question, answer = map(Path, sys.argv[1:])
    answer.write_text(json.dumps(answered(library, json.loads(question.read_text(encoding="utf-8")))), encoding="utf-8")
    return 0
