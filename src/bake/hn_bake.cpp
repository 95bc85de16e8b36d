// hn-bake: a noise as a picture, a volume or raw numbers.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "bake/expression_program.hpp"
#include "bake/files.hpp"
#include "bake/options.hpp"
#include "bake/planes.hpp"
#include "bake/progress.hpp"
#include "base/console.hpp"
#include "base/file.hpp"
#include "base/interruption.hpp"
#include "base/json.hpp"
#include "base/temporary_folder.hpp"

namespace {

constexpr const char* kProgram = "hn-bake";

// Held while a file is written, so that a signal waits for its end: there is a whole file, or none.
std::mutex writing;

// Runs before a signal ends the program. Its locks stay locked.
void say_farewell(int signal, bool) {
  if (isatty(STDERR_FILENO) != 0) std::fputs("\n", stderr);  // below a line of progress, or ^C
  writing.lock();
  hn::remove_folders_of(getpid());  // where an expression was compiled; its processes end with this one
  hn::complain(kProgram, fmt::format("ended by {}; what was not finished is not there", hn::name_of_signal(signal)));
}

int usage_error(std::string_view message) {
  hn::complain(kProgram, message);
  return hn::kBadUsage;
}

hn::Result<void> write_whole(const std::filesystem::path& path, std::string_view bytes) {
  const std::lock_guard lock(writing);
  return hn::write_file(path, bytes);
}

// Before the work rather than after it.
hn::Result<void> make_sure_it_can_be_written(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return hn::fail(fmt::format("--out {}: it is a folder; name a file in it", path.string()));
  }
  const std::filesystem::path folder = path.parent_path();
  if (!folder.empty() && std::filesystem::status(folder, error).type() == std::filesystem::file_type::not_found) {
    return hn::fail(fmt::format("--out {}: there is no folder {}; make it, or name a file in another", path.string(),
                                folder.string()));
  }
  const std::lock_guard lock(writing);
  if (const auto written = hn::try_to_write(path); !written) {
    const std::string& message = written.error().message;
    return hn::fail(
        fmt::format("--out {}: no file can be made there: {}", path.string(), message.substr(message.rfind(": ") + 2)));
  }
  return {};
}

// As a floating-point number, since there may be more than any integer counts.
double points_of(const hn::BakeOptions& options) {
  return std::accumulate(options.size.begin(), options.size.end(), 1.0, std::multiplies<>());
}

// All values are in memory at a time, as floats, and the words that become of them. Linux gives memory that is not
// there, and ends the program later.
hn::Result<void> make_sure_it_fits(const hn::BakeOptions& options, std::size_t components) {
  const double needed = points_of(options) * static_cast<double>(components * sizeof(float));
  const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed < there) return {};
  return hn::fail(
      fmt::format("--size: {} points with {} components need {:.3g} GB, and this machine has {:.3g} GB of "
                  "memory; bake parts of it with --origin",
                  fmt::join(options.size, " x "), components, needed * 1e-9, there * 1e-9));
}

std::string listed(const std::vector<int>& size) { return fmt::format("{}", fmt::join(size, " x ")); }

void print_text(const hn::BakeOptions& options, const hn::Report& report, double seconds) {
  const std::size_t files = report.files.size();
  fmt::print("{}{}: {} of {} points, {}", report.files.front().string(),
             files > 1 ? fmt::format(" to {}", report.files.back().string()) : "", options.function,
             listed(options.size), name_of(options.format));
  if (report.atlas.columns > 1) fmt::print(", {} slices in {} columns", report.atlas.slices, report.atlas.columns);
  if (options.tile) fmt::print(", a tile of {} cells", fmt::join(options.cells, " x "));
  fmt::print(", in {:.2f} s\n", seconds);
  for (const hn::Component& component : report.components) {
    fmt::print("  {}: {} to {}", component.name, component.range.least, component.range.greatest);
    if (component.mapping) {
      const hn::Mapping& mapping = *component.mapping;
      fmt::print("; {} to {} ({}) became 0 to 65535", mapping.interval.least, mapping.interval.greatest,
                 mapping.source);
    }
    fmt::print("\n");
  }
}

void warn_of_values(const hn::Report& report) {
  for (const hn::Component& component : report.components) {
    if (component.nans != 0) {
      hn::complain(kProgram, fmt::format("warning: {} values of {} are NaN{}", component.nans, component.name,
                                         component.mapping ? ", and became 0" : ""));
    }
    if (!component.mapping || component.mapping->clamped == 0) continue;
    const hn::Interval& interval = component.mapping->interval;
    hn::complain(
        kProgram,
        fmt::format("warning: {} values of {} are outside of {} to {}, and became its ends; they go from {} to {}",
                    component.mapping->clamped, component.name, interval.least, interval.greatest,
                    component.range.least, component.range.greatest));
  }
}

