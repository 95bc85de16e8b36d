// hashnoise: gradients in four dimensions.
// SPDX-License-Identifier: MIT

#ifndef HN_DIRECTION4D_GLSL
#define HN_DIRECTION4D_GLSL

#include "falloff.glsl"

// In four dimensions a gradient is one of the 24 corners of the 24-cell: two components are 1 or -1, and two are 0. The
// 24 are as isotropic as a sphere up to the fifth harmonic. The size of the hash chooses one of three ways to pair the
// axes: xy and zw below the first third, xw and yz from the second third on, and xz and yw between. Bit 20 chooses the
// second pair, and bits 22 and 21 are the signs.
//
// A ramp is the sum of two offsets. In a kernel it has 30 bits, so its units in HN_FIXED are 2^-28, twice as large as
// other ramps. An interpolation between such ramps is scaled by twice as much there.
//
//   hn_i_flipped(x, h)           x, or -x if the highest bit of the hash is set
//   hn_i_along4(h, x, y, z, w)   the gradient of a hash times an offset, in the units of offsets
//   hn_i_direction4(h)           the gradient; hn_i_along4(g, x, y, z, w), the same of offsets that are floats
//   hn_i_ramp_of4, hn_i_lerp_ramps4, hn_i_ramp_difference4, hn_i_lerp_components4 and hn_i_d_weighted_ramp4 are as in
//   direction.glsl and falloff.glsl, in the units of four dimensions

HN_FN hn_float hn_i_flipped(hn_float x, hn_uint h) {
#if HN_I_BITCAST
  return uintBitsToFloat(floatBitsToUint(x) ^ (h & 0x80000000u));
#else
  return hn_i_select((h & 0x80000000u) != 0u, -x, x);
#endif
}
HN_FN hn_int hn_i_flipped(hn_int x, hn_uint h) { return hn_i_select((h & 0x80000000u) != 0u, -x, x); }

HN_FN hn_i_num hn_i_along4(hn_uint h, hn_i_num x, hn_i_num y, hn_i_num z, hn_i_num w) {
  hn_uint second = h & 0x00100000u;
  hn_i_num a = hn_i_select(second != 0u, hn_i_select(h < 0x55555555u, z, y), x);
  hn_i_num b = hn_i_select(second != 0u, hn_i_select(h < 0xAAAAAAAAu, w, z),
                           hn_i_select(h < 0x55555555u, y, hn_i_select(h < 0xAAAAAAAAu, z, w)));
  return hn_i_plus(hn_i_flipped(a, h << 9u), hn_i_flipped(b, h << 10u));
}

HN_FN hn_vec4 hn_i_direction4(hn_uint h) {
  hn_uint second = h & 0x00100000u;
  hn_vec2 g = vec2(hn_i_flipped(1.0f, h << 9u), hn_i_flipped(1.0f, h << 10u));
  hn_float a1 = hn_i_select(second != 0u, 0.0f, g.x);  // of the first pair
  hn_float b1 = hn_i_select(second != 0u, 0.0f, g.y);
  hn_float a2 = hn_i_select(second != 0u, g.x, 0.0f);  // of the second
  hn_float b2 = hn_i_select(second != 0u, g.y, 0.0f);
  return vec4(a1, hn_i_select(h < 0x55555555u, b1, a2),
              hn_i_select(h < 0x55555555u, a2, hn_i_select(h < 0xAAAAAAAAu, b1, b2)),
              hn_i_select(h < 0xAAAAAAAAu, b2, b1));
}

#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_along4(hn_vec4 g, hn_float x, hn_float y, hn_float z, hn_float w) {
  HN_I_PRECISE hn_float n = g.x * x + g.y * y + g.z * z + g.w * w;
  return n;
}
HN_FN hn_float hn_i_ramp_of4(hn_float n) { return n; }
HN_FN hn_float hn_i_lerp_ramps4(hn_float a, hn_float b, hn_float t) { return hn_i_lerp(a, b, t); }
HN_FN hn_float hn_i_ramp_difference4(hn_float a, hn_float b) { return hn_i_minus(b, a); }
HN_FN hn_float hn_i_lerp_components4(hn_float g, hn_float h, hn_float t) { return hn_i_lerp(g, h, t); }
HN_FN hn_float hn_i_d_weighted_ramp4(hn_float g, hn_float w, hn_float k, hn_float x) {
  return hn_i_d_weighted_ramp(g, w, k, x);
}
HN_FN hn_float hn_i_scaled_ramps(hn_float n, hn_int s) { return hn_i_scaled(n, s); }
#else
HN_FN hn_int hn_i_along4(hn_vec4 g, hn_float x, hn_float y, hn_float z, hn_float w) {
  return hn_i_beyond_12(g.x * x + 12.0f + g.y * y + g.z * z + g.w * w);
}
HN_FN hn_int hn_i_ramp_of4(hn_int n) { return n * 256; }
HN_FN hn_int hn_i_lerp_ramps4(hn_int a, hn_int b, hn_int t) {
  hn_int d = b - a;
  return a * 256 + ((d >> 1) * (t >> 9) + (d >> 10) * (t & 511));
}
HN_FN hn_int hn_i_ramp_difference4(hn_int a, hn_int b) { return (b - a) * 64; }
HN_FN hn_int hn_i_lerp_components4(hn_float g, hn_float h, hn_float t) { return hn_i_lerp_components(g, h, t) >> 1; }
HN_FN hn_int hn_i_d_weighted_ramp4(hn_float g, hn_int w, hn_int k, hn_int x) {
  return (hn_i_weighted_component(g, hn_i_exact(w)) >> 1) - 2 * hn_i_part(k, x >> 2);
}
HN_FN hn_int hn_i_scaled_ramps(hn_int n, hn_int s) { return hn_i_scaled(n, s + s); }
#endif

// 953 / 1024 is 1 / 1.073455, rounded down. 1.073455 is the largest value of Perlin noise before it is scaled
// (tools/make bounds).
HN_FN hn_i_num hn_i_scaled4(hn_i_num n) { return hn_i_scaled_ramps(n, 953); }

#endif
