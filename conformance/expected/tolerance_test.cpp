#include "expected/tolerance.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "library/configurations.hpp"

namespace hn {
namespace {

// The table that tools/bounds prints, which derives the formula.
TEST(OctaveTolerance, AgreesWithItsDerivation) {
  const auto near = [](double got, double expected) { EXPECT_NEAR(got / expected, 1.0, 0.005); };
  near(octave_tolerance(OctaveSum::fbm, 2, {16.0, 5, 2.0, 0.5, true}), 4.18e-06);
  near(octave_tolerance(OctaveSum::fbm, 2, {16.0, 5, 2.0, 0.5, false}), 7.95e-05);
  near(octave_tolerance(OctaveSum::fbm, 3, {16.0, 5, 2.0, 0.5, false}), 0.000106);
  near(octave_tolerance(OctaveSum::fbm, 3, {1024.0, 8, 2.0, 0.5, false}), 0.0171);
  near(octave_tolerance(OctaveSum::turbulence, 3, {16.0, 5, 1.9, 0.6, false}), 0.000132);
  near(octave_tolerance(OctaveSum::clouds, 2, {16.0, 5, 2.0, 0.5, false}), 0.000239);
}

TEST(OctaveTolerance, OfTheSineGradientAgreesWithItsDerivation) {
  const auto near = [](double got, double expected) { EXPECT_NEAR(got / expected, 1.0, 0.005); };
  const auto sine = Gradient::sine;
  near(octave_tolerance(OctaveSum::fbm, 2, {16.0, 5, 2.0, 0.5, true}, sine), 5.91e-06);
  near(octave_tolerance(OctaveSum::fbm, 3, {16.0, 5, 2.0, 0.5, false}, sine), 0.00015);
  near(octave_tolerance(OctaveSum::turbulence, 3, {16.0, 5, 1.9, 0.6, false}, sine), 0.000186);
  near(octave_tolerance(OctaveSum::clouds, 2, {16.0, 5, 2.0, 0.5, false}, sine), 0.000245);
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

TEST(Tolerance, ExactPositionsAreRecognised) {
  const Function& fbm = find_function("fbm.fbm2");
  const double exact = octave_tolerance(OctaveSum::fbm, 2, {1.5, 4, 2.0, 0.5, true});
  EXPECT_EQ(tolerance(fbm, default_configuration(), fbm2_inputs(1.5f, 4, 2.0f), 0), exact);
  EXPECT_GT(tolerance(fbm, default_configuration(), fbm2_inputs(1.5f, 4, 1.9f), 0), exact);
  EXPECT_GT(tolerance(fbm, default_configuration(), fbm2_inputs(1e6f, 4, 2.0f), 0), exact);
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
