#include "report/report.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/folder.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

TEST(Output, ResultsOfAnEarlierRunAreGone) {
  const TemporaryFolder folder;
  constexpr std::array kNames = {"results.json", "junit.xml", "index.html"};
  for (const char* name : kNames) folder.write(name, "yesterday");
  folder.write("other.txt", "mine");
  ASSERT_TRUE(prepare_results(folder.path()));
  for (const char* name : kNames) {
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "other.txt"));
}

TEST(Summary, NamesWhatFailedAndWhatIsUnsupported) {
  const auto text = summary(run_of({result("a.b.golden", Status::pass), result("c.d.golden", Status::fail),
                                    result("e.f.golden", Status::unsupported)}));
  EXPECT_NE(text.find("FAIL    c.d.golden\n  why"), std::string::npos) << text;
  EXPECT_NE(text.find("Unsupported, 1 case: why"), std::string::npos) << text;
  EXPECT_NE(text.find("1 pass, 1 fail, 1 unsupported"), std::string::npos) << text;
  CaseResult known = result("g.h.golden", Status::fail);
  known.excuse = "known";
  const auto excused = summary(run_of({known, result("c.d.golden", Status::fail), result("a.b", Status::unsupported)}));
  EXPECT_NE(excused.find("0 pass, 2 fail (1 excused), 1 unsupported;"), std::string::npos) << excused;
}

// An error is the suite's, not the driver's.
TEST(Summary, BlamesNoDriverForErrors) {
  CaseResult error = result("a.b.golden", Status::error);
  error.outcome.message = "golden/a.b:1: no";
  const auto text = summary(run_of({error, result("a.c.golden", Status::pass)}));
  EXPECT_NE(text.find("1 of 2 cases could not be checked on osmesa."), std::string::npos) << text;
}

TEST(Summary, SaysWhatWasNotRun) {
  hn::Run run = run_of({result("a.b.golden", Status::pass)});
  run.not_run = 4;
  EXPECT_NE(summary(run).find("1 pass, 4 not run;"), std::string::npos) << summary(run);
  hn::Run not_begun;
  not_begun.driver = "zink";
  not_begun.not_run = 5;
  EXPECT_EQ(summary(not_begun), "zink: none of its 5 cases was run\n");
}

CaseResult wrong(const std::string& id) {
  CaseResult bad = result(id, Status::fail);
  bad.outcome.mismatches = 4;
  bad.outcome.max_abs = 0.7;
  bad.outcome.allowed = 3.5e-6;
  bad.outcome.max_ulp = 2080170303;
  bad.outcome.message = "first at x=1.5 (3fc00000): got 0.7 (3f333333), expected 0 (00000000) within 3.5e-06";
  return bad;
}

TEST(Summary, SaysEachThingOnce) {
  CaseResult crashed = result("fbm.fbm2.lattice.fast.fragment.gl330.twin", Status::crash);
  crashed.outcome.message = "ended by signal 11; it printed:\n1\n2\n3\n4\n5\n6\n7\n8";
  const auto text = summary(run_of({wrong("noise2d.perlin.lattice.fixed.fragment.gl330.golden"),
                                    wrong("noise2d.perlin.fnv1.fixed.vertex.es300.twin"),
                                    result("noise2d.perlin.lattice.fast.fragment.gl330.golden", Status::pass),
                                    result("noise3d.value.fnv1.fixed.vertex.es300.twin", Status::pass), crashed}));
  const std::string expected =
      "osmesa on r, 4.5\n"
      "Largest difference from the exact values:\n"
      "  noise2d.perlin         0.7\n"
      "3 of 5 cases are wrong on osmesa.\n"
      "Begin with noise2d.perlin, the lowest layer that fails: 1 of 1 other failures may follow.\n"
      "Every failing case is in 2D; the one in 3D passes.\n"
      "FAIL    2 of 3 cases of noise2d.perlin (only with HN_FIXED)\n"
      "  such as noise2d.perlin.lattice.fixed.fragment.gl330.golden\n"
      "  4 of 10 values are wrong; the largest difference is 0.7, and 3.5e-06 is allowed\n"
      "  first at x=1.5 (3fc00000): got 0.7 (3f333333), expected 0 (00000000) within 3.5e-06\n"
      "CRASH   fbm.fbm2.lattice.fast.fragment.gl330.twin\n"
      "  ended by signal 11; it printed:\n"
      "  1\n  2\n  3\n  4\n  5\n"
      "  (3 more lines in results.json)\n";
  EXPECT_EQ(text.substr(0, expected.size()), expected);
}

TEST(Summary, HidesNoGroup) {
  std::vector<CaseResult> cases;
  for (int i = 0; i < 26; ++i) {
    for (int more = 0; more <= i % 2; ++more) {
      cases.push_back(wrong("f.g" + std::to_string(i) + ".x." + std::to_string(more)));
    }
  }
  const auto text = summary(run_of(std::move(cases)));
  EXPECT_NE(text.find("FAIL    f.g18.x.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("FAIL    2 of 2 cases of f.g19\n"), std::string::npos) << text;
  EXPECT_NE(
      text.find("... and 6 more groups, with the numbers of their cases: f.g20 (1), f.g21 (2), f.g22 (1), f.g23 (2), "
                "f.g24 (1), f.g25 (2); all are in results.json\n"),
      std::string::npos)
      << text;
}

TEST(EditedLibraries, AreNamedOnce) {
  hn::Run run = run_of({result("a.b.golden", Status::pass)});
  EXPECT_EQ(edited_libraries({run}), "");
  run.library = {.folder = "my/copy", .digest = "0123", .changed = {}};
  EXPECT_EQ(edited_libraries({run, run}), "The tested library is " + library_text(run.library) + "\n");
}

TEST(Summary, TellsWhatNeedsNoExcuse) {
  CaseResult first = result("a.b.x", Status::pass);
  CaseResult second = result("a.c.x", Status::pass);
  first.excuse = second.excuse = "known";
  const auto text = summary(run_of({first, second}));
  EXPECT_NE(text.find("PASS    a.b.x and 1 more\n  it is excused (known), and needs no excuse"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace hn
