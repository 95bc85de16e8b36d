// hashnoise: what HN_ARITHMETIC means: the numbers that noise is computed in, and the steps that depend on them.
// SPDX-License-Identifier: MIT

#ifndef HN_ARITHMETIC_GLSL
#define HN_ARITHMETIC_GLSL

#include "config.glsl"

// The text of a noise is the same for all three. It is written in
//
//   HN_I_NUMBER        a fraction of a cell, and what is made of it: a float, or an integer in units of 2^-20 and, further
//                      on, of others (docs/contract.md, section 8); HN_I_NUMBER2 and HN_I_NUMBER3 are vectors of it
//   HN_I_ONE           1 as a fraction
//   hn_i_cell(p)       the cell of a position
//   hn_i_fraction(p)   the place in that cell
//   hn_i_inside(f)     the same of what the caller says is a place in a cell
//   hn_i_fade(f)       6 f^5 - 15 f^4 + 10 f^3, along each axis
//   hn_i_lerp(a, b, t) from a to b by such a t
//   hn_i_scaled(n, s)  a noise of ramps, times s / 1024; hn_i_unscaled(n), as it is
//   hn_i_value(n)      the float that a noise is

#if HN_ARITHMETIC != HN_FIXED

#define HN_I_NUMBER float
#define HN_I_NUMBER2 vec2
#define HN_I_NUMBER3 vec3
#define HN_I_ONE 1.0f

#if HN_ARITHMETIC == HN_FAST

HN_FN HN_HIGHP ivec2 hn_i_cell(HN_HIGHP vec2 p) { return ivec2(floor(p)); }
HN_FN HN_HIGHP ivec3 hn_i_cell(HN_HIGHP vec3 p) { return ivec3(floor(p)); }
HN_FN HN_HIGHP vec2 hn_i_fraction(HN_HIGHP vec2 p) { return p - floor(p); }
HN_FN HN_HIGHP vec3 hn_i_fraction(HN_HIGHP vec3 p) { return p - floor(p); }
HN_FN HN_HIGHP vec2 hn_i_inside(HN_HIGHP vec2 f) { return f; }
HN_FN HN_HIGHP vec3 hn_i_inside(HN_HIGHP vec3 f) { return f; }

#else  // HN_PRECISE

// Without what is so small that a product of it could be subnormal: drivers may flush those to 0.
HN_FN HN_HIGHP float hn_i_inside(HN_HIGHP float x) { return abs(x) < (1.0f / 4294967296.0f) ? 0.0f : x; }
HN_FN HN_HIGHP vec2 hn_i_inside(HN_HIGHP vec2 f) { return vec2(hn_i_inside(f.x), hn_i_inside(f.y)); }
HN_FN HN_HIGHP vec3 hn_i_inside(HN_HIGHP vec3 f) { return vec3(hn_i_inside(f.x), hn_i_inside(f.y), hn_i_inside(f.z)); }

// The conversion of a float that is no int is undefined: 2147483520 is the largest float below 2^31.
HN_FN HN_HIGHP int hn_i_cell(HN_HIGHP float p) {
  return int(min(max(floor(hn_i_inside(p)), -2147483648.0f), 2147483520.0f));
}
HN_FN HN_HIGHP ivec2 hn_i_cell(HN_HIGHP vec2 p) { return ivec2(hn_i_cell(p.x), hn_i_cell(p.y)); }
HN_FN HN_HIGHP ivec3 hn_i_cell(HN_HIGHP vec3 p) { return ivec3(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z)); }

HN_FN HN_HIGHP float hn_i_fraction(HN_HIGHP float p) {
  HN_HIGHP float q = hn_i_inside(p);
  HN_I_PRECISE HN_HIGHP float f = q - floor(q);
  return f;
}
HN_FN HN_HIGHP vec2 hn_i_fraction(HN_HIGHP vec2 p) { return vec2(hn_i_fraction(p.x), hn_i_fraction(p.y)); }
HN_FN HN_HIGHP vec3 hn_i_fraction(HN_HIGHP vec3 p) {
  return vec3(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z));
}

#endif

// Without the cancellation of the usual form.
HN_FN HN_HIGHP vec2 hn_i_fade(HN_HIGHP vec2 f) {
  HN_I_PRECISE HN_HIGHP vec2 d = f - 1.0f;
  HN_I_PRECISE HN_HIGHP vec2 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}
HN_FN HN_HIGHP vec3 hn_i_fade(HN_HIGHP vec3 f) {
  HN_I_PRECISE HN_HIGHP vec3 d = f - 1.0f;
  HN_I_PRECISE HN_HIGHP vec3 t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}

HN_FN HN_HIGHP float hn_i_lerp(HN_HIGHP float a, HN_HIGHP float b, HN_HIGHP float t) {
  HN_I_PRECISE HN_HIGHP float n = a + t * (b - a);
  return n;
}

HN_FN HN_HIGHP float hn_i_scaled(HN_HIGHP float n, HN_HIGHP float s) {
  HN_I_PRECISE HN_HIGHP float scaled = n * (s * (1.0f / 1024.0f));
  return scaled;
}

