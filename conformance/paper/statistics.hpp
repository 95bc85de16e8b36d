// Describes a sample of noise values: its moments, its histogram, and whether it is normally distributed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"

namespace hn {

// They describe the sample itself, and estimate no larger population: numpy.var(x), scipy.stats.skew(x),
// scipy.stats.kurtosis(x) of the values as doubles. Skewness and excess kurtosis of values that are all the same are
// NaN.
struct Moments {
  std::size_t count = 0;
  double minimum = 0.0;
  double maximum = 0.0;
  double mean = 0.0;
  double variance = 0.0;
  double skewness = 0.0;
  double excess_kurtosis = 0.0;
};

// Fails for no values and for a value that is not finite.
Result<Moments> moments(std::span<const float> values);

// As numpy.histogram(x, bins, (low, high)) counts the values as doubles: each bin has its left edge and not its right
// one, but the last has both; a value outside, or NaN, is in none. Without bins or with low >= high there are no
// counts.
std::vector<std::uint64_t> histogram(std::span<const float> values, double low, double high, std::size_t bins);

// D'Agostino and Pearson's K^2 test, as scipy.stats.normaltest(x): how far skewness and kurtosis together are from
// those of a normal distribution.
struct NormalityTest {
  double statistic = 0.0;  // skewness_z^2 + kurtosis_z^2; chi-square with two degrees of freedom if normal
  double p_value = 0.0;    // rounds to 0 for a statistic beyond about 1490
  double log10_p = 0.0;    // its decimal logarithm, which does not
  double skewness_z = 0.0;
  double kurtosis_z = 0.0;
};

// Fails for fewer than 8 values, for which the approximations do not hold, and for values that are all the same.
Result<NormalityTest> normality_test(const Moments& sample);

}  // namespace hn
