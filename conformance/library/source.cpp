#include "library/source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <hashnoise/hashnoise.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/file.hpp"
#include "base/json.hpp"
#include "library/digest.hpp"
#include "library/files.hpp"

namespace hn {

std::string library_version() { return fmt::format("{}.{}.{}", HN_VERSION_MAJOR, HN_VERSION_MINOR, HN_VERSION_PATCH); }

namespace {

constexpr std::size_t kMostFilesNamed = 3;

std::string differences(const std::vector<std::string>& changed) {
  const std::string original = fmt::format("hashnoise {}", library_version());
  if (changed.empty()) return fmt::format("the same text as {}", original);
  const std::size_t named = std::min(changed.size(), kMostFilesNamed);
  const std::string names =
      fmt::format("{}", fmt::join(changed.begin(), changed.begin() + static_cast<std::ptrdiff_t>(named), ", "));
  if (named < changed.size()) {
    return fmt::format("{} and {} more of its files differ from {}", names, changed.size() - named, original);
  }
  return fmt::format("{} {} from {}", names, named == 1 ? "differs" : "differ", original);
}

}  // namespace

std::string library_text(const std::optional<EditedLibrary>& library) {
  if (!library) return fmt::format("hashnoise {}", library_version());
  return fmt::format("the library in {} ({}; digest {})", library->folder, differences(library->changed),
                     library->digest);
}

nlohmann::ordered_json to_json(const EditedLibrary& library) {
  return {{"folder", library.folder}, {"digest", library.digest}, {"changed", library.changed}};
}

EditedLibrary edited_library_from(const nlohmann::json& json) {
  return {text_at(json, "folder"), text_at(json, "digest"), texts_at(json, "changed")};
}

namespace {

// Each source gets its own range of line numbers, because Mesa reports source number 0 whatever #line has. No file of
// the library comes near so many.
constexpr int kLinesPerSource = 10000;
// The library nests 6 deep; a file that includes itself outside of its guard would go on for ever.
constexpr int kDeepestInclude = 16;
// And files without guards that include the next several times multiply with every level.
constexpr std::size_t kLongestText = std::size_t{8} << 20;

void skip_spaces(std::string_view& text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
}

// Whether a guard makes a second inclusion of the file empty: its first directive is #ifndef.
bool has_guard(std::string_view text) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size() - 1);
    if (const auto directive = directive_of(text.substr(0, end + 1))) return directive->word == "ifndef";
    text.remove_prefix(end + 1);
  }
  return false;
}

// Whether the preprocessor may have skipped what stands before this line.
bool ends_a_branch(std::string_view line) {
  const auto directive = directive_of(line);
  return directive && (directive->word == "endif" || directive->word == "else" || directive->word == "elif");
}

// By how many branches more the next line is in.
int change_of_branches(std::string_view line) {
  const auto directive = directive_of(line);
  if (!directive) return 0;
  return directive->word.starts_with("if") ? 1 : directive->word == "endif" ? -1 : 0;
}

class Expander {
 public:
  Expander(const SourceSet& sources, const Profile& profile) : sources_(sources), profile_(profile) {
    out_.paths.push_back("the case's shader");
  }

  Result<ShaderText> run(std::string_view main_text) {
    out_.text = fmt::format("{}\n", profile_.directive);
    mark_line(0, 2);
    HN_DO(add(main_text, "", 0, 2, 0));
    return std::move(out_);
  }

 private:
  void mark_line(int source, int line) { out_.text += line_directive(profile_, source, line); }

  int number_of(const std::string& path) {
    for (std::size_t i = 1; i < out_.paths.size(); ++i) {
      if (out_.paths[i] == path) return static_cast<int>(i);
    }
    out_.paths.push_back(path);
    return static_cast<int>(out_.paths.size()) - 1;
  }

  // `file` is the name of the text in the set.
  Result<void> add(std::string_view text, std::string_view file, int source, int line, int depth) {
    bool included = false;
    int branches = has_guard(text) ? -1 : 0;  // that the preprocessor may skip and this line is in
    for (; !text.empty(); ++line) {
      if (line == kLinesPerSource) {
        return fail(fmt::format("{}: a file may have {} lines at the most",
                                out_.paths[static_cast<std::size_t>(source)], line - 1));
      }
      const auto end = std::min(text.find('\n'), text.size() - 1);
      const std::string_view current = text.substr(0, end + 1);
      text.remove_prefix(end + 1);
      const auto name = included_name(current);
      if (!name) {
        out_.text += current;
        branches += change_of_branches(current);
        // In a branch that is skipped, the lines of an include count and its #line does not.
        if (included && ends_a_branch(current) && current.ends_with('\n')) mark_line(source, line + 1);
        continue;
      }
      const std::string where = fmt::format("{}:{}", out_.paths[static_cast<std::size_t>(source)], line);
      if (out_.text.size() > kLongestText) {
        return fail(fmt::format("{}: with its includes the shader is longer than {} bytes", where, kLongestText));
      }
      // Beside the file, or as if the set were a folder of the include path.
      std::string included_file = included_from(file, *name);
      if (!sources_.find(included_file)) included_file = *name;
      const SourceFile* found = sources_.find(included_file);
      if (!found) return fail(fmt::format("{}: there is no \"{}\" to include", where, *name));
      if (depth == kDeepestInclude) {
        return fail(fmt::format("{}: includes are nested more than {} deep", where, kDeepestInclude));
      }
      // Below the shader itself, a guarded file that this include has brought already is left out: else the text would
      // hold the shared files of the library once for every file that includes them.
      if (depth == 0) brought_.clear();
      included = true;
      const bool chosen = branches > 0;  // by a knob
      const auto brought_anyhow = chosen ? brought_ : std::set<const SourceFile*>{};
      if (has_guard(found->text) && !brought_.insert(found).second) {
        mark_line(source, line + 1);
        continue;
      }
      const int number = number_of(found->path);
      mark_line(number, 1);
      HN_DO(add(found->text, included_file, number, 1, depth + 1));
      if (chosen) brought_ = brought_anyhow;
      if (out_.text.back() != '\n') out_.text += '\n';
      mark_line(source, line + 1);
    }
    return {};
  }

