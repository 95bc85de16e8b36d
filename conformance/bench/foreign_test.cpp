#include "bench/foreign.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/folder.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

class Foreigns : public OnOsmesa<> {
 protected:
  std::string path(std::string_view name) const { return (folder_.path() / name).string(); }

  // The subjects of an argument, whose file is in the folder.
  Result<std::vector<Subject>> subjects(std::string_view name, std::string_view rest) {
    SourceSet sources = SourceSet::embedded();
    HN_TRY(const auto foreign, read_foreign(fmt::format("{}={}", name, path(rest)), sources));
    Workbench workbench(*context_, sources);
    return foreign_subjects(workbench, foreign);
  }

  void expect_compiles(std::string_view name, std::string_view rest) {
    const auto found = subjects(name, rest);
    EXPECT_TRUE(found) << found.error().text();
  }

  // The text of the error must have this part.
  void expect_refused(std::string_view name, std::string_view rest, std::string_view part) {
    const auto found = subjects(name, rest);
    ASSERT_FALSE(found) << rest;
    EXPECT_NE(found.error().text().find(part), std::string::npos) << found.error().text();
  }

  TemporaryFolder folder_;
};

TEST_F(Foreigns, IncludeTheirNeighbours) {
  for (const std::string_view name : {"noise", "math/more"}) std::filesystem::create_directories(path(name));
  folder_.write("noise/simple.glsl",
                "#include \"../math/both.glsl\"\nfloat simple(vec2 p) { return one() + two(); }\n");
  folder_.write("math/both.glsl", "#include \"one.glsl\"\n#include \"more/two.glsl\"");
  folder_.write("math/one.glsl", "#ifndef ONE\n#define ONE\nfloat one() { return 1.0; }\n#endif\n");
  folder_.write("math/more/two.glsl", "#include \"../one.glsl\"\nfloat two() { return one() + one(); }\n");
  const auto found = subjects("simple", "noise/simple.glsl:simple(p)");
  ASSERT_TRUE(found) << found.error().text();
  ASSERT_EQ(found->size(), 1u);
  EXPECT_EQ(found->front().id, "simple2");
}

TEST_F(Foreigns, IncludeTheLibraryUnlessANeighbourHasTheName) {
  folder_.write("own.glsl", "#include \"hashnoise/noise2d.glsl\"\n");
  expect_compiles("own", "own.glsl:hn_perlin(p)");
  folder_.write("hashnoise/noise2d.glsl", "float neighbour(vec2 p) { return p.x; }\n");
  expect_compiles("own", "own.glsl:neighbour(p)");
  expect_refused("own", "own.glsl:hn_perlin(p)", "hn_perlin");
}

// The tables that are measured as well are not files of the library.
TEST_F(Foreigns, DoNotIncludeWhatIsOurs) {
  for (const std::string_view name : {"perlin.glsl", "hashnoise/perlin.glsl"}) {
    folder_.write("own.glsl", fmt::format("\n#include \"{}\"\n", name));
    expect_refused("own", "own.glsl:p.x", path("own.glsl:2"));
  }
}

TEST_F(Foreigns, IncludesThatAreLeftOutNeedNotBeThere) {
  folder_.write("optional.glsl",
                "/* as in\n#include \"comment.glsl\"\n*/\n#ifdef NEVER\n#include \"absent.glsl\"\n#endif\n");
  expect_compiles("optional", "optional.glsl:p.x");
  folder_.write("optional.glsl", "#ifndef NEVER\n#include \"absent.glsl\"\n#endif\n");
  expect_refused("optional", "optional.glsl:p.x", path("optional.glsl:2"));
  expect_refused("optional", "optional.glsl:p.x", "there is no file absent.glsl to include");
}

TEST_F(Foreigns, WithoutEndAreRefused) {
  folder_.write("endless.glsl", "float f(vec2 p) { return p.x; }\n#include \"endless.glsl\"\n");
  expect_refused("endless", "endless.glsl:f(p)", path("endless.glsl:2: includes are nested more than 16 deep"));
}

