// hashnoise: noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE3D_GLSL
#define HN_NOISE3D_GLSL

#include "gradient.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN hn_num hn_i_perlin(hn_ivec3 cell, hn_num3 f, hn_uint seed) {
  hn_uvec3 c = hn_i_wrap(cell);
  hn_uint s = hn_i_mix(seed);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // The two joins of the corners' coordinates (hash.glsl): a and b of the near and the far ones; odd of the near
  // corner, and what a step along each axis adds to it.
  hn_uvec3 c0 = hn_i_spread(c);
  hn_uvec3 c1 = hn_i_spread_next(c0, c);
  hn_uvec3 a = hn_i_fold(c0);
  hn_uvec3 b = hn_i_fold(c1);
  hn_uint odd = hn_i_odd(c0.x + c0.y + c0.z + s);
  hn_uint x = (c1.x - c0.x) * 2u;
  hn_uint y = (c1.y - c0.y) * 2u;
  hn_uint z = (c1.z - c0.z) * 2u;
  a.x ^= s;
  b.x ^= s;
  hn_uint k00 = a.x ^ a.y;
  hn_uint k10 = b.x ^ a.y;
  hn_uint k01 = a.x ^ b.y;
  hn_uint k11 = b.x ^ b.y;
  // The sum and the difference of the offsets along x and y, and twice that along z (hn_i_ramp), at each corner.
  HN_I_PRECISE hn_num u = f.x + f.y;
  HN_I_PRECISE hn_num v = f.x - f.y;
  HN_I_PRECISE hn_num w = f.z + f.z;
  HN_I_PRECISE hn_num u1 = u - HN_I_ONE;
  HN_I_PRECISE hn_num u2 = u - (HN_I_ONE + HN_I_ONE);
  HN_I_PRECISE hn_num v10 = v - HN_I_ONE;
  HN_I_PRECISE hn_num v01 = v + HN_I_ONE;
  HN_I_PRECISE hn_num w1 = w - (HN_I_ONE + HN_I_ONE);
  hn_num n000 = hn_i_ramp(hn_i_word(k00 ^ a.z, odd), u, v, w);
  hn_num n100 = hn_i_ramp(hn_i_word(k10 ^ a.z, odd + x), u1, v10, w);
  hn_num n010 = hn_i_ramp(hn_i_word(k01 ^ a.z, odd + y), u1, v01, w);
  hn_num n110 = hn_i_ramp(hn_i_word(k11 ^ a.z, odd + (x + y)), u2, v, w);
  hn_num n001 = hn_i_ramp(hn_i_word(k00 ^ b.z, odd + z), u, v, w1);
  hn_num n101 = hn_i_ramp(hn_i_word(k10 ^ b.z, odd + (x + z)), u1, v10, w1);
  hn_num n011 = hn_i_ramp(hn_i_word(k01 ^ b.z, odd + (y + z)), u1, v01, w1);
  hn_num n111 = hn_i_ramp(hn_i_word(k11 ^ b.z, odd + (x + y + z)), u2, v, w1);
#else
  hn_uvec3 c1 = hn_i_next(c);
  hn_uint k0 = hn_i_column(c.x, s);
  hn_uint k1 = hn_i_column(c1.x, s);
  hn_uint k00 = hn_i_row(k0, c.y);
  hn_uint k10 = hn_i_row(k1, c.y);
  hn_uint k01 = hn_i_row(k0, c1.y);
  hn_uint k11 = hn_i_row(k1, c1.y);
  HN_I_PRECISE hn_num3 d = f - HN_I_ONE;
  hn_num n000 = hn_i_ramp(hn_i_gradient(k0, k00, c.z), f.x, f.y, f.z);
  hn_num n100 = hn_i_ramp(hn_i_gradient(k1, k10, c.z), d.x, f.y, f.z);
  hn_num n010 = hn_i_ramp(hn_i_gradient(k0, k01, c.z), f.x, d.y, f.z);
  hn_num n110 = hn_i_ramp(hn_i_gradient(k1, k11, c.z), d.x, d.y, f.z);
  hn_num n001 = hn_i_ramp(hn_i_gradient(k0, k00, c1.z), f.x, f.y, d.z);
  hn_num n101 = hn_i_ramp(hn_i_gradient(k1, k10, c1.z), d.x, f.y, d.z);
  hn_num n011 = hn_i_ramp(hn_i_gradient(k0, k01, c1.z), f.x, d.y, d.z);
  hn_num n111 = hn_i_ramp(hn_i_gradient(k1, k11, c1.z), d.x, d.y, d.z);
#endif
  hn_num3 t = hn_i_fade(f);
  hn_num n0 = hn_i_lerp(hn_i_lerp(n000, n100, t.x), hn_i_lerp(n010, n110, t.x), t.y);
  hn_num n1 = hn_i_lerp(hn_i_lerp(n001, n101, t.x), hn_i_lerp(n011, n111, t.x), t.y);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // 1 / 0.562902, rounded down: the largest that a sum of ramps of such gradients can be (tools/bounds.py).
  return hn_i_scaled(hn_i_lerp(n0, n1, t.z), 1819);
#else
  return hn_i_unscaled(hn_i_lerp(n0, n1, t.z));
#endif
}

// Gradient noise on the cubic lattice, from a cell and a position in it: Perlin 2002 interpolant, hashed gradients.
// Names cells exactly where a float no longer can: far out in a large world, or in a world that moves with the viewer.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99992), mean 0, 0 at lattice points, twice continuously differentiable (HN_FIXED:
//            in steps of 2^-21); with HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2] and the rest alike
//   error    at most 5.2e-6 against the exact value, in any rounding mode (docs/accuracy.md); HN_GRADIENT_SINE 7.8e-6.
//            HN_FIXED 6.03e-5; HN_GRADIENT_SINE 1.40e-4
//   period   HN_PERIOD; without it 2^32 cells per axis (HN_GRADIENT_SINE with HN_HASH_PARTIAL_FNV1: no more than 2^31)
//   cost     8 hashes (none with HN_HASH_LATTICE) and 8 multiplications; 3 more to spread the coordinates, and 2 more
//            for a seed that is no constant. HN_GRADIENT_SINE: 14 hashes and 24 sines of 10 multiplications each
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN hn_float hn_perlin(hn_ivec3 cell, hn_vec3 f, hn_uint seed) {
  return hn_i_value(hn_i_perlin(cell, hn_i_inside(f), seed));
}

HN_FN hn_float hn_perlin(hn_ivec3 cell, hn_vec3 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint, 0 if left out
//   returns  as above
//   error    at most 5.54e-6; HN_GRADIENT_SINE 8.2e-6. HN_FIXED as above
//   cost     as above
HN_FN hn_float hn_perlin(hn_vec3 p, hn_uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN hn_float hn_perlin(hn_vec3 p) { return hn_perlin(p, 0u); }

#endif
