// hashnoise: simplex noise in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX4D_GLSL
#define HN_SIMPLEX4D_GLSL

#include "detail/body_centred_lattice.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_simplex(hn_i_neighbourhood4 cells, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 w;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, w, t);
  hn_i_num n = hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.x, x.x, y.x, z.x, w.x)), hn_i_weight3(t.x));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.y, x.y, y.y, z.y, w.y)), hn_i_weight3(t.y)));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.z, x.z, y.z, z.z, w.z)), hn_i_weight3(t.z)));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.w, x.w, y.w, z.w, w.w)), hn_i_weight3(t.w)));
  return hn_i_scaled_simplex4(n);
}

// Simplex noise in four dimensions: gradient noise on the corners and centres of all cells. Four points are enough,
// where the lattice of simplices would take five and a sort. Where two coordinates stay fixed the contrast depends on
// them: it is least at vec2(1/2, 0), midway between corners and centres.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_simplex(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  [-1, 1] (proven bound 0.99915), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 4.78e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.22e-4. From a cell at most 4.78e-6
//   period   2^32 cells per axis, or the tile's
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 4 more to spread the coordinates, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Noise hardware", 2001, for the sum over lattice points; docs/reference/contract.md, section 13
HN_FN hn_float hn_simplex(hn_place4 place, hn_uint seed) {
  return hn_i_value(hn_i_simplex(hn_i_neighbourhood(place), place.fraction, seed));
}
HN_FN hn_float hn_simplex(hn_vec4 p, hn_uint seed) { return hn_simplex(hn_place(p), seed); }
HN_FN hn_float hn_simplex(hn_vec4 p) { return hn_simplex(p, 0u); }

#endif
