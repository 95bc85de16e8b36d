#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <hashnoise/hashnoise.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "output/file.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostFailuresShown = 20;

nlohmann::ordered_json timings(const BenchReport& report) {
  nlohmann::ordered_json functions = nlohmann::ordered_json::array();
  for (const Measurement& measurement : report.measurements) {
    if (measurement.error) {
      functions.push_back({{"id", measurement.subject.id}, {"error", measurement.error->text()}});
    } else {
      functions.push_back(
          {{"id", measurement.subject.id}, {"ratio", measurement.ratio.value}, {"spread", measurement.ratio.spread}});
    }
  }
  return {{"clock", name_of(report.gate.clock)}, {"rounds", report.rounds}, {"functions", std::move(functions)}};
}

std::string_view function_of(const std::string& id) {
  const auto file_end = id.find('.');
  return std::string_view(id).substr(0, id.find('.', file_end + 1));
}

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

std::string failure_lines(const Run& run) {
  std::string text;
  std::size_t shown = 0;
  for (const CaseResult& result : run.cases) {
    const Status status = result.outcome.status;
    if (status != Status::fail && status != Status::error) continue;
    if (shown++ < kMostFailuresShown) {
      text +=
          fmt::format("{} {}\n  {}\n", status == Status::fail ? "FAIL " : "ERROR", result.id, result.outcome.message);
    }
  }
  if (shown > kMostFailuresShown)
    text += fmt::format("... and {} more, all in results.json\n", shown - kMostFailuresShown);
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

std::size_t Run::count(Status status) const {
  return static_cast<std::size_t>(
      std::count_if(cases.begin(), cases.end(), [&](const CaseResult& c) { return c.outcome.status == status; }));
}

bool Run::as_expected() const {
  return count(Status::pass) > 0 && count(Status::fail) == 0 && count(Status::error) == 0;
}

std::string library_version() { return fmt::format("{}.{}.{}", HN_VERSION_MAJOR, HN_VERSION_MINOR, HN_VERSION_PATCH); }

std::string to_json(const std::vector<Run>& runs) {
  nlohmann::ordered_json json = {
      {"schema", 1}, {"version", library_version()}, {"runs", nlohmann::ordered_json::array()}};
  for (const Run& run : runs) {
    nlohmann::ordered_json totals;
    for (const Status status : kStatuses) totals[std::string(name_of(status))] = run.count(status);
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    for (const CaseResult& result : run.cases) {
      const Outcome& outcome = result.outcome;
      cases.push_back({{"id", result.id},
                       {"status", name_of(outcome.status)},
                       {"samples", outcome.samples},
                       {"mismatches", outcome.mismatches},
                       {"max_abs", outcome.max_abs},
                       {"max_ulp", outcome.max_ulp},
                       {"seconds", result.seconds},
                       {"message", outcome.message}});
    }
    nlohmann::ordered_json one = {{"driver", run.driver},
                                  {"vendor", run.info.vendor},
                                  {"renderer", run.info.renderer},
                                  {"gl_version", run.info.gl_version},
                                  {"glsl_version", run.info.glsl_version},
                                  {"seed", run.seed},
                                  {"totals", totals},
                                  {"cases", std::move(cases)}};
    if (run.timings) one["timings"] = timings(*run.timings);
    json["runs"].push_back(std::move(one));
  }
  // A driver's log may hold any bytes; those that are no UTF-8 are replaced.
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<void> write_results(const std::filesystem::path& directory, const std::vector<Run>& runs) {
  return write_file(directory / kResultsFile, to_json(runs));
}

std::string summary(const Run& run) {
  double seconds = 0.0;
  std::uint64_t samples = 0;
  for (const CaseResult& result : run.cases) {
    seconds += result.seconds;
    samples += result.outcome.samples;
  }
  std::string text = failure_lines(run) + unsupported_lines(run) + error_lines(run);
  text += fmt::format("{} on {}, {}\n", run.driver, run.info.renderer, run.info.gl_version);
  text += fmt::format("{} passed, {} failed, {} unsupported, {} errors; {} values compared in {:.1f} s\n",
                      run.count(Status::pass), run.count(Status::fail), run.count(Status::unsupported),
                      run.count(Status::error), samples, seconds);
  return text;
}

}  // namespace hn
