// hashnoise: the meaning of HN_ARITHMETIC: the numbers that a noise computes with, and the steps that depend on them.
// SPDX-License-Identifier: MIT

#ifndef HN_ARITHMETIC_GLSL
#define HN_ARITHMETIC_GLSL

#include "word.glsl"

// Noises with derivatives return this in four dimensions, where no vector has room for all of it.
struct hn_derivatives4 {
  hn_float value;
  hn_vec4 gradient;
};

// Vectors of noise with derivatives return these: 2x3 has two components, along three axes. dx has the derivatives of
// all components along x, and so on.
struct hn_derivatives2x2 {
  hn_vec2 value;
  hn_vec2 dx;
  hn_vec2 dy;
};
struct hn_derivatives2x3 {
  hn_vec2 value;
  hn_vec2 dx;
  hn_vec2 dy;
  hn_vec2 dz;
};
struct hn_derivatives3x3 {
  hn_vec3 value;
  hn_vec3 dx;
  hn_vec3 dy;
  hn_vec3 dz;
};

// A noise has one text for all three arithmetics. It is written in these steps, not in operators, so that with
// HN_PRECISE each step can round on its own:
//
//   hn_i_num                   a fraction of a cell, and what is computed from it: a float, or an integer. The fraction
//                              is in units of 2^-20, and later numbers have other units, which stand below and in
//                              docs/reference/contract.md, section 8. hn_i_num2 to hn_i_num4 are vectors of such
//                              numbers
//   hn_i_vector(x, y, ...)     such a vector
//   HN_I_ONE                   1 as a fraction
//   hn_i_cell(p)               the cell of a position; p is a float or a vector, and so is f in the next two
//   hn_i_fraction(p)           the fraction in that cell
//   hn_i_to_num(f)             the same from a fraction that the caller passes
//   hn_i_plus(a, b), hn_i_minus(a, b); floats only: hn_i_times(a, b), hn_i_multiply_add(a, b, c): a b + c
//   hn_i_minus_one(f)          f - 1: the offset from the far corner
//   hn_i_dot(g, x, y, ...)     a gradient times an offset
//   hn_i_signed(m, h)          m, or -m if the highest bit of the hash is set; floats: m >= 0
//   hn_i_magnitude(x)          the absolute value
//   hn_i_fade(f)               6 f^5 - 15 f^4 + 10 f^3, along each axis
//   hn_i_lerp(a, b, t)         interpolates from a to b by a fade t
//   hn_i_lerp(n, x, y)         between four corners 00, 10, 01, 11
//   hn_i_scaled(n, s)          a noise, from an interpolation between ramps, times s / 1024
//   hn_i_flushed(n)            floats only: n, or 0 where subnormal numbers could have changed it
//   hn_i_value(n)              the float of a noise; hn_i_derivative(n), of a derivative
//   hn_i_select(c, a, b)       a where the condition holds, else b; both are computed
//   hn_i_select_int(c, a, b)   such an integer of two, which may be literals: in HLSL a literal has no type of its
//                              own, so an overload for integers would be ambiguous
//   hn_i_to_bool(c)            the condition as a bool, if it is the same for all points
//   hn_i_any(c)                whether the condition holds at one of the points
//
// cell2d.glsl has the cell, the fraction and the fade of a vector; place.glsl and cell.glsl have them in
// other dimensions. The steps are in value.glsl for value noise, in derivative.glsl for derivatives, in
// cubic_spline.glsl for splines, in direction_turning.glsl for rotating gradients, in falloff.glsl for simplex noise,
// and in octave.glsl for fractals.

