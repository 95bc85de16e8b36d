// hashnoise: integer hashes, the hash of a lattice point, and the float of a hash.
// SPDX-License-Identifier: MIT
//
// Everything in this file is exact: the same bits on every driver. docs/reference/contract.md defines each value.
//
// A hash is a uint, and so is a seed: hn_hash(7u). For 7, an int, most versions of GLSL find no overload.
//
// In all files a cost counts multiplications, of integers unless it has "of floats". It leaves out ramps, interpolation
// and the cheap factors of 24 bits in sums of coordinates.

#ifndef HN_HASH_GLSL
#define HN_HASH_GLSL

#include "detail/hashes.glsl"
#include "detail/word.glsl"

// The hash of a lattice point and a seed.
HN_FN hn_uint hn_i_point(hn_uvec2 cell, hn_uint seed) {
  return hn_i_seeded_hash(hn_i_spread(cell), hn_i_scramble(seed));
}
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_i_point(hn_uint cell, hn_uint seed) {
  return hn_i_seeded_hash(hn_i_spread(cell), hn_i_scramble(seed));
}
HN_FN hn_uint hn_i_point(hn_uvec3 cell, hn_uint seed) {
  return hn_i_seeded_hash(hn_i_spread(cell), hn_i_scramble(seed));
}
HN_FN hn_uint hn_i_point(hn_uvec4 cell, hn_uint seed) {
  return hn_i_seeded_hash(hn_i_spread(cell), hn_i_scramble(seed));
}

// hn_lattice of spread coordinates and the mixed seed s.
HN_FN hn_uint hn_i_lattice(hn_uvec2 c, hn_uint s) { return hn_i_scramble(hn_i_seeded_hash(c, s) + (hn_i_sum(c) + s)); }
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_i_lattice(hn_uint c, hn_uint s) { return hn_i_scramble(hn_i_seeded_hash(c, s) + (hn_i_sum(c) + s)); }
HN_FN hn_uint hn_i_lattice(hn_uvec3 c, hn_uint s) { return hn_i_scramble(hn_i_seeded_hash(c, s) + (hn_i_sum(c) + s)); }
HN_FN hn_uint hn_i_lattice(hn_uvec4 c, hn_uint s) { return hn_i_scramble(hn_i_seeded_hash(c, s) + (hn_i_sum(c) + s)); }

// The hash of a lattice point, to scatter and vary things: 32 well mixed bits, with any HN_HASH. It is mixed from the
// hash that noises use and from the sum of the coordinates, since the former is 0 at one point in two million.
//   cell     the point: int, ivec2, ivec3 or ivec4
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   example  uint h = hn_lattice(ivec2(3, -5), 7u);
//   returns  any uint; take bits from anywhere in it
//   period   2^32 along each axis
//   cost     1 hash (none with HN_HASH_LATTICE); 1 multiplication per axis and 3 more; 2 more for a seed that is not
//            constant
HN_FN hn_uint hn_lattice(hn_ivec2 cell, hn_uint seed) {
  return hn_i_lattice(hn_i_spread(uvec2(cell)), hn_i_scramble(seed));
}
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_lattice(hn_int cell, hn_uint seed) {
  return hn_i_lattice(hn_i_spread(uint(cell)), hn_i_scramble(seed));
}
HN_FN hn_uint hn_lattice(hn_ivec3 cell, hn_uint seed) {
  return hn_i_lattice(hn_i_spread(uvec3(cell)), hn_i_scramble(seed));
}
HN_FN hn_uint hn_lattice(hn_ivec4 cell, hn_uint seed) {
  return hn_i_lattice(hn_i_spread(uvec4(cell)), hn_i_scramble(seed));
}

HN_FN hn_uint hn_lattice(hn_ivec2 cell) { return hn_lattice(cell, 0u); }
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_lattice(hn_int cell) { return hn_lattice(cell, 0u); }
HN_FN hn_uint hn_lattice(hn_ivec3 cell) { return hn_lattice(cell, 0u); }
HN_FN hn_uint hn_lattice(hn_ivec4 cell) { return hn_lattice(cell, 0u); }

// ---------------------------------------------------------------------------------------------------------------------
// The selected hash as published, of 1 to 4 numbers: H(x), H(H(x) + y), and so on. With HN_HASH_LATTICE, which was not
// published, it is hn_lattice.
//   x, v     the numbers: uint, uvec2, uvec3 or uvec4
//   example  uint h = hn_hash(uvec2(12u, 34u));
//   returns  any uint; it is as good or as weak as the hash
//   cost     1 hash per number (HN_HASH_LATTICE: as hn_lattice)
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
// From a hash to a float. Every step is exact in a 32-bit float, however it is rounded or contracted.

// A random float in [0, 1) from a hash: its high 24 bits.
//   h        any uint
//   example  float u = hn_unorm(hn_lattice(ivec2(3, -5), 7u));
//   returns  [0, 1), a multiple of 2^-24
//   error    none
//   cost     1 multiplication of floats
HN_FN hn_float hn_unorm(hn_uint h) { return HN_I_NOT_WHOLE(hn_i_float(h >> 8u) * (1.0f / 16777216.0f)); }

// A random float in [-1, 1) from a hash: its high 24 bits.
//   h        any uint
//   example  float s = hn_snorm(hn_lattice(ivec2(3, -5), 7u));
//   returns  [-1, 1), a multiple of 2^-23
//   error    none
//   cost     1 multiplication of floats
HN_FN hn_float hn_snorm(hn_uint h) { return HN_I_NOT_WHOLE(hn_i_float(h >> 8u) * (1.0f / 8388608.0f)) - 1.0f; }

#endif
