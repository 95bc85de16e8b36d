// hashnoise: random numbers, directions and points from a hash, a shuffled order, and points that fill a square evenly.
// SPDX-License-Identifier: MIT
//
// Choose the hash by the thing that needs a number: hn_lattice(cell, seed) for each cell, hn_lattice(pixel, frame) for
// each pixel of a frame, and hn_lattice(int(i), seed) for each item. Where one thing needs several independent numbers,
// give each a hash of its own:
//
//   uint h = hn_lattice(cell, seed);
//   vec2 place = hn_unorm_two(h);
//   vec3 direction = hn_sphere(hn_rehash(h, 5u));   // from 5 on: the functions of this file use 1 to 4
//
// Everything in this file is exact: the same bits with every HN_ARITHMETIC and on every driver.
// docs/reference/contract.md, section 18, defines each value.

#ifndef HN_NUMBERS_GLSL
#define HN_NUMBERS_GLSL

#include "detail/sphere.glsl"
#include "hash.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// More hashes, and numbers.

// Another hash made of a hash, for things that need several random numbers.
//   h        any uint
//   k        which one: any uint, usually 5 or more, since other functions of this kind use 1 to 4
//   example  uint h = hn_rehash(hn_lattice(ivec2(3, -5), 7u), 5u);
//   returns  any uint; for each k a bijection of h
//   cost     2 multiplications; 1 more for a k that is not constant
//   source   docs/reference/contract.md, section 18
HN_FN hn_uint hn_rehash(hn_uint h, hn_uint k) { return hn_i_scramble(h + k * HN_I_SEED_STEP); }

// Two uniform numbers: a point of the unit square.
//   h        any uint
//   example  vec2 n = hn_unorm_two(hn_lattice(ivec2(3, -5), 7u));
//   returns  two numbers in [0, 1), multiples of 2^-24. The first is hn_unorm(h)
//   error    none
//   cost     2 multiplications, and 2 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec2 hn_unorm_two(hn_uint h) { return vec2(hn_unorm(h), hn_unorm(hn_rehash(h, 1u))); }

// Three uniform numbers: a colour, or a point of the unit cube.
//   h        any uint
//   example  vec3 n = hn_unorm_three(hn_lattice(ivec2(3, -5), 7u));
//   returns  three numbers in [0, 1), multiples of 2^-24. The first two are hn_unorm_two(h)
//   error    none
//   cost     4 multiplications, and 3 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec3 hn_unorm_three(hn_uint h) {
  return vec3(hn_unorm(h), hn_unorm(hn_rehash(h, 1u)), hn_unorm(hn_rehash(h, 2u)));
}

// Four uniform numbers.
//   h        any uint
//   example  vec4 n = hn_unorm_four(hn_lattice(ivec2(3, -5), 7u));
//   returns  four numbers in [0, 1), multiples of 2^-24. The first three are hn_unorm_three(h)
//   error    none
//   cost     6 multiplications, and 4 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec4 hn_unorm_four(hn_uint h) {
  return vec4(hn_unorm(h), hn_unorm(hn_rehash(h, 1u)), hn_unorm(hn_rehash(h, 2u)), hn_unorm(hn_rehash(h, 3u)));
}

// How many bits of each byte are set, in that byte. GLSL before 4.00 and ES before 3.10 have no function for it.
HN_FN hn_uint hn_i_bits_of_bytes(hn_uint word) {
  hn_uint pairs = word - ((word >> 1u) & 0x55555555u);
  hn_uint fours = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
  return (fours + (fours >> 4u)) & 0x0F0F0F0Fu;
}

// The sum of the bytes, if it is below 256: the product has it in its highest byte.
HN_FN hn_uint hn_i_sum_of_bytes(hn_uint bytes) { return (bytes * 0x01010101u) >> 24u; }

// A normally distributed number: a height, a size, or how far a shot misses.
//   h        any uint
//   example  float n = hn_gaussian(hn_lattice(ivec2(3, -5), 7u));
//   returns  an odd multiple of 2^-13 in [-67581/8192, 67581/8192], with mean 0 and deviation 1. It is the sum of 63
//            coins and of three uniform numbers, which is nearly normally distributed
//   error    none
//   cost     5 multiplications, and 1 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_float hn_gaussian(hn_uint h) {
  hn_uint coins = hn_i_sum_of_bytes(hn_i_bits_of_bytes(hn_rehash(h, 1u)) + hn_i_bits_of_bytes(hn_rehash(h, 2u) >> 1u));
  hn_uint sum = (h & 1023u) + ((h >> 10u) & 1023u) + ((h >> 20u) & 1023u);
  return hn_i_float(int((coins << 11u) + (sum << 1u)) - 67581) * (1.0f / 8192.0f);
}

