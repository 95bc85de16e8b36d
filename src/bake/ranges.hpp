// The ranges that the functions document: what 16 bits stand for if nobody says otherwise.
#pragma once

#include <hashnoise/field.hpp>
#include <optional>
#include <string_view>

#include "bake/options.hpp"

namespace hn {

// The range of a component, as the comment of the function in glsl/hashnoise/ has it, or nothing where that has no
// numbers: of the derivatives of fbm_d, which depend on the gain and the lacunarity, and of distances in other metrics
// than the Euclidean one.
std::optional<Interval> documented_range(const hashnoise::Settings& settings, int dimensions,
                                         std::string_view component);

}  // namespace hn
