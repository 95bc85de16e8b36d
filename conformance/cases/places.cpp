#include "cases/places.hpp"

#include <bit>
#include <cmath>

namespace hn {

std::uint32_t random_cell_of(const Function& function, std::uint32_t furthest, Random& random) {
  const bool far = function.takes_cell() && random.below(2) == 0;
  return far ? random.word() : random.below(2 * furthest) - furthest;
}

Place moved(const Place& place, double by) {
  const double fraction = place.fraction + by;
  if (fraction >= 0.0 && fraction <= 1.0) return {place.cell, fraction};
  const double cells = std::floor(fraction);
  return {place.cell + static_cast<std::uint32_t>(static_cast<std::int32_t>(cells)), fraction - cells};
}

void put(const Function& function, std::span<std::uint32_t> words, std::size_t axis, const Place& place) {
  const auto bits = [](double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); };
  if (function.takes_cell()) {
    words[axis] = place.cell;
    words[static_cast<std::size_t>(function.axes) + axis] = bits(place.fraction);
  } else {
    words[axis] = bits(static_cast<double>(static_cast<std::int32_t>(place.cell)) + place.fraction);
  }
}

}  // namespace hn
