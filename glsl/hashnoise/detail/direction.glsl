// hashnoise: gradients from hashes on the line and on the plane, and their ramps: what they add at an offset.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_GLSL
#define HN_DIRECTION_GLSL

#include "cell2d.glsl"

// On the plane a gradient is one of 8: (3, 1) / 4 and (1, 3) / 4, with signs. Their second moments are those of a
// circle, so noise has the spectrum that gradients of all directions would give it. A gradient that is rotated by a
// quarter turn is one of the set, too. Gradients are floats with every HN_ARITHMETIC, and exact.
//
//   hn_i_offset(x)                   an offset as a float
//   hn_i_far(x)                      x - 1 of such a float: the offset from the far corner
//   hn_i_exact(t)                    a fade or a weight as a float
//   hn_i_direction2(h, turned)       the gradient of a hash on the plane, or what a quarter turn makes of it
//   hn_i_along2(g, x, y)             a gradient times an offset; in HN_FIXED in units of 2^-22
//   hn_i_ramp_of2(n)                 takes it to the units of ramps
//   hn_i_lerp_ramps2(a, b, t)        interpolates from a to b by a fade, to a ramp
//   hn_i_ramp_difference2(a, b)      their difference, in the units of derivatives
//   hn_i_weighted_component(g, w)    HN_FIXED only: a component of a gradient times an exact weight, in the units of
//                                    derivatives
//   hn_i_lerp_components(g, h, t)    interpolates from g to h by an exact fade, to the units of derivatives
//   hn_i_gradient1(h)                the gradient on the line, and hn_i_ramp1(g, x), what it adds
//   hn_i_scaled1(n)                  noise on the line that is interpolated between ramps, in [-1, 1]: before it is at
//                                    most 1/2

// Bits behind an exponent make a float without a shift and without a conversion from integer. But a compiler that knows
// the offset may multiply out the difference, and round. So HN_FIXED chooses.
#if HN_I_BITCAST && HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_quarters_of(hn_uint h) {
  return hn_i_minus(uintBitsToFloat((h & 0x00600000u) | 0x40000000u), 2.75f);
}
#else
HN_FN hn_float hn_i_quarters_of(hn_uint h) {
  hn_float one = 0.25f;
  hn_float three = 0.75f;
  return hn_i_select((h & 0x00400000u) != 0u, hn_i_select((h & 0x00200000u) != 0u, three, one),
                     hn_i_select((h & 0x00200000u) != 0u, -one, -three));
}
#endif
HN_FN hn_vec2 hn_i_direction2(hn_uint h) {
  hn_float x = hn_i_quarters_of(h);
  return vec2(x, hn_i_signed(hn_i_minus(1.0f, abs(x)), h));
}
HN_FN hn_vec2 hn_i_turned(hn_vec2 g, bool turned) {
  hn_vec2 n = g;
  if (turned) n = vec2(-g.y, g.x);
  return n;
}
HN_FN hn_vec2 hn_i_direction2(hn_uint h, bool turned) { return hn_i_turned(hn_i_direction2(h), turned); }

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_offset(hn_float x) { return x; }
HN_FN hn_float hn_i_far(hn_float x) { return hn_i_minus_one(x); }
HN_FN hn_float hn_i_exact(hn_float t) { return t; }
HN_FN hn_float hn_i_along2(hn_vec2 g, hn_float x, hn_float y) { return hn_i_dot(g, x, y); }
HN_FN hn_float hn_i_ramp_of2(hn_float n) { return n; }
HN_FN hn_float hn_i_lerp_ramps2(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }
HN_FN hn_float hn_i_ramp_difference2(hn_float a, hn_float b) { return hn_i_minus(b, a); }
HN_FN hn_float hn_i_lerp_components(hn_float g, hn_float h, hn_float t) { return hn_i_lerp(g, h, t); }

HN_FN hn_float hn_i_gradient1(hn_uint h) {
#if HN_I_BITCAST
  return hn_i_minus(uintBitsToFloat((h & 0x007FC000u) | 0x40000000u), 3.0f - 1.0f / 512.0f);
#else
  return hn_i_minus(hn_i_float((h >> 14u) & 511u) * (1.0f / 256.0f), 1.0f - 1.0f / 512.0f);
#endif
}
HN_FN hn_float hn_i_ramp1(hn_float g, hn_float x) { return hn_i_times(g, x); }

#else

