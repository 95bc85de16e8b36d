// Khronos' own opinion on a shader: glslang for the language, SPIRV-Tools for what glslang makes of it for Vulkan.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "library/profile.hpp"
#include "base/result.hpp"
#include "library/source.hpp"

namespace hn {

// SPIRV-Tools' verdict, by the rules of Vulkan 1.0.
Result<void> validate_spirv(std::span<const std::uint32_t> words);

// The results of instructions that may be computed in less than 32 bits: their names, where they have one, else "".
std::vector<std::string> relaxed_precision(std::span<const std::uint32_t> words);

// The functions in which an operation on floats may be contracted or reassociated with others: their mangled names.
std::vector<std::string> contractible(std::span<const std::uint32_t> words);

std::string reference_compiler_version();  // of glslang

class ReferenceCompiler {
 public:
  ReferenceCompiler();
  ~ReferenceCompiler();
  ReferenceCompiler(const ReferenceCompiler&) = delete;
  ReferenceCompiler& operator=(const ReferenceCompiler&) = delete;

  // Compiles and links the shader. For the Vulkan profile it also generates SPIR-V and validates it. Warnings are
  // errors.
  Result<void> check(const ShaderText& shader, const Profile& profile, Stage stage) const;

  // The SPIR-V of a shader of the Vulkan profile. Warnings are let pass: the shader may be somebody else's.
  Result<std::vector<std::uint32_t>> spirv(const ShaderText& shader, Stage stage) const;
};

}  // namespace hn
