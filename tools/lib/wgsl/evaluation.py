"""Compute shaders that evaluate the rows of functions.inc at many points: what the tests run."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from wgsl.module import Module, Settings

# What the bodies of the rows take for granted (conformance/library/functions.inc).
PROLOGUE = """#include "hashnoise.glsl"
#define float_of uintBitsToFloat
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


def evaluations(library: Path, bodies: Mapping[str, str], settings: Settings, macros: str = "") -> dict[str, list[str]]:
    """The shader of each body, by its name, in pieces: shaders have most of theirs in common."""
    numbers = {name: f"evaluate_{number}" for number, name in enumerate(bodies)}
    functions = [f"uvec4 {numbers[name]}(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {{ {body} }}\n"
                 for name, body in bodies.items()]
    module = Module(library, PROLOGUE + macros + "".join(functions), settings, "functions.inc")
    return {name: [*module.pieces([number]), EPILOGUE.replace("EVALUATE", number)] for name, number in numbers.items()}


def macros_of_rows(table: Path) -> str:
    """The macros that stand in the bodies of its rows as they are read: those of one line, which make no row."""
    lines = table.read_text(encoding="utf-8").split("\n")
    return "".join(f"{line}\n" for line in lines
                   if line.startswith("#define ") and not line.endswith("\\") and "FUNCTION(" not in line)
