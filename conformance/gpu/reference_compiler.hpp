// Khronos' own opinion on a shader: glslang judges the language, and SPIRV-Tools the SPIR-V that glslang makes for
// Vulkan.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "library/profile.hpp"
#include "library/source.hpp"

namespace hn {

std::string reference_compiler_version();  // of glslang

class ReferenceCompiler {
 public:
  ReferenceCompiler();
  ~ReferenceCompiler();
  ReferenceCompiler(const ReferenceCompiler&) = delete;
  ReferenceCompiler& operator=(const ReferenceCompiler&) = delete;

  // Compiles and links the shader. For profiles that have SPIR-V it also generates that and validates it. Warnings are
  // errors.
  Result<void> check(const ShaderText& shader, const Profile& profile, Stage stage) const;

  // The SPIR-V of a shader of a profile that has it: of Vulkan's GLSL, or of HLSL as glslang reads it. Warnings are
  // allowed: the shader may be somebody else's.
  Result<std::vector<std::uint32_t>> spirv(const ShaderText& shader, const Profile& profile, Stage stage) const;
  Result<std::vector<std::uint32_t>> spirv(const ShaderText& shader, Stage stage) const;  // of Vulkan's GLSL

  // The shader without macros and conditions, for compilers whose preprocessors lack something.
  Result<ShaderText> preprocessed(const ShaderText& shader, const Profile& profile, Stage stage) const;

  // A line of each function that main calls, or that these call: of the overloads only those. The shader has no #line.
  Result<std::set<std::size_t>> lines_of_called(const ShaderText& shader, const Profile& profile, Stage stage) const;
};

}  // namespace hn
