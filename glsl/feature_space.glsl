// hashnoise: the feature points around a place in space.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_SPACE_GLSL
#define HN_FEATURE_SPACE_GLSL

#include "feature.glsl"

HN_FN hn_num3 hn_i_inner(hn_num3 f) { return hn_i_num(hn_i_inner(f.x), hn_i_inner(f.y), hn_i_inner(f.z)); }
HN_FN hn_num3 hn_i_beside(hn_num3 d, hn_int x, hn_int y, hn_int z) {
  return hn_i_num(hn_i_beside(d.x, x), hn_i_beside(d.y, y), hn_i_beside(d.z, z));
}
HN_FN hn_num3 hn_i_apart(hn_num3 a, hn_num3 b) {
  return hn_i_num(hn_i_apart(a.x, b.x), hn_i_apart(a.y, b.y), hn_i_apart(a.z, b.z));
}

// An offset from a point is turned where it is made of floats: its components are x + y, x - y and z. Directions come
// so (gradient.glsl), and the sums of offsets from centres are shared between cells. In HN_FIXED they are x, y and z.
//
//   hn_i_turned_offset(d)    such an offset
//   hn_i_plain_offset(d)     the offset of such a one
//   hn_i_turned_point(word)  twice the offset of a point from the centre of its cell
#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec3 hn_i_turned_offset(hn_vec3 d) { return vec3(hn_i_plus(d.x, d.y), hn_i_minus(d.x, d.y), d.z); }
HN_FN hn_vec3 hn_i_plain_offset(hn_vec3 d) {
  return vec3(hn_i_times(hn_i_plus(d.x, d.y), 0.5f), hn_i_times(hn_i_minus(d.x, d.y), 0.5f), d.z);
}
HN_FN hn_vec3 hn_i_turned_point(hn_uint word) {
  hn_vec4 direction = hn_i_direction3(word);
  return vec3(direction.x, direction.y, direction.z);
}
HN_FN hn_float hn_i_squared(hn_vec3 d) {
  HN_I_PRECISE hn_float q = (d.x * d.x + d.y * d.y) * 0.5f + d.z * d.z;
  return q;
}
HN_FN hn_float hn_i_manhattan(hn_vec3 d) { return hn_i_plus(max(abs(d.x), abs(d.y)), abs(d.z)); }
HN_FN hn_float hn_i_chebyshev(hn_vec3 d) { return max(hn_i_times(hn_i_plus(abs(d.x), abs(d.y)), 0.5f), abs(d.z)); }

#else

HN_FN hn_ivec3 hn_i_turned_offset(hn_ivec3 d) { return d; }
HN_FN hn_ivec3 hn_i_plain_offset(hn_ivec3 d) { return d; }

// A direction in space has units of 2^-8, and this has those of 2^-9.
HN_FN hn_ivec3 hn_i_turned_point(hn_uint word) {
  hn_ivec4 direction = hn_i_direction3(word);
  return ivec3(direction.x + direction.y, direction.x - direction.y, direction.z + direction.z);
}
HN_FN hn_uint hn_i_squared(hn_ivec3 d) { return hn_i_squared(d.x, d.y, d.z); }
HN_FN hn_uint hn_i_manhattan(hn_ivec3 d) { return hn_i_size(d.x) + hn_i_size(d.y) + hn_i_size(d.z); }
HN_FN hn_uint hn_i_chebyshev(hn_ivec3 d) { return max(max(hn_i_size(d.x), hn_i_size(d.y)), hn_i_size(d.z)); }

#endif

HN_FN hn_rank hn_i_rank(hn_num3 d, hn_int metric) {
  if (metric == HN_METRIC_MANHATTAN) return hn_i_manhattan(d);
  if (metric == HN_METRIC_CHEBYSHEV) return hn_i_chebyshev(d);
  if (metric == HN_METRIC_HYBRID) return hn_i_hybrid(hn_i_squared(d), hn_i_manhattan(d));
  return hn_i_squared(d);
}

