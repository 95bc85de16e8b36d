#include "run/selection.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

std::vector<std::string> ids(const std::vector<Case>& cases) {
  std::vector<std::string> names;
  for (const Case& test : cases) names.push_back(test.id);
  return names;
}

TEST(Filter, GlobsSelectAndUnite) {
  const auto test = [](std::string function, std::string check) {
    return Case({std::move(function), "c", "fast", Stage::vertex, "es300", std::move(check)}, ReferenceKind{});
  };
  const std::vector<Case> cases = {test("a.x", "golden"), test("a.y", "twin"), test("b.x", "golden")};
  const std::string ax = "a.x.c.fast.vertex.es300.golden";
  const std::string ay = "a.y.c.fast.vertex.es300.twin";
  const std::string bx = "b.x.c.fast.vertex.es300.golden";
  EXPECT_EQ(ids(filter_cases(cases, {})), (std::vector<std::string>{ax, ay, bx}));
  EXPECT_EQ(ids(filter_cases(cases, {"*golden"})), (std::vector<std::string>{ax, bx}));
  EXPECT_EQ(ids(filter_cases(cases, {"a.y*", "b.*"})), (std::vector<std::string>{ay, bx}));
  EXPECT_TRUE(filter_cases(cases, {"golden"}).empty());
}

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
