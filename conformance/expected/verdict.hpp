// How a case ended, and what to report about it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace hn {

enum class Status {
  pass,
  warning,      // every promise of the library holds; the message has what somebody should know
  fail,         // the driver, or the library on it, is wrong
  unsupported,  // the driver cannot, and does not claim to
  crash,        // the process of the driver ended, or its context or device was lost
  timeout,      // the driver did not answer in time
  error,        // the suite itself could not do its work: a golden file is missing, for example
};
inline constexpr std::array kStatuses = {Status::pass,  Status::warning, Status::fail, Status::unsupported,
                                         Status::crash, Status::timeout, Status::error};
static_assert(kStatuses.size() == static_cast<std::size_t>(Status::error) + 1, "every status, in their order");
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

// The step of a way (gpu/way/) at which a case goes wrong: the first after which a value is wrong, or the one that
// refuses the shader, crashes or hangs.
struct FaultyStep {
  std::size_t number = 0;  // from 1
  std::string input;       // the file that it got, in the folder of the results: "ways/CASE-ID/1-spirv-opt.spirv"
  std::string text = {};   // of that file, or the disassembly of its SPIR-V

  bool operator==(const FaultyStep&) const = default;
};

struct Outcome {
  Status status = Status::pass;
  std::uint64_t samples = 0;           // values compared
  std::uint64_t mismatches = 0;        // values outside of what is allowed
  double max_abs = 0.0;                // largest difference seen, allowed or not
  std::optional<double> allowed = {};  // where it was seen, if any was; 0 where every bit counts
  std::uint64_t max_ulp = 0;           // the same, in units in the last place of a float
  std::string message;
  std::vector<Mismatch> examples;  // the first of the values that are wrong
  // CRC-32 of the words that came out for the rows of a golden file, where every bit counts: each driver that is right
  // has the same.
  std::optional<std::uint32_t> checksum = {};
  std::optional<FaultyStep> step = {};
};

// "123 of 192 values are wrong; the largest difference is 0.389, and 3.51e-06 is allowed": of compared values. Units in
// the last place are printed where no difference is allowed and they are few: a large number of them helps nobody.
std::string measure_of(const Outcome& outcome);

Outcome outcome_with(Status status, const Error& error);

// The data that a developer needs to see a fault: made where a case failed.
struct Evidence {
  std::string shader;  // a fragment shader that stands alone and shows it; empty if none does
  // PNG files in base64: the values, what they should be, and the difference, amplified. Empty if there is nothing to
  // be seen.
  std::string got;
  std::string reference;
  std::string difference;
  double factor = 0.0;    // by which the difference is amplified
  std::string note = {};  // a note on the pictures and the shader

  bool operator==(const Evidence&) const = default;
};

struct CaseResult {
  std::string id;
  Outcome outcome;
  double seconds = 0.0;
  double processor_seconds = 0.0;  // of all cores, in the driver's process; 0 if the driver is elsewhere
  std::optional<Evidence> evidence = {};
  std::string excuse = {};  // of an expectation; why this case need not be right on this driver
};

// An excuse is right where the case is bad, and wrong where it is not.
bool as_expected(const CaseResult& result);

// "noise2d.perlin": the function in a case's id.
std::string_view function_of(std::string_view id);

}  // namespace hn
