// Takes a shader through the steps of a way.
#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "gpu/way/way.hpp"

namespace hn {

// A step that did not do its work.
struct StepError {
  StepEnd end;
  std::size_t number;  // of the step, from 1
  Error error;
};

// Collects the result of each step in `given`, in their order, as far as they come. SPIR-V is valid, or the step is at
// fault. limit: of each step's time; its program is then killed with all that it started.
tl::expected<void, StepError> translate(std::span<const Step> steps, const Code& code, std::chrono::milliseconds limit,
                                        std::vector<Code>& given);

}  // namespace hn