// Reads what the expression calls, and compiles it; the status of the program if that is impossible.
tl::expected<hn::ExpressionProgram, int> program_of(hn::BakeOptions& options) {
  const auto& source = options.expression->source;
  if (!source.empty()) {
    auto text = hn::read_file(source, "--source wants a file of GLSL with functions");
    if (!text) return tl::unexpected(usage_error(text.error().text()));
    options.expression->source_text = *std::move(text);
  }
  const bool terminal = isatty(STDERR_FILENO) != 0;
  if (terminal) std::fputs("\r\033[Kcompiling the expression", stderr);
  auto program = hn::ExpressionProgram::make(options);
  if (terminal) std::fputs("\r\033[K", stderr);
  if (program) return std::move(*program);
  hn::complain(kProgram, program.error().message);
  return tl::unexpected(program.error().status);
}

// The values of the expression or the function, with a line of progress.
hn::Result<hn::Planes> values_of(const hn::BakeOptions& options, const std::optional<hn::ExpressionProgram>& program) {
  const auto width = static_cast<std::size_t>(options.size.front());
  hn::RowsProgress progress(static_cast<std::size_t>(points_of(options)) / width, width);
  const auto rows_done = [&](std::size_t rows) { progress.add(rows); };
  return program ? hn::compute(*program, options, rows_done) : hn::compute(options, rows_done);
}

void print_record(const hn::BakeOptions& options, const hn::Planes& planes, const hn::Report& report, double seconds) {
  auto record = hn::record_of(options, planes, report);
  record["files"] = nlohmann::ordered_json::array();
  for (const auto& file : report.files) record["files"].push_back(file.string());
  if (!options.expression) record["instruction_set"] = hashnoise::name(planes.instruction_set);
  record["seconds"] = seconds;
  fmt::print("{}\n", hn::dump(record, 1));
}

int bake(hn::BakeOptions options) {
  const auto start = std::chrono::steady_clock::now();
  for (const auto& file : hn::files_of(options)) {
    if (const auto possible = make_sure_it_can_be_written(file); !possible) return usage_error(possible.error().text());
  }
  std::optional<hn::ExpressionProgram> program;
  if (options.expression) {
    auto made = program_of(options);
    if (!made) return made.error();
    program.emplace(*std::move(made));
  }
  std::vector<std::string> names;
  try {
    if (program) {
      for (const std::size_t i : hn::chosen_components(program->components(), options)) {
        names.push_back(program->components()[i]);
      }
    } else {
      names = hn::component_names(options);
    }
  } catch (const std::invalid_argument& problem) {
    return usage_error(problem.what());
  }
  const auto mappings = hn::mappings_of(options, names);
  if (!mappings) return usage_error(mappings.error().text());
  if (const auto fits = make_sure_it_fits(options, names.size()); !fits) return usage_error(fits.error().text());
  auto planes = values_of(options, program);
  if (!planes) {
    hn::complain(kProgram, planes.error().text());
    return hn::kNotWritten;
  }
  hn::Planes without_values;
  without_values.instruction_set = planes->instruction_set;
  const auto report = hn::write_files(options, *std::move(planes), *mappings, write_whole);
  if (!report) {
    hn::complain(kProgram, report.error().text());
    return hn::kNotWritten;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  warn_of_values(*report);
  if (options.json) {
    print_record(options, without_values, *report, seconds);
  } else {
    print_text(options, *report, seconds);
  }
  return 0;
}

// --size may need more memory than there is.
bool is_out_of_memory(const std::exception& problem) {
  return dynamic_cast<const std::bad_alloc*>(&problem) || dynamic_cast<const std::length_error*>(&problem);
}

int run_program(int argc, char** argv) {
  try {
    hn::Interruption interruption(say_farewell);
    signal(SIGXFSZ, SIG_IGN);  // a file that is longer than allowed is an error, like a full disk
    const auto options = hn::parse_options(argc, argv);
    if (options) return hn::status_once_printed(kProgram, bake(*options));
    fmt::print("{}", options.error().out);
    if (!options.error().err.empty()) hn::complain(kProgram, options.error().err);
    return hn::status_once_printed(kProgram, options.error().status);
  } catch (const std::exception& problem) {
    hn::complain(kProgram, is_out_of_memory(problem)
                               ? "there is not enough memory for so many points; take a smaller --size"
                               : problem.what());
    return hn::kNotWritten;
  }
}

}  // namespace

int main(int argc, char** argv) { return run_program(argc, argv); }
