// hashnoise: the feature points around a place in space.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS3D_GLSL
#define HN_FEATURE_POINTS3D_GLSL

#include "block.glsl"
#include "feature_points.glsl"

// From here feature_points3d.glsl is generated from feature_points2d.glsl.

HN_FN hn_i_num3 hn_i_from_centre(hn_i_num3 f) {
  return hn_i_vector(hn_i_from_centre(f.x), hn_i_from_centre(f.y), hn_i_from_centre(f.z));
}

// Chooses b along each axis where the place is above the centre of its cell, else a.
HN_FN hn_uvec3 hn_i_toward_place(hn_i_num3 d, hn_uvec3 a, hn_uvec3 b) {
  return uvec3(hn_i_select(d.x > HN_I_NO_OFFSET, b.x, a.x), hn_i_select(d.y > HN_I_NO_OFFSET, b.y, a.y),
               hn_i_select(d.z > HN_I_NO_OFFSET, b.z, a.z));
}

// The spread coordinates of the cell that is two steps away along all axes, on the side of the place.
HN_FN hn_uvec3 hn_i_far_cell(hn_place3 place, hn_i_neighbourhood3 cells, hn_i_num3 d) {
  hn_uvec3 two;
  if (place.tiled) {
    hn_uvec3 c = hn_i_wrap(place.cell, place.period);
    two = hn_i_spread(hn_i_toward_place(d, hn_i_previous(hn_i_previous(c, place.period), place.period),
                                        hn_i_following(hn_i_following(c, place.period), place.period)));
  } else {
    two = hn_i_toward_place(d, hn_i_previous(cells.previous), hn_i_upper(cells.following));
  }
  return two;
}

// The cell of the neighbourhood with a code, modulo the period.
HN_FN hn_ivec3 hn_i_cell_of(hn_place3 place, hn_i_rank code) {
  hn_uvec3 c = hn_i_wrap(place.cell, place.period);
  hn_uvec3 before = hn_i_previous(c, place.period);
  hn_uvec3 after = hn_i_following(c, place.period);
  return ivec3(int(hn_i_triple_at(uvec3(before.x, c.x, after.x), hn_i_x_of(int(code)))),
               int(hn_i_triple_at(uvec3(before.y, c.y, after.y), hn_i_y_of(int(code)))),
               int(hn_i_triple_at(uvec3(before.z, c.z, after.z), hn_i_z_of(int(code)))));
}

// To here feature_points3d.glsl is generated from feature_points2d.glsl.

// The directions of three hashes. Seen along z the octahedron is a square with corners on the axes, and the fields run
// along its sides: u = x + y and v = x - y. The height above a point of the square is 1 minus the larger of |u| and
// |v|. Where they are floats, the components of directions are u, v and z. The offsets from points have such
// components, too. In HN_FIXED u and v stand for x and y, in units of 2^-9.
//
//   hn_i_octahedral_u(x, y), hn_i_octahedral_v(x, y)  such components of offsets
//   hn_i_squares, hn_i_manhattans, hn_i_chebyshevs  squares, sums of sizes and largest sizes of such offsets
//   hn_i_from_octahedral(d)  the offset along x, y and z, from one with such components
#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec3 hn_i_points_u(hn_uvec3 hashes) { return hn_i_fields3(hashes >> 8u); }
HN_FN hn_vec3 hn_i_points_v(hn_uvec3 hashes) { return hn_i_fields3(hashes); }
HN_FN hn_vec3 hn_i_points_z(hn_uvec3 hashes) {
  HN_I_PRECISE hn_vec3 m = vec3(1.0f, 1.0f, 1.0f) - max(abs(hn_i_fields3(hashes >> 8u)), abs(hn_i_fields3(hashes)));
  return hn_i_signed(m, hashes);
}
HN_FN hn_vec3 hn_i_octahedral_u(hn_vec3 x, hn_vec3 y) { return hn_i_sum(x, y); }
HN_FN hn_vec3 hn_i_octahedral_v(hn_vec3 x, hn_vec3 y) {
  HN_I_PRECISE hn_vec3 v = x - y;
  return v;
}
HN_FN hn_vec3 hn_i_squares(hn_vec3 u, hn_vec3 v, hn_vec3 z) {
  HN_I_PRECISE hn_vec3 q = (u * u + v * v) * 0.5f + z * z;
  return q;
}
HN_FN hn_vec3 hn_i_manhattans(hn_vec3 u, hn_vec3 v, hn_vec3 z) { return hn_i_sum(max(abs(u), abs(v)), abs(z)); }
HN_FN hn_vec3 hn_i_chebyshevs(hn_vec3 u, hn_vec3 v, hn_vec3 z) {
  HN_I_PRECISE hn_vec3 m = (abs(u) + abs(v)) * 0.5f;
  return max(m, abs(z));
}
HN_FN hn_vec3 hn_i_from_octahedral(hn_vec3 d) {
  return vec3(hn_i_times(hn_i_plus(d.x, d.y), 0.5f), hn_i_times(hn_i_minus(d.x, d.y), 0.5f), d.z);
}

