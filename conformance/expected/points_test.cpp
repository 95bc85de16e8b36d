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

bool is_subnormal(float x) { return std::fpclassify(x) == FP_SUBNORMAL; }
float from_whole(float x) { return std::fabs(x - std::round(x)); }

// How many of the 10,000 values are such ones, at the least; or, with 0, none is.
struct Share {
  std::string_view id;
  std::string_view column;
  Extremes extremes;
  bool (*is_such)(float);
  int least;
};

TEST(Points, AreOfAllKinds) {
  constexpr Extremes kNone = Extremes::none, kFloats = Extremes::floats, kIntegers = Extremes::integers;
  std::vector<Share> shares = {
      // Positions are near, negative, far and on lattice lines.
      {"noise2d.perlin", "x", kNone, [](float x) { return x > 0 && x < 64; }, 500},
      {"noise2d.perlin", "x", kNone, [](float x) { return x < 0; }, 500},
      {"noise2d.perlin", "x", kNone, [](float x) { return std::fabs(x) >= 1048576.0f; }, 500},
      {"noise2d.perlin", "x", kNone, [](float x) { return x == std::floor(x) && std::fabs(x) <= 64; }, 500},
      {"noise2d.perlin", "x", kNone, [](float x) { return !(std::fabs(x) < 8388608.0f); }, 0},
      {"noise3d.perlin", "z", kNone, is_subnormal, 0},
      // Extremes of floats overflow no octave, and only those of integers lie beside their cell.
      {"fbm.fbm3", "y", kFloats, [](float x) { return std::fabs(x) >= 0x1p96f; }, 0},
      {"fbm.fbm3", "y", kIntegers, [](float x) { return std::fabs(x) >= 0x1p96f; }, 50},
      {"noise2d.perlin_cell", "fx", kFloats, [](float f) { return f < 0.0f || f > 1.0f; }, 0},
      {"noise2d.perlin_cell", "fx", kIntegers, [](float f) { return f < 0.0f || f > 1.0f; }, 250},
      {"noise3d.perlin_cell", "fz", kFloats, is_subnormal, 150},
      // Fractions reach both ends.
      {"noise2d.perlin_cell", "fx", kNone, [](float f) { return f < 0.0f || f > 1.0f; }, 0},
      {"fbm.ridged3_cell", "fy", kNone, [](float f) { return f == 0.0f; }, 50},
      {"fbm.ridged3_cell", "fy", kNone, [](float f) { return f == 1.0f; }, 50},
      // Footprints are of all sizes; one below 0 has no value in floats.
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f == 0.0f; }, 300},
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f == 3.0f; }, 300},
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f > 0.25f && f <= 1.0f; }, 1000},
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f > 0.0f && f < 0x1p-7f; }, 1000},
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f < 0.0f; }, 0},
      {"fbm.fbm3_footprint", "footprint", kIntegers, [](float f) { return f < 0.0f; }, 100},
      // Details are whole, nearly whole and between.
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return from_whole(d) == 0.0f; }, 2000},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return from_whole(d) > 0.0f && from_whole(d) < 0x1p-12f; },
       1000},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return from_whole(d) > 0.1f; }, 2000},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return d > 6.0f; }, 300},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return d == 0.0f; }, 200},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return d == -1.0f; }, 200},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return d > 7.0f || d < -1.0f; }, 0},
      {"fbm.fbm2_detail", "detail", kIntegers, [](float d) { return d == 33.5f; }, 5},
      // Strengths lie in their range, at its ends and beyond.
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s >= 0.0f && s <= 4.0f; }, 6000},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s == 2.0f; }, 500},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s == 0.0f; }, 500},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s == 64.0f; }, 500},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s == -1.0f; }, 500},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return s == 100.0f; }, 500},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return std::fabs(s) > 100.0f; }, 0},
      {"fbm.weighted3_cell_period", "strength", kNone, [](float s) { return s >= 0.0f && s <= 1.0f; }, 6000},
      {"fbm.weighted3_cell_period", "strength", kNone, [](float s) { return s == 1.0f; }, 500},
      {"fbm.weighted3_cell_period", "strength", kNone, [](float s) { return s == 0.0f; }, 500},
      {"fbm.weighted3_cell_period", "strength", kNone, [](float s) { return s == -1.0f; }, 500},
      {"fbm.weighted3_cell_period", "strength", kNone, [](float s) { return s == 2.0f; }, 500},
      {"fbm.weighted3_cell_period", "strength", kIntegers, [](float s) { return s > 1e20f; }, 10},
  };
  // Gullies run down hills and flat ground.
  for (const std::string_view id : {"noise2d.gullies", "noise2d.gullies_cell_period_footprint"}) {
    shares.push_back({id, "depth", kNone, [](float d) { return d > 0.0f && d <= 0.5f; }, 8000});
    shares.push_back({id, "depth", kNone, [](float d) { return d == 0.0f; }, 100});
    shares.push_back({id, "depth", kNone, [](float d) { return d == 8.0f; }, 100});
    shares.push_back({id, "depth", kNone, [](float d) { return d == 9.0f; }, 100});
    shares.push_back({id, "depth", kNone, [](float d) { return d == -1.0f; }, 100});
    for (const std::string_view axis : {"ex", "ey"}) {
      shares.push_back({id, axis, kNone, [](float e) { return std::fabs(e) <= 3.0f; }, 8000});
      shares.push_back({id, axis, kNone, [](float e) { return e == 0.0f; }, 1000});
      shares.push_back({id, axis, kNone, [](float e) { return std::fabs(e) > 8.0f; }, 200});
      shares.push_back({id, axis, kFloats, [](float e) { return std::fabs(e) > 1e20f; }, 50});
    }
  }
  // Extremes are subnormal, tiny, -0 and huge, and at the thresholds of precise arithmetic and of normal numbers.
  for (const std::string_view id : {"noise2d.perlin", "noise3d.perlin"}) {
    for (const Extremes extremes : {kFloats, kIntegers}) {
      shares.push_back({id, "y", extremes, is_subnormal, 150});
      shares.push_back({id, "y", extremes, [](float x) { return std::isnormal(x) && std::fabs(x) < 0x1p-32f; }, 150});
      shares.push_back(
          {id, "y", extremes, [](float x) { return std::fabs(x) >= 0x1p-32f && std::fabs(x) < 0x1p-20f; }, 50});
      shares.push_back({id, "y", extremes, [](float x) { return x == 0.0f && std::signbit(x); }, 150});
      shares.push_back({id, "y", extremes, [](float x) { return x == 0x1p-32f; }, 10});
      shares.push_back({id, "y", extremes, [](float x) { return x == std::nextafter(-0x1p-32f, 0.0f); }, 10});
      shares.push_back({id, "y", extremes, [](float x) { return x == -0x1p-126f; }, 10});
      shares.push_back({id, "y", extremes, [](float x) { return x == std::nextafter(0x1p-126f, 0.0f); }, 10});
      shares.push_back({id, "y", extremes, [](float x) { return x > 1e30f; }, 25});
      shares.push_back({id, "y", extremes, [](float x) { return x < -1e30f; }, 25});
      shares.push_back({id, "y", extremes, [](float x) { return !std::isfinite(x); }, 0});
    }
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& share = shares[i];
    const auto count =
        std::ranges::count_if(column_of(share.id, share.column, share.extremes),
                              [&](std::uint32_t word) { return share.is_such(std::bit_cast<float>(word)); });
    EXPECT_TRUE(share.least == 0 ? count == 0 : count > share.least)
        << "share " << i << ", of " << share.column << " of " << share.id << ": " << count << ", not " << share.least;
  }
}

TEST(Points, HaveSoManyMetricsAndRarelyNone) {
  const Function& function = find_function("noise2d.cellular_full");
  for (const std::uint32_t metrics : {kMetrics, kMetrics + 1}) {
    const auto words = random_points(function, 10000, Random(1, "test"), Extremes::none, metrics);
    std::vector<int> counts(metrics + 1);
    for (auto i = static_cast<std::size_t>(function.input("metric")); i < words.size(); i += kInputWords) {
      ++counts[words[i] <= metrics ? words[i] : 0];
    }
    EXPECT_LT(counts[0], 1000);
    EXPECT_GT(std::ranges::min(counts), 100);
  }
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
  EXPECT_EQ(count_steep("noise2d.gullies", Extremes::floats).first, 0);
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

TEST(Random, UniformStaysBelowItsEnd) {
  Random random(3, "uniform");
  for (int i = 0; i < 1000000; ++i) ASSERT_LT(random.uniform(-1.0f, 3.0f), 3.0f);
}

}  // namespace
}  // namespace hn
