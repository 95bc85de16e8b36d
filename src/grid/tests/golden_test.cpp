// With Arithmetic::kFixed a field has the values of the golden files, which the oracle writes from
// docs/reference/contract.md alone. So does the twin that the other tests compare with.
//
// docs/reference/formats.md describes the files. Each row is a field with settings of its own, and one point.
// hn-conform compares drivers with the twin.
#include "expected/golden.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "compare.hpp"
#include "fields.hpp"
#include "grid/functions.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

struct Row {
  std::map<std::string, std::uint32_t> words;  // by column
  std::vector<float> values;
};

// The golden file of a function with HN_FIXED, without the rows with infinities: a field takes none.
struct Golden {
  std::string calls;  // the function of the library, without "hn_"
  int dimensions = 0;
  bool from_cell = false;
  std::set<std::string> columns;
  bool is_part = false;   // of what a field has: in 4D a noise with derivatives has one file for its value
  std::size_t first = 0;  // of the components in the file
  std::vector<Row> rows;
};

Golden read(const hn::Function& function) {
  const auto file = hn::read_golden(hn::golden_path(HN_GOLDEN_DIRECTORY, function), function,
                                    hn::configuration_named("lattice+fixed"));
  if (!file) throw std::runtime_error(file.error().text());
  Golden golden;
  golden.calls = file->calls.substr(std::string("hn_").size());
  // The phase of hn_cellular_phase is a setting.
  if (golden.calls.ends_with("_phase")) golden.calls.erase(golden.calls.rfind("_phase"));
  golden.dimensions = function.axes;
  golden.from_cell = function.takes_cell();
  golden.is_part = function.is_derived() && function.axes == 4;
  golden.first = golden.is_part && function.is_slope(0) ? 1 : 0;  // and one for the derivatives
  for (const hn::Column& column : function.inputs) golden.columns.insert(std::string(column.name));
  for (const hn::GoldenRow& words : file->rows) {
    Row row;
    bool is_finite = true;
    for (std::size_t i = 0; i < words.inputs.size(); ++i) {
      if (function.inputs[i].type == hn::WordType::f32) {
        is_finite = is_finite && std::isfinite(std::bit_cast<float>(words.inputs[i]));
      }
      row.words[std::string(function.inputs[i].name)] = words.inputs[i];
    }
    for (const std::uint64_t value : words.values) {
      row.values.push_back(static_cast<float>(std::bit_cast<double>(value)));
    }
    if (is_finite) golden.rows.push_back(row);
  }
  return golden;
}

// The field that has what a file is of. None if no field has what the function returns: the nearest cell, or the way to
// its point; or what it is: derivatives of several numbers, or gullies.
std::optional<Settings> settings_of(const hn::Function& function, const Golden& golden) {
  if (function.inputs_are_units() || function.is_name(0) || function.is_offset) return {};
  Settings settings;
  settings.arithmetic = Arithmetic::kFixed;
  if (function.is_octave_sum()) {
    if (std::ranges::count(sums(golden.dimensions), golden.calls) == 0) return {};
    settings.fractal = golden.calls;
    settings.noise = noise_below(golden.calls);
    return settings;
  }
  if (!function.is_noise() && function.family != hn::Family::curl) return {};
  if (std::ranges::count(noises(golden.dimensions), golden.calls) == 0) return {};
  settings.noise = golden.calls;
  return settings;
}

// Sets the columns of a row. Returns whether a field may have it: a sum without a positive period is no tile. Numbers
// that the functions take as the nearer end, or in a tile as the whole part, are errors of a field.
bool set_columns(Settings& settings, MoreSettings& more, const Golden& golden, const Row& row) {
  settings.seed = row.words.at("seed");
  settings.wave.clear();
  for (const std::string& name : golden.columns) {
    const std::uint32_t word = row.words.at(name);
    if (name == "octaves" || name == "metric") {
      set(settings, name, static_cast<std::int32_t>(word));
    } else if (name.starts_with("p") && name.size() == 2) {
      settings.period[std::string("xyzw").find(name[1])] = static_cast<std::int32_t>(word);
    } else if (name.starts_with("k") && name.size() == 2) {
      set(settings, "wave", static_cast<double>(std::bit_cast<float>(word)));
    } else if (name == "bandwidth") {
      more.bandwidth = std::bit_cast<float>(word);
    } else if (name != "seed" && name.size() > 2) {
      set(settings, name, static_cast<double>(std::bit_cast<float>(word)));
    }
  }
  const bool is_tile = has_period(settings, golden.dimensions);
  if (settings.lacunarity) settings.lacunarity = std::clamp(*settings.lacunarity, 0.0f, 255.0f);
  if (settings.lacunarity && is_tile) settings.lacunarity = std::trunc(*settings.lacunarity);
  if (settings.gain) settings.gain = std::clamp(*settings.gain, 0.0f, 1.0f);
  return is_tile || settings.fractal.empty() || !golden.columns.contains("px");
}

// The components in the file, or all if that is what the file should have.
std::span<const float> shown(const Golden& golden, const Row& row, std::span<const float> values) {
  if (!golden.is_part || values.size() < golden.first + row.values.size()) return values;
  return values.subspan(golden.first, row.values.size());
}

