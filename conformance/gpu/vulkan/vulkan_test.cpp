#include <fmt/format.h>

#include <algorithm>

#include "gpu/evaluator.hpp"
#include "gpu/spirv.hpp"
#include "gpu/vulkan/vulkan_fixture.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::string_view kBuffers = R"(layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Results { uvec4 results[]; };
layout(std430, set = 0, binding = 1) readonly buffer Points { uvec4 points[]; };
layout(std430, set = 0, binding = 2) readonly buffer Uniforms { int trips; uint variant_seed; };
)";

class Vulkan : public OnVulkan<> {
 protected:
  void SetUp() override {
    OnVulkan::SetUp();
    if (IsSkipped()) return;
    auto evaluator = create_vulkan_evaluator(number_, compiler_);
    ASSERT_TRUE(evaluator) << evaluator.error().text();
    evaluator_ = std::move(*evaluator);
  }

  // A shader's main, in which i is the number of the point.
  Result<std::unique_ptr<Evaluable>> build(std::string_view body) {
    return build_whole(fmt::format("{}void main() {{\n  uint i = gl_GlobalInvocationID.x;\n{}}}\n", kBuffers, body));
  }

  Result<std::unique_ptr<Evaluable>> build_whole(std::string_view text, std::string_view profile = "vulkan") {
    const Evaluation evaluation{
        find_function("hash.word"), default_configuration(), profile_named(profile), {}, Stage::compute};
    return evaluator_->build(sources_, evaluation, text);
  }

  Words evaluate(Evaluable& evaluable, const Words& inputs) {
    const auto words = evaluable.evaluate(inputs);
    EXPECT_TRUE(words) << words.error().text();
    return words.value_or(Words{});
  }

  const ReferenceCompiler compiler_;
  const SourceSet sources_ = SourceSet::embedded();
  std::unique_ptr<Evaluator> evaluator_;
};

Words many_words(std::size_t points) {
  Words words(points * kInputWords);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(i) * 0x9E3779B9u + 1;
  return words;
}

TEST_F(Vulkan, WordsTravelUnchanged) {
  const auto sum = build(
      "  results[i] = points[4 * i] + points[4 * i + 1].wzyx + 3u * points[4 * i + 2] + 5u * points[4 * i + 3];\n");
  ASSERT_TRUE(sum) << sum.error().text();
  for (const std::size_t points : {std::size_t{2500}, std::size_t{65}, std::size_t{1}, std::size_t{10000}}) {
    const Words inputs = many_words(points);
    const Words outputs = evaluate(**sum, inputs);
    ASSERT_EQ(outputs.size(), points * kOutputWords);
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t word = 0; word < 4; ++word) {
        const std::uint32_t* const in = &inputs[i * kInputWords];
        ASSERT_EQ(outputs[i * 4 + word], in[word] + in[7 - word] + 3u * in[8 + word] + 5u * in[12 + word]);
      }
    }
  }
}

TEST_F(Vulkan, AShaderThatDoesNothingCannotPassForTheOneBefore) {
  const auto one = build("  results[i] = uvec4(1u);\n");
  const auto none = build("  if (i > 1000u) results[i] = uvec4(1u);\n");
  ASSERT_TRUE(one && none);
  EXPECT_EQ(evaluate(**one, many_words(1)), Words(kOutputWords, 1u));
  EXPECT_EQ(evaluate(**none, many_words(1)), Words(kOutputWords, 0xDEADBEEFu));
}

// They could send what runs beside the points into a loop of 2^32 turns.
TEST_F(Vulkan, NoWordsOfEarlierPointsLieBesideThePoints) {
  const auto beside = build("  results[i] = points[4 * (i ^ 1u)];\n");
  ASSERT_TRUE(beside);
  const Words before = evaluate(**beside, many_words(128));
  EXPECT_NE(before[64 * kOutputWords], 0u);
  const Words words = evaluate(**beside, many_words(65));
  EXPECT_EQ(words[64 * kOutputWords], 0u);
}

TEST_F(Vulkan, UniformsHoldWhatTheyShould) {
  const auto built = build("  results[i] = uvec4(uint(trips), variant_seed, 0u, 0u);\n");
  ASSERT_TRUE(built);
  Evaluable& evaluable = **built;
  EXPECT_EQ(evaluate(evaluable, many_words(1)), (Words{kLoopTrips, kVariantSeed, 0, 0}));
  evaluable.uniforms = {7, 9};
  EXPECT_EQ(evaluate(evaluable, many_words(1)), (Words{7, 9, 0, 0}));
}

TEST_F(Vulkan, AnErrorInAShaderNamesItsFile) {
  const auto broken = build_whole("#define hn_i_scramble 1\n#include \"hash.glsl\"\nvoid main() {}\n");
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().log.find("glsl/hashnoise/detail/word.glsl:"), std::string::npos) << broken.error().log;
  const auto hlsl = build_whole("#include \"begin.hlsl\"\n#define hn_i_scramble 1\n#include \"hash.glsl\"\n", "hlsl60");
  ASSERT_FALSE(hlsl);
  EXPECT_NE(hlsl.error().log.find("glsl/hashnoise/detail/word.glsl:"), std::string::npos) << hlsl.error().log;
}

