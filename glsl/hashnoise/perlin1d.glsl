// hashnoise: Perlin noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN1D_GLSL
#define HN_PERLIN1D_GLSL

#include "detail/cell.glsl"
#include "detail/direction.glsl"

// The paper's gradient has no noise on the line.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_perlin(hn_i_cell_corners1 corners, hn_i_num f, hn_uint seed) {
  hn_uvec2 h = hn_i_corner_hashes(corners, seed);
  hn_i_num left = hn_i_ramp1(hn_i_gradient1(h.x), f);
  hn_i_num right = hn_i_ramp1(hn_i_gradient1(h.y), hn_i_minus_one(f));
  return hn_i_scaled1(hn_i_lerp(left, right, hn_i_fade(f)));
}

// Perlin noise on the line: smooth hills and valleys, about one to a cell, and 0 at whole positions. It is gradient
// noise on the integers, with the interpolant of 2002 and hashed gradients.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_perlin(uv.x * 8.0, 7u);
//   returns  [-1, 1] (proven bound 0.99805), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 1.62e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            3.71e-5. From a cell at most 1.46e-6
//   period   2^32 cells, or the tile's
//   cost     2 hashes (none with HN_HASH_LATTICE) and 2 multiplications; 1 more to spread the coordinate, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_place1 place, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell_corners(place), place.fraction, seed));
}
HN_FN hn_float hn_perlin(hn_float p, hn_uint seed) { return hn_perlin(hn_place(p), seed); }
HN_FN hn_float hn_perlin(hn_float p) { return hn_perlin(p, 0u); }

#endif
#endif
