// hashnoise: noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE2D_GLSL
#define HN_NOISE2D_GLSL

#include "gradient.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_perlin(hn_ivec2 cell, hn_num2 f, hn_uint seed) {
  hn_uvec2 c = hn_i_wrap(cell);
  hn_uint s = hn_i_mix(seed);
  HN_I_PRECISE hn_num2 d = f - HN_I_ONE;
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // The two joins of the corners' coordinates (hash.glsl): a and b of the near and the far ones; odd of the near
  // corner, and what a step along each axis adds to it.
  hn_uvec2 c0 = hn_i_spread(c);
  hn_uvec2 c1 = hn_i_spread_next(c0, c);
  hn_uvec2 a = hn_i_fold(c0);
  hn_uvec2 b = hn_i_fold(c1);
  hn_uint odd = hn_i_odd(c0.x + c0.y + s);
  hn_uint x = (c1.x - c0.x) * 2u;
  hn_uint y = (c1.y - c0.y) * 2u;
  a.x ^= s;
  b.x ^= s;
  hn_num n00 = hn_i_ramp(hn_i_word(a.x ^ a.y, odd), f.x, f.y);
  hn_num n10 = hn_i_ramp(hn_i_word(b.x ^ a.y, odd + x), d.x, f.y);
  hn_num n01 = hn_i_ramp(hn_i_word(a.x ^ b.y, odd + y), f.x, d.y);
  hn_num n11 = hn_i_ramp(hn_i_word(b.x ^ b.y, odd + (x + y)), d.x, d.y);
#else
  hn_uvec2 c1 = hn_i_next(c);
  hn_uint k0 = hn_i_column(c.x, s);
  hn_uint k1 = hn_i_column(c1.x, s);
  hn_num n00 = hn_i_ramp(hn_i_gradient(k0, c.y), f.x, f.y);
  hn_num n10 = hn_i_ramp(hn_i_gradient(k1, c.y), d.x, f.y);
  hn_num n01 = hn_i_ramp(hn_i_gradient(k0, c1.y), f.x, d.y);
  hn_num n11 = hn_i_ramp(hn_i_gradient(k1, c1.y), d.x, d.y);
#endif
  hn_num2 t = hn_i_fade(f);
  hn_num n = hn_i_lerp(hn_i_lerp(n00, n10, t.x), hn_i_lerp(n01, n11, t.x), t.y);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // 1 / 0.535276, rounded down: the largest that a sum of ramps of such gradients can be (tools/bounds.py).
  return hn_i_scaled(n, 1913);
#else
  return hn_i_unscaled(n);
#endif
}

// Gradient noise on the square lattice, from a cell and a position in it: Perlin 2002 interpolant, hashed gradients.
// Names cells exactly where a float no longer can: far out in a large world, or in a world that moves with the viewer.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.999985), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21); with HN_GRADIENT_SINE, which is not scaled, [-1, 1] and the rest alike
//   error    at most 3.3e-6 against the exact value, in any rounding mode (docs/accuracy.md); HN_GRADIENT_SINE 4.4e-6.
//            HN_FIXED 4.90e-5; HN_GRADIENT_SINE 7.98e-5
//   period   HN_PERIOD; without it 2^32 cells per axis (HN_GRADIENT_SINE with HN_HASH_PARTIAL_FNV1: no more than 2^31)
//   cost     4 hashes (none with HN_HASH_LATTICE) and 4 multiplications; 2 more to spread the coordinates, and 2 more
//            for a seed that is no constant. HN_GRADIENT_SINE: 6 hashes and 8 sines of 10 multiplications each
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_ivec2 cell, hn_vec2 f, hn_uint seed) {
  return hn_i_value(hn_i_perlin(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_perlin(hn_ivec2 cell, hn_vec2 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint, 0 if left out
//   returns  as above
//   error    at most 3.51e-6; HN_GRADIENT_SINE 4.58e-6. HN_FIXED as above
//   cost     as above
HN_FN hn_float hn_perlin(hn_vec2 p, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_perlin(hn_vec2 p) { return hn_perlin(p, 0u); }

#endif
