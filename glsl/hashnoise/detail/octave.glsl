// hashnoise: the common parts of fractals.
// SPDX-License-Identifier: MIT
//
// A fractal is a weighted mean over octaves. It may transform each of them first (absolute value, ridge and so on).
// Octave i has the weight gain^i and a seed of its own, which is HN_I_SEED_STEP further, so that octaves of nearby
// seeds do not coincide either. Each octave is shifted: so the lattice points, where the noise is 0, do not fall
// together at the origin. And each is rotated, so that the axes do not add up.
//
// octaves1d.glsl to octaves4d.glsl have the positions of octaves, one after another. jacobian.glsl has the parts that
// fractals with derivatives and displacements need as well.

#ifndef HN_OCTAVE_GLSL
#define HN_OCTAVE_GLSL

#include "cell2d.glsl"

// The cosines and sines of the rotations, in 32nds: a position loses few bits by them. In the plane of x and y the
// angle is arctan(4/5), in space then arctan(13/29) in that of y and z, and in 4D at last arctan(4/5) in that of z and
// w. The numbers also stretch a little, by 1.0005 and 0.9931.
#define HN_I_COS_XY 25
#define HN_I_SIN_XY 20
#define HN_I_COS_YZ 29
#define HN_I_SIN_YZ 13

// A fractal under way. With HN_FIXED sums are in units of 2^-21, and weights in units of 2^-18.
struct hn_i_octave_sum {
  hn_i_num value;
  hn_i_num weight;    // of the octave
  hn_i_num feedback;  // how much of the next octave a ridge or a height lets count
  hn_i_num gain;
  hn_i_num part;       // of the last octave: how much of it counts
  hn_i_num footprint;  // in cells of the octave; with HN_FIXED in units of 2^-24
  hn_int octaves;
  hn_int at;  // the number of the octave, from 0
};

// ---------------------------------------------------------------------------------------------------------------------
// Values and weights.

#if HN_ARITHMETIC != HN_FIXED

#if HN_ARITHMETIC == HN_FAST

HN_FN hn_float hn_i_quotient(hn_float a, hn_float b) { return a / b; }

// The position of the first octave.
HN_FN hn_vec2 hn_i_flushed_position(hn_vec2 p) { return p; }
// Generated for 1, 3 and 4 dimensions from the lines above.
HN_FN hn_float hn_i_flushed_position(hn_float p) { return p; }
HN_FN hn_vec3 hn_i_flushed_position(hn_vec3 p) { return p; }
HN_FN hn_vec4 hn_i_flushed_position(hn_vec4 p) { return p; }

#else

// GLSL leaves the last bits of a division open. So a/b is computed as a times a reciprocal, by Newton's method. The
// first guess is at most 1/8 off, and each step squares the error. b is from 1 to 2^100.
HN_FN hn_float hn_i_quotient(hn_float a, hn_float b) {
  HN_I_PRECISE hn_float r = uintBitsToFloat(0x7EF311C7u - floatBitsToUint(b));
  for (hn_int i = 0; i < 4; ++i) r = r * (2.0f - b * r);
  HN_I_PRECISE hn_float quotient = a * r;
  return quotient;
}

// Replaces a subnormal number by 0, since a huge lacunarity could make it large. No later octave needs this: the shift
// between octaves leaves a position that is 0 or at least 2^-25.
HN_FN hn_float hn_i_flushed_position(hn_float p) {
  return hn_i_select((floatBitsToUint(p) & 0x7F800000u) == 0u, 0.0f, p);
}
HN_FN hn_vec2 hn_i_flushed_position(hn_vec2 p) { return vec2(hn_i_flushed_position(p.x), hn_i_flushed_position(p.y)); }
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_vec3 hn_i_flushed_position(hn_vec3 p) {
  return vec3(hn_i_flushed_position(p.x), hn_i_flushed_position(p.y), hn_i_flushed_position(p.z));
}
HN_FN hn_vec4 hn_i_flushed_position(hn_vec4 p) {
  return vec4(hn_i_flushed_position(p.x), hn_i_flushed_position(p.y), hn_i_flushed_position(p.z),
              hn_i_flushed_position(p.w));
}

