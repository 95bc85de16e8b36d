// hashnoise: the gradient at a lattice point.
// SPDX-License-Identifier: MIT

#ifndef HN_GRADIENT_GLSL
#define HN_GRADIENT_GLSL

#include "hash.glsl"

// In steps that the corners of a cell share: wrap the coordinates, place them, make a key of x, go on along y and z.
// HN_GRADIENT decides what each step does.

// A cell's coordinates, wrapped by HN_PERIOD, and those of its far corner.
#if HN_PERIOD == 0
HN_FN HN_HIGHP uvec2 hn_i_wrap(HN_HIGHP ivec2 cell) { return uvec2(cell); }
HN_FN HN_HIGHP uvec3 hn_i_wrap(HN_HIGHP ivec3 cell) { return uvec3(cell); }
HN_FN HN_HIGHP uvec2 hn_i_next(HN_HIGHP uvec2 c) { return c + 1u; }
HN_FN HN_HIGHP uvec3 hn_i_next(HN_HIGHP uvec3 c) { return c + 1u; }
#else
#if (HN_PERIOD & (HN_PERIOD - 1)) == 0
HN_FN HN_HIGHP uint hn_i_wrap(HN_HIGHP int c) { return uint(c) & uint(HN_PERIOD - 1); }
HN_FN HN_HIGHP uint hn_i_next(HN_HIGHP uint c) { return (c + 1u) & uint(HN_PERIOD - 1); }
#else
// The remainder of floored division. GLSL leaves % of negative numbers undefined, so those count back from -1.
HN_FN HN_HIGHP uint hn_i_wrap(HN_HIGHP int c) {
  return c < 0 ? uint(HN_PERIOD - 1) - uint(-1 - c) % uint(HN_PERIOD) : uint(c) % uint(HN_PERIOD);
}
HN_FN HN_HIGHP uint hn_i_next(HN_HIGHP uint c) { return c == uint(HN_PERIOD - 1) ? 0u : c + 1u; }
#endif
HN_FN HN_HIGHP uvec2 hn_i_wrap(HN_HIGHP ivec2 cell) { return uvec2(hn_i_wrap(cell.x), hn_i_wrap(cell.y)); }
HN_FN HN_HIGHP uvec3 hn_i_wrap(HN_HIGHP ivec3 cell) {
  return uvec3(hn_i_wrap(cell.x), hn_i_wrap(cell.y), hn_i_wrap(cell.z));
}
HN_FN HN_HIGHP uvec2 hn_i_next(HN_HIGHP uvec2 c) { return uvec2(hn_i_next(c.x), hn_i_next(c.y)); }
HN_FN HN_HIGHP uvec3 hn_i_next(HN_HIGHP uvec3 c) { return uvec3(hn_i_next(c.x), hn_i_next(c.y), hn_i_next(c.z)); }
#endif

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

HN_FN HN_HIGHP uvec2 hn_i_place(HN_HIGHP uvec2 c) { return hn_i_spread(c); }
HN_FN HN_HIGHP uvec3 hn_i_place(HN_HIGHP uvec3 c) { return hn_i_spread(c); }

// The key of a column (x, and the mixed seed s), and of a row of it.
HN_FN HN_HIGHP uint hn_i_column(HN_HIGHP uint x, HN_I_UNUSED HN_HIGHP uint s) { return hn_i_key(x); }
HN_FN HN_HIGHP uint hn_i_row(HN_HIGHP uint column, HN_HIGHP uint y) { return hn_i_key(column, y); }

// The gradient from the last keys and the last coordinate.
HN_FN HN_HIGHP vec2 hn_i_gradient(HN_HIGHP uint column, HN_HIGHP uint y, HN_HIGHP uint s) {
  return hn_gradient2(hn_i_mix(hn_i_key(column, y) ^ s));
}
HN_FN HN_HIGHP vec3 hn_i_gradient(HN_I_UNUSED HN_HIGHP uint column, HN_HIGHP uint row, HN_HIGHP uint z,
                                  HN_HIGHP uint s) {
  return hn_gradient3(hn_i_mix(hn_i_key(row, z) ^ s));
}

#else  // HN_GRADIENT_SINE: the coordinates as they are, the hash as published

HN_FN HN_HIGHP uvec2 hn_i_place(HN_HIGHP uvec2 c) { return c; }
HN_FN HN_HIGHP uvec3 hn_i_place(HN_HIGHP uvec3 c) { return c; }

// The seed comes in behind the first hash: before it, it would only move the field along x.
HN_FN HN_HIGHP uint hn_i_column(HN_HIGHP uint x, HN_HIGHP uint s) { return hn_hash(x) ^ s; }
HN_FN HN_HIGHP uint hn_i_row(HN_HIGHP uint column, HN_HIGHP uint y) { return hn_hash(column + y); }

