"""Calls of other libraries, and those of ours that shall look alike."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

PLAIN = (-1.0, 1.0)
UNKNOWN = (0.0, 0.0)  # no range: theirs documents none
BILLOW = (-math.inf, 1.0)  # of -(2 * mean - 1), where each octave adds up to {inner}: it begins at 1 - 2 * {inner}


class Row(NamedTuple):
    """In `ours` and `before` stand {p} for the position, which the scale multiplies, {factor} for the factor with a
    sign of multiplication, {offset} for what is added, {seed} for the seed, {amplitude} for that of a warp, {sum} for
    the number of octaves, the lacunarity and the gain, and {inner} for the factor of another row. A missing one is
    not looked for."""
    table: str  # of the page
    peer: str  # the option of tools/measure peers
    theirs: str  # on the page
    file: str  # below the path that is given
    expression: str  # of a position p, in their GLSL; or statements with a return
    axes: int
    ours: str
    range: tuple[float, float] = PLAIN  # of ours, without a factor
    before: str = ""  # what stands before it in the shader: a sum over another noise, for instance
    statement: str = ""  # what stands before it in a function
    sum: str = "3, 2.0, 0.5"  # for which sums are measured
    amplitude: str = "0.3"  # for which warps are measured: 30 and 0.01 are FastNoiseLite's defaults
    inner: str = ""  # the id of the row whose factor is {inner}
    part: str = ""  # of a vector: what is measured of ours; the page shows the whole

    @property
    def id(self) -> str:
        return f"{self.table}: {self.theirs} {self.axes}D".replace("`", "")


# --- Sums over another noise than the library's own: # stands for the number of dimensions ----------------------------

STEPS = {"fbm": "hn_add(o, {})", "weighted": "hn_add_weighted(o, {}, strength)", "billow": "hn_add_turbulence(o, {})",
         "ping_pong": "hn_add_ping_pong(o, {}, strength)", "warp": "hn_add", "warp_progressive": "hn_add_progressive"}
MEANS = {"billow": "2.0 * hn_mean(o) - 1.0"}
OWN_SUM = """float {name}(vec# p, int octaves, float lacunarity, float gain, {strength}uint seed) {{
  hn_octaves# o = hn_octaves(p, octaves, lacunarity, gain, seed);
  do {step}; while (hn_next(o));
  return {mean};
}}
"""
OWN_WARP = """vec# {name}(vec# p, int octaves, float lacunarity, float gain, float amplitude, uint seed) {{
  hn_octaves# o = hn_octaves(p, octaves, lacunarity, gain, seed);
  hn_shifts# s = hn_shifts(o, amplitude);
  do {step}(o, s, {vector}); while (hn_next(o));
  return hn_mean(o, s);
}}
"""


def own_sum(name: str, kind: str, noise: str) -> str:
    step = STEPS[kind].format(f"{noise}(o.place, o.seed)")
    return OWN_SUM.format(name=name, step=step, mean=MEANS.get(kind, "hn_mean(o)"),
                          strength="float strength, " if "strength" in step else "")


def own_warp(name: str, kind: str, noise: str, axes: int) -> str:
    vector = ", ".join(f"{noise}(o.place, o.seed + {axis}u)" for axis in range(axes))
    text = OWN_WARP.format(name=name, step=STEPS[kind], vector=f"vec{axes}({vector})")
    return text.replace("#", str(axes))


# --- FastNoiseLite, and Godot, which has it ---------------------------------------------------------------------------

# A noise with their contrast, for sums that fold it: a factor of the sum would come too late.
LOUD = "float loud(hn_place# place, uint seed) {{ return {{inner}} * {}(place, seed); }}\n"


def _state(settings: dict[str, str]) -> str:
    lines = "".join(f"s.{name} = {value}; " for name, value in {"frequency": "1.0", **settings}.items())
    return f"fnl_state s = fnlCreateState(0); {lines}"


def _noise(theirs: str, ours: str, range: tuple[float, float] = PLAIN, before: str = "", statement: str = "",
           inner: str = "", table: str = "FastNoiseLite", sum: str = "3, 2.0, 0.5", **settings: str) -> Iterator[Row]:
    """In both dimensions; # stands for their number."""
    for axes, place in ((2, "p.x, p.y"), (3, "p.x, p.y, p.z")):
        call = f"{_state(settings)}return fnlGetNoise{axes}D(s, {place});"
        words = (text.replace("#", str(axes)) for text in (ours, before, statement, inner))
        ours_here, before_here, statement_here, inner_here = words
        yield Row(table, "fastnoiselite", theirs, "", call, axes, ours_here, range, before_here, statement_here,
                  sum=sum, inner=inner_here)


