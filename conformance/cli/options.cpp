#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <hashnoise/detail/closest.hpp>
#include <sstream>
#include <string_view>
#include <thread>

#include "base/text.hpp"
#include "library/source.hpp"

namespace hn {
namespace {

using hashnoise::detail::suggestion;

constexpr std::uint64_t kMostPoints = 10'000'000'000;

constexpr const char* kCommands = "drivers, list, run, check, merge, bench, spirv, paper or web";

void add_statuses(CLI::App& command, const std::string& statuses) {
  command.footer(fmt::format("Exit status: {}.", statuses));
}

// Options that several commands have.
void add_driver(CLI::App& command, std::string& driver) {
  command.add_option("--driver", driver, "A driver that hn-conform drivers lists")
      ->type_name("NAME")
      ->capture_default_str();
}

void add_filter(CLI::App& command, std::vector<std::string>& filters, const std::string& what) {
  command.add_option("--filter", filters, fmt::format("Only the {} whose id matches this glob; may be repeated", what))
      ->type_name("GLOB")
      ->allow_extra_args(false);
}

void add_thorough(CLI::App& command, bool& thorough) {
  command.add_flag("--thorough", thorough, "Run every setting of the knobs in every version and stage, not pairs only");
}

void add_out(CLI::App& command, std::string& out, const std::string& files) {
  command.add_option("--out", out, fmt::format("The folder for {}; it is created if it does not exist", files))
      ->type_name("DIR")
      ->capture_default_str();
}

void add_glsl(CLI::App& command, std::string& directory) {
  command.add_option("--glsl", directory, "Use this copy of glsl/hashnoise/ instead of the built-in one")
      ->type_name("DIR");
}

void add_against(CLI::App& command, std::vector<std::string>& against, const std::string& what) {
  command
      .add_option("--against", against,
                  what +
                      ": the expression is a float from p, a vec2 or a vec3, as in s=other.glsl:snoise(p); s@420=... "
                      "requires GLSL 4.20; may be repeated")
      ->type_name("[NAME[@VERSION]=]FILE:EXPRESSION")
      ->allow_extra_args(false);
}

void add_golden(CLI::App& command, std::string& directory) {
  command.add_option("--golden", directory, "The folder of the golden files")->type_name("DIR")->capture_default_str();
}

void add_rounds(CLI::App& command, int& rounds) {
  command.add_option("--rounds", rounds, "How many samples of each time")
      ->type_name("N")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
}

// CLI::Range takes "nan".
CLI::Validator number_between(double low, double high) {
  const auto check = [=](const std::string& text) {
    double number = 0.0;
    const bool right = CLI::detail::lexical_cast(text, number) && number >= low && number <= high;
    return right ? std::string() : fmt::format("{} is not a number from {} to {}", text, low, high);
  };
  return {check, fmt::format("FLOAT in [{} - {}]", low, high)};
}

void add_expect(CLI::App& command, std::string& directory) {
  command.add_option("--expect", directory, "The folder of the tables of expected failures")
      ->type_name("DIR")
      ->capture_default_str();
}

void add_way(CLI::App& command, WayOptions& way) {
  const auto add = [&](const char* name, std::vector<std::string>& values, const char* type, const char* help) {
    command.add_option(name, values, help)->type_name(type)->allow_extra_args(false);
  };
  add("--through", way.through, "TRANSLATOR",
      "A translator between the suite's shaders and the driver: NAME[:FORM][=PROGRAM], or a command with {in} and "
      "{out}; may be repeated, in the order of the steps");
  add("--takes", way.takes, "FORM", "The form that a command takes, such as spirv; one for each command");
  add("--gives", way.gives, "FORM", "The form that a command gives, such as glsl-es; one for each command");
}

// Options of run and check: on which drivers, how, and where the results go.
void add_execution(CLI::App& command, RunCommand& run) {
  command
      .add_option("--driver", run.selection.drivers,
                  "A driver that hn-conform drivers lists, a glob, or all; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->capture_default_str();
  add_filter(command, run.selection.filters, "cases");
  add_out(command, run.output.out, "results.json, junit.xml and index.html");
  command.add_flag("--resume", run.output.resume,
                   "Continue a run that was interrupted; finished cases are not run again");
  command.add_option("--timeout", run.execution.timeout, "Seconds that a case may take")
      ->type_name("SECONDS")
      ->check(number_between(0.1, 86400.0))
      ->capture_default_str();
  command.add_option("--jobs", run.execution.jobs, "How many processes run at the same time")
      ->type_name("N")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_flag("--fail-fast", run.execution.fail_fast, "Stop at the first case that is not as expected");
  add_way(command, run.execution.suite.way);
}

void add_run(CLI::App& app, RunCommand& run, const std::string& faults) {
  CLI::App& command =
      *app.add_subcommand("run", "Run the cases on drivers and write results.json, junit.xml and index.html");
  add_execution(command, run);
  add_thorough(command, run.selection.thorough);
  command.add_flag("--deal", run.selection.deal,
                   "With several drivers: run on each what every driver must show, and each other case on one");
  command.add_option("--seed", run.execution.suite.seed, "The seed of the random points")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0xFFFFFFFF}))
      ->capture_default_str();
  command
      .add_option("--points", run.execution.suite.points,
                  "How many random points the cases *.twin compare with the C++ twin, instead of at most "
                  "65,536; --timeout is then for each million")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, kMostPoints));
  add_glsl(command, run.execution.suite.glsl);
  add_golden(command, run.execution.suite.golden);
  add_expect(command, run.execution.expect);
  command
      .add_option("--shard", run.selection.shard, "Only the Ith of N parts of the cases: 2/3 is the second of three")
      ->type_name("I/N");
  command
      .add_option(
          "--inject", run.execution.suite.inject,
          fmt::format(
              "Make the driver behave as if it had a fault, to see which cases fail; \"list\" describes the faults: {}",
              faults))
      ->type_name("FAULT");
}

