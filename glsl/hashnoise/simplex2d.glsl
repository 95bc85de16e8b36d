// hashnoise: simplex noise on the plane.
// To read it in one piece: docs/reference/snippets/hn_simplex2.md
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX2D_GLSL
#define HN_SIMPLEX2D_GLSL

#include "detail/triangular_lattice.glsl"

// The noise before it is scaled, from the hashes of the corners. The gradients may be rotated by a quarter turn.
HN_FN hn_i_num hn_i_simplex(hn_uvec3 h, hn_i_num2 skewed, bool turned) {
  hn_i_num3 x = hn_i_triangle_x(skewed);
  hn_i_num3 y = hn_i_triangle_y(skewed);
  hn_i_num3 t = hn_i_triangle_falloff(x, y);
  hn_i_num n = hn_i_weighted_ramp(hn_i_triangle_ramp(h.x, x.x, y.x, turned), hn_i_weight_plane(t.x));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.y, x.y, y.y, turned), hn_i_weight_plane(t.y)));
  return hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.z, x.z, y.z, turned), hn_i_weight_plane(t.z)));
}
HN_FN hn_i_num hn_i_simplex(hn_uvec3 h, hn_i_num2 skewed) {
  return hn_i_scaled_simplex2(hn_i_simplex(h, skewed, false));
}
HN_FN hn_i_num hn_i_simplex(hn_place2 place, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  return hn_i_simplex(hn_i_triangle(place, skewed, seed), skewed);
}

// Simplex noise on the plane: gradient noise on a triangular lattice. It does not prefer the axes. There are four
// lattice points to a cell, so its features are about half as large as hn_perlin's.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_simplex(uv * 8.0, 7u);
//   returns  [-1, 1] (proven bound 0.97117), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 3.16e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.63e-4. From a cell at most 2.64e-6
//   period   2^31 cells per axis, or the tile's
//   cost     3 hashes (none with HN_HASH_LATTICE) and 3 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over the corners of a simplex; docs/reference/contract.md,
//            section 13
HN_FN hn_float hn_simplex(hn_place2 place, hn_uint seed) { return hn_i_value(hn_i_simplex(place, seed)); }
HN_FN hn_float hn_simplex(hn_vec2 p, hn_uint seed) { return hn_simplex(hn_place(p), seed); }
HN_FN hn_float hn_simplex(hn_vec2 p) { return hn_simplex(p, 0u); }

#endif
