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

// "noise2d.perlin.lattice" of "noise2d.perlin.lattice.fast.fragment.gl330.golden", and "noise2d.perlin.lattice+fixed"
// if that says "fixed" in place of "fast"
std::string subject_of(const std::string& id) {
  std::size_t end = 0;
  for (int part = 0; part < 3; ++part) end = id.find('.', end + 1);
  const std::string subject = id.substr(0, end);
  for (const std::string_view arithmetic : {"precise", "fixed"}) {
    if (id.find(fmt::format(".{}.", arithmetic), end) == end) return fmt::format("{}+{}", subject, arithmetic);
  }
  return subject;
}

}  // namespace

nlohmann::ordered_json timings_report(const Context& context, const SourceSet& sources,
                                      const ReferenceCompiler& reference, const std::vector<std::string>& ids) {
  if (context.api() != Api::gl) return {{"error", "times are taken in desktop OpenGL only"}};
  std::set<std::string> wanted;
  for (const std::string& id : ids) wanted.insert(subject_of(id));
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
