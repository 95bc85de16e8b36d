// hashnoise: vectors of Perlin noise and their derivatives in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_VECTOR_D3D_GLSL
#define HN_PERLIN_VECTOR_D3D_GLSL

#include "perlin_d3d.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Three independent Perlin noises and their slopes, from one hash for each corner: the value of hn_perlin_vector with
// its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  hn_derivatives3x3 n = hn_perlin_vector_d(vec3(uv * 8.0, 0.5), 7u);
//   returns  value, and in dx, dy and dz its derivatives along x, y and z. A derivative is per cell, in [-3.61, 3.61],
//            once continuously differentiable (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin_vector's, and of a derivative at most 1.17e-5 against the exact value, in any rounding
//            mode (docs/measured/accuracy.md). HN_FIXED 2.28e-4. From a cell at most 1.04e-5
//   period   2^32 cells per axis, or the tile's
//   cost     hn_perlin_d's, and twice the same again without the hashes; for each corner two multiplications more
//   source   the product rule on the interpolation; docs/reference/contract.md, section 22
HN_FN hn_derivatives3x3 hn_perlin_vector_d(hn_place3 place, hn_uint seed) {
  hn_i_cell_corners3 corners = hn_i_cell_corners(place);
  hn_uvec4 a = hn_i_corner_hashes(corners, false, seed);
  hn_uvec4 b = hn_i_corner_hashes(corners, true, seed);
  hn_i_num3 f = place.fraction;
  hn_i_num3 t = hn_i_fade(f);
  hn_i_num3 s = hn_i_d_fade(f);
  hn_vec4 x = hn_i_scaled_perlin_d(hn_i_perlin_d(a, b, f, t, s, false));
  hn_vec4 y = hn_i_scaled_perlin_d(hn_i_perlin_d(hn_i_hashes_of_y(a), hn_i_hashes_of_y(b), f, t, s, false));
  hn_vec4 z = hn_i_scaled_perlin_d(hn_i_perlin_d(hn_i_hashes_of_z(a), hn_i_hashes_of_z(b), f, t, s, false));
  return hn_i_of_components(x, y, z);
}
HN_FN hn_derivatives3x3 hn_perlin_vector_d(hn_vec3 p, hn_uint seed) { return hn_perlin_vector_d(hn_place(p), seed); }
HN_FN hn_derivatives3x3 hn_perlin_vector_d(hn_vec3 p) { return hn_perlin_vector_d(p, 0u); }

#endif
#endif