void add_check(CLI::App& app, CheckCommand& options) {
  CLI::App& command = *app.add_subcommand(
      "check", "Compare what your own function returns on drivers: with a file, with a record, or with the first one");
  command
      .add_option("FUNCTION", options.function,
                  "A file of GLSL and an expression of the points' columns, as in 'noise.glsl:snoise(p)'; s@430=... "
                  "has another name, and requires GLSL 4.30")
      ->type_name("[NAME[@VERSION]=]FILE:EXPRESSION")
      ->required();
  command
      .add_option("--points", options.points,
                  "The arguments: a CSV file, whose header names them: p.x,p.y is a vec2 p, and seed:uint a uint")
      ->type_name("CSV")
      ->required();
  CLI::Option* const expect =
      command.add_option("--expect", options.expect, "The right values: a row for each of the points")
          ->type_name("CSV");
  command.add_option("--record", options.record, "Write the values of the first driver there, and compare nothing")
      ->type_name("CSV")
      ->excludes(expect);
  command.add_option("--tolerance", options.tolerance, "How far a float may be off; 0: it must be the very number")
      ->type_name("NUMBER")
      ->check(number_between(0.0, 1e30))
      ->capture_default_str();
  add_execution(command, options.run);
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
  add_statuses(command, "0 done, 1 something could not be measured, 2 bad usage, 3 no usable driver");
  add_driver(command, options.driver);
  add_filter(command, options.filters, "subjects");
  add_out(command, options.out, "bench.csv");
  add_against(command, options.against, "Also measure a shader file");
  add_rounds(command, options.rounds);
  add_glsl(command, options.glsl);
  command.add_flag("--dump", options.dump, "Also write the SPIR-V that was counted: spirv/ID.spv");
}

