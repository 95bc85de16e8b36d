// hashnoise: octave sums over a noise in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM4D_GLSL
#define HN_FBM4D_GLSL

#include "octaves.glsl"
#include "perlin4d.glsl"

// A whole position; each axis is one of octaves.glsl.
struct hn_i_whole4 {
  hn_ivec2 x;
  hn_ivec2 y;
  hn_ivec2 z;
  hn_ivec2 w;
};

HN_FN hn_ivec4 hn_i_cell_of(hn_i_whole4 q) { return ivec4(q.x.x, q.y.x, q.z.x, q.w.x); }
HN_FN hn_vec4 hn_i_place_of(hn_i_whole4 q) {
  return vec4(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y), hn_i_whole_fraction(q.z), hn_i_whole_fraction(q.w));
}

HN_FN hn_i_whole4 hn_i_position(hn_ivec4 cell, hn_vec4 f) {
  HN_I_NEW(hn_i_whole4, q);
  q.x = hn_i_whole(cell.x, f.x);
  q.y = hn_i_whole(cell.y, f.y);
  q.z = hn_i_whole(cell.z, f.z);
  q.w = hn_i_whole(cell.w, f.w);
  return q;
}

// 5767168 and others are the shifts, in units of 2^-24.
HN_FN hn_i_whole4 hn_i_next_tile(hn_i_whole4 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  HN_I_NEW(hn_i_whole4, next);
  next.x = hn_i_shifted(hn_i_times_ratio(q.x, ratio), 5767168);
  next.y = hn_i_shifted(hn_i_times_ratio(q.y, ratio), 9961472);
  next.z = hn_i_shifted(hn_i_times_ratio(q.z, ratio), 12058624);
  next.w = hn_i_shifted(hn_i_times_ratio(q.w, ratio), 14155776);
  return next;
}

// The turns are those of space, and then one in the plane of z and w.
HN_FN hn_i_whole4 hn_i_next(hn_i_whole4 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  hn_ivec2 z = hn_i_times_ratio(q.z, ratio);
  hn_ivec2 w = hn_i_times_ratio(q.w, ratio);
  hn_ivec2 turned_y = hn_i_turned_axis(y, x, 25, 20);
  hn_ivec2 turned_z = hn_i_turned_axis(z, turned_y, 29, 13);
  HN_I_NEW(hn_i_whole4, next);
  next.x = hn_i_shifted(hn_i_turned_axis(x, y, 25, -20), 5767168);
  next.y = hn_i_shifted(hn_i_turned_axis(turned_y, z, 29, -13), 9961472);
  next.z = hn_i_shifted(hn_i_turned_axis(turned_z, w, 25, -20), 12058624);
  next.w = hn_i_shifted(hn_i_turned_axis(w, turned_z, 25, 20), 14155776);
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_PLACE4 hn_i_whole4

HN_FN hn_i_whole4 hn_i_position(hn_vec4 p) {
  HN_I_NEW(hn_i_whole4, q);
  q.x = hn_i_whole(p.x);
  q.y = hn_i_whole(p.y);
  q.z = hn_i_whole(p.z);
  q.w = hn_i_whole(p.w);
  return q;
}

#else

#define HN_I_PLACE4 hn_vec4

HN_FN hn_vec4 hn_i_position(hn_vec4 p) { return hn_i_start(p); }
HN_FN hn_ivec4 hn_i_cell_of(hn_vec4 q) { return hn_i_cell(q); }
HN_FN hn_vec4 hn_i_place_of(hn_vec4 q) { return hn_i_fraction(q); }

HN_FN hn_vec4 hn_i_next(hn_vec4 q, hn_float lacunarity) {
  hn_float a = hn_i_times(lacunarity, 25.0f / 32.0f);
  hn_float b = hn_i_times(lacunarity, 20.0f / 32.0f);
  hn_float c = hn_i_times(lacunarity, 29.0f / 32.0f);
  hn_float d = hn_i_times(lacunarity, 13.0f / 32.0f);
  HN_I_PRECISE hn_float y = b * q.x + a * q.y;
  HN_I_PRECISE hn_float z = 13.0f / 32.0f * y + c * q.z;
  HN_I_PRECISE hn_vec4 next =
      vec4(a * q.x - b * q.y + 11.0f / 32.0f, 29.0f / 32.0f * y - d * q.z + 19.0f / 32.0f,
           25.0f / 32.0f * z - b * q.w + 23.0f / 32.0f, 20.0f / 32.0f * z + a * q.w + 27.0f / 32.0f);
  return next;
}

HN_FN hn_vec4 hn_i_next_tile(hn_vec4 q, hn_float lacunarity) {
  return hn_i_times_plus(q, lacunarity, vec4(11.0f / 32.0f, 19.0f / 32.0f, 23.0f / 32.0f, 27.0f / 32.0f));
}

#endif

HN_FN hn_ivec4 hn_i_next_period(hn_ivec4 period, hn_float lacunarity) {
  return ivec4(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity),
               hn_i_next_period(period.z, lacunarity), hn_i_next_period(period.w, lacunarity));
}

