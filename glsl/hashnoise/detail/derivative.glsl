// hashnoise: the steps that derivatives of lattice noises are made of.
// SPDX-License-Identifier: MIT

#ifndef HN_DERIVATIVE_GLSL
#define HN_DERIVATIVE_GLSL

#include "arithmetic.glsl"

// Derivatives, too, are numbers. Those that are interpolated have units four times as large:
//
//   hn_i_d_fade(f)         the derivative of the fade, 30 f^2 (1 - f)^2, along each axis
//   hn_i_d_corner(a, b)    b - a: the difference of two corners, of which a derivative is made
//   hn_i_d_faded(r, s)     a rise times the slope of a fade: what the fade adds to a derivative
//   hn_i_d_faded(g, r, s)  the same, with what an interpolated gradient adds
//   hn_i_lerp_d(n, t, s)   like hn_i_lerp between four corners, with the derivatives along x and y; t are the fades, s
//                          their slopes
//   hn_i_of_d_corners(n)   the derivative of a noise, from an interpolation between rises of hn_i_number
//   hn_i_edge_d(...)       the share of two corners of a cell along x in gradient noise: the interpolated ramp, its
//                          derivative along x, and what the gradients' other components add. a and b are the ramps, g
//                          and h the gradients, t the fade and s its slope
//   hn_i_face_d(...)       the share of four corners 00, 10, 01, 11 in it: the interpolated ramp, its derivatives along
//                          x and y, and in space what the gradients' last components add
//   hn_i_of_components(...)  a vector with its derivatives, from its components, each a float with its own

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec2 hn_i_d_fade(hn_vec2 f) {
  HN_I_PRECISE hn_vec2 q = f - f * f;
  HN_I_PRECISE hn_vec2 s = q * q * 30.0f;
  return s;
}
// The same in 1, 3 and 4 dimensions: tools/umbrella makes it.
HN_FN hn_float hn_i_d_fade(hn_float f) {
  HN_I_PRECISE hn_float q = f - f * f;
  HN_I_PRECISE hn_float s = q * q * 30.0f;
  return s;
}
HN_FN hn_vec3 hn_i_d_fade(hn_vec3 f) {
  HN_I_PRECISE hn_vec3 q = f - f * f;
  HN_I_PRECISE hn_vec3 s = q * q * 30.0f;
  return s;
}
HN_FN hn_vec4 hn_i_d_fade(hn_vec4 f) {
  HN_I_PRECISE hn_vec4 q = f - f * f;
  HN_I_PRECISE hn_vec4 s = q * q * 30.0f;
  return s;
}

HN_FN hn_float hn_i_d_corner(hn_float a, hn_float b) { return hn_i_minus(b, a); }
HN_FN hn_float hn_i_d_faded(hn_float rise, hn_float slope) { return hn_i_times(rise, slope); }
HN_FN hn_float hn_i_d_faded(hn_float g, hn_float rise, hn_float slope) { return hn_i_times_plus(rise, slope, g); }

HN_FN hn_float hn_i_of_d_corners(hn_float n) { return n; }
HN_FN hn_float hn_i_offset4(hn_float t) { return t; }
HN_FN hn_float hn_i_lerp_gradient(hn_float g, hn_float h, hn_float t) { return hn_i_lerp(g, h, t); }

#else

// The result is in units of 2^-18. x is that of the fade, in units of 2^-17, and q = x (1 - x) is at most 1/4, in units
// of 2^-18.
HN_FN hn_int hn_i_d_fade(hn_int f) {
  hn_uint x = hn_i_from_end(f);
  hn_uint q = (x * (131072u - x)) >> 16u;
  return int((((q * q) >> 4u) * 15u + 4096u) >> 13u);
}
HN_FN hn_ivec2 hn_i_d_fade(hn_ivec2 f) { return ivec2(hn_i_d_fade(f.x), hn_i_d_fade(f.y)); }
// The same in 3 and 4 dimensions: tools/umbrella makes it.
HN_FN hn_ivec3 hn_i_d_fade(hn_ivec3 f) { return ivec3(hn_i_d_fade(f.x), hn_i_d_fade(f.y), hn_i_d_fade(f.z)); }
HN_FN hn_ivec4 hn_i_d_fade(hn_ivec4 f) {
  return ivec4(hn_i_d_fade(f.x), hn_i_d_fade(f.y), hn_i_d_fade(f.z), hn_i_d_fade(f.w));
}

// Rises are in units of 2^-27, and so is what is made of them: there is room for the slope of a fade, up to 15/8.
HN_FN hn_int hn_i_d_corner(hn_int a, hn_int b) { return (b - a) >> 2; }
HN_FN hn_int hn_i_d_faded(hn_int rise, hn_int slope) { return hn_i_part(rise, slope); }
HN_FN hn_int hn_i_d_faded(hn_int g, hn_int rise, hn_int slope) { return g + hn_i_part(rise, slope); }

