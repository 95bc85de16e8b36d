#include "run/journal.hpp"

#include <gtest/gtest.h>

#include "run/result_support.hpp"

namespace hn {
namespace {

const nlohmann::json kPlan = {{"version", "1"}, {"drivers", {{"egl", {"a", "b"}}}}};

std::string text_with(const std::string& lines) { return nlohmann::json{{"plan", kPlan}}.dump() + "\n" + lines; }

std::string error_of(const std::string& text) {
  const auto entries = parse_journal(text, kPlan);
  return entries ? "none" : entries.error().message;
}

TEST(Journal, GivesTheReportsInTheirOrder) {
  const nlohmann::json first = {{"result", to_json(result("a", Status::pass))}};
  const nlohmann::json second = {{"absent", "why"}};
  const auto entries = parse_journal(
      text_with(journal_line("egl", first) + "\n" + journal_line("zink", second) + "\n{\"driver\": \"e"), kPlan);
  ASSERT_TRUE(entries) << entries.error().text();
  ASSERT_EQ(entries->size(), 2u) << "without the line that was broken off";
  EXPECT_EQ(entries->at(0).driver, "egl");
  EXPECT_EQ(entries->at(0).report, first);
  EXPECT_EQ(entries->at(1).report, second);
  EXPECT_TRUE(parse_journal("", kPlan));
}

TEST(Journal, OfAnotherRunSaysWhatIsOther) {
  EXPECT_EQ(error_of("{\"plan\": {\"version\": \"1\", \"drivers\": 7}}\n"),
            "it belongs to a run with other settings: \"drivers\"");
  nlohmann::json more = kPlan;
  more["more"] = 1;
  EXPECT_EQ(error_of(nlohmann::json{{"plan", more}}.dump() + "\n"),
            "it belongs to a run with other settings: \"more\"");
  for (const char* line : {"\n", "x\n", "{}\n", "[]\n", "7\n", "{\"plan\": null}\n", "{\"plan\": [1]}\n"}) {
    EXPECT_EQ(error_of(line), "its first line is not a plan") << line;
  }
}

// These would be exceptions later, when the scheduler takes them.
TEST(Journal, WithAWrongReportNamesTheLine) {
  const std::string good = journal_line("egl", {{"lost", true}}) + "\n";
  for (const char* report : {"{\"result\": {\"id\": 7}}", "{\"result\": null}", "{\"ready\": {}}", "{\"absent\": 7}",
                             "{\"error\": null}", "[]", "null"}) {
    const std::string line = "{\"driver\": \"egl\", \"report\": " + std::string(report) + "}\n";
    EXPECT_TRUE(error_of(text_with(good + line)).starts_with("line 3 is not a report of a driver: ")) << line;
  }
  for (const char* line : {"\n", "x\n", "[]\n", "{\"driver\": 7, \"report\": {}}\n", "{\"driver\": \"egl\"}\n"}) {
    EXPECT_TRUE(error_of(text_with(line)).starts_with("line 2 is not a report of a driver: ")) << line;
  }
}

TEST(Journal, MayNotBeNestedWithoutEnd) {
  const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
  EXPECT_EQ(error_of("{\"plan\": " + deep + "}\n"), "its first line is not a plan");
  EXPECT_TRUE(error_of(text_with("{\"driver\": \"egl\", \"report\": {\"unknown\": " + deep + "}}\n"))
                  .starts_with("line 2 is not a report of a driver: it is nested"));
}

}  // namespace
}  // namespace hn
