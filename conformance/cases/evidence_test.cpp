#include "cases/evidence.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <tuple>

#include "base/folder.hpp"
#include "fault/faults.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

constexpr std::string_view kRight = "0x2C1B3C6Du";  // of the lattice hash
constexpr std::string_view kWrong = "0x2C1B3C6Fu";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

SourceSet changed(const std::string& file, std::string_view what, std::string_view by) {
  SourceSet sources = SourceSet::embedded();
  sources.add(file, replaced(sources.find(file)->text, what, by), file);
  return sources;
}

class EvidenceOf : public OnOsmesa<> {
 protected:
  // Runs the case on a library, and makes its evidence.
  std::optional<Evidence> evidence(const SourceSet& sources, const std::string& id,
                                   const std::filesystem::path& pick = {}) {
    Session session(
        {.sources = sources, .reference = reference_, .golden_directory = HN_GOLDEN_DIRECTORY, .seed = 1, .pick = pick},
        *context_, 4096);
    const Case test = case_named(id);
    outcome_ = run_case(session, test).outcome;
    return make_evidence(session, test, outcome_);
  }

  // "red", "green", or the fault.
  std::string colour(const std::string& shader, const std::string& profile) {
    const SourceSet none;
    const auto vertex = expand(none, profile_named(profile), vertex_shader());
    const auto program = Program::build(*context_, *vertex, {shader, {"the shader"}});
    if (!program) return program.error().text();
    const auto pixel = draw_pixel(*context_, *program);
    if (!pixel) return pixel.error().text();
    if (*pixel == std::array<std::uint8_t, 4>{255, 0, 0, 255}) return "red";
    return *pixel == std::array<std::uint8_t, 4>{0, 255, 0, 255} ? "green" : "another colour";
  }

  ReferenceCompiler reference_;
  Outcome outcome_;
};

TEST_F(EvidenceOf, AWrongConstantIsRedAndTheRightOneGreen) {
  const SourceSet wrong = changed("detail/word.glsl", kRight, kWrong);
  for (const std::string profile : {"gl140", "gl330", "es300"}) {
    for (const std::string function : {"noise2d.perlin.lattice.fast", "hash.lattice3.lattice.exact",
                                       "gradient.lattice2.lattice.exact", "fbm.clouds3.lattice.fast"}) {
      const std::string id = function + ".fragment." + profile + ".golden";
      SCOPED_TRACE(id);
      const auto found = evidence(wrong, id);
      ASSERT_TRUE(found);
      EXPECT_EQ(outcome_.status, Status::fail);
      EXPECT_EQ(colour(found->shader, profile), "red") << found->note << found->shader;
      EXPECT_EQ(colour(replaced(found->shader, kWrong, kRight), profile), "green");
      for (const char* left_out : {"#if", "#define", "#line", "(uint k) {\n", "hn_simplex", "hn_value("}) {
        EXPECT_EQ(found->shader.find(left_out), std::string::npos) << left_out;
      }
      EXPECT_LT(std::ranges::count(found->shader, '\n'), function.starts_with("fbm") ? 420 : 210) << found->shader;
      EXPECT_NE(found->note.find("The shader is red on this driver"), std::string::npos) << found->note;
    }
  }
}

TEST_F(EvidenceOf, TheShaderIsAsShortAsToolsPickWritesIt) {
  const auto pick = std::filesystem::path(HN_GOLDEN_DIRECTORY).parent_path().parent_path().parent_path() / "tools/pick";
  const SourceSet wrong = changed("detail/word.glsl", kRight, kWrong);
  const std::tuple<std::string, std::string, int> kMost[] = {{"hash.lattice2.lattice.exact", "gl330", 35},
                                                             {"noise2d.perlin.lattice.fast", "es300", 52},
                                                             {"noise2d.perlin.lattice.precise", "gl400", 80},
                                                             {"fbm.fbm2.lattice.fast", "gl140", 76}};
  for (const auto& [function, profile, lines] : kMost) {
    const std::string id = fmt::format("{}.fragment.{}.golden", function, profile);
    SCOPED_TRACE(id);
    const auto found = evidence(wrong, id, pick);
    ASSERT_TRUE(found);
    EXPECT_EQ(colour(found->shader, profile), "red") << found->note << found->shader;
    EXPECT_EQ(colour(replaced(found->shader, kWrong, kRight), profile), "green") << found->shader;
    EXPECT_LE(std::ranges::count(found->shader, '\n'), lines) << found->shader;
    EXPECT_NE(found->shader.find(outcome_.examples.front().got), std::string::npos) << found->shader;
  }
  const auto nan = evidence(changed("detail/direction.glsl", "(n, 1831)", "(sqrt(-1.0f - abs(n)), 1831)"),
                            "noise2d.perlin.lattice.fast.fragment.gl330.golden", pick);
  ASSERT_TRUE(nan);
  EXPECT_NE(nan->shader.find("sqrt(-1.0 - abs("), std::string::npos) << "the library has -1.0f: " << nan->shader;
}

