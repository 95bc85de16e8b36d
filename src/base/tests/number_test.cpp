#include "base/number.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

TEST(Number, ThreeDigitsKeepTheirZeros) {
  EXPECT_EQ(three_digits(2.0), "2.00");
  EXPECT_EQ(three_digits(13.96), "14.0");
  EXPECT_EQ(three_digits(527.4), "527");
  EXPECT_EQ(three_digits(0.0012345), "0.00123");
}

TEST(Number, ZeroHasNoMinus) {
  EXPECT_EQ(decimals(-0.0004, 3), "0.000");
  EXPECT_EQ(decimals(-0.0006, 3), "-0.001");
  EXPECT_EQ(decimals(1.5, 1), "1.5");
}

}  // namespace
}  // namespace hn
