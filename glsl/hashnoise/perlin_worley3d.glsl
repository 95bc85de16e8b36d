// hashnoise: Perlin-Worley noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_WORLEY3D_GLSL
#define HN_PERLIN_WORLEY3D_GLSL

#include "cellular3d.glsl"
#include "detail/jacobian.glsl"
#include "fbm3d.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// A billow around a point, of the distance to it. Twice a distance is exact, and in HN_FIXED the difference is.
HN_FN hn_float hn_i_billow_at(hn_float distance) {
  HN_I_PRECISE hn_float n = 1.0f - 2.0f * distance;
  return n;
}

// 1 - (1 - a) (1 - b) / 4
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_either(hn_float a, hn_float b) {
  HN_I_PRECISE hn_float neither = (1.0f - a) * (1.0f - b) * 0.25f;
  return hn_i_minus(1.0f, neither);
}
#else
HN_FN hn_int hn_i_either(hn_int a, hn_int b) {
  return HN_I_UNITS_VALUE - ((hn_i_wide_times(HN_I_UNITS_VALUE - a, HN_I_UNITS_VALUE - b) + 16) >> 5);
}
#endif

HN_FN hn_float hn_i_perlin_worley(hn_octaves3 wisps, hn_octaves3 billows) {
  hn_octaves3 o = billows;
  do hn_add(o, hn_i_billow_at(hn_cellular(o.place, o.seed).x));
  while (hn_next(o));
  return hn_i_value(hn_i_either(hn_i_bounded_octave(hn_i_fbm(wisps)), hn_i_bounded_octave(hn_mean(o))));
}

// Perlin-Worley noise, for volumes of clouds: round billows where the points of cellular noise are, and wisps of Perlin
// noise between them. In a tile it repeats along all three axes, so a texture of one tile fills a sky.
// Experimental: a later version may return other values.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest hills. Less than 2^23 / lacunarity^octaves - 1 along each axis, for a lacunarity of 2 or
//               more: larger floats have no fraction
//   place       in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl).
//               The period of a tile times lacunarity^octaves is below 2^31
//   octaves     how many of Perlin noise, usually 4 to 8; the first three have billows, too. More than 32 count as
//               32, and with fewer than 1 the result is 3/4
//   lacunarity  ratio of frequencies from octave to octave, usually 2. In a tile it is a whole number from 1 to 255;
//               others are rounded down
//   gain        ratio of amplitudes (persistence), usually 0.5; not negative
//   seed        any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example     float n = hn_perlin_worley(vec3(uv * 8.0, 0.5), 6, 2.0, 0.5, 7u);
//   returns     [0, 1], continuous. A cloud is where it is above a threshold, of about 0.75
//   error       docs/measured/accuracy.md
//   period      2^32 cells per axis, or the tile's
//   cost        hn_fbm, and three times hn_cellular in space, which is most of it
//   HN_FIXED    takes a gain above 1 as 1
//   source      Schneider and Vos, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn", 2015;
//               docs/reference/contract.md, section 25
HN_FN hn_float hn_perlin_worley(hn_place3 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_perlin_worley(hn_octaves(place, octaves, lacunarity, gain, seed),
                            hn_octaves(place, min(octaves, 3), lacunarity, gain, hn_i_other_seed(seed)));
}
HN_FN hn_float hn_perlin_worley(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_perlin_worley(hn_octaves(p, octaves, lacunarity, gain, seed),
                            hn_octaves(p, min(octaves, 3), lacunarity, gain, hn_i_other_seed(seed)));
}
HN_FN hn_float hn_perlin_worley(hn_vec3 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_perlin_worley(p, octaves, lacunarity, gain, 0u);
}

#endif
#endif