// How many low bits of m a float has no room for, for m <= 2^31.
HN_FN HN_HIGHP uint hn_i_excess_bits(HN_HIGHP uint m) {
#if HN_I_BITCAST
  // m >> 8 is exact in a float; 142 is the biased exponent of 2^15, which stands for 2^23, the last with no excess.
  return max(floatBitsToUint(float(m >> 8)) >> 23, 142u) - 142u;
#else
  // The length of the highest byte; 2^31, which alone has its highest bit, is the same rounded to 7 or to 8 bits less.
  HN_HIGHP uint b = m >> 24;
  return uint(b >= 1u) + uint(b >= 2u) + uint(b >= 4u) + uint(b >= 8u) + uint(b >= 16u) + uint(b >= 32u) +
         uint(b >= 64u);
#endif
}

// The paper's sin(float(int)), in radians: of a word as a signed integer, rounded to the 24 bits of a float (to
// nearest, ties to even). GLSL says neither how that conversion rounds nor what sin makes of so large an argument.
//   error    below 2^-19
HN_FN HN_HIGHP float hn_i_sine(HN_HIGHP uint w) {
  HN_HIGHP uint m = (w & 0x80000000u) != 0u ? 0u - w : w;
  HN_HIGHP uint k = hn_i_excess_bits(m);
  HN_HIGHP uint unit = 1u << k;
  HN_HIGHP uint rounds = min(k, 1u);
  m = (m + (unit >> 1) - rounds + ((m >> k) & rounds)) & (0u - unit);
  // In turns, modulo 1, in units of 2^-32: m / 2 pi. 0x28BE60DB9391054A is 2^64 / 2 pi.
  HN_HIGHP uint high = m >> 16;
  HN_HIGHP uint low = m & 0xFFFFu;
  HN_HIGHP uint rest = high * 0x054Au + low * 0x9391u;  // in units of 2^-48
  HN_HIGHP uint turns = m * 0x28BE60DBu + high * 0x9391u + (rest >> 16);
  // The first quarter of the wave is enough: mirror the second, negate the second half.
  HN_HIGHP uint q = turns & 0x7FFFFFFFu;
  q = min(q, 0x80000000u - q);
  HN_HIGHP float x = float(q >> 6) * (1.0f / 16777216.0f);
  HN_HIGHP float t = x * x;
  // sin(x pi / 2) on [0, 1] to 6.3e-7: minimax, held at 1 - 2^-21 at the end so that no rounding takes it beyond 1.
  HN_HIGHP float sine = x * (1.57079090f + t * (-0.64589171f + t * (0.07943160f + t * -0.00433127f)));
  return hn_i_signed(sine, turns ^ w);
}

HN_FN HN_HIGHP vec2 hn_i_gradient(HN_HIGHP uint column, HN_HIGHP uint y, HN_I_UNUSED HN_HIGHP uint s) {
  HN_HIGHP uint k = hn_hash(column + y);
  return vec2(hn_i_sine(column + k), hn_i_sine(k + k));
}
HN_FN HN_HIGHP vec3 hn_i_gradient(HN_HIGHP uint column, HN_HIGHP uint row, HN_HIGHP uint z,
                                  HN_I_UNUSED HN_HIGHP uint s) {
  HN_HIGHP uint k = hn_hash(row + z);
  return vec3(hn_i_sine(k + column), hn_i_sine(k + row), hn_i_sine(k + k));
}

#endif

// The gradient of the noise at a lattice point.
//   cell     the point: ivec2 or ivec3
//   seed     any uint, 0 if left out; different seeds give independent fields
//   returns  a point of the square or octahedron |x| + |y| (+ |z|) = 1; with HN_GRADIENT_SINE, of the square or cube
//            [-1, 1]^n
//   error    none; with HN_GRADIENT_SINE less than 2^-19
//   period   2^32 along each axis (see hn_lattice), or HN_PERIOD
//   cost     as hn_lattice; with HN_GRADIENT_SINE 1 hash per axis and a sine of 10 multiplications per component
//   source   for the sine: Valdenegro-Toro and Pincheira, sec. 5
HN_FN HN_HIGHP vec2 hn_gradient(HN_HIGHP ivec2 cell, HN_HIGHP uint seed) {
  HN_HIGHP uvec2 c = hn_i_place(hn_i_wrap(cell));
  HN_HIGHP uint s = hn_i_mix(seed);
  return hn_i_gradient(hn_i_column(c.x, s), c.y, s);
}

HN_FN HN_HIGHP vec3 hn_gradient(HN_HIGHP ivec3 cell, HN_HIGHP uint seed) {
  HN_HIGHP uvec3 c = hn_i_place(hn_i_wrap(cell));
  HN_HIGHP uint s = hn_i_mix(seed);
  HN_HIGHP uint column = hn_i_column(c.x, s);
  return hn_i_gradient(column, hn_i_row(column, c.y), c.z, s);
}

HN_FN HN_HIGHP vec2 hn_gradient(HN_HIGHP ivec2 cell) { return hn_gradient(cell, 0u); }
HN_FN HN_HIGHP vec3 hn_gradient(HN_HIGHP ivec3 cell) { return hn_gradient(cell, 0u); }

#endif
