// hashnoise: value noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE1D_GLSL
#define HN_VALUE1D_GLSL

#include "detail/cell.glsl"
#include "detail/value.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_value_noise(hn_i_cell_corners1 corners, hn_i_num f, hn_uint seed) {
  hn_uvec2 h = hn_i_corner_hashes(corners, seed);
  return hn_i_noise_of_numbers(hn_i_lerp(hn_i_number(h.x), hn_i_number(h.y), hn_i_fade(f)));
}

// Value noise on the line: cheaper than Perlin noise, and coarser, since its values are large at lattice points. It
// interpolates hashed numbers on the integers by Perlin's interpolant of 2002.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_value(uv.x * 8.0, 7u);
//   returns  [-1, 1], mean 0, at lattice points any multiple of 2^-22, twice continuously differentiable (HN_FIXED: in
//            steps of 2^-21)
//   error    at most 1.96e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            3.58e-5. From a cell at most 1.82e-6
//   period   2^32 cells, or the tile's
//   cost     2 hashes (none with HN_HASH_LATTICE) and 2 multiplications; 1 more to spread the coordinate, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002, for the interpolant
HN_FN hn_float hn_value(hn_place1 place, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(hn_i_cell_corners(place), place.fraction, seed));
}
HN_FN hn_float hn_value(hn_float p, hn_uint seed) { return hn_value(hn_place(p), seed); }
HN_FN hn_float hn_value(hn_float p) { return hn_value(p, 0u); }

#endif
