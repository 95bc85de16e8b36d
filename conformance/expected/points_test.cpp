#include "expected/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace hn {
namespace {

TEST(Points, TheSameSeedGivesTheSamePoints) {
  const Function& function = find_function("noise3d.perlin");
  EXPECT_EQ(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(7, "a")));
  EXPECT_NE(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(8, "a")));
  EXPECT_NE(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(7, "b")));
}

TEST(Points, PositionsAreNearNegativeFarAndOnLatticeLines) {
  const auto words = random_points(find_function("noise2d.perlin"), 10000, Random(1, "test"));
  int near = 0, negative = 0, far = 0, on_line = 0;
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const float x = std::bit_cast<float>(words[i]);
    ASSERT_TRUE(std::isfinite(x));
    ASSERT_LT(std::fabs(x), 8388608.0f);
    near += x > 0 && x < 64;
    negative += x < 0;
    far += std::fabs(x) >= 1048576.0f;
    on_line += x == std::floor(x) && std::fabs(x) <= 64;
  }
  for (const int count : {near, negative, far, on_line}) EXPECT_GT(count, 500);
}

TEST(Points, NoPositionIsSubnormal) {
  const auto words = random_points(find_function("noise3d.perlin"), 100000, Random(1, "test"));
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i % kInputWords < 3) {
      ASSERT_NE(std::fpclassify(std::bit_cast<float>(words[i])), FP_SUBNORMAL);
    }
  }
}

// Counts the coordinates of 10,000 points for which a predicate holds.
template <typename Predicate>
int count_coordinates(std::string_view id, Extremes extremes, Predicate predicate) {
  const Function& function = find_function(id);
  const auto words = random_points(function, 10000, Random(1, "test"), extremes);
  int count = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t column = i % kInputWords;
    if (column >= function.inputs.size() || function.inputs[column].type != WordType::f32) continue;
    const bool setting = static_cast<int>(column) > function.input("octaves") && function.is_octave_sum();
    if (!setting && predicate(std::bit_cast<float>(words[i]))) ++count;
  }
  return count;
}

TEST(Points, ExtremesAreSubnormalTinyMinusZeroAndHuge) {
  for (const std::string_view id : {"noise2d.perlin", "noise3d.perlin"}) {
    for (const Extremes extremes : {Extremes::floats, Extremes::integers}) {
      const auto count = [&](auto predicate) { return count_coordinates(id, extremes, predicate); };
      EXPECT_GT(count([](float x) { return std::fpclassify(x) == FP_SUBNORMAL; }), 300);
      EXPECT_GT(count([](float x) { return std::isnormal(x) && std::fabs(x) < 0x1p-32f; }), 300);
      EXPECT_GT(count([](float x) { return std::fabs(x) >= 0x1p-32f && std::fabs(x) < 0x1p-20f; }), 100);
      EXPECT_GT(count([](float x) { return x == 0.0f && std::signbit(x); }), 300);
      for (const float threshold :
           {0x1p-32f, std::nextafter(0x1p-32f, 0.0f), 0x1p-126f, std::nextafter(0x1p-126f, 0.0f)}) {
        EXPECT_GT(count([&](float x) { return x == threshold; }), 20);
        EXPECT_GT(count([&](float x) { return x == -threshold; }), 20);
      }
      EXPECT_GT(count([](float x) { return x > 1e30f; }), 50);
      EXPECT_GT(count([](float x) { return x < -1e30f; }), 50);
      EXPECT_EQ(count([](float x) { return !std::isfinite(x); }), 0);
    }
  }
}

TEST(Points, ExtremesOfFloatsOverflowNoOctave) {
  const auto too_large = [](float x) { return std::fabs(x) >= 0x1p96f; };
  EXPECT_EQ(count_coordinates("fbm.fbm3", Extremes::floats, too_large), 0);
  EXPECT_GT(count_coordinates("fbm.fbm3", Extremes::integers, too_large), 50);
}

