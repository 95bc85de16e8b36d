// hashnoise: curl noise on the plane that changes with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL_PHASE2D_GLSL
#define HN_CURL_PHASE2D_GLSL

#include "curl2d.glsl"
#include "simplex_phase2d.glsl"

// The rotations of a phase, which all octaves of a sum share.
#define hn_i_curl_rotation2 hn_i_num2
HN_FN hn_i_curl_rotation2 hn_i_new_curl_rotation2(hn_float phase) { return hn_i_rotation(phase); }

HN_FN hn_vec2 hn_i_curl(hn_place2 place, hn_i_curl_rotation2 rotation, hn_uint seed) {
  return hn_i_curl(hn_i_simplex_phase_d(place, rotation, seed));
}

// Curl noise on the plane that changes with a phase: a flow without divergence that evolves in place, and loops after
// one turn.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   phase    in turns, any float: the field of phase + 1 has the same bits, and at phase + 1/2 it is the negative
//            (HN_FIXED: but for the last bits). A float far from 0 has few bits left for the turn: pass fract(phase)
//   seed     any uint: 7u, not 7; different seeds give independent fields
//   example  vec2 n = hn_curl(uv * 8.0, 0.25, 7u);
//   returns  the derivative along y of hn_simplex with the phase, and its negative derivative along x: per cell, each
//            in [-8.64, 8.64], once continuously differentiable, and smooth in the phase
//   error    at most 3.78e-5. HN_FIXED 3.02e-3
//   period   2^31 cells per axis, or the tile's
//   cost     hn_simplex_d's with a phase
//   source   Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid flow", 2007; Perlin and Neyret, "Flow
//            noise", 2001; docs/reference/contract.md, section 15
HN_FN hn_vec2 hn_curl(hn_place2 place, hn_float phase, hn_uint seed) {
  return hn_i_curl(place, hn_i_new_curl_rotation2(phase), seed);
}
HN_FN hn_vec2 hn_curl(hn_vec2 p, hn_float phase, hn_uint seed) { return hn_curl(hn_place(p), phase, seed); }

#endif
