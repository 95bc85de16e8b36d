// hashnoise: numbers of hashes, and value noise, which blends them.
// SPDX-License-Identifier: MIT

#ifndef HN_VALUE_GLSL
#define HN_VALUE_GLSL

#include "arithmetic.glsl"

//   hn_i_number(h)             the low 23 bits of a hash as a number in [-1, 1), with an offset, which
//                              hn_i_noise_of_numbers takes off
//   hn_i_numbers(h)            the same of four hashes
//   hn_i_noise_of_numbers(n)   a noise, from an interpolation between such numbers
//   hn_i_value_noise(h, t)     value noise, from the hashes of the corners of a square and the fades along each axis;
//                              in space from the front and the back face

#if HN_ARITHMETIC != HN_FIXED

// The low 23 bits of a hash, behind the exponent of 2, are a float in [2, 4): that costs two operations. The 3 that are
// too many stay in until the end, since weights sum to 1 and derivatives do not see them.
HN_FN hn_float hn_i_number(hn_uint h) {
#if HN_I_BITCAST
  return uintBitsToFloat((h & 0x007FFFFFu) | 0x40000000u);
#else
  return hn_i_float(h & 0x007FFFFFu) * (1.0f / 4194304.0f) + 2.0f;
#endif
}

HN_FN hn_float hn_i_noise_of_numbers(hn_float n) { return hn_i_minus(n, 3.0f); }

#else

// A number is in units of 2^-29 and has no offset. From there the noise is rounded to units of 2^-21.
HN_FN hn_int hn_i_number(hn_uint h) { return int((h & 0x007FFFFFu) << 7u) - HN_I_UNITS_RAMP; }
HN_FN hn_int hn_i_noise_of_numbers(hn_int n) { return (n + 128) >> 8; }

#endif

HN_FN hn_i_num4 hn_i_numbers(hn_uvec4 h) {
  return hn_i_vector(hn_i_number(h.x), hn_i_number(h.y), hn_i_number(h.z), hn_i_number(h.w));
}
HN_FN hn_i_num hn_i_value_noise(hn_uvec4 h, hn_i_num2 t) {
  return hn_i_noise_of_numbers(hn_i_lerp(hn_i_numbers(h), t.x, t.y));
}
HN_FN hn_i_num hn_i_value_noise(hn_uvec4 front, hn_uvec4 back, hn_i_num3 t) {
  return hn_i_noise_of_numbers(
      hn_i_lerp(hn_i_lerp(hn_i_numbers(front), t.x, t.y), hn_i_lerp(hn_i_numbers(back), t.x, t.y), t.z));
}

#endif
