// hashnoise: the borders of cells in space.
// SPDX-License-Identifier: MIT

#ifndef HN_CELL_BORDER3D_GLSL
#define HN_CELL_BORDER3D_GLSL

#include "detail/feature_points3d.glsl"

// Compares the borders of a row of cells with the nearest one so far, as on the plane (cell_border2d.glsl).
HN_FN hn_i_rank hn_i_border(hn_i_rank best, hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num3 z, hn_i_num jitter,
                            hn_int code, hn_int step, hn_i_num3 from, hn_i_rank4 nearest) {
  hn_i_num3 u = hn_i_from_u(hashes, x, y, jitter);
  hn_i_num3 v = hn_i_from_v(hashes, x, y, jitter);
  hn_i_num3 w = hn_i_from_z(hashes, z, jitter);
  return hn_i_nearest_border(best, hn_i_rank_differences(hn_i_squares(u, v, w), nearest.x),
                             hn_i_squares(hn_i_offset_difference(u, from.x), hn_i_offset_difference(v, from.y),
                                          hn_i_offset_difference(w, from.z)),
                             code, step, nearest.w);
}

// The distance to the border, given the smallest ranks. The cells beside the neighbourhood count, too: where a place is
// at the wall of its own cell, the cell two steps on may share the nearest border with the nearest one (tools/make
// bounds). These are 54 cells, in six slabs. They are visited in a loop: unrolled, a shader takes much longer to
// compile.
HN_FN hn_float hn_i_cell_border(hn_i_neighbourhood3 cells, hn_uvec3 two, hn_i_num3 d, hn_i_num jitter, hn_uint seed,
                                hn_i_rank4 nearest) {
  hn_i_num3 from = hn_i_from_nearest(cells, d, jitter, seed, nearest.w);
  hn_i_rank best = hn_i_far_away().x;
  for (hn_int slab = -1; slab < 5; ++slab) {
    hn_int axis = hn_i_select(slab > 1, slab - 2, 2);
    hn_uint at =
        hn_i_select(slab > 1, hn_i_component_along(axis, two), hn_i_triple_at(hn_i_coordinates_z(cells), slab));
    hn_int steps = hn_i_select(slab > 1, hn_i_far_step_along(axis, d), slab);
    hn_i_num3 x = hn_i_slab_x(d, axis, steps);
    for (hn_int n = -1; n <= 1; ++n) {
      hn_int code = hn_i_select(slab > 1, HN_I_NO_CODE, hn_i_code(0, n, slab));
      best = hn_i_border(best, hn_i_slab_hashes(cells, axis, at, n, seed), x, hn_i_slab_y(d, axis, steps, n),
                         hn_i_slab_z(d, axis, steps, n), jitter, code, hn_i_select_int(slab > 1, 0, 1), from, nearest);
    }
  }
  return hn_i_border_distance(best);
}

// From here cell_border3d.glsl is generated from cell_border2d.glsl.

HN_FN hn_float hn_i_cell_border(hn_place3 place, hn_i_num jitter, hn_uint seed) {
  hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
  hn_i_num3 d = hn_i_from_centre(place.fraction);
  return hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed,
                          hn_i_nearest(cells, d, jitter, HN_METRIC_SQUARED, seed));
}
HN_FN hn_float hn_i_cell_border(hn_place3 place, hn_i_num jitter, hn_uint seed, HN_I_OUT(hn_ivec3) nearest,
                                HN_I_OUT(hn_vec3) offset) {
  hn_i_neighbourhood3 cells = hn_i_neighbourhood(place);
  hn_i_num3 d = hn_i_from_centre(place.fraction);
  hn_i_rank4 best = hn_i_nearest(cells, d, jitter, HN_METRIC_SQUARED, seed);
  nearest = hn_i_cell_of(place, best.w);
  offset = hn_i_toward(hn_i_from_nearest(cells, d, jitter, seed, best.w));
  return hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed, best);
}

// To here cell_border3d.glsl is generated from cell_border2d.glsl.

// The distance to the border of a cell of cellular noise in space, for cracks, tiles and veins. The border is where
// another feature point is as near as the nearest one. It is not the difference of the distances to both.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_cell_border(vec3(uv * 8.0, 0.5), 7u);
//   returns  the distance to the border, in cells, in [0, 0.883] (proven bound), and 0.13 on average. It is continuous
//            (HN_FIXED: in steps of 2^-16)
//   error    at most 1.72e-3 against the exact value, in any rounding mode. HN_FIXED 6.97e-3. This is for two points
//            that nearly touch: it falls with the distance of the two that make the border (docs/measured/accuracy.md)
//   period   2^32 cells per axis, or the tile's
//   cost     27, 1 and 54 hashes (none with HN_HASH_LATTICE), as many multiplications, and 54 square roots and
//            divisions
//   source   Quilez, "Voronoi edges", 2012, for the distance; docs/reference/contract.md, section 16
HN_FN hn_float hn_cell_border(hn_place3 place, hn_uint seed) { return hn_i_cell_border(place, HN_I_ONE, seed); }

// From here cell_border3d.glsl is generated from cell_border2d.glsl.

HN_FN hn_float hn_cell_border(hn_vec3 p, hn_uint seed) { return hn_cell_border(hn_place(p), seed); }
HN_FN hn_float hn_cell_border(hn_vec3 p) { return hn_cell_border(p, 0u); }

// This form also takes the jitter.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   example  float n = hn_cell_border(vec3(uv * 8.0, 0.5), 1.0, 7u);
//   returns  as above
//   error    as above
//   cost     as above
HN_FN hn_float hn_cell_border(hn_place3 place, hn_float jitter, hn_uint seed) {
  return hn_i_cell_border(place, hn_i_jitter(jitter), seed);
}
HN_FN hn_float hn_cell_border(hn_vec3 p, hn_float jitter, hn_uint seed) {
  return hn_cell_border(hn_place(p), jitter, seed);
}

// This form also takes the jitter, and sets the nearest point.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   nearest  set to the cell of the nearest point, modulo the period: hn_lattice(nearest, seed) is a random hash for
//            each cell. Among points at the same distance the first cell counts, by z, then by y, then by x
//   offset   set to the vector from the position to that point, in cells
//   example  ivec3 nearest; vec3 offset; float n = hn_cell_border(vec3(uv * 8.0, 0.5), 1.0, 7u, nearest, offset);
//   returns  as above
//   error    as above; of the offset at most 1.05e-6. HN_FIXED 2.38e-6
//   cost     as above; one more hash
HN_FN hn_float hn_cell_border(hn_place3 place, hn_float jitter, hn_uint seed, HN_I_OUT(hn_ivec3) nearest,
                              HN_I_OUT(hn_vec3) offset) {
  return hn_i_cell_border(place, hn_i_jitter(jitter), seed, nearest, offset);
}
HN_FN hn_float hn_cell_border(hn_vec3 p, hn_float jitter, hn_uint seed, HN_I_OUT(hn_ivec3) nearest,
                              HN_I_OUT(hn_vec3) offset) {
  return hn_cell_border(hn_place(p), jitter, seed, nearest, offset);
}

// To here cell_border3d.glsl is generated from cell_border2d.glsl.

#endif
