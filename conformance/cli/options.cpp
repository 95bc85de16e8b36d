#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <sstream>
#include <string_view>
#include <thread>

#include "base/version.hpp"

namespace hn {
namespace {

constexpr std::uint64_t kMostPoints = 10'000'000'000;

constexpr const char* kCommands = "drivers, list, run, merge, bench, paper or web";

// Options that several commands have.
void add_driver(CLI::App& command, std::string& driver) {
  command.add_option("--driver", driver, "One of those that hn-conform drivers lists")
      ->type_name("NAME")
      ->capture_default_str();
}

void add_filter(CLI::App& command, std::vector<std::string>& filters, const std::string& what) {
  command.add_option("--filter", filters, fmt::format("Only the {} whose id matches this glob; may be repeated", what))
      ->type_name("GLOB")
      ->allow_extra_args(false);
}

void add_thorough(CLI::App& command, bool& thorough) {
  command.add_flag("--thorough", thorough, "Every setting of the knobs in every version and stage, not pairs of them");
}

void add_out(CLI::App& command, std::string& out, const std::string& files) {
  command.add_option("--out", out, fmt::format("The folder for {}; made if it is not there", files))
      ->type_name("DIR")
      ->capture_default_str();
}

void add_glsl(CLI::App& command, std::string& directory) {
  command.add_option("--glsl", directory, "Take this copy of glsl/ instead of the one built in")->type_name("DIR");
}

void add_golden(CLI::App& command, std::string& directory) {
  command.add_option("--golden", directory, "The folder of the golden files")->type_name("DIR")->capture_default_str();
}

void add_rounds(CLI::App& command, int& rounds) {
  command.add_option("--rounds", rounds, "Samples of each time")
      ->type_name("N")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
}

// CLI::Range takes "nan".
CLI::Validator seconds_between(double low, double high) {
  const auto check = [=](const std::string& text) {
    double seconds = 0.0;
    const bool right = CLI::detail::lexical_cast(text, seconds) && seconds >= low && seconds <= high;
    return right ? std::string() : fmt::format("{} is no number from {} to {}", text, low, high);
  };
  return {check, fmt::format("FLOAT in [{} - {}]", low, high)};
}

void add_expect(CLI::App& command, std::string& directory) {
  command.add_option("--expect", directory, "The folder of the tables of what is expected to fail")
      ->type_name("DIR")
      ->capture_default_str();
}

void add_run(CLI::App& app, RunCommand& options, const std::string& faults) {
  CLI::App& command =
      *app.add_subcommand("run", "Run the cases on drivers and write results.json, junit.xml and index.html");
  command
      .add_option("--driver", options.drivers,
                  "One of those that hn-conform drivers lists, a glob, or all; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->capture_default_str();
  add_filter(command, options.filters, "cases");
  add_thorough(command, options.thorough);
  command.add_flag("--deal", options.deal,
                   "Of several drivers: run what each must show on each, and every other case on one that can run it");
  add_out(command, options.out, "results.json, junit.xml and index.html");
  command.add_option("--seed", options.suite.seed, "Of the random points")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0xFFFFFFFF}))
      ->capture_default_str();
  command
      .add_option("--points", options.suite.points,
                  "Compare each function with the C++ twin at so many random points (the cases *.twin), not at "
                  "262,144 at the most; --timeout is then for each million")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, kMostPoints));
  add_glsl(command, options.suite.glsl);
  add_golden(command, options.suite.golden);
  add_expect(command, options.expect);
  command.add_option("--shard", options.shard, "Only the Ith of N parts of the cases: 2/3 is the second of three")
      ->type_name("I/N");
  command.add_flag("--resume", options.resume, "Go on with a run that was broken off: what it has is not run again");
  command.add_option("--timeout", options.timeout, "Seconds that a case may take")
      ->type_name("SECONDS")
      ->check(seconds_between(0.1, 86400.0))
      ->capture_default_str();
  command.add_option("--jobs", options.jobs, "Drivers that run at the same time")
      ->type_name("N")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_flag("--fail-fast", options.fail_fast, "Stop at the first case that is not as expected");
  command
      .add_option(
          "--inject", options.suite.inject,
          fmt::format(
              "Make the driver behave as one that has a fault, to see what notices; \"list\" tells what each does: {}",
              faults))
      ->type_name("FAULT");
  command.add_flag("--timings", options.timings, "Time the functions of the cases, too, as multiples of Perlin/Float");
}

void add_merge(CLI::App& app, MergeCommand& options) {
  CLI::App& command = *app.add_subcommand("merge", "Join the results of shards, or of several machines");
  command.add_option("inputs", options.inputs, "Files results.json, or the folders that hold them")
      ->type_name("PATH")
      ->required();
  add_out(command, options.out, "results.json, junit.xml and index.html");
  add_expect(command, options.expect);
}

