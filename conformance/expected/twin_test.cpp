// The C++ twin, and so the library's text, against the golden files, without any driver.
#include "expected/twin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <hashnoise/hashnoise.hpp>
#include <limits>
#include <ostream>
#include <type_traits>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "expected/compare.hpp"
#include "expected/golden.hpp"
#include "expected/points.hpp"

namespace hn {

// How GoogleTest shows one; the name is GoogleTest's.
void PrintTo(const Configuration& configuration, std::ostream* out) { *out << configuration.name; }

namespace {

class TwinGolden : public testing::TestWithParam<Configuration> {};

TEST_P(TwinGolden, AgreesWithTheOracle) {
  for (const Function& function : all_functions()) {
    const Configuration& configuration = GetParam();
    if (!covers(configuration, function)) continue;
    const auto golden = read_golden(golden_path(HN_GOLDEN_DIRECTORY, function), function, configuration);
    ASSERT_TRUE(golden) << golden.error().text();
    for (const GoldenRow& row : golden->rows) {
      std::vector<std::uint32_t> inputs(row.inputs);
      inputs.resize(kInputWords);
      const auto got = evaluate_twin(function, configuration, inputs);
      Comparison comparison(function, inputs);
      compare_with_golden(comparison, function, configuration, inputs, got, row.values);
      ASSERT_TRUE(comparison.all_right())
          << function.id << ", line " << row.line << ": " << comparison.finish().message;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, TwinGolden, testing::ValuesIn(all_configurations()), [](const auto& instance) {
  std::string name(instance.param.name);
  std::replace(name.begin(), name.end(), '+', '_');
  return name;
});

// -2^31 fits an int, 2^31 does not.
TEST(Twin, TheSmallestCellIsThatOfAPosition) {
  using namespace hashnoise;
  constexpr int kSmallest = std::numeric_limits<int>::min();
  EXPECT_EQ(hn_perlin(vec2(-0x1p31f, 0.25f), 9u), hn_perlin(hn_place(ivec2(kSmallest, 0), vec2(0.0f, 0.25f)), 9u));
  EXPECT_EQ(hn_value(vec3(0.5f, -0x1p31f, 0.25f), 9u),
            hn_value(hn_place(ivec3(0, kSmallest, 0), vec3(0.5f, 0.0f, 0.25f)), 9u));
}

TEST(Twin, HugeNumbersHaveNoUndefinedBehaviour) {
  using namespace hashnoise;
  for (const float x : {3e9f, -3e9f, std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()}) {
    EXPECT_EQ(hn_perlin(vec2(x, x)), 0.0f);
    EXPECT_EQ(hn_perlin(vec3(x, x, x)), 0.0f);
  }
  for (const float x : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    (void)hn_perlin(vec3(x, x, x));  // any value, but no trap and no fault under a sanitizer
    EXPECT_EQ(hn_turbulence(vec2(x, 0.5f), 3, 2.0f, 0.5f, 7u), 0.0f);
    EXPECT_EQ(hn_fbm_d(vec2(0.5f, x), 3, 2.0f, 0.5f, 7u), vec3(0.0f, 0.0f, 0.0f));
  }
  EXPECT_EQ(hn_fbm(vec2(1.3f, 2.7f), 14, 1000.0f, 0.5f, 7u), 0.0f);
  EXPECT_EQ(hn_ridged(vec2(1.3f, 2.7f), 1000000000, 3.0f, 0.5f, 7u), hn_ridged(vec2(1.3f, 2.7f), 32, 3.0f, 0.5f, 7u));
}

TEST(Twin, WithFixedANanIsTheLeastFloat) {
  const Configuration& fixed = configuration_named("lattice+fixed");
  for (const std::string_view id :
       {"noise2d.perlin", "fbm.fbm2", "fbm.fbm3_detail", "fbm.weighted2_cell", "fbm_d.eroded3",
        "warp.warp_progressive2", "noise2d.gullies", "noise3d.cellular_three_full"}) {
    const Function& function = find_function(id);
    const auto inputs = random_points(function, 64, Random(1, id));
    for (std::size_t word = 0; word < function.inputs.size(); ++word) {
      if (function.inputs[word].type != WordType::f32) continue;
      auto nans = inputs;
      auto least = inputs;
      for (std::size_t i = word; i < inputs.size(); i += kInputWords) {
        nans[i] = 0x7FC00000u;
        least[i] = 0xFF7FFFFFu;
      }
      EXPECT_EQ(evaluate_twin(function, fixed, nans), evaluate_twin(function, fixed, least))
          << id << " " << function.inputs[word].name;
    }
  }
}

TEST(Twin, PreciseResultsAreZeroBelowTheirThreshold) {
  const Function& function = find_function("noise4d.perlin");
  const Configuration& precise = configuration_named("lattice+precise");
  const auto values = evaluate_twin(function, precise, random_points(function, 4, Random(1, "test"), Extremes::floats));
  const auto value = [&](std::size_t i) { return std::bit_cast<float>(values[i * kOutputWords]); };
  EXPECT_EQ(std::fabs(value(0)), 0x1p-96f);
  EXPECT_EQ(value(1), 0.0f);
  EXPECT_EQ(std::fabs(value(2)), 0x1p-96f);
  EXPECT_EQ(value(3), 0.0f);
}

#ifdef __SSE2__
// While it lives, subnormal numbers are 0 as operands and as results, as they are on many drivers. Threads that start
// take it over.
class FlushedSubnormals {
 public:
  FlushedSubnormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }  // flush to zero, denormals are zero
  ~FlushedSubnormals() { _mm_setcsr(before_); }
  FlushedSubnormals(const FlushedSubnormals&) = delete;
  FlushedSubnormals& operator=(const FlushedSubnormals&) = delete;

 private:
  unsigned before_;
};

TEST(Twin, BitsOfPreciseAndFixedDoNotDependOnSubnormals) {
  for (const Configuration& configuration : all_configurations()) {
    if (configuration.fast()) continue;
    for (const Function& function : all_functions()) {
      if (!covers(configuration, function)) continue;
      const auto inputs = random_points(function, 1000, Random(1, function.id), defined_extremes(configuration));
      const auto values = evaluate_twin(function, configuration, inputs);
      const FlushedSubnormals flushed;
      EXPECT_TRUE(values == evaluate_twin(function, configuration, inputs)) << function.id << " " << configuration.name;
    }
  }
}
#endif

TEST(Shim, FloatsThatFitNoIntAreClamped) {
  using namespace hashnoise;
  EXPECT_EQ(ivec2(vec2(3e9f, -3e9f)), ivec2(std::numeric_limits<int>::max(), std::numeric_limits<int>::min()));
  EXPECT_EQ(ivec2(vec2(std::numeric_limits<float>::quiet_NaN(), -1.5f)), ivec2(0, -1));
}

// As in GLSL 5.4.2: every order of scalars and vectors, of any types.
TEST(Shim, VectorsAreMadeOfSmallerOnesAndOfScalars) {
  using namespace hashnoise;
  EXPECT_EQ(vec3(vec2(1.0f, 2.0f), 3.0f), vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(8.0f * vec2(1.0f, 2.0f) / 2.0f, vec2(4.0f, 8.0f));
  EXPECT_EQ(8.0f * vec3(1.0f, 2.0f, 3.0f) / vec3(2.0f, 4.0f, 8.0f), vec3(4.0f, 4.0f, 3.0f));
  EXPECT_EQ(vec3(1.0f, vec2(2.0f, 3.0f)), vec3(1.0f, 2.0f, 3.0f));
  const vec4 counted(1.0f, 2.0f, 3.0f, 4.0f);
  EXPECT_EQ(vec4(vec2(1.0f, 2.0f), vec2(3.0f, 4.0f)), counted);
  EXPECT_EQ(vec4(vec2(1.0f, 2.0f), 3.0f, 4.0f), counted);
  EXPECT_EQ(vec4(1.0f, vec2(2.0f, 3.0f), 4.0f), counted);
  EXPECT_EQ(vec4(1.0f, 2.0f, vec2(3.0f, 4.0f)), counted);
  EXPECT_EQ(vec4(vec3(1.0f, 2.0f, 3.0f), 4.0f), counted);
  EXPECT_EQ(vec4(1.0f, vec3(2.0f, 3.0f, 4.0f)), counted);
  // The rest of the last argument is dropped.
  EXPECT_EQ(vec2(counted), vec2(1.0f, 2.0f));
  EXPECT_EQ(vec3(counted), vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(vec3(vec2(1.0f, 2.0f), vec2(3.0f, 4.0f)), vec3(1.0f, 2.0f, 3.0f));
}

TEST(Shim, VectorsHaveTheOperatorsOfGlsl) {
  using namespace hashnoise;
  EXPECT_EQ(1.0f - vec2(1, 2), vec2(0, -1));
  EXPECT_EQ(2.0f / vec3(2, 4, 8), vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(1 + ivec4(1, 2, 3, 4), ivec4(2, 3, 4, 5));
  EXPECT_TRUE(std::signbit((-vec2(0, 1)).x));
  EXPECT_EQ(-ivec3(1, 2, 3), ivec3(-1, -2, -3));
  vec2 p(1, 2);
  p += vec2(1, 2);
  p *= 2.0f;
  p -= 1.0f;
  p /= vec2(3, 7);
  EXPECT_EQ(p, vec2(1, 1));
  ivec4 cell(7);
  EXPECT_EQ(cell /= 2, ivec4(3));
}

TEST(Shim, ConstructorsConvert) {
  using namespace hashnoise;
  EXPECT_EQ(vec3(ivec2(-1, 2), 3u), vec3(-1.0f, 2.0f, 3.0f));
  EXPECT_EQ(ivec4(vec2(-1.75f, 1.75f), uvec2(3u, 0xFFFFFFFFu)), ivec4(-1, 1, 3, -1));
  EXPECT_EQ(uvec3(ivec3(-1, 2, 3)), uvec3(0xFFFFFFFFu, 2u, 3u));
  EXPECT_EQ(ivec3(2.5f), ivec3(2, 2, 2));
  EXPECT_EQ(ivec2(vec3(3e9f, -3e9f, 0.0f)), ivec2(std::numeric_limits<int>::max(), std::numeric_limits<int>::min()));
  EXPECT_EQ(uvec2(true, false), uvec2(1u, 0u));
}

TEST(Shim, ConstructorsTakeAsManyComponentsAsThereAre) {
  using namespace hashnoise;
  static_assert(!std::is_constructible_v<vec3, vec2>);
  static_assert(!std::is_constructible_v<vec4, vec2, float>);
  static_assert(!std::is_constructible_v<vec2, vec2, float>);
  static_assert(!std::is_constructible_v<vec3, vec2, float, float>);
  static_assert(!std::is_convertible_v<vec3, vec2> && !std::is_convertible_v<float, vec2>);
}

}  // namespace
}  // namespace hn
