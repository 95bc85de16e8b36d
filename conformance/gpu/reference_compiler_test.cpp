#include "gpu/reference_compiler.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gpu/spirv.hpp"

namespace hn {
namespace {

Result<void> check(std::string_view profile, std::string_view text, Stage stage = Stage::fragment) {
  const ReferenceCompiler compiler;
  const auto shader = expand(SourceSet::embedded(), profile_named(profile), text);
  return shader ? compiler.check(*shader, profile_named(profile), stage) : tl::unexpected(shader.error());
}

TEST(ReferenceCompiler, AWarningIsAnError) {
  // glslang warns of precision qualifiers without a default precision when it makes SPIR-V.
  const auto done = check("vulkan", "void main() { highp float x = 1.0; }\n");
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("warns"), std::string::npos);
}

TEST(ReferenceCompiler, WhatAVersionHasNotIsAnError) {
  EXPECT_FALSE(check("gl130", "void main() { uint x = floatBitsToUint(1.0); }\n"));
  EXPECT_FALSE(check("es300", "out vec4 o;\nvoid main() {}\n"));  // no default precision for float
}

TEST(ReferenceCompiler, SpirvThatIsNoneIsRejected) {
  const std::uint32_t header_only[] = {0x07230203u, 0x00010000u, 0u, 1u, 0u};  // no memory model, no entry point
  EXPECT_FALSE(validate_spirv(header_only));
  EXPECT_FALSE(validate_spirv({}));
}

// The functions of a shader that calls f(x) in which an operation may be contracted.
std::vector<std::string> contractible_in(std::string_view function) {
  const ReferenceCompiler compiler;
  const auto text = fmt::format(
      "{}layout(location = 0) in float x;\nlayout(location = 0) out vec4 o;\nvoid main() {{ o = vec4(f(x)); }}\n",
      function);
  const auto shader = expand(SourceSet::embedded(), profile_named("vulkan"), text);
  return contractible(compiler.spirv(shader.value(), Stage::fragment).value());
}

TEST(ReferenceCompiler, NamesTheFunctionsThatAreNotPrecise) {
  EXPECT_TRUE(contractible_in("float f(float a) { precise float b = a * a + 1.0; return b; }\n").empty());
  EXPECT_TRUE(contractible_in("float f(float a) { return a * 0.25; }\n").empty());  // which rounds nothing
  EXPECT_FALSE(contractible_in("float f(float a) { return a * 0.75; }\n").empty());
  const auto found = contractible_in("float f(float a) { return a * a + 1.0; }\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], "f(f1;");
}

TEST(ReferenceCompiler, ExpandsMacros) {
  const ReferenceCompiler compiler;
  const Profile& hlsl = profile_named("hlsl50");
  const auto of = [&](std::string_view text) {
    const auto shader = expand(SourceSet::embedded(), hlsl, text);
    return compiler.preprocessed(*shader, hlsl, Stage::compute);
  };
  const auto plain =
      of("#define PAIR 1, 2\n#define SUM(a) ADD(a)\n#define ADD(a, b) ((a) + (b))\n#if 0\nno\n#endif\n"
         "int x = SUM(PAIR);\n");
  ASSERT_TRUE(plain) << plain.error().text();
  EXPECT_EQ(plain->text.find("SUM"), std::string::npos) << plain->text;
  EXPECT_EQ(plain->text.find("no"), std::string::npos) << plain->text;
  EXPECT_NE(plain->text.find("+"), std::string::npos) << plain->text;
  EXPECT_FALSE(of("#if\n"));
}

TEST(ReferenceCompiler, LinksAWholeProgram) {
  EXPECT_FALSE(check("gl450", "float f();\nvoid main() { gl_FragDepth = f(); }\n"));
}

}  // namespace
}  // namespace hn
