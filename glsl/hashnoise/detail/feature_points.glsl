// hashnoise: the feature points of cellular noise: where they are in their cells, and how their distances compare.
// SPDX-License-Identifier: MIT

#ifndef HN_FEATURE_POINTS_GLSL
#define HN_FEATURE_POINTS_GLSL

#include "square_root.glsl"
#include "word.glsl"

// The metric of hn_cellular and hn_cellular_three is how they measure distances. It should be a constant: then the
// compiler keeps that metric alone. Any other number counts as HN_METRIC_EUCLIDEAN.
#define HN_METRIC_EUCLIDEAN 1
#define HN_METRIC_SQUARED 2    // the square of the Euclidean distance
#define HN_METRIC_MANHATTAN 3  // the sum of the sizes along the axes
#define HN_METRIC_CHEBYSHEV 4  // the largest of them
#define HN_METRIC_HYBRID 5     // Manhattan and squared, added

// Each cell has one feature point. Its offset from the centre of the cell is half the direction that the hash of the
// cell gives, times the jitter. So with a jitter of 1 it lies on a square or octahedron whose corners are in the middle
// of the cell's sides. So a cell and its neighbours always have the two nearest points:
//
//   Let a place be off the centre of its cell by a >= b >= c, each from 0 to 1/2. No point is off its centre by more
//   than 1/2 in sum along the axes, so it is farthest or nearest at a corner of its octahedron. The point of the cell
//   itself is not farther than (a + 1/2, b, c), and that of the next cell along the first axis not farther than
//   (3/2 - a, b, c). Outside of the neighbours no point is nearer than (3/2 - a, b, c). All this holds in every
//   metric here.
//
// The third is not farther than (a, 3/2 - b, c). To have it, the cells two steps away on the side of the place, along
// the axis with a, are enough. A point that is two steps away along another axis is not nearer than that.
//
// On the square a coordinate has the variance of one that is anywhere in a cell, 1/12. On the octahedron it has half of
// that, so in space the lattice shows a little (docs/guide/cellular.md).
//
// Cells are visited by threes, in rows along an axis, and their numbers are vectors: so the text stays short, and
// compilers take less time. Offsets are numbers like those of arithmetic.glsl. Where they are floats, they are in units
// of half a cell: then a direction needs no factor. In HN_FIXED they are in units of 2^-20 of a cell.
//
//   hn_i_jitter(j)                     the jitter, from 0 to 1; in HN_FIXED in units of 2^-20
//   HN_I_NO_OFFSET                     0 as an offset
//   hn_i_from_centre(f)                the offset of a fraction from the centre of its cell
//   hn_i_offset_from_cell(d, n)        that offset from the centre of the n-th cell after it
//   hn_i_triple(a, b, c)               a vector of three numbers
//   hn_i_offsets_from_points(d, a, j)  the offsets of a place from three points, along an axis: d are those from the
//                                      centres of their cells, and a the directions
//   hn_i_toward(d)                     the opposite of an offset as a float, in cells; it is not -0
//   hn_i_sum(a, b), hn_i_rank_differences(a, b)  a + b of ranks, and a - b of three ranks
//   hn_i_hybrids(q, m)                 ranks of the hybrid metric, from squares and sums of sizes
//   hn_i_distance(r, metric)           the distance of a rank
//   hn_i_far_away(), hn_i_no_weight()  the largest ranks, and a weight of 0: they stand for no point yet
//   hn_i_offset_difference(a, b)       a - b of offsets; in HN_FIXED in units of 2^-19, rounded down
//   hn_i_border_ranks(n, q)            numbers by which borders are compared. They grow with n / sqrt(q): n are
//                                      differences of two squares, and q squares
//   hn_i_border_distance(r)            the distance to a border, from that
//   hn_i_smooth_weight(q)              the weight of a point for hn_cellular_smooth, from a square: (1 - distance)^4 up
//                                      to 1
//   hn_i_smooth_distance(w)            the smooth distance, from the sum of the weights: 1 - (w + 1/4096)^(1/4)

