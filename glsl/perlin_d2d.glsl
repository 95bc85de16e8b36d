// hashnoise: Perlin noise and its derivatives on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_D2D_GLSL
#define HN_PERLIN_D2D_GLSL

#include "gradient.glsl"
#include "slope.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The noise and its derivatives.
HN_FN hn_vec3 hn_i_perlin_d(hn_i_box2 box, hn_num2 f, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(box, seed);
  hn_num3 d00 = hn_i_direction2(h.x);
  hn_num3 d10 = hn_i_direction2(h.y);
  hn_num3 d01 = hn_i_direction2(h.z);
  hn_num3 d11 = hn_i_direction2(h.w);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  hn_num4 r = hn_i_num(hn_i_ramp(d00, f.x, f.y), hn_i_ramp(d10, x, f.y), hn_i_ramp(d01, f.x, y), hn_i_ramp(d11, x, y));
  hn_num3 n = hn_i_face_d(r, hn_i_gradient(d00), hn_i_gradient(d10), hn_i_gradient(d01), hn_i_gradient(d11),
                          hn_i_fade(f), hn_i_slope(f));
  return vec3(hn_i_value(hn_i_scaled2(n.x)), hn_i_derivative(hn_i_scaled2(n.y)), hn_i_derivative(hn_i_scaled2(n.z)));
}

// Perlin noise on the plane and how steep it is, from a cell and a position in it. The value is that of hn_perlin.
//   cell     the cell; its corners wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats extrapolate
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  the value and its derivatives along x and y. A derivative is per cell, in [-2.78, 2.78], once continuously
//            differentiable (HN_FIXED: in steps of 2^-19)
//   error    that of hn_perlin, and of a derivative at most 1.37e-5 against the exact value, in any rounding mode
//            (docs/accuracy.md). HN_FIXED 1.87e-4
//   period   2^32 cells per axis
//   cost     the hashes of hn_perlin, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/contract.md, section 10
HN_FN hn_vec3 hn_perlin_d(hn_ivec2 cell, hn_vec2 f, hn_uint seed) {
  return hn_i_perlin_d(hn_i_box(cell), hn_i_inside(f), seed);
}

HN_FN hn_vec3 hn_perlin_d(hn_ivec2 cell, hn_vec2 f) { return hn_perlin_d(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    of a derivative at most 1.46e-5. The rest is as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_vec3 hn_perlin_d(hn_vec2 p, hn_uint seed) {
  return hn_i_perlin_d(hn_i_box(hn_i_cell(p)), hn_i_fraction(p), seed);
}

HN_FN hn_vec3 hn_perlin_d(hn_vec2 p) { return hn_perlin_d(p, 0u); }

// Both with a period: the field repeats after that many cells. Its values are those at the corners modulo the period.
//   period   cells along each axis, any ivec2; 0 for none along that axis. Less than 0 is none, too
//   seed     any uint: 7u, not 7
//   error    as without a period
//   cost     a mask along each axis more for a constant power of two; else a division. Each axis has one comparison
//            more
HN_FN hn_vec3 hn_perlin_d(hn_ivec2 cell, hn_vec2 f, hn_ivec2 period, hn_uint seed) {
  return hn_i_perlin_d(hn_i_box(cell, period), hn_i_inside(f), seed);
}

HN_FN hn_vec3 hn_perlin_d(hn_vec2 p, hn_ivec2 period, hn_uint seed) {
  return hn_i_perlin_d(hn_i_box(hn_i_cell(p), period), hn_i_fraction(p), seed);
}

#endif
#endif
