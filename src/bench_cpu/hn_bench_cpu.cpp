// hn-bench-cpu: what hashnoise::grid costs on this processor, beside FastNoise2 and Python.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fnmatch.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <exception>

#include "base/command_line.hpp"
#include "base/console.hpp"
#include "base/file.hpp"
#include "base/interruption.hpp"
#include "base/output_folder.hpp"
#include "base/temporary_folder.hpp"
#include "base/version.hpp"
#include "bench_cpu/fast_noise.hpp"
#include "bench_cpu/measure.hpp"
#include "bench_cpu/options.hpp"
#include "bench_cpu/record.hpp"

namespace {

constexpr const char* kProgram = "hn-bench-cpu";

void say_farewell(int signal, bool) {
  if (isatty(STDERR_FILENO) != 0) std::fputs("\n", stderr);
  hn::complain(kProgram, fmt::format("ended by {}; no results are written", hn::name_of_signal(signal)));
  hn::remove_folders_of(getpid());
}

int usage_error(std::string_view message) {
  hn::complain(kProgram, message);
  return hn::kBadUsage;
}

int failure(std::string_view message) {
  hn::complain(kProgram, message);
  return hn::kNotMeasured;
}

bool is_wanted(const hn::Subject& subject, const std::vector<std::string>& filters) {
  return filters.empty() || std::ranges::any_of(filters, [&](const std::string& filter) {
           return fnmatch(filter.c_str(), subject.id.c_str(), 0) == 0;
         });
}

// As somebody else would call it: files by their names, and not where they are here.
std::string command_of(const hn::BenchCpuOptions& options) {
  const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  std::vector<std::string> words = {"tools/measure cpu", "--rounds", std::to_string(options.rounds)};
  if (!options.against.empty()) words.insert(words.end(), {"--against", "fastnoise2=" + name_of(options.against)});
  if (!options.strict.empty()) words.insert(words.end(), {"--against", "strict=" + name_of(options.strict)});
  if (!options.python.empty()) words.insert(words.end(), {"--python", name_of(options.python)});
  for (const std::string& filter : options.filters) words.insert(words.end(), {"--filter", filter});
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return hn::command_line("tools/measure cpu", static_cast<int>(pointers.size()), pointers.data());
}

// A line on a terminal that the next one overwrites, and nothing elsewhere.
void show_progress(std::size_t done, std::size_t all, const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fputs(fmt::format("\r\033[K[{}/{}] {}", done, all, what).c_str(), stderr);
  if (what.empty()) std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

int bench(const hn::BenchCpuOptions& options, hn::Interruption& interruption) {
  hashnoise::Field<1>{
      hashnoise::Settings{}};  // throws if this processor has no instructions that there are kernels for
  std::vector<hn::Subject> subjects = hn::subjects();
  std::erase_if(subjects, [&](const hn::Subject& subject) { return !is_wanted(subject, options.filters); });
  if (subjects.empty()) {
    return usage_error(fmt::format(
        "no subject matches --filter; the ids are like perlin2, cellular3 and fbm_simplex2, and * stands for "
        "any part"));
  }
  std::optional<hn::FastNoise> other, strict;
  for (const auto& [file, library] : {std::pair{&options.against, &other}, std::pair{&options.strict, &strict}}) {
    if (file->empty()) continue;
    auto opened = hn::FastNoise::open(*file);
    if (!opened) return usage_error(opened.error().text());
    *library = std::move(*opened);
  }
  const std::string name = hn::compiler_name();
  const auto folder = hn::OutputFolder::prepare(options.out, {name + ".csv"});
  if (!folder) return usage_error(folder.error().text());

  const hn::Facts facts = {{"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
                           {"command", command_of(options)},
                           {"compiler", hn::compiler_version()},
                           {"processor", hn::processor_name()},
                           {"library", hn::library_version()},
                           {"rounds", std::to_string(options.rounds)},
                           {"step", fmt::format("{}", hn::kStep)},
                           {"note", options.note}};
  std::optional<hn::PythonMeasurement> python;
  // Before what takes long: it may not be there.
  if (!options.python.empty()) {
    show_progress(0, subjects.size(), "Python");
    const auto measured = hn::measure_python(options.python, options.rounds);
    if (!measured) return failure(measured.error().text());
    python = *measured;
  }
  std::vector<hn::Measurement> measurements;
  for (const hn::Subject& subject : subjects) {
    show_progress(static_cast<std::size_t>(&subject - subjects.data()), subjects.size(), subject.id);
    const auto measured =
        hn::measure_subject(subject, other ? &*other : nullptr, strict ? &*strict : nullptr, options.rounds);
    if (!measured) return failure(measured.error().text());
    measurements.insert(measurements.end(), measured->begin(), measured->end());
  }
  show_progress(subjects.size(), subjects.size(), "");
  interruption.note_the_first();
  const std::filesystem::path path = std::filesystem::path(options.out) / (name + ".csv");
  const auto written = hn::write_file(path, hn::record_of(facts, measurements, python));
  if (!written) return failure(written.error().text());
  for (const hn::Measurement& measurement : measurements) {
    fmt::print("{:>18} {:8}{:8.0f} million points a second\n", measurement.subject.id, hashnoise::name(measurement.set),
               measurement.millions_a_second.at("fast"));
  }
  fmt::print("{} subjects measured: {}\n", subjects.size(), path.string());
  return 0;
}

int run_program(int argc, char** argv) {
  try {
    hn::Interruption interruption(say_farewell);
    signal(SIGXFSZ, SIG_IGN);  // a file that is longer than allowed is an error, like a full disk
    const auto options = hn::parse_options(argc, argv);
    if (options) return hn::status_once_printed(kProgram, bench(*options, interruption));
    fmt::print("{}", options.error().out);
    if (!options.error().err.empty()) hn::complain(kProgram, options.error().err);
    return hn::status_once_printed(kProgram, options.error().status);
  } catch (const std::exception& exception) {
    return failure(exception.what());
  }
}

}  // namespace

int main(int argc, char** argv) { return run_program(argc, argv); }