void add_spirv(CLI::App& app, SpirvCommand& options) {
  CLI::App& command =
      *app.add_subcommand("spirv", "Write the SPIR-V of what bench counts, for other compilers; it needs no driver");
  add_statuses(command, "0 done, 1 a shader could not be compiled, 2 bad usage");
  add_filter(command, options.filters, "subjects");
  add_out(command, options.out, "spirv/ID.spv");
  add_against(command, options.against, "Also a shader file");
  add_glsl(command, options.glsl);
}

void add_paper(CLI::App& app, PaperCommand& options) {
  CLI::App& command = *app.add_subcommand(
      "paper", "Measure what the paper shows, as records; tools/measure paper makes a page of them");
  add_statuses(command, "0 done, 1 something could not be measured, 2 bad usage, 3 no usable driver");
  add_driver(command, options.driver);
  add_out(command, options.out, "CSV files, and values/ with what is drawn");
  add_rounds(command, options.rounds);
  add_glsl(command, options.glsl);
  command.add_flag("--dump", options.dump, "Also write the SPIR-V that was counted: spirv/ID.spv");
}

void add_web(CLI::App& app, WebCommand& options) {
  CLI::App& command = *app.add_subcommand("web", "Write the page that checks a browser: one file, for any web server");
  add_statuses(command, "0 done, 2 bad usage");
  add_out(command, options.out, "index.html");
  add_filter(command, options.filters, "cases");
  add_thorough(command, options.thorough);
  add_glsl(command, options.glsl);
  add_golden(command, options.golden);
}

tl::unexpected<Stop> wrong_usage(const std::string& message) {
  return tl::unexpected(Stop{kBadUsage, {}, fmt::format("hn-conform: {}\n", message)});
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(fmt::format("--{}", name));
  }
  return names;
}

tl::unexpected<Stop> unknown_command(const CLI::App& app, const std::string& word) {
  return wrong_usage(fmt::format("there is no command \"{}\"{}; there are {}", word,
                                 suggestion(word, names_of_commands(app)), kCommands));
}

// The command that the arguments name, or the program itself.
const CLI::App& chosen_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

// "hn-conform run"
std::string full_name(const CLI::App& app, const CLI::App& command) {
  return &command == &app ? app.get_name() : fmt::format("{} {}", app.get_name(), command.get_name());
}

bool has_option(const CLI::App& command, const std::string& name) {
  return std::ranges::count(names_of_options(command), name) != 0;
}

// The first argument that a command did not take; behind "--" none is an option.
std::string first_left_over(const CLI::App& command) {
  const auto left = command.remaining();
  const auto first = std::ranges::find_if(left, [](const std::string& argument) { return argument != "--"; });
  return first == left.end() ? std::string() : *first;
}

// Where the arguments have a word that the chosen command does not take.
tl::unexpected<Stop> unexpected_argument(const CLI::App& app) {
  const std::string before = first_left_over(app);
  const CLI::App& command = before.empty() ? chosen_command(app) : app;
  const std::string argument = before.empty() ? first_left_over(command) : before;
  const std::string word = argument.substr(0, argument.find('='));
  const bool is_option = argument.starts_with('-');
  const auto wrong = [&](const std::string& what) {
    return wrong_usage(fmt::format("{}; see {} --help", what, full_name(app, command)));
  };
  if (!is_option) {
    return &command == &app ? unknown_command(app, argument)
                            : wrong(fmt::format("\"{}\" is one argument too many", argument));
  }
  for (const CLI::App* const other : commands_of(app)) {
    if (&command != &app || !has_option(*other, word)) continue;
    return wrong(fmt::format("{} belongs after a command, as in {} {}", word, full_name(app, *other), word));
  }
  return wrong(fmt::format("there is no option {}{}", word, suggestion(word, names_of_options(command))));
}

