#include "bake/positions.hpp"

#include <cmath>

namespace hn {
namespace {

__extension__ using Wide = __int128;  // a product of two numbers of 64 bits

constexpr double kUnits = 4294967296.0;  // of a cell

std::int64_t in_units(double cells) { return std::llround(cells * kUnits); }

}  // namespace

Axis axis_of(double origin, double cells, int size) {
  const std::int64_t first = in_units(origin);
  const Wide all = in_units(cells);
  Axis axis;
  const auto count = static_cast<std::size_t>(size);
  axis.cell.reserve(count);
  axis.f.reserve(count);
  axis.p.reserve(count);
  for (int i = 0; i < size; ++i) {
    const std::int64_t at = first + static_cast<std::int64_t>(all * i / size);
    const std::uint32_t place = static_cast<std::uint32_t>(at) >> 8;
    axis.cell.push_back(static_cast<std::int32_t>(at >> 32));
    axis.f.push_back(static_cast<float>(place) * 0x1p-24f);
    axis.p.push_back(static_cast<float>(static_cast<double>(axis.cell.back()) + static_cast<double>(place) * 0x1p-24));
  }
  return axis;
}

}  // namespace hn
