// hashnoise: simplex noise on the plane whose gradients turn with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_SIMPLEX_PHASE2D_GLSL
#define HN_SIMPLEX_PHASE2D_GLSL

#include "detail/direction_turning.glsl"
#include "detail/triangular_lattice.glsl"

// The ramp of a corner, before it is weighted.
HN_FN hn_i_num hn_i_triangle_ramp(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num2 rotation) {
  return hn_i_ramp2(h, hn_i_offset(x), hn_i_offset(y), rotation);
}

// The noise in the numbers of HN_ARITHMETIC, from the words of the corners.
HN_FN hn_i_num hn_i_simplex_phase(hn_uvec3 h, hn_i_num2 skewed, hn_i_num2 rotation) {
  hn_i_num3 x = hn_i_triangle_x(skewed);
  hn_i_num3 y = hn_i_triangle_y(skewed);
  hn_i_num3 t = hn_i_triangle_falloff(x, y);
  hn_i_num n = hn_i_weighted_ramp(hn_i_triangle_ramp(h.x, x.x, y.x, rotation), hn_i_weight_plane(t.x));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.y, x.y, y.y, rotation), hn_i_weight_plane(t.y)));
  n = hn_i_plus(n, hn_i_weighted_ramp(hn_i_triangle_ramp(h.z, x.z, y.z, rotation), hn_i_weight_plane(t.z)));
  return hn_i_scaled_simplex2(n);
}
HN_FN hn_i_num hn_i_simplex_phase(hn_place2 place, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  return hn_i_simplex_phase(hn_i_triangle(place, skewed, seed), skewed, rotation);
}

// The share of a corner in the noise and in its derivatives, in steps.
HN_FN hn_i_num3 hn_i_turning_ramp_d(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num t, hn_i_num2 rotation) {
  return hn_i_weighted_ramp_d(hn_i_triangle_ramp(h, x, y, rotation), hn_i_gradient2(h, rotation), x, y, hn_i_weight_plane(t), hn_i_d_weight_plane(t, 1));
}

// The noise and its derivatives, from the words of the corners.
HN_FN hn_vec3 hn_i_simplex_phase_d(hn_uvec3 h, hn_i_num2 skewed, hn_i_num2 rotation) {
  hn_i_num3 x = hn_i_triangle_x(skewed);
  hn_i_num3 y = hn_i_triangle_y(skewed);
  hn_i_num3 t = hn_i_triangle_falloff(x, y);
  hn_i_num3 n = hn_i_plus(
      hn_i_plus(hn_i_turning_ramp_d(h.x, x.x, y.x, t.x, rotation), hn_i_turning_ramp_d(h.y, x.y, y.y, t.y, rotation)),
      hn_i_turning_ramp_d(h.z, x.z, y.z, t.z, rotation));
  return vec3(hn_i_value(hn_i_scaled_simplex2(n.x)), hn_i_per_cell(hn_i_derivative(hn_i_scaled_simplex2(n.y))),
              hn_i_per_cell(hn_i_derivative(hn_i_scaled_simplex2(n.z))));
}
HN_FN hn_vec3 hn_i_simplex_phase_d(hn_place2 place, hn_i_num2 rotation, hn_uint seed) {
  hn_i_num2 skewed = hn_i_skewed(place.fraction);
  return hn_i_simplex_phase_d(hn_i_triangle(place, skewed, seed), skewed, rotation);
}

// Simplex noise on the plane whose gradients turn: the field changes in place, and loops after one turn. All gradients
// turn alike.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   place    a place in its stead: hn_place(cell, f), hn_tile(p, period) and so on (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and that of phase + 1/2 is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: wrap it yourself
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99875), mean 0, 0 at lattice points, twice continuously differentiable, and smooth
//            in the phase. With a phase of 0 it is hn_simplex, within the error.
//   error    at most 6.43e-6 against the exact value, in any rounding mode (docs/accuracy.md). HN_FIXED 2.21e-4
//   period   2^31 cells per axis, or that of the tile
//   cost     the hashes of hn_simplex, a sine and a cosine of 6 multiplications of floats each, and twice the rest
//   source   Perlin and Neyret, "Flow noise", 2001; docs/contract.md, section 14
HN_FN hn_float hn_simplex(hn_place2 place, hn_float phase, hn_uint seed) {
  return hn_i_value(hn_i_simplex_phase(place, hn_i_rotation(phase), seed));
}
HN_FN hn_float hn_simplex(hn_vec2 p, hn_float phase, hn_uint seed) { return hn_simplex(hn_place(p), phase, seed); }

// The same with the derivatives along x and y, as of hn_simplex_d. The value is as above.
//   returns  the value and its derivatives, per cell, in [-8.63, 8.63]
//   error    of a derivative at most 8.35e-5. HN_FIXED 3.36e-3
//   cost     as above, and about twice the rest
//   (parameters as above)
HN_FN hn_vec3 hn_simplex_d(hn_place2 place, hn_float phase, hn_uint seed) {
  return hn_i_simplex_phase_d(place, hn_i_rotation(phase), seed);
}
HN_FN hn_vec3 hn_simplex_d(hn_vec2 p, hn_float phase, hn_uint seed) { return hn_simplex_d(hn_place(p), phase, seed); }

#endif
