// RADV behind Vulkan: makes pipelines and reads what became of their fragment shaders.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "bench/amd.hpp"

namespace hn {

class Radv {
 public:
  // The driver and its GPU are those of the environment (VK_ICD_FILENAMES, RADV_FORCE_FAMILY). RADV ends the process
  // if it does not know the family.
  static Result<std::unique_ptr<Radv>> open();
  virtual ~Radv() = default;

  virtual Result<AmdStatistics> compile(std::span<const std::uint32_t> fragment_shader) = 0;
};

}  // namespace hn
