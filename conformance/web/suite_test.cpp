#include "web/suite.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/folder.hpp"
#include "cases/bugs/bugs.hpp"
#include "expected/golden.hpp"
#include "library/configurations.hpp"
#include "web/files.hpp"
#include "web/wgsl.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;

// All of them, made once: they take a good part of a second.
const std::vector<Case>& product() {
  static const std::vector<Case> cases = all_cases();
  return cases;
}

Json suite_of(std::string_view id, const std::filesystem::path& golden = HN_GOLDEN_DIRECTORY) {
  const Case test = case_named(id);
  return Json::parse(make_suite(SourceSet::embedded(), golden, std::span(&test, 1)).json);
}

// The fragment shader of the only case.
Json fragment_of(const Json& suite) {
  return suite["programs"][suite["cases"][0]["program"].get<std::size_t>()]["fragment"];
}

std::string text_of(const Json& suite, const Json& shader) {
  std::string text;
  for (const std::size_t piece : suite["shaders"][shader.get<std::size_t>()]["pieces"]) {
    text += suite["texts"][piece].get<std::string>();
  }
  return text;
}

TEST(Suite, ThePageKnowsEveryStatusAndWhichAreBad) {
  std::vector<std::string_view> all;
  std::vector<std::string_view> bad;
  for (const Status status : kStatuses) {
    all.push_back(name_of(status));
    if (is_bad(status)) bad.push_back(name_of(status));
  }
  const std::string_view module = text_of(kWebFiles, "checks.js");
  for (const auto& [name, statuses] : {std::pair("kStatuses", all), std::pair("kBadStatuses", bad)}) {
    const std::string line = fmt::format("export const {} = [\"{}\"];\n", name, fmt::join(statuses, "\", \""));
    EXPECT_NE(module.find(line), std::string_view::npos) << "checks.js lacks " << line;
  }
}

TEST(Suite, AShaderIsTheOneThatDriversGet) {
  for (const std::string_view id :
       {"fbm.clouds3.lattice.fast.fragment.es300.golden", "hashnoise.all.pcg.fast.fragment.es300.driver"}) {
    const Json suite = suite_of(id);
    const Case test = case_named(id);
    const auto expected = expand(
        SourceSet::embedded(), profile_named("es300"),
        test.evaluation() ? evaluation_shader(*test.evaluation()) : std::get<CompilationKind>(*test.kind).fragment());
    EXPECT_EQ(text_of(suite, fragment_of(suite)), expected->text) << id;
    EXPECT_EQ(suite["shaders"][fragment_of(suite).get<std::size_t>()]["paths"], expected->paths) << id;
  }
}

TEST(Suite, OfAllDefaultCasesSaysOfWhichGoldenFilesItIs) {
  const Case test = case_named("noise2d.perlin.lattice.fast.fragment.es300.golden");
  const auto suite = [&](bool whole) {
    return Json::parse(
        make_suite(SourceSet::embedded(), HN_GOLDEN_DIRECTORY, std::span(&test, 1), {}, Platform::opengl, whole).json);
  };
  EXPECT_EQ(suite(true)["golden"], golden_checksum(HN_GOLDEN_DIRECTORY));
  EXPECT_FALSE(suite(false).contains("golden"));
}

Json wgsl_suite(const SourceSet& sources) {
  const Case test = case_named("noise2d.perlin.lattice.fixed.compute.wgsl.golden");
  return Json::parse(make_suite(sources, HN_GOLDEN_DIRECTORY, std::span(&test, 1)).json);
}

TEST(Suite, AnotherCopyOfTheLibraryHasNoWgsl) {
  SourceSet sources = SourceSet::embedded();
  const SourceFile file = *sources.find("hash.glsl");
  sources.add("hash.glsl", file.text + "// edited\n", file.path);
  const Json test = wgsl_suite(sources)["cases"][0];
  EXPECT_EQ(test["decided"]["status"], "unsupported");
  EXPECT_NE(test["decided"]["message"].get<std::string>().find("build hn-conform from the other copy"),
            std::string::npos)
      << test;
}

TEST(Suite, FaultsAreOfGlsl) {
  SourceSet sources = SourceSet::embedded();
  sources.transform_with([](ShaderText&, const Profile&) { return Result<void>(); });
  EXPECT_EQ(wgsl_suite(sources)["cases"][0]["decided"]["status"], "unsupported");
}

