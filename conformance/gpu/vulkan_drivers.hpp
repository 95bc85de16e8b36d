// The drivers of Vulkan on this machine.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

inline const std::vector<std::filesystem::path> kVulkanDriverDirectories = {"/usr/share/vulkan/icd.d",
                                                                            "/etc/vulkan/icd.d"};

// The description files whose names begin so, as the loader of Vulkan wants them in VK_ICD_FILENAMES. There is one per
// architecture; the loader leaves those of the others out.
Result<std::string> vulkan_drivers(std::string_view prefix,
                                   const std::vector<std::filesystem::path>& directories = kVulkanDriverDirectories);

// SwiftShader, as browsers ship it: where the loader does not look.
inline const std::vector<std::filesystem::path> kBrowsersVulkanDrivers = {
    "/usr/lib/chromium/vk_swiftshader_icd.json",
    "/usr/lib/chromium-browser/vk_swiftshader_icd.json",
    "/usr/lib64/chromium-browser/vk_swiftshader_icd.json",
    "/opt/google/chrome/vk_swiftshader_icd.json",
};

// The environment in which the loader finds the drivers of a browser besides those that it finds by itself: the first
// of the files that is here. Who sets VK_DRIVER_FILES or VK_ICD_FILENAMES gets just those drivers.
std::vector<std::array<std::string, 2>> vulkan_environment(
    const std::vector<std::filesystem::path>& files = kBrowsersVulkanDrivers);

}  // namespace hn
