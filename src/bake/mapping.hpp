// Values as 16 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bake/options.hpp"

namespace hn {

struct Texels {
  std::vector<std::uint16_t> words;
  std::size_t clamped = 0;  // values outside of the interval, which became its nearer end
};

// The least of the interval becomes 0, the greatest 65535, and what is between the nearest number; of two that are as
// near the greater one. NaN becomes 0. An interval without an extent makes 0 of everything.
Texels to_16_bits(std::span<const float> values, const Interval& interval);

}  // namespace hn
