#include "cases/deal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <set>
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
  const std::vector<CanRun> drivers = {anything, anything};
  EXPECT_EQ(deal(cases, drivers), (Places{{0, 2}, {0, 1}}));
}

TEST(Deal, WhatSharesAProgramStaysTogether) {
  const std::vector<Case> cases = {
      case_of("a.a", "golden", Extent::one_driver), case_of("a.a", "twin", Extent::one_driver),
      case_of("a.b", "golden", Extent::one_driver), case_of("a.b", "twin", Extent::one_driver)};
  const std::vector<CanRun> drivers = {anything, anything};
  EXPECT_EQ(deal(cases, drivers), (Places{{0, 1}, {2, 3}}));
}

TEST(Deal, ACaseIsForADriverThatCanRunIt) {
  std::vector<Case> cases;
  for (int i = 0; i < 8; ++i) cases.push_back(case_of("a." + std::to_string(i), "golden", Extent::one_driver));
  const std::vector<CanRun> drivers = {nothing, anything};
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
  const std::vector<CanRun> drivers = {nothing, nothing};
  EXPECT_EQ(deal(cases, drivers), (Places{{0}, {}}));
}

std::string target_of(const CaseName& name) { return std::string(name_of(name.stage)) + " " + name.profile; }
std::string setting_of(const CaseName& name) { return name.configuration + " " + name.arithmetic; }

// The function; but of further ones the family, whose functions take turns.
std::string turn_of(const CaseName& name) {
  for (const Function& function : all_functions()) {
    if (function.id == name.function && function.is_further()) {
      return fmt::format("family {}", static_cast<unsigned>(function.family));
    }
  }
  return name.function;
}

using Pairs = std::vector<std::string> (*)(const CaseName& name);

// What is met by the cases that are not thorough alone, of those that there are.
void expect_all_met(std::initializer_list<std::string_view> checks, Pairs pairs_of) {
  std::set<std::string> met;
  std::set<std::string> all;
  for (const Case& test : all_cases()) {
    if (std::find(checks.begin(), checks.end(), test.name.check) == checks.end()) continue;
    for (const std::string& pair : pairs_of(test.name)) {
      all.insert(pair);
      if (test.extent != Extent::thorough) met.insert(pair);
    }
  }
  EXPECT_FALSE(all.empty());
  for (const std::string& pair : all) EXPECT_TRUE(met.contains(pair)) << pair;
}

TEST(Extent, GoldenValuesMeetEveryPair) {
  expect_all_met({"golden"}, [](const CaseName& name) -> std::vector<std::string> {
    return {name.function + " " + setting_of(name), turn_of(name) + " " + target_of(name),
            setting_of(name) + " " + target_of(name)};
  });
}

TEST(Extent, CompilationsMeetEveryPair) {
  const Pairs pairs = [](const CaseName& name) -> std::vector<std::string> {
    return {name.function + " " + setting_of(name), name.function + " " + target_of(name),
            setting_of(name) + " " + target_of(name)};
  };
  expect_all_met({"glslang", "spirv"}, pairs);
  expect_all_met({"driver"}, pairs);
}

TEST(Extent, VariantsMeetEveryFunctionAndEveryVersion) {
  expect_all_met({"inlined", "in_loop", "constant_seed", "uniform_seed", "folded"},
                 [](const CaseName& name) -> std::vector<std::string> {
                   return {name.check + " " + turn_of(name), name.check + " " + name.arithmetic + " " + name.profile};
                 });
}

TEST(Extent, EveryStageHasCases) {
  for (const Stage stage : {Stage::fragment, Stage::vertex, Stage::compute}) {
    for (const std::string_view check : {"golden", "glslang"}) {
      const auto cases = all_cases();
      EXPECT_TRUE(std::any_of(cases.begin(), cases.end(),
                              [&](const Case& test) { return test.name.stage == stage && test.name.check == check; }))
          << name_of(stage) << " " << check;
    }
  }
}

}  // namespace
}  // namespace hn
