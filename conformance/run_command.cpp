// hn-conform drivers, list and run
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "case.hpp"
#include "command.hpp"
#include "fault/faults.hpp"
#include "output/file.hpp"
#include "report.hpp"
#include "runner.hpp"

namespace hn {
namespace {

Result<std::vector<Case>> select_cases(const std::vector<std::string>& filters) {
  auto cases = filter_cases(all_cases(), filters);
  if (!cases.empty()) return cases;
  return fail(fmt::format("no case matches --filter '{}'; hn-conform list shows the ids, and * stands for any part",
                          fmt::join(filters, "' '")));
}

// Without the driver every case is unsupported, and results.json says why.
int report_no_driver(const std::vector<Case>& cases, const RunCommand& options, const Error& error) {
  const std::string reason = fmt::format("the driver {} cannot be used here: {}", options.driver, error.text());
  Run run{.driver = options.driver, .info = {}, .seed = options.seed, .cases = {}, .timings = {}};
  for (const Case& test : cases) {
    run.cases.push_back({test.id, outcome_with(Status::unsupported, {reason, {}}), 0.0});
  }
  fmt::print(stderr, "hn-conform: {}\n", reason);
  if (const auto written = write_results(options.out, {run}); !written) return usage_error(written.error().text());
  return kNoDriver;
}

// The functions and configurations of the cases, timed against Perlin/Float.
Result<BenchReport> time_functions(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
                                   const std::vector<Case>& cases) {
  // "noise2d.perlin.lattice" of "noise2d.perlin.lattice.fast.fragment.gl330.golden"
  std::set<std::string> wanted;
  for (const Case& test : cases) {
    std::size_t end = 0;
    for (int part = 0; part < 3; ++part) end = test.id.find('.', end + 1);
    wanted.insert(test.id.substr(0, end));
  }
  std::vector<Subject> subjects = library_subjects();
  std::erase_if(subjects, [&](const Subject& subject) { return !wanted.contains(subject.id); });
  return run_bench(context, sources, reference, std::move(subjects), {.counts = false}, stderr);
}

}  // namespace

int drivers_command() {
  bool usable = false;
  for (const Driver& driver : all_drivers()) {
    const auto context = driver.create();
    fmt::print("{:<12} {}\n", driver.name, driver.description);
    if (context) {
      usable = true;
      const ContextInfo info = describe(**context);
      fmt::print("             {}; OpenGL {}; GLSL {}\n", info.renderer, info.gl_version, info.glsl_version);
    } else {
      fmt::print("             not here: {}\n", context.error().text());
    }
  }
  return usable ? 0 : kNoDriver;
}

int list_command(const std::vector<std::string>& filters) {
  const auto cases = select_cases(filters);
  if (!cases) return usage_error(cases.error().text());
  for (const Case& test : *cases) fmt::print("{}\n", test.id);
  return 0;
}

int run_command(const RunCommand& options) {
  const auto driver = find_driver(options.driver);
  if (!driver) return unknown_driver(options.driver);
  const auto cases = select_cases(options.filters);
  if (!cases) return usage_error(cases.error().text());
  auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  if (!options.inject.empty()) {
    if (const auto done = inject_into(*sources, options.inject); !done) return usage_error(done.error().text());
  }
  if (const auto ready = prepare_output(options.out, {kResultsFile}); !ready) return usage_error(ready.error().text());

  const auto context = driver->create();
  if (!context) return report_no_driver(*cases, options, context.error());
  const ReferenceCompiler reference;
  Run result{.driver = options.driver, .info = {}, .seed = options.seed, .cases = {}, .timings = {}};
  {
    Session session(**context, *sources, reference, options.golden, options.seed);
    result.info = session.info;
    Progress progress(stderr, cases->size());
    result.cases = run_cases(session, *cases, {options.fail_fast}, progress);
  }
  if (options.timings) {
    auto timed = time_functions(**context, *sources, reference, *cases);
    if (timed) {
      result.timings = std::move(*timed);
    } else {
      fmt::print(stderr, "hn-conform: the functions cannot be timed: {}\n", timed.error().text());
    }
  }
  if (const auto written = write_results(options.out, {result}); !written) return usage_error(written.error().text());
  fmt::print("{}", summary(result));
  fmt::print("{}: {}/results.json\n", result.as_expected() ? "All as expected" : "NOT AS EXPECTED", options.out);
  const bool timed = !options.timings || result.timings;
  return result.as_expected() && timed ? 0 : kNotAsExpected;
}

}  // namespace hn
