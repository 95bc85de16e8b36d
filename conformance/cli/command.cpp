#include "cli/command.hpp"

#include <cstdlib>
#include <system_error>

#include "base/console.hpp"

namespace hn {

void say(const std::string& text) { std::fputs(text.c_str(), stdout); }

void complain(const std::string& message) { complain("hn-conform", message); }

int usage_error(const std::string& message) {
  complain(message);
  return kBadUsage;
}

std::string farewell(int signal) { return fmt::format("ended by {}; no results are written", name_of_signal(signal)); }

std::string driver_names(DriverKind kind) {
  std::string names;
  for (const Driver& driver : all_drivers({})) {
    if (kind == DriverKind::with_context && !driver.has_context()) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", driver.name);
  }
  names += ", egl-device:N, egl-device:N-gles";
  return kind == DriverKind::with_context ? names : names + ", vulkan:N";
}

int unknown_driver(const std::string& name) {
  return usage_error(
      fmt::format("there is no driver \"{}\"; there are: {}", name, driver_names(DriverKind::with_context)));
}

tl::expected<OpenDriver, int> open_driver(const std::string& name, const std::string& command_line) {
  // Before anything loads a driver: compile times would be those of a look into a cache.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  setenv("__GL_SHADER_DISK_CACHE", "0", 1);
  const auto driver = find_driver(name);
  if (!driver) return tl::unexpected(unknown_driver(name));
  auto context = create_context(*driver);
  if (!context) {
    complain(fmt::format("the driver {} cannot be used here: {}", name, context.error().text()));
    return tl::unexpected(kNoDriver);
  }
  if ((*context)->api() != Api::gl) {
    return tl::unexpected(usage_error(fmt::format("{} is OpenGL ES; measuring needs desktop OpenGL", name)));
  }
  Provenance provenance{now(), command_line, name, describe(**context)};
  return OpenDriver{std::move(*context), std::move(provenance)};
}

std::filesystem::path data_folder_of(const std::filesystem::path& program) {
  std::error_code error;
  const auto folder = std::filesystem::canonical(program, error).parent_path();
  const auto built = folder / HN_BUILT_DATA;
  if (std::filesystem::is_directory(built, error)) return built;
  return (folder / HN_INSTALLED_DATA).lexically_normal();
}

}  // namespace hn
