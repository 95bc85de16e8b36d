#include "run/filter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

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

TEST(Cases, IdsAreUniqueAndHaveSevenParts) {
  std::set<std::string> seen;
  for (const Case& test : all_cases()) {
    EXPECT_TRUE(seen.insert(test.id).second) << test.id;
    EXPECT_EQ(std::count(test.id.begin(), test.id.end(), '.'), 6) << test.id;
  }
}

TEST(Cases, EveryConfigurationAndFunctionHasGoldenAndTwin) {
  std::set<std::string> seen;
  for (const Case& test : all_cases()) seen.insert(test.id);
  for (const Function& function : all_functions()) {
    for (const Configuration& configuration : all_configurations()) {
      if (!covers(configuration, function)) continue;
      const auto name = depends_on_configuration(function) ? configuration.name_without_arithmetic() : "any";
      const bool precise = configuration.arithmetic() == Arithmetic::precise;
      const std::string start = fmt::format("{}.{}.{}.fragment.{}.", function.id, name,
                                            arithmetic_name(function, configuration), precise ? "gl400" : "gl330");
      EXPECT_TRUE(seen.contains(start + "golden")) << start;
      EXPECT_TRUE(seen.contains(start + "twin")) << start;
    }
  }
}

}  // namespace
}  // namespace hn
