// Drivers of WebGPU without a browser: programs that evaluate shaders, and that this process talks to.
#pragma once

#include <memory>

#include "gpu/evaluator.hpp"

namespace hn {

enum class WebGpu {
  wgpu,  // PyPI's wgpu, which is naga: of the folder that HN_WGPU names, else the one that python3 finds
  dawn,  // npm's webgpu, which is Dawn with Tint, in Node.js: of the node_modules in HN_DAWN, or above this folder
};

// An error names the part that this machine lacks.
Result<std::unique_ptr<Evaluator>> create_webgpu_evaluator(WebGpu which);

}  // namespace hn
