// hn-conform: does the library compute what it promises, on this driver, and at what cost?
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "base/process.hpp"
#include "bench/amd.hpp"
#include "cli/child.hpp"
#include "cli/command.hpp"
#include "cli/data_folder.hpp"
#include "cli/options.hpp"
#include "fault/faults.hpp"
#include "run/job.hpp"

namespace {

int run(const hn::DriversCommand&) { return hn::drivers_command(); }
int run(const hn::ListCommand& command) { return hn::list_command(command); }
int run(const hn::RunCommand& command) { return hn::run_command(command); }
int run(const hn::MergeCommand& command) { return hn::merge_command(command); }
int run(const hn::BenchCommand& command) { return hn::bench_command(command); }
int run(const hn::PaperCommand& command) { return hn::paper_command(command); }
int run(const hn::WebCommand& command) { return hn::web_command(command); }

int dispatch(int argc, char** argv) {
  const auto data = hn::data_folder_of(hn::own_program());
  const auto command = hn::parse_options(
      argc, argv, {.golden = data / "golden", .expect = data / "expect", .faults = hn::fault_names()});
  if (command) return std::visit([](const auto& chosen) { return run(chosen); }, *command);
  fmt::print("{}", command.error().out);
  fmt::print(stderr, "{}", command.error().err);
  return command.error().status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    // What we start ourselves; not for people.
    if (argc == 3 && argv[1] == std::string_view(hn::kChildCommand)) return hn::child_command(argv[2]);
    if (argc == 3 && argv[1] == std::string_view(hn::kAmdCommand)) return hn::amd_counts_child(argv[2]);
    return dispatch(argc, argv);
  } catch (const std::exception& exception) {
    fmt::print(stderr, "hn-conform: {}\n", exception.what());
    return hn::kNotAsExpected;
  }
}
