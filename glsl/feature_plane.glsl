// hashnoise: the feature points around a place on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_PLANE_GLSL
#define HN_FEATURE_PLANE_GLSL

#include "feature.glsl"

HN_FN hn_num2 hn_i_inner(hn_num2 f) { return hn_i_num(hn_i_inner(f.x), hn_i_inner(f.y)); }
HN_FN hn_num2 hn_i_beside(hn_num2 d, hn_int x, hn_int y) { return hn_i_num(hn_i_beside(d.x, x), hn_i_beside(d.y, y)); }
HN_FN hn_num2 hn_i_apart(hn_num2 a, hn_num2 b) { return hn_i_num(hn_i_apart(a.x, b.x), hn_i_apart(a.y, b.y)); }

HN_FN hn_rank hn_i_squared(hn_num2 d) { return hn_i_squared(d.x, d.y); }
HN_FN hn_rank hn_i_manhattan(hn_num2 d) { return hn_i_sum(hn_i_size(d.x), hn_i_size(d.y)); }
HN_FN hn_rank hn_i_rank(hn_num2 d, hn_int metric) {
  if (metric == HN_METRIC_MANHATTAN) return hn_i_manhattan(d);
  if (metric == HN_METRIC_CHEBYSHEV) return max(hn_i_size(d.x), hn_i_size(d.y));
  if (metric == HN_METRIC_HYBRID) return hn_i_hybrid(hn_i_squared(d), hn_i_manhattan(d));
  return hn_i_squared(d);
}

// The offset of a place from the point of a cell with that word; d is that from the centre of the cell.
HN_FN hn_num2 hn_i_from_point(hn_uint word, hn_num2 d, hn_num jitter) {
  hn_num3 direction = hn_i_direction2(word);
  return hn_i_num(hn_i_past_point(d.x, direction.x, jitter), hn_i_past_point(d.y, direction.y, jitter));
}
HN_FN hn_vec2 hn_i_cells(hn_num2 from) { return vec2(hn_i_cells(from.x), hn_i_cells(from.y)); }
HN_FN hn_vec2 hn_i_toward(hn_num2 from) { return vec2(hn_i_toward(from.x), hn_i_toward(from.y)); }
HN_FN hn_vec2 hn_i_unit(hn_num2 from) { return hn_i_unit(from.x, from.y); }

// a along that axis, and b along the other.
HN_FN hn_uvec2 hn_i_on(hn_int axis, hn_uvec2 a, hn_uvec2 b) {
  return uvec2(hn_i_select(axis == 0, a.x, b.x), hn_i_select(axis == 1, a.y, b.y));
}

// Along each axis b where the place is on that side of the centre, else a.
HN_FN hn_uvec2 hn_i_ahead(hn_num2 d, hn_uvec2 a, hn_uvec2 b) {
  return uvec2(hn_i_select(d.x > HN_I_NO_OFFSET, b.x, a.x), hn_i_select(d.y > HN_I_NO_OFFSET, b.y, a.y));
}

// The spread coordinates of the cell that is two steps on along both axes, on the side of the place.
HN_FN hn_uvec2 hn_i_two_steps(hn_uvec2 first, hn_num2 d) {
  return hn_i_ahead(d, hn_i_before(hn_i_before(first)), hn_i_last(hn_i_last(first)));
}
HN_FN hn_uvec2 hn_i_two_steps(hn_uvec2 c, hn_ivec2 period, hn_num2 d) {
  return hn_i_spread(
      hn_i_ahead(d, hn_i_before(hn_i_before(c, period), period), hn_i_after(hn_i_after(c, period), period)));
}

// The distance to the border between the cells of two points P and Q is (q - p) / (2 |P - Q|), where p and q are the
// squares of the distances to them. Borders are compared by this number, from the offsets of a place from Q and from P,
// and from p. It is large for the cell of P itself, which `code` and `own` tell.
HN_FN hn_rank hn_i_border(hn_num2 from, hn_num2 nearest, hn_rank p, hn_rank code, hn_rank own) {
  hn_rank large = hn_i_far_away().x;
  hn_rank apart = hn_i_select(code == own, large, hn_i_squared(hn_i_apart(from, nearest)));
  return hn_i_select(code == own, large, hn_i_border_rank(hn_i_gap(hn_i_squared(from), p), apart));
}

