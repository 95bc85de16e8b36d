// Common parts of the subcommands of hn-conform.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "base/interruption.hpp"
#include "bench/bench.hpp"
#include "cases/case.hpp"
#include "cli/drivers.hpp"
#include "cli/options.hpp"

namespace hn {

// Writes to the standard output. A failure to write is reported at the end, and stops nothing before.
void say(const std::string& text);
// Writes to the standard error, with the program's name.
void complain(const std::string& message);
int usage_error(const std::string& message);
std::string farewell(int signal);  // where there are no results
int unknown_driver(const std::string& name);

// "osmesa, egl, ...": the drivers that give a context, or all.
enum class DriverKind { with_context, any };
std::string driver_names(DriverKind kind);

// The cases that match one of the filters, or all: of the default run, and if none of these matches, or with thorough,
// of the product. So any id that a run has shown can be run again. Having none is an error.
struct Selection {
  std::vector<Case> cases;
  bool thorough;
};
Result<Selection> select_cases(const std::vector<std::string>& filters, bool thorough);

struct DriverChoice {
  std::vector<std::string> names;
  std::set<std::string> named;  // not by a glob, so they must be here
  std::vector<std::string> problems;
  WayOptions way = {};
  std::map<std::string, Way> ways = {};  // that it gives, to each of the names
  std::vector<Run> absent = {};          // drivers to which it gives none
};
// Names, globs, and "all"; each driver once, with the way to it. It ends once stop_fd can be read.
Result<DriverChoice> choose_drivers(const std::vector<std::string>& wanted, const WayOptions& way, int stop_fd);

// The commands. They only note a signal while they do something that they must finish themselves, so that files are
// whole. Each returns the exit status of the program.
int run(const DriversCommand& command, Interruption& interruption);
int run(const ListCommand& command, Interruption& interruption);
int run(const RunCommand& command, Interruption& interruption);
int run(const CheckCommand& command, Interruption& interruption);
int run(const MergeCommand& command, Interruption& interruption);
int run(const BenchCommand& command, Interruption& interruption);
int run(const SpirvCommand& command, Interruption& interruption);
int run(const PaperCommand& command, Interruption& interruption);
int run(const WebCommand& command, Interruption& interruption);
// The process that runs the cases of one driver: the hidden subcommand "child JOB" with the path of the job.
int child_command(const std::filesystem::path& job);

// The folder that holds the folders golden/ and expect/. It is found from the program's own path, so that both can be
// moved. It is the folder beside the program, as in a build; if that is missing, it is the folder of an installed
// program.
std::filesystem::path data_folder_of(const std::filesystem::path& program);

// A context, and the provenance that stands above every result. Without a context: the exit status, after a message.
struct OpenDriver {
  std::unique_ptr<Context> context;
  Provenance provenance;
};
tl::expected<OpenDriver, int> open_driver(const std::string& name, const std::string& command_line);

}  // namespace hn
