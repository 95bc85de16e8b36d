#include "sums/gullies.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <string_view>
#include <vector>

#include "expected/tolerance.hpp"
#include "library/configurations.hpp"

namespace hn {
namespace {

// Tests of tools/lib/proof/bounds hold these against the library's text with adverse roundings.

// As in bounds.inc, but rounded.
constexpr GulliesBounds kBounds{5e-6, 20.0, 1.4, 1e-4, 300.0, 20.0, 12.0, 2e-4, 4e-3};

GulliesTolerance of(double octaves, double slope, double depth, double gain = 0.5) {
  OctaveArguments arguments{0.0, octaves, 2.0, gain, true};
  arguments.rotates = false;
  arguments.from_cell = true;
  return gullies_tolerance({arguments, slope, depth}, kBounds);
}

TEST(GulliesTolerance, GrowsFromOctaveToOctaveUpToTheEnds) {
  for (const double slope : {0.0, 0.125, 1.0, 8.0}) {
    for (int octaves = 1; octaves < 30; ++octaves) {
      EXPECT_LT(of(octaves, slope, 0.1).height, 2.0 * 0.1 * 2.001);
      EXPECT_LE(of(octaves, slope, 0.1).height, of(octaves + 1, slope, 0.1).height);
      EXPECT_LE(of(octaves, slope, 0.1).slope, of(octaves + 1, slope, 0.1).slope);
    }
  }
  EXPECT_GT(of(30, 1.0, 8.0).slope, 15.9);
  EXPECT_LT(of(30, 1.0, 8.0).slope, 16.001);
  EXPECT_GT(of(30, 1.0, 8.0).height, 7.9);  // the first octave, half of all, is right
  EXPECT_LT(of(30, 1.0, 8.0).height, 32.001);
}

// One octave at an exact place: depth times |u| = 8/9 times the error of the waves, and some roundings.
TEST(GulliesTolerance, OfOneOctaveIsThatOfItsWaves) {
  const auto [height, slope] = of(1, 1.0, 0.1);
  EXPECT_GT(height, 0.1 * 8.0 / 9.0 * 5e-6);
  EXPECT_LT(height, 2.5 * 0.1 * 8.0 / 9.0 * 5e-6);
  EXPECT_GT(slope, 0.1 * 8.0 / 9.0 * 1e-4);
  EXPECT_LT(slope, 2.5 * 0.1 * 8.0 / 9.0 * 1e-4);
}

TEST(GulliesTolerance, IsLessOnSteepGroundAndForLessDepth) {
  EXPECT_LT(10.0 * of(4, 3.0, 0.05).slope, of(4, 0.5, 0.05).slope);
  EXPECT_LT(20.0 * of(4, 1.0, 0.05).slope, of(4, 1.0, 0.2).slope);
  EXPECT_LT(of(4, 0.0, 0.05).slope, of(4, 0.5, 0.05).slope);
}

TEST(GulliesTolerance, HasEdges) {
  EXPECT_EQ(of(5, 1.0, 0.0).height, 0.0);
  EXPECT_EQ(of(5, 1.0, -1.0).slope, 0.0);
  EXPECT_EQ(of(0, 1.0, 1.0).slope, 0.0);
  EXPECT_EQ(of(3, 1.0, 8.0).slope, of(3, 1.0, 100.0).slope);
  EXPECT_EQ(of(20, 1.0, 1.0, 1e20).height, std::numeric_limits<double>::infinity());
}

TEST(GulliesTolerance, CountsWhatIsCutOfAPosition) {
  OctaveArguments arguments{0.0, 1, 2.0, 0.5, false};
  arguments.rotates = false;
  arguments.from_cell = true;
  EXPECT_GT(gullies_tolerance({arguments, 8.0, 1.0}, kBounds).slope, of(1, 8.0, 1.0).slope + 300.0 * 0x1p-24);
}

// The tolerance of an output of a row, at a point that the columns give.
struct Setting {
  std::string_view column;
  float value;
};
double at(std::string_view id, std::size_t output, const std::vector<Setting>& settings, int octaves = 4) {
  const Function& function = find_function(id);
  std::vector<std::uint32_t> inputs(kInputWords);
  for (const auto& [column, value] : settings) {
    inputs[static_cast<std::size_t>(function.input(column))] = std::bit_cast<std::uint32_t>(value);
  }
  inputs[static_cast<std::size_t>(function.input("octaves"))] = static_cast<std::uint32_t>(octaves);
  return tolerance(function, default_configuration(), inputs, output);
}

TEST(Tolerance, OfGulliesTakesItsSettings) {
  const auto of_gullies = [](std::size_t output, float ex, float lacunarity, float depth) {
    return at("noise2d.gullies", output,
              {{"x", 0.5f}, {"ex", ex}, {"lacunarity", lacunarity}, {"gain", 0.5f}, {"depth", depth}});
  };
  for (const std::size_t output : {0u, 1u, 2u}) {
    EXPECT_EQ(of_gullies(output, 1.0f, 2.0f, 0.0f), 0.0);
    EXPECT_GT(of_gullies(output, 1.0f, 2.0f, 0.1f), 0.0);
    EXPECT_EQ(of_gullies(output, 1.0f, 2.0f, 0.1f), of_gullies(output, -1.0f, 2.9f, 0.1f));
    EXPECT_EQ(of_gullies(output, 8.0f, 2.0f, 0.1f), of_gullies(output, 1e20f, 2.0f, 0.1f));
    EXPECT_LT(of_gullies(output, 3.0f, 2.0f, 0.1f), of_gullies(output, 1.0f, 2.0f, 0.1f));
  }
  EXPECT_EQ(of_gullies(1, 1.0f, 2.0f, 0.1f), of_gullies(2, 1.0f, 2.0f, 0.1f));
  EXPECT_LT(of_gullies(0, 1.0f, 2.0f, 0.1f), of_gullies(1, 1.0f, 2.0f, 0.1f));
}

TEST(Tolerance, OfGulliesCountsAFootprint) {
  const auto with = [](float footprint) {
    return at("noise2d.gullies_footprint", 1,
              {{"footprint", footprint}, {"ex", 1.0f}, {"lacunarity", 2.0f}, {"gain", 0.5f}, {"depth", 0.1f}});
  };
  EXPECT_GT(with(0.0f), with(0.1f));
  EXPECT_GT(with(0.1f), with(0.3f));
  EXPECT_LT(with(0.75f), 3e-6);
}

TEST(Tolerance, OfPerlinWorleyIsThatOfItsTwoSums) {
  const auto of_sum = [](int octaves, float gain) {
    return at("noise3d.perlin_worley", 0, {{"x", 1.5f}, {"lacunarity", 2.0f}, {"gain", gain}}, octaves);
  };
  const double wisps = octave_tolerance(OctaveSum::fbm, 3, {1.5, 2, 2.0, 0.5, true});
  const double distance = noise_bounds("cellular_d", 3, Gradient::octahedral).error;
  EXPECT_GT(of_sum(2, 0.5f), wisps / 2.0 + distance);
  EXPECT_LT(of_sum(2, 0.5f), wisps / 2.0 + distance + 3e-6);
  EXPECT_LT(of_sum(0, 0.5f), 1e-6);
  EXPECT_LT(of_sum(3, 0.5f), of_sum(12, 0.9f));
  EXPECT_LE(of_sum(30, 1.0f), 1.0);
}

}  // namespace
}  // namespace hn
