#include "run/scheduler.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/resource.h>

#include <fstream>
#include <thread>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kReady =
    R"({"ready": {"vendor": "v", "renderer": "r", "gl_version": "1", "glsl_version": "2"}})";

// A line of a script that reports so.
std::string report_line(std::string_view report) { return "echo '" + std::string(report) + "' >&3\n"; }

// The beginning of every script: `report_result ID STATUS MEMBERS` reports so, where MEMBERS follow the result.
constexpr std::string_view kScript = R"(#!/bin/sh
report_result() {
  echo '{"result": {"id": "'$1'", "status": "'$2'", "samples": 1, "mismatches": 0, "max_abs": 0, "max_ulp": 0,' \
       '"seconds": 0, "message": ""}'$3'}' >&3
}
)";

// Passes every case of the job that is left, but does something else at one of them; $2 is the job.
std::string script_that(std::string_view at, std::string_view does) {
  return report_line(kReady) + fmt::format(R"(for id in a b c d e; do
  grep -o '"ids":[^]]*' "$2" | grep -q "\"$id\"" || continue
  if [ $id = {} ]; then {}; fi
  report_result $id pass
done
)",
                                           at, does);
}

// Does something at each case of the job with a name of this pattern, and passes it.
std::string script_of(std::string_view pattern, std::string_view does) {
  return report_line(kReady) +
         fmt::format("for id in $(grep -o '{}' \"$2\"); do\n  {}\n  report_result $id pass\ndone\n", pattern, does);
}

class SchedulerTest : public testing::Test {
 protected:
  // Runs the plan with the script in place of the driver's process.
  PlanResult run_with(const std::string& script, Journal& journal) {
    plan_.program = folder_.path() / "child";
    folder_.write("child", std::string(kScript) + script);
    std::filesystem::permissions(plan_.program, std::filesystem::perms::owner_all);
    return run_plan(plan_, folder_.path(), journal, stderr);
  }

  PlanResult run_all(const std::string& script) {
    auto journal = Journal::create(folder_.path(), to_json(plan_));
    EXPECT_TRUE(journal);
    return run_with(script, *journal);
  }

  hn::Run run(const std::string& script) { return run_all(script).runs.front(); }

  // Goes on with a journal that has so many reports.
  hn::Run resume(const std::string& script, std::size_t earlier) {
    auto journal = Journal::reopen(folder_.path(), to_json(plan_));
    if (!journal) {
      ADD_FAILURE() << journal.error().text();
      return {};
    }
    EXPECT_EQ(journal->earlier().size(), earlier);
    return run_with(script, *journal).runs.front();
  }

  std::string text_of(std::string_view file) const {
    std::ifstream in(folder_.path() / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void plan_cases(std::string_view format, int count) {
    plan_.drivers[0].ids.clear();
    for (int i = 0; i < count; ++i) plan_.drivers[0].ids.push_back(fmt::format(fmt::runtime(format), i));
  }

  // "a pass, b crash, ..."
  static std::string verdicts(const hn::Run& run) {
    std::string text;
    for (const CaseResult& result : run.cases) {
      text += (text.empty() ? "" : ", ") + result.id + " " + std::string(name_of(result.outcome.status));
    }
    return text;
  }

  TemporaryFolder folder_;
  RunPlan plan_{.drivers = {{"any", {"a", "b", "c", "d", "e"}, 5}}, .suite = {}, .shard = {}, .limit = 10s};
};

TEST_F(SchedulerTest, ADriverThatBehavesHasItsVerdicts) {
  const hn::Run result = run(script_that("none", ":"));
  EXPECT_EQ(verdicts(result), "a pass, b pass, c pass, d pass, e pass");
  EXPECT_EQ(result.info.renderer, "r");
  EXPECT_EQ(result.absent, "");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "any.log")) << "nothing was printed";
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "any.job"));
}

TEST_F(SchedulerTest, ACrashCostsItsCaseAndTheRunGoesOn) {
  const hn::Run result = run(script_that("c", "echo the end; kill -SEGV $$"));
  EXPECT_EQ(verdicts(result), "a pass, b pass, c crash, d pass, e pass");
  EXPECT_EQ(result.cases[2].outcome.message,
            "the driver's process ended by signal 11 (Segmentation fault); it printed:\nthe end\n");
}

TEST_F(SchedulerTest, AnEndWithoutAWordIsACrash) {
  const hn::Run result = run(script_that("b", "exit 7"));
  EXPECT_EQ(verdicts(result), "a pass, b crash, c pass, d pass, e pass");
  EXPECT_NE(result.cases[1].outcome.message.find("ended with status 7"), std::string::npos);
}

