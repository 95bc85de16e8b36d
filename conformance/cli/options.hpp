// The command line: what is to be done.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "cli/command.hpp"

namespace hn {

struct DriversCommand {};

struct ListCommand {
  std::vector<std::string> filters;
  bool about = false;
};

using Command =
    std::variant<DriversCommand, ListCommand, RunCommand, MergeCommand, BenchCommand, PaperCommand, WebCommand>;

// Where nothing is to be done: help or the version was asked for, or the usage is wrong.
struct Stop {
  int status;       // of the program: 0 or kBadUsage
  std::string out;  // for the standard output
  std::string err;  // and for the standard error
};

// What the program comes with.
struct Installation {
  std::string golden;  // folders that are taken if no option names others
  std::string expect;
  std::string faults = {};  // the names for --inject
};

// Does nothing but read the arguments, the first of which is the program's name.
tl::expected<Command, Stop> parse_options(int argc, const char* const* argv, const Installation& installation);

// The arguments after the first, as a shell would take them again, behind "hn-conform".
std::string command_line(int argc, const char* const* argv);

}  // namespace hn