TEST_F(Vulkan, SaysWhatItIsAndWhatItDoesNotDo) {
  EXPECT_NE(evaluator_->info().renderer, "");
  EXPECT_NE(evaluator_->info().gl_version.find("Vulkan 1."), std::string::npos) << evaluator_->info().gl_version;
  EXPECT_EQ(evaluator_->unsupported(profile_named("vulkan"), Stage::compute), "");
  EXPECT_EQ(evaluator_->unsupported(profile_named("hlsl60"), Stage::compute), "");
  EXPECT_NE(evaluator_->unsupported(profile_named("vulkan"), Stage::fragment), "");
  EXPECT_EQ(evaluator_->unsupported(profile_named("gl330"), Stage::compute),
            "this context does not compile desktop GLSL");
  EXPECT_FALSE(evaluator_->is_lost());
  EXPECT_EQ(evaluator_->context(), nullptr);
}

TEST_F(Vulkan, WhatIsInvalidIsAnErrorOfTheValidationLayers) {
  const auto device = open_vulkan_device(number_);
  ASSERT_TRUE(device) << device.error().text();
  if (!(*device)->info().validated) GTEST_SKIP() << "the validation layers are not here";
  const auto text = expand(sources_, profile_named("vulkan"),
                           "layout(local_size_x = 1) in;\nlayout(std430, set = 0, binding = 7) buffer Far { uint word; "
                           "};\nvoid main() { word = 1u; }\n");
  const auto words = compiler_.spirv(*text, profile_named("vulkan"), Stage::compute);
  ASSERT_TRUE(words && validate_spirv(*words));
  const auto kernel = (*device)->build(*words);  // no buffer is bound there
  ASSERT_FALSE(kernel);
  EXPECT_EQ(kernel.error().message, "the validation layers complain");
  EXPECT_NE(kernel.error().log.find("VUID-"), std::string::npos) << kernel.error().log;
}

TEST_F(Vulkan, DevicesKeepTheirNumbers) {
  for (int number = 0; number <= number_; ++number) {
    const auto first = open_vulkan_device(number);
    const auto second = open_vulkan_device(number);
    ASSERT_TRUE(first && second);
    EXPECT_EQ((*first)->info().name, (*second)->info().name);
  }
  const auto none = open_vulkan_device(number_ + 1);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message,
            fmt::format("there is no Vulkan device {}; this machine has {}", number_ + 1, number_ + 1));
}

TEST_F(Vulkan, ADxcThatIsNamedAndNotHereHasAReason) {
  const char* const given = std::getenv("HN_DXC");
  const std::string before = given ? given : "";
  setenv("HN_DXC", "/nowhere/dxc", 1);
  const auto evaluator = create_vulkan_evaluator(number_, compiler_);
  ASSERT_TRUE(evaluator) << evaluator.error().text();
  const std::string reason = (*evaluator)->unsupported(profile_named("hlsl60"), Stage::compute);
  given ? setenv("HN_DXC", before.c_str(), 1) : unsetenv("HN_DXC");
  EXPECT_NE(reason.find("/nowhere/dxc cannot be run"), std::string::npos) << reason;
}

// Nothing here needs a device.

TEST(VulkanEnvironment, NamesTheDriverOfABrowserIfItIsHere) {
  const auto names = [](const std::vector<std::filesystem::path>& files) {
    std::string text;
    for (const auto& [name, value] : vulkan_environment(files)) {
      if (name == "VK_ADD_DRIVER_FILES") text += value;
    }
    return text;
  };
  unsetenv("VK_ADD_DRIVER_FILES");
  EXPECT_EQ(names({"/nowhere/a.json"}), "");
  EXPECT_EQ(names({"/nowhere/a.json", HN_GOLDEN_DIRECTORY, "/"}), HN_GOLDEN_DIRECTORY);
  setenv("VK_ADD_DRIVER_FILES", "mine.json", 1);
  EXPECT_EQ(names({"/"}), "mine.json:/");
  unsetenv("VK_ADD_DRIVER_FILES");
}

TEST(Spirv, ADecorationThatIsRepeatedGoes) {
  const ReferenceCompiler compiler;
  const auto text =
      expand(SourceSet::embedded(), profile_named("vulkan"), fmt::format("{}void main() {{}}\n", kBuffers));
  const auto words = compiler.spirv(*text, profile_named("vulkan"), Stage::compute);
  ASSERT_TRUE(words);
  EXPECT_EQ(without_repeated_decorations(*words), *words);
  // The first decoration of the module once more.
  constexpr std::uint32_t kDecorate = 71;
  std::size_t at = 5;
  while (((*words)[at] & 0xFFFFu) != kDecorate) at += (*words)[at] >> 16;
  Words repeated = *words;
  const auto begin = words->begin() + static_cast<std::ptrdiff_t>(at);
  repeated.insert(repeated.begin() + static_cast<std::ptrdiff_t>(at), begin, begin + ((*words)[at] >> 16));
  EXPECT_EQ(without_repeated_decorations(repeated), *words);
}

}  // namespace
}  // namespace hn
