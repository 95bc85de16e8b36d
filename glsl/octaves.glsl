// hashnoise: what the octave sums on the plane and in space have in common.
// SPDX-License-Identifier: MIT
//
// A sum is the mean of the octaves, or of their absolute values, weighted by gain^i. Each octave has a seed of its own,
// 2^32 divided by the golden ratio further, so that the octaves of nearby seeds do not coincide either. The shift keeps
// their lattice points, where the noise is 0, from falling together at the origin.

#ifndef HN_OCTAVES_GLSL
#define HN_OCTAVES_GLSL

#include "arithmetic.glsl"

#if HN_ARITHMETIC == HN_FIXED

// A position along one axis is a number of 64 bits, in units of 2^-32 cells: x the cell, y its fraction.
HN_FN hn_uvec2 hn_i_long(hn_float p) {
  hn_float rest = p - trunc(p);
  // The rest is in (-1, 1). It is cut off towards 0, so that it does not matter whether subnormal numbers are flushed.
  hn_uint u = uint(abs(rest) * 4294967296.0f);
  hn_uint cell = uint(hn_i_whole_cell(p));
  return uvec2(cell - uint(rest < 0.0f && u != 0u), hn_i_select(rest < 0.0f, 0u - u, u));
}

HN_FN hn_float hn_i_short(hn_uvec2 q) { return float(int(q.x)) + float(q.y >> 8u) * (1.0f / 16777216.0f); }

// The high word of a product of two words. umulExtended is not in GLSL 1.30.
HN_FN hn_uint hn_i_multiply_high(hn_uint a, hn_uint b) {
  hn_uint a0 = a & 0xFFFFu;
  hn_uint a1 = a >> 16u;
  hn_uint b0 = b & 0xFFFFu;
  hn_uint b1 = b >> 16u;
  hn_uint middle = a1 * b0 + ((a0 * b0) >> 16u);
  return a1 * b1 + (middle >> 16u) + ((a0 * b1 + (middle & 0xFFFFu)) >> 16u);
}

// Times lacunarity (in units of 2^-23, below 2^31), plus shift (in units of 2^-32).
HN_FN hn_uvec2 hn_i_next_octave(hn_uvec2 q, hn_uint lacunarity, hn_uint shift) {
  hn_uint cell;
  hn_uint rest;
  hn_uint more = 0u;
  if (lacunarity == 16777216u) {  // 2, the usual value
    cell = (q.x << 1u) | (q.y >> 31u);
    rest = q.y << 1u;
  } else {
    hn_uint low = q.x * lacunarity;
    hn_uint high = hn_i_multiply_high(q.x, lacunarity);
    high -= hn_i_select((q.x & 0x80000000u) != 0u, lacunarity, 0u);  // the cell is signed
    hn_uint part = hn_i_multiply_high(q.y, lacunarity);
    cell = ((high << 9u) | (low >> 23u)) + (part >> 23u);
    rest = low << 9u;
    more = (part << 9u) | ((q.y * lacunarity) >> 23u);
  }
  // Each of the two sums carries if the result is smaller than the summand.
  rest += more;
  cell += uint(rest < more);
  rest += shift;
  cell += uint(rest < shift);
  return uvec2(cell, rest);
}

// Times a weight in units of 2^-18.
HN_FN hn_int hn_i_weighted(hn_int n, hn_int weight) { return (n * (weight >> 9) + (n >> 9) * (weight & 511)) >> 9; }

HN_FN hn_int hn_i_next_weight(hn_int weight, hn_int gain) {
  return ((weight >> 9) * gain + (((weight & 511) * gain) >> 9)) >> 9;
}

// sum * 2^18 / total, cut off towards 0, by long division: the whole part, then 9 bits, then 9 more. A rest of 23 bits
// leaves room for only 9 bits at a time.
HN_FN hn_int hn_i_mean(hn_int sum, hn_int total) {
  hn_uint divisor = uint(total);
  hn_uint rest = uint(max(sum, -sum));
  hn_uint quotient = rest / divisor;
  rest -= quotient * divisor;
  for (hn_int i = 0; i < 2; ++i) {
    rest <<= 9u;
    hn_uint digits = rest / divisor;
    rest -= digits * divisor;
    quotient = (quotient << 9u) | digits;
  }
  return hn_i_select(sum < 0, -int(quotient), int(quotient));
}

HN_FN hn_uint hn_i_lacunarity(hn_float lacunarity) { return uint(min(max(lacunarity, 0.0f), 255.0f) * 8388608.0f); }
HN_FN hn_int hn_i_gain(hn_float gain) { return int(min(max(gain, 0.0f), 1.0f) * 262144.0f); }

// Makes a sky from an fBm: it is clear below -1/8 and dense above 3/8, with a smooth step between. The density is
// 1/2 + c (3/2 - 2 c^2) with c = 2 fbm - 1/4, clamped to [-1/2, 1/2], in units of 2^-16.
HN_FN hn_int hn_i_cloud_density(hn_int fbm) {
  hn_int c = (min(max(2 * fbm + 524288, 0), 2097152) - 1048576) >> 5;
  return 1048576 + ((c * int((0xC0000000u - uint(c * c)) >> 16u)) >> 10);
}

#else

// A lacunarity with which a tile stays a tile.
HN_FN hn_float hn_i_whole(hn_float lacunarity) { return floor(min(max(lacunarity, 0.0f), 255.0f)); }

// Makes a sky from an fBm: it is clear below -1/8 and dense above 3/8, with a smooth step between.
HN_FN hn_float hn_i_cloud_density(hn_float fbm) {
  return hn_i_smooth(min(max(hn_i_times_plus(2.0f, fbm, 0.25f), 0.0f), 1.0f));
}

#endif

#endif
