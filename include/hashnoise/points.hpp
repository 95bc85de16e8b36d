// The points of a field: uniform grids and lists of points, in one to four dimensions.
// SPDX-License-Identifier: MIT

#pragma once

#include "glsl.hpp"  // the first, since it refuses compilers before C++20

// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
// clang-format on

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace hashnoise::inline HN_I_LIBRARY {

template <typename T, int D>
using PerAxis = std::array<T, static_cast<std::size_t>(D)>;

// A uniform grid at positions of floats.
//   origin  the first point, in cells
//   step    from point to point along each axis, in cells
//   size    points along each axis, less than 2^29
//   first   the number of the first point along each axis, more than -2^29: then this is a part of a larger grid, and
//           has the bits that the larger one has there. first + size is less than 2^29
// Point i along an axis is at the float nearest to origin + (first + i) * step, as computed in doubles, so that errors
// do not add up. Values are stored with x fastest, then y, then z, then w.
template <int D>
struct Grid {
  PerAxis<float, D> origin{};
  PerAxis<float, D> step{};
  PerAxis<int, D> size{};
  PerAxis<int, D> first{};
};

// A uniform grid from a cell and a position in it: exact however far out, and no two points fall together.
//   cell    the cell of the first point; cells wrap at 2^32
//   f       its position in the cell, in [0, 1]; else Field throws, and lanes::fill takes the nearer end
//   step    from point to point along each axis, in cells; rounded to a multiple of 2^-32, and less than 2^31
//   size    points along each axis, less than 2^29
//   first   as of Grid
// Point i is in the cell and at the place that cell + f + (first + i) * step is, where the place is cut off to a
// multiple of 2^-24.
template <int D>
struct CellGrid {
  PerAxis<std::int32_t, D> cell{};
  PerAxis<float, D> f{};
  PerAxis<double, D> step{};
  PerAxis<int, D> size{};
  PerAxis<int, D> first{};
};

// Points at positions, in cells: an array of coordinates for each axis, all of the same length. Columns makes these of
// points that lie one behind the other.
template <int D>
struct Points {
  PerAxis<std::span<const float>, D> p{};
};

// Points as cells and positions in them, in [0, 1]. Outside of it HN_FIXED takes the nearer end, and for floats no
// value is defined.
template <int D>
struct CellPoints {
  PerAxis<std::span<const std::int32_t>, D> cell{};
  PerAxis<std::span<const float>, D> f{};
};

// The least and the greatest value. Without values it is (infinity, -infinity).
struct Range {
  float least = std::numeric_limits<float>::infinity();
  float greatest = -std::numeric_limits<float>::infinity();
  friend bool operator==(const Range&, const Range&) = default;
};

}  // namespace hashnoise

namespace hashnoise::inline HN_I_NAMESPACE {

namespace detail {

// Accepts structs with [] or with x, y, z and w, and no others.
template <typename Point>
constexpr auto coordinate(const Point& point, [[maybe_unused]] std::size_t axis) {
  if constexpr (requires { point[axis]; }) {
    return point[axis];
  } else if constexpr (requires { point.w; }) {
    return axis == 0 ? point.x : axis == 1 ? point.y : axis == 2 ? point.z : point.w;
  } else if constexpr (requires { point.z; }) {
    return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
  } else if constexpr (requires { point.y; }) {
    return axis == 0 ? point.x : point.y;
  }
}

// Whether it has D numbers in it, and no pointer to any.
template <typename Point, int D>
constexpr bool is_point() {
  if constexpr (D > 1 && std::is_class_v<Point> && std::is_trivially_copyable_v<Point>) {
    using Number = decltype(coordinate(std::declval<const Point&>(), 0));
    constexpr bool is_span = requires(const Point& point) { point.subspan(0); };
    if constexpr (std::is_floating_point_v<Number> && !is_span) {
      return sizeof(Point) == sizeof(Number) * static_cast<std::size_t>(D);
    }
  }
  return false;
}

}  // namespace detail

// The arrays of Points, copied from points of D coordinates that lie one behind the other, in a std::vector or another
// container: std::array<float, 3>, hashnoise::vec3, or a struct of another library that has [] or x, y and z. Bare
// floats, and structs of more or fewer numbers, do not compile.
//
//   field.fill(hashnoise::Columns<3>(vertices).points(), heights);
template <int D>
class Columns {
 public:
  template <typename Container>
  requires(detail::is_point<typename Container::value_type, D>()) explicit Columns(const Container& points) {
    for (std::size_t axis = 0; axis < columns_.size(); ++axis) {
      columns_[axis].reserve(points.size());
      for (const auto& point : points) columns_[axis].push_back(static_cast<float>(detail::coordinate(point, axis)));
    }
  }

  // Valid as long as this is.
  Points<D> points() const {
    Points<D> all;
    for (std::size_t axis = 0; axis < columns_.size(); ++axis) all.p[axis] = columns_[axis];
    return all;
  }

 private:
  PerAxis<std::vector<float>, D> columns_;
};

}  // namespace hashnoise

// The rest belongs to the library: both kinds of grids are made of it.
namespace hashnoise::inline HN_I_NAMESPACE::detail {

// The coordinates of point i of a grid along an axis.
HN_I_INLINE float position_of(float origin, float step, int i) {
  // The product is exact, so that it does not matter whether it is contracted with the sum.
  return static_cast<float>(static_cast<double>(origin) + static_cast<double>(i) * static_cast<double>(step));
}

struct CellAndPlace {
  std::int32_t cell;
  float f;
};
HN_I_INLINE CellAndPlace cell_and_place_of(std::int32_t cell, float f, double step, int i) {
  constexpr double kUnit = 4294967296.0;  // 2^32
  const double inside = f > 0.0f ? (f < 1.0f ? static_cast<double>(f) : 1.0) : 0.0;
  // Modulo 2^64, as cells wrap.
  const std::uint64_t at = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell)) << 32u) +
                           static_cast<std::uint64_t>(inside * kUnit) +
                           static_cast<std::uint64_t>(std::llround(step * kUnit)) * static_cast<std::uint64_t>(i);
  return {static_cast<std::int32_t>(static_cast<std::uint32_t>(at >> 32u)),
          static_cast<float>(static_cast<std::uint32_t>(at) >> 8u) * (1.0f / 16777216.0f)};
}

}  // namespace hashnoise::detail

#include "../../glsl/hashnoise/detail/macros_end.h"
