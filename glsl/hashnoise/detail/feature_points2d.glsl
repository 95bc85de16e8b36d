// hashnoise: the feature points around a place on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS2D_GLSL
#define HN_FEATURE_POINTS2D_GLSL

#include "block2d.glsl"
#include "feature_points.glsl"

// From here feature_points3d.glsl is generated from feature_points2d.glsl.

HN_FN hn_i_num2 hn_i_from_centre(hn_i_num2 f) { return hn_i_vector(hn_i_from_centre(f.x), hn_i_from_centre(f.y)); }

// Chooses b along each axis where the place is above the centre of its cell, else a.
HN_FN hn_uvec2 hn_i_toward_place(hn_i_num2 d, hn_uvec2 a, hn_uvec2 b) {
  return uvec2(hn_i_select(d.x > HN_I_NO_OFFSET, b.x, a.x), hn_i_select(d.y > HN_I_NO_OFFSET, b.y, a.y));
}

// The spread coordinates of the cell that is two steps away along all axes, on the side of the place.
HN_FN hn_uvec2 hn_i_far_cell(hn_place2 place, hn_i_neighbourhood2 cells, hn_i_num2 d) {
  hn_uvec2 two;
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    two = hn_i_spread(hn_i_toward_place(d, hn_i_previous(hn_i_previous(c, place.period), place.period),
                                        hn_i_following(hn_i_following(c, place.period), place.period)));
  } else {
    two = hn_i_toward_place(d, hn_i_previous(cells.previous), hn_i_upper(cells.following));
  }
  return two;
}

// The cell of the neighbourhood with a code, modulo the period.
HN_FN hn_ivec2 hn_i_cell_of(hn_place2 place, hn_i_rank code) {
  hn_uvec2 c = hn_i_wrap(place.cell, place.period);
  hn_uvec2 before = hn_i_previous(c, place.period);
  hn_uvec2 after = hn_i_following(c, place.period);
  return ivec2(int(hn_i_triple_at(uvec3(before.x, c.x, after.x), hn_i_x_of(int(code)))),
               int(hn_i_triple_at(uvec3(before.y, c.y, after.y), hn_i_y_of(int(code)))));
}

// To here feature_points3d.glsl is generated from feature_points2d.glsl.

// The directions of three hashes along each axis. In HN_FIXED they are in units of 2^-9.
#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec3 hn_i_points_x(hn_uvec3 hashes) { return hn_i_fields2(hashes); }
HN_FN hn_vec3 hn_i_points_y(hn_uvec3 hashes) {
  HN_I_PRECISE hn_vec3 m = vec3(1.0f, 1.0f, 1.0f) - abs(hn_i_fields2(hashes));
  return hn_i_signed(m, hashes);
}

#else

// They are computed as floats, since on GPUs the absolute value of a float costs nothing, and of an integer it does.
// No step rounds: the floats are whole numbers of few bits.
HN_FN hn_vec3 hn_i_whole_points(hn_uvec3 hashes) {
#if HN_I_BITCAST
  return uintBitsToFloat(hn_i_or(hn_i_and(hashes, 0x007FC000u), 0x44800000u)) - 1535.0f;
#else
  return hn_i_fields2(hashes) * 512.0f;
#endif
}
HN_FN hn_ivec3 hn_i_points_x(hn_uvec3 hashes) { return ivec3(hn_i_whole_points(hashes)); }
HN_FN hn_ivec3 hn_i_points_y(hn_uvec3 hashes) {
  return ivec3(hn_i_signed(vec3(512.0f, 512.0f, 512.0f) - abs(hn_i_whole_points(hashes)), hashes));
}

#endif

// Subtracts the points of three cells, along each axis: x and y hold the offsets of the place from the centres of the
// cells, and the results its offsets from their points.
HN_FN hn_i_num3 hn_i_from_x(hn_uvec3 hashes, hn_i_num3 x, hn_i_num jitter) {
  return hn_i_offsets_from_points(x, hn_i_points_x(hashes), jitter);
}
HN_FN hn_i_num3 hn_i_from_y(hn_uvec3 hashes, hn_i_num3 y, hn_i_num jitter) {
  return hn_i_offsets_from_points(y, hn_i_points_y(hashes), jitter);
}
HN_FN hn_i_rank3 hn_i_squares(hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num jitter) {
  return hn_i_squares(hn_i_from_x(hashes, x, jitter), hn_i_from_y(hashes, y, jitter));
}

