#include "cases/costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hn {
namespace {

constexpr std::string_view kTable =
    "check,function,cases,seconds\n"
    "calibration,,1,0.001000\n"
    "golden,noise2d.a,4,2.000\n"
    "golden,noise2d.b,2,0.400\n"
    "range,noise2d.a,1,0.010\n";

Costs table() { return Costs::parse(kTable).value(); }

std::string id_of(const std::string& function, const std::string& check, const std::string& profile = "gl330") {
  return function + ".lattice.fast.fragment." + profile + "." + check;
}

// As recorded: four, two and one.
std::vector<std::string> as_recorded() {
  std::vector<std::string> ids = {id_of("noise2d.a", "range")};
  for (const char* const profile : {"gl140", "gl330", "es300", "es310"}) {
    ids.push_back(id_of("noise2d.a", "golden", profile));
  }
  for (const char* const profile : {"gl330", "es300"}) ids.push_back(id_of("noise2d.b", "golden", profile));
  return ids;
}

TEST(Costs, TextIsReadAsItWasWritten) { EXPECT_EQ(table().text(), kTable); }

TEST(Costs, ATableThatCannotBeReadIsRefused) {
  for (const char* const text : {"", "check,function\n", "check,function,cases,seconds\ngolden,a,1,0.5\n",
                                 "check,function,cases,seconds\ncalibration,,1,0.001\ngolden,a,0,0.5\n",
                                 "check,function,cases,seconds\ncalibration,,1,0.001\ngolden,a,1\n"}) {
    EXPECT_FALSE(Costs::parse(text)) << text;
  }
}

TEST(Costs, ACaseCostsWhatThoseOfItsCheckAndFunctionDidElseTheMeanOfItsCheck) {
  EXPECT_DOUBLE_EQ(table().seconds_of(id_of("noise2d.a", "golden")), 0.5);
  EXPECT_DOUBLE_EQ(table().seconds_of(id_of("noise2d.new", "golden")), 0.4);
  EXPECT_GT(table().seconds_of(id_of("noise2d.a", "new")), 0.0);
  EXPECT_DOUBLE_EQ(table().seconds_of(as_recorded()), 2.41);
}

TEST(Costs, OfResultsTheProcessorTimeCounts) {
  CaseResult result{.id = id_of("noise2d.a", "golden"), .outcome = {}, .seconds = 9.0, .processor_seconds = 0.25};
  const Costs costs = Costs::of(std::vector{result, result}, 0.002);
  EXPECT_EQ(costs.text(), "check,function,cases,seconds\ncalibration,,1,0.002000\ngolden,noise2d.a,2,0.500\n");
}

TEST(Budget, WhatIsAsRecordedAndWithinTheBudgetIsGood) { EXPECT_EQ(complaint_about(table(), as_recorded(), 3.0), ""); }

TEST(Budget, BeyondTheBudgetFails) { EXPECT_NE(complaint_about(table(), as_recorded(), 2.0), ""); }

// A function that is added twice.
TEST(Budget, WhatHasGrownFailsAndIsNamed) {
  std::vector<std::string> ids = as_recorded();
  for (const std::string& id : as_recorded()) {
    if (id.starts_with("noise2d.a")) ids.push_back("noise2d.a_again" + id.substr(id.find('.', id.find('.') + 1)));
  }
  const std::string complaint = complaint_about(table(), ids, 100.0);
  EXPECT_NE(complaint.find("golden of noise2d.a_again: 4 cases in place of 0, +1.60 s"), std::string::npos)
      << complaint;
  EXPECT_NE(complaint.find("range of noise2d.a_again: 1 cases in place of 0"), std::string::npos) << complaint;
}

TEST(Budget, WhatIsGoneFailsSinceTheTableIsStale) {
  std::vector<std::string> ids = as_recorded();
  std::erase(ids, id_of("noise2d.a", "range"));
  EXPECT_NE(complaint_about(table(), ids, 100.0).find("range of noise2d.a: 0 cases in place of 1"), std::string::npos);
}

// tools/conform --record-costs writes the table.
TEST(Budget, TheDefaultRunKeepsIt) { EXPECT_EQ(complaint_about(Costs::recorded(), ids_of_default_run()), ""); }

}  // namespace
}  // namespace hn
