// hn-conform paper
#include <fmt/format.h>

#include <chrono>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "cli/command.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

struct Part {
  std::string_view name;
  Result<Section> (*measure)(Laboratory&);
};
// The table first: it decides which clock is believed.
constexpr Part kParts[] = {
    {"table", measure_table}, {"values", write_values}, {"period", measure_periods}, {"bandwidth", measure_bandwidth}};

}  // namespace

int run(const PaperCommand& options, Interruption& interruption) {
  const auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  const auto folder = OutputFolder::prepare(options.out, {"table.csv", "values.csv", "period.csv", "bandwidth.csv"});
  if (!folder) return usage_error(folder.error().text());
  const auto driver = open_driver(options.driver, options.line);
  if (!driver) return driver.error();
  const ReferenceCompiler reference;
  Laboratory laboratory(*driver->context, *sources, reference, options.out, options.rounds, options.dump);
  Provenance provenance = driver->provenance;
  provenance.library = sources->edited();
  std::vector<Section> sections;
  bool complete = true;
  for (const Part& part : kParts) {
    const auto start = std::chrono::steady_clock::now();
    auto section = part.measure(laboratory);
    if (!section) {
      // The other sections are still worth having.
      complain(fmt::format("{}: {}", part.name, section.error().text()));
      complete = false;
      continue;
    }
    complete = complete && section->complete;
    sections.push_back(std::move(*section));
    fmt::print(stderr, "{}: {:.1f} s\n", part.name,
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  interruption.note_the_first();
  for (const Section& section : sections) {
    Facts facts = facts_of(provenance, laboratory.stopwatch.gate(), options.rounds);
    facts.insert(facts.end(), section.facts.begin(), section.facts.end());
    const std::filesystem::path path = laboratory.out / fmt::format("{}.csv", section.name);
    if (const auto written = write_file(path, to_record(facts, section.header, section.rows)); !written) {
      complain(written.error().text());
      return kNotAsExpected;
    }
    fmt::print("{}: {} rows\n", path.string(), section.rows.size());
  }
  if (complete) return 0;
  fmt::print("NOT AS EXPECTED: something could not be measured; the records name the problem\n");
  return kNotAsExpected;
}

}  // namespace hn
