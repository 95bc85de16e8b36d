#include "bench/foreign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

#include "base/file.hpp"
#include "bench/counts.hpp"

namespace hn {
namespace {

constexpr int kLowestVersion = 330;  // the shaders around the expression need it
constexpr std::ptrdiff_t kMostLogLines = 12;

// The parts of an argument. The file's name may have a colon in it only if the file exists.
struct Parts {
  std::string name;
  std::optional<std::string> version;
  std::string file;
  std::string expression;
};

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_word(std::string_view name) {
  return std::ranges::all_of(name, [](char c) { return is_of_word(c) || c == '-'; });
}

std::string first_word(const std::string& expression) {
  const auto begin = std::ranges::find_if(expression, is_of_word);
  const std::string word(begin, std::find_if_not(begin, expression.end(), is_of_word));
  return word.empty() ? "function" : word;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

Result<Parts> split(const std::string& argument, std::string_view option) {
  const auto wrong = [&](std::string_view what) {
    return fail(fmt::format("{} {}: {}; write FILE:EXPRESSION, as in other.glsl:snoise(p), or NAME=FILE:EXPRESSION",
                            option, argument, what));
  };
  Parts parts;
  const auto end = argument.find_first_of("=@:");
  const bool is_named = end != 0 && end != argument.npos && argument[end] != ':' && is_word(argument.substr(0, end));
  const auto equals = is_named ? argument.find('=', end) : argument.npos;
  if (is_named && equals == argument.npos) return wrong("there is no =");
  if (is_named) parts.name = argument.substr(0, end);
  if (is_named && end < equals) parts.version = argument.substr(end + 1, equals - end - 1);
  const std::string place = is_named ? argument.substr(equals + 1) : argument;
  auto colon = place.find(':');
  while (colon != std::string::npos && !is_file(place.substr(0, colon))) colon = place.find(':', colon + 1);
  if (colon == std::string::npos) {
    if (is_file(place)) return wrong("there is no expression");
    return wrong(fmt::format("there is no file \"{}\"", place.substr(0, place.find(':'))));
  }
  parts.file = place.substr(0, colon);
  parts.expression = place.substr(colon + 1);
  if (parts.expression.find_first_not_of(" \t\r\n") == std::string::npos) return wrong("there is no expression");
  if (!is_named) parts.name = first_word(parts.expression);
  if (parts.name == "empty") return wrong("the empty shaders have that name");
  return parts;
}

// The profile of a version from GLSL 3.30 on, by its number.
Result<std::string_view> profile_of(std::string_view number, const std::string& where) {
  std::vector<std::string> numbers;
  for (const Profile& profile : all_profiles()) {
    if (profile.es || profile.spirv || profile.version < kLowestVersion) continue;
    numbers.push_back(std::to_string(profile.version));
    if (numbers.back() == number) return profile.name;
  }
  return fail(fmt::format("{}: \"{}\" is not a version of GLSL that can be measured; there are {}", where, number,
                          fmt::join(numbers, ", ")));
}

// The profile for a #version line. Before GLSL 3.30 and ES 3.00 the shaders around the expression use GLSL 3.30.
Result<std::string_view> profile_of_line(std::string_view version, const std::string& where) {
  const auto digits = version.substr(0, version.find_first_not_of("0123456789"));
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool es = version.find("es", digits.size()) != std::string_view::npos;
  const bool early = error == std::errc() && (es || number < kLowestVersion);
  return early ? Result<std::string_view>("gl330") : profile_of(digits, where);
}

// Whether a block comment is open behind a line, from whether one is open before it.
bool is_comment_open_after(std::string_view line, bool open) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (!open && two == "//") return false;
    if (two != (open ? "*/" : "/*")) continue;
    open = !open;
    ++i;
  }
  return open;
}

// As users include the library; in the set its files have names without it.
constexpr std::string_view kLibrary = "hashnoise/";

// Reads a file with what it includes into a set, each once.
class Reader {
 public:
  Reader(SourceSet& sources, std::string name) : sources_(sources), name_(std::move(name)) {}

  // The name that the file has in the set.
  Result<std::string> add(const std::filesystem::path& path) {
    const auto [entry, is_new] =
        names_.try_emplace(std::filesystem::weakly_canonical(path), fmt::format("against/{}/{}", name_, names_.size()));
    const std::string name = entry->second;
    if (!is_new) return name;
    HN_TRY(const auto text, read_file(path));
    HN_TRY(auto adapted, adapt(text, path));
    sources_.add(name, std::move(adapted), path.string());
    return name;
  }

  // The first #version line of the file that was added first.
  const std::optional<std::string>& version() const { return version_; }
  const std::string& place_of_version() const { return place_of_version_; }

 private:
  // The text, fit to stand behind a #version line of ours, with the names of the set in its includes.
  Result<std::string> adapt(std::string_view text, const std::filesystem::path& path) {
    const bool is_first = names_.size() == 1;
    std::string adapted;
    bool in_comment = false;
    for (int number = 1; !text.empty(); ++number) {
      const std::string_view line = text.substr(0, text.find('\n'));
      const bool ends = line.size() < text.size();
      text.remove_prefix(line.size() + (ends ? 1 : 0));
      const auto directive = directive_of(line);
      if (directive && directive->word == "version" && is_first && !in_comment && !version_) {
        version_ = std::string(directive->rest.substr(0, directive->rest.find_first_of("\r/")));
        place_of_version_ = fmt::format("{}:{}", path.string(), number);
      }
      HN_TRY(const auto replaced, replace(line, path, in_comment));
      adapted += replaced;
      if (ends) adapted += '\n';
      in_comment = is_comment_open_after(line, in_comment);
    }
    return adapted;
  }