#else

// A direction in space comes in units of 2^-8.
HN_FN hn_ivec3 hn_i_points_p(hn_uvec3 hashes) { return ivec3(hn_i_and(hashes >> 22u, 510u)) - 255; }
HN_FN hn_ivec3 hn_i_points_q(hn_uvec3 hashes) { return ivec3(hn_i_and(hashes >> 14u, 510u)) - 255; }
HN_FN hn_ivec3 hn_i_points_u(hn_uvec3 hashes) { return hn_i_points_p(hashes) + hn_i_points_q(hashes); }
HN_FN hn_ivec3 hn_i_points_v(hn_uvec3 hashes) { return hn_i_points_p(hashes) - hn_i_points_q(hashes); }
HN_FN hn_ivec3 hn_i_points_z(hn_uvec3 hashes) {
  hn_uvec3 larger = max(hn_i_magnitudes(hn_i_points_p(hashes)), hn_i_magnitudes(hn_i_points_q(hashes)));
  return hn_i_signed((ivec3(256, 256, 256) - ivec3(larger)) * 2, hashes);
}

// These return x and y. Compilers drop the rest, which is there since a parameter that is not used is a warning, and
// one without a name an error in Mesa.
HN_FN hn_ivec3 hn_i_octahedral_u(hn_ivec3 x, hn_ivec3 y) { return x + y * 0; }
HN_FN hn_ivec3 hn_i_octahedral_v(hn_ivec3 x, hn_ivec3 y) { return x * 0 + y; }
HN_FN hn_uvec3 hn_i_manhattans(hn_ivec3 x, hn_ivec3 y, hn_ivec3 z) {
  return hn_i_magnitudes(x) + hn_i_magnitudes(y) + hn_i_magnitudes(z);
}
HN_FN hn_uvec3 hn_i_chebyshevs(hn_ivec3 x, hn_ivec3 y, hn_ivec3 z) {
  return max(max(hn_i_magnitudes(x), hn_i_magnitudes(y)), hn_i_magnitudes(z));
}
HN_FN hn_ivec3 hn_i_from_octahedral(hn_ivec3 d) { return d; }

#endif

// Subtracts the points of three cells, in u, v and z: x, y and z hold the offsets of the place from the centres of the
// cells, and the results its offsets from their points.
HN_FN hn_i_num3 hn_i_from_u(hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num jitter) {
  return hn_i_offsets_from_points(hn_i_octahedral_u(x, y), hn_i_points_u(hashes), jitter);
}
HN_FN hn_i_num3 hn_i_from_v(hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num jitter) {
  return hn_i_offsets_from_points(hn_i_octahedral_v(x, y), hn_i_points_v(hashes), jitter);
}
HN_FN hn_i_num3 hn_i_from_z(hn_uvec3 hashes, hn_i_num3 z, hn_i_num jitter) {
  return hn_i_offsets_from_points(z, hn_i_points_z(hashes), jitter);
}

// The ranks of the distances to these points.
HN_FN hn_i_rank3 hn_i_ranks(hn_uvec3 hashes, hn_i_num3 x, hn_i_num3 y, hn_i_num3 z, hn_i_num jitter, hn_int metric) {
  hn_i_num3 u = hn_i_from_u(hashes, x, y, jitter);
  hn_i_num3 v = hn_i_from_v(hashes, x, y, jitter);
  hn_i_num3 w = hn_i_from_z(hashes, z, jitter);
  if (metric == HN_METRIC_MANHATTAN) return hn_i_manhattans(u, v, w);
  if (metric == HN_METRIC_CHEBYSHEV) return hn_i_chebyshevs(u, v, w);
  if (metric == HN_METRIC_HYBRID) return hn_i_hybrids(hn_i_squares(u, v, w), hn_i_manhattans(u, v, w));
  return hn_i_squares(u, v, w);
}

