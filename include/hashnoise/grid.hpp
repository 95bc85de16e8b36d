// Any noise, of the library or your own, over grids and lists of points; header only. field.hpp has the same for noises
// that are chosen at run time, and takes the widest instructions that the processor has.
// SPDX-License-Identifier: MIT
//
//   #include <hashnoise/grid.hpp>
//   namespace lanes = hashnoise::lanes;
//
//   std::vector<float> heights(1024 * 1024);
//   const hashnoise::Grid<2> grid{{0, 0}, {0.01f, 0.01f}, {1024, 1024}};
//   lanes::fill(grid, heights, [](lanes::vec2 p) { return lanes::hn_fbm(p, 6, 2.0f, 0.5f, 7u); });
//
// `fill` calls the noise with the points of all lanes: fill(Grid or Points, values, noise) with positions, and
// fill(CellGrid or CellPoints, values, noise) with cells and places in them. The noise returns a Float, or a vector
// whose components go to planes of their own: `values` has all of the first component, then all of the second. `fill`
// returns the least and the greatest number of the first component.
//
// Sizes that do not fit are a std::invalid_argument; with -fno-exceptions `fill` prints the error, and aborts. It
// checks no origin, step or coordinate: of those that are not finite no value is defined.
//
// The instructions are those that the flags of the compiler allow. lanes.hpp describes what a noise over lanes may do,
// and hashnoise.hpp which knobs there are.

#include "lanes.hpp"  // each time, since it compares the knobs
#include "points.hpp"

#ifndef HN_I_GRID_HPP
#define HN_I_GRID_HPP

