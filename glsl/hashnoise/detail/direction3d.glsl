// hashnoise: gradients from hashes in space, and their ramps: what they add at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION3D_GLSL
#define HN_DIRECTION3D_GLSL

#include "cell.glsl"
#include "direction.glsl"

// In space a gradient is one of the 12 edges of a cube: two components are 1 or -1, and one is 0. Their second moments
// are those of a sphere. A gradient that is rotated by a quarter turn, in the plane of its two axes, is one of the set,
// too.
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

// The size of the hash chooses the axes: x and y below the first third, y and z from the second third on, and x and z
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

// In space the difference of two ramps can be 2^31, at corners that have no weight: there uints wrap, where signed
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

// Each HN_GRADIENT offers these functions:
//
//   hn_i_ramps(box, f, back, seed)  what the corners of the front face of a cell, or of its back face along z, add at
//                                   the place f in it
//   hn_i_face3(n, x, y)             interpolates between such four by fades x and y
//   hn_i_scaled3(n)                 noise that is interpolated between ramps, in [-1, 1]

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// From the hashes of the corners of a face, where the gradients may be rotated by a quarter turn.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num3 f, bool back, bool turned) {
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  hn_float z = hn_i_offset(hn_i_select(back, hn_i_minus_one(f.z), f.z));
  return hn_i_vector(
      hn_i_along3(h.x, hn_i_signs(h.x, turned), x, y, z), hn_i_along3(h.y, hn_i_signs(h.y, turned), x1, y, z),
      hn_i_along3(h.z, hn_i_signs(h.z, turned), x, y1, z), hn_i_along3(h.w, hn_i_signs(h.w, turned), x1, y1, z));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_box3 box, hn_i_num3 f, bool back, hn_uint seed) {
  return hn_i_ramps(hn_i_corners(box, back, seed), f, back, false);
}

HN_FN hn_i_num hn_i_face3(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_edge3(n.x, n.y, x), hn_i_edge3(n.z, n.w, x), y);
}

// Noise before it is scaled, from the hashes of the corners of both faces and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 front, hn_uvec4 back, hn_i_num3 f, hn_i_num3 t, bool turned) {
  return hn_i_lerp(hn_i_face3(hn_i_ramps(front, f, false, turned), t.x, t.y),
                   hn_i_face3(hn_i_ramps(back, f, true, turned), t.x, t.y), t.z);
}

// 985 / 1024 is just below 1 / 1.0385: the largest value that a noise has before it is scaled, with rotating gradients,
// too (tools/make bounds).
HN_FN hn_i_num hn_i_scaled3(hn_i_num n) { return hn_i_scaled(n, 985); }

#endif

#endif
