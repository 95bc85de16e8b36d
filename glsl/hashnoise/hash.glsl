// hashnoise: integer hashes, the hash of a lattice point, and the float of a hash.
// SPDX-License-Identifier: MIT
//
// Everything in this file is exact: the same bits on every driver. docs/contract.md defines each value.
//
// A word is a uint, and so is a seed: hn_hash(7u). For 7, an int, most versions of GLSL find no overload.
//
// In all files a cost counts multiplications. They are of words unless it says otherwise. Ramps, interpolation and the
// cheap factors of 24 bits in sums of coordinates do not count.

#ifndef HN_HASH_GLSL
#define HN_HASH_GLSL

#include "config.glsl"
#include "detail/convert.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Word hashes take a uint and return a uint. They do not depend on HN_HASH.

// FNV-1, 32 bit, of the four bytes of k, lowest first.
//   k        any uint
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

// FNV-1's step, twice with the whole word. It is weak: 31 of 32 words k have the same hash as -2 - k, and the low 8
// bits repeat with a period of 256.
//   k        any uint
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

// One-at-a-time with a single step that takes the whole word.
//   k        any uint
//   returns  any uint
//   cost     no multiplication; 5 shifts, 5 additions and exclusive ors
//   source   Valdenegro-Toro and Pincheira, sec. 7
HN_FN hn_uint hn_hash_partial_jenkins(hn_uint k) { return hn_i_jenkins_end(hn_i_jenkins_step(0u, k)); }

// The paper's Murmur: the body of MurmurHash2 for one word, without its final avalanche.
//   k        any uint
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

// Hashes of several words, which return as many: of a pixel and a frame, for example. They are no choices of HN_HASH,
// which is of one word.

HN_FN hn_uint hn_i_congruential(hn_uint k) { return k * 1664525u + 1013904223u; }
HN_FN hn_uint hn_i_folded(hn_uint k) { return k ^ (k >> 16u); }

// PCG's step of each of two words, which are then mixed with each other.
//   v        any uvec2
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

// PCG's step of each of three words, which are then mixed by products of two.
//   v        any uvec3
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

// PCG's step of each of four words, which are then mixed by products of two.
//   v        any uvec4
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

// ---------------------------------------------------------------------------------------------------------------------
// The word of a lattice point.

