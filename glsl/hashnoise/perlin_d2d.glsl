// hashnoise: Perlin noise and its derivatives on the plane.
// To read it in one piece: docs/reference/snippets/hn_perlin_d2.md
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_D2D_GLSL
#define HN_PERLIN_D2D_GLSL

#include "detail/direction.glsl"
#include "detail/derivative.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The share of two corners along x: the interpolated ramp, its derivative along x, and what the gradients' other
// components add. a and b are the ramps, g and h the gradients, t the fade and s its slope.
HN_FN hn_i_num3 hn_i_lerp_ramps_d(hn_i_num a, hn_i_num b, hn_vec2 g, hn_vec2 h, hn_i_num t, hn_i_num s) {
  hn_float e = hn_i_exact(t);
  return hn_i_vector(hn_i_lerp_ramps2(a, b, t),
                     hn_i_d_faded(hn_i_lerp_components(g.x, h.x, e), hn_i_ramp_difference2(a, b), s),
                     hn_i_lerp_components(g.y, h.y, e));
}

// The noise and its derivatives before they are scaled, from the hashes of the corners, the fades and their slopes. The
// gradients may be rotated by a quarter turn.
HN_FN hn_i_num3 hn_i_perlin_d(hn_uvec4 h, hn_i_num2 f, hn_i_num2 t, hn_i_num2 s, bool turned) {
  hn_i_num4 r = hn_i_ramps(h, f, turned);
  hn_i_num3 n0 = hn_i_lerp_ramps_d(r.x, r.y, hn_i_direction2(h.x, turned), hn_i_direction2(h.y, turned), t.x, s.x);
  hn_i_num3 n1 = hn_i_lerp_ramps_d(r.z, r.w, hn_i_direction2(h.z, turned), hn_i_direction2(h.w, turned), t.x, s.x);
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.y), hn_i_lerp(n0.y, n1.y, t.y),
                     hn_i_d_faded(hn_i_lerp(n0.z, n1.z, t.y), hn_i_d_corner(n0.x, n1.x), s.y));
}
HN_FN hn_vec3 hn_i_scaled_perlin_d(hn_i_num3 n) {
  return vec3(hn_i_value(hn_i_scaled2(n.x)), hn_i_derivative(hn_i_scaled2(n.y)), hn_i_derivative(hn_i_scaled2(n.z)));
}
HN_FN hn_vec3 hn_i_perlin_d(hn_uvec4 h, hn_i_num2 f) {
  return hn_i_scaled_perlin_d(hn_i_perlin_d(h, f, hn_i_fade(f), hn_i_d_fade(f), false));
}

// Perlin noise on the plane and its slope: the value of hn_perlin with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec3 n = hn_perlin_d(uv * 8.0, 7u);
//   returns  the value and its derivatives along x and y. A derivative is per cell, in [-2.91, 2.91], once continuously
//            differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin's, and of a derivative at most 9.48e-6 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 2.01e-4. From a cell at most 9.00e-6
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_perlin, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_vec3 hn_perlin_d(hn_place2 place, hn_uint seed) {
  return hn_i_perlin_d(hn_i_corner_hashes(hn_i_cell_corners(place), seed), place.fraction);
}
HN_FN hn_vec3 hn_perlin_d(hn_vec2 p, hn_uint seed) { return hn_perlin_d(hn_place(p), seed); }
HN_FN hn_vec3 hn_perlin_d(hn_vec2 p) { return hn_perlin_d(p, 0u); }

#endif
#endif
