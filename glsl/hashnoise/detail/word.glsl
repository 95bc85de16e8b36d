// hashnoise: the hash of a lattice point, for its random numbers and gradients; and integers as floats.
// SPDX-License-Identifier: MIT

#ifndef HN_WORD_GLSL
#define HN_WORD_GLSL

#include "../config.glsl"
#if HN_HASH != HN_HASH_LATTICE
#include "hashes.glsl"
#endif

// In GLSL ES a constructor has the precision of its argument. NVIDIA's driver takes the default of the scope instead:
// where that is mediump, float(100000) is infinite. So integers become floats here alone, in scopes of their own.
// vkd3d 2.1, with which Wine compiles HLSL, takes float(n) and uint(n) of one int for the same conversion, and makes
// another noise. An or with 0 keeps them apart; FXC leaves it out. With a mask vkd3d would take twice as long.
HN_FN hn_float hn_i_float(hn_int n) {
#ifdef HN_I_FXC
  return float(n | 0);
#else
  HN_I_HIGHP_HERE hn_float x = float(n);
  return x;
#endif
}
HN_FN hn_float hn_i_float(hn_uint n) {
#ifdef HN_I_FXC
  return float(n | 0u);
#else
  HN_I_HIGHP_HERE hn_float x = float(n);
  return x;
#endif
}

// Microsoft's FXC takes a whole number times a constant below 2^-19 for a whole number, and leaves out the floor() of
// it, also where users write it. It does not see what this does, which others leave out.
#ifdef HN_I_FXC
#define HN_I_NOT_WHOLE(x) uintBitsToFloat(floatBitsToUint(x) ^ 0u)
#else
#define HN_I_NOT_WHOLE(x) (x)
#endif

// The selected hash of one number.
#if HN_HASH == HN_HASH_FNV1
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_fnv1(k); }
#elif HN_HASH == HN_HASH_PARTIAL_FNV1
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_partial_fnv1(k); }
#elif HN_HASH == HN_HASH_JENKINS
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_jenkins(k); }
#elif HN_HASH == HN_HASH_PARTIAL_JENKINS
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_partial_jenkins(k); }
#elif HN_HASH == HN_HASH_MURMUR
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_murmur(k); }
#elif HN_HASH == HN_HASH_PCG
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_pcg(k); }
#elif HN_HASH == HN_HASH_XXHASH32
HN_FN hn_uint hn_i_hash(hn_uint k) { return hn_hash_xxhash32(k); }
#elif HN_HASH == HN_HASH_CUSTOM
HN_FN hn_uint hn_i_hash(hn_uint k) { return HN_HASH_FN(k); }
#else
HN_FN hn_uint hn_i_hash(hn_uint k) { return k; }
#endif

// Coordinates are spread: multiplying by an odd number (a prime of xxHash) sends neighbours far apart. So from a point
// to the next along an axis a spread coordinate grows by a constant, HN_I_STEP_X and so on. The offset, which is
// xxHash's fifth prime, keeps the hash of the origin from being 0.
#define HN_I_STEP_X 0x9E3779B1u
#define HN_I_STEP_Y 0x85EBCA77u
#define HN_I_STEP_Z 0xC2B2AE3Du
#define HN_I_STEP_W 0x27D4EB2Fu
#define HN_I_ORIGIN_X 0x165667B1u
HN_FN hn_uint hn_i_spread(hn_uint x) { return x * HN_I_STEP_X + HN_I_ORIGIN_X; }
HN_FN hn_uvec2 hn_i_spread(hn_uvec2 v) { return uvec2(hn_i_spread(v.x), v.y * HN_I_STEP_Y); }
HN_FN hn_uvec3 hn_i_spread(hn_uvec3 v) { return uvec3(hn_i_spread(v.x), v.y * HN_I_STEP_Y, v.z * HN_I_STEP_Z); }
HN_FN hn_uvec4 hn_i_spread(hn_uvec4 v) {
  return uvec4(hn_i_spread(v.x), v.y * HN_I_STEP_Y, v.z * HN_I_STEP_Z, v.w * HN_I_STEP_W);
}

// The high bits of a spread coordinate, no more than 23. The shifts differ by axis, so that axes do not cancel.
#define HN_I_HIGH_X 12u
#define HN_I_HIGH_Y 11u
#define HN_I_HIGH_Z 10u
#define HN_I_HIGH_W 9u
HN_FN hn_uint hn_i_high(hn_uint x) { return x >> HN_I_HIGH_X; }
HN_FN hn_uvec2 hn_i_high(hn_uvec2 v) { return uvec2(hn_i_high(v.x), v.y >> HN_I_HIGH_Y); }
HN_FN hn_uvec3 hn_i_high(hn_uvec3 v) { return uvec3(hn_i_high(v.x), v.y >> HN_I_HIGH_Y, v.z >> HN_I_HIGH_Z); }
HN_FN hn_uvec4 hn_i_high(hn_uvec4 v) {
  return uvec4(hn_i_high(v.x), v.y >> HN_I_HIGH_Y, v.z >> HN_I_HIGH_Z, v.w >> HN_I_HIGH_W);
}

