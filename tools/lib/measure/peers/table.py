"""Other libraries' noise beside ours: how bench calls it, and where it stands in the table of
docs/measured/measuring.md."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple


class Peer(NamedTuple):
    option: str  # of tools/measure peers
    what: str  # of its value, for help
    title: str  # in the table
    version: str  # of GLSL, if 3.30 will not do


class Call(NamedTuple):
    noise: str  # the row of the table
    ours: str  # the subject of bench
    peer: str  # the option of the peer
    file: str  # below the path that is given
    expression: str  # of a position p, a float


PEERS = (
    Peer("fastnoiselite", "FastNoiseLite.glsl", "FastNoiseLite", "420"),
    Peer("wombat", "the folder of Wombat", "Wombat", ""),
    Peer("materialx", "the folder libraries/stdlib/genglsl/lib of MaterialX", "MaterialX", ""),
    Peer("webgl-noise", "the folder src of webgl-noise", "webgl-noise", ""),
    Peer("psrdnoise", "the folder src of psrdnoise", "psrdnoise", ""),
)
# No cost of these is measured, only what they look like.
OTHERS = (Peer("lygia", "the folder of lygia", "lygia", ""),
          Peer("glsl-noise", "the folder of glsl-noise, from npm", "glsl-noise", ""))

# FastNoiseLite's state: Perlin noise with the frequency 1, then octaves, lacunarity, gain, the strengths of weighted
# and of ping-pong sums, and what only cells and warps use.
SIX_OCTAVES = ("fnl_state(0, 1.0, FNL_NOISE_PERLIN, FNL_ROTATION_NONE, FNL_FRACTAL_NONE, 6, 2.0, 0.5, 0.0, 2.0, 0, 0, 1.0, "
               "0, 1.0)")


# Its warps move p, and return it. Their vectors are those of a grid, as ours are.
def _warped(kind: str, axes: str) -> str:
    state = SIX_OCTAVES.removesuffix("0, 1.0)") + "FNL_DOMAIN_WARP_BASICGRID, 1.0)"
    moved = [f"hn_bench_set.{axis}" for axis in axes]
    start = ", ".join([f"p.{axis}" for axis in axes] + ["0.0"] * (4 - len(axes)))
    return (f"(hn_bench_set = vec4({start}), _fnlDomainWarpFractal{kind}{len(axes)}D({state}, {', '.join(moved)}), "
            f"{' + '.join(moved)})")


# The parts of a vector are added up, as bench does with those of ours.
CALLS = (
    Call("Perlin 2D", "noise2d.perlin", "fastnoiselite", "", "_fnlSinglePerlin2D(0, p.x, p.y)"),
    Call("Perlin 3D", "noise3d.perlin", "fastnoiselite", "", "_fnlSinglePerlin3D(0, p.x, p.y, p.z)"),
    Call("Perlin 2D", "noise2d.perlin", "wombat", "Perlin2D.glsl", "Perlin2D(p)"),
    Call("Perlin 3D", "noise3d.perlin", "wombat", "Perlin3D.glsl", "Perlin3D(p)"),
    Call("Perlin 4D", "noise4d.perlin", "wombat", "Perlin4D.glsl", "Perlin4D(vec4(p, p.x))"),
    Call("Perlin 2D", "noise2d.perlin", "materialx", "mx_noise.glsl", "mx_perlin_noise_float(p)"),
    Call("Perlin 3D", "noise3d.perlin", "materialx", "mx_noise.glsl", "mx_perlin_noise_float(p)"),
    Call("Perlin 2D with derivatives", "noise2d.perlin_d", "wombat", "Perlin2D_Deriv.glsl",
         "dot(Perlin2D_Deriv(p), vec3(1.0))"),
    Call("Perlin 3D with derivatives", "noise3d.perlin_d", "wombat", "Perlin3D_Deriv.glsl",
         "dot(Perlin3D_Deriv(p), vec4(1.0))"),
    Call("value 2D", "noise2d.value", "fastnoiselite", "", "_fnlSingleValue2D(0, p.x, p.y)"),
    Call("value 3D", "noise3d.value", "fastnoiselite", "", "_fnlSingleValue3D(0, p.x, p.y, p.z)"),
    Call("value 2D", "noise2d.value", "wombat", "Value2D.glsl", "Value2D(p)"),
    Call("value 3D", "noise3d.value", "wombat", "Value3D.glsl", "Value3D(p)"),
    Call("value 4D", "noise4d.value", "wombat", "Value4D.glsl", "Value4D(vec4(p, p.x))"),
    Call("value 2D with derivatives", "noise2d.value_d", "wombat", "Value2D_Deriv.glsl",
         "dot(Value2D_Deriv(p), vec3(1.0))"),
    Call("value 3D with derivatives", "noise3d.value_d", "wombat", "Value3D_Deriv.glsl",
         "dot(Value3D_Deriv(p), vec4(1.0))"),
    Call("cubic value 2D", "noise2d.value_cubic", "fastnoiselite", "", "_fnlSingleValueCubic2D(0, p.x, p.y)"),
    Call("cubic value 3D", "noise3d.value_cubic", "fastnoiselite", "", "_fnlSingleValueCubic3D(0, p.x, p.y, p.z)"),
    Call("simplex 2D", "noise2d.simplex", "fastnoiselite", "", "_fnlSingleSimplex2D(0, p.x, p.y)"),
    Call("simplex 3D", "noise3d.simplex", "fastnoiselite", "", "_fnlSingleOpenSimplex23D(0, p.x, p.y, p.z)"),
    Call("simplex 2D", "noise2d.simplex", "wombat", "SimplexPerlin2D.glsl", "SimplexPerlin2D(p)"),
    Call("simplex 3D", "noise3d.simplex", "wombat", "SimplexPerlin3D.glsl", "SimplexPerlin3D(p)"),
    Call("simplex 2D", "noise2d.simplex", "webgl-noise", "noise2D.glsl", "snoise(p)"),
    Call("simplex 3D", "noise3d.simplex", "webgl-noise", "noise3D.glsl", "snoise(p)"),
    Call("simplex 4D", "noise4d.simplex", "webgl-noise", "noise4D.glsl", "snoise(vec4(p, p.x))"),
    Call("simplex 2D with derivatives", "noise2d.simplex_d", "wombat", "SimplexPerlin2D_Deriv.glsl",
         "dot(SimplexPerlin2D_Deriv(p), vec3(1.0))"),
    Call("simplex 3D with derivatives", "noise3d.simplex_d", "wombat", "SimplexPerlin3D_Deriv.glsl",
         "dot(SimplexPerlin3D_Deriv(p), vec4(1.0))"),
    Call("smooth simplex 2D", "noise2d.simplex_smooth", "fastnoiselite", "", "_fnlSingleOpenSimplex2S2D(0, p.x, p.y)"),
    Call("smooth simplex 3D", "noise3d.simplex_smooth", "fastnoiselite", "",
         "_fnlSingleOpenSimplex2S3D(0, p.x, p.y, p.z)"),
    # Its own default: the nearest distance, squared. The result is chosen at run time, so both are computed.
    Call("cellular 2D", "noise2d.cellular", "fastnoiselite", "", "_fnlSingleCellular2D(fnlCreateState(0), 0, p.x, p.y)"),
    Call("cellular 3D", "noise3d.cellular", "fastnoiselite", "",
         "_fnlSingleCellular3D(fnlCreateState(0), 0, p.x, p.y, p.z)"),
    Call("cellular 2D", "noise2d.cellular", "wombat", "Cellular2D.glsl", "Cellular2D(p)"),
    Call("cellular 3D", "noise3d.cellular", "wombat", "Cellular3D.glsl", "Cellular3D(p)"),
    Call("cellular 2D", "noise2d.cellular", "materialx", "mx_noise.glsl",
         "dot(mx_worley_noise_vec2(p, 1.0, 0, 0), vec2(1.0))"),
    Call("cellular 3D", "noise3d.cellular", "materialx", "mx_noise.glsl",
         "dot(mx_worley_noise_vec2(p, 1.0, 0, 0), vec2(1.0))"),
    Call("cellular 2D", "noise2d.cellular", "webgl-noise", "cellular2D.glsl", "dot(cellular(p), vec2(1.0))"),
    Call("cellular 3D", "noise3d.cellular", "webgl-noise", "cellular3D.glsl", "dot(cellular(p), vec2(1.0))"),
    Call("fBm 2D, 6 octaves", "fbm.fbm2", "fastnoiselite", "", f"_fnlGenFractalFBM2D({SIX_OCTAVES}, p.x, p.y)"),
    Call("fBm 3D, 6 octaves", "fbm.fbm3", "fastnoiselite", "", f"_fnlGenFractalFBM3D({SIX_OCTAVES}, p.x, p.y, p.z)"),
    Call("fBm 2D, 6 octaves", "fbm.fbm2", "materialx", "mx_noise.glsl", "mx_fractal2d_noise_float(p, 6, 2.0, 0.5)"),
    Call("fBm 3D, 6 octaves", "fbm.fbm3", "materialx", "mx_noise.glsl", "mx_fractal3d_noise_float(p, 6, 2.0, 0.5)"),
    Call("ridged 2D, 6 octaves", "fbm.ridged2", "fastnoiselite", "",
         f"_fnlGenFractalRidged2D({SIX_OCTAVES}, p.x, p.y)"),
    Call("ridged 3D, 6 octaves", "fbm.ridged3", "fastnoiselite", "",
         f"_fnlGenFractalRidged3D({SIX_OCTAVES}, p.x, p.y, p.z)"),
    Call("ping-pong 2D, 6 octaves", "fbm.ping_pong2", "fastnoiselite", "",
         f"_fnlGenFractalPingPong2D({SIX_OCTAVES}, p.x, p.y)"),
    Call("ping-pong 3D, 6 octaves", "fbm.ping_pong3", "fastnoiselite", "",
         f"_fnlGenFractalPingPong3D({SIX_OCTAVES}, p.x, p.y, p.z)"),
    Call("warp 2D, 6 octaves", "warp.warp2", "fastnoiselite", "", _warped("Independent", "xy")),
    Call("warp 3D, 6 octaves", "warp.warp3", "fastnoiselite", "", _warped("Independent", "xyz")),
    Call("progressive warp 2D, 6 octaves", "warp.warp_progressive2", "fastnoiselite", "", _warped("Progressive", "xy")),
    Call("progressive warp 3D, 6 octaves", "warp.warp_progressive3", "fastnoiselite", "", _warped("Progressive", "xyz")),
    Call("turning simplex 2D with derivatives", "noise2d.simplex_d_phase", "psrdnoise", "psrdnoise2.glsl",
         "psrdnoise(p, vec2(0.0), p.x, hn_bench_set.xy) + hn_bench_set.x + hn_bench_set.y"),
    Call("turning simplex 3D with derivatives", "noise3d.simplex_d_phase", "psrdnoise", "psrdnoise3.glsl",
         "psrdnoise(p, vec3(0.0), p.x, hn_bench_set.xyz) + hn_bench_set.x + hn_bench_set.y + hn_bench_set.z"),
)


def subject(call: Call) -> str:
    """The name that bench is given for it. Bench adds the number of dimensions."""
    return f"{call.peer}-{call.noise.lower().replace(',', '').replace(' ', '-')}-"


def dimensions(call: Call) -> int:
    """Of the position that bench offers: a vec2 or a vec3."""
    return 2 if "2D" in call.noise else 3


def against(paths: Mapping[str, Path]) -> list[str]:
    """Arguments of --against for the calls of the peers at these paths."""
    versions = {peer.option: f"@{peer.version}" if peer.version else "" for peer in PEERS}
    return [f"{subject(call)}{versions[call.peer]}={paths[call.peer] / call.file}:{call.expression}"
            for call in CALLS if call.peer in paths]