TEST_F(SchedulerTest, AHangAndAStopAreTimeouts) {
  plan_.limit = 500ms;
  EXPECT_EQ(verdicts(run(script_that("b", "exec sleep 60"))), "a pass, b timeout, c pass, d pass, e pass");
  const hn::Run stopped = run(script_that("e", "kill -STOP $$"));
  EXPECT_EQ(verdicts(stopped), "a pass, b pass, c pass, d pass, e timeout");
  EXPECT_EQ(stopped.cases[4].outcome.message, "the driver's process was killed, because it gave no answer for 0.5 s");
}

TEST_F(SchedulerTest, TheLimitIsForACaseAndNotForTheRun) {
  plan_.limit = 3s;
  EXPECT_EQ(verdicts(run(script_that("$id", "sleep 0.8"))), "a pass, b pass, c pass, d pass, e pass");
}

TEST_F(SchedulerTest, ACaseThatSaysThatItIsAliveMayTakeLonger) {
  plan_.limit = 1s;
  const std::string alive = "for i in 1 2 3 4; do sleep 0.5; echo '{\"alive\": true}' >&3; done";
  EXPECT_EQ(verdicts(run(script_that("b", alive))), "a pass, b pass, c pass, d pass, e pass");
  const std::string then_hangs = "echo '{\"alive\": true}' >&3; exec sleep 60";
  EXPECT_EQ(verdicts(run(script_that("b", then_hangs))), "a pass, b timeout, c pass, d pass, e pass");
}

TEST_F(SchedulerTest, AfterALostContextAnotherProcessGoesOn) {
  EXPECT_EQ(verdicts(run(script_that("b", "report_result b crash; echo '{\"lost\": true}' >&3; exit 0"))),
            "a pass, b crash, c pass, d pass, e pass");
}

// The lines after a failed case; $id is the case.
const std::string kFailsAndIsExamined = R"(report_result $id fail ', "examined": true'; )";
const std::string kEvidence =
    R"(echo '{"evidence": {"shader": "s", "got": "", "reference": "", "difference": "", "factor": 2, "note": "n"}, )"
    R"("id": "b"}' >&3; continue)";

TEST_F(SchedulerTest, EvidenceBelongsToItsCase) {
  const hn::Run result = run(script_that("b", kFailsAndIsExamined + kEvidence));
  EXPECT_EQ(verdicts(result), "a pass, b fail, c pass, d pass, e pass");
  ASSERT_TRUE(result.cases[1].evidence);
  EXPECT_EQ(result.cases[1].evidence->shader, "s");
  EXPECT_EQ(result.cases[1].evidence->factor, 2.0);
  EXPECT_FALSE(result.cases[2].evidence);

  const std::string none = "echo '{\"evidence\": null, \"id\": \"b\"}' >&3; continue";
  EXPECT_FALSE(run(script_that("b", kFailsAndIsExamined + none)).cases[1].evidence);
}

TEST_F(SchedulerTest, ADriverThatCrashesOverTheEvidenceCostsNoVerdict) {
  for (const char* end : {"kill -SEGV $$", "exec sleep 60"}) {
    plan_.limit = 2s;
    const hn::Run result = run("cp \"$2\" \"$0.job\"\n" + script_that("b", kFailsAndIsExamined + end));
    EXPECT_EQ(verdicts(result), "a pass, b fail, c pass, d pass, e pass");
    const auto json = nlohmann::json::parse(text_of("child.job"));  // of the process that went on
    EXPECT_EQ(json.at("ids"), nlohmann::json({"c", "d", "e"}));
    EXPECT_EQ(json.at("examined"), nlohmann::json({"b"})) << "so that they do not have it again and again";
  }
}

TEST_F(SchedulerTest, FailFastWaitsForTheEvidence) {
  plan_.fail_fast = true;
  const hn::Run result = run(script_that("b", kFailsAndIsExamined + "sleep 0.3; " + kEvidence));
  EXPECT_EQ(verdicts(result), "a pass, b fail");
  EXPECT_TRUE(result.cases[1].evidence);
}

TEST_F(SchedulerTest, ADriverThatIsNotHereHasNoCases) {
  const hn::Run result = run(report_line(R"({"absent": "no such library"})"));
  EXPECT_EQ(verdicts(result), "");
  EXPECT_EQ(result.absent, "no such library");
}

TEST_F(SchedulerTest, ADriverThatDoesNotStartFailsEveryCase) {
  EXPECT_EQ(verdicts(run("kill -ABRT $$\n")), "a crash, b crash, c crash, d crash, e crash");
  // Once could be chance, and costs a case.
  const std::string once = "[ -e $0.once ] || { touch $0.once; kill -KILL $$; }\n";
  EXPECT_EQ(verdicts(run(once + script_that("none", ":"))), "a crash, b pass, c pass, d pass, e pass");
  plan_.limit = 200ms;
  EXPECT_EQ(verdicts(run("exec sleep 60\n")), "a timeout, b timeout, c timeout, d timeout, e timeout");
}

