// hashnoise: the borders of cells on the plane.
// To read it in one piece: docs/reference/snippets/hn_cell_border2.md
// SPDX-License-Identifier: MIT

#ifndef HN_CELL_BORDER2D_GLSL
#define HN_CELL_BORDER2D_GLSL

#include "detail/feature_points2d.glsl"

// The distance to the border between the cells of two points P and Q is (q - p) / (2 |P - Q|), where p and q are the
// squares of the distances to them. hn_i_border compares the borders of a row of cells with the nearest one so far.
// The offset from P is from, and nearest has p and the code of its cell.
HN_FN hn_i_rank hn_i_border(hn_i_rank best, hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num jitter, hn_int code,
                            hn_int step, hn_i_num2 from, hn_i_rank4 nearest) {
  hn_i_num3 from_x = hn_i_from_x(hashes, x, jitter);
  hn_i_num3 from_y = hn_i_from_y(hashes, y, jitter);
  return hn_i_nearest_border(
      best, hn_i_rank_differences(hn_i_squares(from_x, from_y), nearest.x),
      hn_i_squares(hn_i_offset_difference(from_x, from.x), hn_i_offset_difference(from_y, from.y)), code, step,
      nearest.w);
}

// The distance to the border, given the smallest ranks. The cells beside the neighbourhood count, too: where a place is
// at the wall of its own cell, the cell two steps on may share the nearest border with the nearest one (tools/make
// bounds).
HN_FN hn_float hn_i_cell_border(hn_i_neighbourhood2 cells, hn_uvec2 two, hn_i_num2 d, hn_i_num jitter, hn_uint seed,
                                hn_i_rank4 nearest) {
  hn_i_num2 from = hn_i_from_nearest(cells, d, jitter, seed, nearest.w);
  hn_uint s = hn_i_scramble(seed);
  hn_i_num3 x = hn_i_row(d.x);
  hn_i_num3 y = hn_i_row(d.y);
  hn_i_num3 two_x = hn_i_equal_triple(hn_i_offset_from_cell(d.x, hn_i_far_step(d.x)));
  hn_i_num3 two_y = hn_i_equal_triple(hn_i_offset_from_cell(d.y, hn_i_far_step(d.y)));
  hn_uvec3 hashes = hn_i_hashes_along_x(cells, cells.previous.y, s);
  hn_i_rank best =
      hn_i_border(hn_i_far_away().x, hashes, x, hn_i_equal_triple(y.x), jitter, hn_i_code(0, -1), 1, from, nearest);
  hashes = hn_i_hashes_along_x(cells, cells.cell.y, s);
  best = hn_i_border(best, hashes, x, hn_i_equal_triple(y.y), jitter, hn_i_code(0, 0), 1, from, nearest);
  hashes = hn_i_hashes_along_x(cells, cells.following.y, s);
  best = hn_i_border(best, hashes, x, hn_i_equal_triple(y.z), jitter, hn_i_code(0, 1), 1, from, nearest);
  hashes = hn_i_hashes_along_x(cells, two.y, s);
  best = hn_i_border(best, hashes, x, two_y, jitter, HN_I_NO_CODE, 0, from, nearest);
  hashes = hn_i_hashes_along_y(cells, two.x, s);
  best = hn_i_border(best, hashes, two_x, y, jitter, HN_I_NO_CODE, 0, from, nearest);
  return hn_i_border_distance(best);
}

// From here cell_border3d.glsl is generated from cell_border2d.glsl.