// Counts the points of an octave sum whose lacunarity is huge, and those of them with a subnormal coordinate.
std::pair<int, int> count_steep(std::string_view id, Extremes extremes) {
  const Function& function = find_function(id);
  const auto words = random_points(function, 10000, Random(1, "test"), extremes);
  std::pair<int, int> counts;
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const auto number = [&](int column) { return std::bit_cast<float>(words[i + static_cast<std::size_t>(column)]); };
    if (std::fabs(number(function.input("lacunarity"))) < 0x1p20f) continue;
    ++counts.first;
    counts.second += std::fpclassify(number(0)) == FP_SUBNORMAL;
    EXPECT_LE(words[i + static_cast<std::size_t>(function.input("octaves"))], 2u);
    for (int axis = 0; axis < function.axes; ++axis) EXPECT_LT(std::fabs(number(axis)), 0x1p-30f);
  }
  return counts;
}

TEST(Points, OnlyTinyPositionsOfFloatsHaveAHugeLacunarity) {
  for (const std::string_view id : {"fbm.fbm2", "fbm.clouds3"}) {
    const auto [steep, subnormal] = count_steep(id, Extremes::floats);
    EXPECT_GT(steep, 1000);
    EXPECT_GT(subnormal, 400);
    EXPECT_EQ(count_steep(id, Extremes::none).first, 0);
  }
}

// The values of a column at 10,000 points.
std::vector<std::uint32_t> column_of(std::string_view id, std::string_view name, Extremes extremes = Extremes::none) {
  const Function& function = find_function(id);
  const auto words = random_points(function, 10000, Random(1, "test"), extremes);
  std::vector<std::uint32_t> column;
  for (auto i = static_cast<std::size_t>(function.input(name)); i < words.size(); i += kInputWords) {
    column.push_back(words[i]);
  }
  return column;
}

template <typename Predicate>
std::ptrdiff_t count_floats(const std::vector<std::uint32_t>& column, Predicate predicate) {
  return std::ranges::count_if(column, [&](std::uint32_t word) { return predicate(std::bit_cast<float>(word)); });
}

TEST(Points, OctaveSumsStartFromCellsAnywhereWithAllTheirOctaves) {
  const auto cells = column_of("fbm.ridged3_cell", "cz");
  const auto octaves = column_of("fbm.ridged3_cell", "octaves");
  int near = 0, far = 0, many_far = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto distance = std::abs(static_cast<double>(static_cast<std::int32_t>(cells[i])));
    near += distance < 256;
    far += distance > 0x1p30;
    many_far += distance > 0x1p30 && octaves[i] == 5;
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 500);
  EXPECT_GT(many_far, 50);
  EXPECT_EQ(std::ranges::max(octaves), 5u);
  const auto fractions = column_of("fbm.ridged3_cell", "fy");
  for (const float end : {0.0f, 1.0f}) {
    EXPECT_GT(count_floats(fractions, [&](float f) { return f == end; }), 50) << end;
  }
}

TEST(Points, StrengthsLieInTheirRangeAtItsEndsAndBeyond) {
  struct {
    std::string_view id;
    float most;
    std::vector<float> values;
  } const kSums[] = {{"fbm.ping_pong2", 4.0f, {2.0f, 0.0f, 64.0f, -1.0f, 100.0f}},
                     {"fbm.weighted3_cell_period", 1.0f, {1.0f, 0.0f, -1.0f, 2.0f}}};
  for (const auto& [id, most, values] : kSums) {
    const auto strengths = column_of(id, "strength");
    EXPECT_GT(count_floats(strengths, [&](float s) { return s >= 0.0f && s <= most; }), 6000) << id;
    for (const float value : values) EXPECT_GT(count_floats(strengths, [&](float s) { return s == value; }), 500) << id;
    EXPECT_EQ(count_floats(strengths, [](float s) { return std::fabs(s) > 100.0f; }), 0) << id;
    EXPECT_GT(count_floats(column_of(id, "strength", Extremes::integers), [](float s) { return s > 1e20f; }), 10) << id;
  }
}

