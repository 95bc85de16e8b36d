#include "library/profile.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

TEST(Profile, LineDirectiveFollowsTheSpecifications) {
  EXPECT_FALSE(profile_named("gl130").line_names_next());
  EXPECT_FALSE(profile_named("gl150").line_names_next());
  EXPECT_TRUE(profile_named("gl330").line_names_next());
  EXPECT_TRUE(profile_named("es300").line_names_next());
}

TEST(Profile, WhatAContextCannotCompileHasAReason) {
  const LanguageSupport desktop{330, 0};
  EXPECT_EQ(unsupported_reason(profile_named("gl330"), desktop), "");
  EXPECT_EQ(unsupported_reason(profile_named("gl460"), desktop), "GLSL 4.60 is beyond this context's 3.30");
  EXPECT_EQ(unsupported_reason(profile_named("es300"), desktop), "this context does not compile GLSL ES");
  EXPECT_EQ(unsupported_reason(profile_named("es320"), {450, 310}), "GLSL ES 3.20 is beyond this context's 3.10");
  const LanguageSupport strict_core{450, 0, false, false};
  EXPECT_EQ(unsupported_reason(profile_named("gl130"), strict_core), "this context does not accept GLSL 1.30");
  EXPECT_EQ(unsupported_reason(profile_named("gl140"), strict_core), "");
}

TEST(Profile, RunningNeedsBitCasts) {
  EXPECT_EQ(unsupported_to_run(profile_named("gl140"), {450, 0, true, false}),
            "the suite needs GL_ARB_shader_bit_encoding in GLSL 1.40");
  EXPECT_EQ(unsupported_to_run(profile_named("gl140"), {450, 0, true, true}), "");
  EXPECT_EQ(unsupported_to_run(profile_named("gl330"), {450, 0, true, false}), "");
  EXPECT_EQ(unsupported_to_run(profile_named("gl330"), {150, 0}), "GLSL 3.30 is beyond this context's 1.50");
}

TEST(Profile, APlatformRunsItsOwnProfilesAlone) {
  const LanguageSupport opengl{460, 320};
  LanguageSupport vulkan{0, 0};
  vulkan.profiles = {"vulkan", "hlsl60"};
  EXPECT_EQ(profile_named("gl460").platform(), Platform::opengl);
  EXPECT_EQ(unsupported_reason(profile_named("vulkan"), opengl),
            "this driver does not run vulkan, which is for drivers of Vulkan");
  EXPECT_EQ(unsupported_reason(profile_named("hlsl60"), opengl),
            "this driver does not run hlsl60, which is for drivers of Vulkan");
  EXPECT_EQ(unsupported_to_run(profile_named("vulkan"), vulkan), "");
  EXPECT_EQ(unsupported_to_run(profile_named("hlsl60"), vulkan), "");
  EXPECT_NE(unsupported_reason(profile_named("hlsl50"), vulkan), "");
  EXPECT_EQ(unsupported_reason(profile_named("gl330"), vulkan), "this context does not compile desktop GLSL");
  EXPECT_TRUE(vulkan.has_stage(Stage::compute));
  EXPECT_FALSE(vulkan.has_stage(Stage::fragment));
}

}  // namespace
}  // namespace hn
