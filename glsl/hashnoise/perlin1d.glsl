// hashnoise: Perlin noise on the line.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN1D_GLSL
#define HN_PERLIN1D_GLSL

#include "detail/cell.glsl"
#include "detail/direction.glsl"

// The paper's gradient has no noise on the line.
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_perlin(hn_i_box1 box, hn_i_num f, hn_uint seed) {
  hn_uvec2 h = hn_i_corners(box, seed);
  hn_i_num left = hn_i_ramp1(hn_i_gradient1(h.x), f);
  hn_i_num right = hn_i_ramp1(hn_i_gradient1(h.y), hn_i_minus_one(f));
  return hn_i_scaled1(hn_i_lerp(left, right, hn_i_fade(f)));
}

// Gradient noise on the integers: Perlin 2002 interpolant, hashed gradients.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   place    a place in its stead: hn_place(cell, f), hn_tile(p, period) and so on (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99805), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21)
//   error    at most 1.62e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED 3.71e-5.
//            From a cell at most 1.46e-6
//   period   2^32 cells
//   cost     2 hashes (none with HN_HASH_LATTICE) and 2 multiplications; 1 more to spread the coordinate, and 2 more
//            for a seed that is not constant
//   source   Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_place1 place, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_box(place), place.fraction, seed));
}
HN_FN hn_float hn_perlin(hn_float p, hn_uint seed) { return hn_perlin(hn_place(p), seed); }
HN_FN hn_float hn_perlin(hn_float p) { return hn_perlin(p, 0u); }

#endif
#endif