#endif

HN_FN hn_float hn_i_smooth(hn_float t) {
  HN_I_PRECISE hn_float n = t * t * (3.0f - 2.0f * t);
  return n;
}

#define HN_I_WEIGHT_ONE 1.0f
#define HN_I_NO_WEIGHT 0.0f

// A setting in [0, most].
HN_FN hn_float hn_i_setting(hn_float x, hn_float most) { return min(max(0.0f, x), most); }
HN_FN hn_float hn_i_gain(hn_float gain) { return gain; }

// The product of two numbers in [0, 1], and sum + n * weight.
HN_FN hn_float hn_i_weight_times(hn_float a, hn_float b) { return hn_i_times(a, b); }
HN_FN hn_float hn_i_summed(hn_float sum, hn_float n, hn_float weight) { return hn_i_multiply_add(weight, n, sum); }

// The noise of an octave as it is, and in [-1, 1]. (With HN_GRADIENT_SINE it reaches 3/2 in space.)
HN_FN hn_float hn_i_octave(hn_float n) { return n; }
HN_FN hn_float hn_i_bounded_octave(hn_float n) { return min(max(-1.0f, n), 1.0f); }

// 1 - abs(n), and (1 + n) / 2. hn_i_weight_to_value converts them from the units of weights to those of values.
HN_FN hn_float hn_i_ridge(hn_float n) { return hn_i_minus(1.0f, abs(n)); }
HN_FN hn_float hn_i_weight_to_value(hn_float weight) { return weight; }
HN_FN hn_float hn_i_height(hn_float n) { return hn_i_multiply_add(0.5f, n, 0.5f); }

// A wave between -1 and 1: up and down again along two units of (n + 1) * strength.
HN_FN hn_float hn_i_folds(hn_float n, hn_float strength) {
  HN_I_PRECISE hn_float t = (n + 1.0f) * strength;
  HN_I_PRECISE hn_float folded = t - 2.0f * floor(t * 0.5f);
  HN_I_PRECISE hn_float wave = 2.0f * min(folded, 2.0f - folded) - 1.0f;
  return wave;
}

// 1 - strength * (1 - n) / 2
HN_FN hn_float hn_i_weight_factor(hn_float n, hn_float strength) {
  HN_I_PRECISE hn_float factor = 1.0f - strength * (0.5f - 0.5f * n);
  return factor;
}

// The total of the weights. Only a part of the last octave counts.
HN_FN hn_float hn_i_total(hn_int octaves, hn_float gain, hn_float part) {
  hn_float total = part;
  for (hn_int i = 1; i < octaves; ++i) total = hn_i_multiply_add(gain, total, 1.0f);
  return total;
}

HN_FN hn_float hn_i_mean(hn_float sum, hn_float total) { return hn_i_quotient(sum, total); }

// A sky of an fBm: it is clear below -1/8 and dense above 3/8, with a smooth step between.
HN_FN hn_float hn_i_density(hn_float mean) {
  return hn_i_smooth(min(max(0.0f, hn_i_multiply_add(2.0f, mean, 0.25f)), 1.0f));
}

HN_FN hn_float hn_i_billows(hn_float mean) { return min(hn_i_multiply_add(2.0f, mean, -1.0f), 1.0f); }

#else

#define HN_I_WEIGHT_ONE HN_I_UNITS_WEIGHT
#define HN_I_NO_WEIGHT 0

HN_FN hn_int hn_i_setting(hn_float x, hn_float most) { return int(min(max(0.0f, x), most) * HN_I_FLOAT_UNITS_WEIGHT); }
HN_FN hn_int hn_i_gain(hn_float gain) { return hn_i_setting(gain, 1.0f); }

HN_FN hn_int hn_i_weight_times(hn_int a, hn_int b) { return ((a >> 9) * b + (((a & 511) * b) >> 9)) >> 9; }
HN_FN hn_int hn_i_summed(hn_int sum, hn_int n, hn_int weight) {
  return sum + ((n * (weight >> 9) + (n >> 9) * (weight & 511)) >> 9);
}