// The ranks of the distances to these points.
HN_FN hn_i_rank3 hn_i_ranks(hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num jitter, hn_int metric) {
  if (metric == HN_METRIC_MANHATTAN || metric == HN_METRIC_CHEBYSHEV || metric == HN_METRIC_HYBRID) {
    hn_i_rank3 a = hn_i_magnitudes(hn_i_from_x(hashes, x, jitter));
    hn_i_rank3 b = hn_i_magnitudes(hn_i_from_y(hashes, y, jitter));
    if (metric == HN_METRIC_CHEBYSHEV) return max(a, b);
    if (metric == HN_METRIC_MANHATTAN) return hn_i_sum(a, b);
    return hn_i_hybrids(hn_i_squares(hashes, x, y, jitter), hn_i_sum(a, b));
  }
  return hn_i_squares(hashes, x, y, jitter);
}

// The hashes of a row of the cells around a place, from their spread coordinates: along x at y, and along y at x. s is
// the mixed seed.
HN_FN hn_uvec3 hn_i_hashes_along_x(hn_i_neighbourhood2 cells, hn_uint y, hn_uint s) {
  hn_uvec3 x = hn_i_coordinates_x(cells);
  return hn_i_row_hashes(x >> HN_I_HIGH_X, hn_i_odds_x(x), hn_i_high(uvec2(0u, y)).y ^ hn_i_seed_join(s),
                         hn_i_odd_y(y - cells.cell.y, hn_i_odd(cells.cell, s)));
}
HN_FN hn_uvec3 hn_i_hashes_along_y(hn_i_neighbourhood2 cells, hn_uint x, hn_uint s) {
  hn_uvec3 y = hn_i_coordinates_y(cells);
  return hn_i_row_hashes(y >> HN_I_HIGH_Y, hn_i_odds_y(y), hn_i_high(x) ^ hn_i_seed_join(s),
                         hn_i_odd_x(x - cells.cell.x, hn_i_odd(cells.cell, s)));
}

// The three smallest ranks of the points of a cell and its neighbours, and the code of the nearest one's cell. d is the
// offset of the place from the centre of the cell.
HN_FN hn_i_rank4 hn_i_nearest(hn_i_neighbourhood2 cells, hn_i_num2 d, hn_i_num jitter, hn_int metric, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_i_num3 x = hn_i_row(d.x);
  hn_i_num3 y = hn_i_row(d.y);
  hn_uvec3 hashes = hn_i_hashes_along_x(cells, cells.previous.y, s);
  hn_i_rank4 best =
      hn_i_insert(hn_i_far_away(), hn_i_ranks(hashes, x, hn_i_equal_triple(y.x), jitter, metric), hn_i_code(0, -1), 1);
  hashes = hn_i_hashes_along_x(cells, cells.cell.y, s);
  best = hn_i_insert(best, hn_i_ranks(hashes, x, hn_i_equal_triple(y.y), jitter, metric), hn_i_code(0, 0), 1);
  hashes = hn_i_hashes_along_x(cells, cells.following.y, s);
  return hn_i_insert(best, hn_i_ranks(hashes, x, hn_i_equal_triple(y.z), jitter, metric), hn_i_code(0, 1), 1);
}

// The offset of the place from the point of the cell with that code.
HN_FN hn_i_num2 hn_i_from_nearest(hn_i_neighbourhood2 cells, hn_i_num2 d, hn_i_num jitter, hn_uint seed,
                                  hn_i_rank code) {
  hn_int x = hn_i_x_of(int(code));
  hn_int y = hn_i_y_of(int(code));
  hn_uint s = hn_i_scramble(seed);
  hn_uint h = hn_i_seeded_hash(
      uvec2(hn_i_triple_at(hn_i_coordinates_x(cells), x), hn_i_triple_at(hn_i_coordinates_y(cells), y)), s);
  hn_uvec3 hashes = hn_i_equal_triple(h);
  return hn_i_vector(hn_i_from_x(hashes, hn_i_equal_triple(hn_i_offset_from_cell(d.x, x)), jitter).x,
                     hn_i_from_y(hashes, hn_i_equal_triple(hn_i_offset_from_cell(d.y, y)), jitter).x);
}

// The vector from a place to a point, as floats, from the offset of the place from it.
HN_FN hn_vec2 hn_i_toward(hn_i_num2 from) { return vec2(hn_i_toward(from.x), hn_i_toward(from.y)); }

#endif
