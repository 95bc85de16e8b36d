// hashnoise: the gradient of a word, the gradient of a lattice point, and what gradients add at a place in a cell.
// SPDX-License-Identifier: MIT

#ifndef HN_GRADIENT_GLSL
#define HN_GRADIENT_GLSL

#include "arithmetic.glsl"
#include "hash.glsl"
#include "lattice.glsl"
#include "turn.glsl"

// Gradients are made of fields: bits of a hash as odd multiples of 2^-9 for the plane, and of 2^-8 for space, in
// (-1, 1). They are symmetric about 0 and never 0. The highest bit is a sign. The fields are taken from the bits
// below it, and no bit is used twice. Bits behind an exponent make a float without a conversion from integer.
#if HN_I_BITCAST
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(uintBitsToFloat(((h >> 8u) & 0x007FC000u) | 0x40000000u), 3.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(uintBitsToFloat(((h >> 8u) & 0x007F8000u) | 0x40000000u), 3.0f - 1.0f / 256.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(uintBitsToFloat((h & 0x007F8000u) | 0x40000000u), 3.0f - 1.0f / 256.0f);
}

// The same of three words at once.
HN_FN hn_vec3 hn_i_of_field_bits(hn_uvec3 bits, hn_float offset) {
  HN_I_PRECISE hn_vec3 x = uintBitsToFloat(hn_i_or(bits, 0x40000000u)) - offset;
  return x;
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return hn_i_of_field_bits(hn_i_and(h >> 8u, 0x007FC000u), 3.0f - 1.0f / 512.0f); }
HN_FN hn_vec3 hn_i_fields3p(hn_uvec3 h) { return hn_i_of_field_bits(hn_i_and(h >> 8u, 0x007F8000u), 3.0f - 1.0f / 256.0f); }
HN_FN hn_vec3 hn_i_fields3q(hn_uvec3 h) { return hn_i_of_field_bits(hn_i_and(h, 0x007F8000u), 3.0f - 1.0f / 256.0f); }
#else
HN_FN hn_float hn_i_field2(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 22u) & 511u) * (1.0f / 256.0f), 1.0f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_field3p(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 23u) & 255u) * (1.0f / 128.0f), 1.0f - 1.0f / 256.0f);
}
HN_FN hn_float hn_i_field3q(hn_uint h) {
  return hn_i_minus(hn_i_float((h >> 15u) & 255u) * (1.0f / 128.0f), 1.0f - 1.0f / 256.0f);
}
HN_FN hn_vec3 hn_i_fields2(hn_uvec3 h) { return vec3(hn_i_field2(h.x), hn_i_field2(h.y), hn_i_field2(h.z)); }
HN_FN hn_vec3 hn_i_fields3p(hn_uvec3 h) { return vec3(hn_i_field3p(h.x), hn_i_field3p(h.y), hn_i_field3p(h.z)); }
HN_FN hn_vec3 hn_i_fields3q(hn_uvec3 h) { return vec3(hn_i_field3q(h.x), hn_i_field3q(h.y), hn_i_field3q(h.z)); }
#endif

// A direction is a point of the square or octahedron |x| + |y| (+ |z|) = 1, and `more`: 1 less its largest component.
// The gradient is the point times 1 + more. That brings its length near 1 in every direction, since noise made of the
// points themselves would show the axes (docs/quality.md). Ramps are lengthened in place of gradients: it is cheaper.
#if HN_ARITHMETIC != HN_FIXED

// The plane: x, y, more.
HN_FN hn_vec3 hn_i_direction2(hn_uint h) {
  hn_float x = hn_i_field2(h);
  hn_float m = hn_i_minus(1.0f, abs(x));
  return vec3(x, hn_i_signed(m, h), min(abs(x), m));
}

// Space: p, q, z, more. Seen along z the octahedron is a square with corners on the axes. p and q run along its sides:
// x = (p + q) / 2 and y = (p - q) / 2. The height above a point of the square is 1 minus the larger of |p| and |q|.
HN_FN hn_vec4 hn_i_direction3(hn_uint h) {
  hn_float p = hn_i_field3p(h);
  hn_float q = hn_i_field3q(h);
  hn_float larger = max(abs(p), abs(q));
  hn_float more = min(hn_i_times_plus(-0.5f, hn_i_plus(abs(p), abs(q)), 1.0f), larger);
  return vec4(p, q, hn_i_signed(hn_i_minus(1.0f, larger), h), more);
}