// clang-format off
#include "../../glsl/hashnoise/detail/macros_begin.h"
// clang-format on

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace hashnoise::inline HN_I_NAMESPACE {

namespace detail {

[[noreturn]] inline void refuse(const char* why) {
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
  throw std::invalid_argument(why);
#else
  std::fprintf(stderr, "hashnoise: %s\n", why);
  std::abort();
#endif
}

}  // namespace detail

namespace HN_LANES {

namespace detail {

template <typename Value>
constexpr std::size_t kPlanes = 1;
template <>
inline constexpr std::size_t kPlanes<vec2> = 2;
template <>
inline constexpr std::size_t kPlanes<vec3> = 3;
template <>
inline constexpr std::size_t kPlanes<vec4> = 4;

// Computes `count` points behind each other; value(i) is that of the lanes from point i on. The last points, which do
// not fill the lanes, are computed once more together with those before them; where there are none, value(0) has to
// bear lanes without a point.
template <typename Value>
class Writer {
 public:
  using Result = std::remove_cvref_t<std::invoke_result_t<Value, std::size_t>>;

  Writer(std::span<float> values, std::size_t points) {
    if (values.size() != points * kPlanes<Result>) {
      hashnoise::detail::refuse("fill: the size of the values is not that of the points times the components");
    }
    for (std::size_t i = 0; i < kPlanes<Result>; ++i) planes_[i] = values.data() + i * points;
  }

  // Writes from point `first` of the planes on.
  void write(std::size_t first, std::size_t count, const Value& value) {
    constexpr auto lanes = static_cast<std::size_t>(kCount);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) keep(first + i, value(i));
    if (i == count) return;
    if (count >= lanes) {
      keep(first + count - lanes, value(count - lanes));
      return;
    }
    float rest[4][lanes];
    float* const rests[4] = {rest[0], rest[1], rest[2], rest[3]};
    store(rests, 0, value(0));
    for (std::size_t plane = 0; plane < kPlanes<Result>; ++plane) {
      std::copy_n(rest[plane], count, planes_[plane] + first);
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) rest[0][lane] = rest[0][std::min(lane, count - 1)];
    widen(Float::load(rest[0]));
  }

  Range range() const {
    Range range;
    for (int lane = 0; lane < kCount; ++lane) {
      range.least = std::min(range.least, least_[lane]);
      range.greatest = std::max(range.greatest, greatest_[lane]);
    }
    return range;
  }

 private:
  HN_I_INLINE void keep(std::size_t i, Result n) {
    store(planes_.data(), i, n);
    if constexpr (kPlanes<Result> == 1) {
      widen(n);
    } else {
      widen(n.x);
    }
  }
  HN_I_INLINE void widen(Float n) {
    least_ = min(least_, n);
    greatest_ = max(greatest_, n);
  }

  std::array<float*, 4> planes_{};
  Float least_ = Range{}.least;
  Float greatest_ = Range{}.greatest;
};

// The coordinates of a grid along an axis, with room for the lanes of the last point.
struct Positions {
  std::vector<float> p;

  Positions(float origin, float step, int size, int first) : p(static_cast<std::size_t>(size + kCount)) {
    for (int i = 0; i < size; ++i) {
      p[static_cast<std::size_t>(i)] = hashnoise::detail::position_of(origin, step, first + i);
    }
  }
};
struct CellsAndPlaces {
  std::vector<std::int32_t> cell;
  std::vector<float> f;

  CellsAndPlaces(std::int32_t first_cell, float place, double step, int size, int first)
      : cell(static_cast<std::size_t>(size + kCount)), f(cell.size()) {
    for (int i = 0; i < size; ++i) {
      const auto at = hashnoise::detail::cell_and_place_of(first_cell, place, step, first + i);
      cell[static_cast<std::size_t>(i)] = at.cell;
      f[static_cast<std::size_t>(i)] = at.f;
    }
  }
};

// Whether a grid has points. Checked before their coordinates are computed, which may be many: values for all of them.
template <std::size_t D>
bool has_points(const std::array<int, D>& size, const std::array<int, D>& first, std::span<float> values) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (size[axis] < 0 || size[axis] >= 1 << 29) {
      hashnoise::detail::refuse("fill: a size of the grid is not from 0 to 536870911");
    }
    if (first[axis] <= -(1 << 29) || first[axis] >= (1 << 29) - size[axis]) {
      hashnoise::detail::refuse("fill: the first or the last point of the grid is not from -536870911 to 536870910");
    }
  }
  if (std::find(size.begin(), size.end(), 0) != size.end()) {
    if (!values.empty()) hashnoise::detail::refuse("fill: there are values and no points");
    return false;
  }
  std::size_t points = 1;
  for (const int n : size) {
    if (points > values.size() / static_cast<std::size_t>(n)) {
      hashnoise::detail::refuse("fill: the values have no room for the points of the grid");
    }
    points *= static_cast<std::size_t>(n);
  }
  return true;
}

// Rows along x of a grid of D dimensions; value(at, i) is that of the lanes from point i of the row at `at` on.
template <std::size_t D, typename Value>
Range fill_rows(const std::array<int, D>& size, std::span<float> values, const Value& value) {
  std::size_t rows = 1;
  for (std::size_t axis = 1; axis < D; ++axis) rows *= static_cast<std::size_t>(size[axis]);
  const auto width = static_cast<std::size_t>(size[0]);
  std::array<std::size_t, D> at{};
  const auto in_row = [&](std::size_t i) HN_I_INLINED { return value(at, i); };
  Writer<decltype(in_row)> writer(values, rows * width);
  for (std::size_t row = 0; row < rows; ++row) {
    writer.write(row * width, width, in_row);
    for (std::size_t axis = 1; axis < D; ++axis) {
      if (++at[axis] < static_cast<std::size_t>(size[axis])) break;
      at[axis] = 0;
    }
  }
  return writer.range();
}

template <std::size_t D, typename Coordinates, typename... Arguments>
std::vector<Coordinates> axes_of(const Arguments&... arguments) {
  std::vector<Coordinates> axes;
  for (std::size_t axis = 0; axis < D; ++axis) axes.emplace_back(arguments[axis]...);
  return axes;
}

