// The list of rules: its messages, and that docs/guide/cpu.md has the same.
#include "grid/rules.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "grid/functions.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {
namespace {

std::string page() {
  std::ifstream in(HN_CPU_PAGE);
  return {std::istreambuf_iterator<char>(in), {}};
}

// How the row of a rule begins in the table of the page.
std::string row_of(const Rule& rule, const std::string& of = "") {
  const std::string usual = std::isnan(rule.usual) ? "" : digits_of(rule.usual);
  return "\n| `" + std::string(rule.setting) + "`" + of + " | " + words_of(rule) + " |" + (usual.empty() ? "" : " ") +
         usual + " | ";
}

// The rules that the page lacks.
std::string missing_from(const std::string& text) {
  std::string missing;
  const auto look_for = [&](const std::string& row) {
    if (text.find(row) == std::string::npos) missing += row;
  };
  for (const Rule& rule : kRules) look_for(row_of(rule));
  for (const SumRow& sum : kSumRows) {
    if (!sum.strength.empty()) look_for(row_of(strength_rule(sum), " of `" + std::string(sum.name) + "`"));
  }
  return missing;
}

TEST(Rules, AreThoseOfThePage) { EXPECT_EQ(missing_from(page()), ""); }

TEST(Rules, ThatThePageHasOtherwiseAreNoticed) {
  std::string text = page();
  const std::string row = row_of(kOctavesRule);
  const std::size_t at = text.find(row);
  ASSERT_NE(at, std::string::npos);
  text.replace(text.find("32", at), 2, "64");
  EXPECT_EQ(missing_from(text), row);
}

TEST(Rules, SayWhatIsWrongAndWhatWouldBeRight) {
  EXPECT_EQ(problem_of(kOctavesRule, 1), "");
  EXPECT_EQ(problem_of(kOctavesRule, 32), "");
  EXPECT_EQ(problem_of(kOctavesRule, 0), "octaves is 0, and has to be from 1 to 32");
  EXPECT_EQ(problem_of(kJitterRule, static_cast<double>(0.1f)), "");
  EXPECT_EQ(problem_of(kJitterRule, static_cast<double>(-0.1f)), "jitter is -0.1, and has to be from 0 to 1");
  EXPECT_EQ(problem_of(kJitterRule, 1.0 + 0x1p-23), "jitter is 1.0000001, and has to be from 0 to 1");
  EXPECT_EQ(problem_of(kSeedRule, 4294967296.0), "seed is 4294967296, and has to be from 0 to 4294967295");
  EXPECT_EQ(problem_of(kGainRule, -1.5), "gain is -1.5, and has to be a finite number of 0 or more");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem_of(kLacunarityRule, -infinity), "lacunarity is -inf, and has to be a finite number");
  EXPECT_EQ(problem_of(kLacunarityRule, std::nan("")), "lacunarity is nan, and has to be a finite number");
  EXPECT_EQ(problem_of(kLacunarityRule, -3.0), "");
}

}  // namespace
}  // namespace hashnoise::grid
