// hashnoise: noise in space.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE3D_GLSL
#define HN_NOISE3D_GLSL

#include "gradient.glsl"

// What a corner with the gradient g adds at (x, y, z) from it.
HN_FN HN_HIGHP float hn_i_ramp(HN_HIGHP vec3 g, HN_HIGHP float x, HN_HIGHP float y, HN_HIGHP float z) {
  return g.x * x + g.y * y + g.z * z;
}

// Gradient noise on the cubic lattice, from a cell and a position in it: Perlin 2002 interpolant, hashed gradients.
// Names cells exactly where a float no longer can: far out in a large world, or in a world that moves with the viewer.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.99992), mean 0, 0 at lattice points, twice continuously differentiable; with
//            HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2] and the rest alike
//   error    at most 5.1e-6 against the exact value, in any rounding mode (docs/accuracy.md); HN_GRADIENT_SINE 7.8e-6
//   period   HN_PERIOD; without it 2^32 cells per axis (HN_HASH_PARTIAL_FNV1: 2^29, 2^30 and
//            2^31, with HN_GRADIENT_SINE no more than 2^31)
//   cost     14 hashes (none with HN_HASH_LATTICE); 22 integer multiplications to spread and mix, and 2 more for a seed
//            that is no constant. HN_GRADIENT_SINE: 14 hashes and 24 sines of 10 multiplications each
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec3 cell, HN_HIGHP vec3 f, HN_HIGHP uint seed) {
  HN_HIGHP uvec3 c = hn_i_wrap(cell);
  HN_HIGHP uvec3 c0 = hn_i_place(c);
  HN_HIGHP uvec3 c1 = hn_i_place(hn_i_next(c));
  HN_HIGHP uint s = hn_i_mix(seed);
  HN_HIGHP uint k0 = hn_i_column(c0.x, s);
  HN_HIGHP uint k1 = hn_i_column(c1.x, s);
  HN_HIGHP uint k00 = hn_i_row(k0, c0.y);
  HN_HIGHP uint k10 = hn_i_row(k1, c0.y);
  HN_HIGHP uint k01 = hn_i_row(k0, c1.y);
  HN_HIGHP uint k11 = hn_i_row(k1, c1.y);
  HN_HIGHP vec3 d = f - 1.0f;
  HN_HIGHP vec3 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);  // 6 f^5 - 15 f^4 + 10 f^3, without cancellation

  HN_HIGHP float n000 = hn_i_ramp(hn_i_gradient(k0, k00, c0.z, s), f.x, f.y, f.z);
  HN_HIGHP float n100 = hn_i_ramp(hn_i_gradient(k1, k10, c0.z, s), d.x, f.y, f.z);
  HN_HIGHP float n010 = hn_i_ramp(hn_i_gradient(k0, k01, c0.z, s), f.x, d.y, f.z);
  HN_HIGHP float n110 = hn_i_ramp(hn_i_gradient(k1, k11, c0.z, s), d.x, d.y, f.z);
  HN_HIGHP float n001 = hn_i_ramp(hn_i_gradient(k0, k00, c1.z, s), f.x, f.y, d.z);
  HN_HIGHP float n101 = hn_i_ramp(hn_i_gradient(k1, k10, c1.z, s), d.x, f.y, d.z);
  HN_HIGHP float n011 = hn_i_ramp(hn_i_gradient(k0, k01, c1.z, s), f.x, d.y, d.z);
  HN_HIGHP float n111 = hn_i_ramp(hn_i_gradient(k1, k11, c1.z, s), d.x, d.y, d.z);

  HN_HIGHP float n00 = n000 + t.x * (n100 - n000);
  HN_HIGHP float n10 = n010 + t.x * (n110 - n010);
  HN_HIGHP float n01 = n001 + t.x * (n101 - n001);
  HN_HIGHP float n11 = n011 + t.x * (n111 - n011);
  HN_HIGHP float n0 = n00 + t.y * (n10 - n00);
  HN_HIGHP float n1 = n01 + t.y * (n11 - n01);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // 1 / 0.562902, rounded down: the largest that a sum of ramps of such gradients can be (tools/bounds.py).
  return (n0 + t.z * (n1 - n0)) * (1819.0f / 1024.0f);
#else
  return n0 + t.z * (n1 - n0);
#endif
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec3 cell, HN_HIGHP vec3 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint, 0 if left out
//   returns  as above
//   error    at most 5.43e-6; HN_GRADIENT_SINE 8.2e-6
//   cost     as above
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec3 p, HN_HIGHP uint seed) {
  HN_HIGHP vec3 cell = floor(p);
  return hn_perlin(ivec3(cell), p - cell, seed);
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec3 p) { return hn_perlin(p, 0u); }

#endif
