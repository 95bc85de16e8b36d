// What the subcommands of hn-conform share.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "bench/bench.hpp"
#include "gpu/driver/driver.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/source.hpp"

namespace hn {

// Exit statuses. 0 is: all as expected.
constexpr int kNotAsExpected = 1;
constexpr int kBadUsage = 2;
constexpr int kNoDriver = 3;

int usage_error(const std::string& message);
int unknown_driver(const std::string& name);

// "osmesa, egl, ..."; of those that give a context, or of all.
enum class DriverKind { with_context, any };
std::string driver_names(DriverKind kind);

int drivers_command();
int list_command(const std::vector<std::string>& filters, bool about);

struct RunCommand {
  std::vector<std::string> drivers = {"osmesa"};  // names, globs, "all"
  std::vector<std::string> filters;
  std::string out = "out";
  std::string glsl;
  std::string golden;
  std::string expect;
  std::string shard;  // "I/N", or empty
  std::uint64_t seed = 1;
  std::uint64_t points = 0;  // of each comparison with the twin; 0 for what its case says
  double timeout = 60.0;     // seconds
  std::size_t jobs = 1;
  bool fail_fast = false;
  bool resume = false;
  bool timings = false;
  std::string inject;  // the name of a fault, or nothing
  std::string line;    // the command line, for the record
};
int run_command(const RunCommand& options);

struct MergeCommand {
  std::vector<std::string> inputs;
  std::string out = "out";
  std::string expect;
};
int merge_command(const MergeCommand& options);

struct BenchCommand {
  std::string driver = "osmesa";
  std::vector<std::string> filters;
  std::string out = "out";
  std::string glsl;
  std::vector<std::string> against;  // NAME=FILE:EXPRESSION
  std::string baseline;
  int rounds = 9;
  bool dump = false;
  std::string line;  // the command line, for the record
};
int bench_command(const BenchCommand& options);

struct PaperCommand {
  std::string driver = "osmesa";
  std::string out = "out";
  std::string glsl;
  int rounds = 9;
  bool dump = false;
  std::string line;
};
int paper_command(const PaperCommand& options);

struct WebCommand {
  std::string out = "out";
  std::string glsl;
  std::string golden;
};
int web_command(const WebCommand& options);

// A context with what stands above every result; or the exit status, after a message, where there is none.
struct OpenDriver {
  std::unique_ptr<Context> context;
  Provenance provenance;
};
tl::expected<OpenDriver, int> open_driver(const std::string& name, const std::string& command_line);

Result<SourceSet> library_sources(const std::string& directory);

}  // namespace hn