def _warp(theirs: str, ours: str, own: tuple[str, str, str] | None, table: str = "FastNoiseLite",
          sum: str = "3, 2.0, 0.5", amplitude: str = "0.3", **settings: str) -> Iterator[Row]:
    for axes, moved in ((2, "q.x, q.y"), (3, "q.x, q.y, q.z")):
        state = _state({"domain_warp_amp": amplitude, **settings})
        call = f"{state}vec{axes} q = p; fnlDomainWarp{axes}D(s, {moved}); return q.x - p.x;"
        yield Row(table, "fastnoiselite", theirs, "", call, axes, ours, UNKNOWN,
                  own_warp(*own, axes) if own else "", sum=sum, amplitude=amplitude, part=".x")


def _fastnoiselite() -> Iterator[Row]:
    for name, function in (("OPENSIMPLEX2", "hn_simplex"), ("OPENSIMPLEX2S", "hn_simplex_smooth"),
                           ("PERLIN", "hn_perlin"), ("VALUE", "hn_value"), ("VALUE_CUBIC", "hn_value_cubic")):
        yield from _noise(f"`FNL_NOISE_{name}`", f"{{factor}}{function}({{p}}, {{seed}})",
                          noise_type=f"FNL_NOISE_{name}")
    for name, function in (("OPENSIMPLEX2", "hn_simplex"), ("OPENSIMPLEX2S", "hn_simplex_smooth"), ("PERLIN", "hn_perlin")):
        for theirs, step, rest, settings in (
                ("`FNL_FRACTAL_FBM`", "fbm", "", {"fractal_type": "FNL_FRACTAL_FBM"}),
                ("`weighted_strength` of 1", "weighted", ", 1.0",
                 {"fractal_type": "FNL_FRACTAL_FBM", "weighted_strength": "1.0"})):
            own = f"hn_{step}" if name == "PERLIN" else f"my_{step}"
            yield from _noise(f"{theirs} over `{name}`", f"{{factor}}{own}({{p}}, {{sum}}{rest}, {{seed}})",
                              before=own_sum(own, step, function) if own.startswith("my") else "",
                              noise_type=f"FNL_NOISE_{name}", **settings)
        for theirs, step, sign, rest, range in (("RIDGED", "billow", "-", "", BILLOW),
                                                ("PINGPONG", "ping_pong", "", ", 2.0", PLAIN)):
            own = f"loud_{step}"
            yield from _noise(f"`FNL_FRACTAL_{theirs}` over `{name}`",
                              f"{sign}{{factor}}{own}({{p}}, {{sum}}{rest}, {{seed}})", range,
                              before=LOUD.format(function) + own_sum(own, step, "loud"),
                              inner=f"FastNoiseLite: FNL_NOISE_{name} #D", noise_type=f"FNL_NOISE_{name}",
                              fractal_type=f"FNL_FRACTAL_{theirs}")
    for metric, name in (("SQUARED", "EUCLIDEANSQ"), ("EUCLIDEAN", "EUCLIDEAN"), ("MANHATTAN", "MANHATTAN"),
                         ("HYBRID", "HYBRID")):
        found = f"vec2 F = hn_cellular(p, 1.0, HN_METRIC_{metric}, 7u); "
        for value, ours in (("DISTANCE", "F.x"), ("DISTANCE2", "F.y"), ("DISTANCE2ADD", "0.5 * (F.y + F.x)"),
                            ("DISTANCE2SUB", "(F.y - F.x)"), ("DISTANCE2MUL", "0.5 * F.y * F.x"),
                            ("DISTANCE2DIV", "F.x / F.y"))[:6 if metric in ("SQUARED", "EUCLIDEAN") else 1]:
            yield from _noise(f"`{value}`" if metric == "SQUARED" else f"`{value}` of `{name}`",
                              f"{{factor}}{ours} - 1.0", UNKNOWN, statement=found, noise_type="FNL_NOISE_CELLULAR",
                              table="FastNoiseLite's cells", cellular_return_type=f"FNL_CELLULAR_RETURN_TYPE_{value}",
                              cellular_distance_func=f"FNL_CELLULAR_DISTANCE_{name}")
    for name, function in (("OPENSIMPLEX2", "hn_simplex"), ("OPENSIMPLEX2_REDUCED", "hn_simplex"),
                           ("BASICGRID", "hn_value")):
        kind = {"domain_warp_type": f"FNL_DOMAIN_WARP_{name}"}
        for theirs, numbers, step, fractal in (
                ("no fractal", "1, 2.0, 0.5", "warp", "NONE"),
                ("`INDEPENDENT`", "{sum}", "warp", "DOMAIN_WARP_INDEPENDENT"),
                ("`PROGRESSIVE`", "{sum}", "warp_progressive", "DOMAIN_WARP_PROGRESSIVE")):
            own = f"{'hn' if function == 'hn_value' else 'my'}_{step}"
            yield from _warp(f"`FNL_DOMAIN_WARP_{name}`, {theirs}",
                             f"{own}({{p}}, {numbers}, {{factor}}{{amplitude}}, {{seed}})",
                             (own, step, function) if own.startswith("my") else None,
                             "FastNoiseLite's warps", fractal_type=f"FNL_FRACTAL_{fractal}", **kind)


