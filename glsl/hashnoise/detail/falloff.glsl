// hashnoise: the steps of simplex noise: a sum over the lattice points around a place, each with a weight that falls to
// 0 at a radius.
// SPDX-License-Identifier: MIT

#ifndef HN_FALLOFF_GLSL
#define HN_FALLOFF_GLSL

#include "direction.glsl"

// An offset is a number like a fraction. The square of a length is a float, or a uint in units of 2^-30, rounded down.
//
//   hn_i_quarters(n)                  n / 4 as an offset
//   hn_i_half(x)                      x / 2; in HN_FIXED x is even
//   hn_i_floor(x)                     the largest int that is not above x; hn_i_fract(x) is what x has beyond it
//   hn_i_truncate(x)                  the same int of an x that is not negative. GPUs cut a float off in one step
//   hn_i_square(x, y, ...)            the square of the length of an offset
//   hn_i_square_plus(q, x)            such a square plus a number that is given as an offset
//   hn_i_falloff(q, s, m)             s / 1024 - m q, or 0 beyond the radius, where that is negative. In HN_FIXED it is
//                                     in units of 2^-16 and below 1. m is 1 or 2: 2 gives the weights of a small radius
//                                     more bits
//   hn_i_weight3(t), ...              the weight of a point: t^3, t^4, 4 t^5, and of the plane t^3 (3 - 2 t). Each
//                                     makes the noise twice continuously differentiable. They were chosen with
//                                     tools/measure hashes, so that noise shows little of its lattice
//   hn_i_d_weight3(t, m), ...         how the weight falls: 2 m times its derivative by t; in HN_FIXED an eighth of
//                                     that
//   hn_i_weighted_ramp(n, w)          n times a weight or a fall
//   hn_i_d_weighted_ramp(g, w, k, x)  what a point adds to a derivative: g w - k x, of the component g of its gradient,
//                                     its weight w, its ramp k times the fall, and the offset x. HN_FIXED: in units
//                                     four times as large
//   hn_i_weighted_ramp_d(r, g, ...)   the value and the derivatives of a weight times a ramp r, from its gradient g,
//                                     the offset, the weight and its fall
//   hn_i_plus(a, b)                   the sum of such vectors
//
// At the radius and beyond it a weight is 0: HN_FIXED rounds the square down to a multiple of 2^-30, and the radius is
// one. So it does not matter which points beyond it are visited, and there are no seams.

#if HN_ARITHMETIC != HN_FIXED

#define hn_i_square_number hn_float

HN_FN hn_float hn_i_quarters(hn_int n) { return hn_i_float(n) * 0.25f; }
HN_FN hn_float hn_i_half(hn_float x) { return hn_i_times(x, 0.5f); }
HN_FN hn_int hn_i_floor(hn_float x) { return hn_i_cell(x); }
HN_FN hn_int hn_i_truncate(hn_float x) { return ivec2(vec2(x, 0.0f)).x; }
HN_FN hn_float hn_i_fract(hn_float x) { return hn_i_fraction(x); }

HN_FN hn_float hn_i_square(hn_float x, hn_float y) {
  HN_I_PRECISE hn_float q = x * x + y * y;
  return q;
}
HN_FN hn_float hn_i_square(hn_float x, hn_float y, hn_float z) {
  HN_I_PRECISE hn_float q = x * x + y * y + z * z;
  return q;
}
HN_FN hn_float hn_i_square(hn_float x, hn_float y, hn_float z, hn_float w) {
  HN_I_PRECISE hn_float q = x * x + y * y + z * z + w * w;
  return q;
}
HN_FN hn_float hn_i_square_plus(hn_float q, hn_float x) { return hn_i_plus(q, x); }

