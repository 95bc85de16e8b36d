// The cases on a device of Vulkan: that they notice a wrong library in each language, and which are not for them.
#include <fmt/format.h>

#include "cases/case.hpp"
#include "cases/evidence.hpp"
#include "gpu/evaluator.hpp"
#include "gpu/vulkan/vulkan_fixture.hpp"

namespace hn {
namespace {

class CasesOnVulkan : public OnVulkan<> {
 protected:
  void change(const std::string& file, std::string_view what, std::string_view by) {
    std::string text = sources_.find(file)->text;
    const auto at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    sources_.add(file, text.replace(at, what.size(), by), file);
  }

  Session session() {
    auto evaluator = create_vulkan_evaluator(number_, reference_);
    EXPECT_TRUE(evaluator) << evaluator.error().text();
    return {{sources_, reference_, HN_GOLDEN_DIRECTORY, 1}, std::move(*evaluator)};
  }

  Outcome run(std::string_view id) {
    Session one = session();
    return run_case(one, case_named(id)).outcome;
  }

  const ReferenceCompiler reference_;
  SourceSet sources_ = SourceSet::embedded();
};

// Cases in every language and arithmetic, and some that show a shape of the shader.
constexpr std::array kIds = {
    "noise2d.perlin.lattice.fast.compute.vulkan.golden",    "noise2d.perlin.lattice.fixed.compute.vulkan.golden",
    "noise2d.perlin.lattice.precise.compute.vulkan.golden", "noise2d.perlin.lattice.fixed.compute.vulkan.twin",
    "noise2d.perlin.lattice.fast.compute.hlsl60.golden",    "noise2d.perlin.lattice.fixed.compute.hlsl60.golden",
    "noise2d.perlin.lattice.precise.compute.hlsl60.golden", "noise2d.perlin.lattice.fixed.compute.hlsl60.twin",
    "noise2d.perlin.lattice.fixed.compute.hlsl50.golden",
};

TEST_F(CasesOnVulkan, AConstantThatIsWrongFailsInEveryLanguage) {
  for (const std::string_view id : kIds) {
    sources_ = SourceSet::embedded();
    const Outcome right = run(id);
    if (right.status == Status::unsupported && id.find("hlsl50") != std::string_view::npos) continue;
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
    change("detail/word.glsl", "0x2C1B3C6Du", "0x2C1B3C6Fu");
    const Outcome wrong = run(id);
    EXPECT_EQ(wrong.status, Status::fail) << id << ": " << wrong.message;
    EXPECT_NE(wrong.mismatches, 0u) << id << ": " << wrong.message;
  }
}

// A fault in one shape of the shader alone is caught by the case of that shape.
TEST_F(CasesOnVulkan, AShapeThatIsWrongFails) {
  for (const auto& [check, macro] :
       {std::array{"inlined", "CASE_INLINED"}, std::array{"in_loop", "CASE_IN_LOOP"},
        std::array{"constant_seed", "CASE_CONSTANT_SEED"}, std::array{"uniform_seed", "CASE_UNIFORM_SEED"}}) {
    const std::string id = fmt::format("noise3d.perlin.lattice.fixed.compute.vulkan.{}", check);
    sources_ = SourceSet::embedded();
    const Outcome right = run(id);
    EXPECT_EQ(right.status, Status::pass) << id << ": " << right.message;
    const std::string text = sources_.find("perlin3d.glsl")->text;
    sources_.add("perlin3d.glsl",
                 fmt::format("{}\n#ifdef {}\n#define hn_perlin(args) (hn_perlin(args) + 0.1)\n#endif\n", text, macro),
                 "perlin3d.glsl");
    EXPECT_NE(run(id).mismatches, 0u) << id;
  }
}

TEST_F(CasesOnVulkan, WhatFailsHasPicturesAndNoShader) {
  change("detail/word.glsl", "0x2C1B3C6Du", "0x2C1B3C6Fu");
  Session one = session();
  const Case test = case_named("noise2d.perlin.lattice.fast.compute.vulkan.golden");
  const auto evidence = make_evidence(one, test, run_case(one, test).outcome);
  ASSERT_TRUE(evidence);
  EXPECT_NE(evidence->got, "");
  EXPECT_NE(evidence->difference, "");
  EXPECT_EQ(evidence->shader, "");
  EXPECT_NE(evidence->note.find("made for OpenGL"), std::string::npos) << evidence->note;
}

TEST_F(CasesOnVulkan, WhatNeedsOpenGlIsUnsupported) {
  for (const std::string_view id :
       {"hash.all.lattice.fast.fragment.gl330.driver", "config.hash_0.any.fast.fragment.gl330.refused_by_driver",
        "noise2d.perlin.lattice.fast.fragment.gl330.golden", "noise2d.perlin.lattice.fast.fragment.gl330.range"}) {
    const Outcome outcome = run(id);
    EXPECT_EQ(outcome.status, Status::unsupported) << id;
    EXPECT_NE(outcome.message, "") << id;
  }
}

// A fault is a change of GLSL.
TEST_F(CasesOnVulkan, WithAFaultThatIsInjectedOtherLanguagesAreUnsupported) {
  sources_.transform_with([](ShaderText& shader, const Profile&) -> Result<void> {
    shader.text += "\n";
    return {};
  });
  EXPECT_EQ(run("noise2d.perlin.lattice.fast.compute.vulkan.golden").status, Status::pass);
  const Outcome outcome = run("noise2d.perlin.lattice.fast.compute.hlsl60.golden");
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_EQ(outcome.message, "faults are injected into GLSL");
}

}  // namespace
}  // namespace hn