// The share of the cells around a place in the first join of a hash, along one axis.
HN_FN hn_uvec3 hn_i_joins_x(hn_i_neighbourhood3 cells) {
  hn_uvec3 x = hn_i_coordinates_x(cells);
  return x >> HN_I_HIGH_X;
}
HN_FN hn_uvec3 hn_i_joins_y(hn_i_neighbourhood3 cells) {
  hn_uvec3 y = hn_i_coordinates_y(cells);
  return y >> HN_I_HIGH_Y;
}
HN_FN hn_uvec3 hn_i_joins_z(hn_i_neighbourhood3 cells) {
  hn_uvec3 z = hn_i_coordinates_z(cells);
  return z >> HN_I_HIGH_Z;
}

// Inserts the ranks of nine cells in a slab across z into the three smallest so far. x and y are the offsets of the
// place from their centres along these axes, and z is that along z. To the joins of a hash z and the seed add join
// and odd. The cell in the middle has the code.
HN_FN hn_i_rank4 hn_i_visit_slab(hn_i_rank4 best, hn_i_neighbourhood3 cells, hn_uint join, hn_uint odd, hn_i_num3 x,
                                 hn_i_num3 y, hn_i_num z, hn_i_num jitter, hn_int metric, hn_int code) {
  hn_uvec3 joins = hn_i_joins_x(cells);
  hn_uvec3 odds = hn_i_odds_x(hn_i_coordinates_x(cells));
  hn_uvec3 rows = hn_i_xor(hn_i_joins_y(cells), join);
  hn_uvec3 row_odds = hn_i_odds_y(hn_i_coordinates_y(cells)) + odd;
  hn_i_num3 across = hn_i_equal_triple(z);
  best = hn_i_insert(
      best,
      hn_i_ranks(hn_i_row_hashes(joins, odds, rows.x, row_odds.x), x, hn_i_equal_triple(y.x), across, jitter, metric),
      code - 4, 1);
  best = hn_i_insert(
      best,
      hn_i_ranks(hn_i_row_hashes(joins, odds, rows.y, row_odds.y), x, hn_i_equal_triple(y.y), across, jitter, metric),
      code, 1);
  return hn_i_insert(
      best,
      hn_i_ranks(hn_i_row_hashes(joins, odds, rows.z, row_odds.z), x, hn_i_equal_triple(y.z), across, jitter, metric),
      code + 4, 1);
}

// The three smallest ranks of the points of a cell and its neighbours, and the code of the nearest one's cell. d is the
// offset of the place from the centre of the cell. With a loop over z a shader compiles in about 0.6 of the time. But
// llvmpipe does not unroll it, and then takes 1.6 times as long.
HN_FN hn_i_rank4 hn_i_nearest(hn_i_neighbourhood3 cells, hn_i_num3 d, hn_i_num jitter, hn_int metric, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_i_num3 x = hn_i_row(d.x);
  hn_i_num3 y = hn_i_row(d.y);
  hn_i_num3 z = hn_i_row(d.z);
  hn_uvec3 joins = hn_i_xor(hn_i_joins_z(cells), hn_i_seed_join(s));
  hn_uvec3 odds = hn_i_odds_z(hn_i_coordinates_z(cells)) + hn_i_odd(cells.cell, s);
  hn_i_rank4 best =
      hn_i_visit_slab(hn_i_far_away(), cells, joins.x, odds.x, x, y, z.x, jitter, metric, hn_i_code(0, 0, -1));
  best = hn_i_visit_slab(best, cells, joins.y, odds.y, x, y, z.y, jitter, metric, hn_i_code(0, 0, 0));
  return hn_i_visit_slab(best, cells, joins.z, odds.z, x, y, z.z, jitter, metric, hn_i_code(0, 0, 1));
}

// ---------------------------------------------------------------------------------------------------------------------
// A slab of nine cells may lie across any axis: 0 is x, 1 is y and 2 is z. Its rows run along x, but a slab across x
// has rows along y. They follow each other along y, but in a slab across x or y along z. The spread coordinate
// along the axis is at.

HN_FN hn_uvec3 hn_i_if_axis(hn_int axis, hn_int which, hn_uvec3 a, hn_uvec3 b) {
  return uvec3(hn_i_select(axis == which, a.x, b.x), hn_i_select(axis == which, a.y, b.y),
               hn_i_select(axis == which, a.z, b.z));
}
HN_FN hn_i_num3 hn_i_if_axis(hn_int axis, hn_int which, hn_i_num3 a, hn_i_num3 b) {
  return hn_i_vector(hn_i_select(axis == which, a.x, b.x), hn_i_select(axis == which, a.y, b.y),
                     hn_i_select(axis == which, a.z, b.z));
}
HN_FN hn_uint hn_i_component_along(hn_int axis, hn_uvec3 v) {
  return hn_i_select(axis == 0, v.x, hn_i_select(axis == 1, v.y, v.z));
}