HN_FN hn_float hn_i_gradient1(hn_uint h) { return hn_i_field2(h); }
HN_FN hn_vec2 hn_i_gradient(hn_vec3 d) { return vec2(hn_i_lengthened(d.x, d.z), hn_i_lengthened(d.y, d.z)); }
HN_FN hn_vec3 hn_i_gradient(hn_vec4 d) {
  hn_float half_length = hn_i_times_plus(0.5f, d.w, 0.5f);
  return vec3(hn_i_times(hn_i_plus(d.x, d.y), half_length), hn_i_times(hn_i_minus(d.x, d.y), half_length),
              hn_i_lengthened(d.z, d.w));
}

// A direction times an offset. In space u = (x + y) / 2, v = (x - y) / 2, and w = z.
HN_FN hn_float hn_i_straight(hn_vec3 d, hn_float x, hn_float y) { return hn_i_dot(vec2(d.x, d.y), x, y); }
HN_FN hn_float hn_i_straight(hn_vec4 d, hn_float u, hn_float v, hn_float w) {
  return hn_i_dot(vec3(d.x, d.y, d.z), u, v, w);
}
HN_FN hn_float hn_i_ramp(hn_float g, hn_float x) { return hn_i_times(g, x); }

// a x - b y
HN_FN hn_float hn_i_cross(hn_float a, hn_float x, hn_float b, hn_float y) {
  HN_I_PRECISE hn_float n = a * x - b * y;
  return n;
}
HN_FN hn_float hn_i_of_offset(hn_float x) { return x; }

// The offsets as ramps in space take them: u and v are made of halves.
HN_FN hn_float hn_i_turned(hn_float x) { return hn_i_times(x, 0.5f); }
HN_FN hn_float hn_i_upright(hn_float z) { return z; }

#else

// The same in units of 2^-9, but p, q and z in units of 2^-8.
HN_FN hn_ivec3 hn_i_direction2(hn_uint h) {
  hn_int x = int((h >> 21u) & 1022u) - 511;
  hn_int m = 512 - hn_i_size(x);
  return ivec3(x, hn_i_signed(m, h), min(512 - m, m));
}
HN_FN hn_ivec4 hn_i_direction3(hn_uint h) {
  hn_int p = int((h >> 22u) & 510u) - 255;
  hn_int q = int((h >> 14u) & 510u) - 255;
  hn_int larger = max(hn_i_size(p), hn_i_size(q));
  return ivec4(p, q, hn_i_signed(256 - larger, h), min(512 - hn_i_size(p) - hn_i_size(q), larger + larger));
}

// Gradients are in units of 2^-29, as ramps are.
HN_FN hn_int hn_i_gradient1(hn_uint h) { return (int((h >> 21u) & 1022u) - 511) << 20; }
HN_FN hn_ivec2 hn_i_gradient(hn_ivec3 d) {
  hn_int s = (512 + d.z) << 11;
  return ivec2(d.x * s, d.y * s);
}
HN_FN hn_ivec3 hn_i_gradient(hn_ivec4 d) {
  hn_int s = (512 + d.w) << 11;
  return ivec3((d.x + d.y) * s, (d.x - d.y) * s, (d.z + d.z) * s);
}

HN_FN hn_int hn_i_straight(hn_ivec3 d, hn_int x, hn_int y) { return d.x * x + d.y * y; }
HN_FN hn_int hn_i_straight(hn_ivec4 d, hn_int u, hn_int v, hn_int w) { return d.x * u + d.y * v + d.z * w; }
HN_FN hn_int hn_i_ramp(hn_int g, hn_int x) { return (g >> 20) * x; }
HN_FN hn_int hn_i_cross(hn_int a, hn_int x, hn_int b, hn_int y) { return a * x - b * y; }

// In four dimensions ramps are in units of 2^-28, since two offsets of a cell fill 30 bits.
HN_FN hn_int hn_i_of_offset(hn_int x) { return x * 256; }

// In space p, q and z have units twice as large, so u = x + y, v = x - y and w = 2 z.
HN_FN hn_int hn_i_turned(hn_int x) { return x; }
HN_FN hn_int hn_i_upright(hn_int z) { return z + z; }

