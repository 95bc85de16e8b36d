// The ranges that the functions document.
#pragma once

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
  const bool differs = name == "d" || name == "axis" || name == "f1" || name == "f2";  // with a phase
  if (settings.fractal.empty() && settings.phase && differs) name += "_phase";
  for (const RangeRow& row : kRangeRows) {
    if (row.noise == id && row.component == name && row.dimensions == dimensions) {
      return Interval{row.least, row.greatest};
    }
  }
  return is_value ? std::optional(Interval{-1.0, 1.0}) : std::nullopt;
}

}  // namespace hashnoise::grid
