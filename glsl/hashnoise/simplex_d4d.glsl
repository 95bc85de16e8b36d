// hashnoise: simplex noise and its derivatives in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_D4D_GLSL
#define HN_SIMPLEX_D4D_GLSL

#include "detail/body_centred_lattice.glsl"

// The share of a point in the derivatives of the noise.
HN_FN hn_i_num4 hn_i_weighted_ramp_d(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num w, hn_i_num t) {
  hn_i_num k = hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h, x, y, z, w)), hn_i_d_weight3(t, 2));
  hn_i_num weight = hn_i_weight3(t);
  hn_vec4 g = hn_i_direction4(h);
  return hn_i_vector(hn_i_d_weighted_ramp4(g.x, weight, k, x), hn_i_d_weighted_ramp4(g.y, weight, k, y),
                     hn_i_d_weighted_ramp4(g.z, weight, k, z), hn_i_d_weighted_ramp4(g.w, weight, k, w));
}

HN_FN hn_derivatives4 hn_i_simplex_d(hn_i_neighbourhood4 cells, hn_i_num4 f, hn_uint seed) {
  hn_i_num4 x;
  hn_i_num4 y;
  hn_i_num4 z;
  hn_i_num4 w;
  hn_i_num4 t;
  hn_uvec4 h = hn_i_four_points(cells, f, seed, x, y, z, w, t);
  hn_i_num4 corners =
      hn_i_plus(hn_i_weighted_ramp_d(h.x, x.x, y.x, z.x, w.x, t.x), hn_i_weighted_ramp_d(h.y, x.y, y.y, z.y, w.y, t.y));
  hn_i_num4 d = hn_i_plus(hn_i_plus(corners, hn_i_weighted_ramp_d(h.z, x.z, y.z, z.z, w.z, t.z)),
                          hn_i_weighted_ramp_d(h.w, x.w, y.w, z.w, w.w, t.w));
  HN_I_NEW(hn_derivatives4, n);
  n.gradient = vec4(hn_i_derivative(hn_i_scaled_simplex4(d.x)), hn_i_derivative(hn_i_scaled_simplex4(d.y)),
                    hn_i_derivative(hn_i_scaled_simplex4(d.z)), hn_i_derivative(hn_i_scaled_simplex4(d.w)));
  hn_i_num sum = hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.x, x.x, y.x, z.x, w.x)), hn_i_weight3(t.x));
  sum = hn_i_plus(sum, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.y, x.y, y.y, z.y, w.y)), hn_i_weight3(t.y)));
  sum = hn_i_plus(sum, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.z, x.z, y.z, z.z, w.z)), hn_i_weight3(t.z)));
  sum = hn_i_plus(sum, hn_i_weighted_ramp(hn_i_ramp_of4(hn_i_along4(h.w, x.w, y.w, z.w, w.w)), hn_i_weight3(t.w)));
  n.value = hn_i_value(hn_i_scaled_simplex4(sum));
  return n;
}

// Simplex noise in four dimensions and its slope: the value of hn_simplex with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  hn_derivatives4 n = hn_simplex_d(vec4(uv * 8.0, 0.5, 0.25), 7u);
//   returns  value and, in gradient, its derivatives along x, y, z and w. A derivative is per cell, in
//            [-6.06, 6.06], once continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_simplex's, and of a derivative at most 3.72e-5 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 1.36e-3. From a cell at most 3.72e-5
//   period   2^32 cells per axis, or the tile's
//   cost     the hashes of hn_simplex, which are most of its cost, and about twice the rest
//   source   the product rule on weight and ramp; docs/reference/contract.md, section 13
HN_FN hn_derivatives4 hn_simplex_d(hn_place4 place, hn_uint seed) {
  return hn_i_simplex_d(hn_i_neighbourhood(place), place.fraction, seed);
}
HN_FN hn_derivatives4 hn_simplex_d(hn_vec4 p, hn_uint seed) { return hn_simplex_d(hn_place(p), seed); }
HN_FN hn_derivatives4 hn_simplex_d(hn_vec4 p) { return hn_simplex_d(p, 0u); }

#endif
