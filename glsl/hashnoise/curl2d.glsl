// hashnoise: curl noise on the plane.
// To read it in one piece: docs/reference/snippets/hn_curl2.md
// SPDX-License-Identifier: MIT

#ifndef HN_CURL2D_GLSL
#define HN_CURL2D_GLSL

#include "simplex_d2d.glsl"

// A zero must not become -0. The negative of 0 would be -0, and some drivers turn a difference from 0 into a negative.
HN_FN hn_vec2 hn_i_curl(hn_vec3 d) { return vec2(d.z, hn_i_select(d.y == 0.0f, 0.0f, -d.y)); }

// Curl noise on the plane: velocities of a flow that neither gathers nor spreads. Particles in it circle the hills and
// hollows of hn_simplex, along lines of equal height.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec2 n = hn_curl(uv * 8.0, 7u);
//   returns  the derivative of hn_simplex along y, and its negative derivative along x: per cell, each in
//            [-8.46, 8.46], once continuously differentiable (HN_FIXED: in steps of 2^-18)
//   error    the error of derivatives of hn_simplex_d: at most 3.20e-5. HN_FIXED 2.49e-3. From a cell at most 2.64e-5
//   period   2^31 cells per axis, or the tile's
//   cost     hn_simplex_d's
//   source   Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid flow", 2007
HN_FN hn_vec2 hn_curl(hn_place2 place, hn_uint seed) { return hn_i_curl(hn_simplex_d(place, seed)); }
HN_FN hn_vec2 hn_curl(hn_vec2 p, hn_uint seed) { return hn_curl(hn_place(p), seed); }
HN_FN hn_vec2 hn_curl(hn_vec2 p) { return hn_curl(p, 0u); }

#endif
