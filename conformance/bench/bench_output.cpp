// bench.csv.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/version.hpp"
#include "bench/bench.hpp"

namespace hn {
namespace {

std::vector<std::string> header_of() {
  std::vector<std::string> names = {"id",        "dimensions", "call", "ratio", "spread", "evaluations_per_second",
                                    "compile_ms"};
  for (const char* const source : kCountSources) names.push_back(source);
  names.emplace_back("problem");
  return names;
}

// Numbers, and words where there is none.
std::vector<std::string> row_of(const Measurement& measurement, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> row = {measurement.subject.id, fmt::format("{}", measurement.subject.dimensions),
                                  measurement.subject.expression};
  if (measurement.error) {
    row.resize(header_of().size() - 1, "failed");
    row.push_back(measurement.error->text());
    return row;
  }
  for (const double number : {measurement.ratio.value, measurement.ratio.spread}) {
    row.push_back(measurement.ratio.known() ? fmt::format("{:.5g}", number) : "cannot be told");
  }
  row.push_back(measurement.evaluations_per_second ? fmt::format("{:.3g}", *measurement.evaluations_per_second)
                                                   : "too fast to tell");
  row.push_back(fmt::format("{:.1f}", measurement.compile_seconds * 1e3));
  for (const char* const source : kCountSources) row.push_back(count_text(measurement.counts, source, absent));
  row.push_back(fmt::format("{}", fmt::join(measurement.counts.problems, "\n")));
  return row;
}

}  // namespace

Facts facts_of(const Provenance& provenance, const Gate& gate, int rounds) {
  return {{"date", provenance.date},
          {"command", provenance.command},
          {"driver", provenance.driver},
          {"renderer", provenance.info.renderer},
          {"OpenGL", provenance.info.gl_version},
          {"GLSL", provenance.info.glsl_version},
          {"library", library_text(provenance.library)},
          {"clock", fmt::format("{}: {}", name_of(gate.clock), gate.reason)},
          {"rounds", fmt::format("{}", rounds)}};
}

Result<void> write_bench(const std::filesystem::path& directory, const Provenance& provenance,
                         const BenchReport& report, bool dump) {
  Facts facts = facts_of(provenance, report.gate, report.rounds);
  facts.emplace_back("load", fmt::format("{0} x {0} pixels with {1} evaluations each", report.side, report.iterations));
  for (const auto& [source, reason] : report.absent) {
    facts.emplace_back(fmt::format("no counts from {} here", source), reason);
  }
  std::vector<std::vector<std::string>> rows;
  for (const Measurement& measurement : report.measurements) rows.push_back(row_of(measurement, report.absent));
  HN_DO(write_file(directory / "bench.csv", to_record(facts, header_of(), rows)));
  if (!dump) return {};
  for (const Measurement& measurement : report.measurements) {
    HN_DO(write_spirv(directory, measurement.subject.id, measurement.counts.optimised));
  }
  return {};
}

}  // namespace hn
