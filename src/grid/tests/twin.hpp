// The scalar functions of hashnoise.hpp by the names of Settings: the right values of a field, point by point.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hashnoise/field.hpp"

namespace hashnoise::twin {

// A noise or a sum with its settings. The functions write `components` numbers.
template <int D>
struct Function {
  int components = 0;
  std::function<void(const std::array<float, D>& p, float* values)> at;
  // Empty where there is no such form: sums with a detail or a footprint.
  std::function<void(const std::array<std::int32_t, D>& cell, const std::array<float, D>& f, float* values)> in;
};

// Throws std::logic_error if there is no such function. The settings must outlive the result.
template <int D>
Function<D> function(const Settings& settings);

// The catalog's noises and sums.
struct Noise {
  std::string name;
  int components;
};
std::vector<Noise> noises(int dimensions);
std::vector<std::string> sums(int dimensions);

// The noises that a sum can be taken over; "" alone for a sum of noises of its own.
std::vector<std::string> noises_of(const std::string& sum, int dimensions);
// The noise of its GLSL function; "" if there are several.
std::string noise_below(const std::string& sum);

bool has_period(const Settings& settings, int dimensions);

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
float strength_of(const Settings& s);
inline float amplitude_of(const Settings& s) { return s.amplitude.value_or(1.0f); }

}  // namespace hashnoise::twin
