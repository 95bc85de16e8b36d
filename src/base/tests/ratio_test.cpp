#include "base/ratio.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace hn {
namespace {

TEST(Timing, MedianAndSpread) {
  struct Row {
    std::vector<double> samples;
    double median;
    double spread;
  };
  const Row rows[] = {
      {{}, 0.0, 0.0},
      {{7.0}, 7.0, 0.0},
      {{9.0, 1.0}, 5.0, 2.0},
      {{9.0, 1.0, 2.0}, 2.0, 2.0},
      {{8.0, 1.0, 4.0, 2.0}, 3.0, 1.625},
      {{5.0, 1.0, 4.0, 2.0, 3.0}, 3.0, 1.0},
      {{2.0, 2.0, 1000.0, 2.0, 2.0}, 2.0, 0.0},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(Timing{row.samples}.median(), row.median);
    EXPECT_EQ(Timing{row.samples}.spread(), row.spread);
  }
}

TEST(Ratio, OfTooFewRoundsCannotBeTold) {
  EXPECT_FALSE(ratio({{6.0}}, {{1.0}}, {{1.0}}).known());
  EXPECT_FALSE(ratio({}, {}, {}).known());
  // Two of three rounds prove nothing.
  EXPECT_FALSE(ratio({{6.0, 6.0, 6.0}}, {{1.0, 0.5, 3.0}}, {{1.0, 1.0, 1.0}}).known());
  EXPECT_EQ(text_of({}), "cannot be told");
  EXPECT_EQ(text_of({1.234, 0.056}), "1.23 ± 0.06");
}

struct RatioRow {
  std::string_view what;
  std::vector<double> timing;
  std::vector<double> reference;
  std::vector<double> empty;
  double value;
  double spread;
};

TEST(Ratio, OfRounds) {
  const RatioRow rows[] = {
      {"the empty shader is taken off both", {7.0}, {3.0}, {1.0}, 3.0, 0.0},
      {"as fast as the empty shader", {1.0}, {3.0}, {1.0}, 0.0, 0.0},
      {"round by round, so that what slows a round down leaves its ratio", {4.0, 40.0}, {2.0, 20.0}, {0, 0}, 2.0, 0.0},
      {"the median of the rounds", {1.0, 2.0, 90.0}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, 2.0, 22.25},
      {"half the distance of the quartiles", {5.0, 1.0, 4.0, 2.0, 3.0}, {1, 1, 1, 1, 1}, {0, 0, 0, 0, 0}, 3.0, 1.0},
      {"rounds whose reference is no longer than the empty shader are left out",
       {6.0, 6.0, 6.0},
       {3.0, 0.5, 3.0},
       {1.0, 1.0, 1.0},
       2.5,
       0.0},
      {"more samples of the subject", {4.0, 100.0}, {2.0}, {0.0, 0.0}, 2.0, 0.0},
      {"more samples of the reference", {4.0}, {2.0, 100.0}, {0.0, 0.0}, 2.0, 0.0},
      {"more samples of the empty shader", {4.0}, {2.0}, {0.0, 100.0}, 2.0, 0.0},
  };
  for (const RatioRow& row : rows) {
    const Ratio is = ratio({row.timing}, {row.reference}, {row.empty});
    EXPECT_EQ(is.value, row.value) << row.what;
    EXPECT_EQ(is.spread, row.spread) << row.what;
  }
}

}  // namespace
}  // namespace hn
