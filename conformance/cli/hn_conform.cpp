// hn-conform: does the library keep its promises on this driver, and at what cost?
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "base/console.hpp"
#include "base/folder.hpp"
#include "base/interruption.hpp"
#include "base/process.hpp"
#include "bench/shader_statistics.hpp"
#include "cli/command.hpp"
#include "cli/options.hpp"
#include "fault/faults.hpp"
#include "run/job.hpp"

#if !__has_include("paper/laboratory.hpp")
int hn::run(const PaperCommand&, Interruption&) { return usage_error("conformance/paper was deleted"); }
#endif

namespace {

int dispatch(int argc, char** argv, hn::Interruption& interruption) {
  const auto data = hn::data_folder_of(hn::own_program());
  const auto command = hn::parse_options(
      argc, argv, {.golden = data / "golden", .expect = data / "expect", .faults = hn::fault_names()});
  if (command) return std::visit([&](const auto& chosen) { return hn::run(chosen, interruption); }, *command);
  fmt::print("{}", command.error().out);
  fmt::print(stderr, "{}", command.error().err);
  return command.error().status;
}

// Before a signal ends the program.
void say_farewell(int signal, bool again) {
  if (isatty(STDERR_FILENO) != 0) std::fputs("\n", stderr);  // below a line of progress, or ^C
  hn::complain(again ? fmt::format("ended by a second {}", hn::name_of_signal(signal)) : hn::farewell(signal));
  hn::remove_folders_of(getpid());
}

int run_program(int argc, char** argv) {
  try {
    // Commands for the program itself, not for people.
    if (argc == 3 && argv[1] == std::string_view(hn::kChildCommand)) return hn::child_command(argv[2]);
    if (argc > 2 && argv[1] == std::string_view(hn::kStatisticsCommand)) {
      return hn::shader_statistics_command({argv + 2, argv + argc});
    }
    hn::Interruption interruption(say_farewell);
    signal(SIGXFSZ, SIG_IGN);  // a file that is longer than allowed is an error, like a full disk
    return hn::status_once_printed("hn-conform", dispatch(argc, argv, interruption));
  } catch (const std::exception& exception) {
    hn::complain(exception.what());
    return hn::kNotAsExpected;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int status = run_program(argc, argv);
  if (status > hn::kSignalled) hn::Interruption::end_by(status - hn::kSignalled);
  return status;
}
