// hashnoise: vectors of Perlin noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_VECTOR3D_GLSL
#define HN_PERLIN_VECTOR3D_GLSL

#include "detail/direction3d.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// Three independent Perlin noises from one hash for each corner: for displacements, for the parts of a flow.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec3 n = hn_perlin_vector(vec3(uv * 8.0, 0.5), 7u);
//   returns  along x hn_perlin, and along y and z other such noises, each in [-1, 1] (proven bound 0.99689), mean 0, 0
//            at lattice points, twice continuously differentiable (HN_FIXED: in steps of 2^-21)
//   error    of each at most 3.40e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md).
//            HN_FIXED 5.40e-5. From a cell at most 3.40e-6
//   period   2^32 cells per axis, or the tile's
//   cost     hn_perlin's, and twice the same again without the hashes; for each corner two multiplications more
//   source   Perlin, "Improving noise", 2002; docs/reference/contract.md, section 22
HN_FN hn_vec3 hn_perlin_vector(hn_place3 place, hn_uint seed) {
  hn_i_cell_corners3 corners = hn_i_cell_corners(place);
  hn_uvec4 a = hn_i_corner_hashes(corners, false, seed);
  hn_uvec4 b = hn_i_corner_hashes(corners, true, seed);
  hn_i_num3 f = place.fraction;
  hn_i_num3 t = hn_i_fade(f);
  return vec3(hn_i_value(hn_i_scaled3(hn_i_cell_of_ramps(a, b, f, t, false))),
              hn_i_value(hn_i_scaled3(hn_i_cell_of_ramps(hn_i_hashes_of_y(a), hn_i_hashes_of_y(b), f, t, false))),
              hn_i_value(hn_i_scaled3(hn_i_cell_of_ramps(hn_i_hashes_of_z(a), hn_i_hashes_of_z(b), f, t, false))));
}
HN_FN hn_vec3 hn_perlin_vector(hn_vec3 p, hn_uint seed) { return hn_perlin_vector(hn_place(p), seed); }
HN_FN hn_vec3 hn_perlin_vector(hn_vec3 p) { return hn_perlin_vector(p, 0u); }

#endif
#endif
