// hashnoise: smooth simplex noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_SMOOTH3D_GLSL
#define HN_SIMPLEX_SMOOTH3D_GLSL

#include "detail/body_centred_lattice.glsl"

// The kernel ends at the square root of 3/4, half of a cell's longest diagonal. The ends of each such diagonal:
// one is as far away, or farther: the squares of both distances sum to 3/2 or more. So of each kind of points four are
// enough: one end of each diagonal of the cube around the place, whichever is nearer.

// A sum of weighted ramps is at most 1024 / 4279 (tools/make bounds).
HN_FN hn_i_num hn_i_scaled_smooth3(hn_i_num n) { return hn_i_scaled(n, 4279); }

// The share of a neighbour of the nearest point in the noise: the one along an axis, or the opposite end of its
// diagonal. The first has the spread coordinates one and the offsets d, the second others and e. The magnitude of
// the offset is size along the axis, and total along all three. q is the square of the distance of the nearest point.
HN_FN hn_i_num hn_i_neighbour(hn_uvec3 one, hn_uvec3 others, hn_i_num3 d, hn_i_num3 e, hn_i_num size, hn_i_num total,
                              hn_i_square_number q, hn_uint join, hn_uint sum) {
  hn_i_num twice = hn_i_plus(size, size);
  hn_i_num excess = hn_i_minus(total, twice);  // above 1/2 where the opposite end is nearer
  hn_i_num middle = hn_i_quarters(2);
  hn_uvec3 c = uvec3(hn_i_select(excess > middle, others.x, one.x), hn_i_select(excess > middle, others.y, one.y),
                     hn_i_select(excess > middle, others.z, one.z));
  hn_i_num x = hn_i_select(excess > middle, e.x, d.x);
  hn_i_num y = hn_i_select(excess > middle, e.y, d.y);
  hn_i_num z = hn_i_select(excess > middle, e.z, d.z);
  hn_i_num more =
      min(hn_i_minus(HN_I_ONE, twice), hn_i_plus(hn_i_minus(hn_i_quarters(8), hn_i_plus(total, total)), twice));
  return hn_i_weighted_ramp(hn_i_ramp_of(hn_i_point_hash(c, join, sum), x, y, z, false),
                            hn_i_weight5(hn_i_falloff(hn_i_square_plus(q, more), 768, 1)));
}

// The share of the four points of a kind in the noise. The nearest has the spread coordinates n and the offsets d;
// along each axis the next ones are m and e. The offsets have the magnitudes size.
HN_FN hn_i_num hn_i_cube(hn_uvec3 n, hn_uvec3 m, hn_i_num3 d, hn_i_num3 e, hn_i_num3 size, hn_i_square_number q,
                         hn_uint join, hn_uint sum) {
  hn_i_num total = hn_i_plus(hn_i_plus(size.x, size.y), size.z);
  hn_i_num a = hn_i_weighted_ramp(hn_i_ramp_of(hn_i_point_hash(n, join, sum), d.x, d.y, d.z, false),
                                  hn_i_weight5(hn_i_falloff(q, 768, 1)));
  a = hn_i_plus(a, hn_i_neighbour(uvec3(m.x, n.y, n.z), uvec3(n.x, m.y, m.z), hn_i_vector(e.x, d.y, d.z),
                                  hn_i_vector(d.x, e.y, e.z), size.x, total, q, join, sum));
  a = hn_i_plus(a, hn_i_neighbour(uvec3(n.x, m.y, n.z), uvec3(m.x, n.y, m.z), hn_i_vector(d.x, e.y, d.z),
                                  hn_i_vector(e.x, d.y, e.z), size.y, total, q, join, sum));
  return hn_i_plus(a, hn_i_neighbour(uvec3(n.x, n.y, m.z), uvec3(m.x, m.y, n.z), hn_i_vector(d.x, d.y, e.z),
                                     hn_i_vector(e.x, e.y, d.z), size.z, total, q, join, sum));
}

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_simplex_smooth(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_uint seed) {
  hn_i_num4 x = hn_i_offsets(f.x);
  hn_i_num4 y = hn_i_offsets(f.y);
  hn_i_num4 z = hn_i_offsets(f.z);
  hn_i_num3 size = hn_i_vector(hn_i_magnitude(x.x), hn_i_magnitude(y.x), hn_i_magnitude(z.x));
  hn_i_num3 inner = hn_i_vector(hn_i_magnitude(x.z), hn_i_magnitude(y.z), hn_i_magnitude(z.z));
  hn_uint s = hn_i_scramble(seed);
  hn_uint join = hn_i_seed_join(s);
  hn_i_num corners =
      hn_i_cube(hn_i_nearer(f, cells.cell, cells.following), hn_i_nearer(f, cells.following, cells.cell),
                hn_i_vector(x.x, y.x, z.x), hn_i_vector(x.y, y.y, z.y), size, hn_i_square(x.x, y.x, z.x), join, s);
  hn_i_num centres = hn_i_cube(cells.cell, hn_i_nearer(f, cells.previous, cells.following), hn_i_vector(x.z, y.z, z.z),
                               hn_i_vector(x.w, y.w, z.w), inner, hn_i_square(x.z, y.z, z.z), join ^ HN_I_CENTRE_JOIN,
                               s + HN_I_CENTRE_SUM);
  return hn_i_scaled_smooth3(hn_i_plus(corners, centres));
}

// Smooth simplex noise in space. The kernel is half again as large as hn_simplex's, in the square of its radius,
// so the field is calmer.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_simplex_smooth(vec3(uv * 8.0, 0.5), 7u);
//   returns  [-1, 1] (proven bound 0.99942), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 2.56e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            3.88e-4. From a cell at most 2.52e-6
//   period   2^32 cells per axis, or the tile's
//   cost     8 hashes (none with HN_HASH_LATTICE) and 8 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over lattice points; docs/reference/contract.md, section 13
HN_FN hn_float hn_simplex_smooth(hn_place3 place, hn_uint seed) {
  return hn_i_value(hn_i_simplex_smooth(hn_i_neighbourhood(place), place.fraction, seed));
}
HN_FN hn_float hn_simplex_smooth(hn_vec3 p, hn_uint seed) { return hn_simplex_smooth(hn_place(p), seed); }
HN_FN hn_float hn_simplex_smooth(hn_vec3 p) { return hn_simplex_smooth(p, 0u); }

#endif
