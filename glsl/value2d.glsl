// hashnoise: value noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE2D_GLSL
#define HN_VALUE2D_GLSL

#include "lattice.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_value_noise(hn_ivec2 cell, hn_num2 f, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(hn_i_wrap(cell), seed);
  hn_num2 t = hn_i_fade(f);
  hn_num4 n = hn_i_num(hn_i_number(h.x), hn_i_number(h.y), hn_i_number(h.z), hn_i_number(h.w));
  return hn_i_of_numbers(hn_i_lerp(n, t.x, t.y));
}

// Value noise on the square lattice, from a cell and a position in it: hashed numbers, Perlin's 2002 interpolant.
// It is cheaper than gradient noise, and coarser: its values are large at lattice points.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats extrapolate
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.999985), mean 0, at lattice points any odd multiple of 2^-16, twice continuously
//            differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 2.51e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 4.43e-5
//   period   HN_PERIOD; without it 2^32 cells per axis
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 2 more to spread the coordinates (4 with
//            HN_PERIOD, of the far corner too), and 2 more for a seed that is not constant
//   source   Perlin, "Improving noise", 2002, for the interpolant
HN_FN hn_float hn_value(hn_ivec2 cell, hn_vec2 f, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_value(hn_ivec2 cell, hn_vec2 f) { return hn_value(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 2.79e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_value(hn_vec2 p, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_value(hn_vec2 p) { return hn_value(p, 0u); }

#endif
