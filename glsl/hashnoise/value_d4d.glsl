// hashnoise: value noise and its derivatives in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_D4D_GLSL
#define HN_VALUE_D4D_GLSL

#include "detail/cell.glsl"
#include "detail/derivative.glsl"
#include "detail/value.glsl"

// The share of the two squares along z that w chooses in the noise: the value, and its derivatives along x, y and z.
HN_FN hn_i_num4 hn_i_value_cube_d(hn_i_cell_corners4 corners, bool far_w, hn_i_num4 t, hn_i_num4 s, hn_uint seed) {
  hn_i_num2 t2 = hn_i_vector(t.x, t.y);
  hn_i_num2 s2 = hn_i_vector(s.x, s.y);
  hn_i_num3 front = hn_i_lerp_d(hn_i_numbers(hn_i_corner_hashes(corners, false, far_w, seed)), t2, s2);
  hn_i_num3 back = hn_i_lerp_d(hn_i_numbers(hn_i_corner_hashes(corners, true, far_w, seed)), t2, s2);
  return hn_i_vector(hn_i_lerp(front.x, back.x, t.z), hn_i_lerp(front.y, back.y, t.z), hn_i_lerp(front.z, back.z, t.z),
                     hn_i_d_faded(hn_i_d_corner(front.x, back.x), s.z));
}

HN_FN hn_derivatives4 hn_i_value_d(hn_i_cell_corners4 corners, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 t = hn_i_fade(f);
  hn_i_num4 s = hn_i_d_fade(f);
  hn_i_num4 a = hn_i_value_cube_d(corners, false, t, s, seed);
  hn_i_num4 b = hn_i_value_cube_d(corners, true, t, s, seed);
  HN_I_NEW(hn_derivatives4, n);
  n.gradient = vec4(hn_i_derivative(hn_i_of_d_corners(hn_i_lerp(a.y, b.y, t.w))),
                    hn_i_derivative(hn_i_of_d_corners(hn_i_lerp(a.z, b.z, t.w))),
                    hn_i_derivative(hn_i_of_d_corners(hn_i_lerp(a.w, b.w, t.w))),
                    hn_i_derivative(hn_i_of_d_corners(hn_i_d_faded(hn_i_d_corner(a.x, b.x), s.w))));
  n.value = hn_i_value(hn_i_noise_of_numbers(hn_i_lerp(a.x, b.x, t.w)));
  return n;
}

// Value noise in four dimensions and its slope: the value of hn_value with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  hn_derivatives4 n = hn_value_d(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  value and, in gradient, its derivatives along x, y, z and w. A derivative is per cell, in
//            [-3.76, 3.76], once continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_value's, and of a derivative at most 1.61e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 3.65e-4. From a cell at most 1.61e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_value, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_derivatives4 hn_value_d(hn_place4 place, hn_uint seed) {
  return hn_i_value_d(hn_i_cell_corners(place), place.fraction, seed);
}
HN_FN hn_derivatives4 hn_value_d(hn_vec4 p, hn_uint seed) { return hn_value_d(hn_place(p), seed); }
HN_FN hn_derivatives4 hn_value_d(hn_vec4 p) { return hn_value_d(p, 0u); }

#endif
