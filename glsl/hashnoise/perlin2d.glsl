// hashnoise: Perlin noise on the plane.
// To read it in one piece: docs/reference/snippets/hn_perlin2.md
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN2D_GLSL
#define HN_PERLIN2D_GLSL

#include "detail/direction.glsl"
#if HN_GRADIENT == HN_GRADIENT_SINE
#include "detail/sine_gradient.glsl"
#endif

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_i_num hn_i_perlin(hn_i_cell_corners2 corners, hn_i_num2 f, hn_uint seed) {
  hn_i_num4 n = hn_i_ramps(corners, f, seed);
  hn_i_num2 t = hn_i_fade(f);
  return hn_i_scaled2(hn_i_bilerp_ramps2(n, t.x, t.y));
}

// Perlin noise on the plane: smooth hills and valleys, about one to a cell, and 0 at whole positions. It is gradient
// noise on the square lattice, with the interpolant of 2002 and hashed gradients.
//   p        position, in cells: a coordinate times a frequency, so that a cell is as large as a hill or a valley. Less
//            than 2^23 along each axis: larger floats have no fraction
//   place    in place of p: hn_place(cell, f) far from the origin, or hn_tile(p, period) for a tile (place.glsl)
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  float n = hn_perlin(uv * 8.0, 7u);
//   returns  [-1, 1] (proven bound 0.90913), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21); with HN_GRADIENT_SINE, which is not scaled, [-1, 1] and the rest alike
//   error    at most 2.67e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md);
//            HN_GRADIENT_SINE 2.42e-6. HN_FIXED 4.30e-5; HN_GRADIENT_SINE 7.99e-5. From a cell at most 2.44e-6;
//            HN_GRADIENT_SINE 2.42e-6
//   period   2^32 cells per axis, or the tile's (HN_GRADIENT_SINE with HN_HASH_PARTIAL_FNV1: no more than 2^31)
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is not constant. HN_GRADIENT_SINE: 6 hashes and 8 sines of 10 multiplications each, 6 of
//            them of floats
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_place2 place, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell_corners(place), place.fraction, seed));
}
HN_FN hn_float hn_perlin(hn_vec2 p, hn_uint seed) { return hn_perlin(hn_place(p), seed); }
HN_FN hn_float hn_perlin(hn_vec2 p) { return hn_perlin(p, 0u); }

#endif
