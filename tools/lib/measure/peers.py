"""Measures what other libraries' noises, sums and warps cost, beside ours and in the same rounds.

    tools/measure peers [--fastnoiselite FILE] [--wombat DIR] [--materialx DIR] [--webgl-noise DIR] [--psrdnoise DIR]
                        [--driver NAME] [--out DIR]

Each option is the path of a copy of yours; its help names which file or folder of it. Peers without an option are left
out.

It calls hn-conform bench --against, which must be on the PATH or built (tools/measure clock builds it), and leaves
bench.csv in DIR. docs/measured/results/llvmpipe/peers.csv is such a file; tools/make pages makes the table of
docs/measured/measuring.md of it.

Exit status: that of hn-conform bench; 2 bad usage.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.tree import GLSL, hn_conform
from base.usage import Parser


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
# FastNoiseLite's state: Perlin noise with the frequency 1, then octaves, lacunarity, gain, the strengths of weighted
# and of ping-pong sums, and what only cells and warps use.
STATE = ("fnl_state(0, 1.0, FNL_NOISE_PERLIN, FNL_ROTATION_NONE, FNL_FRACTAL_NONE, 6, 2.0, 0.5, 0.0, 2.0, 0, 0, 1.0, "
         "{warp}, 1.0)")
# Its warps move p, and return it. Their vectors are those of a grid, as ours are.
WARP = "(hn_bench_set = vec4({zeros}), _fnlDomainWarpFractal{kind}{n}D({warping}, {set}), {sum})"
# The noise, ours, the numbers of dimensions, the peer, its file and its expression, in which {n} stands for one of these
# numbers, {m} for one more, {p} for the position, {xyz} for its coordinates, {set} for parts of hn_bench_set, and {sum}
# for their sum. The parts of a vector are added up, as bench does with those of ours.
ROWS = (
    ("Perlin {n}D", "noise{n}d.perlin", "23", "fastnoiselite", "", "_fnlSinglePerlin{n}D(0, {xyz})"),
    ("Perlin {n}D", "noise{n}d.perlin", "234", "wombat", "Perlin{n}D.glsl", "Perlin{n}D({p})"),
    ("Perlin {n}D", "noise{n}d.perlin", "23", "materialx", "mx_noise.glsl", "mx_perlin_noise_float(p)"),
    ("Perlin {n}D with derivatives", "noise{n}d.perlin_d", "23", "wombat", "Perlin{n}D_Deriv.glsl",
     "dot(Perlin{n}D_Deriv(p), vec{m}(1.0))"),
    ("value {n}D", "noise{n}d.value", "23", "fastnoiselite", "", "_fnlSingleValue{n}D(0, {xyz})"),
    ("value {n}D", "noise{n}d.value", "234", "wombat", "Value{n}D.glsl", "Value{n}D({p})"),
    ("value {n}D with derivatives", "noise{n}d.value_d", "23", "wombat", "Value{n}D_Deriv.glsl",
     "dot(Value{n}D_Deriv(p), vec{m}(1.0))"),
    ("cubic value {n}D", "noise{n}d.value_cubic", "23", "fastnoiselite", "", "_fnlSingleValueCubic{n}D(0, {xyz})"),
    ("simplex {n}D", "noise{n}d.simplex", "2", "fastnoiselite", "", "_fnlSingleSimplex2D(0, {xyz})"),
    ("simplex {n}D", "noise{n}d.simplex", "3", "fastnoiselite", "", "_fnlSingleOpenSimplex23D(0, {xyz})"),
    ("simplex {n}D", "noise{n}d.simplex", "23", "wombat", "SimplexPerlin{n}D.glsl", "SimplexPerlin{n}D(p)"),
    ("simplex {n}D", "noise{n}d.simplex", "234", "webgl-noise", "noise{n}D.glsl", "snoise({p})"),
    ("simplex {n}D with derivatives", "noise{n}d.simplex_d", "23", "wombat", "SimplexPerlin{n}D_Deriv.glsl",
     "dot(SimplexPerlin{n}D_Deriv(p), vec{m}(1.0))"),
    ("smooth simplex {n}D", "noise{n}d.simplex_smooth", "23", "fastnoiselite", "", "_fnlSingleOpenSimplex2S{n}D(0, {xyz})"),
    # Its own default: the nearest distance, squared. The result is chosen at run time, so both are computed.
    ("cellular {n}D", "noise{n}d.cellular", "23", "fastnoiselite", "",
     "_fnlSingleCellular{n}D(fnlCreateState(0), 0, {xyz})"),
    ("cellular {n}D", "noise{n}d.cellular", "23", "wombat", "Cellular{n}D.glsl", "Cellular{n}D(p)"),
    ("cellular {n}D", "noise{n}d.cellular", "23", "materialx", "mx_noise.glsl",
     "dot(mx_worley_noise_vec2(p, 1.0, 0, 0), vec2(1.0))"),
    ("cellular {n}D", "noise{n}d.cellular", "23", "webgl-noise", "cellular{n}D.glsl", "dot(cellular(p), vec2(1.0))"),
    ("fBm {n}D, 6 octaves", "fbm.fbm{n}", "23", "fastnoiselite", "", "_fnlGenFractalFBM{n}D({state}, {xyz})"),
    ("fBm {n}D, 6 octaves", "fbm.fbm{n}", "23", "materialx", "mx_noise.glsl", "mx_fractal{n}d_noise_float(p, 6, 2.0, 0.5)"),
    ("ridged {n}D, 6 octaves", "fbm.ridged{n}", "23", "fastnoiselite", "", "_fnlGenFractalRidged{n}D({state}, {xyz})"),
    ("ping-pong {n}D, 6 octaves", "fbm.ping_pong{n}", "23", "fastnoiselite", "",
     "_fnlGenFractalPingPong{n}D({state}, {xyz})"),
    ("warp {n}D, 6 octaves", "warp.warp{n}", "23", "fastnoiselite", "", WARP.replace("{kind}", "Independent")),
    ("progressive warp {n}D, 6 octaves", "warp.warp_progressive{n}", "23", "fastnoiselite", "",
     WARP.replace("{kind}", "Progressive")),
    ("turning simplex {n}D with derivatives", "noise{n}d.simplex_d_phase", "23", "psrdnoise", "psrdnoise{n}.glsl",
     "psrdnoise(p, vec{n}(0.0), p.x, hn_bench_set.{axes}) + {sum}"),
)


def _calls():
    for noise, ours, numbers, peer, file, expression in ROWS:
        for n in map(int, numbers):
            axes = "xyz"[:n]
            places, parts = [f"p.{axis}" for axis in axes], [f"hn_bench_set.{axis}" for axis in axes]
            words = {"n": n, "m": n + 1, "p": "p" if n < 4 else "vec4(p, p.x)", "axes": axes, "xyz": ", ".join(places),
                     "zeros": ", ".join(places + ["0.0"] * (4 - n)), "set": ", ".join(parts), "sum": " + ".join(parts),
                     "state": STATE.format(warp=0), "warping": STATE.format(warp="FNL_DOMAIN_WARP_BASICGRID")}
            yield Call(*(text.format_map(words) for text in (noise, ours, peer, file, expression)))


CALLS = tuple(_calls())


def subject(call: Call) -> str:
    """The name that bench is given for it. Bench adds the number of dimensions."""
    return f"{call.peer}-{call.noise.lower().replace(',', '').replace(' ', '-')}-"


def dimensions(call: Call) -> int:
    """The position that bench offers: a vec2 or a vec3."""
    return 2 if "2D" in call.noise else 3


def against(paths: Mapping[str, Path]) -> list[str]:
    """Arguments of --against for the calls of the peers at these paths."""
    versions = {peer.option: f"@{peer.version}" if peer.version else "" for peer in PEERS}
    return [f"{subject(call)}{versions[call.peer]}={paths[call.peer] / call.file}:{call.expression}"
            for call in CALLS if call.peer in paths]


def add_options(parser: argparse.ArgumentParser, peers: Sequence[Peer] = PEERS) -> None:
    for peer in peers:
        parser.add_argument(f"--{peer.option}", type=Path, metavar="PATH", help=f"your copy of it: {peer.what}")


def given(options: argparse.Namespace, peers: Sequence[Peer] = PEERS) -> dict[str, Path]:
    """Where those of the peers are that options name. A path that leads nowhere is a ValueError."""
    paths = {peer.option: path for peer in peers if (path := getattr(options, peer.option.replace("-", "_")))}
    for option, path in paths.items():
        if not path.exists():
            raise ValueError(f"--{option}: there is no {path}")
    return paths


def main(arguments: Sequence[str] | None = None) -> int:
    from measure import conform  # which imports the table here

    parser = Parser("tools/measure peers", __doc__)
    add_options(parser)
    parser.add_argument("--driver", default="osmesa", metavar="NAME", help="of hn-conform (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="(default: %(default)s)")
    options = parser.parse_args(arguments)
    try:
        paths = given(options)
    except ValueError as error:
        parser.error(str(error))
    program = hn_conform()
    if not paths or not program:
        parser.error("name at least one peer, for example --webgl-noise DIR" if program else
                     "there is no hn-conform: build it by tools/measure clock, or put it on the PATH")
    words = ["--driver", options.driver, "--glsl", str(GLSL)]  # the program may be older than the text here
    for ours in dict.fromkeys(call.ours for call in CALLS if call.peer in paths):
        words += ["--filter", f"{ours}.lattice"]
    for one in against(paths):
        words += ["--against", one]
    return conform.bench(program, options.out, words)[0]
