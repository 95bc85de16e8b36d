// hashnoise: the feature points around a place in space, as they circle.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS_MOVING3D_GLSL
#define HN_FEATURE_POINTS_MOVING3D_GLSL

#include "feature_points_moving.glsl"
#include "feature_points3d.glsl"

// As on the plane, but at the corner of eight cells: sqrt(3/4) + r < sqrt(11/4) - r, that is, r < 0.3961. Directions
// are shorter than 1, so with 25/32 of the jitter r is below 0.3907.
HN_FN hn_i_num hn_i_moving_jitter3(hn_float jitter) { return hn_i_jitter(jitter, 25); }

// The rows of a matrix that rotates a place around the centre of a cell, backwards. Points rotate about the x axis
// first, then about the z axis, both by the phase. About one axis alone the points near to it would hardly move.
struct hn_i_turn3 {
  hn_i_num3 x;
  hn_i_num3 y;
  hn_i_num3 z;
};
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_product_of_sines(hn_float a, hn_float b) { return hn_i_times(a, b); }
#else
// Half of a sine times another, in units of 2^-16, may be 2^31: a sine is 1 in places. So the second is halved, too,
// and its low bit taken on its own. The result is the whole product's.
HN_FN hn_int hn_i_product_of_sines(hn_int a, hn_int b) {
  hn_int first = a >> 3;
  return ((first * (b >> 3) + ((first * ((b >> 2) & 1) + 16384) >> 1)) >> 14) * 4;
}
#endif
HN_FN hn_i_turn3 hn_i_turning3(hn_float phase) {
  HN_I_NEW(hn_i_turn3, turn);
  hn_i_num2 r = hn_i_rotation(phase);
  hn_i_num both = hn_i_product_of_sines(r.y, r.x);
  turn.x = hn_i_vector(r.x, r.y, hn_i_minus(r.x, r.x));
  turn.y = hn_i_vector(-both, hn_i_product_of_sines(r.x, r.x), r.y);
  turn.z = hn_i_vector(hn_i_product_of_sines(r.y, r.y), -both, r.x);
  return turn;
}
HN_FN hn_i_num hn_i_projected(hn_i_num3 d, hn_i_num3 row) {
  return hn_i_plus(hn_i_plus(hn_i_projected(d.x, row.x), hn_i_projected(d.y, row.y)), hn_i_projected(d.z, row.z));
}

// The offsets of a place from the centres of three cells: of the n-th cell after its own along z, and of the neighbours
// of that cell along y. d is the offset from the centre of its own cell along an axis, rotated.
HN_FN hn_i_num3 hn_i_column(hn_i_num d, hn_i_num3 row, hn_int n) {
  return hn_i_row(hn_i_turned_offset(d, row.z, n), row.y);
}

// Inserts the ranks of nine cells in a slab across z, the n-th after that of the place, into the three smallest so far.
// d is the offset of the place from the centre of its cell, rotated.
HN_FN hn_i_rank4 hn_i_visit_slab(hn_i_rank4 best, hn_i_neighbourhood3 cells, hn_i_num3 d, hn_i_turn3 turn,
                                 hn_i_num jitter, hn_uint at, hn_int n, hn_uint seed) {
  hn_i_num3 x = hn_i_column(d.x, turn.x, n);
  hn_i_num3 y = hn_i_column(d.y, turn.y, n);
  hn_i_num3 z = hn_i_column(d.z, turn.z, n);
  best = hn_i_insert(best,
                     hn_i_ranks(hn_i_slab_hashes(cells, 2, at, -1, seed), hn_i_row(x.x, turn.x.x),
                                hn_i_row(y.x, turn.y.x), hn_i_row(z.x, turn.z.x), jitter, HN_METRIC_EUCLIDEAN),
                     hn_i_code(0, -1, n), 1);
  best = hn_i_insert(best,
                     hn_i_ranks(hn_i_slab_hashes(cells, 2, at, 0, seed), hn_i_row(x.y, turn.x.x),
                                hn_i_row(y.y, turn.y.x), hn_i_row(z.y, turn.z.x), jitter, HN_METRIC_EUCLIDEAN),
                     hn_i_code(0, 0, n), 1);
  return hn_i_insert(best,
                     hn_i_ranks(hn_i_slab_hashes(cells, 2, at, 1, seed), hn_i_row(x.z, turn.x.x),
                                hn_i_row(y.z, turn.y.x), hn_i_row(z.z, turn.z.x), jitter, HN_METRIC_EUCLIDEAN),
                     hn_i_code(0, 1, n), 1);
}

// The three smallest ranks of the points of a cell and its neighbours, and the code of the nearest one's cell. d is the
// offset of the place from the centre of the cell.
HN_FN hn_i_rank4 hn_i_nearest(hn_i_neighbourhood3 cells, hn_i_num3 d, hn_i_turn3 turn, hn_i_num jitter, hn_uint seed) {
  hn_i_num3 turned = hn_i_vector(hn_i_projected(d, turn.x), hn_i_projected(d, turn.y), hn_i_projected(d, turn.z));
  hn_i_rank4 best = hn_i_visit_slab(hn_i_far_away(), cells, turned, turn, jitter, cells.previous.z, -1, seed);
  best = hn_i_visit_slab(best, cells, turned, turn, jitter, cells.cell.z, 0, seed);
  return hn_i_visit_slab(best, cells, turned, turn, jitter, cells.following.z, 1, seed);
}

// The vector from the place to the point of the cell with that code.
HN_FN hn_i_num hn_i_turned_offset(hn_i_num3 d, hn_i_num3 row, hn_int i, hn_int j, hn_int k) {
  return hn_i_turned_offset(hn_i_turned_offset(hn_i_turned_offset(hn_i_projected(d, row), row.z, k), row.y, j), row.x,
                            i);
}
HN_FN hn_vec3 hn_i_to_nearest(hn_i_neighbourhood3 cells, hn_i_num3 d, hn_i_turn3 turn, hn_i_num jitter, hn_uint seed,
                              hn_i_rank code) {
  hn_int i = hn_i_x_of(int(code));
  hn_int j = hn_i_y_of(int(code));
  hn_int k = hn_i_z_of(int(code));
  hn_uint s = hn_i_scramble(seed);
  hn_uvec3 hashes = hn_i_equal_triple(
      hn_i_seeded_hash(uvec3(hn_i_triple_at(hn_i_coordinates_x(cells), i), hn_i_triple_at(hn_i_coordinates_y(cells), j),
                             hn_i_triple_at(hn_i_coordinates_z(cells), k)),
                       s));
  hn_i_num3 x = hn_i_equal_triple(hn_i_turned_offset(d, turn.x, i, j, k));
  hn_i_num3 y = hn_i_equal_triple(hn_i_turned_offset(d, turn.y, i, j, k));
  hn_i_num3 z = hn_i_equal_triple(hn_i_turned_offset(d, turn.z, i, j, k));
  hn_i_num3 from = hn_i_from_octahedral(hn_i_vector(
      hn_i_from_u(hashes, x, y, jitter).x, hn_i_from_v(hashes, x, y, jitter).x, hn_i_from_z(hashes, z, jitter).x));
  return vec3(hn_i_toward(hn_i_projected(from, hn_i_vector(turn.x.x, turn.y.x, turn.z.x))),
              hn_i_toward(hn_i_projected(from, hn_i_vector(turn.x.y, turn.y.y, turn.z.y))),
              hn_i_toward(hn_i_projected(from, hn_i_vector(turn.x.z, turn.y.z, turn.z.z))));
}

#endif
