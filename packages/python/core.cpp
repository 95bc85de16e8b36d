// The compiled part of the Python package: fields over NumPy's arrays. hashnoise/ has the interface that users see, and
// checks what they pass.
// SPDX-License-Identifier: MIT

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <hashnoise/detail/closest.hpp>
#include <hashnoise/field.hpp>
#include <hashnoise/points.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "grid/ranges.hpp"
#include "grid/rules.hpp"
#include "half.hpp"

namespace nb = nanobind;

namespace hashnoise::python {
namespace {

constexpr std::size_t kBlock = 4096;            // points that are copied at a time: they stay in the nearest caches
constexpr std::size_t kTask = 8 * kBlock;       // points that a thread takes at a time
constexpr std::size_t kWorthThreads = 1 << 17;  // points: below, starting threads takes too large a part of the time

using Pair = std::pair<float, float>;
using Ranges = std::vector<std::pair<double, double>>;

// 0 threads are as many as are worth it.
Executor executor(int count, std::size_t points) {
  if (count == 1 || (count == 0 && points < kWorthThreads)) return {};
  return threads(count);
}

template <class Task>
void run(const Executor& executor, std::size_t count, const Task& task) {
  if (executor && count <= static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    executor(static_cast<int>(count), [&](int i) { task(static_cast<std::size_t>(i)); });
    return;
  }
  for (std::size_t i = 0; i < count; ++i) task(i);
}

enum class Numbers { kFloat32, kFloat16, kUint16 };

inline Numbers numbers_of(const Memory& memory) {
  if (memory.holds("f", 4)) return Numbers::kFloat32;
  if (memory.holds("e", 2)) return Numbers::kFloat16;
  if (memory.holds("H", 2)) return Numbers::kUint16;
  throw std::invalid_argument("the result must be of float32, float16 or uint16");
}

// A result: planes of components, along its first axis.
class Planes {
 public:
  Planes(nb::handle array, int components) : memory_(array, PyBUF_RECORDS), numbers_(numbers_of(memory_)) {
    const Py_buffer& view = memory_.view();
    if (view.ndim < 1 || view.shape[0] != components) {
      throw std::invalid_argument("the first axis of the result must be that of the components");
    }
    shape_.assign(view.shape + 1, view.shape + view.ndim);
    for (const std::ptrdiff_t size : shape_) points_ *= static_cast<std::size_t>(size);
  }

  Numbers numbers() const { return numbers_; }
  std::size_t points() const { return points_; }
  const std::vector<std::ptrdiff_t>& shape() const { return shape_; }
  std::ptrdiff_t step() const { return memory_.view().strides[0]; }  // in bytes, from plane to plane

  // A plane as an array of its points.
  StridedArray first() const {
    const Py_buffer& view = memory_.view();
    StridedArray strided{static_cast<std::byte*>(view.buf), Kind::kFloat32, {}};
    strided.steps.assign(view.strides + 1, view.strides + view.ndim);
    return strided;
  }

  // All numbers, if they are as a field writes them: floats that lie one behind the other. Else none.
  std::span<float> whole() const {
    const Py_buffer& view = memory_.view();
    const bool is_aligned = reinterpret_cast<std::uintptr_t>(view.buf) % alignof(float) == 0;
    if (numbers_ != Numbers::kFloat32 || !is_aligned || !PyBuffer_IsContiguous(&view, 'C')) return {};
    return {static_cast<float*>(view.buf), static_cast<std::size_t>(view.shape[0]) * points_};
  }

 private:
  Memory memory_;
  Numbers numbers_;
  std::vector<std::ptrdiff_t> shape_{};
  std::size_t points_ = 1;
};

// Writes a line of values, `from_step` floats from each other, as numbers that are `step` bytes from each other.
template <class Convert>
void write_line(const float* from, std::size_t from_step, std::byte* to, std::ptrdiff_t step, std::size_t count,
                const Convert& convert) {
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(convert(0.0f)));
  const auto write = [&](std::size_t i, std::size_t from_at, std::ptrdiff_t to_at) {
    const auto number = convert(from[i * from_at]);
    std::memcpy(to + static_cast<std::ptrdiff_t>(i) * to_at, &number, sizeof number);
  };
  if (step == size && from_step == 1) {  // a loop of its own, which compilers vectorize
    for (std::size_t i = 0; i < count; ++i) write(i, 1, size);
  } else {
    for (std::size_t i = 0; i < count; ++i) write(i, from_step, step);
  }
}

// A part of a grid that is computed at a time, where the numbers of a grid are not those that a field writes: they go
// from there to their places.
template <int D>
struct Tile {
  std::array<int, D> first{};
  std::array<int, D> size{};

