#include "places.hpp"

#include <cmath>

namespace hashnoise::twin {

float coordinate(float origin, float step, int i) {
  const double at = static_cast<double>(origin) + static_cast<double>(i) * static_cast<double>(step);
  return static_cast<float>(at);
}

// In units of 2^-32, with as many bits as it takes.
CellCoordinate cell_coordinate(std::int32_t cell, float f, double step, int i) {
  __extension__ using Wide = __int128;
  const Wide one = Wide{1} << 32;
  const auto start = static_cast<Wide>(static_cast<double>(std::clamp(f, 0.0f, 1.0f)) * 0x1p32);
  const Wide at = cell * one + start + static_cast<Wide>(std::llround(step * 0x1p32)) * i;
  Wide whole = at / one;
  Wide rest = at % one;
  if (rest < 0) {
    rest += one;
    --whole;
  }
  Wide wrapped = whole % one;
  if (wrapped < 0) wrapped += one;
  return {static_cast<std::int32_t>(static_cast<std::uint32_t>(wrapped)),
          static_cast<float>(static_cast<std::uint32_t>(rest) >> 8) * 0x1p-24f};
}

Range range_of(std::span<const float> planes, std::size_t points) {
  Range range;
  for (const float value : planes.first(points)) {
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
  }
  return range;
}

}  // namespace hashnoise::twin
