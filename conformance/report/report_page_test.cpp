#include <gtest/gtest.h>

#include "report/report.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

std::string page_of(const std::vector<hn::Run>& runs, const std::vector<std::string>& problems = {}) {
  const auto page = report_page(runs, problems);
  EXPECT_TRUE(page) << page.error().text();
  return page.value_or("");
}

testing::AssertionResult has(const std::string& page, const std::string& text) {
  if (page.find(text) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << text << "\" is not in the page";
}

CaseResult failed(const std::string& id) {
  CaseResult bad = result(id, Status::fail);
  bad.outcome.mismatches = 4;
  bad.outcome.examples = {{1024 * 3 + 17, {1}, "x=1.5 (3fc00000)", "2 (00000002)", "3 (00000003)"}};
  bad.evidence = {.shader = "void main() { a < b && c; }",
                  .got = "R09U",
                  .reference = "UkVG",
                  .difference = "RElG",
                  .factor = 12.5,
                  .note = "A note."};
  return bad;
}

TEST(Page, OfAPassingRunSaysSoFirst) {
  hn::Run run = run_of({result("a.b.golden", Status::pass)});
  run.date = "2026-11-20T10:00:00Z";
  run.commands = {"hn-conform run --filter 'a*'"};
  const std::string page = page_of({run});
  EXPECT_TRUE(has(page, "<h1 class=\"verdict good\">All as expected: 1 case on 1 driver</h1>"));
  for (const char* part : {"osmesa", "4.5", "0.25", "hn-conform run --filter &apos;a*&apos;", "2026-11-20T10:00:00Z"}) {
    EXPECT_TRUE(has(page, part));
  }
  for (const char* part : {"Failures", "Crashes", "Not here", "Warnings", "Excused", "Unsupported"}) {
    EXPECT_FALSE(has(page, std::string("<h2>") + part));
  }
}

TEST(Page, ShowsWhatFailedAndWhere) {
  const std::string page = page_of({run_of({failed("f.g.x.golden"), result("f.g.y.golden", Status::pass)})});
  EXPECT_TRUE(has(page, "<h1 class=\"verdict bad\">Not as expected: 1 of 2 cases on 1 of 1 driver</h1>"));
  for (const char* part : {"f.g <span class=\"faint\">- 1 of 2 cases fail", "17, 3", "x=1.5 (3fc00000)", "2 (00000002)",
                           "3 (00000003)", "base64,R09U", "base64,UkVG", "base64,RElG", "times 12.5", "A note.",
                           "a &lt; b &amp;&amp; c;", "4 of 10 values are wrong"}) {
    EXPECT_TRUE(has(page, part));
  }
}

TEST(Page, HasOneTextForAVendor) {
  CaseResult bad = failed("noise2d.perlin.lattice.precise.compute.gl430.twin");
  EXPECT_TRUE(has(page_of({run_of({bad})}), "<pre class=\"code\">void main() { a &lt; b"));
  bad.evidence.reset();
  EXPECT_TRUE(has(page_of({run_of({bad})}), R"(<pre class="code">noise2d.perlin.lattice.precise.compute.gl430.twin
fails on r, 4.5, GLSL 4.50 (v).

rule      GLSL 4.00 section 4.9 (4.60 section 4.12), GLSL ES 3.20 section 4.9: with precise, operations are neither fused nor reassociated; so HLSL&apos;s precise
at        x=1.5 (3fc00000)
got       2 (00000002)
expected  3 (00000003)

4 of 10 values are wrong.

To see it: hn-conform run --driver osmesa --filter noise2d.perlin.lattice.precise.compute.gl430.twin, of )"));
  bad.outcome = result("x", Status::fail).outcome;
  bad.outcome.message = "does not compile\nglsl/hash.glsl:7: no";
  const std::string page = page_of({run_of({bad})});
  EXPECT_TRUE(has(page, "(v).\n\n"));
  EXPECT_TRUE(has(page, "glsl/hash.glsl:7: no\n\nTo see it:"));
  EXPECT_FALSE(has(page, "rule  "));
}

// Nobody promises that two drivers return the same, so there is no report of it for a vendor.
TEST(Page, OfACheckIsAboutTheFunction) {
  hn::Run run =
      run_of({failed("check.hash.any.fast.fragment.gl330.same"), result("check.hash.x", Status::unsupported)});
  run.checked = {"hash.glsl:hash(p)", "osmesa in gl330", false};
  run.way = short_way();
  run.cases[1].outcome.step = {1, "", ""};
  const std::string page = page_of({run});
  for (const char* part :
       {"<title>hash.glsl:hash(p): Not as expected", "Check of <strong>hash.glsl:hash(p)</strong>, by hashnoise ",
        "compared with those of osmesa in gl330, which may be wrong itself.", "4 of 10 values differ",
        "<th>point</th><th>at</th>", "data-label=\"point\">3090<", "<summary>The values: a shader that shows it alone",
        "<th class=\"number\">fail</th><th class=\"number\">unsupported</th><th class=\"number\">time</th>",
        "<th>command</th><th>date</th>"}) {
    EXPECT_TRUE(has(page, part));
  }
  for (const char* part :
       {"Conformance of", "Copy a report", "are wrong", ">excused<", "Every case", "points are random"}) {
    EXPECT_FALSE(has(page, part));
  }
  run.checked = {"hash.glsl:hash(p)", "right.csv", true};
  const std::string of_right = page_of({run});
  for (const char* part : {"compared with the right ones in right.csv.", "4 of 10 values are wrong",
                           "Copy a report for the vendor", "<summary>The report: a shader that shows it alone"}) {
    EXPECT_TRUE(has(of_right, part));
  }
  run.checked->expected_right = false;
  run.cases[0].outcome.step = {1, "", ""};
  EXPECT_TRUE(has(page_of({run}), "changes values: <code>/usr/bin/spirv-opt"));
  EXPECT_FALSE(has(page_of({run}), "Copy a report"));
}

TEST(Page, HasOneTextForTheMakersOfATranslator) {
  CaseResult wrong = failed("bugs.abs_of_int.any.exact.compute.vulkan.defined");
  wrong.outcome.step = {1, "ways/bugs.abs/1-spirv-opt.spv", "%1 = OpTypeVoid"};
  wrong.outcome.message = "wrong after it: first\nreturn abs(x);";
  CaseResult refused = result("a.b.refused", Status::fail);
  CaseResult crash = result("a.b.crash", Status::crash);
  refused.outcome.step = crash.outcome.step = {1, "", ""};
  CaseResult elsewhere = failed("f.g.elsewhere");
  elsewhere.outcome.message = "wrong without a translator, too";
  hn::Run run = run_of({wrong, refused, crash, elsewhere});
  run.way = short_way();
  const std::string page = page_of({run});
  EXPECT_FALSE(has(page, "Crashes, timeouts and errors")) << "each is a failure of the step";
  for (const char* part :
       {"<h3>osmesa through spirv-opt 2023.1: r, 4.5</h3>", "Copy a report for the makers of spirv-opt",
        "<strong>Step 1 of the chain, spirv-opt 2023.1,</strong> makes a right shader wrong: <code>/usr/bin/spirv-opt "
        "-O "
        "1-spirv-opt.spv -o out.spv</code>",
        "<td class=\"wide\">through <strong>spirv-opt 2023.1</strong><br>on r<br>",
        "<a href=\"ways/bugs.abs/1-spirv-opt.spv\">", "Copy a report for the vendor",
        "<pre>wrong without a translator, too</pre>",
        "spirv-opt 2023.1 refuses a valid shader, or writes an invalid one.", "spirv-opt 2023.1 crashes.",
        R"(<pre class="code">spirv-opt 2023.1 makes a right shader wrong.

command   /usr/bin/spirv-opt -O 1-spirv-opt.spv -o out.spv
run on    r, 4.5, GLSL 4.50 (v)
rule      )",
        R"(
at        x=1.5 (3fc00000)
got       2 (00000002)
expected  3 (00000003)

4 of 10 values are wrong.

To see it: hn-conform run --driver osmesa --through spirv-opt --filter bugs.abs_of_int.any.exact.compute.vulkan.defined, of )",
        "\nThe lines that go wrong, as the suite has them:\nreturn abs(x);\n\n"
        "The shader that it got is ways/bugs.abs/1-spirv-opt.spv. It writes 4 words for each point to the buffer at "
        "binding 0, of 16 words of the one at binding 1; the first here:\n00000001\n\n%1 = OpTypeVoid\n"}) {
    EXPECT_TRUE(has(page, part));
  }
}

