#include "bench/bench.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "base/console.hpp"
#include "base/file.hpp"
#include "bench/counts.hpp"
#include "bench/workbench.hpp"
#include "gpu/spirv.hpp"
#include "library/source.hpp"

namespace hn {
namespace {

constexpr std::size_t kReferences = 6;  // the subjects that are measured with each batch of the others

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
      Progress line(progress, kReferences + subjects.size());
      for (Subject& subject : reference_subjects()) compile(std::move(subject), line);
      for (const Measurement& reference : report_.measurements) {
        if (reference.error) return tl::unexpected(*reference.error);
      }
      HN_DO(choose_load(options));
      for (const auto& [begin, end] : batches(subjects.size(), options.most_at_a_time)) {
        for (std::size_t i = begin; i < end; ++i) compile(std::move(subjects[i]), line);
        show(line, fmt::format("time {} rounds", options.rounds));
        HN_DO(time(options));
        compiled_.resize(kReferences);  // the driver, too, forgets their shaders
      }
    }
    fmt::print(progress, "counting\n");
    count();
    return std::move(report_);
  }

 private:
  // A program, and which measurement it is of.
  struct CompiledSubject {
    std::size_t owner;
    std::unique_ptr<Program> program;
  };

  void show(Progress& line, const std::string& what) const { line.show(report_.measurements.size(), failed_, what); }

  void compile(Subject subject, Progress& line) {
    show(line, fmt::format("compile {}", subject.id));
    Measurement& measurement = report_.measurements.emplace_back(Measurement{.subject = std::move(subject)});
    if (const auto reason = workbench_.unsupported(measurement.subject); !reason.empty()) {
      measurement.error = Error{reason, {}};
      measurement.unsupported = true;
      ++failed_;
      return;
    }
    const auto start = std::chrono::steady_clock::now();
    auto program = workbench_.build(loop_shader(measurement.subject), measurement.subject.profile);
    if (!program) {
      measurement.error = program.error();
      ++failed_;
      return;
    }
    stopwatch_.first_draw(*program);
    measurement.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    compiled_.push_back({report_.measurements.size() - 1, std::make_unique<Program>(std::move(*program))});
  }

  Result<void> choose_load(const BenchOptions& options) {
    HN_TRY(load_, stopwatch_.sufficient_load(*compiled_[float_index(2)].program));
    report_.gate = stopwatch_.choose_clock(load_);
    report_.rounds = options.rounds;
    report_.side = load_.width;
    report_.iterations = load_.iterations;
    return {};
  }

  // Compiles one batch after another, each behind the reference shaders.
  Result<void> time(const BenchOptions& options) {
    std::vector<Workload> workloads(compiled_.size(), load_);
    for (std::size_t i = 0; i < compiled_.size(); ++i) workloads[i].program = compiled_[i].program.get();
    HN_TRY(const auto timings, stopwatch_.measure(workloads, options.rounds));
    const double evaluations = static_cast<double>(load_.width) * load_.height * load_.iterations;
    for (std::size_t i = 0; i < compiled_.size(); ++i) {
      Measurement& measurement = report_.measurements[compiled_[i].owner];
      const int dimensions = measurement.subject.dimensions;
      const Timing& empty = timings[empty_index(dimensions)];
      measurement.ratio = ratio(timings[i], timings[float_index(dimensions)], empty);
      const double seconds = timings[i].median() - empty.median();
      // A difference below the spread of the empty shader's own time is noise.
      measurement.evaluations_per_second.reset();
      if (seconds > empty.spread()) measurement.evaluations_per_second = evaluations / seconds;
    }
    return {};
  }

  void count() {
    for (Measurement& measurement : report_.measurements) {
      if (measurement.error) continue;
      auto words = optimised_spirv(workbench_.sources, reference_, measurement.subject);
      if (words) {
        measurement.spirv = std::move(*words);
      } else {
        measurement.problem = fmt::format("SPIR-V: {}", words.error().text());
      }
    }
  }

  Workbench workbench_;
  const ReferenceCompiler& reference_;
  Stopwatch stopwatch_;
  Workload load_{};  // of each program
  BenchReport report_;
  std::size_t failed_ = 0;
  std::vector<CompiledSubject> compiled_;  // the references, then the batch
};

}  // namespace

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

std::vector<Batch> batches(std::size_t count, std::size_t most) {
  const std::size_t number = std::max<std::size_t>((count + most - 1) / most, 1);
  std::vector<Batch> batches;
  for (std::size_t i = 0; i < number; ++i) batches.push_back({count * i / number, count * (i + 1) / number});
  return batches;
}

Result<BenchReport> run_bench(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
                              std::vector<Subject> subjects, const BenchOptions& options, std::FILE* progress) {
  return Bench(context, sources, reference).run(std::move(subjects), options, progress);
}

namespace {

std::vector<std::string> header_of() {
  return {"id", "dimensions", "call", "ratio", "spread", "evaluations_per_second", "compile_ms", "spirv", "problem"};
}

// Numbers, and words where there is none.
std::vector<std::string> row_of(const Measurement& measurement) {
  std::vector<std::string> row = {measurement.subject.id, fmt::format("{}", measurement.subject.dimensions),
                                  measurement.subject.expression};
  if (measurement.error) {
    row.resize(header_of().size() - 1, "failed");
    row.push_back(measurement.error->text());
    return row;
  }
  for (const double number : {measurement.ratio.value, measurement.ratio.spread}) {
    row.push_back(measurement.ratio.known() ? fmt::format("{:.5g}", number) : "cannot be told");
  }
  row.push_back(measurement.evaluations_per_second ? fmt::format("{:.3g}", *measurement.evaluations_per_second)
                                                   : "too fast to tell");
  row.push_back(fmt::format("{:.1f}", measurement.compile_seconds * 1e3));
  row.push_back(measurement.problem.empty() ? fmt::format("{}", count_spirv(measurement.spirv)) : "failed");
  row.push_back(measurement.problem);
  return row;
}

}  // namespace

Facts facts_of(const Provenance& provenance, const Gate& gate, int rounds) {
  return {{"date", provenance.date},
          {"command", provenance.command},
          {"driver", provenance.driver},
          {"renderer", provenance.info.renderer},
          {"OpenGL", provenance.info.gl_version},
          {"GLSL", provenance.info.glsl_version},
          {"library", library_text(provenance.library)},
          {"clock", fmt::format("{}: {}", name_of(gate.clock), gate.reason)},
          {"rounds", fmt::format("{}", rounds)}};
}

Result<void> write_bench(const std::filesystem::path& directory, const Provenance& provenance,
                         const BenchReport& report, bool dump) {
  Facts facts = facts_of(provenance, report.gate, report.rounds);
  facts.emplace_back("load", fmt::format("{0} x {0} pixels with {1} evaluations each", report.side, report.iterations));
  std::vector<std::vector<std::string>> rows;
  for (const Measurement& measurement : report.measurements) rows.push_back(row_of(measurement));
  HN_DO(write_file(directory / "bench.csv", to_record(facts, header_of(), rows)));
  if (!dump) return {};
  for (const Measurement& measurement : report.measurements) {
    HN_DO(write_spirv(directory, measurement.subject.id, measurement.spirv));
  }
  return {};
}

}  // namespace hn
