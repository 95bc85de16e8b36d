#include "points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hn {
namespace {

TEST(Points, TheSameSeedGivesTheSamePoints) {
  const Function& function = find_function("noise3d.perlin");
  EXPECT_EQ(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(7, "a")));
  EXPECT_NE(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(8, "a")));
  EXPECT_NE(random_points(function, 100, Random(7, "a")), random_points(function, 100, Random(7, "b")));
}

TEST(Points, PositionsAreNearNegativeFarAndOnLatticeLines) {
  const auto words = random_points(find_function("noise2d.perlin"), 10000, Random(1, "test"));
  int near = 0, negative = 0, far = 0, on_line = 0;
  for (std::size_t i = 0; i < words.size(); i += kInputWords) {
    const float x = std::bit_cast<float>(words[i]);
    ASSERT_TRUE(std::isfinite(x));
    ASSERT_LT(std::fabs(x), 8388608.0f);
    near += x > 0 && x < 64;
    negative += x < 0;
    far += std::fabs(x) >= 1048576.0f;
    on_line += x == std::floor(x) && std::fabs(x) <= 64;
  }
  for (const int count : {near, negative, far, on_line}) EXPECT_GT(count, 500);
}

TEST(Points, NoPositionIsSubnormal) {
  const auto words = random_points(find_function("noise3d.perlin"), 100000, Random(1, "test"));
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i % kInputWords < 3) {
      ASSERT_NE(std::fpclassify(std::bit_cast<float>(words[i])), FP_SUBNORMAL);
    }
  }
}

TEST(Points, FractionsReachBothEnds) {
  const auto words = random_points(find_function("noise2d.perlin_cell"), 10000, Random(1, "test"));
  bool zero = false, one = false;
  for (std::size_t i = 2; i < words.size(); i += kInputWords) {
    const float f = std::bit_cast<float>(words[i]);
    ASSERT_GE(f, 0.0f);
    ASSERT_LE(f, 1.0f);
    zero |= f == 0.0f;
    one |= f == 1.0f;
  }
  EXPECT_TRUE(zero && one);
}

TEST(Random, UniformStaysBelowItsEnd) {
  Random random(3, "uniform");
  for (int i = 0; i < 1000000; ++i) ASSERT_LT(random.uniform(-1.0f, 3.0f), 3.0f);
}

}  // namespace
}  // namespace hn
