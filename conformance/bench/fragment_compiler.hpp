// A driver of Vulkan as a compiler: makes pipelines, and reads what became of their fragment shaders.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "base/result.hpp"

namespace hn {

// The statistics of VK_KHR_pipeline_executable_properties for the fragment stage, by the driver's own names.
using ShaderStatistics = std::map<std::string, double, std::less<>>;

struct CompiledShader {
  ShaderStatistics statistics;
  double seconds = 0.0;  // of the processor, for the pipeline with its vertex shader
};

class FragmentCompiler {
 public:
  // The driver and its GPU are those of the environment (VK_DRIVER_FILES, RADV_FORCE_FAMILY, LD_PRELOAD). RADV ends the
  // process if it does not know the family.
  static Result<std::unique_ptr<FragmentCompiler>> open();
  virtual ~FragmentCompiler() = default;

  virtual std::uint32_t vendor() const = 0;               // as PCI numbers them
  virtual const std::string& device() const = 0;          // "AMD NAVI21 (ACO)"
  virtual const std::string& driver_version() const = 0;  // "Mesa 26.2.6-1"; empty if the driver names none

  // SPIR-V with the entry point main, which may read a float vector at location 0, four combined image samplers (set 0,
  // bindings 0 to 3) and 16 bytes of push constants, and writes a vec4 at location 0.
  virtual Result<CompiledShader> compile(std::span<const std::uint32_t> fragment_shader) = 0;
};

// Runs the hidden subcommand "shader-statistics FILE...": compiles each file of SPIR-V, and prints a line of JSON for
// the device, {"device": ..., "driver": ...} or {"error": ...}, and one for each file in order, {"statistics": {...},
// "seconds": ...} or {"error": ...}. Returns the exit status of the program.
constexpr const char* kStatisticsCommand = "shader-statistics";
int shader_statistics_command(std::span<const char* const> files);

}  // namespace hn
