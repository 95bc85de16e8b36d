// A shader that shows a wrong value and nothing else: for the people who write the driver.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/result.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

struct ShaderFacts {
  std::string id;        // of the case
  std::string renderer;  // where it failed
  std::span<const std::uint32_t> inputs;
  std::span<const std::uint32_t> got;  // empty if there was no value
  std::array<std::uint32_t, kOutputWords> expected;
  std::array<double, kOutputWords> allowed;  // how far each float may be off,
  bool every_bit;                            // unless every bit counts
};

// A fragment shader, complete, without textures or attributes: green where the function has the expected value,
// else red. The point is hidden from the compiler behind a uniform that nobody needs to set, so that it
// evaluates the function on the device. Comments describe it. With a compiler it is brief: macros are expanded,
// and what main does not call is left out.
Result<std::string> stand_alone_shader(const SourceSet& sources, const Evaluation& evaluation, const ShaderFacts& facts,
                                       const ReferenceCompiler* compiler = nullptr);

// A shader that stands alone, made green where the function has the wrong value that the suite got.
std::string expecting_got(std::string shader, const ShaderFacts& facts);

// Lines without comments, #line directives and lines left empty.
std::string without_comments(std::string_view glsl);

}  // namespace hn
