// hashnoise: octave sums in integers, for HN_FIXED; empty without. Included by fbm.glsl.
// SPDX-License-Identifier: MIT

#ifndef HN_FBM_FIXED_GLSL
#define HN_FBM_FIXED_GLSL

#include "noise2d.glsl"
#include "noise3d.glsl"

#if HN_ARITHMETIC == HN_FIXED

// A position along one axis is a number of 64 bits, in units of 2^-32 cells: x the cell, y its fraction.
HN_FN HN_HIGHP uvec2 hn_i_long(HN_HIGHP float p) {
  HN_HIGHP float rest = p - trunc(p);
  // In (-1, 1). Cut off towards 0, so that it does not matter whether subnormal numbers are flushed.
  HN_HIGHP uint u = uint(abs(rest) * 4294967296.0f);
  HN_HIGHP uint cell = uint(hn_i_whole_cell(p));
  return rest < 0.0f && u != 0u ? uvec2(cell - 1u, 0u - u) : uvec2(cell, u);
}

HN_FN HN_HIGHP float hn_i_short(HN_HIGHP uvec2 q) { return float(int(q.x)) + float(q.y >> 8) * (1.0f / 16777216.0f); }

// The high word of a product of two words. umulExtended is not in GLSL 1.30.
HN_FN HN_HIGHP uint hn_i_multiply_high(HN_HIGHP uint a, HN_HIGHP uint b) {
  HN_HIGHP uint a0 = a & 0xFFFFu;
  HN_HIGHP uint a1 = a >> 16;
  HN_HIGHP uint b0 = b & 0xFFFFu;
  HN_HIGHP uint b1 = b >> 16;
  HN_HIGHP uint middle = a1 * b0 + ((a0 * b0) >> 16);
  return a1 * b1 + (middle >> 16) + ((a0 * b1 + (middle & 0xFFFFu)) >> 16);
}

// Times lacunarity (in units of 2^-23, below 2^31), plus shift (in units of 2^-32).
HN_FN HN_HIGHP uvec2 hn_i_next_octave(HN_HIGHP uvec2 q, HN_HIGHP uint lacunarity, HN_HIGHP uint shift) {
  HN_HIGHP uint cell;
  HN_HIGHP uint rest;
  HN_HIGHP uint more = 0u;
  if (lacunarity == 16777216u) {  // 2, which nearly everybody takes
    cell = (q.x << 1) | (q.y >> 31);
    rest = q.y << 1;
  } else {
    HN_HIGHP uint low = q.x * lacunarity;
    HN_HIGHP uint high = hn_i_multiply_high(q.x, lacunarity);
    high -= (q.x & 0x80000000u) != 0u ? lacunarity : 0u;  // the cell is signed
    HN_HIGHP uint part = hn_i_multiply_high(q.y, lacunarity);
    cell = ((high << 9) | (low >> 23)) + (part >> 23);
    rest = low << 9;
    more = (part << 9) | ((q.y * lacunarity) >> 23);
  }
  // Each of the two sums carries where it comes out below what was added.
  rest += more;
  cell += uint(rest < more);
  rest += shift;
  cell += uint(rest < shift);
  return uvec2(cell, rest);
}

// The noise of an octave, in units of 2^-21.
#ifdef HN_FBM_NOISE2D
HN_FN HN_HIGHP int hn_i_octave(HN_HIGHP uvec2 x, HN_HIGHP uvec2 y, HN_HIGHP uint seed) {
  HN_HIGHP float n = HN_FBM_NOISE2D(vec2(hn_i_short(x), hn_i_short(y)), seed);
  return int(min(max(n, -1.0f), 1.0f) * 2097152.0f);
}
#else
HN_FN HN_HIGHP int hn_i_octave(HN_HIGHP uvec2 x, HN_HIGHP uvec2 y, HN_HIGHP uint seed) {
  return hn_i_perlin(ivec2(int(x.x), int(y.x)), ivec2(int(x.y >> 12), int(y.y >> 12)), seed);
}
#endif
#ifdef HN_FBM_NOISE3D
HN_FN HN_HIGHP int hn_i_octave(HN_HIGHP uvec2 x, HN_HIGHP uvec2 y, HN_HIGHP uvec2 z, HN_HIGHP uint seed) {
  HN_HIGHP float n = HN_FBM_NOISE3D(vec3(hn_i_short(x), hn_i_short(y), hn_i_short(z)), seed);
  return int(min(max(n, -1.0f), 1.0f) * 2097152.0f);
}
#else
HN_FN HN_HIGHP int hn_i_octave(HN_HIGHP uvec2 x, HN_HIGHP uvec2 y, HN_HIGHP uvec2 z, HN_HIGHP uint seed) {
  return hn_i_perlin(ivec3(int(x.x), int(y.x), int(z.x)), ivec3(int(x.y >> 12), int(y.y >> 12), int(z.y >> 12)), seed);
}
#endif

