#include "web/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/json.hpp"
#include "cases/bugs/bugs.hpp"
#include "expected/golden.hpp"
#include "expected/pairing.hpp"
#include "expected/tolerance.hpp"
#include "library/source.hpp"
#include "output/encoding.hpp"
#include "web/wgsl.hpp"

namespace hn {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page's numbers are little-endian");

// The page takes the first of the random points that other drivers take by default, since its size is that of its
// points.
constexpr std::uint64_t kPageSeed = 1;
constexpr std::size_t kPagePoints = 1024;
constexpr std::size_t kFurtherPagePoints = 128;  // of further functions, which are many

// Numbers values, so that each is stored once.
class Table {
 public:
  std::size_t number_of(const Json& value) {
    const auto [entry, added] = numbers_.try_emplace(value.dump(), values_.size());
    if (added) values_.push_back(value);
    return entry->second;
  }
  const Json& values() const { return values_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  Json values_ = Json::array();
};

class SuiteWriter {
 public:
  SuiteWriter(const SourceSet& sources, const std::filesystem::path& golden) : sources_(sources), golden_(golden) {}

  Json case_json(const Case& test) {
    auto part = part_of(test);
    if (!part) {
      if (is_bad(part.error().status)) defect_ = part.error().message;
      part = decided(part.error());
    }
    Json with_id = {{"id", test.id}};
    with_id.update(*part);
    return with_id;
  }

  const std::optional<std::string>& defect() const { return defect_; }

  Json finish(Json cases, std::string_view report_to, Platform platform, bool whole) {
    Json suite = {{"schema", 1}, {"version", library_version()}, {"api", api_of(platform)}};
    if (sources_.edited()) suite["library"] = to_json(*sources_.edited());
    if (!report_to.empty()) suite["report_to"] = report_to;
    if (whole) suite["golden"] = golden_checksum(golden_);
    suite["uniforms"] = {{"trips", {{"type", "int"}, {"value", kLoopTrips}}},
                         {"variant_seed", {{"type", "uint"}, {"value", kVariantSeed}}}};
    suite["texts"] = texts_.values();
    suite["shaders"] = shaders_.values();
    suite["programs"] = programs_.values();
    suite["data"] = data_.values();
    suite["cases"] = std::move(cases);
    return suite;
  }

 private:
  // A case without the browser, or its outcome if it has a fault of its own: the same as on a driver.
  using Part = tl::expected<Json, Outcome>;

  Part part_of(const Case& test) {
    return std::visit([this](const auto& kind) { return part(kind); }, *test.kind);
  }

  Part part(const CheckKind&) { throw std::logic_error("the page has no check that is written in C++"); }
  Part part(const ReferenceKind&) { throw std::logic_error("the page has no reference compiler"); }
  Part part(const PairingKind& kind) {
    const bool further = kind.evaluation.function.is_further();
    return same(kind.make(kind.evaluation, kPageSeed, further ? kFurtherPagePoints : kPagePoints));
  }

  static Json decided(const Outcome& outcome) {
    return {{"decided", {{"status", name_of(outcome.status)}, {"message", outcome.message}}}};
  }

  // The number of a shader. Its text is cut where files begin and end, since shaders have the files in common.
  tl::expected<std::size_t, Outcome> shader(const Profile& profile, std::string_view text, Status if_wrong) {
    const auto expanded = expand(sources_, profile, text);
    if (!expanded) return tl::unexpected(outcome_with(if_wrong, expanded.error()));
    Json pieces = Json::array();
    std::string piece;
    for (std::string_view rest = expanded->text; !rest.empty();) {
      const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
      rest.remove_prefix(line.size());
      const bool cut = line.starts_with("#line ");
      if (cut && !piece.empty()) pieces.push_back(texts_.number_of(std::exchange(piece, {})));
      piece += line;
      if (cut) pieces.push_back(texts_.number_of(std::exchange(piece, {})));
    }
    if (!piece.empty()) pieces.push_back(texts_.number_of(piece));
    return shaders_.number_of({{"pieces", pieces}, {"paths", expanded->paths}});
  }

  // The number of a program whose shader of that stage evaluates, or only compiles.
  tl::expected<std::size_t, Outcome> program(const Profile& profile, std::string_view text, Stage stage) {
    const bool of_vertices = stage == Stage::vertex;
    HN_TRY(const auto main, shader(profile, text, Status::fail));
    HN_TRY(const auto other, shader(profile, of_vertices ? idle_fragment_shader() : vertex_shader(), Status::error));
    return programs_.number_of(
        {{"stage", name_of(stage)}, {"vertex", of_vertices ? main : other}, {"fragment", of_vertices ? other : main}});
  }

