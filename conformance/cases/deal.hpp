// Which driver of a run runs which case, if no case is to be run twice.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "cases/case.hpp"

namespace hn {

using CanRun = std::function<bool(const Case&)>;

// The cases of each driver, as places in `cases`: what every driver must show, and of what one driver shows its part.
// Cases that share a program stay together. What no driver can run goes to the first, which says why.
std::vector<std::vector<std::size_t>> deal(std::span<const Case> cases, std::span<const CanRun> drivers);

}  // namespace hn
