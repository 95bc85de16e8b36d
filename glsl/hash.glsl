// hashnoise: integer hashes, the hash of a lattice point, and what becomes of a hash: a float or a gradient.
// SPDX-License-Identifier: MIT
//
// Everything in this file is exact: the same bits on every driver. docs/contract.md defines each value.
// HN_HIGHP stands on every declaration because GLSL ES makes int and uint mediump (16 bits) in fragment shaders.

#ifndef HN_HASH_GLSL
#define HN_HASH_GLSL

#include "config.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Word hashes: a uint for a uint, whatever HN_HASH says.

// FNV-1, 32 bit, of the four bytes of k, lowest first.
//   returns  any uint
//   cost     3 multiplications (the first is of constants)
//   source   Fowler, Noll, Vo; paper fig. 1
HN_FN HN_HIGHP uint hn_hash_fnv1(HN_HIGHP uint k) {
  HN_HIGHP uint h = 2166136261u;
  h = (h * 16777619u) ^ (k & 255u);
  h = (h * 16777619u) ^ ((k >> 8) & 255u);
  h = (h * 16777619u) ^ ((k >> 16) & 255u);
  h = (h * 16777619u) ^ (k >> 24);
  return h;
}

// FNV-1's step, twice with the whole word. Weak: 31 of 32 words k have the same hash as -2 - k, and the low 8 bits
// repeat with a period of 256.
//   returns  any uint
//   cost     1 multiplication (the first is of constants)
//   source   Valdenegro-Toro and Pincheira, sec. 7
HN_FN HN_HIGHP uint hn_hash_partial_fnv1(HN_HIGHP uint k) {
  HN_HIGHP uint h = 2166136261u;
  h = (h * 16777619u) ^ k;
  h = (h * 16777619u) ^ k;
  return h;
}

HN_FN HN_HIGHP uint hn_i_jenkins_step(HN_HIGHP uint h, HN_HIGHP uint add) {
  h += add;
  h += h << 10;
  return h ^ (h >> 6);
}

HN_FN HN_HIGHP uint hn_i_jenkins_end(HN_HIGHP uint h) {
  h += h << 3;
  h ^= h >> 11;
  return h + (h << 15);
}

// Jenkins one-at-a-time of the four bytes of k, lowest first.
//   returns  any uint
//   cost     no multiplication; 14 shifts, 14 additions and exclusive ors
//   source   Jenkins, "A hash function for hash table lookup"; paper fig. 2
HN_FN HN_HIGHP uint hn_hash_jenkins(HN_HIGHP uint k) {
  HN_HIGHP uint h = 0u;
  h = hn_i_jenkins_step(h, k & 255u);
  h = hn_i_jenkins_step(h, (k >> 8) & 255u);
  h = hn_i_jenkins_step(h, (k >> 16) & 255u);
  h = hn_i_jenkins_step(h, k >> 24);
  return hn_i_jenkins_end(h);
}

// One-at-a-time with a single step that takes the whole word.
//   returns  any uint
//   cost     no multiplication; 5 shifts, 5 additions and exclusive ors
//   source   Valdenegro-Toro and Pincheira, sec. 7
HN_FN HN_HIGHP uint hn_hash_partial_jenkins(HN_HIGHP uint k) { return hn_i_jenkins_end(hn_i_jenkins_step(0u, k)); }

// The paper's Murmur: the body of MurmurHash2 for one word, without its final avalanche.
//   returns  any uint
//   cost     2 multiplications
//   source   Appleby; paper fig. 3
HN_FN HN_HIGHP uint hn_hash_murmur(HN_HIGHP uint k) {
  HN_HIGHP uint m = 1540483477u;
  k *= m;
  k ^= k >> 24;
  k *= m;
  return (10u * m) ^ k;
}

// PCG, output permutation RXS-M-XS of a 32-bit congruential step.
//   returns  any uint; a bijection
//   cost     2 multiplications, 1 shift by a variable
//   source   O'Neill; Jarzynski and Olano 2020, pcg_hash
HN_FN HN_HIGHP uint hn_hash_pcg(HN_HIGHP uint k) {
  HN_HIGHP uint s = k * 747796405u + 2891336453u;
  HN_HIGHP uint w = ((s >> ((s >> 28) + 4u)) ^ s) * 277803737u;
  return (w >> 22) ^ w;
}

// XXH32 of the four bytes of k with seed 0.
//   returns  any uint; a bijection
//   cost     4 multiplications
//   source   Collet, xxHash specification; 374761397 is its fifth prime plus the length, 4
HN_FN HN_HIGHP uint hn_hash_xxhash32(HN_HIGHP uint k) {
  HN_HIGHP uint h = 374761397u + k * 3266489917u;
  h = ((h << 17) | (h >> 15)) * 668265263u;
  h ^= h >> 15;
  h *= 2246822519u;
  h ^= h >> 13;
  h *= 3266489917u;
  return h ^ (h >> 16);
}