#endif

// What a corner adds.
HN_FN hn_num hn_i_ramp(hn_num3 d, hn_num x, hn_num y) { return hn_i_lengthened(hn_i_straight(d, x, y), d.z); }
HN_FN hn_num hn_i_ramp(hn_num4 d, hn_num u, hn_num v, hn_num w) {
  return hn_i_lengthened(hn_i_straight(d, u, v, w), d.w);
}

// ---------------------------------------------------------------------------------------------------------------------
// Gradients that turn with a phase. On the plane all turn alike. In space each turns in the plane of the two axes along
// which it is longest; its component along the third shrinks to nothing in a quarter of a turn, and comes back
// negative.

// Along which axis a direction in space is shortest: chooses among what belongs to x, to y and to z.
HN_FN hn_num hn_i_by_shortest(hn_num4 d, hn_num x, hn_num y, hn_num z) {
  hn_num a = hn_i_plus(d.x, d.y);   // twice the direction along x
  hn_num b = hn_i_minus(d.x, d.y);  // along y
  hn_num along_x = hn_i_size(a);
  hn_num along_y = hn_i_size(b);
  hn_num along_z = hn_i_plus(hn_i_size(d.z), hn_i_size(d.z));
  return hn_i_select(along_z <= min(along_x, along_y), z, hn_i_select(along_y <= along_x, y, x));
}

HN_FN hn_num hn_i_ramp(hn_num3 d, hn_num x, hn_num y, hn_num2 rotation) {
  return hn_i_lengthened(hn_i_mixed(rotation, hn_i_straight(d, x, y), hn_i_cross(d.x, y, d.y, x)), d.z);
}
HN_FN hn_num hn_i_ramp(hn_num4 d, hn_num x, hn_num y, hn_num z, hn_num2 rotation) {
  hn_num u = hn_i_turned(x);
  hn_num v = hn_i_turned(y);
  hn_num w = hn_i_turned(z);
  hn_num a = hn_i_plus(d.x, d.y);
  hn_num b = hn_i_minus(d.x, d.y);
  hn_num m = hn_i_plus(d.z, d.z);
  hn_num turned = hn_i_by_shortest(d, hn_i_cross(b, w, m, v), hn_i_cross(m, u, a, w), hn_i_cross(a, v, b, u));
  return hn_i_lengthened(
      hn_i_mixed(rotation, hn_i_straight(d, hn_i_plus(u, v), hn_i_minus(u, v), hn_i_upright(z)), turned), d.w);
}

HN_FN hn_num2 hn_i_rotated(hn_num2 g, hn_num2 rotation) {
  return hn_i_num(hn_i_mixed(rotation, g.x, -g.y), hn_i_mixed(rotation, g.y, g.x));
}
HN_FN hn_num2 hn_i_gradient(hn_num3 d, hn_num2 rotation) { return hn_i_rotated(hn_i_gradient(d), rotation); }
HN_FN hn_num3 hn_i_gradient(hn_num4 d, hn_num2 rotation) {
  hn_num3 g = hn_i_gradient(d);
  hn_num none = hn_i_minus(HN_I_ONE, HN_I_ONE);
  return hn_i_num(hn_i_mixed(rotation, g.x, hn_i_by_shortest(d, none, g.z, -g.y)),
                  hn_i_mixed(rotation, g.y, hn_i_by_shortest(d, -g.z, none, g.x)),
                  hn_i_mixed(rotation, g.z, hn_i_by_shortest(d, g.y, -g.x, none)));
}

// In four dimensions a gradient is one of the 24 corners of the 24-cell: two components are 1 or -1, and two are 0. The
// 24 are as isotropic as a sphere up to the fifth harmonic. The size of the word chooses one of three ways to pair the
// axes: xy and zw below the first third, xw and yz from the second third on, and xz and yw between. Bit 20 chooses the
// second pair, and bits 19 and 18 are the signs.
HN_FN hn_num hn_i_ramp(hn_uint h, hn_num x, hn_num y, hn_num z, hn_num w) {
  hn_uint second = h & 0x00100000u;
  hn_num a = hn_i_select(second != 0u, hn_i_select(h < 0x55555555u, z, y), x);
  hn_num b = hn_i_select(second != 0u, hn_i_select(h < 0xAAAAAAAAu, w, z),
                         hn_i_select(h < 0x55555555u, y, hn_i_select(h < 0xAAAAAAAAu, z, w)));
  return hn_i_of_offset(hn_i_plus(hn_i_flipped(a, h << 12u), hn_i_flipped(b, h << 13u)));
}

