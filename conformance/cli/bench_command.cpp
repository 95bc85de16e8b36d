// hn-conform bench
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/file.hpp"
#include "base/output_folder.hpp"
#include "base/text.hpp"
#include "bench/foreign.hpp"
#include "cli/command.hpp"
#include "run/filter.hpp"

namespace hn {
namespace {

struct Selection {
  std::vector<Subject> subjects;
  std::vector<Foreign> foreigns;
};

Result<Selection> select(const BenchCommand& options, SourceSet& sources) {
  Selection selection{library_subjects(), {}};
  std::erase_if(selection.subjects, [&](const Subject& s) { return !matches_any(s.id, options.filters); });
  if (selection.subjects.empty()) {
    return fail(
        fmt::format("no subject matches --filter '{}'; ids are like noise2d.perlin.lattice, and * stands for any part",
                    fmt::join(options.filters, "' '")));
  }
  std::set<std::string> names;
  for (const std::string& argument : options.against) {
    HN_TRY(auto foreign, read_foreign(argument, sources));
    if (!names.insert(foreign.name).second)
      return fail(fmt::format("--against: the name {} is used twice", foreign.name));
    selection.foreigns.push_back(std::move(foreign));
  }
  return selection;
}

// Adds the subjects of the foreign expressions. False, after messages, if there is one that does not compile.
bool add_foreigns(const Context& context, const SourceSet& sources, Selection& selection) {
  if (selection.foreigns.empty()) return true;
  Workbench workbench(context, sources);
  bool good = true;
  for (const Foreign& foreign : selection.foreigns) {
    const auto subjects = foreign_subjects(workbench, foreign);
    if (subjects) {
      selection.subjects.insert(selection.subjects.end(), subjects->begin(), subjects->end());
    } else {
      usage_error(subjects.error().text());
      good = false;
    }
  }
  return good;
}

constexpr std::ptrdiff_t kFew = 40;  // a terminal has room for them

int conclude(const BenchReport& report, const std::string& out) {
  int status = 0;
  const auto measured = std::ranges::count_if(report.measurements, [](const Measurement& m) { return !m.error; });
  for (const Measurement& measurement : report.measurements) {
    if (!measurement.error && measured <= kFew) {
      fmt::print("{:>16} {}\n", text_of(measurement.ratio), measurement.subject.id);
    }
    if (!measurement.error) continue;
    fmt::print("NOT MEASURED {}\n{}\n", measurement.subject.id, printable(measurement.error->text()));
    if (!measurement.unsupported) status = kNotAsExpected;
  }
  fmt::print("{} subjects measured by {}: {}/bench.csv\n", measured, name_of(report.gate.clock), out);
  return status;
}

}  // namespace

int bench_command(const BenchCommand& options, Interruption& interruption) {
  auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  auto selection = select(options, *sources);
  if (!selection) return usage_error(selection.error().text());
  const auto driver = open_driver(options.driver, options.line);
  if (!driver) return driver.error();
  if (!add_foreigns(*driver->context, *sources, *selection)) return kBadUsage;
  const auto folder = OutputFolder::prepare(options.out, {"bench.csv"});
  if (!folder) return usage_error(folder.error().text());
  const ReferenceCompiler reference;
  auto report = run_bench(*driver->context, *sources, reference, std::move(selection->subjects),
                          {.rounds = options.rounds}, stderr);
  if (!report) {
    complain(report.error().text());
    return kNotAsExpected;
  }
  Provenance provenance = driver->provenance;
  provenance.library = sources->edited();
  interruption.note_the_first();
  if (const auto written = write_bench(options.out, provenance, *report, options.dump); !written) {
    complain(written.error().text());
    return kNotAsExpected;
  }
  return conclude(*report, options.out);
}

}  // namespace hn
