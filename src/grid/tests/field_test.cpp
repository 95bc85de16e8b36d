// Tests the descriptions of a field, empty grids, and every error that field.hpp promises.
#include "hashnoise/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
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

// Of each shape.
TEST(Components, AreNamed) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of<3>("cell_border"), (Names{"value"}));
  EXPECT_EQ(names_of<1>("value_d"), (Names{"value", "dx"}));
  EXPECT_EQ(names_of<4>("perlin_d"), (Names{"value", "dx", "dy", "dz", "dw"}));
  EXPECT_EQ(names_of<2>("cellular"), (Names{"f1", "f2"}));
  EXPECT_EQ(names_of<3>("cellular_three"), (Names{"f1", "f2", "f3"}));
  EXPECT_EQ(names_of<3>("cellular_d"), (Names{"f1", "dx", "dy", "dz"}));
  EXPECT_EQ(names_of<2>("curl"), (Names{"x", "y"}));
  EXPECT_EQ(names_of<2>("phasor"), (Names{"value", "quadrature"}));
  EXPECT_EQ(names_of<2>("perlin", "ridged"), (Names{"value"}));
  EXPECT_EQ(names_of<3>("simplex_d", "fbm_d"), (Names{"value", "dx", "dy", "dz"}));
  EXPECT_EQ(names_of<3>("", "perlin_worley"), (Names{"value"}));
  EXPECT_EQ(names_of<3>("value_vector", "warp_progressive"), (Names{"x", "y", "z"}));
}

TEST(InstructionSets, AreNamedAndChosenAndTheWidestFirst) {
  const std::vector<std::pair<InstructionSet, std::string_view>> order = {{InstructionSet::kAvx512, "avx512"},
                                                                          {InstructionSet::kAvx2, "avx2"},
                                                                          {InstructionSet::kSse41, "sse4.1"},
                                                                          {InstructionSet::kNeon, "neon"},
                                                                          {InstructionSet::kGeneric, "generic"}};
  std::vector<InstructionSet> expected;
  const std::vector<InstructionSet> sets = instruction_sets();
  for (const auto& [set, its_name] : order) {
    EXPECT_EQ(name(set), its_name);
    if (std::ranges::count(sets, set) == 0) continue;
    expected.push_back(set);
    Settings settings;
    settings.instruction_set = set;
    EXPECT_EQ(Field<3>(settings).instruction_set(), set);
  }
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets, expected);
  EXPECT_EQ(Field<2>(Settings{}).instruction_set(), sets.front());
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

TEST(Range, OfNothingIsEmpty) {
  EXPECT_EQ(Range{}.least, kInfinity);
  EXPECT_EQ(Range{}.greatest, -kInfinity);
  std::vector<float> none;
  const Field<3> field(of("perlin_d"));
  for (std::size_t empty = 0; empty < 3; ++empty) {
    std::array<int, 3> size = {7, 7, 7};
    size[empty] = 0;
    for (const Executor& executor : {Executor(), threads(2)}) {
      EXPECT_EQ(field.fill(Grid<3>{{}, {}, size}, none, executor), Range{});
      EXPECT_EQ(field.fill(CellGrid<3>{{}, {}, {}, size}, none, executor), Range{});
      EXPECT_EQ(field.fill(Points<3>{}, none, executor), Range{});
      EXPECT_EQ(field.fill(CellPoints<3>{}, none, executor), Range{});
    }
  }
}

// --- The usual noise -------------------------------------------------------------------------------------------------

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

using Given = std::vector<std::pair<std::string, double>>;
Settings with(const std::string& noise, const std::string& fractal, const Given& given) {
  Settings settings = of(noise, fractal);
  for (const auto& [name, value] : given) twin::set(settings, name, value);
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
    twin::set(settings, word.substr(0, at), std::stod(word.substr(at + 1)));
  }
  return settings;
}

constexpr int kMostInt = std::numeric_limits<int>::max();
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
// nearer end. A field of zeros is what nobody wants, and more octaves than 32 would count as 32 with HN_FIXED.
struct Ends {
  const char* settings;
  double least, most;
};
const std::vector<Ends> kEnds = {{"perlin ping_pong strength", 0, 64},
                                 {"perlin weighted strength", 0, 1},
                                 {"perlin_d eroded strength", 0, 16},
                                 {"value_vector warp amplitude", 0, 64},
                                 {"cellular - jitter", 0, 1},
                                 {"perlin fbm detail", 0, 32},
                                 {"perlin fbm octaves", 1, 32},
                                 {"perlin fbm period=4 lacunarity", 1, 255},
                                 {"phasor - wave=1 wave", -16, 16},
                                 {"perlin - period", 0, kMostInt},
                                 {"perlin fbm period_z=-1 period_y", 0, kMostInt}};  // a plane has no third axis

