// What the subcommands of hn-conform share.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "base/interruption.hpp"
#include "bench/bench.hpp"
#include "cli/drivers.hpp"
#include "cli/options.hpp"

namespace hn {

// On the standard output. That it could not be written is told in the end, and ends nothing before.
void say(const std::string& text);
// On the standard error, with the program's name.
void complain(const std::string& message);
int usage_error(const std::string& message);
std::string farewell(int signal);  // where there are no results
int unknown_driver(const std::string& name);

// "osmesa, egl, ..."; of those that give a context, or of all.
enum class DriverKind { with_context, any };
std::string driver_names(DriverKind kind);

// They note a signal where they have begun what they end themselves, so that what is written is whole.
int drivers_command(Interruption& interruption);
int list_command(const ListCommand& options);
int run_command(const RunCommand& options, Interruption& interruption);
int merge_command(const MergeCommand& options, Interruption& interruption);
int bench_command(const BenchCommand& options, Interruption& interruption);
int paper_command(const PaperCommand& options, Interruption& interruption);
int web_command(const WebCommand& options, Interruption& interruption);

// A context with what stands above every result; or the exit status, after a message, where there is none.
struct OpenDriver {
  std::unique_ptr<Context> context;
  Provenance provenance;
};
tl::expected<OpenDriver, int> open_driver(const std::string& name, const std::string& command_line);

}  // namespace hn
