// hashnoise: the waves of phasor noise, around a lattice point.
// SPDX-License-Identifier: MIT

#ifndef HN_PHASOR_GLSL
#define HN_PHASOR_GLSL

#include "falloff.glsl"
#include "sphere.glsl"

// An angle is a uint, in units of 2^-32 turns, so that it wraps as turns do.
//
//   hn_i_waves(k)              a component of a wave vector, in waves per cell: at most 16 in size. In HN_FIXED in
//                              units of 2^-16
//   hn_i_bandwidth(b)          how far the waves of points are from that, in waves per cell: in [0, 16]. In HN_FIXED in
//                              units of 2^-16
//   hn_i_own_wave(k, b, u)     a component of the wave of a point: u is the component of its direction, in
//                              units of 2^-16
//   hn_i_own_waves(k, b, h)    the wave of a point with the hash h
//   hn_i_waves_from(k, x, y)   the angle of the waves along an offset, whose steps are half a cell on the plane, and a
//                              cell in space; in HN_FIXED that of each axis rounded down
//   hn_i_unit_wave(angle)      the cosine and the sine of an angle, as ramps
//   hn_i_weight_wave(t)        the weight of a point, t^3 (1 + 15 (1 - t)^2): the energy of the waves, which is the sum
//                              of the squared weights, is nearly the same everywhere
//   hn_i_d_weight_wave(t, m)   how the weight falls: 2 m times its derivative by t; in HN_FIXED an eighth of that
//   hn_i_weighted_wave(n, w)   these times a weight or a fall; hn_i_wave_at(angle, w) is both steps
//   hn_i_falling_wave(n, x)    what falls along the offset x: -n x, of these times a fall
//   hn_i_of_fall(n, steps)     the part of a derivative that comes from the weights, from a sum of those that was
//                              scaled; with so many steps in a cell. In HN_FIXED in units of 2^-24
//   hn_i_turning(n, k)         2 pi k n, in these units
//   hn_i_own_turning(n, k)     with the wave of a point: a share of a sum that hn_i_of_turning(n, s) takes to these
//                              units, scaled
//   hn_i_wave_slope(d)         the float of a derivative

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_waves(hn_float k) { return min(max(-16.0f, k), 16.0f); }
HN_FN hn_float hn_i_bandwidth(hn_float b) { return min(max(0.0f, b), 16.0f); }
HN_FN hn_float hn_i_own_wave(hn_float k, hn_float b, hn_int u) {
  HN_I_PRECISE hn_float own = b * (hn_i_float(u) * (1.0f / 65536.0f)) + k;
  return hn_i_waves(own);
}
HN_FN hn_uint hn_i_waves_from(hn_vec2 k, hn_float x, hn_float y) {
  HN_I_PRECISE hn_float turns = (k.x * x + k.y * y) * 0.5f;
  return hn_i_angle(turns);
}
HN_FN hn_uint hn_i_waves_from(hn_vec3 k, hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float turns = k.x * x + k.y * y + k.z * z;
  return hn_i_angle(turns);
}
HN_FN hn_float hn_i_as_ramp(hn_float sine) { return sine; }
HN_FN hn_float hn_i_weight_wave(hn_float t) {
  HN_I_PRECISE hn_float q = t * t;
  HN_I_PRECISE hn_float g = t - q;
  HN_I_PRECISE hn_float w = (g * g * 15.0f + q) * t;
  return w;
}
HN_FN hn_float hn_i_d_weight_wave(hn_float t, hn_int m) {
  HN_I_PRECISE hn_float h = t * 4.0f - t * t * 5.0f;
  HN_I_PRECISE hn_float k = h * h * hn_i_float(6 * m);
  return k;
}
HN_FN hn_float hn_i_falling(hn_float n, hn_float x) { return hn_i_times(n, -x); }
HN_FN hn_float hn_i_of_fall(hn_float n, hn_int steps) { return hn_i_times(n, hn_i_float(steps)); }
HN_FN hn_float hn_i_turning(hn_float n, hn_float k) { return hn_i_times(hn_i_times(k, 6.2831853f), hn_i_flushed(n)); }
HN_FN hn_float hn_i_own_turning(hn_float n, hn_float k) { return hn_i_times(n, k); }
HN_FN hn_float hn_i_of_turning(hn_float n, hn_int s) { return hn_i_times(hn_i_scaled(n, s), 6.2831853f); }
HN_FN hn_float hn_i_wave_slope(hn_float d) { return hn_i_derivative(d); }

#else

HN_FN hn_int hn_i_waves(hn_float k) { return int(min(max(-16.0f, k), 16.0f) * 65536.0f); }
HN_FN hn_int hn_i_bandwidth(hn_float b) { return int(min(max(0.0f, b), 16.0f) * 65536.0f); }

// b u / 2^16, rounded down. The product has up to 37 bits, so the digits of b are taken in turn.
HN_FN hn_int hn_i_own_wave(hn_int k, hn_int b, hn_int u) {
  hn_int across = ((b >> 10) * u + (((b & 1023) * u) >> 10)) >> 6;
  return min(max(-1048576, k + across), 1048576);
}

