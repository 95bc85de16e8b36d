// hashnoise: Perlin noise and its derivatives on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN_D1D_GLSL
#define HN_PERLIN_D1D_GLSL

#include "detail/cell.glsl"
#include "detail/derivative.glsl"
#include "detail/direction.glsl"

// The paper's gradient has no noise of this kind.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The noise and its derivative.
HN_FN hn_vec2 hn_i_perlin_d(hn_i_cell_corners1 corners, hn_i_num f, hn_uint seed) {
  hn_uvec2 h = hn_i_corner_hashes(corners, seed);
  hn_i_num a = hn_i_gradient1(h.x);
  hn_i_num b = hn_i_gradient1(h.y);
  hn_i_num left = hn_i_ramp1(a, f);
  hn_i_num right = hn_i_ramp1(b, hn_i_minus_one(f));
  hn_i_num t = hn_i_fade(f);
  hn_i_num slope = hn_i_d_faded(hn_i_lerp(a, b, t), hn_i_d_corner(left, right), hn_i_d_fade(f));
  return vec2(hn_i_value(hn_i_scaled1(hn_i_lerp(left, right, t))), hn_i_derivative(hn_i_scaled1(slope)));
}

// Perlin noise on the line and its slope: the value of hn_perlin with its derivatives.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  vec2 n = hn_perlin_d(uv.x * 8.0, 7u);
//   returns  the value and its derivative. A derivative is per cell, in [-2.69, 2.69], once continuously differentiable
//            (HN_FIXED: in steps of 2^-19)
//   error    hn_perlin's, and of a derivative at most 5.36e-6 against the exact value, in any rounding mode
//            (docs/measured/accuracy.md). HN_FIXED 1.72e-4. From a cell at most 4.72e-6
//   period   2^32 cells, or the tile's
//   cost     the hashes of hn_perlin, which are most of its cost, and about twice the rest
//   source   the product rule on the interpolation; docs/reference/contract.md, section 10
HN_FN hn_vec2 hn_perlin_d(hn_place1 place, hn_uint seed) {
  return hn_i_perlin_d(hn_i_cell_corners(place), place.fraction, seed);
}
HN_FN hn_vec2 hn_perlin_d(hn_float p, hn_uint seed) { return hn_perlin_d(hn_place(p), seed); }
HN_FN hn_vec2 hn_perlin_d(hn_float p) { return hn_perlin_d(p, 0u); }

#endif
#endif
