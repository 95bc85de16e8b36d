// hashnoise: the triangular lattice of simplex noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_TRIANGULAR_LATTICE_GLSL
#define HN_TRIANGULAR_LATTICE_GLSL

#include "block2d.glsl"
#include "direction.glsl"
#include "falloff.glsl"

// The points lie in rows that are half a cell apart. In a row they are half a cell apart, too, and every second row is
// shifted by a quarter: so a cell has four points. A step is half a cell. Three neighbours form a triangle whose sides
// are 1, 1.12 and 1.12 steps long. There is no coarser lattice of nearly regular triangles that has a point at every
// corner of a cell; with this one every whole period fits. Its coordinates are quarters, so they are exact.
//
// Point i of row j is at (i, j) in steps, or at (i + 1/2, j) in odd rows. It has the hash of the point (i, j) of the
// integer lattice.

// The place of a fraction of a cell, in steps.
HN_FN hn_i_num2 hn_i_steps(hn_i_num2 f) { return hn_i_vector(hn_i_plus(f.x, f.x), hn_i_plus(f.y, f.y)); }

// Adds two numbers of rows or columns. For a place that is far out of its cell they are so large that ints would
// overflow, which C++ leaves undefined.
HN_FN hn_int hn_i_add_wrapping(hn_int i, hn_int more) { return int(uint(i) + uint(more)); }

// A coordinate of a point: 2 c + more, where c is its cell's, and more lies in [-2, 3].
HN_FN hn_uint hn_i_doubled(hn_uint c, hn_int more) { return c * 2u + uint(more); }

// With a period, for a wrapped c. Before it is wrapped, a point lies up to one cell outside of the period.
HN_FN hn_uint hn_i_doubled(hn_uint c, hn_int more, hn_int period) {
  hn_uint size = uint(max(period, 0)) * 2u;
  hn_uint i = hn_i_doubled(c, more);
  return hn_i_select(more < 0, hn_i_select(c == 0u, i + size, i), hn_i_select(i >= size, i - size, i));
}

// ---------------------------------------------------------------------------------------------------------------------
// The triangle around a place. Skewed coordinates u = x + y / 2 and v = y, in steps, are whole at the points. The
// corners of the triangle are the first corner of the skewed square around the place, its last, and between them the
// one along u if u has more beyond a whole number than v has, else the one along v.

HN_FN hn_i_num2 hn_i_skewed(hn_i_num2 f) {
  return hn_i_vector(hn_i_plus(hn_i_plus(f.x, f.x), f.y), hn_i_plus(f.y, f.y));
}

// The column of the first corner in its row, counted from column 2 c.x, where c is the cell.
HN_FN hn_int hn_i_column_of(hn_i_num2 skewed) {
  return int(uint(hn_i_truncate(skewed.x)) - uint(min(hn_i_truncate(skewed.y), 1)));
}

// The spread coordinates of the corners, in the order above.
struct hn_i_triangle2 {
  hn_uvec2 first;
  hn_uvec2 middle;
  hn_uvec2 last;
};
HN_FN hn_i_triangle2 hn_i_triangle(hn_place2 place, hn_i_num2 skewed) {
  hn_int row = hn_i_truncate(skewed.y);
  hn_int column = hn_i_column_of(skewed);
  hn_i_num u = hn_i_fract(skewed.x);
  hn_i_num v = hn_i_fract(skewed.y);
  HN_I_NEW(hn_i_triangle2, corners);
  if (place.tiled) {
    hn_int last_column = hn_i_add_wrapping(column, row & 1);
    hn_int middle_column = hn_i_select(u > v, hn_i_add_wrapping(column, 1), hn_i_add_wrapping(last_column, -1));
    hn_uvec2 c = hn_i_wrap(place.cell, place.period);
    hn_uint lower = hn_i_doubled(c.y, row, place.period.y);
    hn_uint upper = hn_i_doubled(c.y, hn_i_add_wrapping(row, 1), place.period.y);
    corners.first = hn_i_spread(uvec2(hn_i_doubled(c.x, column, place.period.x), lower));
    corners.middle =
        hn_i_spread(uvec2(hn_i_doubled(c.x, middle_column, place.period.x), hn_i_select(u > v, lower, upper)));
    corners.last = hn_i_spread(uvec2(hn_i_doubled(c.x, last_column, place.period.x), upper));
  } else {
    hn_uvec2 first =
        hn_i_spread(uvec2(hn_i_doubled(uint(place.cell.x), column), hn_i_doubled(uint(place.cell.y), row)));
    hn_uvec2 next = hn_i_upper(first);
    hn_uvec2 last = uvec2(hn_i_select((row & 1) == 0, first.x, next.x), next.y);
    hn_uvec2 middle = uvec2(hn_i_select(u > v, next.x, last.x - HN_I_STEP_X), hn_i_select(u > v, first.y, next.y));
    corners.first = first;
    corners.middle = middle;
    corners.last = last;
  }
  return corners;
}

