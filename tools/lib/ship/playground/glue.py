"""Functions of the playground's own, in GLSL, which tools/pick translates. For languages without vectors: the one number
of a noise that a picture shows, places that are moved, and how layers are combined; a shader has these in line."""

from __future__ import annotations

from collections.abc import Sequence

from catalog.model import Sum

PREFIX = "hn_play_"
TILED = (2, 3)  # dimensions in which sums in a tile have functions of their own: people tile pictures and volumes
# Each noise of distances: the function, the number that a picture shows, and the noise that a sum takes.
DISTANCES = {
    "cellular": ("cellular", "{}.x", "1.0f - 2.0f * {}"),
    "cellular_second": ("cellular", "{}.y", "1.5f - 2.0f * {}"),
    "cellular_between": ("cellular", "{0}.y - {0}.x", "1.0f - 2.0f * {}"),
    "cellular_third": ("cellular_three", "{}.z", "1.75f - 2.0f * {}"),
}


def text_of_shaders(n: int, arithmetic: str, sums: Sequence[Sum]) -> str:
    """Sums of values over octaves at positions in floats, which integers have not, and in a tile of Perlin noise. Both are
    shorter than what takes every place."""
    if arithmetic == "fixed":
        return ""
    p, octaves, state = "hn_float" if n == 1 else f"hn_vec{n}", f"hn_octaves{n} o;", "inout hn_i_octave_sum sum"
    lines = [
        "HN_FN hn_i_octave_sum hn_play_begin(hn_int octaves, hn_float gain) { return hn_i_empty_sum(octaves, gain); }",
        f"HN_FN bool hn_play_next(inout {p} p, inout hn_uint seed, {state}, hn_float lacunarity) {{ "
        f"hn_octaves{n} o = hn_octaves(p, sum.octaves, lacunarity, sum.gain, seed); o.sum = sum; "
        "bool more = hn_next(o); p = o.p; seed = o.seed; sum = o.sum; return more; }",
    ]
    lines += [f"HN_FN hn_float hn_play_{end}(hn_i_octave_sum sum) {{ {octaves} o.sum = sum; return hn_{end}(o); }}"
              for end in ("mean", "density")]
    for step, has_strength in {total.step_of_loops: bool(total.strength) for total in sums if total.is_of_values}.items():
        strength, passed = (", hn_float strength", ", strength") if has_strength else ("", "")
        lines.append(f"HN_FN void hn_play_{step.removeprefix('hn_')}({state}, hn_float n{strength}) {{ {octaves} "
                     f"o.sum = sum; {step}(o, n{passed}); sum = o.sum; }}")
    for total in sums:
        if total.is_of_values and n in TILED:
            strength, passed = (", hn_float strength", ", strength") if total.strength else ("", "")
            lines.append(f"HN_FN hn_float hn_play_{total.name}_in_tile({p} p, hn_ivec{n} period, hn_int octaves, "
                         f"hn_float lacunarity, hn_float gain{strength}, hn_uint seed) {{ return "
                         f"hn_{total.name}(hn_tile(p, period), octaves, lacunarity, gain{passed}, seed); }}")
    return "\n".join(lines) + "\n"


