// hashnoise: vectors of value noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_VECTOR2D_GLSL
#define HN_VALUE_VECTOR2D_GLSL

#include "detail/cell2d.glsl"
#include "detail/value.glsl"

// Two independent value noises from one hash for each corner: for displacements, for the two parts of a flow, for two
// colours.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec2 n = hn_value_vector(uv * 8.0, 7u);
//   returns  along x hn_value, and along y another such noise, each in [-1, 1], mean 0, twice continuously
//            differentiable (HN_FIXED: in steps of 2^-21)
//   error    of each at most 3.24e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md).
//            HN_FIXED 4.42e-5. From a cell at most 3.14e-6
//   period   2^32 cells per axis, or the tile's
//   cost     hn_value's, and for each corner a multiplication more
//   source   Perlin, "Improving noise", 2002, for the interpolant; docs/reference/contract.md, section 22
HN_FN hn_vec2 hn_value_vector(hn_place2 place, hn_uint seed) {
  hn_uvec4 h = hn_i_corner_hashes(hn_i_cell_corners(place), seed);
  hn_i_num2 t = hn_i_fade(place.fraction);
  return vec2(hn_i_value(hn_i_value_noise(h, t)), hn_i_value(hn_i_value_noise(hn_i_hashes_of_y(h), t)));
}
HN_FN hn_vec2 hn_value_vector(hn_vec2 p, hn_uint seed) { return hn_value_vector(hn_place(p), seed); }
HN_FN hn_vec2 hn_value_vector(hn_vec2 p) { return hn_value_vector(p, 0u); }

#endif
