#include "expected/tolerance.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "library/configurations.hpp"

namespace hn {
namespace {

// The tolerance of an output of a row, at a point that the columns give; others are 0, and a gain is 1/2.
struct Setting {
  std::string_view column;
  float value;
};
double at(std::string_view id, std::size_t output, const std::vector<Setting>& settings, int octaves = 4,
          const Configuration& configuration = default_configuration()) {
  const Function& function = find_function(id);
  std::vector<std::uint32_t> inputs(kInputWords);
  const auto set = [&](std::string_view column, std::uint32_t word) {
    inputs[static_cast<std::size_t>(function.input(column))] = word;
  };
  set("gain", std::bit_cast<std::uint32_t>(0.5f));
  set("octaves", static_cast<std::uint32_t>(octaves));
  for (const auto& [column, value] : settings) set(column, std::bit_cast<std::uint32_t>(value));
  return tolerance(function, configuration, inputs, output);
}

// A position keeps few bits when it is a multiple of 1/32 and the lacunarity a small whole number: each rotation takes
// five more.
TEST(Tolerance, ExactRotationsAreRecognised) {
  const auto tolerance_at = [](float x, float y, float z, int octaves, float lacunarity) {
    return at("fbm.fbm3", 0, {{"x", x}, {"y", y}, {"z", z}, {"lacunarity", lacunarity}}, octaves);
  };
  const auto exact = [&](int octaves) { return tolerance_at(0.0f, 0.0f, 0.0f, octaves, 2.0f); };
  EXPECT_EQ(tolerance_at(1.5f, 0.25f, 2.75f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.75f, 2, 1.9f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.2f, 2.75f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.7f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.75f, 5, 2.0f), exact(5));
  EXPECT_EQ(tolerance_at(1.5f, 0.25f, 2.75f, 1, 1.9f), exact(1));  // nothing is rounded before the first octave
}

// From a cell the distance does not count, and the settings are those that the contract cuts off.
TEST(Tolerance, OfASumFromACellTakesItsSettings) {
  const auto of = [](std::string_view id, std::uint32_t cell, float f, float lacunarity, float strength) {
    std::vector<Setting> settings = {{"cx", std::bit_cast<float>(cell)}, {"fx", f}, {"lacunarity", lacunarity}};
    if (find_function(id).takes_strength()) settings.push_back({"strength", strength});
    return at(id, 0, settings);
  };
  EXPECT_EQ(of("fbm.fbm2_cell", 7, 0.5f, 2.0f, 0.0f), of("fbm.fbm2_cell", 0x40000000u, 0.5f, 2.0f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell", 7, 0.5f, 255.0f, 0.0f), of("fbm.fbm2_cell", 7, 0.5f, 1e6f, 0.0f));
  EXPECT_LT(of("fbm.fbm2_cell", 7, 0.5f, 0.7f, 0.0f), of("fbm.fbm2_cell", 0x40000000u, 0.5f, 0.7f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f), of("fbm.fbm2_cell_period", 8, 0.25f, 2.0f, 0.0f));
  EXPECT_GT(of("fbm.fbm2_cell_period", 7, 0x1.8p-24f, 2.0f, 0.0f), of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f), of("fbm.fbm2_cell_period", 7, 0.5f, 2.9f, 0.0f));
  EXPECT_EQ(of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 64.0f), of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 100.0f));
  EXPECT_LT(of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 2.0f), of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 3.0f));
  EXPECT_EQ(of("fbm.weighted2_cell", 7, 0.5f, 2.0f, 1.0f), of("fbm.weighted2_cell", 7, 0.5f, 2.0f, 3.0f));
}

