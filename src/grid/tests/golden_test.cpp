// With Arithmetic::kFixed a field has the values of the golden files, which the oracle writes from docs/contract.md
// alone. So does the twin that the other tests compare with.
//
// docs/formats.md describes the files. Each row is a field with settings of its own, and one point. What a driver
// computes is compared with the twin by hn-conform.
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "compare.hpp"
#include "fields.hpp"

namespace hashnoise::twin {
namespace {

constexpr std::string_view kEnd = ".lattice+fixed.golden";

struct Row {
  std::map<std::string, std::uint32_t> words;  // by column
  std::vector<float> values;
};

struct Golden {
  int dimensions = 0;
  bool from_cell = false;
  std::set<std::string> columns;
  std::vector<Row> rows;
};

Golden read(const std::filesystem::path& path) {
  std::ifstream file(path);
  Golden golden;
  std::vector<std::string> inputs;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "columns") {
      while (words >> word && word != "=") inputs.push_back(word.substr(0, word.find(':')));
    }
    if (line.find(" = ") == std::string::npos || word == "columns" || word == "digest") continue;
    Row row;
    for (const std::string& input : inputs) {
      row.words[input] = static_cast<std::uint32_t>(std::stoul(word, nullptr, 16));
      words >> word;
    }
    if (word != "=") throw std::runtime_error(path.string() + ": a row has another number of columns");
    while (words >> word) {
      row.values.push_back(static_cast<float>(std::bit_cast<double>(std::uint64_t{std::stoull(word, nullptr, 16)})));
    }
    golden.rows.push_back(row);
  }
  golden.columns.insert(inputs.begin(), inputs.end());
  golden.from_cell = golden.columns.contains("cx");
  for (const std::string axis : {"x", "y", "z", "w"}) {
    if (golden.columns.contains(golden.from_cell ? "c" + axis : axis)) ++golden.dimensions;
  }
  return golden;
}

// What a file is of: "fbm.clouds2_cell_period" is of clouds over perlin. None if no field has the function, or not all
// that it returns.
std::optional<Settings> settings_of(const std::string& id) {
  const std::size_t dot = id.find('.');
  const std::string file = id.substr(0, dot);
  std::string function = id.substr(dot + 1);
  if (file == "hash" || file == "gradient" || file == "position") return {};
  if (function.ends_with("_value") || function.ends_with("_nearest") || function.ends_with("_offset")) return {};
  for (const std::string form : {"_period", "_full", "_cell", "_phase", "_detail", "_footprint"}) {
    if (function.ends_with(form)) function.resize(function.size() - form.size());
    // The cell stands before the period and behind a phase.
    if (form == "_full" && function.ends_with("_cell")) function.resize(function.size() - 5);
  }
  Settings settings;
  settings.arithmetic = Arithmetic::kFixed;
  if (file.starts_with("noise")) {
    settings.noise = function;
    return settings;
  }
  function.pop_back();  // the dimensions
  if (file == "curl") {
    settings.noise = function;
    return settings;
  }
  settings.sum = function;
  settings.noise = file == "fbm" ? "perlin" : file == "fbm_d" ? "perlin_d" : "value";
  return settings;
}

// Whether a field has the row: metrics have names, and a period is a positive number, so that a tile of a sum that has
// none is no tile.
bool set(Settings& settings, const Golden& golden, const Row& row) {
  const auto word = [&](const std::string& column) { return row.words.at(column); };
  const auto number = [&](const std::string& column) { return std::bit_cast<float>(word(column)); };
  const auto has = [&](const std::string& column) { return golden.columns.contains(column); };
  settings.seed = word("seed");
  constexpr std::array<const char*, 4> kPeriods = {"px", "py", "pz", "pw"};
  bool has_period = false;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(golden.dimensions); ++axis) {
    if (!has(kPeriods[axis])) continue;
    settings.period[axis] = static_cast<std::int32_t>(word(kPeriods[axis]));
    has_period = has_period || settings.period[axis] > 0;
  }
  if (has("px") && !settings.sum.empty() && !has_period) return false;
  if (has("phase")) settings.phase = number("phase");
  if (has("jitter")) settings.jitter = number("jitter");
  if (has("metric")) {
    if (word("metric") < 1 || word("metric") > 5) return false;
    settings.metric = static_cast<Metric>(word("metric"));
  }
  if (has("octaves")) settings.octaves = static_cast<std::int32_t>(word("octaves"));
  if (has("lacunarity")) settings.lacunarity = number("lacunarity");
  if (has("gain")) settings.gain = number("gain");
  if (has("strength")) settings.strength = number("strength");
  if (has("amplitude")) settings.amplitude = number("amplitude");
  if (has("detail")) settings.detail = number("detail");
  if (has("footprint")) settings.footprint = number("footprint");
  return true;
}