// The offset of a place from the point of a cell with that word, turned; d is that from the centre of the cell.
HN_FN hn_num3 hn_i_from_point(hn_uint word, hn_num3 d, hn_num jitter) {
  hn_num3 point = hn_i_turned_point(word);
  hn_num3 from = hn_i_turned_offset(d);
  return hn_i_num(hn_i_past_point(from.x, point.x, jitter), hn_i_past_point(from.y, point.y, jitter),
                  hn_i_past_point(from.z, point.z, jitter));
}
HN_FN hn_vec3 hn_i_toward(hn_num3 from) {
  hn_num3 d = hn_i_plain_offset(from);
  return vec3(hn_i_toward(d.x), hn_i_toward(d.y), hn_i_toward(d.z));
}
HN_FN hn_vec3 hn_i_unit(hn_num3 from) {
  hn_num3 d = hn_i_plain_offset(from);
  return hn_i_unit(d.x, d.y, d.z);
}

// Along each axis b where the place is on that side of the centre, else a.
HN_FN hn_uvec3 hn_i_ahead(hn_num3 d, hn_uvec3 a, hn_uvec3 b) {
  return uvec3(hn_i_select(d.x > HN_I_NO_OFFSET, b.x, a.x), hn_i_select(d.y > HN_I_NO_OFFSET, b.y, a.y),
               hn_i_select(d.z > HN_I_NO_OFFSET, b.z, a.z));
}

// The spread coordinates of the cell that is two steps on along all axes, on the side of the place.
HN_FN hn_uvec3 hn_i_two_steps(hn_uvec3 first, hn_num3 d) {
  return hn_i_ahead(d, hn_i_before(hn_i_before(first)), hn_i_last(hn_i_last(first)));
}
HN_FN hn_uvec3 hn_i_two_steps(hn_uvec3 c, hn_ivec3 period, hn_num3 d) {
  return hn_i_spread(
      hn_i_ahead(d, hn_i_before(hn_i_before(c, period), period), hn_i_after(hn_i_after(c, period), period)));
}

// The distance to the border between the cells of two points P and Q is (q - p) / (2 |P - Q|), where p and q are the
// squares of the distances to them. Borders are compared by this number, from the offsets of a place from Q and from P,
// and from p. It is large for the cell of P itself, which `code` and `own` tell.
HN_FN hn_rank hn_i_border(hn_num3 from, hn_num3 nearest, hn_rank p, hn_rank code, hn_rank own) {
  hn_rank large = hn_i_far_away().x;
  hn_rank apart = hn_i_select(code == own, large, hn_i_squared(hn_i_apart(from, nearest)));
  return hn_i_select(code == own, large, hn_i_border_rank(hn_i_gap(hn_i_squared(from), p), apart));
}

// What the point of one more cell makes of `best`: the smallest ranks by a metric, the nearest border, or
// the sum of weights. The cell has that word and code, and d is the offset of the place from its centre. For borders
// `nearest` is the offset from the nearest point, and `known` has its rank and code.
HN_FN hn_rank4 hn_i_visit(hn_rank4 best, hn_uint word, hn_num3 d, hn_num jitter, hn_int metric, hn_int code,
                          hn_num3 nearest, hn_rank4 known) {
  hn_num3 from = hn_i_from_point(word, d, jitter);
  if (metric == HN_I_WEIGHTS) {
    return hn_i_ranks(hn_i_sum(best.x, hn_i_closeness(hn_i_squared(from))), best.y, best.z, best.w);
  }
  if (metric == HN_I_BORDERS) {
    hn_rank border = hn_i_border(from, nearest, known.x, hn_i_rank_of_code(code), known.w);
    return hn_i_ranks(min(best.x, border), best.y, best.z, best.w);
  }
  return hn_i_visited(best, hn_i_rank(from, metric), code);
}

// The same for three cells in a row, with the offsets of the place from their centres.
HN_FN hn_rank4 hn_i_visit_row(hn_rank4 best, hn_uvec3 words, hn_num3 before, hn_num3 middle, hn_num3 after,
                              hn_num jitter, hn_int metric, hn_int code, hn_int step, hn_num3 nearest, hn_rank4 known) {
  best = hn_i_visit(best, words.x, before, jitter, metric, code - step, nearest, known);
  best = hn_i_visit(best, words.y, middle, jitter, metric, code, nearest, known);
  return hn_i_visit(best, words.z, after, jitter, metric, code + step, nearest, known);
}

