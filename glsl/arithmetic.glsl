// hashnoise: what HN_ARITHMETIC means: the numbers that noise is computed in, and the steps that depend on them.
// SPDX-License-Identifier: MIT

#ifndef HN_ARITHMETIC_GLSL
#define HN_ARITHMETIC_GLSL

#include "config.glsl"

// The text of a noise is the same for all three. It is written in
//
//   hn_num             a fraction of a cell, and what is made of it: a float, or an integer in units of 2^-20 and, further
//                      on, of others (docs/contract.md, section 8); hn_num2 and hn_num3 are vectors of it, hn_i_num(x, y)
//                      and hn_i_num(x, y, z) make them
//   HN_I_ONE           1 as a fraction
//   hn_i_cell(p)       the cell of a position
//   hn_i_fraction(p)   the place in that cell
//   hn_i_inside(f)     the same of what the caller says is a place in a cell
//   hn_i_fade(f)       6 f^5 - 15 f^4 + 10 f^3, along each axis
//   hn_i_lerp(a, b, t) from a to b by such a t
//   hn_i_scaled(n, s)  a noise of ramps, times s / 1024; hn_i_unscaled(n), as it is
//   hn_i_value(n)      the float that a noise is

#if HN_ARITHMETIC != HN_FIXED

#define hn_num hn_float
#define hn_num2 hn_vec2
#define hn_num3 hn_vec3
#define HN_I_ONE 1.0f

HN_FN hn_vec2 hn_i_num(hn_float x, hn_float y) { return vec2(x, y); }
HN_FN hn_vec3 hn_i_num(hn_float x, hn_float y, hn_float z) { return vec3(x, y, z); }

#if HN_ARITHMETIC == HN_FAST

HN_FN hn_ivec2 hn_i_cell(hn_vec2 p) { return ivec2(floor(p)); }
HN_FN hn_ivec3 hn_i_cell(hn_vec3 p) { return ivec3(floor(p)); }
HN_FN hn_vec2 hn_i_fraction(hn_vec2 p) { return p - floor(p); }
HN_FN hn_vec3 hn_i_fraction(hn_vec3 p) { return p - floor(p); }
HN_FN hn_vec2 hn_i_inside(hn_vec2 f) { return f; }
HN_FN hn_vec3 hn_i_inside(hn_vec3 f) { return f; }

#else  // HN_PRECISE

// Without what is so small that a product of it could be subnormal: drivers may flush those to 0.
HN_FN hn_float hn_i_inside(hn_float x) { return abs(x) < (1.0f / 4294967296.0f) ? 0.0f : x; }
HN_FN hn_vec2 hn_i_inside(hn_vec2 f) { return vec2(hn_i_inside(f.x), hn_i_inside(f.y)); }
HN_FN hn_vec3 hn_i_inside(hn_vec3 f) { return vec3(hn_i_inside(f.x), hn_i_inside(f.y), hn_i_inside(f.z)); }

// The conversion of a float that is no int is undefined: 2147483520 is the largest float below 2^31.
HN_FN hn_int hn_i_cell(hn_float p) { return int(min(max(floor(hn_i_inside(p)), -2147483648.0f), 2147483520.0f)); }
HN_FN hn_ivec2 hn_i_cell(hn_vec2 p) { return ivec2(hn_i_cell(p.x), hn_i_cell(p.y)); }
HN_FN hn_ivec3 hn_i_cell(hn_vec3 p) { return ivec3(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z)); }

HN_FN hn_float hn_i_fraction(hn_float p) {
  hn_float q = hn_i_inside(p);
  HN_I_PRECISE hn_float f = q - floor(q);
  return f;
}
HN_FN hn_vec2 hn_i_fraction(hn_vec2 p) { return vec2(hn_i_fraction(p.x), hn_i_fraction(p.y)); }
HN_FN hn_vec3 hn_i_fraction(hn_vec3 p) { return vec3(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z)); }

#endif

