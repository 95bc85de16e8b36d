// hashnoise: noise with uniform values, so that "30% of the land is water" is a number.
// SPDX-License-Identifier: MIT
//
// Most values of a noise are near 0. Their distribution depends on the noise and on its octaves. hn_uniform turns a
// value into the fraction of all values that are smaller:
//
//   float height = hn_fbm(p, 5, 2.0, 0.5, 7u);
//   vec4 distribution = hn_distribution_fbm(hn_distribution(HN_DISTRIBUTION_PERLIN2), 5.0, 0.5);
//   bool water = hn_uniform(height, distribution) < 0.3;   // 30% of the plane
//
// A distribution is four numbers: the reach, beyond which there are no values, and three coefficients.
// docs/guide/uniform.md has how near to uniform the results are, and tools/measure uniform measures it.
//
// With s = |value| / reach the tail, which is twice the fraction of values farther out, is a polynomial of
// y = (1 - s)^2 with the Bernstein coefficients 0, a, b, c, 1. These rise, and so the tail does; its slope is 0 at the
// reach.

#ifndef HN_UNIFORM_GLSL
#define HN_UNIFORM_GLSL

#include "detail/octave.glsl"
#include "detail/square_root.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// The distributions of the noises.

// tools/measure uniform: numbers
#define HN_DISTRIBUTION_VALUE1 1
#define HN_DISTRIBUTION_VALUE2 2
#define HN_DISTRIBUTION_VALUE3 3
#define HN_DISTRIBUTION_VALUE4 4
#define HN_DISTRIBUTION_VALUE_CUBIC1 5
#define HN_DISTRIBUTION_VALUE_CUBIC2 6
#define HN_DISTRIBUTION_VALUE_CUBIC3 7
#define HN_DISTRIBUTION_PERLIN1 8
#define HN_DISTRIBUTION_PERLIN2 9
#define HN_DISTRIBUTION_PERLIN3 10
#define HN_DISTRIBUTION_PERLIN4 11
#define HN_DISTRIBUTION_SIMPLEX2 12
#define HN_DISTRIBUTION_SIMPLEX3 13
#define HN_DISTRIBUTION_SIMPLEX4 14
#define HN_DISTRIBUTION_SIMPLEX_SMOOTH2 15
#define HN_DISTRIBUTION_SIMPLEX_SMOOTH3 16
#define HN_DISTRIBUTION_SINE2 17
#define HN_DISTRIBUTION_SINE3 18
// tools/measure uniform: end

HN_FN hn_vec4 hn_i_distribution(hn_int reach, hn_int a, hn_int b, hn_int c) {
  return vec4(hn_i_float(reach), hn_i_float(a), hn_i_float(b), hn_i_float(c)) * (1.0f / 4096.0f);
}

// The distribution of the values of a noise.
// Experimental: a later version may return other values.
//   kind     one of HN_DISTRIBUTION_PERLIN2, HN_DISTRIBUTION_SIMPLEX3 and so on; other numbers count as
//            HN_DISTRIBUTION_PERLIN2
//   example  vec4 distribution = hn_distribution(HN_DISTRIBUTION_PERLIN2);
//   returns  the reach, in [1/16, 3], and the three coefficients of the tail, which rise from 0 to 1
//   error    none
//   cost     none for a constant
//   source   docs/reference/contract.md, section 21; fitted by tools/measure uniform
HN_FN hn_vec4 hn_distribution(hn_int kind) {
  // tools/measure uniform: distributions
  if (kind == HN_DISTRIBUTION_VALUE1) return hn_i_distribution(4386, 1861, 2547, 3506);
  if (kind == HN_DISTRIBUTION_VALUE2) return hn_i_distribution(4192, 1310, 2400, 3358);
  if (kind == HN_DISTRIBUTION_VALUE3) return hn_i_distribution(4043, 833, 2233, 3164);
  if (kind == HN_DISTRIBUTION_VALUE4) return hn_i_distribution(3957, 453, 1904, 2991);
  if (kind == HN_DISTRIBUTION_VALUE_CUBIC1) return hn_i_distribution(3847, 1006, 2480, 3274);
  if (kind == HN_DISTRIBUTION_VALUE_CUBIC2) return hn_i_distribution(3312, 126, 1874, 2995);
  if (kind == HN_DISTRIBUTION_VALUE_CUBIC3) return hn_i_distribution(2423, 68, 1551, 2913);
  if (kind == HN_DISTRIBUTION_PERLIN1) return hn_i_distribution(3930, 91, 1356, 1679);
  if (kind == HN_DISTRIBUTION_PERLIN3) return hn_i_distribution(2953, 348, 1923, 3001);
  if (kind == HN_DISTRIBUTION_PERLIN4) return hn_i_distribution(2707, 122, 1749, 2951);
  if (kind == HN_DISTRIBUTION_SIMPLEX2) return hn_i_distribution(4235, 4, 2867, 3147);
  if (kind == HN_DISTRIBUTION_SIMPLEX3) return hn_i_distribution(4253, 790, 1515, 3070);
  if (kind == HN_DISTRIBUTION_SIMPLEX4) return hn_i_distribution(3718, 507, 886, 2305);
  if (kind == HN_DISTRIBUTION_SIMPLEX_SMOOTH2) return hn_i_distribution(4533, 51, 2427, 3152);
  if (kind == HN_DISTRIBUTION_SIMPLEX_SMOOTH3) return hn_i_distribution(4162, 875, 2535, 3241);
  if (kind == HN_DISTRIBUTION_SINE2) return hn_i_distribution(2596, 306, 1551, 2823);
  if (kind == HN_DISTRIBUTION_SINE3) return hn_i_distribution(2954, 111, 1490, 2882);
  return hn_i_distribution(4082, 21, 1195, 3017);
  // tools/measure uniform: end
}

