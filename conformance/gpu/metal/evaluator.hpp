// Functions evaluated in Metal's shading language, without Metal: as C++14, with a stand-in for its standard library.
#pragma once

#include <memory>

#include "base/result.hpp"
#include "gpu/evaluator.hpp"

namespace hn {

// An error names the part that this machine lacks.
Result<std::unique_ptr<Evaluator>> create_metal_evaluator();

}  // namespace hn