// Nine cells that have one coordinate in common, in three rows: what the axis along the rows adds to the joins of a
// word, what the axis across them adds, and what the rest adds. The offset is that from the centre of the cell in the
// middle, and `along` and `across` are the axes.
HN_FN hn_num3 hn_i_step_by(hn_num3 d, hn_ivec3 along, hn_int n) {
  return hn_i_beside(d, along.x * n, along.y * n, along.z * n);
}
HN_FN hn_rank4 hn_i_visit_slab(hn_rank4 best, hn_uvec3 joins, hn_uvec3 odds, hn_uvec3 row_joins, hn_uvec3 row_odds,
                               hn_uint join, hn_uint odd, hn_num3 d, hn_ivec3 along, hn_ivec3 across, hn_num jitter,
                               hn_int metric, hn_int code, hn_ivec2 step, hn_num3 nearest, hn_rank4 known) {
  hn_num3 a = hn_i_step_by(d, across, -1);
  hn_num3 b = hn_i_step_by(d, across, 1);
  best = hn_i_visit_row(best, hn_i_row_words(joins, odds, row_joins.x ^ join, row_odds.x + odd),
                        hn_i_step_by(a, along, -1), a, hn_i_step_by(a, along, 1), jitter, metric, code - step.y, step.x,
                        nearest, known);
  best = hn_i_visit_row(best, hn_i_row_words(joins, odds, row_joins.y ^ join, row_odds.y + odd),
                        hn_i_step_by(d, along, -1), d, hn_i_step_by(d, along, 1), jitter, metric, code, step.x, nearest,
                        known);
  return hn_i_visit_row(best, hn_i_row_words(joins, odds, row_joins.z ^ join, row_odds.z + odd),
                        hn_i_step_by(b, along, -1), b, hn_i_step_by(b, along, 1), jitter, metric, code + step.y, step.x,
                        nearest, known);
}

// A cell and its neighbours, from their spread coordinates. d is the offset from the centre of the cell. `best` is what
// other cells made.
HN_FN hn_rank4 hn_i_visit_block(hn_rank4 best, hn_uvec3 before, hn_uvec3 cell, hn_uvec3 after, hn_num3 d, hn_num jitter,
                                hn_int metric, hn_uint seed, hn_num3 nearest, hn_rank4 known) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 a = hn_i_fold(before);
  hn_uvec3 b = hn_i_fold(cell);
  hn_uvec3 c = hn_i_fold(after);
  hn_uvec3 join_x = uvec3(a.x, b.x, c.x);
  hn_uvec3 join_y = uvec3(a.y, b.y, c.y);
  hn_uvec3 odd_x = uvec3(before.x * 2u, cell.x * 2u, after.x * 2u);
  hn_uvec3 odd_y = uvec3(before.y * 2u, cell.y * 2u, after.y * 2u);
  hn_ivec3 x = ivec3(1, 0, 0);
  hn_ivec3 y = ivec3(0, 1, 0);
  hn_ivec2 step = ivec2(1, 4);
  best = hn_i_visit_slab(best, join_x, odd_x, join_y, odd_y, a.z ^ s, hn_i_odd(before.z + s), hn_i_beside(d, 0, 0, -1),
                         x, y, jitter, metric, hn_i_code(0, 0, -1), step, nearest, known);
  best = hn_i_visit_slab(best, join_x, odd_x, join_y, odd_y, b.z ^ s, hn_i_odd(cell.z + s), d, x, y, jitter, metric,
                         hn_i_code(0, 0, 0), step, nearest, known);
  return hn_i_visit_slab(best, join_x, odd_x, join_y, odd_y, c.z ^ s, hn_i_odd(after.z + s), hn_i_beside(d, 0, 0, 1), x,
                         y, jitter, metric, hn_i_code(0, 0, 1), step, nearest, known);
}

// a for that axis, else b.
HN_FN hn_uvec3 hn_i_for_axis(hn_int axis, hn_int which, hn_uvec3 a, hn_uvec3 b) {
  return uvec3(hn_i_select(axis == which, a.x, b.x), hn_i_select(axis == which, a.y, b.y),
               hn_i_select(axis == which, a.z, b.z));
}
HN_FN hn_uint hn_i_along(hn_int axis, hn_uvec3 v) {
  return hn_i_select(axis == 0, v.x, hn_i_select(axis == 1, v.y, v.z));
}

