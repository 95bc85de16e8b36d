// The table noises, on OSMesa.
#include "bench/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "bench/workbench.hpp"
#include "expected/points.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

TEST(TablePermutation, HasEveryNumberOnce) {
  const auto p = table_permutation();
  EXPECT_EQ(std::set(p.begin(), p.end()).size(), 256u);
  EXPECT_FALSE(std::is_sorted(p.begin(), p.end()));
  EXPECT_EQ(p, table_permutation());
}

class TableNoise : public OnOsmesa<testing::TestWithParam<int>> {
 protected:
  void SetUp() override {
    OnOsmesa::SetUp();
    if (HasFatalFailure()) return;
    sampler_ = std::make_unique<Sampler>(*context_, SourceSet::embedded());
  }

  std::vector<float> values(const Subject& subject, const std::vector<Position>& positions) {
    const auto values = sampler_->values(subject, positions);
    EXPECT_TRUE(values) << values.error().text();
    return values.value_or(std::vector<float>(positions.size()));
  }

  // In multiples of 2^-14, so that a position a period away has the same fraction.
  static std::vector<Position> positions(float low, float high) {
    Random random(1, "tables");
    std::vector<Position> positions(5000);
    const auto coordinate = [&] { return std::floor(random.uniform(low, high) * 16384.0f) / 16384.0f; };
    for (Position& p : positions) {
      p.x = coordinate();
      p.y = coordinate();
      p.z = coordinate();
    }
    return positions;
  }

  std::unique_ptr<Sampler> sampler_;
};

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}));
  return largest;
}

constexpr double kRounding = 1e-5;

TEST_P(TableNoise, IsTheSameWithFloatsAndIntegers) {
  for (const auto& [low, high] : {std::pair{-4.0f, 4.0f}, {0.0f, 256.0f}, {-256.0f, 0.0f}}) {
    const auto at = positions(low, high);
    const auto floats = values(float_subject(GetParam()), at);
    EXPECT_LE(largest_difference(floats, values(integer_subject(GetParam()), at)), kRounding) << low;
    // The two fields are not zero everywhere, and positions give different values.
    const auto [least, greatest] = std::minmax_element(floats.begin(), floats.end());
    EXPECT_LT(*least, -0.5f) << low;
    EXPECT_GT(*greatest, 0.5f) << low;
    auto others = at;
    for (Position& p : others) p.x += 1.0f;
    EXPECT_GT(largest_difference(floats, values(integer_subject(GetParam()), others)), 0.5) << low;
  }
}

TEST_P(TableNoise, HasThePeriod256) {
  const auto at = positions(-128.0f, 128.0f);
  for (const Subject& subject : {float_subject(GetParam()), integer_subject(GetParam())}) {
    const auto here = values(subject, at);
    float Position::*const axes[] = {&Position::x, &Position::y, &Position::z};
    for (int axis = 0; axis < GetParam(); ++axis) {
      for (const auto& [cells, repeats] : {std::pair{256.0f, true}, {-256.0f, true}, {128.0f, false}, {64.0f, false}}) {
        auto there = at;
        for (Position& p : there) p.*axes[axis] += cells;
        const double difference = largest_difference(here, values(subject, there));
        EXPECT_EQ(difference <= kRounding, repeats) << subject.id << " " << axis << " " << cells << ": " << difference;
      }
    }
  }
}

TEST_P(TableNoise, IsZeroAtLatticePoints) {
  auto at = positions(-256.0f, 256.0f);
  for (Position& p : at) p = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const std::vector<float> zeros(at.size());
  EXPECT_LE(largest_difference(values(float_subject(GetParam()), at), zeros), kRounding);
  EXPECT_EQ(largest_difference(values(integer_subject(GetParam()), at), zeros), 0.0);
}

// A renderer that is made later has textures of its own.
TEST_P(TableNoise, KeepsItsTablesBesideARenderer) {
  const auto at = positions(-4.0f, 4.0f);
  const auto before = values(float_subject(GetParam()), at);
  GridRenderer later(*context_);
  const auto program = sampler_->build(value_shader(float_subject(GetParam())));
  ASSERT_TRUE(program) << program.error().text();
  std::vector<std::uint32_t> inputs(at.size() * kInputWords);
  for (std::size_t i = 0; i < at.size(); ++i) {
    inputs[i * kInputWords] = std::bit_cast<std::uint32_t>(at[i].x);
    inputs[i * kInputWords + 1] = std::bit_cast<std::uint32_t>(at[i].y);
    inputs[i * kInputWords + 2] = std::bit_cast<std::uint32_t>(at[i].z);
  }
  const auto words = later.evaluate(*program, inputs);
  ASSERT_TRUE(words) << words.error().text();
  std::vector<float> after(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) after[i] = std::bit_cast<float>((*words)[i * kOutputWords]);
  EXPECT_EQ(before, after);
  EXPECT_EQ(before, values(float_subject(GetParam()), at));
  for (const Subject& subject : {float_subject(GetParam()), integer_subject(GetParam())}) {
    EXPECT_LE(largest_difference(before, values(subject, at)), kRounding) << subject.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, TableNoise, testing::Values(2, 3),
                         [](const auto& test) { return std::to_string(test.param) + "D"; });

}  // namespace
}  // namespace hn
