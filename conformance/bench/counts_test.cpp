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

TEST_F(SpirvTools, AgreeOnTheNumberOfInstructions) {
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
  }
}

TEST_F(SpirvTools, OptimiseTheSame) {
  for (const Subject& subject : kSubjects) {
    const Words words = compile(subject);
    const auto optimised = optimise_spirv(words);
    ASSERT_TRUE(optimised) << optimised.error().text();
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

// --- NVIDIA's assembly ---

using std::string_literals::operator""s;

const std::string kVertexText =
    "!!NVvp5.0\n"
    "OPTION NV_internal;\n"
    "ATTRIB vertex_attrib[] = { vertex.attrib[0..0] };\n"
    "MOV.F result.position, vertex.attrib[0];\n"
    "ADD.F result.attrib[0], vertex.attrib[0], {1, 0, 0, 0}.x;\n"
    "END\n"s;

// Every kind of declaration of the grammar, and of instruction, label, comment and end of a line.
const std::string kFragmentText =
    "!!NVfp5.0\n"
    "OPTION NV_internal;\n"
    "OPTION NV_gpu_program_fp64;\n"
    "# cgc version 3.4.0001, build date Jan  1 2015; a comment\n"
    "#semantic iterations; ADD.F R0, R0, R0;\n"
    "#const c[0] = 1 0 0.5 2;\n"
    "# END\n"
    "PARAM c[2] = { program.local[0..1] };\n"
    "PARAM one = {1, 1, 1, 1};\n"
    "LONG PARAM wide = program.local[2];\n"
    "CBUFFER block[] = { program.buffer[0] };\n"
    "BUFFER4 four[] = { program.buffer[1] };\n"
    "BUFFER single = program.buffer[2][0];\n"
    "ATTRIB fragment_attrib[] = { fragment.attrib[0..1] };\n"
    "FLAT ATTRIB flat_attrib = fragment.attrib[2];\n"
    "CENTROID NOPERSPECTIVE ATTRIB p = fragment.attrib[3];\n"
    "SAMPLE ATTRIB s = fragment.attrib[4];\n"
    "OUTPUT result_color0 = result.color;\n"
    "UINT OUTPUT result_color1 = result.color[1];\n"
    "TEXTURE texture0 = texture[0];\n"
    "TEXTURE textures[2] = { texture[1..2] };\n"
    "IMAGE image0 = image[0];\n"
    "STORAGE store[] = { program.storage[0] };\n"
    "COUNTER counts = program.counter[0];\n"
    "TEMP R0, R1;\n"
    "TEMP\tRC;\n"
    "INT TEMP I0;\n"
    "UINT TEMP U0;\n"
    "FLOAT TEMP F0;\n"
    "SHORT FLOAT TEMP H0;\n"
    "LONG TEMP D0;\n"
    "ALIAS also = R1;\n"
    "main:\n"
    "MOV.F R0, fragment.attrib[0];\n"                 // 1
    "MOV.S I0.x, {0, 0, 0, 0};\n"                     // 2
    "REP.S {4, 0, 0, 0}.x;\n"                         // 3
    "SGE.S.CC RC.x, I0, c[0];\n"                      // 4
    "BRK   (NE.x);\n"                                 // 5
    "  IF    NE.x;   # the condition; of a branch\n"  // 6
    "\tTEX.F R1, R0, texture0, 2D;\r\n"               // 7
    "ELSE;\n"                                         // 8
    "    MAD.F R1.xyz, R0, c[0].x,\n"                 // 9, over two lines
    "          {1, 2, 3, 0};\n"
    "ENDIF;\n"                              // 10
    "INT_TO_FLOAT: I2F.F R0, I0;\n"         // 11, behind a label like a declaration
    "ADD.S I0.x, I0, {1, 0, 0, 0};\n"       // 12
    "ENDREP;\n"                             // 13
    "CAL BB1; TRUNC.S I0, R0; DDX R1, R0;"  // 14, 15, 16 on a line
    "\n"
    "KIL LT.x;\n"  // 17
    "ENDING_of_main: BB0:\n"
    "MOV.F result_color0, R1;\n"  // 18
    "RET;\n"                      // 19
    "BB1:\n"
    "PK64.U D0.x, U0;\n"  // 20
    "RET;\n"              // 21
    "BB2:\n"
    "END\n"
    "# 21 instructions, 2 R-regs, 0 D-regs; that much\n"s;
constexpr std::int64_t kFragmentCount = 21;

TEST(CountNvidia, CountsInstructionsAndNothingElse) { EXPECT_EQ(count_nvidia(kFragmentText), kFragmentCount); }

TEST(CountNvidia, FindsTheTextInABinary) {
  const std::string before = "\x01\0;END;\n\xFF!!NV\0\x7F"s;
  const std::string after = "\0\x02;ADD.F;\xFE\nMUL;\nEND\n;;\0"s;
  for (const std::string& binary :
       {kFragmentText + after, before + kFragmentText, before + kFragmentText + after,
        before + kVertexText + after + kFragmentText + after, before + kFragmentText + after + kVertexText}) {
    EXPECT_EQ(count_nvidia(binary), kFragmentCount);
  }
}

TEST(CountNvidia, OfOneMoreInstructionIsOneMore) {
  const std::string end = "END\n";
  const auto at = kFragmentText.rfind("\nEND\n") + 1;
  const auto with = [&](const std::string& line) {
    return count_nvidia(kFragmentText.substr(0, at) + line + kFragmentText.substr(at));
  };
  EXPECT_EQ(with("LG2.F R0.x, R0.x;\n"), kFragmentCount + 1);
  EXPECT_EQ(with("TEMPER R0;\n"), kFragmentCount + 1);  // begins like a declaration
  EXPECT_EQ(with("TEMP R9;\n"), kFragmentCount);
  EXPECT_EQ(with("# LG2.F R0.x, R0.x;\n"), kFragmentCount);
  EXPECT_EQ(with("label:\n"), kFragmentCount);
}

TEST(CountNvidia, OfAnEmptyProgramIsZero) {
  EXPECT_EQ(count_nvidia("!!NVfp5.0\nEND\n"), 0);
  EXPECT_EQ(count_nvidia("!!NVfp4.0\nTEMP R0;\nEND"), 0);
}

TEST(CountNvidia, WithoutATextOrItsEndIsNone) {
  const std::string whole = kFragmentText.substr(0, kFragmentText.rfind("\nEND\n") + 1);
  for (const std::string& binary :
       {""s, "\x01\x02\0\x03"s, kVertexText, "NVfp5.0\nADD.F R0, R0, R0;\nEND\n"s, "!!NVfp5.0"s,
        "!!NVfp5.0\nADD.F R0, R0, R0;\nEN"s, whole, whole + "ENDIF;\n", whole + "# END\n", whole + "END_of_it:\n",
        // Its end is missing, and another text has one.
        whole + "\0"s + kVertexText}) {
    EXPECT_EQ(count_nvidia(binary), std::nullopt) << binary.substr(0, 40);
  }
}

}  // namespace
}  // namespace hn
