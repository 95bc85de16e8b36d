// results.json, as merge reads it. Inputs that are none are most of those that a fuzzer thinks of, so the version may
// be left out: it is put in.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "fuzz.hpp"
#include "library/source.hpp"
#include "run/merge.hpp"
#include "run/selection.hpp"

namespace hn::fuzz {
namespace {

void check_error(const std::string& message) {
  const bool has_place = message.starts_with("the file") || message.starts_with("run ") ||
                         message.starts_with("its schema is ") || message.starts_with("it was written by version ");
  require(has_place && message.size() > 20, "an error names place and fault", message);
}

// All ids, and how often each is there.
std::map<std::string, int> count_ids(const std::vector<Run>& runs) {
  std::map<std::string, int> counts;
  for (const Run& run : runs) {
    for (const CaseResult& result : run.cases) ++counts[result.id];
  }
  return counts;
}

void check_round_trip(const std::vector<Run>& runs) {
  const std::string text = results_text(runs);
  const auto again = parse_results(text);
  require(again.has_value(), "what was read can be written and read again", text);
  require(results_text(*again) == text, "it is the same then", text);
}

void check_merged(const std::vector<Run>& runs, const MergeResult& merged) {
  require(count_ids(merged.runs) == count_ids(runs), "merge neither loses nor makes a case");
  for (const Run& run : merged.runs) {
    const auto by_id = [](const CaseResult& a, const CaseResult& b) { return a.id < b.id; };
    require(std::is_sorted(run.cases.begin(), run.cases.end(), by_id), "cases are in their order");
    const bool is_whole = run.shard.empty() || !run.absent.empty();
    require(is_whole || run.cases.size() < run.whole, "what is called a shard lacks cases");
    require(is_whole || parse_shard(run.shard).has_value(), "a shard is one", run.shard);
    require(is_whole || !merged.gaps.empty(), "a gap is reported");
  }
  check_round_trip(merged.runs);
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  std::string text(fuzz::text_of(data, size));
  if (const auto at = text.find("VERSION"); at != std::string::npos) text.replace(at, 7, library_version());
  const auto runs = parse_results(text);
  if (!runs) {
    fuzz::check_error(runs.error().message);
    return 0;
  }
  fuzz::check_round_trip(*runs);
  std::vector<std::string> ids;
  for (const auto& [id, count] : fuzz::count_ids(*runs)) ids.push_back(id);
  const auto merged = merge_runs(*runs, ids);
  if (merged) {
    fuzz::check_merged(*runs, *merged);
  } else {
    fuzz::require(!merged.error().message.empty(), "an error has a message");
  }
  return 0;
}
