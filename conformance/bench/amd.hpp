// Instruction counts for AMD's GPUs, from Mesa's RADV, which also compiles for a GPU that the machine lacks.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "base/process.hpp"
#include "gpu/vulkan_drivers.hpp"

namespace hn {

// VK_KHR_pipeline_executable_properties tells these of the fragment stage of a pipeline.
struct AmdStatistics {
  std::int64_t instructions = 0;
  std::int64_t inverse_throughput = 0;  // RADV's estimate of the cycles that one wave keeps the GPU busy
  std::int64_t latency = 0;             // the same with the cycles that the wave waits
  std::int64_t vgprs = 0;
  std::int64_t code_size = 0;  // bytes

  bool operator==(const AmdStatistics&) const = default;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AmdStatistics, instructions, inverse_throughput, latency, vgprs, code_size)

// Where the counts come from. Tests set other sources.
struct AmdSource {
  std::filesystem::path program = own_program();  // answers kAmdCommand with amd_counts_child
  std::vector<std::filesystem::path> icd_directories = kVulkanDriverDirectories;
  std::chrono::milliseconds limit = std::chrono::seconds(120);  // without a new result
};

// RADV's names of the GPUs that we count for.
std::span<const std::string_view> amd_families();

// Compiles fragment shaders for a family: each is SPIR-V with the entry point main, which may read a float vector at
// location 0, four combined image samplers (set 0, bindings 0 to 3) and 16 bytes of push constants, and writes a vec4
// at location 0. One result per shader; the outer error says why there are no counts here at all.
//
// It runs in a child process: RADV reads its environment once, and a crash in it must cost a count and not the run.
Result<std::vector<Result<AmdStatistics>>> amd_counts(std::string_view family,
                                                      std::span<const std::vector<std::uint32_t>> shaders,
                                                      const AmdSource& source = {});

// Runs the hidden subcommand "amd-counts JOB", which the child does. Returns the exit status of the program.
constexpr const char* kAmdCommand = "amd-counts";
int amd_counts_child(const std::filesystem::path& job);

}  // namespace hn