// A script in place of tools/pick: its text for the shader, and whether that still shows the fault.
TEST_F(EvidenceOf, AShortShaderThatFailsOtherwiseIsNotShown) {
  struct Row {
    std::string_view what, by, script;
    bool is_shown;
  };
  constexpr std::string_view kHead = "#include \"../config.glsl\"\n";
  const auto refused = fmt::format("{}#extension GL_EXT_null_initializer : require\n", kHead);  // by Mesa alone
  for (const Row& row : {Row{kRight, kWrong, "cat", true},
                         {kRight, kWrong, "sed s/0x2C1B3C6Fu/0x2C1B3C6Du/", false},
                         {kRight, kWrong, "sed s/0x2C1B3C6Fu/0x2C1B3C61u/", false},
                         {kRight, kWrong, "sed s/uvec4/u4/", false},
                         {kRight, kWrong, "false", false},
                         {kHead, refused, "cat", true},
                         {kHead, refused, "sed /null_initializer/d", false}}) {
    SCOPED_TRACE(row.script);
    const TemporaryFolder folder;
    folder.write("pick", fmt::format("#!/bin/sh\n{} \"$2\" && echo '// short'\n", row.script));
    std::filesystem::permissions(folder.path() / "pick", std::filesystem::perms::owner_all);
    const auto found = evidence(changed("detail/word.glsl", row.what, row.by),
                                "hash.lattice2.lattice.exact.fragment.gl330.golden", folder.path() / "pick");
    ASSERT_TRUE(found);
    EXPECT_NE(found->shader, "") << found->note;
    EXPECT_EQ(found->shader.ends_with("// short\n"), row.is_shown) << found->shader;
  }
}

TEST_F(EvidenceOf, TheShaderSaysWhatItIs) {
  const auto found =
      evidence(changed("detail/word.glsl", kRight, kWrong), "hash.lattice2.lattice.exact.fragment.gl330.golden");
  ASSERT_TRUE(found);
  const Mismatch& first = outcome_.examples.front();
  EXPECT_EQ(found->shader.substr(0, 13), "#version 330\n");
  for (const std::string& part :
       {std::string("hash.lattice2.lattice.exact.fragment.gl330.golden"), std::string("llvmpipe"),
        std::string("(Metal);\n//           section 5.9: "), first.inputs, first.got, first.expected}) {
    EXPECT_NE(found->shader.find(part), std::string::npos) << part << found->shader;
  }
  EXPECT_EQ(found->shader.find("#line"), std::string::npos);
  EXPECT_EQ(found->shader.find("#include"), std::string::npos);
}

// Drivers define names that glslang does not.
TEST_F(EvidenceOf, TheWholeTextIsShownWhereTheBriefOneIsRight) {
  const std::string either =
      fmt::format("\n#ifdef GL_MESA_shader_integer_functions\n{}\n#else\n{}\n#endif\n", kWrong, kRight);
  const auto found =
      evidence(changed("detail/word.glsl", kRight, either), "hash.lattice2.lattice.exact.fragment.gl330.golden");
  ASSERT_TRUE(found);
  EXPECT_EQ(colour(found->shader, "gl330"), "red") << found->note << found->shader;
  EXPECT_NE(found->shader.find("#if"), std::string::npos);
}

