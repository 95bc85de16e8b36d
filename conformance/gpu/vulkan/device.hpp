// A device of Vulkan that runs compute shaders over buffers of words.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace hn {

struct VulkanDeviceInfo {
  std::string name;
  std::string driver;   // empty if the device names none
  std::string version;  // of Vulkan and of the driver
  bool validated;       // by VK_LAYER_KHRONOS_validation
};

// A compute shader, ready to be run.
class VulkanKernel {
 public:
  virtual ~VulkanKernel() = default;
};

// The bindings of its shaders: buffers of words, all in descriptor set 0.
inline constexpr std::uint32_t kResultsBinding = 0;
inline constexpr std::uint32_t kPointsBinding = 1;
inline constexpr std::uint32_t kUniformsBinding = 2;

class VulkanDevice {
 public:
  virtual ~VulkanDevice() = default;

  virtual const VulkanDeviceInfo& info() const = 0;
  // Builds a kernel of a module with the entry point "main". It must not outlive the device.
  virtual Result<std::unique_ptr<VulkanKernel>> build(std::span<const std::uint32_t> spirv) = 0;
  // Runs so many groups. Before, `results` is what the buffer of results holds; then it is what the shader left there.
  virtual Result<void> run(const VulkanKernel& kernel, std::span<const std::uint32_t> points,
                           std::span<const std::uint32_t> uniforms, std::uint32_t groups,
                           std::span<std::uint32_t> results) = 0;
  // Whether it broke and runs nothing any more.
  virtual bool is_lost() const = 0;
};

// The devices of all drivers, in an order that does not depend on the loader's: graphics cards come before what runs on
// the CPU, and then names decide. The drivers are
// those that the loader finds; vulkan_environment() (gpu/vulkan_drivers.hpp) lets it find more.
Result<std::unique_ptr<VulkanDevice>> open_vulkan_device(int number);
int vulkan_device_count();

}  // namespace hn
