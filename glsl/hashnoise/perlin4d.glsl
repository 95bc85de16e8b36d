// hashnoise: Perlin noise in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN4D_GLSL
#define HN_PERLIN4D_GLSL

#include "detail/cell.glsl"
#include "detail/direction4d.glsl"

// The paper's gradient has no noise in four dimensions.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The share of the corners 00, 10, 01, 11 of the square that z and w choose, at the place f; z and w are the offsets
// from that square, and t are the fades.
HN_FN hn_i_num hn_i_square_of_ramps(hn_uvec4 h, hn_i_num4 f, hn_i_num z, hn_i_num w, hn_i_num4 t) {
  hn_i_num x = hn_i_minus_one(f.x);
  hn_i_num y = hn_i_minus_one(f.y);
  return hn_i_lerp(hn_i_lerp_ramps4(hn_i_along4(h.x, f.x, f.y, z, w), hn_i_along4(h.y, x, f.y, z, w), t.x),
                   hn_i_lerp_ramps4(hn_i_along4(h.z, f.x, y, z, w), hn_i_along4(h.w, x, y, z, w), t.x), t.y);
}

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_perlin(hn_i_cell_corners4 corners, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 t = hn_i_fade(f);
  hn_i_num z = hn_i_minus_one(f.z);
  hn_i_num w = hn_i_minus_one(f.w);
  hn_i_num4 n = hn_i_vector(hn_i_square_of_ramps(hn_i_corner_hashes(corners, false, false, seed), f, f.z, f.w, t),
                            hn_i_square_of_ramps(hn_i_corner_hashes(corners, true, false, seed), f, z, f.w, t),
                            hn_i_square_of_ramps(hn_i_corner_hashes(corners, false, true, seed), f, f.z, w, t),
                            hn_i_square_of_ramps(hn_i_corner_hashes(corners, true, true, seed), f, z, w, t));
  return hn_i_scaled4(hn_i_lerp(n, t.z, t.w));
}

// Perlin noise in four dimensions: smooth hills and valleys, about one to a cell, and 0 at whole positions. It is
// gradient noise on the lattice of four dimensions, with the interpolant of 2002 and hashed gradients.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_perlin(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  [-1, 1] (proven bound 0.99904), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 3.48e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            6.93e-5. From a cell at most 3.48e-6
//   period   2^32 cells per axis, or the tile's
//   cost     16 hashes (none with HN_HASH_LATTICE) and 16 multiplications; 4 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_place4 place, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell_corners(place), place.fraction, seed));
}
HN_FN hn_float hn_perlin(hn_vec4 p, hn_uint seed) { return hn_perlin(hn_place(p), seed); }
HN_FN hn_float hn_perlin(hn_vec4 p) { return hn_perlin(p, 0u); }

#endif
#endif
