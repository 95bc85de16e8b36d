#include "report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/file.hpp"
#include "base/text.hpp"
#include "run/failures.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostGroupsShown = 20;
constexpr std::size_t kMostLinesShown = 6;
constexpr std::size_t kMostOfTitle = 60;

// "noise2d.perlin   3.1e-07" per float function: the largest difference from a golden value.
std::string error_lines(const Run& run) {
  std::map<std::string_view, double> largest;
  for (const CaseResult& result : run.cases) {
    if (result.outcome.max_abs == 0.0 || !result.id.ends_with(".golden")) continue;
    double& value = largest[function_of(result.id)];
    value = std::max(value, result.outcome.max_abs);
  }
  if (largest.empty()) return {};
  std::string text = "Largest difference from the exact values:\n";
  for (const auto& [function, value] : largest) text += fmt::format("  {:<22} {:.2g}\n", function, value);
  return text;
}

// The first lines, indented, and a word on how many there are besides.
std::string indented(std::string_view text) {
  std::string lines;
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (count < kMostLinesShown) lines += fmt::format("  {}\n", line);
  }
  if (count > kMostLinesShown) lines += fmt::format("  ({} more lines in results.json)\n", count - kMostLinesShown);
  return lines;
}

// "FAIL 3 of 7 cases of noise2d.perlin (only with HN_FIXED)", an example, and what there is to report of it.
std::string group_lines(const Run& run, const FailureGroup& group) {
  const CaseResult& example = *group.cases.front();
  const bool alone = group.cases.size() == 1;
  std::string text = fmt::format("{:<7} {}\n", in_upper_case(name_of(group.status)), alone ? example.id : group.text());
  if (!alone) text += fmt::format("  such as {}\n", example.id);
  if (group.of_function()) text += fmt::format("  {}\n", run.measure(example.outcome));
  std::string_view message = example.outcome.message;
  // The heading has the first line.
  if (!alone && !group.of_function()) message.remove_prefix(std::min(group.title.size() + 1, message.size()));
  return text + indented(message);
}

// The failures: their common traits, then group by group; beyond a limit only names and numbers.
std::string failure_lines(const Run& run) {
  const Failures failures = failures_of(run);
  if (failures.failed == 0) return {};
  const bool only_errors = std::all_of(failures.groups.begin(), failures.groups.end(),
                                       [](const FailureGroup& group) { return group.status == Status::error; });
  std::string text = fmt::format("{} of {} cases {} on {}.\n", failures.failed, failures.ran,
                                 only_errors ? "could not be checked" : run.wrong(), run.name());
  for (const std::string& sentence : failures.common) text += fmt::format("{}\n", sentence);
  std::vector<std::string> rest;
  for (std::size_t i = 0; i < failures.groups.size(); ++i) {
    const FailureGroup& group = failures.groups[i];
    if (i < kMostGroupsShown) {
      text += group_lines(run, group);
    } else {
      rest.push_back(fmt::format("{} ({})", shortened(group.title, kMostOfTitle), group.cases.size()));
    }
  }
  if (rest.empty()) return text;
  return text + fmt::format("... and {} more groups, with the numbers of their cases: {}; all are in results.json\n",
                            rest.size(), fmt::join(rest, ", "));
}

// Excuses of cases that are right.
std::string unneeded_lines(const Run& run) {
  std::map<std::string_view, std::vector<const CaseResult*>> by_excuse;
  for (const CaseResult& result : run.cases) {
    if (!as_expected(result) && !is_bad(result.outcome.status)) by_excuse[result.excuse].push_back(&result);
  }
  std::string text;
  for (const auto& [excuse, cases] : by_excuse) {
    text += fmt::format("{:<7} {}{}\n", in_upper_case(name_of(cases.front()->outcome.status)), cases.front()->id,
                        cases.size() == 1 ? "" : fmt::format(" and {} more", cases.size() - 1));
    text += fmt::format("  it is excused ({}), and needs no excuse: remove it from the expected failures\n", excuse);
  }
  return text;
}

std::string unsupported_lines(const Run& run) {
  std::map<std::string, std::size_t> reasons;
  for (const CaseResult& result : run.cases) {
    if (result.outcome.status == Status::unsupported) ++reasons[result.outcome.message];
  }
  std::string text;
  for (const auto& [reason, count] : reasons) {
    text += fmt::format("Unsupported, {} {}: {}\n", count, count == 1 ? "case" : "cases", reason);
  }
  return text;
}

}  // namespace

Result<OutputFolder> prepare_results(const std::filesystem::path& directory) {
  return OutputFolder::prepare(directory, {kResultsFile, kJunitFile, kPageFile});
}

Result<void> write_results(const std::filesystem::path& directory, const std::vector<Run>& runs,
                           const std::vector<std::string>& problems) {
  HN_DO(write_file(directory / kResultsFile, results_text(runs)));
  HN_DO(write_file(directory / kJunitFile, junit_text(runs, problems)));
  HN_TRY(const auto page, report_page(runs, problems));
  return write_file(directory / kPageFile, page);
}

std::string edited_libraries(const std::vector<Run>& runs) {
  std::set<std::string> texts;
  for (const Run& run : runs) {
    if (run.library) texts.insert(fmt::format("The tested library is {}\n", library_text(run.library)));
  }
  return fmt::format("{}", fmt::join(texts, ""));
}

std::string summary(const Run& run) {
  if (!run.absent.empty()) return fmt::format("{} is not here: {}\n", run.driver, run.absent);
  if (run.cases.empty() && run.not_run != 0) {
    return fmt::format("{}: none of its {} cases was run\n", run.name(), run.not_run);
  }
  double seconds = 0.0;
  std::uint64_t samples = 0;
  for (const CaseResult& result : run.cases) {
    seconds += result.seconds;
    samples += result.outcome.samples;
  }
  std::string text = fmt::format("{} on {}, {}{}\n", run.name(), run.info.renderer, run.info.gl_version,
                                 run.injected.empty() ? "" : ", made to have the fault " + run.injected);
  // Failures come last, where the reader of a long log looks.
  text += error_lines(run) + unsupported_lines(run) + unneeded_lines(run) + failure_lines(run);
  std::string counts;
  for (const Status status : kStatuses) {
    if (const std::size_t count = run.count(status); count != 0 || status == Status::pass) {
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, name_of(status));
      const auto excused = std::ranges::count_if(run.cases, [&](const CaseResult& result) {
        return result.outcome.status == status && is_bad(status) && !result.excuse.empty();
      });
      if (excused != 0) counts += fmt::format(" ({} excused)", excused);
    }
  }
  if (run.not_run != 0) counts += fmt::format(", {} not run", run.not_run);
  text += fmt::format("{}; {} values compared in {:.1f} s\n", counts, samples, seconds);
  return text;
}

}  // namespace hn
