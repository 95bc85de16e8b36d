// A case: one thing that a driver can get right or wrong, with its evidence.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "context_info.hpp"
#include "gpu.hpp"
#include "reference_compiler.hpp"
#include "result.hpp"
#include "source.hpp"

namespace hn {

enum class Status {
  pass,
  fail,         // the driver, or the library on it, is wrong
  unsupported,  // the driver cannot, and does not claim to
  error,        // the suite itself could not do its work: a golden file is missing, say
};
std::string_view name_of(Status status);

struct Outcome {
  Status status = Status::pass;
  std::uint64_t samples = 0;     // values compared
  std::uint64_t mismatches = 0;  // values outside of what is allowed
  double max_abs = 0.0;          // largest difference seen, allowed or not
  std::uint64_t max_ulp = 0;     // the same, in units in the last place of a float
  std::string message;
};

// What a case may use while it runs.
struct Session {
  const Context& context;
  const ContextInfo info;
  const SourceSet& sources;
  const ReferenceCompiler& reference;
  std::filesystem::path golden_directory;
  std::uint64_t seed;  // of the random points
  GridRenderer grid;

  // Random points for a function and how far the driver and the twin may be apart at each; the same for
  // every hash, and kept until another function asks.
  struct PointSet {
    std::vector<std::uint32_t> inputs;  // kInputWords per point
    std::vector<double> allowed;        // per point
  };
  const PointSet& twin_points(const Function& function, const Configuration& configuration, std::size_t count);

  // The program that evaluates a function; the last one is kept, since cases that share a program follow each other.
  Result<const Program*> evaluation_program(const Function& function, const Configuration& configuration,
                                            const Profile& profile, const ShaderVariant& variant = {});

  Session(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
          std::filesystem::path golden_directory, std::uint64_t seed);

 private:
  std::string kept_key_;
  std::unique_ptr<Program> kept_;
  std::string kept_points_of_;
  PointSet kept_points_;
};

struct Case {
  std::string id;  // file.function.hash.arithmetic.stage.profile.check
  std::function<Outcome(Session&)> run;
};

// Every case, in the order in which they run.
std::vector<Case> all_cases();

// The parts of all_cases, a file each.
void add_compile_cases(std::vector<Case>& cases);
void add_value_cases(std::vector<Case>& cases);

// An outcome with the error as its message.
Outcome outcome_with(Status status, const Error& error);

}  // namespace hn
