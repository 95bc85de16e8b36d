// hashnoise: noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE3D_GLSL
#define HN_NOISE3D_GLSL

#include "gradient.glsl"

// The noise in the numbers of HN_ARITHMETIC.
HN_FN HN_HIGHP HN_I_NUMBER hn_i_perlin(HN_HIGHP ivec3 cell, HN_HIGHP HN_I_NUMBER3 f, HN_HIGHP uint seed) {
  HN_HIGHP uvec3 c = hn_i_wrap(cell);
  HN_HIGHP uint s = hn_i_mix(seed);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // The two joins of the corners' coordinates (hash.glsl): a and b of the near and the far ones; odd of the near
  // corner, and what a step along each axis adds to it.
  HN_HIGHP uvec3 c0 = hn_i_spread(c);
  HN_HIGHP uvec3 c1 = hn_i_spread_next(c0, c);
  HN_HIGHP uvec3 a = hn_i_fold(c0);
  HN_HIGHP uvec3 b = hn_i_fold(c1);
  HN_HIGHP uint odd = hn_i_odd(c0.x + c0.y + c0.z + s);
  HN_HIGHP uint x = (c1.x - c0.x) * 2u;
  HN_HIGHP uint y = (c1.y - c0.y) * 2u;
  HN_HIGHP uint z = (c1.z - c0.z) * 2u;
  a.x ^= s;
  b.x ^= s;
  HN_HIGHP uint k00 = a.x ^ a.y;
  HN_HIGHP uint k10 = b.x ^ a.y;
  HN_HIGHP uint k01 = a.x ^ b.y;
  HN_HIGHP uint k11 = b.x ^ b.y;
  // The sum and the difference of the offsets along x and y, and twice that along z (hn_i_ramp), at each corner.
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER u = f.x + f.y;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER v = f.x - f.y;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER w = f.z + f.z;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER u1 = u - HN_I_ONE;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER u2 = u - (HN_I_ONE + HN_I_ONE);
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER v10 = v - HN_I_ONE;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER v01 = v + HN_I_ONE;
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER w1 = w - (HN_I_ONE + HN_I_ONE);
  HN_HIGHP HN_I_NUMBER n000 = hn_i_ramp(hn_i_word(k00 ^ a.z, odd), u, v, w);
  HN_HIGHP HN_I_NUMBER n100 = hn_i_ramp(hn_i_word(k10 ^ a.z, odd + x), u1, v10, w);
  HN_HIGHP HN_I_NUMBER n010 = hn_i_ramp(hn_i_word(k01 ^ a.z, odd + y), u1, v01, w);
  HN_HIGHP HN_I_NUMBER n110 = hn_i_ramp(hn_i_word(k11 ^ a.z, odd + (x + y)), u2, v, w);
  HN_HIGHP HN_I_NUMBER n001 = hn_i_ramp(hn_i_word(k00 ^ b.z, odd + z), u, v, w1);
  HN_HIGHP HN_I_NUMBER n101 = hn_i_ramp(hn_i_word(k10 ^ b.z, odd + (x + z)), u1, v10, w1);
  HN_HIGHP HN_I_NUMBER n011 = hn_i_ramp(hn_i_word(k01 ^ b.z, odd + (y + z)), u1, v01, w1);
  HN_HIGHP HN_I_NUMBER n111 = hn_i_ramp(hn_i_word(k11 ^ b.z, odd + (x + y + z)), u2, v, w1);
#else
  HN_HIGHP uvec3 c1 = hn_i_next(c);
  HN_HIGHP uint k0 = hn_i_column(c.x, s);
  HN_HIGHP uint k1 = hn_i_column(c1.x, s);
  HN_HIGHP uint k00 = hn_i_row(k0, c.y);
  HN_HIGHP uint k10 = hn_i_row(k1, c.y);
  HN_HIGHP uint k01 = hn_i_row(k0, c1.y);
  HN_HIGHP uint k11 = hn_i_row(k1, c1.y);
  HN_I_PRECISE HN_HIGHP HN_I_NUMBER3 d = f - HN_I_ONE;
  HN_HIGHP HN_I_NUMBER n000 = hn_i_ramp(hn_i_gradient(k0, k00, c.z), f.x, f.y, f.z);
  HN_HIGHP HN_I_NUMBER n100 = hn_i_ramp(hn_i_gradient(k1, k10, c.z), d.x, f.y, f.z);
  HN_HIGHP HN_I_NUMBER n010 = hn_i_ramp(hn_i_gradient(k0, k01, c.z), f.x, d.y, f.z);
  HN_HIGHP HN_I_NUMBER n110 = hn_i_ramp(hn_i_gradient(k1, k11, c.z), d.x, d.y, f.z);
  HN_HIGHP HN_I_NUMBER n001 = hn_i_ramp(hn_i_gradient(k0, k00, c1.z), f.x, f.y, d.z);
  HN_HIGHP HN_I_NUMBER n101 = hn_i_ramp(hn_i_gradient(k1, k10, c1.z), d.x, f.y, d.z);
  HN_HIGHP HN_I_NUMBER n011 = hn_i_ramp(hn_i_gradient(k0, k01, c1.z), f.x, d.y, d.z);
  HN_HIGHP HN_I_NUMBER n111 = hn_i_ramp(hn_i_gradient(k1, k11, c1.z), d.x, d.y, d.z);
#endif
  HN_HIGHP HN_I_NUMBER3 t = hn_i_fade(f);
  HN_HIGHP HN_I_NUMBER n0 = hn_i_lerp(hn_i_lerp(n000, n100, t.x), hn_i_lerp(n010, n110, t.x), t.y);
  HN_HIGHP HN_I_NUMBER n1 = hn_i_lerp(hn_i_lerp(n001, n101, t.x), hn_i_lerp(n011, n111, t.x), t.y);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // 1 / 0.562902, rounded down: the largest that a sum of ramps of such gradients can be (tools/bounds.py).
  return hn_i_scaled(hn_i_lerp(n0, n1, t.z), HN_I_NUMBER(1819));
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
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec3 cell, HN_HIGHP vec3 f, HN_HIGHP uint seed) {
  return hn_i_value(hn_i_perlin(cell, hn_i_inside(f), seed));
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec3 cell, HN_HIGHP vec3 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint, 0 if left out
//   returns  as above
//   error    at most 5.54e-6; HN_GRADIENT_SINE 8.2e-6. HN_FIXED as above
//   cost     as above
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec3 p, HN_HIGHP uint seed) {
  return hn_i_value(hn_i_perlin(hn_i_cell(p), hn_i_fraction(p), seed));
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec3 p) { return hn_perlin(p, 0u); }

#endif