TEST(Errors, OfSettingsOutsideOfTheirRange) {
  for (const Ends& ends : kEnds) {
    const std::string text = ends.settings;
    const auto error = [&](double value) { return error_of<2>(with(text + "=" + std::to_string(value))); };
    for (const double right : {ends.least, ends.most}) EXPECT_NO_ERROR(error(right)) << text << " " << right;
    std::string setting = text.substr(text.rfind(' ') + 1);
    setting = setting.substr(0, setting.find('_'));
    EXPECT_TRUE(has_parts(error(ends.least - 1), {setting + " is ", ", and has to be "})) << text;
    if (ends.most == kMostInt) continue;
    EXPECT_TRUE(has_parts(error(ends.most + 1), {setting + " is "})) << text;
  }
  for (const char* const setting :
       {"perlin - phase=", "cellular - jitter=", "perlin fbm lacunarity=", "perlin fbm gain=", "perlin fbm detail=",
        "perlin fbm footprint=", "perlin ping_pong strength=", "value_vector warp amplitude=",
        "phasor - wave=1 wave="}) {
    for (const char* const none : {"inf", "-inf", "nan"}) {
      EXPECT_ERROR(error_of<2>(with(std::string(setting) + none))) << setting << none;
    }
  }
}

TEST(Errors, OfABandwidth) {
  const auto error = [](const Settings& settings, float bandwidth) {
    try {
      const Field<2> field(settings, {.bandwidth = bandwidth});
    } catch (const std::invalid_argument& wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  for (const float right : {0.0f, 16.0f}) EXPECT_EQ(error(of("phasor"), right), "");
  for (const float wrong : {-0.5f, 16.5f, NAN}) {
    EXPECT_TRUE(has_parts(error(of("phasor"), wrong), {"bandwidth is ", ", and has to be from 0 to 16"})) << wrong;
  }
  EXPECT_EQ(error(of("perlin"), 0.0f), "\"perlin\" in 2D has no bandwidth; phasor has one in 2D and 3D");
}

// A bandwidth of 0 changes no bit, and others do, also in a tile.
TEST(Values, OfABandwidth) {
  for (const Arithmetic arithmetic : {Arithmetic::kFast, Arithmetic::kPrecise, Arithmetic::kFixed}) {
    for (const int period : {0, 4}) {
      Settings settings = of("phasor");
      settings.arithmetic = arithmetic;
      settings.period = {period, period};
      std::vector<float> plain(2 * 64 * 64), zero(plain.size()), wide(plain.size());
      const Grid<2> grid{{0, 0}, {0.07f, 0.07f}, {64, 64}};
      Field<2>(settings).fill(grid, plain);
      Field<2>(settings, {.bandwidth = 0.0f}).fill(grid, zero);
      Field<2>(settings, {.bandwidth = 1.5f}).fill(grid, wide);
      EXPECT_EQ(plain, zero);
      EXPECT_NE(plain, wide);
    }
  }
}

// All pairs that are not among those of the twin.
TEST(Errors, OfASumOverAnotherNoise) {
  constexpr int D = 3;
  for (const std::string& sum : twin::sums(D)) {
    const std::vector<std::string> right = twin::noises_of(sum, D);
    for (const std::string& noise : twin::noises(D)) {
      if (std::ranges::find(right, noise) != right.end()) continue;
      const std::string error = error_of<D>(of(noise, sum));
      EXPECT_TRUE(has_parts(error, {noise})) << sum;
      EXPECT_TRUE(
          std::ranges::any_of(right, [&](const std::string& name) { return error.find(name) != std::string::npos; }))
          << error << ": it names nothing that would be right";
    }
  }
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
  for (const std::string& noise : twin::noises(D)) {
    const Settings one = of(noise);
    const bool has_phase = twin::can_have_phase(noise, D), has_metric = twin::row_of(noise).has_metric();
    expect(one, {{"phase", 0}}, has_phase);
    expect(one, {{"jitter", 1}}, twin::row_of(noise).has_jitter());
    expect(one, {{"metric", 1}}, has_metric);
    expect(one, {{"metric", 1}, {"phase", 0}}, has_metric && has_phase);
    expect(one, {{"metric", 3}, {"phase", 0}}, false);
    expect(one, wave, twin::row_of(noise).has_wave());
    expect(one, {{"strength", 1}}, false);
    // The settings of sums, also where they have their defaults.
    for (const auto& [setting, usual] : Given{{"octaves", 6}, {"lacunarity", 2}, {"gain", 0.5}, {"amplitude", 1}}) {
      expect(one, {{setting, usual}}, false, "has no");
    }
  }
  for (const Settings& subject : twin::sum_subjects(D)) {
    expect(subject, {{"phase", 0.25}}, grid::sum_row(subject.fractal).has_phase);
    for (const auto& [setting, value] : Given{{"jitter", 0.5}, {"metric", 3}}) {
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
  for (const std::string& noise : twin::noises(2)) expect_nan(of(noise));
  for (const std::string& sum : twin::sums(2)) expect_nan(of("", sum));
}

// Octaves of 2.9 would be 2.
static_assert(std::is_constructible_v<OptionalInt, int> && std::is_assignable_v<OptionalInt&, int>);
static_assert(std::is_assignable_v<OptionalInt&, std::optional<int>> &&
              std::is_assignable_v<OptionalInt&, std::nullopt_t>);
static_assert(!std::is_convertible_v<float, OptionalInt> && !std::is_convertible_v<double&, OptionalInt>);
static_assert(!std::is_assignable_v<OptionalInt&, float> && !std::is_assignable_v<OptionalInt&, const double&>);

// In cells positions are whole numbers, with any arithmetic; and there is no detail or footprint from a cell.
TEST(Errors, OfSumsInCells) {
  const std::vector<std::int32_t> cell = {3};
  const std::vector<float> f = {0.5f};
  std::vector<float> values(1);
  for (const char* const wrong : {"lacunarity=-2", "lacunarity=256", "detail=1", "footprint=1", "lacunarity=255"}) {
    const Field<1> field(with(std::string("perlin fbm ") + wrong));
    EXPECT_NO_THROW(field.fill(Grid<1>{{3.5f}, {1.0f}, {1}}, values));
    const bool is_right = std::string(wrong) == "lacunarity=255";
    for (const auto& fill : {std::function<void()>([&] {
                               field.fill(CellPoints<1>{{cell}, {f}}, values);
                             }),
                             std::function<void()>([&] {
                               field.fill(CellGrid<1>{{3}, {0.5f}, {1.0}, {1}}, values);
                             })}) {
      if (is_right) {
        EXPECT_NO_THROW(fill());
      } else {
        EXPECT_THROW(fill(), std::invalid_argument) << wrong;
      }
    }
  }
}

// --- Errors of places ------------------------------------------------------------------------------------------------

TEST(Errors, OfValuesOfAnotherSize) {
  const std::vector<float> floats(12);
  const std::vector<std::int32_t> ints(12);
  for (const std::size_t numbers : {0, 1, 11, 12, 13, 24}) {
    const std::string said = numbers == 12 ? ""
                                           : "there is room for " + std::to_string(numbers) +
                                                 " values, and there "
                                                 "have to be 12: 1 at each of 12 points";
    EXPECT_EQ(error_of<2>(Grid<2>{{0, 0}, {1, 1}, {3, 4}}, numbers), said);
    EXPECT_EQ(error_of<2>(CellGrid<2>{{0, 0}, {0, 0}, {1, 1}, {3, 4}}, numbers), said);
    EXPECT_EQ(error_of<2>(Points<2>{{floats, floats}}, numbers), said);
    EXPECT_EQ(error_of<2>(CellPoints<2>{{ints, ints}, {floats, floats}}, numbers), said);
  }
  EXPECT_ERROR(error_of<2>(Grid<2>{{0, 0}, {1, 1}, {0, 4}}, 4));
  // With several components.
  std::vector<float> values(12);
  EXPECT_THROW(Field<2>(of("perlin_d")).fill(Points<2>{{floats, floats}}, values), std::invalid_argument);
  values.resize(36);
  EXPECT_NO_THROW(Field<2>(of("perlin_d")).fill(Points<2>{{floats, floats}}, values));
}

TEST(Errors, OfAxesOfUnequalLength) {
  const std::vector<float> two(2), three(3);
  const std::vector<std::int32_t> two_ints(2), three_ints(3);
  for (const std::size_t numbers : {2, 3}) {
    EXPECT_ERROR(error_of<2>(Points<2>{{three, two}}, numbers));
    EXPECT_ERROR(error_of<3>(Points<3>{{two, two, three}}, numbers));
    EXPECT_ERROR(error_of<2>(CellPoints<2>{{two_ints, three_ints}, {two, two}}, numbers));
    EXPECT_ERROR(error_of<2>(CellPoints<2>{{two_ints, two_ints}, {two, three}}, numbers));
    EXPECT_ERROR(error_of<1>(CellPoints<1>{{three_ints}, {two}}, numbers));
  }
  EXPECT_ERROR(error_of<2>(Points<2>{{std::span<const float>(), two}}, 0));
}

// Grids of 2 by 2 points with a number of one axis that is wrong; and what the message has.
TEST(Errors, OfPlaces) {
  const Grid<2> grid = {{0, 0}, {1, 1}, {2, 2}};
  const CellGrid<2> cells = {{0, 0}, {0, 0}, {1, 1}, {2, 2}};
  const auto expect = [](const auto& right, auto member, auto number, const std::string& said) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      auto places = right;
      (places.*member)[axis] = number;
      const std::string error = error_of<2>(places, 4);
      EXPECT_EQ(error.empty(), said.empty()) << number;
      EXPECT_TRUE(has_parts(error, {said})) << number;
    }
  };
  for (const int wrong : {-1, std::numeric_limits<int>::min(), 1 << 29, kMostInt}) {
    expect(grid, &Grid<2>::size, wrong, "size is " + std::to_string(wrong));
    expect(cells, &CellGrid<2>::size, wrong, "size is " + std::to_string(wrong));
  }
  for (const int wrong : {-536870912, std::numeric_limits<int>::min(), 536870910, kMostInt}) {
    const std::string said =
        "first is " + std::to_string(wrong) + ", and has to be from -536870911 to 536870909 where the size is 2";
    expect(grid, &Grid<2>::first, wrong, said);
    expect(cells, &CellGrid<2>::first, wrong, said);
  }
  for (const int right : {536870909, -536870911}) expect(grid, &Grid<2>::first, right, "");
  for (const float wrong : {kInfinity, -kInfinity, kNan}) {
    expect(grid, &Grid<2>::origin, wrong, "the origin of a grid has to be finite");
    expect(grid, &Grid<2>::step, wrong, "the step of a grid has to be finite");
    expect(cells, &CellGrid<2>::f, wrong, "f of a grid is ");
    expect(cells, &CellGrid<2>::step, static_cast<double>(wrong), "the step of a grid has to be finite");
  }
  for (const float wrong : {-0x1p-149f, 1.0f + 0x1p-23f, 6.5f}) expect(cells, &CellGrid<2>::f, wrong, "from 0 to 1");
  for (const float right : {-0.0f, 1.0f}) expect(cells, &CellGrid<2>::f, right, "");
  for (const double wrong : {0x1p31, -0x1p31, 0x1p31 - 0x1p-33, 1e300}) {
    expect(cells, &CellGrid<2>::step, wrong, "less than 2^31 cells");
  }
  for (const double right : {-0x1p31 + 1, 0x1p31 - 0x1p-21}) expect(cells, &CellGrid<2>::step, right, "");
  // The last or the first point is no finite float.
  EXPECT_ERROR(error_of<2>(Grid<2>{{0, -3e38f}, {1, -1e38f}, {2, 2}}, 4));
  EXPECT_ERROR(error_of<2>(Grid<2>{{3e38f, 0}, {1e37f, 1}, {2, 2}, {10, 0}}, 4));
  EXPECT_ERROR(error_of<2>(Grid<2>{{-3e38f, 0}, {1e37f, 1}, {2, 2}, {-10, 0}}, 4));
}

// The product of these is a multiple of 2^64, or of 2^32. It is noticed before anything is done for any point: that
// would take gigabytes and minutes.
TEST(Errors, OfProductsOfSizesThatOverflow) {
  const std::clock_t start = std::clock();
  const int large = 1 << 28;
  for (const std::array<int, 4>& size :
       std::vector<std::array<int, 4>>{{large, large, large, large}, {large, large, 256, 1}, {large, 16, 1, 1}}) {
    EXPECT_ERROR(error_of<4>(Grid<4>{{}, {}, size}, 0));
    EXPECT_ERROR(error_of<4>(CellGrid<4>{{}, {}, {}, size}, 0));
  }
  // Times the components it is 2^64.
  std::vector<float> none;
  EXPECT_THROW(Field<3>(of("perlin_d")).fill(Grid<3>{{}, {}, {large, large, 64}}, none), std::invalid_argument);
  EXPECT_LT(std::clock() - start, 5 * CLOCKS_PER_SEC);  // processor time
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
