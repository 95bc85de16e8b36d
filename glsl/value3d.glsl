// hashnoise: value noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE3D_GLSL
#define HN_VALUE3D_GLSL

#include "lattice.glsl"

// Interpolates the front or back face of a cell, at a place that x and y give by their fades.
HN_FN hn_num hn_i_value_face(hn_uvec3 c, bool back, hn_num x, hn_num y, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(c, back, seed);
  return hn_i_lerp(hn_i_num(hn_i_number(h.x), hn_i_number(h.y), hn_i_number(h.z), hn_i_number(h.w)), x, y);
}

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_value_noise(hn_ivec3 cell, hn_num3 f, hn_uint seed) {
  hn_uvec3 c = hn_i_wrap(cell);
  hn_num3 t = hn_i_fade(f);
  hn_num front = hn_i_value_face(c, false, t.x, t.y, seed);
  hn_num back = hn_i_value_face(c, true, t.x, t.y, seed);
  return hn_i_of_numbers(hn_i_lerp(front, back, t.z));
}

// Value noise on the cubic lattice, from a cell and a position in it: hashed numbers, Perlin's 2002 interpolant.
// It is cheaper than gradient noise, and coarser: its values are large at lattice points.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats extrapolate
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.999985), mean 0, at lattice points any odd multiple of 2^-16, twice continuously
//            differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 3.92e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 5.58e-5
//   period   HN_PERIOD; without it 2^32 cells per axis
//   cost     8 hashes (none with HN_HASH_LATTICE) and 8 multiplications; 3 more to spread the coordinates (6 with
//            HN_PERIOD, of the far corner too), and 2 more for a seed that is not constant
//   source   Perlin, "Improving noise", 2002, for the interpolant
HN_FN hn_float hn_value(hn_ivec3 cell, hn_vec3 f, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_value(hn_ivec3 cell, hn_vec3 f) { return hn_value(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 4.25e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_value(hn_vec3 p, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_value(hn_vec3 p) { return hn_value(p, 0u); }

#endif
