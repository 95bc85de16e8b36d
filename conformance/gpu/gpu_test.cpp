// The parts that need a context, on OSMesa.
#include "gpu/gpu.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/osmesa_fixture.hpp"
#include "gpu/translated_fixture.hpp"

namespace hn {
namespace {

class Gpu : public OnOsmesa<> {
 protected:
  Result<Program> build(std::string_view fragment) {
    const Profile& profile = profile_named("gl330");
    const auto vertex_text = expand(sources_, profile, vertex_shader());
    const auto fragment_text = expand(sources_, profile, fragment);
    if (!fragment_text) return tl::unexpected(fragment_text.error());
    return Program::build(*context_, *vertex_text, *fragment_text);
  }

  SourceSet sources_ = SourceSet::embedded();
};

constexpr std::string_view kTextures =
    "uniform usampler2D input_a;\nuniform usampler2D input_b;\nuniform usampler2D input_c;\n"
    "uniform usampler2D input_d;\n";
const std::string kInputs = std::string(kTextures) + "out uvec4 result;\n";

// 2500 points: more than a row of the texture, and no whole number of rows or groups.
constexpr std::size_t kSeveralRows = 2500;
constexpr std::string_view kAt = "ivec2 at = ivec2(index % 1024, index / 1024);\n";
// Every word counts.
constexpr std::string_view kSum =
    "texelFetch(input_a, at, 0) + texelFetch(input_b, at, 0).wzyx + 3u * texelFetch(input_c, at, 0) + 5u * "
    "texelFetch(input_d, at, 0);\n";
constexpr std::string_view kStorage = "layout(std430, binding = 0) buffer Results { uvec4 results[]; };\n";

void expect_words_unchanged(const Context& context, const Result<Program>& program) {
  ASSERT_TRUE(program) << program.error().text();
  std::vector<std::uint32_t> inputs(kSeveralRows * kInputWords);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = static_cast<std::uint32_t>(i) * 0x9E3779B9u;
  GridRenderer grid(context);
  const auto outputs = grid.evaluate(*program, inputs);
  ASSERT_TRUE(outputs) << outputs.error().text();
  ASSERT_EQ(outputs->size(), kSeveralRows * kOutputWords);
  for (std::size_t i = 0; i < kSeveralRows; ++i) {
    for (std::size_t word = 0; word < 4; ++word) {
      const std::uint32_t* const in = &inputs[i * kInputWords];
      ASSERT_EQ((*outputs)[i * 4 + word], in[word] + in[7 - word] + 3u * in[8 + word] + 5u * in[12 + word]);
    }
  }
}

TEST_F(Gpu, BesideTheGridThereAreZeros) {
  // An older grid filled its rows.
  const auto program = build(fmt::format(
      "{}void main() {{ ivec2 at = ivec2(gl_FragCoord.xy) + ivec2(1000, 3);\nresult = {} }}\n", kInputs, kSum));
  ASSERT_TRUE(program) << program.error().text();
  GridRenderer grid(*context_);
  ASSERT_TRUE(grid.evaluate(*program, std::vector<std::uint32_t>(4 * kGridSide * kInputWords, 7u)));
  const auto outputs = grid.evaluate(*program, std::vector<std::uint32_t>(5 * kInputWords, 7u));
  ASSERT_TRUE(outputs) << outputs.error().text();
  for (const std::uint32_t word : *outputs) EXPECT_EQ(word, 0u);
}

TEST_F(Gpu, WordsTravelUnchanged) {
  const auto program =
      build(fmt::format("{}void main() {{ ivec2 at = ivec2(gl_FragCoord.xy);\nresult = {} }}\n", kInputs, kSum));
  expect_words_unchanged(*context_, program);
}

TEST_F(Gpu, PixelsBesideTheGridSeeNoOldWords) {
  // A derivative shows the values of the neighbours in the block.
  const auto program = build(kInputs +
                             "void main() { ivec2 at = ivec2(gl_FragCoord.xy);\n"
                             "float x = float(texelFetch(input_a, at, 0).x + texelFetch(input_b, at, 0).x);\n"
                             "result = uvec4(uint(abs(dFdx(x))), uint(abs(dFdy(x))), 0u, 0u); }\n");
  ASSERT_TRUE(program) << program.error().text();
  GridRenderer grid(*context_);
  ASSERT_TRUE(grid.evaluate(*program, std::vector<std::uint32_t>(4096 * kInputWords, 1000u)));
  const auto outputs = grid.evaluate(*program, std::vector<std::uint32_t>(kInputWords, 7u));
  ASSERT_TRUE(outputs) << outputs.error().text();
  EXPECT_EQ((*outputs)[0], 14u);
  EXPECT_EQ((*outputs)[1], 14u);
}

TEST_F(Gpu, AShaderThatWritesNothingLeavesNoOldResult) {
  const std::vector<std::uint32_t> inputs(4 * kInputWords);
  GridRenderer grid(*context_);
  const auto right = build(kInputs + "void main() { result = uvec4(7u); }\n");
  EXPECT_EQ(grid.evaluate(*right, inputs)->front(), 7u);
  const auto silent = build(kInputs + "void main() { discard; }\n");
  EXPECT_EQ(grid.evaluate(*silent, inputs)->front(), 0xDEADBEEFu);
}

TEST_F(Gpu, AProgramThatReadsNoInputIsNotTheOneBefore) {
  const std::vector<std::uint32_t> inputs(4 * kInputWords);
  GridRenderer grid(*context_);
  const auto first = build(kInputs + "void main() { result = uvec4(7u); }\n");
  const auto second = build(kInputs + "void main() { result = uvec4(8u); }\n");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(grid.evaluate(*first, inputs)->front(), 7u);
    EXPECT_EQ(grid.evaluate(*second, inputs)->front(), 8u);
  }
}

TEST_F(Gpu, WordsTravelUnchangedThroughVertices) {
  const Profile& profile = profile_named("gl330");
  const auto vertex =
      expand(sources_, profile,
             fmt::format("{}uniform int row;\nvoid main() {{ ivec2 at = ivec2(gl_VertexID, row);\nresult = {}}}\n",
                         kInputs, kSum));
  const auto idle = expand(sources_, profile, idle_fragment_shader());
  expect_words_unchanged(*context_, Program::build(*context_, *vertex, *idle, Stage::vertex));
}

TEST_F(Gpu, WordsTravelUnchangedThroughInvocations) {
  const auto compute =
      expand(sources_, profile_named("gl430"),
             fmt::format("layout(local_size_x = 64) in;\n{}{}"
                         "void main() {{ int index = int(gl_GlobalInvocationID.x);\n{}results[index] = {}}}\n",
                         kStorage, kTextures, kAt, kSum));
  expect_words_unchanged(*context_, Program::build_compute(*context_, *compute));
}

TEST_F(Gpu, InvocationsThatWriteNothingLeaveNoOldResult) {
  const std::vector<std::uint32_t> inputs(4 * kInputWords);
  const auto build_compute = [&](std::string_view main) {
    const auto text =
        expand(sources_, profile_named("gl430"), fmt::format("layout(local_size_x = 64) in;\n{}{}", kStorage, main));
    return Program::build_compute(*context_, *text);
  };
  GridRenderer grid(*context_);
  const auto right = build_compute("void main() { results[gl_GlobalInvocationID.x] = uvec4(7u); }\n");
  EXPECT_EQ(grid.evaluate(*right, inputs)->front(), 7u);
  const auto silent = build_compute("void main() { if (results.length() == 1) results[0] = uvec4(7u); }\n");
  EXPECT_EQ(grid.evaluate(*silent, inputs)->front(), 0xDEADBEEFu);
}

TEST_F(Gpu, ADrawThatIsLostLeavesNoOldResult) {
  GladGLContext gl = context_->gl();
  gl.DrawArrays = [](GLenum, GLint, GLsizei) {};
  gl.BeginTransformFeedback = [](GLenum) {};  // which is an error without a program
  gl.EndTransformFeedback = [] {};
  const auto words = make_stage_output(gl, Stage::vertex)->run(0, 4);
  ASSERT_TRUE(words) << words.error().text();
  EXPECT_EQ(*words, std::vector<std::uint32_t>(4 * kOutputWords, 0xDEADBEEFu));
}

TEST_F(Gpu, EvaluatesTheShadersOfTranslators) {
  const auto evaluator = evaluator_on(*context_);
  ASSERT_EQ(evaluator->takes(), (std::vector{Form::gl, Form::glsl_es}));
  std::vector<std::uint32_t> points(100 * kInputWords);  // more than a group has
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = static_cast<std::uint32_t>(i);
  std::vector<std::uint32_t> right;
  for (std::uint32_t i = 0; i < 400; ++i) right.push_back((i / 4 * 16 + 3 - i % 4) * 1000 + 3);
  const auto text = [](std::string_view seed) {
    return fmt::format("uvec4 f(uvec4 p) {{ return p.wzyx * {} + uint(trips); }}", seed);
  };
  const auto expect = [&](Form form, const Result<std::string>& shader, bool is_right) {
    const auto results = results_of(*evaluator, form, shader, points);
    ASSERT_TRUE(results) << results.error().text();
    EXPECT_EQ(*results == right, is_right);
  };
  const std::vector<std::string> to_es = {"--es", "--version", "310"};
  expect(Form::gl, by_spirv_cross(text("variant_seed"), {"--no-es", "--version", "430"}), true);
  expect(Form::glsl_es, by_spirv_cross(text("variant_seed"), to_es), true);
  expect(Form::glsl_es, by_spirv_cross(text("(variant_seed ^ 1u)"), to_es), false);
  // As naga names buffers.
  expect(Form::glsl_es, R"(#version 310 es
layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
struct Shared { int trips; uint seed; };
layout(std430) readonly buffer Shared_block_0Compute { Shared _group_0_binding_2_cs; };
layout(std430) readonly buffer type_1_block_1Compute { uvec4 _group_0_binding_1_cs[]; };
layout(std430) buffer Results_block_2Compute {
    uvec4 words[];
} _group_0_binding_0_cs;
void main() {
  uvec4 p = _group_0_binding_1_cs[gl_GlobalInvocationID.x * 4u].wzyx * _group_0_binding_2_cs.seed;
  _group_0_binding_0_cs.words[gl_GlobalInvocationID.x] = p + uint(_group_0_binding_2_cs.trips);
}
)",
         true);
  EXPECT_FALSE(evaluator->load({Form::gl, "#version 430\nvoid main() { no; }\n"}));
}

TEST_F(Gpu, AContextWithoutComputeShadersSaysSo) {
  GladGLContext gl = context_->gl();
  EXPECT_EQ(unsupported_reason(gl, Stage::compute), "");
  gl.DispatchCompute = nullptr;
  EXPECT_NE(unsupported_reason(gl, Stage::compute), "");
  EXPECT_EQ(unsupported_reason(gl, Stage::vertex), "");
}

TEST_F(Gpu, AProgramThatDoesNotLinkIsAnError) {
  EXPECT_FALSE(build("float f();\nout vec4 o;\nvoid main() { o = vec4(f()); }\n"));
}

}  // namespace
}  // namespace hn
