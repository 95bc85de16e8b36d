// hashnoise: gradients that turn with a phase.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION_TURNING_GLSL
#define HN_DIRECTION_TURNING_GLSL

#include "direction.glsl"
#include "sine.glsl"

//   hn_i_rotation(phase)       the cosine and the sine of a phase in turns; in HN_FIXED in units of 2^-18
//   hn_i_mixed(r, a, b)        r.x a + r.y b: where a rotation takes a, if a quarter of a turn takes it to b

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

// Gradients that turn with a phase. On the plane all turn alike. In space each turns in the plane of its two axes.

HN_FN hn_i_num2 hn_i_rotated(hn_i_num2 g, hn_i_num2 rotation) {
  return hn_i_vector(hn_i_mixed(rotation, g.x, -g.y), hn_i_mixed(rotation, g.y, g.x));
}
HN_FN hn_i_num2 hn_i_gradient2(hn_uint h, hn_i_num2 rotation) { return hn_i_rotated(hn_i_gradient2(h), rotation); }
HN_FN hn_i_num3 hn_i_gradient3(hn_uint h, hn_i_num2 rotation) {
  hn_i_num2 g = hn_i_rotated(hn_i_sign_pair(h), rotation);
  return hn_i_along_axes(h, g.x, g.y);
}

// After a quarter of a turn (x, y) has become (-y, x), and (x, y) times an offset is as much as the gradient times the
// offset that has turned back.
HN_FN hn_i_num hn_i_ramp2(hn_uint h, hn_float x, hn_float y, hn_i_num2 rotation) {
  hn_vec2 g = hn_i_direction2(h);
  return hn_i_mixed(rotation, hn_i_ramp_of2(hn_i_along2(g, x, y)), hn_i_ramp_of2(hn_i_along2(g, y, -x)));
}
HN_FN hn_i_num hn_i_ramp3(hn_uint h, hn_float x, hn_float y, hn_float z, hn_i_num2 rotation) {
  hn_vec2 s = hn_i_signs(h);
  hn_vec2 d = hn_i_pair(h, x, y, z);
  return hn_i_mixed(rotation, hn_i_ramp_of3(hn_i_along3(s, d.x, d.y)), hn_i_ramp_of3(hn_i_along3(s, d.y, -d.x)));
}

#endif