// ---------------------------------------------------------------------------------------------------------------------
// The steps. With HN_FIXED values are in units of 2^-21, and all else is in units of weights, 2^-18.

#if HN_ARITHMETIC != HN_FIXED

#define HN_I_VALUE_ONE 1.0f
#define HN_I_VALUE_TWO 2.0f

HN_FN hn_float hn_i_as_value(hn_float x, hn_float least, hn_float most) { return min(max(least, x), most); }
HN_FN hn_float hn_i_as_reach(hn_float x) { return min(max(0.0625f, x), 3.0f); }
HN_FN hn_float hn_i_half_value(hn_float n) { return hn_i_flushed(hn_i_times(n, 0.5f)); }
HN_FN hn_float hn_i_of_units(hn_float n) { return hn_i_flushed(n); }
HN_FN hn_float hn_i_parts(hn_float x, hn_int n) { return hn_i_times(x, hn_i_float(n) * (1.0f / 1024.0f)); }
HN_FN hn_float hn_i_variance(hn_float a, hn_float b, hn_float c) {
  HN_I_PRECISE hn_float n = 65.0f * a + 33.0f * b + 17.0f * c + 7.0f;
  return n;
}
HN_FN hn_float hn_i_root_of_ratio(hn_float ratio) { return hn_i_root(min(ratio, 8.0f)); }

#else

#define HN_I_VALUE_ONE HN_I_UNITS_VALUE
#define HN_I_VALUE_TWO (2 * HN_I_UNITS_VALUE)

HN_FN hn_int hn_i_as_value(hn_float x, hn_float least, hn_float most) {
  return int(min(max(least, x), most) * HN_I_FLOAT_UNITS_VALUE);
}
HN_FN hn_int hn_i_as_reach(hn_float x) { return int(min(max(0.0625f, x), 3.0f) * HN_I_FLOAT_UNITS_WEIGHT); }
HN_FN hn_float hn_i_half_value(hn_int n) { return hn_i_float(n) * (0.5f / HN_I_FLOAT_UNITS_VALUE); }
HN_FN hn_float hn_i_of_units(hn_int n) { return hn_i_float(n) * (1.0f / HN_I_FLOAT_UNITS_WEIGHT); }

// n / 1024 of a number. A shift rounds down, as a product with a weight does.
HN_FN hn_int hn_i_parts(hn_int x, hn_int n) { return (x * n) >> 10; }

// The result is in units of 2^-15, since a mean has 23 bits.
HN_FN hn_int hn_i_variance(hn_int a, hn_int b, hn_int c) { return (65 * a + 33 * b + 17 * c + 1835008) >> 3; }
HN_FN hn_int hn_i_root_of_ratio(hn_int ratio) { return int(hn_i_root(uint(min(ratio, HN_I_UNITS_VALUE)) << 10u)); }

#endif

// Goes from p to q, which is not smaller, by a weight. The result does not fall where p, q or y rises; with HN_FIXED
// not by a single unit, as the product is rounded down once. So neither does the tail.
HN_FN hn_i_num hn_i_scramble(hn_i_num p, hn_i_num q, hn_i_num y) {
  return hn_i_plus(p, hn_i_weight_times(hn_i_minus(q, p), y));
}

// A tail lies between two numbers. Their difference is a quarter of its slope by y = w^2.
struct hn_i_tail {
  hn_i_num low;
  hn_i_num high;
  hn_i_num w;  // how far the value is from the end: 1 at 0, and 0 at the reach and beyond
  hn_i_num reach;
  hn_i_num value;
};

