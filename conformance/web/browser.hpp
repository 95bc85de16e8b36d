// The cases in a real browser: headless Chromium, on a page that this process serves.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "cases/case.hpp"
#include "gpu/context_info.hpp"
#include "library/source.hpp"

namespace hn {

// A runner of cases reports these in this order: once the driver's information, or why it cannot be used here; then,
// for each case, that it begins and how it ended.
struct CaseEvents {
  std::function<void(const ContextInfo& info)> ready;
  std::function<void(const std::string& id)> started;
  std::function<void(const CaseResult& result)> finished;
  std::function<void(const std::string& why)> absent = {};  // in place of ready
};

struct Browser {
  std::string_view name;
  std::string_view description;
  std::vector<std::string_view> arguments;    // for Chromium, to take this implementation of OpenGL ES or WebGPU
  std::vector<std::string_view> environment;  // NAME=value
  std::string_view renderer;                  // what the renderer's name has in it then
  Platform platform = Platform::opengl;
  // In PATH. The first is Chromium without what draws windows, which starts in less than half of the time.
  std::vector<std::string_view> programs = {"chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"};
};

std::span<const Browser> all_browsers();

// Runs the cases with these ids, in their order, in a browser of its own, which ends with this function or with this
// process. If the context is lost, the case that ran is a crash, and the page continues with a new context. An error
// has the reason why the browser did not start or went away, with its message. The case that ran then has been started
// and not finished.
Result<void> run_in_browser(const Browser& browser, const SourceSet& sources, const std::filesystem::path& golden,
                            std::span<const std::string> ids, const CaseEvents& events);

// The browser's information. An error gives the reason why it is missing.
Result<ContextInfo> describe_browser(const Browser& browser);

}  // namespace hn
