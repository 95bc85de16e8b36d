#include "web/wgsl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/temporary_folder.hpp"
#include "library/configurations.hpp"
#include "web/files.hpp"

namespace hn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kPython = "python3";
constexpr std::string_view kMain = "from translate.wgsl.evaluation import main\n\nmain()\n";

// The package of an embedded file of Python, as tools/lib has it.
std::string_view package_of(std::string_view file) {
  constexpr std::array<std::string_view, 4> kParsing = {"lines.py", "preprocessor.py", "syntax.py", "tokens.py"};
  return std::ranges::find(kParsing, file) == kParsing.end() ? "translate/wgsl" : "translate/parsing";
}

bool in_wgsl(const Case& test) { return profile_named(test.name.profile).language == Language::wgsl; }

std::string key_of(const Evaluation& evaluation) {
  return fmt::format("{} {}", evaluation.configuration.name, evaluation.function.id);
}

Result<void> write_into(const fs::path& folder, std::string_view name, std::string_view text) {
  return write_file(folder / name, text);
}

// A folder with the program and the library, both as Python finds them.
Result<void> prepare(const fs::path& folder, const SourceSet& sources) {
  fs::create_directories(folder / "translate" / "wgsl");
  fs::create_directories(folder / "translate" / "parsing");
  fs::create_directories(folder / "glsl" / "detail");
  HN_DO(write_into(folder, "__main__.py", kMain));
  for (const EmbeddedFile& file : kWebFiles) {
    if (file.name.ends_with(".py")) HN_DO(write_into(folder / package_of(file.name), file.name, file.text));
  }
  for (const auto& [name, file] : sources.files()) HN_DO(write_into(folder / "glsl", name, file.text));
  return {};
}

Result<void> run_python(const fs::path& folder) {
  const auto done =
      run_process({.program = kPython,
                   .arguments = {"-B", folder.string(), folder / "glsl", folder / "question", folder / "answer"},
                   .output = folder / "log"});
  if (done) return {};
  return tl::unexpected(Error{fmt::format("what translates to WGSL: {}", done.error().message), done.error().log});
}

// What is asked for with a configuration.
struct Group {
  std::string knobs;
  std::set<std::string_view> files;
  std::map<std::string_view, std::string_view> bodies;  // by function
};

// By the name of the configuration.
std::map<std::string, Group> groups_of(std::span<const Case> cases) {
  std::map<std::string, Group> groups;
  for (const Case& test : cases) {
    if (!in_wgsl(test) || !test.evaluation()) continue;
    const auto& [function, configuration, profile, variant, stage] = *test.evaluation();
    Group& group = groups[std::string(configuration.name)];
    group.knobs = knobs_of(configuration);
    group.files.insert(function.file);
    group.bodies[function.id] = function.body;
  }
  return groups;
}

}  // namespace

WgslShaders::WgslShaders(const SourceSet& sources, std::span<const Case> cases) {
  if (const auto made = make(sources, cases); !made) missing_ = made.error();
}

Result<void> WgslShaders::make(const SourceSet& sources, std::span<const Case> cases) {
  const std::map<std::string, Group> groups = groups_of(cases);
  if (groups.empty()) return {};
  if (sources.transform()) return fail("faults are injected into GLSL");
  const TemporaryFolder folder;
  HN_DO(prepare(folder.path(), sources));
  Json question = Json::array();
  for (const auto& [name, group] : groups) {
    question.push_back({{"knobs", group.knobs}, {"files", group.files}, {"bodies", Json::object()}});
    for (const auto& [function, body] : group.bodies) question.back()["bodies"][std::string(function)] = body;
  }
  HN_DO(write_into(folder.path(), "question", question.dump()));
  HN_DO(run_python(folder.path()));
  HN_TRY(const std::string text, read_file(folder.path() / "answer"));
  const Json answer = Json::parse(text);
  texts_ = answer.at("texts").get<std::vector<std::string>>();
  auto group = groups.begin();
  for (const Json& found : answer.at("groups")) {
    const std::string& configuration = (group++)->first;
    if (found.contains("error")) {
      errors_[configuration] = found.at("error");
      continue;
    }
    for (const auto& [function, numbers] : found.at("shaders").items()) {
      shaders_[fmt::format("{} {}", configuration, function)] = numbers.get<std::vector<std::size_t>>();
    }
  }
  return {};
}

tl::expected<std::vector<std::string>, Outcome> WgslShaders::find(const Evaluation& evaluation) const {
  if (missing_) return tl::unexpected(outcome_with(Status::unsupported, *missing_));
  if (const auto error = errors_.find(std::string(evaluation.configuration.name)); error != errors_.end()) {
    return tl::unexpected(outcome_with(Status::fail, {"the library has no translation to WGSL", error->second}));
  }
  std::vector<std::string> pieces;
  for (const std::size_t number : shaders_.at(key_of(evaluation))) pieces.push_back(texts_.at(number));
  return pieces;
}

}  // namespace hn
