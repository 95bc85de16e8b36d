#include <algorithm>
#include <cmath>
#include <hashnoise/field.hpp>
#include <stdexcept>

#include "plan.hpp"
#include "rules.hpp"

namespace hashnoise::inline HN_I_LIBRARY {

template <int D>
struct Field<D>::Plan : grid::Plan {};

namespace {

using grid::Batch;
using grid::Kernel;
using grid::kMostComponents;
using grid::kMostLanes;
using grid::Loops;
using grid::Plan;

constexpr std::int64_t kTask = 65536;  // points; long enough that threads do not wait for each other
constexpr int kBlock = 1024;           // points whose coordinates stay in the first cache
constexpr int kNarrow = 64;            // a row with fewer points is not worth a batch of its own

// Runs a kernel over any number of points. The last ones, which do not fill the lanes, are computed in a place of their
// own, where the last one fills them.
void run(const Plan& plan, Kernel kernel, Batch batch, int count) {
  const int rest = count % kMostLanes;
  batch.count = count - rest;
  if (batch.count > 0) kernel(batch, plan.options, plan.octave);
  if (rest == 0) return;
  std::int32_t cell[4][kMostLanes] = {};
  float place[4][kMostLanes] = {};
  float value[kMostComponents][kMostLanes];
  Batch own = batch;
  own.count = kMostLanes;
  for (int axis = 0; axis < plan.dimensions; ++axis) {
    const int numbers = batch.stride[axis] == 0 ? kMostLanes : rest;
    const auto take = [&](const auto* from, auto& to) {
      std::fill_n(std::copy_n(from + batch.count * batch.stride[axis], numbers, to), kMostLanes - numbers,
                  to[numbers - 1]);
      return to;
    };
    own.place[axis] = take(batch.place[axis], place[axis]);
    if (batch.cell[axis] != nullptr) own.cell[axis] = take(batch.cell[axis], cell[axis]);
  }
  for (int i = 0; i < plan.components; ++i) own.value[i] = value[i];
  kernel(own, plan.options, plan.octave);
  for (int i = 0; i < plan.components; ++i) std::copy_n(value[i], rest, batch.value[i] + batch.count);
}

// Where values go: a plane for each component.
struct Planes {
  float* first;
  std::size_t size;

  void point(Batch& batch, int components, std::size_t at) const {
    for (int i = 0; i < components; ++i) batch.value[i] = first + static_cast<std::size_t>(i) * size + at;
  }
};

// The coordinates along an axis of a grid. For a sum at positions the cells are left out.
struct Axis {
  std::vector<std::int32_t> cell;
  std::vector<float> place;
};

std::size_t padded(std::size_t count) { return count + kMostLanes; }

void refuse_if(const std::string& problem) {
  if (!problem.empty()) throw std::invalid_argument(problem);
}

// The last point has a number, too, and the sum of both is an int.
void check_first(int first, int size) {
  const int least = -static_cast<int>(grid::kSizeRule.most);
  const int most = -least - size;
  if (first >= least && first <= most) return;
  throw std::invalid_argument("first is " + std::to_string(first) + ", and has to be from " + std::to_string(least) +
                              " to " + std::to_string(most) + " where the size is " + std::to_string(size));
}

void check_finite(const char* what, double number) {
  if (!std::isfinite(number)) throw std::invalid_argument(std::string(what) + " of a grid has to be finite");
}

Axis axis_of(const Plan& plan, float origin, float step, int size, int first) {
  check_finite("the origin", origin);
  check_finite("the step", step);
  check_finite("the first point", static_cast<double>(detail::position_of(origin, step, first)));
  check_finite("the last point", static_cast<double>(detail::position_of(origin, step, first + size)));
  std::vector<float> positions(padded(static_cast<std::size_t>(size)));
  for (int i = 0; i < size; ++i) {
    positions[static_cast<std::size_t>(i)] = detail::position_of(origin, step, first + i);
  }
  if (plan.takes_positions) return {{}, std::move(positions)};
  Axis axis{std::vector<std::int32_t>(positions.size()), std::vector<float>(positions.size())};
  plan.kernels->split(positions.data(), static_cast<int>(positions.size()) / kMostLanes * kMostLanes, axis.cell.data(),
                      axis.place.data());
  return axis;
}

Axis axis_of(std::int32_t cell, float f, double step, int size, int first) {
  if (!(f >= 0.0f && f <= 1.0f)) {  // for NaN, too
    throw std::invalid_argument("f of a grid is " + grid::digits_of(static_cast<double>(f)) +
                                ", and has to be from 0 to 1");
  }
  check_finite("the step", step);
  if (std::abs(step) >= 2147483648.0) throw std::invalid_argument("the step of a grid has to be less than 2^31 cells");
  Axis axis;
  axis.cell.resize(padded(static_cast<std::size_t>(size)));
  axis.place.resize(axis.cell.size());
  for (int i = 0; i < size; ++i) {
    const detail::CellAndPlace at = detail::cell_and_place_of(cell, f, step, first + i);
    axis.cell[static_cast<std::size_t>(i)] = at.cell;
    axis.place[static_cast<std::size_t>(i)] = at.f;
  }
  return axis;
}

// Sets how far points of a row are from each other. Cell grids cut places off to multiples of 2^-24. Floats are wider
// apart the further out they are, and from 2^23 on they are whole numbers, and positions leap.
template <int D>
void set_step(const CellGrid<D>& grid, Batch& row) {
  row.step = std::abs(grid.step[0]);
  row.rounding = 0x1p-24;
}
template <int D>
void set_step(const Grid<D>& grid, Batch& row) {
  const auto size_at = [&](int i) { return std::abs(detail::position_of(grid.origin[0], grid.step[0], i)); };
  const float furthest = std::max({size_at(grid.first[0]), size_at(grid.first[0] + grid.size[0] - 1), 1.0f});
  if (furthest >= 0x1p23f) return;
  row.step = static_cast<double>(std::abs(grid.step[0]));
  row.rounding = static_cast<double>(furthest) * 0x1p-23;
}

// The ranges of some of the values each, by lanes: joined for each row, they would cost as much as the noise of a short
// one (with AVX-512 a grid of value noise in space took 1.6 times as long).
struct Ranges {
  float least[kMostLanes];
  float greatest[kMostLanes];

