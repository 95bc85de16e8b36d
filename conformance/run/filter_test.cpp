#include "run/filter.hpp"

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

}  // namespace
}  // namespace hn
