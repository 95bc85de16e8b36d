// The compiled part of the Python package: fields over numbers that lie in a row. hashnoise/ has the interface that
// users see, checks what they pass, and brings other arrays into rows.
// SPDX-License-Identifier: MIT

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <hashnoise/detail/closest.hpp>
#include <hashnoise/field.hpp>
#include <hashnoise/points.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "grid/ranges.hpp"
#include "grid/rules.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace hashnoise::python {
namespace {

constexpr std::size_t kWorthThreads = 1 << 17;  // points: below, starting threads takes too large a part of the time

template <class Number, class... More>
using Array = nb::ndarray<Number, nb::c_contig, nb::device::cpu, More...>;
template <class Number>
using Rows = std::vector<Array<Number, nb::ndim<1>>>;

// 0 threads are as many as are worth it.
Executor executor(int count, std::size_t points) {
  if (count == 1 || (count == 0 && points < kWorthThreads)) return {};
  return threads(count);
}

struct AllSettings : Settings, MoreSettings {};

template <int D>
struct PythonField : Field<D> {
  explicit PythonField(const AllSettings& all) : Field<D>(all, all), settings(all) {}
  Settings settings;
};

template <class Number, int D>
PerAxis<std::span<Number>, D> spans(const Rows<Number>& rows) {
  PerAxis<std::span<Number>, D> found;
  if (rows.size() != found.size()) throw std::invalid_argument("an array for each axis is needed");
  for (std::size_t axis = 0; axis < found.size(); ++axis) found[axis] = {rows[axis].data(), rows[axis].size()};
  return found;
}

// All rows have as many numbers. Planes that do not lie one behind the other are copied.
template <int D>
void fill_points(const PythonField<D>& field, const Rows<const float>& places, const Rows<const std::int32_t>& cells,
                 const Rows<float>& planes, int threads) {
  const std::size_t count = planes.at(0).size();
  std::span<float> values{planes[0].data(), count * planes.size()};
  std::vector<float> copy;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].data() != planes[0].data() + i * count) copy.resize(values.size());
  }
  if (!copy.empty()) values = copy;
  const auto f = spans<const float, D>(places);
  const nb::gil_scoped_release released;
  if (cells.empty()) {
    field.fill(Points<D>{f}, values, executor(threads, count));
  } else {
    field.fill(CellPoints<D>{spans<const std::int32_t, D>(cells), f}, values, executor(threads, count));
  }
  for (std::size_t i = 0; i < planes.size() && !copy.empty(); ++i) {
    std::copy_n(&copy[i * count], count, planes[i].data());
  }
}

// Returns the least and the greatest value.
template <int D, class AnyGrid>
std::pair<float, float> fill_grid(const Field<D>& field, const AnyGrid& grid, const Array<float>& out, int threads) {
  const std::size_t points = out.size() / static_cast<std::size_t>(field.component_count());
  const nb::gil_scoped_release released;
  const Range range = field.fill(grid, {out.data(), out.size()}, executor(threads, points));
  return {range.least, range.greatest};
}

// The documented range of each component, or nothing.
template <int D>
std::vector<std::optional<std::pair<double, double>>> ranges(const PythonField<D>& field) {
  std::vector<std::optional<std::pair<double, double>>> ranges;
  for (const std::string& component : field.components()) {
    const auto range = grid::documented_range(field.settings, D, component);
    ranges.push_back(range ? std::optional(std::pair(range->least, range->greatest)) : std::nullopt);
  }
  return ranges;
}

template <int D>
void add_field(nb::module_& module) {
  using Own = PythonField<D>;
  using Floats = PerAxis<float, D>;
  using Numbers = PerAxis<int, D>;
  nb::class_<Own>(module, ("Field" + std::to_string(D)).c_str())
      .def(nb::init<const AllSettings&>())
      .def_prop_ro("component_names", &Own::components)
      .def_prop_ro("instruction_set", [](const Own& field) { return name(field.instruction_set()); })
      .def_prop_ro("ranges", &ranges<D>)
      .def("points", &fill_points<D>, "coordinates"_a.noconvert(), "cells"_a.noconvert(), "planes"_a.noconvert(),
           "threads"_a)
      .def(
          "grid",
          [](const Own& field, const Floats& origin, const Floats& step, const Numbers& size, const Numbers& first,
             const Array<float>& out, int threads) {
            return fill_grid<D>(field, Grid<D>{origin, step, size, first}, out, threads);
          },
          "origin"_a, "step"_a, "size"_a, "first"_a, "out"_a.noconvert(), "threads"_a)
      .def(
          "cell_grid",
          [](const Own& field, const PerAxis<std::int32_t, D>& cell, const Floats& f, const PerAxis<double, D>& step,
             const Numbers& size, const Numbers& first, const Array<float>& out, int threads) {
            return fill_grid<D>(field, CellGrid<D>{cell, f, step, size, first}, out, threads);
          },
          "cell"_a, "f"_a, "step"_a, "size"_a, "first"_a, "out"_a.noconvert(), "threads"_a);
}

std::vector<std::string_view> names_of_instruction_sets() {
  std::vector<std::string_view> names;
  for (const InstructionSet set : instruction_sets()) names.push_back(name(set));
  return names;
}

}  // namespace
}  // namespace hashnoise::python

NB_MODULE(_core, module) {
  using hashnoise::Arithmetic;
  using hashnoise::Metric;
  namespace python = hashnoise::python;
  using python::AllSettings;

  nb::class_<AllSettings>(module, "Settings")
      .def(nb::init<>())
      .def_rw("noise", &AllSettings::noise)
      .def_rw("fractal", &AllSettings::fractal)
      .def_prop_rw("arithmetic", nullptr,
                   [](AllSettings& settings, int value) { settings.arithmetic = static_cast<Arithmetic>(value); })
      .def_rw("seed", &AllSettings::seed)
      .def_rw("period", &AllSettings::period)
      .def_rw("phase", &AllSettings::phase)
      .def_rw("wave", &AllSettings::wave)
      .def_rw("bandwidth", &AllSettings::bandwidth)
      .def_rw("jitter", &AllSettings::jitter)
      .def_prop_rw("metric", nullptr,
                   [](AllSettings& settings, int value) { settings.metric = static_cast<Metric>(value); })
      .def_prop_rw("octaves", nullptr, [](AllSettings& settings, int value) { settings.octaves = value; })
      .def_rw("lacunarity", &AllSettings::lacunarity)
      .def_rw("gain", &AllSettings::gain)
      .def_rw("strength", &AllSettings::strength)
      .def_rw("amplitude", &AllSettings::amplitude)
      .def_rw("detail", &AllSettings::detail)
      .def_rw("footprint", &AllSettings::footprint)
      .def_prop_rw("instruction_set", nullptr, [](AllSettings& settings, std::size_t number) {
        settings.instruction_set = hashnoise::instruction_sets().at(number);
      });
  python::add_field<1>(module);
  python::add_field<2>(module);
  python::add_field<3>(module);
  python::add_field<4>(module);

  module.def(
      "suggestion",
      [](std::string_view word, const std::vector<std::string>& names) {
        return hashnoise::detail::suggestion(word, names);
      },
      nb::arg("word"), nb::arg("names"));
  module.def("noise_names", &hashnoise::noises, nb::arg("dimensions"));
  module.def("fractal_names", &hashnoise::fractals, nb::arg("dimensions"));
  module.def("instruction_sets", &python::names_of_instruction_sets);
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
