// hashnoise: the paper's gradient, HN_GRADIENT_SINE.
// SPDX-License-Identifier: MIT

#ifndef HN_SINE_GRADIENT_GLSL
#define HN_SINE_GRADIENT_GLSL

#include "../hash.glsl"
#include "cell.glsl"
#include "sine.glsl"

#if HN_GRADIENT == HN_GRADIENT_SINE

// It takes the coordinates as they are and the hash as published.

// The corners of a cell share these steps: the key of a column (from x and the mixed seed s), the key of a row in it,
// and the gradient. The seed is added after the first hash, since before it the seed would only move the field along x.
HN_FN hn_uint hn_i_column_key(hn_uint x, hn_uint s) { return hn_hash(x) ^ s; }
HN_FN hn_uint hn_i_row_key(hn_uint column, hn_uint y) { return hn_hash(column + y); }

// The number of low bits of m that do not fit into a float, for m <= 2^31.
HN_FN hn_uint hn_i_excess_bits(hn_uint m) {
#if HN_I_BITCAST
  // m >> 8 is exact in a float. 142 is the biased exponent of 2^15: the m that it stands for, from 2^23 on, are the
  // last without excess bits.
  return max(floatBitsToUint(hn_i_float(m >> 8u)) >> 23u, 142u) - 142u;
#else
  // The length of the highest byte, without its bit 7: only 2^31 has that bit, and it is the same with 7 or 8 bits
  // less.
  hn_uint b = m >> 24u;
  return uint(b >= 1u) + uint(b >= 2u) + uint(b >= 4u) + uint(b >= 8u) + uint(b >= 16u) + uint(b >= 32u) +
         uint(b >= 64u);
#endif
}

// The argument of the paper's sin(float(int)), in turns, modulo 1, in units of 2^-32. The hash is taken as a signed
// integer and rounded to the 24 bits of a float (to nearest, ties to even). GLSL does not define how that conversion
// rounds, or the sine of so large an argument. The result is the magnitude's.
HN_FN hn_uint hn_i_turns(hn_uint w) {
  hn_uint m = hn_i_select((w & 0x80000000u) != 0u, 0u - w, w);
  hn_uint k = hn_i_excess_bits(m);
  hn_uint unit = 1u << k;
  hn_uint rounds = min(k, 1u);
  m = (m + (unit >> 1u) - rounds + ((m >> k) & rounds)) & (0u - unit);
  // m / 2 pi. 0x28BE60DB9391054A is 2^64 / 2 pi.
  hn_uint high = m >> 16u;
  hn_uint low = m & 0xFFFFu;
  hn_uint rest = high * 0x054Au + low * 0x9391u;  // in units of 2^-48
  return m * 0x28BE60DBu + high * 0x9391u + (rest >> 16u);
}

// A gradient times an offset (for floats it is in arithmetic.glsl), and the floats of a gradient.
#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec2 hn_i_components(hn_vec2 g) { return g; }
HN_FN hn_vec3 hn_i_components(hn_vec3 g) { return g; }

#else

HN_FN hn_vec2 hn_i_components(hn_ivec2 g) { return vec2(hn_i_float(g.x), hn_i_float(g.y)) * (1.0f / 65536.0f); }
HN_FN hn_vec3 hn_i_components(hn_ivec3 g) {
  return vec3(hn_i_float(g.x), hn_i_float(g.y), hn_i_float(g.z)) * (1.0f / 65536.0f);
}

// Computes a product of 17 and 21 bits, in units of 2^-28: by the high part and by the low byte of g.
HN_FN hn_int hn_i_product(hn_int g, hn_int x) { return (g >> 8) * x + (((g & 255) * x) >> 8); }
HN_FN hn_int hn_i_dot(hn_ivec2 g, hn_int x, hn_int y) { return hn_i_product(g.x, x) + hn_i_product(g.y, y); }
HN_FN hn_int hn_i_dot(hn_ivec3 g, hn_int x, hn_int y, hn_int z) {
  return hn_i_product(g.x, x) + hn_i_product(g.y, y) + hn_i_product(g.z, z);
}

#endif

