// hashnoise: cubic value noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_CUBIC2D_GLSL
#define HN_VALUE_CUBIC2D_GLSL

#include "detail/cubic_spline.glsl"

// The noise in the numbers of HN_ARITHMETIC. x and y are the spread coordinates of four points along each axis.
HN_FN hn_i_num hn_i_value_cubic(hn_uvec4 x, hn_uvec4 y, hn_i_num2 f, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uint odd = hn_i_odd(uvec2(x.y, y.y), s);
  return hn_i_noise_of_numbers(hn_i_cubic_square(x, y, hn_i_seed_join(s), odd, hn_i_spline(f.x), hn_i_spline(f.y)));
}

HN_FN hn_i_num hn_i_value_cubic(hn_place2 place, hn_uint seed) {
  return hn_i_value_cubic(hn_i_line(place.cell.x, place.period.x, place.tiled, HN_I_STEP_X, HN_I_ORIGIN_X),
                          hn_i_line(place.cell.y, place.period.y, place.tiled, HN_I_STEP_Y, 0u), place.fraction, seed);
}

// Cubic value noise on the plane: a uniform cubic B-spline over hashed numbers. It is the smoothest of the lattice
// noises: it does not show the cells, has no creases in its slopes, and stays between the numbers around it. The price
// is contrast: the spline blurs.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_value_cubic(uv * 8.0, 7u);
//   returns  [-1, 1], mean 0, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 7.78e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            6.39e-5. From a cell at most 7.66e-6
//   period   2^32 cells per axis, or the tile's
//   cost     16 hashes (none with HN_HASH_LATTICE) and 16 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   de Boor, "A Practical Guide to Splines", 1978, for the spline
HN_FN hn_float hn_value_cubic(hn_place2 place, hn_uint seed) { return hn_i_value(hn_i_value_cubic(place, seed)); }
HN_FN hn_float hn_value_cubic(hn_vec2 p, hn_uint seed) { return hn_value_cubic(hn_place(p), seed); }
HN_FN hn_float hn_value_cubic(hn_vec2 p) { return hn_value_cubic(p, 0u); }

#endif
