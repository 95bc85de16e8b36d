// Here is what the tests of browsers share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "base/entry_named.hpp"
#include "base/folder.hpp"
#include "web/browser.hpp"

namespace hn {

inline constexpr const char* kHash = "hash.vec2.pcg.exact.fragment.es300.golden";
inline constexpr const char* kNoise = "noise2d.perlin.lattice.fast.fragment.es300.golden";
inline constexpr const char* kCompiles = "fbm.all.lattice.fast.fragment.es300.driver";
inline constexpr const char* kRefused = "config.hash_beyond_the_last.any.fast.fragment.es300.refused_by_driver";
inline constexpr const char* kDesktop = "noise2d.perlin.lattice.fast.fragment.gl330.golden";
inline constexpr const char* kTwin = "noise2d.perlin.lattice.fast.fragment.gl330.twin";
inline constexpr const char* kWgsl = "noise2d.perlin.lattice.fixed.compute.wgsl.golden";
inline constexpr const char* kWgslHash = "hash.lattice2.lattice.exact.compute.wgsl.golden";
inline constexpr const char* kWgslSum = "fbm.fbm2.lattice.fast.compute.wgsl.golden";
inline const std::vector<std::string> kSome = {kHash, kNoise, kCompiles, kRefused};

// The events of a run, in their order.
struct Story {
  std::vector<ContextInfo> infos;
  std::vector<std::string> started;
  std::vector<CaseResult> finished;
  std::function<void(const std::string&)> on_start = [](const std::string&) {};

  CaseEvents events() {
    return {[this](const ContextInfo& info) { infos.push_back(info); },
            [this](const std::string& id) {
              started.push_back(id);
              on_start(id);
            },
            [this](const CaseResult& result) { finished.push_back(result); }};
  }
  std::vector<std::string> finished_ids() const {
    std::vector<std::string> ids;
    for (const CaseResult& result : finished) ids.push_back(result.id);
    return ids;
  }
  const Outcome& outcome(const std::string& id) const {
    return std::find_if(finished.begin(), finished.end(), [&](const CaseResult& r) { return r.id == id; })->outcome;
  }
};

inline const Browser& browser_named(std::string_view name) {
  return entry_named(all_browsers(), &Browser::name, name, "browser");
}

inline Result<void> run(Story& story, std::span<const std::string> ids, std::string_view browser = "webgl2",
                        const SourceSet& sources = SourceSet::embedded(),
                        const std::filesystem::path& golden = HN_GOLDEN_DIRECTORY) {
  return run_in_browser(browser_named(browser), sources, golden, ids, story.events());
}

// The prefix of a process's folders.
inline std::string folder_of(pid_t owner) { return TemporaryFolder::prefix(owner); }

// The processes of the Chromiums that a process has started. Each has inherited an output that goes to a log in a
// folder of that process; their command lines and environments do not all name it.
inline std::vector<pid_t> chromium_of(pid_t owner) {
  const std::string folder = (std::filesystem::temp_directory_path() / folder_of(owner)).string();
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t pid = std::atoi(entry.path().filename().c_str());
    std::error_code ended;
    const auto log = std::filesystem::read_symlink(entry.path() / "fd" / "2", ended);
    if (pid > 0 && !ended && log.string().starts_with(folder)) found.push_back(pid);
  }
  return found;
}

inline bool has_folders(pid_t owner) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path())) {
    if (entry.path().filename().string().starts_with(folder_of(owner))) return true;
  }
  return false;
}

inline void expect_nothing_is_left(pid_t owner) {
  using namespace std::chrono_literals;
  const auto deadline = std::chrono::steady_clock::now() + 10s;
  const auto left = [&] { return has_folders(owner) || !chromium_of(owner).empty(); };
  while (left() && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(has_folders(owner));
  EXPECT_TRUE(chromium_of(owner).empty());
}

}  // namespace hn
