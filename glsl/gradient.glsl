// hashnoise: the gradient at a lattice point.
// SPDX-License-Identifier: MIT

#ifndef HN_GRADIENT_GLSL
#define HN_GRADIENT_GLSL

#include "arithmetic.glsl"
#include "hash.glsl"

// A cell's coordinates, wrapped by HN_PERIOD, and those of its far corner.
#if HN_PERIOD == 0
HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 cell) { return uvec2(cell); }
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 cell) { return uvec3(cell); }
HN_FN hn_uvec2 hn_i_next(hn_uvec2 c) { return c + 1u; }
HN_FN hn_uvec3 hn_i_next(hn_uvec3 c) { return c + 1u; }
#else
#if (HN_PERIOD & (HN_PERIOD - 1)) == 0
HN_FN hn_uint hn_i_wrap(hn_int c) { return uint(c) & uint(HN_PERIOD - 1); }
HN_FN hn_uint hn_i_next(hn_uint c) { return (c + 1u) & uint(HN_PERIOD - 1); }
#else
// The remainder of floored division. GLSL leaves % of negative numbers undefined, so those count back from -1.
HN_FN hn_uint hn_i_wrap(hn_int c) {
  return c < 0 ? uint(HN_PERIOD - 1) - uint(-1 - c) % uint(HN_PERIOD) : uint(c) % uint(HN_PERIOD);
}
HN_FN hn_uint hn_i_next(hn_uint c) { return c == uint(HN_PERIOD - 1) ? 0u : c + 1u; }
#endif
HN_FN hn_uvec2 hn_i_wrap(hn_ivec2 cell) { return uvec2(hn_i_wrap(cell.x), hn_i_wrap(cell.y)); }
HN_FN hn_uvec3 hn_i_wrap(hn_ivec3 cell) { return uvec3(hn_i_wrap(cell.x), hn_i_wrap(cell.y), hn_i_wrap(cell.z)); }
HN_FN hn_uvec2 hn_i_next(hn_uvec2 c) { return uvec2(hn_i_next(c.x), hn_i_next(c.y)); }
HN_FN hn_uvec3 hn_i_next(hn_uvec3 c) { return uvec3(hn_i_next(c.x), hn_i_next(c.y), hn_i_next(c.z)); }
#endif

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// The spread coordinates of a cell's far corner, from those of its near one.
#if HN_PERIOD == 0
HN_FN hn_uvec2 hn_i_spread_next(hn_uvec2 spread, HN_I_UNUSED hn_uvec2 c) {
  return spread + uvec2(0x9E3779B1u, 0x85EBCA77u);
}
HN_FN hn_uvec3 hn_i_spread_next(hn_uvec3 spread, HN_I_UNUSED hn_uvec3 c) {
  return spread + uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
}
#else
HN_FN hn_uvec2 hn_i_spread_next(HN_I_UNUSED hn_uvec2 spread, hn_uvec2 c) { return hn_i_spread(hn_i_next(c)); }
HN_FN hn_uvec3 hn_i_spread_next(HN_I_UNUSED hn_uvec3 spread, hn_uvec3 c) { return hn_i_spread(hn_i_next(c)); }
#endif

// What a corner adds at a place, given its word.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y) {
  hn_vec2 g = hn_gradient2(h);
  HN_I_PRECISE hn_float n = g.x * x + g.y * y;
  return n;
}
// u and v are the sum and the difference of x and y, and z is twice that: hn_gradient3 without the turn of p and q to
// the axes, halved.
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float u, hn_float v, hn_float z) {
  hn_float p = hn_i_field3p(h);
  hn_float q = hn_i_field3q(h);
  HN_I_PRECISE hn_float m = 0.5f - max(abs(p), abs(q));
  HN_I_PRECISE hn_float n = p * u + q * v + hn_i_signed(m, h) * z;
  return n;
}
#else
// The same with the fields in units of 2^-9. max stands for abs, which drivers got wrong for integers.
HN_FN hn_int hn_i_ramp(hn_uint h, hn_int x, hn_int y) {
  hn_int a = int((h >> 21) & 1022u) - 511;
  hn_int m = 512 - max(a, -a);
  return a * x + m * ((h & 0x80000000u) != 0u ? -y : y);
}
HN_FN hn_int hn_i_ramp(hn_uint h, hn_int u, hn_int v, hn_int z) {
  hn_int p = int((h >> 22) & 510u) - 255;
  hn_int q = int((h >> 14) & 510u) - 255;
  hn_int m = 256 - max(max(p, -p), max(q, -q));
  return p * u + q * v + m * ((h & 0x80000000u) != 0u ? -z : z);
}
#endif

