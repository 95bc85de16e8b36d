// hashnoise: gradients that rotate with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_TURNING_GLSL
#define HN_DIRECTION_TURNING_GLSL

#include "arithmetic.glsl"
#include "sine.glsl"

// On the plane all gradients rotate alike. In space each rotates in a plane across a diagonal of the cube: it is
// another edge after each sixth of a turn, and the sum of the fourth powers of its components stays, so structures
// prefer no direction more than without a phase. (In the plane of its two axes it would be one of them after an
// eighth.) Noise is a sum over gradients. So it is that of the gradients g times a weight, and that of the gradients e,
// rotated by a quarter or in space by a sixth, times another weight.
//
//   hn_i_rotation(phase)       the weights on the plane: the cosine and the sine of a phase in turns; in HN_FIXED in
//                              units of 2^-18
//   hn_i_rotation3(phase)      the weights in space
//   hn_i_mixed(r, a, b)        r.x a + r.y b; also of three and four at once

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_vec2 hn_i_rotation(hn_float cosine, hn_float sine) { return vec2(cosine, sine); }
HN_FN hn_vec2 hn_i_to_sixths(hn_vec2 r) {
  HN_I_PRECISE hn_float e = r.y * 1.15470054f;
  HN_I_PRECISE hn_float g = r.x - 0.5f * e;
  return vec2(g, e);
}

HN_FN hn_float hn_i_mixed(hn_vec2 r, hn_float a, hn_float b) {
  HN_I_PRECISE hn_float n = r.x * a + r.y * b;
  return n;
}

#else

HN_FN hn_ivec2 hn_i_rotation(hn_int cosine, hn_int sine) { return ivec2(cosine * 4, sine * 4); }
HN_FN hn_ivec2 hn_i_to_sixths(hn_ivec2 r) {
  hn_int e = r.y + (((r.y >> 2) * 20277) >> 15);
  return ivec2(r.x - (e >> 1), e);
}
HN_FN hn_int hn_i_mixed(hn_ivec2 r, hn_int a, hn_int b) { return hn_i_part(a, r.x) + hn_i_part(b, r.y); }

#endif

HN_FN hn_i_num2 hn_i_rotation(hn_float phase) {
  hn_uint angle = hn_i_angle(phase);
  return hn_i_rotation(hn_i_wave(angle + 0x40000000u, 0u), hn_i_wave(angle, 0u));
}

// After the angle a gradient is cos g + sin (2 e - g) / sqrt(3), since e is cos(60 degrees) g and sin(60 degrees) times
// what is perpendicular to it.
HN_FN hn_i_num2 hn_i_rotation3(hn_float phase) { return hn_i_to_sixths(hn_i_rotation(phase)); }

HN_FN hn_i_num3 hn_i_mixed(hn_i_num2 r, hn_i_num3 a, hn_i_num3 b) {
  return hn_i_vector(hn_i_mixed(r, a.x, b.x), hn_i_mixed(r, a.y, b.y), hn_i_mixed(r, a.z, b.z));
}
HN_FN hn_i_num4 hn_i_mixed(hn_i_num2 r, hn_i_num4 a, hn_i_num4 b) {
  return hn_i_vector(hn_i_mixed(r, a.x, b.x), hn_i_mixed(r, a.y, b.y), hn_i_mixed(r, a.z, b.z),
                     hn_i_mixed(r, a.w, b.w));
}

#endif
