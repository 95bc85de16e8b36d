#include "bench_cpu/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hn {
namespace {

// Other programs on the machine can spoil a measurement, but hardly every time.
constexpr int kAttempts = 5;

void work_for(int times) {
  volatile float sink = 0.0f;
  for (int i = 0; i < 20000 * times; ++i) sink = std::sqrt(sink + 1.0f);
}

TEST(Measure, TellsWhatTakesLonger) {
  double ratio = 0.0;
  for (int attempt = 0; attempt < kAttempts && !(ratio >= 2.5 && ratio <= 3.5); ++attempt) {
    const std::vector<std::function<void()>> works = {[] { work_for(1); }, [] { work_for(3); }};
    const auto timings = measure(works, 9);
    ASSERT_EQ(timings.size(), 2u);
    ASSERT_EQ(timings[0].samples.size(), 9u);
    ratio = speed(timings[0], timings[1]).value;
  }
  EXPECT_GE(ratio, 2.5);
  EXPECT_LE(ratio, 3.5);
}

TEST(Measure, TakesTurns) {
  std::string order;
  const std::vector<std::function<void()>> works = {[&] { work_for(100), order += 'a'; },
                                                    [&] { work_for(100), order += 'b'; }};
  measure(works, 3);
  // Before the rounds, and in three of them; as often as they like at a time.
  order.erase(std::unique(order.begin(), order.end()), order.end());
  EXPECT_EQ(order, "abababab");
}

TEST(Speed, IsAQuotientOfTimesTheOtherWayRound) {
  const Ratio ratio = speed({{1.0, 2.0, 4.0}}, {{2.0, 4.0, 8.0}});
  EXPECT_EQ(ratio.value, 2.0);
  EXPECT_EQ(ratio.spread, 0.0);
}

TEST(Subjects, AreFields) {
  for (const Subject& subject : subjects()) {
    const auto settings = settings_of(subject, hashnoise::Arithmetic::kFast, hashnoise::instruction_sets().front());
    if (subject.dimensions == 2) {
      EXPECT_NO_THROW(hashnoise::Field<2>{settings}) << subject.id;
    } else {
      EXPECT_NO_THROW(hashnoise::Field<3>{settings}) << subject.id;
    }
    EXPECT_EQ(subject.sum.empty(), subject.fractal.empty());
  }
}

TEST(Subjects, ListsHaveThePointsOfGrids) {
  const auto positions = positions_of_grid(3);
  ASSERT_EQ(positions.size(), 3u);
  for (const auto& axis : positions) ASSERT_EQ(axis.size(), static_cast<std::size_t>(kPoints));
  EXPECT_EQ(positions[0][130], 2.0f * kStep);
  EXPECT_EQ(positions[1][130], kStep);
  EXPECT_EQ(positions[2][kPoints - 1], 63.0f * kStep);
}

}  // namespace
}  // namespace hn