TEST_F(EvidenceOf, AKnownBugIsShownWithItsRule) {
  SourceSet sources = SourceSet::embedded();
  ASSERT_TRUE(inject_into(sources, "abs_int"));
  const auto found = evidence(sources, "bugs.abs_of_int.any.exact.fragment.gl330.defined");
  ASSERT_TRUE(found);
  EXPECT_EQ(colour(found->shader, "gl330"), "red") << found->note << found->shader;
  EXPECT_NE(found->shader.find("// rule      GLSL 4.60 section 8.3: abs is x"), std::string::npos) << found->shader;
  EXPECT_LT(std::ranges::count(found->shader, '\n'), 40) << found->shader;
}

TEST_F(EvidenceOf, ThePicturesShowTheDifference) {
  const auto found =
      evidence(changed("detail/word.glsl", kRight, kWrong), "noise3d.perlin.lattice.fast.fragment.gl330.twin");
  ASSERT_TRUE(found);
  for (const std::string& picture : {found->got, found->reference, found->difference}) {
    EXPECT_EQ(picture.substr(0, 11), "iVBORw0KGgo") << "a PNG's first bytes";
  }
  EXPECT_NE(found->got, found->reference);
  EXPECT_GE(found->factor, 1.0);
  EXPECT_NE(found->note.find("of the 9216 points of the pictures are wrong"), std::string::npos) << found->note;
}

// A noise whose range is too large: no single value shows it, but the twin does.
TEST_F(EvidenceOf, APropertyIsShownByTheTwin) {
  const auto found = evidence(changed("detail/direction.glsl", "n, 1831)", "n, 3907)"),
                              "noise2d.perlin.lattice.fast.fragment.gl330.range");
  ASSERT_TRUE(found);
  EXPECT_EQ(colour(found->shader, "gl330"), "red") << found->note;
}

TEST_F(EvidenceOf, AShaderThatIsRefusedHasNoPictures) {
  const auto found =
      evidence(changed("detail/word.glsl", kRight, "0x2C1B3C6Dx"), "hash.word.lattice.exact.fragment.gl330.golden");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->got, "");
  EXPECT_NE(found->note.find("does not compile"), std::string::npos) << found->note;
  EXPECT_NE(colour(found->shader, "gl330").find("does not compile"), std::string::npos);
}

TEST_F(EvidenceOf, WhatIsRightHasNone) {
  EXPECT_FALSE(evidence(SourceSet::embedded(), "hash.word.fnv1.exact.fragment.gl330.golden"));
  EXPECT_EQ(outcome_.status, Status::pass);
  EXPECT_FALSE(evidence(SourceSet::embedded(), "hash.all.pcg.fast.fragment.gl330.driver")) << "not about values";
}

TEST_F(EvidenceOf, WhatNoValueShowsIsNotClaimed) {
  const SourceSet sources = SourceSet::embedded();
  Session session({sources, reference_, HN_GOLDEN_DIRECTORY, 1}, *context_, 4096);
  Outcome outcome = outcome_with(Status::fail, {"two fields are alike", {}});
  const Case test = case_named("noise2d.perlin.lattice.fast.fragment.gl330.mirror");
  for (const std::vector<std::uint32_t>& words : {std::vector<std::uint32_t>{}, {1, 2, 3, 4, 5, 6, 7, 8}}) {
    outcome.examples = {{0, words, "", "", ""}};
    const auto found = make_evidence(session, test, outcome);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->shader, "");
    EXPECT_EQ(found->got, "");
    EXPECT_NE(found->note.find("agrees with the C++ twin"), std::string::npos) << found->note;
  }
}

TEST_F(EvidenceOf, APixelThatIsNotDrawnIsAnError) {
  EXPECT_EQ(colour("#version 330\nvoid main() { discard; }\n", "gl330"), "nothing was drawn");
  EXPECT_EQ(colour("#version 330\nout vec4 c; void main() { c = vec4(0.0, 0.0, 1.0, 1.0); }\n", "gl330"),
            "another colour");
}