  std::size_t points() const {
    std::size_t points = 1;
    for (const int n : size) points *= static_cast<std::size_t>(n);
    return points;
  }
};

// Cuts a grid into such parts. They are long along the axis that is the nearest in the memory of the result, so that
// the results lie together, and along x, where a field is fast.
template <int D>
class Tiles {
 public:
  // `steps` are those of a plane of the result, along x first.
  Tiles(const std::array<int, D>& size, const std::array<std::ptrdiff_t, D>& steps) : size_(size) {
    for (std::size_t axis = 1; axis < D; ++axis) {
      const bool is_nearer = size_[nearest_] == 1 || std::abs(steps[axis]) < std::abs(steps[nearest_]);
      if (size_[axis] > 1 && is_nearer) nearest_ = axis;
    }
    tile_.fill(1);
    int room = kTilePoints;
    const auto take = [&](std::size_t axis, int most) {
      tile_[axis] = std::clamp(std::min(size_[axis], most), 1, room);
      room /= tile_[axis];
    };
    take(nearest_, nearest_ == 0 ? kTilePoints : kTileSide);
    if (nearest_ != 0) take(0, kTileWidth);
    for (std::size_t axis = 1; axis < D; ++axis) {
      if (axis != nearest_) take(axis, kTilePoints);
    }
    for (std::size_t axis = 0; axis < D; ++axis) {
      counts_[axis] = (static_cast<std::size_t>(size_[axis]) + static_cast<std::size_t>(tile_[axis]) - 1) /
                      static_cast<std::size_t>(tile_[axis]);
    }
  }

  std::size_t nearest() const { return nearest_; }
  std::size_t count() const {
    std::size_t count = 1;
    for (const std::size_t n : counts_) count *= n;
    return count;
  }
  Tile<D> operator[](std::size_t number) const {
    Tile<D> tile;
    for (std::size_t axis = 0; axis < D; ++axis) {
      tile.first[axis] = static_cast<int>(number % counts_[axis]) * tile_[axis];
      tile.size[axis] = std::min(tile_[axis], size_[axis] - tile.first[axis]);
      number /= counts_[axis];
    }
    return tile;
  }

 private:
  static constexpr int kTilePoints = 1 << 14;  // they stay in the second cache
  static constexpr int kTileSide = 144;
  static constexpr int kTileWidth = 112;  // a power of two would put all of a column into the same places of a cache

  std::array<int, D> size_;
  std::array<int, D> tile_{};
  std::array<std::size_t, D> counts_{};
  std::size_t nearest_ = 0;
};

// A field in as many dimensions as were chosen at run time.
class AnyField {
 public:
  AnyField() = default;
  AnyField(const AnyField&) = delete;
  AnyField& operator=(const AnyField&) = delete;
  virtual ~AnyField() = default;

  virtual std::vector<std::string> component_names() const = 0;
  virtual std::string_view instruction_set() const = 0;
  virtual void points(const nb::list& coordinates, const nb::list& cells, nb::handle out, int threads) const = 0;
  // The documented range of each component, or nothing.
  virtual std::vector<std::optional<std::pair<double, double>>> ranges() const = 0;
  // `ranges` are what words of 16 bits stand for, for each component.
  virtual Pair grid(const nb::tuple& origin, const nb::tuple& step, const nb::tuple& size, const nb::tuple& first,
                    nb::handle out, const Ranges& ranges, int threads) const = 0;
  virtual Pair cell_grid(const nb::tuple& cell, const nb::tuple& f, const nb::tuple& step, const nb::tuple& size,
                         const nb::tuple& first, nb::handle out, const Ranges& ranges, int threads) const = 0;
};

// Points of a field that are evaluated together. Numbers that lie in memory otherwise than the field reads and writes
// them are copied. The arrays of the walk are the coordinates, then the cells if there are any, then the first plane of
// the result.
template <int D>
class Block {
 public:
  Block(const Field<D>& field, const Walk& walk, const Planes& planes, bool has_cells)
      : field_(field), walk_(walk), planes_(planes), has_cells_(has_cells) {}

