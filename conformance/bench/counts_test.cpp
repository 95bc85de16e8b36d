// The counts, held against other tools and against programs that were counted by hand.
#include "bench/counts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <sstream>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/process.hpp"
#include "bench/subject.hpp"
#include "gpu/spirv.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

std::int64_t count_disassembly(const std::string& text) {
  std::istringstream lines(text);
  std::int64_t count = 0;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    // "OpStore %a %b" or "%c = OpLoad %float %d"
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word.starts_with('%')) words >> word >> word;
    if (!word.starts_with("Op")) continue;
    if (word == "OpFunctionEnd") inside = false;
    if (inside && word != "OpLabel" && word != "OpFunctionParameter") ++count;
    if (word == "OpFunction") inside = true;
  }
  return count;
}

class SpirvTools : public testing::Test {
 protected:
  Words compile(const Subject& subject) {
    const auto text =
        expand(with_comparison_shaders(SourceSet::embedded()), profile_named("vulkan"), quad_shader(subject));
    EXPECT_TRUE(text) << text.error().text();
    const auto words = reference_.spirv(*text, Stage::fragment);
    EXPECT_TRUE(words) << words.error().text();
    return words.value_or(Words());
  }

  std::string file_of(const Words& words) {
    const auto path = folder_.path() / "shader.spv";
    const auto written = write_file(path, bytes_of(std::span(words)));
    EXPECT_TRUE(written) << written.error().text();
    return path.string();
  }

  const ReferenceCompiler reference_;
  const TemporaryFolder folder_;
};

// With branches, loops and calls of other functions.
const std::array kSubjects = {
    empty_subject(2),
    float_subject(3),
    integer_subject(2),
    Subject{"hash", 2, "#include \"hash.glsl\"\n", "hn_hash(floatBitsToUint(p))"},
    Subject{"noise", 3, "#include \"noise3d.glsl\"\n", "hn_perlin(p)"},
    Subject{"sum", 2, "#include \"fbm2d.glsl\"\n", "hn_fbm(p, int(p.x), 2.0, 0.5)"},
};

TEST_F(SpirvTools, OptimiseAndCountTheSame) {
  for (const Subject& subject : kSubjects) {
    const Words words = compile(subject);
    const auto optimised = optimise_spirv(words);
    ASSERT_TRUE(optimised) << optimised.error().text();
    for (const Words& some : {words, *optimised}) {
      const std::string text = output_of("spirv-dis", {"--no-color", file_of(some)}).value_or("");
      ASSERT_FALSE(text.empty()) << "spirv-dis, of the package spirv-tools, fails";
      EXPECT_EQ(count_spirv(some), count_disassembly(text)) << subject.id;
      EXPECT_GT(count_spirv(some), 0) << subject.id;
    }
    EXPECT_LE(count_spirv(*optimised), count_spirv(words)) << subject.id;
    const std::string bytes =
        output_of("spirv-opt", {"-O", "--target-env=vulkan1.0", file_of(words), "-o", "-"}).value_or("");
    ASSERT_EQ(bytes.size(), optimised->size() * sizeof(std::uint32_t)) << subject.id;
    EXPECT_EQ(std::memcmp(bytes.data(), optimised->data(), bytes.size()), 0) << subject.id;
  }
}

// Each line of it is one that a count could miss, or count in vain.
TEST_F(SpirvTools, CountWhatFunctionsDo) {
  folder_.write("shader.spvasm",
                "OpCapability Shader\n"
                "OpMemoryModel Logical GLSL450\n"
                "OpEntryPoint Fragment %main \"main\"\n"
                "OpExecutionMode %main OriginUpperLeft\n"
                "%void = OpTypeVoid\n"
                "%float = OpTypeFloat 32\n"
                "%procedure = OpTypeFunction %void\n"
                "%function = OpTypeFunction %float %float\n"
                "%one = OpConstant %float 1\n"
                "%half = OpFunction %float None %function\n"
                "%x = OpFunctionParameter %float\n"
                "%a = OpLabel\n"
                "%y = OpFAdd %float %x %one\n"  // 1
                "OpReturnValue %y\n"            // 2
                "OpFunctionEnd\n"
                "%main = OpFunction %void None %procedure\n"
                "%b = OpLabel\n"
                "%z = OpFunctionCall %float %half %one\n"  // 3
                "OpBranch %c\n"                            // 4
                "%c = OpLabel\n"
                "OpReturn\n"  // 5
                "OpFunctionEnd\n");
  const auto path = (folder_.path() / "shader.spvasm").string();
  const std::string bytes = output_of("spirv-as", {"--target-env", "spv1.0", path, "-o", "-"}).value_or("");
  ASSERT_FALSE(bytes.empty());
  Words words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  EXPECT_EQ(count_spirv(words), 5);
}

TEST(CountSpirv, OfWordsThatAreNoneIsNothing) {
  EXPECT_EQ(count_spirv({}), 0);
  const Words some[] = {{0x07230203u},
                        {0x07230203u, 0x00010000u, 0u, 1u, 0u},
                        {0x07230203u, 0x00010000u, 0u, 1u, 0u, 0u, 0u},
                        {1u, 2u, 3u, 4u, 5u, 0xFFFFFFFFu, 7u},
                        Words(100, 0xDEADBEEFu),
                        Words(100, 0u)};
  for (const Words& words : some) {
    EXPECT_EQ(count_spirv(words), 0);
    EXPECT_FALSE(optimise_spirv(words));
  }
  EXPECT_FALSE(optimise_spirv({}));
}

}  // namespace
}  // namespace hn
