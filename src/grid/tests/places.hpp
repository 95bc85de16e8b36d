// Where the points of a grid are, and the twin's value there: from the comments in points.hpp.
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "hashnoise/points.hpp"
#include "twin.hpp"

namespace hashnoise::twin {

template <int D>
using Position = std::array<float, D>;

template <int D>
struct CellPlace {
  std::array<std::int32_t, D> cell{};
  std::array<float, D> f{};
  friend bool operator==(const CellPlace&, const CellPlace&) = default;
};

// Point i along an axis of a grid.
inline float coordinate(float origin, float step, int i) {
  const double at = static_cast<double>(origin) + static_cast<double>(i) * static_cast<double>(step);
  return static_cast<float>(at);
}

struct CellCoordinate {
  std::int32_t cell;
  float f;
};
// In units of 2^-32, with as many bits as it takes.
inline CellCoordinate cell_coordinate(std::int32_t cell, float f, double step, int i) {
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

template <int D>
std::size_t count_of(const std::array<int, D>& size) {
  std::size_t count = 1;
  for (const int points : size) count *= static_cast<std::size_t>(points);
  return count;
}

// Calls `each` with the indices of every point, x fastest.
template <int D, typename Each>
void for_each_index(const std::array<int, D>& size, const Each& each) {
  std::array<int, D> index{};
  for (std::size_t point = 0; point < count_of<D>(size); ++point) {
    each(index);
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (++index[axis] < size[axis]) break;
      index[axis] = 0;
    }
  }
}

template <int D>
std::vector<Position<D>> places_of(const Grid<D>& grid) {
  std::vector<Position<D>> places;
  for_each_index<D>(grid.size, [&](const std::array<int, D>& index) {
    Position<D> p{};
    for (std::size_t axis = 0; axis < D; ++axis) {
      p[axis] = coordinate(grid.origin[axis], grid.step[axis], grid.first[axis] + index[axis]);
    }
    places.push_back(p);
  });
  return places;
}

template <int D>
std::vector<CellPlace<D>> places_of(const CellGrid<D>& grid) {
  std::vector<CellPlace<D>> places;
  for_each_index<D>(grid.size, [&](const std::array<int, D>& index) {
    CellPlace<D> place;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const CellCoordinate at =
          cell_coordinate(grid.cell[axis], grid.f[axis], grid.step[axis], grid.first[axis] + index[axis]);
      place.cell[axis] = at.cell;
      place.f[axis] = at.f;
    }
    places.push_back(place);
  });
  return places;
}

template <int D>
std::vector<Position<D>> places_of(const Points<D>& points) {
  std::vector<Position<D>> places(points.p[0].size());
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i][axis] = points.p[axis][i];
  }
  return places;
}

template <int D>
std::vector<CellPlace<D>> places_of(const CellPoints<D>& points) {
  std::vector<CellPlace<D>> places(points.cell[0].size());
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i].cell[axis] = points.cell[axis][i];
      places[i].f[axis] = points.f[axis][i];
    }
  }
  return places;
}

template <int D>
void evaluate(const Function<D>& function, const Position<D>& p, float* values) {
  function.at(p, values);
}
template <int D>
void evaluate(const Function<D>& function, const CellPlace<D>& place, float* values) {
  function.in(place.cell, place.f, values);
}

// The right values of a field at places: a plane for each component.
template <int D, typename Place>
std::vector<float> planes_of(const Function<D>& function, const std::vector<Place>& places) {
  const auto components = static_cast<std::size_t>(function.components);
  std::vector<float> planes(components * places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::array<float, 5> values{};
    evaluate<D>(function, places[i], values.data());
    for (std::size_t component = 0; component < components; ++component) {
      planes[component * places.size() + i] = values[component];
    }
  }
  return planes;
}

inline Range range_of(std::span<const float> planes, std::size_t points) {
  Range range;
  for (const float value : planes.first(points)) {
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
  }
  return range;
}

}  // namespace hashnoise::twin
