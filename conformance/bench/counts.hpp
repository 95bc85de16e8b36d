// The SPIR-V of a fragment shader, whose instructions are counted (gpu/spirv.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "bench/subject.hpp"
#include "gpu/reference_compiler.hpp"

namespace hn {

// Optimises SPIR-V as spirv-opt -O does.
Result<std::vector<std::uint32_t>> optimise_spirv(std::span<const std::uint32_t> words);

// The same for the shader that evaluates a subject once per pixel.
Result<std::vector<std::uint32_t>> optimised_spirv(const SourceSet& sources, const ReferenceCompiler& reference,
                                                   const Subject& subject);

// Writes it for other tools to count: spirv/<id>.spv. Nothing if there is nothing.
Result<void> write_spirv(const std::filesystem::path& directory, std::string_view id,
                         std::span<const std::uint32_t> words);

}  // namespace hn
