// hashnoise: value noise and its derivatives in space.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_D3D_GLSL
#define HN_VALUE_D3D_GLSL

#include "detail/cell.glsl"
#include "detail/derivative.glsl"
#include "detail/value.glsl"

// The noise and its derivatives, from the hashes of the corners of both faces.
HN_FN hn_vec4 hn_i_value_d(hn_uvec4 a, hn_uvec4 b, hn_i_num3 f) {
  hn_i_num3 t = hn_i_fade(f);
  hn_i_num3 s = hn_i_d_fade(f);
  hn_i_num2 t2 = hn_i_vector(t.x, t.y);
  hn_i_num2 s2 = hn_i_vector(s.x, s.y);
  hn_i_num3 front = hn_i_lerp_d(hn_i_numbers(a), t2, s2);
  hn_i_num3 back = hn_i_lerp_d(hn_i_numbers(b), t2, s2);
  return vec4(hn_i_value(hn_i_noise_of_numbers(hn_i_lerp(front.x, back.x, t.z))),
              hn_i_derivative(hn_i_of_d_corners(hn_i_lerp(front.y, back.y, t.z))),
              hn_i_derivative(hn_i_of_d_corners(hn_i_lerp(front.z, back.z, t.z))),
              hn_i_derivative(hn_i_of_d_corners(hn_i_d_faded(hn_i_d_corner(front.x, back.x), s.z))));
}

// Value noise in space and its slope: the value of hn_value with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec4 n = hn_value_d(vec3(uv * 8.0, 0.5), 7u);
//   returns  the value and its derivatives along x, y and z. A derivative is per cell, in [-3.76, 3.76], once
//            continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_value's, and of a derivative at most 1.27e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 3.18e-4. From a cell at most 1.27e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_value, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_vec4 hn_value_d(hn_place3 place, hn_uint seed) {
  hn_i_cell_corners3 corners = hn_i_cell_corners(place);
  return hn_i_value_d(hn_i_corner_hashes(corners, false, seed), hn_i_corner_hashes(corners, true, seed),
                      place.fraction);
}
HN_FN hn_vec4 hn_value_d(hn_vec3 p, hn_uint seed) { return hn_value_d(hn_place(p), seed); }
HN_FN hn_vec4 hn_value_d(hn_vec3 p) { return hn_value_d(p, 0u); }

#endif
