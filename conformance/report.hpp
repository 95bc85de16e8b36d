// What a run leaves behind: results.json, and what a person reads in a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results.hpp"

namespace hn {

Result<void> write_results(const std::filesystem::path& directory, const std::vector<Run>& runs);

// A few lines: totals, the largest errors by function, what failed and why, what was unsupported and why.
std::string summary(const Run& run);

}  // namespace hn