// A direction is a point of the square or octahedron |x| + |y| (+ |z|) = 1. It is made of fields: bits of a hash as odd
// multiples of 2^-9 for the plane, and of 2^-8 for space, in (-1, 1). They are symmetric about 0 and never 0. The
// highest bit is a sign. For the plane the field is where the fraction of a float begins, from bit 22 down: that saves
// a shift. For space the two fields are from bit 30 down. No bit is used twice.
#if HN_I_BITCAST
HN_FN hn_vec3 hn_i_fields(hn_uvec3 bits, hn_float offset) {
  HN_I_PRECISE hn_vec3 x = uintBitsToFloat(hn_i_or(bits, 0x40000000u)) - offset;
  return x;
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return hn_i_fields(hn_i_and(h, 0x007FC000u), 3.0f - 1.0f / 512.0f); }
HN_FN hn_vec3 hn_i_fields3(hn_uvec3 h) { return hn_i_fields(hn_i_and(h, 0x007F8000u), 3.0f - 1.0f / 256.0f); }
#else
HN_FN hn_vec3 hn_i_fields(hn_uvec3 bits, hn_float unit) {
  return vec3(hn_i_float(bits.x), hn_i_float(bits.y), hn_i_float(bits.z)) * (unit + unit) - (1.0f - unit);
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return hn_i_fields(hn_i_and(h >> 14u, 511u), 1.0f / 512.0f); }
HN_FN hn_vec3 hn_i_fields3(hn_uvec3 h) { return hn_i_fields(hn_i_and(h >> 15u, 255u), 1.0f / 256.0f); }
#endif

// hn_i_signed of three numbers at once.
HN_FN hn_vec3 hn_i_signed(hn_vec3 m, hn_uvec3 hashes) {
#if HN_I_BITCAST
  return uintBitsToFloat(floatBitsToUint(m) | hn_i_and(hashes, 0x80000000u));
#else
  return vec3(hn_i_signed(m.x, hashes.x), hn_i_signed(m.y, hashes.y), hn_i_signed(m.z, hashes.z));
#endif
}
HN_FN hn_ivec3 hn_i_signed(hn_ivec3 m, hn_uvec3 hashes) {
  hn_ivec3 sign = ivec3(hashes) >> 31;  // -1 or 0
  return (m ^ sign) - sign;
}

// A code is the number of a cell beside the middle one, from -1 to 1 along x, y and z.
HN_FN hn_int hn_i_code(hn_int x, hn_int y) { return x + 4 * y + 5; }
HN_FN hn_int hn_i_code(hn_int x, hn_int y, hn_int z) { return x + 4 * y + 16 * z + 21; }
HN_FN hn_int hn_i_x_of(hn_int code) { return (code & 3) - 1; }
HN_FN hn_int hn_i_y_of(hn_int code) { return ((code >> 2) & 3) - 1; }
HN_FN hn_int hn_i_z_of(hn_int code) { return (code >> 4) - 1; }
#define HN_I_NO_CODE 64

#if HN_ARITHMETIC != HN_FIXED

#define HN_I_NO_OFFSET 0.0f

HN_FN hn_float hn_i_jitter(hn_float jitter) { return hn_i_to_num(min(max(0.0f, jitter), 1.0f)); }
HN_FN hn_float hn_i_from_centre(hn_float f) { return hn_i_multiply_add(f, 2.0f, -1.0f); }
HN_FN hn_float hn_i_offset_from_cell(hn_float d, hn_int n) { return hn_i_minus(d, hn_i_float(n) * 2.0f); }
HN_FN hn_vec3 hn_i_triple(hn_float a, hn_float b, hn_float c) { return vec3(a, b, c); }
HN_FN hn_vec3 hn_i_offsets_from_points(hn_vec3 d, hn_vec3 a, hn_float jitter) {
  HN_I_PRECISE hn_vec3 n = d - a * jitter;
  return n;
}
HN_FN hn_float hn_i_toward(hn_float d) { return hn_i_select(d == 0.0f, 0.0f, d * -0.5f); }