// Units of HN_FIXED. A number is an integer there, which counts units of 2^-n. How many make up 1 has a name where the
// text needs it, as an int and as a float:
//
//   n       name      quantity
//   20      FRACTION  a fraction, an offset and a jitter, in cells; a rank that is not squared
//   24      POSITION  the fraction of a fixed-point position, and a footprint, in cells
//   21      VALUE     a value, a fractal, and a component of a unit vector
//   19      SLOPE     a derivative; of simplex noise on the plane in units of 2^-18
//   18      WEIGHT    a fade and its derivative; the weight of a spline, of a point of simplex noise and of an octave;
//                     a setting of a sum; a number of a Jacobian; a cosine or sine by which something turns
//   18      DISTANCE  a distance
//   22, 20            a gradient times an offset, on the plane and beyond (hn_i_along2, hn_i_along3)
//   29      RAMP      a ramp, and the number of a hash. In 4D ramps are in units of 2^-28
//   27                the difference of two corners and a component of a gradient, for derivatives. In 4D 2^-26
//   30, 16            the square of a distance in simplex noise, and its falloff
//   28                a squared rank
//   16                a distance to a border, a velocity of curl in 3D, a slope of gullies
//   32                an angle, in turns
#define HN_I_UNITS_FRACTION 1048576
#define HN_I_UNITS_POSITION 16777216
#define HN_I_UNITS_VALUE 2097152
#define HN_I_UNITS_WEIGHT 262144
#define HN_I_UNITS_RAMP 536870912
#define HN_I_FLOAT_UNITS_FRACTION 1048576.0f
#define HN_I_FLOAT_UNITS_POSITION 16777216.0f
#define HN_I_FLOAT_UNITS_VALUE 2097152.0f
#define HN_I_FLOAT_UNITS_SLOPE 524288.0f
#define HN_I_FLOAT_UNITS_WEIGHT 262144.0f
#define HN_I_FLOAT_UNITS_DISTANCE 262144.0f
#define HN_I_FLOAT_UNITS_RAMP 536870912.0f

// In C++ numbers may be vectors of many points, and these have no ?: operator, and conditions that are no bool.
HN_FN hn_float hn_i_select(bool condition, hn_float a, hn_float b) { return condition ? a : b; }
HN_FN hn_int hn_i_select(bool condition, hn_int a, hn_int b) { return condition ? a : b; }
HN_FN hn_uint hn_i_select(bool condition, hn_uint a, hn_uint b) { return condition ? a : b; }
HN_FN hn_int hn_i_select_int(bool condition, hn_int a, hn_int b) { return condition ? a : b; }
HN_FN bool hn_i_to_bool(bool condition) { return condition; }
HN_FN bool hn_i_any(bool condition) { return condition; }

HN_FN hn_float hn_i_minus(hn_float a, hn_float b) {
  HN_I_AS_WRITTEN hn_float n = a - b;
  return n;
}

// abs and max would do for integers, too, but drivers got both wrong: abs(x), and -x of max(max(x, -x), y).
HN_FN hn_float hn_i_magnitude(hn_float x) { return abs(x); }
HN_FN hn_int hn_i_magnitude(hn_int x) { return hn_i_select(x < 0, -x, x); }

HN_FN hn_float hn_i_signed(hn_float m, hn_uint h) {
#if HN_I_BITCAST
  return uintBitsToFloat(floatBitsToUint(m) | (h & 0x80000000u));
#else
  return hn_i_select((h & 0x80000000u) != 0u, -m, m);
#endif
}
HN_FN hn_int hn_i_signed(hn_int m, hn_uint h) { return hn_i_select((h & 0x80000000u) != 0u, -m, m); }

#if HN_ARITHMETIC != HN_FIXED

#define hn_i_num hn_float
#define hn_i_num2 hn_vec2
#define hn_i_num3 hn_vec3
#define hn_i_num4 hn_vec4
#define HN_I_ONE 1.0f

HN_FN hn_vec2 hn_i_vector(hn_float x, hn_float y) { return vec2(x, y); }
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_vec3 hn_i_vector(hn_float x, hn_float y, hn_float z) { return vec3(x, y, z); }
HN_FN hn_vec4 hn_i_vector(hn_float x, hn_float y, hn_float z, hn_float w) { return vec4(x, y, z, w); }

#if HN_ARITHMETIC == HN_FAST

// This takes the constructor of a vector, since in C++ it has a result for a float that does not fit, too.
HN_FN hn_int hn_i_cell(hn_float p) { return ivec2(vec2(floor(p), 0.0f)).x; }

HN_FN hn_float hn_i_fraction(hn_float p) {
  HN_I_AS_WRITTEN hn_float f = p - floor(p);
  return f;
}
HN_FN hn_float hn_i_to_num(hn_float f) { return f; }
HN_FN hn_float hn_i_flushed(hn_float n) { return n; }