TEST(Page, OfARunThatEndedTooEarlySaysSoFirst) {
  hn::Run run = run_of({result("a.b.golden", Status::pass)});
  run.not_run = 4;
  const std::string page = page_of({run}, {"SIGINT ended the run; 4 of 5 cases were not run"});
  EXPECT_TRUE(has(page, "<h1 class=\"verdict bad\">Not the whole run: 1 of 5 cases on 1 driver</h1>"));
  EXPECT_TRUE(has(page, "SIGINT ended the run"));
  EXPECT_TRUE(has(page, "<td class=\"name bad\">4 not run</td>"));
  run.cases.push_back(failed("f.g.x.golden"));
  EXPECT_TRUE(has(page_of({run}, {"why"}), "Not as expected: 1 of 2 cases on 1 of 1 driver"));
}

TEST(Page, SaysWhatFailuresHaveInCommon) {
  CaseResult second = failed("noise2d.perlin.fnv1.fixed.vertex.es300.twin");
  second.outcome.max_abs = 0.7;
  second.outcome.allowed = 3.5e-6;
  const std::string page = page_of({run_of({failed("noise2d.perlin.lattice.fixed.fragment.gl330.golden"), second,
                                            result("noise2d.perlin.lattice.fast.fragment.gl330.golden", Status::pass),
                                            result("noise2d.perlin.lattice.fast.fragment.gl330.twin", Status::pass)})});
  EXPECT_TRUE(has(page, "<p>Every failing case is with HN_FIXED; all 2 with HN_FAST pass.</p>"));
  EXPECT_TRUE(has(page, "the largest difference is 0.7, and 3.5e-06 is allowed."));
  EXPECT_FALSE(has(page, "units in the last place"));
}

