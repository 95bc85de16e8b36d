// What the subcommands of hn-conform share.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "bench/bench.hpp"
#include "cli/drivers.hpp"
#include "cli/options.hpp"

namespace hn {

int usage_error(const std::string& message);
int unknown_driver(const std::string& name);

// "osmesa, egl, ..."; of those that give a context, or of all.
enum class DriverKind { with_context, any };
std::string driver_names(DriverKind kind);

int drivers_command();
int list_command(const ListCommand& options);
int run_command(const RunCommand& options);
int merge_command(const MergeCommand& options);
int bench_command(const BenchCommand& options);
int paper_command(const PaperCommand& options);
int web_command(const WebCommand& options);

// A context with what stands above every result; or the exit status, after a message, where there is none.
struct OpenDriver {
  std::unique_ptr<Context> context;
  Provenance provenance;
};
tl::expected<OpenDriver, int> open_driver(const std::string& name, const std::string& command_line);

}  // namespace hn
