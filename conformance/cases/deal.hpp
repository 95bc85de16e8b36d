// Deals cases to the drivers of a run: each driver gets every case that all must show; every other case goes to one.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "cases/case.hpp"

namespace hn {

using CanRun = std::function<bool(const Case&)>;

// For each driver, the indices in `cases` of those that it runs. Cases that share a program stay together. A case that
// no driver can run goes to the first, which says why.
std::vector<std::vector<std::size_t>> deal(std::span<const Case> cases, std::span<const CanRun> drivers);

}  // namespace hn
