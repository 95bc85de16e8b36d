// The scalar functions of hashnoise.hpp by the names of Settings: the right values of a field, point by point.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grid/functions.hpp"
#include "grid/plan.hpp"
#include "hashnoise/field.hpp"

namespace hashnoise::twin {

// A noise or a sum with its settings. The functions write `components` numbers. There is no `in` of sums with a detail
// or a footprint.
template <int D>
struct Function {
  int components = 0;
  std::function<void(const std::array<float, D>& p, float* values)> at;
  std::function<void(const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* values)> in;
};

// With one arithmetic: twin_of_arithmetic.cpp is compiled once for each.
template <int D, Arithmetic A>
Function<D> function_of(const Settings& settings);
#define HN_TWIN_OF(A)                                         \
  template <>                                                 \
  Function<1> function_of<1, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<2> function_of<2, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<3> function_of<3, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<4> function_of<4, Arithmetic::A>(const Settings&);
HN_TWIN_OF(kFast)
HN_TWIN_OF(kPrecise)
HN_TWIN_OF(kFixed)
#undef HN_TWIN_OF

// Throws std::logic_error if there is no such function. The settings must outlive the result.
template <int D>
Function<D> function(const Settings& settings) {
  if (settings.arithmetic == Arithmetic::kFast) return function_of<D, Arithmetic::kFast>(settings);
  if (settings.arithmetic == Arithmetic::kPrecise) return function_of<D, Arithmetic::kPrecise>(settings);
  return function_of<D, Arithmetic::kFixed>(settings);
}

// The catalog's noises and sums.
inline std::vector<std::string> noises(int dimensions) {
  const std::vector<std::string_view> names = hashnoise::noises(dimensions);
  return {names.begin(), names.end()};
}
inline std::vector<std::string> sums(int dimensions) {
  const std::vector<std::string_view> names = hashnoise::fractals(dimensions);
  return {names.begin(), names.end()};
}
inline const grid::NoiseRow& row_of(const std::string& noise) { return grid::kNoiseRows[grid::noise_named(noise)]; }

// The noises that a sum can be taken over; "" alone for a sum of noises of its own.
inline std::vector<std::string> noises_of(const std::string& sum, int dimensions) {
  if (!grid::sum_row(sum).takes_noise()) return {""};
  std::vector<std::string> names = noises(dimensions);
  std::erase_if(names, [&](const std::string& noise) { return row_of(noise).shape != grid::sum_row(sum).of; });
  return names;
}
// The noise of its GLSL function; "" if there are several.
inline std::string noise_below(const std::string& sum) {
  const grid::SumRow& row = grid::sum_row(sum);
  return row.takes_noise() ? std::string(grid::kNoiseRows[row.usual_noise].name) : "";
}

inline bool has_period(const Settings& settings, int dimensions) {
  return std::any_of(settings.period.begin(), settings.period.begin() + dimensions, [](int p) { return p > 0; });
}

// The numbers of settings, with the defaults of field.hpp.
inline float jitter_of(const Settings& s) { return s.jitter.value_or(1.0f); }
inline int metric_of(const Settings& s) { return static_cast<int>(s.metric.value_or(Metric::kEuclidean)); }
// 3 along x without one; 0 behind the last axis.
inline std::array<float, 4> wave_of(const Settings& s) {
  std::array<float, 4> wave = {s.wave.empty() ? 3.0f : 0.0f};
  std::copy(s.wave.begin(), s.wave.end(), wave.begin());
  return wave;
}
inline int octaves_of(const Settings& s) { return s.octaves.value_or(6); }
inline float lacunarity_of(const Settings& s) { return s.lacunarity.value_or(2.0f); }
inline float gain_of(const Settings& s) { return s.gain.value_or(0.5f); }
inline float strength_of(const Settings& s) { return s.strength.value_or(grid::sum_row(s.fractal).usual_strength); }
inline float amplitude_of(const Settings& s) { return s.amplitude.value_or(1.0f); }

}  // namespace hashnoise::twin