#else  // HN_GRADIENT_SINE: the coordinates as they are, the hash as published

// In steps that the corners of a cell share: the key of a column (x, and the mixed seed s), of a row of it, the
// gradient. The seed comes in behind the first hash: before it, it would only move the field along x.
HN_FN hn_uint hn_i_column(hn_uint x, hn_uint s) { return hn_hash(x) ^ s; }
HN_FN hn_uint hn_i_row(hn_uint column, hn_uint y) { return hn_hash(column + y); }

// How many low bits of m a float has no room for, for m <= 2^31.
HN_FN hn_uint hn_i_excess_bits(hn_uint m) {
#if HN_I_BITCAST
  // m >> 8 is exact in a float; 142 is the biased exponent of 2^15, which stands for 2^23, the last with no excess.
  return max(floatBitsToUint(float(m >> 8)) >> 23, 142u) - 142u;
#else
  // The length of the highest byte; 2^31, which alone has its highest bit, is the same rounded to 7 or to 8 bits less.
  hn_uint b = m >> 24;
  return uint(b >= 1u) + uint(b >= 2u) + uint(b >= 4u) + uint(b >= 8u) + uint(b >= 16u) + uint(b >= 32u) +
         uint(b >= 64u);
#endif
}

// The argument of the paper's sin(float(int)): a word as a signed integer, rounded to the 24 bits of a float (to
// nearest, ties to even), in turns, modulo 1, in units of 2^-32. GLSL says neither how that conversion rounds nor what
// sin makes of so large an argument. The result is that of the magnitude.
HN_FN hn_uint hn_i_turns(hn_uint w) {
  hn_uint m = (w & 0x80000000u) != 0u ? 0u - w : w;
  hn_uint k = hn_i_excess_bits(m);
  hn_uint unit = 1u << k;
  hn_uint rounds = min(k, 1u);
  m = (m + (unit >> 1) - rounds + ((m >> k) & rounds)) & (0u - unit);
  // m / 2 pi. 0x28BE60DB9391054A is 2^64 / 2 pi.
  hn_uint high = m >> 16;
  hn_uint low = m & 0xFFFFu;
  hn_uint rest = high * 0x054Au + low * 0x9391u;  // in units of 2^-48
  return m * 0x28BE60DBu + high * 0x9391u + (rest >> 16);
}

// The first quarter of the wave is enough: mirror the second; the second half is the first, negated. In units of 2^-30
// of a quarter.
HN_FN hn_uint hn_i_quarter(hn_uint turns) {
  hn_uint q = turns & 0x7FFFFFFFu;
  return min(q, 0x80000000u - q);
}

#if HN_ARITHMETIC != HN_FIXED
// The sine of a word.
//   error    below 2^-19
HN_FN hn_float hn_i_sine(hn_uint w) {
  hn_uint turns = hn_i_turns(w);
  hn_float x = float(hn_i_quarter(turns) >> 6) * (1.0f / 16777216.0f);
  HN_I_PRECISE hn_float t = x * x;
  // sin(x pi / 2) on [0, 1] to 6.3e-7: minimax, held at 1 - 2^-21 at the end so that no rounding takes it beyond 1.
  HN_I_PRECISE hn_float sine = x * (1.57079090f + t * (-0.64589171f + t * (0.07943160f + t * -0.00433127f)));
  return hn_i_signed(sine, turns ^ w);
}

