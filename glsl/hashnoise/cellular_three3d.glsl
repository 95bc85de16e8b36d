// hashnoise: the three nearest points of cellular noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_CELLULAR_THREE3D_GLSL
#define HN_CELLULAR_THREE3D_GLSL

#include "detail/feature_points3d.glsl"

// The axis along which the place is farthest from the centre of its cell.
HN_FN hn_int hn_i_farthest_axis(hn_i_num3 d) {
  hn_i_num x = hn_i_magnitude(d.x);
  hn_i_num y = hn_i_magnitude(d.y);
  hn_i_num z = hn_i_magnitude(d.z);
  return hn_i_select_int(x >= max(y, z), 0, hn_i_select_int(y >= z, 1, 2));
}

// The third point may also be in a cell two steps on along that axis (feature_points.glsl). Nine cells in a slab
// are enough.
HN_FN hn_vec3 hn_i_cellular_three(hn_place3 place, hn_i_num jitter, hn_int metric, hn_uint seed) {
  hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
  hn_i_num3 d = hn_i_from_centre(place.fraction);
  hn_uvec3 two = hn_i_far_cell(place, cells, d);
  hn_i_rank4 best = hn_i_nearest(cells, d, jitter, metric, seed);
  hn_int axis = hn_i_farthest_axis(d);
  hn_uint at = hn_i_component_along(axis, two);
  hn_int steps = hn_i_far_step_along(axis, d);
  for (hn_int n = -1; n <= 1; ++n) {
    hn_uvec3 hashes = hn_i_slab_hashes(cells, axis, at, n, seed);
    best = hn_i_insert(best,
                       hn_i_ranks(hashes, hn_i_slab_x(d, axis, steps), hn_i_slab_y(d, axis, steps, n),
                                  hn_i_slab_z(d, axis, steps, n), jitter, metric),
                       HN_I_NO_CODE, 0);
  }
  return vec3(hn_i_distance(best.x, metric), hn_i_distance(best.y, metric), hn_i_distance(best.z, metric));
}

// Cellular noise in space: the distances to the three nearest feature points (Worley's F1, F2 and F3). The first two
// are hn_cellular's.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float f3 = hn_cellular_three(vec3(uv * 8.0, 0.5), 7u).z;
//   returns  the three distances, in cells, ascending: the third in [0, 1.5812] (proven bound)
//   error    at most 2.76e-6 against the exact value, in any metric and rounding mode (docs/measured/accuracy.md).
//            HN_FIXED 6.87e-5. From a cell at most 2.76e-6
//   period   2^32 cells per axis, or the tile's
//   cost     36 hashes (none with HN_HASH_LATTICE) and 36 multiplications, and what hn_cellular costs besides
//   source   Worley, "A cellular texture basis function", 1996; docs/reference/contract.md, section 16
HN_FN hn_vec3 hn_cellular_three(hn_place3 place, hn_uint seed) {
  return hn_i_cellular_three(place, HN_I_ONE, HN_METRIC_EUCLIDEAN, seed);
}

// From here cellular_three3d.glsl is generated from cellular_three2d.glsl.

HN_FN hn_vec3 hn_cellular_three(hn_vec3 p, hn_uint seed) { return hn_cellular_three(hn_place(p), seed); }
HN_FN hn_vec3 hn_cellular_three(hn_vec3 p) { return hn_cellular_three(p, 0u); }

// This form also takes the jitter and the metric.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   metric   the distance: usually HN_METRIC_EUCLIDEAN, or HN_METRIC_SQUARED, _MANHATTAN, _CHEBYSHEV or _HYBRID. A
//            constant compiles to that metric alone
//   seed     any uint: 7u, not 7
//   example  float f3 = hn_cellular_three(vec3(uv * 8.0, 0.5), 1.0, HN_METRIC_EUCLIDEAN, 7u).z;
//   returns  as above, in the metric
//   error    as above
//   cost     as above
HN_FN hn_vec3 hn_cellular_three(hn_place3 place, hn_float jitter, hn_int metric, hn_uint seed) {
  return hn_i_cellular_three(place, hn_i_jitter(jitter), metric, seed);
}
HN_FN hn_vec3 hn_cellular_three(hn_vec3 p, hn_float jitter, hn_int metric, hn_uint seed) {
  return hn_cellular_three(hn_place(p), jitter, metric, seed);
}

// To here cellular_three3d.glsl is generated from cellular_three2d.glsl.

#endif
