// hashnoise: turns: the sine of an angle, and gradients that turn with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_TURN_GLSL
#define HN_TURN_GLSL

#include "arithmetic.glsl"

//   hn_i_quarter_sine(q)       sin(x pi / 2) of a word of [0, 2^30] that stands for x in [0, 1]
//   hn_i_wave(angle, sign)     the sine of an angle in units of 2^-32 turns, or its negative if the highest bit of the
//                              word `sign` is set
//   hn_i_rotation(phase)       the cosine and the sine of a phase in turns; in HN_FIXED in units of 2^-18
//   hn_i_mixed(r, a, b)        r.x a + r.y b: where a rotation takes a, if a quarter of a turn takes it to b
//   hn_i_dot(g, x, y, ...)     a gradient that is made of sines times an offset (arithmetic.glsl has that of floats)
//   hn_i_components(g)         the floats of such a gradient
//   hn_i_scaled_ramps(n, s)    hn_i_scaled of an interpolation between longer ramps: in HN_FIXED they are in units of
//                              2^-28, twice those of others

#if HN_ARITHMETIC != HN_FIXED

// The polynomial is minimax. At the end it is held at 1 - 2^-21, so that no rounding takes it beyond 1. It is off by
// 6.4e-7 at most.
HN_FN hn_float hn_i_quarter_sine(hn_uint q) {
  hn_float x = hn_i_float(q >> 6u) * (1.0f / 16777216.0f);
  HN_I_PRECISE hn_float t = x * x;
  HN_I_PRECISE hn_float sine = x * (1.57079090f + t * (-0.64589171f + t * (0.07943160f + t * -0.00433127f)));
  return sine;
}

HN_FN hn_vec2 hn_i_components(hn_vec2 g) { return g; }
HN_FN hn_vec3 hn_i_components(hn_vec3 g) { return g; }

HN_FN hn_float hn_i_scaled_ramps(hn_float n, hn_int s) { return hn_i_scaled(n, s); }

HN_FN hn_vec2 hn_i_rotation(hn_float cosine, hn_float sine) { return vec2(cosine, sine); }

HN_FN hn_float hn_i_mixed(hn_vec2 r, hn_float a, hn_float b) {
  HN_I_PRECISE hn_float n = r.x * a + r.y * b;
  return n;
}

#else

// This is nearly the polynomial of the floats, in units of 2^-16. It is at most 1.
HN_FN hn_int hn_i_quarter_sine(hn_uint q) {
  hn_uint x = min((q + 8192u) >> 14u, 65535u);
  hn_uint t = (x * x) >> 16u;
  hn_uint y = 102943u - ((t * (42328u - ((t * (5208u - ((t * 288u) >> 16u))) >> 16u))) >> 16u);
  return int((x * (y >> 1u) + 16384u) >> 15u);
}

HN_FN hn_vec2 hn_i_components(hn_ivec2 g) { return vec2(hn_i_float(g.x), hn_i_float(g.y)) * (1.0f / 65536.0f); }
HN_FN hn_vec3 hn_i_components(hn_ivec3 g) {
  return vec3(hn_i_float(g.x), hn_i_float(g.y), hn_i_float(g.z)) * (1.0f / 65536.0f);
}

HN_FN hn_int hn_i_scaled_ramps(hn_int n, hn_int s) { return hn_i_scaled(n, s + s); }

// Computes a product of 17 and 21 bits, in units of 2^-28: by the high part and by the low byte of g.
HN_FN hn_int hn_i_product(hn_int g, hn_int x) { return (g >> 8) * x + (((g & 255) * x) >> 8); }
HN_FN hn_int hn_i_dot(hn_ivec2 g, hn_int x, hn_int y) { return hn_i_product(g.x, x) + hn_i_product(g.y, y); }
HN_FN hn_int hn_i_dot(hn_ivec3 g, hn_int x, hn_int y, hn_int z) {
  return hn_i_product(g.x, x) + hn_i_product(g.y, y) + hn_i_product(g.z, z);
}

HN_FN hn_ivec2 hn_i_rotation(hn_int cosine, hn_int sine) { return ivec2(cosine * 4, sine * 4); }
HN_FN hn_int hn_i_mixed(hn_ivec2 r, hn_int a, hn_int b) { return hn_i_part(a, r.x) + hn_i_part(b, r.y); }

#endif

// The first quarter of the wave is enough: the second is its mirror image, and the second half is the first, negated.
// The quarter is in units of 2^-30 of itself.
HN_FN hn_num hn_i_wave(hn_uint angle, hn_uint sign) {
  hn_uint q = angle & 0x7FFFFFFFu;
  return hn_i_signed(hn_i_quarter_sine(min(q, 0x80000000u - q)), angle ^ sign);
}

// Every step up to the angle is exact, and the angle of a negative phase wraps. So whole turns change no bit.
HN_FN hn_num2 hn_i_rotation(hn_float phase) {
  hn_uint angle = uint(int((phase - trunc(phase)) * 1073741824.0f)) << 2u;
  return hn_i_rotation(hn_i_wave(angle + 0x40000000u, 0u), hn_i_wave(angle, 0u));
}

#endif