#else  // HN_PRECISE

#define HN_I_TINY (1.0f / 4294967296.0f)  // 2^-32

// Replaces a number by 0 if it is so small that a product could be subnormal: drivers may flush subnormal numbers to 0.
HN_FN hn_float hn_i_to_num(hn_float x) { return hn_i_select(abs(x) < HN_I_TINY, 0.0f, x); }

// Replaces a result by 0 if it is so small that flushed subnormal numbers could have changed it: what they lose is at
// most 2^-126, which is less than half of the last bit of any larger result.
HN_FN hn_float hn_i_flushed(hn_float n) { return hn_i_select(abs(n) < HN_I_TINY * HN_I_TINY * HN_I_TINY, 0.0f, n); }

// Converting a float that does not fit an int is undefined. 2147483520 is the largest float below 2^31. In this order a
// NaN, which octaves far beyond the domain reach, has a cell in C++, too.
HN_FN hn_int hn_i_cell(hn_float p) { return int(min(max(-2147483648.0f, floor(hn_i_to_num(p))), 2147483520.0f)); }

HN_FN hn_float hn_i_fraction(hn_float p) {
  hn_float q = hn_i_to_num(p);
  return hn_i_minus(q, floor(q));
}

#endif

HN_FN hn_float hn_i_plus(hn_float a, hn_float b) {
  HN_I_PRECISE hn_float n = a + b;
  return n;
}
HN_FN hn_float hn_i_times(hn_float a, hn_float b) {
  HN_I_PRECISE hn_float n = a * b;
  return n;
}

HN_FN hn_float hn_i_multiply_add(hn_float a, hn_float b, hn_float c) {
  HN_I_PRECISE hn_float n = a * b + c;
  return n;
}

HN_FN hn_float hn_i_dot(hn_vec2 g, hn_float x, hn_float y) {
  HN_I_PRECISE hn_float n = g.x * x + g.y * y;
  return n;
}
// Generated for 3 dimensions from the lines above.
HN_FN hn_float hn_i_dot(hn_vec3 g, hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float n = g.x * x + g.y * y + g.z * z;
  return n;
}

// This form avoids the cancellation of the usual one.
HN_FN hn_float hn_i_fade(hn_float f) {
  HN_I_AS_WRITTEN hn_float d = f - 1.0f;
  HN_I_PRECISE hn_float t = f * f * f * (d * (f * 6.0f - 9.0f) + 1.0f);
  return t;
}

HN_FN hn_float hn_i_lerp(hn_float a, hn_float b, hn_float t) {
  HN_I_PRECISE hn_float n = a + t * (b - a);
  return n;
}

HN_FN hn_float hn_i_scaled(hn_float n, hn_int s) {
  HN_I_PRECISE hn_float scaled = n * (hn_i_float(s) * (1.0f / 1024.0f));
  return scaled;
}

HN_FN hn_float hn_i_value(hn_float n) { return hn_i_flushed(n); }
HN_FN hn_float hn_i_derivative(hn_float n) { return hn_i_flushed(n); }

#else  // HN_FIXED

#define hn_i_num hn_int
#define hn_i_num2 hn_ivec2
#define hn_i_num3 hn_ivec3
#define hn_i_num4 hn_ivec4
#define HN_I_ONE HN_I_UNITS_FRACTION

HN_FN hn_ivec2 hn_i_vector(hn_int x, hn_int y) { return ivec2(x, y); }
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_ivec3 hn_i_vector(hn_int x, hn_int y, hn_int z) { return ivec3(x, y, z); }
HN_FN hn_ivec4 hn_i_vector(hn_int x, hn_int y, hn_int z, hn_int w) { return ivec4(x, y, z, w); }

// The position, or the nearest that has a cell: converting a float that does not fit an int is undefined. 2147483520 is
// the largest float below 2^31. In this order, here and wherever a float is limited, a NaN becomes the least number.
HN_FN hn_float hn_i_in_cells(hn_float p) { return min(max(-2147483648.0f, p), 2147483520.0f); }