HN_FN hn_float hn_i_cell_border(hn_place2 place, hn_i_num jitter, hn_uint seed) {
  hn_i_neighbourhood2 cells = hn_i_neighbourhood(place);
  hn_i_num2 d = hn_i_from_centre(place.fraction);
  return hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed,
                          hn_i_nearest(cells, d, jitter, HN_METRIC_SQUARED, seed));
}
HN_FN hn_float hn_i_cell_border(hn_place2 place, hn_i_num jitter, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                                HN_I_OUT(hn_vec2) offset) {
  hn_i_neighbourhood2 cells = hn_i_neighbourhood(place);
  hn_i_num2 d = hn_i_from_centre(place.fraction);
  hn_i_rank4 best = hn_i_nearest(cells, d, jitter, HN_METRIC_SQUARED, seed);
  nearest = hn_i_cell_of(place, best.w);
  offset = hn_i_toward(hn_i_from_nearest(cells, d, jitter, seed, best.w));
  return hn_i_cell_border(cells, hn_i_far_cell(place, cells, d), d, jitter, seed, best);
}

// To here cell_border3d.glsl is generated from cell_border2d.glsl.

// The distance to the border of a cell of cellular noise on the plane, for cracks, tiles and veins. The border is where
// another feature point is as near as the nearest one. It is not the difference of the distances to both.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a stone or a tile. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_cell_border(uv * 8.0, 7u);
//   returns  the distance to the border, in cells, in [0, 0.844] (proven bound), and 0.17 on average. It is continuous
//            (HN_FIXED: in steps of 2^-16)
//   error    at most 1.51e-3 against the exact value, in any rounding mode. HN_FIXED 1.27e-2. This is for two points
//            that nearly touch: it falls with the distance of the two that make the border (docs/measured/accuracy.md)
//   period   2^32 cells per axis, or the tile's
//   cost     9, 1 and 15 hashes (none with HN_HASH_LATTICE), as many multiplications, and 15 square roots and divisions
//   source   Quilez, "Voronoi edges", 2012, for the distance; docs/reference/contract.md, section 16
HN_FN hn_float hn_cell_border(hn_place2 place, hn_uint seed) { return hn_i_cell_border(place, HN_I_ONE, seed); }

// From here cell_border3d.glsl is generated from cell_border2d.glsl.

HN_FN hn_float hn_cell_border(hn_vec2 p, hn_uint seed) { return hn_cell_border(hn_place(p), seed); }
HN_FN hn_float hn_cell_border(hn_vec2 p) { return hn_cell_border(p, 0u); }

// This form also takes the jitter.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   example  float n = hn_cell_border(uv * 8.0, 1.0, 7u);
//   returns  as above
//   error    as above
//   cost     as above
HN_FN hn_float hn_cell_border(hn_place2 place, hn_float jitter, hn_uint seed) {
  return hn_i_cell_border(place, hn_i_jitter(jitter), seed);
}
HN_FN hn_float hn_cell_border(hn_vec2 p, hn_float jitter, hn_uint seed) {
  return hn_cell_border(hn_place(p), jitter, seed);
}

// This form also takes the jitter, and sets the nearest point.
//   jitter   how far the points are from the centres of their cells, in [0, 1]: usually 1; 0 makes a regular lattice.
//            Numbers outside count as the nearer end
//   seed     any uint: 7u, not 7
//   nearest  set to the cell of the nearest point, modulo the period: hn_lattice(nearest, seed) is a random hash for
//            each cell. Among points at the same distance the first cell counts, by y, then by x
//   offset   set to the vector from the position to that point, in cells
//   example  ivec2 nearest; vec2 offset; float n = hn_cell_border(uv * 8.0, 1.0, 7u, nearest, offset);
//   returns  as above
//   error    as above; of the offset at most 3.88e-7. HN_FIXED 2.38e-6
//   cost     as above; one more hash
HN_FN hn_float hn_cell_border(hn_place2 place, hn_float jitter, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                              HN_I_OUT(hn_vec2) offset) {
  return hn_i_cell_border(place, hn_i_jitter(jitter), seed, nearest, offset);
}
HN_FN hn_float hn_cell_border(hn_vec2 p, hn_float jitter, hn_uint seed, HN_I_OUT(hn_ivec2) nearest,
                              HN_I_OUT(hn_vec2) offset) {
  return hn_cell_border(hn_place(p), jitter, seed, nearest, offset);
}

// To here cell_border3d.glsl is generated from cell_border2d.glsl.

#endif