// Times a weight in units of 2^-18.
HN_FN HN_HIGHP int hn_i_weighted(HN_HIGHP int n, HN_HIGHP int weight) {
  return (n * (weight >> 9) + (n >> 9) * (weight & 511)) >> 9;
}

HN_FN HN_HIGHP int hn_i_next_weight(HN_HIGHP int weight, HN_HIGHP int gain) {
  return ((weight >> 9) * gain + (((weight & 511) * gain) >> 9)) >> 9;
}

// sum * 2^18 / total, cut off towards 0, by long division: the whole part, then 9 bits, then 9 more, since a rest of 23
// bits leaves room for no more.
HN_FN HN_HIGHP int hn_i_mean(HN_HIGHP int sum, HN_HIGHP int total) {
  HN_HIGHP uint divisor = uint(total);
  HN_HIGHP uint rest = uint(max(sum, -sum));
  HN_HIGHP uint quotient = rest / divisor;
  rest -= quotient * divisor;
  for (HN_HIGHP int i = 0; i < 2; ++i) {
    rest <<= 9;
    HN_HIGHP uint digits = rest / divisor;
    rest -= digits * divisor;
    quotient = (quotient << 9) | digits;
  }
  return sum < 0 ? -int(quotient) : int(quotient);
}

HN_FN HN_HIGHP uint hn_i_lacunarity(HN_HIGHP float lacunarity) {
  return uint(min(max(lacunarity, 0.0f), 255.0f) * 8388608.0f);
}
HN_FN HN_HIGHP int hn_i_gain(HN_HIGHP float gain) { return int(min(max(gain, 0.0f), 1.0f) * 262144.0f); }

HN_FN HN_HIGHP int hn_i_octaves(HN_HIGHP vec2 p, HN_HIGHP int octaves, HN_HIGHP float lacunarity, HN_HIGHP float gain,
                                HN_HIGHP uint seed, bool absolute) {
  HN_HIGHP uvec2 x = hn_i_long(p.x);
  HN_HIGHP uvec2 y = hn_i_long(p.y);
  HN_HIGHP uint ratio = hn_i_lacunarity(lacunarity);
  HN_HIGHP int fall = hn_i_gain(gain);
  HN_HIGHP int sum = 0;
  HN_HIGHP int total = 0;
  HN_HIGHP int weight = 262144;
  for (HN_HIGHP int i = 0; i < min(octaves, 32); ++i) {
    HN_HIGHP int n = hn_i_octave(x, y, seed);
    sum += hn_i_weighted(absolute ? max(n, -n) : n, weight);
    total += weight;
    weight = hn_i_next_weight(weight, fall);
    x = hn_i_next_octave(x, ratio, 0x58000000u);
    y = hn_i_next_octave(y, ratio, 0x98000000u);
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0 : hn_i_mean(sum, total);
}

HN_FN HN_HIGHP int hn_i_octaves(HN_HIGHP vec3 p, HN_HIGHP int octaves, HN_HIGHP float lacunarity, HN_HIGHP float gain,
                                HN_HIGHP uint seed, bool absolute) {
  HN_HIGHP uvec2 x = hn_i_long(p.x);
  HN_HIGHP uvec2 y = hn_i_long(p.y);
  HN_HIGHP uvec2 z = hn_i_long(p.z);
  HN_HIGHP uint ratio = hn_i_lacunarity(lacunarity);
  HN_HIGHP int fall = hn_i_gain(gain);
  HN_HIGHP int sum = 0;
  HN_HIGHP int total = 0;
  HN_HIGHP int weight = 262144;
  for (HN_HIGHP int i = 0; i < min(octaves, 32); ++i) {
    HN_HIGHP int n = hn_i_octave(x, y, z, seed);
    sum += hn_i_weighted(absolute ? max(n, -n) : n, weight);
    total += weight;
    weight = hn_i_next_weight(weight, fall);
    x = hn_i_next_octave(x, ratio, 0x58000000u);
    y = hn_i_next_octave(y, ratio, 0x98000000u);
    z = hn_i_next_octave(z, ratio, 0xB8000000u);
    seed += 0x9E3779B9u;
  }
  return octaves < 1 ? 0 : hn_i_mean(sum, total);
}

// Makes a sky of an fBm: clear where it is below -1/8, dense above 3/8, a smooth step between: 1/2 + c (3/2 - 2 c^2)
// with c half way from -1/2 to 1/2 in units of 2^-16.
HN_FN HN_HIGHP int hn_i_cloud_density(HN_HIGHP int fbm) {
  HN_HIGHP int c = (min(max(2 * fbm + 524288, 0), 2097152) - 1048576) >> 5;
  return 1048576 + ((c * int((0xC0000000u - uint(c * c)) >> 16)) >> 10);
}

#endif

#endif
