// hashnoise: octaves of curl noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_FBM2D_GLSL
#define HN_CURL_FBM2D_GLSL

// From here curl_fbm3d.glsl is generated from curl_fbm2d.glsl.

#include "curl2d.glsl"
#include "curl_phase2d.glsl"
#include "detail/jacobian.glsl"
#include "octaves2d.glsl"

// A sum of velocities, and the matrix of the octave that rotates its velocities back.
// Its numbers are apart: in lavapipe of Mesa 22.3 a point that has left a loop computes a vector once more, while other
// points go on (bugs.vector_behind_loop of the conformance suite).
struct hn_flows2 {
  hn_i_num x;
  hn_i_num y;
  hn_i_jacobian2 cofactors;
  hn_i_num gain;  // of these, from octave to octave
};

// Flows of any velocities, yours or the library's. Where no octave has a divergence, the sum has none:
//
//   hn_octaves2 o = hn_octaves(p, 4, 2.0, 0.5, 7u);
//   hn_flows2 s = hn_flows(o);
//   do hn_add(o, s, hn_curl(o.place, 0.25, o.seed)); while (hn_next(o));
//   vec2 velocity = hn_mean(o, s);
//
//   o        the octaves
//   s        the flows, from hn_flows(o)
//   v        the velocity at o.place. Integers cut it off beyond [-128, 128]
//   example  hn_flows2 s = hn_flows(o);
//   returns  hn_flows: flows to begin with; hn_mean: the velocity along each axis, as hn_curl_fbm
//   error    docs/measured/accuracy.md
//   cost     10 multiplications for the rotation of an octave
//   source   docs/reference/contract.md, section 7
HN_FN hn_flows2 hn_flows(hn_octaves2 o) {
  HN_I_NEW(hn_flows2, s);
  s.x = HN_I_NO_WEIGHT;
  s.y = HN_I_NO_WEIGHT;
  s.cofactors = hn_i_identity2();
  s.gain = o.sum.gain;
  return s;
}
HN_FN void hn_add(hn_octaves2 o, HN_I_INOUT(hn_flows2) s, hn_vec2 v) {
  hn_i_num2 u = hn_i_vector(hn_i_octave_slope(v.x), hn_i_octave_slope(v.y));
  u = hn_i_transposed_times(s.cofactors, u);
  s.x = hn_i_wide_plus(s.x, u.x);
  s.y = hn_i_wide_plus(s.y, u.y);
  s.cofactors = hn_i_next_cofactors(s.cofactors, s.gain, o.place.tiled);
}
HN_FN hn_vec2 hn_mean(hn_octaves2 o, hn_flows2 s) {
  hn_i_num total = hn_i_total(o.sum);
  return vec2(hn_i_derivative(hn_i_coarse(hn_i_mean(o.sum, s.x, total))),
              hn_i_derivative(hn_i_coarse(hn_i_mean(o.sum, s.y, total))));
}

HN_FN hn_vec2 hn_i_curl_fbm(hn_octaves2 o) {
  hn_flows2 s = hn_flows(o);
  do hn_add(o, s, hn_curl(o.place, o.seed));
  while (hn_next(o));
  return hn_mean(o, s);
}
HN_FN hn_vec2 hn_i_curl_fbm(hn_octaves2 o, hn_float phase) {
  hn_flows2 s = hn_flows(o);
  hn_i_curl_rotation2 rotation = hn_i_new_curl_rotation2(phase);
  do hn_add(o, s, hn_i_curl(o.place, rotation, o.seed));
  while (hn_next(o));
  return hn_mean(o, s);
}

// Octaves of curl noise: velocities of a flow with eddies of all sizes. It neither gathers nor spreads: each octave is
// rotated back, and nothing is cut off.
//   p           position, in cells of the first octave: a coordinate times a frequency, so that a cell is as large as
//               the largest hills. Less than 2^23 / lacunarity^octaves - 1 along each axis, for a lacunarity of 2 or
//               more: larger floats have no fraction
//   place       in place of p, in cells of the first octave: hn_place(cell, f) far from the origin, or
//               hn_tile(p, period) (place.glsl)
//   phase       in turns, before the octaves: the flow changes in place, and loops after one turn (hn_curl)
//   octaves     how many, usually 3 to 5; more than 32 count as 32, and with fewer than 1 the velocity is 0
//   lacunarity  ratio of frequencies from octave to octave, usually 2. In a tile it is a whole number from 1 to 255;
//               others are rounded down
//   gain        ratio of velocities, usually 0.5; not negative. Small eddies turn faster than large ones if it is more
//               than 1 / lacunarity
//   seed        any uint: 7u, not 7; 0 if left out; different seeds give independent flows
//   example     vec2 n = hn_curl_fbm(uv * 8.0, 4, 2.0, 0.5, 7u);
//   returns     the velocity along x and y: the mean of the octaves of hn_curl by their weights, per cell of each
//               octave. A component is at most 1.5 times the largest of hn_curl (HN_FIXED: in steps of 2^-19)
//   error       docs/measured/accuracy.md
//   period      none that floats reach, or the tile's
//   cost        hn_curl per octave, and 10 multiplications for its rotation
//   source      docs/reference/contract.md, section 7; Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid
//               flow", 2007
HN_FN hn_vec2 hn_curl_fbm(hn_place2 place, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_curl_fbm(hn_octaves(place, octaves, lacunarity, gain, seed));
}
HN_FN hn_vec2 hn_curl_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_curl_fbm(hn_octaves(p, octaves, lacunarity, gain, seed));
}
HN_FN hn_vec2 hn_curl_fbm(hn_vec2 p, hn_int octaves, hn_float lacunarity, hn_float gain) {
  return hn_curl_fbm(p, octaves, lacunarity, gain, 0u);
}
HN_FN hn_vec2 hn_curl_fbm(hn_place2 place, hn_float phase, hn_int octaves, hn_float lacunarity, hn_float gain,
                          hn_uint seed) {
  return hn_i_curl_fbm(hn_octaves(place, octaves, lacunarity, gain, seed), phase);
}
HN_FN hn_vec2 hn_curl_fbm(hn_vec2 p, hn_float phase, hn_int octaves, hn_float lacunarity, hn_float gain, hn_uint seed) {
  return hn_i_curl_fbm(hn_octaves(p, octaves, lacunarity, gain, seed), phase);
}

// To here curl_fbm3d.glsl is generated from curl_fbm2d.glsl.

#endif
