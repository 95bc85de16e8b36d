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

TEST(Deal, GoesByWhatACaseIsForAndWhatADriverCan) {
  const Case each = case_of("a.a", "golden", Extent::every_driver);
  const Case second = case_of("a.b", "golden", Extent::one_driver);
  const Case third = case_of("a.c", "golden", Extent::one_driver);
  const Case twin = case_of("a.b", "twin", Extent::one_driver);
  std::vector<Case> eight;
  for (int i = 0; i < 8; ++i) eight.push_back(case_of("a." + std::to_string(i), "golden", Extent::one_driver));
  const struct {
    std::string_view what;
    std::vector<Case> cases;
    std::vector<DealtDriver> drivers;
    Places places;
  } rows[] = {
      {"what every driver must show is for each, and the rest for one",
       {each, second, third},
       {{anything, "a"}, {anything, "b"}},
       {{0, 2}, {0, 1}}},
      {"of one renderer the first driver shows what each must, and the others have their share",
       {each, second, third},
       {{anything, "a"}, {anything, "a"}, {anything, "b"}},
       {{0}, {1}, {0, 2}}},
      {"what every driver must show is for those that can", {each}, {{nothing, "a"}, {anything, "a"}}, {{}, {0}}},
      {"what shares a program stays together",
       {second, twin, third},
       {{anything, "a"}, {anything, "b"}},
       {{0, 1}, {2}}},
      {"a driver has as many turns as planned",
       eight,
       {{anything, "a", 3}, {anything, "b", 1}},
       {{0, 1, 2, 4, 5, 6}, {3, 7}}},
      {"a case is for a driver that can run it",
       eight,
       {{nothing, "a"}, {anything, "b"}},
       {{}, {0, 1, 2, 3, 4, 5, 6, 7}}},
      {"without a driver there is nothing to deal", {second}, {}, {}},
      {"what no driver can run is not lost", {second}, {{nothing, "a"}, {nothing, "b"}}, {{0}, {}}},
  };
  for (const auto& row : rows) EXPECT_EQ(deal(row.cases, row.drivers), row.places) << row.what;
}

}  // namespace
}  // namespace hn
