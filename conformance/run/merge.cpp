#include "run/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "base/file.hpp"
#include "run/selection.hpp"

namespace hn {
namespace {

std::string name_of(const Run& run) {
  return fmt::format("{} on {}, {}", run.name(), run.info.renderer, run.info.gl_version);
}

// Returns the number of shards if a run is one of them.
Result<std::size_t> shards_of(const Run& run) {
  HN_TRY(const auto shard, parse_shard(run.shard));
  return shard.count;
}

Result<void> append_cases(Run& to, Run& from) {
  if (to.seed != from.seed || to.injected != from.injected || to.content != from.content) {
    return fail(
        fmt::format("{}: runs that differ in --seed, --inject, the library or the golden files do not belong "
                    "together",
                    name_of(to)));
  }
  HN_TRY(const auto shards, shards_of(to));
  HN_TRY(const auto more, shards_of(from));
  if (shards != more || to.whole != from.whole) {
    return fail(fmt::format("{}: a shard of {} with {} cases in all and a shard of {} with {} do not belong together",
                            name_of(to), shards, to.whole, more, from.whole));
  }
  to.cases.insert(to.cases.end(), std::make_move_iterator(from.cases.begin()),
                  std::make_move_iterator(from.cases.end()));
  to.not_run += from.not_run;
  if (to.golden != from.golden) to.golden.clear();
  to.date = std::max(to.date, from.date);  // of the same length, so in the order of time
  to.commands.merge(from.commands);
  return {};
}

// In the order in which a whole run has them.
Result<void> sort_cases(Run& run, const std::map<std::string, std::size_t>& order) {
  for (const CaseResult& result : run.cases) {
    if (!order.contains(result.id)) {
      return fail(fmt::format("{}: there is no case {}", name_of(run), result.id));
    }
  }
  std::sort(run.cases.begin(), run.cases.end(),
            [&](const CaseResult& a, const CaseResult& b) { return order.at(a.id) < order.at(b.id); });
  const auto twice = std::adjacent_find(run.cases.begin(), run.cases.end(),
                                        [](const CaseResult& a, const CaseResult& b) { return a.id == b.id; });
  if (twice != run.cases.end()) return fail(fmt::format("{}: {} occurs twice", name_of(run), twice->id));
  return {};
}

Result<std::vector<Run>> read_runs(const std::string& name) {
  std::filesystem::path path = name;
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) path /= kResultsFile;
  HN_TRY(const auto text, read_file(path, "merge wants files results.json, or the folders that hold them"));
  auto runs = parse_results(text);
  if (!runs) return fail(fmt::format("{}: {}", path.string(), runs.error().message));
  return runs;
}

}  // namespace

Result<MergeResult> merge_runs(std::vector<Run> runs, const std::vector<std::string>& ids) {
  MergeResult merged;
  std::vector<Run> absent;
  for (Run& run : runs) {
    if (!run.absent.empty()) {
      absent.push_back(std::move(run));
      continue;
    }
    if (const auto shards = shards_of(run); !shards) {
      return fail(fmt::format("{}: {}", name_of(run), shards.error().message));
    }
    const auto same = std::find_if(merged.runs.begin(), merged.runs.end(),
                                   [&](const Run& other) { return name_of(other) == name_of(run); });
    if (same == merged.runs.end()) {
      merged.runs.push_back(std::move(run));
    } else {
      HN_DO(append_cases(*same, run));
    }
  }
  std::map<std::string, std::size_t> order;
  for (const std::string& id : ids) order.emplace(id, order.size());
  for (Run& run : merged.runs) {
    HN_DO(sort_cases(run, order));
    if (!run.shard.empty() && run.cases.size() > run.whole) {
      return fail(fmt::format("{}: by each shard all have {} cases, but here are more", name_of(run), run.whole));
    }
    if (run.not_run != 0) {
      merged.gaps.push_back(fmt::format("{}: {} cases were not run; --resume continues a run that ended early",
                                        name_of(run), run.not_run));
    }
    const std::size_t without = run.whole - std::min(run.whole, run.cases.size());
    run.missing = without - std::min(without, run.not_run);
    if (run.missing != 0) {
      merged.gaps.push_back(fmt::format("{}: {} of {} cases are missing; not all of its shards are here", name_of(run),
                                        run.missing, run.whole));
    } else {
      run.shard.clear();  // it is whole
    }
  }
  // A driver that one machine has is here; of one that none has, one reason is enough.
  for (Run& run : absent) {
    const bool known = std::any_of(merged.runs.begin(), merged.runs.end(),
                                   [&](const Run& other) { return other.driver == run.driver; });
    if (!known) merged.runs.push_back(std::move(run));
  }
  return merged;
}

Result<MergeResult> merge_files(const std::vector<std::string>& paths, const std::vector<std::string>& ids) {
  std::vector<Run> runs;
  for (const std::string& path : paths) {
    HN_TRY(auto more, read_runs(path));
    runs.insert(runs.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return merge_runs(std::move(runs), ids);
}

}  // namespace hn
