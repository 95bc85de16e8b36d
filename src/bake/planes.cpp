#include "bake/planes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "bake/positions.hpp"
#include "base/text.hpp"

namespace hn {
namespace {

// Points that a thread computes at a time. Few enough to stay in its cache.
constexpr std::size_t kBand = 16384;

// Where the points of a band are, along each axis.
template <int D>
class BandPoints {
 public:
  BandPoints(const std::array<Axis, D>& axes, bool as_floats) : axes_(axes), as_floats_(as_floats) {}

  // Places the rows from first up to and without end.
  void place(std::size_t first, std::size_t end) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      cell_[axis].clear();
      f_[axis].clear();
    }
    for (std::size_t row = first; row < end; ++row) {
      std::size_t rest = row;
      append_all(axes_[0]);
      for (std::size_t axis = 1; axis < D; ++axis) {
        append_one(axis, rest % axes_[axis].cell.size());
        rest /= axes_[axis].cell.size();
      }
    }
  }

  hashnoise::Range fill(const hashnoise::Field<D>& field, std::span<float> values) const {
    if (as_floats_) {
      hashnoise::Points<D> points;
      for (std::size_t axis = 0; axis < D; ++axis) points.p[axis] = f_[axis];
      return field.fill(points, values);
    }
    hashnoise::CellPoints<D> points;
    for (std::size_t axis = 0; axis < D; ++axis) {
      points.cell[axis] = cell_[axis];
      points.f[axis] = f_[axis];
    }
    return field.fill(points, values);
  }

 private:
  void append_all(const Axis& axis) {
    const std::vector<float>& places = as_floats_ ? axis.p : axis.f;
    cell_[0].insert(cell_[0].end(), axis.cell.begin(), axis.cell.end());
    f_[0].insert(f_[0].end(), places.begin(), places.end());
  }
  void append_one(std::size_t axis, std::size_t index) {
    const std::vector<float>& places = as_floats_ ? axes_[axis].p : axes_[axis].f;
    cell_[axis].insert(cell_[axis].end(), axes_[0].cell.size(), axes_[axis].cell[index]);
    f_[axis].insert(f_[axis].end(), axes_[0].cell.size(), places[index]);
  }

  const std::array<Axis, D>& axes_;
  bool as_floats_;
  std::array<std::vector<std::int32_t>, D> cell_;
  std::array<std::vector<float>, D> f_;
};

template <int D>
Planes compute_in(const BakeOptions& options, const RowsDone& rows_done) {
  const hashnoise::Field<D> field(options.settings);
  const auto components = static_cast<std::size_t>(field.component_count());
  const auto names = field.components();
  const auto chosen = chosen_components(names, options);
  std::array<Axis, D> axes;
  std::size_t rows = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    axes[axis] = axis_of(options.origin[axis], options.cells[axis], options.size[axis]);
    if (axis > 0) rows *= static_cast<std::size_t>(options.size[axis]);
  }
  const auto width = static_cast<std::size_t>(options.size[0]);

  Planes planes;
  planes.instruction_set = field.instruction_set();
  for (const std::size_t component : chosen)
    planes.planes.push_back({names[component], std::vector<float>(width * rows), {}});

  // The forms of fbm with a detail or a footprint take floats.
  const bool as_floats = options.settings.detail || options.settings.footprint;
  const std::size_t band = std::max<std::size_t>(kBand / width, 1);
  const auto bands = static_cast<int>((rows + band - 1) / band);
  hashnoise::threads(options.threads)(bands, [&](int number) {
    const std::size_t first = static_cast<std::size_t>(number) * band;
    const std::size_t end = std::min(first + band, rows);
    const std::size_t points = (end - first) * width;
    BandPoints<D> place(axes, as_floats);
    place.place(first, end);
    std::vector<float> values(components * points);
    place.fill(field, values);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(chosen[i] * points);
      std::copy_n(from, points, planes.planes[i].values.begin() + static_cast<std::ptrdiff_t>(first * width));
    }
    if (rows_done) rows_done(end - first);
  });
  for (Plane& plane : planes.planes) plane.range = range_of(plane.values);
  return planes;
}

template <int D>
std::vector<std::string> component_names_in(const BakeOptions& options) {
  const hashnoise::Field<D> field(options.settings);
  const auto names = field.components();
  std::vector<std::string> chosen;
  for (const std::size_t component : chosen_components(names, options)) chosen.push_back(names[component]);
  return chosen;
}

}  // namespace

std::vector<std::size_t> chosen_components(const std::vector<std::string>& names, const BakeOptions& options) {
  std::vector<std::size_t> chosen;
  for (const std::string& wanted : options.components) {
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) {
      throw std::invalid_argument(fmt::format("--components: {} has no component {}; it has {}", options.function,
                                              in_quotes(wanted), fmt::join(names, ", ")));
    }
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (std::ranges::count(chosen, index) != 0) {
      throw std::invalid_argument(fmt::format("--components: {} stands there twice", wanted));
    }
    chosen.push_back(index);
  }
  if (chosen.empty()) {
    for (std::size_t i = 0; i < names.size(); ++i) chosen.push_back(i);
  }
  return chosen;
}

hashnoise::Range range_of(std::span<const float> values) {
  hashnoise::Range range;
  for (const float value : values) {
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
  }
  return range;
}

std::vector<std::string> component_names(const BakeOptions& options) {
  switch (options.size.size()) {
    case 1:
      return component_names_in<1>(options);
    case 2:
      return component_names_in<2>(options);
    case 3:
      return component_names_in<3>(options);
    default:
      return component_names_in<4>(options);
  }
}

Planes compute(const BakeOptions& options, const RowsDone& rows_done) {
  switch (options.size.size()) {
    case 1:
      return compute_in<1>(options, rows_done);
    case 2:
      return compute_in<2>(options, rows_done);
    case 3:
      return compute_in<3>(options, rows_done);
    default:
      return compute_in<4>(options, rows_done);
  }
}

}  // namespace hn
