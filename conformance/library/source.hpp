// The library's GLSL: its version, where it comes from, and how #include becomes text that any driver takes.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "library/profile.hpp"

namespace hn {

std::string library_version();  // "0.2.0"

struct EditedLibrary {
  std::string folder;                // as it was named
  std::string digest;                // of the text of its files
  std::vector<std::string> changed;  // its files that this program has with another text

  bool operator==(const EditedLibrary&) const = default;
};

// The library under test, for people: "hashnoise 0.2.0", or "the library in copy (perlin2d.glsl differs from hashnoise
// 0.2.0; digest 0123456789abcdef)".
std::string library_text(const std::optional<EditedLibrary>& library);

nlohmann::ordered_json to_json(const EditedLibrary& library);
// Throws the exceptions of base/json.hpp for anything else.
EditedLibrary edited_library_from(const nlohmann::json& json);

struct SourceFile {
  std::string text;
  std::string path;  // for messages
};

struct ShaderText;

// The files of one copy of glsl/hashnoise/, by their paths from there.
class SourceSet {
 public:
  static SourceSet embedded();  // as they were when this program was built
  static Result<SourceSet> from_directory(const std::filesystem::path& directory);

  // Adds a file that is not the library's, to be included as name and called path in messages.
  void add(std::string name, std::string text, std::string path);

  // How a folder's library differs from the one that this program was built with. Nothing for the embedded one.
  const std::optional<EditedLibrary>& edited() const { return edited_; }

  // Why there are no shaders of it in this language; empty if there are.
  std::string untranslated(const Profile& profile) const;

  // Null if there is no such file.
  const SourceFile* find(std::string_view name) const;
  const std::map<std::string, SourceFile, std::less<>>& files() const { return files_; }

  // The last step for every shader that is expanded from this set. There is none unless it is set.
  using Transform = std::function<Result<void>(ShaderText&, const Profile&)>;
  void transform_with(Transform transform) { transform_ = std::move(transform); }
  const Transform& transform() const { return transform_; }

 private:
  std::map<std::string, SourceFile, std::less<>> files_;
  std::optional<EditedLibrary> edited_;
  Transform transform_;
};

// A line for the preprocessor: the word behind its #, and what follows that word.
struct Directive {
  std::string_view word;
  std::string_view rest;  // begins with no space
};
// Nothing if the line is not such a line.
std::optional<Directive> directive_of(std::string_view line);
// The name in #include "name"; nothing for any other line.
std::optional<std::string_view> included_name(std::string_view line);

// The name in the set of what a file includes by that name: it is relative to the file.
std::string included_from(std::string_view file, std::string_view name);

// The files of a folder, or the embedded ones if no folder is named.
Result<SourceSet> library_sources(const std::string& directory);

// A shader with its includes expanded, and the way back from a line number in a log to a file and a line.
struct ShaderText {
  std::string text;
  std::vector<std::string> paths;  // by source number; 0 is the case's own shader

  // Replaces every "number:line" or "number(line)" that names a line of a file by "path:line".
  std::string translate(std::string_view log) const;
};

// The line that numbers the next one as a line of a source, by its number in ShaderText::paths.
std::string line_directive(const Profile& profile, int source, int line);

// Puts the #version line of the profile before main_text and expands #include "..." from the set. main_text may contain
// only includes of files in the set; a file that includes itself without end is an error.
Result<ShaderText> expand(const SourceSet& sources, const Profile& profile, std::string_view main_text);

}  // namespace hn
