#include "report/digest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "base/file.hpp"
#include "base/strings.hpp"
#include "base/version.hpp"
#include "expected/exact_sets.hpp"
#include "library/timed.hpp"
#include "output/checksum.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;  // with its keys in order

constexpr std::string_view kFormat = "hashnoise-digest 1";
constexpr std::string_view kFilePrefix = "digest-";
constexpr std::string_view kFileSuffix = ".json";
constexpr std::size_t kMostBytesRead = 400;
constexpr std::size_t kMostNameBytes = 96;
constexpr std::string_view kSafe = "()+,./:;@_-";  // beside letters and digits
constexpr std::size_t kMostFailed = 12;

// Empty for what is no driver of a device.
std::string_view api_of(std::string_view driver) {
  if (driver == kReferenceCompiler || driver == "metal-stand-in") return "";
  if (driver.starts_with("webgl2")) return "webgl2";
  if (driver == "webgpu") return "webgpu";
  if (driver.starts_with("vulkan:")) return "vulkan";
  return driver.ends_with("-gles") ? "opengles" : "opengl";
}

// The first of them, with one blank for all others that follow each other, and none in front.
std::string with_safe_characters(std::string_view text, std::size_t most) {
  std::string safe;
  for (const char c : text) {
    const bool is_safe = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                         kSafe.find(c) != std::string_view::npos;
    if (safe.size() == most) break;
    if (is_safe) {
      safe += c;
    } else if (!safe.empty() && safe.back() != ' ') {
      safe += ' ';
    }
  }
  return safe;
}

// A run's results for one API. A page runs WGSL beside WebGL2.
struct Part {
  std::map<std::string, std::array<std::size_t, 3>> counts;  // of a group: passed, failed, other
  std::map<std::size_t, std::uint32_t> checksums;            // by the numbers of sets

  void add(const CaseResult& result, const std::vector<std::string_view>& parts) {
    const Status status = result.outcome.status;
    const std::size_t kind = is_bad(status) ? 1 : status == Status::unsupported ? 2 : 0;
    // The cases of whole files are one group: there are many files.
    ++counts[fmt::format("{}.{}", parts[1] == "all" ? "files" : parts[0], parts[3])][kind];
    if (!result.outcome.checksum) return;
    const auto set = exact_set(function_of(result.id), parts[2], parts[3]);
    if (!set) return;
    // Versions and stages have a case each. A wrong result counts.
    const auto [entry, added] = checksums.emplace(*set, *result.outcome.checksum);
    if (!added && is_bad(status)) entry->second = *result.outcome.checksum;
  }

  Json json() const {
    Json groups = Json::object();
    bool failed = false;
    for (const auto& [group, numbers] : counts) {
      groups[group] = numbers;
      failed = failed || numbers[1] != 0;
    }
    std::map<std::string, std::vector<std::uint32_t>> words;
    std::vector<unsigned> digits((exact_sets().size() + 3) / 4);
    for (const auto& [set, checksum] : checksums) {
      const std::string_view function = exact_sets()[set].function;
      words[std::string(function.substr(0, function.find('.')))].push_back(checksum);
      digits[set / 4] |= 8u >> (set % 4);
    }
    Json sums = Json::object();
    for (const auto& [group, list] : words) {
      sums[group] = fmt::format("{:08x}", crc32_of(bytes_of(std::span<const std::uint32_t>(list))));
    }
    return {{"cases", groups},
            {"checksums", sums},
            {"sets", fmt::format("{:x}", fmt::join(digits, ""))},
            {"verdict", failed ? "fail" : "pass"}};
  }
};