def text_of_cpu(n: int) -> str:
    """For so many dimensions, in the library's own types."""
    p, cell = ("hn_float", "hn_int") if n == 1 else (f"hn_vec{n}", f"hn_ivec{n}")
    place = f"hn_place{n}"
    whole = "period" if n == 1 else f"ivec{n}({', '.join(['period'] * n)})"
    lines = [
        f"HN_FN {place} hn_play_at({p} p, hn_float scale) {{ return hn_place(p * scale); }}",
        f"HN_FN {place} hn_play_in_tile({p} p, hn_float scale, hn_int period) {{ "
        f"return hn_tile(p * scale, {whole}); }}",
        f"HN_FN hn_float hn_play_billows(hn_octaves{n} o) {{ return min(2.0f * hn_mean(o) - 1.0f, 1.0f); }}",
        f"HN_FN hn_float hn_play_bounded(hn_octaves{n} o) {{ return min(max(hn_mean(o), -1.0f), 1.0f); }}",
        f"HN_FN hn_float hn_play_random_signed({place} place, hn_uint seed) {{ "
        "return 2.0f * hn_random(place, seed) - 1.0f; }",
        "HN_FN hn_float hn_play_steps(hn_float v) { return hn_float(int(floor(min(max(v, -8.0f), 8.0f) * 65536.0f))) *"
        " 0.0000152587890625f; }",
        "HN_FN hn_float hn_play_product(hn_float a, hn_float b) { int i = int(a * 65536.0f); int j = int(b * 65536.0f);"
        " return hn_float(((i >> 8) * j + (((i & 255) * j) >> 8)) >> 8) * 0.0000152587890625f; }",
        "HN_FN hn_float hn_play_lower(hn_float a, hn_float b) { return min(a, b); }",
        "HN_FN hn_float hn_play_higher(hn_float a, hn_float b) { return max(a, b); }",
    ]
    # How steep a value is, of those beside it, as a shader has it in line.
    axes = "xyzw"[:n]
    steps = "".join(f"s = hn_play_steps(max(s, d{axis}) + 0.5f * min(s, d{axis})); " for axis in axes)
    beside = "".join(f"hn_float d{axis} = min(max({axis} - v, v - {axis}) * 16.0f, 8.0f); " for axis in axes)
    lines.append(f"HN_FN hn_float hn_play_slope(hn_float v, {', '.join(f'hn_float {axis}' for axis in axes)}) {{ "
                 f"{beside}hn_float s = 0.0f; {steps}return s; }}")
    # The distance from the middle, in radii: of the cell and of the place in it, whose parts are whole numbers of steps.
    lines.append("HN_FN hn_float hn_play_along(hn_int cell, hn_float f, hn_float unit, hn_float ratio) { hn_float at = "
                 "hn_play_steps(hn_float(cell) * unit) + hn_play_steps(f * unit); "
                 "return hn_play_product(min(max(at, -2.0f), 2.0f), ratio); }")
    for shape, value in {"round": "max(1.0f - (hn_play_product(x, x) + hn_play_product(y, y)), -1.0f)",
                         "square": "max(1.0f - max(hn_play_product(x, x), hn_play_product(y, y)), -1.0f)",
                         "along_x": "min(max(x, -1.0f), 1.0f)", "along_y": "min(max(y, -1.0f), 1.0f)"}.items():
        set_ = "".join(f"hn_float {axis} = " + (f"hn_play_along(place.cell{at}, hn_i_position_of(0, place.fraction{at}, place.rest{at}), "
                       "unit, ratio); " if n > 1 or axis == "x" else f"{'x' if shape == 'along_y' else '0.0f'}; ")
                       for axis in "xy" for at in ["" if n == 1 else f".{axis}"] if axis in value or axis == "x")
        lines.append(f"HN_FN hn_float hn_play_{shape}({place} place, hn_float unit, hn_float ratio) {{ {set_}return {value}; }}")
    if n in (2, 3):
        for warp in ("warp", "warp_progressive"):
            moved = "octaves, lacunarity, gain, amplitude, seed"
            settings = "hn_int octaves, hn_float lacunarity, hn_float gain, hn_float amplitude, hn_uint seed"
            lines += [
                f"HN_FN {place} hn_play_{warp}({p} p, hn_float scale, {settings}) {{ {p} s = p * scale; "
                f"return hn_place(s + hn_{warp}(s, {moved})); }}",
                f"HN_FN {place} hn_play_{warp}_in_tile({p} p, hn_float scale, hn_int period, {settings}) {{ "
                f"{p} s = p * scale; return hn_tile(s + hn_{warp}(hn_tile(s, {whole}), {moved}), {whole}); }}"]
        for name, (called, shown, signed) in DISTANCES.items():
            parameters = f"{place} place, hn_float jitter, hn_int metric, hn_uint seed"
            call = f"hn_{called}(place, jitter, metric, seed)"
            size = 3 if called == "cellular_three" else 2
            value = f"hn_vec{size} d = {call}; return {shown.format('d')};"
            lines += [f"HN_FN hn_float hn_play_{name}({parameters}) {{ {value} }}",
                      f"HN_FN hn_float hn_play_{name}_signed({parameters}) {{ return "
                      f"{signed.format(f'hn_play_{name}(place, jitter, metric, seed)')}; }}"]
        for name, signed in (("cellular_smooth", "1.0f - 2.0f * {}"), ("cell_border", "4.0f * {} - 1.0f")):
            lines += [f"HN_FN hn_float hn_play_{name}_signed({place} place, hn_float jitter, hn_uint seed) {{ "
                      f"return {signed.format(f'hn_{name}(place, jitter, seed)')}; }}"]
        lines += [
            f"HN_FN hn_float hn_play_cells({place} place, hn_float jitter, hn_int metric, hn_uint seed) {{ "
            f"{cell} nearest; hn_vec{n} offset; hn_cellular(place, jitter, metric, seed, nearest, offset); "
            "return hn_unorm(hn_lattice(nearest, seed + 1u)); }",
            f"HN_FN hn_float hn_play_cells_signed({place} place, hn_float jitter, hn_int metric, hn_uint seed) {{ "
            "return 2.0f * hn_play_cells(place, jitter, metric, seed) - 1.0f; }",
            f"HN_FN hn_float hn_play_curl({place} place, hn_uint seed) {{ return hn_curl(place, seed).x; }}"]
        lines += [f"HN_FN void hn_play_add_eroded_{noise}(inout hn_octaves{n} o, inout hn_slopes{n} s, "
                  f"hn_float strength) {{ hn_add_eroded(o, s, hn_{noise}_d(o.place, o.seed), strength); }}"
                  for noise in ("perlin", "value", "simplex")]
    return "\n".join(lines) + "\n"
