// Measures what every function, hash and knob costs on a driver, next to table noise and to other people's shaders.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/csv.hpp"
#include "bench/subject.hpp"
#include "bench/timing.hpp"
#include "gpu/context_info.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/source.hpp"

namespace hn {

// Where and how numbers were measured. It stands above every result.
struct Provenance {
  std::string date;  // UTC, ISO 8601
  std::string command;
  std::string driver;
  ContextInfo info;
  std::optional<EditedLibrary> library = {};  // what was measured in place of the program's own
};
Facts facts_of(const Provenance& provenance, const Gate& gate, int rounds);
std::string now();

struct Measurement {
  Subject subject;
  std::optional<Error> error = {};                    // it does not compile, or is no float; then there is nothing else
  bool unsupported = false;                           // the error is that the context is too old, which nobody can mend
  double compile_seconds = 0.0;                       // until a first draw is done
  Ratio ratio = {};                                   // to Perlin/Float of as many dimensions
  std::optional<double> evaluations_per_second = {};  // unless it takes no longer than an empty shader
  std::vector<std::uint32_t> spirv = {};              // optimised
  std::string problem = {};                           // why there is no SPIR-V
};

struct BenchReport {
  Gate gate;
  int rounds = 0;
  int side = 0;  // pixels
  int iterations = 0;
  std::vector<Measurement> measurements;
};

struct BenchOptions {
  int rounds = 9;
  // llvmpipe keeps the code of so many shaders and no more, some 400 of the subjects. It compiles what it has dropped
  // again at each draw, and that would be measured.
  std::size_t most_at_a_time = 128;
};

// From the subject `begin` up to and without `end`.
struct Batch {
  std::size_t begin;
  std::size_t end;
};
// As few as there can be with so many subjects at the most in each, and alike; one that is empty if there are none.
std::vector<Batch> batches(std::size_t count, std::size_t most);

// Measures the subjects, a batch after the other, in the same rounds as Perlin/Float, Perlin/Integer and an empty
// shader, which come first in the report. An error: the driver cannot do even those.
Result<BenchReport> run_bench(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
                              std::vector<Subject> subjects, const BenchOptions& options, std::FILE* progress);

// bench.csv, and with dump the optimised SPIR-V that was counted as spirv/<id>.spv.
Result<void> write_bench(const std::filesystem::path& directory, const Provenance& provenance,
                         const BenchReport& report, bool dump);

}  // namespace hn
