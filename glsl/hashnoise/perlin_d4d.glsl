// hashnoise: Perlin noise and its derivatives in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_D4D_GLSL
#define HN_PERLIN_D4D_GLSL

#include "detail/cell.glsl"
#include "detail/direction4d.glsl"
#include "detail/derivative.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The share of two corners of a cell along x in the noise: the interpolated ramp, its derivative along x, and what the
// gradients' y adds. Their z and w add rest. h are the hashes of the corners, and x, y, z and w the offsets
// from the first; x1 is that from the second along x.
HN_FN hn_i_num3 hn_i_lerp_ramps_d(hn_uvec2 h, hn_float x, hn_float x1, hn_float y, hn_float z, hn_float w,
                                  hn_i_num2 along, HN_I_OUT(hn_i_num2) rest) {
  hn_vec4 g = hn_i_direction4(h.x);
  hn_vec4 k = hn_i_direction4(h.y);
  hn_i_num a = hn_i_along4(g, x, y, z, w);
  hn_i_num b = hn_i_along4(k, x1, y, z, w);
  hn_float e = hn_i_exact(along.x);
  rest = hn_i_vector(hn_i_lerp_components4(g.z, k.z, e), hn_i_lerp_components4(g.w, k.w, e));
  return hn_i_vector(hn_i_lerp_ramps4(a, b, along.x),
                     hn_i_d_faded(hn_i_lerp_components4(g.x, k.x, e), hn_i_ramp_difference4(a, b), along.y),
                     hn_i_lerp_components4(g.y, k.y, e));
}

// The share of the square that z and w choose in the noise: the interpolated ramp, and its derivatives along x and y.
HN_FN hn_i_num3 hn_i_square_d(hn_uvec4 h, hn_i_num4 f, hn_float z, hn_float w, hn_i_num4 t, hn_i_num4 s,
                              HN_I_OUT(hn_i_num2) rest) {
  hn_i_num2 rest0;
  hn_i_num2 rest1;
  hn_float x = hn_i_offset(f.x);
  hn_float x1 = hn_i_far(x);
  hn_float y = hn_i_offset(f.y);
  hn_i_num2 along = hn_i_vector(t.x, s.x);
  hn_i_num3 n0 = hn_i_lerp_ramps_d(uvec2(h.x, h.y), x, x1, y, z, w, along, rest0);
  hn_i_num3 n1 = hn_i_lerp_ramps_d(uvec2(h.z, h.w), x, x1, hn_i_far(y), z, w, along, rest1);
  rest = hn_i_vector(hn_i_lerp(rest0.x, rest1.x, t.y), hn_i_lerp(rest0.y, rest1.y, t.y));
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.y), hn_i_lerp(n0.y, n1.y, t.y),
                     hn_i_d_faded(hn_i_lerp(n0.z, n1.z, t.y), hn_i_d_corner(n0.x, n1.x), s.y));
}

// The share of the two squares along z that w chooses in the noise: the interpolated ramp, and its derivatives along
// x, y and z.
HN_FN hn_i_num4 hn_i_cube_d(hn_i_cell_corners4 corners, hn_i_num4 f, bool far_w, hn_i_num4 t, hn_i_num4 s, hn_uint seed,
                            HN_I_OUT(hn_i_num) rest) {
  hn_i_num2 rest0;
  hn_i_num2 rest1;
  hn_float w = hn_i_offset(hn_i_select(far_w, hn_i_minus_one(f.w), f.w));
  hn_float z = hn_i_offset(f.z);
  hn_i_num3 n0 = hn_i_square_d(hn_i_corner_hashes(corners, false, far_w, seed), f, z, w, t, s, rest0);
  hn_i_num3 n1 = hn_i_square_d(hn_i_corner_hashes(corners, true, far_w, seed), f, hn_i_far(z), w, t, s, rest1);
  rest = hn_i_lerp(rest0.y, rest1.y, t.z);
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.z), hn_i_lerp(n0.y, n1.y, t.z), hn_i_lerp(n0.z, n1.z, t.z),
                     hn_i_d_faded(hn_i_lerp(rest0.x, rest1.x, t.z), hn_i_d_corner(n0.x, n1.x), s.z));
}

HN_FN hn_derivatives4 hn_i_perlin_d(hn_i_cell_corners4 corners, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 t = hn_i_fade(f);
  hn_i_num4 s = hn_i_d_fade(f);
  hn_i_num rest0;
  hn_i_num rest1;
  hn_i_num4 n0 = hn_i_cube_d(corners, f, false, t, s, seed, rest0);
  hn_i_num4 n1 = hn_i_cube_d(corners, f, true, t, s, seed, rest1);
  hn_i_num dw = hn_i_d_faded(hn_i_lerp(rest0, rest1, t.w), hn_i_d_corner(n0.x, n1.x), s.w);
  HN_I_NEW(hn_derivatives4, n);
  n.gradient = vec4(hn_i_derivative(hn_i_scaled4(hn_i_lerp(n0.y, n1.y, t.w))),
                    hn_i_derivative(hn_i_scaled4(hn_i_lerp(n0.z, n1.z, t.w))),
                    hn_i_derivative(hn_i_scaled4(hn_i_lerp(n0.w, n1.w, t.w))), hn_i_derivative(hn_i_scaled4(dw)));
  n.value = hn_i_value(hn_i_scaled4(hn_i_lerp(n0.x, n1.x, t.w)));
  return n;
}

// Perlin noise in four dimensions and its slope: the value of hn_perlin with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  hn_derivatives4 n = hn_perlin_d(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  value and, in gradient, its derivatives along x, y, z and w. A derivative is per cell, in
//            [-3.62, 3.62], once continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin's, and of a derivative at most 1.25e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 3.18e-4. From a cell at most 1.25e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_perlin, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_derivatives4 hn_perlin_d(hn_place4 place, hn_uint seed) {
  return hn_i_perlin_d(hn_i_cell_corners(place), place.fraction, seed);
}
HN_FN hn_derivatives4 hn_perlin_d(hn_vec4 p, hn_uint seed) { return hn_perlin_d(hn_place(p), seed); }
HN_FN hn_derivatives4 hn_perlin_d(hn_vec4 p) { return hn_perlin_d(p, 0u); }

#endif
#endif