HN_FN hn_vec3 hn_i_offset_difference(hn_vec3 a, hn_float b) {
  HN_I_PRECISE hn_vec3 n = a - b;
  return n;
}
HN_FN hn_float hn_i_sum(hn_float a, hn_float b) { return hn_i_plus(a, b); }
HN_FN hn_vec3 hn_i_sum(hn_vec3 a, hn_vec3 b) {
  HN_I_PRECISE hn_vec3 n = a + b;
  return n;
}
HN_FN hn_vec3 hn_i_rank_differences(hn_vec3 a, hn_float b) { return hn_i_offset_difference(a, b); }
HN_FN hn_float hn_i_rank_of_code(hn_int code) { return hn_i_float(code); }
HN_FN hn_float hn_i_no_weight() { return 0.0f; }
HN_FN hn_vec4 hn_i_far_away() { return vec4(65536.0f, 65536.0f, 65536.0f, 0.0f); }
HN_FN hn_vec4 hn_i_ranks(hn_float x, hn_float y, hn_float z, hn_float w) { return vec4(x, y, z, w); }
HN_FN hn_vec3 hn_i_ranks(hn_float x, hn_float y, hn_float z) { return vec3(x, y, z); }

HN_FN hn_vec3 hn_i_multiply_add(hn_vec3 a, hn_float b, hn_vec3 c) {
  HN_I_PRECISE hn_vec3 n = a * b + c;
  return n;
}
HN_FN hn_vec3 hn_i_hybrids(hn_vec3 squares, hn_vec3 sums) { return hn_i_multiply_add(squares, 0.5f, sums); }
HN_FN hn_float hn_i_distance(hn_float rank, hn_int metric) {
  if (metric == HN_METRIC_SQUARED) return rank * 0.25f;
  if (metric == HN_METRIC_MANHATTAN || metric == HN_METRIC_CHEBYSHEV || metric == HN_METRIC_HYBRID) return rank * 0.5f;
  return hn_i_root(rank) * 0.5f;
}

// A square root at the end is cheaper than one for each point. But one of HN_PRECISE costs less than a division.
#if HN_ARITHMETIC == HN_FAST
HN_FN hn_vec3 hn_i_border_ranks(hn_vec3 gaps, hn_vec3 apart) { return gaps * gaps / apart; }
HN_FN hn_float hn_i_border_distance(hn_float rank) { return sqrt(rank) * 0.25f; }
#else
HN_FN hn_vec3 hn_i_border_ranks(hn_vec3 gaps, hn_vec3 apart) {
  return vec3(hn_i_over_root(gaps.x, apart.x), hn_i_over_root(gaps.y, apart.y), hn_i_over_root(gaps.z, apart.z));
}
HN_FN hn_float hn_i_border_distance(hn_float rank) { return rank * 0.25f; }
#endif

HN_FN hn_float hn_i_smooth_weight(hn_float square) {
  HN_I_PRECISE hn_float t = max(1.0f - hn_i_root(square) * 0.5f, 0.0f);
  HN_I_PRECISE hn_float q = t * t;
  HN_I_PRECISE hn_float w = q * q;
  return w;
}
HN_FN hn_float hn_i_smooth_distance(hn_float weights) {
  return hn_i_minus(1.0f, hn_i_root(hn_i_root(hn_i_plus(weights, 1.0f / 4096.0f))));
}

#else

#define HN_I_NO_OFFSET 0

HN_FN hn_int hn_i_jitter(hn_float jitter) { return int(min(max(0.0f, jitter), 1.0f) * HN_I_FLOAT_UNITS_FRACTION); }
HN_FN hn_int hn_i_from_centre(hn_int f) { return f - HN_I_UNITS_FRACTION / 2; }
HN_FN hn_int hn_i_offset_from_cell(hn_int d, hn_int n) { return d - n * HN_I_UNITS_FRACTION; }

HN_FN hn_ivec3 hn_i_triple(hn_int a, hn_int b, hn_int c) { return ivec3(a, b, c); }

// A direction is in units of 2^-9, of half a cell.
HN_FN hn_ivec3 hn_i_offsets_from_points(hn_ivec3 d, hn_ivec3 a, hn_int jitter) { return d - ((a * jitter) >> 10); }
HN_FN hn_float hn_i_toward(hn_int d) { return HN_I_NOT_WHOLE(hn_i_float(-d) * (1.0f / HN_I_FLOAT_UNITS_FRACTION)); }

