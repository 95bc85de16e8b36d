// Deals cases to the drivers of a run: cases that every driver must show go to each of those that draw by themselves,
// every other case to one.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/case.hpp"

namespace hn {

using CanRun = std::function<bool(const Case&)>;

struct DealtDriver {
  CanRun can_run;
  // The renderer. Windows, surfaces and buffers of one renderer lead to the same compiler, so the first of them runs
  // for every driver; the others share the rest.
  std::string renderer;
  int turns = 1;  // of the cases for one driver, how many it gets in a round
};

// For each driver, the indices in `cases` of those that it runs. Cases that share a program stay together. A case that
// no driver can run goes to the first driver, which reports why.
std::vector<std::vector<std::size_t>> deal(std::span<const Case> cases, std::span<const DealtDriver> drivers);

}  // namespace hn
