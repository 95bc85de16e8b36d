// Runs cases one after the other and says how it goes.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "case.hpp"
#include "report.hpp"

namespace hn {

// Whether an id matches one of the globs (as in a shell: * ? [...]), or there is none to match.
bool matches_any(const std::string& id, const std::vector<std::string>& globs);

// The cases whose id matches_any of the globs.
std::vector<Case> filter_cases(std::vector<Case> cases, const std::vector<std::string>& globs);

// A line that is overwritten on a terminal; now and then a whole line elsewhere.
class Progress {
 public:
  Progress(std::FILE* out, std::size_t total);
  ~Progress();
  void show(std::size_t done, std::size_t failed, const std::string& current);

 private:
  std::FILE* out_;
  bool terminal_;
  std::size_t total_;
  std::size_t last_tenth_ = 0;
};

struct RunOptions {
  bool fail_fast = false;  // stop at the first case that fails
};

std::vector<CaseResult> run_cases(Session& session, const std::vector<Case>& cases, const RunOptions& options,
                                  Progress& progress);

}  // namespace hn