  bool needs_no_copy(std::size_t begin, std::size_t count) const {
    for (std::size_t i = 0; i < result(); ++i) {
      if (!walk_.is_row(i, i < D ? Kind::kFloat32 : Kind::kInt32, begin, count)) return false;
    }
    return takes_values(begin, count);
  }

  void fill(std::size_t begin, std::size_t count, const Executor& executor) {
    CellPoints<D> points;
    for (std::size_t i = 0; i < D; ++i) {
      points.f[i] = row(i, Kind::kFloat32, begin, count, coordinates_[i]);
      if (has_cells_) points.cell[i] = row(D + i, Kind::kInt32, begin, count, cells_[i]);
    }
    if (takes_values(begin, count)) {
      compute(points, {reinterpret_cast<float*>(walk_.place(result(), begin)), components() * count}, executor);
      return;
    }
    values_.resize(components() * count);
    compute(points, values_, executor);
    for (std::size_t i = 0; i < components(); ++i) {
      walk_.scatter(values_.data() + i * count, result(), begin, count,
                    static_cast<std::ptrdiff_t>(i) * planes_.step());
    }
  }

 private:
  std::size_t result() const { return has_cells_ ? 2 * D : D; }
  std::size_t components() const { return static_cast<std::size_t>(field_.component_count()); }

  bool takes_values(std::size_t begin, std::size_t count) const {
    return walk_.is_row(result(), Kind::kFloat32, begin, count) &&
           (components() == 1 || planes_.step() == static_cast<std::ptrdiff_t>(count * sizeof(float)));
  }

  void compute(const CellPoints<D>& points, std::span<float> values, const Executor& executor) const {
    if (has_cells_) {
      field_.fill(points, values, executor);
    } else {
      field_.fill(Points<D>{points.f}, values, executor);
    }
  }

  template <class Number>
  std::span<const Number> row(std::size_t index, Kind kind, std::size_t begin, std::size_t count,
                              std::vector<Number>& copy) const {
    if (walk_.is_row(index, kind, begin, count)) {
      return {reinterpret_cast<const Number*>(walk_.place(index, begin)), count};
    }
    copy.resize(count);
    switch (walk_.array(index).kind) {
      case Kind::kFloat32:
        walk_.gather<float>(index, begin, count, copy.data());
        break;
      case Kind::kFloat64:
        walk_.gather<double>(index, begin, count, copy.data());
        break;
      case Kind::kInt32:
        walk_.gather<std::int32_t>(index, begin, count, copy.data());
        break;
      case Kind::kInt64:
        walk_.gather<std::int64_t>(index, begin, count, copy.data());
        break;
    }
    return copy;
  }

  const Field<D>& field_;
  const Walk& walk_;
  const Planes& planes_;
  bool has_cells_;
  std::array<std::vector<float>, D> coordinates_{};
  std::array<std::vector<std::int32_t>, D> cells_{};
  std::vector<float> values_{};
};

template <int D>
class FieldOf final : public AnyField {
 public:
  explicit FieldOf(const Settings& settings) : field_(settings), settings_(settings) {}

  std::vector<std::string> component_names() const override { return field_.components(); }
  std::string_view instruction_set() const override { return name(field_.instruction_set()); }