TEST(Points, GulliesRunDownHillsAndFlatGround) {
  for (const std::string_view id : {"noise2d.gullies", "noise2d.gullies_cell_period_footprint"}) {
    const auto depths = column_of(id, "depth");
    EXPECT_GT(count_floats(depths, [](float d) { return d > 0.0f && d <= 0.5f; }), 8000) << id;
    for (const float value : {0.0f, 8.0f, 9.0f, -1.0f}) {
      EXPECT_GT(count_floats(depths, [&](float d) { return d == value; }), 100) << id;
    }
    for (const std::string_view axis : {"ex", "ey"}) {
      const auto slopes = column_of(id, axis);
      EXPECT_GT(count_floats(slopes, [](float e) { return std::fabs(e) <= 3.0f; }), 8000) << id;
      EXPECT_GT(count_floats(slopes, [](float e) { return e == 0.0f; }), 1000) << id;
      EXPECT_GT(count_floats(slopes, [](float e) { return std::fabs(e) > 8.0f; }), 200) << id;
      EXPECT_GT(count_floats(column_of(id, axis, Extremes::floats), [](float e) { return std::fabs(e) > 1e20f; }), 50);
    }
    EXPECT_EQ(count_steep(id, Extremes::floats).first, 0) << id;
  }
}

TEST(Points, FootprintsAreOfAllSizes) {
  const auto footprints = column_of("fbm.fbm3_footprint", "footprint");
  for (const float value : {0.0f, 3.0f}) {
    EXPECT_GT(count_floats(footprints, [&](float f) { return f == value; }), 300) << value;
  }
  EXPECT_GT(count_floats(footprints, [](float f) { return f > 0.25f && f <= 1.0f; }), 1000);
  EXPECT_GT(count_floats(footprints, [](float f) { return f > 0.0f && f < 0x1p-7f; }), 1000);
  EXPECT_EQ(count_floats(footprints, [](float f) { return f < 0.0f; }), 0);  // that has no value in floats
  const auto extreme = column_of("fbm.fbm3_footprint", "footprint", Extremes::integers);
  EXPECT_GT(count_floats(extreme, [](float f) { return f < 0.0f; }), 100);
}

TEST(Points, DetailsAreWholeNearlyWholeAndBetween) {
  const auto details = column_of("fbm.fbm2_detail", "detail");
  const auto from_whole = [](float d) { return std::fabs(d - std::round(d)); };
  EXPECT_GT(count_floats(details, [&](float d) { return from_whole(d) == 0.0f; }), 2000);
  EXPECT_GT(count_floats(details, [&](float d) { return from_whole(d) > 0.0f && from_whole(d) < 0x1p-12f; }), 1000);
  EXPECT_GT(count_floats(details, [&](float d) { return from_whole(d) > 0.1f; }), 2000);
  EXPECT_GT(count_floats(details, [](float d) { return d > 6.0f; }), 300);
  for (const float value : {0.0f, -1.0f}) {
    EXPECT_GT(count_floats(details, [&](float d) { return d == value; }), 200) << value;
  }
  EXPECT_EQ(count_floats(details, [](float d) { return d > 7.0f || d < -1.0f; }), 0);
  const auto extreme = column_of("fbm.fbm2_detail", "detail", Extremes::integers);
  EXPECT_GT(count_floats(extreme, [](float d) { return d == 33.5f; }), 5);
}

TEST(Points, OnlyExtremesOfIntegersLieBesideTheirCell) {
  const auto beside = [](float f) { return f < 0.0f || f > 1.0f; };
  for (const std::string_view id : {"noise2d.perlin_cell", "noise3d.perlin_cell"}) {
    EXPECT_EQ(count_coordinates(id, Extremes::floats, beside), 0);
    EXPECT_GT(count_coordinates(id, Extremes::integers, beside), 500);
    EXPECT_GT(count_coordinates(id, Extremes::floats, [](float f) { return std::fpclassify(f) == FP_SUBNORMAL; }), 300);
  }
}