HN_FN hn_int hn_i_of_d_corners(hn_int n) { return (n + 128) >> 8; }
HN_FN hn_float hn_i_offset4(hn_int t) { return uintBitsToFloat(uint(t)*4u + 0x41400000u) - 12.0f; }
HN_FN hn_int hn_i_lerp_gradient(hn_float g, hn_float h, hn_float t) {
  return int(floatBitsToUint((h - g) * t + (g + 3.0f)) - 0x40400000u) * 32;
}

#endif

HN_FN hn_i_num3 hn_i_lerp_d(hn_i_num4 n, hn_i_num2 t, hn_i_num2 s) {
  hn_i_num lower = hn_i_lerp(n.x, n.y, t.x);
  hn_i_num upper = hn_i_lerp(n.z, n.w, t.x);
  hn_i_num along_x = hn_i_lerp(hn_i_d_corner(n.x, n.y), hn_i_d_corner(n.z, n.w), t.y);
  return hn_i_vector(hn_i_lerp(lower, upper, t.y), hn_i_d_faded(along_x, s.x),
                     hn_i_d_faded(hn_i_d_corner(lower, upper), s.y));
}

HN_FN hn_i_num3 hn_i_edge_d(hn_i_num a, hn_i_num b, hn_vec2 g, hn_vec2 h, hn_i_num t, hn_i_num s) {
  return hn_i_vector(hn_i_lerp(a, b, t), hn_i_d_faded(hn_i_lerp_gradient(g.x, h.x, hn_i_offset4(t)), hn_i_d_corner(a, b), s),
                     hn_i_lerp_gradient(g.y, h.y, hn_i_offset4(t)));
}
HN_FN hn_i_num4 hn_i_edge_d(hn_i_num a, hn_i_num b, hn_vec3 g, hn_vec3 h, hn_i_num t, hn_i_num s) {
  return hn_i_vector(hn_i_lerp(a, b, t), hn_i_d_faded(hn_i_lerp_gradient(g.x, h.x, hn_i_offset4(t)), hn_i_d_corner(a, b), s),
                     hn_i_lerp_gradient(g.y, h.y, hn_i_offset4(t)), hn_i_lerp_gradient(g.z, h.z, hn_i_offset4(t)));
}

HN_FN hn_i_num3 hn_i_face_d(hn_i_num4 r, hn_vec2 g00, hn_vec2 g10, hn_vec2 g01, hn_vec2 g11, hn_i_num2 t,
                            hn_i_num2 s) {
  hn_i_num3 n0 = hn_i_edge_d(r.x, r.y, g00, g10, t.x, s.x);
  hn_i_num3 n1 = hn_i_edge_d(r.z, r.w, g01, g11, t.x, s.x);
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.y), hn_i_lerp(n0.y, n1.y, t.y),
                     hn_i_d_faded(hn_i_lerp(n0.z, n1.z, t.y), hn_i_d_corner(n0.x, n1.x), s.y));
}
HN_FN hn_i_num4 hn_i_face_d(hn_i_num4 r, hn_vec3 g00, hn_vec3 g10, hn_vec3 g01, hn_vec3 g11, hn_i_num3 t,
                            hn_i_num3 s) {
  hn_i_num4 n0 = hn_i_edge_d(r.x, r.y, g00, g10, t.x, s.x);
  hn_i_num4 n1 = hn_i_edge_d(r.z, r.w, g01, g11, t.x, s.x);
  return hn_i_vector(hn_i_lerp(n0.x, n1.x, t.y), hn_i_lerp(n0.y, n1.y, t.y),
                     hn_i_d_faded(hn_i_lerp(n0.z, n1.z, t.y), hn_i_d_corner(n0.x, n1.x), s.y),
                     hn_i_lerp(n0.w, n1.w, t.y));
}

HN_FN hn_derivatives2x2 hn_i_of_components(hn_vec3 x, hn_vec3 y) {
  HN_I_NEW(hn_derivatives2x2, d);
  d.value = vec2(x.x, y.x);
  d.dx = vec2(x.y, y.y);
  d.dy = vec2(x.z, y.z);
  return d;
}
HN_FN hn_derivatives3x3 hn_i_of_components(hn_vec4 x, hn_vec4 y, hn_vec4 z) {
  HN_I_NEW(hn_derivatives3x3, d);
  d.value = vec3(x.x, y.x, z.x);
  d.dx = vec3(x.y, y.y, z.y);
  d.dy = vec3(x.z, y.z, z.z);
  d.dz = vec3(x.w, y.w, z.w);
  return d;
}

#endif
