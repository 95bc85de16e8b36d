// hashnoise: curl noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL3D_GLSL
#define HN_CURL3D_GLSL

#include "simplex_d3d.glsl"

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_velocity(hn_float a, hn_float b, hn_float c, hn_float d) {
  HN_I_PRECISE hn_float n = a * b - c * d;
  return n;
}
HN_FN hn_float hn_i_curl_to_float(hn_float n) { return hn_i_flushed(n); }
HN_FN hn_float hn_i_float_to_curl(hn_float d) { return d; }

#else

// Multiplies two derivatives, each in units of 2^-19. The product is in units of 2^-20. The product of their low 9
// bits, which is below one unit, is dropped.
HN_FN hn_int hn_i_slope_product(hn_int a, hn_int b) {
  return (a >> 9) * (b >> 9) + (((a >> 9) * (b & 511) + (a & 511) * (b >> 9)) >> 9);
}
HN_FN hn_int hn_i_velocity(hn_int a, hn_int b, hn_int c, hn_int d) {
  return (hn_i_slope_product(a, b) - hn_i_slope_product(c, d) + 8) >> 4;
}
HN_FN hn_float hn_i_curl_to_float(hn_int n) { return hn_i_float(n) * (1.0f / 65536.0f); }
HN_FN hn_int hn_i_float_to_curl(hn_float d) { return int(d * HN_I_FLOAT_UNITS_SLOPE); }

#endif

HN_FN hn_vec3 hn_i_curl(hn_vec4 n, hn_vec4 m) {
  hn_i_num3 a = hn_i_vector(hn_i_float_to_curl(n.y), hn_i_float_to_curl(n.z), hn_i_float_to_curl(n.w));
  hn_i_num3 b = hn_i_vector(hn_i_float_to_curl(m.y), hn_i_float_to_curl(m.z), hn_i_float_to_curl(m.w));
  return vec3(hn_i_curl_to_float(hn_i_velocity(a.y, b.z, a.z, b.y)),
              hn_i_curl_to_float(hn_i_velocity(a.z, b.x, a.x, b.z)),
              hn_i_curl_to_float(hn_i_velocity(a.x, b.y, a.y, b.x)));
}

// A cell, or the next one if a place in it is in that after it is moved by so many quarters of a cell.
HN_FN hn_uint hn_i_moved_cell(hn_uint cell, hn_i_num f, hn_int quarters) {
  return cell + uint(hn_i_select_int(f < hn_i_quarters(4 - quarters), 0, 1));
}
HN_FN hn_i_num hn_i_moved_fraction(hn_i_num f, hn_int quarters) {
  hn_i_num rest = hn_i_quarters(4 - quarters);
  return hn_i_select(f < rest, hn_i_plus(f, hn_i_quarters(quarters)), hn_i_minus(f, rest));
}

// The place moved by half a cell along x and by a quarter along z. No place is farther from the points of the lattice
// than (1/2, 0, 1/4): where one noise is steep near a point, the other one, which is moved, is not.
HN_FN hn_place3 hn_i_between_points(hn_place3 place) {
  hn_place3 moved = place;
  hn_uvec3 cell = uvec3(place.cell);
  if (place.tiled) cell = hn_i_wrap(place.cell, place.period);
  moved.cell =
      ivec3(uvec3(hn_i_moved_cell(cell.x, place.fraction.x, 2), cell.y, hn_i_moved_cell(cell.z, place.fraction.z, 1)));
  moved.fraction =
      hn_i_vector(hn_i_moved_fraction(place.fraction.x, 2), place.fraction.y, hn_i_moved_fraction(place.fraction.z, 1));
  return moved;
}

// Curl noise in space: velocities of a flow that neither gathers nor spreads, the cross product of the gradients of two
// simplex noises. Particles in it stay on the surfaces on which both noises are constant.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec3 n = hn_curl(vec3(uv * 8.0, 0.5), 7u);
//   returns  each component in [-31.1, 31.1], in squared noise per squared cell, once continuously differentiable
//            (HN_FIXED: in steps of 2^-16)
//   error    at most 2.02e-4 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.02e-2. From a cell at most 2.02e-4
//   period   2^32 cells per axis, or the tile's
//   cost     twice hn_simplex_d's
//   source   DeWolf, "Divergence-free noise", 2005; docs/reference/contract.md, section 15
HN_FN hn_vec3 hn_curl(hn_place3 place, hn_uint seed) {
  return hn_i_curl(hn_simplex_d(place, seed), hn_simplex_d(hn_i_between_points(place), hn_i_other_seed(seed)));
}
HN_FN hn_vec3 hn_curl(hn_vec3 p, hn_uint seed) { return hn_curl(hn_place(p), seed); }
HN_FN hn_vec3 hn_curl(hn_vec3 p) { return hn_curl(p, 0u); }

#endif
