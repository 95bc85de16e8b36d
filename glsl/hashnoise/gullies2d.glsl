// hashnoise: gullies as water cuts them into a slope, on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_GULLIES2D_GLSL
#define HN_GULLIES2D_GLSL

#include "detail/jacobian.glsl"
#include "detail/square_root.glsl"
#include "octaves2d.glsl"
#include "phasor_d2d.glsl"

//   hn_i_eroding_slope(x)   a component of a slope, at most 8 in size. In HN_FIXED slopes are in units of 2^-16
//   hn_i_eroded_slope(e, d) the sum of two such components, at most 8 in size, too
//   hn_i_gully_wave(x, r)   3/2 x / (r + 1/8), as a float, of a component x of a slope; r is how steep the slope is
//   hn_i_steepness(r)       r / (r + 1/8), in the units of weights
//   hn_i_added_slope(a, b)  a - b, as a float

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_eroding_slope(hn_float x) { return min(max(-8.0f, hn_i_to_num(x)), 8.0f); }
HN_FN hn_float hn_i_eroded_slope(hn_float e, hn_float d) { return hn_i_eroding_slope(hn_i_plus(e, d)); }
HN_FN hn_float hn_i_slope_of_waves(hn_float d) { return d; }
HN_FN hn_float hn_i_steepness(hn_float r) { return hn_i_quotient(r, hn_i_plus(r, 0.125f)); }
HN_FN hn_float hn_i_gully_wave(hn_float x, hn_float r) {
  return hn_i_times(hn_i_quotient(x, hn_i_plus(r, 0.125f)), 1.5f);
}
HN_FN hn_float hn_i_added_slope(hn_float a, hn_float b) { return hn_i_derivative(hn_i_minus(a, b)); }

#else

HN_FN hn_int hn_i_eroding_slope(hn_float x) { return int(min(max(-8.0f, x), 8.0f) * 65536.0f); }
HN_FN hn_int hn_i_eroded_slope(hn_int e, hn_int d) { return min(max(hn_i_wide_plus(e, d), -524288), 524288); }
HN_FN hn_int hn_i_slope_of_waves(hn_float d) { return int(d * 65536.0f); }

// r is in units of 2^-14, and 2048 is 1/8. A quotient is a multiple of 2^-21, so 3/2 of it is exact.
HN_FN hn_float hn_i_gully_wave(hn_int x, hn_uint r) { return hn_i_over(x, r + 2048u) * 1.5f; }
HN_FN hn_int hn_i_steepness(hn_uint r) { return hn_i_setting(hn_i_over(int(r * 4u), r + 2048u), 1.0f); }
HN_FN hn_float hn_i_added_slope(hn_int a, hn_int b) { return hn_i_float(a - b) * (1.0f / 65536.0f); }

#endif

HN_FN hn_vec3 hn_i_gullies(hn_octaves2 octaves, hn_vec2 slope, hn_float depth) {
  hn_octaves2 o = octaves;
  hn_i_num deep = hn_i_setting(depth, 8.0f);
  hn_i_num growth = hn_i_growth(o.sum.gain, o.lacunarity);
  hn_i_num steepening = deep;  // depth * (gain * lacunarity)^i
  hn_i_num2 before = hn_i_vector(hn_i_eroding_slope(slope.x), hn_i_eroding_slope(slope.y));
  hn_i_num x = before.x;  // apart, for the reason that hn_slopes2 has (fbm_d2d.glsl)
  hn_i_num y = before.y;
  bool more = true;  // apart: of a call in the condition DXC makes SPIR-V that is not valid
  do {
    hn_i_rank r = hn_i_root(hn_i_squared(x, y));
    hn_vec2 wave = vec2(-hn_i_gully_wave(y, r), hn_i_gully_wave(x, r));
    hn_i_num part = hn_i_weight_times(hn_i_steepness(r), hn_i_resolved_part(o.sum.footprint));
    hn_derivatives2x2 n = hn_phasor_d(o.place, wave, 0.0f, o.seed);
    o.sum = hn_i_add_octave(o.sum, hn_i_octave(n.value.x), hn_i_weight_times(o.sum.weight, part));
    hn_i_num rate = hn_i_wide_times(steepening, part);
    x = hn_i_eroded_slope(x, hn_i_wide_times(hn_i_slope_of_waves(n.dx.x), rate));
    y = hn_i_eroded_slope(y, hn_i_wide_times(hn_i_slope_of_waves(n.dy.x), rate));
    steepening = hn_i_wide_times(steepening, growth);
    o.sum.footprint = hn_i_next_footprint(o.sum.footprint, o.lacunarity);
    more = hn_next(o);
  } while (more);
  bool none = hn_i_to_bool(o.sum.octaves < 1);
  hn_i_num height = hn_i_select(none, HN_I_NO_WEIGHT, hn_i_coarse(hn_i_wide_times(hn_i_finite(o.sum.value), deep)));
  return vec3(hn_i_value(height), hn_i_added_slope(hn_i_select(none, before.x, x), before.x),
              hn_i_added_slope(hn_i_select(none, before.y, y), before.y));
}