TEST_F(SchedulerTest, AFunctionThatCrashesAlwaysIsGivenUpAndSoIsADriver) {
  plan_.drivers[0].ids.clear();
  for (const char* function : {"f.a", "f.b", "f.c", "f.d"}) {
    for (int i = 10; i < 25; ++i) plan_.drivers[0].ids.push_back(fmt::format("{}.{}", function, i));
  }
  // Ten cases of each of three functions are tried.
  const hn::Run all = run("echo x >>\"$0.starts\"\n" + report_line(kReady) + "exit 1\n");
  EXPECT_EQ(all.count(Status::crash), 60u);
  EXPECT_EQ(text_of("child.starts").size(), 2 * 30u);
  EXPECT_NE(all.cases[59].outcome.message.find("not run, after 10 cases in a row"), std::string::npos);
  // One function alone does not take the others along.
  const hn::Run one = run(script_of("f[.][a-d][.][0-9]*", "case $id in f.b.*) exit 1;; esac"));
  EXPECT_EQ(one.count(Status::crash), 15u);
  EXPECT_EQ(one.count(Status::pass), 45u);
}

TEST_F(SchedulerTest, AnExcusedFailureDoesNotEndAFastRun) {
  plan_.fail_fast = true;
  plan_.expectations = {{"any", "*", "b", Status::crash, "known", "x.csv:2"}};
  EXPECT_EQ(verdicts(run(script_that("b", "exit 1"))), "a pass, b crash, c pass, d pass, e pass");
}

TEST_F(SchedulerTest, ACrashAfterTheLastCaseIsAProblem) {
  for (const auto& [end, problems] : {std::pair{"exit 0\n", 0u}, std::pair{"kill -SEGV $$\n", 1u}}) {
    const PlanResult result = run_all(script_that("none", ":") + end);
    EXPECT_EQ(result.runs[0].count(Status::pass), 5u);
    EXPECT_EQ(result.problems.size(), problems);
  }
}

TEST_F(SchedulerTest, ADriverThatIsGoneAfterACrashMayComeBack) {
  const std::string gone_once = "[ -e $0.crashed ] && [ ! -e $0.back ] && { touch $0.back; " +
                                report_line(R"({"absent": "no display"})") + "exit 0; }\n";
  const hn::Run result = run(gone_once + script_that("b", "touch $0.crashed; exit 1"));
  EXPECT_EQ(verdicts(result), "a pass, b crash, c crash, d pass, e pass");
  EXPECT_NE(result.cases[2].outcome.message.find("no display"), std::string::npos) << result.cases[2].outcome.message;
}

TEST_F(SchedulerTest, WhatIsNoReportIsPassedOver) {
  EXPECT_EQ(verdicts(run("echo '][' >&3; echo 17 >&3\n" + script_that("none", ":"))),
            "a pass, b pass, c pass, d pass, e pass");
}

TEST_F(SchedulerTest, FailFastEndsWithTheFirstBadCase) {
  plan_.fail_fast = true;
  const hn::Run result = run(script_that("b", "exit 1") + "exec sleep 60\n");
  EXPECT_EQ(verdicts(result), "a pass, b crash");
}

TEST_F(SchedulerTest, WhatStopsTheRunCostsNoVerdict) {
  const FileDescriptor stop(eventfd(0, EFD_CLOEXEC));
  plan_.stop_fd = stop.get();
  std::thread later([&] {
    while (!std::filesystem::exists(folder_.path() / "child.c")) std::this_thread::sleep_for(1ms);
    eventfd_write(stop.get(), 1);
  });
  const hn::Run result = run(script_that("c", "touch \"$0.c\"; exec sleep 60"));
  later.join();
  EXPECT_EQ(verdicts(result), "a pass, b pass");
  EXPECT_EQ(result.not_run, 3u);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "any.job"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "any.log"));
  // And the next goes on.
  plan_.stop_fd = -1;
  const hn::Run whole = resume(script_that("none", ":"), 3u);  // ready, a, b
  EXPECT_EQ(verdicts(whole), "a pass, b pass, c pass, d pass, e pass");
  EXPECT_EQ(whole.not_run, 0u);
}

TEST_F(SchedulerTest, ARunThatWasStoppedBeforeItBeganHasNoVerdicts) {
  const FileDescriptor stop(eventfd(1, EFD_CLOEXEC));
  plan_.stop_fd = stop.get();
  const hn::Run result = run("exec sleep 60\n");
  EXPECT_EQ(verdicts(result), "");
  EXPECT_EQ(result.not_run, 5u);
}