HN_FN hn_int hn_i_octave(hn_float n) { return int(min(max(-1.5f, n), 1.5f) * HN_I_FLOAT_UNITS_VALUE); }
HN_FN hn_int hn_i_bounded_octave(hn_float n) { return int(min(max(-1.0f, n), 1.0f) * HN_I_FLOAT_UNITS_VALUE); }
HN_FN hn_int hn_i_ridge(hn_int n) { return (HN_I_UNITS_VALUE - hn_i_magnitude(n)) >> 3; }
HN_FN hn_int hn_i_weight_to_value(hn_int weight) { return weight << 3; }
HN_FN hn_int hn_i_height(hn_int n) { return (HN_I_UNITS_VALUE + n) >> 4; }

// (n + 1) * strength is in units of 2^-30, and a uint holds it modulo 4.
HN_FN hn_int hn_i_folds(hn_int n, hn_int strength) {
  hn_uint u = uint(n + HN_I_UNITS_VALUE);
  hn_uint s = uint(strength);
  hn_uint t = (u * (s >> 9u) + ((u * (s & 511u)) >> 9u)) & 0x7FFFFFFFu;
  return int(min(t, 0x80000000u - t) >> 8u) - HN_I_UNITS_VALUE;
}

HN_FN hn_int hn_i_weight_factor(hn_int n, hn_int strength) {
  return HN_I_WEIGHT_ONE - hn_i_weight_times((HN_I_UNITS_VALUE - n) >> 4, strength);
}

// gain * total + 1 would round in another way than the weights do, so these are added one by one.
HN_FN hn_int hn_i_total(hn_int octaves, hn_int gain, hn_int part) {
  hn_int total = 0;
  hn_int weight = HN_I_WEIGHT_ONE;
  for (hn_int i = 1; i < octaves; ++i) {
    total += weight;
    weight = hn_i_weight_times(weight, gain);
  }
  return total + hn_i_weight_times(weight, part);
}

// sum * 2^18 / total, cut off towards 0, by long division: the whole part, then 9 bits, then 9 more. A rest of 23 bits
// leaves room for only 9 bits at a time.
HN_FN hn_int hn_i_mean(hn_int sum, hn_int total) {
  hn_uint divisor = uint(total);
  hn_uint rest = uint(hn_i_magnitude(sum));
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

// The density is 1/2 + c (3/2 - 2 c^2) with c = 2 mean - 1/4, clamped to [-1/2, 1/2], in units of 2^-16.
HN_FN hn_int hn_i_density(hn_int mean) {
  hn_int c = (min(max(2 * mean + HN_I_UNITS_VALUE / 4, 0), HN_I_UNITS_VALUE) - HN_I_UNITS_VALUE / 2) >> 5;
  return HN_I_UNITS_VALUE / 2 + ((c * int((0xC0000000u - uint(c * c)) >> 16u)) >> 10);
}

HN_FN hn_int hn_i_billows(hn_int mean) { return 2 * mean - HN_I_UNITS_VALUE; }

#endif

// ---------------------------------------------------------------------------------------------------------------------
// Positions. A sum at a place has fixed-point positions with any arithmetic, since a float could not hold them far out:
// along each axis two integers, the cell x and the fraction y in units of 2^-24. With HN_FIXED every position is one.

// How far an octave is shifted along each axis, in those units: 11/32, 19/32, 23/32 and 27/32 of its cells.
#define HN_I_SHIFT_X 5767168
#define HN_I_SHIFT_Y 9961472
#define HN_I_SHIFT_Z 12058624
#define HN_I_SHIFT_W 14155776

// hn_i_fixed_position converts one axis of a place to a fixed-point position, and hn_i_fixed_fraction the fraction of
// one back to a number of HN_ARITHMETIC.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_ivec2 hn_i_fixed_position(hn_int cell, hn_float fraction, hn_int rest) {
  return ivec2(cell, int(min(max(0.0f, fraction), 1.0f) * HN_I_FLOAT_UNITS_POSITION) + rest);
}
HN_FN hn_float hn_i_fixed_fraction(hn_ivec2 x) {
  return HN_I_NOT_WHOLE(hn_i_float(x.y) * (1.0f / HN_I_FLOAT_UNITS_POSITION));
}
#else
HN_FN hn_ivec2 hn_i_fixed_position(hn_int cell, hn_int fraction, hn_int rest) {
  hn_int units = fraction * 16 + rest;  // from -15 to 2^24
  return ivec2(int(uint(cell) + uint(units >> 31)), units + ((units >> 31) & HN_I_UNITS_POSITION));
}
HN_FN hn_int hn_i_fixed_fraction(hn_ivec2 x) { return x.y >> 4; }
#endif

