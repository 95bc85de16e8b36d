// Reads what cases cost. It is recorded, so that a run can print before it begins how long it will take, and a test how
// long the default run has become.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "expected/verdict.hpp"

namespace hn {

// The limit of the default run on osmesa with an empty cache of shaders: in seconds of processor time of the machine of
// record, 60 s on two cores.
inline constexpr double kBudget = 120.0;

// How many cases of a check and a function a run had, and the time that they took together.
struct Cost {
  std::string check;
  std::string function;
  std::size_t cases = 0;
  double seconds = 0.0;

  bool operator==(const Cost&) const = default;
};

class Costs {
 public:
  // The text of costs.csv.
  static Result<Costs> parse(std::string_view text);
  // Adds up the processor time of results.
  static Costs of(std::span<const CaseResult> results, double calibration);
  static const Costs& recorded();  // costs.csv

  std::string text() const;  // what parse reads

  // The time of a case, estimated from its id: that of its check and function, or else the mean of its check.
  double seconds_of(std::string_view id) const;
  double seconds_of(std::span<const std::string> ids) const;

  // Where cases are not those that were recorded: the new and the old ones, the largest growth first.
  struct Change {
    Cost was;
    Cost now;
  };
  std::vector<Change> changes_to(std::span<const std::string> ids) const;

  // How much longer than the machine of record this one takes, by a loop that takes some milliseconds.
  double factor_here() const;

 private:
  using Key = std::pair<std::string, std::string>;  // check and function
  static Key key_of(std::string_view id);
  void add(const Key& key, std::size_t cases, double seconds);

  std::map<Key, Cost> costs_;
  std::map<std::string, Cost> of_checks_;
  double calibration_ = 0.0;  // seconds of the loop on the machine of record
};

// Seconds of the loop on this machine.
double calibration_here();

// Why the default run, of these cases, is not within the budget or not as recorded, with the cases that have grown; or
// nothing.
std::string complaint_about(const Costs& recorded, std::span<const std::string> ids, double budget = kBudget);

// The cases of the default run: those of osmesa and of glslang.
std::vector<std::string> ids_of_default_run();

}  // namespace hn
