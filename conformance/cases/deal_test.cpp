#include "cases/deal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hn {
namespace {

Case case_of(std::string function, std::string check, Extent extent) {
  return {
      {std::move(function), "lattice", "fast", Stage::fragment, "gl330", std::move(check)}, ReferenceKind{}, extent};
}

bool anything(const Case&) { return true; }
bool nothing(const Case&) { return false; }

using Places = std::vector<std::vector<std::size_t>>;

TEST(Deal, WhatEveryDriverMustShowIsForEachAndTheRestForOne) {
  const std::vector<Case> cases = {case_of("a.a", "golden", Extent::every_driver),
                                   case_of("a.b", "golden", Extent::one_driver),
                                   case_of("a.c", "golden", Extent::one_driver)};
  const std::vector<DealtDriver> drivers = {{anything, "a"}, {anything, "b"}};
  EXPECT_EQ(deal(cases, drivers), (Places{{0, 2}, {0, 1}}));
}

TEST(Deal, OfOneRendererTheFirstDriverShowsWhatEachMustAndTheOthersHaveTheirShare) {
  const std::vector<Case> cases = {case_of("a.a", "golden", Extent::every_driver),
                                   case_of("a.b", "golden", Extent::one_driver),
                                   case_of("a.c", "golden", Extent::one_driver)};
  const std::vector<DealtDriver> drivers = {{anything, "a"}, {anything, "a"}, {anything, "b"}};
  EXPECT_EQ(deal(cases, drivers), (Places{{0}, {1}, {0, 2}}));
}

TEST(Deal, WhatEveryDriverMustShowIsForThoseThatCan) {
  const std::vector<Case> cases = {case_of("a.a", "golden", Extent::every_driver)};
  const std::vector<DealtDriver> drivers = {{nothing, "a"}, {anything, "a"}};
  EXPECT_EQ(deal(cases, drivers), (Places{{}, {0}}));
}

TEST(Deal, WhatSharesAProgramStaysTogether) {
  const std::vector<Case> cases = {
      case_of("a.a", "golden", Extent::one_driver), case_of("a.a", "twin", Extent::one_driver),
      case_of("a.b", "golden", Extent::one_driver), case_of("a.b", "twin", Extent::one_driver)};
  const std::vector<DealtDriver> drivers = {{anything, "a"}, {anything, "b"}};
  EXPECT_EQ(deal(cases, drivers), (Places{{0, 1}, {2, 3}}));
}

TEST(Deal, ADriverHasAsManyTurnsAsPlanned) {
  std::vector<Case> cases;
  for (int i = 0; i < 8; ++i) cases.push_back(case_of("a." + std::to_string(i), "golden", Extent::one_driver));
  const std::vector<DealtDriver> drivers = {{anything, "a", 3}, {anything, "b", 1}};
  EXPECT_EQ(deal(cases, drivers), (Places{{0, 1, 2, 4, 5, 6}, {3, 7}}));
}

TEST(Deal, ACaseIsForADriverThatCanRunIt) {
  std::vector<Case> cases;
  for (int i = 0; i < 8; ++i) cases.push_back(case_of("a." + std::to_string(i), "golden", Extent::one_driver));
  const std::vector<DealtDriver> drivers = {{nothing, "a"}, {anything, "b"}};
  const auto dealt = deal(cases, drivers);
  EXPECT_TRUE(dealt[0].empty());
  EXPECT_EQ(dealt[1].size(), cases.size());
}

TEST(Deal, WithoutADriverThereIsNothingToDeal) {
  const std::vector<Case> cases = {case_of("a.a", "golden", Extent::one_driver)};
  EXPECT_TRUE(deal(cases, {}).empty());
}

TEST(Deal, WhatNoDriverCanRunIsNotLost) {
  const std::vector<Case> cases = {case_of("a.a", "golden", Extent::one_driver)};
  const std::vector<DealtDriver> drivers = {{nothing, "a"}, {nothing, "b"}};
  EXPECT_EQ(deal(cases, drivers), (Places{{0}, {}}));
}

}  // namespace
}  // namespace hn
