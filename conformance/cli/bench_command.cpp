// hn-conform bench
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "base/file.hpp"
#include "cli/command.hpp"
#include "run/filter.hpp"

namespace hn {
namespace {

// NAME=FILE:EXPRESSION. The file's name may have a colon in it only if the file is there.
struct Foreign {
  std::string name;
  std::string file;
  std::string expression;
};

bool is_word(std::string_view name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_'; });
}

Result<Foreign> parse_foreign(const std::string& argument) {
  const auto equals = argument.find('=');
  const auto wrong = [&](std::string_view what) {
    return fail(fmt::format("--against {}: {}; write NAME=FILE:EXPRESSION, as in simplex=other.glsl:snoise(p)",
                            argument, what));
  };
  if (equals == std::string::npos || equals == 0) return wrong("there is no name");
  for (auto colon = argument.find(':', equals); colon != std::string::npos; colon = argument.find(':', colon + 1)) {
    Foreign foreign{argument.substr(0, equals), argument.substr(equals + 1, colon - equals - 1),
                    argument.substr(colon + 1)};
    if (!std::filesystem::is_regular_file(foreign.file)) continue;
    if (foreign.expression.empty()) return wrong("there is no expression");
    if (!is_word(foreign.name)) return wrong("a name is a word of letters, digits, - and _");
    if (foreign.name == "empty") return wrong("the empty shaders have that name");
    return foreign;
  }
  const bool complete = std::filesystem::is_regular_file(argument.substr(equals + 1));
  return wrong(complete ? "there is no expression" : "there is no such file");
}

// The text of a shader file, fit to stand behind a #version line of ours.
Result<std::string> read_foreign(const std::string& path) {
  HN_TRY(const auto text, read_file(path));
  static const std::regex kVersion("(^|\n)([ \t]*#[ \t]*version)");
  return std::regex_replace(text, kVersion, "$1//$2");
}

bool is_of(const Measurement& measurement, const Foreign& foreign) {
  const std::string& id = measurement.subject.id;
  return id == fmt::format("{}2", foreign.name) || id == fmt::format("{}3", foreign.name);
}

// A foreign expression may be for positions in the plane, in space, or both: what compiles in one of them is no fault
// in the other. Where neither compiles, the message says whose it is; the log may know only the shader around it.
void settle_foreigns(BenchReport& report, const std::vector<Foreign>& foreigns) {
  for (const Foreign& foreign : foreigns) {
    const bool some = std::any_of(report.measurements.begin(), report.measurements.end(),
                                  [&](const Measurement& m) { return is_of(m, foreign) && !m.error; });
    if (some) std::erase_if(report.measurements, [&](const Measurement& m) { return is_of(m, foreign) && m.error; });
    for (Measurement& m : report.measurements) {
      if (!m.error || !is_of(m, foreign)) continue;
      m.error->message = fmt::format("{}:{}: {}", foreign.file, foreign.expression, m.error->message);
    }
  }
}

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
    HN_TRY(auto foreign, parse_foreign(argument));
    if (!names.insert(foreign.name).second)
      return fail(fmt::format("--against: there are two of the name {}", foreign.name));
    HN_TRY(const auto text, read_foreign(foreign.file));
    const std::string included = fmt::format("against/{}", foreign.name);
    sources.add(included, text, foreign.file);
    for (const int dimensions : {2, 3}) {
      selection.subjects.push_back(foreign_subject(foreign.name, included, foreign.expression, dimensions));
    }
    selection.foreigns.push_back(std::move(foreign));
  }
  return selection;
}

// What a comparison is worth.
void describe_comparison(const Baseline& baseline, const std::vector<Change>& changes, const std::string& renderer) {
  if (baseline.renderer != renderer) {
    fmt::print("The baseline was measured on another renderer: {}, not {}\n", baseline.renderer, renderer);
  }
  fmt::print("{} subjects compared; {} of the baseline were not measured now\n", changes.size(),
             baseline.ratios.size() - changes.size());
}

int conclude(const BenchReport& report, const std::vector<Change>& changes, const std::string& out) {
  int status = 0;
  for (const Measurement& measurement : report.measurements) {
    if (!measurement.error) continue;
    fmt::print("NOT MEASURED {}\n{}\n", measurement.subject.id, measurement.error->text());
    if (!measurement.unsupported) status = kNotAsExpected;
  }
  for (const Change& change : changes) {
    if (!change.slower) continue;
    fmt::print("SLOWER {}: {:.3f} +- {:.3f}, was {:.3f} +- {:.3f}\n", change.id, change.now.value, change.now.spread,
               change.before.value, change.before.spread);
    status = kNotAsExpected;
  }
  const auto measured = std::count_if(report.measurements.begin(), report.measurements.end(),
                                      [](const Measurement& m) { return !m.error.has_value(); });
  fmt::print("{} subjects measured by {}: {}/index.html\n", measured, name_of(report.gate.clock), out);
  return status;
}

}  // namespace

int bench_command(const BenchCommand& options) {
  auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  auto selection = select(options, *sources);
  if (!selection) return usage_error(selection.error().text());
  Baseline baseline;
  if (!options.baseline.empty()) {
    // Before the run rather than after it; it may be the very file that prepare_output removes.
    auto read = read_baseline(options.baseline);
    if (!read) return usage_error(read.error().text());
    baseline = std::move(*read);
  }
  if (const auto ready = prepare_output(options.out, {"bench.json", "bench.csv", "index.html"}); !ready)
    return usage_error(ready.error().text());
  const auto driver = open_driver(options.driver, options.line);
  if (!driver) return driver.error();
  const ReferenceCompiler reference;
  auto report = run_bench(*driver->context, *sources, reference, std::move(selection->subjects),
                          {.rounds = options.rounds}, stderr);
  if (!report) {
    fmt::print(stderr, "hn-conform: {}\n", report.error().text());
    return kNotAsExpected;
  }
  settle_foreigns(*report, selection->foreigns);
  const std::vector<Change> changes = compare_with_baseline(baseline, *report);
  if (!options.baseline.empty()) describe_comparison(baseline, changes, driver->provenance.info.renderer);
  Provenance provenance = driver->provenance;
  provenance.library = sources->edited();
  if (const auto written = write_bench(options.out, provenance, *report, changes, options.dump); !written) {
    return usage_error(written.error().text());
  }
  return conclude(*report, changes, options.out);
}

}  // namespace hn
