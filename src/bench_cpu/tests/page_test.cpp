#include "bench_cpu/page.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

namespace hn {
namespace {

using hashnoise::InstructionSet;

CpuRun a_run() {
  const auto all = subjects();
  CpuRun run{.date = "2026-01-01T00:00:00Z",
             .command = "tools/measure cpu",
             .compiler = "GCC 12.2.0",
             .processor = "a processor",
             .rounds = 9,
             .note = "A note.",
             .measurements = {},
             .python = PythonMeasurement{{0.95, 0.01}, {0.85, 0.02}}};
  run.measurements.push_back({all[2],
                              InstructionSet::kAvx2,
                              {{Comparison::grids, {1.25, 0.03}}, {Comparison::fixed, {0.55, 0.01}}},
                              {{"fast", 1234.0}}});
  run.measurements.push_back({all[2],
                              InstructionSet::kAvx512,
                              {{Comparison::grids, {0.75, 0.02}}, {Comparison::fixed, {0.65, 0.01}}},
                              {{"fast", 2345.0}}});
  return run;
}

TEST(Page, TellsWhichAimsAreMissed) {
  const std::string page = page_of(a_run());
  EXPECT_NE(page.find("| `perlin2` | 1.2 | 1.25 ± 0.03 | **0.75 ± 0.02** missed |"), std::string::npos) << page;
  EXPECT_NE(page.find("| `perlin2` | **0.55 ± 0.01** missed | 0.65 ± 0.01 |"), std::string::npos) << page;
  EXPECT_NE(page.find("(`out=`) | **0.85 ± 0.02** missed |"), std::string::npos) << page;
  EXPECT_NE(page.find("with a new array each time | 0.95 ± 0.01 |"), std::string::npos) << page;
  EXPECT_NE(page.find("A note."), std::string::npos);
  const auto missed = missed_aims(a_run());
  ASSERT_EQ(missed.size(), 3u);
  EXPECT_EQ(missed[0], "perlin2, avx2: fixed 0.55 ± 0.01, which is to be 0.6");
  EXPECT_EQ(missed[1], "perlin2, avx512: grids 0.75 ± 0.02, which is to be 1.2");
  EXPECT_EQ(missed[2], "Python with out=: 0.85 ± 0.02, which is to be 0.9");
}

TEST(Page, HasNoSectionForWhatWasNotMeasured) {
  const std::string page = page_of(a_run());
  EXPECT_EQ(page.find("Two threads"), std::string::npos);
  CpuRun run = a_run();
  run.python.reset();
  EXPECT_EQ(page_of(run).find("Python"), std::string::npos);
}

TEST(Page, JsonHasTheSame) {
  const auto json = to_json(a_run());
  const auto& first = json.at("measurements").at(0);
  EXPECT_EQ(first.at("id"), "perlin2");
  EXPECT_EQ(first.at("ratios").at("grids").at("met"), true);
  EXPECT_EQ(first.at("ratios").at("fixed").at("met"), false);
  EXPECT_EQ(first.at("ratios").at("fixed").at("aim"), 0.6);
  EXPECT_EQ(json.at("measurements").at(1).at("ratios").at("grids").at("met"), false);
}

TEST(Page, WhatCannotBeToldIsNeitherMetNorMissed) {
  CpuRun run = a_run();
  run.python.reset();
  run.measurements = {{subjects()[0], InstructionSet::kAvx2, {{Comparison::grids, {}}}, {}}};
  EXPECT_TRUE(missed_aims(run).empty());
  EXPECT_EQ(to_json(run).at("measurements").at(0).at("ratios").at("grids").at("met"), false);
  EXPECT_NE(page_of(run).find("cannot be told"), std::string::npos);
}

TEST(Aims, AreThoseOfTheProject) {
  for (const Subject& subject : subjects()) {
    const std::map<std::string, double> higher = {
        {"perlin2", 1.2}, {"perlin3", 1.1}, {"simplex2", 1.1}, {"simplex3", 1.1}, {"cellular2", 2.0}, {"cellular3", 2.0}};
    const auto found = higher.find(subject.id);
    EXPECT_EQ(aim_of(Comparison::grids, subject), found == higher.end() ? 1.0 : found->second) << subject.id;
    EXPECT_EQ(aim_of(Comparison::fixed, subject), 0.6);
    EXPECT_EQ(aim_of(Comparison::lists, subject), 0.5);
    for (const Comparison comparison : {Comparison::octaves, Comparison::tiles, Comparison::threads}) {
      EXPECT_FALSE(aim_of(comparison, subject)) << name_of(comparison);
    }
  }
}

}  // namespace
}  // namespace hn
