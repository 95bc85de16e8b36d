#include "fault/rewriter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "library/files.hpp"

namespace hn {
namespace {

const Rules kAll = {.operators = {{"%", "MOD"}, {"*", "MUL"}, {">>", "SHR"}, {"<<", "SHL"}, {"^", "XOR"}, {"+", "ADD"}},
                    .functions = {{"floor", "FLOOR"}, {"uint", "UINT"}},
                    .minus = "NEG"};

std::string body(std::string_view code, const Rules& rules = kAll) {
  constexpr std::string_view kOpen = "void f() {";
  const auto result = rewrite(std::string(kOpen) + std::string(code) + "}", rules);
  if (!result) return "error: " + result.error().message;
  EXPECT_TRUE(result->starts_with(kOpen) && result->ends_with("}")) << *result;
  return result->substr(kOpen.size(), result->size() - kOpen.size() - 1);
}

TEST(Rewriter, KeepsLinesThatAreMacros) {
  constexpr std::string_view kLines = "#define F(a, b) float a(float x) { return b(x); }\nF(f, sin)\nF(g, cos)\n";
  const auto same = rewrite(kLines, kAll);
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ(*same, kLines);
  EXPECT_TRUE(rewrite(std::string(kLines) + "float h() { return f(1.0); }", {}));
}

TEST(Rewriter, NoRulesChangeNothing) {
  for (const EmbeddedFile& file : kLibraryFiles) {
    const auto same = rewrite(file.text, {});
    ASSERT_TRUE(same) << file.name << ": " << same.error().message;
    EXPECT_EQ(*same, file.text);
  }
}

TEST(Rewriter, PrecedenceAndAssociation) {
  EXPECT_EQ(body("x = a % b * c;"), "x = MUL(MOD(a , b) , c);");
  EXPECT_EQ(body("x = a + b * c >> 2;"), "x = SHR(ADD(a , MUL(b , c)) , 2);");
  EXPECT_EQ(body("x = a ^ b ^ c;"), "x = XOR(XOR(a , b) , c);");
  EXPECT_EQ(body("x = a * (b + c);"), "x = MUL(a , (ADD(b , c)));");
  EXPECT_EQ(body("x = a < b << 1 && c == d;"), "x = a < SHL(b , 1) && c == d;");
}

TEST(Rewriter, CompoundAssignments) {
  EXPECT_EQ(body("h ^= h >> 15;"), "h = XOR(h , SHR(h , 15));");
  EXPECT_EQ(body("v.xy *= 2.0;"), "v.xy = MUL(v.xy , 2.0);");
  EXPECT_EQ(body("a = b += c;"), "a = b = ADD(b , c);");
  EXPECT_EQ(body("h -= 1u;"), "h -= 1u;");
}

TEST(Rewriter, UnaryMinusIsNoBinaryMinus) {
  EXPECT_EQ(body("x = -y;"), "x = NEG(y);");
  EXPECT_EQ(body("x = a - b;"), "x = a - b;");
  EXPECT_EQ(body("x = a - -b;"), "x = a - NEG(b);");
  EXPECT_EQ(body("x = -y.z * -(a - b);"), "x = MUL(NEG(y.z) , NEG((a - b)));");
  EXPECT_EQ(body("x = -1.5e-3 + 1e+2;"), "x = ADD(-1.5e-3 , 1e+2);");
  EXPECT_EQ(body("--x;"), "--x;");
}

TEST(Rewriter, CallsConstructorsAndArrays) {
  EXPECT_EQ(body("x = uint(a >> 8) & floor(b).x;"), "x = UINT(SHR(a , 8)) & FLOOR(b).x;");
  EXPECT_EQ(body("return uvec4(a * b, f(c), 0u, 0u);"), "return uvec4(MUL(a , b), f(c), 0u, 0u);");
  EXPECT_EQ(body("uint t[8]; t[i + 1] = t[i] * 2u;"), "uint t[8]; t[ADD(i , 1)] = MUL(t[i] , 2u);");
  EXPECT_EQ(body("x = f();"), "x = f();");
  EXPECT_EQ(body("x = v.floor;"), "x = v.floor;");  // a member, and no call
}

TEST(Rewriter, TernariesAndBranches) {
  EXPECT_EQ(body("x = c ? a * b : d ? -e : f;"), "x = c ? MUL(a , b) : d ? NEG(e) : f;");
  EXPECT_EQ(body("if (a % b == 0) x = -y; else { y = a * b; }"),
            "if (MOD(a , b) == 0) x = NEG(y); else { y = MUL(a , b); }");
  EXPECT_EQ(body("switch (a % 3) { case 0: x = a * b; break; default: return; }"),
            "switch (MOD(a , 3)) { case 0: x = MUL(a , b); break; default: return; }");
}

TEST(Rewriter, Declarations) {
  EXPECT_EQ(body("highp uint a = b * c, d = e >> 1;"), "highp uint a = MUL(b , c), d = SHR(e , 1);");
  EXPECT_EQ(body("hn_uint k = a % b;"), "hn_uint k = MOD(a , b);");
  EXPECT_EQ(body("const float k = 2.0 * 3.0;"), "const float k = 2.0 * 3.0;");  // may call nothing
  EXPECT_EQ(*rewrite("const int n = 2 * 3;\nuniform float u;\n", kAll), "const int n = 2 * 3;\nuniform float u;\n");
  EXPECT_EQ(*rewrite("struct S { float a; };\nfloat f(float x) { return x * x; }\n", kAll),
            "struct S { float a; };\nfloat f(float x) { return MUL(x , x); }\n");
}

TEST(Rewriter, Loops) {
  EXPECT_EQ(body("for (int i = 0; i < n * 2; ++i) { x = a * b; }"),
            "for (int i = 0; i < MUL(n , 2); ++i) { x = MUL(a , b); }");
  EXPECT_EQ(body("while (a % b > 0) a = a + 1; do { c = -c; } while (c < 0);"),
            "while (MOD(a , b) > 0) a = ADD(a , 1); do { c = NEG(c); } while (c < 0);");
  EXPECT_EQ(body("for (; i < n;) {}"), "for (; i < n;) {}");
  const Rules loops = {
      .before_loop = "B;", .in_loop = "I;", .after_loop = "A;", .condition = "&& C", .initializer = " + 1"};
  EXPECT_EQ(body("for (int i = 0; i < n; ++i) f();", loops),
            "{ B; for (int i = 0 + 1; (i < n) && C; ++i) { I; f(); } A; }");
  EXPECT_EQ(body("int a = 0;\n  while (a < n) { f(); }", loops),
            "int a = 0;\n  { B; while ((a < n) && C) { I; { f(); } } A; }");
}

TEST(Rewriter, PreprocessorLinesStayAndMacrosThatAreExpressionsDoNot) {
  constexpr std::string_view kSame =
      "#if (HN_HASH & (HN_HASH * 1)) == 0\n#define N (2 * 3)\n#define ARGS(s) , s * s\n"
      "#define NOTHING(s)\n#error a * b\n#endif\n";
  EXPECT_EQ(*rewrite(kSame, kAll), kSame);
  EXPECT_EQ(*rewrite("#define HASH(k) (((k) ^ ((k) >> 16)) * 0x045D9F3Bu)\n", kAll),
            "#define HASH(k) (MUL((XOR((k) , (SHR((k) , 16)))) , 0x045D9F3Bu))\n");
  Rules without = kAll;
  without.in_macros = false;
  EXPECT_EQ(*rewrite("#define TWICE(k) ((k) * 2)\n", without), "#define TWICE(k) ((k) * 2)\n");
  EXPECT_EQ(body("\n#if X\nreturn a * b;\n#else\nreturn a;\n#endif\n"),
            "\n#if X\nreturn MUL(a , b);\n#else\nreturn a;\n#endif\n");
}

TEST(Rewriter, AMacroMayBringItsOwnComma) {
  EXPECT_EQ(body("x = f(a * b SEEDED(c));"), "x = f(MUL(a , b) SEEDED(c));");
}

TEST(Rewriter, LinesStayWhereTheyAre) {
  constexpr std::string_view kCode = "void f() {\n  x = a *\n      b;  // a * b\n  /* c\n  * d */ y ^=\n  z >> 3;\n}\n";
  const auto code = rewrite(kCode, kAll);
  ASSERT_TRUE(code);
  EXPECT_EQ(*code, "void f() {\n  x = MUL(a ,\n      b);  // a * b\n  /* c\n  * d */ y = XOR(y ,\n  SHR(z , 3));\n}\n");
  EXPECT_EQ(std::count(code->begin(), code->end(), '\n'), std::count(kCode.begin(), kCode.end(), '\n'));
}

TEST(Rewriter, OnlyConstants) {
  Rules folding = kAll;
  folding.only_constants = true;
  folding.minus = "";
  EXPECT_EQ(body("x = 2.0 * 3.0 * y + (1u << 3);", folding), "x = MUL(2.0 , 3.0) * y + (SHL(1u , 3));");
  EXPECT_EQ(body("x *= 2.0;", folding), "x *= 2.0;");
}

// Whatever is missing, it comes to an end.
TEST(Rewriter, TextThatIsCutOffEnds) {
  for (const EmbeddedFile& file : kLibraryFiles) {
    for (std::size_t length = 0; length < file.text.size(); length += 397) {
      const auto code = rewrite(file.text.substr(0, length), kAll);
      EXPECT_TRUE(code || !code.error().message.empty());
    }
  }
}

TEST(Rewriter, WhatItCannotReadIsAnError) {
  for (const std::string_view code : {"x = a *;", "x = (a;", "x = f(a;", "x = a ? b;", "if a { }", "x = ;"}) {
    EXPECT_TRUE(body(code).starts_with("error: ")) << code;
  }
  EXPECT_FALSE(rewrite("void f() { x = a;", kAll));
}

}  // namespace
}  // namespace hn
