// hashnoise: cellular noise in space whose points circle with a phase.
// SPDX-License-Identifier: MIT
//
// Made from cellular_phase2d.glsl by tools/make. tools/lib/translate/dimensions/numbers.py has its numbers.

#ifndef HN_CELLULAR_PHASE3D_GLSL
#define HN_CELLULAR_PHASE3D_GLSL

// From here cellular_phase3d.glsl is generated from cellular_phase2d.glsl.

#include "detail/feature_points_moving3d.glsl"

HN_FN hn_i_rank4 hn_i_nearest(hn_place3 place, hn_i_turn3 turn, hn_float jitter, hn_uint seed) {
  return hn_i_nearest(hn_i_neighbourhood(place), hn_i_from_centre(place.fraction), turn, hn_i_moving_jitter3(jitter),
                      seed);
}

// Cellular noise in space whose points circle with a phase: cells move in place, and loop after one turn.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: phase + 1 has the same bits. A float far from 0 has few bits left for the turn: pass
//            fract(phase)
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1, which puts them at 25/32 of
//            the distance of hn_cellular's; 0 makes a regular lattice. Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  float f1 = hn_cellular_phase(vec3(uv * 8.0, 0.5), 0.25, 1.0, 7u).x;
//   returns  the two distances, in cells, by the Euclidean metric: the first in [0, 1.208], the second in [0, 1.3892]
//            (proven bounds), and not below the first. Both are continuous (HN_FIXED: in steps of 2^-18), in the phase,
//            too
//   error    at most 6.78e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            2.54e-4. From a cell at most 6.78e-6
//   period   2^32 cells per axis, or the tile's
//   cost     hn_cellular's, a sine and a cosine of 6 multiplications of floats each, and 21 multiplications
//   source   Worley, "A cellular texture basis function", 1996; docs/reference/contract.md, section 16
HN_FN hn_vec2 hn_cellular_phase(hn_place3 place, hn_float phase, hn_float jitter, hn_uint seed) {
  return hn_i_two_distances(hn_i_nearest(place, hn_i_turning3(phase), jitter, seed), HN_METRIC_EUCLIDEAN);
}
HN_FN hn_vec2 hn_cellular_phase(hn_vec3 p, hn_float phase, hn_float jitter, hn_uint seed) {
  return hn_cellular_phase(hn_place(p), phase, jitter, seed);
}

// This form also sets the nearest point.
//   nearest  set to the cell of the nearest point, modulo the period: hn_lattice(nearest, seed) is a random hash for
//            each cell. Among points at the same distance the first cell counts, by z, then by y, then by x
//   offset   set to the vector from the position to that point, in cells
//   example  ivec3 nearest; vec3 offset; float f1 = hn_cellular_phase(vec3(uv * 8.0, 0.5), 0.25, 1.0, 7u, nearest,
//            offset).x;
//   returns  as above
//   error    as above; of the offset at most 7.32e-6. HN_FIXED 3.00e-4
//   cost     as above; one more hash
//   (parameters as above)
HN_FN hn_vec2 hn_cellular_phase(hn_place3 place, hn_float phase, hn_float jitter, hn_uint seed,
                                HN_I_OUT(hn_ivec3) nearest, HN_I_OUT(hn_vec3) offset) {
  hn_i_turn3 turn = hn_i_turning3(phase);
  hn_i_rank4 best = hn_i_nearest(place, turn, jitter, seed);
  nearest = hn_i_cell_of(place, best.w);
  offset = hn_i_to_nearest(hn_i_neighbourhood(place), hn_i_from_centre(place.fraction), turn,
                           hn_i_moving_jitter3(jitter), seed, best.w);
  return hn_i_two_distances(best, HN_METRIC_EUCLIDEAN);
}
HN_FN hn_vec2 hn_cellular_phase(hn_vec3 p, hn_float phase, hn_float jitter, hn_uint seed, HN_I_OUT(hn_ivec3) nearest,
                                HN_I_OUT(hn_vec3) offset) {
  return hn_cellular_phase(hn_place(p), phase, jitter, seed, nearest, offset);
}

// To here cellular_phase3d.glsl is generated from cellular_phase2d.glsl.

#endif