HN_FN hn_i_tail hn_i_tail_of(hn_float value, hn_vec4 distribution) {
  HN_I_NEW(hn_i_tail, tail);
  tail.reach = hn_i_as_value(distribution.x, 0.0625f, 3.0f);
  tail.value = hn_i_as_value(value, -3.0f, 3.0f);
  hn_i_num a = hn_i_as_value(distribution.y, 0.0f, 1.0f);
  hn_i_num b = max(a, hn_i_as_value(distribution.z, 0.0f, 1.0f));
  hn_i_num c = max(b, hn_i_as_value(distribution.w, 0.0f, 1.0f));
  // A quotient of floats may be beyond 1.
  hn_i_num s = hn_i_mean(min(hn_i_magnitude(tail.value), tail.reach), tail.reach);
  tail.w = max(hn_i_minus(HN_I_WEIGHT_ONE, s), HN_I_NO_WEIGHT);
  // De Casteljau's rounds, without the round of the last two numbers.
  hn_i_num y = hn_i_weight_times(tail.w, tail.w);
  hn_i_num ab = hn_i_scramble(a, b, y);
  hn_i_num bc = hn_i_scramble(b, c, y);
  hn_i_num low = hn_i_scramble(hn_i_weight_times(a, y), ab, y);
  hn_i_num middle = hn_i_scramble(ab, bc, y);
  hn_i_num high = hn_i_scramble(bc, hn_i_scramble(c, HN_I_VALUE_ONE, y), y);
  tail.low = hn_i_scramble(low, middle, y);
  tail.high = hn_i_scramble(middle, high, y);
  return tail;
}

HN_FN hn_float hn_i_uniform(hn_i_tail tail) {
  hn_i_num n = hn_i_scramble(tail.low, tail.high, hn_i_weight_times(tail.w, tail.w));
  return hn_i_half_value(hn_i_select(tail.value < HN_I_NO_WEIGHT, n, hn_i_minus(HN_I_VALUE_TWO, n)));
}

// ---------------------------------------------------------------------------------------------------------------------
// Uniform values.

// The fraction of all values of a noise that are smaller than a value: noise with uniform values.
//   value    of a noise, or of hn_fbm
//   distribution  of the noise: hn_distribution(HN_DISTRIBUTION_PERLIN2) and so on, or hn_distribution_fbm of that.
//            Numbers beyond their range count as the nearer end
//   example  float u = hn_uniform(hn_perlin(uv * 8.0, 7u), hn_distribution(HN_DISTRIBUTION_PERLIN2));
//   returns  [0, 1], 1/2 at 0; it never falls where the value rises (with HN_FIXED; roundings of floats may take it
//            down by 1e-6), and is twice continuously differentiable but for 0, where its slope has a crease
//   error    at most 1.20e-6 against the exact value, in any rounding mode (docs/measured/accuracy.md). HN_FIXED
//            5.46e-5. docs/guide/uniform.md has how near to uniform the results are
//   cost     about 40 operations, with a division; in HN_FIXED 3 divisions and 20 multiplications
//   source   docs/reference/contract.md, section 21
HN_FN hn_float hn_uniform(hn_float value, hn_vec4 distribution) {
  return hn_i_uniform(hn_i_tail_of(value, distribution));
}

// The uniform value with its derivative: a slope of the noise, times the derivative, is the slope of its uniform
// values.
//   value    of a noise, or of hn_fbm
//   distribution  as above
//   example  vec2 u = hn_uniform_d(hn_perlin(uv * 8.0, 7u), hn_distribution(HN_DISTRIBUTION_PERLIN2));
//   returns  the uniform value, and its derivative by the value: how many values there are near it. Not negative
//   error    of the value as above; of the derivative at most 1.09e-5 / reach. HN_FIXED 4.18e-4 / reach
//   cost     hn_uniform's, and a division more
//   source   docs/reference/contract.md, section 21
HN_FN hn_vec2 hn_uniform_d(hn_float value, hn_vec4 distribution) {
  hn_i_tail tail = hn_i_tail_of(value, distribution);
  hn_i_num rise = hn_i_weight_times(hn_i_minus(tail.high, tail.low), tail.w);
  hn_i_num twice = hn_i_plus(rise, rise);
  return vec2(hn_i_uniform(tail), hn_i_of_units(hn_i_mean(hn_i_plus(twice, twice), tail.reach)));
}

// A coefficient of a sum lies between a bell's and the noise's. Their difference has two parts: the one
// that goes with the kurtosis of the noise falls as the kurtosis of a sum does, and the rest falls faster.
HN_FN hn_i_num hn_i_of_sum(hn_i_num x, hn_int bell, hn_int way, hn_i_num d, hn_i_num fourth, hn_i_num eighth) {
  hn_i_num start = hn_i_parts(HN_I_WEIGHT_ONE, bell);
  hn_i_num h = hn_i_parts(d, way);
  hn_i_num rest = hn_i_minus(hn_i_minus(x, start), h);
  hn_i_num n = hn_i_plus(hn_i_plus(start, hn_i_weight_times(h, fourth)), hn_i_weight_times(rest, eighth));
  return min(max(n, HN_I_NO_WEIGHT), HN_I_WEIGHT_ONE);
}

