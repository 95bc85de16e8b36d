// The parts that need a context, on OSMesa.
#include "gpu.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "osmesa_fixture.hpp"
#include "runner.hpp"
#include "test_support.hpp"

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

constexpr std::string_view kInputs = "uniform usampler2D input_a;\nuniform usampler2D input_b;\nout uvec4 result;\n";

TEST_F(Gpu, WordsTravelUnchanged) {
  const auto program = build(std::string(kInputs) +
                             "void main() { ivec2 at = ivec2(gl_FragCoord.xy);\n"
                             "result = texelFetch(input_a, at, 0) + texelFetch(input_b, at, 0).wzyx; }\n");
  ASSERT_TRUE(program) << program.error().text();
  // 2500 points: more than a row of the texture, and no whole number of rows.
  std::vector<std::uint32_t> inputs(2500 * kInputWords);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = static_cast<std::uint32_t>(i) * 0x9E3779B9u;
  GridRenderer grid(*context_);
  const auto outputs = grid.evaluate(*program, inputs);
  ASSERT_TRUE(outputs) << outputs.error().text();
  ASSERT_EQ(outputs->size(), 2500 * kOutputWords);
  for (std::size_t i = 0; i < 2500; ++i) {
    for (std::size_t word = 0; word < 4; ++word) {
      ASSERT_EQ((*outputs)[i * 4 + word], inputs[i * 8 + word] + inputs[i * 8 + 7 - word]);
    }
  }
}

TEST_F(Gpu, PixelsBesideTheGridSeeNoOldWords) {
  // A derivative tells what the neighbours in the block have.
  const auto program = build(std::string(kInputs) +
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
  const auto right = build(std::string(kInputs) + "void main() { result = uvec4(7u); }\n");
  EXPECT_EQ(grid.evaluate(*right, inputs)->front(), 7u);
  const auto silent = build(std::string(kInputs) + "void main() { discard; }\n");
  EXPECT_EQ(grid.evaluate(*silent, inputs)->front(), 0xDEADBEEFu);
}

TEST_F(Gpu, AnErrorInALibraryFileNamesItsLine) {
  const auto program = build("#define hn_i_mix 1\n#include \"hash.glsl\"\nvoid main() {}\n");
  ASSERT_FALSE(program);
  EXPECT_NE(program.error().log.find("glsl/hash.glsl:"), std::string::npos) << program.error().log;
}

TEST_F(Gpu, AProgramThatDoesNotLinkIsAnError) {
  EXPECT_FALSE(build("float f();\nout vec4 o;\nvoid main() { o = vec4(f()); }\n"));
}

class RunCases : public Gpu {
 protected:
  std::vector<CaseResult> run(const std::vector<Case>& cases, bool fail_fast) {
    const ReferenceCompiler reference;
    Session session(*context_, sources_, reference, "", 1);
    Progress progress(stderr, cases.size());
    return run_cases(session, cases, {fail_fast}, progress);
  }
};

Outcome passes(Session&) { return {}; }
Outcome fails(Session&) { return outcome_with(Status::fail, {"it fails", {}}); }
Outcome throws(Session&) { throw std::runtime_error("thrown"); }

TEST_F(RunCases, AnExceptionIsAnErrorAndTheRunGoesOn) {
  const auto results = run({{"a", throws}, {"b", passes}}, false);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].outcome.status, Status::error);
  EXPECT_EQ(results[0].outcome.message, "exception: thrown");
  EXPECT_EQ(results[1].outcome.status, Status::pass);
}

TEST_F(RunCases, FailFastStopsAtTheFirstFailure) {
  EXPECT_EQ(run({{"a", passes}, {"b", fails}, {"c", passes}}, true).size(), 2u);
  EXPECT_EQ(run({{"a", passes}, {"b", fails}, {"c", passes}}, false).size(), 3u);
}

}  // namespace
}  // namespace hn
