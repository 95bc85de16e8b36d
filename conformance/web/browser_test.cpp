// The page in headless Chromium, which the machine must have for these tests.
#include "web/browser.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "cases/case.hpp"
#include "web/browser_story.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

SourceSet changed(SourceSet sources, const char* file, std::string_view old, std::string_view with) {
  const SourceFile* original = sources.find(file);
  std::string text = original->text;
  const auto at = text.find(old);
  if (at == std::string::npos) throw std::invalid_argument(std::string(old));
  sources.add(file, text.replace(at, old.size(), with), original->path);
  return sources;
}

SourceSet changed(const char* file, std::string_view old, std::string_view with) {
  return changed(SourceSet::embedded(), file, old, with);
}

TEST(Browser, ItIsWhatItsNameSays) {
  const auto swiftshader = describe_browser(browser_named("webgl2"));
  ASSERT_TRUE(swiftshader) << swiftshader.error().text();
  EXPECT_NE(swiftshader->renderer.find("SwiftShader"), std::string::npos) << swiftshader->renderer;
  EXPECT_TRUE(swiftshader->gl_version.starts_with("WebGL 2.0")) << swiftshader->gl_version;
  const auto mesa = describe_browser(browser_named("webgl2-mesa"));
  ASSERT_TRUE(mesa) << mesa.error().text();
  EXPECT_NE(mesa->renderer.find("Mesa"), std::string::npos) << mesa->renderer;
  EXPECT_EQ(mesa->renderer.find("SwiftShader"), std::string::npos) << mesa->renderer;
  expect_nothing_is_left(getpid());
}

TEST(Browser, AnotherRendererIsAnErrorAndSoIsAProgramThatIsNotHereOrEnds) {
  Browser renderer = browser_named("webgl2"), absent = renderer, ends = renderer;
  renderer.renderer = "llvmpipe";
  absent.programs = {"no-such-browser"};
  ends.programs = {"false"};
  for (const auto& [browser, part] : {std::pair{renderer, "instead of llvmpipe"},
                                      {absent, "there is no no-such-browser in PATH"},
                                      {ends, "Chromium ended with status 1"}}) {
    const auto info = describe_browser(browser);
    ASSERT_FALSE(info) << part;
    EXPECT_NE(info.error().message.find(part), std::string::npos) << info.error().message;
  }
}

TEST(Browser, CasesHaveTheirVerdictsInTheirOrder) {
  Story story;
  const std::vector<std::string> ids = {kDesktop, kHash, kTwin, kNoise, kCompiles, kRefused, kDesktop};
  const auto done = run(story, std::span(ids).first(6));
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(story.infos.size(), 1u);
  EXPECT_EQ(story.started, std::vector(ids.begin(), ids.end() - 1));
  EXPECT_EQ(story.finished_ids(), story.started);
  for (const std::string& id : kSome) EXPECT_EQ(story.outcome(id).status, Status::pass) << story.outcome(id).message;
  EXPECT_EQ(story.outcome(kHash).samples, 16448u);
  EXPECT_GT(story.outcome(kNoise).max_abs, 0.0);
  EXPECT_EQ(story.outcome(kDesktop).status, Status::unsupported);
  EXPECT_EQ(story.outcome(kDesktop).message, "this context does not compile desktop GLSL");
}

TEST(Browser, WgslHasItsValuesInWebGpu) {
  Story story;
  const std::vector<std::string> ids = {kNoise, kWgsl, kWgslHash, kWgslSum};
  const auto done = run(story, ids, "webgpu");
  ASSERT_TRUE(done) << done.error().text();
  ASSERT_EQ(story.infos.size(), 1u);
  EXPECT_NE(story.infos[0].renderer.find("swiftshader"), std::string::npos) << story.infos[0].renderer;
  EXPECT_EQ(story.finished_ids(), ids);
  EXPECT_EQ(story.outcome(kNoise).status, Status::unsupported);
  EXPECT_EQ(story.outcome(kNoise).message, "this is for drivers of OpenGL");
  for (const char* id : {kWgsl, kWgslHash, kWgslSum}) {
    EXPECT_EQ(story.outcome(id).status, Status::pass) << story.outcome(id).message;
  }
  EXPECT_EQ(story.outcome(kWgsl).max_abs, 0.0);
  EXPECT_GT(story.outcome(kWgslHash).samples, 16384u);  // with the digest
  EXPECT_GT(story.outcome(kWgslSum).max_abs, 0.0);
  expect_nothing_is_left(getpid());
}

