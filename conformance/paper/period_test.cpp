#include "paper/period.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace hn {
namespace {

std::size_t repeat(const std::vector<std::uint32_t>& words) { return shortest_cyclic_repeat(words); }

TEST(Period, OfSequences) {
  EXPECT_EQ(repeat({}), 0u);
  EXPECT_EQ(repeat({7}), 1u);
  EXPECT_EQ(repeat({7, 7, 7, 7}), 1u);
  EXPECT_EQ(repeat({1, 2, 1, 2, 1, 2}), 2u);
  EXPECT_EQ(repeat({1, 2, 3, 1, 2, 4}), 6u);
}

// 1 2 1 2 1 repeats after 2 from its start, but not when it goes round.
TEST(Period, MustGoRound) { EXPECT_EQ(repeat({1, 2, 1, 2, 1}), 5u); }

TEST(Period, OneWordThatIsOffIsSeen) {
  std::vector<std::uint32_t> words(1 << 16);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(i & 255u);
  EXPECT_EQ(repeat(words), 256u);
  words[12345] ^= 1u;
  EXPECT_EQ(repeat(words), words.size());
}

}  // namespace
}  // namespace hn
