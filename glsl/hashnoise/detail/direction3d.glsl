// hashnoise: gradients from hashes in space, and their ramps: what they add at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION3D_GLSL
#define HN_DIRECTION3D_GLSL

#include "cell.glsl"
#include "direction.glsl"

// In space a gradient is one of the 12 edges of a cube: two components are 1 or -1, and one is 0. Their second moments
// are a sphere's. A gradient that is rotated by a sixth of a turn, across a diagonal of the cube, is one of the
// set, too. It keeps a component, and has another axis in place of the other one.
//
//   hn_i_signs(h, turned)           the components that are not 0: of a gradient along its first and its second axis,
//                                   of one that is rotated the one that it keeps and the other
//   hn_i_direction3(h, turned)      all three components
//   hn_i_along3(g, x, y, z)         a gradient times an offset; in HN_FIXED in units of offsets, 2^-20
//   hn_i_along3(h, x, y, z, turned)  the same without the component that is 0
//   hn_i_ramp_of3, hn_i_lerp_ramps3 and hn_i_ramp_difference3 are as in direction.glsl, from these units
//   hn_i_scaled_d(n, s)             a noise and its derivatives times s / 1024

#if HN_I_BITCAST && HN_ARITHMETIC != HN_FIXED
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  return vec2(hn_i_minus(5.0f, uintBitsToFloat((h & 0x00400000u) | 0x40800000u)),
              hn_i_minus(9.0f, uintBitsToFloat((h & 0x00200000u) | 0x41000000u)));
}
HN_FN hn_float hn_i_other_sign(hn_uint h) {
  return hn_i_minus(17.0f, uintBitsToFloat((h & 0x00100000u) | 0x41800000u));
}
#else
HN_FN hn_vec2 hn_i_signs(hn_uint h) {
  hn_float one = 1.0f;
  return vec2(hn_i_select((h & 0x00400000u) != 0u, -one, one), hn_i_select((h & 0x00200000u) != 0u, -one, one));
}
HN_FN hn_float hn_i_other_sign(hn_uint h) {
  hn_float one = 1.0f;
  return hn_i_select((h & 0x00100000u) != 0u, -one, one);
}
#endif

// By the size of a hash: below the first third, between, and from the second third on.
HN_FN hn_float hn_i_by_third(hn_uint h, hn_float low, hn_float middle, hn_float high) {
  return hn_i_select(h < 0x55555555u, low, hn_i_select(h < 0xAAAAAAAAu, middle, high));
}

// The size chooses the axes: x and y, x and z, y and z. y, x and z are kept, and the other one becomes z, y
// and x.
HN_FN hn_vec2 hn_i_signs(hn_uint h, bool turned) {
  hn_vec2 signs = hn_i_signs(h);
  if (turned) signs = vec2(hn_i_by_third(h, signs.y, signs.x, signs.y), hn_i_other_sign(h));
  return signs;
}
HN_FN hn_vec3 hn_i_direction3(hn_uint h, bool turned) {
  hn_vec2 signs = hn_i_signs(h, turned);
  hn_vec3 g = vec3(hn_i_select(h < 0xAAAAAAAAu, signs.x, 0.0f), hn_i_by_third(h, signs.y, 0.0f, signs.x),
                   hn_i_select(h < 0x55555555u, 0.0f, signs.y));
  if (turned) {
    g = vec3(hn_i_by_third(h, 0.0f, signs.x, signs.y), hn_i_by_third(h, signs.x, signs.y, 0.0f),
             hn_i_by_third(h, signs.y, 0.0f, signs.x));
  }
  return g;
}

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_along3(hn_vec2 g, hn_float a, hn_float b) { return hn_i_dot(g, a, b); }
HN_FN hn_float hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) { return hn_i_dot(g, x, y, z); }
HN_FN hn_float hn_i_ramp_of3(hn_float n) { return n; }
HN_FN hn_float hn_i_lerp_ramps3(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }
HN_FN hn_float hn_i_ramp_difference3(hn_float a, hn_float b) { return hn_i_minus(b, a); }

