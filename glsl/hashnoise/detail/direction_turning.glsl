// hashnoise: gradients that rotate with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_TURNING_GLSL
#define HN_DIRECTION_TURNING_GLSL

#include "arithmetic.glsl"
#include "sine.glsl"

//   hn_i_rotation(phase)       the cosine and the sine of a phase in turns; in HN_FIXED in units of 2^-18
//   hn_i_mixed(r, a, b)        r.x a + r.y b: where a rotation takes a, if a quarter of a turn takes it to b; also of
//                              three and four at once

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec2 hn_i_rotation(hn_float cosine, hn_float sine) { return vec2(cosine, sine); }

HN_FN hn_float hn_i_mixed(hn_vec2 r, hn_float a, hn_float b) {
  HN_I_PRECISE hn_float n = r.x * a + r.y * b;
  return n;
}

#else

HN_FN hn_ivec2 hn_i_rotation(hn_int cosine, hn_int sine) { return ivec2(cosine * 4, sine * 4); }
HN_FN hn_int hn_i_mixed(hn_ivec2 r, hn_int a, hn_int b) { return hn_i_part(a, r.x) + hn_i_part(b, r.y); }

#endif

HN_FN hn_i_num2 hn_i_rotation(hn_float phase) {
  hn_uint angle = hn_i_angle(phase);
  return hn_i_rotation(hn_i_wave(angle + 0x40000000u, 0u), hn_i_wave(angle, 0u));
}

// Gradients that rotate with a phase. On the plane all rotate alike. In space each rotates in the plane of its two
// axes. Noise is a sum over gradients, so it is the noise of the gradients times the cosine and that of the gradients
// that are rotated by a quarter turn times the sine.
HN_FN hn_i_num3 hn_i_mixed(hn_i_num2 r, hn_i_num3 a, hn_i_num3 b) {
  return hn_i_vector(hn_i_mixed(r, a.x, b.x), hn_i_mixed(r, a.y, b.y), hn_i_mixed(r, a.z, b.z));
}
HN_FN hn_i_num4 hn_i_mixed(hn_i_num2 r, hn_i_num4 a, hn_i_num4 b) {
  return hn_i_vector(hn_i_mixed(r, a.x, b.x), hn_i_mixed(r, a.y, b.y), hn_i_mixed(r, a.z, b.z),
                     hn_i_mixed(r, a.w, b.w));
}

#endif