// Each bit of k changes each bit of the result with a probability near 1/2. This is "prospector32" of hash-prospector.
// The result for 0 is 0.
HN_FN hn_uint hn_i_scramble(hn_uint k) {
  k ^= k >> 15u;
  k *= 0x2C1B3C6Du;
  k ^= k >> 12u;
  k *= 0x297A2D39u;
  return k ^ (k >> 15u);
}

// By this step a seed becomes the seed of the next octave, of another field and so on: 2^32 divided by the golden
// ratio.
#define HN_I_SEED_STEP 0x9E3779B9u

// The seed of another field, where a function needs several.
HN_FN hn_uint hn_i_other_seed(hn_uint seed) { return hn_i_scramble(seed + HN_I_SEED_STEP); }

// The hashes of a vector's second and third component, from the first one's: an odd number of 24 bits times their
// good bits. With other factors two components may depend on each other: docs/measured/quality.md has a test of it.
HN_FN hn_uvec4 hn_i_hashes_of_y(hn_uvec4 h) { return (h >> 8u) * 0xEB1831u; }
HN_FN hn_uvec4 hn_i_hashes_of_z(hn_uvec4 h) { return (h >> 8u) * 0x84A5E5u; }

// The hash of a point is the product of two joins of its spread coordinates. The first is the hash of the exclusive or
// of their high bits and of the seed's. The second is made of their sum: an odd number of 24 bits, so that the product
// loses nothing. Either alone would repeat itself along some line. Without a hash both factors are below 2^24, and
// compilers see it: such a product costs a quarter of one of 32 bits on AMD's GPUs, and a third on Adreno's. Points
// that share coordinates share the work: a noise steps from corner to corner in both joins. The lowest bits are not
// good: bit 0 is the first join's.

// The share of the mixed seed in the exclusive or.
HN_FN hn_uint hn_i_seed_join(hn_uint s) { return s >> 8u; }

// hn_i_sum is that sum. Each axis but x has a factor. Without one, points whose spread coordinates differ by d and -d
// would have the same sum, and the same hash where d is small. From x to w each axis has one more bit among the high
// bits, and its factor one more zero at the end: the two joins share the work of separating points. The low 24 bits of
// a coordinate suffice for 24 bits of the sum, and their product is a cheap one.
#define HN_I_SUM_Y 0x00E6133Eu
#define HN_I_SUM_Z 0x00913FDCu
#define HN_I_SUM_W 0x0085AAB8u
HN_FN hn_uint hn_i_sum_y(hn_uint y) { return (y & 0x00FFFFFFu) * HN_I_SUM_Y; }
HN_FN hn_uint hn_i_sum_z(hn_uint z) { return (z & 0x00FFFFFFu) * HN_I_SUM_Z; }
HN_FN hn_uint hn_i_sum_w(hn_uint w) { return (w & 0x00FFFFFFu) * HN_I_SUM_W; }
HN_FN hn_uint hn_i_sum(hn_uint c) { return c; }
HN_FN hn_uint hn_i_sum(hn_uvec2 c) { return c.x + hn_i_sum_y(c.y); }
HN_FN hn_uint hn_i_sum(hn_uvec3 c) { return c.x + hn_i_sum_y(c.y) + hn_i_sum_z(c.z); }
HN_FN hn_uint hn_i_sum(hn_uvec4 c) { return c.x + hn_i_sum_y(c.y) + hn_i_sum_z(c.z) + hn_i_sum_w(c.w); }