HN_FN hn_float hn_i_falloff(hn_float q, hn_int s, hn_int m) {
  return max(hn_i_multiply_add(hn_i_float(-m), q, hn_i_float(s) * (1.0f / 1024.0f)), 0.0f);
}
HN_FN hn_float hn_i_weight3(hn_float t) {
  HN_I_PRECISE hn_float w = t * t * t;
  return w;
}
HN_FN hn_float hn_i_weight4(hn_float t) {
  HN_I_PRECISE hn_float q = t * t;
  HN_I_PRECISE hn_float w = q * q;
  return w;
}
HN_FN hn_float hn_i_weight5(hn_float t) {
  HN_I_PRECISE hn_float q = t * t;
  HN_I_PRECISE hn_float w = q * q * t * 4.0f;
  return w;
}
HN_FN hn_float hn_i_weight_plane(hn_float t) {
  HN_I_PRECISE hn_float w = t * t * t * (t * -2.0f + 3.0f);
  return w;
}
HN_FN hn_float hn_i_d_weight3(hn_float t, hn_int m) {
  HN_I_PRECISE hn_float k = t * t * hn_i_float(6 * m);
  return k;
}
HN_FN hn_float hn_i_d_weight4(hn_float t, hn_int m) {
  HN_I_PRECISE hn_float k = t * t * t * hn_i_float(8 * m);
  return k;
}
HN_FN hn_float hn_i_d_weight_plane(hn_float t, hn_int m) {
  HN_I_PRECISE hn_float k = t * t * (t * -16.0f + 18.0f) * hn_i_float(m);
  return k;
}
HN_FN hn_float hn_i_weighted_ramp(hn_float n, hn_float w) { return hn_i_times(n, w); }
HN_FN hn_float hn_i_d_weighted_ramp(hn_float g, hn_float w, hn_float k, hn_float x) {
  HN_I_PRECISE hn_float d = g * w - k * x;
  return d;
}

#else

#define hn_i_square_number hn_uint

HN_FN hn_int hn_i_quarters(hn_int n) { return n * (HN_I_UNITS_FRACTION / 4); }
HN_FN hn_int hn_i_half(hn_int x) { return x >> 1; }
HN_FN hn_int hn_i_floor(hn_int x) { return x >> 20; }
HN_FN hn_int hn_i_truncate(hn_int x) { return x >> 20; }
HN_FN hn_int hn_i_fract(hn_int x) { return x & (HN_I_UNITS_FRACTION - 1); }

// Squares have 41 bits. They are summed by the products of the high digits, of a high and a low digit, and of the low
// digits, so that the sum is exact before it is rounded down. A digit has 10 bits.
#ifndef HN_I_OWN_SQUARES  // lanes.hpp has its own
HN_FN hn_uint hn_i_square(hn_int x, hn_int y) {
  hn_uvec2 v = uvec2(ivec2(hn_i_magnitude(x), hn_i_magnitude(y)));
  hn_uvec2 h = uvec2(v.x >> 10u, v.y >> 10u);
  hn_uvec2 l = uvec2(v.x & 1023u, v.y & 1023u);
  return ((h.x * h.x + h.y * h.y) << 10u) + (h.x * l.x + h.y * l.y) * 2u + ((l.x * l.x + l.y * l.y) >> 10u);
}
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_uint hn_i_square(hn_int x, hn_int y, hn_int z) {
  hn_uvec3 v = uvec3(ivec3(hn_i_magnitude(x), hn_i_magnitude(y), hn_i_magnitude(z)));
  hn_uvec3 h = uvec3(v.x >> 10u, v.y >> 10u, v.z >> 10u);
  hn_uvec3 l = uvec3(v.x & 1023u, v.y & 1023u, v.z & 1023u);
  return ((h.x * h.x + h.y * h.y + h.z * h.z) << 10u) + (h.x * l.x + h.y * l.y + h.z * l.z) * 2u +
         ((l.x * l.x + l.y * l.y + l.z * l.z) >> 10u);
}
HN_FN hn_uint hn_i_square(hn_int x, hn_int y, hn_int z, hn_int w) {
  hn_uvec4 v = uvec4(ivec4(hn_i_magnitude(x), hn_i_magnitude(y), hn_i_magnitude(z), hn_i_magnitude(w)));
  hn_uvec4 h = uvec4(v.x >> 10u, v.y >> 10u, v.z >> 10u, v.w >> 10u);
  hn_uvec4 l = uvec4(v.x & 1023u, v.y & 1023u, v.z & 1023u, v.w & 1023u);
  return ((h.x * h.x + h.y * h.y + h.z * h.z + h.w * h.w) << 10u) +
         (h.x * l.x + h.y * l.y + h.z * l.z + h.w * l.w) * 2u +
         ((l.x * l.x + l.y * l.y + l.z * l.z + l.w * l.w) >> 10u);
}
#endif

