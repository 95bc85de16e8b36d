#include "web/chromium.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "base/process.hpp"

namespace hn {
namespace {

namespace fs = std::filesystem;

// Options that keep Chromium from doing anything but show the page.
constexpr std::array<std::string_view, 18> kArguments = {
    "--headless=new",
    "--no-first-run",
    "--no-default-browser-check",
    "--no-proxy-server",
    "--disable-background-networking",
    "--disable-breakpad",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-dev-shm-usage",  // it is small in containers
    "--disable-extensions",
    "--disable-sync",
    "--mute-audio",
    "--password-store=basic",
    // A page that nobody sees is not to be slowed down.
    "--disable-background-timer-throttling",
    "--disable-renderer-backgrounding",
    // A lost context is a verdict about a case, and must not keep the others from theirs; and how long a case may take
    // is for hn-conform to decide.
    "--disable-domain-blocking-for-3d-apis",
    "--disable-gpu-process-crash-limit",
    "--disable-gpu-watchdog",
};

// Variables that would choose another driver, or lead Chromium to the user's desktop and files.
constexpr std::array<std::string_view, 14> kDropped = {
    "ANGLE_", "CHROMIUM_FLAGS=", "DBUS_",   "DISPLAY=", "EGL_", "GALLIUM_",        "HOME=", "LIBGL_",
    "LP_",    "MESA_",           "TMPDIR=", "VK_",      "XDG_", "WAYLAND_DISPLAY="};

// On a machine with other drivers as well, EGL would ask those first.
constexpr const char* kMesaEgl = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";

std::vector<std::string> environment_of(const Browser& browser, const std::string& folder) {
  std::vector<std::string> variables = environment_without(kDropped);
  variables.insert(variables.end(), {"HOME=" + folder, "TMPDIR=" + folder, "MESA_SHADER_CACHE_DISABLE=true"});
  variables.insert(variables.end(), browser.environment.begin(), browser.environment.end());
  return variables;
}

}  // namespace

Result<std::string> find_program(const Browser& browser) {
  const char* const variable = getenv("PATH");
  const std::string_view path = variable ? variable : "";
  for (const std::string_view program : browser.programs) {
    for (std::size_t start = 0; start < path.size();) {
      const auto end = std::min(path.find(':', start), path.size());
      const fs::path candidate = fs::path(path.substr(start, end - start)) / program;
      if (access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate.string();
      start = end + 1;
    }
  }
  return fail(fmt::format("there is no {} in PATH", fmt::join(browser.programs, " or ")));
}

std::span<const Browser> all_browsers() {
  static const std::vector<Browser> kBrowsers = {
      {"webgl2",
       "Chromium on SwiftShader, headless",
       {"--use-angle=swiftshader", "--enable-unsafe-swiftshader"},
       {},
       "SwiftShader"},
      // Chromium keeps WebGL from software drivers by its blocklist. Without it, the only message is that the context
      // cannot be "bound to the current sequence".
      {"webgl2-mesa",
       "Chromium on Mesa's llvmpipe, headless",
       {"--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"},
       {"EGL_PLATFORM=surfaceless", "LIBGL_ALWAYS_SOFTWARE=1", "GALLIUM_DRIVER=llvmpipe"},
       "llvmpipe"},
      {"webgpu",
       "Chromium's WebGPU on SwiftShader, headless",
       {"--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"},
       {},
       "swiftshader",
       Platform::webgpu},
  };
  return kBrowsers;
}

Result<GuardedProcess> start_chromium(const Browser& browser, const std::string& url) {
  HN_TRY(const auto program, find_program(browser));
  remove_left_folders();  // of processes that were killed together with their guards
  TemporaryFolder folder;
  std::vector<std::string> command = {program, fmt::format("--user-data-dir={}", (folder.path() / "profile").string())};
  command.insert(command.end(), kArguments.begin(), kArguments.end());
  command.insert(command.end(), browser.arguments.begin(), browser.arguments.end());
  if (geteuid() == 0) command.emplace_back("--no-sandbox");  // for root Chromium has none, and refuses to start
  command.push_back(url);
  std::vector<std::string> environment = environment_of(browser, folder.path().string());
  const bool mesa = std::find(browser.environment.begin(), browser.environment.end(), "EGL_PLATFORM=surfaceless") !=
                    browser.environment.end();
  if (mesa && fs::exists(kMesaEgl)) environment.push_back(fmt::format("__EGL_VENDOR_LIBRARY_FILENAMES={}", kMesaEgl));
  return GuardedProcess::start(std::move(command), std::move(environment), std::move(folder));
}

}  // namespace hn