// The periods of an axis, and how many of the points lie in the last cell before a multiple of theirs.
std::pair<std::set<std::int32_t>, int> periods_of(std::string_view id, std::size_t axis) {
  const Function& function = find_function(id);
  const auto words = random_points(function, 10000, Random(1, "test"));
  std::pair<std::set<std::int32_t>, int> found;
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const auto period = static_cast<std::int32_t>(words[i + static_cast<std::size_t>(function.period_word()) + axis]);
    found.first.insert(std::max(period, -1));
    const double cell = function.starts_from_integers()
                            ? static_cast<double>(static_cast<std::int32_t>(words[i + axis]))
                            : std::floor(static_cast<double>(std::bit_cast<float>(words[i + axis])));
    if (period > 7 && std::fmod(cell + 1.0, static_cast<double>(period)) == 0.0) ++found.second;
  }
  return found;
}

TEST(Points, PeriodsAreOfAllKindsAndPointsLieAtTheirSeams) {
  const std::set<std::int32_t> kAll = {-1, 0, 1, 2, 3, 5, 7, 48, 64, 1000003, 1 << 20, 1 << 30, 0x7FFFFFFF};
  for (const std::string_view id :
       {"noise1d.value_cell_period", "noise4d.perlin_period", "noise3d.value_d_cell_period"}) {
    const auto axis = static_cast<std::size_t>(find_function(id).axes - 1);
    const auto [periods, at_seams] = periods_of(id, axis);
    EXPECT_EQ(periods, kAll) << id;
    EXPECT_GT(at_seams, 500) << id;
  }
  const auto [periods, at_seams] = periods_of("fbm.fbm2_period", 1);
  EXPECT_EQ(periods, (std::set<std::int32_t>{-1, 0, 1, 2, 3, 5, 7, 48, 64}));  // they grow with each octave
  EXPECT_GT(at_seams, 300);
}

TEST(Points, ItemsAreOfAnyNumberAndAmongThemOrBeyond) {
  const Function& function = find_function("numbers.shuffle");
  const auto words = random_points(function, 10000, Random(1, "test"));
  std::set<std::uint32_t> counts;
  int last = 0, first_beyond = 0, among_many = 0, beyond = 0;
  for (std::size_t point = 0; point < words.size(); point += kInputWords) {
    const std::uint32_t i = words[point], n = words[point + 1];
    ASSERT_LE(n, 1u << 31);
    counts.insert(n);
    if (n < 8) continue;
    last += i == n - 1;
    first_beyond += i == n;
    among_many += i < n && n > 256;
    beyond += i > n;
  }
  for (const std::uint32_t n : {0u, 1u, 2u, 3u, 1023u, 1024u, 1025u, (1u << 31) - 1, 1u << 31}) {
    EXPECT_EQ(counts.count(n), 1u) << n;
  }
  for (const int count : {last, first_beyond, among_many, beyond}) EXPECT_GT(count, 200);
}

TEST(Points, FractionsReachBothEnds) {
  const auto words = random_points(find_function("noise2d.perlin_cell"), 10000, Random(1, "test"));
  bool zero = false, one = false;
  for (std::size_t i = 2; i < words.size(); i += kInputWords) {
    const float f = std::bit_cast<float>(words[i]);
    ASSERT_GE(f, 0.0f);
    ASSERT_LE(f, 1.0f);
    zero |= f == 0.0f;
    one |= f == 1.0f;
  }
  EXPECT_TRUE(zero && one);
}

TEST(Random, UniformStaysBelowItsEnd) {
  Random random(3, "uniform");
  for (int i = 0; i < 1000000; ++i) ASSERT_LT(random.uniform(-1.0f, 3.0f), 3.0f);
}

}  // namespace
}  // namespace hn
