#include "bake/mapping.hpp"

#include <cmath>

namespace hn {

Mapped to_16_bits(std::span<const float> values, const Interval& interval) {
  constexpr double kGreatest = 65535.0;
  const double extent = interval.greatest - interval.least;
  Mapped mapped;
  mapped.words.reserve(values.size());
  for (const float value : values) {
    const double v = static_cast<double>(value);
    std::uint16_t word = 0;
    if (!(v >= interval.least)) {  // or it is not a number
      ++mapped.clamped;
    } else if (v > interval.greatest) {
      ++mapped.clamped;
      word = 0xFFFF;
    } else if (extent > 0.0) {
      word = static_cast<std::uint16_t>(std::floor((v - interval.least) / extent * kGreatest + 0.5));
    }
    mapped.words.push_back(word);
  }
  return mapped;
}

}  // namespace hn