// Help for the command of this name, or for the program if it is empty.
tl::unexpected<Stop> help_with(const CLI::App& app, const std::string& topic) {
  // App::help would describe the command that was chosen, which is "help".
  if (topic.empty()) {
    return tl::unexpected(
        Stop{0, app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal), {}});
  }
  for (const CLI::App* const command : commands_of(app)) {
    if (command->get_name() == topic) return tl::unexpected(Stop{0, command->help(app.get_name()), {}});
  }
  return unknown_command(app, topic);
}

// The help, or the error in CLI11's words.
tl::unexpected<Stop> stop_at(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) {
    return wrong_usage(fmt::format("{}; see {} --help", error.what(), full_name(app, chosen_command(app))));
  }
  std::ostringstream out;
  std::ostringstream err;
  app.exit(error, out, err);
  return tl::unexpected(Stop{0, out.str(), err.str()});
}

}  // namespace

tl::expected<Command, Stop> parse_options(int argc, const char* const* argv, const Installation& installation) {
  CLI::App app("Checks that hashnoise computes what it promises on a driver, and measures what it costs.",
               "hn-conform");
  app.set_version_flag("--version", library_version());
  add_statuses(
      app,
      "0 all as expected, 1 something is not, 2 bad usage, 3 no usable driver, 130 ended by Ctrl-C (SIGINT), "
      "143 by SIGTERM, 129 by SIGHUP; of tools/conform and of tools/measure clock and paper also 4, it could not be "
      "built");
  app.require_subcommand(0, 1);  // none gets a better message below
  ListCommand list;
  RunCommand run;
  run.execution.suite.golden = installation.golden;
  MergeCommand merge;
  run.execution.expect = merge.expect = installation.expect;
  run.execution.jobs = std::max(1u, std::thread::hardware_concurrency());
  BenchCommand bench;
  SpirvCommand spirv;
  PaperCommand paper;
  std::vector<std::string> words = {"hn-conform"};
  words.insert(words.end(), argv + std::min(argc, 1), argv + argc);
  run.output.line = bench.line = paper.line = command_line(words);
  add_statuses(*app.add_subcommand("drivers", "List the drivers, what is behind each here, or why it is missing"),
               "0 there is a usable driver, 2 bad usage, 3 there is none");
  CLI::App& list_app = *app.add_subcommand("list", "List the ids of the cases");
  add_statuses(list_app, "0 done, 2 bad usage");
  add_filter(list_app, list.filters, "cases");
  add_thorough(list_app, list.thorough);
  list_app.add_flag("--about", list.about, "Also print where cases come from: where a bug was reported");
  list_app.add_flag("--checks", list.checks, "Print what each check demands (docs/reference/checks.md)")
      ->excludes("--filter");
  add_run(app, run, installation.faults);
  CheckCommand check{.run = run};
  check.run.selection.drivers = {"all"};
  add_check(app, check);
  add_merge(app, merge);
  add_bench(app, bench);
  add_spirv(app, spirv);
  add_paper(app, paper);
  WebCommand web;
  web.golden = installation.golden;
  add_web(app, web);
  std::string topic;
  CLI::App& help_app = *app.add_subcommand("help", "Print what a command does, as its option --help does");
  add_statuses(help_app, "0 done, 2 bad usage");
  help_app.add_option("COMMAND", topic, "One of the other commands")->type_name("");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return unexpected_argument(app);
  } catch (const CLI::ParseError& error) {
    return stop_at(app, error);
  }
  if (app.got_subcommand("help")) return help_with(app, topic);
  if (app.got_subcommand("drivers")) return DriversCommand{};
  if (app.got_subcommand("list")) return list;
  if (app.got_subcommand("run")) return run;
  if (app.got_subcommand("check")) return check;
  if (app.got_subcommand("merge")) return merge;
  if (app.got_subcommand("bench")) return bench;
  if (app.got_subcommand("spirv")) return spirv;
  if (app.got_subcommand("paper")) return paper;
  if (app.got_subcommand("web")) return web;
  return wrong_usage(fmt::format("name a command: {}; see --help", kCommands));
}

}  // namespace hn
