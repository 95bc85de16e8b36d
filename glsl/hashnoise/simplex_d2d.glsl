// hashnoise: simplex noise and its derivatives on the plane.
// To read it in one piece: docs/reference/snippets/hn_simplex_d2.md
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_D2D_GLSL
#define HN_SIMPLEX_D2D_GLSL

#include "detail/triangular_lattice.glsl"

// The share of a corner in the noise and in its derivatives, in steps. The gradient may be rotated by a quarter turn.
HN_FN hn_i_num3 hn_i_weighted_ramp_d(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num t, bool turned) {
  return hn_i_weighted_ramp_d(hn_i_triangle_ramp(h, x, y, turned), hn_i_direction2(h, turned), x, y,
                              hn_i_weight_plane(t), hn_i_d_weight_plane(t, 1));
}

// The noise and its derivatives before they are scaled, from the hashes of the corners.
HN_FN hn_i_num3 hn_i_simplex_d(hn_uvec3 h, hn_i_num2 skewed, bool turned) {
  hn_i_num3 x = hn_i_triangle_x(skewed);
  hn_i_num3 y = hn_i_triangle_y(skewed);
  hn_i_num3 t = hn_i_triangle_falloff(x, y);
  return hn_i_plus(
      hn_i_plus(hn_i_weighted_ramp_d(h.x, x.x, y.x, t.x, turned), hn_i_weighted_ramp_d(h.y, x.y, y.y, t.y, turned)),
      hn_i_weighted_ramp_d(h.z, x.z, y.z, t.z, turned));
}
HN_FN hn_vec3 hn_i_scaled_simplex_d(hn_i_num3 n) {
  return vec3(hn_i_value(hn_i_scaled_simplex2(n.x)), hn_i_per_cell(hn_i_derivative(hn_i_scaled_simplex2(n.y))),
              hn_i_per_cell(hn_i_derivative(hn_i_scaled_simplex2(n.z))));
}
HN_FN hn_vec3 hn_i_simplex_d(hn_uvec3 h, hn_i_num2 skewed) {
  return hn_i_scaled_simplex_d(hn_i_simplex_d(h, skewed, false));
}
HN_FN hn_vec3 hn_i_simplex_d(hn_place2 place, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  return hn_i_simplex_d(hn_i_triangle(place, skewed, seed), skewed);
}

// Simplex noise on the plane and its slope: the value of hn_simplex with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec3 n = hn_simplex_d(uv * 8.0, 7u);
//   returns  the value and its derivatives along x and y. A derivative is per cell, in [-8.46, 8.46], once continuously
//            differentiable (HN_FIXED: in steps of 2^-18)
//   error    hn_simplex's, and of a derivative at most 3.34e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 2.49e-3. From a cell at most 2.60e-5
//   period   2^31 cells per axis, or the tile's
//   cost     the hashes of hn_simplex, which are most of its cost, and about twice the rest
//   source   the product rule on weight and ramp; docs/reference/contract.md, section 13
HN_FN hn_vec3 hn_simplex_d(hn_place2 place, hn_uint seed) { return hn_i_simplex_d(place, seed); }
HN_FN hn_vec3 hn_simplex_d(hn_vec2 p, hn_uint seed) { return hn_simplex_d(hn_place(p), seed); }
HN_FN hn_vec3 hn_simplex_d(hn_vec2 p) { return hn_simplex_d(p, 0u); }

#endif
