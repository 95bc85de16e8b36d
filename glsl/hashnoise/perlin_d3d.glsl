// hashnoise: Perlin noise and its derivatives in space.
// To read it in one piece: docs/reference/snippets/hn_perlin_d3.md
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_D3D_GLSL
#define HN_PERLIN_D3D_GLSL

#include "detail/direction3d.glsl"
#include "detail/derivative.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The share of two corners along x: the interpolated ramp, its derivative along x, and what the gradients' other
// components add. a and b are the ramps, g and h the gradients, t the fade and s its slope.
HN_FN hn_i_num4 hn_i_lerp_ramps_d(hn_i_num a, hn_i_num b, hn_vec3 g, hn_vec3 h, hn_i_num t, hn_i_num s) {
  hn_float e = hn_i_exact(t);
  return hn_i_vector(hn_i_lerp_ramps3(a, b, t),
                     hn_i_d_faded(hn_i_lerp_components(g.x, h.x, e), hn_i_ramp_difference3(a, b), s),
                     hn_i_lerp_components(g.y, h.y, e), hn_i_lerp_components(g.z, h.z, e));
}

// The share of a face, from the hashes of its corners: the interpolated ramp, its derivatives along x and y, and what
// the gradients' last components add. The gradients may be rotated by a sixth of a turn.
HN_FN hn_i_num4 hn_i_bilerp_ramps_d(hn_uvec4 h, hn_i_num3 f, bool back, hn_i_num3 t, hn_i_num3 s, bool turned) {
  hn_vec3 g00 = hn_i_direction3(h.x, turned);
  hn_vec3 g10 = hn_i_direction3(h.y, turned);
  hn_vec3 g01 = hn_i_direction3(h.z, turned);
  hn_vec3 g11 = hn_i_direction3(h.w, turned);
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  hn_float z = hn_i_offset(hn_i_select(back, hn_i_minus_one(f.z), f.z));
  hn_i_num4 n0 = hn_i_lerp_ramps_d(hn_i_along3(g00, x, y, z), hn_i_along3(g10, x1, y, z), g00, g10, t.x, s.x);
  hn_i_num4 n1 = hn_i_lerp_ramps_d(hn_i_along3(g01, x, y1, z), hn_i_along3(g11, x1, y1, z), g01, g11, t.x, s.x);
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.y), hn_i_lerp(n0.y, n1.y, t.y),
                     hn_i_d_faded(hn_i_lerp(n0.z, n1.z, t.y), hn_i_d_corner(n0.x, n1.x), s.y),
                     hn_i_lerp(n0.w, n1.w, t.y));
}

// The noise and its derivatives before they are scaled, from the hashes of the corners of both faces, the fades and
// their slopes.
HN_FN hn_i_num4 hn_i_perlin_d(hn_uvec4 a, hn_uvec4 b, hn_i_num3 f, hn_i_num3 t, hn_i_num3 s, bool turned) {
  hn_i_num4 front = hn_i_bilerp_ramps_d(a, f, false, t, s, turned);
  hn_i_num4 back = hn_i_bilerp_ramps_d(b, f, true, t, s, turned);
  return hn_i_vector(hn_i_lerp(front.x, back.x, t.z), hn_i_lerp(front.y, back.y, t.z), hn_i_lerp(front.z, back.z, t.z),
                     hn_i_d_faded(hn_i_lerp(front.w, back.w, t.z), hn_i_d_corner(front.x, back.x), s.z));
}
HN_FN hn_vec4 hn_i_scaled_perlin_d(hn_i_num4 n) { return hn_i_scaled_d(n, 985); }

// Perlin noise in space and its slope: the value of hn_perlin with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec4 n = hn_perlin_d(vec3(uv * 8.0, 0.5), 7u);
//   returns  the value and its derivatives along x, y and z. A derivative is per cell, in [-3.61, 3.61], once
//            continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin's, and of a derivative at most 1.17e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 2.28e-4. From a cell at most 1.04e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_perlin, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_vec4 hn_perlin_d(hn_place3 place, hn_uint seed) {
  hn_i_cell_corners3 corners = hn_i_cell_corners(place);
  hn_i_num3 f = place.fraction;
  return hn_i_scaled_perlin_d(hn_i_perlin_d(hn_i_corner_hashes(corners, false, seed),
                                            hn_i_corner_hashes(corners, true, seed), f, hn_i_fade(f), hn_i_d_fade(f),
                                            false));
}
HN_FN hn_vec4 hn_perlin_d(hn_vec3 p, hn_uint seed) { return hn_perlin_d(hn_place(p), seed); }
HN_FN hn_vec4 hn_perlin_d(hn_vec3 p) { return hn_perlin_d(p, 0u); }

#endif
#endif
