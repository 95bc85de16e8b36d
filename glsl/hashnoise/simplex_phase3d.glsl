// hashnoise: simplex noise in space whose gradients rotate with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_PHASE3D_GLSL
#define HN_SIMPLEX_PHASE3D_GLSL

#include "detail/direction_turning.glsl"
#include "simplex3d.glsl"
#include "simplex_d3d.glsl"

// The noise in the numbers of HN_ARITHMETIC. Its weighted ramps sum up to at most 1024 / 4902 (tools/make bounds).
HN_FN hn_i_num hn_i_simplex_phase(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, t);
  return hn_i_scaled(hn_i_mixed(rotation, hn_i_simplex(h, x, y, z, t, false), hn_i_simplex(h, x, y, z, t, true)), 4902);
}

// The noise and its derivatives.
HN_FN hn_vec4 hn_i_simplex_phase_d(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, t);
  return hn_i_scaled_d(hn_i_mixed(rotation, hn_i_simplex_d(h, x, y, z, t, false), hn_i_simplex_d(h, x, y, z, t, true)),
                       4902);
}

// Simplex noise in space whose gradients rotate with a phase: the field changes in place, and loops after one turn.
// Each gradient rotates across a diagonal of a cell.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and at phase + 1/2 it is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  float n = hn_simplex(vec3(uv * 8.0, 0.5), 0.25, 7u);
//   returns  [-1, 1] (proven bound 0.99954), mean 0, 0 at lattice points, twice continuously differentiable, and smooth
//            in the phase. With a phase of 0 it is hn_simplex times 4902/4918, within the error.
//   error    at most 6.60e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            2.48e-4
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_simplex, a sine and a cosine of 6 multiplications of floats each, and twice the rest
//   source   Perlin and Neyret, "Flow noise", 2001; docs/reference/contract.md, section 14
HN_FN hn_float hn_simplex(hn_place3 place, hn_float phase, hn_uint seed) {
  return hn_i_value(hn_i_simplex_phase(hn_i_neighbourhood(place), place.fraction, hn_i_rotation3(phase), seed));
}
HN_FN hn_float hn_simplex(hn_vec3 p, hn_float phase, hn_uint seed) { return hn_simplex(hn_place(p), phase, seed); }

// The noise with the derivatives along x, y and z, as of hn_simplex_d. The value is as above.
//   example  vec4 n = hn_simplex_d(vec3(uv * 8.0, 0.5), 0.25, 7u);
//   returns  the value and its derivatives, per cell, in [-5.6, 5.6]
//   error    of a derivative at most 4.06e-5. HN_FIXED 1.28e-3
//   cost     as above, and about twice the rest
//   (parameters as above)
HN_FN hn_vec4 hn_simplex_d(hn_place3 place, hn_float phase, hn_uint seed) {
  return hn_i_simplex_phase_d(hn_i_neighbourhood(place), place.fraction, hn_i_rotation3(phase), seed);
}
HN_FN hn_vec4 hn_simplex_d(hn_vec3 p, hn_float phase, hn_uint seed) { return hn_simplex_d(hn_place(p), phase, seed); }

#endif