// The high 32 bits of a product of two uints. umulExtended is not in GLSL 1.30.
HN_FN hn_uint hn_i_multiply_high(hn_uint a, hn_uint b) {
  hn_uint a0 = a & 0xFFFFu;
  hn_uint a1 = a >> 16u;
  hn_uint b0 = b & 0xFFFFu;
  hn_uint b1 = b >> 16u;
  hn_uint middle = a1 * b0 + ((a0 * b0) >> 16u);
  return a1 * b1 + (middle >> 16u) + ((a0 * b1 + (middle & 0xFFFFu)) >> 16u);
}

// hn_i_ratio converts a lacunarity to units of 2^-23; the result is below 2^31. hn_i_lacunarity rounds the lacunarity
// of a tile down, so that the next octave fits the tile, too.
HN_FN hn_uint hn_i_ratio(hn_float lacunarity) { return uint(min(max(0.0f, lacunarity), 255.0f) * 8388608.0f); }
HN_FN hn_float hn_i_lacunarity(hn_float lacunarity, bool tiled) {
  hn_float ratio = lacunarity;
  if (tiled) ratio = floor(min(max(0.0f, lacunarity), 255.0f));
  return ratio;
}

// Multiplies a fixed-point position by a ratio. The product of the cell is exact, and the product of the fraction loses
// what is below 2^-24. The rest and the part together are at most 2^32 - 2.
HN_FN hn_ivec2 hn_i_times_ratio(hn_ivec2 x, hn_uint ratio) {
  if (ratio == 16777216u)
    return ivec2(int((uint(x.x) << 1u) + (uint(x.y) >> 23u)), (x.y << 1) & (HN_I_UNITS_POSITION - 1));
  hn_uint low = uint(x.x) * ratio;
  hn_uint high = hn_i_multiply_high(uint(x.x), ratio) - hn_i_select(x.x < 0, ratio, 0u);
  hn_uint part = (hn_i_multiply_high(uint(x.y), ratio) << 9u) | ((uint(x.y) * ratio) >> 23u);
  hn_uint rest = ((low & 8388607u) << 1u) + part;
  return ivec2(int(((high << 9u) | (low >> 23u)) + (rest >> 24u)), int(rest & 16777215u));
}

// along / 32 * a + across / 32 * b, of small numbers along and across. The cell is taken apart, so that each product
// has 32 bits.
HN_FN hn_ivec2 hn_i_rotated_axis(hn_ivec2 a, hn_ivec2 b, hn_int along, hn_int across) {
  hn_int rest = along * a.y + across * b.y;
  hn_int low = along * (a.x & 31) + across * (b.x & 31) + (rest >> 24);
  hn_uint high = uint(along) * uint(a.x >> 5) + uint(across) * uint(b.x >> 5);
  return ivec2(int(high + uint(low >> 5)), ((low & 31) << 19) | ((rest & (HN_I_UNITS_POSITION - 1)) >> 5));
}

// Adds a shift in units of 2^-24.
HN_FN hn_ivec2 hn_i_shifted(hn_ivec2 x, hn_int shift) {
  hn_int rest = x.y + shift;
  return ivec2(int(uint(x.x) + uint(rest >> 24)), rest & (HN_I_UNITS_POSITION - 1));
}

HN_FN hn_int hn_i_next_period(hn_int period, hn_float lacunarity) { return int(uint(period) * uint(lacunarity)); }

#if HN_ARITHMETIC != HN_FIXED

