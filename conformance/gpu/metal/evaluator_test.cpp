#include <gtest/gtest.h>

#include "gpu/translated_fixture.hpp"

namespace hn {
namespace {

class MetalStandIn : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = create_metal_evaluator();
    ASSERT_TRUE(made) << made.error().text();
    evaluator_ = std::move(*made);
  }
  static void TearDownTestSuite() { evaluator_.reset(); }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, std::string_view function,
                                           std::string_view configuration) {
    const Evaluation evaluation{
        find_function(function), configuration_named(configuration), profile_named("msl"), {}, Stage::compute};
    return evaluator_->build(sources, evaluation, evaluation_shader(evaluation));
  }

  static inline std::unique_ptr<Evaluator> evaluator_;
};

SourceSet changed(const std::string& file, std::string_view what, std::string_view by) {
  SourceSet sources = SourceSet::embedded();
  std::string text = sources.find(file)->text;
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  sources.add(file, text.replace(at, what.size(), by), file);
  return sources;
}

TEST_F(MetalStandIn, EvaluatesTheTextThatItIsGiven) {
  const std::vector<std::uint32_t> points(3 * kInputWords, 0x3F000000u);
  const auto right = build(SourceSet::embedded(), "noise2d.perlin", "lattice+fixed");
  ASSERT_TRUE(right) << right.error().text();
  const auto wrong =
      build(changed("detail/word.glsl", "0x2C1B3C6Du", "0x2C1B3C6Fu"), "noise2d.perlin", "lattice+fixed");
  ASSERT_TRUE(wrong) << wrong.error().text();
  const auto values = (*right)->evaluate(points);
  const auto other_values = (*wrong)->evaluate(points);
  ASSERT_TRUE(values && other_values);
  EXPECT_EQ(values->size(), 3 * kOutputWords);
  EXPECT_EQ((*values)[0], (*values)[2 * kOutputWords]);
  EXPECT_NE((*values)[0], (*other_values)[0]);
}

TEST_F(MetalStandIn, SaysWhereTheTextIsWrong) {
  const auto built =
      build(changed("hash.glsl", "HN_FN hn_float hn_unorm(", "HN_FN hn_flote hn_unorm("), "hash.unorm", "lattice");
  ASSERT_FALSE(built);
  EXPECT_NE(built.error().log.find("hash.glsl:"), std::string::npos) << built.error().log;
  EXPECT_NE(built.error().log.find("hn_flote"), std::string::npos) << built.error().log;
}

TEST_F(MetalStandIn, EvaluatesTheKernelsOfTranslators) {
  std::vector<std::uint32_t> points(2 * kInputWords, 0x12345678u);
  for (std::size_t i = 0; i < 4; ++i) points[i] = static_cast<std::uint32_t>(i + 5);
  const auto results = results_of(*evaluator_, Form::msl,
                                  by_spirv_cross(R"(
    uvec4 f(uvec4 p) {
      int some[3] = int[3](5, 6, trips);
      precise vec3 v = fract(mat3(0.25) * vec3(p.yzx));
      v = mix(v.zyx, vec3(9.0), equal(p.xyz, uvec3(6u)));
      uint x = uint(some[p.x % 3u]) + (any(lessThan(p.xy, uvec2(6u))) ? 100u : 0u);
      uint z = bitfieldInsert(bitfieldExtract(p.z, 4, 8), variant_seed, 16, 16) ^ uint(findMSB(p.w));
      return uvec4(x, floatBitsToUint(clamp(v.x, 0.0, 1.0)), z, uint(int(p.w) >> 1));
    })",
                                                 {"--msl"}),
                                  points);
  ASSERT_TRUE(results) << results.error().text();
  EXPECT_EQ(*results, (std::vector<std::uint32_t>{103, 0x3E800000, 1000u << 16 ^ 3, 4,  //
                                                  5, 0, (0x67u | 1000u << 16) ^ 28, 0x091A2B3C}));
  // naga has no numbers, and Slang another form of the kernel.
  const auto of_naga = results_of(*evaluator_, Form::msl, R"(
struct _mslBufferSizes { uint size1; };
typedef metal::uint4 type_1[1];
kernel void main_(metal::uint3 id [[thread_position_in_grid]], device type_1 const& points [[user(fake0)]],
  device type_1& results [[user(fake0)]], constant _mslBufferSizes& _buffer_sizes [[user(fake0)]]) {
  metal::uint4 p = points[id.x * 4u];
  results[id.x] = metal::select(p, metal::uint4(_buffer_sizes.size1), p > metal::uint4(6u));
})",
                                  points);
  ASSERT_TRUE(of_naga) << of_naga.error().text();
  EXPECT_EQ(*of_naga, (std::vector<std::uint32_t>{5, 6, 128, 128, 128, 128, 128, 128}));
  const auto of_slang = results_of(*evaluator_, Form::msl, R"(using namespace metal;
[[kernel]] void main(uint3 at [[thread_position_in_grid]], uint4 device* b [[buffer(1)]],
                     uint4 device* a [[buffer(0)]]) {
  uint4 device* p = b + at.x * 4U;
  *(a + at.x) = *p;
  (*(a + at.x)).zx = (*p).xy;
})",
                                   points);
  ASSERT_TRUE(of_slang) << of_slang.error().text();
  EXPECT_EQ((std::vector(of_slang->begin(), of_slang->begin() + 4)), (std::vector<std::uint32_t>{6, 6, 5, 8}));
}

TEST_F(MetalStandIn, FindsWhatMetalLeavesUndefined) {
  const auto text =
      by_spirv_cross("uvec4 f(uvec4 p) { return uvec4(ivec4(int(p.x) << 2) ^ ivec4(p) * 3); }", {"--msl"});
  const auto log_of = [&](std::uint32_t x, std::uint32_t y) {
    std::vector<std::uint32_t> points(2 * kInputWords);
    points[kInputWords] = x;
    points[kInputWords + 1] = y;
    const auto results = results_of(*evaluator_, Form::msl, text, points);
    return results ? "" : results.error().log.substr(results.error().log.find(' ') + 1);
  };
  EXPECT_EQ(log_of(7, 0x2AAAAAAAu), "");
  EXPECT_EQ(log_of(0xFFFFFFF9u, 0),
            "a shift to the left of an int that is negative or gets too large is undefined (point 1)");
  EXPECT_EQ(log_of(7, 0x2AAAAAABu), "a product of ints that overflows is undefined (point 1)");
  // The text's line, in operators of vectors too.
  const auto lines = results_of(*evaluator_, Form::msl,
                                "using namespace metal;\nkernel void k(device int4* results) {\n"
                                "  results[0] = int4(2147483647) +\n    int4(1);\n}\n",
                                std::vector<std::uint32_t>(16));
  ASSERT_FALSE(lines);
  EXPECT_EQ(lines.error().log, "kernel:4: a sum of ints that overflows is undefined (point 0)");
}

TEST_F(MetalStandIn, RefusesOtherLanguagesAndStages) {
  EXPECT_NE(evaluator_->unsupported(profile_named("gl430"), Stage::compute), "");
  EXPECT_NE(evaluator_->unsupported(profile_named("msl"), Stage::fragment), "");
  EXPECT_EQ(evaluator_->unsupported(profile_named("msl"), Stage::compute), "");
  EXPECT_FALSE(evaluator_->load({Form::msl, "void f() {}"}));
  const auto loaded = evaluator_->load({Form::msl, "kernel void k(texture2d<float> t [[texture(0)]]) {}"});
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("t [[texture(0)]]"), std::string::npos) << loaded.error().message;
}

}  // namespace
}  // namespace hn