// Every step up to the integers is exact in floats, so rounding, contraction and flushed subnormal numbers cannot
// change it. p - floor(p) would not be exact: for a small negative p it has too many bits. So the whole part is cut off
// towards 0, and the rest, in (-1, 1), may be negative. An infinity has the rest of the last cell, which is 0.
HN_FN hn_float hn_i_beside_cell(hn_float p) {
  hn_float q = hn_i_in_cells(p);
  return q - trunc(q);
}
HN_FN hn_int hn_i_rest(hn_float p) { return int(hn_i_beside_cell(p) * HN_I_FLOAT_UNITS_FRACTION); }

HN_FN hn_int hn_i_cell(hn_float p) { return int(trunc(hn_i_in_cells(p))) + (hn_i_rest(p) >> 20); }

HN_FN hn_int hn_i_fraction(hn_float p) { return hn_i_rest(p) & (HN_I_UNITS_FRACTION - 1); }

HN_FN hn_int hn_i_to_num(hn_float f) { return int(min(max(0.0f, f), 1.0f) * HN_I_FLOAT_UNITS_FRACTION); }

HN_FN hn_int hn_i_plus(hn_int a, hn_int b) { return a + b; }
HN_FN hn_int hn_i_minus(hn_int a, hn_int b) { return a - b; }

// The distance of a fraction from the nearer end, in units of 2^-17, rounded. It has 16 bits, so it is never 1/2, which
// has one bit more. It is unsigned, so that compilers see a product of 24 bits in its square. AMD and Adreno compute
// that at a third of the cost of one of 32 bits.
HN_FN hn_uint hn_i_from_end(hn_int f) {
  hn_uint x = uint(f);
  return min(min(x, 1048576u - x) + 4u, 524287u) >> 3u;
}

// The result is in units of 2^-18 and never falls. With the nearer end at 0, f^3 (10 - 15 f + 6 f^2) is computed as f Q
// with Q = f^2 (4 + R) and R = 6 - 15 f + 6 f^2. The other half is the mirror image. x has 16 bits and its square 32.
// The summands 32768 and 16384 round. r is below 2^19: its mask is for compilers, as above.
HN_FN hn_int hn_i_fade(hn_int f) {
  hn_uint x = hn_i_from_end(f);
  hn_uint square = x * x;
  hn_uint z = (square + 32768u) >> 16u;
  hn_uint r = ((1572864u + 6u * z - 30u * x) >> 2u) & 524287u;
  hn_uint q = (square + ((z * r) >> 2u) + 32768u) >> 16u;
  hn_int t = int((x * q + 16384u) >> 15u);
  return hn_i_select(f > HN_I_UNITS_FRACTION / 2, HN_I_UNITS_WEIGHT - t, t);
}

// Computes a product of 31 and 19 bits, divided by 2^18, from two products that fit 32 bits: one by the high and one by
// the low half of t.
HN_FN hn_int hn_i_part(hn_int d, hn_int t) { return (d >> 9) * (t >> 9) + (d >> 18) * (t & 511); }

HN_FN hn_int hn_i_lerp(hn_int a, hn_int b, hn_int t) { return a + hn_i_part(b - a, t); }

// Converts units of 2^-29 to units of 2^-21, rounded.
HN_FN hn_int hn_i_scaled(hn_int n, hn_int s) { return (((n + 256) >> 9) * s + 256) >> 9; }

HN_FN hn_float hn_i_value(hn_int n) { return HN_I_NOT_WHOLE(hn_i_float(n) * (1.0f / HN_I_FLOAT_UNITS_VALUE)); }

// The step that takes a noise from units of 2^-29 to units of 2^-21 takes a derivative from units of 2^-27 to units of
// 2^-19.
HN_FN hn_float hn_i_derivative(hn_int n) { return hn_i_float(n) * (1.0f / HN_I_FLOAT_UNITS_SLOPE); }

#endif

HN_FN hn_i_num hn_i_minus_one(hn_i_num f) { return hn_i_minus(f, HN_I_ONE); }

HN_FN hn_i_num hn_i_lerp(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_lerp(n.x, n.y, x), hn_i_lerp(n.z, n.w, x), y);
}

#endif
