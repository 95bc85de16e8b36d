// Whether a field is right, and if not, where it differs first.
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

#include "hashnoise/field.hpp"

namespace hashnoise {

// How gtest prints them.
inline std::ostream& operator<<(std::ostream& out, const Range& range) {
  return out << "[" << range.least << ", " << range.greatest << "]";
}

inline std::ostream& operator<<(std::ostream& out, const Settings& s) {
  out << (s.fractal.empty() ? "" : s.fractal + " of ") << s.noise << ", arithmetic " << static_cast<int>(s.arithmetic)
      << ", seed " << s.seed << ", period";
  for (const std::int32_t period : s.period) out << " " << period;
  if (s.phase) out << ", phase " << *s.phase;
  for (const float wave : s.wave) out << ", wave " << wave;
  if (s.jitter) out << ", jitter " << *s.jitter;
  if (s.metric) out << ", metric " << static_cast<int>(*s.metric);
  if (s.octaves) out << ", octaves " << *s.octaves;
  if (s.lacunarity) out << ", lacunarity " << *s.lacunarity;
  if (s.gain) out << ", gain " << *s.gain;
  if (s.strength) out << ", strength " << *s.strength;
  if (s.amplitude) out << ", amplitude " << *s.amplitude;
  if (s.detail) out << ", detail " << *s.detail;
  if (s.footprint) out << ", footprint " << *s.footprint;
  if (s.instruction_set) out << ", with " << name(*s.instruction_set);
  return out;
}

namespace twin {

inline testing::AssertionResult compared(std::span<const float> got, std::span<const float> expected,
                                         std::size_t points, const std::function<bool(std::size_t)>& is_right) {
  if (got.size() != expected.size()) {
    return testing::AssertionFailure() << got.size() << " numbers in place of " << expected.size();
  }
  std::size_t wrong = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (is_right(i)) continue;
    if (wrong++ == 0) first = i;
  }
  if (wrong == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << wrong << " of " << got.size() << " numbers are wrong. The first is component "
                                     << first / points << " of point " << first % points << " of " << points << ": "
                                     << got[first] << " (" << std::hex << std::bit_cast<std::uint32_t>(got[first])
                                     << ") in place of " << expected[first] << " ("
                                     << std::bit_cast<std::uint32_t>(expected[first]) << ")";
}

// Every bit of every plane, with so many points in each. NaN is nowhere right.
inline testing::AssertionResult same_bits(std::span<const float> got, std::span<const float> expected,
                                          std::size_t points) {
  return compared(got, expected, points, [&](std::size_t i) {
    return std::bit_cast<std::uint32_t>(got[i]) == std::bit_cast<std::uint32_t>(expected[i]) && !std::isnan(got[i]);
  });
}

// Within a bound that may depend on the component and the point. Infinity is a bound that nothing is compared for.
using Bound = std::function<double(std::size_t component, std::size_t point)>;
inline testing::AssertionResult within(std::span<const float> got, std::span<const float> expected, std::size_t points,
                                       const Bound& bound) {
  return compared(got, expected, points, [&](std::size_t i) {
    const double difference = std::fabs(static_cast<double>(got[i]) - static_cast<double>(expected[i]));
    return difference <= bound(i / points, i % points);  // not so with a NaN
  });
}

}  // namespace twin
}  // namespace hashnoise