template <int D, typename Places>
testing::AssertionResult has_row(Settings settings, const Places& where, const Row& row) {
  if (const auto same = same_bits(planes_of(function<D>(settings), places_of(where)), row.values, 1); !same) {
    return testing::AssertionFailure() << "the twin of " << settings << ": " << same.message();
  }
  for (const InstructionSet instructions : instruction_sets()) {
    settings.instruction_set = instructions;
    std::vector<float> values(row.values.size());
    Field<D>(settings).fill(where, values);
    if (const auto same = same_bits(values, row.values, 1); !same) {
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
    if (!set(settings, golden, row)) continue;
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
    const auto right = golden.from_cell ? has_row<D>(settings, cell_points, row) : has_row<D>(settings, points, row);
    if (!right) return right;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult has_rows(const Settings& settings, const Golden& golden, std::size_t& compared) {
  if (golden.dimensions == 1) return has_rows<1>(settings, golden, compared);
  if (golden.dimensions == 2) return has_rows<2>(settings, golden, compared);
  if (golden.dimensions == 3) return has_rows<3>(settings, golden, compared);
  return has_rows<4>(settings, golden, compared);
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(HN_GOLDEN_DIRECTORY)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(kEnd)) continue;
    std::string id = name.substr(0, name.size() - kEnd.size());
    if (settings_of(id)) all.push_back(id);
  }
  std::ranges::sort(all);
  return all;
}

std::filesystem::path path_of(const std::string& id) {
  return std::filesystem::path(HN_GOLDEN_DIRECTORY) / (id + std::string(kEnd));
}

TEST(Golden, Values) {
  std::size_t rows = 0;
  std::set<std::string> subjects;
  for (const std::string& id : ids()) {
    SCOPED_TRACE(id);
    const Golden golden = read(path_of(id));
    const Settings settings = *settings_of(id);
    std::size_t compared = 0;
    EXPECT_TRUE(has_rows(settings, golden, compared));
    EXPECT_GT(compared, 20u);
    rows += compared;
    subjects.insert(settings.sum + " " + settings.noise + std::to_string(golden.dimensions) + (golden.columns.contains("phase") ? " phase" : "") +
                    (golden.columns.contains("detail") ? " detail" : "") +
                    (golden.columns.contains("footprint") ? " footprint" : ""));
  }
  // Every noise is there, every phase, and every sum over the noise of its GLSL function.
  std::set<std::string> expected;
  for (int dimensions = 1; dimensions <= 4; ++dimensions) {
    const std::string d = std::to_string(dimensions);
    for (const Noise& noise : noises(dimensions)) expected.insert(" " + noise.name + d);
    if (dimensions == 2 || dimensions == 3) {
      for (const std::string noise : {"perlin", "perlin_d", "simplex", "simplex_d"}) {
        expected.insert(" " + noise + d + " phase");
      }
    }
    for (const std::string& sum : sums(dimensions)) {
      const std::string noise = sum == "fbm_d" || sum == "eroded" ? "perlin_d" : sum.starts_with("warp") ? "value" : "perlin";
      expected.insert(sum + " " + noise + d);
      if (sum == "fbm") expected.insert({sum + " " + noise + d + " detail", sum + " " + noise + d + " footprint"});
    }
  }
  EXPECT_EQ(subjects, expected);
  EXPECT_GT(rows, 20000u);
}

// --- What reads and compares must notice what is wrong ---

TEST(GoldenFile, WithAWrongNumberIsNoticed) {
  const std::string id = "noise2d.perlin_d_cell";
  const Golden golden = read(path_of(id));
  const Settings settings = *settings_of(id);
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

TEST(GoldenFile, NamesWhatItIsOf) {
  const auto name = [](const std::string& id) {
    const auto settings = settings_of(id);
    return settings ? settings->sum + "/" + settings->noise : "";
  };
  EXPECT_EQ(name("noise2d.perlin"), "/perlin");
  EXPECT_EQ(name("noise2d.perlin_d_phase_cell_period"), "/perlin_d");
  EXPECT_EQ(name("noise3d.cellular_smooth_cell_full"), "/cellular_smooth");
  EXPECT_EQ(name("noise3d.cellular_full"), "/cellular");
  EXPECT_EQ(name("noise2d.cellular_cell_nearest"), "");
  EXPECT_EQ(name("curl.curl3_cell_period"), "/curl");
  EXPECT_EQ(name("fbm.ping_pong2_cell_period"), "ping_pong/perlin");
  EXPECT_EQ(name("fbm.fbm4_footprint"), "fbm/perlin");
  EXPECT_EQ(name("fbm_d.eroded3_period"), "eroded/perlin_d");
  EXPECT_EQ(name("warp.warp_progressive2_cell"), "warp_progressive/value");
  EXPECT_EQ(name("position.perlin2"), "");
  EXPECT_EQ(name("hash.word"), "");
}

}  // namespace
}  // namespace hashnoise::twin
