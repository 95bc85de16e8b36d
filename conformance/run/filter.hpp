// Choosing cases, and saying how a run goes.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "cases/case.hpp"

namespace hn {

// As in a shell: * ? [...]
bool matches_glob(const std::string& text, const std::string& glob);
// Whether an id matches one of the globs, or there is none to match.
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

}  // namespace hn