HN_FN hn_uint hn_i_square_plus(hn_uint q, hn_int x) { return q + uint(x) * 1024u; }

// The largest number below 1 has 16 bits, and so its square fits a uint.
HN_FN hn_int hn_i_falloff(hn_uint q, hn_int s, hn_int m) {
  hn_uint radius = uint(s) << 20u;
  return int(min((radius - min(uint(m) * q, radius) + 8192u) >> 14u, 65535u));
}

// The square is in units of 2^-16. Weights are in units of 2^-18, and so are falls. All are rounded.
HN_FN hn_uint hn_i_falloff_square(hn_int t) { return (uint(t) * uint(t) + 32768u) >> 16u; }
HN_FN hn_int hn_i_weight3(hn_int t) { return int((hn_i_falloff_square(t) * uint(t) + 8192u) >> 14u); }
HN_FN hn_int hn_i_weight4(hn_int t) {
  hn_uint q = hn_i_falloff_square(t);
  return int((q * q + 8192u) >> 14u);
}
HN_FN hn_int hn_i_weight5(hn_int t) {
  hn_uint q = hn_i_falloff_square(t);
  return int((((q * q + 32768u) >> 16u) * uint(t) + 2048u) >> 12u);
}

// 98304 is 3/2, and 73728 is 9/8.
HN_FN hn_int hn_i_weight_plane(hn_int t) {
  hn_uint u = (uint(t) * uint(98304 - t) + 32768u) >> 16u;
  return int((hn_i_falloff_square(t) * u + 4096u) >> 13u);
}
HN_FN hn_int hn_i_d_weight3(hn_int t, hn_int m) { return int(hn_i_falloff_square(t)) * 3 * m; }
HN_FN hn_int hn_i_d_weight4(hn_int t, hn_int m) { return hn_i_weight3(t) * m; }
HN_FN hn_int hn_i_d_weight_plane(hn_int t, hn_int m) {
  return ((int(hn_i_falloff_square(t)) * (73728 - t) + 4096) >> 13) * m;
}
HN_FN hn_int hn_i_weighted_ramp(hn_int n, hn_int w) { return hn_i_part(n, w); }
HN_FN hn_int hn_i_d_weighted_ramp(hn_float g, hn_int w, hn_int k, hn_int x) {
  return hn_i_weighted_component(g, hn_i_exact(w)) - 2 * hn_i_part(k, x >> 2);
}

#endif

HN_FN hn_i_num3 hn_i_weighted_ramp_d(hn_i_num r, hn_vec2 g, hn_i_num x, hn_i_num y, hn_i_num w, hn_i_num fall) {
  hn_i_num k = hn_i_weighted_ramp(r, fall);
  return hn_i_vector(hn_i_weighted_ramp(r, w), hn_i_d_weighted_ramp(g.x, w, k, x), hn_i_d_weighted_ramp(g.y, w, k, y));
}
// Generated for 3 dimensions from the lines above.
HN_FN hn_i_num4 hn_i_weighted_ramp_d(hn_i_num r, hn_vec3 g, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num w,
                                     hn_i_num fall) {
  hn_i_num k = hn_i_weighted_ramp(r, fall);
  return hn_i_vector(hn_i_weighted_ramp(r, w), hn_i_d_weighted_ramp(g.x, w, k, x), hn_i_d_weighted_ramp(g.y, w, k, y),
                     hn_i_d_weighted_ramp(g.z, w, k, z));
}

HN_FN hn_i_num3 hn_i_plus(hn_i_num3 a, hn_i_num3 b) {
  return hn_i_vector(hn_i_plus(a.x, b.x), hn_i_plus(a.y, b.y), hn_i_plus(a.z, b.z));
}
HN_FN hn_i_num4 hn_i_plus(hn_i_num4 a, hn_i_num4 b) {
  return hn_i_vector(hn_i_plus(a.x, b.x), hn_i_plus(a.y, b.y), hn_i_plus(a.z, b.z), hn_i_plus(a.w, b.w));
}

#endif