// What the point of one more cell makes of `best`: the smallest ranks by a metric, the nearest border, or
// the sum of weights. The cell has that word and code, and d is the offset of the place from its centre. For borders
// `nearest` is the offset from the nearest point, and `known` has its rank and code.
HN_FN hn_rank4 hn_i_visit(hn_rank4 best, hn_uint word, hn_num2 d, hn_num jitter, hn_int metric, hn_int code,
                          hn_num2 nearest, hn_rank4 known) {
  hn_num2 from = hn_i_from_point(word, d, jitter);
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
HN_FN hn_rank4 hn_i_visit_row(hn_rank4 best, hn_uvec3 words, hn_num2 before, hn_num2 middle, hn_num2 after,
                              hn_num jitter, hn_int metric, hn_int code, hn_int step, hn_num2 nearest, hn_rank4 known) {
  best = hn_i_visit(best, words.x, before, jitter, metric, code - step, nearest, known);
  best = hn_i_visit(best, words.y, middle, jitter, metric, code, nearest, known);
  return hn_i_visit(best, words.z, after, jitter, metric, code + step, nearest, known);
}

// A cell and its neighbours, from their spread coordinates. d is the offset from the centre of the cell. `best` is what
// other cells made.
HN_FN hn_rank4 hn_i_visit_block(hn_rank4 best, hn_uvec2 before, hn_uvec2 cell, hn_uvec2 after, hn_num2 d, hn_num jitter,
                                hn_int metric, hn_uint seed, hn_num2 nearest, hn_rank4 known) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec2 a = hn_i_fold(before);
  hn_uvec2 b = hn_i_fold(cell);
  hn_uvec2 c = hn_i_fold(after);
  hn_uvec3 joins = uvec3(a.x, b.x, c.x);
  hn_uvec3 odds = uvec3(before.x * 2u, cell.x * 2u, after.x * 2u);
  best =
      hn_i_visit_row(best, hn_i_row_words(joins, odds, a.y ^ s, hn_i_odd(before.y + s)), hn_i_beside(d, -1, -1),
                     hn_i_beside(d, 0, -1), hn_i_beside(d, 1, -1), jitter, metric, hn_i_code(0, -1), 1, nearest, known);
  best = hn_i_visit_row(best, hn_i_row_words(joins, odds, b.y ^ s, hn_i_odd(cell.y + s)), hn_i_beside(d, -1, 0), d,
                        hn_i_beside(d, 1, 0), jitter, metric, hn_i_code(0, 0), 1, nearest, known);
  return hn_i_visit_row(best, hn_i_row_words(joins, odds, c.y ^ s, hn_i_odd(after.y + s)), hn_i_beside(d, -1, 1),
                        hn_i_beside(d, 0, 1), hn_i_beside(d, 1, 1), jitter, metric, hn_i_code(0, 1), 1, nearest, known);
}

// The three cells beside the block that are two steps on along an axis, on the side of the place: along x for 0, and
// along y for 1.
HN_FN hn_rank4 hn_i_visit_beyond(hn_rank4 best, hn_uvec2 before, hn_uvec2 cell, hn_uvec2 after, hn_uvec2 two,
                                 hn_int axis, hn_num2 d, hn_num jitter, hn_int metric, hn_uint seed, hn_num2 nearest,
                                 hn_rank4 known) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 words = uvec3(hn_i_word(hn_i_on(axis, two, before), s, s), hn_i_word(hn_i_on(axis, two, cell), s, s),
                         hn_i_word(hn_i_on(axis, two, after), s, s));
  hn_int x = hn_i_select(axis == 0, hn_i_two(d.x), 0);
  hn_int y = hn_i_select(axis == 0, 0, hn_i_two(d.y));
  hn_int step_x = hn_i_select(axis == 0, 0, 1);
  hn_int step_y = hn_i_select(axis == 0, 1, 0);
  return hn_i_visit_row(best, words, hn_i_beside(d, x - step_x, y - step_y), hn_i_beside(d, x, y),
                        hn_i_beside(d, x + step_x, y + step_y), jitter, metric, HN_I_NO_CODE, 0, nearest, known);
}

// The smallest ranks, and the code of the nearest point's cell.
HN_FN hn_rank4 hn_i_nearest(hn_uvec2 before, hn_uvec2 cell, hn_uvec2 after, hn_num2 d, hn_num jitter, hn_int metric,
                            hn_uint seed) {
  return hn_i_visit_block(hn_i_far_away(), before, cell, after, d, jitter, metric, seed, d, hn_i_nothing());
}

// The offset of the place from the point of the cell with that code.
HN_FN hn_num2 hn_i_from_nearest(hn_uvec2 before, hn_uvec2 cell, hn_uvec2 after, hn_num2 d, hn_num jitter, hn_uint seed,
                                hn_rank code) {
  hn_int x = hn_i_x_of(int(code));
  hn_int y = hn_i_y_of(int(code));
  hn_uint s = hn_i_mix(seed);
  hn_uvec2 c =
      uvec2(hn_i_of_three(uvec3(before.x, cell.x, after.x), x), hn_i_of_three(uvec3(before.y, cell.y, after.y), y));
  return hn_i_from_point(hn_i_word(c, s, s), hn_i_beside(d, x, y), jitter);
}

// The cell with that code, from wrapped coordinates.
HN_FN hn_ivec2 hn_i_cell_of(hn_uvec2 c, hn_ivec2 period, hn_rank code) {
  hn_uvec2 before = hn_i_before(c, period);
  hn_uvec2 after = hn_i_after(c, period);
  return ivec2(int(hn_i_of_three(uvec3(before.x, c.x, after.x), hn_i_x_of(int(code)))),
               int(hn_i_of_three(uvec3(before.y, c.y, after.y), hn_i_y_of(int(code)))));
}

#endif
