// Tests the descriptions of a field, empty grids, and every error that field.hpp promises.
#include "hashnoise/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "compare.hpp"
#include "fields.hpp"
#include "grid/functions.hpp"
#include "subjects.hpp"
#include "twin.hpp"

namespace hashnoise {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Settings of(const std::string& noise, const std::string& sum = "") {
  Settings settings;
  settings.noise = noise;
  settings.fractal = sum;
  return settings;
}

template <int D>
std::string error_of(const Settings& settings) {
  try {
    const Field<D> field(settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

std::string error_in(int dimensions, const Settings& settings) {
  std::string error;
  twin::in_dimensions(dimensions, [&]<int D>(std::integral_constant<int, D>) { error = error_of<D>(settings); });
  return error;
}

template <int D, typename Places>
std::string error_of(const Places& places, std::size_t numbers) {
  std::vector<float> values(numbers);
  try {
    Field<D>(Settings{}).fill(places, values);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

testing::AssertionResult has_parts(const std::string& text, const std::vector<std::string_view>& parts) {
  for (const std::string_view part : parts) {
    if (text.find(part) == std::string::npos) {
      return testing::AssertionFailure() << "'" << text << "' does not have '" << part << "'";
    }
  }
  return testing::AssertionSuccess();
}

// An error has a message.
#define EXPECT_ERROR(...) EXPECT_NE((__VA_ARGS__), "")
#define EXPECT_NO_ERROR(...) EXPECT_EQ((__VA_ARGS__), "")

// --- Accessors ------------------------------------------------------------------------------------------------------

TEST(Names, OfOtherDimensionsAreNone) {
  for (const int dimensions : {-1, 0, 5}) {
    try {
      EXPECT_TRUE(noises(dimensions).empty());
      EXPECT_TRUE(fractals(dimensions).empty());
    } catch (const std::invalid_argument&) {
    }
  }
}

// Each name is one of a field in the dimensions that list it, and an error in others.
TEST(Names, AreOfFieldsInTheirDimensions) {
  for (int d = 1; d <= 4; ++d) {
    for (int other = 1; other <= 4; ++other) {
      for (const std::string_view name : noises(other)) {
        EXPECT_EQ(error_in(d, of(std::string(name))).empty(), std::ranges::count(noises(d), name) == 1) << name << d;
      }
      for (const Settings& settings : twin::sum_subjects(other)) {
        const bool is_here = std::ranges::count(noises(d), settings.noise) == 1 || settings.noise.empty();
        EXPECT_EQ(error_in(d, settings).empty(), is_here && std::ranges::count(fractals(d), settings.fractal) == 1)
            << settings << d;
      }
    }
  }
}

template <int D>
std::vector<std::string> names_of(const std::string& noise, const std::string& sum = "") {
  const Field<D> field(of(noise, sum));
  const auto names = field.components();
  EXPECT_EQ(names.size(), static_cast<std::size_t>(field.component_count()));
  return names;
}

TEST(Components, AreNamed) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of<1>("perlin"), (Names{"value"}));
  EXPECT_EQ(names_of<2>("value_cubic"), (Names{"value"}));
  EXPECT_EQ(names_of<3>("cell_border"), (Names{"value"}));
  EXPECT_EQ(names_of<2>("cellular_smooth"), (Names{"value"}));
  EXPECT_EQ(names_of<1>("value_d"), (Names{"value", "dx"}));
  EXPECT_EQ(names_of<2>("simplex_d"), (Names{"value", "dx", "dy"}));
  EXPECT_EQ(names_of<3>("perlin_d"), (Names{"value", "dx", "dy", "dz"}));
  EXPECT_EQ(names_of<4>("perlin_d"), (Names{"value", "dx", "dy", "dz", "dw"}));
  EXPECT_EQ(names_of<2>("cellular"), (Names{"f1", "f2"}));
  EXPECT_EQ(names_of<3>("cellular"), (Names{"f1", "f2"}));
  EXPECT_EQ(names_of<3>("cellular_three"), (Names{"f1", "f2", "f3"}));
  EXPECT_EQ(names_of<2>("cellular_d"), (Names{"f1", "dx", "dy"}));
  EXPECT_EQ(names_of<3>("cellular_d"), (Names{"f1", "dx", "dy", "dz"}));
  EXPECT_EQ(names_of<2>("curl"), (Names{"x", "y"}));
  EXPECT_EQ(names_of<3>("curl"), (Names{"x", "y", "z"}));
  EXPECT_EQ(names_of<2>("phasor"), (Names{"value", "quadrature"}));
  EXPECT_EQ(names_of<3>("phasor"), (Names{"value", "quadrature"}));
  EXPECT_EQ(names_of<2>("perlin", "ridged"), (Names{"value"}));
  EXPECT_EQ(names_of<2>("perlin_d", "fbm_d"), (Names{"value", "dx", "dy"}));
  EXPECT_EQ(names_of<3>("simplex_d", "fbm_d"), (Names{"value", "dx", "dy", "dz"}));
  EXPECT_EQ(names_of<3>("perlin_d", "eroded"), (Names{"value"}));
  EXPECT_EQ(names_of<3>("", "perlin_worley"), (Names{"value"}));
  EXPECT_EQ(names_of<2>("value_vector", "warp"), (Names{"x", "y"}));
  EXPECT_EQ(names_of<3>("value_vector", "warp_progressive"), (Names{"x", "y", "z"}));
}

TEST(InstructionSets, AreNamedAndChosen) {
  const std::vector<InstructionSet> sets = instruction_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(std::set(sets.begin(), sets.end()).size(), sets.size());
  EXPECT_EQ(Field<2>(Settings{}).instruction_set(), sets.front());
  for (const InstructionSet set : sets) {
    Settings settings;
    settings.instruction_set = set;
    EXPECT_EQ(Field<3>(settings).instruction_set(), set);
  }
  EXPECT_EQ(name(InstructionSet::kSse41), "sse4.1");
  EXPECT_EQ(name(InstructionSet::kAvx2), "avx2");
  EXPECT_EQ(name(InstructionSet::kAvx512), "avx512");
  EXPECT_EQ(name(InstructionSet::kNeon), "neon");
  EXPECT_EQ(name(InstructionSet::kGeneric), "generic");
}

TEST(InstructionSets, AreTheWidestFirst) {
  const std::vector order = {InstructionSet::kAvx512, InstructionSet::kAvx2, InstructionSet::kSse41,
                             InstructionSet::kNeon, InstructionSet::kGeneric};
  const std::vector<InstructionSet> sets = instruction_sets();
  const auto place = [&](InstructionSet set) { return std::ranges::find(order, set); };
  EXPECT_TRUE(std::ranges::is_sorted(sets, {}, place));
}

TEST(InstructionSets, ThatAreNotHereAreErrors) {
  const std::vector<InstructionSet> sets = instruction_sets();
  int absent = 0;
  for (int i = 0; i <= static_cast<int>(InstructionSet::kGeneric); ++i) {
    const auto set = static_cast<InstructionSet>(i);
    if (std::ranges::find(sets, set) != sets.end()) continue;
    ++absent;
    Settings settings;
    settings.instruction_set = set;
    const std::string error = error_of<2>(settings);
    EXPECT_TRUE(has_parts(error, {name(set), name(sets.front())}));
  }
  EXPECT_GT(absent, 0);  // no processor has both SSE and NEON
}

TEST(Fields, Move) {
  static_assert(!std::is_copy_constructible_v<Field<2>>);
  static_assert(std::is_nothrow_move_constructible_v<Field<2>> && std::is_nothrow_move_assignable_v<Field<2>>);
  const Grid<2> grid = {{0.1f, 0.2f}, {0.3f, 0.4f}, {5, 6}};
  Field<2> first(of("perlin"));
  const auto perlin = twin::fill(first, grid, 30);
  Field<2> second(of("value_d"));
  const auto value = twin::fill(second, grid, 30);
  Field<2> moved(std::move(first));
  EXPECT_TRUE(twin::same_bits(twin::fill(moved, grid, 30).values, perlin.values, 30));
  moved = std::move(second);
  EXPECT_EQ(moved.component_count(), 3);
  EXPECT_TRUE(twin::same_bits(twin::fill(moved, grid, 30).values, value.values, 30));
}

// The settings and their names can go.
TEST(Fields, KeepTheirSettings) {
  auto settings = std::make_unique<Settings>(of("simplex", "fbm"));
  settings->seed = 5;
  const Field<2> field(*settings);
  const Field<2> other(*settings);
  *settings = of("perlin", "ridged");
  settings.reset();
  const Grid<2> grid = {{0.1f, 0.2f}, {0.3f, 0.4f}, {5, 6}};
  EXPECT_TRUE(twin::same_bits(twin::fill(field, grid, 30).values, twin::fill(other, grid, 30).values, 30));
}

// --- Nothing to fill -------------------------------------------------------------------------------------------------

template <int D>
void expect_empty_range() {
  std::vector<float> none;
  const Field<D> field(of("perlin_d"));
  Grid<D> grid;
  CellGrid<D> cells;
  for (std::size_t empty = 0; empty < D; ++empty) {
    grid.size.fill(7);
    grid.size[empty] = 0;
    cells.size = grid.size;
    EXPECT_EQ(field.fill(grid, none), Range{});
    EXPECT_EQ(field.fill(cells, none), Range{});
    EXPECT_EQ(field.fill(grid, none, threads(2)), Range{});
  }
  EXPECT_EQ(field.fill(Grid<D>{}, none), Range{});
  EXPECT_EQ(field.fill(CellGrid<D>{}, none), Range{});
  EXPECT_EQ(field.fill(Points<D>{}, none), Range{});
  EXPECT_EQ(field.fill(CellPoints<D>{}, none), Range{});
  EXPECT_EQ(field.fill(CellPoints<D>{}, none, threads(2)), Range{});
}
TEST(Range, OfNothingIsEmpty) {
  EXPECT_EQ(Range{}.least, kInfinity);
  EXPECT_EQ(Range{}.greatest, -kInfinity);
  expect_empty_range<1>();
  expect_empty_range<2>();
  expect_empty_range<3>();
  expect_empty_range<4>();
}

// The vectors reach behind the last point: the numbers there are no values. The first and the last point have the
// extremes of lists made for that.
TEST(Range, IsOfThePointsAndNoOthers) {
  for (const InstructionSet set : instruction_sets()) {
    for (const Arithmetic arithmetic : {Arithmetic::kFast, Arithmetic::kPrecise, Arithmetic::kFixed}) {
      for (int count = 1; count <= 40; ++count) {
        Settings settings = of("perlin");
        settings.arithmetic = arithmetic;
        settings.instruction_set = set;
        const Field<1> field(settings);
        // All points are one, whose value is not 0, as a point of zeros would have it.
        const std::vector<float> x(static_cast<std::size_t>(count), 0.375f);
        std::vector<float> values(x.size());
        const Range range = field.fill(Points<1>{{x}}, values);
        EXPECT_NE(values[0], 0.0f);
        EXPECT_EQ(range, (Range{values[0], values[0]})) << settings << ", points " << count;
        const Range of_grid = field.fill(Grid<1>{{0.375f}, {0.0f}, {count}}, values);
        EXPECT_EQ(of_grid, (Range{values[0], values[0]})) << settings << ", points " << count;
      }
    }
  }
}

TEST(Range, HasTheExtremesWhereverTheyAre) {
  const std::size_t count = 1009;
  for (const InstructionSet set : instruction_sets()) {
    Settings settings = of("value");
    settings.arithmetic = Arithmetic::kFixed;
    settings.instruction_set = set;
    const Field<1> field(settings);
    for (const std::size_t place : {std::size_t{0}, std::size_t{1}, std::size_t{500}, count - 2, count - 1}) {
      for (const float extreme : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f}) {
        std::vector<float> x(count, 0.25f);
        x[place] = extreme;
        std::vector<float> values(count);
        const Range range = field.fill(Points<1>{{x}}, values);
        EXPECT_EQ(range, twin::range_of(values, count));
        EXPECT_NE(range.least, range.greatest);
      }
    }
  }
}

// --- The usual noise -------------------------------------------------------------------------------------------------

// Without a wave and a phase there are 3 waves to a cell along x.
TEST(Settings, WithoutAWaveHaveTheUsualOne) {
  const Grid<3> grid = {{0.3f, -1.7f, 0.6f}, {0.17f, 0.23f, 0.11f}, {9, 7, 5}};
  Settings settings = of("phasor");
  const auto usual = twin::fill(Field<3>(settings), grid, 315);
  settings.wave = {3.0f, 0.0f, 0.0f};
  settings.phase = 0.0f;
  EXPECT_TRUE(twin::same_bits(twin::fill(Field<3>(settings), grid, 315).values, usual.values, 315));
  settings.wave[1] = 0.5f;
  EXPECT_FALSE(twin::same_bits(twin::fill(Field<3>(settings), grid, 315).values, usual.values, 315));
}

TEST(Settings, WithoutANoiseHaveTheUsualOne) {
  const Grid<2> grid = {{0.3f, -1.7f}, {0.17f, 0.23f}, {9, 7}};
  const auto values_of = [&](const Settings& settings) {
    const Field<2> field(settings);
    std::vector<float> values(static_cast<std::size_t>(field.component_count()) * 63);
    field.fill(grid, values);
    return values;
  };
  EXPECT_EQ(values_of(Settings{}), values_of(of("perlin")));
  for (const std::string& sum : twin::sums(2)) {
    EXPECT_EQ(values_of(of("", sum)), values_of(of(twin::noise_below(sum), sum))) << sum;
  }
  EXPECT_NE(values_of(of("", "warp")), values_of(of("perlin_vector", "warp")));
}

// --- Errors of settings ----------------------------------------------------------------------------------------------

// A setting by its name; a period along x, unless another axis is behind it, and the next component of a wave.
void set(Settings& s, const std::string& name, double value) {
  const auto whole = static_cast<int>(value);
  const auto number = static_cast<float>(value);
  const std::map<std::string, std::optional<float>*> numbers = {
      {"phase", &s.phase},   {"jitter", &s.jitter},      {"lacunarity", &s.lacunarity},
      {"gain", &s.gain},     {"strength", &s.strength},  {"amplitude", &s.amplitude},
      {"detail", &s.detail}, {"footprint", &s.footprint}};
  if (numbers.contains(name)) {
    *numbers.at(name) = number;
  } else if (name.starts_with("period")) {
    s.period.at(name == "period_z" ? 2 : name == "period_y" ? 1 : 0) = whole;
  } else if (name == "wave") {
    s.wave.push_back(number);
  } else if (name == "octaves") {
    s.octaves = whole;
  } else if (name == "metric") {
    s.metric = static_cast<Metric>(whole);
  } else if (name == "instruction_set") {
    s.instruction_set = static_cast<InstructionSet>(whole);
  } else if (name == "arithmetic") {
    s.arithmetic = static_cast<Arithmetic>(whole);
  } else {
    FAIL() << "there is no setting " << name;
  }
}

using Given = std::vector<std::pair<std::string, double>>;
Settings with(const std::string& noise, const std::string& fractal, const Given& given) {
  Settings settings = of(noise, fractal);
  for (const auto& [name, value] : given) set(settings, name, value);
  return settings;
}

// "perlin fbm gain=0.5": the noise, the fractal, each a - if it is left out, and settings.
Settings with(const std::string& text) {
  std::istringstream words(text);
  std::string noise, fractal;
  words >> noise >> fractal;
  Settings settings = of(noise == "-" ? "" : noise, fractal == "-" ? "" : fractal);
  for (std::string word; words >> word;) {
    const std::size_t at = word.find('=');
    set(settings, word.substr(0, at), std::stod(word.substr(at + 1)));
  }
  return settings;
}

constexpr int kMostInt = std::numeric_limits<int>::max();
constexpr int kLeastInt = std::numeric_limits<int>::min();
// The dimensions, the settings, and what the message has; nothing if they are right, and "*" for any message.
struct Row {
  int dimensions;
  const char* settings;
  std::string said = "*";
};
const std::vector<Row> kRows = {
    // Names.
    {2, "perlln -", "\"perlln\" in 2D (did you mean perlin?); there are: perlin, "},
    {2, "perlln -", "cell_border"},
    {2, "hn_value -", "\"hn_value\" in 2D (did you mean value?)"},
    {1, "hn_perlin -", "value_cubic"},
    {2, "opensimplex2 fbm", "\"opensimplex2\" in 2D (here it is simplex)"},
    {3, "Perlin -"},
    {2, "perlin fmb", "\"fmb\" in 2D (did you mean fbm?); there are: fbm, turbulence, "},
    {2, "perlin perlin"},
    {2, "fbm -"},
    {3, "simplex perlin_worley", "\"perlin_worley\" has noises of its own; leave the noise \"simplex\" out"},
    // Numbers that name nothing.
    {2, "cellular - metric=0"},
    {2, "cellular - metric=6"},
    {2, "cellular - metric=-1"},
    {2, "perlin - arithmetic=0"},
    {2, "perlin - arithmetic=4"},
    {2, "- - instruction_set=-1", "instruction_set has to be a value of InstructionSet; there are: "},
    {2, "- - instruction_set=5", "instruction_set has to be a value of InstructionSet; there are: "},
    // Numbers that functions change: cut off, or moved to the nearer end.
    {2, "perlin fbm gain=-0.5", "gain is -0.5, and has to be a finite number of 0 or more"},
    {2, "perlin fbm footprint=-0.25", "footprint is -0.25, and has to be a finite number of 0 or more"},
    {2, "perlin fbm lacunarity=2.5", ""},
    {2, "perlin fbm period=4 lacunarity=2.5",
     "lacunarity is 2.5, and has to be a whole number from 1 to 255 with a period"},
    {2, "perlin fbm period=4 lacunarity=0",
     "lacunarity is 0, and has to be a whole number from 1 to 255 with a period"},
    {2, "perlin - period=4", ""},  // a noise has none, and its default counts for nothing
    {2, "perlin fbm arithmetic=3 gain=1", ""},
    {2, "perlin fbm gain=1.5", ""},
    {2, "perlin fbm arithmetic=3 gain=1.5", "gain is 1.5, and has to be from 0 to 1 with fixed arithmetic"},
    {2, "perlin fbm arithmetic=3 lacunarity=-2", ", and has to be from 0 to 255 with fixed arithmetic"},
    {2, "perlin fbm arithmetic=3 lacunarity=256", ", and has to be from 0 to 255 with fixed arithmetic"},
    // Octaves that overflow.
    {2, "perlin fbm octaves=32 lacunarity=1e30",
     "with 32 octaves and a gain of 0.5 it has to be at most 8.55, or floats"},
    {2, "perlin fbm octaves=32 gain=1e6", "with 32 octaves and a lacunarity of 2 it has to be at most 4.27, or floats"},
    {2, "perlin fbm octaves=32 gain=4.27", ""},
    {2, "perlin fbm octaves=2 gain=1e6", ""},
    {2, "perlin fbm detail=31.5 gain=1e6"},
    // Waves.
    {2, "phasor -", ""},
    {2, "phasor - wave=16 wave=-16", ""},
    {2, "phasor - wave=0 wave=0", ""},
    {2, "phasor - wave=2.5", "wave has 1 component, and has to have 2 in 2D, one for each axis"},
    {2, "phasor - wave=2.5 wave=1.5 wave=0", "wave has 3 components, and has to have 2 in 2D, one for each axis"},
    {3, "phasor - wave=2.5 wave=1.5", "wave has 2 components, and has to have 3 in 3D, one for each axis"},
    {2, "perlin - wave=2.5 wave=1.5", "\"perlin\" in 2D has no wave; phasor has one in 2D and 3D"},
    // Details and footprints.
    {2, "perlin fbm detail=2.5", ""},
    {2, "perlin fbm detail=2.5 octaves=6", "detail stands in place of octaves; leave one out"},
    {2, "perlin fbm detail=2.5 footprint=1", "detail and footprint exclude each other; leave one out"},
    {1, "value fbm footprint=1", ""},
    {4, "simplex fbm footprint=1", ""},
    {2, "perlin fbm footprint=1 period_y=4"},
    {2, "perlin fbm detail=1 period_y=4"},
    {2, "perlin - detail=1"},
    {2, "perlin - footprint=1"},
};

TEST(Errors, OfSettings) {
  for (const Row& row : kRows) {
    const std::string error = error_in(row.dimensions, with(row.settings));
    EXPECT_EQ(error.empty(), row.said.empty()) << row.settings << ": " << error;
    EXPECT_TRUE(row.said == "*" || has_parts(error, {row.said})) << row.settings << ": " << error;
  }
  EXPECT_ERROR(error_of<3>(of("perlin ")));
  // It takes no distances.
  EXPECT_EQ(error_of<2>(of("opensimplex2", "fbm")).find("cellular,"), std::string::npos);
  for (const std::string& sum : twin::sums(2)) {
    EXPECT_EQ(error_of<2>(with("- " + sum + " detail=1")).empty(), sum == "fbm") << sum;
    EXPECT_EQ(error_of<2>(with("- " + sum + " footprint=1")).empty(), sum == "fbm") << sum;
  }
}

// A setting with its ends, in which it is right, and beyond which it is an error. The functions of GLSL would take the
// nearer end.
struct Ends {
  std::string noise, fractal, setting;
  double least, most;
  std::string said = "";
  Given given = {};
};

TEST(Errors, OfSettingsOutsideOfTheirRange) {
  const Given tile = {{"period", 4}, {"period_y", 4}};
  std::vector<Ends> all = {
      {"perlin", "ping_pong", "strength", 0, 64},
      {"perlin", "weighted", "strength", 0, 1},
      {"perlin_d", "eroded", "strength", 0, 16},
      {"value_vector", "warp", "amplitude", 0, 64},
      {"value_vector", "warp_progressive", "amplitude", 0, 64},
      {"cellular", "", "jitter", 0, 1},
      {"cellular_three", "", "jitter", 0, 1},
      {"cellular_d", "", "jitter", 0, 1},
      {"cellular_smooth", "", "jitter", 0, 1},
      {"cell_border", "", "jitter", 0, 1},
      {"perlin", "fbm", "detail", 0, 32},
      {"perlin", "fbm", "lacunarity", 1, 255, ", and has to be a whole number from 1 to 255 with a period", tile},
      {"phasor", "", "wave", -16, 16, "and has to be from -16 to 16", {{"wave", 1}}}};
  // A field of zeros is what nobody wants, and more octaves than 32 would count as 32 with HN_FIXED.
  for (const std::string& sum : twin::sums(2)) all.push_back({twin::noises_of(sum, 2).front(), sum, "octaves", 1, 32});
  for (const std::string sum : {"", "fbm"}) {
    for (const std::string setting : {"period", "period_y"}) {
      all.push_back({"perlin",
                     sum,
                     setting,
                     0,
                     kMostInt,
                     "period is -1, and has to be from 0 to 2147483647",
                     {{"period_z", -1}}});  // a plane has no third axis
    }
  }
  for (const Ends& of : all) {
    const bool is_int = of.setting == "octaves" || of.setting.starts_with("period");
    const auto error = [&](double value) {
      Given given = of.given;
      given.emplace_back(of.setting, value);
      return error_of<2>(with(of.noise, of.fractal, given));
    };
    for (const double right : {of.least, of.most, std::floor(0.5 * (of.least + of.most))}) {
      EXPECT_NO_ERROR(error(right)) << of.noise << of.fractal << " " << of.setting << " " << right;
    }
    const std::vector<double> near =
        is_int ? std::vector<double>{of.least - 1, double(kLeastInt), of.most < kMostInt ? of.most + 1 : of.least - 1}
               : std::vector<double>{std::nextafter(float(of.least), -1e9f),
                                     std::nextafter(float(of.most), 1e9f),
                                     of.least - 1,
                                     of.most + 1,
                                     1e9,
                                     -1e9};
    for (const double wrong : near) {
      const bool is_first = wrong == near.front();
      EXPECT_TRUE(
          has_parts(error(wrong), {of.setting.substr(0, of.setting.find('_')) + " is ", is_first ? of.said : ""}))
          << of.noise << of.fractal << " " << wrong;
    }
  }
  EXPECT_EQ(error_of<2>(with("perlin", "fbm", {{"octaves", 33}})), "octaves is 33, and has to be from 1 to 32");
}

TEST(Errors, OfSettingsThatAreNotFinite) {
  for (const double wrong : {double(kInfinity), -double(kInfinity), double(kNan)}) {
    for (const auto& [noise, fractal, setting] :
         std::vector<std::array<std::string, 3>>{{"perlin", "", "phase"},
                                                 {"cellular", "", "jitter"},
                                                 {"perlin", "fbm", "lacunarity"},
                                                 {"perlin", "fbm", "gain"},
                                                 {"perlin", "fbm", "detail"},
                                                 {"perlin", "fbm", "footprint"},
                                                 {"perlin", "ping_pong", "strength"},
                                                 {"value_vector", "warp", "amplitude"}}) {
      EXPECT_ERROR(error_of<2>(with(noise, fractal, {{setting, wrong}}))) << setting << " " << wrong;
    }
    EXPECT_ERROR(error_of<2>(with("phasor", "", {{"wave", wrong}, {"wave", 1}}))) << wrong;
    EXPECT_ERROR(error_of<2>(with("phasor", "", {{"wave", 1}, {"wave", wrong}}))) << wrong;
  }
}

// All pairs that are not among those of the twin.
template <int D>
void expect_errors_of_wrong_pairs() {
  for (const std::string& sum : twin::sums(D)) {
    const std::vector<std::string> right = twin::noises_of(sum, D);
    for (const twin::Noise& noise : twin::noises(D)) {
      if (std::ranges::find(right, noise.name) != right.end()) continue;
      const std::string error = error_of<D>(of(noise.name, sum));
      EXPECT_TRUE(has_parts(error, {noise.name})) << sum;
      EXPECT_TRUE(
          std::ranges::any_of(right, [&](const std::string& name) { return error.find(name) != std::string::npos; }))
          << error << ": it names nothing that would be right";
    }
  }
}
TEST(Errors, OfASumOverAnotherNoise) {
  expect_errors_of_wrong_pairs<1>();
  expect_errors_of_wrong_pairs<2>();
  expect_errors_of_wrong_pairs<3>();
  expect_errors_of_wrong_pairs<4>();
}

// A setting that is given is an error where the noise or the sum does not have it, also if it is what is usual.
template <int D>
void expect_errors_of_settings() {
  const auto expect = [](const Settings& of, const Given& given, bool is_right, std::string_view said = "") {
    const Settings settings = with(of.noise, of.fractal, given);
    const std::string error = error_of<D>(settings);
    EXPECT_EQ(error.empty(), is_right) << settings << ": " << error;
    EXPECT_TRUE(has_parts(error, {said})) << settings;
  };
  const Given wave(D, {"wave", 3});
  for (const twin::Noise& noise : twin::noises(D)) {
    const Settings one = of(noise.name);
    const bool has_phase = twin::can_have_phase(noise.name, D), has_metric = twin::has_metric(noise.name);
    expect(one, {{"phase", 0}}, has_phase);
    expect(one, {{"jitter", 1}}, twin::has_jitter(noise.name));
    expect(one, {{"metric", 1}}, has_metric);
    expect(one, {{"metric", 1}, {"phase", 0}}, has_metric && has_phase);
    expect(one, {{"metric", 3}, {"phase", 0}}, false);
    expect(one, wave, twin::has_wave(noise.name));
    expect(one, {{"strength", 1}}, false);
    // The settings of sums, also where they have their defaults.
    for (const auto& [setting, usual] : Given{{"octaves", 6}, {"lacunarity", 2}, {"gain", 0.5}, {"amplitude", 1}}) {
      expect(one, {{setting, usual}}, false, "has no");
    }
  }
  for (const Settings& subject : twin::sum_subjects(D)) {
    for (const auto& [setting, value] : Given{{"phase", 0.25}, {"jitter", 0.5}, {"metric", 3}}) {
      expect(subject, {{setting, value}}, false);
    }
    expect(subject, wave, false, "has no wave; phasor has one in 2D and 3D");
    expect(subject, {{"strength", 1}}, grid::sum_row(subject.fractal).strength == "strength");
    expect(subject, {{"amplitude", 1}}, subject.fractal.starts_with("warp"));
    expect(subject, {{"octaves", 6}, {"lacunarity", 2}, {"gain", 0.5}}, true);
  }
}
TEST(Errors, OfAPhaseAJitterAMetricOrAStrengthWhereThereIsNone) {
  expect_errors_of_settings<1>();
  expect_errors_of_settings<2>();
  expect_errors_of_settings<3>();
  expect_errors_of_settings<4>();
}

// With the greatest allowed settings everything is a number: positions at the end of the domain, in each sum.
TEST(Values, AreFiniteAtTheEndsOfWhatIsAllowed) {
  for (const std::string& sum : twin::sums(2)) {
    for (const int octaves : {2, 5, 32}) {
      const auto growth = static_cast<float>(std::exp2(96.0 / (octaves - 1)) * 0.999);
      for (const auto& [lacunarity, gain] : {std::pair(growth, 0.5f), std::pair(-growth, 1.0f), std::pair(1.0f, growth),
                                             std::pair(std::sqrt(growth), std::sqrt(growth))}) {
        for (const Arithmetic arithmetic : {Arithmetic::kFast, Arithmetic::kPrecise}) {
          Settings settings = of("", sum);
          settings.octaves = octaves;
          settings.lacunarity = lacunarity;
          settings.gain = gain;
          settings.arithmetic = arithmetic;
          const Field<2> field(settings);
          const std::vector<float> x = {0.3f, -8388607.0f, 8388607.0f, 4194303.75f, 1e-30f};
          const std::vector<float> y = {0.7f, 8388607.0f, 8388607.0f, -0.25f, -77.7f};
          std::vector<float> values(x.size() * static_cast<std::size_t>(field.component_count()));
          field.fill(Points<2>{{x, y}}, values);
          for (const float value : values) EXPECT_TRUE(std::isfinite(value)) << settings;
        }
      }
    }
  }
}

// --- Coordinates that are no numbers ---------------------------------------------------------------------------------

void expect_nan(Settings settings) {
  constexpr std::size_t kPoints = 40;
  constexpr std::array<float, 3> kNone = {kNan, kInfinity, -kInfinity};
  const std::vector<float> usual(kPoints, 0.375f);
  const std::vector<std::int32_t> cells(kPoints, 7);
  for (const Arithmetic arithmetic : {Arithmetic::kFast, Arithmetic::kPrecise, Arithmetic::kFixed}) {
    settings.arithmetic = arithmetic;
    const Field<2> field(settings);
    std::vector<float> values(kPoints * static_cast<std::size_t>(field.component_count()));
    for (const bool is_x : {true, false}) {
      std::vector<float> other = usual;
      for (const std::size_t at : {0, 17, 39}) other[at] = kNone[at % 3];
      const auto& x = is_x ? other : usual;
      const auto& y = is_x ? usual : other;
      for (const bool has_cells : {true, false}) {
        const Range range = has_cells ? field.fill(CellPoints<2>{{cells, cells}, {x, y}}, values)
                                      : field.fill(Points<2>{{x, y}}, values);
        EXPECT_TRUE(std::isfinite(range.least) && range.least == range.greatest) << settings;
        for (std::size_t i = 0; i < values.size(); ++i) {
          const std::size_t component = i / kPoints;
          EXPECT_EQ(std::isnan(values[i]), !std::isfinite(other[i % kPoints])) << settings << " at " << i;
          if (!std::isfinite(other[i % kPoints])) continue;
          EXPECT_EQ(values[i], values[component * kPoints + 1]) << settings;
        }
      }
    }
  }
}

// No number comes out, of any arithmetic and in any component, and the points beside it are what they are without it.
TEST(Values, AreNoNumbersWhereCoordinatesAreNone) {
  for (const twin::Noise& noise : twin::noises(2)) expect_nan(of(noise.name));
  for (const std::string& sum : twin::sums(2)) expect_nan(of("", sum));
}

// Octaves of 2.9 would be 2.
static_assert(std::is_constructible_v<OptionalInt, int> && std::is_assignable_v<OptionalInt&, int>);
static_assert(std::is_assignable_v<OptionalInt&, std::optional<int>> &&
              std::is_assignable_v<OptionalInt&, std::nullopt_t>);
static_assert(!std::is_convertible_v<float, OptionalInt> && !std::is_convertible_v<double&, OptionalInt>);
static_assert(!std::is_assignable_v<OptionalInt&, float> && !std::is_assignable_v<OptionalInt&, const double&>);

// In cells positions are whole numbers, with any arithmetic.
TEST(Errors, OfALacunarityInCells) {
  for (const float lacunarity : {-2.0f, 256.0f, 255.0f}) {
    Settings settings = of("perlin", "fbm");
    settings.octaves = 4;
    settings.lacunarity = lacunarity;
    const Field<1> field(settings);
    std::vector<float> values(1);
    const std::vector<std::int32_t> cell = {3};
    const std::vector<float> f = {0.5f};
    EXPECT_NO_THROW(field.fill(Grid<1>{{3.5f}, {1.0f}, {1}}, values));
    if (lacunarity == 255.0f) {
      EXPECT_NO_THROW(field.fill(CellPoints<1>{{cell}, {f}}, values));
      continue;
    }
    EXPECT_THROW(field.fill(CellGrid<1>{{3}, {0.5f}, {1.0}, {1}}, values), std::invalid_argument);
    EXPECT_THROW(field.fill(CellPoints<1>{{cell}, {f}}, values), std::invalid_argument);
  }
}

// There is no such form from a cell. So it is an error of filling, if not of the field.
TEST(Errors, OfADetailOrAFootprintFromCells) {
  for (const bool is_detail : {true, false}) {
    Settings settings = of("perlin", "fbm");
    (is_detail ? settings.detail : settings.footprint) = 1.0f;
    const Field<1> field(settings);
    std::vector<float> values(1);
    const std::vector<std::int32_t> cell = {3};
    const std::vector<float> f = {0.5f};
    EXPECT_THROW(field.fill(CellGrid<1>{{3}, {0.5f}, {1.0}, {1}}, values), std::invalid_argument);
    EXPECT_THROW(field.fill(CellPoints<1>{{cell}, {f}}, values), std::invalid_argument);
    EXPECT_NO_THROW(field.fill(Grid<1>{{3.5f}, {1.0f}, {1}}, values));
  }
}

// --- Errors of places ------------------------------------------------------------------------------------------------

TEST(Errors, OfValuesOfAnotherSize) {
  const Grid<2> grid = {{0, 0}, {1, 1}, {3, 4}};
  const CellGrid<2> cells = {{0, 0}, {0, 0}, {1, 1}, {3, 4}};
  const std::vector<float> floats(12);
  const std::vector<std::int32_t> ints(12);
  const Points<2> points = {{floats, floats}};
  const CellPoints<2> cell_points = {{ints, ints}, {floats, floats}};
  EXPECT_NO_ERROR(error_of<2>(grid, 12));
  EXPECT_NO_ERROR(error_of<2>(cells, 12));
  EXPECT_NO_ERROR(error_of<2>(points, 12));
  EXPECT_NO_ERROR(error_of<2>(cell_points, 12));
  for (const std::size_t wrong : {0, 1, 11, 13, 24}) {
    EXPECT_ERROR(error_of<2>(grid, wrong)) << wrong;
    EXPECT_ERROR(error_of<2>(cells, wrong)) << wrong;
    EXPECT_ERROR(error_of<2>(points, wrong)) << wrong;
    EXPECT_ERROR(error_of<2>(cell_points, wrong)) << wrong;
  }
  EXPECT_TRUE(has_parts(error_of<2>(grid, 11), {"11", "12"}));
  EXPECT_ERROR(error_of<2>(Grid<2>{{0, 0}, {1, 1}, {0, 4}}, 4));
  // With several components.
  std::vector<float> values(12);
  EXPECT_THROW(Field<2>(of("perlin_d")).fill(grid, values), std::invalid_argument);
  values.resize(36);
  EXPECT_NO_THROW(Field<2>(of("perlin_d")).fill(grid, values));
}

TEST(Errors, OfAxesOfUnequalLength) {
  const std::vector<float> two(2);
  const std::vector<float> three(3);
  const std::vector<std::int32_t> two_ints(2);
  const std::vector<std::int32_t> three_ints(3);
  for (const std::size_t numbers : {2, 3}) {
    EXPECT_ERROR(error_of<2>(Points<2>{{two, three}}, numbers));
    EXPECT_ERROR(error_of<2>(Points<2>{{three, two}}, numbers));
    EXPECT_ERROR(error_of<3>(Points<3>{{two, two, three}}, numbers));
    EXPECT_ERROR(error_of<2>(CellPoints<2>{{two_ints, three_ints}, {two, two}}, numbers));
    EXPECT_ERROR(error_of<2>(CellPoints<2>{{two_ints, two_ints}, {two, three}}, numbers));
    EXPECT_ERROR(error_of<2>(CellPoints<2>{{two_ints, two_ints}, {three, three}}, numbers));
    EXPECT_ERROR(error_of<1>(CellPoints<1>{{three_ints}, {two}}, numbers));
    const std::span<const float> none;
    EXPECT_ERROR(error_of<2>(Points<2>{{none, two}}, 0));
    EXPECT_ERROR(error_of<2>(Points<2>{{two, none}}, numbers));
  }
}

TEST(Errors, OfSizes) {
  for (const int wrong : {-1, std::numeric_limits<int>::min(), 1 << 29, std::numeric_limits<int>::max()}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int other : {1, 0}) {
        Grid<3> grid;
        grid.size.fill(other);
        grid.size[axis] = wrong;
        CellGrid<3> cells;
        cells.size = grid.size;
        EXPECT_ERROR(error_of<3>(grid, 0)) << wrong;
        EXPECT_ERROR(error_of<3>(cells, 0)) << wrong;
      }
    }
  }
}

TEST(Errors, OfAFirstPoint) {
  const Grid<2> right = {{0, 0}, {1, 1}, {2, 2}, {0, 536870909}};
  EXPECT_NO_ERROR(error_of<2>(right, 4));
  EXPECT_NO_ERROR(error_of<2>(Grid<2>{{0, 0}, {1, 1}, {2, 2}, {0, -536870911}}, 4));
  for (const int wrong : {-536870912, std::numeric_limits<int>::min(), 536870910, std::numeric_limits<int>::max()}) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Grid<2> grid = right;
      grid.first[axis] = wrong;
      CellGrid<2> cells = {{0, 0}, {0, 0}, {1, 1}, {2, 2}};
      cells.first[axis] = wrong;
      const std::string said =
          "first is " + std::to_string(wrong) + ", and has to be from -536870911 to 536870909 where the size is 2";
      EXPECT_EQ(error_of<2>(grid, 4), said);
      EXPECT_EQ(error_of<2>(cells, 4), said);
    }
  }
  // The last or the first point of the part is no finite float.
  EXPECT_ERROR(error_of<2>(Grid<2>{{3e38f, 0}, {1e37f, 1}, {2, 2}, {10, 0}}, 4));
  EXPECT_ERROR(error_of<2>(Grid<2>{{-3e38f, 0}, {1e37f, 1}, {2, 2}, {-10, 0}}, 4));
}

