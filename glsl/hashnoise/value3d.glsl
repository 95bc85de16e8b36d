// hashnoise: value noise in space.
// To read it in one piece: docs/reference/snippets/hn_value3.md
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE3D_GLSL
#define HN_VALUE3D_GLSL

#include "detail/cell.glsl"
#include "detail/value.glsl"

// Value noise in space: cheaper than Perlin noise, and coarser, since its values are large at lattice points. It
// interpolates hashed numbers on the cubic lattice by Perlin's interpolant of 2002.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_value(vec3(uv * 8.0, 0.5), 7u);
//   returns  [-1, 1], mean 0, at lattice points any multiple of 2^-22, twice continuously differentiable (HN_FIXED: in
//            steps of 2^-21)
//   error    at most 4.26e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            5.57e-5. From a cell at most 4.26e-6
//   period   2^32 cells per axis, or the tile's
//   cost     8 hashes (none with HN_HASH_LATTICE) and 8 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002, for the interpolant
HN_FN hn_float hn_value(hn_place3 place, hn_uint seed) {
  hn_i_cell_corners3 corners = hn_i_cell_corners(place);
  return hn_i_value(hn_i_value_noise(hn_i_corner_hashes(corners, false, seed), hn_i_corner_hashes(corners, true, seed),
                                     hn_i_fade(place.fraction)));
}
HN_FN hn_float hn_value(hn_vec3 p, hn_uint seed) { return hn_value(hn_place(p), seed); }
HN_FN hn_float hn_value(hn_vec3 p) { return hn_value(p, 0u); }

#endif
