// hashnoise: simplex noise on the plane whose gradients rotate with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_PHASE2D_GLSL
#define HN_SIMPLEX_PHASE2D_GLSL

#include "detail/direction_turning.glsl"
#include "simplex2d.glsl"
#include "simplex_d2d.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_simplex_phase(hn_place2 place, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  hn_uvec3 h = hn_i_triangle(place, skewed, seed);
  return hn_i_scaled_simplex2(hn_i_mixed(rotation, hn_i_simplex(h, skewed, false), hn_i_simplex(h, skewed, true)));
}

// The noise and its derivatives.
HN_FN hn_vec3 hn_i_simplex_phase_d(hn_place2 place, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  hn_uvec3 h = hn_i_triangle(place, skewed, seed);
  return hn_i_scaled_simplex_d(hn_i_mixed(rotation, hn_i_simplex_d(h, skewed, false), hn_i_simplex_d(h, skewed, true)));
}

// Simplex noise on the plane whose gradients rotate with a phase: the field changes in place, and loops after one turn.
// All gradients rotate alike.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and at phase + 1/2 it is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  float n = hn_simplex(uv * 8.0, 0.25, 7u);
//   returns  [-1, 1] (proven bound 0.99952), mean 0, 0 at lattice points, twice continuously differentiable, and smooth
//            in the phase. With a phase of 0 it is hn_simplex, within the error.
//   error    at most 4.34e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            2.38e-4
//   period   2^31 cells per axis, or the tile's
//   cost     the hashes of hn_simplex, a sine and a cosine of 6 multiplications of floats each, and twice the rest
//   source   Perlin and Neyret, "Flow noise", 2001; docs/reference/contract.md, section 14
HN_FN hn_float hn_simplex(hn_place2 place, hn_float phase, hn_uint seed) {
  return hn_i_value(hn_i_simplex_phase(place, hn_i_rotation(phase), seed));
}
HN_FN hn_float hn_simplex(hn_vec2 p, hn_float phase, hn_uint seed) { return hn_simplex(hn_place(p), phase, seed); }

// The noise with the derivatives along x and y, as of hn_simplex_d. The value is as above.
//   example  vec3 n = hn_simplex_d(uv * 8.0, 0.25, 7u);
//   returns  the value and its derivatives, per cell, in [-8.64, 8.64]
//   error    of a derivative at most 3.70e-5. HN_FIXED 3.08e-3
//   cost     as above, and about twice the rest
//   (parameters as above)
HN_FN hn_vec3 hn_simplex_d(hn_place2 place, hn_float phase, hn_uint seed) {
  return hn_i_simplex_phase_d(place, hn_i_rotation(phase), seed);
}
HN_FN hn_vec3 hn_simplex_d(hn_vec2 p, hn_float phase, hn_uint seed) { return hn_simplex_d(hn_place(p), phase, seed); }

#endif
