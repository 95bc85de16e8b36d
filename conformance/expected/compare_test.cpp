#include "expected/compare.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace hn {
namespace {

const std::vector<std::uint32_t> kInputs(kInputWords, 0u);
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(UlpDistance, CountsFloatsBetween) {
  EXPECT_EQ(ulp_distance(1.0f, 1.0f), 0u);
  EXPECT_EQ(ulp_distance(1.0f, std::nextafter(1.0f, 2.0f)), 1u);
  EXPECT_EQ(ulp_distance(0.0f, -0.0f), 0u);
  EXPECT_EQ(ulp_distance(std::nextafter(0.0f, 1.0f), std::nextafter(0.0f, -1.0f)), 2u);
  EXPECT_EQ(ulp_distance(kNan, 1.0f), 0xFFFFFFFFu);
  EXPECT_EQ(ulp_distance(kNan, kNan), 0u);
}

TEST(Comparison, OneBitOffFails) {
  Comparison comparison(find_function("hash.word"), kInputs);
  comparison.bits(kInputs, 5, 5);
  EXPECT_EQ(comparison.finish().status, Status::pass);
  comparison.bits(kInputs, 5, 4);
  const Outcome outcome = comparison.finish();
  EXPECT_EQ(outcome.status, Status::fail);
  EXPECT_EQ(outcome.samples, 2u);
  EXPECT_EQ(outcome.mismatches, 1u);
  EXPECT_EQ(outcome.message, "first at key=0 (00000000): got 5 (00000005), expected 4 (00000004)");
}

TEST(Comparison, NumbersMayBeOffByWhatIsAllowedAndNoMore) {
  Comparison comparison(find_function("noise2d.perlin"), kInputs);
  comparison.number(kInputs, 0.5f, 0.5 + 0x1p-20, 0x1p-20);
  EXPECT_EQ(comparison.finish().status, Status::pass);
  EXPECT_EQ(comparison.finish().max_abs, 0x1p-20);
  EXPECT_EQ(comparison.finish().max_ulp, 16u);
  comparison.number(kInputs, 0.5f, 0.5 + 0x1.1p-20, 0x1p-20);
  EXPECT_EQ(comparison.finish().status, Status::fail);
  EXPECT_EQ(comparison.finish().allowed, 0x1p-20);
}

TEST(Comparison, NamesAreBitsAndWhatIsUndecidedIsLeftOut) {
  const Function& names = find_function("noise2d.cellular_nearest");
  Comparison comparison(names, kInputs);
  comparison.word(kInputs, 7, 0.0, 7, 1.0, 0);
  comparison.word(kInputs, 7, 0.0, 6, kUndecided, 0);
  EXPECT_EQ(comparison.left_out(), 1u);
  comparison.word(kInputs, 7, 0.0, 6, 1.0, 0);
  EXPECT_EQ(comparison.finish().mismatches, 1u) << "the nearest cell is right or wrong";
  Comparison offsets(find_function("noise2d.cellular_offset"), kInputs);
  const auto half = std::bit_cast<std::uint32_t>(0.5f);
  offsets.word(kInputs, half, 0.51, 0, 0.1, 0);
  EXPECT_TRUE(offsets.all_right());
  offsets.word(kInputs, half, 0.5, half + 1, std::nullopt, 0);
  EXPECT_FALSE(offsets.all_right());
}

// A check that leaves out more than an eighth proves nothing.
TEST(Comparison, TooMuchThatIsLeftOutIsAnError) {
  Comparison comparison(find_function("noise2d.cellular_nearest"), kInputs);
  for (int i = 0; i < 7; ++i) comparison.word(kInputs, 1, 0.0, 1, 0.0, 0);
  comparison.word(kInputs, 1, 0.0, 2, kUndecided, 0);
  EXPECT_EQ(comparison.finish().status, Status::pass);
  comparison.word(kInputs, 1, 0.0, 2, kUndecided, 0);
  EXPECT_EQ(comparison.finish().status, Status::error);
}

TEST(Comparison, WhatIsAllowedIsThatOfTheLargestDifference) {
  Comparison comparison(find_function("noise2d.perlin"), kInputs);
  EXPECT_FALSE(comparison.finish().allowed);
  comparison.number(kInputs, 0.5f, 0.75, 0.125);
  comparison.number(kInputs, 0.5f, 0.625, 0.0625);
  EXPECT_EQ(comparison.finish().allowed, 0.125);
  comparison.number(kInputs, 0.5f, 2.5, std::numeric_limits<double>::infinity());
  EXPECT_EQ(comparison.finish().allowed, std::numeric_limits<double>::max()) << "JSON has no infinity";
}

TEST(Comparison, BitsOfFloatsHaveADifference) {
  Comparison comparison(find_function("noise2d.perlin"), kInputs);
  comparison.bits(kInputs, std::bit_cast<std::uint32_t>(0.5f), std::bit_cast<std::uint32_t>(0.5f));
  comparison.bits(kInputs, std::bit_cast<std::uint32_t>(0.5f), std::bit_cast<std::uint32_t>(0.75f));
  const Outcome outcome = comparison.finish();
  EXPECT_EQ(outcome.mismatches, 1u);
  EXPECT_EQ(outcome.max_abs, 0.25);
  EXPECT_EQ(outcome.max_ulp, 1u << 22);
  EXPECT_EQ(outcome.allowed, 0.0);
  Comparison zeros(find_function("noise2d.perlin"), kInputs);
  zeros.bits(kInputs, 0u, 0x80000000u);
  EXPECT_EQ(zeros.finish().mismatches, 1u) << "-0 has other bits than 0";
}

TEST(Comparison, OneOfSeveralOutputsIsNamed) {
  Comparison comparison(find_function("hash.gradient2"), kInputs);
  comparison.number(kInputs, 0.5f, 0.25, 0.0, 1);
  EXPECT_EQ(comparison.finish().examples.at(0).got, "y=0.5 (3f000000)");
}

TEST(Comparison, PointsOfTheNextGridAreNumberedOn) {
  const std::vector<std::uint32_t> first(3 * kInputWords, 0u);
  Comparison comparison(find_function("hash.word"), first);
  comparison.bits(std::span(first).subspan(2 * kInputWords, kInputWords), 5, 4);
  const std::vector<std::uint32_t> second(2 * kInputWords, 0u);
  comparison.next_grid(second);
  comparison.bits(std::span(second).subspan(kInputWords, kInputWords), 5, 4);
  const Outcome outcome = comparison.finish();
  ASSERT_EQ(outcome.examples.size(), 2u);
  EXPECT_EQ(outcome.examples[0].point, 2u);
  EXPECT_EQ(outcome.examples[1].point, 4u);
}

TEST(Comparison, NanAndInfinityAreNeverRight) {
  for (const float wrong : {kNan, std::numeric_limits<float>::infinity()}) {
    Comparison comparison(find_function("noise2d.perlin"), kInputs);
    comparison.number(kInputs, wrong, 0.0, 1e30);
    const Outcome outcome = comparison.finish();
    EXPECT_EQ(outcome.status, Status::fail);
    EXPECT_TRUE(std::isfinite(outcome.max_abs));
  }
}

TEST(Comparison, NothingComparedIsAnError) {
  EXPECT_EQ(Comparison(find_function("hash.word"), kInputs).finish().status, Status::error);
}

TEST(Comparison, MessagesShowInputsInTheirOwnWay) {
  std::vector<std::uint32_t> inputs(kInputWords, 0u);
  inputs[0] = 0xFFFFFFFFu;
  inputs[2] = std::bit_cast<std::uint32_t>(0.5f);
  EXPECT_EQ(describe_inputs(find_function("noise2d.perlin_cell"), inputs),
            "cx=-1 (ffffffff) cy=0 (00000000) fx=0.5 (3f000000) fy=0 (00000000) seed=0 (00000000)");
}

}  // namespace
}  // namespace hn
