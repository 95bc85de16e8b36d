#include "expected/tolerance.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "expected/twin.hpp"
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

// The roundings of a place have the same bits with every compiler and on every processor, so these are literals.
TEST(Tolerance, OfASumIsTheSameEverywhere) {
  const std::vector<Setting> place = {{"x", 3.7f}, {"y", -12.3f}, {"z", 0.4f}, {"lacunarity", 1.9f}};
  EXPECT_EQ(at("fbm.fbm3", 0, place), 0x1.3e0ae388d0f48p-17);
  EXPECT_EQ(at("fbm.fbm3", 0, place, 4, configuration_named("lattice+sine")), 0x1.68b418be67da3p-17);
  EXPECT_EQ(at("fbm_d.fbm_d3", 2, place), 0x1.e84f751db94e7p-14);
}

// It notices a position that is off by 2^-16, a weight by 2^-14 and another seed.
TEST(Tolerance, OfASumIsBelowAFault) {
  const auto value = [](float x, float gain, float seed) {
    const Function& function = find_function("fbm.fbm2");
    std::vector<std::uint32_t> inputs(kInputWords);
    const auto set = [&](std::string_view column, std::uint32_t word) {
      inputs[static_cast<std::size_t>(function.input(column))] = word;
    };
    set("x", std::bit_cast<std::uint32_t>(x)), set("y", std::bit_cast<std::uint32_t>(0.3f));
    set("octaves", 4), set("lacunarity", std::bit_cast<std::uint32_t>(2.0f));
    set("gain", std::bit_cast<std::uint32_t>(gain)), set("seed", std::bit_cast<std::uint32_t>(seed));
    return static_cast<double>(std::bit_cast<float>(evaluate_twin(function, default_configuration(), inputs).front()));
  };
  const double right = value(0.7f, 0.5f, 0.0f);
  const double allowed = at("fbm.fbm2", 0, {{"x", 0.7f}, {"y", 0.3f}, {"lacunarity", 2.0f}});
  EXPECT_GT(std::fabs(value(0.7f + 0x1p-16f, 0.5f, 0.0f) - right), allowed);
  EXPECT_GT(std::fabs(value(0.7f, 0.5f + 0x1p-14f, 0.0f) - right), allowed);
  EXPECT_GT(std::fabs(value(0.7f, 0.5f, 1.0f) - right), allowed);
}

TEST(Tolerance, WithoutOctavesIsThatOfANoise) {
  EXPECT_LT(at("fbm.fbm2", 0, {{"lacunarity", 2.0f}}, 0), 2e-6);
  EXPECT_LT(at("fbm_d.fbm_d2", 1, {{"lacunarity", 2.0f}}, 0), 2e-5);
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

TEST(Tolerance, OfShiftsAndGulliesScalesWithTheirSize) {
  for (const auto& [id, size] : {std::pair{"warp.warp3", "amplitude"}, std::pair{"noise2d.gullies", "depth"}}) {
    const auto with = [&](float by) { return at(id, 0, {{"x", 0.7f}, {"lacunarity", 2.0f}, {size, by}}); };
    EXPECT_EQ(with(0.0f), 0.0) << id;
    EXPECT_LT(with(0x1p-40f), with(1.0f) * 0x1p-39) << id;
  }
}

}  // namespace
}  // namespace hn
