#include "expected/tolerance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <stdexcept>

#include "library/configurations.hpp"

namespace hn {
namespace {

// Tests of tools/lib/proof/bounds hold these against sums that are computed with adverse roundings.

TEST(OctaveTolerance, OfSlopesAndShiftsHasEdges) {
  EXPECT_EQ(octave_slope_tolerance(OctaveSum::fbm_d, 2, {1.0, 0, 2.0, 0.5, false}), 0.0);
  EXPECT_EQ(octave_tolerance(OctaveSum::warp, 3, {1.0, 0, 2.0, 0.5, false}), 0.0);
  EXPECT_EQ(octave_slope_tolerance(OctaveSum::fbm_d, 2, {1.0, 20, 2.0, 1e20, false}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(octave_tolerance(OctaveSum::warp_progressive, 2, {1.0, 8, 1e20, 1.0, false}),
            std::numeric_limits<double>::infinity());
  EXPECT_THROW(octave_slope_tolerance(OctaveSum::fbm, 2, {1.0, 1, 2.0, 0.5, false}), std::logic_error);
  // Nothing is further from a component of a shift than twice the amplitude, but for its rounding.
  OctaveArguments large{1.0, 5, 2.0, 1.0, false};
  large.amplitude = 100.0;
  EXPECT_LE(octave_tolerance(OctaveSum::warp_progressive, 3, large), 128.001);
}

TEST(OctaveTolerance, EdgesAreNoNan) {
  EXPECT_EQ(octave_tolerance(OctaveSum::fbm, 2, {1.0, 0, 2.0, 0.5, false}), 0.0);
  EXPECT_EQ(octave_tolerance(OctaveSum::fbm, 3, {1.0, 20, 2.0, 1e20, false}), std::numeric_limits<double>::infinity());
}

std::vector<std::uint32_t> fbm2_inputs(float x, int octaves, float lacunarity) {
  return {std::bit_cast<std::uint32_t>(x),
          0u,
          static_cast<std::uint32_t>(octaves),
          std::bit_cast<std::uint32_t>(lacunarity),
          std::bit_cast<std::uint32_t>(0.5f),
          0u,
          0u,
          0u};
}

// A position keeps few bits when it is a multiple of 1/32 and the lacunarity a small whole number: each rotation takes
// five more.
TEST(Tolerance, ExactRotationsAreRecognised) {
  const Function& fbm = find_function("fbm.fbm3");
  const auto tolerance_at = [&](float x, float y, float z, std::uint32_t octaves, float lacunarity) {
    std::vector<std::uint32_t> inputs(kInputWords);
    const std::array<float, 3> position = {x, y, z};
    for (std::size_t axis = 0; axis < 3; ++axis) inputs[axis] = std::bit_cast<std::uint32_t>(position[axis]);
    inputs[3] = octaves;
    inputs[4] = std::bit_cast<std::uint32_t>(lacunarity);
    inputs[5] = std::bit_cast<std::uint32_t>(0.5f);
    return tolerance(fbm, default_configuration(), inputs, 0);
  };
  const auto exact = [](double octaves) {
    return octave_tolerance(OctaveSum::fbm, 3, {2.75, octaves, 2.0, 0.5, true});
  };
  EXPECT_EQ(tolerance_at(1.5f, 0.25f, 2.75f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.75f, 2, 1.9f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.2f, 2.75f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.7f, 2, 2.0f), exact(2));
  EXPECT_GT(tolerance_at(1.5f, 0.25f, 2.75f, 5, 2.0f), exact(5));
  EXPECT_EQ(tolerance_at(1.5f, 0.2f, 2.75f, 1, 1.9f), exact(1));  // nothing is rounded before the first octave
}

// From a cell the distance does not count, and the settings are those that the contract cuts off.
TEST(Tolerance, OfASumFromACellTakesItsSettings) {
  const auto inputs_of = [](const Function& function, std::uint32_t cell, float f, float lacunarity, float strength) {
    std::vector<std::uint32_t> inputs(kInputWords);
    const auto set = [&](std::string_view name, std::uint32_t word) {
      if (function.input(name) >= 0) inputs[static_cast<std::size_t>(function.input(name))] = word;
    };
    const auto set_float = [&](std::string_view name, float value) { set(name, std::bit_cast<std::uint32_t>(value)); };
    set("cx", cell);
    set_float("fx", f);
    set("octaves", 4);
    set_float("lacunarity", lacunarity);
    set_float("gain", 0.5f);
    set_float("strength", strength);
    return inputs;
  };
  const auto of = [&](std::string_view id, std::uint32_t cell, float f, float lacunarity, float strength) {
    const Function& function = find_function(id);
    return tolerance(function, default_configuration(), inputs_of(function, cell, f, lacunarity, strength), 0);
  };
  EXPECT_EQ(of("fbm.fbm2_cell", 7, 0.5f, 2.0f, 0.0f), of("fbm.fbm2_cell", 0x40000000u, 0.5f, 2.0f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell", 7, 0.5f, 255.0f, 0.0f), of("fbm.fbm2_cell", 7, 0.5f, 1e6f, 0.0f));
  EXPECT_LT(of("fbm.fbm2_cell", 7, 0.5f, 0.7f, 0.0f), of("fbm.fbm2_cell", 0x40000000u, 0.5f, 0.7f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f),
            octave_tolerance(OctaveSum::fbm, 2, {7.5, 4, 2.0, 0.5, true, 0.0, {}, false, true}));
  EXPECT_GT(of("fbm.fbm2_cell_period", 7, 0x1.8p-24f, 2.0f, 0.0f), of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f));
  EXPECT_EQ(of("fbm.fbm2_cell_period", 7, 0.5f, 2.0f, 0.0f), of("fbm.fbm2_cell_period", 7, 0.5f, 2.9f, 0.0f));
  EXPECT_EQ(of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 64.0f), of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 100.0f));
  EXPECT_LT(of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 2.0f), of("fbm.ping_pong2_cell", 7, 0.5f, 2.0f, 3.0f));
  EXPECT_EQ(of("fbm.weighted2_cell", 7, 0.5f, 2.0f, 1.0f), of("fbm.weighted2_cell", 7, 0.5f, 2.0f, 3.0f));
}

TEST(Tolerance, ExactPositionsAreRecognised) {
  const Function& fbm = find_function("fbm.fbm2");
  const double exact = octave_tolerance(OctaveSum::fbm, 2, {1.5, 3, 2.0, 0.5, true});
  EXPECT_EQ(tolerance(fbm, default_configuration(), fbm2_inputs(1.5f, 3, 2.0f), 0), exact);
  EXPECT_GT(tolerance(fbm, default_configuration(), fbm2_inputs(1.5f, 3, 1.9f), 0), exact);
  EXPECT_GT(tolerance(fbm, default_configuration(), fbm2_inputs(1e6f, 3, 2.0f), 0), exact);
}

TEST(Tolerance, ExactFunctionsHaveNone) {
  for (const Function& function : all_functions()) {
    if (!function.exact()) continue;
    EXPECT_EQ(tolerance(function, default_configuration(), std::vector<std::uint32_t>(kInputWords), 0), 0.0)
        << function.id;
  }
}

TEST(Tolerance, OfFixedArithmeticIsNoneAndOfPreciseThatOfFast) {
  const Function& fbm = find_function("fbm.fbm2");
  const auto inputs = fbm2_inputs(1.5f, 4, 1.9f);
  EXPECT_EQ(tolerance(fbm, configuration_named("lattice+fixed"), inputs, 0), 0.0);
  EXPECT_EQ(tolerance(fbm, configuration_named("lattice+precise"), inputs, 0),
            tolerance(fbm, default_configuration(), inputs, 0));
  EXPECT_EQ(tolerance(fbm, configuration_named("lattice+sine+precise"), inputs, 0),
            tolerance(fbm, configuration_named("lattice+sine"), inputs, 0));
}

}  // namespace
}  // namespace hn