// The distribution of the values of a fractal, from its noise's, for any gain and number of octaves. It takes
// octaves as independent, which on the line they are not quite (docs/guide/uniform.md).
// Experimental: a later version may return other values.
//   distribution  of the noise: hn_distribution(HN_DISTRIBUTION_PERLIN2) and so on
//   detail   octaves as a float, as of hn_fbm, usually 4 to 8, from 1 to 32. The lacunarity does not matter
//   gain     ratio of amplitudes, as of hn_fbm, usually 0.5, in [0, 1]
//   example  vec4 distribution = hn_distribution_fbm(hn_distribution(HN_DISTRIBUTION_PERLIN2), 5.0, 0.5);
//   returns  the distribution of hn_fbm, or of another mean of octaves of the noise (hn_add)
//   error    of the coefficients at most 2.54e-5. HN_FIXED 8.40e-5. The reach: docs/measured/accuracy.md
//   cost     about 10 operations for each octave and 60 more. It does not depend on the position: compute it on the
//            CPU, or let the compiler, where detail and gain are constants
//   source   docs/reference/contract.md, section 21
HN_FN hn_vec4 hn_distribution_fbm(hn_vec4 distribution, hn_float detail, hn_float gain) {
  hn_i_num a = hn_i_setting(distribution.y, 1.0f);
  hn_i_num b = max(a, hn_i_setting(distribution.z, 1.0f));
  hn_i_num c = max(b, hn_i_setting(distribution.w, 1.0f));
  hn_float octaves = min(max(1.0f, detail), 32.0f);
  hn_int count = hn_i_whole_octaves(octaves);
  hn_i_num ratio = hn_i_setting(gain, 1.0f);

  // The sums of the weights, and of their powers.
  hn_i_num sum = HN_I_NO_WEIGHT;
  hn_i_num sum2 = HN_I_NO_WEIGHT;
  hn_i_num sum4 = HN_I_NO_WEIGHT;
  hn_i_num sum8 = HN_I_NO_WEIGHT;
  hn_i_num weight = HN_I_WEIGHT_ONE;
  for (hn_int i = 1; i <= count; ++i) {
    if (i == count) weight = hn_i_weight_times(weight, hn_i_last_part(octaves, count));
    hn_i_num square = hn_i_weight_times(weight, weight);
    hn_i_num fourth = hn_i_weight_times(square, square);
    sum = hn_i_plus(sum, weight);
    sum2 = hn_i_plus(sum2, square);
    sum4 = hn_i_plus(sum4, fourth);
    sum8 = hn_i_plus(sum8, hn_i_weight_times(fourth, fourth));
    weight = hn_i_weight_times(weight, ratio);
  }
  hn_i_num per_square = hn_i_mean(HN_I_WEIGHT_ONE, sum2);
  hn_i_num rho4 = hn_i_weight_times(hn_i_weight_times(sum4, per_square), per_square);
  hn_i_num per_fourth = hn_i_weight_times(per_square, per_square);
  hn_i_num rho8 = hn_i_weight_times(hn_i_weight_times(sum8, per_fourth), per_fourth);

  // docs/reference/contract.md, section 21: the bell, and how a sum comes near to it. tools/measure uniform fits them.
  hn_i_num d = hn_i_minus(c, hn_i_parts(HN_I_WEIGHT_ONE, 736));
  hn_i_num new_a = hn_i_of_sum(a, 103, 592, d, rho4, rho8);
  hn_i_num new_b = hn_i_of_sum(b, 381, 1958, d, rho4, rho8);
  hn_i_num new_c = hn_i_of_sum(c, 736, 452, d, rho4, rho8);

  // The reach, so that the variance is the sum's: the noise's, times sum2 / sum^2.
  hn_i_num per_sum = hn_i_mean(HN_I_WEIGHT_ONE, sum);
  hn_i_num falls = hn_i_weight_times(hn_i_weight_times(sum2, per_sum), per_sum);
  hn_i_num variance = hn_i_weight_times(hn_i_variance(a, b, c), falls);
  hn_i_num stretch = hn_i_root_of_ratio(hn_i_mean(variance, hn_i_variance(new_a, new_b, new_c)));
  hn_i_num reach = hn_i_weight_times(hn_i_as_reach(distribution.x), stretch);
  return vec4(hn_i_of_units(reach), hn_i_of_units(new_a), hn_i_of_units(new_b), hn_i_of_units(new_c));
}

#endif