template <typename Spans>
std::size_t common_length(const Spans& spans) {
  for (const auto& span : spans) {
    if (span.size() != spans[0].size()) hashnoise::detail::refuse("fill: the arrays of points differ in length");
  }
  return spans[0].size();
}

// Lanes of an array from i on. Behind its end there are zeros.
template <typename Number>
HN_I_INLINE Lanes<Number> load_some(std::span<const Number> numbers, std::size_t i) {
  constexpr auto lanes = static_cast<std::size_t>(kCount);
  if (i + lanes <= numbers.size()) return Lanes<Number>::load(numbers.data() + i);
  Number rest[lanes] = {};
  std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(i), numbers.end(), rest);
  return Lanes<Number>::load(rest);
}

}  // namespace detail

template <int D, typename Noise>
Range fill(const Grid<D>& grid, std::span<float> values, const Noise& noise) {
  if (!detail::has_points(grid.size, grid.first, values)) return {};
  const auto axes = detail::axes_of<D, detail::Positions>(grid.origin, grid.step, grid.size, grid.first);
  return detail::fill_rows(grid.size, values, [&](const auto& at, std::size_t i) HN_I_INLINED {
    return noise(vector_of<PlaceOf<D>, D>([&](int axis) HN_I_INLINED {
      const auto a = static_cast<std::size_t>(axis);
      return a == 0 ? Float::load(axes[0].p.data() + i) : Float(axes[a].p[at[a]]);
    }));
  });
}

template <int D, typename Noise>
Range fill(const CellGrid<D>& grid, std::span<float> values, const Noise& noise) {
  if (!detail::has_points(grid.size, grid.first, values)) return {};
  const auto axes = detail::axes_of<D, detail::CellsAndPlaces>(grid.cell, grid.f, grid.step, grid.size, grid.first);
  return detail::fill_rows(grid.size, values, [&](const auto& at, std::size_t i) HN_I_INLINED {
    return noise(vector_of<CellOf<D>, D>([&](int axis) HN_I_INLINED {
                   const auto a = static_cast<std::size_t>(axis);
                   return a == 0 ? Int::load(axes[0].cell.data() + i) : Int(axes[a].cell[at[a]]);
                 }),
                 vector_of<PlaceOf<D>, D>([&](int axis) HN_I_INLINED {
                   const auto a = static_cast<std::size_t>(axis);
                   return a == 0 ? Float::load(axes[0].f.data() + i) : Float(axes[a].f[at[a]]);
                 }));
  });
}

template <int D, typename Noise>
Range fill(const Points<D>& points, std::span<float> values, const Noise& noise) {
  const std::size_t count = detail::common_length(points.p);
  const auto value = [&](std::size_t i) HN_I_INLINED {
    return noise(vector_of<PlaceOf<D>, D>(
        [&](int axis) HN_I_INLINED { return detail::load_some(points.p[static_cast<std::size_t>(axis)], i); }));
  };
  detail::Writer<decltype(value)> writer(values, count);
  writer.write(0, count, value);
  return writer.range();
}

template <int D, typename Noise>
Range fill(const CellPoints<D>& points, std::span<float> values, const Noise& noise) {
  const std::size_t count = detail::common_length(points.cell);
  if (detail::common_length(points.f) != count) {
    hashnoise::detail::refuse("fill: the arrays of points differ in length");
  }
  const auto value = [&](std::size_t i) HN_I_INLINED {
    return noise(vector_of<CellOf<D>, D>([&](int axis) HN_I_INLINED {
                   return detail::load_some(points.cell[static_cast<std::size_t>(axis)], i);
                 }),
                 vector_of<PlaceOf<D>, D>([&](int axis) HN_I_INLINED {
                   return detail::load_some(points.f[static_cast<std::size_t>(axis)], i);
                 }));
  };
  detail::Writer<decltype(value)> writer(values, count);
  writer.write(0, count, value);
  return writer.range();
}

}  // namespace HN_LANES
}  // namespace hashnoise

#include "../../glsl/hashnoise/detail/macros_end.h"

#endif
