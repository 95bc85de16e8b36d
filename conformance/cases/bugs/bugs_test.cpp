#include "cases/bugs/bugs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "base/text.hpp"
#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

std::vector<std::uint32_t> right_words(const Bug& bug) {
  std::vector<std::uint32_t> words(bug.points.size() * kOutputWords, 0x12345678u);
  for (std::size_t i = 0; i < bug.points.size(); ++i) {
    std::copy(bug.points[i].expected.begin(), bug.points[i].expected.end(),
              words.begin() + static_cast<std::ptrdiff_t>(i * kOutputWords));
  }
  return words;
}

TEST(Bugs, EachHasWhatItsColumnsSay) {
  std::set<std::string_view> seen;
  for (const Bug& bug : all_bugs()) {
    EXPECT_TRUE(bug.function.id.starts_with("bugs.") && seen.insert(bug.function.id).second) << bug.function.id;
    EXPECT_FALSE(bug.reference.empty() || bug.rule.text.empty() || bug.points.empty()) << bug.function.id;
    EXPECT_GE(bug.rule.allowed, 0.0);
    for (const BugPoint& point : bug.points) {
      EXPECT_EQ(point.inputs.size(), bug.function.inputs.size()) << bug.function.id;
      EXPECT_EQ(point.expected.size(), bug.function.outputs.size()) << bug.function.id;
    }
  }
}

// Each bug with one of the profiles that have each of its rules.
std::vector<std::pair<const Bug*, const Profile*>> bugs_by_rule() {
  std::vector<std::pair<const Bug*, const Profile*>> found;
  for (const Bug& bug : all_bugs()) {
    found.emplace_back(&bug, &profile_named(split(bug.profiles, ' ').front()));
    if (!bug.exceptions.empty()) found.emplace_back(&bug, &profile_named(split(bug.exceptions, ' ').front()));
  }
  return found;
}

TEST(Bugs, RightWordsPass) {
  for (const auto& [one, profile] : bugs_by_rule()) {
    const Bug& bug = *one;
    const Outcome outcome = judge_bug(bug, *profile, right_words(bug));
    EXPECT_EQ(outcome.status, Status::pass) << bug.function.id;
    EXPECT_EQ(outcome.samples, bug.points.size() * bug.function.outputs.size());
  }
}

// Each single word, if it is wrong, is noticed; and a value that the specification leaves open never fails.
TEST(Bugs, AnyWrongWordFailsOrWarns) {
  for (const auto& [one, profile] : bugs_by_rule()) {
    const Bug& bug = *one;
    for (std::size_t i = 0; i < bug.points.size(); ++i) {
      for (std::size_t column = 0; column < bug.function.outputs.size(); ++column) {
        auto words = right_words(bug);
        std::uint32_t& word = words[i * kOutputWords + column];
        const bool is_float = bug.function.outputs[column].type == WordType::f32;
        // Beyond every allowed difference: the largest is 2^-6.
        const float value = std::bit_cast<float>(word);
        word = is_float ? hn::word(value + std::max(0.02f, std::fabs(value) * 0.01f)) : word ^ 1u;
        const Outcome outcome = judge_bug(bug, *profile, words);
        ASSERT_EQ(outcome.status, bug.rule_in(*profile).defined ? Status::fail : Status::warning) << bug.function.id;
        EXPECT_EQ(outcome.mismatches, 1u);
        EXPECT_EQ(outcome.examples.front().point, i);
      }
    }
  }
}

const Bug& bug_named(std::string_view id) {
  const auto bugs = all_bugs();
  return *std::find_if(bugs.begin(), bugs.end(), [&](const Bug& bug) { return bug.function.id == id; });
}

const Profile& kDesktop = profile_named("gl330");

TEST(Bugs, NothingButTheNumberIsANumber) {
  const Bug& bug = bug_named("bugs.sin_within_a_turn");
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    auto words = right_words(bug);
    words[0] = word(wrong);
    EXPECT_EQ(judge_bug(bug, kDesktop, words).status, Status::fail);
  }
  auto words = right_words(bug);
  words[0] = word(-0.0f);
  EXPECT_EQ(judge_bug(bug, kDesktop, words).status, Status::pass);
  words[0] = word(0x1p-11f);
  EXPECT_EQ(judge_bug(bug, kDesktop, words).status, Status::pass);
  words[0] = word(0x1.02p-11f);
  EXPECT_EQ(judge_bug(bug, kDesktop, words).status, Status::fail);
}

TEST(Bugs, TheMessageHasTheValueTheCodeTheReferenceAndTheSpecification) {
  const Bug& bug = bug_named("bugs.uint_of_int_shifted_by_31");
  auto words = right_words(bug);
  words[0] = 0xFFFFFFFFu;
  const std::string message = judge_bug(bug, kDesktop, words).message;
  for (const std::string_view part : {"x=-1", "got 4294967295 (ffffffff)", "expected 1 (00000001)", "return uvec4(",
                                      "KhronosGroup/WebGL 2989", "section 5.9"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
  }
}

TEST(Bugs, CasesRunInTheVersionsThatTheyName) {
  std::vector<Case> cases;
  add_bug_cases(cases);
  std::set<std::string> ids;
  for (const Case& test : cases) ids.insert(test.id);
  EXPECT_TRUE(ids.contains("bugs.uint_of_int_shifted_by_31.any.exact.fragment.gl330.defined"));
  EXPECT_TRUE(ids.contains("bugs.uint_of_int_shifted_by_31.any.exact.fragment.es300.defined"));
  EXPECT_TRUE(ids.contains("bugs.contracted_despite_precise.any.exact.fragment.es320.defined"));
  EXPECT_TRUE(ids.contains("bugs.sin_of_large.any.fast.fragment.gl330.undefined"));
  // vkd3d-compiler does not end on it: no default run may have it.
  const auto hangs = std::ranges::find(cases, "bugs.do_while.any.exact.compute.hlsl50.defined", &Case::id);
  EXPECT_TRUE(hangs != cases.end() && hangs->extent == Extent::thorough);
  // Where another language has another rule, so has the case.
  EXPECT_TRUE(ids.contains("bugs.modulo_of_negative.any.exact.compute.hlsl60.undefined"));
  EXPECT_TRUE(ids.contains("bugs.modulo_of_negative.any.exact.compute.msl.defined"));
  EXPECT_FALSE(ids.contains("bugs.contracted_despite_precise.any.exact.fragment.gl330.defined"));
}

}  // namespace
}  // namespace hn
