// The ranges that the functions document, and values as 16 bits of such a range: for files, and for arrays of Python.
#pragma once

#include <cstdint>
#include <hashnoise/field.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "functions.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

struct Interval {
  double least;
  double greatest;
  friend bool operator==(const Interval&, const Interval&) = default;
};

// The least of the interval becomes 0, the greatest 65535, and a number between them the nearest integer; of two
// equally near the greater one. A number outside becomes the nearer end, and NaN becomes 0. An interval without an
// extent makes 0 of everything that is not above it.
inline std::uint16_t word_of(float value, const Interval& interval) {
  constexpr double kGreatest = 65535.0;
  const double v = static_cast<double>(value);
  const double extent = interval.greatest - interval.least;
  if (!(extent > 0.0)) return v > interval.greatest ? 0xFFFF : 0;
  // No branches, so that compilers vectorize a loop over it. NaN becomes the least.
  const double above = v > interval.least ? v : interval.least;
  const double inside = above < interval.greatest ? above : interval.greatest;
  return static_cast<std::uint16_t>(static_cast<int>((inside - interval.least) / extent * kGreatest + 0.5));
}

// The range of a component, as the comment of the function in glsl/hashnoise/ has it, or nothing where that has no
// numbers: of the derivatives of fbm_d, which depend on the gain and the lacunarity, and of distances in other metrics
// than the Euclidean one. The settings of a sum name its noise.
inline std::optional<Interval> documented_range(const Settings& settings, int dimensions, std::string_view component) {
  const bool is_value = component == "value";
  if (!settings.fractal.empty()) {
    const SumRow& sum = sum_row(settings.fractal);
    if (sum.bounds == Bounds::kThese) return is_value ? std::optional(Interval{sum.least, sum.greatest}) : std::nullopt;
    if (sum.bounds == Bounds::kOfTheStrength) {
      const double most = static_cast<double>(strength_of(settings, sum).value_or(sum.usual_strength));
      return most == 0.0 ? std::nullopt : std::optional(Interval{-most, most});
    }
    // Others are means of the noise, and of values that lie nearer to 0.
  } else if (settings.metric.value_or(Metric::kEuclidean) != Metric::kEuclidean) {
    return std::nullopt;
  }
  const NoiseId id = noise_named(settings.noise);
  std::string name(component);  // in the catalog
  if (kNoiseRows[id].shape == Shape::kVector) {
    name = "axis";
  } else if (component.size() == 2 && component.front() == 'd') {
    name = "d";
  }
  if (settings.fractal.empty() && settings.phase && (name == "d" || name == "f1" || name == "f2")) name += "_phase";
  for (const RangeRow& row : kRangeRows) {
    if (row.noise == id && row.component == name && row.dimensions == dimensions) {
      return Interval{row.least, row.greatest};
    }
  }
  return is_value ? std::optional(Interval{-1.0, 1.0}) : std::nullopt;
}

}  // namespace hashnoise::grid
