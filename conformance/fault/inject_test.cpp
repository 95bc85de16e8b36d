#include <gtest/gtest.h>

#include "fault/faults.hpp"

namespace hn {
namespace {

TEST(Faults, AWrongNameListsTheRightOnes) {
  SourceSet sources = SourceSet::embedded();
  const auto done = inject_into(sources, "abs_imt");
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find("abs_int"), std::string::npos);
}

TEST(Faults, TheShimStandsBelowVersionAndExtensions) {
  SourceSet sources = SourceSet::embedded();
  ASSERT_TRUE(inject_into(sources, "loop_condition"));
  const auto shader = expand(sources, profile_named("gl330"), "#extension GL_X : enable\nvoid main() {}\n");
  ASSERT_TRUE(shader);
  EXPECT_EQ(shader->text,
            "#version 330\n#line 2 0\n#extension GL_X : enable\n#line 10001 1\nint hn_fault_turns = 0;\n#line 3 0\n"
            "void main() {}\n");
  EXPECT_EQ(shader->translate("0:3: x"), "the case's shader:3: x");
  EXPECT_EQ(shader->translate("0:10001: x"), "the injected fault loop_condition:1: x");
}

TEST(Faults, WhatTheyDoNotConcernStays) {
  SourceSet sources = SourceSet::embedded();
  ASSERT_TRUE(inject_into(sources, "mediump_everywhere"));
  constexpr std::string_view kText = "float f(float x) { return x * x; }\n";
  EXPECT_EQ(expand(sources, profile_named("gl330"), kText)->text,
            expand(SourceSet::embedded(), profile_named("gl330"), kText)->text);
}

}  // namespace
}  // namespace hn