// Floats compute this without rounding. The summands of 12 are multiples of 2^-20, and with 3 multiples of 2^-22:
// the last bit of a float there, so that its bits are that number as an integer. Each part of a sum is such a multiple,
// and so is each partial sum. So no order of the sum rounds, and no contraction. No part may be a difference from a
// large constant, such as a number whose bits stand behind an exponent: a compiler that knows the other parts would add
// up such constants, and the sum would have too few bits.
HN_FN hn_float hn_i_offset(hn_int x) { return hn_i_float(x) * (1.0f / HN_I_FLOAT_UNITS_FRACTION); }
HN_FN hn_float hn_i_far(hn_float x) { return x - 1.0f; }
#if HN_I_BITCAST
HN_FN hn_int hn_i_beyond_3(hn_float n) { return int(floatBitsToUint(n) - 0x40400000u); }
HN_FN hn_int hn_i_beyond_12(hn_float n) { return int(floatBitsToUint(n) - 0x41400000u); }
#else
HN_FN hn_int hn_i_beyond_3(hn_float n) { return int((n - 3.0f) * 4194304.0f); }
HN_FN hn_int hn_i_beyond_12(hn_float n) { return int((n - 12.0f) * HN_I_FLOAT_UNITS_FRACTION); }
#endif

HN_FN hn_float hn_i_exact(hn_int t) { return hn_i_offset(t * 4); }
HN_FN hn_int hn_i_along2(hn_vec2 g, hn_float x, hn_float y) { return hn_i_beyond_3(g.x * x + 3.0f + g.y * y); }
HN_FN hn_int hn_i_ramp_of2(hn_int n) { return n * 128; }

// These are hn_i_lerp and hn_i_d_corner of ramps, without the bits that are 0 in them.
HN_FN hn_int hn_i_lerp_ramps2(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return a * 128 + ((d >> 2) * (t >> 9) + (d >> 11) * (t & 511));
}
HN_FN hn_int hn_i_ramp_difference2(hn_int a, hn_int b) { return (b - a) * 32; }

HN_FN hn_int hn_i_weighted_component(hn_float g, hn_float w) { return hn_i_beyond_3(g * w + 3.0f) * 32; }
HN_FN hn_int hn_i_lerp_components(hn_float g, hn_float h, hn_float t) {
  return hn_i_beyond_3((h - g) * t + (g + 3.0f)) * 32;
}

// In units of 2^-27.
HN_FN hn_int hn_i_gradient1(hn_uint h) { return (int((h >> 13u) & 1022u) - 511) * 262144; }
HN_FN hn_int hn_i_ramp1(hn_int g, hn_int x) { return (g >> 18) * x; }

#endif

HN_FN hn_i_num hn_i_scaled1(hn_i_num n) { return hn_i_scaled(n, 2048); }

// Each HN_GRADIENT offers these functions:
//
//   hn_i_ramps(corners, f, seed)  what the corners 00, 10, 01, 11 of a cell add at the place f in it
//   hn_i_bilerp_ramps2(n, x, y)   interpolates between such four by fades x and y
//   hn_i_scaled2(n)               noise that is interpolated between ramps, in [-1, 1]

#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL

// From the hashes of the corners, where the gradients may be rotated by a quarter turn.
HN_FN hn_i_num4 hn_i_ramps(hn_uvec4 h, hn_i_num2 f, bool turned) {
  hn_float x = hn_i_offset(f.x);
  hn_float y = hn_i_offset(f.y);
  hn_float x1 = hn_i_far(x);
  hn_float y1 = hn_i_far(y);
  return hn_i_vector(hn_i_along2(hn_i_direction2(h.x, turned), x, y), hn_i_along2(hn_i_direction2(h.y, turned), x1, y),
                     hn_i_along2(hn_i_direction2(h.z, turned), x, y1),
                     hn_i_along2(hn_i_direction2(h.w, turned), x1, y1));
}
HN_FN hn_i_num4 hn_i_ramps(hn_i_cell_corners2 corners, hn_i_num2 f, hn_uint seed) {
  return hn_i_ramps(hn_i_corner_hashes(corners, seed), f, false);
}

HN_FN hn_i_num hn_i_bilerp_ramps2(hn_i_num4 n, hn_i_num x, hn_i_num y) {
  return hn_i_lerp(hn_i_lerp_ramps2(n.x, n.y, x), hn_i_lerp_ramps2(n.z, n.w, x), y);
}

// Noise before it is scaled, from the hashes of the corners and the fades.
HN_FN hn_i_num hn_i_cell_of_ramps(hn_uvec4 h, hn_i_num2 f, hn_i_num2 t, bool turned) {
  return hn_i_bilerp_ramps2(hn_i_ramps(h, f, turned), t.x, t.y);
}

// 1831 / 1024 is just below 1 / 0.55902: the largest value that a noise has before it is scaled, with rotating
// gradients, too (tools/make bounds).
HN_FN hn_i_num hn_i_scaled2(hn_i_num n) { return hn_i_scaled(n, 1831); }

#endif

#endif
