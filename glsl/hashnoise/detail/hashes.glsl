// hashnoise: hashes of 32-bit numbers. Each is exact: the same bits on every driver.
// SPDX-License-Identifier: MIT

#ifndef HN_HASHES_GLSL
#define HN_HASHES_GLSL

#include "../config.glsl"

// These take a uint and return a uint. They do not depend on HN_HASH.

// FNV-1, 32 bit, of the four bytes of k, lowest first.
//   k        any uint
//   example  uint n = hn_hash_fnv1(5u);
//   returns  any uint
//   cost     3 multiplications (the first is of constants)
//   source   Fowler, Noll, Vo; paper fig. 1
HN_FN hn_uint hn_hash_fnv1(hn_uint k) {
  hn_uint h = 2166136261u;
  h = (h * 16777619u) ^ (k & 255u);
  h = (h * 16777619u) ^ ((k >> 8u) & 255u);
  h = (h * 16777619u) ^ ((k >> 16u) & 255u);
  h = (h * 16777619u) ^ (k >> 24u);
  return h;
}

// FNV-1's step, twice with all 32 bits. It is weak: 31 of 32 numbers k have the same hash as -2 - k, and the low 8 bits
// repeat with a period of 256.
//   k        any uint
//   example  uint n = hn_hash_partial_fnv1(5u);
//   returns  any uint
//   cost     1 multiplication (the first is of constants)
//   source   Valdenegro-Toro and Pincheira, sec. 7
HN_FN hn_uint hn_hash_partial_fnv1(hn_uint k) {
  hn_uint h = 2166136261u;
  h = (h * 16777619u) ^ k;
  h = (h * 16777619u) ^ k;
  return h;
}

HN_FN hn_uint hn_i_jenkins_step(hn_uint h, hn_uint add) {
  h += add;
  h += h << 10u;
  return h ^ (h >> 6u);
}

HN_FN hn_uint hn_i_jenkins_end(hn_uint h) {
  h += h << 3u;
  h ^= h >> 11u;
  return h + (h << 15u);
}

// Jenkins one-at-a-time of the four bytes of k, lowest first.
//   k        any uint
//   example  uint n = hn_hash_jenkins(5u);
//   returns  any uint
//   cost     no multiplication; 14 shifts, 14 additions and exclusive ors
//   source   Jenkins, "A hash function for hash table lookup"; paper fig. 2
HN_FN hn_uint hn_hash_jenkins(hn_uint k) {
  hn_uint h = 0u;
  h = hn_i_jenkins_step(h, k & 255u);
  h = hn_i_jenkins_step(h, (k >> 8u) & 255u);
  h = hn_i_jenkins_step(h, (k >> 16u) & 255u);
  h = hn_i_jenkins_step(h, k >> 24u);
  return hn_i_jenkins_end(h);
}

// One-at-a-time with a single step that takes all 32 bits.
//   k        any uint
//   example  uint n = hn_hash_partial_jenkins(5u);
//   returns  any uint
//   cost     no multiplication; 5 shifts, 5 additions and exclusive ors
//   source   Valdenegro-Toro and Pincheira, sec. 7
HN_FN hn_uint hn_hash_partial_jenkins(hn_uint k) { return hn_i_jenkins_end(hn_i_jenkins_step(0u, k)); }

// The paper's Murmur: the body of MurmurHash2 for 32 bits, without its final avalanche.
//   k        any uint
//   example  uint n = hn_hash_murmur(5u);
//   returns  any uint
//   cost     2 multiplications
//   source   Appleby; paper fig. 3
HN_FN hn_uint hn_hash_murmur(hn_uint k) {
  hn_uint m = 1540483477u;
  k *= m;
  k ^= k >> 24u;
  k *= m;
  return (10u * m) ^ k;
}

// PCG, output permutation RXS-M-XS of a 32-bit congruential step.
//   k        any uint
//   example  uint n = hn_hash_pcg(5u);
//   returns  any uint; a bijection
//   cost     2 multiplications, 1 shift by a variable
//   source   O'Neill; Jarzynski and Olano 2020, pcg_hash
HN_FN hn_uint hn_hash_pcg(hn_uint k) {
  hn_uint s = k * 747796405u + 2891336453u;
  hn_uint w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
  return (w >> 22u) ^ w;
}

