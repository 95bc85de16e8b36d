#include "bench/bench.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <iterator>
#include <memory>

#include "base/progress.hpp"
#include "bench/workbench.hpp"

namespace hn {
namespace {

constexpr std::size_t kReferences = 6;  // the subjects that run_bench puts before the others

std::vector<Subject> reference_subjects() {
  return {empty_subject(2), empty_subject(3),   float_subject(2),
          float_subject(3), integer_subject(2), integer_subject(3)};
}

std::size_t empty_index(int dimensions) { return dimensions == 2 ? 0 : 1; }
std::size_t float_index(int dimensions) { return dimensions == 2 ? 2 : 3; }

class Bench {
 public:
  Bench(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference)
      : workbench_(context, sources), reference_(reference), stopwatch_(context) {}

  Result<BenchReport> run(std::vector<Subject> subjects, const BenchOptions& options, std::FILE* progress) {
    {
      Progress line(progress, subjects.size());
      std::size_t failed = 0;
      for (Subject& subject : subjects) {
        line.show(report_.measurements.size(), failed, fmt::format("compile {}", subject.id));
        compile(std::move(subject));
        if (report_.measurements.back().error) ++failed;
      }
    }
    fmt::print(progress, "timing {} rounds, then counting\n", options.rounds);
    for (std::size_t i = 0; i < kReferences; ++i) {
      if (report_.measurements[i].error) return tl::unexpected(*report_.measurements[i].error);
    }
    HN_DO(time(options));
    if (options.counts) count();
    return std::move(report_);
  }

 private:
  void compile(Subject subject) {
    if (const auto reason = workbench_.unsupported(subject); !reason.empty()) {
      report_.measurements.push_back({.subject = std::move(subject), .error = Error{reason, {}}, .unsupported = true});
      programs_.push_back(nullptr);
      return;
    }
    const auto start = std::chrono::steady_clock::now();
    auto program = workbench_.build(loop_shader(subject), subject.profile);
    Measurement measurement{.subject = std::move(subject)};
    if (program) {
      stopwatch_.first_draw(*program);
      measurement.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      programs_.push_back(std::make_unique<Program>(std::move(*program)));
    } else {
      measurement.error = program.error();
      programs_.push_back(nullptr);
    }
    report_.measurements.push_back(std::move(measurement));
  }

  Result<void> time(const BenchOptions& options) {
    HN_TRY(const auto load, stopwatch_.sufficient_load(*programs_[float_index(2)]));
    report_.gate = stopwatch_.choose_clock(load);
    report_.rounds = options.rounds;
    report_.side = load.width;
    report_.iterations = load.iterations;
    std::vector<Workload> workloads;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < programs_.size(); ++i) {
      if (!programs_[i]) continue;
      workloads.push_back(load);
      workloads.back().program = programs_[i].get();
      owners.push_back(i);
    }
    HN_TRY(const auto timings, stopwatch_.measure(workloads, options.rounds));
    const double evaluations = static_cast<double>(load.width) * load.height * load.iterations;
    for (std::size_t i = 0; i < owners.size(); ++i) {
      Measurement& measurement = report_.measurements[owners[i]];
      const int dimensions = measurement.subject.dimensions;
      const Timing& empty = timings[empty_index(dimensions)];
      measurement.ratio = ratio(timings[i], timings[float_index(dimensions)], empty);
      const double seconds = timings[i].median() - empty.median();
      // The spread of the empty shader's own time is what can be told apart from nothing.
      if (seconds > empty.spread()) measurement.evaluations_per_second = evaluations / seconds;
    }
    return {};
  }

  void count() {
    std::vector<CountedShader> shaders;
    std::vector<std::unique_ptr<Program>> programs;
    std::vector<std::size_t> owners;
    for (std::size_t i = 0; i < report_.measurements.size(); ++i) {
      Measurement& measurement = report_.measurements[i];
      if (measurement.error) continue;
      const std::string text = quad_shader(measurement.subject);
      auto vulkan = expand(workbench_.sources, profile_named("vulkan"), text);
      if (!vulkan) {
        measurement.counts.problems.push_back(vulkan.error().text());
        continue;
      }
      const Program* program = nullptr;
      if (counts_programs(workbench_.context)) {
        auto built = workbench_.build(text, measurement.subject.profile);
        if (built) program = programs.emplace_back(std::make_unique<Program>(std::move(*built))).get();
      }
      shaders.push_back({std::move(*vulkan), program});
      owners.push_back(i);
    }
    CountReport counted = count_instructions(workbench_.context, reference_, shaders);
    report_.absent = std::move(counted.absent);
    for (std::size_t i = 0; i < owners.size(); ++i) {
      report_.measurements[owners[i]].counts = std::move(counted.counts[i]);
    }
  }

  Workbench workbench_;
  const ReferenceCompiler& reference_;
  Stopwatch stopwatch_;
  BenchReport report_;
  std::vector<std::unique_ptr<Program>> programs_;  // null where it does not compile
};

}  // namespace

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

Result<BenchReport> run_bench(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
                              std::vector<Subject> subjects, const BenchOptions& options, std::FILE* progress) {
  std::vector<Subject> all = reference_subjects();
  std::move(subjects.begin(), subjects.end(), std::back_inserter(all));
  return Bench(context, sources, reference).run(std::move(all), options, progress);
}

}  // namespace hn
