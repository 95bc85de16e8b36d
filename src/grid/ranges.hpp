// The ranges that the functions document.
#pragma once

#include <hashnoise/field.hpp>
#include <optional>
#include <string_view>

#include "functions.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

struct Interval {
  double least;
  double greatest;
  friend bool operator==(const Interval&, const Interval&) = default;
};

namespace ranges {

constexpr Interval kSigned = {-1.0, 1.0};

inline bool is_derivative(std::string_view component) { return component.size() == 2 && component.front() == 'd'; }

// The catalog's name of a component.
inline std::string_view name_of(std::string_view component, Shape shape, bool has_phase) {
  if (shape == Shape::kVector) return "axis";
  if (is_derivative(component)) return has_phase ? "d_phase" : "d";
  if (has_phase && component == "f1") return "f1_phase";
  return has_phase && component == "f2" ? "f2_phase" : component;
}

// A noise alone.
inline std::optional<Interval> range_of_noise(std::string_view noise, bool has_phase, int dimensions,
                                              std::string_view component) {
  const NoiseId id = noise_named(noise);
  const std::string_view name = name_of(component, kNoiseRows[id].shape, has_phase);
  for (const RangeRow& row : kRangeRows) {
    if (row.noise == id && row.component == name && row.dimensions == dimensions) {
      return Interval{row.least, row.greatest};
    }
  }
  return component == "value" ? std::optional(kSigned) : std::nullopt;
}

inline std::optional<Interval> range_of_sum(const SumRow& sum, const Settings& settings, int dimensions,
                                            std::string_view component) {
  switch (sum.bounds) {
    case Bounds::kThese:
      return component == "value" ? std::optional(Interval{sum.least, sum.greatest}) : std::nullopt;
    case Bounds::kOfTheNoise:  // these are means of the noise, and of values that lie nearer to 0
      return range_of_noise(settings.noise, false, dimensions, component);
    case Bounds::kOfTheStrength: {
      const double most = static_cast<double>(strength_of(settings, sum).value_or(sum.usual_strength));
      return most == 0.0 ? std::nullopt : std::optional(Interval{-most, most});
    }
  }
  return std::nullopt;
}

}  // namespace ranges

// The range of a component, as the comment of the function in glsl/hashnoise/ has it, or nothing where that has no
// numbers: of the derivatives of fbm_d, which depend on the gain and the lacunarity, and of distances in other metrics
// than the Euclidean one. The settings of a sum name its noise.
inline std::optional<Interval> documented_range(const Settings& settings, int dimensions, std::string_view component) {
  if (!settings.fractal.empty())
    return ranges::range_of_sum(sum_row(settings.fractal), settings, dimensions, component);
  if (settings.metric.value_or(Metric::kEuclidean) != Metric::kEuclidean) return std::nullopt;
  return ranges::range_of_noise(settings.noise, settings.phase.has_value(), dimensions, component);
}

}  // namespace hashnoise::grid
