// What a run leaves behind: results.json, and what a person reads in a terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "case.hpp"

namespace hn {

struct Run {
  std::string driver;
  ContextInfo info;
  std::uint64_t seed = 0;
  std::vector<CaseResult> cases;
  std::optional<BenchReport> timings = {};  // of the functions of the cases, if they were asked for

  std::size_t count(Status status) const;
  // Everything that could run ran, and was right; at least one case passed.
  bool as_expected() const;
};

std::string library_version();

// The JSON text of results.json; docs/internals.md describes it.
std::string to_json(const std::vector<Run>& runs);

constexpr std::string_view kResultsFile = "results.json";
Result<void> write_results(const std::filesystem::path& directory, const std::vector<Run>& runs);

// A few lines: totals, the largest errors by function, what failed and why, what was unsupported and why.
std::string summary(const Run& run);

}  // namespace hn