// A defect of one file is an error in every function: it is shown once.
TEST(Page, ShowsTheSameErrorOnce) {
  const auto refused = [](const std::string& id) {
    CaseResult bad = result(id, Status::fail);
    bad.outcome.message = "does not compile\nglsl/hash.glsl:7: no";
    return bad;
  };
  const std::string page = page_of({run_of({refused("f.g.x"), refused("f.h.x"), refused("f.i.x")})});
  EXPECT_TRUE(has(page, "does not compile <span class=\"faint\">- 3 cases"));
  EXPECT_TRUE(has(page, "2 more of the kind, in results.json"));
  const auto first = page.find("glsl/hash.glsl:7");
  const auto in_report = page.find("glsl/hash.glsl:7", first + 1);
  EXPECT_EQ(page.find("glsl/hash.glsl:7", in_report + 1), std::string::npos);
}

TEST(Page, NamesTheEditedLibrary) {
  hn::Run run = run_of({failed("f.g.x.golden")});
  EXPECT_TRUE(has(page_of({run}), "Conformance of hashnoise "));
  EXPECT_TRUE(has(page_of({run}), "<figcaption>this driver</figcaption>"));
  EXPECT_FALSE(has(page_of({run}), "its text may be at fault"));
  run.library = {.folder = "my/<copy>", .digest = "0123", .changed = {"hash.glsl"}};
  EXPECT_TRUE(has(page_of({run}), "Conformance of the library in my/&lt;copy&gt; (hash.glsl differs from hashnoise "));
  EXPECT_TRUE(has(page_of({run}), "<figcaption>the edited library</figcaption>"));
  EXPECT_TRUE(has(page_of({run}), "<p>The library is edited: its text may be at fault, and not the driver.</p>"));
}