HN_FN hn_ivec3 hn_i_offset_difference(hn_ivec3 a, hn_int b) { return (a - b) >> 1; }
HN_FN hn_uint hn_i_sum(hn_uint a, hn_uint b) { return a + b; }
HN_FN hn_uvec3 hn_i_sum(hn_uvec3 a, hn_uvec3 b) { return a + b; }
HN_FN hn_uvec3 hn_i_rank_differences(hn_uvec3 a, hn_uint b) { return a - b; }
HN_FN hn_uint hn_i_rank_of_code(hn_int code) { return uint(code); }
HN_FN hn_uint hn_i_no_weight() { return 0u; }
HN_FN hn_uvec4 hn_i_far_away() { return uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0u); }
HN_FN hn_uvec4 hn_i_ranks(hn_uint x, hn_uint y, hn_uint z, hn_uint w) { return uvec4(x, y, z, w); }
HN_FN hn_uvec3 hn_i_ranks(hn_uint x, hn_uint y, hn_uint z) { return uvec3(x, y, z); }

// Squares are in units of 2^-28, and the ranks of the other metrics in units of 2^-20.
HN_FN hn_uvec3 hn_i_hybrids(hn_uvec3 squares, hn_uvec3 sums) { return (squares >> 8u) + sums; }
HN_FN hn_float hn_i_distance(hn_uint rank, hn_int metric) {
  if (metric == HN_METRIC_SQUARED) return HN_I_NOT_WHOLE(hn_i_float(rank >> 8u) * (1.0f / HN_I_FLOAT_UNITS_FRACTION));
  if (metric == HN_METRIC_MANHATTAN || metric == HN_METRIC_CHEBYSHEV || metric == HN_METRIC_HYBRID) {
    return HN_I_NOT_WHOLE(hn_i_float(rank) * (1.0f / HN_I_FLOAT_UNITS_FRACTION));
  }
  return hn_i_float(hn_i_root(rank)) * (1.0f / HN_I_FLOAT_UNITS_DISTANCE);
}
HN_FN hn_uvec3 hn_i_border_ranks(hn_uvec3 gaps, hn_uvec3 apart) {
  return uvec3(hn_i_over_root(gaps.x, apart.x), hn_i_over_root(gaps.y, apart.y), hn_i_over_root(gaps.z, apart.z));
}
HN_FN hn_float hn_i_border_distance(hn_uint rank) { return hn_i_float(rank) * (1.0f / 65536.0f); }

// Weights are in units of 2^-30. They are made of 1 - distance in units of 2^-16, below 1, so that its square fits.
HN_FN hn_uint hn_i_smooth_weight(hn_uint square) {
  hn_uint t = min((262144u - min(hn_i_root(square), 262144u)) >> 2u, 65535u);
  hn_uint q = (t * t) >> 16u;
  return (q * q) >> 2u;
}

// 262144 is 1/4096 in units of 2^-30. The first root is in units of 2^-19, and so is the second.
HN_FN hn_float hn_i_smooth_distance(hn_uint weights) {
  hn_uint root = hn_i_root(hn_i_root(weights + 262144u) << 11u);
  return hn_i_float(524288 - int(root)) * (1.0f / 524288.0f);
}

#endif

// The number of steps, 2 or -2, to the cell beyond the neighbours of a cell, on the side of a place with the offset d
// from the centre of that cell.
HN_FN hn_int hn_i_far_step(hn_i_num d) { return hn_i_select_int(d > HN_I_NO_OFFSET, 2, -2); }

// hn_i_row returns the offsets from the centres of a cell and of its neighbours along an axis. hn_i_equal_triple
// repeats an offset, or a hash, three times.
HN_FN hn_i_num3 hn_i_row(hn_i_num d) {
  return hn_i_triple(hn_i_offset_from_cell(d, -1), d, hn_i_offset_from_cell(d, 1));
}
HN_FN hn_i_num3 hn_i_equal_triple(hn_i_num d) { return hn_i_triple(d, d, d); }
HN_FN hn_uvec3 hn_i_equal_triple(hn_uint h) { return uvec3(h, h, h); }