  Ranges() {
    std::fill_n(least, kMostLanes, Range{}.least);
    std::fill_n(greatest, kMostLanes, Range{}.greatest);
  }
  void widen(const Plan& plan, const float* values, int count) { plan.kernels->widen(values, count, least, greatest); }
  Range joined() const {
    return {*std::min_element(least, least + kMostLanes), *std::max_element(greatest, greatest + kMostLanes)};
  }
};

// Runs tasks of points, and joins their ranges. The order does not change the result.
template <typename Task>
Range run_tasks(std::int64_t count, const Executor& executor, const Task& task) {
  if (count > std::numeric_limits<int>::max()) throw std::invalid_argument("there are too many points");
  std::vector<Range> ranges(static_cast<std::size_t>(count));
  const auto one = [&](int i) {
    Ranges of_task;
    task(i, of_task);
    ranges[static_cast<std::size_t>(i)] = of_task.joined();
  };
  if (executor && count > 1) {
    executor(static_cast<int>(count), one);
  } else {
    for (int i = 0; i < count; ++i) one(i);
  }
  Range range;
  for (const Range& r : ranges) {
    range.least = std::min(range.least, r.least);
    range.greatest = std::max(range.greatest, r.greatest);
  }
  return range;
}

struct Box {
  const Plan& plan;
  Loops loops;
  std::array<int, 4> size;
  Batch blank;  // of a row, without its points
  std::vector<Axis> axes;
  Planes planes;

  bool has_cells() const { return !axes.front().cell.empty(); }

  // Coordinates of the row with that number along all axes but x.
  std::array<std::size_t, 4> row_at(std::int64_t number) const {
    std::array<std::size_t, 4> at{};
    for (std::size_t axis = 1; axis < axes.size(); ++axis) {
      at[axis] = static_cast<std::size_t>(number % size[axis]);
      number /= size[axis];
    }
    return at;
  }

  void run_row(std::int64_t number, int first, int count, Ranges& ranges) const {
    const std::array<std::size_t, 4> at = row_at(number);
    std::int32_t cell[4][kMostLanes];
    float place[4][kMostLanes];
    Batch batch = blank;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      if (axis == 0) {
        batch.place[0] = axes[0].place.data() + first;
        if (has_cells()) batch.cell[0] = axes[0].cell.data() + first;
        batch.stride[0] = 1;
        continue;
      }
      std::fill_n(place[axis], kMostLanes, axes[axis].place[at[axis]]);
      batch.place[axis] = place[axis];
      if (!has_cells()) continue;
      std::fill_n(cell[axis], kMostLanes, axes[axis].cell[at[axis]]);
      batch.cell[axis] = cell[axis];
    }
    const std::size_t start = static_cast<std::size_t>(number) * static_cast<std::size_t>(size[0]);
    planes.point(batch, plan.components, start + static_cast<std::size_t>(first));
    run(plan, loops.row, batch, count);
    ranges.widen(plan, batch.value[0], count);
  }