// ---------------------------------------------------------------------------------------------------------------------
// The hash of a lattice point, in three steps: spread the coordinates, make a key of them, mix.

// Odd multiples (the primes of xxHash) send neighbours far apart, so that what a hash does alike for nearby or mirrored
// words happens nowhere near the origin. The offset keeps the origin itself from being a word of zeros.
HN_FN HN_HIGHP uint hn_i_spread(HN_HIGHP uint x) { return x * 0x9E3779B1u + 0x165667B1u; }

HN_FN HN_HIGHP uvec2 hn_i_spread(HN_HIGHP uvec2 v) { return uvec2(hn_i_spread(v.x), v.y * 0x85EBCA77u); }

HN_FN HN_HIGHP uvec3 hn_i_spread(HN_HIGHP uvec3 v) {
  return uvec3(hn_i_spread(v.x), v.y * 0x85EBCA77u, v.z * 0xC2B2AE3Du);
}

HN_FN HN_HIGHP uvec4 hn_i_spread(HN_HIGHP uvec4 v) {
  return uvec4(hn_i_spread(v.x), v.y * 0x85EBCA77u, v.z * 0xC2B2AE3Du, v.w * 0x27D4EB2Fu);
}

// A key is built axis by axis, so that lattice points that share coordinates share the work: hn_i_key starts with x,
// and hn_i_key with two parameters adds the next coordinate to the key of those before.
#if HN_HASH == HN_HASH_LATTICE
// Exclusive or after a rotation. Without the rotation, points opposite each other would often have the same key; a sum
// would be linear, and repeat along some diagonal.
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return x; }
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint k, HN_HIGHP uint next) { return ((k << 13) | (k >> 19)) ^ next; }
#else
#if HN_HASH == HN_HASH_FNV1
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_fnv1(x); }
#elif HN_HASH == HN_HASH_PARTIAL_FNV1
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_partial_fnv1(x); }
#elif HN_HASH == HN_HASH_JENKINS
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_jenkins(x); }
#elif HN_HASH == HN_HASH_PARTIAL_JENKINS
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_partial_jenkins(x); }
#elif HN_HASH == HN_HASH_MURMUR
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_murmur(x); }
#elif HN_HASH == HN_HASH_PCG
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_pcg(x); }
#elif HN_HASH == HN_HASH_XXHASH32
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return hn_hash_xxhash32(x); }
#else
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint x) { return HN_HASH_FN(x); }
#endif
// The paper's chain: each hash feeds the next axis (sec. 5).
HN_FN HN_HIGHP uint hn_i_key(HN_HIGHP uint k, HN_HIGHP uint next) { return hn_i_key(k + next); }
#endif

// Each bit of k changes each bit of the result with a probability near 1/2: "prospector32" of hash-prospector. 0 stays
// 0.
HN_FN HN_HIGHP uint hn_i_mix(HN_HIGHP uint k) {
  k ^= k >> 15;
  k *= 0x2C1B3C6Du;
  k ^= k >> 12;
  k *= 0x297A2D39u;
  return k ^ (k >> 15);
}

// Lattice hashing: a well mixed hash of a point of the integer lattice, with any HN_HASH. What the noise is made of;
// use it to scatter things.
//   cell     the point: int, ivec2, ivec3 or ivec4
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  any uint; take bits from anywhere in it
//   period   2^32 along each axis (HN_HASH_PARTIAL_FNV1: 2^31 along the last axis, half as much along each before)
//   cost     per axis 1 multiplication and 1 hash (none with HN_HASH_LATTICE); 2 multiplications to mix, and 2 more for
//            a seed that is no constant
HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP int cell, HN_HIGHP uint seed) {
  return hn_i_mix(hn_i_key(hn_i_spread(uint(cell))) ^ hn_i_mix(seed));
}

HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec2 cell, HN_HIGHP uint seed) {
  HN_HIGHP uvec2 c = hn_i_spread(uvec2(cell));
  return hn_i_mix(hn_i_key(hn_i_key(c.x), c.y) ^ hn_i_mix(seed));
}

HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec3 cell, HN_HIGHP uint seed) {
  HN_HIGHP uvec3 c = hn_i_spread(uvec3(cell));
  return hn_i_mix(hn_i_key(hn_i_key(hn_i_key(c.x), c.y), c.z) ^ hn_i_mix(seed));
}

HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec4 cell, HN_HIGHP uint seed) {
  HN_HIGHP uvec4 c = hn_i_spread(uvec4(cell));
  return hn_i_mix(hn_i_key(hn_i_key(hn_i_key(hn_i_key(c.x), c.y), c.z), c.w) ^ hn_i_mix(seed));
}

HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP int cell) { return hn_lattice(cell, 0u); }
HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec2 cell) { return hn_lattice(cell, 0u); }
HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec3 cell) { return hn_lattice(cell, 0u); }
HN_FN HN_HIGHP uint hn_lattice(HN_HIGHP ivec4 cell) { return hn_lattice(cell, 0u); }

// ---------------------------------------------------------------------------------------------------------------------
// The selected hash as published, of 1 to 4 words: H(x), H(H(x) + y), and so on. HN_HASH_LATTICE has no published form;
// with it this is hn_lattice.
//   returns  any uint; as good, or as weak, as the hash is
//   cost     1 hash per word (HN_HASH_LATTICE: as hn_lattice)
//   source   Valdenegro-Toro and Pincheira, sec. 5
#if HN_HASH == HN_HASH_LATTICE
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uint x) { return hn_lattice(int(x)); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec2 v) { return hn_lattice(ivec2(v)); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec3 v) { return hn_lattice(ivec3(v)); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec4 v) { return hn_lattice(ivec4(v)); }
#else
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uint x) { return hn_i_key(x); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec2 v) { return hn_i_key(hn_hash(v.x), v.y); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec3 v) { return hn_i_key(hn_hash(uvec2(v.x, v.y)), v.z); }
HN_FN HN_HIGHP uint hn_hash(HN_HIGHP uvec4 v) { return hn_i_key(hn_hash(uvec3(v.x, v.y, v.z)), v.w); }
#endif

// ---------------------------------------------------------------------------------------------------------------------
// From a hash to a float. Every step below is exact in a 32-bit float, however it is rounded or contracted.

// A float of the high 24 bits of a hash.
//   returns  [0, 1), a multiple of 2^-24
HN_FN HN_HIGHP float hn_unorm(HN_HIGHP uint h) { return float(h >> 8) * (1.0f / 16777216.0f); }

// A signed float of the high 24 bits of a hash.
//   returns  [-1, 1), a multiple of 2^-23
HN_FN HN_HIGHP float hn_snorm(HN_HIGHP uint h) { return float(h >> 8) * (1.0f / 8388608.0f) - 1.0f; }

// The odd multiples of 2^-16 in (-1, 1) from the high 16 bits of h: symmetric about 0, never 0.
HN_FN HN_HIGHP float hn_i_symmetric16(HN_HIGHP uint h) {
#if HN_I_BITCAST
  // The bits, put behind the exponent of 2, make a float in [2, 4) without a conversion from integer.
  return uintBitsToFloat(((h >> 9) & 0x007FFF80u) | 0x40000000u) - (3.0f - 1.0f / 65536.0f);
#else
  return float(h >> 16) * (1.0f / 32768.0f) - (1.0f - 1.0f / 65536.0f);
#endif
}

// m or, if the highest bit of the word is set, -m; for m >= 0.
HN_FN HN_HIGHP float hn_i_signed(HN_HIGHP float m, HN_HIGHP uint word) {
#if HN_I_BITCAST
  return uintBitsToFloat(floatBitsToUint(m) | (word & 0x80000000u));
#else
  return (word & 0x80000000u) != 0u ? -m : m;
#endif
}

// A gradient in the plane, from the high 17 bits of a hash.
//   returns  a point of the square |x| + |y| = 1, uniform along its sides; multiples of 2^-16
HN_FN HN_HIGHP vec2 hn_gradient2(HN_HIGHP uint h) {
  HN_HIGHP float x = hn_i_symmetric16(h);
  return vec2(x, hn_i_signed(1.0f - abs(x), h << 16));
}

// A gradient in space, from all bits of a hash.
//   returns  a point of the octahedron |x| + |y| + |z| = 1, uniform in area; multiples of 2^-16
//   source   the octahedral map of Meyer et al., "On Floating-Point Normal Vectors", 2010
HN_FN HN_HIGHP vec3 hn_gradient3(HN_HIGHP uint h) {
  HN_HIGHP float x = hn_i_symmetric16(h);
  HN_HIGHP float y = hn_i_symmetric16(h << 16);
  HN_HIGHP float z = 1.0f - abs(x) - abs(y);
  // Where z is negative, fold: move x and y by t towards 0. x is positive where the highest bit of h is set, y
  // likewise.
  HN_HIGHP float t = max(-z, 0.0f);
  return vec3(x + hn_i_signed(t, h), y + hn_i_signed(t, h << 16), z);
}

#endif
