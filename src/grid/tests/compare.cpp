#include "compare.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace hashnoise {

std::ostream& operator<<(std::ostream& out, const Range& range) {
  return out << "[" << range.least << ", " << range.greatest << "]";
}

std::ostream& operator<<(std::ostream& out, const Settings& s) {
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
namespace {

testing::AssertionResult compared(std::span<const float> got, std::span<const float> expected, std::size_t points,
                                  const std::function<bool(std::size_t)>& is_right) {
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

}  // namespace

testing::AssertionResult same_bits(std::span<const float> got, std::span<const float> expected, std::size_t points) {
  return compared(got, expected, points, [&](std::size_t i) {
    return std::bit_cast<std::uint32_t>(got[i]) == std::bit_cast<std::uint32_t>(expected[i]) && !std::isnan(got[i]);
  });
}

testing::AssertionResult within(std::span<const float> got, std::span<const float> expected, std::size_t points,
                                const Bound& bound) {
  return compared(got, expected, points, [&](std::size_t i) {
    const double difference = std::fabs(static_cast<double>(got[i]) - static_cast<double>(expected[i]));
    return difference <= bound(i / points, i % points);  // not so with a NaN
  });
}

}  // namespace twin
}  // namespace hashnoise
