// hashnoise: the gradient of a word on the line, on the plane and in space, and what it adds at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_GLSL
#define HN_DIRECTION_GLSL

#include "arithmetic.glsl"

// On the plane a gradient has one of 8 directions: (3, 1) / 4 and (1, 3) / 4, with signs. In space it is one of the 12
// edges of a cube: two components are 1 or -1, and one is 0. Both sets are alike along all axes and diagonals, so noise
// has the spectrum that gradients of all directions would give it.
//
//   hn_i_offset(x)                   an offset as a float
//   hn_i_direction2(h)               a gradient on the plane, as floats
//   hn_i_signs(h)                    the components of a gradient in space that are not 0
//   hn_i_pair(h, x, y, z)            the offsets along their two axes
//   hn_i_along2(g, x, y)             a gradient times an offset. In HN_FIXED in units of 2^-22, and in those of offsets,
//   hn_i_along3(s, a, b)             2^-20, in space; hn_i_ramp_of2, 3 take it to the units of ramps
//   hn_i_ramp2(h, x, y)              the ramp of a word; hn_i_ramp3(h, x, y, z)
//   hn_i_edge2(a, b, t)              interpolates from a to b by a fade t, to a ramp; hn_i_edge3(a, b, t)
//   hn_i_gradient1, 2, 3(h)          a gradient, in the units of ramps
//   hn_i_along_axes(h, a, b)         a vector in space with these components along the two axes

// Bits behind an exponent make a float without a conversion from integer, and without a shift.
#if HN_I_BITCAST
HN_FN hn_vec2 hn_i_direction2(hn_uint h) {
  hn_float x = uintBitsToFloat((h & 0x00600000u) | 0x40000000u) - 2.75f;
  return vec2(x, hn_i_signed(1.0f - abs(x), h));
}
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  return vec2(5.0f - uintBitsToFloat((h & 0x00400000u) | 0x40800000u),
              9.0f - uintBitsToFloat((h & 0x00200000u) | 0x41000000u));
}
#else
HN_FN hn_vec2 hn_i_direction2(hn_uint h) {
  hn_float x = hn_i_float((h >> 21u) & 3u) * 0.5f - 0.75f;
  return vec2(x, hn_i_signed(1.0f - abs(x), h));
}
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  return vec2(hn_i_select((h & 0x00400000u) != 0u, -1.0f, 1.0f), hn_i_select((h & 0x00200000u) != 0u, -1.0f, 1.0f));
}
#endif

// The size of the word chooses the axes: x and y below the first third, y and z from the second third on, and x and z
// between.
HN_FN hn_vec2 hn_i_pair(hn_uint h, hn_float x, hn_float y, hn_float z) {
  return vec2(hn_i_select(h < 0xAAAAAAAAu, x, y), hn_i_select(h < 0x55555555u, y, z));
}
HN_FN hn_vec3 hn_i_direction3(hn_uint h) {
  hn_vec2 g = hn_i_signs(h);
  return vec3(hn_i_select(h < 0xAAAAAAAAu, g.x, 0.0f),
              hn_i_select(h < 0x55555555u, g.y, hn_i_select(h < 0xAAAAAAAAu, 0.0f, g.x)),
              hn_i_select(h < 0x55555555u, 0.0f, g.y));
}
HN_FN hn_i_num3 hn_i_along_axes(hn_uint h, hn_i_num a, hn_i_num b) {
  hn_i_num none = hn_i_minus(HN_I_ONE, HN_I_ONE);
  return hn_i_vector(hn_i_select(h < 0xAAAAAAAAu, a, none),
                     hn_i_select(h < 0x55555555u, b, hn_i_select(h < 0xAAAAAAAAu, none, a)),
                     hn_i_select(h < 0x55555555u, none, b));
}

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_offset(hn_float x) { return x; }
HN_FN hn_float hn_i_along2(hn_vec2 g, hn_float x, hn_float y) { return hn_i_dot(g, x, y); }
HN_FN hn_float hn_i_along3(hn_vec2 signs, hn_float a, hn_float b) { return hn_i_dot(signs, a, b); }
HN_FN hn_float hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) { return hn_i_dot(g, x, y, z); }
HN_FN hn_float hn_i_ramp_of2(hn_float n) { return n; }
HN_FN hn_float hn_i_ramp_of3(hn_float n) { return n; }
HN_FN hn_float hn_i_edge2(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }
HN_FN hn_float hn_i_edge3(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }

