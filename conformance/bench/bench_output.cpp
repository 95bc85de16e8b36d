// bench.json and what is made of it: CSV, and the comparison with an earlier one.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/number.hpp"
#include "base/version.hpp"
#include "bench/bench.hpp"
#include "bench/bench_page.hpp"
#include "output/csv.hpp"

namespace hn {
namespace {

constexpr int kSchema = 1;

nlohmann::json to_json(const Measurement& measurement) {
  nlohmann::json json = {{"id", measurement.subject.id},
                         {"dimensions", measurement.subject.dimensions},
                         {"expression", measurement.subject.expression}};
  if (measurement.error) {
    json["error"] = measurement.error->text();
    return json;
  }
  json["ratio"] = measurement.ratio.value;
  json["spread"] = measurement.ratio.spread;
  // Null for what takes no longer than an empty shader.
  json["evaluations_per_second"] =
      measurement.evaluations_per_second ? nlohmann::json(*measurement.evaluations_per_second) : nlohmann::json();
  json["compile_seconds"] = measurement.compile_seconds;
  json["instructions"] = to_json(measurement.counts);
  return json;
}

// The columns of bench.csv.
const std::vector<std::string> kHeader = [] {
  std::vector<std::string> names = {"id", "ratio", "spread", "evaluations_per_second", "compile_ms"};
  for (const std::string& source : count_sources()) names.push_back(source);
  return names;
}();

std::vector<std::string> row_of(const Measurement& measurement, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> row = {measurement.subject.id};
  if (measurement.error) {
    row.resize(kHeader.size(), "failed");
    return row;
  }
  for (const double number : {measurement.ratio.value, measurement.ratio.spread}) {
    row.push_back(measurement.ratio.known() ? decimals(number, 3) : "cannot be told");
  }
  row.push_back(measurement.evaluations_per_second ? fmt::format("{:.3g}", *measurement.evaluations_per_second)
                                                   : "too fast to tell");
  row.push_back(fmt::format("{:.1f}", measurement.compile_seconds * 1e3));
  for (const std::string& source : count_sources()) row.push_back(count_text(measurement.counts, source, absent));
  return row;
}

Ratio ratio_in(const nlohmann::json& subject) {
  return {subject.at("ratio").get<double>(), subject.at("spread").get<double>()};
}

}  // namespace

nlohmann::json to_json(const Provenance& provenance) {
  nlohmann::json json = {{"version", library_version()},
                         {"date", provenance.date},
                         {"command", provenance.command},
                         {"driver", provenance.driver},
                         {"vendor", provenance.info.vendor},
                         {"renderer", provenance.info.renderer},
                         {"gl_version", provenance.info.gl_version},
                         {"glsl_version", provenance.info.glsl_version}};
  if (provenance.library) json["library"] = to_json(*provenance.library);
  return json;
}

nlohmann::json to_json(const Counts& counts) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [source, instructions] : counts.instructions) json[source] = instructions;
  for (const auto& [family, statistics] : counts.amd) json[family] = statistics;
  if (!counts.problems.empty()) json["problems"] = counts.problems;
  return json;
}

nlohmann::json to_json(const Gate& gate) {
  return {{"clock", name_of(gate.clock)},
          {"query_with_4_times_the_pixels", gate.pixels},
          {"query_with_4_times_the_iterations", gate.iterations},
          {"query_with_4_draws", gate.draws},
          {"reason", gate.reason}};
}

nlohmann::json to_json(const BenchReport& report) {
  nlohmann::json subjects = nlohmann::json::array();
  for (const Measurement& measurement : report.measurements) subjects.push_back(to_json(measurement));
  return {{"schema", kSchema},   {"timing", to_json(report.gate)},  {"rounds", report.rounds},
          {"side", report.side}, {"iterations", report.iterations}, {"absent_counts", report.absent},
          {"subjects", subjects}};
}

nlohmann::json absent_sources(const std::map<std::string, std::string>& absent) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [source, reason] : absent) list.push_back({{"source", source}, {"reason", reason}});
  return list;
}

Result<Baseline> read_baseline(const std::filesystem::path& path) {
  HN_TRY(const auto text, read_file(path, "--baseline wants a bench.json"));
  Baseline baseline;
  try {
    const auto json = parse_json(text);
    if (json.at("schema").get<int>() != kSchema) throw std::runtime_error("another schema");
    baseline.renderer = json.value("renderer", "");
    for (const nlohmann::json& subject : json.at("subjects").get_ref<const nlohmann::json::array_t&>()) {
      if (!subject.contains("error") && !subject.at("ratio").is_null())
        baseline.ratios.emplace(subject.at("id").get<std::string>(), ratio_in(subject));
    }
  } catch (const std::exception& problem) {
    return fail(fmt::format("{} is not a bench.json of this program: {}", path.string(), problem.what()));
  }
  return baseline;
}

std::vector<Change> compare_with_baseline(const Baseline& baseline, const BenchReport& report) {
  std::vector<Change> changes;
  for (const Measurement& measurement : report.measurements) {
    const auto found = baseline.ratios.find(measurement.subject.id);
    if (found == baseline.ratios.end() || measurement.error || !measurement.ratio.known()) continue;
    const Ratio& was = found->second;
    const Ratio& is = measurement.ratio;
    changes.push_back({measurement.subject.id, was, is, is.value - was.value > is.spread + was.spread});
  }
  return changes;
}

Result<void> write_bench(const std::filesystem::path& directory, const Provenance& provenance,
                         const BenchReport& report, const std::vector<Change>& changes, bool dump) {
  nlohmann::json json = to_json(provenance);
  json.update(to_json(report));
  std::vector<std::vector<std::string>> rows;
  for (const Measurement& measurement : report.measurements) rows.push_back(row_of(measurement, report.absent));
  HN_TRY(const auto html, bench_page(provenance, report, changes));
  const std::string dumped = hn::dump(json, 1) + "\n";
  for (const auto& [name, text] : {std::pair{"bench.json", dumped}, std::pair{"bench.csv", to_csv(kHeader, rows)},
                                   std::pair{"index.html", html}}) {
    HN_DO(write_file(directory / name, text));
  }
  if (!dump) return {};
  for (const Measurement& measurement : report.measurements) {
    HN_DO(write_spirv(directory, measurement.subject.id, measurement.counts.optimised));
  }
  return {};
}

}  // namespace hn
