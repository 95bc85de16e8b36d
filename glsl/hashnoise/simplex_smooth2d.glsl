// hashnoise: smooth simplex noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_SMOOTH2D_GLSL
#define HN_SIMPLEX_SMOOTH2D_GLSL

#include "detail/triangular_lattice.glsl"

// A sum of weighted ramps is at most 1024 / 3081 (tools/make bounds).
HN_FN hn_i_num hn_i_scaled_smooth2(hn_i_num n) { return hn_i_scaled(n, 3081); }

// The noise in the numbers of HN_ARITHMETIC, from the hashes of two neighbours in the lower row and of two in the upper
// one, and the places between these.
HN_FN hn_i_num hn_i_simplex_smooth(hn_uvec4 h, hn_i_num lower, hn_i_num upper, hn_i_num y) {
  hn_i_num lower1 = hn_i_minus_one(lower);
  hn_i_num upper1 = hn_i_minus_one(upper);
  hn_i_num y1 = hn_i_minus_one(y);
  hn_i_num n = hn_i_weighted_ramp(hn_i_triangle_ramp(h.x, lower, y, false),
                                  hn_i_weight3(hn_i_falloff(hn_i_square(lower, y), 1024, 1)));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.y, lower1, y, false),
                                      hn_i_weight3(hn_i_falloff(hn_i_square(lower1, y), 1024, 1))));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.z, upper, y1, false),
                                      hn_i_weight3(hn_i_falloff(hn_i_square(upper, y1), 1024, 1))));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.w, upper1, y1, false),
                                      hn_i_weight3(hn_i_falloff(hn_i_square(upper1, y1), 1024, 1))));
  return hn_i_scaled_smooth2(n);
}

// The place along x in a row, in steps: odd rows are shifted.
HN_FN hn_i_num hn_i_in_row(hn_i_num x, hn_int row) {
  return hn_i_minus(x, hn_i_select((row & 1) == 0, hn_i_quarters(0), hn_i_quarters(2)));
}

HN_FN hn_i_num hn_i_simplex_smooth(hn_place2 place, hn_uint seed) {
  hn_i_num2 p = hn_i_steps(place.fraction);
  hn_int row = hn_i_floor(p.y);
  hn_i_num lower = hn_i_in_row(p.x, row);
  hn_i_num upper = hn_i_in_row(p.x, hn_i_add_wrapping(row, 1));
  hn_int i = hn_i_floor(lower);
  hn_int j = hn_i_floor(upper);
  // The spread coordinates of two points of the lower row and of two of the upper one, and of both rows.
  hn_uvec2 x0;
  hn_uvec2 x1;
  hn_uvec2 y;
  if (place.tiled) {
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    hn_uint y0 = hn_i_doubled(c.y, row, place.period.y);
    hn_uint y1 = hn_i_doubled(c.y, hn_i_add_wrapping(row, 1), place.period.y);
    hn_uvec2 a = hn_i_spread(uvec2(hn_i_doubled(c.x, i, place.period.x), y0));
    hn_uvec2 b = hn_i_spread(uvec2(hn_i_doubled(c.x, j, place.period.x), y1));
    y = uvec2(a.y, b.y);
    x0 = uvec2(a.x, hn_i_spread(hn_i_doubled(c.x, hn_i_add_wrapping(i, 1), place.period.x)));
    x1 = uvec2(b.x, hn_i_spread(hn_i_doubled(c.x, hn_i_add_wrapping(j, 1), place.period.x)));
  } else {
    hn_uvec2 c = hn_i_spread(uvec2(hn_i_doubled(uint(place.cell.x), i), hn_i_doubled(uint(place.cell.y), row)));
    hn_uint x = hn_i_spread(hn_i_doubled(uint(place.cell.x), j));
    y = uvec2(c.y, hn_i_upper(c).y);
    x0 = uvec2(c.x, hn_i_upper(c.x));
    x1 = uvec2(x, hn_i_upper(x));
  }
  hn_uint s = hn_i_scramble(seed);
  return hn_i_simplex_smooth(uvec4(hn_i_seeded_hash(uvec2(x0.x, y.x), s), hn_i_seeded_hash(uvec2(x0.y, y.x), s),
                                   hn_i_seeded_hash(uvec2(x1.x, y.y), s), hn_i_seeded_hash(uvec2(x1.y, y.y), s)),
                             hn_i_fract(lower), hn_i_fract(upper), hn_i_fract(p.y));
}

// Smooth simplex noise on the plane. The kernel is a quarter larger than hn_simplex's, in the square of its
// radius, so the field is calmer. At the distance of a step the kernel ends: so only the two rows around a place count,
// and in each the two nearest points.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_simplex_smooth(uv * 8.0, 7u);
//   returns  [-1, 1] (proven bound 0.99967), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 1.71e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            8.95e-5. From a cell at most 1.52e-6
//   period   2^31 cells per axis, or the tile's
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over the corners of a simplex; docs/reference/contract.md,
//            section 13
HN_FN hn_float hn_simplex_smooth(hn_place2 place, hn_uint seed) { return hn_i_value(hn_i_simplex_smooth(place, seed)); }
HN_FN hn_float hn_simplex_smooth(hn_vec2 p, hn_uint seed) { return hn_simplex_smooth(hn_place(p), seed); }
HN_FN hn_float hn_simplex_smooth(hn_vec2 p) { return hn_simplex_smooth(p, 0u); }

#endif
