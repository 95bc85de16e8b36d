// hashnoise: vectors of Perlin noise and their derivatives on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_VECTOR_D2D_GLSL
#define HN_PERLIN_VECTOR_D2D_GLSL

#include "perlin_d2d.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Two independent Perlin noises and their slopes, from one hash for each corner: the value of hn_perlin_vector with its
// derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  hn_derivatives2x2 n = hn_perlin_vector_d(uv * 8.0, 7u);
//   returns  value, and in dx and dy its derivatives along x and y. A derivative is per cell, in [-2.91, 2.91], once
//            continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin_vector's, and of a derivative at most 9.48e-6 against the exact value, in any rounding
//            mode (docs/measured/accuracy.md). HN_FIXED 2.01e-4. From a cell at most 9.00e-6
//   period   2^32 cells per axis, or the tile's
//   cost     hn_perlin_d's, and the same again without the hashes; for each corner a multiplication more
//   source   the product rule on the interpolation; docs/reference/contract.md, section 22
HN_FN hn_derivatives2x2 hn_perlin_vector_d(hn_place2 place, hn_uint seed) {
  hn_uvec4 h = hn_i_corner_hashes(hn_i_cell_corners(place), seed);
  hn_i_num2 f = place.fraction;
  return hn_i_of_components(hn_i_perlin_d(h, f), hn_i_perlin_d(hn_i_hashes_of_y(h), f));
}
HN_FN hn_derivatives2x2 hn_perlin_vector_d(hn_vec2 p, hn_uint seed) { return hn_perlin_vector_d(hn_place(p), seed); }
HN_FN hn_derivatives2x2 hn_perlin_vector_d(hn_vec2 p) { return hn_perlin_vector_d(p, 0u); }

#endif
#endif
