// hashnoise: cubic value noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_CUBIC1D_GLSL
#define HN_VALUE_CUBIC1D_GLSL

#include "detail/cubic_spline.glsl"

// The noise in the numbers of HN_ARITHMETIC. x are the spread coordinates of four points.
HN_FN hn_i_num hn_i_value_cubic(hn_uvec4 x, hn_i_num f, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  return hn_i_noise_of_numbers(hn_i_cubic_row(x, hn_i_seed_join(s), hn_i_odd(x.y, s), hn_i_spline(f)));
}

HN_FN hn_i_num hn_i_value_cubic(hn_place1 place, hn_uint seed) {
  return hn_i_value_cubic(hn_i_line(place.cell, place.period, place.tiled, HN_I_STEP_X, HN_I_ORIGIN_X), place.fraction,
                          seed);
}

// Cubic value noise on the line: a uniform cubic B-spline over hashed numbers. It is the smoothest of the lattice
// noises: it does not show the cells, has no creases in its slopes, and stays between the numbers around it. The price
// is contrast: the spline blurs.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_value_cubic(uv.x * 8.0, 7u);
//   returns  [-1, 1], mean 0, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    at most 4.48e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            3.98e-5. From a cell at most 4.46e-6
//   period   2^32 cells, or the tile's
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 1 more to spread the coordinate, and 2 more
//            for a seed that is not constant
//   source   de Boor, "A Practical Guide to Splines", 1978, for the spline
HN_FN hn_float hn_value_cubic(hn_place1 place, hn_uint seed) { return hn_i_value(hn_i_value_cubic(place, seed)); }
HN_FN hn_float hn_value_cubic(hn_float p, hn_uint seed) { return hn_value_cubic(hn_place(p), seed); }
HN_FN hn_float hn_value_cubic(hn_float p) { return hn_value_cubic(p, 0u); }

#endif