// The components of such a gradient, in the numbers of its ramps. None is -0.
HN_FN hn_num4 hn_i_gradient4(hn_uint h) {
  hn_uint second = h & 0x00100000u;
  hn_num none = hn_i_minus(HN_I_ONE, HN_I_ONE);
  hn_num a = hn_i_of_offset(hn_i_flipped(HN_I_ONE, h << 12u));
  hn_num b = hn_i_of_offset(hn_i_flipped(HN_I_ONE, h << 13u));
  hn_num a1 = hn_i_select(second != 0u, none, a);  // of the first pair
  hn_num b1 = hn_i_select(second != 0u, none, b);
  hn_num a2 = hn_i_select(second != 0u, a, none);  // of the second
  hn_num b2 = hn_i_select(second != 0u, b, none);
  return hn_i_num(a1, hn_i_select(h < 0x55555555u, b1, a2),
                  hn_i_select(h < 0x55555555u, a2, hn_i_select(h < 0xAAAAAAAAu, b1, b2)),
                  hn_i_select(h < 0xAAAAAAAAu, b2, b1));
}

// A gradient on the line, from bits 22 to 30 of a hash.
//   h        any uint
//   returns  an odd multiple of 2^-9 in (-1, 1)
//   error    none
//   cost     no multiplication (GLSL before 3.30: 1 of floats)
//   source   docs/contract.md, section 4
HN_FN hn_float hn_gradient1(hn_uint h) { return hn_i_field2(h); }

// A gradient in the plane, from the high 10 bits of a hash.
//   h        any uint
//   returns  a vector that is 0.98 to 1.06 long, in any direction; multiples of 2^-18
//   error    none
//   cost     2 multiplications of floats (GLSL before 3.30: 3)
//   source   docs/contract.md, section 4
HN_FN hn_vec2 hn_gradient2(hn_uint h) {
#if HN_ARITHMETIC != HN_FIXED
  return hn_i_gradient(hn_i_direction2(h));
#else
  hn_ivec2 g = hn_i_gradient(hn_i_direction2(h));
  return vec2(hn_i_float(g.x), hn_i_float(g.y)) * (1.0f / 536870912.0f);
#endif
}

// A gradient in space, from the high 17 bits of a hash.
//   h        any uint
//   returns  a vector that is 0.91 to 1.06 long, in any direction; multiples of 2^-16
//   error    none
//   cost     3 multiplications of floats (GLSL before 3.30: 5)
//   source   docs/contract.md, section 4
HN_FN hn_vec3 hn_gradient3(hn_uint h) {
#if HN_ARITHMETIC != HN_FIXED
  return hn_i_gradient(hn_i_direction3(h));
#else
  hn_ivec3 g = hn_i_gradient(hn_i_direction3(h));
  return vec3(hn_i_float(g.x), hn_i_float(g.y), hn_i_float(g.z)) * (1.0f / 536870912.0f);
#endif
}

// A gradient in four dimensions, from the high 14 bits of a hash.
//   h        any uint
//   returns  two components that are 1 or -1, and two that are 0
//   error    none
//   cost     no multiplication
//   source   docs/contract.md, section 4
HN_FN hn_vec4 hn_gradient4(hn_uint h) {
#if HN_ARITHMETIC != HN_FIXED
  return hn_i_gradient4(h);
#else
  hn_ivec4 g = hn_i_gradient4(h);
  return vec4(hn_i_float(g.x), hn_i_float(g.y), hn_i_float(g.z), hn_i_float(g.w)) * (1.0f / 268435456.0f);
#endif
}

// ---------------------------------------------------------------------------------------------------------------------
// Each HN_GRADIENT offers these functions to a noise on the plane and in space:
//
//   hn_i_ramps(box, f, seed)          what the corners 00, 10, 01, 11 of a cell add at the place f in it
//   hn_i_ramps(box, f, back, seed)    in space, the same for the corners of its front face or of its back face along z
//   hn_i_scaled2(n), hn_i_scaled3(n)  noise that is interpolated between ramps, on the plane and in space, in [-1, 1]

