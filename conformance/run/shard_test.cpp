#include "run/shard.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

TEST(Shards, AreIOfN) {
  EXPECT_TRUE(parse_shard("")->has(17));
  EXPECT_EQ(parse_shard("2/3")->index, 2u);
  EXPECT_EQ(parse_shard("2/3")->count, 3u);
  for (const char* wrong : {"0/3", "4/3", "1", "/", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0", "1 /2", "1/99999"}) {
    const auto shard = parse_shard(wrong);
    ASSERT_FALSE(shard) << wrong;
    EXPECT_NE(shard.error().message.find("2/3"), std::string::npos);
  }
}

TEST(Shards, HaveEveryCaseOnce) {
  for (std::size_t number = 0; number < 20; ++number) {
    int owners = 0;
    for (const char* shard : {"1/3", "2/3", "3/3"}) owners += parse_shard(shard)->has(number) ? 1 : 0;
    EXPECT_EQ(owners, 1) << number;
  }
}

}  // namespace
}  // namespace hn