  static std::string_view api_of(Platform platform) { return platform == Platform::webgpu ? "webgpu" : "webgl2"; }

  tl::expected<std::size_t, Outcome> program(const Evaluation& evaluation) {
    if (evaluation.profile.language == Language::wgsl) return wgsl_program(evaluation);
    return program(evaluation.profile, evaluation_shader(evaluation), evaluation.stage);
  }

  tl::expected<std::size_t, Outcome> wgsl_program(const Evaluation& evaluation) {
    const auto texts = wgsl_shader(sources_, evaluation);
    if (!texts) return tl::unexpected(outcome_with(Status::unsupported, texts.error()));
    Json pieces = Json::array();
    for (const std::string& text : *texts) pieces.push_back(texts_.number_of(text));
    const std::size_t shader = shaders_.number_of({{"pieces", pieces}, {"paths", Json::array()}});
    return programs_.number_of({{"stage", "compute"}, {"wgsl", shader}});
  }

  Part part(const CompilationKind& compilation) {
    const bool refused = !compilation.refusal.empty();
    if (refused) {
      HN_TRY(const auto fragment, shader(*compilation.profile, compilation.fragment(), Status::error));
      return Json{{"check", "refused"},
                  {"fragment", fragment},
                  {"names", compilation.refusal},
                  {"too_old", compilation.too_old}};
    }
    HN_TRY(const auto compiled, program(*compilation.profile, compilation.fragment(), Stage::fragment));
    return Json{{"check", "compiles"}, {"program", compiled}};
  }

  Part part(const GoldenKind& kind) {
    const Evaluation& evaluation = kind.evaluation;
    const Function& function = evaluation.function;
    const Configuration& configuration = evaluation.configuration;
    const auto golden = read_golden(golden_path(golden_, function), function, configuration);
    if (!golden) return tl::unexpected(outcome_with(Status::error, golden.error()));
    HN_TRY(const auto evaluated, program(evaluation));
    Json json = {{"check", "values"},
                 {"program", evaluated},
                 {"columns", columns_of(function)},
                 {"exact", has_exact_values(function, configuration)},
                 {"inputs", inputs_of(*golden)},
                 {"expected", expected_of(*golden, function, configuration)},
                 {"allowed", allowed_json(allowed_at(*golden, function, configuration))}};
    if (golden->digest) json["digest"] = digest_json(*golden->digest);
    return json;
  }

  Part same(const Pairing& pairing) {
    HN_TRY(const auto evaluated, program(pairing.evaluation));
    HN_TRY(const auto other, program(pairing.other));
    const Function& function = pairing.evaluation.function;
    return Json{{"check", "same"},
                {"program", evaluated},
                {"other", other},
                {"columns", columns_of(function)},
                {"other_columns", columns_of(pairing.other.function)},
                {"exact", pairing.exact},
                {"in_loop", pairing.in_loop()},
                {"factor", pairing.factor},
                {"words", pairing.words()},
                {"inputs", packed(pairing.inputs, function)},
                {"other_inputs", packed(pairing.other_inputs, pairing.other.function)},
                {"allowed", pairing.exact ? Json(0.0) : allowed_json(pairing.allowed)}};
  }

  Part part(const BugKind& kind) {
    const Bug& bug = *kind.bug;
    const Rule& rule = bug.rule_in(*kind.profile);
    HN_TRY(const auto evaluated, program(evaluation_of(bug, *kind.profile)));
    std::vector<std::uint32_t> inputs;
    std::vector<std::uint32_t> expected;
    for (const BugPoint& point : bug.points) {
      inputs.insert(inputs.end(), point.inputs.begin(), point.inputs.end());
      expected.insert(expected.end(), point.expected.begin(), point.expected.end());
    }
    Json json = {{"check", "bug"},          {"program", evaluated},           {"columns", columns_of(bug.function)},
                 {"inputs", data(inputs)},  {"expected", data(expected)},     {"allowed", rule.allowed},
                 {"defined", rule.defined}, {"note", bug.note(*kind.profile)}};
    if (bug.given) json["given"] = true;
    return json;
  }

