// hn-conform bench and spirv
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/console.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "bench/counts.hpp"
#include "bench/foreign.hpp"
#include "cli/command.hpp"
#include "run/selection.hpp"

namespace hn {
namespace {

struct SubjectSelection {
  std::vector<Subject> subjects;
  std::vector<Foreign> foreigns;
};

std::vector<Subject> subjects_with(const std::vector<std::string>& filters) {
  std::vector<Subject> subjects = library_subjects();
  std::erase_if(subjects, [&](const Subject& subject) { return !matches_any(subject.id, filters); });
  return subjects;
}

tl::unexpected<Error> no_subject(const std::vector<std::string>& filters) {
  return fail(
      fmt::format("no subject matches --filter '{}'; ids are like noise2d.perlin.lattice, and * stands for any part",
                  fmt::join(filters, "' '")));
}

Result<SubjectSelection> select(const BenchCommand& options, SourceSet& sources) {
  SubjectSelection selection{subjects_with(options.filters), {}};
  if (selection.subjects.empty()) return no_subject(options.filters);
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
bool add_foreigns(const Context& context, const SourceSet& sources, SubjectSelection& selection) {
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

// The matching subjects of the library, then the foreign ones. The empty shaders come first: the cost of each is
// subtracted from the others.
Result<std::vector<Subject>> subjects_of(const SpirvCommand& options, SourceSet& sources,
                                         const ReferenceCompiler& reference) {
  std::vector<Subject> subjects = subjects_with(options.filters);
  if (subjects.empty() && options.against.empty()) return no_subject(options.filters);
  subjects.insert(subjects.begin(), {empty_subject(2), empty_subject(3)});
  for (const std::string& argument : options.against) {
    HN_TRY(const auto foreign, read_foreign(argument, sources));
    HN_TRY(auto found, foreign_subjects(sources, reference, foreign));
    for (Subject& subject : found) subjects.push_back(std::move(subject));
  }
  return subjects;
}

}  // namespace

int run(const BenchCommand& options, Interruption& interruption) {
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

int run(const SpirvCommand& options, Interruption&) {
  auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  const ReferenceCompiler reference;
  const auto subjects = subjects_of(options, *sources, reference);
  if (!subjects) return usage_error(subjects.error().text());
  const auto folder = OutputFolder::prepare(options.out, {});
  if (!folder) return usage_error(folder.error().text());
  std::size_t failed = 0;
  Progress progress(stderr, subjects->size());
  for (std::size_t i = 0; i < subjects->size(); ++i) {
    const Subject& subject = (*subjects)[i];
    progress.show(i, failed, subject.id);
    const auto written = optimised_spirv(*sources, reference, subject).and_then([&](const auto& words) {
      return write_spirv(options.out, subject.id, words);
    });
    if (written) {
      say(fmt::format("{} {}\n", subject.id, subject.dimensions));
    } else {
      complain(fmt::format("{}: {}", subject.id, written.error().text()));
      ++failed;
    }
  }
  return failed == 0 ? 0 : kNotAsExpected;
}

}  // namespace hn
