// hn-conform: does the library compute what it promises, on this driver?
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "bench/amd.hpp"
#include "case.hpp"
#include "command.hpp"
#include "context_info.hpp"
#include "driver/driver.hpp"
#include "report.hpp"
#include "runner.hpp"

namespace {

using hn::driver_names;
using hn::kBadUsage;
using hn::kNoDriver;
using hn::kNotAsExpected;
using hn::usage_error;

struct Options {
  std::string driver = "osmesa";
  std::vector<std::string> filters;
  std::string out = "out";
  std::string glsl;
  std::string golden = HN_GOLDEN_DIRECTORY;
  std::uint64_t seed = 1;
  bool fail_fast = false;
};

int list_drivers() {
  bool usable = false;
  for (const hn::Driver& driver : hn::all_drivers()) {
    const auto context = driver.create();
    fmt::print("{:<12} {}\n", driver.name, driver.description);
    if (context) {
      usable = true;
      const hn::ContextInfo info = hn::describe(**context);
      fmt::print("             {}; OpenGL {}; GLSL {}\n", info.renderer, info.gl_version, info.glsl_version);
    } else {
      fmt::print("             not here: {}\n", context.error().text());
    }
  }
  return usable ? 0 : kNoDriver;
}

hn::Result<std::vector<hn::Case>> select_cases(const Options& options) {
  auto cases = hn::filter_cases(hn::all_cases(), options.filters);
  if (!cases.empty()) return cases;
  return hn::fail(fmt::format("no case matches --filter '{}'; hn-conform list shows the ids, and * stands for any part",
                              fmt::join(options.filters, "' '")));
}

int list_cases(const Options& options) {
  const auto cases = select_cases(options);
  if (!cases) return usage_error(cases.error().text());
  for (const hn::Case& test : *cases) fmt::print("{}\n", test.id);
  return 0;
}

// Without the driver every case is unsupported, and results.json says why.
int report_no_driver(const hn::Driver& driver, const std::vector<hn::Case>& cases, const Options& options,
                     const hn::Error& error) {
  const std::string reason = fmt::format("the driver {} cannot be used here: {}", driver.name, error.text());
  hn::Run run{options.driver, {}, options.seed, {}};
  for (const hn::Case& test : cases) {
    run.cases.push_back({test.id, hn::outcome_with(hn::Status::unsupported, {reason, {}}), 0.0});
  }
  fmt::print(stderr, "hn-conform: {}\n", reason);
  if (const auto written = hn::write_results(options.out, {run}); !written) {
    return usage_error(written.error().text());
  }
  return kNoDriver;
}

int run(const Options& options) {
  const auto driver = hn::find_driver(options.driver);
  if (!driver) {
    return usage_error(fmt::format("there is no driver \"{}\"; there are: {}", options.driver, driver_names()));
  }
  const auto cases = select_cases(options);
  if (!cases) return usage_error(cases.error().text());
  const auto sources = hn::library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  if (const auto ready = hn::prepare_output(options.out); !ready) return usage_error(ready.error().text());

  const auto context = driver->create();
  if (!context) return report_no_driver(*driver, *cases, options, context.error());
  const hn::ReferenceCompiler reference;
  hn::Session session(**context, *sources, reference, options.golden, options.seed);
  hn::Run result{options.driver, session.info, options.seed, {}};
  {
    hn::Progress progress(stderr, cases->size());
    result.cases = hn::run_cases(session, *cases, {options.fail_fast}, progress);
  }
  if (const auto written = hn::write_results(options.out, {result}); !written) {
    return usage_error(written.error().text());
  }
  fmt::print("{}", hn::summary(result));
  fmt::print("{}: {}/results.json\n", result.as_expected() ? "All as expected" : "NOT AS EXPECTED", options.out);
  return result.as_expected() ? 0 : kNotAsExpected;
}

void add_filter(CLI::App& command, Options& options) {
  command.add_option("--filter", options.filters, "Only the cases whose id matches this glob; may be repeated")
      ->type_name("GLOB")
      ->allow_extra_args(false);
}

void add_bench(CLI::App& app, hn::BenchCommand& options) {
  CLI::App& command = *app.add_subcommand("bench", "Measure what every function, hash and knob costs");
  command.add_option("--driver", options.driver, "One of: " + driver_names())->type_name("NAME")->capture_default_str();
  command.add_option("--filter", options.filters, "Only the subjects whose id matches this glob; may be repeated")
      ->type_name("GLOB")
      ->allow_extra_args(false);
  command.add_option("--out", options.out, "The folder for bench.json, bench.csv and index.html")
      ->type_name("DIR")
      ->capture_default_str();
  command
      .add_option(
          "--against", options.against,
          "Measure a shader file as well: NAME=FILE:EXPRESSION, a float of p, as in s=other.glsl:snoise(p); may "
          "be repeated")
      ->type_name("WHAT")
      ->allow_extra_args(false);
  command
      .add_option("--baseline", options.baseline, "A bench.json to compare with; status 1 if something became slower")
      ->type_name("FILE");
  command.add_option("--rounds", options.rounds, "Samples of each subject")
      ->type_name("N")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  command.add_option("--glsl", options.glsl, "Measure this copy of glsl/ instead of the one built in")
      ->type_name("DIR");
  command.add_flag("--dump", options.dump, "Write the SPIR-V that was counted, too: spirv/ID.spv");
}

void add_paper(CLI::App& app, hn::PaperCommand& options) {
  CLI::App& command = *app.add_subcommand("paper", "Reproduce what the paper shows, as a page with pictures and data");
  command.add_option("--driver", options.driver, "One of: " + driver_names())->type_name("NAME")->capture_default_str();
  command.add_option("--out", options.out, "The folder for index.html, paper.json, the CSV files and the pictures")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--rounds", options.rounds, "Samples of each render time")
      ->type_name("N")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  command.add_option("--glsl", options.glsl, "Take this copy of glsl/ instead of the one built in")->type_name("DIR");
  command.add_flag("--dump", options.dump,
                   "Write what was measured, too: the values of the statistics as grids/ID.f32, the SPIR-V that was "
                   "counted as spirv/ID.spv");
}

std::string command_line(int argc, char** argv) {
  return fmt::format("hn-conform {}", fmt::join(argv + std::min(argc, 1), argv + argc, " "));
}

int dispatch(int argc, char** argv) {
  CLI::App app("Checks that hashnoise computes what it promises on a driver.", "hn-conform");
  app.set_version_flag("--version", hn::library_version());
  app.footer("Exit status: 0 all as expected, 1 something is not, 2 bad usage, 3 no usable driver.");
  app.require_subcommand(0, 1);  // none gets a better message below
  Options options;

  app.add_subcommand("drivers", "List the drivers, what is behind each here, or why it is missing");

  CLI::App& list = *app.add_subcommand("list", "List the ids of the cases");
  add_filter(list, options);

  CLI::App& run_command = *app.add_subcommand("run", "Run the cases on a driver and write results.json");
  run_command.add_option("--driver", options.driver, "One of: " + driver_names())
      ->type_name("NAME")
      ->capture_default_str();
  add_filter(run_command, options);
  run_command.add_option("--out", options.out, "The folder for results.json; made if it is not there")
      ->type_name("DIR")
      ->capture_default_str();
  run_command.add_option("--seed", options.seed, "Of the random points")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0xFFFFFFFF}))
      ->capture_default_str();
  run_command.add_option("--glsl", options.glsl, "Test this copy of glsl/ instead of the one built in")
      ->type_name("DIR");
  run_command.add_option("--golden", options.golden, "The folder of the golden files")
      ->type_name("DIR")
      ->capture_default_str();
  run_command.add_flag("--fail-fast", options.fail_fast, "Stop at the first case that is not as expected");

  hn::BenchCommand bench;
  bench.line = command_line(argc, argv);
  add_bench(app, bench);
  hn::PaperCommand paper;
  paper.line = bench.line;
  add_paper(app, paper);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    if (app.get_subcommands().empty()) {
      return usage_error(std::string(error.what()) + "; there are drivers, list, run, bench or paper");
    }
    return app.exit(error) == 0 ? 0 : kBadUsage;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUsage;
  }
  if (app.got_subcommand("drivers")) return list_drivers();
  if (app.got_subcommand("list")) return list_cases(options);
  if (app.got_subcommand("run")) return run(options);
  if (app.got_subcommand("bench")) return bench_command(bench);
  if (app.got_subcommand("paper")) return paper_command(paper);
  return usage_error("say what to do: drivers, list, run, bench or paper; --help tells more");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    // What bench starts to count for AMD; not for people.
    if (argc == 4 && std::string_view(argv[1]) == "amd-counts") return hn::amd_counts_child(argv[2], argv[3]);
    return dispatch(argc, argv);
  } catch (const std::exception& exception) {
    fmt::print(stderr, "hn-conform: {}\n", exception.what());
    return kNotAsExpected;
  }
}
