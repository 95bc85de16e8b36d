// hashnoise: the steps that derivatives of lattice noises are made of.
// SPDX-License-Identifier: MIT

#ifndef HN_DERIVATIVE_GLSL
#define HN_DERIVATIVE_GLSL

#include "arithmetic.glsl"

// Derivatives are numbers, too, with units four times as large where they are interpolated:
//
//   hn_i_d_fade(f)         the derivative of the fade, 30 f^2 (1 - f)^2, along each axis
//   hn_i_d_corner(a, b)    b - a: the difference of two corners, from which a derivative is made
//   hn_i_d_faded(r, s)     a rise times the slope of a fade: what the fade adds to a derivative
//   hn_i_d_faded(g, r, s)  the same, with what an interpolated gradient adds
//   hn_i_lerp_d(n, t, s)   like hn_i_lerp between four corners, with the derivatives along x and y; t are the fades, s
//                          their slopes
//   hn_i_of_d_corners(n)   the derivative of a noise, from an interpolation between rises of hn_i_number
//   hn_i_of_components(...)  a vector with its derivatives, from its components, each a float with its own

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec2 hn_i_d_fade(hn_vec2 f) {
  HN_I_PRECISE hn_vec2 q = f - f * f;
  HN_I_PRECISE hn_vec2 s = q * q * 30.0f;
  return s;
}
// Generated for 1, 3 and 4 dimensions from the lines above.
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
HN_FN hn_float hn_i_d_faded(hn_float g, hn_float rise, hn_float slope) { return hn_i_multiply_add(rise, slope, g); }

HN_FN hn_float hn_i_of_d_corners(hn_float n) { return n; }

#else

// The result is in units of 2^-18. x is the fade's, in units of 2^-17, and q = x (1 - x) is at most 1/4, in units
// of 2^-18.
HN_FN hn_int hn_i_d_fade(hn_int f) {
  hn_uint x = hn_i_from_end(f);
  hn_uint q = (x * (131072u - x)) >> 16u;
  return int((((q * q) >> 4u) * 15u + 4096u) >> 13u);
}
HN_FN hn_ivec2 hn_i_d_fade(hn_ivec2 f) { return ivec2(hn_i_d_fade(f.x), hn_i_d_fade(f.y)); }
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_ivec3 hn_i_d_fade(hn_ivec3 f) { return ivec3(hn_i_d_fade(f.x), hn_i_d_fade(f.y), hn_i_d_fade(f.z)); }
HN_FN hn_ivec4 hn_i_d_fade(hn_ivec4 f) {
  return ivec4(hn_i_d_fade(f.x), hn_i_d_fade(f.y), hn_i_d_fade(f.z), hn_i_d_fade(f.w));
}

// Rises are in units of 2^-27, and so is what is made of them: there is room for the slope of a fade, up to 15/8.
HN_FN hn_int hn_i_d_corner(hn_int a, hn_int b) { return (b - a) >> 2; }
HN_FN hn_int hn_i_d_faded(hn_int rise, hn_int slope) { return hn_i_part(rise, slope); }
HN_FN hn_int hn_i_d_faded(hn_int g, hn_int rise, hn_int slope) { return g + hn_i_part(rise, slope); }

HN_FN hn_int hn_i_of_d_corners(hn_int n) { return (n + 128) >> 8; }

#endif

HN_FN hn_i_num3 hn_i_lerp_d(hn_i_num4 n, hn_i_num2 t, hn_i_num2 s) {
  hn_i_num lower = hn_i_lerp(n.x, n.y, t.x);
  hn_i_num upper = hn_i_lerp(n.z, n.w, t.x);
  hn_i_num along_x = hn_i_lerp(hn_i_d_corner(n.x, n.y), hn_i_d_corner(n.z, n.w), t.y);
  return hn_i_vector(hn_i_lerp(lower, upper, t.y), hn_i_d_faded(along_x, s.x),
                     hn_i_d_faded(hn_i_d_corner(lower, upper), s.y));
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
