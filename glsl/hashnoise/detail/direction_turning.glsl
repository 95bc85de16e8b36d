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

// Gradients that turn with a phase. On the plane all turn alike. In space each turns in the plane of the two axes along
// which it is longest; its component along the third shrinks to nothing in a quarter of a turn, and comes back
// negative.

// Chooses one of three things, which belong to x, y and z: that of the axis along which a direction in space is
// shortest.
HN_FN hn_i_num hn_i_by_shortest(hn_i_num4 d, hn_i_num x, hn_i_num y, hn_i_num z) {
  hn_i_num a = hn_i_plus(d.x, d.y);   // twice the direction along x
  hn_i_num b = hn_i_minus(d.x, d.y);  // along y
  hn_i_num along_x = hn_i_size(a);
  hn_i_num along_y = hn_i_size(b);
  hn_i_num along_z = hn_i_plus(hn_i_size(d.z), hn_i_size(d.z));
  return hn_i_select(along_z <= min(along_x, along_y), z, hn_i_select(along_y <= along_x, y, x));
}

HN_FN hn_i_num hn_i_ramp(hn_i_num3 d, hn_i_num x, hn_i_num y, hn_i_num2 rotation) {
  return hn_i_times_one_plus(hn_i_mixed(rotation, hn_i_dot_direction(d, x, y), hn_i_cross(d.x, y, d.y, x)), d.z);
}
HN_FN hn_i_num hn_i_ramp(hn_i_num4 d, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num2 rotation) {
  hn_i_num u = hn_i_octahedral(x);
  hn_i_num v = hn_i_octahedral(y);
  hn_i_num w = hn_i_octahedral(z);
  hn_i_num a = hn_i_plus(d.x, d.y);
  hn_i_num b = hn_i_minus(d.x, d.y);
  hn_i_num m = hn_i_plus(d.z, d.z);
  hn_i_num turned = hn_i_by_shortest(d, hn_i_cross(b, w, m, v), hn_i_cross(m, u, a, w), hn_i_cross(a, v, b, u));
  return hn_i_times_one_plus(
      hn_i_mixed(rotation, hn_i_dot_direction(d, hn_i_plus(u, v), hn_i_minus(u, v), hn_i_octahedral_z(z)), turned),
      d.w);
}

HN_FN hn_i_num2 hn_i_rotated(hn_i_num2 g, hn_i_num2 rotation) {
  return hn_i_vector(hn_i_mixed(rotation, g.x, -g.y), hn_i_mixed(rotation, g.y, g.x));
}
HN_FN hn_i_num2 hn_i_gradient(hn_i_num3 d, hn_i_num2 rotation) { return hn_i_rotated(hn_i_gradient(d), rotation); }
HN_FN hn_i_num3 hn_i_gradient(hn_i_num4 d, hn_i_num2 rotation) {
  hn_i_num3 g = hn_i_gradient(d);
  hn_i_num none = hn_i_minus(HN_I_ONE, HN_I_ONE);
  return hn_i_vector(hn_i_mixed(rotation, g.x, hn_i_by_shortest(d, none, g.z, -g.y)),
                     hn_i_mixed(rotation, g.y, hn_i_by_shortest(d, -g.z, none, g.x)),
                     hn_i_mixed(rotation, g.z, hn_i_by_shortest(d, g.y, -g.x, none)));
}

#endif
