// How many instructions a fragment shader has, by every source at hand.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/subject.hpp"
#include "gpu/gpu.hpp"
#include "gpu/reference_compiler.hpp"

namespace hn {

// Optimises SPIR-V as spirv-opt -O does.
Result<std::vector<std::uint32_t>> optimise_spirv(std::span<const std::uint32_t> words);

// The same for the shader that evaluates a subject once per pixel.
Result<std::vector<std::uint32_t>> optimised_spirv(const SourceSet& sources, const ReferenceCompiler& reference,
                                                   const Subject& subject);

// The instructions of NVIDIA's assembly text in a program binary: the statements of its fragment program, without the
// declarations and labels. Nothing if there is no such text from its header to its END.
std::optional<std::int64_t> count_nvidia(std::string_view binary);

struct Counts {
  std::map<std::string, std::int64_t, std::less<>> instructions;  // by source
  std::vector<std::string> problems;                              // why one of them is missing, for this shader alone
  std::vector<std::uint32_t> optimised;
};

// A shader to count: its text for Vulkan, and the driver's program for the same text, if there is one.
struct CountedShader {
  ShaderText vulkan;
  const Program* program = nullptr;
};

struct CountReport {
  std::vector<Counts> counts;                 // one for each shader
  std::map<std::string, std::string> absent;  // by source: why it is not here at all
};

// The sources.
inline constexpr const char* kSpirvSource = "spirv";
inline constexpr const char* kNvidiaSource = "nvidia";
inline constexpr std::array kCountSources = {kSpirvSource, kNvidiaSource};

// A shader's count from a source as text: "not here" if there is no such source, "failed" if it could not count this
// shader.
std::string count_text(const Counts& counts, std::string_view source, const std::map<std::string, std::string>& absent);

// Writes what was counted, for other tools to count: spirv/<id>.spv. Nothing if there is nothing.
Result<void> write_spirv(const std::filesystem::path& directory, std::string_view id,
                         std::span<const std::uint32_t> words);

// Whether the driver's own programs are counted, too.
bool counts_programs(const Context& context);

CountReport count_instructions(const Context& context, const ReferenceCompiler& reference,
                               std::span<const CountedShader> shaders);

}  // namespace hn
