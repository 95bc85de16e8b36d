// hashnoise: noise on the plane.
// SPDX-License-Identifier: MIT

#ifndef HN_NOISE2D_GLSL
#define HN_NOISE2D_GLSL

#include "gradient.glsl"

// What a corner with the gradient g adds at (x, y) from it.
HN_FN HN_HIGHP float hn_i_ramp(HN_HIGHP vec2 g, HN_HIGHP float x, HN_HIGHP float y) { return g.x * x + g.y * y; }

// Gradient noise on the square lattice, from a cell and a position in it: Perlin 2002 interpolant, hashed gradients.
// Names cells exactly where a float no longer can: far out in a large world, or in a world that moves with the viewer.
//   cell     the cell; its corners wrap at 2^32, or HN_PERIOD
//   f        position in the cell, in [0, 1]
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  [-1, 1] (proven bound 0.999985), mean 0, 0 at lattice points, twice continuously differentiable; with
//            HN_GRADIENT_SINE, which is not scaled, [-1, 1] and the rest alike
//   error    at most 3.3e-6 against the exact value, in any rounding mode (docs/accuracy.md); HN_GRADIENT_SINE 4.4e-6
//   period   HN_PERIOD; without it 2^32 cells per axis (HN_HASH_PARTIAL_FNV1: 2^30 and 2^31,
//            with HN_GRADIENT_SINE no more than 2^31)
//   cost     6 hashes (none with HN_HASH_LATTICE); 12 integer multiplications to spread and mix, and 2 more for a seed
//            that is no constant. HN_GRADIENT_SINE: 6 hashes and 8 sines of 10 multiplications each
//   source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec2 cell, HN_HIGHP vec2 f, HN_HIGHP uint seed) {
  HN_HIGHP uvec2 c = hn_i_wrap(cell);
  HN_HIGHP uvec2 c0 = hn_i_place(c);
  HN_HIGHP uvec2 c1 = hn_i_place(hn_i_next(c));
  HN_HIGHP uint s = hn_i_mix(seed);
  HN_HIGHP uint k0 = hn_i_column(c0.x, s);
  HN_HIGHP uint k1 = hn_i_column(c1.x, s);
  HN_HIGHP vec2 d = f - 1.0f;
  HN_HIGHP vec2 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);  // 6 f^5 - 15 f^4 + 10 f^3, without cancellation
  HN_HIGHP float n00 = hn_i_ramp(hn_i_gradient(k0, c0.y, s), f.x, f.y);
  HN_HIGHP float n10 = hn_i_ramp(hn_i_gradient(k1, c0.y, s), d.x, f.y);
  HN_HIGHP float n01 = hn_i_ramp(hn_i_gradient(k0, c1.y, s), f.x, d.y);
  HN_HIGHP float n11 = hn_i_ramp(hn_i_gradient(k1, c1.y, s), d.x, d.y);
  HN_HIGHP float n0 = n00 + t.x * (n10 - n00);
  HN_HIGHP float n1 = n01 + t.x * (n11 - n01);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  // 1 / 0.535276, rounded down: the largest that a sum of ramps of such gradients can be (tools/bounds.py).
  return (n0 + t.y * (n1 - n0)) * (1913.0f / 1024.0f);
#else
  return n0 + t.y * (n1 - n0);
#endif
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP ivec2 cell, HN_HIGHP vec2 f) { return hn_perlin(cell, f, 0u); }

// The same at a position.
//   p        position, in cells; |p| < 2^23 along each axis (beyond, a float has no fraction)
//   seed     any uint, 0 if left out
//   returns  as above
//   error    at most 3.51e-6; HN_GRADIENT_SINE 4.58e-6
//   cost     as above
HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec2 p, HN_HIGHP uint seed) {
  HN_HIGHP vec2 cell = floor(p);
  return hn_perlin(ivec2(cell), p - cell, seed);
}

HN_FN HN_HIGHP float hn_perlin(HN_HIGHP vec2 p) { return hn_perlin(p, 0u); }

#endif
