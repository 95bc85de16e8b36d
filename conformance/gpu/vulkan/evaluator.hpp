// Functions evaluated by Vulkan, in compute shaders.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/evaluator.hpp"
#include "gpu/reference_compiler.hpp"

namespace hn {

// On the device of that number. An error names the part that this machine lacks.
Result<std::unique_ptr<Evaluator>> create_vulkan_evaluator(int number, const ReferenceCompiler& compiler);

}  // namespace hn
