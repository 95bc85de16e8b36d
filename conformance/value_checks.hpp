// The checks of the cases that evaluate functions on the driver, and what they share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "case.hpp"
#include "compare.hpp"
#include "functions.hpp"

namespace hn {

using Words = std::vector<std::uint32_t>;

inline std::span<const std::uint32_t> point(const Words& inputs, std::size_t i) {
  return std::span(inputs).subspan(i * kInputWords, kInputWords);
}

inline std::span<const std::uint32_t> result(const Words& outputs, std::size_t i) {
  return std::span(outputs).subspan(i * kOutputWords, kOutputWords);
}

// Evaluates on the driver; the outcome of a failure is ready to be returned.
tl::expected<Words, Outcome> evaluate(Session& session, const Evaluation& evaluation, const Words& inputs);

void compare_with_twin(Comparison& comparison, const Function& function, std::span<const std::uint32_t> inputs,
                       std::span<const std::uint32_t> got, std::span<const std::uint32_t> twin, double allowed);

using Check = Outcome(Session& session, const Evaluation& evaluation);

// property_checks.cpp
Check check_zero;        // noise is 0 at lattice points
Check check_range;       // values keep to their range and use it
Check check_period;      // the same bits a period on
Check check_seeds;       // fields of different seeds are uncorrelated
Check check_mirror;      // no quadrant mirrors another
Check check_unseeded;    // without a seed means with seed 0
Check check_noise_knob;  // HN_FBM_NOISE2D and HN_FBM_NOISE3D are used

}  // namespace hn
