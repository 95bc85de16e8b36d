#include "library/source.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/folder.hpp"
#include "library/files.hpp"

namespace hn {
namespace {

EditedLibrary copy_with(const TemporaryFolder& folder, std::initializer_list<std::string_view> changed) {
  for (const EmbeddedFile& file : kLibraryFiles) {
    const bool edited = std::find(changed.begin(), changed.end(), file.name) != changed.end();
    folder.write(std::string(file.name), std::string(file.text) + (edited ? "// edited\n" : ""));
  }
  const auto sources = SourceSet::from_directory(folder.path());
  EXPECT_TRUE(sources && sources->edited());
  return *sources->edited();
}

TEST(EditedLibrary, IsNoneWhereTheLibraryIsTheProgramsOwn) {
  EXPECT_FALSE(SourceSet::embedded().edited());
  EXPECT_FALSE(library_sources("")->edited());
  EXPECT_EQ(library_text({}), fmt::format("hashnoise {}", library_version()));
}

TEST(EditedLibrary, NamesItsFolderAndTheFilesThatDiffer) {
  const TemporaryFolder folder;
  const std::string original = fmt::format("hashnoise {}", library_version());
  const auto text_of = [&](std::initializer_list<std::string_view> changed) {
    EditedLibrary library = copy_with(folder, changed);
    EXPECT_EQ(library.folder, folder.path().string());
    EXPECT_EQ(library.digest.size(), 16u);
    library.folder = "my/copy";
    library.digest = "0123";
    return library_text(library);
  };
  EXPECT_EQ(text_of({}), "the library in my/copy (the same text as " + original + "; digest 0123)");
  EXPECT_EQ(text_of({"hash.glsl"}), "the library in my/copy (hash.glsl differs from " + original + "; digest 0123)");
  EXPECT_EQ(text_of({"config.glsl", "hash.glsl"}),
            "the library in my/copy (config.glsl, hash.glsl differ from " + original + "; digest 0123)");
  EXPECT_EQ(
      text_of({"config.glsl", "detail/arithmetic.glsl", "fbm.glsl", "gradient.glsl", "hash.glsl"}),
      "the library in my/copy (config.glsl, detail/arithmetic.glsl, fbm.glsl and 2 more of its files differ from " +
          original + "; digest 0123)");
}

TEST(EditedLibrary, HasAnotherDigestWithAnotherText) {
  const TemporaryFolder folder;
  const std::string same = copy_with(folder, {}).digest;
  EXPECT_EQ(copy_with(folder, {}).digest, same);
  EXPECT_NE(copy_with(folder, {"hash.glsl"}).digest, same);
}

TEST(EditedLibrary, IsReadAgain) {
  const TemporaryFolder folder;
  const EditedLibrary library = copy_with(folder, {"hash.glsl"});
  EXPECT_EQ(edited_library_from(nlohmann::json(to_json(library))), library);
  EXPECT_THROW(edited_library_from(nlohmann::json({{"folder", "x"}})), std::invalid_argument);
}

// A copy of the library with one file replaced.
SourceSet with_file(const TemporaryFolder& folder, std::string_view name, std::string_view text) {
  for (const EmbeddedFile& file : kLibraryFiles) folder.write(file.name, file.text);
  folder.write(name, text);
  return SourceSet::from_directory(folder.path()).value();
}

TEST(Source, IncludesAreReplacedAndLinesCounted) {
  const TemporaryFolder folder;
  const auto sources = with_file(folder, "hash.glsl", "one\ntwo\n");
  const auto shader = expand(sources, profile_named("gl330"), "a\n#include \"hash.glsl\"\nb\n");
  ASSERT_TRUE(shader) << shader.error().text();
  EXPECT_EQ(shader->text, "#version 330\n#line 2 0\na\n#line 10001 1\none\ntwo\n#line 4 0\nb\n");
}

// An include in a skipped branch counts as lines, and the #line behind it has no effect.
TEST(Source, LinesAreCountedAgainBehindABranchWithAnInclude) {
  SourceSet sources;
  sources.add("one", "1\n", "one");
  const std::string_view text = "#if 0\n#include \"one\"\n#else\na\n#endif\n#if 0\n#endif";
  const auto shader = expand(sources, profile_named("gl330"), text);
  ASSERT_TRUE(shader) << shader.error().text();
  EXPECT_EQ(shader->text,
            "#version 330\n#line 2 0\n#if 0\n#line 10001 1\n1\n#line 4 0\n#else\n#line 5 0\na\n#endif\n#line 7 0\n"
            "#if 0\n#endif");
}

TEST(Source, AFileOfTooManyLinesIsAnError) {
  SourceSet sources;
  const auto expand_lines = [&](std::size_t lines) {
    std::string text;
    for (std::size_t i = 0; i < lines; ++i) text += '\n';
    sources.add("long", text, "the long one");
    return expand(sources, profile_named("gl330"), "#include \"long\"\n");
  };
  EXPECT_TRUE(expand_lines(9999));
  const auto shader = expand_lines(10000);
  ASSERT_FALSE(shader);
  EXPECT_EQ(shader.error().message, "the long one: a file may have 9999 lines at the most");
}

TEST(Source, BeforeGlsl330LineNumbersAreOneLess) {
  const TemporaryFolder folder;
  const auto sources = with_file(folder, "hash.glsl", "one\n");
  const auto shader = expand(sources, profile_named("gl140"), "#include \"hash.glsl\"\nb\n");
  EXPECT_EQ(shader->text, "#version 140\n#line 1 0\n#line 10000 1\none\n#line 2 0\nb\n");
}

TEST(Source, TheEmbeddedLibraryExpandsCompletely) {
  const auto shader = expand(SourceSet::embedded(), profile_named("es300"), "#include \"hashnoise.glsl\"\n");
  ASSERT_TRUE(shader);
  EXPECT_EQ(shader->text.find("#include"), std::string::npos);
  EXPECT_NE(shader->text.find("hn_turbulence"), std::string::npos);
}

TEST(Source, MissingIncludeNamesFileAndLine) {
  const TemporaryFolder folder;
  const auto sources = with_file(folder, "hash.glsl", "one\n#include \"absent.glsl\"\n");
  const auto shader = expand(sources, profile_named("gl330"), "#include \"hash.glsl\"\n");
  ASSERT_FALSE(shader);
  EXPECT_EQ(shader.error().message,
            (folder.path() / "hash.glsl").string() + ":2: there is no \"absent.glsl\" to include");
}

TEST(Source, EndlessIncludeIsAnError) {
  const TemporaryFolder folder;
  const auto sources = with_file(folder, "hash.glsl", "#include \"hash.glsl\"\n");
  const auto shader = expand(sources, profile_named("gl330"), "#include \"hash.glsl\"\n");
  ASSERT_FALSE(shader);
  EXPECT_NE(shader.error().message.find("nested more than 16 deep"), std::string::npos);
}

// Eight times as many with every level: 8^10 of the last.
TEST(Source, IncludesThatMultiplyAreAnError) {
  SourceSet sources;
  sources.add("a", "x\n", "glsl/a");
  for (char name = 'b'; name <= 'k'; ++name) {
    std::string lines;
    for (int i = 0; i < 8; ++i) lines += fmt::format("#include \"{}\"\n", static_cast<char>(name - 1));
    sources.add(std::string(1, name), lines, fmt::format("glsl/{}", name));
  }
  const auto shader = expand(sources, profile_named("gl330"), "#include \"k\"\n");
  ASSERT_FALSE(shader);
  EXPECT_TRUE(shader.error().message.starts_with("glsl/")) << shader.error().message;
  EXPECT_NE(shader.error().message.find("longer than"), std::string::npos) << shader.error().message;
}

// How often a line stands in a text.
std::size_t count_of(std::string_view line, std::string_view text) {
  std::size_t count = 0;
  for (auto at = text.find(line); at != std::string_view::npos; at = text.find(line, at + 1)) ++count;
  return count;
}

TEST(Source, WhatAnIncludeHasBroughtAlreadyIsLeftOutBelowIt) {
  SourceSet sources;
  sources.add("guarded", "// shared\n#ifndef GUARD\n#define GUARD\nint guarded;\n#endif\n", "glsl/guarded");
  sources.add("open", "int open;\n", "glsl/open");
  for (const std::string name : {"a", "b"}) {
    sources.add(name, "#ifndef " + name + "\n#define " + name + "\n#include \"guarded\"\n#include \"open\"\n#endif\n",
                "glsl/" + name);
  }
  sources.add("both", "#include \"a\"\n#include \"b\"\n", "glsl/both");
  const auto once = expand(sources, profile_named("gl330"), "#include \"both\"\n");
  ASSERT_TRUE(once);
  EXPECT_EQ(count_of("int guarded;", once->text), 1u);
  EXPECT_EQ(count_of("int open;", once->text), 2u);  // the preprocessor would not leave it out
  // The first include of a shader may stand in a branch that is skipped, so the second brings everything again.
  const auto twice = expand(sources, profile_named("gl330"), "#if 0\n#include \"both\"\n#endif\n#include \"both\"\n");
  ASSERT_TRUE(twice);
  EXPECT_EQ(count_of("int guarded;", twice->text), 2u);
}

TEST(Source, WhatABranchHasBroughtMayBeMissingBehindIt) {
  SourceSet sources;
  sources.add("shared", "#ifndef SHARED\n#define SHARED\nint shared;\n#endif\n", "glsl/shared");
  sources.add("knob", "#ifndef KNOB\n#define KNOB\n#include \"shared\"\n#endif\n", "glsl/knob");
  sources.add("a", "#ifndef A\n#define A\n#if CHOSEN\n#include \"knob\"\n#endif\n#include \"shared\"\n#endif\n",
              "glsl/a");
  sources.add("both", "#include \"a\"\n#include \"knob\"\n", "glsl/both");
  const auto found = expand(sources, profile_named("gl330"), "#include \"both\"\n");
  ASSERT_TRUE(found);
  EXPECT_EQ(count_of("int shared;", found->text), 2u);  // in the branch and behind it
  EXPECT_EQ(count_of("#define KNOB", found->text), 2u);
}

TEST(Source, FolderWithoutAFileIsAnError) {
  const TemporaryFolder folder;
  for (const EmbeddedFile& file : kLibraryFiles) {
    if (file.name != "hash.glsl") folder.write(file.name, "");
  }
  const auto sources = SourceSet::from_directory(folder.path());
  ASSERT_FALSE(sources);
  EXPECT_NE(sources.error().message.find("/hash.glsl"), std::string::npos);
}

TEST(Source, LogsOfEveryVendorNameTheFile) {
  const ShaderText shader{"", {"the case's shader", "glsl/hashnoise/hash.glsl", "glsl/hashnoise/config.glsl"}};
  // Mesa reports source 0 whatever #line has; the line gives the file.
  EXPECT_EQ(shader.translate("0:10012(14): error: x"), "glsl/hashnoise/hash.glsl:12(14): error: x");
  EXPECT_EQ(shader.translate("ERROR: 2:20007: 'x'"), "ERROR: glsl/hashnoise/config.glsl:7: 'x'");
  EXPECT_EQ(shader.translate("1(10012) : error C1008"), "glsl/hashnoise/hash.glsl:12 : error C1008");
  EXPECT_EQ(shader.translate("ERROR: 0:5: main"), "ERROR: the case's shader:5: main");
}

TEST(Source, OtherNumbersInLogsStay) {
  const ShaderText shader{"", {"main"}};
  for (const char* log : {"", "12", "4.50", "C1008: x", "99999:99999: beyond", "1:99999999999", "a1:2", "at 3: none"}) {
    EXPECT_EQ(shader.translate(log), log);
  }
}

}  // namespace
}  // namespace hn