  // Points of several rows.
  void run_points(std::int64_t first, int count, Ranges& ranges) const {
    std::int32_t cell[4][kBlock + kMostLanes];
    float place[4][kBlock + kMostLanes];
    std::array<std::size_t, 4> at = row_at(first / size[0]);
    at[0] = static_cast<std::size_t>(first % size[0]);
    for (int i = 0; i < count; ++i) {
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        place[axis][i] = axes[axis].place[at[axis]];
        if (has_cells()) cell[axis][i] = axes[axis].cell[at[axis]];
      }
      for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (++at[axis] < static_cast<std::size_t>(size[axis])) break;
        at[axis] = 0;
      }
    }
    Batch batch{};
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      batch.place[axis] = place[axis];
      if (has_cells()) batch.cell[axis] = cell[axis];
      batch.stride[axis] = 1;
    }
    planes.point(batch, plan.components, static_cast<std::size_t>(first));
    run(plan, loops.points, batch, count);
    ranges.widen(plan, batch.value[0], count);
  }

  Range fill(std::int64_t points, const Executor& executor) const {
    // A narrow part of a grid has the bits of the whole, so it takes the kernel of that.
    const bool has_kernel_of_rows = loops.row != loops.points && plan.may_fuse;
    if (size[0] < kNarrow && !has_kernel_of_rows) {
      return run_tasks((points + kTask - 1) / kTask, executor, [&](std::int64_t task, Ranges& ranges) {
        const std::int64_t end = std::min(points, (task + 1) * kTask);
        for (std::int64_t i = task * kTask; i < end; i += kBlock) {
          run_points(i, static_cast<int>(std::min<std::int64_t>(kBlock, end - i)), ranges);
        }
      });
    }
    // Short rows are taken several at a time, and long ones in parts.
    const std::int64_t rows = points / size[0];
    const std::int64_t parts = (size[0] + kTask - 1) / kTask;
    const std::int64_t at_a_time = std::max<std::int64_t>(1, kTask / size[0]);
    return run_tasks((rows + at_a_time - 1) / at_a_time * parts, executor, [&](std::int64_t task, Ranges& ranges) {
      const std::int64_t first = task % parts * kTask;
      const int count = static_cast<int>(std::min<std::int64_t>(kTask, size[0] - first));
      const std::int64_t end = std::min(rows, (task / parts + 1) * at_a_time);
      for (std::int64_t i = task / parts * at_a_time; i < end; ++i) run_row(i, static_cast<int>(first), count, ranges);
    });
  }
};

void check_values(const Plan& plan, std::size_t points, std::size_t values) {
  const std::size_t needed = points * static_cast<std::size_t>(plan.components);
  if (values == needed) return;
  throw std::invalid_argument("there is room for " + std::to_string(values) + " values, and there have to be " +
                              std::to_string(needed) + ": " + std::to_string(plan.components) + " at each of " +
                              std::to_string(points) + " points");
}

const Loops& in_cells(const Plan& plan) {
  if (plan.in.points == nullptr) {
    throw std::invalid_argument("detail and footprint need positions, and there are cells");
  }
  const grid::Rule rule = {"lacunarity", false, 0.0, grid::kMostLacunarity, 2.0};
  const std::string problem = grid::problem_of(rule, static_cast<double>(plan.options.lacunarity));
  if (plan.takes_positions && !problem.empty()) refuse_if(problem + " in cells");
  return plan.in;
}

template <std::size_t D>
std::int64_t points_of(const std::array<int, D>& size) {
  std::int64_t points = 1;
  for (const int n : size) {
    refuse_if(grid::problem_of(grid::kSizeRule, n));
    if (n > 0 && points > (std::int64_t{1} << 48) / n) throw std::invalid_argument("a grid has too many points");
    points *= n;
  }
  return points;
}

// The points of a grid, by the axes that axis_at gives. It is checked before its coordinates are computed, which may be
// many.
template <int D, typename AnyGrid, typename AxisAt>
Range fill_grid(const Plan& plan, const Loops& loops, const AnyGrid& grid, std::span<float> values,
                const Executor& executor, const AxisAt& axis_at) {
  const std::int64_t points = points_of(grid.size);
  for (std::size_t axis = 0; axis < D; ++axis) check_first(grid.first[axis], grid.size[axis]);
  check_values(plan, static_cast<std::size_t>(points), values.size());
  if (points == 0) return {};
  Box box{plan, loops, {}, {}, {}, {values.data(), static_cast<std::size_t>(points)}};
  std::copy(grid.size.begin(), grid.size.end(), box.size.begin());
  for (std::size_t axis = 0; axis < D; ++axis) box.axes.push_back(axis_at(axis));
  set_step(grid, box.blank);
  return box.fill(points, executor);
}

