#include "bench/amd.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "base/worker.hpp"
#include "bench/fragment_compiler.hpp"

namespace hn {
namespace {

namespace fs = std::filesystem;
using Shader = std::vector<std::uint32_t>;
using Results = std::vector<Result<AmdStatistics>>;

constexpr std::uint32_t kAmd = 0x1002;

constexpr std::array<std::string_view, 2> kFamilies = {"navi21", "vega10"};
constexpr std::size_t kLogEnd = 4000;

// The child's reports: first {"ready": true} or {"error": why no shader can be compiled}, then for each shader of the
// job {"statistics": {...}} or {"error": message}.
constexpr const char* kReady = "ready";
constexpr const char* kError = "error";
constexpr const char* kStatistics = "statistics";

// Ours, less everything that could change the counts.
std::vector<std::string> child_environment(std::string_view family, const std::string& drivers) {
  constexpr std::array<std::string_view, 5> kOthers = {"RADV_", "ACO_", "MESA_", "VK_", "NODEVICE_SELECT="};
  std::vector<std::string> variables = environment_without(kOthers);
  variables.insert(variables.end(),
                   {
                       fmt::format("RADV_FORCE_FAMILY={}", family), "RADV_DEBUG=nocache",
                       "MESA_SHADER_CACHE_DISABLE=true", "VK_DRIVER_FILES=" + drivers,
                       "VK_ICD_FILENAMES=" + drivers,  // the older name, all that Debian 12's loader knows
                       "NODEVICE_SELECT=1",  // Mesa's layer that sorts the GPUs, and asks a display server for it
                   });
  return variables;
}

Result<std::unique_ptr<FragmentCompiler>> open_radv() {
  HN_TRY(auto compiler, FragmentCompiler::open());
  if (compiler->vendor() != kAmd) return fail(fmt::format("{} is not an AMD GPU", compiler->device()));
  return compiler;
}

Result<AmdStatistics> amd_statistics(const ShaderStatistics& statistics) {
  AmdStatistics result;
  const std::array<std::pair<std::string_view, std::int64_t*>, 5> wanted = {{
      {"Instructions", &result.instructions},
      {"Inverse Throughput", &result.inverse_throughput},
      {"Latency", &result.latency},
      {"VGPRs", &result.vgprs},
      {"Code size", &result.code_size},
  }};
  for (const auto& [name, into] : wanted) {
    const auto found = statistics.find(name);
    if (found == statistics.end()) return fail(fmt::format("this RADV has no statistic \"{}\"", name));
    *into = static_cast<std::int64_t>(found->second);
  }
  return result;
}

struct Reply {
  bool ready = false;
  std::optional<std::string> no_source;
  Results results;
};

void take(Reply& reply, const nlohmann::json& report) {
  if (report.contains(kStatistics)) {
    reply.results.push_back(report.at(kStatistics).get<AmdStatistics>());
  } else if (report.contains(kError) && reply.ready) {
    reply.results.push_back(fail(report.at(kError)));
  } else if (report.contains(kError)) {
    reply.no_source = report.at(kError);
  } else {
    reply.ready = report.contains(kReady);
  }
}

// One child for as many of the shaders as it can do. If it does not reach the last, the one where it ended has an
// error, so that the next child can go on after it.
Result<Results> next_results(std::span<const Shader> shaders, const Launch& launch) {
  std::error_code none;
  fs::remove(launch.log, none);
  HN_TRY(auto child, Worker::start(shaders, launch));
  Reply reply;
  while (!child.end()) {
    for (const nlohmann::json& report : child.wait()) take(reply, report);
  }
  const std::string log = end_of_log(launch.log, kLogEnd);
  if (reply.no_source) return fail(*reply.no_source, log);
  if (!reply.ready) return fail(fmt::format("RADV does not start: its process {}", child.end()->text), log);
  if (reply.results.size() > shaders.size()) return fail("RADV's process has more results than shaders", log);
  if (reply.results.size() < shaders.size()) {
    reply.results.push_back(fail(fmt::format("RADV crashed on it: its process {}", child.end()->text), log));
  }
  return reply.results;
}

}  // namespace

std::span<const std::string_view> amd_families() { return kFamilies; }

Result<Results> amd_counts(std::string_view family, std::span<const Shader> shaders, const AmdSource& source) {
  const auto drivers = vulkan_drivers("radeon_icd", source.icd_directories);
  if (!drivers) return fail(fmt::format("Mesa's RADV is not here: {}", drivers.error().message));
  const TemporaryFolder folder;
  const Launch launch = {source.program,        kAmdCommand,  folder.path() / "job",
                         folder.path() / "log", source.limit, child_environment(family, *drivers)};
  Results results;
  while (results.size() < shaders.size()) {
    auto next = next_results(shaders.subspan(results.size()), launch);
    if (!next && results.empty()) return tl::unexpected(next.error());
    if (!next) {  // after a crash; what came before it is good
      results.resize(shaders.size(), tl::unexpected(next.error()));
      break;
    }
    results.insert(results.end(), next->begin(), next->end());
  }
  return results;
}

int amd_counts_child(const fs::path& job) {
  const auto radv = open_radv();
  if (!radv) {
    report({{kError, radv.error().text()}});
    return EXIT_FAILURE;
  }
  const auto text = read_file(job);
  if (!text) return EXIT_FAILURE;
  report({{kReady, true}});
  for (const auto& shader : nlohmann::json::parse(*text).get<std::vector<Shader>>()) {
    const auto statistics =
        (*radv)->compile(shader).and_then([](const CompiledShader& made) { return amd_statistics(made.statistics); });
    report(statistics ? nlohmann::json{{kStatistics, *statistics}}
                      : nlohmann::json{{kError, statistics.error().text()}});
  }
  return EXIT_SUCCESS;
}

}  // namespace hn