// Gullies that run down a slope, and smaller ones that run down into them, octave by octave: erosion by water for any
// height. Add them to a height and its derivatives:
//
//   vec3 land = hn_fbm_d(p, 3, 2.0, 0.4, 7u);
//   land += hn_gullies(p, land.yz, 5, 2.0, 0.5, 0.1, 7u);
//
// Flat ground has none. Gullies of the first octave are about a cell apart. For a frequency of 3 pass 3 p and a third
// of the slope, and add three times the slope that it returns.
// Experimental: a later version may return other values.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest gullies are apart
//   place       in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl).
//               The period of a tile times lacunarity^octaves is below 2^31
//   footprint   the size of a pixel at p, in cells of the first octave; 0 if it is left out. An octave fades out as a
//               pixel grows from 1/4 to 3/4 of its cells
//   slope       the derivatives of the height along x and y, per cell of p; numbers outside [-8, 8] count as the nearer
//               end
//   octaves     how many, usually 4 to 8; more than 32 count as 32, and with fewer than 1 the result is 0
//   lacunarity  ratio of frequencies, usually 2: a whole number from 1 to 255; others are rounded down
//   gain        ratio of depths, usually 0.5; not negative
//   depth       of the first octave, half from ridge to floor on steep ground: usually 0.05 to 0.2; numbers outside
//               [0, 8] count as the nearer end
//   seed        any uint: 7u, not 7; different seeds give independent fields
//   example     vec3 d = hn_gullies(uv * 8.0, vec2(0.5, 0.0), 5, 2.0, 0.5, 0.1, 7u);
//   returns     the amounts to add to the height, at most depth * sum of gain^i in size, and to its derivatives along x
//               and y. It is continuous where the slope is. The derivatives leave out that the gullies rotate
//   error       it grows from octave to octave, since each follows those before it (docs/measured/accuracy.md).
//               HN_FIXED has the same bits everywhere
//   period      2^31 cells per axis, or the tile's
//   cost        hn_phasor_d, a square root and three divisions per octave
//   HN_FIXED    takes a gain above 1 as 1
//   source      docs/reference/contract.md, section 24; waves across the slope as gullies: Tricard et al., "Procedural
//               phasor noise", 2019, for the waves
HN_FN hn_vec3 hn_gullies(hn_place2 place, hn_float footprint, hn_vec2 slope, hn_int octaves, hn_float lacunarity,
                         hn_float gain, hn_float depth, hn_uint seed) {
  hn_octaves2 o = hn_octaves(hn_tile(place, place.period), octaves, lacunarity, gain, seed);
  HN_I_PRECISE hn_float twice = footprint * 2.0f;
  o.sum.footprint = hn_i_footprint(twice);
  return hn_i_gullies(o, slope, depth);
}
HN_FN hn_vec3 hn_gullies(hn_place2 place, hn_vec2 slope, hn_int octaves, hn_float lacunarity, hn_float gain,
                         hn_float depth, hn_uint seed) {
  return hn_gullies(place, 0.0f, slope, octaves, lacunarity, gain, depth, seed);
}
HN_FN hn_vec3 hn_gullies(hn_vec2 p, hn_float footprint, hn_vec2 slope, hn_int octaves, hn_float lacunarity,
                         hn_float gain, hn_float depth, hn_uint seed) {
  return hn_gullies(hn_place(p), footprint, slope, octaves, lacunarity, gain, depth, seed);
}
HN_FN hn_vec3 hn_gullies(hn_vec2 p, hn_vec2 slope, hn_int octaves, hn_float lacunarity, hn_float gain, hn_float depth,
                         hn_uint seed) {
  return hn_gullies(hn_place(p), 0.0f, slope, octaves, lacunarity, gain, depth, seed);
}

#endif
