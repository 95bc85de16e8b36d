// Adds a grid to a sum of grids. It has a source of its own, since its time is measured: the rest of the program is not
// optimized.
#pragma once

#include <span>

namespace hn {

void add(std::span<float> sum, std::span<const float> grid, float weight);

}  // namespace hn
