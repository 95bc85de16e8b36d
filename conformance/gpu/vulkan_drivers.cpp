#include "gpu/vulkan_drivers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

namespace hn {

Result<std::string> vulkan_drivers(std::string_view prefix, const std::vector<std::filesystem::path>& directories) {
  std::vector<std::string> files;
  std::vector<std::string> searched;
  for (const std::filesystem::path& directory : directories) {
    searched.push_back(directory.string());
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(directory, none)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(prefix) && name.ends_with(".json")) files.push_back(entry.path().string());
    }
  }
  if (files.empty()) return fail(fmt::format("no {}*.json in {}", prefix, fmt::join(searched, ", ")));
  std::sort(files.begin(), files.end());
  return fmt::format("{}", fmt::join(files, ":"));
}

std::vector<std::array<std::string, 2>> vulkan_environment(const std::vector<std::filesystem::path>& files) {
  std::vector<std::array<std::string, 2>> environment = {
      {"NODEVICE_SELECT", "1"}};  // a layer of Mesa's that queries a display server
  for (const std::filesystem::path& file : files) {
    std::error_code none;
    if (!std::filesystem::exists(file, none)) continue;
    const char* const given = std::getenv("VK_ADD_DRIVER_FILES");
    environment.push_back({"VK_ADD_DRIVER_FILES", given ? fmt::format("{}:{}", given, file.string()) : file.string()});
    break;
  }
  return environment;
}

}  // namespace hn
