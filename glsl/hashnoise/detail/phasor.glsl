// hashnoise: the waves of phasor noise, around a lattice point.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_GLSL
#define HN_PHASOR_GLSL

#include "falloff.glsl"
#include "sine.glsl"

// An angle is a word, in units of 2^-32 turns, so that it wraps as turns do.
//
//   hn_i_waves(k)              a component of a wave vector, in waves per cell: at most 16 in size. In HN_FIXED in
//                              units of 2^-16
//   hn_i_waves_from(k, x, y)   the angle of the waves along an offset, whose steps are half a cell on the plane, and a
//                              cell in space; in HN_FIXED that of each axis rounded down
//   hn_i_wave_at(angle, w)     the cosine and the sine of an angle, times a weight

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_waves(hn_float k) { return min(max(k, -16.0f), 16.0f); }
HN_FN hn_uint hn_i_waves_from(hn_vec2 k, hn_float x, hn_float y) {
  HN_I_PRECISE hn_float turns = (k.x * x + k.y * y) * 0.5f;
  return hn_i_angle(turns);
}
HN_FN hn_uint hn_i_waves_from(hn_vec3 k, hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float turns = k.x * x + k.y * y + k.z * z;
  return hn_i_angle(turns);
}
HN_FN hn_float hn_i_as_ramp(hn_float sine) { return sine; }

#else

HN_FN hn_int hn_i_waves(hn_float k) { return int(min(max(k, -16.0f), 16.0f) * 65536.0f); }

// k d / 2^4, and half of that. Of the up to 42 bits of k d the low 32 count behind the shift. Half of the offset at a
// time keeps each product below 2^31.
HN_FN hn_uint hn_i_crossed(hn_int k, hn_int d) { return (uint(k * (d >> 10)) << 6u) + uint((k * (d & 1023)) >> 4); }
HN_FN hn_uint hn_i_crossed_half(hn_int k, hn_int d) {
  return (uint(k * (d >> 10)) << 5u) + uint((k * (d & 1023)) >> 5);
}
HN_FN hn_uint hn_i_waves_from(hn_ivec2 k, hn_int x, hn_int y) {
  return hn_i_crossed_half(k.x, x) + hn_i_crossed_half(k.y, y);
}
HN_FN hn_uint hn_i_waves_from(hn_ivec3 k, hn_int x, hn_int y, hn_int z) {
  return hn_i_crossed(k.x, x) + hn_i_crossed(k.y, y) + hn_i_crossed(k.z, z);
}
// From units of 2^-16 to those of ramps.
HN_FN hn_int hn_i_as_ramp(hn_int sine) { return sine * 8192; }

#endif

HN_FN hn_num2 hn_i_wave_at(hn_uint angle, hn_num w) {
  return hn_i_num(hn_i_weighted_ramp(hn_i_as_ramp(hn_i_wave(angle + 0x40000000u, 0u)), w),
                  hn_i_weighted_ramp(hn_i_as_ramp(hn_i_wave(angle, 0u)), w));
}
HN_FN hn_num2 hn_i_plus(hn_num2 a, hn_num2 b) { return hn_i_num(hn_i_plus(a.x, b.x), hn_i_plus(a.y, b.y)); }

#endif