#define HN_I_TYPES4 hn_vec4, hn_ivec4, HN_I_PLACE4, hn_i_whole4

// ---------------------------------------------------------------------------------------------------------------------
// Sums over other noises than hn_perlin: HN_FBM4D(my_sum, hn_value), outside of all functions and without a semicolon,
// and the others, as fbm2d.glsl says. The noise is called with an ivec4, a place in that cell and a seed.
#define HN_FBM4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_FBM)
#define HN_FBM_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_FBM)
#define HN_TURBULENCE4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_TURBULENCE)
#define HN_TURBULENCE_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_TURBULENCE)
#define HN_CLOUDS4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_CLOUDS)
#define HN_CLOUDS_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_CLOUDS)
#define HN_BILLOW4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_BILLOW)
#define HN_BILLOW_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_BILLOW)
#define HN_RIDGED4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_RIDGED)
#define HN_RIDGED_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_RIDGED)
#define HN_PING_PONG4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_PING_PONG)
#define HN_PING_PONG_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_PING_PONG)
#define HN_WEIGHTED4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_WEIGHTED)
#define HN_WEIGHTED_PERIOD4D(name, noise) HN_I_TILED_OF(name, noise, HN_I_TYPES4, HN_I_OF_WEIGHTED)
#define HN_FBM_LIMITED4D(name, noise) HN_I_LIMITED_OF(name, noise, HN_I_TYPES4)

// ---------------------------------------------------------------------------------------------------------------------
// Sums over hn_perlin, in the forms of fbm2d.glsl, where each is described. Ranges are those of the plane.

// The paper's gradient has no noise in four dimensions.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Fractional Brownian motion in four dimensions.
//   p, cell, f, period   as on the plane, of four axes
//   octaves     how many; with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies, usually 2. With a period it is a whole number from 1 to 255
//   gain        ratio of amplitudes, usually 0.5; not negative
//   seed        any uint: 7u, not 7; 0 if left out
//   returns     [-1, 1], mean 0
//   error       docs/accuracy.md
//   period      as on the plane
//   cost        1 noise per octave
//   source      Musgrave, as on the plane
HN_FBM4D(hn_fbm, hn_perlin)
HN_FBM_PERIOD4D(hn_fbm, hn_perlin)

// The same without detail that a pixel cannot show, with `detail` or `footprint` as on the plane.
//   (parameters as for hn_fbm at a position)
//   returns  [-1, 1], mean 0
HN_FBM_LIMITED4D(hn_fbm, hn_perlin)

// Turbulence: the mean of the octaves' absolute values.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]
HN_TURBULENCE4D(hn_turbulence, hn_perlin)
HN_TURBULENCE_PERIOD4D(hn_turbulence, hn_perlin)

// Billows: twice the turbulence less 1.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [-1, 1]
HN_BILLOW4D(hn_billow, hn_perlin)
HN_BILLOW_PERIOD4D(hn_billow, hn_perlin)

// Clouds: the density of a sky, from an fBm.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense
HN_CLOUDS4D(hn_clouds, hn_perlin)
HN_CLOUDS_PERIOD4D(hn_clouds, hn_perlin)

// Ridges: sharp crests where the noise passes 0.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 1 on a crest of every octave
HN_RIDGED4D(hn_ridged, hn_perlin)
HN_RIDGED_PERIOD4D(hn_ridged, hn_perlin)

// Ping-pong: each octave is folded up and down between -1 and 1.
//   strength  how many times from one end to the other on the way from -1 to 1, times 1/2; in [0, 64]
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_PING_PONG4D(hn_ping_pong, hn_perlin)
HN_PING_PONG_PERIOD4D(hn_ping_pong, hn_perlin)

// Weighted fBm: where an octave is low, the finer ones count less.
//   strength  how much less, in [0, 1]: 0 is hn_fbm
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_WEIGHTED4D(hn_weighted, hn_perlin)
HN_WEIGHTED_PERIOD4D(hn_weighted, hn_perlin)

#endif
#endif
