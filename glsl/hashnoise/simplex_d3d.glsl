// hashnoise: simplex noise and its derivatives in space.
// To read it in one piece: docs/reference/snippets/hn_simplex_d3.md
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_D3D_GLSL
#define HN_SIMPLEX_D3D_GLSL

#include "detail/body_centred_lattice.glsl"

// The share of a point in the noise and in its derivatives. The gradient may be rotated by a sixth of a turn.
HN_FN hn_i_num4 hn_i_weighted_ramp_d(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num t, bool turned) {
  return hn_i_weighted_ramp_d(hn_i_ramp_of(h, x, y, z, turned), hn_i_direction3(h, turned), x, y, z, hn_i_weight4(t),
                              hn_i_d_weight4(t, 2));
}

// The noise and its derivatives before they are scaled.
HN_FN hn_i_num4 hn_i_simplex_d(hn_uvec4 h, hn_i_num4 x, hn_i_num4 y, hn_i_num4 z, hn_i_num4 t, bool turned) {
  hn_i_num4 corners = hn_i_plus(hn_i_weighted_ramp_d(h.x, x.x, y.x, z.x, t.x, turned),
                                hn_i_weighted_ramp_d(h.y, x.y, y.y, z.y, t.y, turned));
  return hn_i_plus(hn_i_plus(corners, hn_i_weighted_ramp_d(h.z, x.z, y.z, z.z, t.z, turned)),
                   hn_i_weighted_ramp_d(h.w, x.w, y.w, z.w, t.w, turned));
}
HN_FN hn_vec4 hn_i_scaled_simplex_d(hn_i_num4 n) { return hn_i_scaled_d(n, 4918); }
HN_FN hn_vec4 hn_i_simplex_d(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, t);
  return hn_i_scaled_simplex_d(hn_i_simplex_d(h, x, y, z, t, false));
}

// Simplex noise in space and its slope: the value of hn_simplex with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec4 n = hn_simplex_d(vec3(uv * 8.0, 0.5), 7u);
//   returns  the value and its derivatives along x, y and z. A derivative is per cell, in [-4.81, 4.81], once
//            continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_simplex's, and of a derivative at most 2.78e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 9.84e-4. From a cell at most 2.78e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_simplex, which are most of its cost, and about twice the rest
//   source   the product rule on weight and ramp; docs/reference/contract.md, section 13
HN_FN hn_vec4 hn_simplex_d(hn_place3 place, hn_uint seed) {
  return hn_i_simplex_d(hn_i_neighbourhood(place), place.fraction, seed);
}
HN_FN hn_vec4 hn_simplex_d(hn_vec3 p, hn_uint seed) { return hn_simplex_d(hn_place(p), seed); }
HN_FN hn_vec4 hn_simplex_d(hn_vec3 p) { return hn_simplex_d(p, 0u); }

#endif