// hn_i_odd makes the second join of a sum: it is odd, and multiplied by 4097, by a shift and an addition, so that low
// bits of a coordinate reach the high ones of the hash. Only its low 24 bits count.
HN_FN hn_uint hn_i_odd(hn_uint sum) {
  hn_uint odd = sum * 2u + 1u;
  return odd + (odd << 12u);
}
// The join, axis by axis: each adds the product of its coordinate, or of a step along it, to an odd number. GPUs have a
// product of 24 bits and an addition as one operation. hn_i_point_hash below takes the sum: with products hn_random
// would cost 7 to 14% more on Apple, where a product costs four additions.
//
// HN_I_ODD_Y is the low 24 bits of HN_I_SUM_Y * HN_I_ODD_X, and so on. They are written out, because FXC takes every
// product of two literals from 2^31 on for 2^31.
#define HN_I_ODD_X 8194u
#define HN_I_ODD_Y 0x0033E67Cu
#define HN_I_ODD_Z 0x001DFFB8u
#define HN_I_ODD_W 0x00625570u
HN_FN hn_uint hn_i_odd_x(hn_uint x, hn_uint odd) { return (x & 0x00FFFFFFu) * HN_I_ODD_X + odd; }
HN_FN hn_uint hn_i_odd_y(hn_uint y, hn_uint odd) { return (y & 0x00FFFFFFu) * HN_I_ODD_Y + odd; }
HN_FN hn_uint hn_i_odd_z(hn_uint z, hn_uint odd) { return (z & 0x00FFFFFFu) * HN_I_ODD_Z + odd; }
HN_FN hn_uint hn_i_odd_w(hn_uint w, hn_uint odd) { return (w & 0x00FFFFFFu) * HN_I_ODD_W + odd; }

// The join of a point to which nothing but the mixed seed s adds. x comes last: it has an addition more.
HN_FN hn_uint hn_i_odd(hn_uint c, hn_uint s) { return hn_i_odd_x(c, hn_i_odd(s)); }
HN_FN hn_uint hn_i_odd(hn_uvec2 c, hn_uint s) { return hn_i_odd_x(c.x, hn_i_odd_y(c.y, hn_i_odd(s))); }
HN_FN hn_uint hn_i_odd(hn_uvec3 c, hn_uint s) { return hn_i_odd_x(c.x, hn_i_odd_y(c.y, hn_i_odd_z(c.z, hn_i_odd(s)))); }
HN_FN hn_uint hn_i_odd(hn_uvec4 c, hn_uint s) {
  return hn_i_odd_x(c.x, hn_i_odd_y(c.y, hn_i_odd_z(c.z, hn_i_odd_w(c.w, hn_i_odd(s)))));
}

// From one spread coordinate to another along x. Neighbours are a constant apart, and compilers see it once the origin
// is taken off both.
HN_FN hn_uint hn_i_step_x(hn_uint from, hn_uint to) { return (to - HN_I_ORIGIN_X) - (from - HN_I_ORIGIN_X); }

#if HN_HASH == HN_HASH_LATTICE
HN_FN hn_uint hn_i_point_hash(hn_uint join, hn_uint odd) { return join * (odd & 0x00FFFFFFu); }
#else
// A weak hash leaves too much to the product, whose high bits are best; gradients are taken from lower ones. And it may
// lose a bit (the lowest of partial FNV1 is constant), which the join has.
HN_FN hn_uint hn_i_point_hash(hn_uint join, hn_uint odd) {
  hn_uint h = hn_i_hash(join) * (odd & 0x00FFFFFFu) + join;
  return h ^ (h >> 9u);
}
#endif

// The hash of a point, from its spread coordinates. The seed and all else add join to the exclusive or, and sum to
// the sum.
HN_FN hn_uint hn_i_point_hash(hn_uvec2 c, hn_uint join, hn_uint sum) {
  hn_uvec2 j = hn_i_high(c);
  return hn_i_point_hash(j.x ^ j.y ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_i_point_hash(hn_uint c, hn_uint join, hn_uint sum) {
  hn_uint j = hn_i_high(c);
  return hn_i_point_hash(j ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
HN_FN hn_uint hn_i_point_hash(hn_uvec3 c, hn_uint join, hn_uint sum) {
  hn_uvec3 j = hn_i_high(c);
  return hn_i_point_hash(j.x ^ j.y ^ j.z ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
HN_FN hn_uint hn_i_point_hash(hn_uvec4 c, hn_uint join, hn_uint sum) {
  hn_uvec4 j = hn_i_high(c);
  return hn_i_point_hash(j.x ^ j.y ^ j.z ^ j.w ^ join, hn_i_odd(hn_i_sum(c) + sum));
}

// The hash of a point to which nothing but the mixed seed s adds.
HN_FN hn_uint hn_i_seeded_hash(hn_uvec2 c, hn_uint s) { return hn_i_point_hash(c, hn_i_seed_join(s), s); }
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_i_seeded_hash(hn_uint c, hn_uint s) { return hn_i_point_hash(c, hn_i_seed_join(s), s); }
HN_FN hn_uint hn_i_seeded_hash(hn_uvec3 c, hn_uint s) { return hn_i_point_hash(c, hn_i_seed_join(s), s); }
HN_FN hn_uint hn_i_seeded_hash(hn_uvec4 c, hn_uint s) { return hn_i_point_hash(c, hn_i_seed_join(s), s); }

#endif
