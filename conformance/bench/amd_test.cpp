#include "bench/amd.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/temporary_folder.hpp"

namespace hn {
namespace {

using Shader = std::vector<std::uint32_t>;
using std::chrono::seconds;
using std::chrono::steady_clock;

const AmdSource kHere{.program = HN_AMD_PROGRAM};
const Shader kGarbage = {0x07230203, 0x00010000, 0, 8, 0, 0xDEADBEEF, 0x12345678};

Shader spirv_of(const std::string& body) {
  const std::string text =
      "#version 450\n"
      "layout(location = 0) in vec3 p;\n"
      "layout(location = 0) out vec4 color;\n"
      "layout(set = 0, binding = 3) uniform usampler2D words;\n"
      "layout(push_constant) uniform Block { vec4 value; } pushed;\n"
      "void main() {\n" +
      body + "}\n";
  const char* const pointer = text.c_str();
  const auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  Shader words;
  glslang::InitializeProcess();
  {
    glslang::TShader shader(EShLangFragment);
    shader.setStrings(&pointer, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    EXPECT_TRUE(shader.parse(GetDefaultResources(), 450, false, rules)) << shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    EXPECT_TRUE(program.link(rules)) << program.getInfoLog();
    glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), words);
  }
  glslang::FinalizeProcess();
  return words;
}

// Programs that behave as the child might, so that what the parent makes of it is seen without RADV.
class AmdChild : public testing::Test {
 protected:
  AmdChild() { folder_.write("radeon_icd.any.json", "{}"); }

  AmdSource source(const std::string& script) {
    folder_.write("child", "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder_.path() / "child", std::filesystem::perms::owner_all);
    return {folder_.path() / "child", {folder_.path()}, std::chrono::milliseconds(300)};
  }

  TemporaryFolder folder_;
};

const std::vector<Shader> kThree = {{1}, {2}, {3}};

// Answers with the shader's only word as every statistic. Before shader 2, it does something else.
std::string script_with(const std::string& before_two) {
  return "echo '{\"ready\": true}' >&3\n"
         "for word in $(tr -cs 0-9 ' ' <\"$2\"); do\n"
         "  if [ $word = 2 ]; then " +
         before_two +
         "; fi\n"
         "  echo '{\"statistics\": {\"instructions\": W, \"inverse_throughput\": W, \"latency\": W, \"vgprs\": W,"
         " \"code_size\": W}}' | sed s/W/$word/g >&3\n"
         "done\n";
}

void expect_only_two_fails(const AmdSource& source, const std::string& why) {
  const auto counts = amd_counts("navi21", kThree, source);
  ASSERT_TRUE(counts) << counts.error().text();
  ASSERT_EQ(counts->size(), 3u);
  EXPECT_EQ(counts->at(0).value().instructions, 1);
  ASSERT_FALSE(counts->at(1));
  EXPECT_NE(counts->at(1).error().text().find(why), std::string::npos) << counts->at(1).error().text();
  EXPECT_EQ(counts->at(2).value().instructions, 3);
}

TEST_F(AmdChild, ThatCrashesCostsOneCount) {
  expect_only_two_fails(source(script_with("echo told before >&2; kill -SEGV $$")), "told before");
  expect_only_two_fails(source(script_with("kill -SEGV $$")), "Segmentation fault");
}

TEST_F(AmdChild, ThatEndsEarlyCostsOneCount) { expect_only_two_fails(source(script_with("exit 7")), "status 7"); }

TEST_F(AmdChild, ThatHangsOnAShaderIsKilled) {
  const auto before = steady_clock::now();
  expect_only_two_fails(source(script_with("exec sleep 60")), "was killed");
  EXPECT_LT(steady_clock::now() - before, seconds(30));
}

TEST_F(AmdChild, ThatLeavesHalfALineCostsOneCount) {
  expect_only_two_fails(source(script_with("printf '{\"statistics\": {\"inst' >&3; exit 0")), "status 0");
}

TEST_F(AmdChild, ThatRefusesAShaderGoesOn) {
  expect_only_two_fails(source(script_with("echo '{\"error\": \"too hard\"}' >&3; continue")), "too hard");
}

TEST_F(AmdChild, ThatNeverAnswersIsNoSource) {
  const auto before = steady_clock::now();
  const auto counts = amd_counts("navi21", kThree, source("echo starting up; exec sleep 60\n"));
  EXPECT_LT(steady_clock::now() - before, seconds(30));
  ASSERT_FALSE(counts);
  EXPECT_NE(counts.error().message.find("was killed"), std::string::npos) << counts.error().text();
  EXPECT_EQ(counts.error().log, "starting up\n");
}

TEST_F(AmdChild, ThatSaysWhyThereIsNoSourceIsBelieved) {
  const auto counts = amd_counts("navi21", kThree, source("echo '{\"error\": \"no libvulkan\"}' >&3\n"));
  ASSERT_FALSE(counts);
  EXPECT_EQ(counts.error().message, "no libvulkan");
}

TEST_F(AmdChild, ThatDoesNotStartAgainKeepsTheCountsBefore) {
  const auto counts =
      amd_counts("navi21", kThree, source("[ -e $0.once ] && exit 5; touch $0.once\n" + script_with("kill -SEGV $$")));
  ASSERT_TRUE(counts) << counts.error().text();
  ASSERT_EQ(counts->size(), 3u);
  EXPECT_TRUE(counts->at(0));
  EXPECT_FALSE(counts->at(1));
  ASSERT_FALSE(counts->at(2));
  EXPECT_NE(counts->at(2).error().message.find("status 5"), std::string::npos) << counts->at(2).error().text();
}

TEST_F(AmdChild, ThatIsNotThereIsNoSource) {
  AmdSource none = source("");
  none.program = folder_.path() / "none";
  const auto counts = amd_counts("navi21", kThree, none);
  ASSERT_FALSE(counts);
  EXPECT_NE(counts.error().message.find("cannot start"), std::string::npos) << counts.error().text();
}

TEST_F(AmdChild, SeesTheFamilyAndNoOtherSettingsOfRadv) {
  ::setenv("RADV_PERFTEST", "pswave32", 1);
  const auto counts = amd_counts("vega10", kThree, source("env; exit 1\n"));
  ::unsetenv("RADV_PERFTEST");
  ASSERT_FALSE(counts);
  EXPECT_NE(counts.error().log.find("RADV_FORCE_FAMILY=vega10\n"), std::string::npos);
  EXPECT_NE(counts.error().log.find("/radeon_icd.any.json\n"), std::string::npos);
  EXPECT_EQ(counts.error().log.find("RADV_PERFTEST"), std::string::npos);
}

TEST(Amd, WithoutADriverNamesWhatIsMissing) {
  const TemporaryFolder empty;
  const auto counts = amd_counts("navi21", kThree, {.program = HN_AMD_PROGRAM, .icd_directories = {empty.path()}});
  ASSERT_FALSE(counts);
  EXPECT_NE(counts.error().message.find("radeon_icd"), std::string::npos);
  EXPECT_NE(counts.error().message.find(empty.path().string()), std::string::npos);
}

// What needs RADV. It is skipped where that is not installed, but not where it is and does not work.
class AmdFamily : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    const std::vector<Shader> trial = {spirv_of("color = p.xyzx;")};
    const auto counts = amd_counts(GetParam(), trial, kHere);
    if (counts) return;
    if (counts.error().message.find("is not here") != std::string::npos) GTEST_SKIP() << counts.error().text();
    FAIL() << counts.error().text();
  }
};

