// The program of an expression has the values of the functions in it. One is compiled for all tests, since that takes a
// second: what it computes depends on where its points are.
#define HN_ARITHMETIC HN_FIXED
#include <gtest/gtest.h>
#include <stdlib.h>

#include <hashnoise/hashnoise.hpp>
#include <nlohmann/json.hpp>

#include "bake/expression_program.hpp"
#include "bake/files.hpp"
#include "bake/positions.hpp"
#include "bake/tests/options_fixture.hpp"

namespace hn {
namespace {

const std::vector<std::string> kPlace = {"--size", "100x57", "--cells", "7x3", "--tile", "--seed", "9"};

// From cell 5000 on it divides by 0, as no compiler foresees.
const std::string kSource =
    "// Some GLSL.\nfloat sum(hn_place2 q, in vec2 p) {\n\tint d = max(5000 - int(p.x), 0);\n"
    "  return hn_simplex(q, 3u) - 0.3 * hn_cellular(q, 5u).yx.y + 0.1 * float(7 / d);\n}\n";
const std::string kExpression =
    "vec4(hn_fbm(place, 6, 2.0, 0.5, seed), hn_perlin(hn_tile(p, period), 4u), sum(place, p), p.x)";

tl::expected<BakeOptions, Stop> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return parsed(words);
}

BakeOptions options_of(const std::string& expression) {
  auto options = with({"--expression", expression, "--source", "sum.glsl"}, kPlace);
  EXPECT_TRUE(options) << options.error().err;
  options->expression->source_text = kSource;
  return *options;
}

std::vector<float> values_of(const std::vector<std::string>& function) {
  const auto options = with(function, kPlace);
  EXPECT_TRUE(options) << options.error().err;
  return compute(*options, {}).planes[0].values;
}

void expect_the_values_of_the_functions(const Planes& planes) {
  ASSERT_EQ(planes.planes.size(), 4u);
  EXPECT_EQ(planes.planes[0].values, values_of({"fbm"}));
  const Axis x = axis_of(0.0, 7.0, 100);
  const Axis y = axis_of(0.0, 3.0, 57);
  for (std::size_t i = 0; i < 5700; ++i) {
    using namespace hashnoise;
    const std::size_t column = i % 100;
    const std::size_t row = i / 100;
    const hn_place2 place =
        hn_tile(hn_place(ivec2(x.cell[column], y.cell[row]), vec2(x.f[column], y.f[row])), ivec2(7, 3));
    const float sum = hn_simplex(place, 3u) - 0.3f * hn_cellular(place, 5u).x + 0.1f * 0.0f;
    ASSERT_EQ(planes.planes[1].values[i], hn_perlin(hn_tile(vec2(x.p[column], y.p[row]), ivec2(7, 3)), 4u));
    ASSERT_EQ(planes.planes[2].values[i], sum) << column << " " << row;
    ASSERT_EQ(planes.planes[3].values[i], x.p[column]);
  }
}

TEST(Expression, OfSeveralNoises) {
  BakeOptions options = options_of(kExpression);
  const auto program = ExpressionProgram::make(options);
  ASSERT_TRUE(program) << program.error().message;
  EXPECT_EQ(program->components(), (std::vector<std::string>{"x", "y", "z", "w"}));
  std::atomic<std::size_t> rows = 0;
  const auto planes = compute(*program, options, [&](std::size_t done) { rows += done; });
  ASSERT_TRUE(planes) << planes.error().text();
  EXPECT_EQ(rows, 57u);
  expect_the_values_of_the_functions(*planes);

  // The bits do not depend on the number of processes, and parts may be chosen.
  options.components = {"z"};
  for (const int threads : {1, 3}) {
    options.threads = threads;
    const auto part = compute(*program, options, {});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->planes[0].values, planes->planes[2].values);
  }
  options.components = {"value"};
  EXPECT_THROW(compute(*program, options, {}), std::invalid_argument);

  // A crash is an error.
  options.components = {};
  options.origin = {5000.0, 0.0};
  const auto crash = compute(*program, options, {});
  ASSERT_FALSE(crash);
  EXPECT_NE(crash.error().message.find("ended by signal"), std::string::npos) << crash.error().message;
  EXPECT_NE(crash.error().message.find("divided by 0?"), std::string::npos) << crash.error().message;
}

TEST(Expression, IsRecordedWithItsSource) {
  const auto record = record_of(options_of("p.x"), {}, {});
  EXPECT_EQ(record.at("function"), "expression");
  const nlohmann::ordered_json settings = {
      {"expression", "p.x"}, {"source", kSource}, {"arithmetic", "fixed"}, {"seed", 9}, {"period", {7, 3}}};
  EXPECT_EQ(record.at("settings"), settings);
}

// The compiler has a name that does not exist.
TEST(Expression, WithoutACompiler) {
  const char* const before = getenv("CXX");
  const std::string kept = before ? before : "";
  setenv("CXX", "no-such-compiler -x", 1);
  const auto program = ExpressionProgram::make(options_of("p.x"));
  before ? setenv("CXX", kept.c_str(), 1) : unsetenv("CXX");
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().status, kNotBuilt);
  EXPECT_NE(program.error().message.find("install g++ or clang"), std::string::npos) << program.error().message;
}

}  // namespace
}  // namespace hn
