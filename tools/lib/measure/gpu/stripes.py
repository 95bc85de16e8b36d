"""Other libraries' stripes and gullies beside ours, whose cost the compilers alone count.

Two of their files are no GLSL that an expression can stand behind: one is C#, and one is a whole shader. The text
compiled is made of them each time, in a folder that goes away.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from measure.peers import Call, Peer, subject

PEERS = (
    Peer("terrain-erosion", "AdvancedTerrainErosion.cs", "AdvancedTerrainErosion", ""),
    Peer("phasor-noise", "phasor.frag of PhasorNoise", "PhasorNoise", ""),
    Peer("clay-john", "a file with Clay John's erosion, such as erosion2D.glsl of cflake-engine", "Clay John's", ""),
)

# Octaves, lacunarity and gain are those of our row of bench. The other numbers are those of its own example. The
# ridges, which it returns as well, are not used, so that compilers leave them out.
FIVE_OCTAVES = ("p, vec3(0.0, p), 0.0, 0.22, 0.5, 1.5, vec4(0.1, 0.0, 0.1, 2.0), vec4(1.25, 1.25, 2.8, 1.5), "
                "vec2(0.7, 1.0), 0.15, 5, 2.0, 0.5, 0.7, 0.5, 0, hn_bench_set.w")
CALLS = (
    Call("stripes 2D", "noise2d.phasor", "terrain-erosion", "",
         "dot(PhacelleNoise(p, p, 1.0, p.x, 0.5, 0).xy, vec2(1.0))"),
    # With as many waves as its own program has: 16 and one more in each of 25 cells.
    Call("stripes 2D", "noise2d.phasor", "phasor-noise", "",
         "(_f = p.x, _o = p.y, _b = 1.0, _impPerKernel = 16, init_noise(), dot(phasor_noise(p), vec2(1.0)))"),
    Call("stripes 2D with derivatives", "noise2d.phasor_d", "clay-john", "", "dot(erosion(p, p), vec3(1.0))"),
    Call("gullies 2D, 5 octaves", "noise2d.gullies", "terrain-erosion", "",
         f"dot(ErosionFilter({FIVE_OCTAVES}).xyz, vec3(1.0))"),
)

# The regions of the C# that are taken, in this order.
REGIONS = ("Precision helper constants", "Common shader-style helpers", "Core algorithms")
# Types that C# leaves to its compiler. All others are floats.
TYPES = {**dict.fromkeys(("i", "j"), "int"),
         **dict.fromkeys(("gullySlope", "sideDir", "pInt", "pFrac", "gridOffset", "gridPoint", "randomOffset",
                          "vectorFromCellPoint", "interpolated", "k", "seedOffset", "inner"), "vec2"),
         **dict.fromkeys(("inputHeightAndSlope", "gullies", "fadedGullies", "heightAndSlopeDelta"), "vec3"),
         "phacelle": "vec4"}
# Functions of Unity's library that GLSL lacks, or names otherwise.
UNITY = """#define lerp mix
#define frac fract
#define PI_DBL 3.14159265358979
#define TAU_DBL 6.28318530717959
vec2 normalizesafe(vec2 v) { return dot(v, v) > 1.2e-38 ? v * inversesqrt(dot(v, v)) : vec2(0.0); }
"""
CSHARP = (
    (r"//.*", ""),
    (r"\[MethodImpl.*\]", ""),
    (r"\b(?:private|public|static|readonly)\s", ""),
    (r"\(real\)|\bmath\.", ""),
    (r"\breal\b", "float"),
    (r"(vec\d) (\w+) = new\(", r"\1 \2 = \1("),
    (r"\bnew (?=vec)", ""),
    (r"(vec\d) (\w+) = R0;", r"\1 \2 = \1(R0);"),
)
FUNCTION = re.compile(r"^\s*((?:float|vec\d) \w+\([^{;]*?\))\s*\{", re.MULTILINE)


def of_csharp(text: str) -> str:
    parts = []
    for name in REGIONS:
        region = re.search(rf"#region {name}\n(.*?)#endregion", text, re.DOTALL)
        if region is None:
            raise ValueError(f"it has no region {name!r}")
        parts.append(region[1])
    found = "".join(parts)
    for pattern, right in CSHARP:
        found = re.sub(pattern, right, found)
    found = re.sub(r"\bvar (\w+)", lambda name: f"{TYPES.get(name[1], 'float')} {name[1]}", found)
    # C# lets a function stand below those that call it.
    return UNITY + "".join(f"{head};\n" for head in FUNCTION.findall(found)) + found


def of_shader(text: str) -> str:
    """The text above its main function, with variables in place of its uniforms, which the expression sets."""
    above, main, _ = text.partition("void main()")
    found, count = re.subn(r"layout\s*\([^)]*\)\s*uniform \w+\s*\{([^}]*)\};", r"\1", above)
    if not main or not count:
        raise ValueError("it is no shader with uniforms in a block")
    return re.sub(r"layout\s*\([^)]*\)\s*(?:in|out) [^;]*;", "", found)


ADAPTERS = {"terrain-erosion": of_csharp, "phasor-noise": of_shader}


def adapted(peer: str, path: Path, folder: Path) -> Path:
    if peer not in ADAPTERS:
        return path
    try:
        text = ADAPTERS[peer](path.read_text(encoding="utf-8-sig"))
    except ValueError as error:
        raise ValueError(f"--{peer} {path}: {error}") from error
    made = folder / f"{peer}.glsl"
    made.write_text(text, encoding="utf-8")
    return made


def against(paths: Mapping[str, Path], folder: Path) -> list[str]:
    """Arguments of --against for the calls of the peers at these paths. Made files go there."""
    files = {peer: adapted(peer, path, folder) for peer, path in paths.items()}
    return [f"{subject(call)}={files[call.peer]}:{call.expression}" for call in CALLS if call.peer in files]