// Without the cancellation of the usual form.
HN_FN hn_vec2 hn_i_fade(hn_vec2 f) {
  HN_I_PRECISE hn_vec2 d = f - 1.0f;
  HN_I_PRECISE hn_vec2 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
HN_FN hn_vec3 hn_i_fade(hn_vec3 f) {
  HN_I_PRECISE hn_vec3 d = f - 1.0f;
  HN_I_PRECISE hn_vec3 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}

HN_FN hn_float hn_i_lerp(hn_float a, hn_float b, hn_float t) {
  HN_I_PRECISE hn_float n = a + t * (b - a);
  return n;
}

HN_FN hn_float hn_i_scaled(hn_float n, hn_int s) {
  HN_I_PRECISE hn_float scaled = n * (float(s) * (1.0f / 1024.0f));
  return scaled;
}

HN_FN hn_float hn_i_unscaled(hn_float n) { return n; }

HN_FN hn_float hn_i_value(hn_float n) { return n; }

#else  // HN_FIXED

#define hn_num hn_int
#define hn_num2 hn_ivec2
#define hn_num3 hn_ivec3
#define HN_I_ONE 1048576

HN_FN hn_ivec2 hn_i_num(hn_int x, hn_int y) { return ivec2(x, y); }
HN_FN hn_ivec3 hn_i_num(hn_int x, hn_int y, hn_int z) { return ivec3(x, y, z); }

// Every step up to the integers is exact in floats, so that neither rounding, contraction nor flushed subnormal numbers
// can change it. p - floor(p) would not be: for a small negative p it has too many bits. So the whole part is cut off
// towards 0, and what is left, in (-1, 1), may be negative.
HN_FN hn_int hn_i_rest(hn_float p) { return int((p - trunc(p)) * 1048576.0f); }

// The conversion of a float that is no int is undefined: 2147483520 is the largest float below 2^31.
HN_FN hn_int hn_i_whole_cell(hn_float p) { return int(min(max(trunc(p), -2147483648.0f), 2147483520.0f)); }

HN_FN hn_int hn_i_cell(hn_float p) { return hn_i_whole_cell(p) + (hn_i_rest(p) >> 20); }
HN_FN hn_ivec2 hn_i_cell(hn_vec2 p) { return ivec2(hn_i_cell(p.x), hn_i_cell(p.y)); }
HN_FN hn_ivec3 hn_i_cell(hn_vec3 p) { return ivec3(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z)); }

HN_FN hn_int hn_i_fraction(hn_float p) { return hn_i_rest(p) & 1048575; }
HN_FN hn_ivec2 hn_i_fraction(hn_vec2 p) { return ivec2(hn_i_fraction(p.x), hn_i_fraction(p.y)); }
HN_FN hn_ivec3 hn_i_fraction(hn_vec3 p) { return ivec3(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z)); }

HN_FN hn_int hn_i_inside(hn_float f) { return int(min(max(f, 0.0f), 1.0f) * 1048576.0f); }
HN_FN hn_ivec2 hn_i_inside(hn_vec2 f) { return ivec2(hn_i_inside(f.x), hn_i_inside(f.y)); }
HN_FN hn_ivec3 hn_i_inside(hn_vec3 f) { return ivec3(hn_i_inside(f.x), hn_i_inside(f.y), hn_i_inside(f.z)); }

// In units of 2^-18, rising throughout: with the nearer end at 0, f^3 (10 - 15 f + 6 f^2) as f Q with
// Q = f^2 (4 + R) and R = 6 - 15 f + 6 f^2; the other half is the mirror image. x has 16 bits, its square 32, and is never
// 1/2, which has one more. The summands 4, 32768 and 16384 round.
HN_FN hn_int hn_i_fade(hn_int f) {
  hn_uint x = uint(min(min(f, 1048576 - f) + 4, 524287)) >> 3;
  hn_uint square = x * x;
  hn_uint z = (square + 32768u) >> 16;
  hn_uint r = (1572864u + 6u * z - 30u * x) >> 2;
  hn_uint q = (square + ((z * r) >> 2) + 32768u) >> 16;
  hn_int t = int((x * q + 16384u) >> 15);
  return f > 524288 ? 262144 - t : t;
}
HN_FN hn_ivec2 hn_i_fade(hn_ivec2 f) { return ivec2(hn_i_fade(f.x), hn_i_fade(f.y)); }
HN_FN hn_ivec3 hn_i_fade(hn_ivec3 f) { return ivec3(hn_i_fade(f.x), hn_i_fade(f.y), hn_i_fade(f.z)); }

// A product of 31 and 19 bits from two that fit 32 each: by the high and by the low half of t.
HN_FN hn_int hn_i_lerp(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return a + ((d >> 9) * (t >> 9) + (d >> 18) * (t & 511));
}

// From units of 2^-29 to units of 2^-21, rounded.
HN_FN hn_int hn_i_scaled(hn_int n, hn_int s) { return (((n + 256) >> 9) * s + 256) >> 9; }

// The ramps of the sine gradient are longer: in units of 2^-28.
HN_FN hn_int hn_i_unscaled(hn_int n) { return n >> 7; }

HN_FN hn_float hn_i_value(hn_int n) { return float(n) * (1.0f / 2097152.0f); }

#endif

#endif
