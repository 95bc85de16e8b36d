// The command line: what is to be done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "run/job.hpp"

namespace hn {

// Exit statuses. 0 means that all is as expected.
constexpr int kNotAsExpected = 1;
constexpr int kBadUsage = 2;
constexpr int kNoDriver = 3;
constexpr int kSignalled = 128;  // and the number of the signal that ended it, as a shell counts it

struct DriversCommand {};

struct ListCommand {
  std::vector<std::string> filters;
  bool thorough = false;
  bool about = false;
  bool checks = false;  // what each check is, instead
};

// Which cases run, and on which drivers.
struct RunSelection {
  std::vector<std::string> drivers = {"osmesa"};  // names, globs, "all"
  std::vector<std::string> filters;
  std::string shard;  // "I/N", or empty
  bool thorough = false;
  bool deal = false;  // each case that not every driver must show on one of them
};

// How they run.
struct RunExecution {
  SuiteOptions suite;
  std::string expect;
  double timeout = 60.0;  // seconds
  std::size_t jobs = 1;
  bool fail_fast = false;
};

// Where the results go, and what else is recorded.
struct RunOutput {
  std::string out = "out";
  bool resume = false;  // what is there
  std::string line;     // the command line
};

struct RunCommand {
  RunSelection selection;
  RunExecution execution;
  RunOutput output;
};

struct CheckCommand {
  std::string function = {};  // [NAME[@VERSION]=]FILE:EXPRESSION
  std::string points = {};    // the names of CSV files; empty for none
  std::string expect = {};
  std::string record = {};
  double tolerance = 1e-5;
  RunCommand run;  // of what these make
};

struct MergeCommand {
  std::vector<std::string> inputs;
  std::string out = "out";
  std::string expect;
};

struct BenchCommand {
  std::string driver = "osmesa";
  std::vector<std::string> filters;
  std::string out = "out";
  std::string glsl;
  std::vector<std::string> against;  // [NAME[@VERSION]=]FILE:EXPRESSION
  int rounds = 9;
  bool dump = false;
  std::string line;  // the command line, for the record
};

struct SpirvCommand {
  std::vector<std::string> filters;
  std::string out = "out";
  std::string glsl;
  std::vector<std::string> against;  // [NAME[@VERSION]=]FILE:EXPRESSION
};

struct PaperCommand {
  std::string driver = "osmesa";
  std::string out = "out";
  std::string glsl;
  int rounds = 9;
  bool dump = false;
  std::string line;
};

struct WebCommand {
  std::string out = "out";
  std::vector<std::string> filters;
  bool thorough = false;
  std::string glsl;
  std::string golden;
};

using Command = std::variant<DriversCommand, ListCommand, RunCommand, CheckCommand, MergeCommand, BenchCommand,
                             SpirvCommand, PaperCommand, WebCommand>;

// There is nothing to do: help or the version was requested, or the usage is wrong.
struct Stop {
  int status;       // of the program: 0 or kBadUsage
  std::string out;  // for the standard output
  std::string err;  // and for the standard error
};

// The files that belong to the program.
struct Installation {
  std::string golden;  // folders that are taken if no option names others
  std::string expect;
  std::string faults = {};  // the names for --inject
};

// Only reads the arguments. The first is the program's name.
tl::expected<Command, Stop> parse_options(int argc, const char* const* argv, const Installation& installation);

}  // namespace hn