// XXH32 of the four bytes of k with seed 0.
//   k        any uint
//   example  uint n = hn_hash_xxhash32(5u);
//   returns  any uint; a bijection
//   cost     4 multiplications
//   source   Collet, xxHash specification; 374761397 is its fifth prime plus the length, 4
HN_FN hn_uint hn_hash_xxhash32(hn_uint k) {
  hn_uint h = 374761397u + k * 3266489917u;
  h = ((h << 17u) | (h >> 15u)) * 668265263u;
  h ^= h >> 15u;
  h *= 2246822519u;
  h ^= h >> 13u;
  h *= 3266489917u;
  return h ^ (h >> 16u);
}

// Wellons' hash with little bias, of two multiplications.
//   k        any uint
//   example  uint n = hn_hash_lowbias32(5u);
//   returns  any uint; a bijection
//   cost     2 multiplications
//   source   Wellons, hash-prospector, lowbias32
HN_FN hn_uint hn_hash_lowbias32(hn_uint k) {
  k ^= k >> 16u;
  k *= 0x7FEB352Du;
  k ^= k >> 15u;
  k *= 0x846CA68Bu;
  return k ^ (k >> 16u);
}

// Hashes of several numbers, which return as many: of a pixel and a frame, for example. HN_HASH does not offer them,
// since it hashes one number.

HN_FN hn_uint hn_i_congruential(hn_uint k) { return k * 1664525u + 1013904223u; }
HN_FN hn_uint hn_i_folded(hn_uint k) { return k ^ (k >> 16u); }

// PCG's step of each of two numbers, which are then mixed with each other.
//   v        any uvec2
//   example  uvec2 n = hn_hash_pcg2d(uvec2(12u, 34u));
//   returns  any uvec2; a bijection
//   cost     6 multiplications
//   source   Jarzynski and Olano 2020, pcg2d
HN_FN hn_uvec2 hn_hash_pcg2d(hn_uvec2 v) {
  hn_uint x = hn_i_congruential(v.x);
  hn_uint y = hn_i_congruential(v.y);
  x += y * 1664525u;
  y += x * 1664525u;
  x = hn_i_folded(x);
  y = hn_i_folded(y);
  x += y * 1664525u;
  y += x * 1664525u;
  return uvec2(hn_i_folded(x), hn_i_folded(y));
}

// PCG's step of each of three numbers, which are then mixed by products of two.
//   v        any uvec3
//   example  uvec3 n = hn_hash_pcg3d(uvec3(12u, 34u, 56u));
//   returns  any uvec3; a bijection
//   cost     9 multiplications
//   source   Jarzynski and Olano 2020, pcg3d
HN_FN hn_uvec3 hn_hash_pcg3d(hn_uvec3 v) {
  hn_uint x = hn_i_congruential(v.x);
  hn_uint y = hn_i_congruential(v.y);
  hn_uint z = hn_i_congruential(v.z);
  x += y * z;
  y += z * x;
  z += x * y;
  x = hn_i_folded(x);
  y = hn_i_folded(y);
  z = hn_i_folded(z);
  x += y * z;
  y += z * x;
  z += x * y;
  return uvec3(x, y, z);
}

// PCG's step of each of four numbers, which are then mixed by products of two.
//   v        any uvec4
//   example  uvec4 n = hn_hash_pcg4d(uvec4(12u, 34u, 56u, 78u));
//   returns  any uvec4; a bijection
//   cost     12 multiplications
//   source   Jarzynski and Olano 2020, pcg4d
HN_FN hn_uvec4 hn_hash_pcg4d(hn_uvec4 v) {
  hn_uint x = hn_i_congruential(v.x);
  hn_uint y = hn_i_congruential(v.y);
  hn_uint z = hn_i_congruential(v.z);
  hn_uint w = hn_i_congruential(v.w);
  x += y * w;
  y += z * x;
  z += x * y;
  w += y * z;
  x = hn_i_folded(x);
  y = hn_i_folded(y);
  z = hn_i_folded(z);
  w = hn_i_folded(w);
  x += y * w;
  y += z * x;
  z += x * y;
  w += y * z;
  return uvec4(x, y, z, w);
}

#endif