  Result<std::string> replace(std::string_view line, const std::filesystem::path& path, bool in_comment) {
    const auto directive = directive_of(line);
    const auto included = included_name(line);
    // In a comment an include is not one, and "//" changes nothing.
    if ((directive && directive->word == "version") || (included && in_comment)) return fmt::format("//{}", line);
    // Ours are put in already; drivers do not know glslang's extension.
    if (directive && directive->word == "extension" &&
        directive->rest.find("GL_GOOGLE_include_directive") != std::string_view::npos) {
      return fmt::format("//{}", line);
    }
    if (!included) return std::string(line);
    const auto neighbour = (path.parent_path() / *included).lexically_normal();
    if (is_file(neighbour)) {
      HN_TRY(const auto name, add(neighbour));
      return fmt::format("#include \"{}\"", name);
    }
    if (const auto ours = included->starts_with(kLibrary) ? included->substr(kLibrary.size()) : "";
        sources_.find(ours)) {
      return fmt::format("#include \"{}\"", ours);
    }
    // The compiler comes upon it unless an #if leaves it out.
    return fmt::format("#error there is no file {} to include", *included);
  }

  SourceSet& sources_;
  std::string name_;
  std::map<std::filesystem::path, std::string> names_;  // by where the files are
  std::optional<std::string> version_;
  std::string place_of_version_;
};

std::string first_lines(const std::string& log) {
  auto end = log.begin();
  for (std::ptrdiff_t i = 0; i < kMostLogLines && end != log.end(); ++i) {
    end = std::find(end, log.end(), '\n');
    if (end != log.end()) ++end;
  }
  const auto left = std::count(end, log.end(), '\n');
  const std::string text(log.begin(), end);
  return left == 0 ? text : fmt::format("{}and {} lines more\n", text, left);
}

// Whether a subject compiles, in a language that messages name.
using Trial = std::function<Result<void>(const Subject&)>;

Result<std::vector<Subject>> subjects_that_compile(const Foreign& foreign, std::string_view language,
                                                   const Trial& trial) {
  std::vector<Subject> subjects;
  std::vector<std::string> logs;
  const std::string expression = fmt::format("\n#include \"{}\"\n", foreign.expression);
  for (const int dimensions : {2, 3}) {
    Subject subject = foreign_subject(foreign.name, foreign.file, expression, dimensions, foreign.profile);
    const auto compiled = trial(subject);
    if (compiled) {
      subjects.push_back(std::move(subject));
    } else {
      const Error& error = compiled.error();
      logs.push_back(first_lines(error.log.empty() ? error.message + "\n" : error.log));
    }
  }
  if (!subjects.empty()) return subjects;
  const std::string log =
      logs[0] == logs[1] ? logs[0] : fmt::format("With a vec2 as p:\n{}With a vec3 as p:\n{}", logs[0], logs[1]);
  return fail(fmt::format("--against {}: this does not compile with {}, neither for a vec2 nor for a vec3; the "
                          "expression must be a float from p, and NAME@450=FILE:EXPRESSION requires GLSL 4.50",
                          foreign.argument, language),
              log);
}

}  // namespace

Result<Foreign> read_foreign(const std::string& argument, SourceSet& sources, std::string_view option) {
  HN_TRY(const auto parts, split(argument, option));
  Reader reader(sources, parts.name);
  HN_TRY(const auto file, reader.add(parts.file));
  const std::string expression = fmt::format("against/{}/expression", parts.name);
  sources.add(expression, parts.expression + "\n", fmt::format("the expression of {}", parts.name));
  Foreign foreign{.argument = argument, .name = parts.name, .file = file, .expression = expression};
  if (parts.version) {
    HN_TRY(foreign.profile, profile_of(*parts.version, fmt::format("{} {}", option, argument)));
  } else if (reader.version()) {
    HN_TRY(foreign.profile, profile_of_line(*reader.version(), reader.place_of_version()));
  }
  return foreign;
}

Result<std::vector<Subject>> foreign_subjects(Workbench& workbench, const Foreign& foreign) {
  if (const auto reason = workbench.unsupported(foreign.profile); !reason.empty()) {
    return fail(fmt::format("--against {}: {}", foreign.argument, reason));
  }
  // Not the shader that is timed: how long that one takes to compile is measured, and a driver may remember it.
  return subjects_that_compile(foreign, profile_named(foreign.profile).directive, [&](const Subject& subject) {
    return workbench.build(quad_shader(subject), subject.profile).map([](const Program&) {});
  });
}

Result<std::vector<Subject>> foreign_subjects(const SourceSet& sources, const ReferenceCompiler& reference,
                                              const Foreign& foreign) {
  const std::string language = fmt::format("{} for Vulkan", profile_named("vulkan").directive);
  return subjects_that_compile(foreign, language, [&](const Subject& subject) {
    return optimised_spirv(sources, reference, subject).map([](const auto&) {});
  });
}

}  // namespace hn