void add_bench(CLI::App& app, BenchCommand& options) {
  CLI::App& command = *app.add_subcommand("bench", "Measure what every function, hash and knob costs");
  add_driver(command, options.driver);
  add_filter(command, options.filters, "subjects");
  add_out(command, options.out, "bench.json, bench.csv and index.html");
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
  add_rounds(command, options.rounds);
  add_glsl(command, options.glsl);
  command.add_flag("--dump", options.dump, "Write the SPIR-V that was counted, too: spirv/ID.spv");
}

void add_paper(CLI::App& app, PaperCommand& options) {
  CLI::App& command = *app.add_subcommand("paper", "Reproduce what the paper shows, as a page with pictures and data");
  add_driver(command, options.driver);
  add_out(command, options.out, "index.html, paper.json, the CSV files and the pictures");
  add_rounds(command, options.rounds);
  add_glsl(command, options.glsl);
  command.add_flag("--dump", options.dump,
                   "Write what was measured, too: the values of the statistics as grids/ID.f32, the SPIR-V that was "
                   "counted as spirv/ID.spv");
}

void add_web(CLI::App& app, WebCommand& options) {
  CLI::App& command = *app.add_subcommand("web", "Write the page that checks a browser: one file, for any web server");
  add_out(command, options.out, "index.html");
  add_filter(command, options.filters, "cases");
  add_thorough(command, options.thorough);
  add_glsl(command, options.glsl);
  add_golden(command, options.golden);
}

tl::unexpected<Stop> wrong_usage(const std::string& message) {
  return tl::unexpected(Stop{kBadUsage, {}, fmt::format("hn-conform: {}\n", message)});
}

// Help that was asked for, or what is wrong, in CLI11's words.
tl::unexpected<Stop> stop_at(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = app.exit(error, out, err) == 0 ? 0 : kBadUsage;
  return tl::unexpected(Stop{status, out.str(), err.str()});
}

}  // namespace

std::string command_line(int argc, const char* const* argv) {
  std::string line = "hn-conform";
  for (const std::string_view argument :
       std::span(argv, static_cast<std::size_t>(argc)).subspan(std::min(argc, 1) == 1)) {
    const bool plain =
        argument.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#~!") == std::string_view::npos && !argument.empty();
    if (plain) {
      line += fmt::format(" {}", argument);
      continue;
    }
    std::string quoted(argument);
    for (auto at = quoted.find('\''); at != std::string::npos; at = quoted.find('\'', at + 4)) {
      quoted.replace(at, 1, "'\\''");
    }
    line += fmt::format(" '{}'", quoted);
  }
  return line;
}

tl::expected<Command, Stop> parse_options(int argc, const char* const* argv, const Installation& installation) {
  CLI::App app("Checks that hashnoise computes what it promises on a driver, and measures what it costs.",
               "hn-conform");
  app.set_version_flag("--version", library_version());
  app.footer(
      "Exit status: 0 all as expected, 1 something is not, 2 bad usage, 3 no usable driver, "
      "130 ended by Ctrl-C (SIGINT), 143 by SIGTERM, 129 by SIGHUP.");
  app.require_subcommand(0, 1);  // none gets a better message below
  ListCommand list;
  RunCommand run;
  run.suite.golden = installation.golden;
  MergeCommand merge;
  run.expect = merge.expect = installation.expect;
  run.jobs = std::max(1u, std::thread::hardware_concurrency());
  BenchCommand bench;
  PaperCommand paper;
  run.line = bench.line = paper.line = command_line(argc, argv);
  app.add_subcommand("drivers", "List the drivers, what is behind each here, or why it is missing");
  CLI::App& list_app = *app.add_subcommand("list", "List the ids of the cases");
  add_filter(list_app, list.filters, "cases");
  add_thorough(list_app, list.thorough);
  list_app.add_flag("--about", list.about, "Tell where cases come from, too: where a bug was reported");
  add_run(app, run, installation.faults);
  add_merge(app, merge);
  add_bench(app, bench);
  add_paper(app, paper);
  WebCommand web;
  web.golden = installation.golden;
  add_web(app, web);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    if (app.get_subcommands().empty()) {
      return wrong_usage(fmt::format("{}; there are {}", error.what(), kCommands));
    }
    return stop_at(app, error);
  } catch (const CLI::ParseError& error) {
    return stop_at(app, error);
  }
  if (app.got_subcommand("drivers")) return DriversCommand{};
  if (app.got_subcommand("list")) return list;
  if (app.got_subcommand("run")) return run;
  if (app.got_subcommand("merge")) return merge;
  if (app.got_subcommand("bench")) return bench;
  if (app.got_subcommand("paper")) return paper;
  if (app.got_subcommand("web")) return web;
  return wrong_usage(fmt::format("say what to do: {}; --help tells more", kCommands));
}

}  // namespace hn