def _godot() -> Iterator[Row]:
    """The defaults of FastNoiseLite in Godot, by its documentation (doc_classes/FastNoiseLite.xml)."""
    yield from _noise("`get_noise_2d`, `get_noise_3d`", "{factor}my_fbm({p}, 5, 2.0, 0.5, {seed})", table="Godot",
                      before=own_sum("my_fbm", "fbm", "hn_simplex_smooth"), noise_type="FNL_NOISE_OPENSIMPLEX2S",
                      fractal_type="FNL_FRACTAL_FBM", octaves="5")
    # In cells of the warp: an amplitude of 30 with a frequency of 0.05.
    yield from _warp("`domain_warp_enabled`", "my_warp({p}, 5, 6.0, 0.5, {factor}{amplitude}, {seed})",
                     ("my_warp", "warp_progressive", "hn_simplex"), "Godot", amplitude="1.5", octaves="5",
                     lacunarity="6.0", fractal_type="FNL_FRACTAL_DOMAIN_WARP_PROGRESSIVE")


# --- webgl-noise and psrdnoise ----------------------------------------------------------------------------------------

OLDER = ", older text"  # which glsl-noise and Unity.Mathematics have


def _webgl_noise() -> Iterator[Row]:
    def row(peer: str, theirs: str, file: str, expression: str, axes: int, ours: str,
            range: tuple[float, float] = PLAIN, text: str = "") -> Row:
        return Row("webgl-noise", peer, f"`{theirs}`{text}", f"{file}.glsl", expression, axes, ours, range)

    for axes in (2, 3, 4):
        yield row("webgl-noise", f"snoise(vec{axes} p)", f"noise{axes}D", "snoise(p)", axes,
                  "{factor}hn_simplex({p}, {seed})")
    for axes in (3, 4):
        yield row("glsl-noise", f"snoise(vec{axes} p)", f"simplex/{axes}d", "snoise(p)", axes,
                  "{factor}hn_simplex({p}, {seed})", text=OLDER)
    for axes in (2, 3, 4):
        yield row("webgl-noise", f"cnoise(vec{axes} p)", f"classicnoise{axes}D", "cnoise(p)", axes,
                  "{factor}hn_perlin({p}, {seed})")
    for axes, part in ((2, "x"), (2, "y"), (3, "x"), (3, "y")):
        yield row("webgl-noise", f"cellular(vec{axes} p).{part}", f"cellular{axes}D", f"cellular(p).{part}", axes,
                  f"{'{offset}' if part == 'y' else ''}{{factor}}hn_cellular({{p}}, {{seed}}).{part}", UNKNOWN)
    for axes, name in ((2, "cellular2x2"), (3, "cellular2x2x2")):
        yield row("webgl-noise", f"{name}(vec{axes} p).x", name, f"{name}(p).x", axes,
                  "{factor}hn_cellular({p}, {seed}).x", UNKNOWN)
    for axes in (2, 3):
        body = f"vec{axes} g; return psrdnoise(p, vec{axes}(0.0), 0.0, g);"
        yield row("psrdnoise", f"psrdnoise(vec{axes} p, ...)", f"psrdnoise{axes}", body, axes,
                  "{factor}hn_simplex({p}, {seed})")


# --- lygia ------------------------------------------------------------------------------------------------------------


