// hashnoise: value noise and its derivatives on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_D2D_GLSL
#define HN_VALUE_D2D_GLSL

#include "detail/cell2d.glsl"
#include "detail/derivative.glsl"
#include "detail/value.glsl"

// The noise and its derivatives, from the hashes of the corners.
HN_FN hn_vec3 hn_i_value_d(hn_uvec4 h, hn_i_num2 f) {
  hn_i_num2 t = hn_i_fade(f);
  hn_i_num3 n = hn_i_lerp_d(hn_i_numbers(h), t, hn_i_d_fade(f));
  return vec3(hn_i_value(hn_i_noise_of_numbers(n.x)), hn_i_derivative(hn_i_of_d_corners(n.y)),
              hn_i_derivative(hn_i_of_d_corners(n.z)));
}

// Value noise on the plane and its slope: the value of hn_value with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec3 n = hn_value_d(uv * 8.0, 7u);
//   returns  the value and its derivatives along x and y. A derivative is per cell, in [-3.76, 3.76], once continuously
//            differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_value's, and of a derivative at most 8.68e-6 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 2.86e-4. From a cell at most 8.56e-6
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_value, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_vec3 hn_value_d(hn_place2 place, hn_uint seed) {
  return hn_i_value_d(hn_i_corner_hashes(hn_i_cell_corners(place), seed), place.fraction);
}
HN_FN hn_vec3 hn_value_d(hn_vec2 p, hn_uint seed) { return hn_value_d(hn_place(p), seed); }
HN_FN hn_vec3 hn_value_d(hn_vec2 p) { return hn_value_d(p, 0u); }

#endif
