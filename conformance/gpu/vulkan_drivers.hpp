// The drivers of Vulkan on this machine.
#pragma once

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

}  // namespace hn
