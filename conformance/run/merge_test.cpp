#include "run/merge.hpp"

#include <gtest/gtest.h>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "run/result_support.hpp"
#include "run/selection.hpp"

namespace hn {
namespace {

const std::vector<std::string>& some_ids() {
  static const std::vector<std::string> kIds = {"k", "j", "i", "h", "g", "f", "e", "d", "c", "b"};
  return kIds;
}

Result<MergeResult> merge(std::vector<hn::Run> runs) { return merge_runs(std::move(runs), some_ids()); }

// The cases of a shard of these ten.
Run shard_run(const std::string& text) {
  const auto shard = parse_shard(text);
  const auto& ids = some_ids();
  std::vector<CaseResult> cases;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (shard->has(i)) cases.push_back(result(ids[i], Status::pass));
  }
  hn::Run run = run_of(std::move(cases));
  run.shard = text;
  run.whole = 10;
  return run;
}

TEST(Merge, KeepsEveryCommandInWhateverOrder) {
  hn::Run first = shard_run("1/2");
  hn::Run second = shard_run("2/2");
  first.date = "2026-11-20T10:00:00Z";
  second.date = "2026-11-20T09:00:00Z";
  first.commands = {"run 1/2"};
  second.commands = {"run 2/2"};
  const auto merged = merge({first, second});
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->runs[0].date, "2026-11-20T10:00:00Z");
  EXPECT_EQ(merged->runs[0].commands, (std::set<std::string>{"run 1/2", "run 2/2"}));
  EXPECT_EQ(results_text(merge({second, first})->runs), results_text(merged->runs));
}

TEST(Merge, TheUnionOfTheShardsIsTheWhole) {
  const auto merged = merge({shard_run("3/3"), shard_run("1/3"), shard_run("2/3")});
  ASSERT_TRUE(merged) << merged.error().text();
  EXPECT_TRUE(merged->gaps.empty());
  ASSERT_EQ(merged->runs.size(), 1u);
  EXPECT_EQ(merged->runs[0].shard, "");
  std::vector<std::string> ids;
  for (const CaseResult& c : merged->runs[0].cases) ids.push_back(c.id);
  EXPECT_EQ(ids, some_ids());
}

TEST(Merge, OnlyShardsOfTheDefaultCasesAreThoseOfARunOfThem) {
  hn::Run first = shard_run("1/2");
  hn::Run second = shard_run("2/2");
  first.golden = second.golden = "89abcdef";
  EXPECT_EQ(merge({first, second})->runs[0].golden, "89abcdef");
  second.golden.clear();
  EXPECT_EQ(merge({first, second})->runs[0].golden, "");
  EXPECT_EQ(merge({second, first})->runs[0].golden, "");
}

TEST(Merge, WhatARunDidNotComeToIsAGap) {
  hn::Run whole = run_of({result("b", Status::pass), result("c", Status::pass)});
  whole.not_run = 8;
  hn::Run shard = shard_run("1/2");
  shard.cases.pop_back();
  shard.not_run = 1;
  for (const std::vector<hn::Run>& runs : {std::vector{whole}, std::vector{shard, shard_run("2/2")}}) {
    const auto merged = merge(runs);
    ASSERT_TRUE(merged) << merged.error().text();
    ASSERT_EQ(merged->gaps.size(), 1u);
    EXPECT_NE(merged->gaps[0].find(runs.size() == 1 ? "8 cases were not run" : "1 cases were not run"),
              std::string::npos)
        << merged->gaps[0];
    EXPECT_FALSE(all_as_expected(merged->runs));
    EXPECT_EQ(merged->runs[0].shard, "");
  }
  EXPECT_EQ(merge({shard})->gaps.size(), 2u) << "that, and the shard that is not here";
}

TEST(Merge, AMissingShardIsAGap) {
  const auto merged = merge({shard_run("3/3"), shard_run("1/3")});
  ASSERT_TRUE(merged);
  ASSERT_EQ(merged->gaps.size(), 1u);
  EXPECT_NE(merged->gaps[0].find("3 of 10 cases are missing"), std::string::npos) << merged->gaps[0];
  const auto read = parse_results(results_text(merged->runs));
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->at(0).missing, 3u);
  const auto whole = merge({read->at(0), shard_run("2/3")});
  ASSERT_TRUE(whole) << whole.error().text();
  EXPECT_EQ(whole->gaps.size(), 0u);
  EXPECT_TRUE(all_as_expected(whole->runs));
}

TEST(Merge, WhatDoesNotBelongTogetherIsAnError) {
  EXPECT_FALSE(merge({shard_run("1/3"), shard_run("1/3")})) << "the same twice";
  EXPECT_FALSE(merge({shard_run("1/3"), shard_run("2/2")})) << "of other splits";
  hn::Run other_seed = shard_run("2/3");
  other_seed.seed = 8;
  EXPECT_FALSE(merge({shard_run("1/3"), other_seed}));
  EXPECT_FALSE(merge({run_of({result("no.such.case", Status::pass)})}));
  hn::Run bad_shard = shard_run("1/3");
  bad_shard.shard = "x";
  EXPECT_FALSE(merge({bad_shard, shard_run("2/3")}));
  EXPECT_FALSE(merge({bad_shard})) << "also if there is nothing to merge it with";
  hn::Run too_many = shard_run("1/3");
  too_many.whole = 3;
  EXPECT_FALSE(merge({too_many}));
}

TEST(Merge, OtherDriversAndRenderersStayApart) {
  hn::Run elsewhere = shard_run("2/3");
  elsewhere.info.renderer = "another";
  hn::Run egl = shard_run("2/3");
  egl.driver = "egl";
  hn::Run absent;
  absent.driver = "zink";
  absent.absent = "why";
  hn::Run absent_here = absent;
  absent_here.driver = "egl";
  hn::Run through = shard_run("2/3");
  through.way = short_way();
  hn::Run through_another = shard_run("2/3");
  through_another.way = short_way("2025.5");
  const auto merged = merge({shard_run("1/3"), elsewhere, egl, through, through_another, absent, absent, absent_here});
  ASSERT_TRUE(merged) << merged.error().text();
  ASSERT_EQ(merged->runs.size(), 6u);
  EXPECT_EQ(merged->runs[5].absent, "why");
  EXPECT_EQ(merged->runs[5].driver, "zink");
}

TEST(Merge, ReadsFilesAndFolders) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "one" / kResultsFile, results_text({shard_run("1/2")})));
  ASSERT_TRUE(write_file(folder.path() / "two" / kResultsFile, results_text({shard_run("2/2")})));
  const auto merged =
      merge_files({(folder.path() / "one").string(), (folder.path() / "two" / kResultsFile).string()}, some_ids());
  ASSERT_TRUE(merged) << merged.error().text();
  EXPECT_EQ(merged->runs.at(0).cases.size(), 10u);
  EXPECT_FALSE(merge_files({(folder.path() / "three").string()}, some_ids()));
  folder.write("broken.json", "{\"schema\": 2");
  const auto broken = merge_files({(folder.path() / "broken.json").string()}, some_ids());
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().message.find("broken.json"), std::string::npos);
}

}  // namespace
}  // namespace hn
