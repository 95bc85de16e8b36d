#include "bake/mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hn {
namespace {

using Words = std::vector<std::uint16_t>;

TEST(Mapping, EndsAndMiddle) {
  const Texels mapped = to_16_bits(std::vector<float>{-1.0f, 0.0f, 1.0f, -0.5f}, {-1.0, 1.0});
  EXPECT_EQ(mapped.words, (Words{0, 32768, 65535, 16384}));
  EXPECT_EQ(mapped.clamped, 0u);
}

TEST(Mapping, OfEveryWord) {
  std::vector<float> values;
  Words words;
  for (int i = 0; i < 65536; ++i) {
    values.push_back(static_cast<float>(i) / 65536.0f);
    words.push_back(static_cast<std::uint16_t>(i));
  }
  const Texels mapped = to_16_bits(values, {0.0, 65535.0 / 65536.0});
  EXPECT_EQ(mapped.words, words);
  EXPECT_EQ(mapped.clamped, 0u);
}

TEST(Mapping, CountsWhatIsOutside) {
  const float above = std::nextafter(1.0f, 2.0f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const Texels mapped = to_16_bits(std::vector<float>{above, -0.1f, nan, infinite, -infinite, 1.0f}, {0.0, 1.0});
  EXPECT_EQ(mapped.words, (Words{65535, 0, 0, 65535, 0, 65535}));
  EXPECT_EQ(mapped.clamped, 4u);  // without NaN
}

TEST(Mapping, OfNoExtent) { EXPECT_EQ(to_16_bits(std::vector<float>{0.5f, 0.5f}, {0.5, 0.5}).words, (Words{0, 0})); }

}  // namespace
}  // namespace hn
