// Each operation rounds either way, and a product that is added may be whole.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <hashnoise/glsl.hpp>
#include <set>
#include <vector>

#include "roundings/ways.hpp"
#define HN_I_OWN_FLOATS "roundings/floats.hpp"
#include <hashnoise/lanes.hpp>

namespace hn::roundings {
namespace {

namespace own = hashnoise::own;
using Float = own::Float;

// Lanes round down and up in turn, and half of them fuse.
class Lanes : public testing::Test {
 protected:
  Lanes() : words_(kWays), before_(std::fegetround()) {
    for (std::uint32_t i = 0; i < words_.size(); ++i) words_[i] = (i & 1u) << 31u | (i >> 1u & 1u);
    ways = {.words = words_.data()};
    std::fesetround(FE_DOWNWARD);
  }
  ~Lanes() override { std::fesetround(before_); }

  static std::set<float> of(const Float& x) {
    std::set<float> found;
    for (int i = 0; i < own::kCount; ++i) found.insert(x[i]);
    return found;
  }

 private:
  std::vector<std::uint32_t> words_;
  int before_;
};
using Set = std::set<float>;

TEST_F(Lanes, RoundEitherWay) {
  EXPECT_EQ(of(Float(1.0f) + Float(0x1p-30f)), (Set{1.0f, 0x1.000002p0f}));
  EXPECT_EQ(of(Float(-1.0f) - Float(0x1p-30f)), (Set{-0x1.000002p0f, -1.0f}));
  EXPECT_EQ(of(Float(0x1.000002p0f) * Float(0x1.000002p0f)), (Set{0x1.000004p0f, 0x1.000006p0f}));
  EXPECT_EQ(of(Float(own::Int(-0x1000001))), (Set{-0x1.000002p24f, -0x1p24f}));
  EXPECT_EQ(of(Float(own::Uint(0xFFFFFFFFu))), (Set{0x1.fffffep31f, 0x1p32f}));
}

TEST_F(Lanes, KeepWhatIsExact) {
  EXPECT_EQ(of(Float(1.5f) + Float(2.25f)), Set{3.75f});
  EXPECT_EQ(of(Float(1.5f) * Float(-2.5f)), Set{-3.75f});
  EXPECT_EQ(of(Float(own::Int(-7)) + Float(own::Uint(9u))), Set{2.0f});
}

TEST_F(Lanes, MayFuseAProductOnEitherSide) {
  const Float x(0x1.000002p0f), square = x * x;  // 1 + 2^-22 + 2^-46
  EXPECT_TRUE(of(square - Float(0x1.000004p0f)).contains(0x1p-46f));
  EXPECT_TRUE(of(Float(0x1.000004p0f) - square).contains(-0x1p-46f));
  EXPECT_FALSE(of(own::select(x > 0.0f, square, x) - Float(0x1.000004p0f)).contains(0x1p-46f));
}

TEST_F(Lanes, AreOffBySeveralUlpsInQuotientsAndRoots) {
  EXPECT_EQ(of(Float(1.0f) / Float(2.0f)), (Set{0.5f - 0x1p-24f, 0.5f + 0x1p-23f}));
  EXPECT_EQ(of(Float(-1.0f) / Float(2.0f)), (Set{-0.5f - 0x1p-23f, -0.5f + 0x1p-24f}));
  EXPECT_EQ(of(sqrt(Float(4.0f))), (Set{2.0f - 0x1.4p-21f, 2.0f + 0x1.4p-20f}));
  EXPECT_EQ(of(sqrt(Float(0.0f))), Set{0.0f});
}

}  // namespace
}  // namespace hn::roundings
