// hashnoise: octave sums over a noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM1D_GLSL
#define HN_FBM1D_GLSL

#include "octaves.glsl"
#include "perlin1d.glsl"

// A whole position is an axis of octaves.glsl. On the line nothing can turn.
struct hn_i_whole1 {
  hn_ivec2 x;
  hn_int period;
  bool tiled;
};

HN_FN hn_i_whole1 hn_i_position(hn_place1 place) {
  HN_I_NEW(hn_i_whole1, q);
  q.x = hn_i_whole(place.cell, place.fraction, place.rest);
  q.period = place.period;
  q.tiled = place.tiled;
  return q;
}
HN_FN hn_place1 hn_i_place_of(hn_i_whole1 q) {
  hn_place1 place = hn_i_place(q.x.x, hn_i_whole_fraction(q.x), HN_I_REST(q.x.y & 15));
  place.period = q.period;
  place.tiled = q.tiled;
  return place;
}

HN_FN hn_i_whole1 hn_i_next(hn_i_whole1 q, hn_float lacunarity) {
  hn_i_whole1 next = q;
  next.x = hn_i_shifted(hn_i_times_ratio(q.x, hn_i_ratio(lacunarity)), HN_I_SHIFT_X);
  if (q.tiled) next.period = hn_i_next_period(q.period, lacunarity);
  return next;
}

#if HN_ARITHMETIC == HN_FIXED

#define HN_I_POSITION1 hn_i_whole1

HN_FN hn_i_whole1 hn_i_position(hn_float p) { return hn_i_position(hn_place(p)); }

#else

#define HN_I_POSITION1 hn_float

HN_FN hn_float hn_i_position(hn_float p) { return hn_i_start(p); }
HN_FN hn_place1 hn_i_place_of(hn_float q) { return hn_place(q); }
HN_FN hn_float hn_i_next(hn_float q, hn_float lacunarity) { return hn_i_times_plus(q, lacunarity, 11.0f / 32.0f); }

#endif

#define HN_I_TYPES1 hn_float, hn_place1, HN_I_POSITION1, hn_i_whole1

// ---------------------------------------------------------------------------------------------------------------------
// Sums over other noises than hn_perlin: HN_FBM1D(my_sum, hn_value), outside of all functions and without a semicolon,
// and the others, as fbm2d.glsl says. The noise is called with a place and a seed.
#define HN_FBM1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_FBM)
#define HN_TURBULENCE1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_TURBULENCE)
#define HN_CLOUDS1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_CLOUDS)
#define HN_BILLOW1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_BILLOW)
#define HN_RIDGED1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_RIDGED)
#define HN_PING_PONG1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_PING_PONG)
#define HN_WEIGHTED1D(name, noise) HN_I_SUMS_OF(name, noise, HN_I_TYPES1, HN_I_OF_WEIGHTED)
#define HN_FBM_LIMITED1D(name, noise) HN_I_LIMITED_OF(name, noise, HN_I_TYPES1)

// ---------------------------------------------------------------------------------------------------------------------
// Sums over hn_perlin, in the forms of fbm2d.glsl, where each is described. Ranges are those of the plane.

// The paper's gradient has no noise on the line.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Fractional Brownian motion on the line.
//   p, place    as on the plane, of one axis
//   octaves     how many; with fewer than 1 the sum is 0
//   lacunarity  ratio of frequencies, usually 2. In a tile it is a whole number from 1 to 255
//   gain        ratio of amplitudes, usually 0.5; not negative
//   seed        any uint: 7u, not 7; 0 if left out
//   returns     [-1, 1], mean 0
//   error       docs/accuracy.md
//   period      as on the plane
//   cost        1 noise per octave
//   source      Musgrave, as on the plane
HN_FBM1D(hn_fbm, hn_perlin)

// The same without detail that a pixel cannot show, with `detail` or `footprint` as on the plane.
//   (parameters as for hn_fbm at a position)
//   returns  [-1, 1], mean 0
HN_FBM_LIMITED1D(hn_fbm, hn_perlin)

// Turbulence: the mean of the octaves' absolute values.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]
HN_TURBULENCE1D(hn_turbulence, hn_perlin)

// Billows: twice the turbulence less 1.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [-1, 1]
HN_BILLOW1D(hn_billow, hn_perlin)

// Clouds: the density of a sky, from an fBm.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 0 is clear, 1 is dense
HN_CLOUDS1D(hn_clouds, hn_perlin)

// Ridges: sharp crests where the noise passes 0.
//   (parameters, error, period, cost and source as for hn_fbm)
//   returns  [0, 1]: 1 on a crest of every octave
HN_RIDGED1D(hn_ridged, hn_perlin)

// Ping-pong: each octave is folded up and down between -1 and 1.
//   strength  how many times from one end to the other on the way from -1 to 1, times 1/2; in [0, 64]
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_PING_PONG1D(hn_ping_pong, hn_perlin)

// Weighted fBm: where an octave is low, the finer ones count less.
//   strength  how much less, in [0, 1]: 0 is hn_fbm
//   (other parameters, error, period, cost and source as for hn_fbm)
//   returns   [-1, 1]
HN_WEIGHTED1D(hn_weighted, hn_perlin)

#endif
#endif
