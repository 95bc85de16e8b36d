// hashnoise: value noise in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE4D_GLSL
#define HN_VALUE4D_GLSL

#include "detail/cell.glsl"
#include "detail/value.glsl"

// Interpolates the square that z and w choose, at a place that t gives by its fades.
HN_FN hn_i_num hn_i_value_square(hn_i_cell_corners4 corners, bool far_z, bool far_w, hn_i_num4 t, hn_uint seed) {
  return hn_i_lerp(hn_i_numbers(hn_i_corner_hashes(corners, far_z, far_w, seed)), t.x, t.y);
}

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_value_noise(hn_i_cell_corners4 corners, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 t = hn_i_fade(f);
  hn_i_num4 n =
      hn_i_vector(hn_i_value_square(corners, false, false, t, seed), hn_i_value_square(corners, true, false, t, seed),
                  hn_i_value_square(corners, false, true, t, seed), hn_i_value_square(corners, true, true, t, seed));
  return hn_i_noise_of_numbers(hn_i_lerp(n, t.z, t.w));
}

// Value noise in four dimensions: cheaper than Perlin noise, and coarser, since its values are large at lattice points.
// It interpolates hashed numbers on the lattice of four dimensions by Perlin's interpolant of 2002.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_value(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  [-1, 1], mean 0, at lattice points any multiple of 2^-22, twice continuously differentiable (HN_FIXED: in
//            steps of 2^-21)
//   error    at most 5.50e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            6.55e-5. From a cell at most 5.10e-6
//   period   2^32 cells per axis, or the tile's
//   cost     16 hashes (none with HN_HASH_LATTICE) and 16 multiplications; 4 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002, for the interpolant
HN_FN hn_float hn_value(hn_place4 place, hn_uint seed) {
  return hn_i_value(hn_i_value_noise(hn_i_cell_corners(place), place.fraction, seed));
}
HN_FN hn_float hn_value(hn_vec4 p, hn_uint seed) { return hn_value(hn_place(p), seed); }
HN_FN hn_float hn_value(hn_vec4 p) { return hn_value(p, 0u); }

#endif
