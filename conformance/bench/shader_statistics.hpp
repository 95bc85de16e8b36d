// A driver of Vulkan as a compiler: makes pipelines, and prints what became of their fragment shaders.
#pragma once

#include <span>

namespace hn {

// Runs the hidden subcommand "shader-statistics FILE...": compiles each file of SPIR-V, and prints a line of JSON for
// the device, {"device": ..., "driver": ...} or {"error": ...}, and one for each file in order, {"statistics": {...},
// "seconds": ...} or {"error": ...}: the statistics of VK_KHR_pipeline_executable_properties for the fragment stage, by
// the driver's own names, and seconds of the processor for the pipeline with its vertex shader. The SPIR-V has the
// entry point main, may read a float vector at location 0, four combined image samplers (set 0, bindings 0 to 3) and 16
// bytes of push constants, and writes a vec4 at location 0. The driver and its GPU are those of the environment
// (VK_DRIVER_FILES, RADV_FORCE_FAMILY, LD_PRELOAD). RADV ends the process if it does not know the family. Returns the
// exit status of the program.
constexpr const char* kStatisticsCommand = "shader-statistics";
int shader_statistics_command(std::span<const char* const> files);

}  // namespace hn