TEST_P(AmdFamily, CountsGrowWithTheShaderAndRepeat) {
  const std::vector<Shader> shaders = {
      spirv_of("color = vec4(p, 1.0);"), spirv_of("color = vec4(sin(p) * sqrt(p.zyx) + exp2(p.yzx), p.x / p.y);"),
      spirv_of("color = vec4(p, 1.0);"), spirv_of("color = vec4(texture(words, p.xy)) + pushed.value;")};
  const auto counts = amd_counts(GetParam(), shaders, kHere);
  ASSERT_TRUE(counts) << counts.error().text();
  ASSERT_EQ(counts->size(), shaders.size());
  for (const auto& count : *counts) {
    ASSERT_TRUE(count) << count.error().text();
    EXPECT_GT(count->instructions, 0);
    EXPECT_GT(count->inverse_throughput, 0);
    EXPECT_GT(count->latency, 0);
    EXPECT_GT(count->vgprs, 0);
    EXPECT_GE(count->code_size, 4 * count->instructions);  // no instruction has less than 4 bytes
  }
  EXPECT_GT(counts->at(1)->instructions, counts->at(0)->instructions);
  EXPECT_GT(counts->at(1)->code_size, counts->at(0)->code_size);
  EXPECT_EQ(*counts->at(0), *counts->at(2));
}

TEST_P(AmdFamily, GarbageHasAnErrorAndTheNextHasItsCounts) {
  const Shader good = spirv_of("color = vec4(p, 1.0);");
  const auto counts = amd_counts(GetParam(), std::vector<Shader>{good, kGarbage, {}, good}, kHere);
  ASSERT_TRUE(counts) << counts.error().text();
  ASSERT_EQ(counts->size(), 4u);
  ASSERT_TRUE(counts->at(0)) << counts->at(0).error().text();
  EXPECT_FALSE(counts->at(1));
  EXPECT_FALSE(counts->at(2));
  ASSERT_TRUE(counts->at(3)) << counts->at(3).error().text();
  EXPECT_EQ(*counts->at(0), *counts->at(3));
}

TEST_P(AmdFamily, OfAnUnknownNameIsNoSource) {
  const auto counts = amd_counts("navi999", kThree, kHere);
  ASSERT_FALSE(counts);
  EXPECT_NE(counts.error().text().find("navi999"), std::string::npos) << counts.error().text();
}

INSTANTIATE_TEST_SUITE_P(Families, AmdFamily, testing::ValuesIn(amd_families()),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace hn