// As on a full disk.
TEST_F(SchedulerTest, AJournalThatCannotBeWrittenEndsTheRun) {
  signal(SIGXFSZ, SIG_IGN);
  auto journal = Journal::create(folder_.path(), to_json(plan_));
  ASSERT_TRUE(journal);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{std::filesystem::file_size(folder_.path() / kJournalFile) + 500, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  run_with(script_that("none", ":") + "exec sleep 60\n", *journal);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(journal->problem(), "cannot write " + (folder_.path() / kJournalFile).string() + ": File too large");
  RunPlan other = plan_;
  other.ways.emplace("egl", Way{});
  EXPECT_FALSE(Journal::reopen(folder_.path(), to_json(other))) << "of another way";
  const auto again = Journal::reopen(folder_.path(), to_json(plan_));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_GE(again->earlier().size(), 2u);
}

TEST_F(SchedulerTest, DriversRunSideBySide) {
  plan_.drivers.push_back({"other", {"d", "e"}, 2});
  plan_.jobs = 2;
  const auto runs = run_all(script_that("none", ":")).runs;
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].driver, "other");
  EXPECT_EQ(verdicts(runs[1]), "d pass, e pass");
}

// Parts of 60 cases at the least: 16 of them.
TEST_F(SchedulerTest, TheCasesOfADriverAreSplitWhereProcessesAreLeft) {
  plan_cases("case{:03}", 1000);
  plan_.drivers[0].whole = 1000;
  plan_.jobs = 3;
  // Each passes what its job has, and the last of them crashes in its last case.
  const hn::Run result = run("echo x >>\"$0.starts\"\n" + script_of("case[0-9]*", "[ $id = case999 ] && exit 1"));
  EXPECT_EQ(text_of("child.starts").size(), 2 * 16u);
  ASSERT_EQ(result.cases.size(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(result.cases[i].id, plan_.drivers[0].ids[i]);
  EXPECT_EQ(result.count(Status::pass), 999u);
  EXPECT_EQ(result.cases[999].outcome.status, Status::crash);
}

// Here a part is a sixth of all: 67 cases.
TEST_F(SchedulerTest, ADriverThatTakesOneProcessOnlyIsNotAbsent) {
  plan_cases("case{:03}", 400);
  plan_.jobs = 2;
  const hn::Run result = run("grep -q case000 \"$2\" || { " + report_line(R"({"absent": "one is enough"})") +
                             "exit 0; }\n" + script_of("case[0-9]*", ":"));
  EXPECT_EQ(result.absent, "");
  EXPECT_EQ(result.count(Status::pass), 67u);
  EXPECT_EQ(result.count(Status::crash), 333u);
}

TEST_F(SchedulerTest, WhatTheJournalHasIsNotRunAgain) {
  run(script_that("c", "exit 1"));
  EXPECT_EQ(verdicts(resume("kill -KILL $$\n", 7u)), "a pass, b pass, c crash, d pass, e pass");
}

TEST_F(SchedulerTest, WhatTheJournalLacksIsRun) {
  run(script_that("none", ":"));
  // As if it had been killed while it wrote the third case.
  std::string text = text_of(kJournalFile);
  text.resize(text.find("\"c\"", text.find("\"result\"")) + 1);
  folder_.write(kJournalFile, text);
  const hn::Run again = resume("cp \"$2\" \"$0.job\"\n" + script_that("none", ":"), 3u);  // ready, a, b
  EXPECT_EQ(verdicts(again), "a pass, b pass, c pass, d pass, e pass");
  EXPECT_EQ(nlohmann::json::parse(text_of("child.job")).at("ids"), nlohmann::json({"c", "d", "e"}));
}

TEST(JournalTest, OfAnotherRunIsRefused) {
  const TemporaryFolder folder;
  ASSERT_TRUE(Journal::create(folder.path(), {{"seed", 1}, {"shard", ""}}));
  const auto other = Journal::reopen(folder.path(), {{"seed", 2}, {"shard", ""}});
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message.find("other settings: \"seed\""), std::string::npos) << other.error().message;
  EXPECT_TRUE(Journal::reopen(folder.path(), {{"seed", 1}, {"shard", ""}}));
  folder.write(kJournalFile, "{}\n");
  EXPECT_FALSE(Journal::reopen(folder.path(), {}));
  folder.write(kJournalFile, "{\"plan\": null}\n{\"driver\": 1}\n");
  EXPECT_FALSE(Journal::reopen(folder.path(), {}));
}

}  // namespace
}  // namespace hn