def _lygia() -> Iterator[Row]:
    def row(axes: int, theirs: str, ours: str, range: tuple[float, float] = PLAIN, file: str = "", before: str = "",
            part: str = "", ours_part: str = "") -> Row:
        return Row("lygia", "lygia", f"`{theirs}(vec{axes} p)`", f"generative/{file or theirs}.glsl",
                   f"{theirs}(p){part}", axes, ours, range, before, sum="4, 2.0, 0.5", part=ours_part)

    for axes in (2, 3):
        yield row(axes, "snoise", "{factor}hn_simplex({p}, {seed})")
    for axes in (2, 3):
        yield row(axes, "noised", "{factor}hn_perlin_d({p}, {seed})", part=".x", ours_part=".x")
    yield row(2, "gnoise", "{offset}{factor}hn_value({p}, {seed})")
    yield row(3, "gnoise", "{factor}hn_value({p}, {seed})")
    for axes in (2, 3):
        yield row(axes, "fbm", "{factor}my_fbm({p}, 4, 2.0, 0.5, {seed})",
                  before=own_sum("my_fbm", "fbm", "hn_simplex").replace("#", str(axes)))
    for axes in (2, 3):
        yield row(axes, "worley", "1.0 - {factor}hn_cellular({p}, {seed}).x", UNKNOWN)
    yield row(2, "voronoi", "{factor}hn_cellular({p}, {seed}).x", UNKNOWN, part=".z")
    # The summand keeps the curl from 0, which has no direction.
    yield row(3, "curl", "normalize(hn_curl({p}, {seed}) + 1.0e-6)", UNKNOWN, part=".x", ours_part=".x")


# --- MaterialX --------------------------------------------------------------------------------------------------------


def _materialx() -> Iterator[Row]:
    def row(axes: int, theirs: str, ours: str, range: tuple[float, float] = PLAIN, rest: str = "") -> Row:
        return Row("MaterialX", "materialx", f"`{theirs}(vec{axes} p{', ...' if rest else ''})`", "mx_noise.glsl",
                   f"{theirs}(p{rest})", axes, ours, range)

    for axes in (2, 3):
        yield row(axes, "mx_perlin_noise_float", "{factor}hn_perlin({p}, {seed})")
    for axes in (2, 3):
        yield row(axes, f"mx_fractal{axes}d_noise_float", "{factor}hn_fbm({p}, {sum}, {seed})", rest=", 3, 2.0, 0.5")
    for axes in (2, 3):
        yield row(axes, "mx_worley_noise_float", "{factor}hn_cellular({p}, {seed}).x", UNKNOWN, rest=", 1.0, 0, 0")


# --- Unity's Shader Graph ---------------------------------------------------------------------------------------------


def _unity() -> Iterator[Row]:
    """p is uv * scale there."""
    def row(theirs: str, ours: str, before: str = "") -> Row:
        name = theirs.lower().replace(" ", "_")
        return Row("Unity", "unity", theirs, "", f"{name}(p)", 2, f"{{offset}}{{factor}}{ours}", before=before)

    yield row("Gradient Noise", "hn_perlin({p}, {seed})")
    yield row("Simple Noise", "my_fbm({p}, 3, 2.0, 0.5, {seed})", own_sum("my_fbm", "fbm", "hn_value").replace("#", "2"))


# --- Snippets by Inigo Quilez -----------------------------------------------------------------------------------------


def _quilez() -> Iterator[Row]:
    """Value noise in [0, 1], and sums of five octaves with the weights 1/2, 1/4, ..."""
    before = own_sum("my_fbm", "fbm", "hn_value")
    for axes in (2, 3):
        for theirs, name, ours in (("`noise(x)`, value noise", "value_noise", "hn_value({p}, {seed})"),
                                   ("`fbm(x)` of it", "value_sum", "my_fbm({p}, 5, 2.0, 0.5, {seed})")):
            yield Row("Quilez", "quilez", theirs, "", f"{name}(p)", axes, f"{{offset}}{{factor}}{ours}",
                      before=before.replace("#", str(axes)))
        # The mean of theirs moves the whole picture alike, and is left out.
        yield Row("Quilez", "quilez", "`4.0 * vec2(fbm(...), ...)`, a warp by it", "", "4.0 * (value_sum(p) - 0.484)", axes,
                  "hn_warp({p}, 5, 2.0, 0.5, {factor}4.0, {seed})", UNKNOWN, part=".x")


ROWS = (*_fastnoiselite(), *_godot(), *_webgl_noise(), *_lygia(), *_materialx(), *_unity(), *_quilez())
