#include "profile.hpp"

#include <gtest/gtest.h>

#include "test_support.hpp"

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
  EXPECT_EQ(unsupported_reason(profile_named("es300"), desktop), "this context compiles no GLSL ES");
  EXPECT_EQ(unsupported_reason(profile_named("es320"), {450, 310}), "GLSL ES 3.20 is beyond this context's 3.10");
}

}  // namespace
}  // namespace hn