#else

HN_FN hn_int hn_i_along3(hn_vec2 g, hn_float a, hn_float b) { return hn_i_beyond_12(g.x * a + 12.0f + g.y * b); }
HN_FN hn_int hn_i_along3(hn_vec3 g, hn_float x, hn_float y, hn_float z) {
  return hn_i_beyond_12(g.x * x + 12.0f + g.y * y + g.z * z);
}
HN_FN hn_int hn_i_ramp_of3(hn_int n) { return n * 512; }

// In space the difference of two ramps can be 2^31, at corners that have no weight: there uints wrap, where signed
// integers of C++ must not.
HN_FN hn_int hn_i_lerp_ramps3(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return int(uint(a) * 512u + uint(d) * uint(t >> 9) + uint((d >> 9) * (t & 511)));
}
HN_FN hn_int hn_i_ramp_difference3(hn_int a, hn_int b) { return (b - a) * 128; }

#endif

HN_FN hn_i_num hn_i_along3(hn_uint h, hn_float x, hn_float y, hn_float z, bool turned) {
  hn_vec2 d = vec2(hn_i_select(h < 0xAAAAAAAAu, x, y), hn_i_select(h < 0x55555555u, y, z));
  if (turned) d = vec2(hn_i_by_third(h, y, x, z), hn_i_by_third(h, z, y, x));
  return hn_i_along3(hn_i_signs(h, turned), d.x, d.y);
}

HN_FN hn_vec4 hn_i_scaled_d(hn_i_num4 n, hn_int s) {
  return vec4(hn_i_value(hn_i_scaled(n.x, s)), hn_i_derivative(hn_i_scaled(n.y, s)),
              hn_i_derivative(hn_i_scaled(n.z, s)), hn_i_derivative(hn_i_scaled(n.w, s)));
}

// Each HN_GRADIENT offers these functions:
//
//   hn_i_ramps(corners, f, back, seed)  what the corners of the front face of a cell, or of its back face along z, add
//                                       at the place f in it
//   hn_i_bilerp_ramps3(n, x, y)         interpolates between such four by fades x and y
//   hn_i_scaled3(n)                     noise that is interpolated between ramps, in [-1, 1]

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// From the hashes of the corners of a face, where the gradients may be rotated by a sixth of a turn.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num3 f, bool back, bool turned) {
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  hn_float z = hn_i_offset(hn_i_select(back, hn_i_minus_one(f.z), f.z));
  return hn_i_vector(hn_i_along3(h.x, x, y, z, turned), hn_i_along3(h.y, x1, y, z, turned),
                     hn_i_along3(h.z, x, y1, z, turned), hn_i_along3(h.w, x1, y1, z, turned));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_cell_corners3 corners, hn_i_num3 f, bool back, hn_uint seed) {
  return hn_i_ramps(hn_i_corner_hashes(corners, back, seed), f, back, false);
}

HN_FN hn_i_num hn_i_bilerp_ramps3(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_lerp_ramps3(n.x, n.y, x), hn_i_lerp_ramps3(n.z, n.w, x), y);
}

// Noise before it is scaled, from the hashes of the corners of both faces and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 front, hn_uvec4 back, hn_i_num3 f, hn_i_num3 t, bool turned) {
  return hn_i_lerp(hn_i_bilerp_ramps3(hn_i_ramps(front, f, false, turned), t.x, t.y),
                   hn_i_bilerp_ramps3(hn_i_ramps(back, f, true, turned), t.x, t.y), t.z);
}

// 985 / 1024 is below 1 / 1.0364: the largest value that a noise has before it is scaled (tools/make bounds).
HN_FN hn_i_num hn_i_scaled3(hn_i_num n) { return hn_i_scaled(n, 985); }

#endif

#endif