// The number of steps to the slab beside the neighbourhood, on the side of the place.
HN_FN hn_int hn_i_far_step_along(hn_int axis, hn_i_num3 d) {
  return hn_i_select(axis == 0, hn_i_far_step(d.x), hn_i_select(axis == 1, hn_i_far_step(d.y), hn_i_far_step(d.z)));
}

// The hashes of its row n, which is -1, 0 or 1.
HN_FN hn_uvec3 hn_i_slab_hashes(hn_i_neighbourhood3 cells, hn_int axis, hn_uint at, hn_int n, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uvec3 x = hn_i_joins_x(cells);
  hn_uvec3 y = hn_i_joins_y(cells);
  hn_uvec3 z = hn_i_joins_z(cells);
  hn_uvec3 odds_y = hn_i_odds_y(hn_i_coordinates_y(cells));
  hn_uvec3 odds = hn_i_if_axis(axis, 0, odds_y, hn_i_odds_x(hn_i_coordinates_x(cells)));
  hn_uint next = hn_i_triple_at(hn_i_if_axis(axis, 2, odds_y, hn_i_odds_z(hn_i_coordinates_z(cells))), n);
  hn_uint step = (at - hn_i_component_along(axis, cells.cell)) & 0x00FFFFFFu;
  next += step * hn_i_component_along(axis, uvec3(HN_I_ODD_X, HN_I_ODD_Y, HN_I_ODD_Z));
  return hn_i_row_hashes(hn_i_if_axis(axis, 0, y, x), odds,
                         hn_i_triple_at(hn_i_if_axis(axis, 2, y, z), n) ^
                             hn_i_component_along(axis, hn_i_high(uvec3(at, at, at))) ^ hn_i_seed_join(s),
                         next + hn_i_odd(cells.cell, s));
}

// The offsets of the place from the centres of the cells of that row, along each axis; the slab is some steps on.
HN_FN hn_i_num3 hn_i_slab_x(hn_i_num3 d, hn_int axis, hn_int steps) {
  return hn_i_if_axis(axis, 0, hn_i_equal_triple(hn_i_offset_from_cell(d.x, steps)), hn_i_row(d.x));
}
HN_FN hn_i_num3 hn_i_slab_y(hn_i_num3 d, hn_int axis, hn_int steps, hn_int n) {
  return hn_i_if_axis(axis, 0, hn_i_row(d.y),
                      hn_i_equal_triple(hn_i_offset_from_cell(d.y, hn_i_select(axis == 1, steps, n))));
}
HN_FN hn_i_num3 hn_i_slab_z(hn_i_num3 d, hn_int axis, hn_int steps, hn_int n) {
  return hn_i_equal_triple(hn_i_offset_from_cell(d.z, hn_i_select(axis == 2, steps, n)));
}

// ---------------------------------------------------------------------------------------------------------------------

// The offset of the place from the point of the cell with that code, in u, v and z.
HN_FN hn_i_num3 hn_i_from_nearest(hn_i_neighbourhood3 cells, hn_i_num3 d, hn_i_num jitter, hn_uint seed,
                                  hn_i_rank code) {
  hn_int x = hn_i_x_of(int(code));
  hn_int y = hn_i_y_of(int(code));
  hn_int z = hn_i_z_of(int(code));
  hn_uint s = hn_i_scramble(seed);
  hn_uint h =
      hn_i_seeded_hash(uvec3(hn_i_triple_at(hn_i_coordinates_x(cells), x), hn_i_triple_at(hn_i_coordinates_y(cells), y),
                             hn_i_triple_at(hn_i_coordinates_z(cells), z)),
                       s);
  hn_uvec3 hashes = hn_i_equal_triple(h);
  hn_i_num3 beside_x = hn_i_equal_triple(hn_i_offset_from_cell(d.x, x));
  hn_i_num3 beside_y = hn_i_equal_triple(hn_i_offset_from_cell(d.y, y));
  return hn_i_vector(hn_i_from_u(hashes, beside_x, beside_y, jitter).x,
                     hn_i_from_v(hashes, beside_x, beside_y, jitter).x,
                     hn_i_from_z(hashes, hn_i_equal_triple(hn_i_offset_from_cell(d.z, z)), jitter).x);
}

// The vector from a place to a point, as floats, from the offset of the place from it.
HN_FN hn_vec3 hn_i_toward(hn_i_num3 from) {
  hn_i_num3 d = hn_i_from_octahedral(from);
  return vec3(hn_i_toward(d.x), hn_i_toward(d.y), hn_i_toward(d.z));
}

#endif
