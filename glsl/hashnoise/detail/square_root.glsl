// hashnoise: square roots and quotients by them, with the bits that HN_ARITHMETIC promises.
// SPDX-License-Identifier: MIT

#ifndef HN_SQUARE_ROOT_GLSL
#define HN_SQUARE_ROOT_GLSL

#include "arithmetic.glsl"

// The square of a length is a rank: by it lengths are compared. It is a float, or a uint in units of 2^-28.
//
//   hn_i_rank             such a square, or another number that lengths are compared by; hn_i_rank3 and hn_i_rank4 are
//                         vectors of it
//   hn_i_magnitudes(x)         the absolute values of three numbers, as ranks
//   hn_i_squares(x, ...)  the squares of three lengths
//   hn_i_squared(x, ...)  the square of the length of an offset
//   hn_i_root(q)          the square root of a square. In HN_FIXED it is in units of 2^-18, rounded down. The root of a
//                         uint is there with every HN_ARITHMETIC
//   hn_i_over_root(n, q)  n divided by the square root of q, which is not 0. n is the difference of two squares. In
//                         HN_FIXED the square is in units of 2^-26, and the quotient in units of 2^-15, rounded down
//   hn_i_unit(x, ...)     an offset divided by its length; 0 if the length is 0. Its components are floats, and in
//                         HN_FIXED multiples of 2^-21

// These combine each component with the same uint. In Godot and WGSL such operators take two vectors alone, and HLSL
// has no constructor from one number.
HN_FN hn_uvec3 hn_i_and(hn_uvec3 words, hn_uint mask) { return words & uvec3(mask, mask, mask); }
HN_FN hn_uvec3 hn_i_or(hn_uvec3 words, hn_uint mask) { return words | uvec3(mask, mask, mask); }
HN_FN hn_uvec3 hn_i_xor(hn_uvec3 words, hn_uint word) { return words ^ uvec3(word, word, word); }

// The root of a uint is there with every HN_ARITHMETIC. First the root of 2^8 q is guessed in floats. The guess is less
// than 1 off, even if a driver's sqrt is 6 units in the last place off. So the integers around it decide. The rest of
// 2^8 q is small: 32 bits are enough for its sign.
HN_FN hn_uint hn_i_root(hn_uint q) {
  hn_uint v = uint(sqrt(hn_i_float(q)) * 16.0f);
  v = hn_i_select(int((q << 8u) - v * v) < 0, v - 1u, v);
  return hn_i_select(int((q << 8u) - v * v) > int(v + v), v + 1u, v);
}

#if HN_ARITHMETIC != HN_FIXED

#define hn_i_rank hn_float
#define hn_i_rank3 hn_vec3
#define hn_i_rank4 hn_vec4

HN_FN hn_vec3 hn_i_magnitudes(hn_vec3 x) { return abs(x); }
HN_FN hn_vec3 hn_i_squares(hn_vec3 x, hn_vec3 y) {
  HN_I_PRECISE hn_vec3 q = x * x + y * y;
  return q;
}
HN_FN hn_float hn_i_squared(hn_float x, hn_float y) {
  HN_I_PRECISE hn_float q = x * x + y * y;
  return q;
}
HN_FN hn_float hn_i_squared(hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float q = x * x + y * y + z * z;
  return q;
}

#if HN_ARITHMETIC == HN_FAST

HN_FN hn_float hn_i_root(hn_float q) { return sqrt(q); }
HN_FN hn_float hn_i_over_root(hn_float n, hn_float q) { return n / sqrt(q); }

#else  // HN_PRECISE

// GLSL leaves the last bits of a square root open. So this computes 1 / sqrt(q) by Newton's method. The first guess is
// at most 1/28 off, and each step leaves 3/2 of the square of the error. q is 0 or from 2^-100 to 2^100; for 0 the
// result is a large number.
HN_FN hn_float hn_i_reciprocal_root(hn_float q) {
  HN_I_PRECISE hn_float half_q = q * 0.5f;
  HN_I_PRECISE hn_float r = uintBitsToFloat(0x5F375A86u - (floatBitsToUint(q) >> 1u));
  for (hn_int i = 0; i < 3; ++i) r = r * (1.5f - half_q * r * r);
  return r;
}
HN_FN hn_float hn_i_root(hn_float q) { return hn_i_times(q, hn_i_reciprocal_root(q)); }
HN_FN hn_float hn_i_over_root(hn_float n, hn_float q) { return hn_i_times(n, hn_i_reciprocal_root(q)); }

#endif

#define HN_I_TINY_SQUARE (1.0f / 4294967296.0f / 4294967296.0f / 4294967296.0f)  // 2^-96

HN_FN hn_vec2 hn_i_unit(hn_float x, hn_float y) {
  hn_float q = max(hn_i_squared(x, y), HN_I_TINY_SQUARE);
  return vec2(hn_i_over_root(x, q), hn_i_over_root(y, q));
}
HN_FN hn_vec3 hn_i_unit(hn_float x, hn_float y, hn_float z) {
  hn_float q = max(hn_i_squared(x, y, z), HN_I_TINY_SQUARE);
  return vec3(hn_i_over_root(x, q), hn_i_over_root(y, q), hn_i_over_root(z, q));
}

