#include "bench/amd.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/process.hpp"
#include "bench/radv.hpp"
#include "gpu/vulkan_drivers.hpp"

namespace hn {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AmdStatistics, instructions, inverse_throughput, latency, vgprs, code_size)

namespace {

namespace fs = std::filesystem;
using Shader = std::vector<std::uint32_t>;
using Results = std::vector<Result<AmdStatistics>>;

constexpr std::array<std::string_view, 2> kFamilies = {"navi21", "vega10"};
constexpr std::size_t kLogEnd = 4000;
constexpr std::chrono::milliseconds kPoll{2};

// The lines of the child's result: first {"ready": true} or {"error": why no shader can be compiled}, then for each
// shader of the job {"statistics": {...}} or {"error": message}.
constexpr const char* kReady = "ready";
constexpr const char* kError = "error";
constexpr const char* kStatistics = "statistics";

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The files between us and the children of one call.
class Exchange {
 public:
  static Result<Exchange> make() {
    std::string path = (fs::temp_directory_path() / "hn-amd-XXXXXX").string();
    if (!mkdtemp(path.data())) return fail(fmt::format("cannot make a folder {}: {}", path, std::strerror(errno)));
    return Exchange(path);
  }
  Exchange(Exchange&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
  Exchange& operator=(Exchange&&) = delete;
  ~Exchange() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }

  fs::path job() const { return folder_ / "job"; }
  fs::path result() const { return folder_ / "result"; }
  fs::path log() const { return folder_ / "log"; }

 private:
  explicit Exchange(fs::path folder) : folder_(std::move(folder)) {}
  fs::path folder_;
};

// Ours, less everything that could change the counts.
std::vector<std::string> child_environment(std::string_view family, const std::string& drivers) {
  std::vector<std::string> variables = {
      fmt::format("RADV_FORCE_FAMILY={}", family),
      "RADV_DEBUG=nocache",
      "MESA_SHADER_CACHE_DISABLE=true",
      "VK_DRIVER_FILES=" + drivers,
      "VK_ICD_FILENAMES=" + drivers,  // the older name, which is all that the loader of Debian 12 knows
      "NODEVICE_SELECT=1",            // Mesa's layer that sorts the GPUs, and asks a display server for it
  };
  for (char** variable = environ; *variable; variable++) {
    const std::string_view text = *variable;
    const auto begins = [&](std::string_view prefix) { return text.starts_with(prefix); };
    constexpr std::array<std::string_view, 5> kOthers = {"RADV_", "ACO_", "MESA_", "VK_", "NODEVICE_SELECT="};
    if (std::none_of(kOthers.begin(), kOthers.end(), begins)) variables.emplace_back(text);
  }
  return variables;
}

Result<pid_t> start_child(const fs::path& program, const Exchange& files, std::vector<std::string> environment) {
  std::error_code none;
  fs::remove(files.log(), none);
  HN_TRY(const auto process, start_process({.program = program.string(),
                                            .arguments = {"amd-counts", files.job().string(), files.result().string()},
                                            .environment = std::move(environment),
                                            .output = files.log()}));
  return process.pid;
}

// How the child ended, in words. It is killed when nothing new has been in its result for as long as the limit.
std::string wait_for(pid_t pid, const fs::path& result, std::chrono::milliseconds limit) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_news = Clock::now();
  std::uintmax_t size = 0;
  int status = 0;
  bool killed = false;
  while (true) {
    const pid_t ended = waitpid(pid, &status, killed ? 0 : WNOHANG);
    if (ended == pid) break;
    if (ended < 0 && errno != EINTR) return fmt::format("was lost: {}", std::strerror(errno));
    std::error_code none;
    const std::uintmax_t size_now = fs::file_size(result, none);
    if (!none && size_now != std::exchange(size, size_now)) last_news = Clock::now();
    if (!killed && Clock::now() - last_news > limit) killed = ::kill(pid, SIGKILL) == 0;
    std::this_thread::sleep_for(kPoll);
  }
  if (killed) return fmt::format("was killed, with nothing new in {} s", std::chrono::duration<double>(limit).count());
  return describe_end(status);
}

struct Reply {
  bool ready = false;
  std::optional<std::string> no_source;
  Results results;
};

// What is whole in the child's result.
Reply read_reply(const fs::path& path) {
  Reply reply;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) break;
    if (json.contains(kStatistics)) {
      reply.results.push_back(json.at(kStatistics).get<AmdStatistics>());
    } else if (json.contains(kError) && reply.ready) {
      reply.results.push_back(fail(json.at(kError)));
    } else if (json.contains(kError)) {
      reply.no_source = json.at(kError);
    } else {
      reply.ready = json.contains(kReady);
    }
  }
  return reply;
}

// One child for as many of the shaders as it can do. If it does not reach the last, the one where it ended has an
// error, so that the next child can go on after it.
Result<Results> next_results(std::span<const Shader> shaders, const Exchange& files, const AmdSource& source,
                             const std::vector<std::string>& environment) {
  std::ofstream(files.job()) << nlohmann::json(shaders);
  std::ofstream(files.result());  // empties it
  HN_TRY(const auto child, start_child(source.program, files, environment));
  const std::string end = wait_for(child, files.result(), source.limit);

  std::string log = text_of(files.log());
  if (log.size() > kLogEnd) log.erase(0, log.size() - kLogEnd);
  Reply reply = read_reply(files.result());
  if (reply.no_source) return fail(*reply.no_source, log);
  if (!reply.ready) return fail(fmt::format("RADV does not start: its process {}", end), log);
  if (reply.results.size() > shaders.size()) return fail("RADV's process has more results than shaders", log);
  if (reply.results.size() < shaders.size()) {
    reply.results.push_back(fail(fmt::format("RADV crashed on it: its process {}", end), log));
  }
  return reply.results;
}

}  // namespace

std::span<const std::string_view> amd_families() { return kFamilies; }

Result<Results> amd_counts(std::string_view family, std::span<const Shader> shaders, const AmdSource& source) {
  const auto drivers = vulkan_drivers("radeon_icd", source.icd_directories);
  if (!drivers) return fail(fmt::format("Mesa's RADV is not here: {}", drivers.error().message));
  HN_TRY(const auto files, Exchange::make());
  const std::vector<std::string> environment = child_environment(family, *drivers);
  Results results;
  while (results.size() < shaders.size()) {
    auto next = next_results(shaders.subspan(results.size()), files, source, environment);
    if (!next && results.empty()) return tl::unexpected(next.error());
    if (!next) {  // after a crash; what came before it is good
      results.resize(shaders.size(), tl::unexpected(next.error()));
      break;
    }
    results.insert(results.end(), next->begin(), next->end());
  }
  return results;
}

int amd_counts_child(const fs::path& job, const fs::path& result) {
  std::ofstream out(result, std::ios::app);
  const auto write = [&](const nlohmann::json& line) { out << line << std::endl; };  // flushed: a crash may be next
  const auto radv = Radv::open();
  if (!radv) {
    write({{kError, radv.error().text()}});
    return EXIT_FAILURE;
  }
  std::ifstream in(job);
  const auto shaders = nlohmann::json::parse(in).get<std::vector<Shader>>();
  write({{kReady, true}});
  for (const Shader& shader : shaders) {
    if (const auto statistics = (*radv)->compile(shader)) {
      write({{kStatistics, *statistics}});
    } else {
      write({{kError, statistics.error().text()}});
    }
  }
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace hn
