// The search for feature points, against the twin and the golden files' margins.
#include "expected/cellular.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "expected/compare.hpp"
#include "expected/points.hpp"
#include "expected/twin.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::size_t kPoints = 300;

// Calls with each function of cellular noise, and the arithmetics that have values of it.
template <typename Call>
void for_each_row(Call call) {
  for (const Function& function : all_functions()) {
    if (!function.is_cellular()) continue;
    for (const Configuration& configuration : all_configurations()) {
      if (covers(configuration, function)) call(function, configuration);
    }
  }
}

// Every bit, names included. This shares no code with the twin.
TEST(Search, HasTheBitsOfFixedArithmetic) {
  for_each_row([](const Function& function, const Configuration& configuration) {
    if (configuration.arithmetic != Arithmetic::fixed) return;
    const Words inputs = random_points(function, kPoints, Random(1, "search"), Extremes::integers);
    const Words values = evaluate_twin(function, configuration, inputs);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto point = std::span(inputs).subspan(i * kInputWords, kInputWords);
      const CellularValue right = searched(function, configuration, point);
      for (std::size_t word = 0; word < function.outputs.size(); ++word) {
        const std::uint32_t got = values[i * kOutputWords + word];
        const std::uint32_t expected = function.is_name(word)
                                           ? static_cast<std::uint32_t>(static_cast<std::int32_t>(right.values[word]))
                                           : std::bit_cast<std::uint32_t>(static_cast<float>(right.values[word]));
        ASSERT_EQ(got, expected) << function.id << " " << describe_inputs(function, point);
      }
    }
  });
}

TEST(Search, IsNearTheFloatsOfTheTwin) {
  for_each_row([](const Function& function, const Configuration& configuration) {
    if (configuration.arithmetic == Arithmetic::fixed) return;
    const Words inputs = random_points(function, kPoints, Random(2, "search"));
    const Words values = evaluate_twin(function, configuration, inputs);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto point = std::span(inputs).subspan(i * kInputWords, kInputWords);
      const CellularValue right = searched(function, configuration, point);
      if (function.jumps() && right.second - right.first < kClearMargin) continue;
      for (std::size_t word = 0; word < function.outputs.size(); ++word) {
        const std::uint32_t got = values[i * kOutputWords + word];
        const double value = function.is_name(word) ? static_cast<double>(static_cast<std::int32_t>(got))
                                                    : static_cast<double>(std::bit_cast<float>(got));
        const double allowed = function.is_slope(word) ? 1e-5 / std::max(right.first, 1e-5) : 1e-4;
        ASSERT_NEAR(value, right.values[word], allowed) << function.id << " " << describe_inputs(function, point);
      }
    }
  });
}

// One cell to each side is enough for two distances, and two for all.
TEST(Search, AsFarAsItGoesNothingMatters) {
  for_each_row([](const Function& function, const Configuration& configuration) {
    if (!configuration.is_default()) return;
    const bool far = function.bound == "cellular_three" || function.bound == "cell_border";
    const Words inputs = random_points(function, 2 * kPoints, Random(3, "search"));
    for (std::size_t i = 0; i < 2 * kPoints; ++i) {
      const auto point = std::span(inputs).subspan(i * kInputWords, kInputWords);
      EXPECT_EQ(searched(function, configuration, point, far ? 2 : 1).values,
                searched(function, configuration, point).values)
          << function.id << " " << describe_inputs(function, point);
    }
  });
}

TEST(Search, UndecidedIsWhatJumpsAndWhatIsEquallyNear) {
  const Function& names = find_function("noise2d.cellular_nearest");
  const auto place = [](float x, float jitter) {
    Words words(kInputWords);
    words[0] = words[1] = std::bit_cast<std::uint32_t>(x);
    words[2] = std::bit_cast<std::uint32_t>(jitter);
    words[3] = 1;
    return words;
  };
  const Configuration& fast = default_configuration();
  // On a regular lattice the corner of a cell is as far from four points, and its middle is one.
  EXPECT_TRUE(is_undecided(names, fast, place(3.0f, 0.0f)));
  EXPECT_FALSE(is_undecided(names, fast, place(3.5f, 0.0f)));
  EXPECT_TRUE(is_undecided(names, fast, place(3.0001f, 0.0f)));
  EXPECT_FALSE(is_undecided(names, fast, place(3.01f, 0.0f)));
  EXPECT_FALSE(is_undecided(names, configuration_named("lattice+fixed"), place(3.0f, 0.0f)));
  EXPECT_FALSE(is_undecided(names, configuration_named("lattice+precise"), place(3.0f, 0.0f)));
  EXPECT_FALSE(is_undecided(find_function("noise2d.cellular_full"), fast, place(3.0f, 0.0f)));
  EXPECT_EQ(nearest_distance(names, fast, place(3.5f, 0.0f)), 0.0);
  EXPECT_EQ(nearest_distance(names, fast, place(3.0f, 0.0f)), std::sqrt(0.5));
}

}  // namespace
}  // namespace hn
