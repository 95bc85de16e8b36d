// hashnoise: curl noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_CURL2D_GLSL
#define HN_CURL2D_GLSL

#include "simplex_d2d.glsl"

// A zero must not become -0. The negative of 0 would be -0, and some drivers turn a difference from 0 into a negative.
HN_FN hn_vec2 hn_i_curl(hn_vec3 d) { return vec2(d.z, hn_i_select(d.y == 0.0f, 0.0f, -d.y)); }

// The curl of hn_simplex on the plane: a field of velocities that neither flows together nor apart. What it carries
// turns round the hills and hollows of the noise, along lines of equal height.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   place    a place in its stead: hn_place(cell, f), hn_tile(p, period) and so on (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  the derivative of hn_simplex along y, and its negative derivative along x: per cell, each in [-8.46,
//            8.46], once continuously differentiable (HN_FIXED: in steps of 2^-18)
//   error    that of the derivatives of hn_simplex_d: at most 5.15e-5. HN_FIXED 2.49e-3. From a cell at most 4.45e-5
//   period   2^31 cells per axis, or that of the tile
//   cost     that of hn_simplex_d
//   source   Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid flow", 2007
HN_FN hn_vec2 hn_curl(hn_place2 place, hn_uint seed) { return hn_i_curl(hn_simplex_d(place, seed)); }
HN_FN hn_vec2 hn_curl(hn_vec2 p, hn_uint seed) { return hn_curl(hn_place(p), seed); }
HN_FN hn_vec2 hn_curl(hn_vec2 p) { return hn_curl(p, 0u); }

#endif
