// hashnoise: the feature points around a place on the plane, as they circle.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS_MOVING2D_GLSL
#define HN_FEATURE_POINTS_MOVING2D_GLSL

#include "feature_points_moving.glsl"
#include "feature_points2d.glsl"

// At the corner of four cells each of their points may be sqrt(1/2) + r away, where r is the largest distance from the
// centre of a cell. A cell beyond has its centre sqrt(5/2) away. So the nearest two are among the four if
// sqrt(1/2) + r < sqrt(5/2) - r, that is, for r < 0.4370; everywhere else there is more room. Directions are no longer
// than sqrt(511^2 + 1) / 512, so with 7/8 of the jitter r is 0.4367.
HN_FN hn_i_num hn_i_moving_jitter2(hn_float jitter) { return hn_i_jitter(jitter, 28); }

// The rows of a matrix that rotates a place around the centre of a cell, backwards.
struct hn_i_turn2 {
  hn_i_num2 x;
  hn_i_num2 y;
};
HN_FN hn_i_turn2 hn_i_turning2(hn_float phase) {
  HN_I_NEW(hn_i_turn2, turn);
  turn.x = hn_i_rotation(phase);
  turn.y = hn_i_vector(-turn.x.y, turn.x.x);
  return turn;
}
HN_FN hn_i_num hn_i_projected(hn_i_num2 d, hn_i_num2 row) {
  return hn_i_plus(hn_i_projected(d.x, row.x), hn_i_projected(d.y, row.y));
}

// The three smallest ranks of the points of a cell and its neighbours, and the code of the nearest one's cell. d is the
// offset of the place from the centre of the cell. x and y are those from the centres of the cells above and below it,
// rotated.
HN_FN hn_i_rank4 hn_i_nearest(hn_i_neighbourhood2 cells, hn_i_num2 d, hn_i_turn2 turn, hn_i_num jitter, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_i_num3 x = hn_i_row(hn_i_projected(d, turn.x), turn.x.y);
  hn_i_num3 y = hn_i_row(hn_i_projected(d, turn.y), turn.y.y);
  hn_i_rank4 best = hn_i_insert(hn_i_far_away(),
                                hn_i_squares(hn_i_hashes_along_x(cells, cells.previous.y, s), hn_i_row(x.x, turn.x.x),
                                             hn_i_row(y.x, turn.y.x), jitter),
                                hn_i_code(0, -1), 1);
  best = hn_i_insert(best,
                     hn_i_squares(hn_i_hashes_along_x(cells, cells.cell.y, s), hn_i_row(x.y, turn.x.x),
                                  hn_i_row(y.y, turn.y.x), jitter),
                     hn_i_code(0, 0), 1);
  return hn_i_insert(best,
                     hn_i_squares(hn_i_hashes_along_x(cells, cells.following.y, s), hn_i_row(x.z, turn.x.x),
                                  hn_i_row(y.z, turn.y.x), jitter),
                     hn_i_code(0, 1), 1);
}

// The vector from the place to the point of the cell with that code.
HN_FN hn_vec2 hn_i_to_nearest(hn_i_neighbourhood2 cells, hn_i_num2 d, hn_i_turn2 turn, hn_i_num jitter, hn_uint seed,
                              hn_i_rank code) {
  hn_int i = hn_i_x_of(int(code));
  hn_int j = hn_i_y_of(int(code));
  hn_uint s = hn_i_scramble(seed);
  hn_uvec3 hashes = hn_i_equal_triple(hn_i_seeded_hash(
      uvec2(hn_i_triple_at(hn_i_coordinates_x(cells), i), hn_i_triple_at(hn_i_coordinates_y(cells), j)), s));
  hn_i_num x = hn_i_turned_offset(hn_i_turned_offset(hn_i_projected(d, turn.x), turn.x.y, j), turn.x.x, i);
  hn_i_num y = hn_i_turned_offset(hn_i_turned_offset(hn_i_projected(d, turn.y), turn.y.y, j), turn.y.x, i);
  hn_i_num2 from = hn_i_vector(hn_i_from_x(hashes, hn_i_equal_triple(x), jitter).x,
                               hn_i_from_y(hashes, hn_i_equal_triple(y), jitter).x);
  return vec2(hn_i_toward(hn_i_projected(from, hn_i_vector(turn.x.x, turn.y.x))),
              hn_i_toward(hn_i_projected(from, hn_i_vector(turn.x.y, turn.y.y))));
}

#endif