// The selected hash of one word.
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
// xxHash's fifth prime, keeps the origin from being a word of zeros.
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
HN_FN hn_uint hn_i_mix(hn_uint k) {
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
HN_FN hn_uint hn_i_other_seed(hn_uint seed) { return hn_i_mix(seed + HN_I_SEED_STEP); }

// The words of a vector's second and third component, from those of the first: an odd number of 24 bits times their
// good bits. With other factors two components may depend on each other: docs/quality.md has a test of it.
HN_FN hn_uvec4 hn_i_words_of_y(hn_uvec4 words) { return (words >> 8u) * 0xEB1831u; }
HN_FN hn_uvec4 hn_i_words_of_z(hn_uvec4 words) { return (words >> 8u) * 0x84A5E5u; }

// The word of a point is the product of two joins of its spread coordinates. The first is the hash of the exclusive or
// of their high bits and of the seed's. The second is made of their sum: an odd number of 24 bits, so that the product
// loses nothing. Either alone would repeat itself along some line. Without a hash both factors are below 2^24, and
// compilers see it: such a product costs a quarter of one of 32 bits on AMD's GPUs, and a third on Adreno's. Points
// that share coordinates share the work: a noise steps from corner to corner in both joins. The lowest bits are not
// good: bit 0 is that of the first join.

// The share of the mixed seed in the exclusive or.
HN_FN hn_uint hn_i_seed_join(hn_uint s) { return s >> 8u; }

// hn_i_sum is that sum. Each axis but x has a factor. Without one, points whose spread coordinates differ by d and -d
// would have the same sum, and the same word where d is small. From x to w each axis has one more bit among the high
// bits, and its factor one more zero at the end: the two joins share the work of telling points apart. The low 24 bits
// of a coordinate suffice for 24 bits of the sum, and their product is a cheap one.
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

// hn_i_odd makes the second join of a sum: it is odd, and multiplied by HN_I_ODD_FACTOR, by a shift and an addition, so
// that low bits of a coordinate reach the high ones of the word. Only its low 24 bits count. Where the sum grows by a
// step, the join grows by hn_i_odd_step.
#define HN_I_ODD_FACTOR 4097u
HN_FN hn_uint hn_i_odd(hn_uint sum) {
  hn_uint odd = sum * 2u + 1u;
  return odd + (odd << 12u);
}
HN_FN hn_uint hn_i_odd_step(hn_uint step) { return step * (2u * HN_I_ODD_FACTOR); }
HN_FN hn_uvec3 hn_i_odd_step(hn_uvec3 steps) { return steps * (2u * HN_I_ODD_FACTOR); }

// The same join where points share no sum. Each axis adds its product to what was made before: GPUs have a product of 24
// bits and an addition as one operation. That makes simplex noise on the plane 3% cheaper in the mean of six compilers.
// It is not done elsewhere: in space simplex noise would be 1% cheaper, but hn_simplex_d with HN_FIXED 8% dearer by the
// schedule for NVIDIA, and so hn_simplex_smooth on the plane with HN_FIXED on Adreno.
#define HN_I_ODD_OF(factor) (((factor) * (2u * HN_I_ODD_FACTOR)) & 0x00FFFFFFu)
HN_FN hn_uint hn_i_odd_x(hn_uint x, hn_uint odd) { return (x & 0x00FFFFFFu) * HN_I_ODD_OF(1u) + odd; }
HN_FN hn_uint hn_i_odd_y(hn_uint y, hn_uint odd) { return (y & 0x00FFFFFFu) * HN_I_ODD_OF(HN_I_SUM_Y) + odd; }

#if HN_HASH == HN_HASH_LATTICE
HN_FN hn_uint hn_i_word(hn_uint join, hn_uint odd) { return join * (odd & 0x00FFFFFFu); }
#else
// A weak hash leaves too much to the product, whose high bits are best; gradients are taken from lower ones. And it may
// lose a bit (the lowest of partial FNV1 is constant), which the join has.
HN_FN hn_uint hn_i_word(hn_uint join, hn_uint odd) {
  hn_uint h = hn_i_hash(join) * (odd & 0x00FFFFFFu) + join;
  return h ^ (h >> 9u);
}
#endif

// The word of a point, from its spread coordinates. The seed and all else add `join` to the exclusive or, and `sum` to
// the sum.
HN_FN hn_uint hn_i_word(hn_uvec2 c, hn_uint join, hn_uint sum) {
  hn_uvec2 j = hn_i_high(c);
  return hn_i_word(j.x ^ j.y ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_i_word(hn_uint c, hn_uint join, hn_uint sum) {
  hn_uint j = hn_i_high(c);
  return hn_i_word(j ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
HN_FN hn_uint hn_i_word(hn_uvec3 c, hn_uint join, hn_uint sum) {
  hn_uvec3 j = hn_i_high(c);
  return hn_i_word(j.x ^ j.y ^ j.z ^ join, hn_i_odd(hn_i_sum(c) + sum));
}
HN_FN hn_uint hn_i_word(hn_uvec4 c, hn_uint join, hn_uint sum) {
  hn_uvec4 j = hn_i_high(c);
  return hn_i_word(j.x ^ j.y ^ j.z ^ j.w ^ join, hn_i_odd(hn_i_sum(c) + sum));
}

// The word of a point to which nothing but the mixed seed s adds.
HN_FN hn_uint hn_i_seeded_word(hn_uvec2 c, hn_uint s) { return hn_i_word(c, hn_i_seed_join(s), s); }
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_i_seeded_word(hn_uint c, hn_uint s) { return hn_i_word(c, hn_i_seed_join(s), s); }
HN_FN hn_uint hn_i_seeded_word(hn_uvec3 c, hn_uint s) { return hn_i_word(c, hn_i_seed_join(s), s); }
HN_FN hn_uint hn_i_seeded_word(hn_uvec4 c, hn_uint s) { return hn_i_word(c, hn_i_seed_join(s), s); }

HN_FN hn_uint hn_i_point(hn_uvec2 cell, hn_uint seed) { return hn_i_seeded_word(hn_i_spread(cell), hn_i_mix(seed)); }
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_i_point(hn_uint cell, hn_uint seed) { return hn_i_seeded_word(hn_i_spread(cell), hn_i_mix(seed)); }
HN_FN hn_uint hn_i_point(hn_uvec3 cell, hn_uint seed) { return hn_i_seeded_word(hn_i_spread(cell), hn_i_mix(seed)); }
HN_FN hn_uint hn_i_point(hn_uvec4 cell, hn_uint seed) { return hn_i_seeded_word(hn_i_spread(cell), hn_i_mix(seed)); }

// hn_lattice of spread coordinates and the mixed seed s.
HN_FN hn_uint hn_i_lattice(hn_uvec2 c, hn_uint s) { return hn_i_mix(hn_i_seeded_word(c, s) + (hn_i_sum(c) + s)); }
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_i_lattice(hn_uint c, hn_uint s) { return hn_i_mix(hn_i_seeded_word(c, s) + (hn_i_sum(c) + s)); }
HN_FN hn_uint hn_i_lattice(hn_uvec3 c, hn_uint s) { return hn_i_mix(hn_i_seeded_word(c, s) + (hn_i_sum(c) + s)); }
HN_FN hn_uint hn_i_lattice(hn_uvec4 c, hn_uint s) { return hn_i_mix(hn_i_seeded_word(c, s) + (hn_i_sum(c) + s)); }

// Lattice hashing: a well mixed hash of a point of the integer lattice, with any HN_HASH. It is made of the word from
// which noise starts, and of the sum: where the first join is 0, at one point in two million, the word is 0, too. Use
// the hash to scatter things.
//   cell     the point: int, ivec2, ivec3 or ivec4
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  any uint; take bits from anywhere in it
//   period   2^32 along each axis
//   cost     1 hash (none with HN_HASH_LATTICE); 1 multiplication per axis and 3 more; 2 more for a seed that is not
//            constant
HN_FN hn_uint hn_lattice(hn_ivec2 cell, hn_uint seed) { return hn_i_lattice(hn_i_spread(uvec2(cell)), hn_i_mix(seed)); }
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_lattice(hn_int cell, hn_uint seed) { return hn_i_lattice(hn_i_spread(uint(cell)), hn_i_mix(seed)); }
HN_FN hn_uint hn_lattice(hn_ivec3 cell, hn_uint seed) { return hn_i_lattice(hn_i_spread(uvec3(cell)), hn_i_mix(seed)); }
HN_FN hn_uint hn_lattice(hn_ivec4 cell, hn_uint seed) { return hn_i_lattice(hn_i_spread(uvec4(cell)), hn_i_mix(seed)); }

HN_FN hn_uint hn_lattice(hn_ivec2 cell) { return hn_lattice(cell, 0u); }
// The same in 1, 3 and 4 dimensions: tools/make writes it.
HN_FN hn_uint hn_lattice(hn_int cell) { return hn_lattice(cell, 0u); }
HN_FN hn_uint hn_lattice(hn_ivec3 cell) { return hn_lattice(cell, 0u); }
HN_FN hn_uint hn_lattice(hn_ivec4 cell) { return hn_lattice(cell, 0u); }

// ---------------------------------------------------------------------------------------------------------------------
// The selected hash as published, of 1 to 4 words: H(x), H(H(x) + y), and so on. HN_HASH_LATTICE has no published form,
// and with it this is hn_lattice.
//   x, v     the words: uint, uvec2, uvec3 or uvec4
//   returns  any uint; it is as good or as weak as the hash
//   cost     1 hash per word (HN_HASH_LATTICE: as hn_lattice)
//   source   Valdenegro-Toro and Pincheira, sec. 5
#if HN_HASH == HN_HASH_LATTICE
HN_FN hn_uint hn_hash(hn_uint x) { return hn_lattice(int(x)); }
HN_FN hn_uint hn_hash(hn_uvec2 v) { return hn_lattice(ivec2(v)); }
HN_FN hn_uint hn_hash(hn_uvec3 v) { return hn_lattice(ivec3(v)); }
HN_FN hn_uint hn_hash(hn_uvec4 v) { return hn_lattice(ivec4(v)); }
#else
HN_FN hn_uint hn_hash(hn_uint x) { return hn_i_hash(x); }
HN_FN hn_uint hn_hash(hn_uvec2 v) { return hn_i_hash(hn_hash(v.x) + v.y); }
HN_FN hn_uint hn_hash(hn_uvec3 v) { return hn_i_hash(hn_hash(uvec2(v.x, v.y)) + v.z); }
HN_FN hn_uint hn_hash(hn_uvec4 v) { return hn_i_hash(hn_hash(uvec3(v.x, v.y, v.z)) + v.w); }
#endif

// ---------------------------------------------------------------------------------------------------------------------
// From a hash to a float. Every step below is exact in a 32-bit float, however it is rounded or contracted.

// A float of the high 24 bits of a hash.
//   h        any uint
//   returns  [0, 1), a multiple of 2^-24
//   error    none
//   cost     1 multiplication of floats
HN_FN hn_float hn_unorm(hn_uint h) { return HN_I_NOT_WHOLE(hn_i_float(h >> 8u) * (1.0f / 16777216.0f)); }

// A signed float of the high 24 bits of a hash.
//   h        any uint
//   returns  [-1, 1), a multiple of 2^-23
//   error    none
//   cost     1 multiplication of floats
HN_FN hn_float hn_snorm(hn_uint h) { return HN_I_NOT_WHOLE(hn_i_float(h >> 8u) * (1.0f / 8388608.0f)) - 1.0f; }

#endif
