// hashnoise: the gradient of a word in space, and what it adds at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION3D_GLSL
#define HN_DIRECTION3D_GLSL

#include "direction.glsl"

// In space a gradient is one of the 12 edges of a cube: two components are 1 or -1, and one is 0. Their second moments
// are those of a sphere. A gradient that has turned by a quarter, in the plane of its two axes, is one of the set, too.
//
//   hn_i_signs(h, turned)           its components along its first and its second axis
//   hn_i_direction3(h, signs)       all three components
//   hn_i_along3(g, x, y, z)         a gradient times an offset; in HN_FIXED in units of offsets, 2^-20
//   hn_i_along3(h, signs, x, y, z)  the same without the component that is 0
//   hn_i_ramp_of3, hn_i_edge3 and hn_i_d_edge3 are those of direction.glsl from these units

#if HN_I_BITCAST && HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  return vec2(hn_i_minus(5.0f, uintBitsToFloat((h & 0x00400000u) | 0x40800000u)),
              hn_i_minus(9.0f, uintBitsToFloat((h & 0x00200000u) | 0x41000000u)));
}
#else
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  hn_float one = 1.0f;
  return vec2(hn_i_select((h & 0x00400000u) != 0u, -one, one), hn_i_select((h & 0x00200000u) != 0u, -one, one));
}
#endif
HN_FN hn_vec2 hn_i_signs(hn_uint h, bool turned) { return hn_i_turned(hn_i_signs(h), turned); }

// The size of the word chooses the axes: x and y below the first third, y and z from the second third on, and x and z
// between.
HN_FN hn_vec3 hn_i_direction3(hn_uint h, hn_vec2 signs) {
  return vec3(hn_i_select(h < 0xAAAAAAAAu, signs.x, 0.0f),
              hn_i_select(h < 0x55555555u, signs.y, hn_i_select(h < 0xAAAAAAAAu, 0.0f, signs.x)),
              hn_i_select(h < 0x55555555u, 0.0f, signs.y));
}

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_along3(hn_vec2 g, hn_float a, hn_float b) { return hn_i_dot(g, a, b); }
HN_FN hn_float hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) { return hn_i_dot(g, x, y, z); }
HN_FN hn_float hn_i_ramp_of3(hn_float n) { return n; }
HN_FN hn_float hn_i_edge3(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }
HN_FN hn_float hn_i_d_edge3(hn_float a, hn_float b) { return hn_i_minus(b, a); }

#else

HN_FN hn_int hn_i_along3(hn_vec2 g, hn_float a, hn_float b) { return hn_i_beyond_12(g.x * a + 12.0f + g.y * b); }
HN_FN hn_int hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) {
  return hn_i_beyond_12(g.x * x + 12.0f + g.y * y + g.z * z);
}
HN_FN hn_int hn_i_ramp_of3(hn_int n) { return n * 512; }

// In space the difference of two ramps can be 2^31, at corners that have no weight: there words wrap, where signed
// integers of C++ must not.
HN_FN hn_int hn_i_edge3(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return int(uint(a) * 512u + uint(d) * uint(t >> 9) + uint((d >> 9) * (t & 511)));
}
HN_FN hn_int hn_i_d_edge3(hn_int a, hn_int b) { return (b - a) * 128; }

#endif

HN_FN hn_i_num hn_i_along3(hn_uint h, hn_vec2 signs, hn_float x, hn_float y, hn_float z) {
  return hn_i_along3(signs, hn_i_select(h < 0xAAAAAAAAu, x, y), hn_i_select(h < 0x55555555u, y, z));
}

#endif