// The hashes of the corners. The middle corner lies in the row of the first or of the last. So it takes its
// row's share of both joins from there.
HN_FN hn_uvec3 hn_i_triangle(hn_place2 place, hn_i_num2 skewed, hn_uint seed) {
  hn_i_triangle2 corners = hn_i_triangle(place, skewed);
  hn_i_num u = hn_i_fract(skewed.x);
  hn_i_num v = hn_i_fract(skewed.y);
  hn_uint s = hn_i_scramble(seed);
  hn_uint lower_join = hn_i_high(corners.first).y ^ hn_i_seed_join(s);
  hn_uint upper_join = hn_i_high(corners.last).y ^ hn_i_seed_join(s);
  hn_uint lower_odd = hn_i_odd_y(corners.first.y, hn_i_odd(s));
  hn_uint upper_odd = hn_i_odd_y(corners.last.y, hn_i_odd(s));
  return uvec3(hn_i_point_hash(hn_i_high(corners.first.x) ^ lower_join, hn_i_odd_x(corners.first.x, lower_odd)),
               hn_i_point_hash(hn_i_high(corners.middle.x) ^ hn_i_select(u > v, lower_join, upper_join),
                               hn_i_odd_x(corners.middle.x, hn_i_select(u > v, lower_odd, upper_odd))),
               hn_i_point_hash(hn_i_high(corners.last.x) ^ upper_join, hn_i_odd_x(corners.last.x, upper_odd)));
}

// The offsets from the corners along x and along y, and how near the corners are.
HN_FN hn_i_num3 hn_i_triangle_x(hn_i_num2 skewed) {
  hn_i_num u = hn_i_fract(skewed.x);
  hn_i_num v = hn_i_fract(skewed.y);
  hn_i_num x = hn_i_minus(u, hn_i_half(v));
  return hn_i_vector(x, hn_i_select(u > v, hn_i_minus(x, HN_I_ONE), hn_i_plus(x, hn_i_quarters(2))),
                     hn_i_minus(x, hn_i_quarters(2)));
}
HN_FN hn_i_num3 hn_i_triangle_y(hn_i_num2 skewed) {
  hn_i_num y = hn_i_fract(skewed.y);
  return hn_i_vector(y, hn_i_select(hn_i_fract(skewed.x) > y, y, hn_i_minus_one(y)), hn_i_minus_one(y));
}

// The squared radius in units of 2^-10. It is just below 4/5, the squared height over the longer sides of a triangle.
#define HN_I_TRIANGLE_RADIUS 819
HN_FN hn_i_num3 hn_i_triangle_falloff(hn_i_num3 x, hn_i_num3 y) {
  return hn_i_vector(hn_i_falloff(hn_i_square(x.x, y.x), HN_I_TRIANGLE_RADIUS, 1),
                     hn_i_falloff(hn_i_square(x.y, y.y), HN_I_TRIANGLE_RADIUS, 1),
                     hn_i_falloff(hn_i_square(x.z, y.z), HN_I_TRIANGLE_RADIUS, 1));
}

// The ramp of a corner, before it is weighted. The gradient may be rotated by a quarter turn.
HN_FN hn_i_num hn_i_triangle_ramp(hn_uint h, hn_i_num x, hn_i_num y, bool turned) {
  return hn_i_ramp_of2(hn_i_along2(hn_i_direction2(h, turned), hn_i_offset(x), hn_i_offset(y)));
}

// Converts a derivative per step to one per cell.
HN_FN hn_float hn_i_per_cell(hn_float d) { return d * 2.0f; }

// A sum of weighted ramps is at most 1024 / 4099 (tools/make bounds), with turning gradients, too.
HN_FN hn_i_num hn_i_scaled_simplex2(hn_i_num n) { return hn_i_scaled(n, 4099); }

#endif