  void points(const nb::list& coordinates, const nb::list& cells, nb::handle out, int threads) const override {
    const bool has_cells = nb::len(cells) != 0;
    if (nb::len(coordinates) != D || (has_cells && nb::len(cells) != D)) {
      throw std::invalid_argument("an array for each axis is needed");
    }
    const Planes planes(out, field_.component_count());
    if (planes.numbers() != Numbers::kFloat32) throw std::invalid_argument("the result must be of float32");
    std::deque<Memory> memories;
    std::vector<StridedArray> arrays;
    for (const nb::list* list : {&coordinates, &cells}) {
      for (const nb::handle array : *list) {
        memories.emplace_back(array, PyBUF_RECORDS_RO);
        arrays.push_back(broadcast(memories.back(), planes.shape()));
      }
    }
    arrays.push_back(planes.first());
    if (planes.points() == 0) return;
    const Walk walk(planes.shape(), std::move(arrays));
    const nb::gil_scoped_release released;
    evaluate(walk, planes, has_cells, executor(threads, planes.points()));
  }

  std::vector<std::optional<std::pair<double, double>>> ranges() const override {
    std::vector<std::optional<std::pair<double, double>>> ranges;
    for (const std::string& component : field_.components()) {
      const auto range = grid::documented_range(settings_, D, component);
      ranges.push_back(range ? std::optional(std::pair(range->least, range->greatest)) : std::nullopt);
    }
    return ranges;
  }

  Pair grid(const nb::tuple& origin, const nb::tuple& step, const nb::tuple& size, const nb::tuple& first,
            nb::handle out, const Ranges& ranges, int threads) const override {
    return fill(Grid<D>{numbers<float>(origin), numbers<float>(step), numbers<int>(size), numbers<int>(first)}, out,
                ranges, threads);
  }

  Pair cell_grid(const nb::tuple& cell, const nb::tuple& f, const nb::tuple& step, const nb::tuple& size,
                 const nb::tuple& first, nb::handle out, const Ranges& ranges, int threads) const override {
    return fill(CellGrid<D>{numbers<std::int32_t>(cell), numbers<float>(f), numbers<double>(step), numbers<int>(size),
                            numbers<int>(first)},
                out, ranges, threads);
  }

 private:
  template <class Number>
  static std::array<Number, D> numbers(const nb::tuple& tuple) {
    return nb::cast<std::array<Number, D>>(tuple);
  }

  template <class AnyGrid>
  Pair fill(const AnyGrid& grid, nb::handle out, const Ranges& ranges, int threads) const {
    const Planes planes(out, field_.component_count());
    if (planes.numbers() == Numbers::kUint16 && ranges.size() != static_cast<std::size_t>(field_.component_count())) {
      throw std::invalid_argument("words of 16 bits want a range for each component");
    }
    const std::span<float> values = planes.whole();
    const bool has_points = planes.points() > 0;
    const nb::gil_scoped_release released;
    const Executor run_by = executor(threads, planes.points());
    const Range range =
        has_points && values.empty() ? fill_by_tiles(grid, planes, ranges, run_by) : field_.fill(grid, values, run_by);
    return {range.least, range.greatest};
  }

  template <class AnyGrid>
  Range fill_by_tiles(const AnyGrid& grid, const Planes& planes, const Ranges& ranges, const Executor& executor) const {
    if (planes.shape().size() != D) throw std::invalid_argument("the result must have an axis for each of the grid");
    const StridedArray plane = planes.first();
    std::array<std::ptrdiff_t, D> steps{};  // x is the last axis of an array
    for (std::size_t axis = 0; axis < D; ++axis) {
      steps[axis] = plane.steps[D - 1 - axis];
      if (planes.shape()[D - 1 - axis] != grid.size[axis]) throw std::invalid_argument("the result has another shape");
    }
    check_corners(grid);
    const Tiles<D> tiles(grid.size, steps);
    std::vector<Range> found(tiles.count());
    run(executor, tiles.count(), [&](std::size_t number) {
      const Tile<D> tile = tiles[number];
      AnyGrid part = grid;
      part.size = tile.size;
      std::byte* to = plane.data;
      for (std::size_t axis = 0; axis < D; ++axis) {
        part.first[axis] += tile.first[axis];
        to += static_cast<std::ptrdiff_t>(tile.first[axis]) * steps[axis];
      }
      const std::size_t points = tile.points();
      std::vector<float> values(points * static_cast<std::size_t>(field_.component_count()));
      found[number] = field_.fill(part, values);
      for (std::size_t i = 0; i < static_cast<std::size_t>(field_.component_count()); ++i) {
        const float* const from = values.data() + i * points;
        std::byte* const to_plane = to + static_cast<std::ptrdiff_t>(i) * planes.step();
        switch (planes.numbers()) {
          case Numbers::kFloat32:
            write_tile(from, to_plane, tile.size, steps, tiles.nearest(), [](float value) { return value; });
            break;
          case Numbers::kFloat16:
            write_tile(from, to_plane, tile.size, steps, tiles.nearest(), [](float value) { return half_of(value); });
            break;
          case Numbers::kUint16:
            write_tile(from, to_plane, tile.size, steps, tiles.nearest(),
                       [range = grid::Interval{ranges[i].first, ranges[i].second}](float value) {
                         return grid::word_of(value, range);
                       });
            break;
        }
      }
    });
    Range range;
    for (const Range& of_tile : found) {
      range.least = std::min(range.least, of_tile.least);
      range.greatest = std::max(range.greatest, of_tile.greatest);
    }
    return range;
  }