// The sine of a hash. The comment over hn_gradient has its error.
HN_FN hn_i_num hn_i_sine(hn_uint w) { return hn_i_wave(hn_i_turns(w), w); }

HN_FN hn_i_num2 hn_i_gradient(hn_uint column, hn_uint y) {
  hn_uint k = hn_hash(column + y);
  return hn_i_vector(hn_i_sine(column + k), hn_i_sine(k + k));
}
HN_FN hn_i_num3 hn_i_gradient(hn_uint column, hn_uint row, hn_uint z) {
  hn_uint k = hn_hash(row + z);
  return hn_i_vector(hn_i_sine(k + column), hn_i_sine(k + row), hn_i_sine(k + k));
}

// The coordinates that were spread. The factors are the inverses of those that spread, modulo 2^32; compilers cancel
// the two.
HN_FN hn_uint hn_i_gathered(hn_uint x) { return (x - HN_I_ORIGIN_X) * 0x0E8B2F51u; }
HN_FN hn_uvec2 hn_i_gathered(hn_uvec2 v) { return uvec2(hn_i_gathered(v.x), v.y * 0xB6C92F47u); }
HN_FN hn_uvec3 hn_i_gathered(hn_uvec3 v) { return uvec3(hn_i_gathered(v.x), v.y * 0xB6C92F47u, v.z * 0xA89ED915u); }

HN_FN hn_i_num4 hn_i_ramps(hn_i_cell_corners2 corners, hn_i_num2 f, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uvec2 c0 = hn_i_gathered(corners.lower);
  hn_uvec2 c1 = hn_i_gathered(corners.upper);
  hn_uint k0 = hn_i_column_key(c0.x, s);
  hn_uint k1 = hn_i_column_key(c1.x, s);
  hn_i_num x = hn_i_minus_one(f.x);
  hn_i_num y = hn_i_minus_one(f.y);
  return hn_i_vector(hn_i_dot(hn_i_gradient(k0, c0.y), f.x, f.y), hn_i_dot(hn_i_gradient(k1, c0.y), x, f.y),
                     hn_i_dot(hn_i_gradient(k0, c1.y), f.x, y), hn_i_dot(hn_i_gradient(k1, c1.y), x, y));
}

HN_FN hn_i_num4 hn_i_ramps(hn_i_cell_corners3 corners, hn_i_num3 f, bool back, hn_uint seed) {
  hn_uint s = hn_i_scramble(seed);
  hn_uvec3 c0 = hn_i_gathered(corners.lower);
  hn_uvec3 c1 = hn_i_gathered(corners.upper);
  hn_uint k0 = hn_i_column_key(c0.x, s);
  hn_uint k1 = hn_i_column_key(c1.x, s);
  hn_i_num x = hn_i_minus_one(f.x);
  hn_i_num y = hn_i_minus_one(f.y);
  hn_uint cz = hn_i_select(back, c1.z, c0.z);
  hn_i_num z = hn_i_select(back, hn_i_minus_one(f.z), f.z);
  return hn_i_vector(hn_i_dot(hn_i_gradient(k0, hn_i_row_key(k0, c0.y), cz), f.x, f.y, z),
                     hn_i_dot(hn_i_gradient(k1, hn_i_row_key(k1, c0.y), cz), x, f.y, z),
                     hn_i_dot(hn_i_gradient(k0, hn_i_row_key(k0, c1.y), cz), f.x, y, z),
                     hn_i_dot(hn_i_gradient(k1, hn_i_row_key(k1, c1.y), cz), x, y, z));
}

HN_FN hn_i_num hn_i_bilerp_ramps2(hn_i_num4 n, hn_i_num x, hn_i_num y) { return hn_i_lerp(n, x, y); }
HN_FN hn_i_num hn_i_bilerp_ramps3(hn_i_num4 n, hn_i_num x, hn_i_num y) { return hn_i_lerp(n, x, y); }

// The noise is not scaled, as in the paper.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_scaled2(hn_float n) { return n; }
HN_FN hn_float hn_i_scaled3(hn_float n) { return n; }
#else
HN_FN hn_int hn_i_scaled2(hn_int n) { return n >> 7; }
HN_FN hn_int hn_i_scaled3(hn_int n) { return n >> 7; }
#endif

#endif

#endif
