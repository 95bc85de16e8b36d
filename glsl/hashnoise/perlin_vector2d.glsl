// hashnoise: vectors of Perlin noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_VECTOR2D_GLSL
#define HN_PERLIN_VECTOR2D_GLSL

#include "detail/direction.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Two independent Perlin noises from one hash for each corner: for displacements, for the two parts of a flow.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec2 n = hn_perlin_vector(uv * 8.0, 7u);
//   returns  along x hn_perlin, and along y another such noise, each in [-1, 1] (proven bound 0.90913), mean 0, 0 at
//            lattice points, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    of each at most 2.67e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md).
//            HN_FIXED 4.30e-5. From a cell at most 2.44e-6
//   period   2^32 cells per axis, or the tile's
//   cost     hn_perlin's, and the same again without the hashes; for each corner a multiplication more
//   source   Perlin, "Improving noise", 2002; docs/reference/contract.md, section 22
HN_FN hn_vec2 hn_perlin_vector(hn_place2 place, hn_uint seed) {
  hn_uvec4 h = hn_i_corner_hashes(hn_i_cell_corners(place), seed);
  hn_i_num2 f = place.fraction;
  hn_i_num2 t = hn_i_fade(f);
  return vec2(hn_i_value(hn_i_scaled2(hn_i_cell_of_ramps(h, f, t, false))),
              hn_i_value(hn_i_scaled2(hn_i_cell_of_ramps(hn_i_hashes_of_y(h), f, t, false))));
}
HN_FN hn_vec2 hn_perlin_vector(hn_vec2 p, hn_uint seed) { return hn_perlin_vector(hn_place(p), seed); }
HN_FN hn_vec2 hn_perlin_vector(hn_vec2 p) { return hn_perlin_vector(p, 0u); }

#endif
#endif