template <int D, typename Places>
testing::AssertionResult has_row(Settings settings, const MoreSettings& more, const Places& where, const Golden& golden,
                                 const Row& row) {
  const std::vector<float> of_twin = planes_of(function<D>(settings), places_of(where));
  // The twin has no bandwidth.
  if (const auto same = same_bits(shown(golden, row, of_twin), row.values, 1); !same && !more.bandwidth) {
    return testing::AssertionFailure() << "the twin of " << settings << ": " << same.message();
  }
  for (const InstructionSet instructions : instruction_sets()) {
    settings.instruction_set = instructions;
    std::vector<float> values(of_twin.size());
    Field<D>(settings, more).fill(where, values);
    if (const auto same = same_bits(shown(golden, row, values), row.values, 1); !same) {
      return testing::AssertionFailure() << "the field of " << settings << ": " << same.message();
    }
  }
  return testing::AssertionSuccess();
}

// Whether all rows are right that a field has. They are counted.
template <int D>
testing::AssertionResult has_rows(Settings settings, const Golden& golden, std::size_t& compared) {
  constexpr std::array<const char*, 4> kAxes = {"x", "y", "z", "w"};
  for (const Row& row : golden.rows) {
    MoreSettings more;
    if (!set_columns(settings, more, golden, row)) continue;
    try {
      const Field<D> field(settings, more);
    } catch (const std::invalid_argument&) {
      continue;
    }
    ++compared;
    std::array<float, D> p{};
    std::array<std::int32_t, D> cell{};
    Points<D> points;
    CellPoints<D> cell_points;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::string name = kAxes[axis];
      if (golden.from_cell) cell[axis] = static_cast<std::int32_t>(row.words.at("c" + name));
      p[axis] = std::bit_cast<float>(row.words.at(golden.from_cell ? "f" + name : name));
      points.p[axis] = cell_points.f[axis] = std::span(&p[axis], 1);
      cell_points.cell[axis] = std::span(&cell[axis], 1);
    }
    const auto right = golden.from_cell ? has_row<D>(settings, more, cell_points, golden, row)
                                        : has_row<D>(settings, more, points, golden, row);
    if (!right) return right;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult has_rows(const Settings& settings, const Golden& golden, std::size_t& compared) {
  testing::AssertionResult right = testing::AssertionSuccess();
  in_dimensions(golden.dimensions,
                [&]<int D>(std::integral_constant<int, D>) { right = has_rows<D>(settings, golden, compared); });
  return right;
}

TEST(Golden, Values) {
  std::size_t rows = 0;
  std::set<std::string> subjects;
  for (const hn::Function& function : hn::all_functions()) {
    SCOPED_TRACE(function.id);
    if (!hn::covers(hn::configuration_named("lattice+fixed"), function)) continue;
    const Golden golden = read(function);
    const std::optional<Settings> settings = settings_of(function, golden);
    if (!settings) continue;
    std::size_t compared = 0;
    EXPECT_TRUE(has_rows(*settings, golden, compared));
    EXPECT_GT(compared, 20u);
    rows += compared;
    subjects.insert(settings->fractal + " " + settings->noise + std::to_string(golden.dimensions) +
                    (golden.columns.contains("phase") ? " phase" : "") +
                    (golden.columns.contains("bandwidth") ? " bandwidth" : "") +
                    (golden.columns.contains("detail") ? " detail" : "") +
                    (golden.columns.contains("footprint") ? " footprint" : ""));
  }
  // Every noise is there, every phase, and every sum over the noise of its GLSL function.
  std::set<std::string> expected;
  for (int dimensions = 1; dimensions <= 4; ++dimensions) {
    const std::string d = std::to_string(dimensions);
    for (const std::string& noise : noises(dimensions)) {
      if (!row_of(noise).has_wave()) expected.insert(" " + noise + d);  // it has no form without a phase
      if (can_have_phase(noise, dimensions)) expected.insert(" " + noise + d + " phase");
      if (row_of(noise).has_wave()) expected.insert(" " + noise + d + " phase bandwidth");
    }
    for (const std::string& sum : sums(dimensions)) {
      const std::string noise = noise_below(sum);
      expected.insert(sum + " " + noise + d);
      if (grid::sum_row(sum).has_phase) expected.insert(sum + " " + noise + d + " phase");
      if (sum == "fbm") expected.insert({sum + " " + noise + d + " detail", sum + " " + noise + d + " footprint"});
    }
  }
  EXPECT_EQ(subjects, expected);
  EXPECT_GT(rows, 20000u);
}

// --- The readers and comparisons must notice faults ---

TEST(GoldenFile, WithAWrongNumberIsNoticed) {
  const hn::Function& function = hn::find_function("noise2d.perlin_d_cell");
  const Golden golden = read(function);
  const Settings settings = *settings_of(function, golden);
  std::size_t compared = 0;
  ASSERT_TRUE(has_rows(settings, golden, compared));
  EXPECT_EQ(compared, golden.rows.size());
  ASSERT_GT(compared, 100u);
  Golden wrong = golden;
  wrong.rows.back().values[2] += 0x1p-19f;  // the last derivative of the last row, by its last bit
  EXPECT_FALSE(has_rows(settings, wrong, compared));
  wrong = golden;
  wrong.rows[50].words["seed"] += 1;
  EXPECT_FALSE(has_rows(settings, wrong, compared));
  Settings other = settings;
  other.noise = "simplex_d";
  EXPECT_FALSE(has_rows(other, golden, compared));
}

}  // namespace
}  // namespace hashnoise::twin