HN_FN HN_HIGHP float hn_i_unscaled(HN_HIGHP float n) { return n; }

HN_FN HN_HIGHP float hn_i_value(HN_HIGHP float n) { return n; }

#else  // HN_FIXED

#define HN_I_NUMBER int
#define HN_I_NUMBER2 ivec2
#define HN_I_NUMBER3 ivec3
#define HN_I_ONE 1048576

// Every step up to the integers is exact in floats, so that neither rounding, contraction nor flushed subnormal numbers
// can change it. p - floor(p) would not be: for a small negative p it has too many bits. So the whole part is cut off
// towards 0, and what is left, in (-1, 1), may be negative.
HN_FN HN_HIGHP int hn_i_rest(HN_HIGHP float p) { return int((p - trunc(p)) * 1048576.0f); }

// The conversion of a float that is no int is undefined: 2147483520 is the largest float below 2^31.
HN_FN HN_HIGHP int hn_i_whole_cell(HN_HIGHP float p) { return int(min(max(trunc(p), -2147483648.0f), 2147483520.0f)); }

HN_FN HN_HIGHP int hn_i_cell(HN_HIGHP float p) { return hn_i_whole_cell(p) + (hn_i_rest(p) >> 20); }
HN_FN HN_HIGHP ivec2 hn_i_cell(HN_HIGHP vec2 p) { return ivec2(hn_i_cell(p.x), hn_i_cell(p.y)); }
HN_FN HN_HIGHP ivec3 hn_i_cell(HN_HIGHP vec3 p) { return ivec3(hn_i_cell(p.x), hn_i_cell(p.y), hn_i_cell(p.z)); }

HN_FN HN_HIGHP int hn_i_fraction(HN_HIGHP float p) { return hn_i_rest(p) & 1048575; }
HN_FN HN_HIGHP ivec2 hn_i_fraction(HN_HIGHP vec2 p) { return ivec2(hn_i_fraction(p.x), hn_i_fraction(p.y)); }
HN_FN HN_HIGHP ivec3 hn_i_fraction(HN_HIGHP vec3 p) {
  return ivec3(hn_i_fraction(p.x), hn_i_fraction(p.y), hn_i_fraction(p.z));
}

HN_FN HN_HIGHP int hn_i_inside(HN_HIGHP float f) { return int(min(max(f, 0.0f), 1.0f) * 1048576.0f); }
HN_FN HN_HIGHP ivec2 hn_i_inside(HN_HIGHP vec2 f) { return ivec2(hn_i_inside(f.x), hn_i_inside(f.y)); }
HN_FN HN_HIGHP ivec3 hn_i_inside(HN_HIGHP vec3 f) {
  return ivec3(hn_i_inside(f.x), hn_i_inside(f.y), hn_i_inside(f.z));
}

// In units of 2^-18, rising throughout: with the nearer end at 0, f^3 (10 - 15 f + 6 f^2) as f Q with
// Q = f^2 (4 + R) and R = 6 - 15 f + 6 f^2; the other half is the mirror image. x has 16 bits, its square 32, and is never
// 1/2, which has one more. The summands 4, 32768 and 16384 round.
HN_FN HN_HIGHP int hn_i_fade(HN_HIGHP int f) {
  HN_HIGHP uint x = uint(min(min(f, 1048576 - f) + 4, 524287)) >> 3;
  HN_HIGHP uint square = x * x;
  HN_HIGHP uint z = (square + 32768u) >> 16;
  HN_HIGHP uint r = (1572864u + 6u * z - 30u * x) >> 2;
  HN_HIGHP uint q = (square + ((z * r) >> 2) + 32768u) >> 16;
  HN_HIGHP int t = int((x * q + 16384u) >> 15);
  return f > 524288 ? 262144 - t : t;
}
HN_FN HN_HIGHP ivec2 hn_i_fade(HN_HIGHP ivec2 f) { return ivec2(hn_i_fade(f.x), hn_i_fade(f.y)); }
HN_FN HN_HIGHP ivec3 hn_i_fade(HN_HIGHP ivec3 f) { return ivec3(hn_i_fade(f.x), hn_i_fade(f.y), hn_i_fade(f.z)); }

// A product of 31 and 19 bits from two that fit 32 each: by the high and by the low half of t.
HN_FN HN_HIGHP int hn_i_lerp(HN_HIGHP int a, HN_HIGHP int b, HN_HIGHP int t) {
  HN_HIGHP int d = b - a;
  return a + ((d >> 9) * (t >> 9) + (d >> 18) * (t & 511));
}

// From units of 2^-29 to units of 2^-21, rounded.
HN_FN HN_HIGHP int hn_i_scaled(HN_HIGHP int n, HN_HIGHP int s) { return (((n + 256) >> 9) * s + 256) >> 9; }

// The ramps of the sine gradient are longer: in units of 2^-28.
HN_FN HN_HIGHP int hn_i_unscaled(HN_HIGHP int n) { return n >> 7; }

HN_FN HN_HIGHP float hn_i_value(HN_HIGHP int n) { return float(n) * (1.0f / 2097152.0f); }

#endif

#endif
