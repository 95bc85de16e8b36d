#include "bench/timings.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bench/bench.hpp"

namespace hn {
namespace {

nlohmann::ordered_json function_timing(const Measurement& measurement) {
  nlohmann::ordered_json json = {{"id", measurement.subject.id}};
  if (measurement.error) {
    json["error"] = measurement.error->text();
  } else {
    json["ratio"] = measurement.ratio.value;
    json["spread"] = measurement.ratio.spread;
  }
  return json;
}

}  // namespace

nlohmann::ordered_json timings_report(const Context& context, const SourceSet& sources,
                                      const ReferenceCompiler& reference, const std::set<std::string>& wanted) {
  if (context.api() != Api::gl) return {{"error", "times are taken in desktop OpenGL only"}};
  std::vector<Subject> subjects = library_subjects();
  std::erase_if(subjects, [&](const Subject& subject) { return !wanted.contains(subject.id); });
  const auto report = run_bench(context, sources, reference, std::move(subjects), {.counts = false}, stderr);
  if (!report) return {{"error", report.error().text()}};
  nlohmann::ordered_json functions = nlohmann::ordered_json::array();
  for (const Measurement& measurement : report->measurements) functions.push_back(function_timing(measurement));
  return {{"timings",
           {{"clock", name_of(report->gate.clock)}, {"rounds", report->rounds}, {"functions", std::move(functions)}}}};
}

}  // namespace hn
