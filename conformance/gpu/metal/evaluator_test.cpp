#include "gpu/evaluator.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

class MetalStandIn : public testing::Test {
 protected:
  void SetUp() override {
    auto made = create_metal_evaluator();
    ASSERT_TRUE(made) << made.error().text();
    evaluator_ = std::move(*made);
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, std::string_view function,
                                           std::string_view configuration) {
    const Evaluation evaluation{
        find_function(function), configuration_named(configuration), profile_named("msl"), {}, Stage::compute};
    return evaluator_->build(sources, evaluation, evaluation_shader(evaluation));
  }

  std::unique_ptr<Evaluator> evaluator_;
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

TEST_F(MetalStandIn, RefusesOtherLanguagesAndStages) {
  EXPECT_NE(evaluator_->unsupported(profile_named("gl430"), Stage::compute), "");
  EXPECT_NE(evaluator_->unsupported(profile_named("msl"), Stage::fragment), "");
  EXPECT_EQ(evaluator_->unsupported(profile_named("msl"), Stage::compute), "");
}

}  // namespace
}  // namespace hn