// 1365 / 1024 and 1228 / 1024 are 1 / 0.75 and 1 / 0.833334, rounded down. These are the largest values that a noise
// has before it is scaled, on the plane and in space (tools/bounds). On the line it is 1/2, and in four dimensions
// 1.073455.
HN_FN hn_num hn_i_scaled1(hn_num n) { return hn_i_scaled(n, 2048); }
HN_FN hn_num hn_i_scaled4(hn_num n) { return hn_i_scaled_ramps(n, 953); }

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

HN_FN hn_num4 hn_i_ramps(hn_i_box2 box, hn_num2 f, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(box, seed);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  return hn_i_num(hn_i_ramp(hn_i_direction2(h.x), f.x, f.y), hn_i_ramp(hn_i_direction2(h.y), x, f.y),
                  hn_i_ramp(hn_i_direction2(h.z), f.x, y), hn_i_ramp(hn_i_direction2(h.w), x, y));
}

// The ramps of a face, given the directions of its corners.
HN_FN hn_num4 hn_i_ramps(hn_num4 d00, hn_num4 d10, hn_num4 d01, hn_num4 d11, hn_num3 f, bool back) {
  hn_num x = hn_i_turned(f.x);
  hn_num y = hn_i_turned(f.y);
  hn_num step = hn_i_turned(HN_I_ONE);
  hn_num u = hn_i_plus(x, y);
  hn_num v = hn_i_minus(x, y);
  hn_num w = hn_i_upright(hn_i_select(back, hn_i_far(f.z), f.z));
  hn_num u1 = hn_i_minus(u, step);
  return hn_i_num(hn_i_ramp(d00, u, v, w), hn_i_ramp(d10, u1, hn_i_minus(v, step), w),
                  hn_i_ramp(d01, u1, hn_i_plus(v, step), w), hn_i_ramp(d11, hn_i_minus(u1, step), v, w));
}

HN_FN hn_num4 hn_i_ramps(hn_i_box3 box, hn_num3 f, bool back, hn_uint seed) {
  hn_uvec4 h = hn_i_corners(box, back, seed);
  return hn_i_ramps(hn_i_direction3(h.x), hn_i_direction3(h.y), hn_i_direction3(h.z), hn_i_direction3(h.w), f, back);
}

HN_FN hn_num hn_i_scaled2(hn_num n) { return hn_i_scaled(n, 1365); }
HN_FN hn_num hn_i_scaled3(hn_num n) { return hn_i_scaled(n, 1228); }

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
  return max(floatBitsToUint(hn_i_float(m >> 8u)) >> 23u, 142u) - 142u;
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

// The sine of a word. The comment over hn_gradient tells its error.
HN_FN hn_num hn_i_sine(hn_uint w) { return hn_i_wave(hn_i_turns(w), w); }

HN_FN hn_num2 hn_i_gradient(hn_uint column, hn_uint y) {
  hn_uint k = hn_hash(column + y);
  return hn_i_num(hn_i_sine(column + k), hn_i_sine(k + k));
}
HN_FN hn_num3 hn_i_gradient(hn_uint column, hn_uint row, hn_uint z) {
  hn_uint k = hn_hash(row + z);
  return hn_i_num(hn_i_sine(k + column), hn_i_sine(k + row), hn_i_sine(k + k));
}

// The coordinates that were spread. The factors are the inverses of those that spread, modulo 2^32; compilers cancel
// the two.
HN_FN hn_uint hn_i_gathered(hn_uint x) { return (x - HN_I_ORIGIN_X) * 0x0E8B2F51u; }
HN_FN hn_uvec2 hn_i_gathered(hn_uvec2 v) { return uvec2(hn_i_gathered(v.x), v.y * 0xB6C92F47u); }
HN_FN hn_uvec3 hn_i_gathered(hn_uvec3 v) { return uvec3(hn_i_gathered(v.x), v.y * 0xB6C92F47u, v.z * 0xA89ED915u); }

