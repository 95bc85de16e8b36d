// The compiled part of the Python package: fields over NumPy's arrays. hashnoise/ says what users see of it, and checks
// what they pass.
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
#include <deque>
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
#include "grid/rules.hpp"

namespace nb = nanobind;

namespace hashnoise::python {
namespace {

constexpr std::size_t kBlock = 4096;            // points that are copied at a time: they stay in the nearest caches
constexpr std::size_t kTask = 8 * kBlock;       // points that a thread takes at a time
constexpr std::size_t kWorthThreads = 1 << 17;  // points: below, starting threads takes too large a part of the time

using Pair = std::pair<float, float>;

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

// A result: planes of components, along its first axis.
class Planes {
 public:
  Planes(nb::handle array, int components) : memory_(array, PyBUF_RECORDS) {
    const Py_buffer& view = memory_.view();
    if (kind_of(memory_) != Kind::kFloat32) throw std::invalid_argument("the result must be of float32");
    if (view.ndim < 1 || view.shape[0] != components) {
      throw std::invalid_argument("the first axis of the result must be that of the components");
    }
    shape_.assign(view.shape + 1, view.shape + view.ndim);
    for (const std::ptrdiff_t size : shape_) points_ *= static_cast<std::size_t>(size);
  }

  std::size_t points() const { return points_; }
  const std::vector<std::ptrdiff_t>& shape() const { return shape_; }
  std::ptrdiff_t step() const { return memory_.view().strides[0]; }  // in bytes, from plane to plane

  // A plane as an array of its points.
  Strided first() const {
    const Py_buffer& view = memory_.view();
    Strided strided{static_cast<std::byte*>(view.buf), Kind::kFloat32, {}};
    strided.steps.assign(view.strides + 1, view.strides + view.ndim);
    return strided;
  }

  // All numbers, if they lie one behind the other.
  std::span<float> whole() const {
    const Py_buffer& view = memory_.view();
    if (!PyBuffer_IsContiguous(&view, 'C')) throw std::invalid_argument("the result must be contiguous");
    return {static_cast<float*>(view.buf), static_cast<std::size_t>(view.shape[0]) * points_};
  }

 private:
  Memory memory_;
  std::vector<std::ptrdiff_t> shape_{};
  std::size_t points_ = 1;
};

// A field in as many dimensions as were asked for at run time.
class AnyField {
 public:
  AnyField() = default;
  AnyField(const AnyField&) = delete;
  AnyField& operator=(const AnyField&) = delete;
  virtual ~AnyField() = default;

  virtual std::vector<std::string> component_names() const = 0;
  virtual std::string_view instruction_set() const = 0;
  virtual void points(const nb::list& coordinates, const nb::list& cells, nb::handle out, int threads) const = 0;
  virtual Pair grid(const nb::tuple& origin, const nb::tuple& step, const nb::tuple& size, nb::handle out,
                    int threads) const = 0;
  virtual Pair cell_grid(const nb::tuple& cell, const nb::tuple& f, const nb::tuple& step, const nb::tuple& size,
                         nb::handle out, int threads) const = 0;
};

// Points of a field that are evaluated together. What does not lie in memory as the field reads and writes it is
// copied. The arrays of the walk are the coordinates, then the cells if there are any, then the first plane of the
// result.
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
  std::size_t components() const { return static_cast<std::size_t>(field_.components()); }

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
  explicit FieldOf(const Settings& settings) : field_(settings) {}

  std::vector<std::string> component_names() const override { return field_.component_names(); }
  std::string_view instruction_set() const override { return name(field_.instruction_set()); }

  void points(const nb::list& coordinates, const nb::list& cells, nb::handle out, int threads) const override {
    const bool has_cells = nb::len(cells) != 0;
    if (nb::len(coordinates) != D || (has_cells && nb::len(cells) != D)) {
      throw std::invalid_argument("an array for each axis is needed");
    }
    const Planes planes(out, field_.components());
    std::deque<Memory> memories;
    std::vector<Strided> arrays;
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

  Pair grid(const nb::tuple& origin, const nb::tuple& step, const nb::tuple& size, nb::handle out,
            int threads) const override {
    return fill(Grid<D>{numbers<float>(origin), numbers<float>(step), numbers<int>(size)}, out, threads);
  }

  Pair cell_grid(const nb::tuple& cell, const nb::tuple& f, const nb::tuple& step, const nb::tuple& size,
                 nb::handle out, int threads) const override {
    return fill(CellGrid<D>{numbers<std::int32_t>(cell), numbers<float>(f), numbers<double>(step), numbers<int>(size)},
                out, threads);
  }

 private:
  template <class Number>
  static std::array<Number, D> numbers(const nb::tuple& tuple) {
    return nb::cast<std::array<Number, D>>(tuple);
  }

  template <class AnyGrid>
  Pair fill(const AnyGrid& grid, nb::handle out, int threads) const {
    const Planes planes(out, field_.components());
    const std::span<float> values = planes.whole();
    const nb::gil_scoped_release released;
    const Range range = field_.fill(grid, values, executor(threads, planes.points()));
    return {range.least, range.greatest};
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
      .def_rw("sum", &Settings::sum)
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
      .def_rw("octaves", &Settings::octaves)
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
      .def("grid", &AnyField::grid, nb::arg("origin"), nb::arg("step"), nb::arg("size"), nb::arg("out"),
           nb::arg("threads"))
      .def("cell_grid", &AnyField::cell_grid, nb::arg("cell"), nb::arg("f"), nb::arg("step"), nb::arg("size"),
           nb::arg("out"), nb::arg("threads"));

  module.def("noise_names", &hashnoise::noise_names, nb::arg("dimensions"));
  module.def("sum_names", &hashnoise::sum_names, nb::arg("dimensions"));
  module.def("instruction_sets", [] { return hashnoise::python::names_of(hashnoise::instruction_sets()); });
  // Of settings that are whole numbers: the least and the most. What Python has may not fit a Settings, which checks
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
