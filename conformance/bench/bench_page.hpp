// The page for people: what everything costs on this driver.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.hpp"

namespace hn {

Result<std::string> bench_page(const Provenance& provenance, const BenchReport& report,
                               const std::vector<Change>& changes);

}  // namespace hn
