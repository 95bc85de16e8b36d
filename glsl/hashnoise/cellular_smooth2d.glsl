// hashnoise: smooth cellular noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_CELLULAR_SMOOTH2D_GLSL
#define HN_CELLULAR_SMOOTH2D_GLSL

#include "detail/feature_points2d.glsl"

HN_FN hn_float hn_i_cellular_smooth(hn_i_neighbourhood2 cells, hn_i_num2 f, hn_i_num jitter, hn_uint seed) {
  hn_i_num2 d = hn_i_from_centre(f);
  hn_uint s = hn_i_scramble(seed);
  hn_i_num3 x = hn_i_row(d.x);
  hn_i_num3 y = hn_i_row(d.y);
  hn_i_rank weights = hn_i_no_weight();
  hn_uvec3 hashes = hn_i_hashes_along_x(cells, cells.previous.y, s);
  weights = hn_i_summed_weights(weights, hn_i_squares(hashes, x, hn_i_equal_triple(y.x), jitter));
  hashes = hn_i_hashes_along_x(cells, cells.cell.y, s);
  weights = hn_i_summed_weights(weights, hn_i_squares(hashes, x, hn_i_equal_triple(y.y), jitter));
  hashes = hn_i_hashes_along_x(cells, cells.following.y, s);
  weights = hn_i_summed_weights(weights, hn_i_squares(hashes, x, hn_i_equal_triple(y.z), jitter));
  return hn_i_smooth_distance(weights);
}

// Cellular noise on the plane with rounded valleys and no creases between cells: a distance that takes all points
// within 1 into account, in any order. No point outside the cells that it visits is within 1, so there are no seams.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_cellular_smooth(uv * 8.0, 7u);
//   returns  1 - (the sum of (1 - distance)^4 over these points + 1/4096)^(1/4): a little below the first distance of
//            hn_cellular, in [-0.1937, 7/8] (proven bound), continuously differentiable but for the points themselves
//            (HN_FIXED: in steps of 2^-19)
//   error    at most 2.68e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.79e-4. From a cell at most 2.68e-6
//   period   2^32 cells per axis, or the tile's
//   cost     9 hashes (none with HN_HASH_LATTICE), 9 multiplications and 11 square roots; 2 more multiplications to
//            spread the coordinates, and 2 more for a seed that is not constant
//   source   docs/reference/contract.md, section 16
HN_FN hn_float hn_cellular_smooth(hn_place2 place, hn_uint seed) {
  return hn_i_cellular_smooth(hn_i_neighbourhood(place), place.fraction, HN_I_ONE, seed);
}

// From here cellular_smooth3d.glsl is generated from cellular_smooth2d.glsl.

HN_FN hn_float hn_cellular_smooth(hn_vec2 p, hn_uint seed) { return hn_cellular_smooth(hn_place(p), seed); }
HN_FN hn_float hn_cellular_smooth(hn_vec2 p) { return hn_cellular_smooth(p, 0u); }

// This form also takes the jitter.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   example  float n = hn_cellular_smooth(uv * 8.0, 1.0, 7u);
//   returns  as above
//   error    as above
//   cost     as above
HN_FN hn_float hn_cellular_smooth(hn_place2 place, hn_float jitter, hn_uint seed) {
  return hn_i_cellular_smooth(hn_i_neighbourhood(place), place.fraction, hn_i_jitter(jitter), seed);
}
HN_FN hn_float hn_cellular_smooth(hn_vec2 p, hn_float jitter, hn_uint seed) {
  return hn_cellular_smooth(hn_place(p), jitter, seed);
}

// To here cellular_smooth3d.glsl is generated from cellular_smooth2d.glsl.

#endif