// In percent of what Perlin noise costs in the plane with floats; null if nothing was timed.
Json costs_of(const Run& run) {
  if (run.timings.empty()) return {};
  std::map<std::string, double> ratios;
  const Json timings = Json::parse(run.timings, nullptr, false);
  if (!timings.is_object() || !timings.contains("functions")) return {};
  for (const Json& function : timings.at("functions")) {
    if (!function.is_object() || !function.contains("id") || !function.contains("ratio")) continue;
    if (!function.at("id").is_string() || !function.at("ratio").is_number()) continue;
    const auto id = function.at("id").get<std::string>();
    const std::string name = id.substr(0, id.rfind('.'));
    const std::string setting = id.substr(name.size());
    if (std::ranges::find(kTimed, name) == kTimed.end()) continue;
    if (setting == ".lattice") ratios[name + ".fast"] = function.at("ratio").get<double>();
    if (setting == ".lattice+fixed") ratios[name + ".fixed"] = function.at("ratio").get<double>();
  }
  const double unit = ratios["noise2d.perlin.fast"];
  if (!(unit > 0.0)) return {};
  Json costs = Json::object();
  for (const auto& [name, ratio] : ratios) {
    const double percent = std::round(100.0 * ratio / unit);
    if (percent >= 1.0 && percent <= 1e6) costs[name] = static_cast<std::int64_t>(percent);
  }
  return costs;
}

Json device_of(const Run& run) {
  Json device = {{"renderer", without_builds(run.info.renderer)}, {"vendor", without_builds(run.info.vendor)}};
  // In a browser the renderer's name has the driver's. The compiler of the suite's shaders for Vulkan is no driver.
  const std::string_view version = run.info.gl_version;
  if (run.info.browser.empty()) device["driver"] = without_builds(version.substr(0, version.find(", glslang")));
  return device;
}

}  // namespace

std::string without_builds(std::string_view text) {
  static const std::regex kCommit(R"( ?\(git-[0-9a-f]+\)|\b[0-9a-f]{8,}\b)");
  static const std::regex kVersion(R"((\d+\.\d+)(\.\d+)+)");
  // A driver may return anything, and the library's regular expressions take stack for each character.
  std::string name = with_safe_characters(text, kMostBytesRead);
  name = std::regex_replace(name, kCommit, "");
  name = std::regex_replace(name, kVersion, "$1");
  name = with_safe_characters(name, kMostNameBytes);
  if (name.ends_with(' ')) name.pop_back();
  return name.empty() ? "unknown" : name;
}

std::string digest_file(const Run& run) {
  std::string name = run.driver;
  std::replace(name.begin(), name.end(), ':', '-');
  return fmt::format("{}{}{}", kFilePrefix, name, kFileSuffix);
}

bool is_digest_file(std::string_view name) { return name.starts_with(kFilePrefix) && name.ends_with(kFileSuffix); }

std::optional<std::string> digest_text(const Run& run) {
  const std::string_view api = api_of(run.driver);
  const bool whole = run.shard.empty() && run.not_run == 0 && run.injected.empty() && !run.library;
  if (api.empty() || !run.absent.empty() || run.golden.empty() || !whole || run.count(Status::pass) == 0) return {};
  std::map<std::string, Part> parts;
  std::vector<std::string> failed;
  for (const CaseResult& result : run.cases) {
    const auto names = split(result.id, '.');
    if (names.size() != 7) return {};
    parts[names[5] == "wgsl" ? "webgpu" : std::string(api)].add(result, names);
    if (is_bad(result.outcome.status) && failed.size() < kMostFailed) failed.push_back(result.id);
  }
  Json apis = Json::object();
  for (const auto& [name, part] : parts) apis[name] = part.json();
  Json digest = {{"apis", apis},
                 {"device", device_of(run)},
                 {"format", kFormat},
                 {"golden", run.golden},
                 {"system", run.info.system.empty() ? "unknown" : without_builds(run.info.system)},
                 {"version", library_version()}};
  if (!run.info.browser.empty()) digest["browser"] = without_builds(run.info.browser);
  if (Json costs = costs_of(run); !costs.is_null()) digest["costs"] = costs;
  // Names are evidence; the first few are enough.
  for (;; failed.pop_back()) {
    digest["failed"] = failed;
    const std::string text = digest.dump() + "\n";
    if (text.size() <= kMostDigestBytes) return text;
    if (failed.empty()) return {};
  }
}

}  // namespace hn
