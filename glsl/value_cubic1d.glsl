// hashnoise: cubic value noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_CUBIC1D_GLSL
#define HN_VALUE_CUBIC1D_GLSL

#include "cubic.glsl"

// The noise in the numbers of HN_ARITHMETIC. x are the spread coordinates of four points.
HN_FN hn_num hn_i_value_cubic(hn_uvec4 x, hn_num f, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  return hn_i_of_numbers(hn_i_cubic_row(x, s, s, hn_i_spline(f)));
}

HN_FN hn_num hn_i_value_cubic(hn_int cell, hn_num f, hn_uint seed) {
  return hn_i_value_cubic(hn_i_line(hn_i_first(cell), 0x9E3779B1u), f, seed);
}
HN_FN hn_num hn_i_value_cubic(hn_int cell, hn_num f, hn_int period, hn_uint seed) {
  return hn_i_value_cubic(hn_i_line(cell, period, 0x9E3779B1u, 0x165667B1u), f, seed);
}

// Cubic value noise on the line, from a cell and a position in it: a uniform cubic B-spline over hashed numbers.
// It is the smoothest of the lattice noises: it does not show the cells, has no creases in its slopes, and stays
// between the numbers around it. The price is contrast: the spline blurs.
//   cell     the cell; its lattice points, from cell - 1 to cell + 2, wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats extrapolate
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1], mean 0, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 5.47e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 4.00e-5
//   period   2^32 cells
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 1 more to spread the coordinate, and 2 more
//            for a seed that is not constant
//   source   de Boor, "A Practical Guide to Splines", 1978, for the spline
HN_FN hn_float hn_value_cubic(hn_int cell, hn_float f, hn_uint seed) {
  return hn_i_value(hn_i_value_cubic(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_value_cubic(hn_int cell, hn_float f) { return hn_value_cubic(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 5.56e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_value_cubic(hn_float p, hn_uint seed) {
  return hn_i_value(hn_i_value_cubic(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_value_cubic(hn_float p) { return hn_value_cubic(p, 0u); }

// Both with a period: the field repeats after that many cells. Its values are those at the corners modulo the period.
//   period   cells, any int; 0 for none. Less than 0 is none, too
//   seed     any uint: 7u, not 7
//   error    as without a period
//   cost     a mask more for a constant power of two; else a division. Each axis has one comparison more
HN_FN hn_float hn_value_cubic(hn_int cell, hn_float f, hn_int period, hn_uint seed) {
  return hn_i_value(hn_i_value_cubic(cell, hn_i_inside(f), period, seed));
}

HN_FN hn_float hn_value_cubic(hn_float p, hn_int period, hn_uint seed) {
  return hn_i_value(hn_i_value_cubic(hn_i_cell(p), hn_i_fraction(p), period, seed));
}

#endif