TEST(EvidenceBudget, IsForEachFunctionAndForAll) {
  EvidenceBudget budget;
  EXPECT_TRUE(budget.take({"a.b", "fnv1", "fast", Stage::fragment, "gl330", "golden"}));
  EXPECT_FALSE(budget.take({"a.b", "fnv1", "fast", Stage::fragment, "es300", "golden"}))
      << "the same in another version";
  EXPECT_TRUE(budget.take({"a.b", "fnv1", "fast", Stage::fragment, "gl330", "twin"}));
  EXPECT_FALSE(budget.take({"a.b", "pcg", "fast", Stage::fragment, "gl330", "golden"}));
  int taken = 0;
  for (int i = 0; i < 1000; ++i) {
    taken += budget.take({"f." + std::to_string(i), "x", "fast", Stage::fragment, "gl330", "twin"}) ? 1 : 0;
  }
  EXPECT_EQ(taken, 38);
  EXPECT_TRUE(budget.take({"bugs.x", "any", "exact", Stage::fragment, "gl330", "defined"})) << "it explains the others";
}

TEST(Window, HasThePointInTheMiddle) {
  std::vector<std::uint32_t> words(kInputWords, 0u);
  words[0] = std::bit_cast<std::uint32_t>(0x1p30f);
  words[1] = std::bit_cast<std::uint32_t>(-0.5f);
  words[2] = 7;
  const Words window = window_around(find_function("noise2d.perlin"), words);
  ASSERT_EQ(window.size(), kPictureSide * kPictureSide * kInputWords);
  const std::size_t middle = kMiddle * kPictureSide + kMiddle;
  EXPECT_TRUE(std::equal(words.begin(), words.end(), point(window, middle).begin()));
  // Far out, by a float's steps; near 0 by a part of a cell. Upwards is towards the first row.
  EXPECT_EQ(std::bit_cast<float>(point(window, middle + 1)[0]), 0x1p30f + 128.0f);
  EXPECT_EQ(std::bit_cast<float>(point(window, middle - kPictureSide)[1]), -0.5f + 0.03125f);
  EXPECT_EQ(point(window, 0)[2], 7u);
}

TEST(Window, OfWholeNumbersWrapsAround) {
  const std::vector<std::uint32_t> words(kInputWords, 0u);
  const std::size_t middle = kMiddle * kPictureSide + kMiddle;
  const Words line = window_around(find_function("hash.word"), words);
  EXPECT_EQ(point(line, middle - 1)[0], 0xFFFFFFFFu);
  EXPECT_EQ(point(line, middle - kPictureSide)[0], kPictureSide);
  const Words plane = window_around(find_function("hash.lattice2"), words);
  EXPECT_EQ(point(plane, middle + kPictureSide)[1], 0xFFFFFFFFu);
}

TEST(Pictures, OfEqualValuesHaveNoDifference) {
  const Words zeros(kPictureSide * kPictureSide * kOutputWords, 0u);
  const Pictures same = draw_pictures(find_function("hash.word"), zeros, zeros);
  EXPECT_EQ(same.got, same.reference);
  EXPECT_EQ(same.got, same.difference) << "black, both";
  EXPECT_EQ(same.factor, 1.0);
}

// One bit of one word, which no high byte shows.
TEST(Pictures, AmplifyTheSmallestDifference) {
  const Words zeros(kPictureSide * kPictureSide * kOutputWords, 0u);
  Words other = zeros;
  other[0] = 1;
  const Pictures pictures = draw_pictures(find_function("hash.word"), other, zeros);
  EXPECT_EQ(pictures.got, pictures.reference);
  EXPECT_NE(pictures.difference, pictures.reference);
  EXPECT_EQ(pictures.factor, 255.0 * 0x1p24);
}

TEST(Pictures, TakeValuesThatAreNoNumbers) {
  const Words zeros(kPictureSide * kPictureSide * kOutputWords, 0u);
  Words other = zeros;
  other[0] = 0x7FC00000u;
  other[4] = 0x7F800000u;
  const Pictures pictures = draw_pictures(find_function("noise2d.perlin"), other, zeros);
  EXPECT_NE(pictures.difference, draw_pictures(find_function("noise2d.perlin"), zeros, zeros).difference);
  EXPECT_EQ(pictures.factor, 1.0);
}

TEST(Shader, LosesItsComments) {
  EXPECT_EQ(without_comments("a // b\n// c\n\n#line 3 0\n  d;   \ne"), "a\n  d;\ne\n");
  EXPECT_EQ(without_comments(""), "");
}

}  // namespace
}  // namespace hn