TEST(Suite, WebGpuHasTheCasesInWgsl) {
  const SourceSet sources = SourceSet::embedded();
  std::size_t supported = 0;
  for (const Case& test : product()) {
    const std::string reason = unsupported_in_browser(test, Platform::webgpu);
    EXPECT_EQ(reason.empty(), test.id.find(".compute.wgsl.") != std::string::npos) << test.id << ": " << reason;
    if (!reason.empty()) continue;
    ++supported;
    const auto* bug = std::get_if<BugKind>(test.kind.get());
    const Evaluation evaluation = bug ? evaluation_of(*bug->bug, *bug->profile) : *test.evaluation();
    EXPECT_TRUE(wgsl_shader(sources, evaluation)) << test.id;
  }
  EXPECT_GT(supported, 700u);
}

TEST(Suite, WgslHasTheSettingsOfTheSuite) {
  const Json all = Json::parse(text_of(kWebFiles, "wgsl.json"));
  for (const Configuration& configuration : all_configurations()) {
    const bool precise = configuration.arithmetic == Arithmetic::precise;
    EXPECT_EQ(all["knobs"].value(std::string(configuration.name), "none"), precise ? "none" : knobs_of(configuration));
  }
}

TEST(Suite, HashesAndFixedArithmeticAreExactAndAHashHasADigest) {
  for (const std::string_view id :
       {"noise2d.perlin.lattice.fixed.fragment.es300.golden", "hash.vec2.pcg.exact.fragment.es300.golden"}) {
    const Json test = suite_of(id)["cases"][0];
    EXPECT_EQ(test["exact"], true) << id;
    EXPECT_EQ(test["allowed"], 0.0) << id;
    EXPECT_EQ(test.contains("digest"), id.starts_with("hash.")) << id;
  }
}

TEST(Suite, ARefusalNamesItsWord) {
  const Json suite = suite_of("config.version_es100.any.fast.fragment.es100.refused_by_driver");
  const Json& test = suite["cases"][0];
  EXPECT_EQ(test["check"], "refused");
  EXPECT_EQ(test["names"], "GLSL ES 3.00");
  EXPECT_EQ(test["too_old"], true);
  EXPECT_TRUE(text_of(suite, test["fragment"]).starts_with("#version 100\n"));
}

TEST(Suite, AMissingGoldenFileIsAnErrorOfItsCase) {
  const TemporaryFolder nothing;
  const Json test = suite_of("noise2d.perlin.pcg.fast.fragment.es300.golden", nothing.path())["cases"][0];
  EXPECT_EQ(test["decided"]["status"], "error");
  EXPECT_NE(test["decided"]["message"].get<std::string>().find("noise2d.perlin.golden"), std::string::npos);
}

TEST(Suite, EveryCaseOfEs300IsInItOrHasAReason) {
  const std::set<std::string> kOnDrivers = {"golden",          "driver",        "refused_by_driver", "inlined",
                                            "in_loop",         "constant_seed", "uniform_seed",      "folded",
                                            "period",          "wrapped",       "constant_period",   "derivative_value",
                                            "defined",         "as_fragment",   "undefined",         "loop",
                                            "half_turn",       "phase_zero",    "from_cell",         "whole_detail",
                                            "small_footprint", "zero_strength", "zero_bandwidth"};
  std::size_t supported = 0;
  for (const Case& test : product()) {
    const std::string reason = unsupported_in_browser(test);
    const auto last = test.id.rfind('.') + 1;
    const bool es = test.id.find(".es300.") != std::string::npos || test.id.find(".es100.") != std::string::npos;
    EXPECT_EQ(reason.empty(), kOnDrivers.contains(test.id.substr(last)) && es) << test.id << ": " << reason;
    supported += reason.empty() ? 1 : 0;
  }
  EXPECT_GT(supported, 200u);
}

TEST(Suite, ThePageIsOneFileOfAModestSize) {
  std::vector<Case> cases = product();
  std::erase_if(cases, [](const Case& test) { return !is_on_page(test); });
  const auto page = web_page(make_suite(SourceSet::embedded(), HN_GOLDEN_DIRECTORY, cases).json);
  ASSERT_TRUE(page) << page.error().text();
  EXPECT_LT(page->size(), 5'000'000u);  // most of it are golden values and points, of all functions
  EXPECT_EQ(page->find("src="), std::string::npos);
  EXPECT_EQ(page->find("from \"./"), std::string::npos);
  EXPECT_NE(page->find("Content-Security-Policy\" content=\"default-src 'none';"), std::string::npos);
}

}  // namespace
}  // namespace hn