HN_FN hn_float hn_i_footprint(hn_float footprint) { return footprint; }
HN_FN hn_float hn_i_resolved_part(hn_float footprint) { return min(max(0.0f, hn_i_minus(1.5f, footprint)), 1.0f); }
HN_FN hn_float hn_i_next_footprint(hn_float footprint, hn_float lacunarity) {
  return hn_i_times(footprint, max(lacunarity, 1.0f));
}

#else

// hn_i_footprint clamps a footprint, which matters up to 2 cells. hn_i_resolved_part returns how much of an octave it
// leaves: all of it up to half a cell, and nothing from one and a half on. hn_i_next_footprint converts it to cells of
// the next octave.
HN_FN hn_int hn_i_footprint(hn_float footprint) {
  return int(min(max(0.0f, footprint), 2.0f) * HN_I_FLOAT_UNITS_POSITION);
}
HN_FN hn_int hn_i_resolved_part(hn_int footprint) {
  return min(max(3 * HN_I_UNITS_WEIGHT / 2 - (footprint >> 6), 0), HN_I_WEIGHT_ONE);
}
HN_FN hn_int hn_i_next_footprint(hn_int footprint, hn_float lacunarity) {
  hn_ivec2 next = hn_i_times_ratio(ivec2(footprint >> 24, footprint & (HN_I_UNITS_POSITION - 1)),
                                   max(hn_i_ratio(lacunarity), 8388608u));
  // The mask: a word beyond 127, which is not selected, may not be shifted so far in Metal.
  return hn_i_select(next.x > 1, 2 * HN_I_UNITS_POSITION, ((next.x & 1) << 24) + next.y);
}

#endif

// ---------------------------------------------------------------------------------------------------------------------
// The steps of sums.

// hn_i_bounded keeps a mean in [-1, 1]: where all octaves are at an end, roundings of floats could take it beyond.
// hn_i_finite returns 0 in place of what is no number, because the positions or the weights of octaves overflowed.
#if HN_ARITHMETIC != HN_FIXED
HN_FN hn_float hn_i_bounded(hn_float mean) { return min(max(-1.0f, mean), 1.0f); }
HN_FN hn_float hn_i_finite(hn_float mean) { return hn_i_select(abs(mean) < 1.0e38f, mean, 0.0f); }
#else
HN_FN hn_int hn_i_bounded(hn_int mean) { return mean; }
HN_FN hn_int hn_i_finite(hn_int mean) { return mean; }
#endif

// A detail is a number of octaves that need not be whole. hn_i_whole_octaves returns how many octaves it takes, and
// hn_i_last_part which part of the last one counts. The first counts as a whole. A detail below 2^-32 takes none, since
// drivers may flush a subnormal number.
HN_FN hn_int hn_i_whole_octaves(hn_float detail) {
  return hn_i_select(detail < 1.0f / 4294967296.0f, 0, -int(floor(-min(max(0.0f, detail), 32.0f))));
}
HN_FN hn_i_num hn_i_last_part(hn_float detail, hn_int octaves) {
  hn_float part = hn_i_minus(min(detail, 32.0f), hn_i_float(octaves - 1));
  return hn_i_setting(hn_i_select(octaves < 2, 1.0f, part), 1.0f);
}

HN_FN hn_i_octave_sum hn_i_empty_sum(hn_int octaves, hn_float gain) {
  HN_I_NEW(hn_i_octave_sum, s);
  s.value = HN_I_NO_WEIGHT;
  s.weight = HN_I_WEIGHT_ONE;
  s.feedback = HN_I_WEIGHT_ONE;
  s.gain = hn_i_gain(gain);
  s.part = HN_I_WEIGHT_ONE;
  s.footprint = HN_I_NO_WEIGHT;
  s.octaves = min(octaves, 32);  // no number that a user chooses hangs a GPU
  s.at = 0;
  return s;
}

