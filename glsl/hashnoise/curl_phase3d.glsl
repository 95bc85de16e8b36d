// hashnoise: curl noise in space that changes with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_PHASE3D_GLSL
#define HN_CURL_PHASE3D_GLSL

#include "curl3d.glsl"
#include "simplex_phase3d.glsl"

// The rotation by an angle in units of 2^-32 turns, as of hn_i_rotation3.
HN_FN hn_i_num2 hn_i_rotation3_by(hn_uint angle) {
  return hn_i_to_sixths(hn_i_rotation(hn_i_wave(angle + 0x40000000u, 0u), hn_i_wave(angle, 0u)));
}

// The rotations of a phase, which all octaves of a sum share: of the first noise, and then of the second, whose phase
// runs twice as fast. With the same phase in both their product would be the same after half a turn, and half of the
// flow would stand still.
#define hn_i_curl_rotation3 hn_i_num4
HN_FN hn_i_curl_rotation3 hn_i_new_curl_rotation3(hn_float phase) {
  hn_uint angle = hn_i_angle(phase);
  hn_i_num2 once = hn_i_rotation3_by(angle);
  hn_i_num2 twice = hn_i_rotation3_by(angle << 1u);
  return hn_i_vector(once.x, once.y, twice.x, twice.y);
}

HN_FN hn_vec3 hn_i_curl(hn_place3 place, hn_i_curl_rotation3 rotation, hn_uint seed) {
  hn_place3 moved = hn_i_between_points(place);
  return hn_i_curl(
      hn_i_simplex_phase_d(hn_i_neighbourhood(place), place.fraction, hn_i_vector(rotation.x, rotation.y), seed),
      hn_i_simplex_phase_d(hn_i_neighbourhood(moved), moved.fraction, hn_i_vector(rotation.z, rotation.w),
                           hn_i_other_seed(seed)));
}

// Curl noise in space that changes with a phase: a flow without divergence that evolves in place, and loops after one
// turn.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and at phase + 1/2 it is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  vec3 n = hn_curl(vec3(uv * 8.0, 0.5), 0.25, 7u);
//   returns  each component in [-34.1, 34.1], in squared noise per squared cell, once continuously differentiable, and
//            smooth in the phase (HN_FIXED: in steps of 2^-16)
//   error    at most 3.00e-4 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            1.22e-2
//   period   2^32 cells per axis, or the tile's
//   cost     twice hn_simplex_d's with a phase
//   source   DeWolf, "Divergence-free noise", 2005; Perlin and Neyret, "Flow noise", 2001;
//            docs/reference/contract.md, section 15
HN_FN hn_vec3 hn_curl(hn_place3 place, hn_float phase, hn_uint seed) {
  return hn_i_curl(place, hn_i_new_curl_rotation3(phase), seed);
}
HN_FN hn_vec3 hn_curl(hn_vec3 p, hn_float phase, hn_uint seed) { return hn_curl(hn_place(p), phase, seed); }

#endif
