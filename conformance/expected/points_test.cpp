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

// How many of the 10,000 values are such ones, at the least; or, with 0, none is. The table of tools/make freeze has
// checksums of the points of integers: it holds the kinds of settings, periods and items.
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
      // Footprints below 0 have a value in integers alone.
      {"fbm.fbm3_footprint", "footprint", kNone, [](float f) { return f < 0.0f; }, 0},
      {"fbm.fbm3_footprint", "footprint", kIntegers, [](float f) { return f < 0.0f; }, 100},
      {"fbm.fbm2_detail", "detail", kNone, [](float d) { return d > 7.0f || d < -1.0f; }, 0},
      {"fbm.fbm2_detail", "detail", kIntegers, [](float d) { return d == 33.5f; }, 5},
      {"fbm.ping_pong2", "strength", kNone, [](float s) { return std::fabs(s) > 100.0f; }, 0},
      {"noise2d.gullies", "ey", kFloats, [](float e) { return std::fabs(e) > 1e20f; }, 50},
  };
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

TEST(Random, UniformStaysBelowItsEnd) {
  Random random(3, "uniform");
  for (int i = 0; i < 1000000; ++i) ASSERT_LT(random.uniform(-1.0f, 3.0f), 3.0f);
}

}  // namespace
}  // namespace hn
