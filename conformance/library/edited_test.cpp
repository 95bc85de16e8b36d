#include "library/edited.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/temporary_folder.hpp"
#include "base/version.hpp"
#include "library/files.hpp"
#include "library/source.hpp"

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

}  // namespace
}  // namespace hn
