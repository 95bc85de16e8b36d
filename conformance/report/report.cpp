#include "report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/file.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostFailuresShown = 20;

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

// "FAIL id", and what there is to say, of every case that is not as expected.
std::string failure_lines(const Run& run) {
  std::string text;
  std::size_t shown = 0;
  for (const CaseResult& result : run.cases) {
    if (as_expected(result) || shown++ >= kMostFailuresShown) continue;
    std::string status(name_of(result.outcome.status));
    std::transform(status.begin(), status.end(), status.begin(), [](char c) { return c >= 'a' ? c - 'a' + 'A' : c; });
    text += fmt::format("{:<7} {}\n", status, result.id);
    if (!is_bad(result.outcome.status)) {
      text += fmt::format("  it is excused ({}), and needs no excuse: take it from the expectations\n", result.excuse);
    } else {
      text += fmt::format("  {}\n", result.outcome.message);
    }
  }
  if (shown > kMostFailuresShown) {
    text += fmt::format("... and {} more, all in results.json\n", shown - kMostFailuresShown);
  }
  return text;
}

std::string unsupported_lines(const Run& run) {
  std::map<std::string, std::size_t> reasons;
  for (const CaseResult& result : run.cases) {
    if (result.outcome.status == Status::unsupported) ++reasons[result.outcome.message];
  }
  std::string text;
  for (const auto& [reason, count] : reasons) text += fmt::format("Unsupported, {} cases: {}\n", count, reason);
  return text;
}

}  // namespace

Result<void> prepare_results(const std::filesystem::path& directory) {
  return prepare_output(directory, {kResultsFile, kJunitFile, kPageFile});
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
    if (run.library) texts.insert(fmt::format("What was tested is {}\n", library_text(run.library)));
  }
  return fmt::format("{}", fmt::join(texts, ""));
}

std::string summary(const Run& run) {
  if (!run.absent.empty()) return fmt::format("{} is not here: {}\n", run.driver, run.absent);
  double seconds = 0.0;
  std::uint64_t samples = 0;
  for (const CaseResult& result : run.cases) {
    seconds += result.seconds;
    samples += result.outcome.samples;
  }
  std::string text = failure_lines(run) + unsupported_lines(run) + error_lines(run);
  text += fmt::format("{} on {}, {}{}\n", run.driver, run.info.renderer, run.info.gl_version,
                      run.injected.empty() ? "" : ", made to have the fault " + run.injected);
  std::string counts;
  for (const Status status : kStatuses) {
    if (const std::size_t count = run.count(status); count != 0 || status == Status::pass) {
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, name_of(status));
    }
  }
  const auto excused = std::count_if(run.cases.begin(), run.cases.end(), [](const CaseResult& result) {
    return is_bad(result.outcome.status) && !result.excuse.empty();
  });
  if (excused != 0) counts += fmt::format(" ({} of these excused)", excused);
  text += fmt::format("{}; {} values compared in {:.1f} s\n", counts, samples, seconds);
  return text;
}

}  // namespace hn
