// hashnoise: simplex noise in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX4D_GLSL
#define HN_SIMPLEX4D_GLSL

#include "centred.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_simplex(hn_i_block4 block, hn_num4 f, hn_uint seed) {
  hn_num4 x;
  hn_num4 y;
  hn_num4 z;
  hn_num4 w;
  hn_num4 t;
  hn_uvec4 h = hn_i_four_points(block, f, seed, x, y, z, w, t);
  hn_num n = hn_i_attenuated(hn_i_ramp(h.x, x.x, y.x, z.x, w.x), hn_i_weight3(t.x));
  n = hn_i_plus(n, hn_i_attenuated(hn_i_ramp(h.y, x.y, y.y, z.y, w.y), hn_i_weight3(t.y)));
  n = hn_i_plus(n, hn_i_attenuated(hn_i_ramp(h.z, x.z, y.z, z.z, w.z), hn_i_weight3(t.z)));
  n = hn_i_plus(n, hn_i_attenuated(hn_i_ramp(h.w, x.w, y.w, z.w, w.w), hn_i_weight3(t.w)));
  return hn_i_scaled_simplex4(n);
}

// Simplex noise in four dimensions, from a cell and a position in it: gradient noise on the corners and centres of all
// cells. Four points are enough, where the lattice of simplices would take five and a sort. Where two coordinates stay
// fixed the contrast depends on them: it is least at vec2(1/2, 0), midway between corners and centres.
//   cell     the cell; its points wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats have no promise
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99915), mean 0, 0 at lattice points, twice continuously differentiable
//            (HN_FIXED: in steps of 2^-21)
//   error    at most 5.52e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 1.22e-4
//   period   2^32 cells per axis
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 4 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over lattice points; docs/contract.md, section 13
HN_FN hn_float hn_simplex(hn_ivec4 cell, hn_vec4 f, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_block(cell), hn_i_inside(f), seed));
}

HN_FN hn_float hn_simplex(hn_ivec4 cell, hn_vec4 f) { return hn_simplex(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 6.24e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_simplex(hn_vec4 p, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_block(hn_i_cell(p)), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_simplex(hn_vec4 p) { return hn_simplex(p, 0u); }

// Both with a period: the field repeats after that many cells. Its values are those at the points modulo the period.
//   period   cells along each axis, any ivec4; 0 for none along that axis. Less than 0 is none, too
//   seed     any uint: 7u, not 7
//   error    as without a period
//   cost     a mask along each axis more for a constant power of two; else a division. Each axis has three comparisons
//            and a multiplication more
HN_FN hn_float hn_simplex(hn_ivec4 cell, hn_vec4 f, hn_ivec4 period, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_block(cell, period), hn_i_inside(f), seed));
}

HN_FN hn_float hn_simplex(hn_vec4 p, hn_ivec4 period, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_block(hn_i_cell(p), period), hn_i_fraction(p), seed));
}

#endif
