// An expectation is a known failure on some drivers, with the reason why it does not make a run wrong.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "run/results.hpp"

namespace hn {

struct Expectation {
  std::string driver;  // globs: of the driver's name, of its renderer, and of the case's id
  std::string renderer;
  std::string id;
  Status status;       // fail, crash, timeout or error
  std::string reason;  // never empty
  std::string place;   // "FILE:LINE"
};

// A table with the columns driver, renderer, case, status, reason; lines that begin with # are comments. An error names
// the file and the line.
Result<std::vector<Expectation>> parse_expectations(std::string_view text, const std::string& path);

// The expectations of every file NAME.csv in the folder.
Result<std::vector<Expectation>> read_expectations(const std::filesystem::path& directory);

// Every expectation must match a case. The error names the first that does not.
Result<void> check_expectations(const std::vector<Expectation>& expectations, const std::vector<std::string>& ids);

// The excuse of a case, or nothing: if there is an expectation for it, and it ended so, or right.
std::string excuse_for(const std::vector<Expectation>& expectations, const std::string& driver,
                       const std::string& renderer, const CaseResult& result);

// Gives every case that has an expectation its excuse: if it ended as expected, or right.
void apply_expectations(const std::vector<Expectation>& expectations, Run& run);

}  // namespace hn
