// hashnoise: Perlin noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_PERLIN3D_GLSL
#define HN_PERLIN3D_GLSL

#include "gradient.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_perlin(hn_i_box3 box, hn_num3 f, hn_uint seed) {
  hn_num3 t = hn_i_fade(f);
  hn_num front = hn_i_lerp(hn_i_ramps(box, f, false, seed), t.x, t.y);
  hn_num back = hn_i_lerp(hn_i_ramps(box, f, true, seed), t.x, t.y);
  return hn_i_scaled3(hn_i_lerp(front, back, t.z));
}

// Gradient noise on the cubic lattice, from a cell and a position in it: Perlin 2002 interpolant, hashed gradients.
// It names cells exactly where a float no longer can: far out in a large world, or in one that moves with the viewer.
//   cell     the cell; its corners wrap at 2^32
//   f        position in the cell, in [0, 1]; outside of it HN_FIXED takes the nearer end, and floats extrapolate
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99936), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21); with HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2] and the rest alike
//   error    at most 4.16e-6 against the exact value, in any rounding mode (docs/accuracy.md); HN_GRADIENT_SINE
//            7.70e-6. HN_FIXED 5.73e-5; HN_GRADIENT_SINE 1.40e-4
//   period   2^32 cells per axis (HN_GRADIENT_SINE with HN_HASH_PARTIAL_FNV1: no more than 2^31)
//   cost     8 hashes (none with HN_HASH_LATTICE) and 8 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is not constant. HN_GRADIENT_SINE: 14 hashes and 24 sines of 10 multiplications each, 6 of
//            them of floats
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_ivec3 cell, hn_vec3 f, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_box(cell), hn_i_inside(f), seed));
}

HN_FN hn_float hn_perlin(hn_ivec3 cell, hn_vec3 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint: 7u, not 7; 0 if left out
//   returns  as above
//   error    at most 4.45e-6; HN_GRADIENT_SINE 8.12e-6. HN_FIXED as above
//   period   as above
//   cost     as above
//   source   as above
HN_FN hn_float hn_perlin(hn_vec3 p, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_box(hn_i_cell(p)), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_perlin(hn_vec3 p) { return hn_perlin(p, 0u); }

// Both with a period: the field repeats after that many cells. Its values are those at the corners modulo the period.
//   period   cells along each axis, any ivec3; 0 for none along that axis. Less than 0 is none, too
//   seed     any uint: 7u, not 7
//   error    as without a period
//   cost     a mask along each axis more for a constant power of two; else a division. Each axis has one comparison
//            more
HN_FN hn_float hn_perlin(hn_ivec3 cell, hn_vec3 f, hn_ivec3 period, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_box(cell, period), hn_i_inside(f), seed));
}

HN_FN hn_float hn_perlin(hn_vec3 p, hn_ivec3 period, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_box(hn_i_cell(p), period), hn_i_fraction(p), seed));
}

#endif
