// hashnoise: cellular noise on the plane.
// To read it in one piece: docs/reference/snippets/hn_cellular2.md
// SPDX-License-Identifier: MIT

#ifndef HN_CELLULAR2D_GLSL
#define HN_CELLULAR2D_GLSL

// From here cellular3d.glsl is generated from cellular2d.glsl.

#include "detail/feature_points2d.glsl"

HN_FN hn_vec2 hn_i_cellular(hn_i_neighbourhood2 cells, hn_i_num2 f, hn_i_num jitter, hn_int metric, hn_uint seed) {
  return hn_i_two_distances(hn_i_nearest(cells, hn_i_from_centre(f), jitter, metric, seed), metric);
}
HN_FN hn_vec2 hn_i_cellular(hn_place2 place, hn_i_num jitter, hn_int metric, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                            HN_I_OUT(hn_vec2) offset) {
  hn_i_neighbourhood2 cells = hn_i_neighbourhood(place);
  hn_i_num2 d = hn_i_from_centre(place.fraction);
  hn_i_rank4 best = hn_i_nearest(cells, d, jitter, metric, seed);
  nearest = hn_i_cell_of(place, best.w);
  offset = hn_i_toward(hn_i_from_nearest(cells, d, jitter, seed, best.w));
  return hn_i_two_distances(best, metric);
}

// Cellular noise on the plane: the distances to the nearest and to the second nearest feature point (Worley's F1 and
// F2). Each cell has one such point. No point of the whole infinite field is nearer.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float f1 = hn_cellular(uv * 8.0, 7u).x;
//   returns  the two distances, in cells: the first in [0, 1.1181], the second in [0, 1.5001] (proven bounds), and not
//            below the first; on average 0.43 and 0.70. Both are continuous (HN_FIXED: in steps of 2^-18)
//   error    at most 2.08e-6 against the exact value, in any metric and rounding mode (docs/measured/accuracy.md).
//            HN_FIXED 6.81e-5. From a cell at most 2.08e-6
//   period   2^32 cells per axis, or the tile's
//   cost     9 hashes (none with HN_HASH_LATTICE) and 9 multiplications; 2 more to spread the coordinates, 2 more for a
//            seed that is not constant, and 2 square roots. The compiler drops the work for results that you ignore
//   source   Worley, "A cellular texture basis function", 1996; docs/reference/contract.md, section 16
HN_FN hn_vec2 hn_cellular(hn_place2 place, hn_uint seed) {
  return hn_i_cellular(hn_i_neighbourhood(place), place.fraction, HN_I_ONE, HN_METRIC_EUCLIDEAN, seed);
}
HN_FN hn_vec2 hn_cellular(hn_vec2 p, hn_uint seed) { return hn_cellular(hn_place(p), seed); }
HN_FN hn_vec2 hn_cellular(hn_vec2 p) { return hn_cellular(p, 0u); }

// This form also takes the jitter and the metric.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   metric   the distance: usually HN_METRIC_EUCLIDEAN, or HN_METRIC_SQUARED, _MANHATTAN, _CHEBYSHEV or _HYBRID. A
//            constant compiles to that metric alone
//   seed     any uint: 7u, not 7
//   example  float f1 = hn_cellular(uv * 8.0, 1.0, HN_METRIC_EUCLIDEAN, 7u).x;
//   returns  as above, in the metric
//   error    as above
//   cost     as above
HN_FN hn_vec2 hn_cellular(hn_place2 place, hn_float jitter, hn_int metric, hn_uint seed) {
  return hn_i_cellular(hn_i_neighbourhood(place), place.fraction, hn_i_jitter(jitter), metric, seed);
}
HN_FN hn_vec2 hn_cellular(hn_vec2 p, hn_float jitter, hn_int metric, hn_uint seed) {
  return hn_cellular(hn_place(p), jitter, metric, seed);
}

// This form also takes the jitter and the metric, and sets the nearest point.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   metric   the distance: usually HN_METRIC_EUCLIDEAN, or HN_METRIC_SQUARED, _MANHATTAN, _CHEBYSHEV or _HYBRID. A
//            constant compiles to that metric alone
//   seed     any uint: 7u, not 7
//   nearest  set to the cell of the nearest point, modulo the period: hn_lattice(nearest, seed) is a random hash for
//            each cell. Among points at the same distance the first cell counts, by y, then by x
//   offset   set to the vector from the position to that point, in cells
//   example  ivec2 nearest; vec2 offset; float f1 = hn_cellular(uv * 8.0, 1.0, HN_METRIC_EUCLIDEAN, 7u, nearest,
//            offset).x;
//   returns  as above, in the metric
//   error    as above; of the offset at most 2.98e-7. HN_FIXED 2.38e-6
//   cost     as above; one more hash
HN_FN hn_vec2 hn_cellular(hn_place2 place, hn_float jitter, hn_int metric, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                          HN_I_OUT(hn_vec2) offset) {
  return hn_i_cellular(place, hn_i_jitter(jitter), metric, seed, nearest, offset);
}
HN_FN hn_vec2 hn_cellular(hn_vec2 p, hn_float jitter, hn_int metric, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                          HN_I_OUT(hn_vec2) offset) {
  return hn_cellular(hn_place(p), jitter, metric, seed, nearest, offset);
}

// To here cellular3d.glsl is generated from cellular2d.glsl.

#endif