// The product of these is a multiple of 2^64, or of 2^32. It is noticed before anything is done for any point: that
// would take gigabytes and minutes.
TEST(Errors, OfProductsOfSizesThatOverflow) {
  const std::clock_t start = std::clock();
  const int large = 1 << 28;
  Grid<4> grid;
  grid.size.fill(large);
  EXPECT_ERROR(error_of<4>(grid, 0));
  CellGrid<4> cells;
  cells.size.fill(large);
  EXPECT_ERROR(error_of<4>(cells, 0));
  grid.size = {large, large, 256, 1};
  EXPECT_ERROR(error_of<4>(grid, 0));
  grid.size = {large, 16, 1, 1};
  EXPECT_ERROR(error_of<4>(grid, 0));
  grid.size = {-2, -3, 1, 1};
  EXPECT_ERROR(error_of<4>(grid, 6));
  // Times the components it is 2^64.
  Grid<3> three;
  three.size = {large, large, 64};
  std::vector<float> none;
  EXPECT_THROW(Field<3>(of("perlin_d")).fill(three, none), std::invalid_argument);
  EXPECT_LT(std::clock() - start, 5 * CLOCKS_PER_SEC);  // processor time
}

TEST(Errors, OfPlacesThatAreNotFinite) {
  for (const float wrong : {kInfinity, -kInfinity, kNan}) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Grid<2> right = {{0, 0}, {1, 1}, {2, 2}};
      Grid<2> grid = right;
      grid.origin[axis] = wrong;
      EXPECT_ERROR(error_of<2>(grid, 4)) << wrong;
      grid = right;
      grid.step[axis] = wrong;
      EXPECT_ERROR(error_of<2>(grid, 4)) << wrong;
      const CellGrid<2> right_cells = {{0, 0}, {0, 0}, {1, 1}, {2, 2}};
      CellGrid<2> cells = right_cells;
      cells.f[axis] = wrong;
      EXPECT_ERROR(error_of<2>(cells, 4)) << wrong;
      cells = right_cells;
      cells.step[axis] = static_cast<double>(wrong);
      EXPECT_ERROR(error_of<2>(cells, 4)) << wrong;
    }
  }
}

