// hashnoise: the sine of an angle in turns.
// SPDX-License-Identifier: MIT

#ifndef HN_SINE_GLSL
#define HN_SINE_GLSL

#include "arithmetic.glsl"

//   hn_i_angle(turns)          the angle of a number of turns, in units of 2^-32 turns
//   hn_i_quarter_sine(q)       sin(x pi / 2) of a uint in [0, 2^30] that stands for x in [0, 1]
//   hn_i_wave(angle, sign)     the sine of an angle in units of 2^-32 turns, or its negative if the highest bit of the
//                              uint sign is set
//
// They are numbers of HN_ARITHMETIC. With every HN_ARITHMETIC there are also those of HN_FIXED, in units of 2^-16:
//
//   hn_i_whole_quarter_sine(q), hn_i_whole_wave(angle, sign)

// A number of turns is cut off to a multiple of 2^-30. Every step is exact, and the angle of a negative one wraps. So
// whole turns change no bit.
HN_FN hn_uint hn_i_angle(hn_float turns) { return uint(int((turns - trunc(turns)) * 1073741824.0f)) << 2u; }

// The first quarter of the wave is enough: the second is its mirror image, and the second half is the first, negated.
// The quarter is in units of 2^-30 of itself.
HN_FN hn_uint hn_i_in_quarter(hn_uint angle) {
  hn_uint q = angle & 0x7FFFFFFFu;
  return min(q, 0x80000000u - q);
}

// This is nearly the polynomial of the floats, in units of 2^-16. It is at most 1.
HN_FN hn_int hn_i_whole_quarter_sine(hn_uint q) {
  hn_uint x = min((q + 8192u) >> 14u, 65535u);
  hn_uint t = (x * x) >> 16u;
  hn_uint y = 102943u - ((t * (42328u - ((t * (5208u - ((t * 288u) >> 16u))) >> 16u))) >> 16u);
  return int((x * (y >> 1u) + 16384u) >> 15u);
}

HN_FN hn_int hn_i_whole_wave(hn_uint angle, hn_uint sign) {
  return hn_i_signed(hn_i_whole_quarter_sine(hn_i_in_quarter(angle)), angle ^ sign);
}

#if HN_ARITHMETIC != HN_FIXED

// The polynomial is minimax. At the end it is held at 1 - 2^-21, so that no rounding takes it beyond 1. It is off by
// 6.4e-7 at most.
HN_FN hn_float hn_i_quarter_sine(hn_uint q) {
  hn_float x = hn_i_float(q >> 6u) * (1.0f / 16777216.0f);
  HN_I_PRECISE hn_float t = x * x;
  HN_I_PRECISE hn_float sine = x * (1.57079090f + t * (-0.64589171f + t * (0.07943160f + t * -0.00433127f)));
  return sine;
}

HN_FN hn_float hn_i_wave(hn_uint angle, hn_uint sign) {
  return hn_i_signed(hn_i_quarter_sine(hn_i_in_quarter(angle)), angle ^ sign);
}

#else

HN_FN hn_int hn_i_wave(hn_uint angle, hn_uint sign) { return hn_i_whole_wave(angle, sign); }

#endif

#endif