// k d / 2^4, and half of that. k d has up to 42 bits. The low 32 count behind the shift. Each product takes half the
// bits of the offset, and so stays below 2^31.
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
// Converts units of 2^-16 to the units of ramps.
HN_FN hn_int hn_i_as_ramp(hn_int sine) { return sine * 8192; }

// t^2 (1 - t)^2 is at most 1/16, so 15 times that is below 1. A uint has the largest square of the other, which may be
// negative.
HN_FN hn_int hn_i_weight_wave(hn_int t) {
  hn_uint q = hn_i_falloff_square(t);
  hn_uint g = uint(t) - q;
  return int(((q + ((g * g * 15u + 32768u) >> 16u)) * uint(t) + 8192u) >> 14u);
}
HN_FN hn_int hn_i_d_weight_wave(hn_int t, hn_int m) {
  hn_uint h = uint(t * 4 - int(hn_i_falloff_square(t)) * 5);
  return int((h * h + 32768u) >> 16u) * 3 * m;
}

// Converts units of 2^-29 to units of 2^-27.
HN_FN hn_int hn_i_falling(hn_int n, hn_int x) { return -2 * hn_i_part(n, x >> 2); }
HN_FN hn_int hn_i_of_fall(hn_int n, hn_int steps) { return n * (32 * steps); }

// 205887 is 2 pi / 8 in units of 2^-18: 2 pi k in units of 2^-13, below 2^20.
HN_FN hn_int hn_i_turning(hn_int n, hn_int k) {
  hn_int rate = hn_i_part(k * 512, 205887) >> 9;
  return hn_i_part(n * 256, rate);
}

// In units of 2^-23, since the sum of all may be 136 before it is scaled: n is a multiple of 2^-29 here, not of 2^-21.
HN_FN hn_int hn_i_own_turning(hn_int n, hn_int k) { return hn_i_part(n >> 1, hn_i_part(k * 512, 205887) >> 9); }
HN_FN hn_int hn_i_of_turning(hn_int n, hn_int s) { return ((n + 256) >> 9) * s; }
HN_FN hn_float hn_i_wave_slope(hn_int d) { return hn_i_float((d + 128) >> 8) * (1.0f / 65536.0f); }

#endif

HN_FN hn_i_num2 hn_i_unit_wave(hn_uint angle) {
  return hn_i_vector(hn_i_as_ramp(hn_i_wave(angle + 0x40000000u, 0u)), hn_i_as_ramp(hn_i_wave(angle, 0u)));
}
HN_FN hn_i_num2 hn_i_weighted_wave(hn_i_num2 n, hn_i_num w) {
  return hn_i_vector(hn_i_weighted_ramp(n.x, w), hn_i_weighted_ramp(n.y, w));
}
HN_FN hn_i_num2 hn_i_falling_wave(hn_i_num2 n, hn_i_num x) {
  return hn_i_vector(hn_i_falling(n.x, x), hn_i_falling(n.y, x));
}
HN_FN hn_i_num2 hn_i_wave_at(hn_uint angle, hn_i_num w) { return hn_i_weighted_wave(hn_i_unit_wave(angle), w); }
HN_FN hn_i_num2 hn_i_plus(hn_i_num2 a, hn_i_num2 b) { return hn_i_vector(hn_i_plus(a.x, b.x), hn_i_plus(a.y, b.y)); }

HN_FN hn_i_num2 hn_i_own_turning(hn_i_num2 n, hn_i_num k) {
  return hn_i_vector(hn_i_own_turning(n.x, k), hn_i_own_turning(n.y, k));
}

// The direction has words of its own, as the components of vectors from one hash do (word.glsl).
HN_FN hn_i_num2 hn_i_own_waves(hn_i_num2 k, hn_i_num b, hn_uint h) {
  hn_ivec2 u = hn_i_on_circle((h >> 8u) * 0xEB1831u);
  return hn_i_vector(hn_i_own_wave(k.x, b, u.x), hn_i_own_wave(k.y, b, u.y));
}
HN_FN hn_i_num3 hn_i_own_waves(hn_i_num3 k, hn_i_num b, hn_uint h) {
  hn_ivec3 u = hn_i_on_sphere((h >> 8u) * 0xEB1831u, (h >> 8u) * 0x84A5E5u);
  return hn_i_vector(hn_i_own_wave(k.x, b, u.x), hn_i_own_wave(k.y, b, u.y), hn_i_own_wave(k.z, b, u.z));
}

// The derivatives of value and quadrature along an axis: n are both, fall is the sum of what falls along it, and k is
// the wave along it.
HN_FN hn_vec2 hn_i_wave_slopes(hn_i_num2 n, hn_i_num2 fall, hn_i_num k) {
  return vec2(hn_i_wave_slope(hn_i_minus(fall.x, hn_i_turning(n.y, k))),
              hn_i_wave_slope(hn_i_plus(fall.y, hn_i_turning(n.x, k))));
}

// With waves of points: turning is the sum of what they turn along it.
HN_FN hn_vec2 hn_i_own_wave_slopes(hn_i_num2 fall, hn_i_num2 turning, hn_int s) {
  return vec2(hn_i_wave_slope(hn_i_minus(fall.x, hn_i_of_turning(turning.y, s))),
              hn_i_wave_slope(hn_i_plus(fall.y, hn_i_of_turning(turning.x, s))));
}

#endif