  // The words that the function's columns use.
  std::size_t packed(const std::vector<std::uint32_t>& inputs, const Function& function) {
    std::vector<std::uint32_t> words;
    for (auto point = inputs.begin(); point != inputs.end(); point += kInputWords) {
      words.insert(words.end(), point, point + static_cast<std::ptrdiff_t>(function.inputs.size()));
    }
    return data(words);
  }

  template <typename T>
  std::size_t data(const std::vector<T>& numbers) {
    return data_.number_of(to_base64(bytes_of(std::span<const T>(numbers))));
  }

  std::size_t inputs_of(const Golden& golden) {
    std::vector<std::uint32_t> words;
    for (const GoldenRow& row : golden.rows) words.insert(words.end(), row.inputs.begin(), row.inputs.end());
    return data(words);
  }

  // Words if every bit counts, else doubles.
  std::size_t expected_of(const Golden& golden, const Function& function, const Configuration& configuration) {
    std::vector<std::uint32_t> words;
    std::vector<double> numbers;
    for (const GoldenRow& row : golden.rows) {
      for (std::size_t i = 0; i < row.values.size(); ++i) {
        words.push_back(result_bits(function.outputs[i], row.values[i]));
        // A word that is no float is compared as a word: signed or not makes no difference.
        numbers.push_back(function.is_name(i) ? static_cast<double>(static_cast<std::int32_t>(row.values[i]))
                                              : std::bit_cast<double>(row.values[i]));
      }
    }
    return has_exact_values(function, configuration) ? data(words) : data(numbers);
  }

  std::vector<double> allowed_at(const Golden& golden, const Function& function, const Configuration& configuration) {
    std::vector<double> allowed;
    std::vector<std::uint32_t> words(kInputWords);
    for (const GoldenRow& row : golden.rows) {
      std::copy(row.inputs.begin(), row.inputs.end(), words.begin());
      for (std::size_t output = 0; output < row.values.size(); ++output) {
        allowed.push_back(tolerance(function, configuration, words, output));
      }
    }
    return allowed;
  }

  // A number for all values, or data with one for each. (JSON has no infinity.)
  Json allowed_json(const std::vector<double>& allowed) {
    const bool constant = std::all_of(allowed.begin(), allowed.end(), [&](double a) { return a == allowed.front(); });
    if (!allowed.empty() && constant && std::isfinite(allowed.front())) return allowed.front();
    return {{"data", data(allowed)}};
  }

  static Json digest_json(const GoldenDigest& digest) {
    return {{"origin", digest.origin},
            {"size", digest.size},
            {"seed", digest.seed},
            {"fnv1a64", fmt::format("{:016x}", digest.fnv1a64)}};
  }

  const SourceSet& sources_;
  const std::filesystem::path& golden_;
  std::optional<std::string> defect_;
  Table texts_;
  Table data_;
  Table shaders_;
  Table programs_;
};

}  // namespace

LanguageSupport webgpu_languages() {
  LanguageSupport languages;
  languages.profiles = {"wgsl"};
  return languages;
}

std::string unsupported_in_browser(const Case& test, Platform platform) {
  if (!test.needs_driver()) return "this check is the harness's own: no driver takes part in it";
  const Profile& profile = profile_named(test.name.profile);
  if (profile.platform() != platform) return fmt::format("this is for drivers of {}", name_of(profile.platform()));
  const LanguageSupport languages = platform == Platform::webgpu ? webgpu_languages() : kWebGl2Languages;
  if (auto reason = unsupported_reason(profile, languages); !reason.empty()) return reason;
  return test.is<CheckKind>() ? "this check runs in the program only, not in a browser" : "";
}

bool is_on_page(const Case& test, bool thorough) {
  if (!thorough && !test.is_covered(true)) return false;
  if (unsupported_in_browser(test).empty()) return true;
  if (!unsupported_in_browser(test, Platform::webgpu).empty()) return false;
  return thorough || test.is<BugKind>() || test.evaluation()->configuration.name == "lattice+fixed";
}

PageSuite make_suite(const SourceSet& sources, const std::filesystem::path& golden, std::span<const Case> cases,
                     std::string_view report_to, Platform platform, bool whole) {
  SuiteWriter writer(sources, golden);
  Json list = Json::array();
  for (const Case& test : cases) list.push_back(writer.case_json(test));
  const Json suite = writer.finish(std::move(list), report_to, platform, whole);
  return {dump(suite), writer.defect()};
}

}  // namespace hn
