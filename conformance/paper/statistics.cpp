#include "paper/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace hn {
namespace {

// D'Agostino 1970: Johnson's S_U fitted to the skewness of n normal values.
double z_of_skewness(double skewness, double n) {
  const double y = skewness * std::sqrt((n + 1) * (n + 3) / (6 * (n - 2)));
  const double beta2 = 3 * (n * n + 27 * n - 70) * (n + 1) * (n + 3) / ((n - 2) * (n + 5) * (n + 7) * (n + 9));
  const double w2 = std::sqrt(2 * (beta2 - 1)) - 1;
  const double delta = 1 / std::sqrt(0.5 * std::log(w2));
  const double alpha = std::sqrt(2 / (w2 - 1));
  return delta * std::asinh(y / alpha);
}

// Anscombe and Glynn 1983: the cube root of a chi-square fitted to the kurtosis of n normal values.
double z_of_kurtosis(double kurtosis, double n) {
  const double expected = 3 * (n - 1) / (n + 1);
  const double variance = 24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5));
  const double x = (kurtosis - expected) / std::sqrt(variance);
  const double skewness =
      6 * (n * n - 5 * n + 2) / ((n + 7) * (n + 9)) * std::sqrt(6 * (n + 3) * (n + 5) / (n * (n - 2) * (n - 3)));
  const double degrees = 6 + 8 / skewness * (2 / skewness + std::sqrt(1 + 4 / (skewness * skewness)));
  const double ratio = (1 - 2 / degrees) / (1 + x * std::sqrt(2 / (degrees - 4)));
  return (1 - 2 / (9 * degrees) - std::cbrt(ratio)) / std::sqrt(2 / (9 * degrees));
}

}  // namespace

Result<Moments> moments(std::span<const float> values) {
  if (values.empty()) return fail("without values there are no moments");
  const auto odd = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (odd != values.end()) {
    return fail(fmt::format("there are no moments: value {} of {} is {}", odd - values.begin(), values.size(), *odd));
  }
  // Boost computes in the type of the values, so these are made double.
  const std::vector<double> wide(values.begin(), values.end());
  const auto [least, greatest] = std::minmax_element(wide.begin(), wide.end());
  const auto [mean, m2, m3, m4] = boost::math::statistics::first_four_moments(wide);
  Moments result{wide.size(), *least, *greatest, mean, m2, 0.0, 0.0};
  // If all values are the same, not even rounding may make a distribution of them.
  const bool constant = *least == *greatest;
  result.skewness = constant ? std::numeric_limits<double>::quiet_NaN() : m3 / (m2 * std::sqrt(m2));
  result.excess_kurtosis = constant ? std::numeric_limits<double>::quiet_NaN() : m4 / (m2 * m2) - 3;
  return result;
}

std::vector<std::uint64_t> histogram(std::span<const float> values, double low, double high, std::size_t bins) {
  if (bins == 0 || !(low < high)) return {};
  const double width = (high - low) / static_cast<double>(bins);
  const auto edge = [&](std::size_t bin) { return bin == bins ? high : low + static_cast<double>(bin) * width; };
  std::vector<std::uint64_t> counts(bins);
  for (const float narrow : values) {
    const double value = static_cast<double>(narrow);
    if (!(value >= low && value <= high)) continue;
    std::size_t bin = std::min(static_cast<std::size_t>((value - low) / width), bins - 1);
    // The division rounds; the edges decide.
    if (bin > 0 && value < edge(bin)) --bin;
    if (bin + 1 < bins && value >= edge(bin + 1)) ++bin;
    ++counts[bin];
  }
  return counts;
}

Result<NormalityTest> normality_test(const Moments& sample) {
  constexpr std::size_t kFewest = 8;  // as scipy: below, the fit to the skewness is undefined
  if (sample.count < kFewest) {
    return fail(fmt::format("the normality test needs {} values or more, not {}", kFewest, sample.count));
  }
  if (!std::isfinite(sample.skewness) || !std::isfinite(sample.excess_kurtosis)) {
    return fail("the normality test needs values that are not all the same");
  }
  const auto n = static_cast<double>(sample.count);
  NormalityTest result;
  result.skewness_z = z_of_skewness(sample.skewness, n);
  result.kurtosis_z = z_of_kurtosis(sample.excess_kurtosis + 3, n);
  result.statistic = result.skewness_z * result.skewness_z + result.kurtosis_z * result.kurtosis_z;
  const boost::math::chi_squared distribution(2.0);
  result.p_value = boost::math::cdf(boost::math::complement(distribution, result.statistic));
  // With two degrees of freedom p is exp(-statistic / 2).
  result.log10_p = -0.5 * result.statistic * std::numbers::log10e;
  return result;
}

}  // namespace hn
