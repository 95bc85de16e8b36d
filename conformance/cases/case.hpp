// A case: one thing that a driver can get right or wrong, with its evidence.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context_info.hpp"
#include "gpu/gpu.hpp"
#include "gpu/reference_compiler.hpp"
#include "base/result.hpp"
#include "library/source.hpp"

namespace hn {

enum class Status {
  pass,
  warning,  // nothing that the library promises is touched, but somebody should know: what is said is in the message
  fail,     // the driver, or the library on it, is wrong
  unsupported,  // the driver cannot, and does not claim to
  crash,        // the process of the driver ended, or its context was lost
  timeout,      // the driver did not answer in time
  error,        // the suite itself could not do its work: a golden file is missing, say
};
inline constexpr std::array kStatuses = {Status::pass,  Status::warning, Status::fail, Status::unsupported,
                                         Status::crash, Status::timeout, Status::error};
std::string_view name_of(Status status);
std::optional<Status> status_named(std::string_view name);
// Whether a case that ended so keeps a run from being as expected, unless an expectation excuses it.
bool is_bad(Status status);

// A value that is wrong.
struct Mismatch {
  std::size_t point = 0;             // its number in the grid: a row of pixels has 1,024
  std::vector<std::uint32_t> words;  // the input words of the point
  std::string inputs;                // the same, by name: "x=1.5 (3fc00000) seed=7 (00000007)"
  std::string got;                   // in decimal and hexadecimal
  std::string expected;
};

struct Outcome {
  Status status = Status::pass;
  std::uint64_t samples = 0;     // values compared
  std::uint64_t mismatches = 0;  // values outside of what is allowed
  double max_abs = 0.0;          // largest difference seen, allowed or not
  std::uint64_t max_ulp = 0;     // the same, in units in the last place of a float
  std::string message;
  std::vector<Mismatch> examples;  // the first of the values that are wrong
};

// What every case may use while it runs.
struct Suite {
  const SourceSet& sources;
  const ReferenceCompiler& reference;
  std::filesystem::path golden_directory;
  std::uint64_t seed;        // of the random points
  std::uint64_t points = 0;  // of each comparison with the twin; 0 for what its case says
};

// What a case on a driver may use besides.
struct Session : Suite {
  const Context& context;
  const ContextInfo info;
  std::size_t most_points;  // of one evaluation: a grid takes 2^20; a slow driver is given fewer
  GridRenderer grid;

  // Random points for a function and how far the driver and the twin may be apart at each; the same for
  // every hash, and kept until another function asks. There may be more than count. A batch has other points than the
  // ones before.
  struct PointSet {
    std::vector<std::uint32_t> inputs;  // kInputWords per point
    std::vector<double> allowed;        // per point
  };
  const PointSet& twin_points(const Function& function, const Configuration& configuration, std::size_t count,
                              std::uint64_t batch = 0);

  // To be called by a case that goes on for long, after each part of its work.
  std::function<void()> still_alive = [] {};

  // The program that evaluates a function. The last few are kept, since cases that share a program follow each other;
  // what is returned lasts until the next call.
  Result<const Program*> evaluation_program(const Evaluation& evaluation);

  Session(const Suite& suite, const Context& context, std::size_t most_points = std::size_t{1} << 20);

 private:
  Result<Program> build(const Evaluation& evaluation, std::string_view shader) const;

  struct KeptProgram {
    std::string key;
    Program program;
  };
  std::list<KeptProgram> kept_;  // the last one that was asked for first
  std::string kept_points_of_;
  PointSet kept_points_;
};

// What a case has the driver compile, and nothing else.
struct Compilation {
  const Profile& profile;
  std::string fragment;  // the shader, before its includes are expanded
  std::string_view refusal =
      {};                // the word that the driver's error must have; empty if the shader must compile and link
  bool too_old = false;  // a driver may refuse the version before it reads the library's words
};

struct Case {
  std::string id;  // file.function.hash.arithmetic.stage.profile.check
  std::function<Outcome(Session&)> run;
  // What it is about, for pictures of what failed and for those who run it elsewhere: values or a compilation.
  std::shared_ptr<const Evaluation> evaluation = {};
  std::shared_ptr<const Compilation> compilation = {};
  std::string about = {};  // where it comes from, in lines for hn-conform list --about; mostly nothing
  std::function<Outcome(const Suite&)> compile = {};  // in place of run, for what the reference compiler alone says

  bool needs_driver() const { return run != nullptr; }
};

// What a developer needs to see a fault: made where a case failed.
struct Evidence {
  std::string shader;  // a fragment shader that stands alone and shows it; empty if none does
  // PNG files in base64: the values, what they should be, and the difference, amplified. Empty if there is nothing to
  // be seen.
  std::string got;
  std::string reference;
  std::string difference;
  double factor = 0.0;    // by which the difference is amplified
  std::string note = {};  // what the pictures and the shader show, and what they do not

  bool operator==(const Evidence&) const = default;
};

struct CaseResult {
  std::string id;
  Outcome outcome;
  double seconds = 0.0;
  std::optional<Evidence> evidence = {};
  std::string excuse = {};  // of an expectation; why this case need not be right on this driver
};

// An excuse is right where the case is bad, and wrong where it is not.
bool as_expected(const CaseResult& result);

// Runs the case, and times it. An exception in it is an error of the suite, and no more.
CaseResult run_case(Session& session, const Case& test);
CaseResult run_case(const Suite& suite, const Case& test);  // of one that needs no driver

// Every case, in the order in which they run.
std::vector<Case> all_cases();
std::vector<std::string> ids_of(const std::vector<Case>& cases);

// The parts of all_cases, a file each.
void add_compile_cases(std::vector<Case>& cases);
void add_value_cases(std::vector<Case>& cases);
void add_bug_cases(std::vector<Case>& cases);  // bugs/

// An outcome with the error as its message.
Outcome outcome_with(Status status, const Error& error);

}  // namespace hn