// ---------------------------------------------------------------------------------------------------------------------
// Directions, and points of a disk and a ball. Their integers are in units of 2^-16.

HN_FN hn_float hn_i_component(hn_int n) { return hn_i_float(n) * (1.0f / 65536.0f); }

HN_FN hn_ivec3 hn_i_on_sphere(hn_uint h) { return hn_i_on_sphere(h, hn_rehash(h, 1u)); }

// A uniform number of 15 bits, from the k-th hash. The larger of two is distributed as the root of one, and the largest
// of three as its cube root: as the distances from the middle are in a disk and in a ball.
HN_FN hn_uint hn_i_length(hn_uint h, hn_uint k) { return hn_rehash(h, k) >> 17u; }

// A random direction in the plane.
//   h        any uint; its high bits are the angle
//   example  vec2 n = hn_circle(hn_lattice(ivec2(3, -5), 7u));
//   returns  a vector that is 1 long, within 2^-14; multiples of 2^-16
//   error    none
//   cost     10 multiplications, and 2 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec2 hn_circle(hn_uint h) {
  hn_ivec2 p = hn_i_on_circle(h);
  return vec2(hn_i_component(p.x), hn_i_component(p.y));
}

// A random point of the unit disk, uniform by area: on a lens, or about a position.
//   h        any uint
//   example  vec2 n = hn_disk(hn_lattice(ivec2(3, -5), 7u));
//   returns  a vector that is at most 1 long, or longer by less than 2^-15; multiples of 2^-16
//   error    none
//   cost     16 multiplications, and 2 of floats
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec2 hn_disk(hn_uint h) {
  hn_ivec2 p = hn_i_on_circle(h);
  hn_int size = int(max(hn_i_length(h, 1u), hn_i_length(h, 2u)));
  return vec2(hn_i_component((p.x * size) >> 15), hn_i_component((p.y * size) >> 15));
}

// A random direction in space.
//   h        any uint
//   example  vec3 n = hn_sphere(hn_lattice(ivec2(3, -5), 7u));
//   returns  a vector that is 1 long, within 2^-13; multiples of 2^-16
//   error    none
//   cost     17 multiplications, 5 of floats, and a square root
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec3 hn_sphere(hn_uint h) {
  hn_ivec3 p = hn_i_on_sphere(h);
  return vec3(hn_i_component(p.x), hn_i_component(p.y), hn_i_component(p.z));
}

// A random point of the unit ball, uniform by volume.
//   h        any uint
//   example  vec3 n = hn_ball(hn_lattice(ivec2(3, -5), 7u));
//   returns  a vector that is at most 1 long, or longer by less than 2^-14; multiples of 2^-16
//   error    none
//   cost     26 multiplications, 5 of floats, and a square root
//   source   docs/reference/contract.md, section 18
HN_FN hn_vec3 hn_ball(hn_uint h) {
  hn_ivec3 p = hn_i_on_sphere(h);
  hn_int size = int(max(max(hn_i_length(h, 2u), hn_i_length(h, 3u)), hn_i_length(h, 4u)));
  return vec3(hn_i_component((p.x * size) >> 15), hn_i_component((p.y * size) >> 15),
              hn_i_component((p.z * size) >> 15));
}

// ---------------------------------------------------------------------------------------------------------------------
// Orders, and points one after the other.

// A round permutes the numbers of as many bits as the number most has, which are all set: it folds the high ones onto
// the low ones, and multiplies by an odd number.
HN_FN hn_uint hn_i_shuffle_round(hn_uint x, hn_uint shift, hn_uint key, hn_uint most) {
  hn_uint a = hn_i_scramble(key);
  return ((x ^ (x >> shift)) * (a | 1u) + (a >> 16u)) & most;
}