// The nine cells at a number of steps along an axis: x for 0, y for 1 and z for 2. `at` is their spread coordinate
// along it. Their rows run along x, or along y if the axis is x. `code` is that of the one in the middle.
HN_FN hn_rank4 hn_i_visit_across(hn_rank4 best, hn_uvec3 before, hn_uvec3 cell, hn_uvec3 after, hn_int axis, hn_uint at,
                                 hn_int steps, hn_num3 d, hn_num jitter, hn_int metric, hn_int code, hn_ivec2 step,
                                 hn_uint seed, hn_num3 nearest, hn_rank4 known) {
  hn_uvec3 a = hn_i_fold(before);
  hn_uvec3 b = hn_i_fold(cell);
  hn_uvec3 c = hn_i_fold(after);
  hn_uvec3 joins = hn_i_for_axis(axis, 0, uvec3(a.y, b.y, c.y), uvec3(a.x, b.x, c.x));
  hn_uvec3 odds = hn_i_for_axis(axis, 0, uvec3(before.y, cell.y, after.y), uvec3(before.x, cell.x, after.x));
  hn_uvec3 row_joins = hn_i_for_axis(axis, 2, uvec3(a.y, b.y, c.y), uvec3(a.z, b.z, c.z));
  hn_uvec3 row_odds = hn_i_for_axis(axis, 2, uvec3(before.y, cell.y, after.y), uvec3(before.z, cell.z, after.z));
  hn_num3 there = hn_i_beside(d, hn_i_select(axis == 0, steps, 0), hn_i_select(axis == 1, steps, 0),
                              hn_i_select(axis == 2, steps, 0));
  hn_uint s = hn_i_mix(seed);
  return hn_i_visit_slab(
      best, joins, uvec3(odds.x * 2u, odds.y * 2u, odds.z * 2u), row_joins,
      uvec3(row_odds.x * 2u, row_odds.y * 2u, row_odds.z * 2u), hn_i_along(axis, hn_i_fold(uvec3(at, at, at))) ^ s,
      hn_i_odd(at + s), there, ivec3(hn_i_select(axis == 0, 0, 1), hn_i_select(axis == 0, 1, 0), 0),
      ivec3(0, hn_i_select(axis == 2, 1, 0), hn_i_select(axis == 2, 0, 1)), jitter, metric, code, step, nearest, known);
}

// How many steps it is to the cells beside the block along an axis, on the side of the place.
HN_FN hn_int hn_i_two_along(hn_int axis, hn_num3 d) {
  return hn_i_select(axis == 0, hn_i_two(d.x), hn_i_select(axis == 1, hn_i_two(d.y), hn_i_two(d.z)));
}

// The smallest ranks, and the code of the nearest point's cell.
HN_FN hn_rank4 hn_i_nearest(hn_uvec3 before, hn_uvec3 cell, hn_uvec3 after, hn_num3 d, hn_num jitter, hn_int metric,
                            hn_uint seed) {
  return hn_i_visit_block(hn_i_far_away(), before, cell, after, d, jitter, metric, seed, d, hn_i_nothing());
}

// The offset of the place from the point of the cell with that code, turned.
HN_FN hn_num3 hn_i_from_nearest(hn_uvec3 before, hn_uvec3 cell, hn_uvec3 after, hn_num3 d, hn_num jitter, hn_uint seed,
                                hn_rank code) {
  hn_int x = hn_i_x_of(int(code));
  hn_int y = hn_i_y_of(int(code));
  hn_int z = hn_i_z_of(int(code));
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 c =
      uvec3(hn_i_of_three(uvec3(before.x, cell.x, after.x), x), hn_i_of_three(uvec3(before.y, cell.y, after.y), y),
            hn_i_of_three(uvec3(before.z, cell.z, after.z), z));
  return hn_i_from_point(hn_i_word(c, s, s), hn_i_beside(d, x, y, z), jitter);
}

// The cell with that code, from wrapped coordinates.
HN_FN hn_ivec3 hn_i_cell_of(hn_uvec3 c, hn_ivec3 period, hn_rank code) {
  hn_uvec3 before = hn_i_before(c, period);
  hn_uvec3 after = hn_i_after(c, period);
  return ivec3(int(hn_i_of_three(uvec3(before.x, c.x, after.x), hn_i_x_of(int(code)))),
               int(hn_i_of_three(uvec3(before.y, c.y, after.y), hn_i_y_of(int(code)))),
               int(hn_i_of_three(uvec3(before.z, c.z, after.z), hn_i_z_of(int(code)))));
}

#endif