TEST_F(Foreigns, ErrorsNameTheLineOfAnIncludedFileAndOfTheExpression) {
  folder_.write("top.glsl", "// a\n#include \"below.glsl\"\nfloat g(vec2 p) { return undeclared_above; }\n");
  folder_.write("below.glsl", "// b\n\nfloat f(vec2 p) { return undeclared_below; }\n");
  expect_refused("top", "top.glsl:f(p)", path("below.glsl:3"));
  expect_refused("top", "top.glsl:f(p)", path("top.glsl:3"));
  folder_.write("good.glsl", "float f(vec2 p) { return p.x; }\n");
  expect_refused("wrong", "good.glsl:absent(p)", "the expression of wrong:1");
  expect_refused("wrong", "good.glsl:absent(p)", "neither for a vec2 nor for a vec3");
}

// Beyond an include in a branch that the preprocessor skips, #line has to be written again.
TEST_F(Foreigns, ErrorsNameTheLineBehindAnIncludeThatIsLeftOut) {
  folder_.write("long.glsl", "// 1\n// 2\n// 3\n// 4\n");
  folder_.write("top.glsl", "#ifdef NEVER\n#include \"long.glsl\"\n#endif\nfloat f(vec2 p) { return undeclared; }\n");
  expect_refused("top", "top.glsl:f(p)", path("top.glsl:4"));
}

TEST_F(Foreigns, OfALongFileSayOnlyTheFirstErrors) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += fmt::format("float f{}() {{ return undeclared; }}\n", i);
  folder_.write("wrong.glsl", text);
  expect_refused("wrong", "wrong.glsl:f0()", " lines more");
}

TEST_F(Foreigns, HaveTheVersionThatTheyAskFor) {
  const auto profile_of = [&](std::string_view name, std::string_view first_line) -> std::string {
    folder_.write("version.glsl", fmt::format("{}\nfloat f(vec2 p) {{ return p.x; }}\n", first_line));
    const auto found = subjects(name, "version.glsl:f(p)");
    return found ? std::string(found->front().profile) : found.error().text();
  };
  for (const auto& [line, profile] : {std::pair{"", "gl330"},
                                      {"#version 120", "gl330"},
                                      {"#version 300 es", "gl330"},
                                      {"#version 320 es", "gl330"},
                                      {"#version 330 core", "gl330"},
                                      {"#version 420", "gl420"},
                                      {" # version 450 core // x", "gl450"},
                                      {"#version 420\r", "gl420"},
                                      {"/* c */\n// c\n#version 430", "gl430"},
                                      {"/*\n#version 430\n*/", "gl330"}}) {
    EXPECT_EQ(profile_of("v", line), profile) << line;
  }
  EXPECT_EQ(profile_of("v@420", "#version 450"), "gl420");
  EXPECT_EQ(profile_of("v@330", "#version 450"), "gl330");
  EXPECT_NE(profile_of("v@460", "").find("GLSL 4.60 is beyond this context's 4.50"), std::string::npos);
  for (const std::string_view name : {"v@", "v@120", "v@425", "v@450core", "v@300es"}) {
    EXPECT_NE(profile_of(name, "").find("there are 330, 400, 410"), std::string::npos) << name;
  }
  for (const std::string_view line : {"#version 425", "#version", "#version new", "#version 99999999999"}) {
    EXPECT_NE(profile_of("v", line).find(path("version.glsl:1: ")), std::string::npos) << line;
  }
}

// As the README's shaders have it.
TEST_F(Foreigns, MayAskForIncludesAsGlslangWantsIt) {
  folder_.write("helper.glsl", "float help(vec2 p) { return p.y; }\n");
  folder_.write("asks.glsl",
                "#extension GL_GOOGLE_include_directive : require\n#include \"helper.glsl\"\n"
                "float f(vec2 p) { return help(p); }\n");
  expect_compiles("asks", "asks.glsl:f(p)");
}

// GLSL 4.20 has initializers in braces, which 3.30 has not.
TEST_F(Foreigns, CompileInTheVersionThatTheyAskFor) {
  folder_.write("braces.glsl", "const float kTwo[] = { 1.0, 2.0 };\nfloat f(vec2 p) { return kTwo[int(p.x) & 1]; }\n");
  expect_refused("braces", "braces.glsl:f(p)", "NAME@450");
  expect_compiles("braces@420", "braces.glsl:f(p)");
}

}  // namespace
}  // namespace hn