// The steps from the middle one of three cells along an axis to each, as they add to the odd number. Without a period
// they are constants.
HN_FN hn_uvec3 hn_i_odds_x(hn_uvec3 x) {
  return uvec3(hn_i_odd_x(hn_i_step_x(x.y, x.x), 0u), 0u, hn_i_odd_x(hn_i_step_x(x.y, x.z), 0u));
}
HN_FN hn_uvec3 hn_i_odds_y(hn_uvec3 y) { return uvec3(hn_i_odd_y(y.x - y.y, 0u), 0u, hn_i_odd_y(y.z - y.y, 0u)); }
HN_FN hn_uvec3 hn_i_odds_z(hn_uvec3 z) { return uvec3(hn_i_odd_z(z.x - z.y, 0u), 0u, hn_i_odd_z(z.z - z.y, 0u)); }

// The hashes of three cells in a row. Their coordinates add joins and odds to the two joins of a hash, and all else
// adds join and odd.
HN_FN hn_uvec3 hn_i_row_hashes(hn_uvec3 joins, hn_uvec3 odds, hn_uint join, hn_uint odd) {
  joins = hn_i_xor(joins, join);
  odds = odds + odd;
  return uvec3(hn_i_point_hash(joins.x, odds.x), hn_i_point_hash(joins.y, odds.y), hn_i_point_hash(joins.z, odds.z));
}

// Inserts a rank into the three smallest ranks so far, and keeps the code of the smallest. The first of equal ranks
// stays.
HN_FN hn_i_rank4 hn_i_insert(hn_i_rank4 best, hn_i_rank rank, hn_int code) {
  return hn_i_ranks(min(best.x, rank), min(best.y, max(best.x, rank)), min(best.z, max(best.y, rank)),
                    hn_i_select(rank < best.x, hn_i_rank_of_code(code), best.w));
}

// Inserts the ranks of a row. The cell in the middle has the code, and the others are a step from it.
HN_FN hn_i_rank4 hn_i_insert(hn_i_rank4 best, hn_i_rank3 ranks, hn_int code, hn_int step) {
  best = hn_i_insert(best, ranks.x, code - step);
  best = hn_i_insert(best, ranks.y, code);
  return hn_i_insert(best, ranks.z, code + step);
}

// Compares the border ranks of a row with the smallest so far. The cell that has the nearest point does not count.
HN_FN hn_i_rank hn_i_nearest_border(hn_i_rank best, hn_i_rank3 gaps, hn_i_rank3 apart, hn_int code, hn_int step,
                                    hn_i_rank own) {
  hn_i_rank large = hn_i_far_away().x;
  hn_i_rank before = hn_i_rank_of_code(code - step);
  hn_i_rank middle = hn_i_rank_of_code(code);
  hn_i_rank after = hn_i_rank_of_code(code + step);
  hn_i_rank3 ranks = hn_i_border_ranks(
      gaps, hn_i_ranks(hn_i_select(before == own, large, apart.x), hn_i_select(middle == own, large, apart.y),
                       hn_i_select(after == own, large, apart.z)));
  return min(min(best, hn_i_select(before == own, large, ranks.x)),
             min(hn_i_select(middle == own, large, ranks.y), hn_i_select(after == own, large, ranks.z)));
}

// Adds the weights of a row to the sum of weights so far.
HN_FN hn_i_rank hn_i_summed_weights(hn_i_rank sum, hn_i_rank3 squares) {
  return hn_i_sum(hn_i_sum(sum, hn_i_smooth_weight(squares.x)),
                  hn_i_sum(hn_i_smooth_weight(squares.y), hn_i_smooth_weight(squares.z)));
}

// The distances of the two smallest ranks.
HN_FN hn_vec2 hn_i_two_distances(hn_i_rank4 best, hn_int metric) {
  return vec2(hn_i_distance(best.x, metric), hn_i_distance(best.y, metric));
}

#endif
