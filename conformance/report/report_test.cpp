#include "report/report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

TEST(Output, AFolderThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const auto inside_a_file = prepare_results(folder.path() / "file" / "out");
  ASSERT_FALSE(inside_a_file);
  EXPECT_NE(inside_a_file.error().message.find("file"), std::string::npos);
  std::filesystem::create_directories(folder.path() / "taken" / "results.json");
  EXPECT_FALSE(prepare_results(folder.path() / "taken"));
}

TEST(Output, ResultsOfAnEarlierRunAreGone) {
  const TemporaryFolder folder;
  for (const char* name : {"results.json", "junit.xml", "index.html"}) folder.write(name, "yesterday");
  folder.write("other.txt", "mine");
  ASSERT_TRUE(prepare_results(folder.path()));
  for (const char* name : {"results.json", "junit.xml", "index.html"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "other.txt"));
}

TEST(Output, ResultsAreWrittenWhole) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "a" / "b";
  ASSERT_TRUE(prepare_results(out));
  ASSERT_TRUE(write_results(out, {run_of({result("a", Status::pass)})}));
  std::ifstream in(out / "results.json");
  EXPECT_EQ(nlohmann::json::parse(in)["runs"].size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(out / "results.json.part"));
  EXPECT_TRUE(std::filesystem::exists(out / "junit.xml"));
  EXPECT_TRUE(std::filesystem::exists(out / "index.html"));
}

TEST(Summary, NamesWhatFailedAndWhatIsUnsupported) {
  const auto text = summary(run_of({result("a.b.golden", Status::pass), result("c.d.golden", Status::fail),
                                    result("e.f.golden", Status::unsupported)}));
  EXPECT_NE(text.find("FAIL    c.d.golden\n  why"), std::string::npos) << text;
  EXPECT_NE(text.find("Unsupported, 1 cases: why"), std::string::npos) << text;
  EXPECT_NE(text.find("1 pass, 1 fail, 1 unsupported"), std::string::npos) << text;
}

TEST(Summary, SaysWhatWasNotRun) {
  hn::Run run = run_of({result("a.b.golden", Status::pass)});
  run.not_run = 4;
  EXPECT_NE(summary(run).find("1 pass, 4 not run;"), std::string::npos) << summary(run);
  hn::Run not_begun;
  not_begun.driver = "zink";
  not_begun.not_run = 5;
  EXPECT_EQ(summary(not_begun), "zink: 5 cases, none of which was run\n");
}

}  // namespace
}  // namespace hn