HN_FN hn_float hn_i_ramp(hn_vec2 g, hn_float x, hn_float y) {
  HN_I_PRECISE hn_float n = g.x * x + g.y * y;
  return n;
}
HN_FN hn_float hn_i_ramp(hn_vec3 g, hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float n = g.x * x + g.y * y + g.z * z;
  return n;
}

HN_FN hn_vec2 hn_i_gradient_value(hn_vec2 g) { return g; }
HN_FN hn_vec3 hn_i_gradient_value(hn_vec3 g) { return g; }
#else
// Nearly the same polynomial, in units of 2^-16; no larger than 1.
//   error    below 2^-14
HN_FN hn_int hn_i_sine(hn_uint w) {
  hn_uint turns = hn_i_turns(w);
  hn_uint x = min((hn_i_quarter(turns) + 8192u) >> 14, 65535u);
  hn_uint t = (x * x) >> 16;
  hn_uint y = 102943u - ((t * (42328u - ((t * (5208u - ((t * 288u) >> 16))) >> 16))) >> 16);
  hn_int sine = int((x * (y >> 1) + 16384u) >> 15);
  return ((turns ^ w) & 0x80000000u) != 0u ? -sine : sine;
}

// A product of 17 and 21 bits, in units of 2^-28: by the high and by the low byte of g.
HN_FN hn_int hn_i_product(hn_int g, hn_int x) { return (g >> 8) * x + (((g & 255) * x) >> 8); }
HN_FN hn_int hn_i_ramp(hn_ivec2 g, hn_int x, hn_int y) { return hn_i_product(g.x, x) + hn_i_product(g.y, y); }
HN_FN hn_int hn_i_ramp(hn_ivec3 g, hn_int x, hn_int y, hn_int z) {
  return hn_i_product(g.x, x) + hn_i_product(g.y, y) + hn_i_product(g.z, z);
}

HN_FN hn_vec2 hn_i_gradient_value(hn_ivec2 g) { return vec2(g) * (1.0f / 65536.0f); }
HN_FN hn_vec3 hn_i_gradient_value(hn_ivec3 g) { return vec3(g) * (1.0f / 65536.0f); }
#endif

HN_FN hn_num2 hn_i_gradient(hn_uint column, hn_uint y) {
  hn_uint k = hn_hash(column + y);
  return hn_i_num(hn_i_sine(column + k), hn_i_sine(k + k));
}
HN_FN hn_num3 hn_i_gradient(hn_uint column, hn_uint row, hn_uint z) {
  hn_uint k = hn_hash(row + z);
  return hn_i_num(hn_i_sine(k + column), hn_i_sine(k + row), hn_i_sine(k + k));
}

#endif

// The gradient of the noise at a lattice point.
//   cell     the point: ivec2 or ivec3
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  a point of the square or octahedron |x| + |y| (+ |z|) = 1; with HN_GRADIENT_SINE, of the square or cube
//            [-1, 1]^n
//   error    none; with HN_GRADIENT_SINE less than 2^-19 (HN_FIXED: 3.7e-5)
//   period   2^32 along each axis, or HN_PERIOD
//   cost     1 hash (none with HN_HASH_LATTICE), 1 multiplication per axis and 1 more, 2 more for a
//            seed that is no constant; with HN_GRADIENT_SINE 1 hash per
//            axis and a sine of 10 multiplications per component
//   source   for the sine: Valdenegro-Toro and Pincheira, sec. 5
HN_FN hn_vec2 hn_gradient(hn_ivec2 cell, hn_uint seed) {
  hn_uvec2 c = hn_i_wrap(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient2(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  return hn_i_gradient_value(hn_i_gradient(hn_i_column(c.x, s), c.y));
#endif
}

HN_FN hn_vec3 hn_gradient(hn_ivec3 cell, hn_uint seed) {
  hn_uvec3 c = hn_i_wrap(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient3(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  hn_uint column = hn_i_column(c.x, s);
  return hn_i_gradient_value(hn_i_gradient(column, hn_i_row(column, c.y), c.z));
#endif
}

HN_FN hn_vec2 hn_gradient(hn_ivec2 cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec3 hn_gradient(hn_ivec3 cell) { return hn_gradient(cell, 0u); }

#endif