TEST(Page, HasEveryStatus) {
  CaseResult excused = result("a.b.excused", Status::timeout);
  excused.excuse = "a known bug";
  CaseResult unneeded = result("a.b.unneeded", Status::pass);
  unneeded.excuse = "an old bug";
  CaseResult warning = result("a.b.warning", Status::warning);
  warning.outcome.message = "1 << 32 is 1";
  CaseResult crash = result("a.b.crash", Status::crash);
  crash.outcome.message = "ended by signal 11; it printed:\nthe end";
  CaseResult refused = result("a.b.refused", Status::fail);
  refused.outcome.message = "does not compile\nglsl/hash.glsl:7: no";
  hn::Run absent;
  absent.driver = "zink";
  absent.absent = "no Vulkan";
  hn::Run run = run_of({crash, warning, excused, unneeded, refused, result("a.b.unsupported", Status::unsupported),
                        result("a.b.timeout", Status::timeout), result("a.b.error", Status::error)});
  run.shard = "2/3";
  run.whole = 24;
  const std::string page = page_of({run, absent}, {"the moon is full"});
  for (const char* part : {"5 of 8 cases", "the moon is full", "no Vulkan", "glsl/hash.glsl:7: no",
                           "it printed:\nthe end", "1 &lt;&lt; 32 is 1", "a known bug", "an old bug",
                           "Excuses that are not needed", "2/3; 24 cases in all", "1 unsupported", "1 timeout"}) {
    EXPECT_TRUE(has(page, part));
  }
}

// A hash that is wrong makes everything above it wrong, and comes first.
TEST(Page, KeepsTheOrderOfTheCases) {
  const std::string page = page_of({run_of({failed("z.hash.x.golden"), failed("a.noise.x.golden")})});
  EXPECT_LT(page.find("z.hash <span"), page.find("a.noise <span"));
}

TEST(Page, WithAProblemIsNotAsExpected) {
  EXPECT_TRUE(has(page_of({run_of({result("a.b.golden", Status::pass)})}, {"a shard is missing"}),
                  "Not as expected, though no case is wrong"));
  EXPECT_TRUE(has(page_of({}), "Not as expected"));
  EXPECT_TRUE(has(page_of({run_of({result("a.b.golden", Status::unsupported)})}), "nothing passed"));
}

TEST(Page, TakesEveryByte) {
  CaseResult bad = failed("<script>alert(1)</script>.b.c");
  bad.outcome.examples.clear();
  bad.outcome.message = "{{verdict}} </pre><script> \xff\x01";
  hn::Run run = run_of({bad});
  run.info.renderer = "\xfe";
  const std::string page = page_of({run});
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("</pre><script>"), std::string::npos);
  EXPECT_EQ(page.find('\xff'), std::string::npos);
  EXPECT_EQ(page.find('\xfe'), std::string::npos);
  EXPECT_TRUE(has(page, "{{verdict}}"));
}

// The largest results.json: everything fails, with logs of every length, and all evidence there is.
TEST(Page, StaysSmallHoweverMuchIsWrong) {
  std::vector<hn::Run> runs;
  for (int driver = 0; driver < 4; ++driver) {
    std::vector<CaseResult> cases;
    for (int i = 0; i < 18000; ++i) {
      CaseResult bad = failed("file.function" + std::to_string(i % 26) + ".x." + std::to_string(i) + ".golden");
      bad.outcome.examples.resize(8, bad.outcome.examples.front());
      if (i % 5 == 0) bad.outcome.examples.clear();
      if (i % 7 == 0) bad.outcome.status = Status::crash;
      if (i % 11 == 0) bad.outcome.status = Status::warning;
      if (i % 13 == 0) bad.outcome.status = Status::unsupported;
      bad.outcome.message = std::to_string(i) + std::string(i < 1000 ? 20000 : 100, 'm');
      if (i >= 32) bad.evidence.reset();
      if (bad.evidence) bad.evidence->got = bad.evidence->difference = std::string(20000, 'A');
      cases.push_back(std::move(bad));
    }
    runs.push_back(run_of(std::move(cases)));
  }
  const std::string page = page_of(runs);
  EXPECT_LT(page.size(), 5'000'000u);
  EXPECT_TRUE(has(page, "more of this function, in results.json"));
  EXPECT_TRUE(has(page, "characters more"));
  EXPECT_TRUE(has(page, "such groups, in results.json"));
  EXPECT_TRUE(has(page, "more warnings, in results.json"));
}

}  // namespace
}  // namespace hn