// Where nothing bounds an error, or the numbers overflow; and where there is no octave.
TEST(Tolerance, HasEdges) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(at("fbm.fbm3", 0, {{"lacunarity", 2.0f}, {"gain", 1e20f}}, 20), infinite);
  EXPECT_EQ(at("fbm_d.fbm_d2", 1, {{"lacunarity", 2.0f}, {"gain", 1e20f}}, 20), infinite);
  EXPECT_EQ(at("warp.warp_progressive2", 0, {{"lacunarity", 1e20f}, {"gain", 1.0f}, {"amplitude", 1.0f}}, 8), infinite);
  EXPECT_EQ(at("fbm.fbm2", 0, {{"x", std::numeric_limits<float>::quiet_NaN()}}), infinite);
  EXPECT_EQ(at("fbm.fbm2", 0, {{"lacunarity", 2.0f}}, 0), 0.0);
  EXPECT_EQ(at("fbm_d.fbm_d2", 1, {{"lacunarity", 2.0f}}, 0), 0.0);
  EXPECT_EQ(at("warp.warp3", 0, {{"lacunarity", 2.0f}, {"amplitude", 1.0f}}, 0), 0.0);
  // Nothing is further from a component of a shift than twice the amplitude, but for its rounding.
  EXPECT_LE(at("warp.warp_progressive3", 0, {{"lacunarity", 2.0f}, {"gain", 1.0f}, {"amplitude", 100.0f}}, 5), 128.001);
}

TEST(Tolerance, ExactPositionsAreRecognised) {
  const auto of_fbm = [](float x, float lacunarity) {
    return at("fbm.fbm2", 0, {{"x", x}, {"lacunarity", lacunarity}}, 3);
  };
  const double exact = of_fbm(0.0f, 2.0f);
  EXPECT_EQ(of_fbm(1.5f, 2.0f), exact);
  EXPECT_GT(of_fbm(1.5f, 1.9f), exact);
  EXPECT_GT(of_fbm(1e6f, 2.0f), exact);
}

TEST(Tolerance, ExactFunctionsHaveNone) {
  for (const Function& function : all_functions()) {
    if (!function.exact()) continue;
    EXPECT_EQ(tolerance(function, default_configuration(), std::vector<std::uint32_t>(kInputWords), 0), 0.0)
        << function.id;
  }
}

TEST(Tolerance, OfFixedArithmeticIsNoneAndOfPreciseThatOfFast) {
  const auto with = [](std::string_view configuration) {
    return at("fbm.fbm2", 0, {{"x", 1.5f}, {"lacunarity", 1.9f}}, 4, configuration_named(configuration));
  };
  EXPECT_EQ(with("lattice+fixed"), 0.0);
  EXPECT_EQ(with("lattice+precise"), with("lattice"));
  EXPECT_EQ(with("lattice+sine+precise"), with("lattice+sine"));
}

TEST(Tolerance, OfGulliesTakesItsSettings) {
  const auto of_gullies = [](std::size_t output, float ex, float lacunarity, float depth) {
    return at("noise2d.gullies", output, {{"x", 0.5f}, {"ex", ex}, {"lacunarity", lacunarity}, {"depth", depth}});
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
              {{"footprint", footprint}, {"ex", 1.0f}, {"lacunarity", 2.0f}, {"depth", 0.1f}});
  };
  EXPECT_GT(with(0.0f), with(0.1f));
  EXPECT_GT(with(0.1f), with(0.3f));
  EXPECT_LT(with(0.75f), 3e-6);
}

TEST(Tolerance, OfPerlinWorleyIsThatOfItsTwoSums) {
  const auto of_sum = [](int octaves, float gain) {
    return at("noise3d.perlin_worley", 0, {{"x", 1.5f}, {"lacunarity", 2.0f}, {"gain", gain}}, octaves);
  };
  const double wisps = at("fbm.fbm3", 0, {{"x", 1.5f}, {"lacunarity", 2.0f}}, 2);
  const double distance = noise_bounds("cellular_d", 3, Gradient::octahedral).error;
  EXPECT_GT(of_sum(2, 0.5f), wisps / 2.0 + distance);
  EXPECT_LT(of_sum(2, 0.5f), wisps / 2.0 + distance + 3e-6);
  EXPECT_LT(of_sum(0, 0.5f), 1e-6);
  EXPECT_LT(of_sum(3, 0.5f), of_sum(12, 0.9f));
  EXPECT_LE(of_sum(30, 1.0f), 1.0);
}

}  // namespace
}  // namespace hn