HN_FN hn_num4 hn_i_ramps(hn_i_box2 box, hn_num2 f, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec2 c0 = hn_i_gathered(box.first);
  hn_uvec2 c1 = hn_i_gathered(box.last);
  hn_uint k0 = hn_i_column(c0.x, s);
  hn_uint k1 = hn_i_column(c1.x, s);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  return hn_i_num(hn_i_dot(hn_i_gradient(k0, c0.y), f.x, f.y), hn_i_dot(hn_i_gradient(k1, c0.y), x, f.y),
                  hn_i_dot(hn_i_gradient(k0, c1.y), f.x, y), hn_i_dot(hn_i_gradient(k1, c1.y), x, y));
}

HN_FN hn_num4 hn_i_ramps(hn_i_box3 box, hn_num3 f, bool back, hn_uint seed) {
  hn_uint s = hn_i_mix(seed);
  hn_uvec3 c0 = hn_i_gathered(box.first);
  hn_uvec3 c1 = hn_i_gathered(box.last);
  hn_uint k0 = hn_i_column(c0.x, s);
  hn_uint k1 = hn_i_column(c1.x, s);
  hn_num x = hn_i_far(f.x);
  hn_num y = hn_i_far(f.y);
  hn_uint cz = hn_i_select(back, c1.z, c0.z);
  hn_num z = hn_i_select(back, hn_i_far(f.z), f.z);
  return hn_i_num(hn_i_dot(hn_i_gradient(k0, hn_i_row(k0, c0.y), cz), f.x, f.y, z),
                  hn_i_dot(hn_i_gradient(k1, hn_i_row(k1, c0.y), cz), x, f.y, z),
                  hn_i_dot(hn_i_gradient(k0, hn_i_row(k0, c1.y), cz), f.x, y, z),
                  hn_i_dot(hn_i_gradient(k1, hn_i_row(k1, c1.y), cz), x, y, z));
}

// The noise is not scaled, as in the paper.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_scaled2(hn_float n) { return n; }
HN_FN hn_float hn_i_scaled3(hn_float n) { return n; }
#else
HN_FN hn_int hn_i_scaled2(hn_int n) { return n >> 7; }
HN_FN hn_int hn_i_scaled3(hn_int n) { return n >> 7; }
#endif

#endif

// The gradient of the noise at a lattice point.
//   cell     the point: int, ivec2, ivec3 or ivec4
//   seed     any uint: 7u, not 7; 0 if left out; different seeds give independent fields
//   returns  a vector of hn_gradient1, hn_gradient2, hn_gradient3 or hn_gradient4; with HN_GRADIENT_SINE, in 2D and 3D,
//            a point of the square or cube [-1, 1]^n
//   error    none; with HN_GRADIENT_SINE less than 2^-19 (HN_FIXED: 3.7e-5)
//   period   2^32 along each axis
//   cost     1 hash (none with HN_HASH_LATTICE), 1 multiplication per axis and 1 more, 2 more for a seed that is not
//            constant, and those of hn_gradient1 to hn_gradient4; with HN_GRADIENT_SINE 1 hash per axis and a sine of
//            10 multiplications, 6 of them of floats, per component
//   source   docs/contract.md, section 4; for the sine: Valdenegro-Toro and Pincheira, sec. 5
HN_FN hn_float hn_gradient(hn_int cell, hn_uint seed) { return hn_gradient1(hn_i_point(uint(cell), seed)); }

HN_FN hn_vec2 hn_gradient(hn_ivec2 cell, hn_uint seed) {
  hn_uvec2 c = uvec2(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient2(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  return hn_i_components(hn_i_gradient(hn_i_column(c.x, s), c.y));
#endif
}

HN_FN hn_vec3 hn_gradient(hn_ivec3 cell, hn_uint seed) {
  hn_uvec3 c = uvec3(cell);
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  return hn_gradient3(hn_i_point(c, seed));
#else
  hn_uint s = hn_i_mix(seed);
  hn_uint column = hn_i_column(c.x, s);
  return hn_i_components(hn_i_gradient(column, hn_i_row(column, c.y), c.z));
#endif
}

HN_FN hn_vec4 hn_gradient(hn_ivec4 cell, hn_uint seed) { return hn_gradient4(hn_i_point(uvec4(cell), seed)); }

HN_FN hn_float hn_gradient(hn_int cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec2 hn_gradient(hn_ivec2 cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec3 hn_gradient(hn_ivec3 cell) { return hn_gradient(cell, 0u); }
HN_FN hn_vec4 hn_gradient(hn_ivec4 cell) { return hn_gradient(cell, 0u); }

#endif