// Golden files whose values are others, since the shaders in WGSL are those of the library alone.
TEST(Browser, WrongValuesAreNoticedInWebGpu) {
  Story story;
  const TemporaryFolder golden;
  const std::vector<std::string> ids = {kWgsl, kWgslSum};
  for (const char* name : {"noise2d.perlin.golden", "fbm.fbm2.golden"}) {
    std::string text = *read_file(std::filesystem::path(HN_GOLDEN_DIRECTORY) / name);
    for (auto at = text.find(" = 3f"); at != std::string::npos; at = text.find(" = 3f", at))
      text.replace(at, 5, " = 40");
    ASSERT_TRUE(write_file(golden.path() / name, text));
  }
  ASSERT_TRUE(run(story, ids, "webgpu", SourceSet::embedded(), golden.path()));
  for (const std::string& id : ids) EXPECT_EQ(story.outcome(id).status, Status::fail) << id;
}

TEST(Browser, AnUnknownCaseIsAnError) {
  Story story;
  const std::vector<std::string> ids = {"no.such.case"};
  EXPECT_FALSE(run(story, ids));
}

// --- Each check of the page must report a fault ----------------------------------------------------------------------

// Most of what a run costs is the browser's start, so two faults share a run where each has cases of its own.
TEST(BrowserFault, AWrongHashFailsWhereItIsWrongAndAShaderThatDoesNotCompileWithItsFileAndLine) {
  Story story;
  ASSERT_TRUE(run(story, kSome, "webgl2",
                  changed(changed("detail/hashes.glsl", "747796405u", "747796407u"), "octaves2d.glsl",
                          "HN_FN bool hn_next(", "HN_FN bolo hn_next(")));
  const Outcome& hash = story.outcome(kHash);
  EXPECT_EQ(hash.status, Status::fail);
  EXPECT_GT(hash.mismatches, 1u);
  ASSERT_FALSE(hash.examples.empty());
  EXPECT_NE(hash.examples[0].inputs.find("x="), std::string::npos) << hash.examples[0].inputs;
  EXPECT_NE(hash.examples[0].got, hash.examples[0].expected);
  EXPECT_NE(hash.message.find("first at"), std::string::npos) << hash.message;
  const Outcome& compiled = story.outcome(kCompiles);
  EXPECT_EQ(compiled.status, Status::fail);
  EXPECT_NE(compiled.message.find("glsl/hashnoise/octaves2d.glsl:"), std::string::npos) << compiled.message;
  EXPECT_EQ(story.outcome(kNoise).status, Status::pass);
  EXPECT_EQ(story.outcome(kRefused).status, Status::pass);
}

// Where the value of a setting begins in the last row of a golden file in which every setting has one.
std::size_t last_value(const std::string& text, const std::string& setting) {
  const auto settings = text.find("settings ");
  const auto named = text.find(" " + setting + ":", settings);
  auto group = std::ranges::count(text.substr(settings, named + 1 - settings), ' ');
  auto at = text.rfind('\n', text.rfind('\n', text.find(" = -")) - 1) + 1;
  for (; group > 0; --group) at = text.find(" = ", at) + 3;
  return at;
}

TEST(BrowserFault, AValueThatIsOffByMoreThanTheBoundFailsAndSoDoesARefusalWithoutItsWord) {
  const TemporaryFolder golden;
  std::filesystem::copy(HN_GOLDEN_DIRECTORY, golden.path(), std::filesystem::copy_options::recursive);
  std::string noise = read_file(golden.path() / "noise2d.perlin.golden").value();
  // Digits 3 to 15 are the fraction of the double, so this one changes it by 2^-9 to 2^-12.
  const auto at = last_value(noise, "lattice") + 5;
  noise[at] = noise[at] == '0' ? 'f' : '0';
  golden.write("noise2d.perlin.golden", noise);
  Story story;
  ASSERT_TRUE(run(story, kSome, "webgl2", changed("config.glsl", "HN_HASH_PARTIAL_JENKINS,", "X,"), golden.path()));
  EXPECT_EQ(story.outcome(kNoise).status, Status::fail);
  EXPECT_EQ(story.outcome(kNoise).mismatches, 1u);
  EXPECT_NE(story.outcome(kNoise).message.find(" within "), std::string::npos) << story.outcome(kNoise).message;
  EXPECT_EQ(story.outcome(kHash).status, Status::pass);
  EXPECT_EQ(story.outcome(kRefused).status, Status::fail) << story.outcome(kRefused).message;
  EXPECT_EQ(story.outcome(kCompiles).status, Status::pass);
}