  // A wrong grid is an error of its first or its last point: throw it here, not in a thread.
  template <class AnyGrid>
  void check_corners(const AnyGrid& grid) const {
    std::vector<float> values(static_cast<std::size_t>(field_.component_count()));
    AnyGrid corner = grid;
    corner.size.fill(1);
    field_.fill(corner, values);
    for (std::size_t axis = 0; axis < D; ++axis) corner.first[axis] += grid.size[axis] - 1;
    field_.fill(corner, values);
  }

  // Values of a tile, x fastest, to their places, in lines along the axis `nearest`.
  template <class Convert>
  static void write_tile(const float* from, std::byte* to, const std::array<int, D>& size,
                         const std::array<std::ptrdiff_t, D>& steps, std::size_t nearest, const Convert& convert) {
    std::array<std::size_t, D> strides{};
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      strides[axis] = stride;
      stride *= static_cast<std::size_t>(size[axis]);
    }
    std::array<int, D> at{};
    const auto length = static_cast<std::size_t>(size[nearest]);
    for (std::size_t lines = stride / length; lines > 0; --lines) {
      const float* line = from;
      std::byte* line_to = to;
      for (std::size_t axis = 0; axis < D; ++axis) {
        line += static_cast<std::size_t>(at[axis]) * strides[axis];
        line_to += at[axis] * steps[axis];
      }
      write_line(line, strides[nearest], line_to, steps[nearest], length, convert);
      for (std::size_t axis = 0; axis < D; ++axis) {
        if (axis == nearest) continue;
        if (++at[axis] < size[axis]) break;
        at[axis] = 0;
      }
    }
  }

  void evaluate(const Walk& walk, const Planes& planes, bool has_cells, const Executor& executor) const {
    const std::size_t points = planes.points();
    Block<D> whole(field_, walk, planes, has_cells);
    if (whole.needs_no_copy(0, points)) return whole.fill(0, points, executor);
    const std::size_t tasks = (points + kTask - 1) / kTask;
    run(executor, tasks, [&](std::size_t task) {
      Block<D> block(field_, walk, planes, has_cells);
      const std::size_t end = std::min(points, (task + 1) * kTask);
      for (std::size_t begin = task * kTask; begin < end; begin += kBlock) {
        block.fill(begin, std::min(kBlock, end - begin), {});
      }
    });
  }

  Field<D> field_;
  Settings settings_;
};

std::unique_ptr<AnyField> make_field(int dimensions, const Settings& settings) {
  switch (dimensions) {
    case 1:
      return std::make_unique<FieldOf<1>>(settings);
    case 2:
      return std::make_unique<FieldOf<2>>(settings);
    case 3:
      return std::make_unique<FieldOf<3>>(settings);
    case 4:
      return std::make_unique<FieldOf<4>>(settings);
    default:
      throw std::invalid_argument("there are 1 to 4 dimensions");
  }
}

std::vector<std::string> names_of(const std::vector<InstructionSet>& sets) {
  std::vector<std::string> names;
  for (const InstructionSet set : sets) names.emplace_back(name(set));
  return names;
}

