#include "gpu/vulkan_drivers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

}  // namespace hn
