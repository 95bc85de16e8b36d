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
  const std::vector<Case> cases = {{"a.x.golden", {}}, {"a.y.twin", {}}, {"b.x.golden", {}}};
  EXPECT_EQ(ids(filter_cases(cases, {})).size(), 3u);
  EXPECT_EQ(ids(filter_cases(cases, {"*golden"})), (std::vector<std::string>{"a.x.golden", "b.x.golden"}));
  EXPECT_EQ(ids(filter_cases(cases, {"a.y*", "b.*"})), (std::vector<std::string>{"a.y.twin", "b.x.golden"}));
  EXPECT_TRUE(filter_cases(cases, {"golden"}).empty());
}

}  // namespace
}  // namespace hn
