#include "expected/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace hn {
namespace {

Outcome wrong_values(double max_abs, std::optional<double> allowed, std::uint64_t max_ulp) {
  Outcome outcome;
  outcome.status = Status::fail;
  outcome.samples = 192;
  outcome.mismatches = 123;
  outcome.max_abs = max_abs;
  outcome.allowed = allowed;
  outcome.max_ulp = max_ulp;
  return outcome;
}

TEST(Measure, SaysWhatIsAllowedWhereSomethingIs) {
  EXPECT_EQ(measure_of(wrong_values(0.389, 3.51e-6, 2089716250)),
            "123 of 192 values are wrong; the largest difference is 0.389, and 3.51e-06 is allowed");
}

TEST(Measure, TellsUnitsInTheLastPlaceWhereEveryBitCountsAndTheyAreFew) {
  EXPECT_EQ(measure_of(wrong_values(1.1920929e-7, 0.0, 1)),
            "123 of 192 values are wrong; "
            "the largest difference is 1.19e-07 (1 unit in the last place), and none is allowed");
  EXPECT_EQ(measure_of(wrong_values(2.3841858e-7, 0.0, 2)),
            "123 of 192 values are wrong; "
            "the largest difference is 2.38e-07 (2 units in the last place), and none is allowed");
  EXPECT_EQ(measure_of(wrong_values(0.7, 0.0, 2080170303)),
            "123 of 192 values are wrong; the largest difference is 0.7, and none is allowed");
}

TEST(Measure, SaysNothingThatIsNotKnown) {
  EXPECT_EQ(measure_of(wrong_values(0.0, {}, 0)), "123 of 192 values are wrong") << "words have no difference";
  EXPECT_EQ(measure_of(wrong_values(0.5, {}, 9)), "123 of 192 values are wrong");
  EXPECT_EQ(measure_of(wrong_values(0.5, 0.75, 9)), "123 of 192 values are wrong") << "what is so far off may be so";
  EXPECT_EQ(measure_of(wrong_values(std::numeric_limits<double>::max(), 3.5e-6, 9)),
            "123 of 192 values are wrong, some of them infinite or not a number");
  EXPECT_EQ(measure_of({}), "");
}

}  // namespace
}  // namespace hn