HN_FN hn_float hn_i_gradient1(hn_uint h) {
#if HN_I_BITCAST
  return hn_i_minus(uintBitsToFloat((h & 0x007FC000u) | 0x40000000u), 3.0f - 1.0f / 512.0f);
#else
  return hn_i_minus(hn_i_float((h >> 14u) & 511u) * (1.0f / 256.0f), 1.0f - 1.0f / 512.0f);
#endif
}
HN_FN hn_float hn_i_ramp(hn_float g, hn_float x) { return hn_i_times(g, x); }
HN_FN hn_vec2 hn_i_gradient2(hn_uint h) { return hn_i_direction2(h); }
HN_FN hn_vec2 hn_i_sign_pair(hn_uint h) { return hn_i_signs(h); }

#else

// Offsets are whole numbers of 2^-20, and a gradient times an offset is below 2 in magnitude, a multiple of 2^-20 or
// 2^-22. With 12 or 3 added it is a float whose last bit has that unit. So floats compute it without rounding, in any
// order, and its bits are an integer.
#if HN_I_BITCAST
HN_FN hn_float hn_i_offset(hn_int x) { return uintBitsToFloat(uint(x) + 0x41400000u) - 12.0f; }
HN_FN hn_int hn_i_along2(hn_vec2 g, hn_float x, hn_float y) {
  return int(floatBitsToUint(g.x * x + 3.0f + g.y * y) - 0x40400000u);
}
HN_FN hn_int hn_i_along3(hn_vec2 signs, hn_float a, hn_float b) {
  return int(floatBitsToUint(signs.x * a + 12.0f + signs.y * b) - 0x41400000u);
}
HN_FN hn_int hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) {
  return int(floatBitsToUint(g.x * x + 12.0f + g.y * y + g.z * z) - 0x41400000u);
}
#else
HN_FN hn_float hn_i_offset(hn_int x) { return hn_i_float(x) * (1.0f / HN_I_FLOAT_UNITS_FRACTION); }
HN_FN hn_int hn_i_along2(hn_vec2 g, hn_float x, hn_float y) { return int((g.x * x + g.y * y) * 4194304.0f); }
HN_FN hn_int hn_i_along3(hn_vec2 signs, hn_float a, hn_float b) {
  return int((signs.x * a + signs.y * b) * HN_I_FLOAT_UNITS_FRACTION);
}
#endif

HN_FN hn_int hn_i_ramp_of2(hn_int n) { return n * 128; }
HN_FN hn_int hn_i_ramp_of3(hn_int n) { return n * 512; }

// hn_i_lerp between ramps, without the bits that are 0 in them.
HN_FN hn_int hn_i_edge2(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return a * 128 + ((d >> 2) * (t >> 9) + (d >> 11) * (t & 511));
}
HN_FN hn_int hn_i_edge3(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return a * 512 + (d * (t >> 9) + (d >> 9) * (t & 511));
}

HN_FN hn_int hn_i_gradient1(hn_uint h) { return (int((h >> 13u) & 1022u) - 511) << 20; }
HN_FN hn_int hn_i_ramp(hn_int g, hn_int x) { return (g >> 20) * x; }
HN_FN hn_ivec2 hn_i_gradient2(hn_uint h) {
  hn_vec2 g = hn_i_direction2(h);
  return ivec2(hn_i_ramp_of2(hn_i_along2(g, 1.0f, 0.0f)), hn_i_ramp_of2(hn_i_along2(g, 0.0f, 1.0f)));
}
HN_FN hn_ivec2 hn_i_sign_pair(hn_uint h) {
  return ivec2(hn_i_signed(HN_I_UNITS_RAMP, h << 9u), hn_i_signed(HN_I_UNITS_RAMP, h << 10u));
}

#endif

HN_FN hn_i_num hn_i_ramp2(hn_uint h, hn_float x, hn_float y) {
  return hn_i_ramp_of2(hn_i_along2(hn_i_direction2(h), x, y));
}
HN_FN hn_i_num hn_i_ramp3(hn_uint h, hn_float x, hn_float y, hn_float z) {
  hn_vec2 offset = hn_i_pair(h, x, y, z);
  return hn_i_ramp_of3(hn_i_along3(hn_i_signs(h), offset.x, offset.y));
}
HN_FN hn_i_num3 hn_i_gradient3(hn_uint h) {
  hn_i_num2 g = hn_i_sign_pair(h);
  return hn_i_along_axes(h, g.x, g.y);
}

#endif