InstructionSet instruction_set_called(const std::string& wanted) {
  std::string known;
  for (const InstructionSet set : instruction_sets()) {
    if (name(set) == wanted) return set;
    known += (known.empty() ? "" : ", ") + std::string(name(set));
  }
  throw std::invalid_argument("instruction_set must be one of this processor's, which are " + known + "; not " +
                              wanted);
}

}  // namespace
}  // namespace hashnoise::python

NB_MODULE(_core, module) {
  using hashnoise::Arithmetic;
  using hashnoise::Metric;
  using hashnoise::Settings;
  using hashnoise::python::AnyField;

  nb::class_<Settings>(module, "Settings")
      .def(nb::init<>())
      .def_rw("noise", &Settings::noise)
      .def_rw("fractal", &Settings::fractal)
      .def_prop_rw(
          "arithmetic", [](const Settings& settings) { return static_cast<int>(settings.arithmetic); },
          [](Settings& settings, int value) { settings.arithmetic = static_cast<Arithmetic>(value); })
      .def_rw("seed", &Settings::seed)
      .def_rw("period", &Settings::period)
      .def_rw("phase", &Settings::phase)
      .def_rw("wave", &Settings::wave)
      .def_rw("jitter", &Settings::jitter)
      .def_prop_rw(
          "metric",
          [](const Settings& settings) { return static_cast<int>(settings.metric.value_or(Metric::kEuclidean)); },
          [](Settings& settings, int value) { settings.metric = static_cast<Metric>(value); })
      .def_prop_rw(
          "octaves", [](const Settings& settings) -> std::optional<int> { return settings.octaves; },
          [](Settings& settings, std::optional<int> value) { settings.octaves = value; })
      .def_rw("lacunarity", &Settings::lacunarity)
      .def_rw("gain", &Settings::gain)
      .def_rw("strength", &Settings::strength)
      .def_rw("amplitude", &Settings::amplitude)
      .def_rw("detail", &Settings::detail)
      .def_rw("footprint", &Settings::footprint)
      .def_prop_rw(
          "instruction_set",
          [](const Settings& settings) {
            return settings.instruction_set ? std::string(name(*settings.instruction_set)) : std::string();
          },
          [](Settings& settings, const std::string& wanted) {
            settings.instruction_set = hashnoise::python::instruction_set_called(wanted);
          });

  nb::class_<AnyField>(module, "Field")
      .def(nb::new_(&hashnoise::python::make_field), nb::arg("dimensions"), nb::arg("settings"))
      .def_prop_ro("component_names", &AnyField::component_names)
      .def_prop_ro("instruction_set", &AnyField::instruction_set)
      .def("points", &AnyField::points, nb::arg("coordinates"), nb::arg("cells"), nb::arg("out"), nb::arg("threads"))
      .def_prop_ro("ranges", &AnyField::ranges)
      .def("grid", &AnyField::grid, nb::arg("origin"), nb::arg("step"), nb::arg("size"), nb::arg("first"),
           nb::arg("out"), nb::arg("ranges"), nb::arg("threads"))
      .def("cell_grid", &AnyField::cell_grid, nb::arg("cell"), nb::arg("f"), nb::arg("step"), nb::arg("size"),
           nb::arg("first"), nb::arg("out"), nb::arg("ranges"), nb::arg("threads"));

  module.def(
      "suggestion",
      [](std::string_view word, const std::vector<std::string>& names) {
        return hashnoise::detail::suggestion(word, names);
      },
      nb::arg("word"), nb::arg("names"));
  module.def("noise_names", &hashnoise::noises, nb::arg("dimensions"));
  module.def("fractal_names", &hashnoise::fractals, nb::arg("dimensions"));
  module.def("instruction_sets", [] { return hashnoise::python::names_of(hashnoise::instruction_sets()); });
  // The least and the most of settings that are whole numbers. Python's number may not fit a Settings, which checks
  // the others.
  nb::dict rules;
  for (const hashnoise::grid::Rule& rule : hashnoise::grid::kRules) {
    if (!rule.is_whole) continue;
    rules[nb::str(rule.setting.data(), rule.setting.size())] =
        nb::make_tuple(static_cast<std::int64_t>(rule.least), static_cast<std::int64_t>(rule.most));
  }
  module.attr("rules") = rules;
  module.attr("version") = HASHNOISE_VERSION;
}
