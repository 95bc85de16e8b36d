#include "bake/mapping.hpp"

#include "grid/ranges.hpp"

namespace hn {

Texels to_16_bits(std::span<const float> values, const Interval& interval) {
  Texels mapped;
  mapped.words.reserve(values.size());
  for (const float value : values) {
    const double v = static_cast<double>(value);
    if (v < interval.least || v > interval.greatest) ++mapped.clamped;  // and not for NaN
    mapped.words.push_back(hashnoise::grid::word_of(value, interval));
  }
  return mapped;
}

}  // namespace hn
