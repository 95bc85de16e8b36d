// The functions that a field can be: their names, in which dimensions they are, and which settings they take.
#pragma once

#include <array>
#include <functional>
#include <hashnoise/field.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "kernel.hpp"
#include "rules.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

struct NoiseRow {
  std::string_view name;
  int first_dimension, last_dimension;
  Shape shape;
  Inputs takes;

  constexpr bool has_phase() const {  // in 2D and 3D
    return takes == Inputs::kPhase || takes == Inputs::kJitterAndMetricAndPhase || has_wave();
  }
  constexpr bool has_wave() const { return takes == Inputs::kBandwidthAndPhaseAndWave; }
  constexpr bool has_jitter() const { return takes == Inputs::kJitter || has_metric(); }
  constexpr bool has_metric() const {
    return takes == Inputs::kJitterAndMetric || takes == Inputs::kJitterAndMetricAndPhase;
  }
};

// The known bounds of a value.
enum class Bounds { kThese, kOfTheNoise, kOfTheStrength };

// The noise that a sum takes has the shape `of`.
struct SumRow {
  std::string_view name;
  int first_dimension, last_dimension;
  Shape shape;
  Shape of;
  NoiseId usual_noise;        // kNoises if nobody chooses them
  std::string_view strength;  // what it calls that parameter; nothing if it has none
  float usual_strength;
  float most_strength;
  Bounds bounds;
  double least, greatest;  // kThese
  bool has_phase;

  constexpr bool takes_noise() const { return usual_noise != kNoises; }
};

// The range of a component that is not in [-1, 1]. "d" is each derivative, "d_phase" with a phase, as
// "f1_phase" is of "f1", and "axis" each component of a vector, "axis_phase" with one.
struct RangeRow {
  NoiseId noise;
  std::string_view component;
  int dimensions;
  double least, greatest;
};

// By NoiseId and SumId; in the order of the dimensions.
constexpr std::array<NoiseRow, kNoises> kNoiseRows = {{
#define HN_CATALOG_NOISE(Id, name, first, last, shape, takes) {#name, first, last, Shape::shape, Inputs::takes},
#include "catalog.inc"
}};
// This throws std::out_of_range for a name that there is not.
template <typename Rows>
constexpr std::size_t index_of(const Rows& rows, std::string_view name) {
  std::size_t i = 0;
  while (rows.at(i).name != name) ++i;
  return i;
}
constexpr NoiseId noise_named(std::string_view name) { return static_cast<NoiseId>(index_of(kNoiseRows, name)); }
constexpr NoiseId noise_or_none(std::string_view name) { return name == "none" ? kNoises : noise_named(name); }
constexpr std::array<SumRow, kNamedSums> kSumRows = {{
// "none" is the strength of a sum without one.
#define HN_CATALOG_SUM(Id, name, first, last, shape, of, noise, strength, usual, most, bounds, least, greatest, \
                       has_phase)                                                                               \
  {#name,                                                                                                       \
   first,                                                                                                       \
   last,                                                                                                        \
   Shape::shape,                                                                                                \
   Shape::of,                                                                                                   \
   noise_or_none(#noise),                                                                                       \
   std::string_view(#strength) == "none" ? std::string_view() : #strength,                                      \
   usual,                                                                                                       \
   most,                                                                                                        \
   Bounds::bounds,                                                                                              \
   least,                                                                                                       \
   greatest,                                                                                                    \
   has_phase},
#include "catalog.inc"
}};
constexpr RangeRow kRangeRows[] = {
#define HN_CATALOG_RANGE(noise, component, dimensions, least, greatest) \
  {noise_named(#noise), #component, dimensions, least, greatest},
#include "catalog.inc"
};
constexpr std::string_view kMetricNames[] = {
#define HN_CATALOG_METRIC(Id, name) #name,
#include "catalog.inc"
};

constexpr const SumRow& sum_row(std::string_view name) { return kSumRows[index_of(kSumRows, name)]; }

// The setting of the number that a sum calls its strength.
inline const std::optional<float>& strength_of(const Settings& settings, const SumRow& sum) {
  return sum.strength == "amplitude" ? settings.amplitude : settings.strength;
}

// The names of the rows for which the predicate is true.
template <typename Rows, typename Predicate>
std::vector<std::string_view> names_where(const Rows& rows, Predicate is_true) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) {
    if (std::invoke(is_true, row)) names.push_back(row.name);
  }
  return names;
}

constexpr Rule strength_rule(const SumRow& sum) {
  return {sum.strength, false, 0, static_cast<double>(sum.most_strength), static_cast<double>(sum.usual_strength)};
}

}  // namespace hashnoise::grid
