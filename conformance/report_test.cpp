#include "report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "output/file.hpp"
#include "test_support.hpp"

namespace hn {
namespace {

CaseResult result(std::string id, Status status) {
  Outcome outcome;
  outcome.status = status;
  outcome.samples = 10;
  outcome.max_abs = 0.25;
  outcome.max_ulp = 3;
  outcome.message = "why";
  return {std::move(id), outcome, 0.5};
}

Run run_of(std::vector<CaseResult> cases) { return {"osmesa", {"v", "r", "4.5", "4.50", {}}, 7, std::move(cases)}; }

TEST(Run, IsAsExpectedOnlyIfSomethingPassedAndNothingFailed) {
  const auto pass = result("a", Status::pass);
  const auto unsupported = result("b", Status::unsupported);
  EXPECT_TRUE(run_of({pass, unsupported}).as_expected());
  EXPECT_FALSE(run_of({pass, result("c", Status::fail)}).as_expected());
  EXPECT_FALSE(run_of({pass, result("c", Status::error)}).as_expected());
  EXPECT_FALSE(run_of({unsupported}).as_expected());
  EXPECT_FALSE(run_of({}).as_expected());
}

TEST(Json, HasTheSchemaOfTheDocumentation) {
  const auto json =
      nlohmann::json::parse(to_json({run_of({result("a.b", Status::pass), result("c.d", Status::fail)})}));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["version"], library_version());
  const auto& run = json["runs"].at(0);
  EXPECT_EQ(run["driver"], "osmesa");
  EXPECT_EQ(run["vendor"], "v");
  EXPECT_EQ(run["renderer"], "r");
  EXPECT_EQ(run["gl_version"], "4.5");
  EXPECT_EQ(run["glsl_version"], "4.50");
  EXPECT_EQ(
      run["totals"],
      nlohmann::json(
          {{"pass", 1}, {"warning", 0}, {"fail", 1}, {"unsupported", 0}, {"crash", 0}, {"timeout", 0}, {"error", 0}}));
  EXPECT_EQ(run["cases"].at(0), nlohmann::json({{"id", "a.b"},
                                                {"status", "pass"},
                                                {"samples", 10},
                                                {"mismatches", 0},
                                                {"max_abs", 0.25},
                                                {"max_ulp", 3},
                                                {"seconds", 0.5},
                                                {"message", "why"}}));
}

TEST(Json, TakesALogThatIsNoUtf8) {
  auto bad = result("a", Status::fail);
  bad.outcome.message = "\xff\xfe";
  EXPECT_TRUE(nlohmann::json::accept(to_json({run_of({bad})})));
}

TEST(Output, AFolderThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const auto inside_a_file = prepare_output(folder.path() / "file" / "out", {kResultsFile});
  ASSERT_FALSE(inside_a_file);
  EXPECT_NE(inside_a_file.error().message.find("file"), std::string::npos);
  std::filesystem::create_directories(folder.path() / "taken" / "results.json");
  EXPECT_FALSE(prepare_output(folder.path() / "taken", {kResultsFile}));
}

TEST(Output, ResultsOfAnEarlierRunAreGone) {
  const TemporaryFolder folder;
  folder.write("results.json", "yesterday");
  folder.write("other.txt", "mine");
  ASSERT_TRUE(prepare_output(folder.path(), {kResultsFile}));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results.json"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "other.txt"));
}

TEST(Output, ResultsAreWrittenWhole) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "a" / "b";
  ASSERT_TRUE(prepare_output(out, {kResultsFile}));
  ASSERT_TRUE(write_results(out, {run_of({result("a", Status::pass)})}));
  std::ifstream in(out / "results.json");
  EXPECT_EQ(nlohmann::json::parse(in)["runs"].size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(out / "results.json.part"));
}

TEST(Summary, NamesWhatFailedAndWhatIsUnsupported) {
  const auto text = summary(run_of({result("a.b.golden", Status::pass), result("c.d.golden", Status::fail),
                                    result("e.f.golden", Status::unsupported)}));
  EXPECT_NE(text.find("FAIL  c.d.golden\n  why"), std::string::npos) << text;
  EXPECT_NE(text.find("Unsupported, 1 cases: why"), std::string::npos) << text;
  EXPECT_NE(text.find("1 passed, 1 failed, 1 unsupported, 0 errors"), std::string::npos) << text;
}

}  // namespace
}  // namespace hn