// A library that is wrong in one variant of the shader only, recognised by the shader's own names.
TEST(BrowserFault, EachWayThatIsWrongFailsAndSoDoAWrongDigestAndARefusalThatIsNone) {
  constexpr std::pair<std::string_view, std::string_view> kWays[] = {
      {"CASE_VERTEX", "vertex.es300.golden"},
      {"CASE_VERTEX", "vertex.es300.as_fragment"},
      {"CASE_INLINED", "fragment.es300.inlined"},
      {"CASE_IN_LOOP", "fragment.es300.in_loop"},
      {"CASE_CONSTANT", "fragment.es300.folded"},
      {"CASE_CONSTANT_SEED", "fragment.es300.constant_seed"},
      {"CASE_UNIFORM_SEED", "fragment.es300.uniform_seed"}};
  std::string faults;
  std::vector<std::string> ids = {kNoise};
  for (const auto& [name, check] : kWays) {
    faults += fmt::format("#if defined({}) && !defined(FAULT)\n#define FAULT\n#endif\n", name);
    ids.push_back(fmt::format("noise2d.perlin.lattice.fast.{}", check));
  }
  faults += "#ifdef FAULT\n#define hn_perlin(call) (hn_perlin(call) + 0.001)\n#endif\n";
  ids.insert(ids.end(), {kHash, kRefused});
  const TemporaryFolder golden;
  std::filesystem::copy(HN_GOLDEN_DIRECTORY, golden.path(), std::filesystem::copy_options::recursive);
  std::string hash = read_file(golden.path() / "hash.vec2.golden").value();
  char& digit = hash[hash.find('\n', hash.find("\ndigest pcg ") + 1) - 1];
  digit = digit == '0' ? '1' : '0';
  golden.write("hash.vec2.golden", hash);
  SourceSet sources = changed("config.glsl", "#error HN_HASH must", "// #error HN_HASH must");
  const SourceFile& file = *sources.find("perlin2d.glsl");
  sources.add("perlin2d.glsl", file.text + "\n" + faults, file.path);
  Story story;
  ASSERT_TRUE(run(story, ids, "webgl2", sources, golden.path()));
  EXPECT_EQ(story.outcome(kNoise).status, Status::pass) << story.outcome(kNoise).message;
  EXPECT_EQ(story.outcome(kHash).status, Status::fail);
  EXPECT_NE(story.outcome(kHash).message.find("the digest of 16384 points"), std::string::npos);
  EXPECT_EQ(story.outcome(kRefused).status, Status::fail) << story.outcome(kRefused).message;
  for (const std::string& id : std::span(ids).subspan(1, std::size(kWays))) {
    EXPECT_EQ(story.outcome(id).status, Status::fail) << id << ": " << story.outcome(id).message;
    EXPECT_GT(story.outcome(id).mismatches, 0u) << id << ": " << story.outcome(id).message;
  }
}

TEST(BrowserFault, ANoiseWithoutItsPeriodFails) {
  SourceSet sources = SourceSet::embedded();
  const SourceFile& file = *sources.find("perlin2d.glsl");
  constexpr std::string_view kFault = "#define hn_perlin(place, seed) (hn_perlin(place, seed) + 0.00001 * p.x)";
  sources.add("perlin2d.glsl", fmt::format("{}\n{}\n", file.text, kFault), file.path);
  const std::vector<std::string> ids = {"noise2d.perlin_period.lattice.fast.fragment.es300.period"};
  Story story;
  ASSERT_TRUE(run(story, ids, "webgl2", sources));
  EXPECT_EQ(story.outcome(ids[0]).status, Status::fail) << story.outcome(ids[0]).message;
  EXPECT_GT(story.outcome(ids[0]).mismatches, 0u) << story.outcome(ids[0]).message;
}

// A bug's case fails if the specification fixes the value; else it warns. Both have the same source: the words from the
// points are changed.
TEST(BrowserFault, ABugThatIsThereFailsOrWarns) {
  SourceSet sources = SourceSet::embedded();
  sources.transform_with([](ShaderText& shader, const Profile&) -> Result<void> {
    constexpr std::string_view kRead = "result = evaluate(";
    if (const auto at = shader.text.find(kRead); at != std::string::npos) {
      shader.text.replace(at, kRead.size(), "result = uvec4(0x12345678u) + evaluate(");
    }
    return {};
  });
  std::vector<std::string> ids;
  std::size_t seen = 0;
  for (const Case& test : all_cases()) {
    if (!test.id.starts_with("bugs.") || !unsupported_in_browser(test).empty()) continue;
    if (seen++ % 5 == 0) ids.push_back(test.id);  // some of each kind; what is read is changed alike in all of them
  }
  Story story;
  ASSERT_TRUE(run(story, ids, "webgl2", sources));
  std::set<Status> statuses;
  for (const CaseResult& result : story.finished) {
    statuses.insert(result.outcome.status);
    const Status expected = result.id.ends_with(".defined") ? Status::fail : Status::warning;
    EXPECT_EQ(result.outcome.status, expected) << result.id << ": " << result.outcome.message;
    EXPECT_NE(result.outcome.message.find("Reported in: "), std::string::npos) << result.id;
  }
  EXPECT_EQ(statuses, (std::set{Status::fail, Status::warning}));
}

}  // namespace
}  // namespace hn
