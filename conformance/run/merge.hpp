// Runs that were split over machines, joined again.
#pragma once

#include <string>
#include <vector>

#include "run/results.hpp"

namespace hn {

struct MergeResult {
  std::vector<Run> runs;          // cases in the order of the ids
  std::vector<std::string> gaps;  // what is missing of the whole, a sentence each
};

// Runs of the same driver on the same renderer become one. The ids are those of all cases, in their order. An error: an
// unknown case, the same case twice, or runs that do not belong together because they differ in their seed or in the
// number of shards.
Result<MergeResult> merge_runs(std::vector<Run> runs, const std::vector<std::string>& ids);

// Merges files named results.json, or the folders that hold them.
Result<MergeResult> merge_files(const std::vector<std::string>& paths, const std::vector<std::string>& ids);

}  // namespace hn