// The position of an item in a shuffled order of n items, without a table: no two items from 0 to n - 1 have the same
// position.
//   i        the item, or the place in the deck: any uint; from n on it counts modulo n
//   n        how many there are: any uint; 0 counts as 1
//   seed     any uint: 7u, not 7; each has an order of its own
//   example  uint place = hn_shuffle(3u, 52u, 7u);
//   returns  0 to n - 1
//   error    none
//   cost     1 division of integers, 4 multiplications, and 30 for each step. An item takes less than 2 steps on the
//            average, and where n is a power of two always 1. 2 multiplications less for a seed that is constant
//   source   docs/reference/contract.md, section 18
HN_FN hn_uint hn_shuffle(hn_uint i, hn_uint n, hn_uint seed) {
  hn_uint size = max(n, 1u);
  hn_uint most = size - 1u;  // and all bits below its highest
  most |= most >> 1u;
  most |= most >> 2u;
  most |= most >> 4u;
  most |= most >> 8u;
  most |= most >> 16u;
  hn_uint half_of_bits = (hn_i_sum_of_bytes(hn_i_bits_of_bytes(most)) + 1u) >> 1u;
  hn_uint s = hn_i_scramble(seed);
  hn_uint x = i - i / size * size;
  hn_uint value = 0xFFFFFFFFu;  // beyond, until there is one
  // A step permutes the numbers up to most. Its cycle through a number below size comes back to one, so this ends.
  // In C++ x may be many points: those that have a value go on for nothing.
  do {
    hn_uint key = s;
    for (hn_int pair = 0; pair < 5; ++pair) {
      x = hn_i_shuffle_round(x, 1u, key + HN_I_SEED_STEP, most);
      key += 0x3C6EF372u;  // twice HN_I_SEED_STEP, modulo 2^32
      x = hn_i_shuffle_round(x, half_of_bits, key, most);
    }
    value = hn_i_select(value >= size, x, value);
  } while (hn_i_any(value >= size));
  return value;
}

// The bits in the reversed order. GLSL before 4.00 and ES before 3.10 have no function for it.
HN_FN hn_uint hn_i_reversed(hn_uint x) {
  x = (x >> 16u) | (x << 16u);
  x = ((x >> 8u) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8u);
  x = ((x >> 4u) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4u);
  x = ((x >> 2u) & 0x33333333u) | ((x & 0x33333333u) << 2u);
  return ((x >> 1u) & 0x55555555u) | ((x & 0x55555555u) << 1u);
}

// Owen's scrambling of a number whose bits are reversed: each bit is flipped or not by what the bits below it are.
HN_FN hn_uint hn_i_owen(hn_uint x, hn_uint s) {
  x ^= x * 0x3D20ADEAu;
  x += s;
  x *= (s >> 16u) | 1u;
  x ^= x * 0x05526C56u;
  return x ^ (x * 0x53A22864u);
}

// The second axis of Sobol's points with reversed bits: the exclusive or of the rows of Pascal's triangle, modulo 2, of
// the bits that are set. Row k is the polynomial (1 + t)^k, so the sum of rows is the polynomial of i at 1 + t. Since
// (1 + t)^16 = 1 + t^16 modulo 2, and so on, powers of two are taken apart one after the other.
HN_FN hn_uint hn_i_pascal(hn_uint i) {
  i ^= (i >> 16u) & 0x0000FFFFu;
  i ^= (i >> 8u) & 0x00FF00FFu;
  i ^= (i >> 4u) & 0x0F0F0F0Fu;
  i ^= (i >> 2u) & 0x33333333u;
  return i ^ ((i >> 1u) & 0x55555555u);
}

// Points that fill the unit square evenly, one after the other: the places of samples. Noise of samples that take them
// falls faster than that of random ones. Each seed has a sequence of its own, also in its order, so that two of them
// make points in four dimensions: take one for each pixel and purpose.
//   i        the number of the point: any uint, from 0 on
//   seed     any uint: 7u, not 7
//   example  vec2 u = hn_sobol(3u, 7u);
//   returns  a point in [0, 1)^2, multiples of 2^-24. Among 2^(a + b) points, from a multiple of that on, one is in
//            each of the 2^a by 2^b equal boxes of the square, for a + b up to 24
//   error    none
//   cost     20 multiplications, and 2 of floats. 8 less for a seed that is constant
//   source   Sobol; Owen 1995; Laine and Karras 2011; Vegdahl's constants; docs/reference/contract.md, section 18
HN_FN hn_vec2 hn_sobol(hn_uint i, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uint j = hn_i_reversed(hn_i_owen(hn_i_reversed(i), hn_rehash(s, 3u)));
  hn_uint x = hn_i_reversed(hn_i_owen(j, hn_rehash(s, 1u)));
  hn_uint y = hn_i_reversed(hn_i_owen(hn_i_pascal(j), hn_rehash(s, 2u)));
  return vec2(hn_unorm(x), hn_unorm(y));
}

#endif