// These add an octave to a sum; n is the noise of it.
HN_FN hn_i_octave_sum hn_i_add_octave(hn_i_octave_sum sum, hn_i_num n, hn_i_num weight) {
  hn_i_octave_sum s = sum;
  s.value = hn_i_summed(s.value, n, weight);
  return s;
}
HN_FN hn_i_octave_sum hn_i_add_noise(hn_i_octave_sum s, hn_float n) {
  return hn_i_add_octave(s, hn_i_octave(n), s.weight);
}
HN_FN hn_i_octave_sum hn_i_add_turbulence(hn_i_octave_sum s, hn_float n) {
  return hn_i_add_octave(s, hn_i_magnitude(hn_i_octave(n)), s.weight);
}
HN_FN hn_i_octave_sum hn_i_add_billow(hn_i_octave_sum s, hn_float n) {
  return hn_i_add_octave(s, hn_i_magnitude(hn_i_bounded_octave(n)), s.weight);
}
HN_FN hn_i_octave_sum hn_i_add_ridged(hn_i_octave_sum s, hn_float n) {
  hn_i_num ridge = hn_i_ridge(hn_i_bounded_octave(n));
  ridge = hn_i_weight_times(hn_i_weight_times(ridge, ridge), s.feedback);
  hn_i_octave_sum next = hn_i_add_octave(s, hn_i_weight_to_value(ridge), s.weight);
  next.feedback = min(hn_i_plus(ridge, ridge), HN_I_WEIGHT_ONE);
  return next;
}
HN_FN hn_i_octave_sum hn_i_add_hybrid(hn_i_octave_sum s, hn_float n) {
  hn_i_num height = hn_i_weight_times(hn_i_height(hn_i_bounded_octave(n)), s.feedback);
  hn_i_octave_sum next = hn_i_add_octave(s, hn_i_weight_to_value(height), s.weight);
  next.feedback = min(hn_i_plus(height, height), HN_I_WEIGHT_ONE);
  return next;
}
HN_FN hn_i_octave_sum hn_i_add_ping_pong(hn_i_octave_sum s, hn_float n, hn_float strength) {
  return hn_i_add_octave(s, hn_i_folds(hn_i_bounded_octave(n), hn_i_setting(strength, 64.0f)), s.weight);
}
HN_FN hn_i_octave_sum hn_i_add_weighted(hn_i_octave_sum s, hn_float n, hn_float strength) {
  hn_i_num value = hn_i_bounded_octave(n);
  hn_i_octave_sum next = hn_i_add_octave(s, value, s.weight);
  next.weight = hn_i_weight_times(s.weight, hn_i_weight_factor(value, hn_i_setting(strength, 1.0f)));
  return next;
}

// Adds the noise of an octave. Only a part of the last octave counts.
HN_FN hn_i_octave_sum hn_i_add_detail(hn_i_octave_sum s, hn_float n) {
  hn_i_num weight = s.weight;
  if (s.at + 1 == s.octaves) weight = hn_i_weight_times(weight, s.part);
  return hn_i_add_octave(s, hn_i_octave(n), weight);
}

// Adds as much of an octave as its footprint leaves. Where that is nothing, nothing is left of the octaves behind it,
// either, and so the sum ends.
HN_FN hn_i_octave_sum hn_i_add_footprint(hn_i_octave_sum s, hn_float n, hn_float lacunarity) {
  hn_i_octave_sum next =
      hn_i_add_octave(s, hn_i_octave(n), hn_i_weight_times(s.weight, hn_i_resolved_part(s.footprint)));
  next.footprint = hn_i_next_footprint(s.footprint, lacunarity);
  if (hn_i_resolved_part(next.footprint) == HN_I_NO_WEIGHT) next.at = s.octaves;
  return next;
}

// The total of the weights, and the mean of what was summed with them. With fewer octaves than one the mean is 0: a
// loop adds an octave before it checks whether there is any.
HN_FN hn_i_num hn_i_total(hn_i_octave_sum s) { return hn_i_total(s.octaves, s.gain, s.part); }
HN_FN hn_i_num hn_i_mean(hn_i_octave_sum s, hn_i_num sum, hn_i_num total) {
  return hn_i_select(s.octaves < 1, HN_I_NO_WEIGHT, hn_i_finite(hn_i_mean(sum, total)));
}
HN_FN hn_i_num hn_i_mean(hn_i_octave_sum s) { return hn_i_mean(s, s.value, hn_i_total(s)); }

#endif
