// hashnoise: simplex noise in space.
// To read it in one piece: docs/reference/snippets/hn_simplex3.md
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX3D_GLSL
#define HN_SIMPLEX3D_GLSL

#include "detail/body_centred_lattice.glsl"

// The noise before it is scaled. The gradients may be rotated by a sixth of a turn.
HN_FN hn_i_num hn_i_simplex(hn_uvec4 h, hn_i_num4 x, hn_i_num4 y, hn_i_num4 z, hn_i_num4 t, bool turned) {
  hn_i_num n = hn_i_weighted_ramp(hn_i_ramp_of(h.x, x.x, y.x, z.x, turned), hn_i_weight4(t.x));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of(h.y, x.y, y.y, z.y, turned), hn_i_weight4(t.y)));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of(h.z, x.z, y.z, z.z, turned), hn_i_weight4(t.z)));
  return hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of(h.w, x.w, y.w, z.w, turned), hn_i_weight4(t.w)));
}
HN_FN hn_i_num hn_i_simplex(hn_i_neighbourhood3 cells, hn_i_num3 f, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, t);
  return hn_i_scaled_simplex3(hn_i_simplex(h, x, y, z, t, false));
}

// Simplex noise in space: gradient noise on the body-centred lattice, the corners and centres of all cells. Slices
// across an axis differ a little: where z is a multiple of 1/2 they have less contrast than in between. Tilted slices
// are alike (docs/measured/quality.md).
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_simplex(vec3(uv * 8.0, 0.5), 7u);
//   returns  [-1, 1] (proven bound 0.99956), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 4.48e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.20e-4. From a cell at most 4.47e-6
//   period   2^32 cells per axis, or the tile's
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over lattice points; docs/reference/contract.md, section 13
HN_FN hn_float hn_simplex(hn_place3 place, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_neighbourhood(place), place.fraction, seed));
}
HN_FN hn_float hn_simplex(hn_vec3 p, hn_uint seed) { return hn_simplex(hn_place(p), seed); }
HN_FN hn_float hn_simplex(hn_vec3 p) { return hn_simplex(p, 0u); }

#endif