TEST(Errors, OfAPlaceOutsideOfItsCell) {
  for (const float wrong : {-0x1p-149f, 1.0f + 0x1p-23f, 6.5f}) {
    EXPECT_TRUE(
        has_parts(error_of<2>(CellGrid<2>{{0, 0}, {0, wrong}, {1, 1}, {2, 2}}, 4), {"f of a grid is ", "from 0 to 1"}))
        << wrong;
  }
  EXPECT_NO_ERROR(error_of<2>(CellGrid<2>{{0, 0}, {-0.0f, 1.0f}, {1, 1}, {2, 2}}, 4));
}

TEST(Errors, OfPlacesThatAreTooLarge) {
  for (const double wrong : {0x1p31, -0x1p31, 0x1p31 - 0x1p-33, 1e300, -1e300}) {
    EXPECT_ERROR(error_of<2>(CellGrid<2>{{0, 0}, {0, 0}, {1, wrong}, {2, 2}}, 4)) << wrong;
  }
  for (const double right : {0x1p31 - 1, -0x1p31 + 1, 0x1p31 - 0x1p-21}) {
    EXPECT_NO_ERROR(error_of<2>(CellGrid<2>{{0, 0}, {0, 0}, {1, right}, {2, 2}}, 4)) << right;
  }
  // The last point is no finite float.
  EXPECT_ERROR(error_of<2>(Grid<2>{{3e38f, 0}, {1e38f, 1}, {2, 2}}, 4));
  EXPECT_ERROR(error_of<2>(Grid<2>{{0, -3e38f}, {1, -1e38f}, {2, 2}}, 4));
}

// A field is as good after an error as before.
TEST(Errors, LeaveTheFieldAsItIs) {
  const Field<2> field(of("perlin"));
  const Grid<2> grid = {{0.1f, 0.2f}, {0.3f, 0.4f}, {5, 6}};
  const auto before = twin::fill(field, grid, 30);
  std::vector<float> values(29, -1.0f);
  EXPECT_THROW(field.fill(grid, values, threads(2)), std::invalid_argument);
  EXPECT_EQ(values, std::vector<float>(29, -1.0f));
  EXPECT_TRUE(twin::same_bits(twin::fill(field, grid, 30).values, before.values, 30));
}

}  // namespace
}  // namespace hashnoise
