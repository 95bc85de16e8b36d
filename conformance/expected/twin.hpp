// The C++ twin as a table: the body of every FUNCTION, compiled with each hash.
#pragma once

#include <cstdint>
#include <span>

#include "library/functions.hpp"

namespace hn {

// Evaluates a function at many points on all cores: kInputWords per point in, kOutputWords per point out.
// The configuration must cover the function.
void evaluate_twin(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                   std::span<std::uint32_t> outputs);

}  // namespace hn
