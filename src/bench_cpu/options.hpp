// The command line of hn-bench-cpu.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace hn {

// Exit statuses. 0 means that everything was measured, whatever the numbers are.
constexpr int kNotMeasured = 1;
constexpr int kBadUsage = 2;

struct BenchCpuOptions {
  std::string out = "docs/measured/results/cpu";
  std::string against;  // the file of FastNoise2, or empty
  std::string strict;   // of one that was built with FASTNOISE2_STRICT_FP
  std::string python;   // a program, or empty
  std::vector<std::string> filters;
  std::string note;
  int rounds = 15;
};

// There is nothing to do: help or the version was requested, or the usage is wrong.
struct Stop {
  int status;       // of the program: 0 or kBadUsage
  std::string out;  // for the standard output
  std::string err;  // what is wrong, and what would be right
};

// Only reads the arguments. The first is the program's name.
tl::expected<BenchCpuOptions, Stop> parse_options(int argc, const char* const* argv);

}  // namespace hn
