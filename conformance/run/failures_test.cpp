#include "run/failures.hpp"

#include <gtest/gtest.h>

#include "run/result_support.hpp"

namespace hn {
namespace {

CaseResult wrong(std::string id) {
  CaseResult bad = result(std::move(id), Status::fail);
  bad.outcome.mismatches = 4;
  return bad;
}

CaseResult right(std::string id) { return result(std::move(id), Status::pass); }

using Sentences = std::vector<std::string>;

Sentences common_in(std::vector<CaseResult> cases) { return failures_of(run_of(std::move(cases))).common; }

struct Row {
  const char* about;
  std::vector<const char*> wrong;
  std::vector<const char*> right;
  Sentences common;
};

TEST(Common, IsWhatAllFailuresAreAndOthersAreNot) {
  const Row rows[] = {
      {"dimensions",
       {"noise2d.perlin.pcg.fast.fragment.gl330.golden", "fbm.fbm2.lattice.fixed.vertex.es300.twin"},
       {"noise3d.perlin.pcg.fast.fragment.gl330.golden", "fbm.fbm3.lattice.fixed.vertex.es300.twin"},
       {"Begin with noise2d.perlin, the lowest layer that fails: 1 of 1 other failures may follow.",
        "Every failing case is in 2D; all 2 in 3D pass."}},
      {"an arithmetic, which does not matter to the hash: it is not counted",
       {"noise2d.perlin.lattice.fixed.fragment.gl330.golden", "fbm.fbm3.lattice+sine.fixed.vertex.es300.twin"},
       {"noise2d.perlin.lattice.fast.fragment.gl330.golden", "fbm.fbm3.lattice+sine.precise.vertex.es300.twin",
        "hash.word.pcg.exact.vertex.es300.twin"},
       {"Every failing case is with HN_FIXED; all 2 with HN_FAST or with HN_PRECISE pass."}},
      {"a form",
       {"noise2d.value_cell_period.lattice.fast.fragment.gl330.golden",
        "noise3d.perlin_cell_period.lattice.fixed.vertex.es300.twin"},
       {"noise2d.value.lattice.fast.fragment.gl330.golden", "noise3d.perlin_cell.lattice.fixed.vertex.es300.twin",
        "gradient.lattice3.lattice.exact.vertex.es300.twin"},
       {"Every failing case is with a period; all 2 without a period pass."}},
      {"one after the other, while it separates more",
       {"noise2d.perlin.lattice.fast.vertex.gl330.golden", "noise2d.perlin.fnv1.precise.vertex.es300.twin"},
       {"noise2d.perlin.lattice.fast.fragment.gl330.golden", "noise2d.perlin.fnv1.precise.fragment.es300.twin",
        "noise2d.perlin.fnv1.fixed.fragment.gl330.golden", "noise3d.value.lattice.fast.vertex.gl330.golden",
        "noise3d.value.fnv1.precise.vertex.es300.twin"},
       {"Every failing case is in the vertex stage; all 3 in the fragment stage pass.",
        "Every failing case is of perlin noise; all 2 of value noise pass."}},
      {"a stage in which other functions pass alone",
       {"fbm.fbm2.pcg.fast.fragment.gl330.golden", "fbm.fbm2.fnv1.fast.fragment.gl330.golden"},
       {"fbm.billow2.pcg.fast.vertex.gl330.golden", "fbm.billow2.fnv1.fast.vertex.gl330.golden"},
       {"Every failing case is in the fragment stage; all 2 in the vertex stage pass (of other functions)."}},
      {"two others",
       {"hash.lattice2.pcg.exact.fragment.gl330.golden", "hash.lattice2.murmur.exact.fragment.es300.golden"},
       {"hash.lattice1.pcg.exact.fragment.gl330.golden", "hash.lattice3.pcg.exact.fragment.es300.golden",
        "noise3d.value.murmur.fast.fragment.es300.golden"},
       {"Every failing case is in 2D; all 3 in 1D or in 3D pass."}},
      {"three others, and one that has no dimension",
       {"hash.lattice2.pcg.exact.fragment.gl330.golden", "hash.lattice2.murmur.exact.fragment.es300.golden"},
       {"hash.lattice1.pcg.exact.fragment.gl330.golden", "hash.lattice3.pcg.exact.fragment.es300.golden",
        "hash.lattice4.pcg.exact.fragment.gl330.golden", "hash.word.pcg.exact.fragment.gl330.golden"},
       {"Every failing case is in 2D; all 3 in 1D, in 3D or in 4D pass."}},
      {"what none of them is",
       {"hash.lattice1.pcg.exact.fragment.gl330.golden", "gradient.lattice2.pcg.exact.fragment.es300.golden",
        "noise2d.perlin.fnv1.fast.fragment.gl330.golden", "noise3d.value.murmur.precise.fragment.es300.golden"},
       {"fbm.fbm3.lattice+sine.fast.fragment.gl330.golden", "fbm.fbm3.lattice+sine.fast.fragment.es300.golden"},
       {"No failing case is of octave sums; all 2 such cases pass."}},
      {"nothing",
       {"noise2d.perlin.pcg.fast.fragment.gl330.golden", "fbm.fbm3.lattice.fixed.vertex.es300.twin",
        "hash.lattice1.fnv1.exact.compute.gl430.golden"},
       {"noise2d.perlin.lattice.fixed.vertex.es300.twin", "hash.lattice1.fnv1.exact.fragment.gl330.golden"},
       {"The names of the failing cases have nothing in common."}},
      {"nothing, of a single group",
       {"noise2d.perlin.pcg.fast.fragment.gl330.golden", "noise2d.perlin.fnv1.fixed.vertex.es300.twin"},
       {"noise2d.perlin.pcg.fixed.vertex.es300.twin", "noise2d.perlin.fnv1.fast.fragment.gl330.golden"},
       {}},
      {"nothing of one case",
       {"noise2d.perlin.pcg.fast.fragment.gl330.golden"},
       {"noise3d.perlin.pcg.fast.fragment.gl330.golden"},
       {}},
      {"nothing without a case", {}, {}, {}},
  };
  for (const Row& row : rows) {
    std::vector<CaseResult> cases;
    for (const char* id : row.wrong) cases.push_back(wrong(id));
    for (const char* id : row.right) cases.push_back(right(id));
    EXPECT_EQ(common_in(cases), row.common) << row.about;
  }
}

// A case with which the sentence would be false takes it away.
TEST(Common, IsHeldAgainstEveryFailure) {
  const auto cases = [](Status of_third) {
    CaseResult third = result("hash.lattice3.murmur.exact.compute.gl430.golden", of_third);
    return std::vector{wrong("noise2d.value.fnv1.fast.fragment.gl330.golden"),
                       wrong("noise2d.perlin.pcg.fixed.vertex.es300.twin"), third,
                       right("noise3d.value.fnv1.fast.fragment.gl330.golden"),
                       right("noise3d.perlin.pcg.fixed.vertex.es300.twin")};
  };
  EXPECT_EQ(common_in(cases(Status::pass)), Sentences{"Every failing case is in 2D; all 3 in 3D pass."});
  EXPECT_EQ(common_in(cases(Status::crash)), Sentences{"The names of the failing cases have nothing in common."});
}

TEST(Common, CountsWhatRanAndNothingElse) {
  CaseResult excused = wrong("noise3d.perlin.fnv1.fast.fragment.gl330.golden");
  excused.excuse = "known";
  const std::vector<CaseResult> cases = {wrong("noise2d.perlin.pcg.fast.fragment.gl330.golden"),
                                         wrong("noise2d.perlin.fnv1.fast.fragment.gl330.golden"),
                                         result("noise3d.perlin.pcg.fast.fragment.gl330.golden", Status::unsupported)};
  const auto with = [&](std::vector<CaseResult> more) {
    more.insert(more.begin(), cases.begin(), cases.end());
    return common_in(more);
  };
  EXPECT_EQ(with({}), Sentences{"Every case that ran fails."});
  const CaseResult passed = right("noise3d.perlin.pcg.fast.fragment.gl330.twin");
  const CaseResult warned = result("noise3d.perlin.pcg.fast.fragment.es300.twin", Status::warning);
  EXPECT_EQ(with({passed, warned}), Sentences{"Every failing case is in 2D; none of the 2 in 3D fails."});
  EXPECT_EQ(with({passed, excused}),
            Sentences{"Every failing case is in 2D; none of the 2 in 3D fails, apart from 1 that is excused."});
}

// A driver that agrees with itself does not show that it is right.
TEST(Common, CountsOnlyWhatTheFaultWouldShowIn) {
  std::vector<CaseResult> cases = {
      wrong("noise2d.perlin.pcg.fast.vertex.gl330.golden"), wrong("noise2d.perlin.fnv1.fixed.compute.gl430.twin"),
      right("noise2d.perlin.pcg.fast.fragment.gl330.inlined"), right("noise2d.perlin.pcg.fast.fragment.gl330.mirror"),
      right("config.all.any.exact.fragment.gl330.driver")};
  EXPECT_EQ(
      common_in(cases),
      Sentences{"Every case that compares with right values fails; the 3 that pass compare the driver with itself."});
  cases.push_back(right("noise2d.perlin.pcg.fast.fragment.gl330.twin"));
  EXPECT_EQ(
      common_in(cases),
      Sentences{
          "Every failing case is in the compute stage or in the vertex stage; the one in the fragment stage passes."});
  cases.pop_back();
  cases.push_back(wrong("noise2d.perlin.pcg.fast.vertex.gl330.inlined"));
  EXPECT_EQ(
      common_in(cases),
      Sentences{
          "Every failing case is in the compute stage or in the vertex stage; the one in the fragment stage passes."})
      << "where inlined fails, it shows the fault";
}

TEST(Common, BeginsWithTheLowestLayerThatFails) {
  const char* const hash2 = "hash.lattice2.lattice.exact.fragment.gl330.golden";
  const char* const hash3 = "hash.lattice3.lattice.exact.vertex.es300.twin";
  const char* const word = "hash.word.pcg.exact.fragment.gl330.golden";
  const char* const noise2 = "noise2d.perlin.lattice.fast.fragment.gl330.golden";
  const char* const noise3 = "noise3d.value.lattice+sine.fixed.vertex.es300.range";
  const char* const noise4 = "noise4d.perlin.pcg.fast.fragment.gl330.twin";
  const char* const sum2 = "fbm.fbm2.lattice.fixed.fragment.gl330.golden";
  const char* const bug = "bugs.abs_of_int.any.exact.fragment.gl330.defined";
  const struct {
    const char* about;
    std::vector<const char*> wrong;
    std::string sentence;  // or nothing
  } rows[] = {
      {"one function",
       {sum2, noise2, hash2},
       "Begin with hash.lattice2, the lowest layer that fails: 2 of 2 other failures may follow."},
      {"of dimensions",
       {hash2, hash3, noise2, noise3, sum2},
       "Begin with hash.lattice2, hash.lattice3, the lowest layer that fails: 3 of 3 other failures may follow."},
      {"that others need",
       {hash2, noise2, sum2, noise4},
       "Begin with hash.lattice2, the lowest layer that fails: 2 of 3 other failures may follow."},
      {"a hash of every dimension",
       {word, noise4},
       "Begin with hash.word, the lowest layer that fails: 1 of 1 other failures may follow."},
      {"noise",
       {noise2, sum2},
       "Begin with noise2d.perlin, the lowest layer that fails: 1 of 1 other failures may follow."},
      {"the driver itself",
       {hash2, noise4, sum2, bug},
       "Begin with bugs.abs_of_int, a few lines without the library: 3 of 3 other failures may follow."},
      {"another dimension", {hash3, noise2, noise4}, ""},
      {"a single layer", {hash2, hash3}, ""},
  };
  for (const auto& row : rows) {
    std::vector<CaseResult> cases = {right("hash.lattice4.fnv1.exact.fragment.gl330.golden")};
    for (const char* id : row.wrong) cases.push_back(wrong(id));
    const Failures failures = failures_of(run_of(cases));
    const std::string first = failures.common.empty() ? "" : failures.common.front();
    EXPECT_EQ(first.starts_with("Begin") ? first : "", row.sentence) << row.about;
    if (row.sentence.empty()) continue;
    EXPECT_NE(row.sentence.find(failures.groups.front().title), std::string::npos) << row.about << ": it comes first";
  }
}

TEST(Groups, AreByFunctionWhereValuesAreWrong) {
  const auto failures = failures_of(run_of({wrong("noise2d.perlin.lattice.fixed.fragment.gl330.golden"),
                                            wrong("noise2d.perlin.fnv1.fixed.vertex.es300.twin"),
                                            wrong("noise3d.perlin.lattice.fast.fragment.gl330.golden"),
                                            right("noise2d.perlin.lattice.fast.fragment.gl330.golden"),
                                            right("noise2d.perlin.fnv1.precise.vertex.es300.twin")}));
  EXPECT_EQ(failures.failed, 3u);
  EXPECT_EQ(failures.ran, 5u);
  ASSERT_EQ(failures.groups.size(), 2u);
  EXPECT_EQ(failures.groups[0].text(), "2 of 4 cases of noise2d.perlin (only with HN_FIXED)");
  EXPECT_EQ(failures.groups[1].text(), "1 of 1 case of noise3d.perlin");
}

TEST(Groups, AreByWhatIsSaidWhereThereAreNoValues) {
  const auto verdict = [](std::string id, Status status, const char* message) {
    CaseResult bad = result(std::move(id), status);
    bad.outcome.message = message;
    return bad;
  };
  const auto failures =
      failures_of(run_of({verdict("noise2d.perlin.lattice.fast.fragment.gl330.golden", Status::fail, "no\n2"),
                          verdict("fbm.fbm3.fnv1.fixed.fragment.gl330.twin", Status::fail, "no\n2"),
                          verdict("fbm.fbm3.lattice.fast.fragment.gl330.twin", Status::crash, "no\n2"),
                          right("fbm.fbm3.lattice.fast.vertex.es300.twin")}));
  ASSERT_EQ(failures.groups.size(), 2u);
  EXPECT_EQ(failures.groups[0].text(), "2 cases: no");
  EXPECT_EQ(failures.groups[1].status, Status::crash);
  EXPECT_EQ(failures.groups[1].text(), "1 case: no");
}

TEST(Groups, LoseNoCase) {
  std::vector<CaseResult> cases;
  for (int i = 0; i < 300; ++i) {
    CaseResult bad = i % 3 == 0 ? wrong("f.g" + std::to_string(i % 70) + ".x." + std::to_string(i))
                                : result("f.h.x." + std::to_string(i), i % 2 == 0 ? Status::timeout : Status::fail);
    bad.outcome.message = std::to_string(i % 11);
    cases.push_back(std::move(bad));
  }
  const hn::Run run = run_of(std::move(cases));
  const Failures failures = failures_of(run);
  std::size_t grouped = 0;
  for (const FailureGroup& group : failures.groups) grouped += group.cases.size();
  EXPECT_EQ(grouped, 300u);
  EXPECT_EQ(failures.failed, 300u);
}

}  // namespace
}  // namespace hn
