// For tests of drivers that take the texts of translators: texts that SPIRV-Cross writes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/folder.hpp"
#include "base/process.hpp"
#include "gpu/evaluator.hpp"

namespace hn {

// A kernel over the suite's buffers that applies a function of Vulkan's GLSL, uvec4 f(uvec4 p), to the first vector of
// each point.
inline Result<std::string> by_spirv_cross(std::string_view function, std::vector<std::string> options) {
  constexpr const char* kKernel = R"(#version 450
layout(local_size_x = {}) in;
layout(std430, binding = 0) buffer Results {{ uvec4 results[]; }};
layout(std430, binding = 1) readonly buffer Points {{ uvec4 points[]; }};
layout(std430, binding = 2) readonly buffer Uniforms {{ int trips; uint variant_seed; }};
{}
void main() {{ results[gl_GlobalInvocationID.x] = f(points[gl_GlobalInvocationID.x * 4u]); }}
)";
  HN_TRY(const auto words,
         ReferenceCompiler().spirv({fmt::format(kKernel, kComputeGroup, function), {}}, Stage::compute));
  const TemporaryFolder folder;
  folder.write("kernel.spv", {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0])});
  options.push_back((folder.path() / "kernel.spv").string());
  return output_of("spirv-cross", options);
}

// Its results, or the error of whoever refuses it.
inline Result<std::vector<std::uint32_t>> results_of(Evaluator& evaluator, Form form, const Result<std::string>& text,
                                                     std::span<const std::uint32_t> points) {
  if (!text) return tl::unexpected(text.error());
  HN_TRY(const auto loaded, evaluator.load({form, *text}));
  loaded->uniforms = {3, 1000};
  return loaded->evaluate(points);
}

}  // namespace hn
