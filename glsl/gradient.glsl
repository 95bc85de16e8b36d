// hashnoise: the gradient of a word, the gradient of a lattice point, and what gradients add at a place in a cell.
// SPDX-License-Identifier: MIT

#ifndef HN_GRADIENT_GLSL
#define HN_GRADIENT_GLSL

#include "arithmetic.glsl"
#include "hash.glsl"
#include "lattice.glsl"

// Gradients are made of fields: bits of a hash as odd multiples of 2^-9, in (-1, 1) for the plane and in (-1/2, 1/2)
// for space. They are symmetric about 0 and never 0. The highest bit is a sign. The fields are taken from the bits
// below it, and no bit is used twice. Bits behind an exponent make a float without a conversion from integer.
#if HN_I_BITCAST
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(uintBitsToFloat(((h >> 8u) & 0x007FC000u) | 0x40000000u), 3.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(uintBitsToFloat(((h >> 8u) & 0x007F8000u) | 0x3F800000u), 1.5f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(uintBitsToFloat((h & 0x007F8000u) | 0x3F800000u), 1.5f - 1.0f / 512.0f);
}
#else
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(float((h >> 22u) & 511u) * (1.0f / 256.0f), 1.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(float((h >> 23u) & 255u) * (1.0f / 256.0f), 0.5f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(float((h >> 15u) & 255u) * (1.0f / 256.0f), 0.5f - 1.0f / 512.0f);
}
#endif

// A gradient in the plane, from the high 10 bits of a hash.
//   h        any uint
//   returns  a point of the square |x| + |y| = 1, uniform along its sides; multiples of 2^-9
//   error    none
//   cost     no multiplication (GLSL before 3.30: 1 of floats)
//   source   docs/contract.md, section 4
HN_FN hn_vec2 hn_gradient2(hn_uint h) {
  hn_float x = hn_i_field2(h);
  return vec2(x, hn_i_signed(hn_i_minus(1.0f, abs(x)), h));
}

// A gradient in space, from the high 17 bits of a hash.
//   h        any uint
//   returns  a point of the octahedron |x| + |y| + |z| = 1, uniform in area; multiples of 2^-8
//   error    none
//   cost     1 multiplication of floats (GLSL before 3.30: 3)
//   source   docs/contract.md, section 4
HN_FN hn_vec3 hn_gradient3(hn_uint h) {
  // Seen along z the octahedron is a square with corners on the axes. p and q run along its sides. The height above a
  // point of the square is 1 minus twice the larger of |p| and |q|.
  hn_float p = hn_i_field3p(h);
  hn_float q = hn_i_field3q(h);
  return vec3(p + q, p - q, hn_i_signed(1.0f - 2.0f * max(abs(p), abs(q)), h));
}

// ---------------------------------------------------------------------------------------------------------------------
// Each HN_GRADIENT offers these functions to a noise:
//
//   hn_i_ramps(c, f, seed)        what the corners 00, 10, 01, 11 of a cell add at the place f in it; c is the first
//   hn_i_ramps(c, f, back, seed)  in space, the same for the corners of its front face or of its back face along z
//   hn_i_scaled2(n)               noise that is interpolated between ramps, scaled to [-1, 1]; in space hn_i_scaled3(n)

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// What a corner adds, given its word.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y) { return hn_i_dot(hn_gradient2(h), x, y); }
// u = x + y, v = x - y, and z is doubled. This is hn_gradient3 without turning p and q to the axes; m is half its
// height.
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float u, hn_float v, hn_float z) {
  hn_float p = hn_i_field3p(h);
  hn_float q = hn_i_field3q(h);
  hn_float m = hn_i_minus(0.5f, max(abs(p), abs(q)));
  return hn_i_dot(vec3(p, q, hn_i_signed(m, h)), u, v, z);
}
#else
// The same with the fields in units of 2^-9. max stands for abs, which drivers got wrong for integers.
HN_FN hn_int hn_i_ramp(hn_uint h, hn_int x, hn_int y) {
  hn_int a = int((h >> 21u) & 1022u) - 511;
  hn_int m = 512 - max(a, -a);
  return a * x + m * hn_i_signed(y, h);
}
HN_FN hn_int hn_i_ramp(hn_uint h, hn_int u, hn_int v, hn_int z) {
  hn_int p = int((h >> 22u) & 510u) - 255;
  hn_int q = int((h >> 14u) & 510u) - 255;
  hn_int m = 256 - max(max(p, -p), max(q, -q));
  return p * u + q * v + m * hn_i_signed(z, h);
}
#endif

HN_FN hn_num4 hn_i_ramps(hn_uvec2 c, hn_num2 f, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(c, seed);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  return hn_i_num(hn_i_ramp(h.x, f.x, f.y), hn_i_ramp(h.y, x, f.y), hn_i_ramp(h.z, f.x, y), hn_i_ramp(h.w, x, y));
}

HN_FN hn_num4 hn_i_ramps(hn_uvec3 c, hn_num3 f, bool back, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(c, back, seed);
  hn_num u = hn_i_plus(f.x, f.y);
  hn_num v = hn_i_minus(f.x, f.y);
  hn_num w0 = hn_i_plus(f.z, f.z);
  hn_num w = hn_i_select(back, hn_i_minus(w0, HN_I_TWO), w0);
  hn_num u1 = hn_i_minus(u, HN_I_ONE);
  return hn_i_num(hn_i_ramp(h.x, u, v, w), hn_i_ramp(h.y, u1, hn_i_minus(v, HN_I_ONE), w),
                  hn_i_ramp(h.z, u1, hn_i_plus(v, HN_I_ONE), w), hn_i_ramp(h.w, hn_i_minus(u, HN_I_TWO), v, w));
}

// 1913 / 1024 and 1819 / 1024 are 1 / 0.535276 and 1 / 0.562902, rounded down. These are the largest values that a
// noise has before it is scaled, on the plane and in space (tools/bounds).
HN_FN hn_num hn_i_scaled2(hn_num n) { return hn_i_scaled(n, 1913); }
HN_FN hn_num hn_i_scaled3(hn_num n) { return hn_i_scaled(n, 1819); }

#else  // HN_GRADIENT_SINE takes the coordinates as they are and the hash as published

// The corners of a cell share these steps: the key of a column (from x and the mixed seed s), the key of a row in it,
// and the gradient. The seed is added after the first hash, since before it the seed would only move the field along x.
HN_FN hn_uint hn_i_column(hn_uint x, hn_uint s) { return hn_hash(x) ^ s; }
HN_FN hn_uint hn_i_row(hn_uint column, hn_uint y) { return hn_hash(column + y); }

// The number of low bits of m that do not fit into a float, for m <= 2^31.
HN_FN hn_uint hn_i_excess_bits(hn_uint m) {
#if HN_I_BITCAST
  // m >> 8 is exact in a float. 142 is the biased exponent of 2^15: the m that it stands for, from 2^23 on, are the
  // last without excess bits.
  return max(floatBitsToUint(float(m >> 8u)) >> 23u, 142u) - 142u;
#else
  // The length of the highest byte, without its bit 7: only 2^31 has that bit, and it is the same with 7 or 8 bits
  // less.
  hn_uint b = m >> 24u;
  return uint(b >= 1u) + uint(b >= 2u) + uint(b >= 4u) + uint(b >= 8u) + uint(b >= 16u) + uint(b >= 32u) +
         uint(b >= 64u);
#endif
}

// The argument of the paper's sin(float(int)), in turns, modulo 1, in units of 2^-32. The word is taken as a signed
// integer and rounded to the 24 bits of a float (to nearest, ties to even). GLSL does not define how that conversion
// rounds, or the sine of so large an argument. The result is that of the magnitude.
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

// The first quarter of the wave is enough: the second is its mirror image, and the second half is the first, negated.
// The result is in units of 2^-30 of a quarter.
HN_FN hn_uint hn_i_quarter(hn_uint turns) {
  hn_uint q = turns & 0x7FFFFFFFu;
  return min(q, 0x80000000u - q);
}

// The sine of a word. The comment over hn_gradient tells its error.
HN_FN hn_num hn_i_sine(hn_uint w) {
  hn_uint turns = hn_i_turns(w);
  return hn_i_signed(hn_i_quarter_sine(hn_i_quarter(turns)), turns ^ w);
}

HN_FN hn_num2 hn_i_gradient(hn_uint column, hn_uint y) {
  hn_uint k = hn_hash(column + y);
  return hn_i_num(hn_i_sine(column + k), hn_i_sine(k + k));
}
HN_FN hn_num3 hn_i_gradient(hn_uint column, hn_uint row, hn_uint z) {
  hn_uint k = hn_hash(row + z);
  return hn_i_num(hn_i_sine(k + column), hn_i_sine(k + row), hn_i_sine(k + k));
}

HN_FN hn_num4 hn_i_ramps(hn_uvec2 c, hn_num2 f, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uint k0 = hn_i_column(c.x, s);
  hn_uint k1 = hn_i_column(hn_i_next(c.x), s);
  hn_uint cy = hn_i_next(c.y);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  return hn_i_num(hn_i_dot(hn_i_gradient(k0, c.y), f.x, f.y), hn_i_dot(hn_i_gradient(k1, c.y), x, f.y),
                  hn_i_dot(hn_i_gradient(k0, cy), f.x, y), hn_i_dot(hn_i_gradient(k1, cy), x, y));
}

HN_FN hn_num4 hn_i_ramps(hn_uvec3 c, hn_num3 f, bool back, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uint k0 = hn_i_column(c.x, s);
  hn_uint k1 = hn_i_column(hn_i_next(c.x), s);
  hn_uint cy = hn_i_next(c.y);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  hn_uint cz = hn_i_select(back, hn_i_next(c.z), c.z);
  hn_num z = hn_i_select(back, hn_i_far(f.z), f.z);
  return hn_i_num(hn_i_dot(hn_i_gradient(k0, hn_i_row(k0, c.y), cz), f.x, f.y, z),
                  hn_i_dot(hn_i_gradient(k1, hn_i_row(k1, c.y), cz), x, f.y, z),
                  hn_i_dot(hn_i_gradient(k0, hn_i_row(k0, cy), cz), f.x, y, z),
                  hn_i_dot(hn_i_gradient(k1, hn_i_row(k1, cy), cz), x, y, z));
}

// The noise is not scaled, as in the paper.
HN_FN hn_num hn_i_scaled2(hn_num n) { return hn_i_unscaled(n); }
HN_FN hn_num hn_i_scaled3(hn_num n) { return hn_i_unscaled(n); }

#endif

// The gradient of the noise at a lattice point.
//   cell     the point: ivec2 or ivec3
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  a point of the square or octahedron |x| + |y| (+ |z|) = 1; with HN_GRADIENT_SINE, of the square or cube
//            [-1, 1]^n
//   error    none; with HN_GRADIENT_SINE less than 2^-19 (HN_FIXED: 3.7e-5)
//   period   2^32 along each axis, or HN_PERIOD
//   cost     1 hash (none with HN_HASH_LATTICE), 1 multiplication per axis and 1 more, and 2 more for a seed that
//            is not constant; with HN_GRADIENT_SINE 1 hash per axis and a sine of 10 multiplications, 6 of them of
//            floats, per component
//   source   docs/contract.md, section 4; for the sine: Valdenegro-Toro and Pincheira, sec. 5
HN_FN hn_vec2 hn_gradient(hn_ivec2 cell, hn_uint seed) {
  hn_uvec2 c = hn_i_wrap(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient2(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  return hn_i_components(hn_i_gradient(hn_i_column(c.x, s), c.y));
#endif
}

HN_FN hn_vec3 hn_gradient(hn_ivec3 cell, hn_uint seed) {
  hn_uvec3 c = hn_i_wrap(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient3(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  hn_uint column = hn_i_column(c.x, s);
  return hn_i_components(hn_i_gradient(column, hn_i_row(column, c.y), c.z));
#endif
}

HN_FN hn_vec2 hn_gradient(hn_ivec2 cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec3 hn_gradient(hn_ivec3 cell) { return hn_gradient(cell, 0u); }

#endif