// No number comes out where a coordinate is none, or infinite. Kernels would make one of it: HN_FIXED, whose fractions
// are integers, and what looks for the nearest point or has a cell alone.
void spread_nan(const Plan& plan, const float* coordinates, int count, const Batch& batch) {
  if (plan.kernels->are_finite(coordinates, count)) return;
  for (int i = 0; i < count; ++i) {
    if (std::isfinite(coordinates[i])) continue;
    for (int n = 0; n < plan.components; ++n) batch.value[n][i] = std::numeric_limits<float>::quiet_NaN();
  }
}

template <typename Spans>
std::size_t common_length(const Spans& spans, std::size_t length) {
  for (const auto& span : spans) {
    if (span.size() != length) {
      throw std::invalid_argument("the arrays of points have " + std::to_string(length) + " and " +
                                  std::to_string(span.size()) + " numbers, and have to have as many for each axis");
    }
  }
  return length;
}

// Points in an array for each axis: positions, or cells and places in them.
template <std::size_t D>
Range fill_points(const Plan& plan, Kernel kernel, const std::array<std::span<const std::int32_t>, D>* cells,
                  const std::array<std::span<const float>, D>& places, std::span<float> values,
                  const Executor& executor) {
  const std::size_t count = common_length(places, places[0].size());
  if (cells != nullptr) common_length(*cells, count);
  check_values(plan, count, values.size());
  const Planes planes{values.data(), count};
  const auto points = static_cast<std::int64_t>(count);
  return run_tasks((points + kTask - 1) / kTask, executor, [&](std::int64_t task, Ranges& ranges) {
    const std::int64_t end = std::min(points, (task + 1) * kTask);
    for (std::int64_t i = task * kTask; i < end; i += kBlock) {
      const int n = static_cast<int>(std::min<std::int64_t>(kBlock, end - i));
      Batch batch{};
      planes.point(batch, plan.components, static_cast<std::size_t>(i));
      for (std::size_t axis = 0; axis < D; ++axis) {
        batch.stride[axis] = 1;
        if (cells != nullptr) batch.cell[axis] = (*cells)[axis].data() + i;
        batch.place[axis] = places[axis].data() + i;
      }
      run(plan, kernel, batch, n);
      for (const auto& axis : places) spread_nan(plan, axis.data() + i, n, batch);
      ranges.widen(plan, batch.value[0], n);
    }
  });
}

}  // namespace

template <int D>
Field<D>::Field(const Settings& settings) : Field(settings, {}) {}
template <int D>
Field<D>::Field(const Settings& settings, const MoreSettings& more)
    : plan_(new Plan{grid::plan_of(D, settings, more)}) {}
template <int D>
Field<D>::~Field() = default;
template <int D>
Field<D>::Field(Field&&) noexcept = default;
template <int D>
Field<D>& Field<D>::operator=(Field&&) noexcept = default;

template <int D>
int Field<D>::component_count() const {
  return plan_->components;
}

template <int D>
std::vector<std::string> Field<D>::components() const {
  return grid::components_of(plan_->shape, D);
}

template <int D>
InstructionSet Field<D>::instruction_set() const {
  return plan_->set;
}

template <int D>
Range Field<D>::fill(const Grid<D>& grid, std::span<float> values, const Executor& executor) const {
  return fill_grid<D>(*plan_, plan_->takes_positions ? plan_->at : plan_->in, grid, values, executor,
                      [&](std::size_t axis) {
                        return axis_of(*plan_, grid.origin[axis], grid.step[axis], grid.size[axis], grid.first[axis]);
                      });
}

template <int D>
Range Field<D>::fill(const CellGrid<D>& grid, std::span<float> values, const Executor& executor) const {
  return fill_grid<D>(*plan_, in_cells(*plan_), grid, values, executor, [&](std::size_t axis) {
    return axis_of(grid.cell[axis], grid.f[axis], grid.step[axis], grid.size[axis], grid.first[axis]);
  });
}

template <int D>
Range Field<D>::fill(const Points<D>& points, std::span<float> values, const Executor& executor) const {
  const Loops& loops = plan_->takes_positions ? plan_->at : plan_->in;
  return fill_points<D>(*plan_, loops.points, nullptr, points.p, values, executor);
}

template <int D>
Range Field<D>::fill(const CellPoints<D>& points, std::span<float> values, const Executor& executor) const {
  return fill_points<D>(*plan_, in_cells(*plan_).points, &points.cell, points.f, values, executor);
}

template class Field<1>;
template class Field<2>;
template class Field<3>;
template class Field<4>;

}  // namespace hashnoise::inline HN_I_LIBRARY
