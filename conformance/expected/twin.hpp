// The C++ twin as a table: the body of every function, compiled with each hash.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "library/functions.hpp"

namespace hn {

// The values of a function at many points, computed on all cores: kInputWords per point in, kOutputWords per point out.
// The configuration must cover the function.
std::vector<std::uint32_t> evaluate_twin(const Function& function, const Configuration& configuration,
                                         std::span<const std::uint32_t> inputs);

}  // namespace hn
