// hashnoise: cellular noise and its gradient in space.
// SPDX-License-Identifier: MIT

#ifndef HN_CELLULAR_D3D_GLSL
#define HN_CELLULAR_D3D_GLSL

#include "detail/feature_points3d.glsl"

HN_FN hn_vec4 hn_i_cellular_d(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_i_num jitter, hn_uint seed) {
  hn_i_num3 d = hn_i_from_centre(f);
  hn_i_rank4 best = hn_i_nearest(cells, d, jitter, HN_METRIC_EUCLIDEAN, seed);
  hn_i_num3 from = hn_i_from_octahedral(hn_i_from_nearest(cells, d, jitter, seed, best.w));
  hn_vec3 slope = hn_i_unit(from.x, from.y, from.z);
  return vec4(hn_i_distance(best.x, HN_METRIC_EUCLIDEAN), slope.x, slope.y, slope.z);
}

// The distance to the nearest feature point in space, which is the first of hn_cellular, and its gradient.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec4 n = hn_cellular_d(vec3(uv * 8.0, 0.5), 7u);
//   returns  the distance, and its derivatives along x, y and z: a vector of length 1 away from the point, which is
//            (position - point) / distance; 0 at the point. It jumps where another point becomes the nearest
//   error    hn_cellular's, and of a derivative at most 1.75e-6 divided by the distance, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 8.46e-6 divided by it. From a cell at most 1.74e-6 divided by it
//   period   2^32 cells per axis, or the tile's
//   cost     hn_cellular's and one more hash
//   source   docs/reference/contract.md, section 16
HN_FN hn_vec4 hn_cellular_d(hn_place3 place, hn_uint seed) {
  return hn_i_cellular_d(hn_i_neighbourhood(place), place.fraction, HN_I_ONE, seed);
}

// From here cellular_d3d.glsl is generated from cellular_d2d.glsl.

HN_FN hn_vec4 hn_cellular_d(hn_vec3 p, hn_uint seed) { return hn_cellular_d(hn_place(p), seed); }
HN_FN hn_vec4 hn_cellular_d(hn_vec3 p) { return hn_cellular_d(p, 0u); }

// This form also takes the jitter.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   example  vec4 n = hn_cellular_d(vec3(uv * 8.0, 0.5), 1.0, 7u);
//   returns  as above
//   error    as above
//   cost     as above
HN_FN hn_vec4 hn_cellular_d(hn_place3 place, hn_float jitter, hn_uint seed) {
  return hn_i_cellular_d(hn_i_neighbourhood(place), place.fraction, hn_i_jitter(jitter), seed);
}
HN_FN hn_vec4 hn_cellular_d(hn_vec3 p, hn_float jitter, hn_uint seed) {
  return hn_cellular_d(hn_place(p), jitter, seed);
}

// To here cellular_d3d.glsl is generated from cellular_d2d.glsl.

#endif
