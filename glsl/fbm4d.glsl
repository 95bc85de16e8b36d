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
  hn_ivec4 period;
  bool tiled;
};

HN_FN hn_i_whole4 hn_i_position(hn_place4 place) {
  HN_I_NEW(hn_i_whole4, q);
  q.x = hn_i_whole(place.cell.x, place.fraction.x, place.rest.x);
  q.y = hn_i_whole(place.cell.y, place.fraction.y, place.rest.y);
  q.z = hn_i_whole(place.cell.z, place.fraction.z, place.rest.z);
  q.w = hn_i_whole(place.cell.w, place.fraction.w, place.rest.w);
  q.period = place.period;
  q.tiled = place.tiled;
  return q;
}
HN_FN hn_place4 hn_i_place_of(hn_i_whole4 q) {
  hn_place4 place = hn_i_place(
      ivec4(q.x.x, q.y.x, q.z.x, q.w.x),
      hn_i_num(hn_i_whole_fraction(q.x), hn_i_whole_fraction(q.y), hn_i_whole_fraction(q.z), hn_i_whole_fraction(q.w)),
      ivec4(HN_I_REST(q.x.y & 15), HN_I_REST(q.y.y & 15), HN_I_REST(q.z.y & 15), HN_I_REST(q.w.y & 15)));
  place.period = q.period;
  place.tiled = q.tiled;
  return place;
}

HN_FN hn_ivec4 hn_i_next_period(hn_ivec4 period, hn_float lacunarity) {
  return ivec4(hn_i_next_period(period.x, lacunarity), hn_i_next_period(period.y, lacunarity),
               hn_i_next_period(period.z, lacunarity), hn_i_next_period(period.w, lacunarity));
}

// The next position. A tile must not turn.
HN_FN hn_i_whole4 hn_i_next(hn_i_whole4 q, hn_float lacunarity) {
  hn_uint ratio = hn_i_ratio(lacunarity);
  hn_ivec2 x = hn_i_times_ratio(q.x, ratio);
  hn_ivec2 y = hn_i_times_ratio(q.y, ratio);
  hn_ivec2 z = hn_i_times_ratio(q.z, ratio);
  hn_ivec2 w = hn_i_times_ratio(q.w, ratio);
  hn_i_whole4 next = q;
  if (q.tiled) {
    next.x = hn_i_shifted(x, HN_I_SHIFT_X);
    next.y = hn_i_shifted(y, HN_I_SHIFT_Y);
    next.z = hn_i_shifted(z, HN_I_SHIFT_Z);
    next.w = hn_i_shifted(w, HN_I_SHIFT_W);
    next.period = hn_i_next_period(q.period, lacunarity);
  } else {
    hn_ivec2 turned_y = hn_i_rotated_axis(y, x, 25, 20);
    hn_ivec2 turned_z = hn_i_rotated_axis(z, turned_y, 29, 13);
    next.x = hn_i_shifted(hn_i_rotated_axis(x, y, 25, -20), HN_I_SHIFT_X);
    next.y = hn_i_shifted(hn_i_rotated_axis(turned_y, z, 29, -13), HN_I_SHIFT_Y);
    next.z = hn_i_shifted(hn_i_rotated_axis(turned_z, w, 25, -20), HN_I_SHIFT_Z);
    next.w = hn_i_shifted(hn_i_rotated_axis(w, turned_z, 25, 20), HN_I_SHIFT_W);
  }
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_POSITION4 hn_i_whole4

HN_FN hn_i_whole4 hn_i_position(hn_vec4 p) { return hn_i_position(hn_place(p)); }

#else

#define HN_I_POSITION4 hn_vec4

HN_FN hn_vec4 hn_i_position(hn_vec4 p) { return hn_i_start(p); }
HN_FN hn_place4 hn_i_place_of(hn_vec4 q) { return hn_place(q); }

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

#endif

#define HN_I_TYPES4 hn_vec4, hn_place4, HN_I_POSITION4, hn_i_whole4

// ---------------------------------------------------------------------------------------------------------------------
// Sums over other noises than hn_perlin: HN_FBM4D(my_sum, hn_value), outside of all functions and without a semicolon,
// and the others, as fbm2d.glsl says. The noise is called with a place and a seed.
#define HN_FBM4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_FBM)
#define HN_TURBULENCE4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_TURBULENCE)
#define HN_CLOUDS4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_CLOUDS)
#define HN_BILLOW4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_BILLOW)
#define HN_RIDGED4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_RIDGED)
#define HN_PING_PONG4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_PING_PONG)
#define HN_WEIGHTED4D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES4, HN_I_OF_WEIGHTED)
#define HN_FBM_LIMITED4D(name, noise) HN_I_LIMITED_OF(name, noise, HN_I_TYPES4)

// ---------------------------------------------------------------------------------------------------------------------
// Sums over hn_perlin, in the forms of fbm2d.glsl, where each is described. Ranges are those of the plane.

// The paper's gradient has no noise in four dimensions.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Fractional Brownian motion in four dimensions.
//   p, place    as on the plane, of four axes
//   octaves     how many; with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies, usually 2. In a tile it is a whole number from 1 to 255
//   gain        ratio of amplitudes, usually 0.5; not negative
//   seed        any uint: 7u, not 7; 0 if left out
//   returns     [-1, 1], mean 0
//   error       docs/accuracy.md
//   period      as on the plane
//   cost        1 noise per octave
//   source      Musgrave, as on the plane
HN_FBM4D(hn_fbm, hn_perlin)

// The same without detail that a pixel cannot show, with `detail` or `footprint` as on the plane.
//   (parameters as for hn_fbm at a position)
//   returns  [-1, 1], mean 0
HN_FBM_LIMITED4D(hn_fbm, hn_perlin)

// Turbulence: the mean of the octaves' absolute values.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]
HN_TURBULENCE4D(hn_turbulence, hn_perlin)

// Billows: twice the turbulence less 1.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [-1, 1]
HN_BILLOW4D(hn_billow, hn_perlin)

// Clouds: the density of a sky, from an fBm.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense
HN_CLOUDS4D(hn_clouds, hn_perlin)

// Ridges: sharp crests where the noise passes 0.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 1 on a crest of every octave
HN_RIDGED4D(hn_ridged, hn_perlin)

// Ping-pong: each octave is folded up and down between -1 and 1.
//   strength  how many times from one end to the other on the way from -1 to 1, times 1/2; in [0, 64]
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_PING_PONG4D(hn_ping_pong, hn_perlin)

// Weighted fBm: where an octave is low, the finer ones count less.
//   strength  how much less, in [0, 1]: 0 is hn_fbm
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_WEIGHTED4D(hn_weighted, hn_perlin)

#endif
#endif