#else  // HN_FIXED

#define hn_i_rank hn_uint
#define hn_i_rank3 hn_uvec3
#define hn_i_rank4 hn_uvec4

// The sizes are uints, since the larger of two uints is right on every driver (see hn_i_magnitude).
HN_FN hn_uvec3 hn_i_magnitudes(hn_ivec3 x) { return uvec3(max(x, x * -1)); }

// An offset is below 4 cells, 2^22, and the square of a length below 16. A square has up to 44 bits, so it is made of
// the products of two digits; each has 11 bits. The mask of the high one shows compilers that its product has factors
// below 2^24. The sum is exact before it is rounded down.
#ifndef HN_I_OWN_SQUARES  // lanes.hpp has its own
HN_FN hn_uvec3 hn_i_high_square(hn_uvec3 a) {
  hn_uvec3 digit = hn_i_and(a >> 11u, 2047u);
  return digit * ((digit << 10u) + hn_i_and(a, 2047u));
}
HN_FN hn_uvec3 hn_i_low_square(hn_uvec3 a) {
  hn_uvec3 digit = hn_i_and(a, 2047u);
  return digit * digit;
}
HN_FN hn_uvec3 hn_i_squares(hn_ivec3 x, hn_ivec3 y) {
  hn_uvec3 a = hn_i_magnitudes(x);
  hn_uvec3 b = hn_i_magnitudes(y);
  return hn_i_high_square(a) + hn_i_high_square(b) + ((hn_i_low_square(a) + hn_i_low_square(b)) >> 12u);
}
HN_FN hn_uvec3 hn_i_squares(hn_ivec3 x, hn_ivec3 y, hn_ivec3 z) {
  hn_uvec3 a = hn_i_magnitudes(x);
  hn_uvec3 b = hn_i_magnitudes(y);
  hn_uvec3 c = hn_i_magnitudes(z);
  return hn_i_high_square(a) + hn_i_high_square(b) + hn_i_high_square(c) +
         ((hn_i_low_square(a) + hn_i_low_square(b) + hn_i_low_square(c)) >> 12u);
}
#endif
HN_FN hn_uint hn_i_squared(hn_int x, hn_int y) { return hn_i_squares(ivec3(x, 0, 0), ivec3(y, 0, 0)).x; }
HN_FN hn_uint hn_i_squared(hn_int x, hn_int y, hn_int z) {
  return hn_i_squares(ivec3(x, 0, 0), ivec3(y, 0, 0), ivec3(z, 0, 0)).x;
}

// A quotient is below 2^19, and its guess less than 1 off, too. s is the root in units of 2^-17.
HN_FN hn_uint hn_i_over_root(hn_uint n, hn_uint q) {
  hn_uint s = hn_i_root(q);
  hn_uint v = uint(hn_i_float(n) * 16.0f / hn_i_float(s));
  hn_int rest = int((n << 4u) - v * s);
  return hn_i_select(rest < 0, v - 1u, hn_i_select(rest >= int(s), v + 1u, v));
}

// The factor by which an offset is multiplied, so that it is 0 or at least 2^17 long and its root has 15 bits. It
// depends on the size of the longest component, which is below 2^21.
HN_FN hn_int hn_i_enlarging_factor(hn_int size) {
  hn_int a = hn_i_select_int(size < 1024, 1024, 1);
  hn_int b = a * hn_i_select_int(size * a < 32768, 32, 1);
  return b * hn_i_select_int(size * b < 131072, 4, 1);
}

// The quotient has two digits, since GLSL's division of integers is exact and has 32 bits.
HN_FN hn_float hn_i_over(hn_int x, hn_uint root) {
  hn_uint size = uint(hn_i_magnitude(x));
  hn_uint high = (size << 11u) / root;
  hn_uint low = (((size << 11u) - high * root) << 8u) / root;
  hn_int quotient = int((high << 8u) + low);
  return HN_I_NOT_WHOLE(hn_i_float(hn_i_select(x < 0, -quotient, quotient)) * (1.0f / HN_I_FLOAT_UNITS_VALUE));
}
HN_FN hn_vec2 hn_i_unit(hn_int x, hn_int y) {
  hn_int m = hn_i_enlarging_factor(max(hn_i_magnitude(x), hn_i_magnitude(y)));
  hn_uint root = max(hn_i_root(hn_i_squared(x * m, y * m)), 1u);
  return vec2(hn_i_over(x * m, root), hn_i_over(y * m, root));
}
HN_FN hn_vec3 hn_i_unit(hn_int x, hn_int y, hn_int z) {
  hn_int m = hn_i_enlarging_factor(max(max(hn_i_magnitude(x), hn_i_magnitude(y)), hn_i_magnitude(z)));
  hn_uint root = max(hn_i_root(hn_i_squared(x * m, y * m, z * m)), 1u);
  return vec3(hn_i_over(x * m, root), hn_i_over(y * m, root), hn_i_over(z * m, root));
}

#endif

#endif
