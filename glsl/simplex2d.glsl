// hashnoise: simplex noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX2D_GLSL
#define HN_SIMPLEX2D_GLSL

#include "triangles.glsl"

// The noise in the numbers of HN_ARITHMETIC, from the words of the corners.
HN_FN hn_num hn_i_simplex(hn_uvec3 h, hn_num2 skewed) {
  hn_num3 x = hn_i_triangle_x(skewed);
  hn_num3 y = hn_i_triangle_y(skewed);
  hn_num3 t = hn_i_triangle_near(x, y);
  hn_num n = hn_i_attenuated(hn_i_triangle_ramp(h.x, x.x, y.x), hn_i_weight_plane(t.x));
  n = hn_i_plus(n, hn_i_attenuated(hn_i_triangle_ramp(h.y, x.y, y.y), hn_i_weight_plane(t.y)));
  n = hn_i_plus(n, hn_i_attenuated(hn_i_triangle_ramp(h.z, x.z, y.z), hn_i_weight_plane(t.z)));
  return hn_i_scaled_simplex2(n);
}
HN_FN hn_num hn_i_simplex(hn_ivec2 cell, hn_num2 f, hn_uint seed) {
  hn_num2 skewed = hn_i_skewed(f);
  return hn_i_simplex(hn_i_triangle(cell, skewed, seed), skewed);
}
HN_FN hn_num hn_i_simplex(hn_ivec2 cell, hn_num2 f, hn_ivec2 period, hn_uint seed) {
  hn_num2 skewed = hn_i_skewed(f);
  return hn_i_simplex(hn_i_triangle(cell, skewed, period, seed), skewed);
}

// Simplex noise on the plane, from a cell and a position in it: gradient noise on a triangular lattice. It does not
// prefer the axes. There are four lattice points to a cell, so its features are about half as large as those of
// hn_perlin.
//   cell     the cell; its points wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats have no promise
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99874), mean 0, 0 at lattice points, twice continuously differentiable
//            (HN_FIXED: in steps of 2^-21)
//   error    at most 3.46e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 1.52e-4
//   period   2^31 cells per axis
//   cost     3 hashes (none with HN_HASH_LATTICE) and 3 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over the corners of a simplex; docs/contract.md, section 13
HN_FN hn_float hn_simplex(hn_ivec2 cell, hn_vec2 f, hn_uint seed) {
  return hn_i_value(hn_i_simplex(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_simplex(hn_ivec2 cell, hn_vec2 f) { return hn_simplex(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 4.06e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_simplex(hn_vec2 p, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_simplex(hn_vec2 p) { return hn_simplex(p, 0u); }

// Both with a period: the field repeats after that many cells. Its values are those at the points modulo the period.
//   period   cells along each axis, any ivec2; 0 for none along that axis. Less than 0 is none, too
//   seed     any uint: 7u, not 7
//   error    as without a period
//   cost     a mask along each axis more for a constant power of two; else a division. Each point has two comparisons
//            more and up to two multiplications
HN_FN hn_float hn_simplex(hn_ivec2 cell, hn_vec2 f, hn_ivec2 period, hn_uint seed) {
  return hn_i_value(hn_i_simplex(cell, hn_i_inside(f), period, seed));
}

HN_FN hn_float hn_simplex(hn_vec2 p, hn_ivec2 period, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_cell(p), hn_i_fraction(p), period, seed));
}

#endif
