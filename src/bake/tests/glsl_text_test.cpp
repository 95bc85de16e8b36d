#include "bake/glsl_text.hpp"

#include <gtest/gtest.h>

#include "bake/compile_errors.hpp"

namespace hn {
namespace {

std::string functions(const std::string& glsl) {
  const auto cpp = cpp_of_functions({"--source a.glsl", glsl});
  return cpp ? cpp->text : cpp.error().message;
}
std::string expression(const std::string& glsl) {
  const auto cpp = cpp_of_expression({"--expression", glsl});
  return cpp ? cpp->text : cpp.error().message;
}

TEST(GlslText, LiteralsAreFloats) {
  EXPECT_EQ(expression("1.0 + .5*2. - 1e3/1.5e-2 + 2 + 3u + 0x1Fu + 1.0f"),
            "1.0f + .5f*2.f - 1e3f/1.5e-2f + 2 + 3u + 0x1Fu + 1.0f");
  EXPECT_EQ(expression("v1.x + a2e5"), "v1.x + a2e5");
}

TEST(GlslText, SwizzlesAreFunctions) {
  EXPECT_EQ(expression("p.yx"), "swizzled<21>(p   )");
  EXPECT_EQ(expression("2.0*f(p, (q)).rgb - 1.0"), "2.0f*swizzled<123>(f(p, (q))    ) - 1.0f");
  EXPECT_EQ(expression("a.b.xxyy.zw.x"), "swizzled<34>(swizzled<1122>(a.b     )   ).x");
  EXPECT_EQ(expression("p.x + p.color + p.xg"), "p.x + p.color + p.xg");
  EXPECT_EQ(functions("a > (b).xy"), "a >swizzled<12>( (b)   )");
  EXPECT_EQ(functions(">.xy > .yx, return .zw"), ">swizzled<12>(   ) >swizzled<21>(    ), return swizzled<34>(   )");
  EXPECT_EQ(functions("return (a + b).xy;"), "return swizzled<12>((a + b)   );");
}

TEST(GlslText, WordsOfGlslAloneAreLeftOut) {
  EXPECT_EQ(
      functions("#version 450\nprecision highp float; // all\nvoid f(in vec2 p, out highp float a, inout vec2 b)\n"
                "#include \"hashnoise/fbm2d.glsl\"\n#define PI 3.14\n/* a\n */float g;"),
      "            \n                             \nvoid f(   vec2 p,           float& a,       vec2& b)\n"
      "                               \n#define PI 3.14f\n    \n   float g;");
}

TEST(GlslText, WhatIsWrongIsToldWithItsPlace) {
  const struct {
    std::string glsl;
    std::string part;
  } expressions[] = {{"", "no expression"},
                     {"  // nothing", "no expression"},
                     {"1.0; 2.0", "column 4: an expression is one value without \";\""},
                     {"f(p", "column 2: this bracket is not closed"},
                     {"f(p))", "column 5: this bracket was not opened"},
                     {"(p]", "column 3: this bracket was not opened"},
                     {"1.0lf", "is a double"},
                     {"1f", "is no number of GLSL"},
                     {"1.0 +\n mat2(1.0)", "line 2, column 2: there is no mat2 here"},
                     {"std::sin(1.0)", "C++ reserves the word std"},
                     {"p->x", "GLSL has no \"->\""},
                     {"\"a\"", "column 1: GLSL has no"},
                     {"#define A", "--source file"},
                     {"1.0 /* a", "column 5: this comment has no end"},
                     {"gl_FragCoord.x", "belongs to a shader"}};
  for (const auto& [glsl, part] : expressions) {
    EXPECT_FALSE(cpp_of_expression({"--expression", glsl})) << glsl;
    EXPECT_NE(expression(glsl).find(part), std::string::npos) << expression(glsl);
  }
  EXPECT_NE(functions("#include \"other.glsl\"").find("no other files"), std::string::npos);
  EXPECT_NE(functions("\n#define HN_HASH 1").find("line 2, column 1: a knob"), std::string::npos);
  EXPECT_EQ(functions("#define M HN_METRIC_SQUARED"), "#define M HN_METRIC_SQUARED");
  EXPECT_NE(functions("a.xy = b;").find("column 3: .xy can only be read here"), std::string::npos);
  EXPECT_NE(functions("a.xy *= b;").find("column 3: .xy can only be read here"), std::string::npos);
  EXPECT_EQ(functions("a.xy == b;"), "swizzled<12>(a   ) == b;");
  EXPECT_NE(functions("uniform float time;").find("belongs to a shader"), std::string::npos);
  EXPECT_NE(functions("class A;").find("GLSL reserves the word class"), std::string::npos);
}

TEST(GlslText, AMessageShowsTheLine) {
  const GlslText text{"--source a.glsl", "one\ntwo\tthree\nfour"};
  EXPECT_EQ(text.at(8, "what"), "--source a.glsl, line 2, column 5: what\n  two three\n      ^");
  EXPECT_EQ(text.at(999, "what"), "--source a.glsl, line 3, column 5: what\n  four\n      ^");
}

std::string explained_log(const std::string& log) {
  const auto glsl = cpp_of_expression({"--expression", "1.0 + f(p.yx, 2.0)"});
  const auto source = cpp_of_functions({"--source a.glsl", "float f(vec2 p, int n) {\n  return g(1.0, p);\n}"});
  EXPECT_TRUE(glsl && source);
  return first_error(log, {"E", &*glsl}, {"S", &*source}).value_or("nothing");
}

// The columns of the C++, "1.0f + f(swizzled<21>(p)   , 2.0f)", are those of the GLSL again.
TEST(CompileErrors, AreToldInTheWordsOfTheUser) {
  EXPECT_EQ(explained_log("E: In function 'x':\nE:1:8: error: 'f' was not declared in this scope\nE:1:9: error: more"),
            "--expression, line 1, column 7: 'f' was not declared in this scope\n  1.0 + f(p.yx, 2.0)\n        ^");
  EXPECT_EQ(explained_log("E:1:30: error: bad 'hashnoise::vec2' {aka 'hashnoise::Vector2<float>'} [-Werror=x]"),
            "--expression, line 1, column 15: bad 'vec2'\n  1.0 + f(p.yx, 2.0)\n                ^");
  EXPECT_NE(
      explained_log("S:2:10: error: no g").find("--source a.glsl, line 2, column 10: no g\n    return g(1.0, p);"),
      std::string::npos);
}

TEST(CompileErrors, InTheLibraryAreToldWhereItWasCalled) {
  EXPECT_NE(
      explained_log(
          "/a/b.hpp: In instantiation of 'c':\nE:1:8:   required from here\n/a/b.hpp:3:4: error: static assertion "
          "failed: hn-bake: too long")
          .find("--expression, line 1, column 7: too long\n"),
      std::string::npos);
  EXPECT_NE(explained_log(
                "/a/b.hpp:3:4: error: static assertion failed \"hn-bake: too long\"\nE:1:8: note: in instantiation of")
                .find("--expression, line 1, column 7: too long\n"),
            std::string::npos);
  EXPECT_NE(explained_log("/a/b.hpp:3:4: error: static assertion failed: hn-bake: no float").find("column 1: no float"),
            std::string::npos);
  for (const char* message :
       {"use of deleted function 'hashnoise::v1_0::detail::Refused<hashnoise::v1_0::detail::Hint<14>{\"write {16u} "
        "(6\"}> "
        "hashnoise::hash_8::gradient_1::arithmetic_3::hn_value(TypesInCall ...) [with TypesInCall = "
        "{hashnoise::Vector2<float>, int}]'",
        "'hn_value<hashnoise::Vector2<float>, int>' is unavailable: write 16u for a seed"}) {
    EXPECT_NE(
        explained_log(std::string("E:1:8: error: ") + message).find("column 7: there is no hn_value(vec2, int)\n"),
        std::string::npos);
  }
}

TEST(CompileErrors, OfTheCompilerAreNotTheUsers) {
  EXPECT_EQ(explained_log("c++: fatal error: no input files"), "nothing");
  EXPECT_EQ(explained_log(""), "nothing");
}

}  // namespace
}  // namespace hn