  const SourceSet& sources_;
  const Profile& profile_;
  ShaderText out_;
  // By the include of the shader that is being expanded, with any knobs.
  std::set<const SourceFile*> brought_;
};

}  // namespace

std::optional<Directive> directive_of(std::string_view line) {
  skip_spaces(line);
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_spaces(line);
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto end = static_cast<std::size_t>(std::ranges::find_if_not(line, is_letter) - line.begin());
  Directive directive{line.substr(0, end), line.substr(end)};
  skip_spaces(directive.rest);
  return directive;
}

std::optional<std::string_view> included_name(std::string_view line) {
  const auto directive = directive_of(line);
  if (!directive || directive->word != "include" || !directive->rest.starts_with('"')) return std::nullopt;
  const auto end = directive->rest.find('"', 1);
  if (end == std::string_view::npos) return std::nullopt;
  return directive->rest.substr(1, end - 1);
}

std::string included_from(std::string_view file, std::string_view name) {
  return (std::filesystem::path(file).parent_path() / name).lexically_normal().generic_string();
}

SourceSet SourceSet::embedded() {
  SourceSet set;
  for (const EmbeddedFile& file : kLibraryFiles) {
    set.add(std::string(file.name), std::string(file.text), fmt::format("glsl/hashnoise/{}", file.name));
  }
  return set;
}

Result<SourceSet> SourceSet::from_directory(const std::filesystem::path& directory) {
  SourceSet set;
  EditedLibrary edited{.folder = directory.string(), .digest = {}, .changed = {}};
  std::uint64_t digest = kEmptyDigest;
  for (const EmbeddedFile& file : kLibraryFiles) {
    const auto path = directory / file.name;
    HN_TRY(auto text, read_file(path, "--glsl wants a folder with a copy of every file of glsl/hashnoise/"));
    digest = fnv1a64(text, digest);
    if (text != file.text) edited.changed.emplace_back(file.name);
    set.add(std::string(file.name), std::move(text), path.string());
  }
  edited.digest = fmt::format("{:016x}", digest);
  set.edited_ = std::move(edited);
  return set;
}

Result<SourceSet> library_sources(const std::string& directory) {
  return directory.empty() ? SourceSet::embedded() : SourceSet::from_directory(directory);
}

std::string SourceSet::untranslated(const Profile& profile) const {
  if (transform_ && !profile.in_glsl()) return "faults are injected into GLSL";
  if (profile.language != Language::wgsl) return "";
  const bool is_alike = std::ranges::all_of(kLibraryFiles, [this](const EmbeddedFile& file) {
    const SourceFile* own = find(file.name);
    return own && own->text == file.text;
  });
  if (is_alike) return "";
  return "this is WGSL of the library that hn-conform was built with: build hn-conform from the other copy";
}

void SourceSet::add(std::string name, std::string text, std::string path) {
  files_.insert_or_assign(std::move(name), SourceFile{std::move(text), std::move(path)});
}

const SourceFile* SourceSet::find(std::string_view name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : &found->second;
}

std::string ShaderText::translate(std::string_view log) const {
  std::string out;
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  // Looks for <digits> (':' | '(') <digits>; the second number gives file and line.
  for (std::size_t i = 0; i < log.size();) {
    std::size_t end = i;
    while (end < log.size() && is_digit(log[end])) ++end;
    if (end == i) {
      out += log[i++];
      continue;
    }
    const bool starts_word = i == 0 || !std::isalnum(static_cast<unsigned char>(log[i - 1]));
    int line = 0;
    if (starts_word && end + 1 < log.size() && (log[end] == ':' || log[end] == '(') && is_digit(log[end + 1])) {
      const auto [stop, error] = std::from_chars(&log[end + 1], log.data() + log.size(), line);
      const auto source = static_cast<std::size_t>(line / kLinesPerSource);
      if (error == std::errc() && source < paths.size()) {
        out += fmt::format("{}:{}", paths[source], line % kLinesPerSource);
        i = static_cast<std::size_t>(stop - log.data());
        if (log[end] == '(' && i < log.size() && log[i] == ')') ++i;
        continue;
      }
    }
    out += log.substr(i, end - i);
    i = end;
  }
  return out;
}

std::string line_directive(const Profile& profile, int source, int line) {
  const int number = source * kLinesPerSource + line - (profile.line_names_next() ? 0 : 1);
  if (profile.in_glsl()) return fmt::format("#line {} {}\n", number, source);
  // The others have a name in the second place. Compilers print this one as a number, as translate wants it.
  return fmt::format("#line {} \"0\"\n", number);
}

Result<ShaderText> expand(const SourceSet& sources, const Profile& profile, std::string_view main_text) {
  auto shader = Expander(sources, profile).run(main_text);
  if (!shader || !sources.transform()) return shader;
  HN_DO(sources.transform()(*shader, profile));
  return shader;
}

}  // namespace hn
